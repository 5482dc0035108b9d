// SPDX-License-Identifier: MIT
// Beyond the paper: how fast a point goes under a chain of joints, and how much it bends, from the joints' channels alone.
//
// Statement. Let each link of a chain carry y to t + R_q (s y), with the translation t, the unit quaternion q and the factors s
// of the scale, curves that are bounded in size, speed and acceleration (c2_channel_motion, c3_normalized_motion). The links
// from the first to the last carry x to A x + b, turned by the product of their quaternions. Bounds of A (as a matrix: of
// ||A x|| / ||x||), of b and of that product are
// - of a link: (q q) s, t, q, where products of bounds are those of Leibniz (lemmas/vocabulary/motion.hpp);
// - of an outer chain A, b, q and an inner one A', b', q': A A', A b' + b, q q';
// - of no links: 1, 0, 1, at rest.
// A point that moves within m below the chain moves within A m + b: a vertex of a joint within A d + b at rest at a distance of
// at most d from the joint's origin, its own frame's. So speed and acceleration are sums over ancestors, of the turn of each
// times the length of the chain below it, and of its own translation. A hinge that turns at one speed reaches them.
//
// Replaces: nothing in the paper, which bounds one pose at a time.
// Notation: t, q, s -> translation, rotation, scale; A, b -> linear, offset.
//
// Proof. y -> q y q* is linear in either q, a scale in s and in y, so a link's image has the derivatives that Leibniz' rule
// says, and their lengths are at most the products of the lengths; a scale stretches by its greatest factor. Sums and
// products of bounds are associative and distributive: it is the same whether they are made from the point up or from the root
// down.
#pragma once

#include "lemmas/c2_channel_motion.hpp"

namespace refitlab {

// A LinkMotion has the motions of the channels of one joint. A scale is measured by its greatest factor.
template <class S>
struct LinkMotion {
  Motion<S> translation, rotation, scale;
};

// A ChainMotion has the motions of a chain of joints: of its linear part, of its offset and of its rotation.
template <class S>
struct ChainMotion {
  Motion<S> linear, offset, rotation;
};

template <class S>
ChainMotion<S> no_links() {
  return {at_rest(S(1)), at_rest(S(0)), at_rest(S(1))};
}

template <class S>
ChainMotion<S> chain_of(const LinkMotion<S>& link) {
  return {product(product(link.rotation, link.rotation), link.scale), link.translation, link.rotation};
}

template <class S>
ChainMotion<S> compose(const ChainMotion<S>& outer, const ChainMotion<S>& inner) {
  return {product(outer.linear, inner.linear), product(outer.linear, inner.offset) + outer.offset,
          product(outer.rotation, inner.rotation)};
}

// Returns the motion of a point that moves below the chain, as seen from above it.
template <class S>
Motion<S> carried_motion(const ChainMotion<S>& chain, const Motion<S>& point) {
  return product(chain.linear, point) + chain.offset;
}

// A LinkMoment has the channels of one joint at a moment, with both derivatives.
template <class S>
struct LinkMoment {
  Moment<S, 3> translation;
  Moment<S, 4> rotation;
  Moment<S, 3> scale;
};

// These return the moment of q y q*, of s y, and of a link's image.
template <class S>
Moment<S, 3> turned_moment(const Moment<S, 4>& q, const Moment<S, 3>& y) {
  const auto quaternions = [](const auto& a, const auto& b) { return multiply<S>(a, b); };
  const auto pure = [](const Vec<S, 3>& x) { return Quaternion<S>(S(0), x[0], x[1], x[2]); };
  const Moment<S, 4> inner{pure(y.value), pure(y.velocity), pure(y.acceleration)};
  const Moment<S, 4> back{conjugate(q.value), conjugate(q.velocity), conjugate(q.acceleration)};
  const Moment<S, 4> turned = product(product(q, inner, quaternions), back, quaternions);
  return {imaginary(turned.value), imaginary(turned.velocity), imaginary(turned.acceleration)};
}
template <class S>
Moment<S, 3> scaled_moment(const Moment<S, 3>& scale, const Moment<S, 3>& y) {
  return product(scale, y,
                 [](const Vec<S, 3>& a, const Vec<S, 3>& b) { return Vec<S, 3>(a[0] * b[0], a[1] * b[1], a[2] * b[2]); });
}
template <class S>
Moment<S, 3> link_moment(const LinkMoment<S>& link, const Moment<S, 3>& y) {
  return turned_moment(link.rotation, scaled_moment(link.scale, y)) + link.translation;
}

// --- Hypotheses ---

template <class S>
Verdict link_hypotheses(const LinkMoment<S>& link, const LinkMotion<S>& motion) {
  return moves_within(link.translation, motion.translation) & moves_within(link.rotation, motion.rotation) &
         is_within(link.scale, motion.scale, by_greatest_factor) & is_motion(motion.translation) & is_motion(motion.rotation) &
         is_motion(motion.scale);
}

// --- Conclusion ---

// The witness is the point below the last link, then its image by each link from the last to the first.
template <class S>
struct ChainSteps {
  Verdict verdict;
  std::vector<Moment<S, 3>> steps;
};

// Returns the bounds of a chain. The first link comes first.
template <class S>
ChainMotion<S> chain_motion(std::span<const LinkMotion<S>> links) {
  ChainMotion<S> chain = no_links<S>();
  for (const LinkMotion<S>& link : links) chain = compose(chain, chain_of(link));
  return chain;
}

template <class S>
ChainSteps<S> chain_moves(std::span<const LinkMoment<S>> links, std::span<const LinkMotion<S>> motions, const Moment<S, 3>& point,
                          const Motion<S>& below) {
  ChainSteps<S> out{Verdict::undecided, {point}};
  for (std::size_t k = links.size(); k-- > 0;) out.steps.push_back(link_moment(links[k], out.steps.back()));
  out.verdict = moves_within(out.steps.back(), carried_motion(chain_motion(motions), below));
  return out;
}

// Checks the witness independently. Each step follows from Im(q y q*) alone, which is quadratic in q, so that its derivative in a
// direction is half of a difference. The last step is within the bounds.
template <class S>
Verdict are_chain_steps(std::span<const LinkMoment<S>> links, std::span<const LinkMotion<S>> motions, const Moment<S, 3>& point,
                        const Motion<S>& below, std::span<const Moment<S, 3>> steps) {
  Verdict v = verdict_of(steps.size() == links.size() + 1) & moves_within(point, below);
  if (v != Verdict::holds) return v;
  const auto along = [](const Quaternion<S>& q, const Quaternion<S>& d, const Vec<S, 3>& x) {
    return Vec<S, 3>((rotate_scaled<S>(q + d, x) - rotate_scaled<S>(q - d, x)) / S(2));
  };
  const auto same = [](const Vec<S, 3>& a, const Vec<S, 3>& b) {
    return equal(a[0], b[0]) & equal(a[1], b[1]) & equal(a[2], b[2]);
  };
  v &= same(steps[0].value, point.value) & same(steps[0].velocity, point.velocity) &
       same(steps[0].acceleration, point.acceleration);
  for (std::size_t k = 0; k < links.size(); ++k) {
    const LinkMoment<S>& link = links[links.size() - 1 - k];
    const Moment<S, 3> z = scaled_moment(link.scale, steps[k]);
    const Quaternion<S>&q = link.rotation.value, &d = link.rotation.velocity, &dd = link.rotation.acceleration;
    v &= same(steps[k + 1].value, rotate_scaled(q, z.value) + link.translation.value) &
         same(steps[k + 1].velocity, along(q, d, z.value) + rotate_scaled(q, z.velocity) + link.translation.velocity) &
         same(steps[k + 1].acceleration, along(q, dd, z.value) + rotate_scaled(d, z.value) * S(2) +
                                             along(q, d, z.velocity) * S(2) + rotate_scaled(q, z.acceleration) +
                                             link.translation.acceleration);
  }
  return v & moves_within(steps.back(), carried_motion(chain_motion(motions), below));
}

}  // namespace refitlab

// Sources: none.
// Used by: c5_skinned_motion; algorithms/bake/over_time/crossfaded_joints.cpp,
// algorithms/bake/over_time/crossfaded_joints.hpp, algorithms/bake/over_time/moving_joints.hpp,
// algorithms/bake/over_time/moving_vertices.cpp, algorithms/bake/over_time/node_motions.cpp,
// algorithms/bake/over_time/node_motions.hpp, experiments/drawings/motion.cpp.
