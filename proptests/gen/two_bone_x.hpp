// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a small rigged file in the text form of X: a strip of two squares with a bone for each.
#pragma once

#include <string>

namespace proptests::gen {

// Holds what the text has in these places, as is.
struct TwoBoneX {
  std::string ticks_per_second = "7";         // empty: the file does not say
  std::string weighted = "0, 1, 2, 3, 4, 5";  // the vertices that the weights are of
  std::string root_weights = "1, 1, 0.5, 0.5, 0.25, 0.25";
  std::string tip_weights = "0, 0, 0.5, 0.5, 0.75, 0.75";
  std::string last_key = "14";  // of clip "wave", in ticks; the first is 0
};

// Throws std::runtime_error where it cannot be written.
void write_x(const TwoBoneX& parts, const std::string& path);

}  // namespace proptests::gen
