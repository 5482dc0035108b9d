// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/blend_simplex.hpp"

#include <ostream>

#include "proptests/gen/any_place.hpp"

namespace proptests::gen {
namespace {

using namespace refitlab;

// Draws a blend of unit quaternions, which is shorter than 1, and sometimes 0.
rc::Gen<RationalQuaternion> weight_vertex_quaternion() {
  const auto blended = rc::gen::apply([](const RationalQuaternion& p, const RationalQuaternion& q,
                                         const Rational& t) { return RationalQuaternion(p * t + q * (Rational(1) - t)); },
                                      unit_quaternion(), unit_quaternion(), unit_interval_rational());
  return rc::gen::weightedOneOf<RationalQuaternion>(
      {{5, unit_quaternion()}, {4, blended}, {1, rc::gen::just(RationalQuaternion(0, 0, 0, 0))}});
}

bool are_positive(const std::vector<RationalQuaternion>& list) {
  for (const auto& p : list)
    for (const auto& q : list)
      if (dot(p, q) <= 0) return false;
  return true;
}

// Moves the list towards one direction until all are less than a right angle apart.
void draw_together(std::vector<RationalQuaternion>& list) {
  const RationalQuaternion middle = identity_quaternion<Rational>();
  while (!are_positive(list))
    for (auto& q : list) q = RationalQuaternion(q / Rational(2) + middle / Rational(2));
}

}  // namespace

bool BlendCase::is_degenerate() const {
  bool is = blend.weight_vertex_count() == 1 || squared_norm(blend.x) == 0;
  for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      is = is || blend.rotations[k] == blend.rotations[l] || dot(blend.rotations[k], blend.rotations[l]) == 0;
  return is;
}

rc::Gen<BlendCase> blend_case(Spread spread, int most) {
  return rc::gen::exec([=] {
    BlendCase c;
    const int m = *between(1, most + 1);
    c.blend.rotations = *rc::gen::container<std::vector<RationalQuaternion>>(m, weight_vertex_quaternion());
    const int relation = *rc::gen::inRange(0, 6);
    if (relation == 4 && m > 1) c.blend.rotations[1] = c.blend.rotations[0];
    if (relation == 5 && m > 1) c.blend.rotations[1] = -c.blend.rotations[0];
    if (spread == Spread::positive) draw_together(c.blend.rotations);
    c.blend.center_images = *rc::gen::container<std::vector<RationalVec<3>>>(m, rational_vector<3>());
    c.blend.x = *rational_vector<3>();
    c.weights = *convex_weights(m);
    return c;
  });
}

rc::Gen<std::vector<Rational>> affine_weights(int n) {
  return rc::gen::map(rc::gen::container<std::vector<Rational>>(n, rational()), [](std::vector<Rational> w) {
    Rational others(0);
    for (std::size_t i = 1; i < w.size(); ++i) others += w[i];
    w[0] = Rational(1) - others;
    return w;
  });
}

void showValue(const BlendCase& c, std::ostream& out) {
  out << "quaternions ";
  rc::show(c.blend.rotations, out);
  out << ", centers ";
  rc::show(c.blend.center_images, out);
  out << ", x = ";
  rc::show(c.blend.x, out);
  out << ", weights ";
  rc::show(c.weights, out);
}

}  // namespace proptests::gen
