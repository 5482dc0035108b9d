// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/allocations.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local long count = 0, fails_at = -1;

}  // namespace

namespace proptests::oracle {

long allocations() { return count; }

FailingAllocation::FailingAllocation(long after) { fails_at = count + after + 1; }
FailingAllocation::~FailingAllocation() { fails_at = -1; }

}  // namespace proptests::oracle

// The address sanitizer has operators of its own, and says what is asked of them.
#ifdef __SANITIZE_ADDRESS__

// This is declared as in sanitizer/allocator_interface.h, which GCC's packages lack.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

void add(const volatile void*, std::size_t) { ++count; }
void ignore(const volatile void*) {}
[[maybe_unused]] const int installed = __sanitizer_install_malloc_and_free_hooks(add, ignore);

}  // namespace

#else

namespace {

void add_one() {
  if (++count == fails_at) throw std::bad_alloc();
}

}  // namespace

// All other forms of the language's own operators call this one.
void* operator new(std::size_t size) {
  add_one();
  if (void* out = std::malloc(size > 0 ? size : 1)) return out;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  add_one();
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* out = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return out;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

#endif
