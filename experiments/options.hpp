// Options: what a run of the experiments is asked for on the command line.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/certificates/certificates.hpp"
#include "experiments/collisions/collisions.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/queries/queries.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/timing.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace refitlab {

struct Options {
  std::string effort = "default";
  std::vector<std::string> only, files;
  std::string models = "out/models", out = "out";
  TightnessSettings tightness;
  SpeedSettings speed;
  VolumeSettings volumes;
  RoundingSettings rounding;
  CollisionSettings collisions{.frames = 6, .speed = {.seconds_per_run = 0.005, .repetitions = 3}};
  TriangleGrowthSettings triangles{.speed = {.seconds_per_run = 0.01, .repetitions = 3}};
  QuerySettings queries;
  bool anew = false, check_only = false, packs_models = false;
  CertificateRequest certificate;
  bool wants(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
};

// False if only help was asked for. Throws what boost::program_options does for options that it does not know, and for
// some that exclude each other.
bool parse(int argc, char** argv, Options& options);

}  // namespace refitlab
