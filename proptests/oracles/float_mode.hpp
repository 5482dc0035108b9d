// SPDX-License-Identifier: GPL-3.0-or-later
// Sets floating-point modes that a calling program may have set: every direction of rounding, denormals flushed to zero on the
// way out (FTZ), taken for zero on the way in (DAZ), and exceptions that trap.
#pragma once

#include <string>
#include <vector>

#include "lemmas/vocabulary/numbers.hpp"

namespace proptests::oracle {

struct FloatMode {
  std::string name;
  // On x86-64 this is the register MXCSR, and elsewhere a rounding direction of <cfenv>.
  unsigned control;
};

// Returns all modes but the default one: on x86-64 15 of rounding, FTZ and DAZ, and one in which invalid operations, divisions by
// zero and overflows trap; elsewhere the other three directions of rounding.
std::vector<FloatMode> other_float_modes();

// Returns the thread's mode as it is, without flags that only remember.
unsigned current_float_mode();

// Gives the thread this mode while it lives.
class ScopedFloatMode {
 public:
  explicit ScopedFloatMode(const FloatMode& mode);
  ~ScopedFloatMode();
  ScopedFloatMode(const ScopedFloatMode&) = delete;

 private:
  unsigned before_;
};

}  // namespace proptests::oracle
