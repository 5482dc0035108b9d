// SPDX-License-Identifier: GPL-3.0-or-later
// States how far dual quaternion blending is from linear blending, for two, three and four joints. The lemma has 9/16 for any
// number of joints, and the sharp 1 / (4 (1 + c)) from c = 3/5 on.
//
// The parameters are all there is: ||B - L||^2 <= (1 - c) F A(f)^2 with F = deviation_share_of_pairs (the lemma's proof), which
// knows of the quaternions the dot products c_kl = 1 - a y_kl alone, where a = 1 - c and c is the least of them. So 0 <= y_kl <=
// 1, and one of them is 1. Triples of y that no quaternions have do no harm. F is a quotient without a cancelling 1 - c, so a = 0
// is a point like any other.
// - Two joints have y = 1 and u = (1 - w, w). They can be exchanged, so w <= 1/2.
// - Three joints are numbered so that y_12 = 1. Then 1 and 2 can still be exchanged, so u = ((1 - u_3) (1 - s), (1 - u_3) s, u_3)
// with s <= 1/2; at u_3 = 1 the share s means nothing, which does no harm.
// - Of four joints, 1 and 2 can be exchanged, and so can 3 and 4. So u = ((1 - r) (1 - s), (1 - r) s, r (1 - t), r t) with s, t
// <= 1/2.
//
// Two joints at halves that turn about an axis reach 1 / (4 (1 + c)), a third joint having no weight. The quaternions 1, i, j at
// thirds have F = 1/3, and 1, i, j, k at quarters have 3/8. No joints are known to have ||B - L||^2 so large: F comes from the
// inequality of Cauchy and Schwarz, which is strict there.
#include "lemmas/b7_motion_bound.hpp"

#include <array>

#include "proptests/exhaustive/theorems.hpp"

namespace proptests::exhaustive {
namespace {

using namespace refitlab;

Interval share_of_two(std::span<const Interval> at) {
  const std::array<Interval, 2> u{Interval(1) - at[1], at[1]};
  const std::array<Interval, 1> versines{Interval(1)};
  return deviation_share_of_pairs<Interval>(u, versines, at[0]);
}

Interval share_of_three(std::span<const Interval> at) {
  const Interval rest = Interval(1) - at[4];
  const std::array<Interval, 3> u{rest * (Interval(1) - at[3]), rest * at[3], at[4]};
  const std::array<Interval, 3> versines{Interval(1), at[1], at[2]};  // of the pairs 1 2, 1 3, 2 3
  return deviation_share_of_pairs<Interval>(u, versines, at[0]);
}

Interval share_of_four(std::span<const Interval> at) {
  const Interval first = Interval(1) - at[6];
  const std::array<Interval, 4> u{first * (Interval(1) - at[7]), first * at[7], at[6] * (Interval(1) - at[8]), at[6] * at[8]};
  const std::array<Interval, 6> versines{Interval(1), at[1], at[2],
                                         at[3],       at[4], at[5]};  // of the pairs 1 2, 1 3, 1 4, 2 3, 2 4, 3 4
  return deviation_share_of_pairs<Interval>(u, versines, at[0]);
}

// Returns 1 / (4 (1 + c)), which two joints at halves reach.
Interval at_halves(std::span<const Interval> at) { return Interval(1) / (Interval(4) * (Interval(2) - at[0])); }

}  // namespace

std::vector<Theorem> theorems_of_motion_bound() {
  const Parameter a{"a", 0, 1}, y13{"y13", 0, 1}, y23{"y23", 0, 1}, s{"s", 0, 0.5}, u3{"u3", 0, 1};
  return {{"b7_motion_bound.two",
           "For two joints whose quaternions have (q_1, q_2) >= c >= 0 and all weights: F <= K / (4 (1 + c)). So ||B - L||^2 <= "
           "K (1 - c) / (4 (1 + c)) A(f)^2 for all points f.",
           {a, {"w", 0, 0.5}},
           1 + 0x1p-6,
           1 + 0x1p-9,
           1,
           [](std::span<const Interval> at, const Interval& k) { return at_most(share_of_two(at), k * at_halves(at)); }},
          {"b7_motion_bound.three",
           "For three joints whose quaternions have (q_k, q_l) >= c >= 0 and all weights: F <= K. So ||B - L||^2 <= K (1 - c) "
           "A(f)^2 for all points f.",
           {a, y13, y23, s, u3},
           0.375,
           343 * 0x1p-10,
           1.0 / 3,
           [](std::span<const Interval> at, const Interval& k) { return at_most(share_of_three(at), k); }},
          {"b7_motion_bound.three_close",
           "For three joints whose quaternions have (q_k, q_l) >= c >= 1/4 and all weights: F <= K / (4 (1 + c)). So ||B - L||^2 "
           "<= K (1 - c) / (4 (1 + c)) A(f)^2 for all points f.",
           {{"a", 0, 0.75}, y13, y23, s, u3},
           1.25,
           1.0625,
           1,
           [](std::span<const Interval> at, const Interval& k) { return at_most(share_of_three(at), k * at_halves(at)); }},
          {"b7_motion_bound.four",
           "For four joints whose quaternions have (q_k, q_l) >= c >= 0 and all weights: F <= K. So ||B - L||^2 <= K (1 - c) "
           "A(f)^2 for all "
           "points f.",
           {a, y13, {"y14", 0, 1}, y23, {"y24", 0, 1}, {"y34", 0, 1}, {"r", 0, 1}, s, {"t", 0, 0.5}},
           0.75,
           0.4375,
           0.375,
           [](std::span<const Interval> at, const Interval& k) { return at_most(share_of_four(at), k); }}};
}

}  // namespace proptests::exhaustive
