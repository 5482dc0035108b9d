// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/node_motions.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/a1_affine_image.hpp"
#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/c2_channel_motion.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {
namespace {

// A spline of unit quaternions is divided if one in the middle is shorter than this. Normalising makes it turn faster by as much.
constexpr double shortest_usual_blend = 0.5;
constexpr int most_divisions = 30;

Vec<double, 3> coefficients(const Eigen::Vector3d& v) { return v; }
Quaternion<double> coefficients(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

// Returns the last key that is not after this time. Returns -1 if the channel stays there, which is before its first key and from
// its last one on.
template <class Value>
int key_before(const Channel<Value>& channel, double time) {
  const auto after =
      std::upper_bound(channel.keys.begin(), channel.keys.end(), time, [](double t, const auto& key) { return t < key.time; });
  return after == channel.keys.end() ? -1 : static_cast<int>(after - channel.keys.begin()) - 1;
}

// Returns the part of a cubic from one share of its time to another, by its polar form.
template <int D>
CubicCurve<double, D> part_of(const CubicCurve<double, D>& curve, double from, double to) {
  const auto blossom = [&](double a, double b, double c) {
    auto p = curve.points;
    for (int i = 0; i < 3; ++i) p[i] = between<double, D>(p[i], p[i + 1], a);
    for (int i = 0; i < 2; ++i) p[i] = between<double, D>(p[i], p[i + 1], b);
    return between<double, D>(p[0], p[1], c);
  };
  return {{blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)},
          curve.duration * (to - from)};
}

template <class Value>
auto curve_between(const Channel<Value>& channel, int key, double start, double end) {
  const Key<Value>&a = channel.keys[key], &b = channel.keys[key + 1];
  constexpr int dimension = decltype(coefficients(a.value))::RowsAtCompileTime;
  const double duration = b.time - a.time;
  const auto whole =
      spline_curve<double, dimension>(coefficients(a.value), coefficients(channel.tangents[key].out),
                                      coefficients(channel.tangents[key + 1].into), coefficients(b.value), duration);
  return part_of<dimension>(whole, (start - a.time) / duration, (end - a.time) / duration);
}

// Returns a lower bound of the length of all quaternions of a spline. It is not positive if none is known.
double least_length(const CubicCurve<double, 4>& curve) {
  const Quaternion<double> axis = curve.points[0] + curve.points[3];
  const double length = norm<double, 4>(axis);
  return length > 0 ? least_along<double>(curve.points, axis) / length : 0;
}

template <class Norm>
Motion<double> vector_motion(const Channel<Eigen::Vector3d>& channel, double start, double end, const Norm& norm) {
  const int key = key_before(channel, start);
  if (key < 0) {
    const bool is_late = start >= channel.keys.front().time;
    return at_rest(norm(coefficients(is_late ? channel.keys.back().value : channel.keys.front().value)));
  }
  const auto &a = channel.keys[key], &b = channel.keys[key + 1];
  switch (channel.interpolation) {
    case Interpolation::step: return at_rest(norm(coefficients(a.value)));
    case Interpolation::linear: return linear_motion<double, 3>(a.value, b.value, b.time - a.time, norm);
    case Interpolation::cubic: break;
  }
  return cubic_motion(curve_between(channel, key, start, end), norm);
}

Motion<double> rotation_motion(const Channel<Eigen::Quaterniond>& channel, double start, double end) {
  const int key = key_before(channel, start);
  if (key < 0 || channel.interpolation == Interpolation::step) return at_rest(1.0);
  const auto &a = channel.keys[key], &b = channel.keys[key + 1];
  if (channel.interpolation == Interpolation::linear) {
    const Quaternion<double> from = coefficients(a.value);
    return slerp_motion<double>(from, by_shorter_way<double>(from, coefficients(b.value)), b.time - a.time);
  }
  const auto curve = curve_between(channel, key, start, end);
  return normalized_motion(cubic_motion(curve, by_length), least_length(curve));
}

// Returns the spline of rotations, if the channel is one and moves from start on. start and end are between two of its keys.
std::optional<CubicCurve<double, 4>> rotation_spline(const NodeTrack& track, double start, double end) {
  if (track.rotations.interpolation != Interpolation::cubic) return std::nullopt;
  const int key = key_before(track.rotations, start);
  if (key < 0) return std::nullopt;
  return curve_between(track.rotations, key, start, end);
}

// Returns whether the spline is certainly longer than shortest_usual_blend, or, if its ends are short, than half of them.
bool is_long(const CubicCurve<double, 4>& curve) {
  const double ends = std::min(norm<double, 4>(curve.points[0]), norm<double, 4>(curve.points[3]));
  return least_length(curve) >= shortest_usual_blend * std::min(1.0, ends) && ends > 0;
}

// Divides the time until all splines are long. They are divided together: a part of a long one need not be long, as seen from its
// own ends, where other channels' keys cut it.
void divide(const Animation& animation, double start, double end, int divisions,
            const std::function<void(const NodeTrack&)>& fail, std::vector<double>& times) {
  for (const NodeTrack& track : animation.tracks) {
    const auto curve = rotation_spline(track, start, end);
    if (!curve || is_long(*curve)) continue;
    const double middle = start + (end - start) / 2;
    if (divisions == most_divisions || !(start < middle && middle < end)) fail(track);
    divide(animation, start, middle, divisions + 1, fail, times);
    times.push_back(middle);
    divide(animation, middle, end, divisions + 1, fail, times);
    return;
  }
}

template <class Value>
bool jumps(const Channel<Value>& channel, double time) {
  const auto first =
      std::lower_bound(channel.keys.begin(), channel.keys.end(), time, [](const auto& key, double t) { return key.time < t; });
  if (first == channel.keys.end() || first->time != time) return false;
  const bool is_step = channel.interpolation == Interpolation::step && first != channel.keys.begin();
  return is_step || (first + 1 != channel.keys.end() && (first + 1)->time == time);
}

// At a moment nothing moves.
Motion<double> during(double start, double end, const Motion<double>& motion) {
  return start < end ? motion : at_rest(motion.size);
}

// Takes homogeneous coordinates: of a point they end with 1, and of a displacement with 0.
ImageLength length_of_image(const Eigen::Matrix4d& offset, const Eigen::Vector4d& v) {
  const Eigen::Vector3d translation = offset.topRightCorner<3, 1>() * v[3];
  const double summed = stretch_of(offset).most * norm<double, 3>(v.head<3>()) + translation.norm();
  const Point3 image = offset.topLeftCorner<3, 3>() * v.head<3>() + translation;
  return {norm<double, 3>(image) + rounding_of_image * summed, summed};
}

// The file's own offset and coordinates differ from the model's where the vertex's mesh is placed.
ImageLength length_of_image(const Model& model, const Eigen::Matrix4d& offset, int vertex, const Eigen::Vector4d& v) {
  const DefaultFloatEnvironment environment;
  ImageLength out = length_of_image(offset, v);
  for (const PlacedVertex& placed : placed_vertices(model, vertex)) {
    const Eigen::Matrix4d& placement = model.placements[static_cast<std::size_t>(placed.placement)];
    out.summed = std::max(out.summed, length_of_image(offset * placement, placement.inverse() * v).summed);
  }
  return out;
}

}  // namespace

Stretch stretch_of(const Eigen::Matrix4d& matrix) {
  const DefaultFloatEnvironment environment;
  const Eigen::Vector3d factors = Eigen::Matrix3d(matrix.topLeftCorner<3, 3>()).jacobiSvd().singularValues();
  return {factors[2], factors[0]};
}

std::vector<double> smooth_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation) {
  const DefaultFloatEnvironment environment;
  std::vector<double> times = key_times(animation, std::numeric_limits<std::size_t>::max());
  const auto fail = [&](const NodeTrack& track) {
    throw ModelError(file, "clip '" + animation.name + "', joint '" + nodes[track.node].name + "'",
                     "its cubic spline of rotations passes through zero, where it turns without a bound");
  };
  const std::size_t count = times.size();
  for (std::size_t i = 0; i + 1 < count; ++i) divide(animation, times[i], times[i + 1], 0, fail, times);
  divide(animation, animation.duration, animation.duration, 0, fail, times);
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<double> part_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation) {
  std::vector<double> times = smooth_times(file, nodes, animation);
  if (const double end = times.back(); times.size() == 1 || jumps_at(animation, end)) times.push_back(end);
  return times;
}

bool jumps_at(const Animation& animation, double time) {
  return std::any_of(animation.tracks.begin(), animation.tracks.end(),
                     [&](const NodeTrack& track) {
                       return jumps(track.positions, time) || jumps(track.rotations, time) || jumps(track.scales, time);
                     }) ||
         std::any_of(animation.weight_tracks.begin(), animation.weight_tracks.end(),
                     [&](const WeightTrack& track) { return jumps(track.weights, time); });
}

LinkMotion<double> track_motion(const NodeTrack& track, double start, double end) {
  const DefaultFloatEnvironment environment;
  return {during(start, end, vector_motion(track.positions, start, end, by_length)),
          during(start, end, rotation_motion(track.rotations, start, end)),
          during(start, end, vector_motion(track.scales, start, end, by_greatest_factor))};
}

ChainMotion<double> still_link(const SceneNode& node) {
  const DefaultFloatEnvironment environment;
  const Eigen::Matrix4d& local = node.local;
  const AffineMap<double> map{{local.col(0).head<3>(), local.col(1).head<3>(), local.col(2).head<3>()}, local.col(3).head<3>()};
  return {at_rest(std::sqrt(squared_stretch(map))), at_rest(norm<double, 3>(map.offset)), at_rest(1.0)};
}

std::vector<ChainMotion<double>> link_motions(const std::vector<SceneNode>& nodes, const Animation& animation, double start,
                                              double end) {
  const DefaultFloatEnvironment environment;
  std::vector<ChainMotion<double>> links;
  for (const SceneNode& node : nodes) links.push_back(still_link(node));
  for (const NodeTrack& track : animation.tracks) links[track.node] = chain_of(track_motion(track, start, end));
  return links;
}

std::vector<Motion<double>> weight_motions(const WeightTrack& track, double start, double end) {
  std::vector<Motion<double>> out;
  for (Eigen::Index i = 0; i < track.weights.keys.front().value.size(); ++i) {
    // The weight becomes the first coordinate of a position.
    Channel<Eigen::Vector3d> one{{}, track.weights.interpolation, {}};
    for (const auto& key : track.weights.keys) one.keys.push_back({key.time, key.value[i] * Point3::UnitX()});
    for (const auto& t : track.weights.tangents)
      one.tangents.push_back({t.into[i] * Point3::UnitX(), t.out[i] * Point3::UnitX()});
    out.push_back(during(start, end, vector_motion(one, start, end, by_length)));
  }
  return out;
}

std::vector<Motion<double>> weight_motions(const MorphedMesh& mesh, const WeightTrack* track, double start, double end) {
  const DefaultFloatEnvironment environment;
  if (track) return weight_motions(*track, start, end);
  std::vector<Motion<double>> out;
  for (const double w : mesh.weights) out.push_back(at_rest(std::abs(w)));
  return out;
}

std::vector<Stretch> stretches(const std::vector<SceneNode>& nodes, const Animation& animation, double start, double end) {
  const DefaultFloatEnvironment environment;
  std::vector<Stretch> out;
  for (const SceneNode& node : nodes) out.push_back(stretch_of(node.local));
  for (const NodeTrack& track : animation.tracks) {
    std::vector<Eigen::Vector3d> hull;  // of the scales
    const auto& keys = track.scales.keys;
    if (const int key = key_before(track.scales, start); key < 0) {
      hull = {start >= keys.front().time ? keys.back().value : keys.front().value};
    } else if (track.scales.interpolation == Interpolation::cubic) {
      for (const auto& point : curve_between(track.scales, key, start, end).points) hull.push_back(point);
    } else {
      hull = {keys[key].value};
      if (track.scales.interpolation == Interpolation::linear) hull.push_back(keys[key + 1].value);
    }
    Stretch stretch{std::numeric_limits<double>::infinity(), 0};
    for (const Eigen::Vector3d& scale : hull)
      for (int i = 0; i < 3; ++i) {
        const bool keeps_sign = scale[i] * hull[0][i] > 0;
        stretch.least = std::min(stretch.least, keeps_sign ? std::abs(scale[i]) : 0);
        stretch.most = std::max(stretch.most, std::abs(scale[i]));
      }
    out[track.node] = stretch;
  }
  return out;
}

double defect_of(const BoundSkeleton& skeleton, const std::vector<Stretch>& links) {
  const DefaultFloatEnvironment environment;
  double greatest = 0;
  for (const BoundJoint& joint : skeleton.joints) {
    // Each link is a factor times a rotation times I + E, with ||E|| at most its noise. The rotations' product differs from the
    // whole by what the noises add up to, and by how far the factors' product is from 1.
    double factor = 1, noise = 1;
    const auto add = [&](const Stretch& link) {
      factor *= std::sqrt(link.least * link.most);
      noise *= std::sqrt(link.most / link.least);
    };
    add(stretch_of(joint.offset));
    for (int n = joint.node; n >= 0; n = skeleton.nodes[n].parent) add(links[n]);
    const double defect = factor * (noise - 1) + std::abs(factor - 1);
    greatest = std::max(greatest, defect >= 0 ? defect : std::numeric_limits<double>::infinity());
  }
  return greatest;
}

ImageLength length_of_vertex(const Model& model, const Eigen::Matrix4d& offset, int vertex) {
  return length_of_image(model, offset, vertex, model.vertices[static_cast<std::size_t>(vertex)].homogeneous());
}

ImageLength length_of_displacement(const Model& model, const Eigen::Matrix4d& offset, int vertex, const Point3& d) {
  return length_of_image(model, offset, vertex, {d[0], d[1], d[2], 0});
}

double growth_of_rounding(const Animation& animation, double start, double end) {
  const DefaultFloatEnvironment environment;
  double growth = 1;
  for (const NodeTrack& track : animation.tracks)
    if (const auto part = rotation_spline(track, start, end)) {
      const int key = key_before(track.rotations, start);
      const auto& keys = track.rotations.keys;
      const auto whole = curve_between(track.rotations, key, keys[key].time, keys[key + 1].time);
      growth = std::max(growth, cubic_motion(whole, by_length).size / least_length(*part));
    }
  return growth;
}

std::vector<ChainMotion<double>> chain_motions(const std::vector<SceneNode>& nodes,
                                               const std::vector<ChainMotion<double>>& links) {
  const DefaultFloatEnvironment environment;
  std::vector<ChainMotion<double>> chains = links;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].parent >= 0) chains[n] = compose(chains[nodes[n].parent], links[n]);
  return chains;
}

ChainMotion<double> chain_below(const std::vector<SceneNode>& nodes, const std::vector<ChainMotion<double>>& links, int ancestor,
                                int node) {
  const DefaultFloatEnvironment environment;
  ChainMotion<double> chain = no_links<double>();
  for (; node != ancestor; node = nodes[node].parent) chain = compose(links[node], chain);
  return chain;
}

}  // namespace refitlab
