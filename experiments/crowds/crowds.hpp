// SPDX-License-Identifier: GPL-3.0-or-later
// This measures what many characters in one scene cost: walking men, of whom each pair may touch.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/timing.hpp"

namespace refitlab {

struct CrowdSettings {
  int most_characters = 1000;  // from 10 in steps of about three times as many, at most 10,000
  SpeedSettings speed;
};

// A CrowdResult has means over the frames.
struct CrowdResult {
  // In the scene "dense" each has two square metres. In "apart" each has so much room that no boxes meet.
  std::string scene;
  int characters = 0;
  double pairs_of_boxes = 0;    // of characters, that meet
  double contacts = 0;          // pairs of characters that touch
  double triangle_pairs = 0;    // that touch
  double clusters_skinned = 0;  // share of all
  // By detector, the time of a frame in us, for everything from poses and placements to pairs of triangles; only "broad_phase" is
  // the comparison of the boxes alone. No name ends with "_on_two_threads" where threads are not to be had.
  struct Time {
    std::string detector;
    double us;
    double
        ratio_to_clusters;  // over the time of collide_all on as many threads, by the same query: the median of the repetitions
  };
  std::vector<Time> times;
};

// Measures the scenes. Throws std::logic_error if two detectors find different contacts.
std::vector<CrowdResult> run_crowds(const CrowdSettings& settings);

void write_crowds(const std::vector<CrowdResult>& rows, const std::string& path);

}  // namespace refitlab
