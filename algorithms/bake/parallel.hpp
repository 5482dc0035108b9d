// SPDX-License-Identifier: GPL-3.0-or-later
// parallel_for does independent pieces of work on all processors. It is for baking and checking that measure geometry, never
// time.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace refitlab {

// Calls work(i) once for each i in [0, count). The first exception thrown is rethrown here, after all threads ended.
template <class Work>
void parallel_for(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto worker = [&] {
    for (std::size_t i; (i = next++) < count;) try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  const unsigned extra = std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency())) - 1;
  for (unsigned t = 0; count > 1 && t < extra; ++t) threads.emplace_back(worker);
  worker();
  for (auto& t : threads) t.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace refitlab
