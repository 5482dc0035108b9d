// SPDX-License-Identifier: GPL-3.0-or-later
// The most memory that this process has had at a time.
#pragma once

#include <optional>

namespace refitlab {

// Megabytes (10^6 bytes) of resident memory; nothing where the system does not tell. Unlike what getrusage says it begins with the
// program, whatever started it.
std::optional<double> peak_megabytes();

}  // namespace refitlab
