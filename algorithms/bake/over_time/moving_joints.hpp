// SPDX-License-Identifier: GPL-3.0-or-later
// MovingJoints move with parameters, which are the time of a clip, or two times and a weight. A cell is a box of parameters over
// which it is known how they move.
#pragma once

#include <compare>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

// PosedJoints skin the vertices at a moment.
struct PosedJoints {
  std::vector<Eigen::Matrix4d> matrices;  // the skin matrices; on columns, from the reference pose
  Pose pose;                              // the rigid transforms nearest to them; empty where they are not asked for
  std::vector<Eigen::VectorXd> weights;   // by target, for each of the morphed meshes of the model
};

// Returns the side of an interval's end that belongs to the interval. If the interval is a moment, it is the later side, which
// the animation shows then.
inline Side side_of_end(double start, double end) { return start < end ? Side::before : Side::after; }

// A NodeSign says to which quaternion of a node's second rotation a crossfade goes: to the one that the file has, or to the
// opposite one.
struct NodeSign {
  int node;
  bool is_opposite;
  auto operator<=>(const NodeSign&) const = default;
};

// A ParameterMoment poses joints. It has a value of each parameter, and the side of that value, which matters where something
// jumps.
struct ParameterMoment {
  struct Coordinate {
    double value;
    Side side;
    auto operator<=>(const Coordinate&) const = default;
  };
  std::vector<Coordinate> coordinates;
  std::vector<NodeSign> signs = {};  // of the cell whose corner it is; by increasing node
  auto operator<=>(const ParameterMoment&) const = default;
};

// A ParameterRange goes from one value of a parameter to another. The parameter is a clip's time in seconds, within the parts
// from the first to the last, or a weight in [0, 1].
struct ParameterRange {
  int first_part, last_part;
  double start, end;
  auto operator<=>(const ParameterRange&) const = default;
};

struct ParameterBox {
  std::vector<ParameterRange> ranges;
  std::vector<NodeSign> signs = {};  // of those moments of the ranges where these hold; by increasing node
  auto operator<=>(const ParameterBox&) const = default;
};

// JointMotions say how joints move with one parameter, per unit of it, while the others are held. They are infinite where nothing
// is known. Lengths are in units of the file.
struct JointMotions {
  std::vector<ChainMotion<double>> links, chains;    // by node, against the parent and against the scene
  std::vector<std::vector<Motion<double>>> weights;  // by target, for each of the model's morphed meshes
};

class MovingJoints;

struct JointCell {
  const MovingJoints* joints;
  std::vector<double> sides;                                 // by parameter: how long its range is
  std::vector<std::shared_ptr<const JointMotions>> motions;  // by parameter
  // The first parameter's ends are next to each other.
  std::vector<ParameterMoment> corners;
  // The linear part of a joint's skin matrix is at most this far from the rotation that its chain's quaternions make, because of
  // the noise of scales that should be one. It is infinite where a scale may vanish, and 0 where no poses are asked for.
  double defect;
  // The rounding errors of the nodes' quaternions are this many times those of a slerp.
  double rounding;
};

// All functions may be called by several threads.
class MovingJoints {
 public:
  virtual ~MovingJoints() = default;
  virtual const Model& model() const = 0;
  // Returns what moves them, for messages: such as "clip 'walk'".
  virtual std::string name() const = 0;
  // Returns boxes that cover all values of the parameters.
  virtual std::vector<ParameterBox> boxes() const = 0;
  virtual JointCell cell(const ParameterBox& box) const = 0;
  // Splits the box in two at a value of this parameter, or by a sign if part of its motion is not known. Returns nothing if there
  // is no value in between.
  virtual std::vector<ParameterBox> halves(const ParameterBox& box, std::size_t parameter, bool is_known) const = 0;
  // Returns the joints at a moment. Throws ModelError for a pose that is asked for and is not rigid, and for a matrix or weight
  // that is not finite.
  virtual std::shared_ptr<const PosedJoints> at(const ParameterMoment& moment) const = 0;
};

// Throws ModelError, with what moves the joints and the moment, if a matrix or a weight is not finite.
void check_finite(const MovingJoints& joints, const PosedJoints& posed, const std::string& moment);

// Returns the corners of a box, which are made of its ranges' ends.
std::vector<ParameterMoment> corners_of(const ParameterBox& box);

// Returns the numbers from 0 on, which are the indices of all vertices or joints.
std::vector<int> indices_below(std::size_t count);

}  // namespace refitlab
