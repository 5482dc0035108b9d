// SPDX-License-Identifier: MIT
// Beyond the paper: how far a skinned vertex can be in another pose, from how far the joints are from where they were.
//
// Statement. Let C_k, k = 1 ... n, be rigid transforms with unit quaternions q_k in one pose, and C'_k with q'_k in another,
// with all ||q'_k - q_k|| <= e. (q and -q are one rotation: of q'_k and -q'_k the one that is nearer is compared.)
// (i) For all points f and a
//   ||C'_k f - C_k f|| <= ||C'_k a - C_k a|| + 2 e ||f - a||.
// In particular the rotation of q'_k moves x by at most 2 e ||x|| from where that of q_k puts it. Small turns come as near to
// this as desired: a turn about an axis that is perpendicular to x moves it by e sqrt(4 - e^2) ||x||.
// (ii) If all ||C'_k f - C_k f|| <= d, every point of the hull of the C'_k f is within d of the point of the hull of the C_k f
// that has the same weights. With A of b7_motion_bound, A'(f) <= A(f) + n d, which any even n reaches: half of the images go
// one way, and half the other.
// (iii) (q'_k, q'_l) >= (q_k, q_l) - 2 e.
// So let all (q_k, q_l) >= c, with c - 2 e >= 0, and let s(c)^2 be a share of b7_motion_bound. What b7_motion_bound says of the
// new pose puts a skinned vertex v' of that pose within
//   ||v - f|| + d + s(c - 2 e) (A(f) + n d)
// of the hull of the C_k f of the old pose, and more closely of the point of that hull with the vertex' own weights. For linear
// blending s is 0. Bounds of the old pose that were blown up by s A then need d + s(c - 2 e) (A + n d) in place of s A.
// (iv) If c - 2 e >= 3/5, s(c - 2 e) <= s(c) + s(1 - 2 e) for the sharp s of b7_motion_bound. So those bounds need no more than
//   d + s(1 - 2 e) A + s(c - 2 e) n d
// besides, with the c of each and with an A and an s(c - 2 e) that are not exceeded by any: that is 0 where nothing changes.
// The signs of skinning may stay: if all sigma_k sigma_l (q_k, q_l) >= c, then all sigma_k sigma_l (q'_k, q'_l) >= c - 2 e.
//
// Replaces: nothing in the paper, which refits every pose from nothing.
// Notation: e -> turn, d -> moved, n -> count, A -> spread, c -> cosine, s -> share, f -> point, a -> anchor.
//
// Proof. (i) C' f - C f = (C' a - C a) + (R' - R) (f - a). R' = P R with P the rotation of p = q' q*, and P turns by an angle t
// with |cos(t / 2)| = |Re p|, so ||P y - y|| <= 2 |sin(t / 2)| ||y|| = 2 ||Im p|| ||y||, with equality for y perpendicular to
// the axis. ||Im p||^2 = (1 - Re p) (1 + Re p) <= 2 (1 - Re p) = ||q' - q||^2, and 2 (1 + Re p) = 4 - ||q' - q||^2.
// (ii) sum u_k (C'_k f - C_k f) is no longer than d. A is a norm of all the differences of images together, so A' <= A + (that
// of the x_k = C'_k f - C_k f), and the square of that is n sum ||x_k||^2 - ||sum x_k||^2 <= n^2 d^2.
// (iii) (q'_k, q'_l) - (q_k, q_l) = (q'_k - q_k, q'_l) + (q_k, q'_l - q_l), and all quaternions are units. Signs that are the
// same in both poses keep the differences' lengths.
// (iv) With x = 1 - c the square of s is x / 8 + 5 x^2 / 64, as long as c >= 3/5. That of x + y is those of x and y and 5 x y / 32,
// which is at most two times the product of the roots, since s >= sqrt(5) x / 8. At a smaller c, s jumps from 1/4 to 9/(4 sqrt(10)).
#pragma once

#include <array>

#include "lemmas/b7_motion_bound.hpp"

namespace refitlab {

// Returns the bound of (i): anchor_moved is at least ||C' a - C a||, turn is e, and to_anchor is at least ||f - a||. With an
// anchor that stays, it is how far a rotation moves a vector of that length.
template <class S>
S moved_at_most(const S& anchor_moved, const S& turn, const S& to_anchor) {
  return anchor_moved + S(2) * turn * to_anchor;
}

// Returns the bound of (iii): the cosine of the new pose, at least.
template <class S>
S cosine_after_change(const S& cosine, const S& turn) {
  return cosine - S(2) * turn;
}

// Returns the bound of (ii) for A'. spread is at least A, count is n, and moved is d.
template <class S>
S spread_after_change(const S& spread, const S& count, const S& moved) {
  return spread + count * moved;
}

// Returns by how much the hull of the old images has to be blown up, besides ||v - f||. share is s(c - 2 e), or 0 for linear
// blending, and spread_after is at least A'.
template <class S>
S growth_by_change(const S& moved, const S& share, const S& spread_after) {
  return moved + share * spread_after;
}

// Says whether (iv) holds of c - 2 e.
template <class S>
auto has_sharp_share(const S& cosine_after) {
  return S(5) * cosine_after >= S(3);
}

// Returns by how much bounds of the old pose that were blown up by s(c) A have to grow, which requires has_sharp_share. turn_share
// is s(1 - 2 e), spread is at least A, and share is s(c - 2 e).
template <class S>
S growth_of_bound(const S& moved, const S& turn_share, const S& spread, const S& share, const S& count) {
  return moved + (turn_share * spread + share * (count * moved));
}

// PoseChangeBounds bound all joints of a vertex: the least (q_k, q_l) of the old pose, e, d, and a number that A of the old
// pose does not exceed.
template <class S>
struct PoseChangeBounds {
  S cosine, turn, moved, spread;
  S cosine_after() const { return cosine_after_change(cosine, turn); }
  S spread_after(std::size_t count) const { return spread_after_change(spread, S(static_cast<int>(count)), moved); }
};

// --- Hypotheses ---

// The quaternions of one joint in both poses are units and no farther apart than turn.
template <class S>
Verdict turns_at_most(const Quaternion<S>& old, const Quaternion<S>& now, const S& turn) {
  return equal(squared_norm(old), S(1)) & equal(squared_norm(now), S(1)) & less_equal(S(0), turn) &
         less_equal(squared_distance<S, 4>(now, old), sq(turn));
}

// The point is no farther than moved from where it was.
template <class S>
Verdict moves_at_most(const Vec<S, 3>& old, const Vec<S, 3>& now, const S& moved) {
  return less_equal(S(0), moved) & less_equal(squared_distance<S, 3>(now, old), sq(moved));
}

// spread is at least A.
template <class S>
Verdict spreads_at_most(const std::vector<Vec<S, 3>>& images, const S& spread) {
  return less_equal(S(0), spread) & less_equal(squared_spread(images), sq(spread));
}

// All that is asked of the joints in both poses.
template <class S>
Verdict is_pose_change(const std::vector<RigidTransform<S>>& old, const std::vector<RigidTransform<S>>& now,
                       const PoseChangeBounds<S>& change, const Vec<S, 3>& point) {
  if (old.size() != now.size()) return Verdict::fails;
  Verdict v = are_within(old, change.cosine) & less_equal(S(0), change.cosine_after()) &
              spreads_at_most(images_of<S>(old, point), change.spread);
  for (std::size_t k = 0; k < old.size(); ++k)
    v &= turns_at_most(old[k].rotation, now[k].rotation, change.turn) &
         moves_at_most(apply(old[k], point), apply(now[k], point), change.moved);
  return v;
}

// The square of share is at least what b7_motion_bound allows at this cosine.
template <class S>
Verdict is_deviation_share(const S& share, const S& cosine) {
  return less_equal(S(0), share) & less_equal(squared_deviation_share(cosine), sq(share));
}

// --- Conclusion of (i) ---

// The witness splits C' f - C f = anchor + turned.
template <class S>
struct MovedPoint {
  Verdict verdict;
  Vec<S, 3> anchor, turned;
};

// Judges how far a point is moved. The lengths of the anchor's move and of f - a are given, or numbers above them.
template <class S>
Verdict moves_little(const Vec<S, 3>& old, const Vec<S, 3>& now, const S& anchor_moved, const S& turn, const S& to_anchor) {
  return less_equal(squared_distance<S, 3>(now, old), sq(moved_at_most(anchor_moved, turn, to_anchor)));
}

// Checks the witness independently: its sum is how the point moves, anchor is how a moves, and turned is within 2 e ||f - a||.
template <class S>
Verdict is_moved_point(const RigidTransform<S>& old, const RigidTransform<S>& now, const S& turn, const Vec<S, 3>& anchor,
                       const Vec<S, 3>& point, const MovedPoint<S>& witness) {
  const Vec<S, 3> of_anchor = apply(now, anchor) - apply(old, anchor), of_point = apply(now, point) - apply(old, point);
  Verdict v = less_equal(squared_norm(witness.turned), S(sq(S(S(2) * turn)) * squared_distance<S, 3>(point, anchor)));
  for (int i = 0; i < 3; ++i)
    v &= equal(witness.anchor[i], of_anchor[i]) & equal(S(witness.anchor[i] + witness.turned[i]), of_point[i]);
  return v;
}

template <class S>
MovedPoint<S> moved_point(const RigidTransform<S>& old, const RigidTransform<S>& now, const S& turn, const Vec<S, 3>& anchor,
                          const Vec<S, 3>& point) {
  const Vec<S, 3> arm = point - anchor;
  MovedPoint<S> out{Verdict::undecided, apply(now, anchor) - apply(old, anchor),
                    rotate(now.rotation, arm) - rotate(old.rotation, arm)};
  out.verdict = is_moved_point(old, now, turn, anchor, point, out);
  return out;
}

// --- Conclusion of (ii) and (iii) ---

// Judges (ii) for images in both poses, which moved no farther than moved.
template <class S>
Verdict spread_grows_little(const std::vector<Vec<S, 3>>& now, const S& spread, const S& moved) {
  const S after = spread_after_change(spread, S(static_cast<int>(now.size())), moved);
  return less_equal(squared_spread(now), sq(after));
}
template <class S>
Verdict hull_moves_little(const std::vector<Vec<S, 3>>& old, const std::vector<Vec<S, 3>>& now, const S& moved,
                          std::span<const S> u) {
  return less_equal(squared_distance<S, 3>(combine<S, 3>(u, now), combine<S, 3>(u, old)), sq(moved));
}

// Judges (iii) for the quaternions of two joints in the new pose. cosine is what they had in the old one, at least.
template <class S>
Verdict cosine_falls_little(const Quaternion<S>& now, const Quaternion<S>& other_now, const S& cosine, const S& turn) {
  return less_equal(cosine_after_change(cosine, turn), dot(now, other_now));
}

// --- Conclusion of (iv) ---

// Judges it for numbers that is_deviation_share accepts: share for c, and turn_share for 1 - 2 e.
template <class S>
Verdict share_grows_little(const S& cosine_after, const S& share, const S& turn_share) {
  return less_equal(squared_deviation_share(cosine_after), sq(S(share + turn_share)));
}

// --- Conclusion for a skinned vertex ---

// The witness splits v' = carried + moved + turned + deviated, where carried is in the hull of the old images.
template <class S>
struct VertexAfterChange {
  Verdict verdict;
  Vec<S, 3> carried, moved, turned, deviated;
};

// Checks the witness independently, except that it sums up to v': carried is the linear blend of f in the old pose, moved is
// within d, turned is no longer than v - f, and deviated is within what b7_motion_bound allows at c - 2 e and A + n d.
template <class S>
Verdict is_vertex_after_change(const std::vector<RigidTransform<S>>& old, const PoseChangeBounds<S>& change,
                               const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& vertex,
                               const VertexAfterChange<S>& witness) {
  const Vec<S, 3> carried = combine<S, 3>(u, images_of<S>(old, point));
  Verdict v = less_equal(squared_norm(witness.moved), sq(change.moved)) &
              less_equal(squared_norm(witness.turned), squared_distance<S, 3>(vertex, point)) &
              deviates_little(squared_norm(witness.deviated), change.cosine_after(), sq(change.spread_after(old.size())));
  for (int i = 0; i < 3; ++i) v &= equal(carried[i], witness.carried[i]);
  return v;
}

// Computes the witness from that of b7_motion_bound for the new pose.
template <class S>
VertexAfterChange<S> vertex_after_change(const std::vector<RigidTransform<S>>& old, const PoseChangeBounds<S>& change,
                                         const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& vertex,
                                         const DeviatedVertex<S>& now) {
  const Vec<S, 3> carried = combine<S, 3>(u, images_of<S>(old, point));
  VertexAfterChange<S> out{Verdict::undecided, carried, now.carried - carried, now.turned, now.deviated};
  out.verdict = is_vertex_after_change(old, change, point, u, vertex, out);
  return out;
}

// Computes b7_motion_bound's witness for linear blending, where nothing deviates.
template <class S>
DeviatedVertex<S> linear_deviation(const std::vector<RigidTransform<S>>& transforms, const Vec<S, 3>& point, std::span<const S> u,
                                   const Vec<S, 3>& vertex) {
  const Vec<S, 3> arm = vertex - point;
  DeviatedVertex<S> out{Verdict::undecided, combine<S, 3>(u, images_of<S>(transforms, point)),
                        combine<S, 3>(u, images_of<S>(rotations_alone(transforms), arm)), Vec<S, 3>::Constant(S(0))};
  out.verdict = less_equal(squared_norm(out.turned), squared_norm(arm));
  return out;
}

// Judges the bound that programs use: an image in the new pose is near the point of the old hull with its weights. share is of
// c - 2 e, or 0 for linear blending, and arm is at least ||v - f||.
template <class S>
Verdict stays_near_old_hull(const std::vector<RigidTransform<S>>& old, const PoseChangeBounds<S>& change, const S& share,
                            const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& image, const S& arm) {
  const S growth = growth_by_change(change.moved, share, change.spread_after(old.size()));
  return less_equal(squared_distance<S, 3>(image, combine<S, 3>(u, images_of<S>(old, point))), sq(S(arm + growth)));
}

// Judges the same of a bound that was blown up by s(c) A before. shares are s(c), s(1 - 2 e) and s(c - 2 e).
template <class S>
Verdict stays_in_grown_bound(const std::vector<RigidTransform<S>>& old, const PoseChangeBounds<S>& change,
                             const std::array<S, 3>& shares, const Vec<S, 3>& point, std::span<const S> u, const Vec<S, 3>& image,
                             const S& arm) {
  const S count(static_cast<int>(old.size())), growth = growth_of_bound(change.moved, shares[1], change.spread, shares[2], count);
  return less_equal(squared_distance<S, 3>(image, combine<S, 3>(u, images_of<S>(old, point))),
                    sq(S(arm + shares[0] * change.spread + growth)));
}

// --- Erratum: the old box grown by how far the images move ---

// Judges what engines guess, with f = v: if no joint moves a vertex by more than d, the box of its old images grown by d holds
// it. That is so by linear blending, and by no other: where joints turn against one another about images that stay, the vertex
// bulges.
template <class S>
Verdict is_in_grown_box(const std::vector<Vec<S, 3>>& old, const S& moved, const Vec<S, 3>& image) {
  Verdict v = Verdict::holds;
  for (int i = 0; i < 3; ++i) {
    S low = old[0][i], high = old[0][i];
    for (const auto& x : old) low = min_of(low, S(x[i])), high = max_of(high, S(x[i]));
    v &= less_equal(S(low - moved), S(image[i])) & less_equal(S(image[i]), S(high + moved));
  }
  return v;
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/runtime/collide/pose_change.cpp, algorithms/runtime/collide/pose_change_kernel.cpp,
// experiments/drawings/control_hulls.cpp.
