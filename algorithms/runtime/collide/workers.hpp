// SPDX-License-Identifier: MIT
// Workers share many tasks. What shares them, and among how many threads, is the caller's.
#pragma once

#include <cstddef>
#include <exception>
#include <mutex>

namespace refitlab {

// This is the interface of a thread pool: for_each(self, count, task, data) calls task(data, i) once for each i < count, in any
// order and on any threads. It returns when all calls have returned. task throws nothing.
struct Workers {
  void (*for_each)(void* self, std::size_t count, void (*task)(void* data, std::size_t i), void* data);
  void* self = nullptr;
};

// Runs all tasks on the calling thread alone.
inline Workers one_worker() {
  return {[](void*, std::size_t count, void (*task)(void*, std::size_t), void* data) {
            for (std::size_t i = 0; i < count; ++i) task(data, i);
          },
          nullptr};
}

// Calls body(i) for each i < count. The first exception that one of them throws is thrown here, after all have ended.
template <class Body>
void for_each(const Workers& workers, std::size_t count, const Body& body) {
  struct Task {
    const Body& body;
    std::mutex mutex;
    std::exception_ptr failure;
  } task{body, {}, {}};
  const auto run = [](void* data, std::size_t i) {
    Task& of = *static_cast<Task*>(data);
    try {
      of.body(i);
    } catch (...) {
      const std::scoped_lock lock(of.mutex);
      if (!of.failure) of.failure = std::current_exception();
    }
  };
  workers.for_each(workers.self, count, run, &task);
  if (task.failure) std::rethrow_exception(task.failure);
}

}  // namespace refitlab
