// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/detector.hpp"

namespace refitlab {

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::own: return "own";
    case Origin::baseline: return "baseline";
    case Origin::engine: return "engine";
    case Origin::bounded: return "bounded";
    case Origin::floor: return "floor";
    case Origin::oracle: break;
  }
  return "oracle";
}

}  // namespace refitlab
