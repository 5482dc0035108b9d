// SPDX-License-Identifier: MIT
// Beyond the paper: how fast a channel of a clip goes between two keys, and how much it bends.
//
// Statement. Between two keys at a distance of T > 0 a channel is bounded in size, speed and acceleration
// (lemmas/vocabulary/motion.hpp) by
// - one key, or a step: its value's length, 0, 0; it jumps at the next key, where intervals end;
// - a linear channel from a to b: max(||a||, ||b||), ||b - a|| / T, 0;
// - a cubic spline, as a Bezier curve: the longest of its points, of those of its derivative, of those of the second;
// - a slerp of unit quaternions a and b with a != -b, where theta is the angle between them: 1, theta / T, theta^2 / T^2; and
//   with t = ||b - a|| / ||b + a||, which is tan(theta / 2), halved three times by t -> t / (1 + sqrt(1 + t^2)),
//   theta <= 16 t.
// A rotation that is a cubic spline is normalised, so the bounds of the spline go through c3_normalized_motion.
// The length of a scale is not Euclidean: it is the greatest factor, by which a diagonal matrix stretches.
// Engines take the shorter way, to b or -b, whose angle is at most a right one; the bound there is at most 1/3 % too great.
//
// Replaces: nothing in the paper, which has no clips.
// Notation: a -> from, b -> to, T -> duration, theta -> angle_at_most.
//
// Proof. Any norm of a convex combination is at most the greatest of the norms, and a Bezier curve and its derivatives are
// convex combinations of their points. A slerp is a circle of radius 1 passed at the speed theta / T. tan x >= x in
// [0, pi / 2), and t -> t / (1 + sqrt(1 + t^2)) is the tangent of the half angle.
#pragma once

#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab {

// by_length is the length of a vector. by_greatest_factor is how much a scale stretches.
// In float and double, squares of small speeds would underflow.
inline constexpr auto by_length = []<class S, int D>(const Vec<S, D>& x) -> S {
  if constexpr (std::is_floating_point_v<S>) return x.stableNorm();
  else return norm<S, D>(x);
};
inline constexpr auto by_greatest_factor = []<class S, int D>(const Vec<S, D>& x) -> S {
  S greatest = max_of(x[0], S(-x[0]));
  for (int i = 1; i < D; ++i) greatest = max_of(greatest, max_of(x[i], S(-x[i])));
  return greatest;
};

template <class S, int D, class Norm>
Motion<S> linear_motion(const Vec<S, D>& from, const Vec<S, D>& to, const S& duration, const Norm& norm) {
  return {max_of(norm(from), norm(to)), norm(Vec<S, D>(to - from)) / duration, S(0)};
}

// Returns the Bezier curve of a cubic spline. Tangents are per second, out of the first key and into the second, as in glTF.
template <class S, int D>
CubicCurve<S, D> spline_curve(const Vec<S, D>& from, const Vec<S, D>& out, const Vec<S, D>& into, const Vec<S, D>& to,
                              const S& duration) {
  const S third = duration / S(3);
  return {{from, Vec<S, D>(from + out * third), Vec<S, D>(to - into * third), to}, duration};
}

template <class S, int D, class Norm>
Motion<S> cubic_motion(const CubicCurve<S, D>& curve, const Norm& norm) {
  const auto longest = [&](const auto& points) {
    S length = norm(points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) length = max_of(length, norm(points[i]));
    return length;
  };
  return {longest(curve.points), longest(curve.velocities()), longest(curve.accelerations())};
}

// Returns b or -b, to which a slerp goes by the shorter way. It is b if both are equally far.
template <class S>
Quaternion<S> by_shorter_way(const Quaternion<S>& from, const Quaternion<S>& to) {
  return choose<bool, S, 4>(certainly_less(dot(from, to), S(0)), -to, to);
}

// Returns theta or a little more, in radians. tangent is tan(theta / 2).
template <class S>
S angle_by_half_tangent(S tangent) {
  for (int i = 0; i < 3; ++i) tangent = tangent / (S(1) + root(S(S(1) + sq(tangent))));
  return S(16) * tangent;
}

// Returns a bound of the angle between both as vectors of R^4, in radians. The rotation turns by twice as much.
template <class S>
S angle_at_most(const Quaternion<S>& from, const Quaternion<S>& to) {
  return angle_by_half_tangent<S>(norm<S, 4>(to - from) / norm<S, 4>(to + from));
}

// Returns the motion of a unit quaternion along a great circle. speed is in radians of R^4 per second.
template <class S>
Motion<S> circle_motion(const S& speed) {
  return {S(1), speed, sq(speed)};
}

template <class S>
Motion<S> slerp_motion(const Quaternion<S>& from, const Quaternion<S>& to, const S& duration) {
  return circle_motion<S>(angle_at_most(from, to) / duration);
}

// --- Hypotheses ---

// A slerp has an arc: both ends have length 1 and are not opposite.
template <class S>
Verdict has_an_arc(const Quaternion<S>& from, const Quaternion<S>& to) {
  return equal(squared_norm(from), S(1)) & equal(squared_norm(to), S(1)) & less(S(-1), dot(from, to));
}

template <class S>
Verdict channel_hypotheses(const S& duration, const S& share) {
  return less(S(0), duration) & is_share(share);
}

// --- Conclusion ---

// The witness is the channel's value at a share of the time between its keys, with its derivatives per second.
template <class S, int D>
struct ChannelMoment {
  Verdict verdict;
  Moment<S, D> moment;
};

// Evaluates a cubic at a share by Bernstein's polynomials.
template <class S, int D>
Vec<S, D> by_bernstein(const CubicCurve<S, D>& curve, const S& share) {
  const S left = S(1) - share;
  return curve.points[0] * S(left * left * left) + curve.points[1] * S(S(3) * left * left * share) +
         curve.points[2] * S(S(3) * left * share * share) + curve.points[3] * S(share * share * share);
}

// Checks the witness independently, by Taylor's polynomial from the moment to a time before both keys and to one behind them. The
// third derivative is constant.
template <class S, int D>
Verdict is_moment_of(const CubicCurve<S, D>& curve, const S& share, const Moment<S, D>& moment) {
  const Vec<S, D> third = (curve.points[3] - curve.points[0]) + (curve.points[1] - curve.points[2]) * S(3);
  const Vec<S, D> here = by_bernstein(curve, share);
  Verdict v = Verdict::holds;
  for (const S& there : {S(-1), S(2)}) {
    const S step = there - share, seconds = step * curve.duration;
    const Vec<S, D> at = by_bernstein(curve, there);
    for (int i = 0; i < D; ++i)
      v &= equal(moment.value[i], here[i]) &
           equal(at[i], S(moment.value[i] + moment.velocity[i] * seconds + moment.acceleration[i] * seconds * seconds / S(2) +
                          third[i] * step * step * step));
  }
  return v;
}

// The lengths of the value and of both derivatives are within the bounds.
template <class S, int D, class Norm>
Verdict is_within(const Moment<S, D>& moment, const Motion<S>& motion, const Norm& norm) {
  return less_equal(norm(moment.value), motion.size) & less_equal(norm(moment.velocity), motion.speed) &
         less_equal(norm(moment.acceleration), motion.acceleration);
}

template <class S, int D, class Norm>
ChannelMoment<S, D> spline_moves(const CubicCurve<S, D>& curve, const S& share, const Norm& norm) {
  const auto v = curve.velocities();
  const auto a = curve.accelerations();
  const Moment<S, D> moment{curve.at(share),
                            between<S, D>(between<S, D>(v[0], v[1], share), between<S, D>(v[1], v[2], share), share),
                            between<S, D>(a[0], a[1], share)};
  return {is_within(moment, cubic_motion(curve, norm), norm), moment};
}

template <class S, int D, class Norm>
ChannelMoment<S, D> line_moves(const Vec<S, D>& from, const Vec<S, D>& to, const S& duration, const S& share, const Norm& norm) {
  const Moment<S, D> moment{between<S, D>(from, to, share), (to - from) / duration, Vec<S, D>::Constant(S(0))};
  return {is_within(moment, linear_motion(from, to, duration, norm), norm), moment};
}

// Judges a slerp that moves at this speed along the great circle from q towards an e across it, both of length 1. q' is the speed
// times e, and q'' points back to 0.
template <class S>
ChannelMoment<S, 4> slerp_moves(const Quaternion<S>& q, const Quaternion<S>& across, const S& speed, const Motion<S>& motion) {
  const Moment<S, 4> moment{q, across * speed, q * S(-sq(speed))};
  return {moves_within(moment, motion), moment};
}

}  // namespace refitlab

// Sources: channels are those of [Khronos 2021, "glTF 2.0 specification", appendix C]; slerp [Shoemake 1985, "Animating
// rotation with quaternion curves"].
// Used by: c4_chain_motion, c7_crossfade, c8_any_pose; algorithms/bake/over_time/node_motions.cpp,
// algorithms/model/channel_value.cpp, experiments/drawings/motion.cpp.
