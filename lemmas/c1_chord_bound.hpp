// SPDX-License-Identifier: MIT
// Beyond the paper: how far a curve is from its chord, from a bound of its second derivative.
//
// Statement. Let f be a curve of R^d over an interval of the length h, and s in [0, 1] the share of it that has passed; the
// chord at s is c = (1 - s) f(start) + s f(end).
// (i) If f is differentiable with ||f''|| <= M but for finitely many moments, there is a k with
//   c - f = s (1 - s) h^2 / 2 k,  ||k|| <= M,
// so ||f - c|| <= M s (1 - s) h^2 / 2 <= M h^2 / 8: f is within M h^2 / 8 of its chord. A parabola reaches it.
// (ii) If f is continuous with ||f'|| <= L but for finitely many moments, ||f - c|| <= 2 s (1 - s) h L <= L h / 2.
//   A path there and back reaches it.
// Where f has a kink (i) says nothing, and where it jumps nothing is said: intervals end there.
//
// Replaces: nothing in the paper, which bounds one pose at a time. Engines take the hull of a few moments.
// Notation: f -> curve, h -> duration, s -> share, c -> on_chord, k -> bend, M -> acceleration, L -> speed.
//
// Proof. (i) For any vector e, let g(s) = (e, f - c) + M ||e|| s (1 - s) h^2 / 2. g' is continuous and g'' <= 0 but for
// finitely many moments, so g is concave, and 0 at both ends: g >= 0. With e = c - f this is ||c - f||^2 <= ||c - f|| M s (1 -
// s) h^2 / 2. For a cubic f'' goes linearly from A to B, and k = ((2 - s) A + (1 + s) B) / 3.
// (ii) f - c = (1 - s) (f - f(start)) - s (f(end) - f), and the two differences are at most L s h and L (1 - s) h long.
#pragma once

#include <array>

#include "lemmas/vocabulary/motion.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns M h^2 / 8.
template <class S>
S chord_slack(const S& acceleration, const S& duration) {
  return acceleration * sq(duration) / S(8);
}

// Returns L h / 2.
template <class S>
S first_order_slack(const S& speed, const S& duration) {
  return speed * duration / S(2);
}

// Returns the smaller of both slacks.
template <class S>
S chord_slack(const Motion<S>& motion, const S& duration) {
  return min_of(chord_slack(motion.acceleration, duration), first_order_slack(motion.speed, duration));
}

// Returns (1 - s) a + s b.
template <class S, int D>
Vec<S, D> between(const Vec<S, D>& a, const Vec<S, D>& b, const S& share) {
  return a * S(S(1) - share) + b * share;
}

// The statement is executed on a cubic, which is given by its Bezier points.
template <class S, int D>
struct CubicCurve {
  std::array<Vec<S, D>, 4> points;
  S duration;  // h

  Vec<S, D> at(const S& share) const {
    std::array<Vec<S, D>, 4> p = points;
    for (int degree = 3; degree > 0; --degree)
      for (int i = 0; i < degree; ++i) p[i] = between<S, D>(p[i], p[i + 1], share);
    return p[0];
  }
  // Returns the Bezier points of f', whose hull holds all of f'.
  std::array<Vec<S, D>, 3> velocities() const {
    const S scale = S(3) / duration;
    return {Vec<S, D>((points[1] - points[0]) * scale), Vec<S, D>((points[2] - points[1]) * scale),
            Vec<S, D>((points[3] - points[2]) * scale)};
  }
  // Returns f'' at both ends. It is linear in between.
  std::array<Vec<S, D>, 2> accelerations() const {
    const auto v = velocities();
    const S scale = S(2) / duration;
    return {Vec<S, D>((v[1] - v[0]) * scale), Vec<S, D>((v[2] - v[1]) * scale)};
  }
};

// --- Hypotheses ---

template <class S>
Verdict is_share(const S& share) {
  return less_equal(S(0), share) & less_equal(share, S(1));
}

// ||f''|| <= M.
template <class S, int D>
Verdict bends_within(const CubicCurve<S, D>& curve, const S& acceleration) {
  Verdict v = less_equal(S(0), acceleration);
  for (const auto& a : curve.accelerations()) v &= less_equal(squared_norm(a), sq(acceleration));
  return v;
}

// ||f'|| <= L. This is decided by its Bezier points.
template <class S, int D>
Verdict runs_within(const CubicCurve<S, D>& curve, const S& speed) {
  Verdict v = less_equal(S(0), speed);
  for (const auto& a : curve.velocities()) v &= less_equal(squared_norm(a), sq(speed));
  return v;
}

template <class S, int D>
Verdict chord_hypotheses(const CubicCurve<S, D>& curve, const S& acceleration, const S& share) {
  return less(S(0), curve.duration) & bends_within(curve, acceleration) & is_share(share);
}

template <class S, int D>
Verdict first_order_hypotheses(const CubicCurve<S, D>& curve, const S& speed, const S& share) {
  return less(S(0), curve.duration) & runs_within(curve, speed) & is_share(share);
}

// --- Conclusion ---

// Judges (i) for three points of any curve: both ends, and the point at the share s.
template <class S, int D>
Verdict is_near_chord(const Vec<S, D>& from, const Vec<S, D>& to, const Vec<S, D>& at, const S& acceleration, const S& duration,
                      const S& share) {
  const S allowed = acceleration * share * (S(1) - share) * sq(duration) / S(2);
  return less_equal(squared_distance(at, between<S, D>(from, to, share)), sq(allowed));
}

// Judges (ii) for the same points.
template <class S, int D>
Verdict is_near_chord_to_first_order(const Vec<S, D>& from, const Vec<S, D>& to, const Vec<S, D>& at, const S& speed,
                                     const S& duration, const S& share) {
  const S allowed = S(2) * share * (S(1) - share) * duration * speed;
  return less_equal(squared_distance(at, between<S, D>(from, to, share)), sq(allowed));
}

// The witness of (i) is the point of the chord, and k, the mean of f'' that leads from f to it.
template <class S, int D>
struct ChordPoint {
  Verdict verdict;
  Vec<S, D> on_chord, bend;
};

// Checks the witness independently: on_chord is on the chord, and k leads there and is short enough.
template <class S, int D>
Verdict is_chord_point(const CubicCurve<S, D>& curve, const S& acceleration, const S& share, const ChordPoint<S, D>& witness) {
  const Vec<S, D> at = curve.at(share);
  Verdict v = less_equal(squared_norm(witness.bend), sq(acceleration));
  for (int i = 0; i < D; ++i)
    v &= equal(witness.on_chord[i], S(curve.points[0][i] + (curve.points[3][i] - curve.points[0][i]) * share)) &
         equal(S(S(2) * (witness.on_chord[i] - at[i])), S(witness.bend[i] * share * (S(1) - share) * sq(curve.duration)));
  return v;
}

template <class S, int D>
ChordPoint<S, D> point_near_chord(const CubicCurve<S, D>& curve, const S& acceleration, const S& share) {
  const auto ends = curve.accelerations();
  return {is_near_chord<S, D>(curve.points[0], curve.points[3], curve.at(share), acceleration, curve.duration, share),
          between<S, D>(curve.points[0], curve.points[3], share), (ends[0] * S(S(2) - share) + ends[1] * S(S(1) + share)) / S(3)};
}

// The witness of (ii) is the mean velocities before and after.
template <class S, int D>
struct ChordSteps {
  Verdict verdict;
  Vec<S, D> before, after;
};

template <class S, int D>
Verdict are_chord_steps(const CubicCurve<S, D>& curve, const S& speed, const S& share, const ChordSteps<S, D>& witness) {
  const Vec<S, D> at = curve.at(share);
  Verdict v = less_equal(squared_norm(witness.before), sq(speed)) & less_equal(squared_norm(witness.after), sq(speed));
  for (int i = 0; i < D; ++i)
    v &= equal(S(at[i] - curve.points[0][i]), S(witness.before[i] * share * curve.duration)) &
         equal(S(curve.points[3][i] - at[i]), S(witness.after[i] * (S(1) - share) * curve.duration));
  return v;
}

template <class S, int D>
ChordSteps<S, D> steps_near_chord(const CubicCurve<S, D>& curve, const S& speed, const S& share) {
  const auto v = curve.velocities();
  const Vec<S, D> early = between<S, D>(v[0], v[1], share), late = between<S, D>(v[1], v[2], share),
                  now = between<S, D>(early, late, share);
  return {is_near_chord_to_first_order<S, D>(curve.points[0], curve.points[3], curve.at(share), speed, curve.duration, share),
          (v[0] + early + now) / S(3), (now + late + v[2]) / S(3)};
}

// --- Erratum: the hull of the moments that are looked at ---

// Judges what engines assume: f is on the chord. A curve leaves its chord wherever it bends.
template <class S, int D>
Verdict is_on_chord_of_moments(const Vec<S, D>& from, const Vec<S, D>& to, const Vec<S, D>& at, const S& share) {
  return is_near_chord<S, D>(from, to, at, S(0), S(1), share);
}

}  // namespace refitlab

// Sources: the bound is that of linear interpolation; for curves of R^d [de Boor 1978, "A practical guide to splines"].
// Used by: c2_channel_motion, c6_interval_hull, c7_crossfade; algorithms/bake/over_time/moving_vertices.cpp,
// algorithms/bake/over_time/node_motions.cpp, experiments/drawings/motion.cpp.
