// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that an animation moves: where they are at a moment, and how far from the chord they are between two moments.
#pragma once

#include <span>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// Which curve of a vertex is followed through an interval.
enum class Followed { skinned, linear_blend };

// What is known of an interval: the point of the curve that is followed is within `chord` of the chord between its ends
// (c1_chord_bound, c6_interval_hull), and the skinned vertex within `beyond` of that point. Infinite where nothing is known.
struct IntervalSlack {
  Followed followed = Followed::skinned;
  double chord = 0;
  std::vector<double> beyond = {};  // by position in vertices(), where a linear blend is followed
};

class MovingVertices {
 public:
  // Some vertices of the model of the joints, by index; at least one. All arguments outlive this. skinning: linear, dual_quaternion
  // or spherical, which is about least-squares centers. Throws std::invalid_argument for Hejl's.
  MovingVertices(const AnimatedJoints& joints, const JointSets& sets, Skinning skinning, std::vector<int> vertices);

  const std::vector<int>& vertices() const { return vertices_; }

  // The points of the followed curves at a time of the animation, by position in vertices(); scene frame, units of the file.
  void place(double time, Side side, Followed followed, std::vector<Point3>& points) const;

  // Of all vertices, from start to end, which are times in this part of the joints' times. Dual quaternions whose blend may
  // vanish are followed only if they must be: then by their linear blend (b7_motion_bound), which is loose.
  // Throws ModelError where it must and there is no bound: a blend of three or more rotations that may vanish.
  IntervalSlack slack(int part, double start, double end, bool must) const;

  // What place() may be off, because of rounding and of skin matrices that are not quite rigid, at any time of this part.
  double placing_error(int part) const;

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
  Motion<double> below(const Set& set, std::size_t k, int part, const std::vector<double>& distances) const;
  Motion<double> linear_motion(const Set& set, int part) const;
  // Of the rotations and images of the set's joints that are computed, relative to what they are summed up from.
  double relative_rounding(const Set& set, int part) const;
  // The chords of linear blends and of dual quaternions; infinite where the latter may vanish.
  double linear_chord(const Set& set, int part, double start, double end) const;
  double dual_chord(const Set& set, int part, double start, double end) const;
  // How far the set's skinned vertices are from their linear blends, whose chord is known; written to beyond. False, or
  // ModelError if it must, where the blends may vanish.
  bool deviate(const Set& set, int part, double start, double end, bool must, double chord, std::vector<double>& beyond) const;
  // What holds of the set's quaternions throughout the interval, with the signs that skinning gives them at each moment.
  struct Rotations {
    bool keep_signs;              // the signs are those of the start
    std::vector<double> cosines;  // no more than the dot products, for k < l in order
  };
  Rotations rotations(const Set& set, int part, double start, double end) const;
  // The least squared length of the blends of the set's vertices.
  double squared_blend(const Set& set, const Rotations& rotations) const;

  const AnimatedJoints& joints_;
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
