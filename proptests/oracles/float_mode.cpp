// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/float_mode.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#else
#include <cfenv>
#endif

namespace proptests::oracle {

#if defined(__x86_64__)
namespace {
constexpr unsigned flags = 0x3f, masks = 0x1f80, daz = 0x40, ftz = 0x8000, invalid_zero_overflow = 0x80 | 0x200 | 0x400;
}

std::vector<FloatMode> other_float_modes() {
  std::vector<FloatMode> modes;
  const char* roundings[] = {"to nearest", "downward", "upward", "toward zero"};
  for (unsigned rounding = 0; rounding < 4; ++rounding)
    for (const unsigned flush : {0u, daz, ftz, daz | ftz})
      if (rounding || flush)
        modes.push_back({std::string(roundings[rounding]) + (flush & ftz ? ", FTZ" : "") + (flush & daz ? ", DAZ" : ""),
                         masks | rounding << 13 | flush});
  modes.push_back({"exceptions trap", masks & ~invalid_zero_overflow});
  return modes;
}
unsigned current_float_mode() { return _mm_getcsr() & ~flags; }
ScopedFloatMode::ScopedFloatMode(const FloatMode& mode) : before_(_mm_getcsr()) { _mm_setcsr(mode.control); }
ScopedFloatMode::~ScopedFloatMode() { _mm_setcsr(before_); }
#else
std::vector<FloatMode> other_float_modes() {
  return {{"downward", FE_DOWNWARD}, {"upward", FE_UPWARD}, {"toward zero", FE_TOWARDZERO}};
}
unsigned current_float_mode() { return static_cast<unsigned>(std::fegetround()); }
ScopedFloatMode::ScopedFloatMode(const FloatMode& mode) : before_(current_float_mode()) {
  std::fesetround(static_cast<int>(mode.control));
}
ScopedFloatMode::~ScopedFloatMode() { std::fesetround(static_cast<int>(before_)); }
#endif

}  // namespace proptests::oracle
