// SPDX-License-Identifier: GPL-3.0-or-later
// MovingVertices are vertices that joints move. They tell where the vertices are at a moment, and how far they are from the
// interpolation of a cell's corners.
#pragma once

#include <algorithm>

#include "algorithms/bake/over_time/moving_joints.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// Followed says which point of a vertex is followed through a cell.
enum class Followed { skinned, linear_blend };

// Throughout a cell, the point that is followed is within `chord` of the linear interpolation of its places at the corners, in
// each parameter (c1_chord_bound, c6_interval_hull). The skinned vertex is within `beyond` of that point. Both are infinite where
// nothing is known.
struct CellSlack {
  Followed followed = Followed::skinned;
  double chord = 0;
  std::vector<double> chords = {};  // by parameter: its share of the chord, of the vertices of which it is greatest
  std::vector<double> beyond = {};  // by position in vertices(), where a linear blend is followed
};

// Finite says whether the slack of a cell may be infinite, because another cell will do, or must be finite, however loose it is.
enum class Finite { may_be, must_be };

// Says what a vertex is off by at most, in units of the file.
struct ErrorGrowth {
  // This is for each unit of relative error in a skinning's steps. It is the greatest distance from the scene's origin of an
  // image of a vertex by one of its joints, even if the images mostly cancel; and more where blended quaternions are short.
  double per_rounding = 0;
  // This is the same for each unit of the sum of the weights' absolute errors.
  double per_weight = 0;
  // This is the error from the file's joints whose weights are rounded to 0 (LostInfluence), however far these carry the vertex.
  // Signs of blended quaternions are those to the first joint that stays.
  double of_lost_influences = 0;

  // Raises each to the other's, if that is greater.
  void merge(const ErrorGrowth& other) {
    per_rounding = std::max(per_rounding, other.per_rounding);
    per_weight = std::max(per_weight, other.per_weight);
    of_lost_influences = std::max(of_lost_influences, other.of_lost_influences);
  }
};

class MovingVertices {
 public:
  // vertices are some vertices of the model, at least one, by index. All arguments must outlive this. skinning is linear,
  // dual_quaternion or spherical, which is about least-squares centers. Throws std::invalid_argument for Hejl's.
  MovingVertices(const Model& model, const JointSets& sets, Skinning skinning, std::vector<int> vertices);

  const std::vector<int>& vertices() const { return vertices_; }

  // Returns the joints of the model that move the vertices, in increasing order, and those of lost influences.
  std::vector<int> joints() const;

  // Computes the points that are followed, by position in vertices(), in the scene's frame and units of the file.
  void place(const PosedJoints& posed, Followed followed, std::vector<Point3>& points) const;

  // Returns the slack of all vertices throughout the cell. Dual quaternions whose blend may vanish are followed only if it must
  // be finite, and then by their linear blend (b7_motion_bound), which is loose.
  // Throws ModelError if it must but there is no bound, which happens for a blend of three or more rotations that may vanish.
  CellSlack slack(const JointCell& cell, Finite finite) const;

  // Returns the greatest growth of errors in any vertex, at any moment of the cell.
  ErrorGrowth error_growth(const JointCell& cell) const;

  // Returns the greatest number of joints of a vertex, without those of lost influences.
  int most_joints() const;

  // Returns the greatest error of place() at any moment of the cell, because of rounding and of skin matrices that are not quite
  // rigid.
  double placing_error(const JointCell& cell) const;

 private:
  // A Morph is a morph target of a mesh that displaces vertices of a set.
  struct Morph {
    int mesh, target;
    std::vector<double> lengths;  // by joint: of the displacements in the joint's frame, at most
    std::vector<double> reaches;  // by joint: the same by what these are summed up from, for rounding
  };
  // A Set is the vertices that one joint-set moves.
  struct Set {
    int index = 0;
    std::vector<int> vertices;      // positions in vertices_
    std::vector<int> lost;          // joints of lost influences, which come after the joint-set's in all that is by joint
    std::vector<double> shares;     // by position in lost: the greatest of a vertex
    std::vector<double> distances;  // by joint: of the vertices from the joint's origin, in its frame, at most
    std::vector<double> reaches;    // by joint: the same by what these are summed up from, for rounding
    std::vector<Morph> morphs;
    int base = -2;  // the deepest node that is above all joints' nodes, or one of them; -1 is the scene
  };

  // Returns a vertex before it is skinned, displaced by the weights of a moment.
  Point3 displaced(int i, const PosedJoints& posed) const;
  // Returns the motion of the set's vertices in the frame of its k-th joint, before that moves (a3_morph_displacement). Lengths
  // are those of the images, or of what these are summed up from.
  enum class Lengths { of_images, of_summands };
  Motion<double> below(const Set& set, std::size_t k, const JointMotions& motions, Lengths lengths) const;
  Motion<double> linear_motion(const Set& set, const JointMotions& motions) const;
  // Returns the motion under dual quaternions whose blends have at least this squared length.
  Motion<double> dual_motion(const Set& set, const JointMotions& motions, double squared_least) const;
  // Returns the rounding error of the computed rotations and images of the set's joints, relative to the sizes of their summands.
  double relative_rounding(const Set& set, const JointCell& cell) const;
  // Returns the greatest distance from the scene's origin of an image of a vertex by the set's k-th joint, or by any of the
  // joint-set's.
  double farthest_image(const Set& set, std::size_t k, int joint, const JointCell& cell) const;
  double farthest_image(const Set& set, const JointCell& cell) const;
  // Returns whether quaternions of several joints are blended, those of lost influences included.
  bool blends(const Set& set) const;
  // Returns the factor by which the blend of a set's quaternions, if there is one, enlarges an error of the weights.
  double inverse_blend(const Set& set, const JointCell& cell) const;
  // Returns the greatest growth of errors in any vertex of the set.
  ErrorGrowth error_growth(const Set& set, const JointCell& cell) const;
  // Returns how far the set's vertices are at most from the prior of their rotation center, in the reference pose.
  double farthest_from_prior(const Set& set, const JointCell& cell) const;
  // These return the chords of linear blends and of dual quaternions, by parameter. Chords are infinite where the latter may
  // vanish.
  std::vector<double> linear_chords(const Set& set, const JointCell& cell) const;
  std::vector<double> dual_chords(const Set& set, const JointCell& cell) const;
  // Returns how far linear blends are from the interpolation of the corners at most, however fast they move: both are no farther
  // from the scene's origin than the vertices ever are. That is loose.
  double widest_chord(const Set& set, const JointCell& cell) const;
  // Writes to beyond how far the set's skinned vertices are from their linear blends, whose chord is known. If the blends may
  // vanish, it returns false, or throws ModelError if it must be finite.
  bool deviate(const Set& set, const JointCell& cell, Finite finite, double chord, std::vector<double>& beyond) const;
  // This holds for the set's quaternions throughout the cell, with the signs that skinning gives them at each moment.
  struct Rotations {
    bool keep_signs;              // the signs are those of the first corner
    std::vector<double> cosines;  // no more than the dot products, for k < l in order
  };
  Rotations rotations(const Set& set, const JointCell& cell) const;
  // Returns the least squared length of the blends of the set's vertices.
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
