// SPDX-License-Identifier: GPL-3.0-or-later
// The Explorer computes what the report's interactive page shows of a character: one pose, one level of its tree, and every
// variant.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/scenes/animated_character.hpp"

namespace refitlab {

struct ExplorerSettings {
  std::string model, variant;  // by name; the variant's skinning is that of the vertices
  std::string clip;            // empty: the reference pose
  double time = 0;             // of the clip, in seconds; beyond its ends they are taken
  int joint = 0;
  double twist = 0;  // of the joint about its bone, in radians, before the clip's pose
  int level = 1;     // of the tree, from 1 (the root); beyond the last it is the last
  int ball = 0;      // the one of the level that is looked at closely; beyond the last it is the last
};

// A VariantSummary says how a variant's balls on the level bound their vertices.
struct VariantSummary {
  std::string variant;
  int balls = 0, undefined = 0;  // of them not a number or of negative radius
  int vertices_outside = 0;      // outside a ball of theirs, by more than miss_tolerance of the root's reference radius
  double worst_miss = 0;         // how far outside, model units
  double mean_radius = 0, mean_over_optimal = 0;  // of the balls that are defined
  double ball_radius = 0;                         // of the one that is looked at
};

struct ExplorerView {
  std::vector<Point3> vertices, joints;  // deformed, and the joints' posed origins
  Point3 axis;                           // of the twisted joint's bone, posed; of unit length
  int level_count = 0;
  std::vector<Ball3<double>> balls;  // of the level, by the variant
  std::vector<bool> misses;          // by ball: undefined, or a vertex of its node is outside
  std::vector<bool> outside;         // by vertex: outside a ball of its node
  int ball = 0;
  int ball_vertices = 0;                  // of the one that is looked at
  double ball_optimal = 0;                // the radius of the smallest ball of these
  std::vector<VariantSummary> summaries;  // of shown_variants, and the chosen one
};

// Returns the variants whose numbers stand beside each other in every view. They need no large tables.
const std::vector<std::string>& shown_variants();

class Explorer {
 public:
  Explorer();

  // Adds a model of pack(), under its name, beside the procedural ones. Throws what unpack() throws.
  void add(const std::vector<std::uint8_t>& packed);

  // Returns the names of the models, in order.
  std::vector<std::string> models() const;

  // Returns the character of a model. It is made when it is first asked for, which may take seconds. Throws std::invalid_argument
  // for a name that is not a model's.
  const AnimatedCharacter& character(const std::string& model);

  // Returns the view of these settings. Throws std::invalid_argument for an unknown name or joint.
  ExplorerView view(const ExplorerSettings& settings);

 private:
  struct Maker {
    std::string name;
    std::function<Model()> make;
  };
  std::vector<Maker> makers_;
  std::map<std::string, AnimatedCharacter> characters_;
};

}  // namespace refitlab
