// SPDX-License-Identifier: GPL-3.0-or-later
// Options are what a run of the experiments is asked for on the command line.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/certificates/certificates.hpp"
#include "experiments/collisions/collisions.hpp"
#include "experiments/crowds/crowds.hpp"
#include "experiments/deformations/deformations.hpp"
#include "experiments/engines/engines.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/over_time/crossfades.hpp"
#include "experiments/over_time/growth.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/timing.hpp"
#include "experiments/synthetic/synthetic.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace refitlab {

inline constexpr const char* experiments_on_models[] = {"tightness",  "speed",     "volumes", "rounding",
                                                        "collisions", "over_time", "engines", "deformations"};
// All or a part of these has nothing to do with a model. That part belongs to no character.
inline constexpr const char* experiments_without_model[] = {"growth", "crowds", "synthetic", "over_time"};
inline constexpr const char* no_character = "none";

// The settings are those of a first look unless asked otherwise: all parts, all characters, in some minutes.
struct Options {
  std::string effort = "default";
  std::vector<std::string> only, files;
  double picture_size = 0.6;            // as a share of that in the paper, in each direction
  std::vector<std::string> characters;  // of the default models those of these names, or all
  std::string models = "out/models", out = "out";
  TightnessSettings tightness{.times_per_clip = 8};
  SpeedSettings speed{.seconds_per_run = 0.01, .repetitions = 3};
  VolumeSettings volumes{.times_per_clip = 3, .nodes_per_level = 32, .speed = speed};
  RoundingSettings rounding{.poses = 1, .vertices_per_node = 1, .speed = speed};
  CollisionSettings collisions{.frames = 1, .speed = {.seconds_per_run = 0.001, .repetitions = 5}};
  TriangleGrowthSettings triangles{.frames = 1, .subdivisions = 1, .speed = {.seconds_per_run = 0.002, .repetitions = 3}};
  CrowdSettings crowds{.most_characters = 1000, .speed = {.seconds_per_run = 0.002, .repetitions = 3}};
  SyntheticSettings synthetic{.count = 2000};
  OverTimeSettings over_time{.random_times = 100, .halvings = 4, .exact_checks = 4, .clips = 2};
  CrossfadeSettings crossfades{.times = 5, .weights = 5, .clips = 2, .cluster_triangles = 512};
  OverTimeGrowthSettings over_time_growth{.subdivisions = 1};
  EngineSettings engines{.times_per_clip = 100, .clips = 2, .speed = speed};
  DeformationSettings deformations{.times_per_clip = 2, .speed = speed};
  bool anew = false, check_only = false, lists_parts = false, packs_models = false;
  CertificateRequest certificate;
  // Returns whether an experiment is wanted that has something to do with a model.
  bool wants_models() const {
    return std::any_of(std::begin(experiments_on_models), std::end(experiments_on_models),
                       [&](const char* name) { return wants(name); });
  }
  bool wants(const std::string& name) const { return only.empty() || std::find(only.begin(), only.end(), name) != only.end(); }
  bool wants_character(const std::string& name) const {
    return characters.empty() || std::find(characters.begin(), characters.end(), name) != characters.end();
  }
  // If the user gives models, the parts that have nothing to do with a model run only if they are asked for.
  bool wants_no_character() const { return wants_character(no_character) && (files.empty() || !only.empty()); }
};

// Returns false if only help was asked for. With --target, all kernels are limited from then on. Throws what boost::program_options
// throws for options that it does not know, and for some that exclude each other.
bool parse(int argc, char** argv, Options& options);

}  // namespace refitlab
