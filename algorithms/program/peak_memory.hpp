// SPDX-License-Identifier: GPL-3.0-or-later
// The peak is the most memory that this process has had at a time.
#pragma once

#include <optional>

namespace refitlab {

// Returns the peak of resident memory in megabytes (10^6 bytes), or nothing if the system does not tell. Unlike the peak of
// getrusage, it begins with the program, whatever started it.
std::optional<double> peak_megabytes();

}  // namespace refitlab
