// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that joints move: where they are at a moment, and how far from what is between the corners of a cell.
#pragma once

#include <span>

#include "algorithms/bake/over_time/moving_joints.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// Which point of a vertex is followed through a cell.
enum class Followed { skinned, linear_blend };

// What is known of a cell: the point that is followed is within `chord` of what lies between its corners, interpolated linearly in
// each parameter (c1_chord_bound, c6_interval_hull), and the skinned vertex within `beyond` of that point. Infinite where nothing
// is known.
struct CellSlack {
  Followed followed = Followed::skinned;
  double chord = 0;
  std::vector<double> chords = {};  // by parameter: its share of the chord, of the vertices of which it is greatest
  std::vector<double> beyond = {};  // by position in vertices(), where a linear blend is followed
};

class MovingVertices {
 public:
  // Some vertices of a model, by index; at least one. All arguments outlive this. skinning: linear, dual_quaternion or spherical,
  // which is about least-squares centers. Throws std::invalid_argument for Hejl's.
  MovingVertices(const Model& model, const JointSets& sets, Skinning skinning, std::vector<int> vertices);

  const std::vector<int>& vertices() const { return vertices_; }

  // That move them: the model's, in increasing order.
  std::vector<int> joints() const;

  // The points that are followed, by position in vertices(); scene frame, units of the file.
  void place(const PosedJoints& posed, Followed followed, std::vector<Point3>& points) const;

  // Of all vertices, throughout the cell. Dual quaternions whose blend may vanish are followed only if they must be: then by their
  // linear blend (b7_motion_bound), which is loose.
  // Throws ModelError where it must and there is no bound: a blend of three or more rotations that may vanish.
  CellSlack slack(const JointCell& cell, bool must) const;

  // What place() may be off, because of rounding and of skin matrices that are not quite rigid, at any moment of the cell.
  double placing_error(const JointCell& cell) const;

 private:
  // A morph target of a mesh that displaces vertices of a set.
  struct Morph {
    int mesh, target;
    std::vector<double> lengths;  // by joint: of the displacements in the joint's frame, at most
  };
  // The vertices that one joint-set moves.
  struct Set {
    int index;
    std::vector<int> vertices;      // positions in vertices_
    std::vector<double> distances;  // by joint: of the vertices from the joint's origin, in its frame, at most
    std::vector<double> reaches;    // by joint: the same by what these are summed up from, for rounding
    std::vector<Morph> morphs;
    int base;  // the deepest node that is above all joints' nodes, or one of them; -1 is the scene
  };

  // A vertex before it is skinned, with the weights of a moment.
  Point3 displaced(int i, const PosedJoints& posed) const;
  // Of the set's vertices in the frame of its k-th joint, before that moves, by how far they are without displacements
  // (a3_morph_displacement).
  Motion<double> below(const Set& set, std::size_t k, const JointMotions& motions, const std::vector<double>& distances) const;
  Motion<double> linear_motion(const Set& set, const JointMotions& motions) const;
  // Of dual quaternions whose blends have this squared length at least.
  Motion<double> dual_motion(const Set& set, const JointMotions& motions, double squared_least) const;
  // Of the rotations and images of the set's joints that are computed, relative to what they are summed up from.
  double relative_rounding(const Set& set, const JointCell& cell) const;
  // The chords of linear blends and of dual quaternions, by parameter; infinite where the latter may vanish.
  std::vector<double> linear_chords(const Set& set, const JointCell& cell) const;
  std::vector<double> dual_chords(const Set& set, const JointCell& cell) const;
  // How far the set's skinned vertices are from their linear blends, whose chord is known; written to beyond. False, or
  // ModelError if it must, where the blends may vanish.
  bool deviate(const Set& set, const JointCell& cell, bool must, double chord, std::vector<double>& beyond) const;
  // What holds of the set's quaternions throughout the cell, with the signs that skinning gives them at each moment.
  struct Rotations {
    bool keep_signs;              // the signs are those of the first corner
    std::vector<double> cosines;  // no more than the dot products, for k < l in order
  };
  Rotations rotations(const Set& set, const JointCell& cell) const;
  // The least squared length of the blends of the set's vertices.
  double squared_blend(const Set& set, const Rotations& rotations) const;

  const Model& model_;
  const JointSets& joint_sets_;
  Skinning skinning_;
  struct Displacement {
    int mesh, target;
    Point3 by;
  };

  std::vector<int> vertices_;
  std::vector<std::vector<Displacement>> displacements_;  // by position in vertices_; empty for a model without morph targets
  std::vector<Set> sets_;
};

}  // namespace refitlab
