// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/bound.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/refit/dual_quaternion.hpp"
#include "algorithms/runtime/skinning/convert_palette.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/exact/exact.hpp"
#include "lemmas/s44_joint_sets.hpp"

namespace refitlab {
namespace {

using By = Bound::By;
using Point = Vec<Rational, 3>;

constexpr int most_halvings_tried = most_halvings + 3;  // a ball that is not a refit's may need more

// A corner exactly, and as a refit in double has it.
template <template <class> class Blend>
struct Corner {
  Blend<Rational> exact;
  Blend<double> rounded;
};

// W_kl and N_kl of degree 2, and whether all W_kl are positive.
struct Mixtures {
  template <class Piece, class Corners>
  Mixtures(const Piece& piece, const Corners& corners) : m(corners.size()) {
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l < m; ++l) {
        entries.push_back(piece.mix(corners[k].exact, corners[l].exact));
        are_positive = are_positive && entries.back().weight > 0;
      }
  }
  const MixedCorners<Rational>& operator()(std::size_t k, std::size_t l) const { return entries[k * m + l]; }

  std::size_t m;
  std::vector<MixedCorners<Rational>> entries;
  bool are_positive = true;
};

// The blends of a spherical piece carry x into the target.
struct SphericalClaim {
  using Corner = refitlab::Corner<BlendedJoints>;
  Point x;
  Ball3<Rational> target;

  template <class S>
  static BlendedJoints<S> blend(const PaletteEntry<S>& palette, std::span<const S> w) {
    return blend_joints(palette, w);
  }
  static Corner middle(const Corner& a, const Corner& b) {
    return {SphericalPiece<Rational>::middle(a.exact, b.exact), SphericalPiece<double>::middle(a.rounded, b.rounded)};
  }

  std::optional<Bound> prove(const std::vector<Corner>& corners) const {
    if (by_cap(corners, {0, 0, 0, 0})) return Bound{By::all_rotations};
    for (const auto& axis : axes(corners))
      if (by_cap(corners, axis)) return Bound{By::cap, axis};
    if (by_control(corners)) return Bound{By::control};
    return {};
  }

 private:
  // The centers of both of the refits' balls around the unit quaternions; none where a corner vanishes.
  static std::vector<Quaternion<double>> axes(const std::vector<Corner>& corners) {
    std::vector<Quaternion<double>> unit;
    for (const Corner& c : corners) {
      const double length = norm(c.rounded.rotation);
      if (!(length > 0)) return {};
      unit.push_back(c.rounded.rotation / length);
    }
    const std::span<const Quaternion<double>> points(unit);
    return {MeanBalls::center_of_points(points), SmallestBalls::center_of_points(points)};
  }

  // Of all rotations for the axis 0.
  bool by_cap(const std::vector<Corner>& corners, const Quaternion<double>& axis) const {
    CapFallback<Rational> cap{{}, {}, convert<Rational>(axis), 0};
    for (const Corner& c : corners) cap.rotations.push_back(c.exact.rotation);
    if (squared_norm(cap.axis) > 0) {
      if (are_strictly_ahead(cap.rotations, cap.axis) != Verdict::holds) return false;
      cap.squared_cosine = squared_cap_cosine<Rational>(cap.rotations, cap.axis);
    }
    const SquaredBall<Rational, 3> turned = fallback_ball(cap, x);
    for (const Corner& c : corners)
      if (encloses_part<Rational>(target, {c.exact.center_image + turned.center, turned.squared_radius}) != Verdict::holds)
        return false;
    return true;
  }

  bool by_control(const std::vector<Corner>& corners) const {
    const Mixtures mixed(SphericalPiece<Rational>(x, 0), corners);
    if (!mixed.are_positive) return false;
    for (std::size_t j = 0; j < corners.size(); ++j)
      for (std::size_t k = j; k < corners.size(); ++k)
        for (std::size_t l = k; l < corners.size(); ++l) {
          const auto point = spherical_control_point(mixed(j, k), mixed(k, l), mixed(j, l), corners[j].exact.center_image,
                                                     corners[k].exact.center_image, corners[l].exact.center_image);
          if (encloses<Rational, 3>(target, point.numerator / point.denominator) != Verdict::holds) return false;
        }
    return true;
  }
};

// The blends of a dual quaternion piece carry x into the target.
struct DualQuaternionClaim {
  using Corner = refitlab::Corner<BlendedDuals>;
  Point x;
  Ball3<Rational> target;

  template <class S>
  static BlendedDuals<S> blend(const PaletteEntry<S>& palette, std::span<const S> w) {
    return blend_duals(palette, w);
  }
  static Corner middle(const Corner& a, const Corner& b) {
    return {DualQuaternionPiece<Rational>::middle(a.exact, b.exact), DualQuaternionPiece<double>::middle(a.rounded, b.rounded)};
  }

  std::optional<Bound> prove(const std::vector<Corner>& corners) const {
    if (auto bound = by_reach(corners)) return bound;
    if (by_control(corners)) return Bound{By::control};
    return {};
  }

 private:
  std::optional<Bound> by_reach(const std::vector<Corner>& corners) const {
    std::vector<BlendedDuals<double>> rounded;
    DualQuaternionBlend<Rational> exact{{}, {}, x};
    for (const Corner& c : corners) {
      rounded.push_back(c.rounded);
      exact.rotations.push_back(c.exact.rotation);
      exact.duals.push_back(c.exact.dual);
    }
    Bound bound{By::reach, DualQuaternionPiece<double>::axis_of(rounded)};
    if (!bound.axis.allFinite()) return {};
    const Quaternion<Rational> axis = convert<Rational>(bound.axis);
    if (are_strictly_ahead(exact.rotations, axis) != Verdict::holds) return {};
    Point middle = Point::Zero();
    for (const Corner& c : corners)
      middle += move_rigidly<Rational>(c.exact, squared_norm(c.exact.rotation), x) / Rational(int(corners.size()));
    for (int i = 0; i < 3; ++i) bound.center[i] = CGAL::to_double(middle[i]);
    if (encloses_part(target, dual_quaternion_ball<Rational>(exact, axis, convert<Rational>(bound.center))) != Verdict::holds)
      return {};
    return bound;
  }

  bool by_control(const std::vector<Corner>& corners) const {
    const Mixtures mixed(DualQuaternionPiece<Rational>(x, 0), corners);
    if (!mixed.are_positive) return false;
    for (const auto& kl : mixed.entries)
      if (encloses<Rational, 3>(target, kl.numerator / kl.weight) != Verdict::holds) return false;
    return true;
  }
};

// The edge at which a refit halves a simplex.
template <class Corner>
std::array<std::size_t, 2> edge_to_halve(const std::vector<Corner>& corners) {
  const auto [k, l] = widest_edge<double>(corners.size(), [&](std::size_t a, std::size_t b) {
    return mix_rotations<double>(corners[a].rounded.rotation, corners[b].rounded.rotation, {0, 0, 0}).weight;
  });
  return {k, l};
}

template <class Claim>
std::optional<Bound> search(const Claim& claim, const std::vector<typename Claim::Corner>& corners, int halvings_left) {
  if (auto bound = claim.prove(corners)) return bound;
  if (halvings_left == 0 || corners.size() == 1) return {};
  Bound bound{.by = By::halves, .edge = edge_to_halve(corners)};
  const auto middle = Claim::middle(corners[bound.edge[0]], corners[bound.edge[1]]);
  for (const std::size_t replaced : bound.edge) {
    auto half = corners;
    half[replaced] = middle;
    auto of_half = search(claim, half, halvings_left - 1);
    if (!of_half) return {};
    bound.halves.push_back(*std::move(of_half));
  }
  return bound;
}

// A joint whose quaternion q is not of unit length maps by M = ||q||^2 R_q + 1 - ||q||^2, which makes a vector longer.
bool linear_holds(const PaletteEntry<Rational>& palette, const std::vector<std::vector<Rational>>& corners,
                  const Ball3<Rational>& reference, const Ball3<Rational>& ball) {
  for (const auto& w : corners) {
    Rational growth(0);
    for (std::size_t i = 0; i < w.size(); ++i) {
      const Rational n = squared_norm(palette.transforms[i].rotation);
      growth += w[i] * (n + abs(Rational(1 - n)));
    }
    const Ball3<Rational> image{blend_linear<Rational>(palette, w, reference.center), reference.radius * growth};
    if (encloses(ball, image) != Verdict::holds) return false;
  }
  return true;
}

}  // namespace

std::optional<Bound> find_bound(const RefitNode<double>& node, std::size_t piece, Skinning skinning, const Ball3<double>& ball) {
  const DefaultFloatEnvironment environment;
  const NodePiece& set = node.pieces[piece];
  const PaletteEntry<double> rounded = node.palette[set.joint_set];
  const OwnedPaletteEntry<Rational> owned = convert<Rational>(rounded);
  const PaletteEntry<Rational> palette = owned;
  std::vector<std::vector<Rational>> corners;
  for (int k = 0; k < set.weight_vertex_count; ++k) {
    const auto w = node.corner(set, k);
    corners.emplace_back(w.begin(), w.end());
  }
  const auto as_exact = [](const Ball3<double>& b) { return Ball3<Rational>{convert<Rational>(b.center), b.radius}; };
  const Ball3<Rational> reference = as_exact(node.piece_reference(piece)), around = as_exact(ball);
  const auto searched = [&]<class Claim>(const Claim& claim) {
    std::vector<typename Claim::Corner> blends;
    for (int k = 0; k < set.weight_vertex_count; ++k)
      blends.push_back({Claim::template blend<Rational>(palette, corners[k]), Claim::blend(rounded, node.corner(set, k))});
    return search(claim, blends, most_halvings_tried);
  };
  // Rigid blends carry the reference ball to within its radius of where they carry its center.
  const Ball3<Rational> target{around.center, around.radius - reference.radius};
  if (target.radius < 0) return {};
  switch (skinning) {
    case Skinning::linear:
      if (linear_holds(palette, corners, reference, around)) return Bound{By::control};
      return {};
    case Skinning::dual_quaternion: return searched(DualQuaternionClaim{reference.center, target});
    default: return searched(SphericalClaim{reference.center - palette.rotation_center, target});
  }
}

}  // namespace refitlab
