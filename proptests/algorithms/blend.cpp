// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the blending of one vertex against matrices.
#include "algorithms/runtime/skinning/blend.hpp"

#include "lemmas/exact/lift.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_blend {
namespace {

using namespace refitlab;
using gen::RationalVec;

struct Blend {
  OwnedPaletteEntry<Rational> palette;
  std::vector<Rational> weights;
  RationalVec<3> vertex;
  bool vanishes() const { return squared_norm(blend_quaternion<Rational>(palette, weights)) == 0; }
};

// Draws a joint-set of 1 to 5 joints in one pose with any signs, a rotation center, weights and a vertex.
Blend draw() {
  Blend b;
  b.palette.transforms = *gen::rigid_transforms(1, 5);
  // Two joints have the same rotation, of opposite signs.
  if (b.palette.transforms.size() > 1 && *rc::gen::inRange(0, 6) == 0)
    b.palette.transforms[1].rotation = -b.palette.transforms[0].rotation;
  const RationalVec<3> center = *gen::rational_vector<3>();
  place_rotation_center<Rational>(b.palette, center);
  place_duals(b.palette);
  b.weights = *gen::convex_weights(static_cast<int>(b.palette.transforms.size()));
  b.vertex = *gen::rational_vector<3>();
  return b;
}

OwnedPaletteEntry<double> in_double(const OwnedPaletteEntry<Rational>& palette) {
  OwnedPaletteEntry<double> out;
  out.transforms = lift<double>(palette.transforms);
  place_rotation_center<double>(out, lift<double>(palette.rotation_center));
  place_duals(out);
  return out;
}

void classify(const Blend& b) {
  bool weight_vertex = false, equal = false;
  for (const auto& w : b.weights) weight_vertex = weight_vertex || w == 1;
  for (std::size_t i = 1; i < b.palette.transforms.size(); ++i)
    equal = equal || abs(dot(b.palette.transforms[0].rotation, b.palette.transforms[i].rotation)) == 1;
  RC_CLASSIFY(weight_vertex || equal || b.vanishes() || b.vertex == b.palette.rotation_center, "degenerate");
}

void linear_blends_and_those_without_a_root(Suite& t) {
  t.holds("linear blending of the images is the image under the blended matrices",
          {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Blend b = draw();
            classify(b);
            RC_ASSERT(blend_linear<Rational>(b.palette, b.weights, b.vertex) ==
                      oracle::linear(b.palette.transforms, b.weights, b.vertex));
          });
  t.holds("spherical blending without a square root is Equation (1) with the matrix of the blended quaternion",
          {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Blend b = draw();
            RC_PRE(!b.vanishes());
            classify(b);
            RC_ASSERT(blend_spherical<Rational>(b.palette, b.weights, b.vertex) ==
                      oracle::spherical(b.palette.transforms, b.weights, b.palette.rotation_center, b.vertex));
          });
  t.holds("dual quaternion blending without a square root is the matrix of the normalised blend",
          {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Blend b = draw();
            RC_PRE(!b.vanishes());
            classify(b);
            RC_ASSERT(blend_dual_quaternion<Rational>(b.palette, b.weights, b.vertex) ==
                      oracle::dual_quaternion(b.palette.transforms, b.weights, b.vertex));
          });
  t.holds("dual quaternion blending is rigid, and a single joint's is its own transform",
          {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Blend b = draw();
            RC_PRE(!b.vanishes());
            classify(b);
            const auto image = [&](const RationalVec<3>& v) { return blend_dual_quaternion<Rational>(b.palette, b.weights, v); };
            const RationalVec<3> other = *gen::rational_vector<3>(), third = *gen::rational_vector<3>();
            const RationalVec<3> p = image(b.vertex), q = image(other), r = image(third);
            RC_ASSERT(squared_distance(p, q) == squared_distance(b.vertex, other));
            const Rational before = dot<Rational, 3>(b.vertex, cross(other, third));
            const RationalVec<3> origin = image(RationalVec<3>(0, 0, 0));
            RC_ASSERT((dot<Rational, 3>(p - origin, cross<Rational>(q - origin, r - origin))) == before);
            std::vector<Rational> first(b.weights.size(), Rational(0));
            first[0] = 1;
            RC_ASSERT(blend_dual_quaternion<Rational>(b.palette, first, b.vertex) == apply(b.palette.transforms[0], b.vertex));
          });
}

void what_does_not_change_a_blend(Suite& t) {
  t.holds("dual quaternion blending of joints that agree at a point is spherical blending about it", {.number_type = "rational"},
          [] {
            Blend b = draw();
            RC_PRE(!b.vanishes());
            const RationalVec<3> joint = *gen::rational_vector<3>(), image = *gen::rational_vector<3>();
            for (auto& c : b.palette.transforms) c.translation = image - rotate(c.rotation, joint);
            place_rotation_center<Rational>(b.palette, joint);
            place_duals(b.palette);
            RC_ASSERT(blend_dual_quaternion<Rational>(b.palette, b.weights, b.vertex) ==
                      blend_spherical<Rational>(b.palette, b.weights, b.vertex));
          });
  t.holds("dual quaternion blending does not depend on the choice of coordinates, before or after", {.number_type = "rational"},
          [] {
            Blend b = draw();
            RC_PRE(!b.vanishes());
            const auto image = blend_dual_quaternion<Rational>(b.palette, b.weights, b.vertex);
            const auto before = *gen::rigid_transform(), after = *gen::rigid_transform();
            for (auto& c : b.palette.transforms) c = compose(after, compose(c, inverse(before)));
            place_duals(b.palette);
            RC_ASSERT(blend_dual_quaternion<Rational>(b.palette, b.weights, apply(before, b.vertex)) == apply(after, image));
          });
  const auto moves_no_vertex = [](Skinning skinning, std::size_t negated) {
    Blend b = draw();
    RC_PRE(!b.vanishes());
    const auto before = blend<Rational>(skinning, b.palette, b.weights, b.vertex);
    for (std::size_t i = 0; i < std::min(negated, b.weights.size()); ++i)
      b.palette.transforms[i].rotation = -b.palette.transforms[i].rotation;
    place_duals(b.palette);
    RC_PRE(!b.vanishes());
    RC_ASSERT(blend<Rational>(skinning, b.palette, b.weights, b.vertex) == before);
  };
  for (const auto& [skinning, name] :
       {std::pair(Skinning::spherical, "spherical"), std::pair(Skinning::dual_quaternion, "dual quaternion")}) {
    t.holds(std::string("negating all quaternions of a joint-set moves no vertex: ") + name, {.number_type = "rational"},
            [=, kind = skinning] { moves_no_vertex(kind, 5); });
    t.refuted(std::string("negating one quaternion of a joint-set moves no vertex: ") + name, {.number_type = "rational"},
              [=, kind = skinning] { moves_no_vertex(kind, 1); });
  }
}

}  // namespace

PROPTEST(blend) {
  linear_blends_and_those_without_a_root(t);
  what_does_not_change_a_blend(t);
  t.holds(
      "all blendings agree with Eigen's quaternions and transforms up to 1e-12 of the coordinates' size",
      {.number_type = "double"}, [] {
        const Blend b = draw();
        // Rounding is magnified by 1 over the length of the blend: keep away from vanishing ones.
        RC_PRE(squared_norm(blend_quaternion<Rational>(b.palette, b.weights)) > Rational(1, 10000));
        const auto palette = in_double(b.palette);
        const std::vector<double> w = lift<double>(b.weights);
        const Point3 v = lift<double>(b.vertex);
        double size = 1;
        for (const auto& c : palette.transforms) size = std::max(size, c.translation.norm());
        size += v.norm() + 2 * palette.rotation_center.norm();
        RC_ASSERT((blend_linear<double>(palette, w, v) - oracle::linear_by_eigen(palette.transforms, w, v)).norm() <=
                  1e-12 * size);
        RC_ASSERT((blend_spherical<double>(palette, w, v) -
                   oracle::spherical_by_eigen(palette.transforms, w, palette.rotation_center, v))
                      .norm() <= 1e-12 * size);
        RC_ASSERT(
            (blend_dual_quaternion<double>(palette, w, v) - oracle::dual_quaternion_by_eigen(palette.transforms, w, v)).norm() <=
            1e-12 * size);
      });
}

}  // namespace proptests::suite_blend
