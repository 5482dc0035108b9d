// SPDX-License-Identifier: GPL-3.0-or-later
// This measures growth with the number of characters in one scene, a square full of walking men, of whom each pair may touch.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/timing.hpp"

namespace refitlab {

// A CharacterGrowth has means over the frames. Times are those of one frame, in us, for everything from poses and placements to
// pairs of triangles.
struct CharacterGrowth {
  int characters = 0;
  double pairs_of_boxes = 0;    // of characters, that meet
  double contacts = 0;          // pairs of characters that touch
  double triangle_pairs = 0;    // that touch
  double clusters_skinned = 0;  // share of all
  double full = 0, yes_no = 0;
  double full_on_two_threads = 0;  // 0 where threads are not to be had
  double skin_all = 0;             // only to palette and skin all of them, in float: less than any detector that does so
};

// Measures 10 to 1000 characters, each with two square metres.
std::vector<CharacterGrowth> run_character_growth(const SpeedSettings& settings);

void write_character_growth(const std::vector<CharacterGrowth>& rows, const std::string& path);

}  // namespace refitlab
