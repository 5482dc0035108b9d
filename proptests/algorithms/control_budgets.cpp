// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the budgets of rounding of control balls and of affine joints: the rates of palette_rounding.hpp are at least what the
// refits' own templates can lose. It works as float_budgets.cpp does, in u of any type; terms of higher order are those of float.
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/skinning/palette_rounding.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/cap_budget.hpp"
#include "proptests/oracles/derived_budgets.hpp"
#include "proptests/oracles/norm_budget.hpp"
#include "proptests/oracles/rounded_scales.hpp"

namespace proptests::suite_control_budgets {
namespace {

using namespace refitlab;
using oracle::Budget;
using oracle::DerivedBudgets;
using oracle::error_of_blend;
using oracle::of_length;
using oracle::rounded_scales;
using oracle::whole;
constexpr double u = Budget::u, u_double = 0x1p-53;
// This stands in place of 0, with which sums would be exact.
constexpr double tiny = 1e-30;
constexpr int numbers_of_joints[] = {1, 2, 3, 4, 8, 64};

// --- What both kinds of rates have ---

// Returns what control balls may lose beside the skinned vertices that they hold, per length and per offset.
template <class S>
RoundingRates<S> of_control_balls(const PaletteRounding<S>& r) {
  const RoundingRates<S>&whole = r.weight_vertices, &vertex = r.vertex;
  return {whole.per_length - vertex.per_length, whole.per_radius - vertex.per_radius, whole.offset - vertex.offset};
}
// Returns the error of a weight vertex in units of u, of its quaternion or its center image: that of a blend, and of middles of
// middles.
template <int D>
double error_of_weight_vertex(int joints) {
  Vec<Budget, D> v = of_length<0, D>(1, error_of_blend<D>(joints, 0) * u);
  for (int i = 0; i < most_halvings; ++i) v = middle_of(v, v);
  return whole(v).in_u();
}

// --- Spherical blending and dual quaternions ---

// Returns the greatest error of a control point N / D of near weight vertices, in u. N, D and their errors are sums over pairs of
// weight vertices, linear in the product s of the pair's lengths and in W_kl, which is between s / sqrt(near) and s. Of quotients
// of such sums, and of products of two, each factor is greatest if one pair is all of it. So the others have an s of next to
// nothing here, a power of two, by which products are exact; or none has.
template <class Piece, class WeightVertex = typename Piece::WeightVertex>
double error_of_control_points(const Piece& piece, const WeightVertex& weight_vertex) {
  constexpr std::size_t m = 3;
  const std::vector<WeightVertex> weight_vertices(m, weight_vertex);
  double worst = 0;
  for (double least = 1 / std::sqrt(Piece::near) - 128 * u; least < 1; least *= 1.01)  // This is the bound as computed.
    for (std::size_t only = 0; only <= m * m; ++only) {
      ControlLists<Budget> lists;
      for (std::size_t k = 0; k < m; ++k)
        for (std::size_t l = 0; l < m; ++l) {
          MixedPair<Budget> mixed = piece.mix(weight_vertex, weight_vertex);
          mixed.weight.most = std::min(least * 1.01, 1.0), mixed.weight.least = least;
          const Budget s(only == m * m || only == std::min(k, l) * m + std::max(k, l) ? 1 : 0x1p-60);
          lists.dots.push_back(mixed.weight * s), lists.products.push_back(mixed.numerator * s);
        }
      piece.emit(weight_vertices, lists);
      for (const auto& ball : lists.cap.balls) worst = std::max(worst, whole(ball.center).in_u());
    }
  return worst;
}
double error_of_spherical_points(double x, double image) {
  const SphericalPiece<Budget> piece(of_length<0, 3>(x), Budget(tiny));
  return error_of_control_points(piece, {of_length<0, 4>(1), of_length<0, 3>(image)});
}
// Returns the error where the duals have half the translation's length.
double error_of_dual_points(double p, double translation) {
  const DualQuaternionPiece<Budget> piece(of_length<0, 3>(p), Budget(tiny));
  return error_of_control_points(piece, {of_length<0, 4>(1), of_length<0, 4>(translation / 2)});
}

// Checks joint-sets of any kappa that a blend in float may have; in double it may be greater, and terms of higher order less. The
// hull of what is computed of weight vertices, x and centers holds the blends of these. So their errors count once, as in
// b8_blend_error.
Checked check_control_balls() {
  DerivedBudgets budgets;
  const double x = whole(Vec<Budget, 3>(of_length<0, 3>(1) - of_length<0, 3>(tiny))).in_u();
  const double spherical = error_of_spherical_points(1, tiny) + x, centers = error_of_spherical_points(tiny, 1);
  const double dual = error_of_dual_points(1, tiny), translations = error_of_dual_points(tiny, 1);
  for (const int n : numbers_of_joints)
    for (const double kappa : {1.0, 1.5, 16.0, 256.0}) {
      char name[80];
      std::snprintf(name, sizeof name, "%d joints, kappa %g, ", n, kappa);
      const auto add = [&](const char* what, double derived, double rate) {
        budgets.add(std::string(name) + what, derived, rate / u_double);
      };
      const double of_quaternion = error_of_weight_vertex<4>(n), of_center = error_of_weight_vertex<3>(n);
      const auto rates = of_control_balls(rounding_spherical(rounded_scales(n, kappa, 1, 0)));
      add("spherical, per |x|", spherical + turn_of_error(of_quaternion, kappa), rates.per_length);
      add("spherical, per center image", centers + of_center, rates.offset);
      // A cap's ball is moved by the center images.
      add("cap, per |x|", oracle::error_of_cap(of_quaternion * kappa + oracle::error_of_unit(), x * u) + 1, rates.per_length);
      add("cap, per center image", of_center + 1, rates.offset);
      // Weight vertices of length 1 / kappa move by kappa |t|, and have duals of half of |t|.
      const auto of_dual = of_control_balls(rounding_dual_quaternion(rounded_scales(n, kappa, 0, 1)));
      add("dual quaternions, per |p|", dual + turn_of_error(of_quaternion, kappa), of_dual.per_length);
      const double moved = move_of_error<double>({of_quaternion, of_quaternion / 2, 0.5, kappa});
      add("dual quaternions, per |t|", translations * kappa + moved, of_dual.offset);
    }
  return budgets.checked();
}

// Checks that rates which do not grow with kappa and joints are what was derived, or less than a unit more. The vertices' own
// blends add nothing here.
Checked check_constants() {
  DerivedBudgets budgets;
  const auto add = [&](const char* what, double derived, double rate) {
    budgets.add_up_to_a_unit(what, derived, rate / u_double);
  };
  const auto spherical = of_control_balls(rounding_spherical(rounded_scales(0, 0, 1, 0)));
  const auto dual = of_control_balls(rounding_dual_quaternion(rounded_scales(0, 1, 0, 1)));
  add("spherical, per |x|", error_of_spherical_points(1, tiny) + 1, spherical.per_length);
  add("spherical, per center image", error_of_spherical_points(tiny, 1) + most_halvings, spherical.offset);
  add("dual quaternions, per |p|", error_of_dual_points(1, tiny) + 2 * most_halvings, dual.per_length);
  add("dual quaternions, per |t|", error_of_dual_points(tiny, 1) + 2 * most_halvings, dual.offset);
  return budgets.checked();
}

// Checks the ball that dual quaternions fall back on, for the shortest weight vertices and the least cosine that it accepts. The
// greatest number of joints is one that no asset has.
Checked check_fallback() {
  DerivedBudgets budgets;
  const double least = least_fallback_cosine * least_fallback_length;
  for (const int n : {1, 2, 3, 4, 8, 64, 1000}) {
    const double of_weight_vertex = error_of_weight_vertex<4>(n) * u;
    const Quaternion<Budget> q = of_length<0, 4>(1, of_weight_vertex);
    const auto of_reach = [&](double t, double p, double f) {
      const BlendedDuals<Budget> weight_vertex{q, of_length<0, 4>(t / 2, t / 2 * of_weight_vertex)};
      return whole(reach_of(weight_vertex, Vec<Budget, 3>(of_length<0, 3>(p)), Vec<Budget, 3>(of_length<0, 3>(f)))).in_u();
    };
    // This is the error of ||E|| ||a|| / (q, a), relative to itself.
    const Budget square(1, squared_norm(Quaternion<Budget>(of_length<0, 4>(1))).error, 1), exact(1, 0, 1);
    const double of_quotient = root(Budget(square / sq(exact) * square)).in_u();
    const double of_cosine = dot(q, Quaternion<Budget>(of_length<0, 4>(1))).in_u();
    const double allowed = fallback_slack(n) / u_double;
    const std::string joints = std::to_string(n) + " joints, ";
    budgets.add(joints + "per |t|", of_reach(1, tiny, tiny) / least, allowed);
    budgets.add(joints + "per |p|", of_reach(tiny, 1, tiny) / least, allowed);
    budgets.add(joints + "per |f|", of_reach(tiny, tiny, 1) / least, allowed);
    budgets.add(joints + "per radius", of_cosine / least + of_quotient, allowed);
    // Two units are for terms of higher order.
    budgets.add(joints + "and not three more", allowed, (of_reach(tiny, 1, tiny) + 3) / least);
  }
  return budgets.checked();
}

// --- Linear blending ---

// Returns the error of an image under a map whose matrix has a Frobenius norm of 1, and an offset of this length. It is linear in
// the products of a column's length and a coordinate, which add up to at most ||p||: so it is greatest where one of them is all.
double error_of_affine_image(double point, double offset) {
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    AffineMap<Budget> map{{of_length<0, 3>(tiny), of_length<0, 3>(tiny), of_length<0, 3>(tiny)}, of_length<0, 3>(offset)};
    map.columns[k] = of_length<0, 3>(1);
    Vec<Budget, 3> p = of_length<0, 3>(tiny);
    p[k] = Budget(point, 0, 0);
    worst = std::max(worst, whole(apply(map, p)).in_u());
  }
  return worst;
}

// Returns s^2 for all columns whose squared lengths add up to 1. It is at least the greatest eigenvalue of A^T A, and so at least
// 1/3.
Budget squared_stretch_of_unit() {
  constexpr int cells = 64;
  Budget out(0, 0, 1. / 3);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double a = i * 1. / cells, b = j * 1. / cells, c = 1 - a * a - b * b;
      if (c < 0) continue;
      const AffineMap<Budget> map{
          {of_length<0, 3>(a + 1. / cells), of_length<0, 3>(b + 1. / cells), of_length<0, 3>(std::sqrt(c))},
          of_length<0, 3>(tiny)};
      out = max(out, squared_stretch(map));
    }
  return out;
}

Checked check_linear() {
  DerivedBudgets budgets;
  const double of_point = error_of_affine_image(1, tiny), of_offset = error_of_affine_image(tiny, 1);
  // These are computed of a matrix of Frobenius norm 1, in u, and multiplied by the radius.
  const Budget squared = squared_stretch_of_unit(), radius(1, 0, 0), stretched = root(squared) * radius;
  const double greatest = std::sqrt(squared.most), own = root(squared).in_u() / std::sqrt(squared.least);
  // The factor of a joint is rounded up by more than a blend of factors may lose.
  const double raised = (stretch_of(identity_map<double>()) - 1) / u_double - own;
  const Budget of_factor = root(sq(Budget(1, 0, 1 - 1e-9))) * radius;
  // The blend of no joints adds nothing.
  const auto vertex = rounding_affine(rounded_scales(0, 1, 0, 1, 1)).vertex;
  budgets.add_up_to_a_unit("a vertex, per F |p|", of_point, vertex.per_length / u_double);
  budgets.add_up_to_a_unit("a vertex, per |t|", of_offset, vertex.offset / u_double);
  budgets.add("per F r, with one more", rounding_affine(rounded_scales(0, 1, 0, 0, 1)).weight_vertices.per_radius / u_double - 1,
              stretched.in_u());
  for (const int n : numbers_of_joints) {
    const std::string joints = std::to_string(n) + " joints, ";
    const auto rounding = rounding_affine(rounded_scales(n, 1, 0, 1, 1));
    const auto more = of_control_balls(rounding), linear = of_control_balls(rounding_linear(rounded_scales(n, 1, 0, 1)));
    const auto of_linear = rounding_linear(rounded_scales(n, 1, 0, 1)).vertex;
    // The matrix that is blended is off by a blend's error, and stretches by so much more.
    const double of_blend = error_of_blend<3>(n, 0);
    budgets.add(joints + "per F |p|", error_of_blend<3>(n, of_point * u), rounding.vertex.per_length / u_double);
    budgets.add(joints + "per |t|", error_of_blend<3>(n, of_offset * u), rounding.vertex.offset / u_double);
    budgets.add(joints + "per F r, of the blended matrix", of_blend + stretched.in_u(), more.per_radius / u_double);
    // This holds for any number of joints.
    const double of_factors = greatest * (16 * of_blend + of_factor.in_u() - raised);
    budgets.add(joints + "times 16, per F r, of blended factors", std::max(1., of_factors),
                rounding_affine(rounded_scales(16 * n, 1, 0, 0, 1)).weight_vertices.per_radius / u_double);
    // The centers of control balls are computed as vertices are.
    budgets.add(joints + "control balls, per F |p|", rounding.vertex.per_length / u_double, more.per_length / u_double);
    budgets.add(joints + "control balls, per |t|", rounding.vertex.offset / u_double, more.offset / u_double);
    budgets.add(joints + "control balls, rigid, per |p|", of_linear.per_length / u_double, linear.per_length / u_double);
    budgets.add(joints + "control balls, rigid, per |t|", of_linear.offset / u_double, linear.offset / u_double);
  }
  return budgets.checked();
}

}  // namespace

PROPTEST(control_budgets) {
  const Options options{.number_type = "bounds of any float"};
  t.example("control balls allow for what the formulas may lose", options, check_control_balls);
  t.example("the ball that dual quaternions fall back on allows for what its formulas may lose", options, check_fallback);
  t.example("the constants of control balls are derived up to a unit", options, check_constants);
  t.example("control balls of linear blending allow for what matrices may lose", options, check_linear);
}

}  // namespace proptests::suite_control_budgets
