// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/counterexamples/algorithm1.hpp"

#include <limits>

#include "algorithms/bake/weight_vertices.hpp"

namespace proptests::counterexamples {
namespace {

using namespace refitlab;
using gen::Rational;
using gen::RationalQuaternion;
using gen::RationalVec;
using Numbers = std::vector<Rational>;

// Returns a case with S = [p, 0] and joints that turn about the rotation center 0, so that only rotations matter.
gen::RefitCase about_origin(const RationalVec<3>& p, const std::vector<RationalQuaternion>& rotations, const Numbers& low,
                            const Numbers& high) {
  gen::SetCase set;
  for (const auto& q : rotations) set.palette.transforms.push_back({q, RationalVec<3>::Zero()});
  place_rotation_center<Rational>(set.palette, RationalVec<3>::Zero());
  set.weights.bounds = {low, high};
  set.weights.vertices = *enumerate_weight_vertices(set.weights.bounds, std::numeric_limits<std::size_t>::max());
  return {{p, Rational(0)}, {set}};
}

RationalQuaternion q(const Rational& w, const Rational& x, const Rational& y, const Rational& z) { return {w, x, y, z}; }

}  // namespace

const std::vector<PinnedRefit>& algorithm1() {
  const Rational half(1, 2), quarter(1, 4), a(3, 5), b(4, 5);
  const RationalVec<3> x(1, 0, 0), y(0, 1, 0);
  const RationalQuaternion one = q(1, 0, 0, 0), steep = q(Rational(33, 65), Rational(56, 65), 0, 0);
  static const std::vector<PinnedRefit> list{
      {"the ball of a cap beyond 90 degrees (line 15)",
       about_origin(x, {one, one, one, q(half, half, half, half)}, Numbers(4, Rational(0)), Numbers(4, Rational(1))),
       Numbers(4, quarter), false},
      // The matrices' quaternions of the last two joints are (33/65, 56/65, 0, 0) and (33/65, -56/65, 0, 0).
      {"a sphere of radius 1 or more around the quaternions gives a negative radius (no case for it)",
       about_origin(y, {steep, steep, steep, q(-steep[0], steep[1], 0, 0)}, Numbers(4, Rational(0)), Numbers(4, Rational(1))),
       {Rational(0), Rational(0), Rational(0), Rational(1)},
       false},
      {"a weight vertex whose blend is zero divides by zero (line 9)",
       about_origin(y, {one, q(-a, b, 0, 0), q(-a, -b, 0, 0)}, {Rational(3, 8), Rational(0), Rational(0)},
                    {Rational(1), Rational(5, 16), Rational(5, 16)}),
       {Rational(11, 16), Rational(5, 16), Rational(0)},
       true},
      {"a mean of zero divides by zero (line 12)",
       about_origin(y, {one, q(-1, 0, 0, 0)}, Numbers(2, Rational(0)), Numbers(2, Rational(1))),
       {quarter, Rational(3, 4)},
       true},
      {"the sign of a quaternion is lost (line 3)",
       about_origin(y, {q(a, b, 0, 0), q(-a, b, 0, 0)}, Numbers(2, half), Numbers(2, half)),
       {half, half},
       false},
  };
  return list;
}

}  // namespace proptests::counterexamples
