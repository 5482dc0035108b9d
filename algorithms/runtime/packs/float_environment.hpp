// SPDX-License-Identifier: MIT
// All derivations of rounding count on this floating-point environment: it rounds to nearest and keeps denormal numbers.
//
// Programs change it for themselves. Engines, and programs linked with -ffast-math, flush denormals to zero, after an operation
// (FTZ) or before it (DAZ), and interval arithmetic rounds upward. So every public function that is compiled into the library and
// computes begins with a DefaultFloatEnvironment. Its results are the same, to the last bit, in every environment that the caller
// may have, and the caller gets that back.
#pragma once

#include <cstdint>

namespace refitlab {

// While it lives, this thread has the default environment. Neither the constructor nor the destructor is inline, so that the
// compiler moves no arithmetic past them.
class DefaultFloatEnvironment {
 public:
  DefaultFloatEnvironment() noexcept;
  ~DefaultFloatEnvironment();
  DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
  DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;

 private:
  std::uint64_t callers_;  // the processor's control register as the caller had it
};

}  // namespace refitlab
