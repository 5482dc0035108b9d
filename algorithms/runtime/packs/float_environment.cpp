// SPDX-License-Identifier: MIT
#include "algorithms/runtime/packs/float_environment.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace refitlab {
namespace {

#if defined(__x86_64__)
// This MXCSR masks all exceptions, rounds to nearest, and has neither FTZ nor DAZ. Its lowest six bits only remember exceptions.
constexpr std::uint64_t default_control = 0x1f80, flags = 0x3f;
std::uint64_t control() { return _mm_getcsr(); }
void set_control(std::uint64_t value) { _mm_setcsr(static_cast<unsigned>(value)); }
#elif defined(__aarch64__)
constexpr std::uint64_t default_control = 0, flags = 0;
std::uint64_t control() {
  std::uint64_t value;
  __asm__ volatile("mrs %0, fpcr" : "=r"(value));
  return value;
}
void set_control(std::uint64_t value) { __asm__ volatile("msr fpcr, %0" : : "r"(value)); }
#else
// On other processors, the standard library only knows the rounding mode.
constexpr std::uint64_t default_control = FE_TONEAREST, flags = 0;
std::uint64_t control() { return static_cast<std::uint64_t>(std::fegetround()); }
void set_control(std::uint64_t value) { std::fesetround(static_cast<int>(value)); }
#endif

}  // namespace

DefaultFloatEnvironment::DefaultFloatEnvironment() noexcept : callers_(control()) {
  if ((callers_ & ~flags) != default_control) set_control(default_control);
}

DefaultFloatEnvironment::~DefaultFloatEnvironment() {
  if ((callers_ & ~flags) != default_control) set_control(callers_);
}

}  // namespace refitlab
