// SPDX-License-Identifier: MIT
// Beyond the paper: how far a vertex can be, from the transforms of its joints alone.
//
// Statement. Let C_k, k = 1 ... n, be rigid transforms with unit quaternions q_k, all (q_k, q_l) >= c >= 0. For a point
// f let L = sum u_k C_k f be its linear blend, B its dual quaternion blend, and A(f)^2 = sum_{k<l} ||C_k f - C_l f||^2.
// For every u of W_n
//   ||B - L||^2 <= 9/16 (1 - c) A(f)^2,
//   ||B - L||^2 <= (1 - c) / (4 (1 + c)) A(f)^2  if c >= 3/5: no two rotations are more than 106 degrees apart.
// The second is sharp: two joints at halves that turn about an axis, and f not on it, reach it.
// So the image of v is known from f and the joints: v' = L + (a vector of length ||v - f||) + (one of length <= s A(f)), s^2 one
// of these factors, in the hull of the C_k f blown up by both lengths, for
// - linear blending: the first may be shorter, and the second is 0;
// - dual quaternions: it is B - L;
// - spherical blending about a rotation center r, at f = r: it is 0;
// - spherical blending about a least-squares center, sum_{k<l} (R_k - R_l)^T (C_k r - C_l r) = 0, at any f: it is L - R
//   of the rotations alone at r - f, whose A is less: sum ||R_k (r - f) - R_l (r - f)||^2 = A(f)^2 - sum ||C_k r - C_l
//   r||^2.
// For given weights u, whatever the signs of the quaternions, with (q_k, q_l) >= c_kl and 0 < D <= ||q||^2,
//   ||B - L||^2 <= A(f)^2 / D^2 sum_{k<l} u_k^2 u_l^2 (1 - d_kl) (1 + d_kl + 2 D), d_kl = max(c_kl, -D).
// Of weights u it may be known that u_k >= m_k, with sum m_k = M, that sum_{k<l} u_k u_l <= P, and that sum_{k<l} (u_k u_l)^2 <= Q.
// - L is in the hull of the sum_l m_l C_l f + (1 - M) C_k f.
// - ||B - L||^2 <= 2 (1 - c) Q / (1 - 2 (1 - c) P)^2 A(f)^2 if 2 (1 - c) P < 1. Weights that are nearly one joint's have a small Q.
// For some of the joints A is no greater and c is no less, so a bound for all joints holds for some of them too.
// With f = v the first length is 0: v' is within s A(v) of the hull of the C_k v, and all v at once of that of the
// images of any set that holds them, such as a box. Their A is known from one of them: A(v) <= A(f) +
// sqrt(2 n (n - 1) (1 - c^2)) ||v - f||.
//
// Replaces: nothing in the paper, where all joint-sets of the root are refitted.
// Notation: u -> coefficients, f -> point, c -> cosine, A^2 -> squared_spread, L -> carried.
//
// Proof. With x_k = C_k f, X_kl = x_k - x_l, q = sum u_k q_k, D = ||q||^2, g_k = (q_k, q), c_kl = (q_k, q_l) and m_kl =
// Im(q_k q_l*): D B = sum_kl u_k u_l Im(x_k q_k q_l*) for pure x_k, and sum u_k g_k = D, so
//   D (B - L) = sum_{k<l} u_k u_l ((g_k - g_l) X_kl + X_kl x m_kl).
// The two vectors of a pair are perpendicular and ||m_kl||^2 = 1 - c_kl^2: with p = u_k u_l, Cauchy and Schwarz give
//   ||B - L||^2 <= A^2 / D^2 sum p^2 ((g_k - g_l)^2 + 1 - c_kl^2).
// - For given weights, (g_k - g_l)^2 <= 2 (1 - c_kl) D; what that leaves of the bracket, over D^2, falls with D, and is greatest
//   at c_kl = -D.
// All sums run over pairs; let P = sum p, a = 1 - c and x = sum u_k^2 = 1 - 2 P.
// - First bound: (g_k - g_l)^2 <= 2 (1 - c_kl) D, so the bracket is at most (1 - c_kl) (1 + c_kl + 2 D), which falls
//   with c_kl. sum p^2 = (x^2 - sum u_k^4) / 2 <= x^2 (1 - x) / 2, since sum u_k u_k^3 >= x^3 (Jensen), and D >= x + c (1
//   - x) >= x. For x <= 2/3 what is left, x^2 (1 - x) (1 + c + 2 D) / (2 D^2), falls with c at the least D, and is (1 -
//   x) (1 + 2 x) / 2 <= 9/16 at c = 0; for x > 2/3 it is at most (1 - x) (1 + x) < 9/16.
// - Second bound: g_k - g_l = (u_k - u_l) (1 - c_kl) + sum of u_m (c_km - c_lm) over the others, so |g_k - g_l| <= a
//   (|u_k - u_l| + 1 - u_k - u_l) = a (1 - 2 min(u_k, u_l)), whose square is at most a^2 (1 - 4 p), because p <= min (1 -
//   min). And 1 - c_kl^2 <= a (2 - a), D >= 1 - 2 a P. The bracket is at most 2 a (1 - 2 a p); it remains to see that
//     8 (2 - a) sum p^2 (1 - 2 a p) <= (1 - 2 a P)^2  for a <= 2/5.
//   p (1 - 2 a p) rises up to p = 1 / (4 a), and p <= 1/4. If P <= 1/4, the left side is therefore at most (2 - a)^2 P <=
//   (1 - a/2)^2. If P > 1/4, the quotient of left and right rises with a: its logarithm's derivative is 4 P / (1 - 2 a P)
//   - 1 / (2 - a) - 2 sum p^3 / sum p^2 (1 - 2 a p), the last at most 2 P / (1 - 2 a P) since each p <= P, and 2 P / (1 -
//   2 a P) >= 1 / (2 - a). So let a = 2/5, and y = sum p^2 / P: y <= x^2 by what was said of sum p^2, and x < 1/2. sum p^3
//   >= P y^2 (Cauchy and Schwarz), and y (1 - 4/5 y) rises, so the left side is at most 32/5 (1 - x) x^2 (1 - 4/5 x^2). 25
//   times what is left of the right one is then (3 + 2 x)^2 - 32 (1 - x) x^2 (5 - 4 x^2) = (1 - 2 x)^2 (9 + 48 x - 32 x^3)
//   >= 0.
// - Of weights with such P and Q: all (q_k, q_m) are in [c, 1], and so are the g_k. The bracket is at most a^2 + a (2 - a) = 2 a, and
//   D = 1 - 2 sum p (1 - c_kl) >= 1 - 2 a P. The hull is that of the weights' simplex (b1_rational_bezier_simplex).
// - The least-squares center is Pythagoras' theorem.
// - ||R_k x - R_l x|| <= 2 sqrt(1 - c_kl^2) ||x||, as the angle between the rotations is twice that between the
//   quaternions.
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/vocabulary/blending.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

// Returns A^2.
template <class S>
S squared_spread(const std::vector<Vec<S, 3>>& images) {
  S sum(0);
  for (std::size_t k = 0; k < images.size(); ++k)
    for (std::size_t l = k + 1; l < images.size(); ++l) sum = sum + squared_distance<S, 3>(images[k], images[l]);
  return sum;
}

// Returns A^2 of count images. squares is the sum of their squared lengths and sum is their sum, both as seen from any one point:
// sum_{k<l} ||y_k - y_l||^2 = n sum ||y_k||^2 - ||sum y_k||^2.
template <class S>
S squared_spread_of_sums(const S& count, const S& squares, const Vec<S, 3>& sum) {
  return count * squares - squared_norm(sum);
}

// By how much the squared spread of a point may exceed that of f, in the square's root and for each unit of ||v - f||: these return
// the factors of the statement's last 2 n (n - 1) (1 - c^2), of the count and of the cosine.
template <class S>
S squared_turn_of_count(const S& count) {
  return S(2) * count * (count - S(1));
}
template <class S>
S squared_turn_of_cosine(const S& cosine) {
  return (S(1) - cosine) * (S(1) + cosine);
}

// Returns s^2, or for c >= 3/5 a little more: (1 - c) / (4 (1 + c)) is 1 - c times a convex function of c, which its chord from c
// = 3/5 to 1, (13 - 5 c) / 64, is above. This takes no quotient and serves packs too.
template <class S>
S squared_deviation_share(const S& cosine) {
  return (S(1) - cosine) * choose(S(5) * cosine >= S(3), S(S(13) / S(64) - S(5) / S(64) * cosine), S(S(9) / S(16)));
}

// Returns a coordinate of sum_l m_l x_l + (1 - M) x_k. at_least is that of the sum, rest is 1 - M, and image is that of x_k.
template <class S>
S shrunk_by_least(const S& at_least, const S& rest, const S& image) {
  return at_least + rest * image;
}

// Returns the share of weights of which so much is known: products is P, and squared_products is Q. The cosine is at least 0, and
// 2 (1 - cosine) products is less than 1.
template <class S>
S squared_share_of_products(const S& cosine, const S& products, const S& squared_products) {
  const S twice = S(2) * (S(1) - cosine);
  return twice * squared_products / sq(S(S(1) - twice * products));
}

// Returns the share for given weights u. cosines are the c_kl for k < l in order, and squared_blend is D.
template <class S>
S squared_deviation_share(std::span<const S> u, std::span<const S> cosines, const S& squared_blend) {
  S sum(0);
  std::size_t pair = 0;
  for (std::size_t k = 0; k < u.size(); ++k)
    for (std::size_t l = k + 1; l < u.size(); ++l) {
      const S cosine = max_of(cosines[pair++], S(-squared_blend));
      sum = sum + sq(S(u[k] * u[l])) * (S(1) - cosine) * (S(1) + cosine + S(2) * squared_blend);
    }
  return sum / sq(squared_blend);
}

// Returns the share before the proof bounds it any further: sum p^2 ((g_k - g_l)^2 + 1 - c_kl^2) / D^2, divided by a = 1 - c.
// versines are the (1 - c_kl) / a for k < l in order, so that nothing cancels where the rotations are close, and a may be 0.
template <class S>
S deviation_share_of_pairs(std::span<const S> u, std::span<const S> versines, const S& a) {
  std::vector<S> behind(u.size(), S(0));  // (1 - g_k) / a
  S lost(0), squared_blend(0), sum(0);    // (1 - D) / (2 a), and D
  for (const S& w : u) squared_blend = squared_blend + sq(w);
  std::size_t pair = 0;
  for (std::size_t k = 0; k < u.size(); ++k)
    for (std::size_t l = k + 1; l < u.size(); ++l) {
      const S& versine = versines[pair++];
      behind[k] = behind[k] + u[l] * versine;
      behind[l] = behind[l] + u[k] * versine;
      lost = lost + u[k] * u[l] * versine;
      squared_blend = squared_blend + S(2) * u[k] * u[l] * (S(1) - a * versine);
    }
  pair = 0;
  for (std::size_t k = 0; k < u.size(); ++k)
    for (std::size_t l = k + 1; l < u.size(); ++l) {
      const S& versine = versines[pair++];
      sum = sum + sq(S(u[k] * u[l])) * (a * sq(S(behind[k] - behind[l])) + versine * (S(2) - a * versine));
    }
  // Both arguments are D. Intervals bound the first better from below where rotations are close, and the second where they are
  // far apart.
  return sum / sq(max_of(S(S(1) - S(2) * a * lost), squared_blend));
}

// Returns the dual quaternion blend that carries the point.
template <class S>
DualQuaternionBlend<S> dual_blend(const std::vector<RigidTransform<S>>& transforms, const Vec<S, 3>& point) {
  DualQuaternionBlend<S> blend{{}, {}, point};
  for (const auto& c : transforms) {
    blend.rotations.push_back(c.rotation);
    blend.duals.push_back(dual_part(c));
  }
  return blend;
}

// Returns the transforms without their translations.
template <class S>
std::vector<RigidTransform<S>> rotations_alone(std::vector<RigidTransform<S>> transforms) {
  for (auto& c : transforms) c.translation = Vec<S, 3>::Constant(S(0));
  return transforms;
}

// --- Hypotheses ---

template <class S>
Verdict are_within(const std::vector<RigidTransform<S>>& transforms, const S& cosine) {
  Verdict v = less_equal(S(0), cosine);
  for (std::size_t k = 0; k < transforms.size(); ++k) {
    v &= equal(squared_norm(transforms[k].rotation), S(1));
    for (std::size_t l = k + 1; l < transforms.size(); ++l)
      v &= less_equal(cosine, dot(transforms[k].rotation, transforms[l].rotation));
  }
  return v;
}

template <class S>
Verdict deviation_hypotheses(const std::vector<RigidTransform<S>>& transforms, const S& cosine, std::span<const S> u) {
  return are_within(transforms, cosine) & is_convex(u);
}

// The center satisfies the normal equations.
template <class S>
Verdict is_least_squares_center(const std::vector<RigidTransform<S>>& transforms, const Vec<S, 3>& center) {
  Vec<S, 3> gradient = Vec<S, 3>::Constant(S(0));
  for (std::size_t k = 0; k < transforms.size(); ++k)
    for (std::size_t l = k + 1; l < transforms.size(); ++l) {
      const Vec<S, 3> gap = apply(transforms[k], center) - apply(transforms[l], center);
      gradient = gradient + rotate(conjugate(transforms[k].rotation), gap) - rotate(conjugate(transforms[l].rotation), gap);
    }
  return equal(gradient[0], S(0)) & equal(gradient[1], S(0)) & equal(gradient[2], S(0));
}

// --- Conclusion ---

// The witness splits v' = carried + turned + deviated.
template <class S>
struct DeviatedVertex {
  Verdict verdict;
  Vec<S, 3> carried, turned, deviated;
};

// Judges both bounds on the squared length of the deviation.
template <class S>
Verdict deviates_little(const S& squared_length, const S& cosine, const S& squared_spread) {
  const S allowed = (S(1) - cosine) * squared_spread;
  return less_equal(S(squared_length * S(16)), S(S(9) * allowed)) &
         implies(less_equal(S(3), S(S(5) * cosine)), less_equal(S(S(4) * (S(1) + cosine) * squared_length), allowed));
}

// Checks the witness independently, except that it sums up to v': carried is the linear blend of f, turned is as long as v - f,
// and deviated is within its bounds.
template <class S>
Verdict is_deviated_vertex(const std::vector<RigidTransform<S>>& transforms, const S& cosine, const Vec<S, 3>& point,
                           std::span<const S> u, const Vec<S, 3>& vertex, const DeviatedVertex<S>& witness) {
  const auto images = images_of<S>(transforms, point);
  const Vec<S, 3> carried = combine<S, 3>(u, images);
  Verdict v = equal(squared_norm(witness.turned), squared_distance(vertex, point)) &
              deviates_little(squared_norm(witness.deviated), cosine, squared_spread(images));
  for (int i = 0; i < 3; ++i) v &= equal(carried[i], witness.carried[i]);
  return v;
}

// Computes the witness for dual quaternions. Its sum is the vertex's image by dual_blend (is_blended_image).
template <class S>
DeviatedVertex<S> dual_quaternion_deviation(const std::vector<RigidTransform<S>>& transforms, const S& cosine,
                                            const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& vertex) {
  const auto at = dual_blend(transforms, point).at(u), of_vertex = dual_blend(transforms, vertex).at(u);
  const Vec<S, 3> image = at.numerator / at.denominator;
  DeviatedVertex<S> out{Verdict::undecided, combine<S, 3>(u, images_of<S>(transforms, point)),
                        of_vertex.numerator / of_vertex.denominator - image, image};
  out.deviated = out.deviated - out.carried;
  out.verdict = is_deviated_vertex(transforms, cosine, point, u, vertex, out);
  return out;
}

// Computes the witness for spherical blending about a center. Its sum is the vertex's image by Equation (1).
template <class S>
DeviatedVertex<S> spherical_deviation(const std::vector<RigidTransform<S>>& transforms, const S& cosine, const Vec<S, 3>& center,
                                      const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& vertex) {
  const auto alone = rotations_alone(transforms);
  const auto turn = [&](const Vec<S, 3>& x) {
    const auto at = dual_blend(alone, x).at(u);
    return Vec<S, 3>(at.numerator / at.denominator);
  };
  const Vec<S, 3> arm = center - point;
  DeviatedVertex<S> out{Verdict::undecided, combine<S, 3>(u, images_of<S>(transforms, point)), turn(vertex - point),
                        combine<S, 3>(u, images_of<S>(alone, arm)) - turn(arm)};
  out.verdict = is_deviated_vertex(transforms, cosine, point, u, vertex, out);
  return out;
}

// Judges the identity of the proof: ||q||^2 (B - L) is a sum over pairs, and each summand is made of two perpendicular vectors.
template <class S>
Verdict deviates_by_pairs(const std::vector<RigidTransform<S>>& transforms, const Vec<S, 3>& point, std::span<const S> u) {
  const auto images = images_of<S>(transforms, point);
  const auto blend = dual_blend(transforms, point);
  const auto at = blend.at(u);
  const Quaternion<S> q = combine<S, 4>(u, blend.rotations);
  Vec<S, 3> sum = Vec<S, 3>::Constant(S(0));
  Verdict v = Verdict::holds;
  for (std::size_t k = 0; k < images.size(); ++k)
    for (std::size_t l = k + 1; l < images.size(); ++l) {
      const Quaternion<S>&a = blend.rotations[k], &b = blend.rotations[l];
      const Vec<S, 3> gap = images[k] - images[l], mixed = imaginary(multiply(a, conjugate(b)));
      const Vec<S, 3> along = gap * dot<S, 4>(a - b, q), across = cross<S>(gap, mixed);
      v &= equal(squared_norm(mixed), S(S(1) - sq(dot(a, b))));
      v &= equal(dot(along, across), S(0));
      sum = sum + (along + across) * (u[k] * u[l]);
    }
  const Vec<S, 3> carried = combine<S, 3>(u, images), deviated = at.numerator - carried * at.denominator;
  for (int i = 0; i < 3; ++i) v &= equal(sum[i], deviated[i]);
  return v;
}

// Judges the bound on the spread of a vector's images by the rotations alone.
template <class S>
Verdict turns_little(const std::vector<RigidTransform<S>>& transforms, const S& cosine, const Vec<S, 3>& vector) {
  const S n(static_cast<int>(transforms.size()));
  return less_equal(squared_spread(images_of<S>(rotations_alone(transforms), vector)),
                    S(squared_turn_of_count(n) * squared_turn_of_cosine(cosine) * squared_norm(vector)));
}

// Judges Pythagoras' theorem for a least-squares center: the squared spread of a point is that of the center plus that of the
// turned difference.
template <class S>
Verdict splits_spread(const std::vector<RigidTransform<S>>& transforms, const Vec<S, 3>& center, const Vec<S, 3>& point) {
  const S at_point = squared_spread(images_of<S>(transforms, point)),
          at_center = squared_spread(images_of<S>(transforms, center)),
          turned = squared_spread(images_of<S>(rotations_alone(transforms), Vec<S, 3>(center - point)));
  return implies(is_least_squares_center(transforms, center), equal(at_point, S(at_center + turned)));
}

}  // namespace refitlab

// Sources: none.
// Used by: b9_pose_change, c8_any_pose; algorithms/bake/over_time/moving_vertices.cpp,
// algorithms/runtime/collide/motion_bound_lanes.hpp, algorithms/runtime/collide/motion_bound_packs.cpp,
// algorithms/runtime/collide/motion_bound_piece_kernel.cpp, algorithms/runtime/collide/pose_change.cpp,
// experiments/drawings/control_hulls.cpp, experiments/drawings/motion.cpp.
