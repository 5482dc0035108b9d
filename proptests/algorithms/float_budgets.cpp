// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the budgets of rounding in float: each allowance of a kernel is at least what its own operations can lose, for all inputs
// that it accepts. The kernels' templates run in number types that carry bounds in place of values (norm_budget.hpp,
// polynomial_budget.hpp). Where a kernel is no template, its steps are repeated here with the templates that it calls. Each check
// says what was derived and what is allowed, in u = 2^-24.
#include <cstdio>

#include "algorithms/runtime/batch/float_skin_joints.hpp"
#include "algorithms/runtime/collide/box_lanes.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/derived_budgets.hpp"
#include "proptests/oracles/norm_budget.hpp"
#include "proptests/oracles/polynomial_budget.hpp"

namespace refitlab {

// The box kernel finds this greatest error of a side.
inline double error_of_merged_box = 0;
template <>
inline void merge_lanes<proptests::oracle::Budget>(const Box<proptests::oracle::Budget>& box, const int*, FlippedBox*) {
  for (int i = 0; i < 3; ++i) error_of_merged_box = std::max({error_of_merged_box, box.low[i].in_u(), box.high[i].in_u()});
}

}  // namespace refitlab

namespace proptests::suite_float_budgets {
namespace {

using namespace refitlab;
using oracle::Budget;
using oracle::DerivedBudgets;
using oracle::of_length;
using oracle::PlainBudget;
using oracle::whole;
constexpr double u = Budget::u;

// This stands in place of 0, with which sums would be exact.
constexpr double tiny = 1e-30;

// Visits all weights of so many joints that are multiples of a share and add up to at most 1.
template <class Visit>
void for_each_weights(int joints, int share, const Visit& visit) {
  std::vector<int> w(joints, 0);
  const auto step = [&](auto&& self, int i, int left) -> void {
    if (i == joints) {
      std::vector<double> weights;
      for (const int x : w) weights.push_back(x ? double(x) / share : tiny);
      return visit(weights);
    }
    for (w[i] = 0; w[i] <= left; ++w[i]) self(self, i + 1, left - w[i]);
    w[i] = 0;
  };
  step(step, 0, share);
}

// --- Boxes around control points ---

// Quaternions whose squared lengths are off by 1e-6 stretch by 2e-6: the placement's, and the joint's in linear blending.
constexpr double stretch = 2e-6 / u;

struct BoxSizes {
  double point = tiny, image = tiny, dual = tiny, radius = tiny;
};

// Returns the greatest error of the kernel's boxes, in u, for all weights and numbers of joints. added is an error that the
// center has besides.
double error_of_boxes(Skinning skinning, const BoxSizes& sizes, double added, bool are_near) {
  Budget::answer = are_near;
  error_of_merged_box = 0;
  for (int joints = 1; joints <= most_box_joints; ++joints)
    for_each_weights(joints, 4, [&](const std::vector<double>& low) {
      BoxPack pack{};
      double rest = 1;
      for (int i = 0; i < joints; ++i) pack.low[i][0] = static_cast<float>(low[i]), rest -= low[i];
      pack.rest[0] = static_cast<float>(rest);
      for (int i = 0; i < 3; ++i) pack.center[i][0] = static_cast<float>(sizes.point);
      pack.radius[0] = static_cast<float>(sizes.radius);
      for (auto* row : {pack.low[0], pack.low[1], pack.low[2], pack.low[3], pack.rest, pack.center[0], pack.center[1],
                        pack.center[2], pack.radius})
        std::fill(row, row + box_lanes, row[0]);
      float slots[8], centers[8], rotation[9];
      std::fill(slots, slots + 4, 1.f);
      std::fill(slots + 4, slots + 8, static_cast<float>(skinning == Skinning::dual_quaternion ? sizes.dual : sizes.image));
      std::fill(centers, centers + 8, static_cast<float>(tiny));
      // A row of the placement's matrix has a length of 1.
      std::fill(rotation, rotation + 9, 1.f);
      Budget::added_begin = pack.center[0], Budget::added_end = pack.center[0] + 3 * box_lanes, Budget::added_error = added;
      baseline::BoxKernel<Budget>::run(&pack, 1, joints, skinning, slots, centers, rotation, nullptr);
      Budget::added_begin = Budget::added_end = nullptr;
    });
  Budget::answer = true;
  // The matrix is rounded to float, and a point that it turns is at most twice its sizes: |P_kl| <= 2 |x| W_kl.
  return error_of_merged_box + 2;
}

constexpr double allowed_of_box = lost_of_box / u;

Checked check_boxes() {
  DerivedBudgets budgets;
  // is_near leaves W_kk > 1/4 and W_kl > sqrt(W_kk W_ll) / 2, as computed, so less 128 u.
  oracle::least_own_weight = 0.25 - 128 * u, oracle::least_mixed_weight = 0.125 - 128 * u;
  for (const bool are_near : {true, false}) {
    const std::string which = are_near ? "spherical, per " : "spherical beyond a right angle, per ";
    // x = p - r_c has errors of u (|p| + |r_c| + |x|) <= 2 u |x| + 2 u |p|.
    budgets.add(which + "|x|", error_of_boxes(Skinning::spherical, {.point = 1}, 1, are_near), allowed_of_box);
    budgets.add(which + "|p|", error_of_boxes(Skinning::spherical, {}, 2, are_near), allowed_of_box);
    budgets.add(which + "|r|", error_of_boxes(Skinning::spherical, {.image = 1}, 0, are_near), allowed_of_box);
    budgets.add(which + "radius", error_of_boxes(Skinning::spherical, {.radius = 1}, 0, are_near) + stretch, allowed_of_box);
  }
  budgets.add("linear, per |p|", error_of_boxes(Skinning::linear, {.point = 1}, 0, true), allowed_of_box);
  budgets.add("linear, per |t|", error_of_boxes(Skinning::linear, {.image = 1}, 0, true), allowed_of_box);
  budgets.add("linear, per radius", error_of_boxes(Skinning::linear, {.radius = 1}, 0, true) + 2 * stretch, allowed_of_box);
  oracle::least_mixed_weight = 0.25 / std::sqrt(2) - 128 * u;
  budgets.add("dual quaternions, per |p|", error_of_boxes(Skinning::dual_quaternion, {.point = 1}, 0, true), allowed_of_box);
  budgets.add("dual quaternions, per 2 |d|", error_of_boxes(Skinning::dual_quaternion, {.dual = 0.5}, 0, true), allowed_of_box);
  budgets.add("dual quaternions, per radius", error_of_boxes(Skinning::dual_quaternion, {.radius = 1}, 0, true) + stretch,
              allowed_of_box);
  return budgets.checked();
}

// --- The filter of triangles ---

template <int digits, class Vertices>
Checked check_filter(const Vertices& vertices) {
  using S = oracle::PolynomialBudget<digits>;
  S::greatest_share = 0, S::compared = 0;
  TriangleOf<S> a;
  for (auto& vertex : a) vertex = {S::vertex(0), S::vertex(1), S::vertex(2)};
  const TriangleOf<S> b = a;
  [[maybe_unused]] const PlaneSides<S, Vertices> sides(a, b, vertices);
  sign_of_determinant<S>(a[0], a[1], b[0], b[1], vertices);
  char text[120];
  std::snprintf(text, sizeof text, "derived %.2f %% of the allowance", 100 * S::greatest_share);
  return Checked(S::greatest_share <= 1 && S::greatest_share > 0.45 && S::compared >= 4, S::compared, text);
}

// Derives what the sum of slopes loses of exact vertices. This counts times the slack, which is e / 2, and is compared with the terms
// of the allowance that have e once.
Checked check_slopes() {
  using S = oracle::PolynomialBudget<24>;
  using Vertices = NearVerticesBySlopes<S>;
  const auto difference = [] { return Vec<S, 3>(S::difference(0), S::difference(1), S::difference(2)); };
  const Vec<S, 3> p = difference(), q = difference(), r = difference();
  const oracle::Polynomial lost = sum_of_slopes<S>(cross<S>(q, r), cross<S>(r, p), cross<S>(p, q)).error;
  const oracle::Polynomial allowed =
      Vertices{{S::twice_slack()}}.error(S::difference(0), S::difference(1), S::difference(2)).least;
  DerivedBudgets budgets;
  for (const auto& [powers, coefficient] : lost.coefficients()) {
    auto of_allowed = powers;
    of_allowed[3] = 1;
    budgets.add("X^" + std::to_string(powers[0]) + " Y^" + std::to_string(powers[1]) + " Z^" + std::to_string(powers[2]),
                coefficient / 2 / u, allowed.at(of_allowed) / u);
  }
  return budgets.checked();
}

// Compares what the code allows for vertices that are off with what b10_determinant_error says of the floats' exact differences,
// which are within 1 + u of the computed ones. Each power of e is looked at by itself, from the least one.
template <class Vertices, int least_power>
Checked check_orders() {
  using S = oracle::PolynomialBudget<24>;
  using oracle::Polynomial;
  const auto exact = [](int axis) { return Polynomial::variable(axis) * Polynomial(1 + u); };
  const Polynomial x = exact(0), y = exact(1), z = exact(2), e = Polynomial::variable(3);
  const Polynomial lost = first_order_by_extents<Polynomial>(e, x * y + y * z + z * x) +
                          second_order_by_extents<Polynomial>(e, x + y + z) + third_order<Polynomial>(e);
  const Polynomial allowed = Vertices{{S::twice_slack()}}.error(S::difference(0), S::difference(1), S::difference(2)).least;
  DerivedBudgets budgets;
  for (const auto& [powers, coefficient] : lost.coefficients())
    if (powers[3] >= least_power)
      budgets.add("X^" + std::to_string(powers[0]) + " Y^" + std::to_string(powers[1]) + " Z^" + std::to_string(powers[2]) +
                      " e^" + std::to_string(powers[3]),
                  coefficient / u, allowed.at(powers) / u);
  return budgets.checked();
}

// --- Skinning in float ---

// Returns the error of an image whose blended quaternion has an error of so much: what that error turns (b8_blend_error), and the
// formula's own errors for a quaternion of any angle.
double error_of_turn(double length, double error_of_blend, const Vec<Budget, 3>& x, const Vec<Budget, 3>& c) {
  double worst = 0;
  constexpr int cells = 512;
  for (int cell = 0; cell < cells; ++cell) {
    const double least = cell * std::acos(0.0) / cells, most = (cell + 1) * std::acos(0.0) / cells;
    Quaternion<PlainBudget> q;
    const double real = length * std::cos(least), imaginary = length * std::sin(most);
    q[0] = PlainBudget(real, 0, 0);
    for (int i = 1; i < 4; ++i) q[i] = PlainBudget(imaginary, 0, 0);
    // All exact sums are at most ||x|| + ||c||, because the kernel's quaternions are at most 1.
    PlainBudget::longest = whole(x).most + whole(c).most;
    PlainBudget::least_squared_norm = length * length;
    const auto out =
        baseline::FloatJointSet<PlainBudget, 2>::turn_and_add(q, oracle::exact<3>(whole(x)), oracle::exact<3>(whole(c)));
    PlainBudget::longest = HUGE_VAL, PlainBudget::least_squared_norm = 0;
    worst = std::max(worst, whole(out).in_u());
  }
  const double turned = turn_of_error(error_of_blend, 1 / length) * (whole(x).most + whole(x).error);
  return worst + (turned + whole(x).error + whole(c).error) / u;
}

}  // namespace
}  // namespace proptests::suite_float_budgets

namespace refitlab::baseline {
namespace {

// Holds the blended quaternion, point and center, so that their errors are taken apart.
template <int N>
struct Blended {
  static inline Quaternion<proptests::oracle::Budget> q;
  static inline Vec<proptests::oracle::Budget, 3> x, c;
};
#define PROPTESTS_TAKE_APART(N)                                                                       \
  template <>                                                                                         \
  inline Vec<proptests::oracle::Budget, 3> FloatJointSet<proptests::oracle::Budget, N>::turn_and_add( \
      const Quaternion<proptests::oracle::Budget>& q, const Vec<proptests::oracle::Budget, 3>& x,     \
      const Vec<proptests::oracle::Budget, 3>& c) {                                                   \
    Blended<N>::q = q, Blended<N>::x = x, Blended<N>::c = c;                                          \
    return c;                                                                                         \
  }
PROPTESTS_TAKE_APART(2)
PROPTESTS_TAKE_APART(3)
PROPTESTS_TAKE_APART(4)
#undef PROPTESTS_TAKE_APART

}  // namespace
}  // namespace refitlab::baseline

namespace proptests::suite_float_budgets {
namespace {

template <int D>
Vec<Budget, D> rounded_input(double length, bool is_step = false) {
  Vec<Budget, D> out = of_length<0, D>(length, u * length);
  for (int i = 0; i < D; ++i) out[i].is_step = is_step;
  return out;
}

// Returns the error for N joints, with |p| + |r| = X.
template <int N>
double error_of_float_skin(double point, double image) {
  using Joints = baseline::FloatJointSet<Budget, N>;
  Joints joints;
  joints.rotation = rounded_input<4>(1);
  joints.center = rounded_input<3>(point / 2), joints.image = rounded_input<3>(image);
  for (int j = 0; j < N - 1; ++j)
    joints.rotation_from[j] = rounded_input<4>(std::sqrt(2.0), true), joints.image_from[j] = rounded_input<3>(2 * image, true);
  double worst = 0;
  for_each_weights(N - 1, 8, [&](const std::vector<double>& w) {
    joints.skin(rounded_input<3>(point / 2), [&](int j) { return Budget(w[j]); });
    using Parts = baseline::Blended<N>;
    for (const double length : {1 / largest_float_kappa, 1.0})
      worst = std::max(worst, error_of_turn(length, whole(Parts::q).error, Parts::x, Parts::c));
  });
  return worst;
}

// Returns the error for one joint, per |p|, and per |r| or T, of which the offset consists.
double error_of_matrix(double point, double offset) {
  double squares = 0, worst = 0;
  for (int k = 0; k < 3; ++k) {
    baseline::FloatJointSet<Budget, 1> joint;
    for (auto& row : joint.row) {
      row = rounded_input<4>(1);
      row[3] = Budget(offset, u * offset, 0);
    }
    Vec<Budget, 3> p = of_length<0, 3>(tiny);
    p[k] = Budget(point, 0, 0);
    const double error = whole(joint.skin(p, [](int) { return Budget(0); })).in_u();
    squares += error * error, worst = std::max(worst, error);
  }
  // The point itself is rounded.
  return point > tiny ? std::sqrt(squares) + 1 : worst;
}

Checked check_float_skin() {
  DerivedBudgets budgets;
  const auto add = [&](int n, double per_length, double per_image) {
    const std::string joints = std::to_string(n) + (n == 1 ? " joint" : " joints");
    budgets.add(joints + ", per X", per_length, float_slack_per_length(n) * float_slack_and_more);
    budgets.add(joints + ", per T", per_image, float_slack_per_image(n) * float_slack_and_more);
  };
  add(1, std::max(error_of_matrix(1, tiny), error_of_matrix(tiny, 1)), error_of_matrix(tiny, 1));
  add(2, error_of_float_skin<2>(1, tiny), error_of_float_skin<2>(tiny, 1));
  add(3, error_of_float_skin<3>(1, tiny), error_of_float_skin<3>(tiny, 1));
  add(4, error_of_float_skin<4>(1, tiny), error_of_float_skin<4>(tiny, 1));
  return budgets.checked();
}

}  // namespace

PROPTEST(float_budgets) {
  const Options options{.number_type = "bounds of float"};
  t.example("boxes around control points allow for what float may lose of them", options, check_boxes);
  t.example("the filter of triangles allows for what double may lose", {.number_type = "bounds of double"}, [] {
    using S = oracle::PolynomialBudget<53>;
    return check_filter<53>(ExactVertices<S>{});
  });
  t.example("the filter of triangles whose vertices are off allows for what float may lose of determinants", options, [] {
    using S = oracle::PolynomialBudget<24>;
    return check_filter<24>(NearVertices<S>{S::twice_slack()});
  });
  t.example("and for vertices that are off by the slack in each coordinate, by extents", options,
            check_orders<NearVertices<oracle::PolynomialBudget<24>>, 1>);
  t.example("the filter by slopes allows for what float may lose of determinants", options, [] {
    using S = oracle::PolynomialBudget<24>;
    return check_filter<24>(NearVerticesBySlopes<S>{{S::twice_slack()}});
  });
  t.example("the filter by slopes allows for what float may lose of slopes", options, check_slopes);
  t.example("and for two or three coordinates that are off by the slack", options,
            check_orders<NearVerticesBySlopes<oracle::PolynomialBudget<24>>, 2>);
  t.example("the slack of skinning in float allows for what float may lose", options, check_float_skin);
}

}  // namespace proptests::suite_float_budgets
