// SPDX-License-Identifier: GPL-3.0-or-later
// Draws chains of joints that move within bounds, at a moment, exactly.
#pragma once

#include "lemmas/c4_chain_motion.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/oracles/jet.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::gen {

// Returns a number that is no more than the root, and close.
inline Rational lower_root(const Rational& x) {
  return x == 0 ? Rational(0) : Rational(Rational(1) / upper_root(Rational(Rational(1) / x)));
}

// Draws a rotation that turns by the rational parameter of the circle, and its bounds: 2 atan(t) has the speed 2 and bends by 4.
struct RationalTurn {
  RationalQuaternion start = *gen::unit_quaternion();
  RationalVec<3> axis = gen::unit_direction();
  Rational rate = *gen::unit_interval_rational();
  RationalQuaternion at(const Rational& time) const {
    const Rational t = rate * time, scale = Rational(1) / (Rational(1) + t * t);
    const RationalVec<3> v = axis * Rational(Rational(2) * t * scale);
    return refitlab::multiply<Rational>({(Rational(1) - t * t) * scale, v[0], v[1], v[2]}, start);
  }
  RationalMotion motion() const { return {Rational(1), Rational(2) * rate, Rational(4) * rate * rate}; }
};

// Holds a quaternion that turns at a rational speed, and the bounds that it reaches: of a slerp, or bent as well.
struct TurningQuaternion {
  refitlab::Moment<Rational, 4> moment;
  RationalMotion motion;
};
inline TurningQuaternion turning_quaternion() {
  const Rational speed = abs(*rational()), bend = *rc::gen::oneOf(rc::gen::just(Rational(0)), positive_rational());
  const RationalVec<3> spin = unit_direction() * speed;
  return {turning_moment(*unit_quaternion(), spin, unit_direction() * bend),
          {Rational(1), speed, upper_root(Rational(speed * speed * speed * speed + bend * bend))}};
}

struct MovingChain {
  std::vector<refitlab::LinkMoment<Rational>> links;
  std::vector<refitlab::LinkMotion<Rational>> motions;
  refitlab::Moment<Rational, 3> point;
  RationalMotion below;
  explicit MovingChain(int most, bool scaled = true) : point(), below(any_motion()) {
    point = moment_within<3>(below);
    const int count = *rc::gen::inRange(0, most + 1);
    for (int k = 0; k < count; ++k) {
      const TurningQuaternion turn = turning_quaternion();
      refitlab::LinkMotion<Rational> motion{any_motion(), turn.motion, any_motion()};
      refitlab::LinkMoment<Rational> link{moment_within<3>(motion.translation), turn.moment, moment_within<3>(motion.scale)};
      if (!scaled) {
        motion.scale = refitlab::at_rest(Rational(1));
        link.scale = {RationalVec<3>(1, 1, 1), RationalVec<3>::Zero(), RationalVec<3>::Zero()};
      }
      links.push_back(link), motions.push_back(motion);
    }
  }
  bool is_degenerate() const {
    bool still = links.empty();
    for (const auto& m : motions) still = still || m.scale.size == 0 || m.rotation.speed == 0;
    return still;
  }
};

// Returns the same by matrices of jets, from the first link to the last, which are then applied to the point.
inline refitlab::Moment<Rational, 3> chain_by_jets(const MovingChain& chain) {
  using Jet = oracle::Jet<Rational>;
  oracle::Affine<Jet> all{};
  for (int i = 0; i < 3; ++i) all[i][i] = Jet(1);
  for (const auto& link : chain.links) {
    const auto scale = oracle::jets_of(link.scale);
    const auto local = oracle::affine_of<Jet>(oracle::jets_of(link.rotation), oracle::jets_of(link.translation));
    oracle::Affine<Jet> next{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {
        for (int m = 0; m < 3; ++m) next[i][j] += all[i][m] * local[m][j];
        next[i][j] = j < 3 ? next[i][j] * scale[j] : next[i][j] + all[i][3];
      }
    all = next;
  }
  return oracle::moment_of<Rational, 3>(oracle::times<Jet>(all, oracle::jets_of(chain.point)));
}

}  // namespace proptests::gen
