// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what this thread takes from the heap by operator new, which the test program replaces for that, and lets it fail.
#pragma once

namespace proptests::oracle {

// Returns the number of allocations since the thread began.
long allocations();

// Returns how many allocations a call makes.
template <class Call>
long allocations_in(const Call& call) {
  const long before = allocations();
  call();
  return allocations() - before;
}

// Lets one allocation of this thread throw std::bad_alloc while it lives: the one after so many others. There is one at a time. A
// program with the address sanitizer, which has its own operators, has none.
class FailingAllocation {
 public:
  explicit FailingAllocation(long after);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
};
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool allocations_can_fail = false;
#else
inline constexpr bool allocations_can_fail = true;
#endif

}  // namespace proptests::oracle
