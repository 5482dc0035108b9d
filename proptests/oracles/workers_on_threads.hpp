// SPDX-License-Identifier: GPL-3.0-or-later
// Makes workers that share tasks among so many threads, however few cores there are.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "algorithms/runtime/collide/crowd.hpp"

namespace proptests::oracle {

template <int threads>
refitlab::Workers workers_on_threads() {
  return {[](void*, std::size_t count, void (*task)(void*, std::size_t), void* data) {
            std::atomic<std::size_t> next = 0;
            const auto work = [&] {
              for (std::size_t i; (i = next++) < count;) task(data, i);
            };
            std::vector<std::jthread> others;
            for (int i = 1; i < threads; ++i) others.emplace_back(work);
            work();
          },
          nullptr};
}

}  // namespace proptests::oracle
