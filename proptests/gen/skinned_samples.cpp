// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/skinned_samples.hpp"

#include "algorithms/runtime/skinning/blend.hpp"
#include "proptests/gen/sphere_point.hpp"

namespace proptests::gen {
namespace {

using namespace refitlab;

// Returns the nearest multiple of 2^-12, which is near enough to aim with, and short.
Rational coarse(double x) { return Rational(std::ldexp(std::round(std::ldexp(x, 12)), -12)); }

// Returns a rational unit vector near a direction.
RationalVec<3> unit_near(const Point3& direction) {
  const double length = direction.norm();
  if (!(length > 1e-12 && length < 1e12)) return {1, 0, 0};
  const Point3 d = direction / length;
  // The projection is from the pole that is farther away.
  const double sign = d[0] < 0 ? -1 : 1;
  const RationalVec<3> x =
      inverse_stereographic<3>({coarse(sign * d[1] / (1 + sign * d[0])), coarse(sign * d[2] / (1 + sign * d[0]))});
  return x * Rational(sign);
}

RationalWeights blend_of_weight_vertices(const SetCase& set, const std::vector<Rational>& shares) {
  RationalWeights w(set.palette.transforms.size(), Rational(0));
  Rational sum(0);
  for (const Rational& share : shares) sum += share;
  for (std::size_t k = 0; k < shares.size(); ++k)
    for (std::size_t i = 0; i < w.size(); ++i) w[i] += set.weights.vertices[k][i] * shares[k] / sum;
  return w;
}

OwnedPaletteEntry<double> in_double(const OwnedPaletteEntry<Rational>& palette) {
  return {lift<double>(palette.transforms), lift<double>(palette.rotation_center), lift<double>(palette.center_images),
          lift<double>(palette.duals)};
}

// Ascends, in double: it moves shares of the weight vertices towards one weight vertex as long as p is carried farther.
class Ascent {
 public:
  Ascent(const RefitCase& c, const SetCase& set, Blending blending, const Point3& far_from)
      : p_(lift<double>(c.reference.center)),
        blending_(blending),
        far_from_(far_from),
        palette_(in_double(set.palette)),
        weight_vertices_(lift<double>(set.weights.vertices)),
        shares_(weight_vertices_.size(), 1.0 / double(weight_vertices_.size())) {}

  std::vector<Rational> run() {
    double reached = distance(shares_);
    for (int round = 0; round < 3; ++round)
      for (std::size_t k = 0; k < shares_.size(); ++k)
        for (const double step : {0.9, 0.5, 0.2, 0.05, -0.1}) {
          std::vector<double> moved = shares_;
          for (double& s : moved) s *= 1 - step;
          moved[k] += step;
          if (moved[k] < 0) continue;
          if (const double d = distance(moved); d > reached) reached = d, shares_ = moved;
        }
    std::vector<Rational> out;
    for (const double s : shares_) out.push_back(coarse(s));
    // They do not all round to 0 then.
    out[0] += Rational(1, 4096);
    return out;
  }

 private:
  double distance(const std::vector<double>& shares) const {
    std::vector<double> w(palette_.transforms.size(), 0.0);
    for (std::size_t k = 0; k < shares.size(); ++k)
      for (std::size_t i = 0; i < w.size(); ++i) w[i] += weight_vertices_[k][i] * shares[k];
    return (blend<double>(blending_, palette_, w, p_) - far_from_).norm();
  }

  Point3 p_;
  Blending blending_;
  Point3 far_from_;
  OwnedPaletteEntry<double> palette_;
  std::vector<std::vector<double>> weight_vertices_;
  std::vector<double> shares_;
};

// Returns the point of the surface of S that these weights carry farthest from a point: outward, turned back.
RationalVec<3> farthest_vertex(const RefitCase& c, const SetCase& set, const RationalWeights& w, Blending blending,
                               const Point3& far_from) {
  const OwnedPaletteEntry<double> palette = in_double(set.palette);
  const auto weights = lift<double>(w);
  const Point3 p = lift<double>(c.reference.center);
  const auto image = [&](const Point3& v) { return blend<double>(blending, palette, weights, v); };
  const Point3 outward = image(p) - far_from, origin = image(Point3::Zero());
  Point3 back;
  for (int i = 0; i < 3; ++i) back[i] = (image(Point3::Unit(i)) - origin).dot(outward);
  return c.reference.center + unit_near(back) * c.reference.radius;
}

}  // namespace

std::optional<RationalVec<3>> skinned(const RefitCase& c, const Sample& sample, Blending blending) {
  const auto& palette = c.sets[sample.joint_set].palette;
  const bool may_vanish = blending != Blending::linear;
  if (may_vanish && squared_norm(blend_quaternion<Rational>(palette, sample.weights)) == 0) return std::nullopt;
  return blend<Rational>(blending, palette, sample.weights, sample.vertex);
}

std::vector<Sample> samples(const RefitCase& c, Blending blending, const Point3& far_from) {
  std::vector<Sample> out;
  for (int s = 0; s < static_cast<int>(c.sets.size()); ++s) {
    const SetCase& set = c.sets[s];
    const int m = static_cast<int>(set.weights.vertices.size());
    const auto& a = set.weights.vertices[*rc::gen::inRange(0, m)];
    const auto& b = set.weights.vertices[*rc::gen::inRange(0, m)];
    const Rational t = *unit_interval_rational();
    RationalWeights edge = a;
    for (std::size_t i = 0; i < edge.size(); ++i) edge[i] += t * (b[i] - a[i]);
    const auto worst = blend_of_weight_vertices(set, Ascent(c, set, blending, far_from).run());
    const auto middle = blend_of_weight_vertices(set, std::vector<Rational>(m, Rational(1)));
    const RationalVec<3> on_surface = c.reference.center + *sphere_point<3>() * c.reference.radius;
    out.push_back({s, a, c.reference.center});
    out.push_back({s, a, farthest_vertex(c, set, a, blending, far_from)});
    out.push_back({s, edge, on_surface});
    out.push_back({s, edge, farthest_vertex(c, set, edge, blending, far_from)});
    out.push_back({s, middle, farthest_vertex(c, set, middle, blending, far_from)});
    out.push_back({s, *admissible_weights(set.weights.bounds), on_surface});
    out.push_back({s, worst, farthest_vertex(c, set, worst, blending, far_from)});
  }
  return out;
}

}  // namespace proptests::gen
