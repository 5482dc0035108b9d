// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes behind which nothing can be read or written, so that code that goes beyond them is stopped at once.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace proptests::gen {

class GuardedBytes {
 public:
  explicit GuardedBytes(std::size_t count) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t room = (count + page - 1) / page * page;
    size_ = room + page;
    base_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (base_ == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<std::uint8_t*>(base_) + room - count;
    if (mprotect(static_cast<std::uint8_t*>(base_) + room, page, PROT_NONE) == 0) return;
    munmap(base_, size_);
    throw std::bad_alloc();
  }
  ~GuardedBytes() { munmap(base_, size_); }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;
  std::uint8_t* data() { return data_; }

 private:
  std::size_t size_;
  void* base_;
  std::uint8_t* data_;
};

}  // namespace proptests::gen
