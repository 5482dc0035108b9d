// SPDX-License-Identifier: GPL-3.0-or-later
// Computes where an animation takes a skinned vertex, written from the definitions and from nothing in algorithms/ but its data:
// slerp by sines, Hermite's polynomials, products of 4x4 matrices, blends of matrices and of dual quaternions. Over intervals of
// 60 digits it is a certain enclosure, over jets of those it has derivatives, and over double it is quick.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/bake/over_time/moving_joints.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/exact/multiprecision_interval.hpp"
#include "proptests/oracles/rotation_center.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/slerp.hpp"

namespace proptests::oracle {

// This is thrown at a moment at which the definition does not say where things are, or rounding would have to: a slerp between
// quaternions at right angles, a joint at half a turn from the first one, a blend that vanishes, a center that tolerances choose.
struct Ambiguous {};

template <class S>
using Matrix4 = std::array<std::array<S, 4>, 4>;

template <class S>
double middle_of(const S& x) {
  if constexpr (std::is_same_v<S, double>) return x;
  else if constexpr (requires { x.first; }) return middle_of(x.value);
  else return static_cast<double>(median(x));
}

template <class S>
Matrix4<S> product(const Matrix4<S>& a, const Matrix4<S>& b) {
  Matrix4<S> out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      out[i][j] = a[i][0] * b[0][j];
      for (int k = 1; k < 4; ++k) out[i][j] = out[i][j] + a[i][k] * b[k][j];
    }
  return out;
}

template <class S>
S number(double x) {
  if constexpr (std::is_same_v<S, double>) return x;
  else if constexpr (requires(S y) { y.first; }) return S(number<decltype(S().value)>(x));
  else return S(x);
}

template <class S>
Matrix4<S> matrix_of(const Eigen::Matrix4d& m) {
  Matrix4<S> out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) out[i][j] = number<S>(m(i, j));
  return out;
}

// Returns the quaternion of the rotation in a matrix that is a rotation but for a factor, which may be negative, and a little
// noise, by Newton's iteration for the polar decomposition and Shepperd's formulas.
template <class S>
refitlab::Quaternion<S> rotation_in(const Eigen::Matrix4d& matrix) {
  const double factor = std::cbrt(matrix.topLeftCorner<3, 3>().determinant());
  std::array<std::array<S, 3>, 3> m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m[i][j] = number<S>(matrix(i, j)) / number<S>(factor);
  for (int step = 0; step < 7; ++step) {
    std::array<std::array<S, 3>, 3> cofactors;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        cofactors[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
      }
    const S determinant = m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m[i][j] = (m[i][j] + cofactors[i][j] / determinant) / S(2);
  }
  // These are 4 times the squares of w, x, y and z, and the root of the greatest is taken.
  const S traces[4] = {S(1) + m[0][0] + m[1][1] + m[2][2], S(1) + m[0][0] - m[1][1] - m[2][2], S(1) - m[0][0] + m[1][1] - m[2][2],
                       S(1) - m[0][0] - m[1][1] + m[2][2]};
  int largest = 0;
  for (int i = 1; i < 4; ++i)
    if (middle_of(traces[i]) > middle_of(traces[largest])) largest = i;
  const S wx = m[2][1] - m[1][2], wy = m[0][2] - m[2][0], wz = m[1][0] - m[0][1], xy = m[1][0] + m[0][1], xz = m[2][0] + m[0][2],
          yz = m[2][1] + m[1][2];
  const S products[4][4] = {{traces[0], wx, wy, wz}, {wx, traces[1], xy, xz}, {wy, xy, traces[2], yz}, {wz, xz, yz, traces[3]}};
  refitlab::Quaternion<S> q;
  for (int i = 0; i < 4; ++i) q[i] = products[largest][i];
  // It may have any length.
  return q;
}

template <class S>
S root_of(const S& x) {
  using std::sqrt;
  if constexpr (requires { x.first; }) {
    const auto r = root_of(x.value);
    const auto slope = x.first / (decltype(r)(2) * r);
    return {r, slope, decltype(r)((x.second / decltype(r)(2) - slope * slope) / r)};
  } else {
    return S(sqrt(x));
  }
}

template <class S>
S product_of_entries(const refitlab::Quaternion<S>& a, const refitlab::Quaternion<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

template <class S>
refitlab::Quaternion<S> unit(refitlab::Quaternion<S> q) {
  const S length = root_of(product_of_entries<S>(q, q));
  for (int i = 0; i < 4; ++i) q[i] = q[i] / length;
  return q;
}

// --- Channels ---

template <class S>
refitlab::Vec<S, 3> numbers(const Eigen::Vector3d& v) {
  return {number<S>(v[0]), number<S>(v[1]), number<S>(v[2])};
}
template <class S>
refitlab::Quaternion<S> numbers(const Eigen::Quaterniond& q) {
  return {number<S>(q.w()), number<S>(q.x()), number<S>(q.y()), number<S>(q.z())};
}

template <class S>
refitlab::Vec<S, 3> between_keys(const refitlab::Vec<S, 3>& a, const refitlab::Vec<S, 3>& b, const S& share) {
  refitlab::Vec<S, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = a[i] * (S(1) - share) + b[i] * share;
  return out;
}
template <class S>
refitlab::Quaternion<S> between_keys(refitlab::Quaternion<S> a, refitlab::Quaternion<S> b, const S& share) {
  using M = refitlab::MultiprecisionInterval;
  M dot(0);
  for (int i = 0; i < 4; ++i) dot += M(middle_of(a[i])) * M(middle_of(b[i]));
  const double cosine = middle_of(dot);
  if (cosine != 0 && std::abs(cosine) < 1e-15) throw Ambiguous();
  a = unit<S>(a), b = unit<S>(b);
  if (cosine < 0)
    for (int i = 0; i < 4; ++i) b[i] = S(0) - b[i];
  bool same = true;
  double apart = 0;
  for (int i = 0; i < 4; ++i) {
    const double d = middle_of(S(a[i] - b[i]));
    same = same && std::abs(d) < 1e-40, apart += d * d;
  }
  if (same) return a;
  if constexpr (std::is_same_v<S, double>) {
    const double angle = 2 * std::asin(std::min(1.0, std::sqrt(apart) / 2)), whole = std::sin(angle);
    const bool is_short = angle < 1e-6;
    return a * (is_short ? 1 - share : std::sin((1 - share) * angle) / whole) +
           b * (is_short ? share : std::sin(share * angle) / whole);
  } else {
    return slerp<S>(a, b, share);
  }
}

// Returns the cubic spline of the glTF specification, appendix C, with tangents per second.
template <class S, int D>
refitlab::Vec<S, D> hermite(const refitlab::Vec<S, D>& a, const refitlab::Vec<S, D>& out_of_a, const refitlab::Vec<S, D>& into_b,
                            const refitlab::Vec<S, D>& b, const S& duration, const S& t) {
  const S t2 = t * t, t3 = t2 * t, h00 = S(2) * t3 - S(3) * t2 + S(1), h10 = t3 - S(2) * t2 + t, h01 = S(3) * t2 - S(2) * t3,
          h11 = t3 - t2;
  refitlab::Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = h00 * a[i] + duration * h10 * out_of_a[i] + h01 * b[i] + duration * h11 * into_b[i];
  return out;
}

// Returns a channel's value at a time, which is when's value. It uses the last of the keys that is not later, or earlier if the
// side before is asked for.
template <class S, class Value>
auto at(const refitlab::Channel<Value>& channel, double time, const S& when, refitlab::Side side) {
  constexpr int D = decltype(numbers<S>(channel.keys[0].value))::RowsAtCompileTime;
  const auto& keys = channel.keys;
  int last = -1;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].time < time || (side == refitlab::Side::after && keys[k].time == time)) last = static_cast<int>(k);
  if (last < 0) return numbers<S>(keys[0].value);
  const auto& a = keys[last];
  if (last + 1 == static_cast<int>(keys.size()) || channel.interpolation == refitlab::Interpolation::step)
    return numbers<S>(a.value);
  const auto& b = keys[last + 1];
  const S duration = number<S>(b.time) - number<S>(a.time), share = (when - number<S>(a.time)) / duration;
  if (channel.interpolation == refitlab::Interpolation::linear)
    return between_keys<S>(numbers<S>(a.value), numbers<S>(b.value), share);
  return hermite<S, D>(numbers<S>(a.value), numbers<S>(channel.tangents[last].out), numbers<S>(channel.tangents[last + 1].into),
                       numbers<S>(b.value), duration, share);
}

// --- Nodes and joints ---

// Holds what a node, or a joint, does: its matrix, and the quaternion of its rotation, where rotations are asked for.
template <class S>
struct Placed {
  Matrix4<S> matrix;
  refitlab::Quaternion<S> turn;
};

// Holds a transform that scales, then turns by a unit quaternion, then moves.
template <class S>
struct Parts {
  refitlab::Vec<S, 3> translation;
  refitlab::Quaternion<S> turn;
  refitlab::Vec<S, 3> scale;
};

template <class S>
Placed<S> placed(const Parts<S>& parts) {
  const Affine<S> affine = affine_of<S>(parts.turn, parts.translation);
  Matrix4<S> m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = i == 3 ? S(j == 3 ? 1 : 0) : j == 3 ? affine[i][3] : S(affine[i][j] * parts.scale[j]);
  return {m, parts.turn};
}

// Returns the parts of a node that the animation moves.
template <class S>
std::optional<Parts<S>> parts_of(const refitlab::Animation& animation, int node, double time, const S& when,
                                 refitlab::Side side) {
  for (const auto& track : animation.tracks)
    if (track.node == node)
      return Parts<S>{at<S>(track.positions, time, when, side), unit<S>(at<S>(track.rotations, time, when, side)),
                      at<S>(track.scales, time, when, side)};
  return std::nullopt;
}

template <class S>
Placed<S> at_rest(const refitlab::SceneNode& node, bool with_turn) {
  Placed<S> out{matrix_of<S>(node.local), {S(1), S(0), S(0), S(0)}};
  if (with_turn) out.turn = unit<S>(rotation_in<S>(node.local));
  return out;
}

// Returns the transforms of nodes against their parents, by node.
template <class S>
std::vector<Placed<S>> local_transforms(const refitlab::BoundSkeleton& skeleton, const refitlab::Animation& animation,
                                        double time, const S& when, refitlab::Side side, bool with_turns) {
  std::vector<Placed<S>> out;
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) {
    const auto parts = parts_of<S>(animation, static_cast<int>(n), time, when, side);
    out.push_back(parts ? placed(*parts) : at_rest<S>(skeleton.nodes[n], with_turns));
  }
  return out;
}

// Returns the transforms of nodes against the scene, by node.
template <class S>
std::vector<Placed<S>> scene_transforms(const refitlab::BoundSkeleton& skeleton, std::vector<Placed<S>> nodes) {
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (const int parent = skeleton.nodes[n].parent; parent >= 0)
      nodes[n] = {product(nodes[parent].matrix, nodes[n].matrix), hamilton<S>(nodes[parent].turn, nodes[n].turn)};
  return nodes;
}

// Places a skinned vertex of a model at the times of an animation.
template <class S>
class AnimatedSkin {
 public:
  AnimatedSkin(const refitlab::Model& model, const refitlab::Animation& animation, refitlab::Skinning skinning)
      : model_(model),
        animation_(animation),
        skinning_(skinning) {
    if (is_rigid())
      for (const auto& joint : model.skeleton.joints) offset_turns_.push_back(unit<S>(rotation_in<S>(joint.offset)));
  }

  // Poses the joints, which is to be done before vertices are asked for. Throws Ambiguous, as vertex does.
  void pose(double time, refitlab::Side side) {
    weights_ = weights_at(animation_, time, side);
    place(local_transforms<S>(model_.skeleton, animation_, time, number<S>(time), side, is_rigid()));
  }

  // Poses the joints in a crossfade to another animation, at a time of each. Rotations are blended by nlerp or by slerp the
  // shorter way, but for nodes with a sign. A node that only one of both moves has its rest transform by its parts.
  void pose(double time, refitlab::Side side, const refitlab::Animation& other, double other_time, refitlab::Side other_side,
            double weight, bool by_nlerp, std::span<const refitlab::NodeSign> signs) {
    const S share = number<S>(weight), left = S(1) - share;
    weights_ = weights_at(animation_, time, side);
    const auto others = weights_at(other, other_time, other_side);
    for (std::size_t m = 0; m < weights_.size(); ++m)
      for (std::size_t t = 0; t < weights_[m].size(); ++t) weights_[m][t] = left * weights_[m][t] + share * others[m][t];
    std::vector<Placed<S>> nodes;
    for (std::size_t n = 0; n < model_.skeleton.nodes.size(); ++n) {
      const auto& node = model_.skeleton.nodes[n];
      auto p = parts_of<S>(animation_, static_cast<int>(n), time, number<S>(time), side),
           q = parts_of<S>(other, static_cast<int>(n), other_time, number<S>(other_time), other_side);
      if (!p && !q) {
        nodes.push_back(at_rest<S>(node, is_rigid()));
        continue;
      }
      const auto rest = [&] {
        const auto& r = node.rest.value();
        return Parts<S>{numbers<S>(r.translation), unit<S>(numbers<S>(r.rotation)), numbers<S>(r.scale)};
      };
      if (!p) p = rest();
      if (!q) q = rest();
      bool is_opposite = false;
      const double cosine = middle_of(product_of_entries<S>(p->turn, q->turn));
      const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& s) { return s.node == static_cast<int>(n); });
      if (sign != signs.end()) is_opposite = sign->is_opposite;
      else if (std::abs(cosine) < 1e-13) throw Ambiguous();
      else is_opposite = cosine < 0;
      if (is_opposite)
        for (int i = 0; i < 4; ++i) q->turn[i] = S(0) - q->turn[i];
      Parts<S> blend = *p;
      for (int i = 0; i < 3; ++i) {
        blend.translation[i] = left * p->translation[i] + share * q->translation[i];
        blend.scale[i] = left * p->scale[i] + share * q->scale[i];
      }
      double apart = 0;
      for (int i = 0; i < 4; ++i) {
        apart += std::abs(middle_of(S(p->turn[i] - q->turn[i])));
        blend.turn[i] = left * p->turn[i] + share * q->turn[i];
      }
      if (!by_nlerp && apart > 1e-14) blend.turn = slerp<S>(p->turn, q->turn, share);
      blend.turn = unit<S>(blend.turn);
      nodes.push_back(placed(blend));
    }
    place(std::move(nodes));
  }

  refitlab::Vec<S, 3> vertex(int v) const {
    using namespace refitlab;
    Vec<S, 3> at = numbers<S>(model_.vertices[v]);
    for (std::size_t m = 0; m < model_.morphs.size(); ++m)
      for (std::size_t t = 0; t < weights_[m].size(); ++t)
        for (const auto& [displaced, by] : model_.morphs[m].targets[t].displacements)
          for (int i = 0; displaced == v && i < 3; ++i) at[i] = at[i] + weights_[m][t] * number<S>(by[i]);
    const auto& influences = model_.influences[v];
    if (!is_rigid()) {
      Matrix4<S> blend = matrix_of<S>(Eigen::Matrix4d::Zero());
      for (const Influence& influence : influences)
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j)
            blend[i][j] = blend[i][j] + number<S>(influence.weight) * joints_[influence.joint].matrix[i][j];
      return times<S>(blend, at);
    }
    std::vector<RigidTransform<S>> transforms;
    std::vector<S> weights;
    for (const Influence& influence : influences) {
      const auto& joint = joints_[influence.joint];
      Quaternion<S> turn = joint.turn;
      if (!transforms.empty()) {
        const double cosine = middle_of(product_of_entries<S>(transforms[0].rotation, turn));
        if (std::abs(cosine) < 1e-14) throw Ambiguous();
        if (cosine < 0)
          for (int i = 0; i < 4; ++i) turn[i] = S(0) - turn[i];
      }
      transforms.push_back({turn, {joint.matrix[0][3], joint.matrix[1][3], joint.matrix[2][3]}});
      weights.push_back(number<S>(influence.weight));
    }
    if (transforms.size() == 1) return oracle::times<S>(affine_of<S>(transforms[0].rotation, transforms[0].translation), at);
    Quaternion<S> q(S(0), S(0), S(0), S(0)), d = q;
    for (std::size_t k = 0; k < transforms.size(); ++k) {
      const auto& t = transforms[k].translation;
      const auto moved = hamilton<S>({S(0), t[0], t[1], t[2]}, transforms[k].rotation);
      for (int i = 0; i < 4; ++i) {
        q[i] = q[i] + weights[k] * transforms[k].rotation[i];
        d[i] = d[i] + weights[k] * moved[i];
      }
    }
    const S length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (middle_of(length) < 1e-12) throw Ambiguous();
    if (skinning_ == Skinning::dual_quaternion) {
      const auto t = hamilton<S>(d, {q[0], S(0) - q[1], S(0) - q[2], S(0) - q[3]});
      return oracle::times<S>(affine_of<S>(q, {t[1] / length, t[2] / length, t[3] / length}), at);
    }
    return spherical<S>(transforms, weights, center(transforms, influences), at);
  }

 private:
  bool is_rigid() const { return skinning_ != refitlab::Skinning::linear; }

  // Returns the weights by target, for each of the morphed meshes.
  std::vector<std::vector<S>> weights_at(const refitlab::Animation& animation, double time, refitlab::Side side) const {
    std::vector<std::vector<S>> out;
    for (const auto& mesh : model_.morphs) {
      out.emplace_back();
      for (const double w : mesh.weights) out.back().push_back(number<S>(w));
      for (const auto& track : animation.weight_tracks)
        for (std::size_t t = 0; track.node == mesh.node && t < mesh.weights.size(); ++t) {
          // A weight moves as a coordinate of a position.
          refitlab::Channel<Eigen::Vector3d> one{{}, track.weights.interpolation, {}};
          const auto i = static_cast<Eigen::Index>(t);
          for (const auto& key : track.weights.keys) one.keys.push_back({key.time, {key.value[i], 0, 0}});
          for (const auto& tangent : track.weights.tangents)
            one.tangents.push_back({{tangent.into[i], 0, 0}, {tangent.out[i], 0, 0}});
          out.back()[t] = oracle::at<S>(one, time, number<S>(time), side)[0];
        }
    }
    return out;
  }

  void place(std::vector<Placed<S>> locals) {
    const auto nodes = scene_transforms(model_.skeleton, std::move(locals));
    joints_.clear();
    for (std::size_t j = 0; j < model_.skeleton.joints.size(); ++j) {
      const auto& joint = model_.skeleton.joints[j];
      const auto& node = nodes[joint.node];
      joints_.push_back({product(node.matrix, matrix_of<S>(joint.offset)), {S(1), S(0), S(0), S(0)}});
      if (is_rigid()) joints_.back().turn = hamilton<S>(node.turn, offset_turns_[j]);
    }
  }

  // Returns the least-squares center nearest to the mean of the joints' origins, by its normal equations, where the tolerances of
  // algorithms/runtime/skinning/rotation_center.hpp have no effect.
  refitlab::Vec<S, 3> center(const std::vector<refitlab::RigidTransform<S>>& transforms,
                             const std::vector<refitlab::Influence>& influences) const {
    using namespace refitlab;
    std::vector<RigidTransform<double>> rounded;
    for (const auto& c : transforms) {
      RigidTransform<double> r;
      for (int i = 0; i < 4; ++i) r.rotation[i] = middle_of(c.rotation[i]);
      for (int i = 0; i < 3; ++i) r.translation[i] = middle_of(c.translation[i]);
      rounded.push_back(r);
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& influence : influences) mean += model_.joints[influence.joint].origin;
    mean /= static_cast<double>(influences.size());
    const RotationCenter found = rotation_center(rounded, mean);
    const Vec<S, 3> prior = numbers<S>(mean);
    if (found.nearest_to_tolerance < 0.05) throw Ambiguous();
    if (found.rank == 0) return prior;
    std::array<std::array<S, 4>, 3> equations;  // N | g
    for (auto& row : equations) row.fill(S(0));
    for (std::size_t a = 0; a < transforms.size(); ++a)
      for (std::size_t b = a + 1; b < transforms.size(); ++b) {
        const auto ca = affine_of<S>(transforms[a].rotation, transforms[a].translation),
                   cb = affine_of<S>(transforms[b].rotation, transforms[b].translation);
        const Vec<S, 3> gap = oracle::times<S>(ca, prior) - oracle::times<S>(cb, prior);
        for (int r = 0; r < 3; ++r)
          for (int i = 0; i < 3; ++i) {
            const S of_i = ca[r][i] - cb[r][i];
            for (int j = 0; j < 3; ++j) equations[i][j] = equations[i][j] + of_i * (ca[r][j] - cb[r][j]);
            equations[i][3] = equations[i][3] - of_i * gap[r];
          }
      }
    if (found.rank == 2) {
      // For two joints nothing is determined along the axis of the relative rotation, and for more only if their axes are
      // parallel.
      if (transforms.size() != 2) throw Ambiguous();
      const auto& p = transforms[0].rotation;
      const auto relative = hamilton<S>({p[0], S(0) - p[1], S(0) - p[2], S(0) - p[3]}, transforms[1].rotation);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) equations[i][j] = equations[i][j] + relative[i + 1] * relative[j + 1];
    } else if (found.rank != 3) {
      throw Ambiguous();
    }
    const auto determinant = [&](int replaced) {
      const auto entry = [&](int i, int j) { return equations[i][j == replaced ? 3 : j]; };
      return S(entry(0, 0) * (entry(1, 1) * entry(2, 2) - entry(1, 2) * entry(2, 1)) -
               entry(0, 1) * (entry(1, 0) * entry(2, 2) - entry(1, 2) * entry(2, 0)) +
               entry(0, 2) * (entry(1, 0) * entry(2, 1) - entry(1, 1) * entry(2, 0)));
    };
    const S whole = determinant(-1);
    Vec<S, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = prior[i] + determinant(i) / whole;
    return out;
  }

  const refitlab::Model& model_;
  const refitlab::Animation& animation_;
  refitlab::Skinning skinning_;
  std::vector<refitlab::Quaternion<S>> offset_turns_;
  std::vector<Placed<S>> joints_;
  std::vector<std::vector<S>> weights_;  // by morphed mesh and target
};

}  // namespace proptests::oracle
