// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/crossfaded_joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "algorithms/bake/over_time/half_turns.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/c7_crossfade.hpp"

namespace refitlab {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// This bounds the rounding of dot products of unit quaternions.
constexpr double rounding_of_cosine = 1e-12;

// A cell is split by the two signs of a quaternion if quaternions go no farther than this within it and may be at a right angle.
constexpr double most_travel_across = 0.125;

// The rounding of blended rotations is this many times that of one clip. Both clips' rotations count, blended across at most two
// thirds of a half turn.
constexpr double growth_by_blend = 8;

constexpr std::size_t bytes_of_cache = std::size_t(16) << 20;

// If the file does not say which of the three factors mirrors, it could be any of them.
NodeTransform rest_of(const SceneNode& node, const std::string& file, const std::string& clip) {
  const std::optional<NodeTransform> parts = parts_of(node);
  if (!parts || (!node.rest && parts->scale[0] < 0))
    throw ModelError(file, "clip '" + clip + "', joint '" + node.name + "'",
                     "does not move in this clip, and its matrix is no rotation and scale to be blended");
  return *parts;
}

NodeTrack still_track(int node, const NodeTransform& rest) {
  return {node, {{{0, rest.translation}}}, {{{0, rest.rotation}}}, {{{0, rest.scale}}}};
}

// Returns, by node, whether one of the joints is below the node or is the node.
std::vector<bool> nodes_above(const BoundSkeleton& skeleton, std::span<const int> joints) {
  std::vector<bool> out(skeleton.nodes.size(), false);
  for (const int j : joints)
    for (int n = skeleton.joints[j].node; n >= 0; n = skeleton.nodes[n].parent) out[n] = true;
  return out;
}

Animation completed(const Model& model, const Animation& animation, const Animation& other, const std::vector<bool>& needed) {
  Animation out = animation;
  std::erase_if(out.tracks, [&](const NodeTrack& track) { return !needed[track.node]; });
  for (const NodeTrack& track : other.tracks)
    if (needed[track.node] &&
        std::none_of(animation.tracks.begin(), animation.tracks.end(), [&](const NodeTrack& t) { return t.node == track.node; }))
      out.tracks.push_back(still_track(track.node, rest_of(model.skeleton.nodes[track.node], model.name, animation.name)));
  std::sort(out.tracks.begin(), out.tracks.end(), [](const NodeTrack& a, const NodeTrack& b) { return a.node < b.node; });
  return out;
}

// Returns the motion over two ranges, one after the other.
Motion<double> joined(const Motion<double>& a, const Motion<double>& b, bool with_jump) {
  const Motion<double> wide = widest(a, b);
  if (with_jump) return {wide.size, unbounded, unbounded};
  return {wide.size, wide.speed, wide.speed > 0 ? unbounded : 0};
}

double coefficient_dot(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs().dot(b.coeffs()); }

// Returns the quaternion at a share of the arc from p to q, even if that is the longer way. The arc is no half turn.
Eigen::Quaterniond on_arc(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q, double share) {
  const double angle = 2 * std::atan2((q.coeffs() - p.coeffs()).norm(), (q.coeffs() + p.coeffs()).norm()),
               whole = std::sin(angle);
  if (angle < 1e-8) return Eigen::Quaterniond(((1 - share) * p.coeffs() + share * q.coeffs()).normalized());
  return Eigen::Quaterniond(
      ((std::sin((1 - share) * angle) * p.coeffs() + std::sin(share * angle) * q.coeffs()) / whole).normalized());
}

// Returns how far a curve goes at most in half of a range.
double travel(const Motion<double>& motion, const ParameterRange& range) {
  return range.start < range.end ? motion.speed * (range.end - range.start) / 2 : 0;
}

double middle_of(const ParameterRange& range) { return range.start + (range.end - range.start) / 2; }

// Returns the side of the middle that belongs to the range. Between neighbouring numbers the middle is one of the ends.
Side side_of_middle(const ParameterRange& range) {
  return middle_of(range) < range.end ? Side::after : side_of_end(range.start, range.end);
}

// Returns the parameter whose halving tells most of a rotation that is not known: the time that turns more or, where neither
// turns, the one that has several parts, since only a box of one part each is split by signs; else the weight.
std::size_t parameter_to_halve(const double (&turned)[2], const std::vector<ParameterRange>& ranges) {
  if (turned[0] + turned[1] > 0) return turned[0] >= turned[1] ? 0 : 1;
  for (const std::size_t k : {0, 1})
    if (ranges[k].first_part < ranges[k].last_part) return k;
  return 2;
}

// Returns the motion of a faded vector in each of the three parameters. apart_in_the_middle is the distance of both clips'
// vectors in the middle of their ranges.
std::array<Motion<double>, 3> faded(const Motion<double>& x, const Motion<double>& y, double apart_in_the_middle,
                                    const std::vector<ParameterRange>& ranges) {
  const double apart = apart_in_the_middle + travel(x, ranges[0]) + travel(y, ranges[1]);
  return {faded_by_time(x, y.size, 1 - ranges[2].start), faded_by_time(y, x.size, ranges[2].end),
          faded_by_weight(x.size, y.size, std::min(apart, x.size + y.size))};
}

// Returns the same for rotations whose dot products are no less than the cosine, which is in [-1/2, 1].
std::array<Motion<double>, 3> faded_rotation(const Motion<double>& p, const Motion<double>& q, double cosine,
                                             const std::vector<ParameterRange>& ranges, RotationBlend how) {
  if (how == RotationBlend::nlerp)
    return {nlerp_motion(faded_by_time(p, 1.0, 1 - ranges[2].start), cosine),
            nlerp_motion(faded_by_time(q, 1.0, ranges[2].end), cosine),
            nlerp_motion(faded_by_weight(1.0, 1.0, gap_of_units(cosine)), cosine)};
  const ParameterRange& w = ranges[2];
  const double nearest_half = std::clamp(0.5, w.start, w.end);
  const auto by_time = [&](const Motion<double>& m, double share) {
    return cosine >= 0 ? slerp_by_time(m, cosine, share, nearest_half * (1 - nearest_half))
                       : Motion<double>{1, slerp_speed_beyond(m.speed), m.speed > 0 || m.acceleration > 0 ? unbounded : 0};
  };
  return {by_time(p, 1 - w.start), by_time(q, w.end), slerp_by_weight(cosine)};
}

}  // namespace

FadingClip::FadingClip(const Model& model, const Animation& animation, const Animation& other, std::span<const int> joints,
                       bool needs_stretches)
    : model_(model),
      animation_(completed(model, animation, other, nodes_above(model.skeleton, joints))),
      needs_stretches_(needs_stretches) {
  const DefaultFloatEnvironment environment;
  times_ = part_times(model.name, model.skeleton.nodes, animation_);
  for (const double time : times_)
    if (jumps_at(animation_, time)) jumps_.push_back(time);
  for (const MorphedMesh& mesh : model.morphs) weight_tracks_.push_back(weight_track_of(mesh, animation_));
}

std::shared_ptr<const FadingClip::Motions> FadingClip::motions(int first_part, int last_part) const {
  return known_.get({first_part, last_part},
                    [&] { return first_part == last_part ? of_part(first_part) : of_parts(first_part, last_part); });
}

FadingClip::Motions FadingClip::of_part(int part) const {
  const DefaultFloatEnvironment environment;
  const double start = times_[part], end = times_[part + 1];
  Motions out;
  for (const NodeTrack& track : animation_.tracks) out.tracks.push_back(track_motion(track, start, end));
  for (std::size_t m = 0; m < weight_tracks_.size(); ++m)
    out.weights.push_back(weight_motions(model_.morphs[m], weight_tracks_[m], start, end));
  if (needs_stretches_) out.stretches = stretches(model_.skeleton.nodes, animation_, start, end);
  out.rounding = growth_of_rounding(animation_, start, end);
  return out;
}

FadingClip::Motions FadingClip::of_parts(int first, int last) const {
  const DefaultFloatEnvironment environment;
  const int middle = first + (last - first) / 2;
  const bool with_jump = std::binary_search(jumps_.begin(), jumps_.end(), times_[middle + 1]);
  Motions out = *motions(first, middle);
  const auto late = motions(middle + 1, last);
  for (std::size_t i = 0; i < out.tracks.size(); ++i) {
    LinkMotion<double>& track = out.tracks[i];
    track = {joined(track.translation, late->tracks[i].translation, with_jump),
             joined(track.rotation, late->tracks[i].rotation, with_jump), joined(track.scale, late->tracks[i].scale, with_jump)};
  }
  for (std::size_t m = 0; m < out.weights.size(); ++m)
    for (std::size_t t = 0; t < out.weights[m].size(); ++t)
      out.weights[m][t] = joined(out.weights[m][t], late->weights[m][t], with_jump);
  for (std::size_t n = 0; n < out.stretches.size(); ++n) out.stretches[n] = widest_of(out.stretches[n], late->stretches[n]);
  out.rounding = std::max(out.rounding, late->rounding);
  return out;
}

Eigen::VectorXd FadingClip::weights(std::size_t mesh, double time, Side side) const {
  return weights_at(model_.morphs[mesh], weight_tracks_[mesh], time, side);
}

ParameterRange FadingClip::whole() const { return {0, static_cast<int>(times_.size()) - 2, times_.front(), times_.back()}; }

std::vector<ParameterRange> FadingClip::halves(const ParameterRange& range) const {
  if (range.first_part < range.last_part) {
    const int middle = range.first_part + (range.last_part - range.first_part) / 2;
    return {{range.first_part, middle, range.start, times_[middle + 1]},
            {middle + 1, range.last_part, times_[middle + 1], range.end}};
  }
  const double middle = middle_of(range);
  if (!(range.start < middle && middle < range.end)) return {};
  return {{range.first_part, range.last_part, range.start, middle}, {range.first_part, range.last_part, middle, range.end}};
}

Side FadingClip::side_of(double time, Side side) const {
  return std::binary_search(jumps_.begin(), jumps_.end(), time) ? side : Side::after;
}

CrossfadedJoints::CrossfadedJoints(const Model& model, const Animation& first, const Animation& second,
                                   std::span<const int> joints, RotationBlend rotations, bool needs_pose)
    : model_(model),
      rotations_(rotations),
      needs_pose_(needs_pose),
      first_(model, first, second, joints, needs_pose),
      second_(model, second, first, joints, needs_pose),
      cells_(bytes_of_cache / (1 + model.skeleton.nodes.size() * 6 * sizeof(ChainMotion<double>))),
      posed_(bytes_of_cache / (1 + model.skeleton.joints.size() * sizeof(Eigen::Matrix4d))) {
  if (model.skeleton.joints.size() != model.joints.size())
    throw ModelError(model.name, "clip '" + first.name + "'", "it has no keys, and nothing is known of it between poses");
}

std::vector<ParameterBox> CrossfadedJoints::boxes() const { return {{{first_.whole(), second_.whole(), {0, 0, 0, 1}}}}; }

std::vector<ParameterBox> CrossfadedJoints::halves(const ParameterBox& box, std::size_t parameter, bool is_known) const {
  const ParameterRange& range = box.ranges[parameter];
  if (!is_known && range.first_part == range.last_part)
    if (const std::optional<int> node = known(box)->across) {
      std::vector<ParameterBox> out;
      for (const bool is_opposite : {false, true}) {
        out.push_back(box);
        auto& signs = out.back().signs;
        const NodeSign sign{*node, is_opposite};
        signs.insert(std::lower_bound(signs.begin(), signs.end(), sign), sign);
      }
      return out;
    }
  std::vector<ParameterRange> ranges;
  if (parameter < 2) ranges = (parameter == 0 ? first_ : second_).halves(range);
  else if (const double middle = middle_of(range); range.start < middle && middle < range.end)
    ranges = {{0, 0, range.start, middle}, {0, 0, middle, range.end}};
  std::vector<ParameterBox> out;
  for (const ParameterRange& half : ranges) {
    out.push_back(box);
    out.back().ranges[parameter] = half;
  }
  return out;
}

JointCell CrossfadedJoints::cell(const ParameterBox& box) const { return known(box)->cell; }

std::shared_ptr<const CrossfadedJoints::KnownCell> CrossfadedJoints::known(const ParameterBox& box) const {
  return cells_.get(box, [&] { return make(box); });
}

CrossfadedJoints::KnownCell CrossfadedJoints::make(const ParameterBox& box) const {
  const DefaultFloatEnvironment environment;
  const std::vector<ParameterRange>& ranges = box.ranges;
  const auto first = first_.motions(ranges[0].first_part, ranges[0].last_part),
             second = second_.motions(ranges[1].first_part, ranges[1].last_part);
  const std::vector<SceneNode>& nodes = model_.skeleton.nodes;
  std::array<std::shared_ptr<JointMotions>, 3> motions;
  for (auto& m : motions) {
    m = std::make_shared<JointMotions>();
    for (const SceneNode& node : nodes) m->links.push_back(still_link(node));
  }
  const bool has_one_part = ranges[0].first_part == ranges[0].last_part && ranges[1].first_part == ranges[1].last_part;
  KnownCell out;
  std::vector<Stretch> stretched;
  if (needs_pose_)
    for (std::size_t n = 0; n < nodes.size(); ++n) stretched.push_back(widest_of(first->stretches[n], second->stretches[n]));
  for (std::size_t i = 0; i < first->tracks.size(); ++i) {
    const LinkMotion<double>&x = first->tracks[i], &y = second->tracks[i];
    const NodeTransform p = transform_at(first_.tracks()[i], middle_of(ranges[0]), side_of_middle(ranges[0])),
                        q = transform_at(second_.tracks()[i], middle_of(ranges[1]), side_of_middle(ranges[1]));
    const int node = first_.tracks()[i].node;
    const auto sign = std::find_if(box.signs.begin(), box.signs.end(), [&](const NodeSign& s) { return s.node == node; });
    const double dot = coefficient_dot(p.rotation, q.rotation),
                 turned[] = {travel(x.rotation, ranges[0]), travel(y.rotation, ranges[1])};
    const double change = turned[0] + turned[1] + rounding_of_cosine;
    const bool is_forced = sign != box.signs.end();
    double cosine = (is_forced ? (sign->is_opposite ? -dot : dot) : std::abs(dot)) - change;
    const bool is_known = cosine >= (is_forced ? -0.5 : rounding_of_cosine_in_float);
    if (!is_known && !is_forced && change <= most_travel_across && has_one_part && !out.across) out.across = node;
    if (!is_known) cosine = 0;
    auto rotations = faded_rotation(x.rotation, y.rotation, cosine, ranges, rotations_);
    if (!is_known) rotations[parameter_to_halve(turned, ranges)].speed = unbounded;
    const auto translations = faded(x.translation, y.translation, norm<double, 3>(q.translation - p.translation), ranges),
               scales = faded(x.scale, y.scale, (q.scale - p.scale).cwiseAbs().maxCoeff(), ranges);
    for (int k = 0; k < 3; ++k) motions[k]->links[node] = chain_of<double>({translations[k], rotations[k], scales[k]});
    if (needs_pose_ && (p.scale.array() * q.scale.array() <= 0).any()) stretched[node].least = 0;
  }
  for (std::size_t m = 0; m < model_.morphs.size(); ++m) {
    const Eigen::VectorXd there = first_.weights(m, middle_of(ranges[0]), side_of_middle(ranges[0])),
                          here = second_.weights(m, middle_of(ranges[1]), side_of_middle(ranges[1]));
    for (auto& motion : motions) motion->weights.emplace_back();
    for (std::size_t t = 0; t < first->weights[m].size(); ++t) {
      const double apart = std::abs(here[static_cast<Eigen::Index>(t)] - there[static_cast<Eigen::Index>(t)]);
      const auto weights = faded(first->weights[m][t], second->weights[m][t], apart, ranges);
      for (int k = 0; k < 3; ++k) motions[k]->weights[m].push_back(weights[k]);
    }
  }
  out.cell.joints = this;
  for (int k = 0; k < 3; ++k) {
    motions[k]->chains = chain_motions(nodes, motions[k]->links);
    out.cell.motions.push_back(std::move(motions[k]));
    out.cell.sides.push_back(ranges[k].end - ranges[k].start);
  }
  out.cell.corners = corners_of(box);
  // A sign belongs to the quaternions of its part. Behind a key, the same rotation may have the opposite sign.
  for (ParameterMoment& corner : out.cell.corners) {
    for (const auto& [clip, k] : {std::pair(&first_, 0), std::pair(&second_, 1)}) {
      auto& [value, side] = corner.coordinates[k];
      if (box.signs.empty()) side = clip->side_of(value, side);
    }
    corner.coordinates[2].side = Side::after;
  }
  out.cell.defect = needs_pose_ ? defect_of(model_.skeleton, stretched) : 0;
  out.cell.rounding = growth_by_blend * std::max(first->rounding, second->rounding);
  return out;
}

std::shared_ptr<const PosedJoints> CrossfadedJoints::at(const ParameterMoment& moment) const {
  return posed_.get(moment, [&] { return posed(moment); });
}

PosedJoints CrossfadedJoints::posed(const ParameterMoment& moment) const {
  const DefaultFloatEnvironment environment;
  const ParameterMoment::Coordinate &a = moment.coordinates[0], &b = moment.coordinates[1];
  const double weight = moment.coordinates[2].value;
  std::vector<Eigen::Matrix4d> locals;
  for (const SceneNode& node : model_.skeleton.nodes) locals.push_back(node.local);
  for (std::size_t i = 0; i < first_.tracks().size(); ++i) {
    const int node = first_.tracks()[i].node;
    const NodeTransform p = transform_at(first_.tracks()[i], a.value, a.side),
                        q = transform_at(second_.tracks()[i], b.value, b.side);
    const auto sign = std::find_if(moment.signs.begin(), moment.signs.end(), [&](const NodeSign& s) { return s.node == node; });
    const bool is_opposite = sign != moment.signs.end() ? sign->is_opposite : coefficient_dot(p.rotation, q.rotation) < 0;
    const Eigen::Quaterniond to(is_opposite ? Eigen::Vector4d(-q.rotation.coeffs()) : Eigen::Vector4d(q.rotation.coeffs()));
    const Eigen::Quaterniond turned =
        rotations_ == RotationBlend::slerp
            ? on_arc(p.rotation, to, weight)
            : Eigen::Quaterniond(((1 - weight) * p.rotation.coeffs() + weight * to.coeffs()).normalized());
    locals[node] =
        matrix_of({(1 - weight) * p.translation + weight * q.translation, (1 - weight) * p.scale + weight * q.scale, turned});
  }
  PosedJoints out{skin_matrices(model_.skeleton, locals), {}, {}};
  for (std::size_t m = 0; m < model_.morphs.size(); ++m)
    out.weights.push_back((1 - weight) * first_.weights(m, a.value, a.side) + weight * second_.weights(m, b.value, b.side));
  check_finite(*this, out, std::to_string(a.value) + " s and " + std::to_string(b.value) + " s");
  if (needs_pose_) {
    std::ostringstream when;
    when << "times " << a.value << " s and " << b.value << " s, weight " << weight;
    out.pose = rigid_pose(model_.skeleton, out.matrices, first_.name() + "' faded to '" + second_.name(), when.str()).pose;
  }
  return out;
}

}  // namespace refitlab
