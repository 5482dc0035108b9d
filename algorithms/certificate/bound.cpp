// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/skinning/convert_palette.hpp"
#include "lemmas/a1_affine_image.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/s41_weight_vertices_span.hpp"
#include "lemmas/s44_joint_sets.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace refitlab {
namespace {

using By = Bound::By;
using Point = Vec<Rational, 3>;

constexpr int most_halvings_tried = most_halvings + 3;  // a ball that is not a refit's may need more

// A WeightVertex is kept exactly, and as a refit in double has it.
template <template <class> class Blend>
struct WeightVertex {
  Blend<Rational> exact;
  Blend<double> rounded;
};

// Mixtures has W_kl and N_kl of degree 2, and whether all W_kl are positive.
struct Mixtures {
  template <class Piece, class WeightVertices>
  Mixtures(const Piece& piece, const WeightVertices& weight_vertices) : m(weight_vertices.size()) {
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l < m; ++l) {
        entries.push_back(piece.mix(weight_vertices[k].exact, weight_vertices[l].exact));
        are_positive = are_positive && entries.back().weight > 0;
      }
  }
  const MixedPair<Rational>& operator()(std::size_t k, std::size_t l) const { return entries[k * m + l]; }

  std::size_t m;
  std::vector<MixedPair<Rational>> entries;
  bool are_positive = true;
};

// A SphericalClaim says that the blends of a spherical piece carry x into the target.
struct SphericalClaim {
  using WeightVertex = refitlab::WeightVertex<BlendedJoints>;
  Point x;
  Ball3<Rational> target;

  template <class S>
  static BlendedJoints<S> blend(const PaletteEntry<S>& palette, std::span<const S> w) {
    return blend_joints(palette, w);
  }
  static WeightVertex middle(const WeightVertex& a, const WeightVertex& b) {
    return {SphericalPiece<Rational>::middle(a.exact, b.exact), SphericalPiece<double>::middle(a.rounded, b.rounded)};
  }

  std::optional<Bound> prove(const std::vector<WeightVertex>& weight_vertices) const {
    if (by_cap(weight_vertices, {0, 0, 0, 0})) return Bound{By::all_rotations};
    for (const auto& axis : axes(weight_vertices))
      if (by_cap(weight_vertices, axis)) return Bound{By::cap, axis};
    if (by_control(weight_vertices)) return Bound{By::control};
    return {};
  }

 private:
  // Returns the centers of the two balls that refits make around the unit quaternions, or none if a weight vertex vanishes.
  static std::vector<Quaternion<double>> axes(const std::vector<WeightVertex>& weight_vertices) {
    std::vector<Quaternion<double>> unit;
    for (const WeightVertex& c : weight_vertices) {
      const double length = norm(c.rounded.rotation);
      if (!(length > 0)) return {};
      unit.push_back(c.rounded.rotation / length);
    }
    const std::span<const Quaternion<double>> points(unit);
    return {MeanBalls::center_of_points(points), SmallestBalls::center_of_points(points)};
  }

  // Judges the bound by the cap about an axis. The axis 0 stands for all rotations.
  bool by_cap(const std::vector<WeightVertex>& weight_vertices, const Quaternion<double>& axis) const {
    CapFallback<Rational> cap{{}, {}, convert<Rational>(axis), 0};
    for (const WeightVertex& c : weight_vertices) cap.rotations.push_back(c.exact.rotation);
    if (squared_norm(cap.axis) > 0) {
      if (are_strictly_ahead(cap.rotations, cap.axis) != Verdict::holds) return false;
      cap.squared_cosine = squared_cap_cosine<Rational>(cap.rotations, cap.axis);
    }
    const SquaredBall<Rational, 3> turned = fallback_ball(cap, x);
    for (const WeightVertex& c : weight_vertices)
      if (encloses_part<Rational>(target, {c.exact.center_image + turned.center, turned.squared_radius}) != Verdict::holds)
        return false;
    return true;
  }

  bool by_control(const std::vector<WeightVertex>& weight_vertices) const {
    const Mixtures mixed(SphericalPiece<Rational>(x, 0), weight_vertices);
    if (!mixed.are_positive) return false;
    for (std::size_t j = 0; j < weight_vertices.size(); ++j)
      for (std::size_t k = j; k < weight_vertices.size(); ++k)
        for (std::size_t l = k; l < weight_vertices.size(); ++l) {
          const auto point =
              spherical_control_point(mixed(j, k), mixed(k, l), mixed(j, l), weight_vertices[j].exact.center_image,
                                      weight_vertices[k].exact.center_image, weight_vertices[l].exact.center_image);
          if (encloses<Rational, 3>(target, point.numerator / point.denominator) != Verdict::holds) return false;
        }
    return true;
  }
};

// A DualQuaternionClaim says that the blends of a dual quaternion piece carry x into the target.
struct DualQuaternionClaim {
  using WeightVertex = refitlab::WeightVertex<BlendedDuals>;
  Point x;
  Ball3<Rational> target;

  template <class S>
  static BlendedDuals<S> blend(const PaletteEntry<S>& palette, std::span<const S> w) {
    return blend_duals(palette, w);
  }
  static WeightVertex middle(const WeightVertex& a, const WeightVertex& b) {
    return {DualQuaternionPiece<Rational>::middle(a.exact, b.exact), DualQuaternionPiece<double>::middle(a.rounded, b.rounded)};
  }

  std::optional<Bound> prove(const std::vector<WeightVertex>& weight_vertices) const {
    if (auto bound = by_reach(weight_vertices)) return bound;
    if (by_control(weight_vertices)) return Bound{By::control};
    return {};
  }

 private:
  std::optional<Bound> by_reach(const std::vector<WeightVertex>& weight_vertices) const {
    std::vector<BlendedDuals<double>> rounded;
    DualQuaternionBlend<Rational> exact{{}, {}, x};
    for (const WeightVertex& c : weight_vertices) {
      rounded.push_back(c.rounded);
      exact.rotations.push_back(c.exact.rotation);
      exact.duals.push_back(c.exact.dual);
    }
    Bound bound{By::reach, DualQuaternionPiece<double>::axis_of(rounded)};
    if (!bound.axis.allFinite()) return {};
    const Quaternion<Rational> axis = convert<Rational>(bound.axis);
    if (are_strictly_ahead(exact.rotations, axis) != Verdict::holds) return {};
    Point middle = Point::Zero();
    for (const WeightVertex& c : weight_vertices)
      middle += move_rigidly<Rational>(c.exact, squared_norm(c.exact.rotation), x) / Rational(int(weight_vertices.size()));
    for (int i = 0; i < 3; ++i) bound.center[i] = CGAL::to_double(middle[i]);
    if (encloses_part(target, dual_quaternion_ball<Rational>(exact, axis, convert<Rational>(bound.center))) != Verdict::holds)
      return {};
    return bound;
  }

  bool by_control(const std::vector<WeightVertex>& weight_vertices) const {
    const Mixtures mixed(DualQuaternionPiece<Rational>(x, 0), weight_vertices);
    if (!mixed.are_positive) return false;
    for (const auto& kl : mixed.entries)
      if (encloses<Rational, 3>(target, kl.numerator / kl.weight) != Verdict::holds) return false;
    return true;
  }
};

// Returns the edge at which a refit halves a simplex.
template <class WeightVertex>
std::array<std::size_t, 2> edge_to_halve(const std::vector<WeightVertex>& weight_vertices) {
  const auto [k, l] = widest_edge<double>(weight_vertices.size(), [&](std::size_t a, std::size_t b) {
    return mix_rotations<double>(weight_vertices[a].rounded.rotation, weight_vertices[b].rounded.rotation, {0, 0, 0}).weight;
  });
  return {k, l};
}

template <class Claim>
std::optional<Bound> search(const Claim& claim, const std::vector<typename Claim::WeightVertex>& weight_vertices,
                            int halvings_left) {
  if (auto bound = claim.prove(weight_vertices)) return bound;
  if (halvings_left == 0 || weight_vertices.size() == 1) return {};
  Bound bound{.by = By::halves, .edge = edge_to_halve(weight_vertices)};
  const auto middle = Claim::middle(weight_vertices[bound.edge[0]], weight_vertices[bound.edge[1]]);
  for (const std::size_t replaced : bound.edge) {
    auto half = weight_vertices;
    half[replaced] = middle;
    auto of_half = search(claim, half, halvings_left - 1);
    if (!of_half) return {};
    bound.halves.push_back(*std::move(of_half));
  }
  return bound;
}

// Judges linear blending. A joint whose quaternion is not of unit length may make a vector longer.
bool linear_holds(const PaletteEntry<Rational>& palette, const std::vector<std::vector<Rational>>& weight_vertices,
                  const Ball3<Rational>& reference, const Ball3<Rational>& ball) {
  for (const auto& w : weight_vertices) {
    Rational growth(0);
    for (std::size_t i = 0; i < w.size(); ++i)
      growth += w[i] * stretch_of_rotate<Rational>(squared_norm(palette.transforms[i].rotation));
    const Ball3<Rational> image{blend_linear<Rational>(palette, w, reference.center), reference.radius * growth};
    if (encloses(ball, image) != Verdict::holds) return false;
  }
  return true;
}

// Returns a double whose square is no less. For squares below 2^-1000 it is 2^-500, since squares of doubles may be no doubles
// there.
Rational root_above(const Rational& square) {
  if (square == 0) return 0;
  double root = std::max(std::sqrt(CGAL::to_double(square)), 0x1p-500);
  while (Rational(root) * Rational(root) < square) root = std::nextafter(root, std::numeric_limits<double>::infinity());
  return root;
}

// Looks for a bound by stretches: at each weight vertex, the lesser of the blend's stretch and of the joints' stretches, blended.
std::optional<Bound> find_stretch(const PaletteEntry<Rational>& palette,
                                  const std::vector<std::vector<Rational>>& weight_vertices, const Ball3<Rational>& reference,
                                  const Ball3<Rational>& ball) {
  Bound bound{.by = By::stretch};
  for (const AffineMap<Rational>& map : palette.maps) bound.of_joints.push_back(root_above(squared_stretch(map)));
  for (const auto& w : weight_vertices) {
    bound.of_weight_vertices.push_back(root_above(blended_squared_stretch<Rational>(palette.maps, bound.of_joints, w)));
    const Ball3<Rational> image{linear_blend<Rational>(palette.maps, w, reference.center),
                                reference.radius * bound.of_weight_vertices.back()};
    if (encloses(ball, image) != Verdict::holds) return {};
  }
  return bound;
}

}  // namespace

std::optional<Bound> find_bound(const RefitNode<double>& node, std::size_t piece, Skinning skinning, const Ball3<double>& ball) {
  const DefaultFloatEnvironment environment;
  const NodePiece& set = node.pieces[piece];
  const PaletteEntry<double> rounded = node.palette[set.joint_set];
  const OwnedPaletteEntry<Rational> owned = convert<Rational>(rounded);
  const PaletteEntry<Rational> palette = owned;
  std::vector<std::vector<Rational>> weight_vertices;
  for (int k = 0; k < set.weight_vertex_count; ++k) {
    const auto w = node.weight_vertex(set, k);
    weight_vertices.emplace_back(w.begin(), w.end());
  }
  const auto as_exact = [](const Ball3<double>& b) { return Ball3<Rational>{convert<Rational>(b.center), b.radius}; };
  const Ball3<Rational> reference = as_exact(node.piece_reference(piece)), around = as_exact(ball);
  if (!palette.maps.empty()) return find_stretch(palette, weight_vertices, reference, around);
  const auto searched = [&]<class Claim>(const Claim& claim) {
    std::vector<typename Claim::WeightVertex> blends;
    for (int k = 0; k < set.weight_vertex_count; ++k)
      blends.push_back(
          {Claim::template blend<Rational>(palette, weight_vertices[k]), Claim::blend(rounded, node.weight_vertex(set, k))});
    return search(claim, blends, most_halvings_tried);
  };
  // Rigid blends carry the reference ball to within its radius of where they carry its center.
  const Ball3<Rational> target{around.center, around.radius - reference.radius};
  if (target.radius < 0) return {};
  switch (skinning) {
    case Skinning::linear:
      if (linear_holds(palette, weight_vertices, reference, around)) return Bound{By::control};
      return {};
    case Skinning::dual_quaternion: return searched(DualQuaternionClaim{reference.center, target});
    default: return searched(SphericalClaim{reference.center - palette.rotation_center, target});
  }
}

}  // namespace refitlab
