// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"

namespace proptests::oracle {
namespace {

using namespace refitlab;
using By = Bound::By;
using Q = Quaternion<double>;
using Point = Vec<double, 3>;
constexpr double nothing = std::numeric_limits<double>::infinity();

Q pure(const Point& x) { return {0, x[0], x[1], x[2]}; }
double along(const Q& a, const Q& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
double length(const Point& x) { return std::hypot(x[0], x[1], x[2]); }
double length(const Q& q) { return std::sqrt(along(q, q)); }
Point image_by(const Q& a, const Q& middle, const Q& b) {
  return imaginary<double>(multiply<double>(multiply<double>(a, middle), conjugate<double>(b)));
}

// Holds the sum, over all orders in which weight vertices are taken, of what the blend's numerator has there, and of its weight.
struct Control {
  Point numerator = {0, 0, 0};
  double weight = 0;
};

void add(Control& sum, const BlendsAtWeightVertices& c, std::size_t k, std::size_t l) {
  sum.weight += along(c.rotations[k], c.rotations[l]);
  sum.numerator += image_by(c.rotations[k], pure(c.x), c.rotations[l]);
  if (!c.duals.empty()) sum.numerator += 2 * imaginary<double>(multiply<double>(c.duals[k], conjugate<double>(c.rotations[l])));
}

double needed_by_control(const BlendsAtWeightVertices& c, const Point& center) {
  double needed = 0;
  const std::size_t m = c.rotations.size();
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t k = 0; k < m; ++k) {
      if (along(c.rotations[j], c.rotations[k]) <= 0) return nothing;
      for (std::size_t l = 0; l < (c.duals.empty() ? m : 1); ++l) {
        Control sum;
        std::array<std::size_t, 3> order{j, k, l};
        if (!c.duals.empty()) {
          add(sum, c, j, k), add(sum, c, k, j);
          // There are six orders: two quaternions, and the third weight vertex's image.
        } else {
          std::array<int, 3> at{0, 1, 2};
          do {
            const auto a = order[at[0]], b = order[at[1]];
            add(sum, c, a, b);
            sum.numerator += along(c.rotations[a], c.rotations[b]) * c.center_images[order[at[2]]];
          } while (std::next_permutation(at.begin(), at.end()));
        }
        needed = std::max(needed, length(Point(sum.numerator / sum.weight - center)));
      }
    }
  return needed;
}

// Returns the radius that a cap needs, by cosines and sines of angles. The cap is that of all rotations for an axis of 0.
double needed_by_cap(const BlendsAtWeightVertices& c, const Point& center, const Q& axis) {
  double angle = length(axis) == 0 ? std::numbers::pi : 0;
  for (const Q& q : c.rotations) {
    if (length(axis) == 0) break;
    if (!(along(q, axis) > 0)) return nothing;
    const Q across = q - axis * (along(q, axis) / along(axis, axis));
    angle = std::max(angle, 2 * std::atan2(length(across) * length(axis), along(q, axis)));
  }
  const double size = length(c.x);
  const bool is_any = angle >= std::numbers::pi / 2;
  Point middle = {0, 0, 0};
  if (!is_any) middle = image_by(axis, pure(c.x), axis) / along(axis, axis) * std::cos(angle);
  double needed = 0;
  for (const Point& r : c.center_images)
    needed = std::max(needed, length(Point(r + middle - center)) + size * (is_any ? 1 : std::sin(angle)));
  return needed;
}

double needed_by_reach(const BlendsAtWeightVertices& c, const Point& center, const Q& axis, const Point& f) {
  double reach = 0;
  for (std::size_t k = 0; k < c.rotations.size(); ++k) {
    if (!(along(c.rotations[k], axis) > 0)) return nothing;
    const Q e = 2 * c.duals[k] + multiply<double>(c.rotations[k], pure(c.x)) - multiply<double>(pure(f), c.rotations[k]);
    reach = std::max(reach, length(e) * length(axis) / along(c.rotations[k], axis));
  }
  return length(Point(f - center)) + reach;
}

// Returns the half with the middle of the edge in place of its first end.
BlendsAtWeightVertices half(BlendsAtWeightVertices c, std::size_t replaced, std::size_t other) {
  c.rotations[replaced] = (c.rotations[replaced] + c.rotations[other]) / 2;
  if (c.duals.empty()) c.center_images[replaced] = (c.center_images[replaced] + c.center_images[other]) / 2;
  else c.duals[replaced] = (c.duals[replaced] + c.duals[other]) / 2;
  return c;
}

}  // namespace

BlendsAtWeightVertices blend_at_weight_vertices(const PaletteEntry<double>& palette,
                                                const std::vector<std::vector<double>>& weight_vertices, const Point& p,
                                                Skinning skinning) {
  BlendsAtWeightVertices out;
  const bool is_dual = skinning == Skinning::dual_quaternion;
  out.x = is_dual ? p : Point(p - palette.rotation_center);
  for (const auto& w : weight_vertices) {
    Q q = {0, 0, 0, 0}, d = {0, 0, 0, 0};
    Point r = {0, 0, 0};
    for (std::size_t i = 0; i < w.size(); ++i) {
      q += w[i] * palette.transforms[i].rotation;
      if (is_dual) d += w[i] * palette.duals[i];
      else r += w[i] * palette.center_images[i];
    }
    out.rotations.push_back(q);
    if (is_dual) out.duals.push_back(d);
    else out.center_images.push_back(r);
  }
  return out;
}

double needed_radius(const BlendsAtWeightVertices& weight_vertices, const Bound& bound, const Point& center) {
  switch (bound.by) {
    case By::control: return needed_by_control(weight_vertices, center);
    case By::all_rotations: return needed_by_cap(weight_vertices, center, {0, 0, 0, 0});
    case By::cap: return needed_by_cap(weight_vertices, center, bound.axis);
    case By::reach: return needed_by_reach(weight_vertices, center, bound.axis, bound.center);
    case By::stretch: throw std::logic_error("a stretch is of affine joints");
    case By::halves: break;
  }
  const auto [k, l] = bound.edge;
  return std::max(needed_radius(half(weight_vertices, k, l), bound.halves[0], center),
                  needed_radius(half(weight_vertices, l, k), bound.halves[1], center));
}

std::vector<Bound> first_tried(const BlendsAtWeightVertices& c) {
  if (!c.duals.empty()) {
    std::vector<BlendedDuals<double>> blends;
    Point f = {0, 0, 0};
    for (std::size_t k = 0; k < c.rotations.size(); ++k) {
      blends.push_back({c.rotations[k], c.duals[k]});
      Control at;
      add(at, c, k, k);
      f += at.numerator / at.weight / double(c.rotations.size());
    }
    // The axis is a hint, which proves nothing.
    return {{.by = By::reach, .axis = DualQuaternionPiece<double>::axis_of(blends), .center = f}};
  }
  std::vector<Bound> out{{.by = By::all_rotations}};
  std::vector<Q> units;
  for (const Q& q : c.rotations) {
    if (length(q) == 0) return out;
    units.push_back(q / length(q));
  }
  Q mean = {0, 0, 0, 0};
  for (const Q& q : units) mean += q;
  out.push_back({.by = By::cap, .axis = mean});
  out.push_back({.by = By::cap, .axis = SmallestBalls::center_of_points(std::span<const Q>(units))});
  return out;
}

double least_found_radius(const BlendsAtWeightVertices& weight_vertices, const Point& center, int halvings) {
  double here = needed_by_control(weight_vertices, center);
  for (const Bound& bound : first_tried(weight_vertices)) here = std::min(here, needed_radius(weight_vertices, bound, center));
  const std::size_t m = weight_vertices.rotations.size();
  if (halvings == 0 || m == 1) return here;
  std::size_t k = 1, l = 0;
  const auto cosine = [&](std::size_t a, std::size_t b) {
    return along(weight_vertices.rotations[a], weight_vertices.rotations[b]) /
           (length(weight_vertices.rotations[a]) * length(weight_vertices.rotations[b]));
  };
  for (std::size_t a = 0; a < m; ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (cosine(a, b) < cosine(k, l)) k = a, l = b;
  const double first = least_found_radius(half(weight_vertices, k, l), center, halvings - 1);
  return std::min(here, std::max(first, least_found_radius(half(weight_vertices, l, k), center, halvings - 1)));
}

double needed_radius_linear(const PaletteEntry<double>& palette, const std::vector<std::vector<double>>& weight_vertices,
                            const Ball3<double>& reference, const Point& center) {
  double needed = 0;
  for (const auto& w : weight_vertices) {
    Point image = {0, 0, 0};
    double growth = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      const auto& [q, t] = palette.transforms[i];
      const Point u = imaginary<double>(q), v = reference.center,
                  turn = cross<double>(u, v) * q[0] + cross<double>(u, cross<double>(u, v));
      image += w[i] * (v + 2 * turn + t);
      growth += w[i] * (along(q, q) + std::abs(1 - along(q, q)));
    }
    needed = std::max(needed, length(Point(image - center)) + growth * reference.radius);
  }
  return needed;
}

}  // namespace proptests::oracle
