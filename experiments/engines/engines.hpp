// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on what engines ship measures the boxes with which engines bound a whole animated character, beside ours: how
// tight they are, how often a vertex is outside, and what a box costs.
#pragma once

#include <string>
#include <vector>

#include "experiments/engines/box_measures.hpp"
#include "experiments/engines/engine_methods.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct EngineSettings {
  int times_per_clip = 200;  // evenly spread
  int clips = 0;             // of a model at most; 0 for all
  SpeedSettings speed;
  bool unseen_clips = false;  // fit rounded boxes to all other clips, too, for each clip, which takes a second each and more
};

// EnginePoses are a clip, or the turns of all joints, with one way of skinning.
struct EnginePoses {
  std::string name, kind;  // kind: clip or twists
  Skinning skinning;
  std::vector<BoxMeasure> measures;  // by method
};

// An EngineCost is the cost of going from a pose to a box.
struct EngineCost {
  std::string method;
  Skinning skinning;
  double ns, ratio;                                  // medians over the repetitions; ratio: to joint boxes
  double ns_of_matrices = 0, ratio_of_matrices = 0;  // the same from the matrices that skinning needs anyway; 0 for methods that
                                                     // do not begin with these
};

struct EngineResult {
  std::string model;
  std::vector<std::string> refused;  // clips that are not rigid, and why
  std::vector<EnginePoses> poses;
  std::vector<EngineCost> costs;
};

// Runs the experiment on a model. Progress goes to stdout.
EngineResult run_engines(const Model& model, const EngineSettings& settings);

void write_engines(const std::vector<EngineResult>& results, const std::string& path);

}  // namespace refitlab
