// SPDX-License-Identifier: GPL-3.0-or-later
// The latencies of this processor's operations on doubles.
#pragma once

#include "experiments/speed/chained.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

// Measures how long operations take of which each waits for the one before.
Latencies measure_latencies(const SpeedSettings& settings);

}  // namespace refitlab
