// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/moving_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "algorithms/bake/over_time/half_turns.hpp"
#include "algorithms/bake/over_time/node_motions.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"
#include "lemmas/a3_morph_displacement.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/b8_blend_error.hpp"
#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/c5_skinned_motion.hpp"
#include "lemmas/c6_interval_hull.hpp"

namespace refitlab {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// This is the error of each link, in units of the last place of double and of the size of what the chain makes. It counts a slerp
// or a spline (16), a rotation matrix (12), and a product of two matrices (3 times 4, for the absolute values of one of them),
// and takes twice that.
constexpr double error_per_link = 80;

// Blends of dual quaternions that may be shorter are not followed, because rounding would grow by as much.
constexpr double squared_shortest_blend = 1e-2;

// This is the error from the rigid transforms' defect, relative to the size of what joints carry. If images are off by d, a blend
// of dual quaternions, at least 1/10 long, is off by 10 d. The bounded images are off by the defect of the vertex, and twice by
// that of the base, at the time and on the chord: 60 in all. The pose's rotations are off by the defect's square.
constexpr double error_per_defect = 64;

// The error of a spherically skinned vertex is at most this many times that of its joints' images. Its center may be as far away
// as the least angle at which rotation_center.hpp looks for one allows.
constexpr double growth_about_center = 1e4;

// Beyond these, the square of a side, or an acceleration in it, may underflow.
constexpr double shortest_side = 1e-140, longest_side = 1e60;

// If a factor is unknown, so is the product, even if the other factor is 0. A NaN becomes unknown here, so that no maximum passes
// over it.
double or_unknown(double x) { return x >= 0 ? x : unknown; }
Motion<double> or_unknown(const Motion<double>& m) {
  return {or_unknown(m.size), or_unknown(m.speed), or_unknown(m.acceleration)};
}

// Returns the slack of c1_chord_bound, also where squares of sides are too small, or accelerations too great, for double.
double chord_within(const Motion<double>& motion, double side) {
  if (side == 0) return 0;
  const double simple = or_unknown(first_order_slack(motion.speed, side));
  if (side < shortest_side || side > longest_side) return simple;
  const double chord = chord_slack(motion, side);
  return chord >= 0 ? chord : simple;
}

int depth_of(const std::vector<SceneNode>& nodes, int node) {
  int depth = 0;
  for (; node >= 0; node = nodes[node].parent) ++depth;
  return depth;
}

int common_node(const std::vector<SceneNode>& nodes, int a, int b) {
  int deep_a = depth_of(nodes, a), deep_b = depth_of(nodes, b);
  while (a != b) {
    if (deep_a >= deep_b) a = nodes[a].parent, --deep_a;
    else b = nodes[b].parent, --deep_b;
  }
  return a;
}

Point3 image(const Eigen::Matrix4d& matrix, const Point3& v) {
  return matrix.topLeftCorner<3, 3>() * v + matrix.topRightCorner<3, 1>();
}

// The least-squares center is not moved from the prior in directions in which the rotations of so many joints differ little.
// Returns by how much they differ there at most: the square root of the sum over pairs (rotation_center.hpp).
double tolerance_of_center(std::size_t joints) {
  const double pairs = static_cast<double>(joints * (joints - 1)) / 2;
  return joints == 2 ? 1e-4 : 1e-4 + 2e-3 * std::sqrt(pairs);
}

// Returns the joint-set's transforms, with the signs that skinning gives them.
std::vector<RigidTransform<double>> transforms_of(std::span<const int> joints, const Pose& pose) {
  std::vector<RigidTransform<double>> transforms;
  for (const int j : joints) transforms.push_back(pose[j]);
  make_signs_consistent<double>(transforms);
  return transforms;
}

}  // namespace

MovingVertices::MovingVertices(const Model& model, const JointSets& sets, Skinning skinning, std::vector<int> vertices)
    : model_(model),
      joint_sets_(sets),
      skinning_(skinning),
      vertices_(std::move(vertices)) {
  const DefaultFloatEnvironment environment;
  if (skinning == Skinning::hejl) throw std::invalid_argument("MovingVertices: there are no bounds over time of Hejl's centers");
  const BoundSkeleton& skeleton = model.skeleton;
  const std::vector<MorphedMesh>& morphs = model.morphs;
  if (!morphs.empty()) displacements_.resize(vertices_.size());
  for (std::size_t m = 0; m < morphs.size(); ++m)
    for (std::size_t t = 0; t < morphs[m].targets.size(); ++t)
      for (std::size_t i = 0; i < vertices_.size(); ++i)
        if (const Point3* by = displacement_of(morphs[m].targets[t], vertices_[i]))
          displacements_[i].push_back({static_cast<int>(m), static_cast<int>(t), *by});
  std::map<int, Set> by_index;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const int index = sets.of_vertex(vertices_[i]);
    Set& set = by_index.try_emplace(index).first->second;
    set.index = index;
    set.vertices.push_back(static_cast<int>(i));
    std::vector<std::pair<std::size_t, int>> moving;  // the joints that move the vertex, with their places in what is by joint
    for (const int j : sets.joints(index)) moving.emplace_back(moving.size(), j);
    const std::size_t kept = moving.size();
    for (const LostInfluence& lost : lost_influences(model, vertices_[i])) {
      const auto at = static_cast<std::size_t>(std::find(set.lost.begin(), set.lost.end(), lost.joint) - set.lost.begin());
      if (at == set.lost.size()) set.lost.push_back(lost.joint), set.shares.push_back(0);
      set.shares[at] = std::max(set.shares[at], lost.share);
      moving.emplace_back(kept + at, lost.joint);
    }
    const std::size_t all = kept + set.lost.size();
    set.distances.resize(all, 0), set.reaches.resize(all, 0);
    for (Morph& morph : set.morphs) morph.lengths.resize(all, 0), morph.reaches.resize(all, 0);
    for (const auto& [k, j] : moving) {
      const BoundJoint& joint = skeleton.joints[j];
      const ImageLength length = length_of_vertex(model, joint.offset, vertices_[i]);
      set.reaches[k] = std::max(set.reaches[k], length.summed);
      set.distances[k] = std::max(set.distances[k], length.computed);
      if (k < kept) set.base = set.base == -2 ? joint.node : common_node(skeleton.nodes, set.base, joint.node);
    }
    if (displacements_.empty()) continue;
    for (const Displacement& d : displacements_[i]) {
      auto morph = std::find_if(set.morphs.begin(), set.morphs.end(),
                                [&](const Morph& known) { return known.mesh == d.mesh && known.target == d.target; });
      if (morph == set.morphs.end()) {
        const std::vector<double> none(all, 0);
        morph = set.morphs.insert(morph, {d.mesh, d.target, none, none});
      }
      for (const auto& [k, j] : moving) {
        const ImageLength length = length_of_displacement(model, skeleton.joints[j].offset, vertices_[i], d.by);
        morph->lengths[k] = std::max(morph->lengths[k], length.computed);
        morph->reaches[k] = std::max(morph->reaches[k], length.summed);
      }
    }
  }
  for (auto& [index, set] : by_index) sets_.push_back(std::move(set));
}

Point3 MovingVertices::displaced(int i, const PosedJoints& posed) const {
  Point3 v = model_.vertices[vertices_[i]];
  if (!displacements_.empty())
    for (const Displacement& d : displacements_[i]) v += posed.weights[d.mesh][d.target] * d.by;
  return v;
}

Motion<double> MovingVertices::below(const Set& set, std::size_t k, const JointMotions& motions, Lengths lengths) const {
  const bool are_summed = lengths == Lengths::of_summands;
  std::vector<double> displaced;
  std::vector<Motion<double>> weights;
  for (const Morph& morph : set.morphs) {
    displaced.push_back((are_summed ? morph.reaches : morph.lengths)[k]);
    weights.push_back(motions.weights[morph.mesh][morph.target]);
  }
  return displaced_motion<double>((are_summed ? set.reaches : set.distances)[k], displaced, weights);
}

std::vector<int> MovingVertices::joints() const {
  std::set<int> all;
  for (const Set& set : sets_) {
    all.insert(joint_sets_.joints(set.index).begin(), joint_sets_.joints(set.index).end());
    all.insert(set.lost.begin(), set.lost.end());
  }
  return {all.begin(), all.end()};
}

void MovingVertices::place(const PosedJoints& posed, Followed followed, std::vector<Point3>& points) const {
  const DefaultFloatEnvironment environment;
  const bool is_linear = skinning_ == Skinning::linear || followed == Followed::linear_blend;
  points.resize(vertices_.size());
  OwnedPaletteEntry<double> palette;
  for (const Set& set : sets_) {
    const auto joints = joint_sets_.joints(set.index);
    if (!is_linear) {
      palette.transforms = transforms_of(joints, posed.pose);
      if (skinning_ == Skinning::dual_quaternion) place_duals(palette);
      else place_rotation_center(palette, rotation_center<double>(palette.transforms, center_prior(model_, joints, skinning_)));
    }
    for (const int i : set.vertices) {
      const Point3 v = displaced(i, posed);
      const auto weights = joint_sets_.weights(vertices_[i]);
      if (is_linear) {
        Point3 sum = image(posed.matrices[joints[0]], v) * weights[0];
        for (std::size_t k = 1; k < joints.size(); ++k) sum += image(posed.matrices[joints[k]], v) * weights[k];
        points[i] = sum;
      } else {
        points[i] = blend<double>(skinning_, palette, weights, v);
      }
    }
  }
}

CellSlack MovingVertices::slack(const JointCell& cell, Finite finite) const {
  const DefaultFloatEnvironment environment;
  const auto is_blended = [&](const Set& set) {
    return skinning_ != Skinning::linear && joint_sets_.joints(set.index).size() > 1;
  };
  CellSlack out{Followed::skinned, 0, std::vector<double>(cell.sides.size(), 0)};
  const auto raise = [&](const std::vector<double>& chords, double sum) {
    if (sum >= out.chord) out.chord = sum, out.chords = chords;
  };
  if (skinning_ != Skinning::spherical) {
    for (const Set& set : sets_) {
      const std::vector<double> chords = is_blended(set) ? dual_chords(set, cell) : linear_chords(set, cell);
      raise(chords, is_blended(set) ? box_slack<double>(chords) : std::min(box_slack<double>(chords), widest_chord(set, cell)));
    }
    if (out.chord < unknown || finite == Finite::may_be) return out;
  }
  out = {Followed::linear_blend, 0, std::vector<double>(cell.sides.size(), 0), std::vector<double>(vertices_.size(), 0)};
  for (const Set& set : sets_) {
    const std::vector<double> chords = linear_chords(set, cell);
    const double sum = std::min(box_slack<double>(chords), widest_chord(set, cell));
    raise(chords, !is_blended(set) || deviate(set, cell, finite, sum, out.beyond) ? sum : unknown);
  }
  return out;
}

double MovingVertices::widest_chord(const Set& set, const JointCell& cell) const {
  double size = 0;
  for (const auto& motions : cell.motions) size = std::max(size, linear_motion(set, *motions).size);
  return 2 * size;
}

Motion<double> MovingVertices::linear_motion(const Set& set, const JointMotions& motions) const {
  const auto joints = joint_sets_.joints(set.index);
  std::vector<Motion<double>> images;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int node = model_.skeleton.joints[joints[k]].node;
    images.push_back(or_unknown(carried_motion(motions.chains[node], below(set, k, motions, Lengths::of_images))));
  }
  return widest<double>(images);
}

Motion<double> MovingVertices::dual_motion(const Set& set, const JointMotions& motions, double squared_least) const {
  const auto joints = joint_sets_.joints(set.index);
  const BoundSkeleton& skeleton = model_.skeleton;
  std::vector<Motion<double>> images, turns;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto chain = chain_below(skeleton.nodes, motions.links, set.base, skeleton.joints[joints[k]].node);
    images.push_back(or_unknown(carried_motion(chain, below(set, k, motions, Lengths::of_images))));
    turns.push_back(or_unknown(chain.rotation));
  }
  const Motion<double> motion = refitlab::dual_motion<double>(images, turns, std::sqrt(squared_least));
  return set.base >= 0 ? carried_motion(motions.chains[set.base], motion) : motion;
}

std::vector<double> MovingVertices::linear_chords(const Set& set, const JointCell& cell) const {
  std::vector<double> chords;
  for (std::size_t i = 0; i < cell.sides.size(); ++i)
    chords.push_back(chord_within(linear_motion(set, *cell.motions[i]), cell.sides[i]));
  return chords;
}

std::vector<double> MovingVertices::dual_chords(const Set& set, const JointCell& cell) const {
  const Rotations known = rotations(set, cell);
  const double squared_least = squared_blend(set, known);
  // If too little is known of blends, the parameter with the greatest chord of linear blends is to be halved.
  if (!known.keep_signs || squared_least < squared_shortest_blend) {
    std::vector<double> chords = linear_chords(set, cell);
    *std::max_element(chords.begin(), chords.end()) = unknown;
    return chords;
  }
  std::vector<double> chords;
  for (std::size_t i = 0; i < cell.sides.size(); ++i)
    chords.push_back(chord_within(dual_motion(set, *cell.motions[i], squared_least), cell.sides[i]));
  return chords;
}

MovingVertices::Rotations MovingVertices::rotations(const Set& set, const JointCell& cell) const {
  const auto joints = joint_sets_.joints(set.index);
  // Only the first corner is used, because skinning may have other signs at the others.
  const auto there = transforms_of(joints, cell.joints->at(cell.corners[0])->pose);
  const BoundSkeleton& skeleton = model_.skeleton;
  std::vector<double> turned(joints.size(), 0);  // how far a quaternion goes at most, as seen from the base
  for (std::size_t k = 0; k < joints.size(); ++k)
    for (std::size_t i = 0; i < cell.sides.size(); ++i)
      if (cell.sides[i] > 0)
        turned[k] +=
            or_unknown(
                chain_below(skeleton.nodes, cell.motions[i]->links, set.base, skeleton.joints[joints[k]].node).rotation.speed) *
            cell.sides[i];
  const auto cosine = [&](std::size_t k, std::size_t l) { return dot(there[k].rotation, there[l].rotation); };
  const double off = 2 * (relative_rounding(set, cell) + cell.defect);
  const auto change = [&](std::size_t k, std::size_t l) { return turned[k] + turned[l] + off; };
  std::vector<bool> keeps_sign;
  // A renderer in float chooses the other sign where rotations are half a turn apart, to within its rounding.
  for (std::size_t k = 0; k < joints.size(); ++k)
    keeps_sign.push_back(k == 0 || cosine(0, k) > change(0, k) + rounding_of_cosine_in_float);
  Rotations out{std::find(keeps_sign.begin(), keeps_sign.end(), false) == keeps_sign.end(), {}};
  for (std::size_t k = 0; k < joints.size(); ++k)
    for (std::size_t l = k + 1; l < joints.size(); ++l) {
      double least = keeps_sign[k] && keeps_sign[l] ? cosine(k, l) - change(k, l) : -std::abs(cosine(k, l)) - change(k, l);
      if (k == 0) least = std::max(least, -rounding_of_cosine_in_float);  // to the first one all signs are so chosen
      out.cosines.push_back(std::max(least, -1.0));
    }
  return out;
}

double MovingVertices::squared_blend(const Set& set, const Rotations& rotations) const {
  double least = 1;
  for (const int i : set.vertices)
    least = std::min(least, least_squared_blend<double>(joint_sets_.weights(vertices_[i]), rotations.cosines));
  return least;
}

bool MovingVertices::deviate(const Set& set, const JointCell& cell, Finite finite, double chord,
                             std::vector<double>& beyond) const {
  const Rotations known = rotations(set, cell);
  const double squared_least = squared_blend(set, known);
  if (squared_least < squared_shortest_blend) {
    if (finite == Finite::may_be) return false;
    throw ModelError(model_.name, "vertex " + std::to_string(vertices_[set.vertices[0]]) + " or one like it",
                     "the rotations of its joints come so far apart that their blend may vanish: there is no bound over time");
  }
  const auto joints = joint_sets_.joints(set.index);
  // Between the corners, two images come apart by at most twice the slack of one.
  const double pairs = static_cast<double>(joints.size() * (joints.size() - 1)) / 2, apart = 2 * chord * std::sqrt(pairs);
  const double tolerance = skinning_ == Skinning::spherical ? tolerance_of_center(joints.size()) : 0;
  const Point3 prior = center_prior(model_, joints, skinning_);
  std::vector<double> shares;
  for (const int i : set.vertices)
    shares.push_back(std::sqrt(squared_deviation_share<double>(joint_sets_.weights(vertices_[i]), known.cosines, squared_least)));
  for (const ParameterMoment& corner : cell.corners) {
    const auto posed = cell.joints->at(corner);
    for (std::size_t s = 0; s < set.vertices.size(); ++s) {
      const int i = set.vertices[s];
      const Point3 v = displaced(i, *posed);
      const double off_center = 2 * tolerance * norm<double, 3>(v - prior);
      std::vector<Point3> images;
      for (const int j : joints) images.push_back(image(posed->matrices[j], v));
      beyond[i] = std::max(beyond[i], shares[s] * (std::sqrt(squared_spread<double>(images)) + apart + off_center));
    }
  }
  return true;
}

double MovingVertices::relative_rounding(const Set& set, const JointCell& cell) const {
  const BoundSkeleton& skeleton = model_.skeleton;
  double links = 4;
  for (const int j : joint_sets_.joints(set.index))
    links = std::max(links, 4.0 + depth_of(skeleton.nodes, skeleton.joints[j].node));
  return error_per_link * links * std::numeric_limits<double>::epsilon() / 2 * cell.rounding;
}

bool MovingVertices::blends(const Set& set) const {
  return skinning_ != Skinning::linear && joint_sets_.joints(set.index).size() + set.lost.size() > 1;
}

double MovingVertices::farthest_image(const Set& set, std::size_t k, int joint, const JointCell& cell) const {
  const JointMotions& motions = *cell.motions[0];  // sizes are the same in all parameters
  return carried_motion(motions.chains[model_.skeleton.joints[joint].node], below(set, k, motions, Lengths::of_summands)).size;
}

double MovingVertices::farthest_image(const Set& set, const JointCell& cell) const {
  const auto joints = joint_sets_.joints(set.index);
  double size = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) size = std::max(size, farthest_image(set, k, joints[k], cell));
  return size;
}

// Returns 1 / ||q|| at most, of the blends q of a joint-set's quaternions.
double MovingVertices::inverse_blend(const Set& set, const JointCell& cell) const {
  return 1 / std::sqrt(std::max(squared_blend(set, rotations(set, cell)), squared_shortest_blend));
}

// Says how far vertices move if their weights change, and their sum and the signs of quaternions stay, by b8_blend_error. A vertex is
// seen from where it is before it is skinned, and so a joint's dual part is half as long as its image of the vertex. ||q|| stands for
// that of the changed blend as well, which is less by the change at most; rounding to multiples of 2^-24 makes a change of half a unit a
// joint, and a whole unit is counted (model_bounds.cpp).
//
// Spherical blends are about the rotation center c. There let y be the mean of the n vectors R_k u. Then n
// sum ||R_k u - y||^2 is the sum over pairs of ||(R_k - R_l) u||^2. The center makes that no more than the sum of ||C_k v - C_l v||^2,
// which is n times a sum of n squares of at most a: C_k v - C_l v is (R_k - R_l) u plus C_k c - C_l c, and the latter is least
// squares' residual, at right angles to all that moves c. In directions in which rotations hardly differ, c stays with the prior, and
// there ||(R_k - R_l) u|| is at most the tolerance of that, times the distance from the prior.
ErrorGrowth MovingVertices::error_growth(const Set& set, const JointCell& cell) const {
  const std::size_t kept = joint_sets_.joints(set.index).size();
  const bool is_blended = blends(set), is_about_center = skinning_ == Skinning::spherical && is_blended;
  const double image = farthest_image(set, cell), kappa = is_blended ? inverse_blend(set, cell) : 1;
  const double growth = is_blended ? move_of_error(BlendError<double>{1, 0.5, 0.5, kappa}) : 1;  // for an image that is 1 away
  const double off_center = is_about_center ? tolerance_of_center(kept) * farthest_from_prior(set, cell) : 0;
  // Returns how far a vertex moves for each unit of the sum of the errors of weights, of joints whose images are this far away.
  const auto moved = [&](double size) {
    if (!is_about_center) return size * growth;
    const double turned = size * std::sqrt(static_cast<double>(kept)) + off_center;
    return spherical_move_of_error(ChangeOfWeights<double>{1, size, turned, kappa});
  };
  ErrorGrowth out;
  // Without a blend of quaternions, or if they are all the same, an image is off by its own error.
  out.per_rounding = image * std::max(growth / 2, 1.0);
  out.per_weight = moved(image);
  // The others have a lost share together, too.
  for (std::size_t l = 0; l < set.lost.size(); ++l)
    out.of_lost_influences += 2 * set.shares[l] * moved(std::max(image, farthest_image(set, kept + l, set.lost[l], cell)));
  return out;
}

double MovingVertices::farthest_from_prior(const Set& set, const JointCell& cell) const {
  const Point3 prior = center_prior(model_, joint_sets_.joints(set.index), skinning_);
  double distance = 0, moved = 0;
  for (const int i : set.vertices) distance = std::max(distance, norm<double, 3>(model_.vertices[vertices_[i]] - prior));
  // A joint's frame is as long as the reference pose, to within the tolerance for rigid joints.
  for (const Morph& morph : set.morphs) moved += cell.motions[0]->weights[morph.mesh][morph.target].size * morph.lengths[0];
  return distance + 2 * moved;
}

ErrorGrowth MovingVertices::error_growth(const JointCell& cell) const {
  const DefaultFloatEnvironment environment;
  ErrorGrowth out;
  for (const Set& set : sets_) out.merge(error_growth(set, cell));
  return out;
}

int MovingVertices::most_joints() const {
  std::size_t most = 0;
  for (const Set& set : sets_) most = std::max(most, joint_sets_.joints(set.index).size());
  return static_cast<int>(most);
}

double MovingVertices::placing_error(const JointCell& cell) const {
  const DefaultFloatEnvironment environment;
  double error = 0;
  for (const Set& set : sets_) {
    double relative = relative_rounding(set, cell);
    if (skinning_ != Skinning::linear) {
      relative *= skinning_ == Skinning::spherical ? growth_about_center : 1 / squared_shortest_blend;
      relative += error_per_defect * cell.defect * (1 + cell.defect);
    }
    error = std::max(error, relative * farthest_image(set, cell) + underflow_of_distance<double>());
  }
  return error;
}

}  // namespace refitlab
