// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what this thread takes from the heap by operator new, which the test program replaces for that.
#pragma once

namespace proptests::oracle {

// Since the thread began.
long allocations();

// How many allocations a call makes.
template <class Call>
long allocations_in(const Call& call) {
  const long before = allocations();
  call();
  return allocations() - before;
}

}  // namespace proptests::oracle
