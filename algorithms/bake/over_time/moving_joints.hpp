// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that move with parameters: with the time of a clip, or with two times and a weight; and cells, boxes of parameters over
// which it is known how they move.
#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "algorithms/model/model.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

// What skins the vertices at a moment, by joint.
struct PosedJoints {
  std::vector<Eigen::Matrix4d> matrices;  // the skin matrices; on columns, from the reference pose
  Pose pose;                              // the rigid transforms nearest to them; empty where they are not asked for
  std::vector<Eigen::VectorXd> weights;   // by target, for each of the morphed meshes of the model
};

// The side of an interval's end that belongs to it: of a moment, the later one, which the animation shows then.
inline Side side_of_end(double start, double end) { return start < end ? Side::before : Side::after; }

// Which of both quaternions of a node's second rotation a crossfade goes to: the one that the file has, or the opposite one.
struct NodeSign {
  int node;
  bool is_opposite;
  auto operator<=>(const NodeSign&) const = default;
};

// What joints are posed by: a value of each parameter, and its side, where something jumps there.
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

// From one value of a parameter to another: of a clip's time, in seconds, within the parts from the first to the last; of a
// weight, a share.
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

// How joints move with one parameter, the others being held, per unit of it. Infinite where nothing is known. Lengths in units of
// the file.
struct JointMotions {
  std::vector<ChainMotion<double>> links, chains;    // by node, against the parent and against the scene
  std::vector<std::vector<Motion<double>>> weights;  // by target, for each of the model's morphed meshes
};

class MovingJoints;

struct JointCell {
  const MovingJoints* joints;
  std::vector<double> sides;                                 // by parameter: how long its range is
  std::vector<std::shared_ptr<const JointMotions>> motions;  // by parameter
  // The first parameter's ends next to each other.
  std::vector<ParameterMoment> corners;
  // How far the linear part of a joint's skin matrix is from the rotation that its chain's quaternions make, at most: by the noise
  // of scales that should be one. Infinite where a scale may vanish; 0 where no poses are asked for.
  double defect;
  // How many times more than the quaternions of a slerp those of the nodes are off by rounding.
  double rounding;
};

// All functions may be called by several threads.
class MovingJoints {
 public:
  virtual ~MovingJoints() = default;
  virtual const Model& model() const = 0;
  // That cover all that parameters can be.
  virtual std::vector<ParameterBox> boxes() const = 0;
  virtual JointCell cell(const ParameterBox& box) const = 0;
  // The box in two: at a value of this parameter, or, of a box of whose motion something is not known, by a sign. None where there
  // is no value between.
  virtual std::vector<ParameterBox> halves(const ParameterBox& box, std::size_t parameter, bool is_known) const = 0;
  // Throws ModelError for a pose that is asked for and is not rigid.
  virtual std::shared_ptr<const PosedJoints> at(const ParameterMoment& moment) const = 0;
};

// By the ranges' ends.
std::vector<ParameterMoment> corners_of(const ParameterBox& box);

}  // namespace refitlab
