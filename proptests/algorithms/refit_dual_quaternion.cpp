// SPDX-License-Identifier: GPL-3.0-or-later
// Tests refitting for dual quaternion skinning: the control balls hold every vertex, exactly in rationals where no root is
// needed, and by intervals on the fallback.
#include <optional>

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/oracles/nearest_point.hpp"
#include "proptests/refits/control_balls.hpp"

// all_of_space throws this, because there is no rational for it.
struct Unbounded {};
namespace refitlab {
template <>
Ball3<Rational> all_of_space(const Vec<Rational, 3>&) {
  throw Unbounded{};
}
}  // namespace refitlab

namespace proptests::suite_refit_dual_quaternion {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RationalVec;
using gen::RefitCase;

using oracle::DualQuaternionHull;
using oracle::random_case;

template <class S>
std::vector<Ball3<S>> balls_of(const RefitCase& c) {
  return oracle::balls_of<DualQuaternionHull, S>(c);
}
template <class S>
void assert_holds(const RefitCase& c, const std::vector<Ball3<S>>& balls, Verdict at_least) {
  oracle::assert_holds<DualQuaternionHull, S>(c, balls, at_least);
}

// Says whether a joint-set's weight vertices blend to 0 somewhere, by a slow search; nothing if it has too many for it.
std::optional<bool> may_vanish(const gen::SetCase& set) {
  std::vector<gen::RationalQuaternion> weight_vertices;
  for (const auto& w : set.weights.vertices) weight_vertices.push_back(blend_quaternion<Rational>(set.palette, w));
  if (weight_vertices.size() > 8) return std::nullopt;
  return squared_norm(combine<Rational, 4>(nearest_point_coefficients<4>(weight_vertices), weight_vertices)) == 0;
}

void check_hull() {
  const RefitCase c = random_case(gen::Turns::any);
  try {
    oracle::check_hull<DualQuaternionHull>(c);
  } catch (const Unbounded&) {
    RC_TAG("unbounded");
    bool some_vanishes = false;
    for (const auto& set : c.sets) some_vanishes = some_vanishes || may_vanish(set).value_or(true);
    RC_ASSERT(some_vanishes);
  }
}

// Returns dual quaternions as weight vertices, of any length and not of unit norm, which a node's weight vertices never are all
// at once.
DualQuaternionBlend<Rational> any_weight_vertices() {
  const auto blend = (*gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), 4)).blend;
  DualQuaternionBlend<Rational> out{blend.rotations, {}, blend.x};
  for (std::size_t k = 0; k < out.rotations.size(); ++k) out.duals.push_back(*gen::rational_vector<4>());
  return out;
}

// Makes a joint-set by hand, with all of its weights, and a vertex with a ball of radius 1/2.
RefitCase by_hand(const std::vector<gen::RationalTransform>& joints) {
  gen::SetCase set;
  set.palette.transforms = joints;
  place_rotation_center<Rational>(set.palette, RationalVec<3>(0, 0, 0));
  place_duals(set.palette);
  const std::size_t n = joints.size();
  set.weights.vertices.assign(n, std::vector<Rational>(n, Rational(0)));
  for (std::size_t i = 0; i < n; ++i) set.weights.vertices[i][i] = 1;
  return {{RationalVec<3>(1, 2, 3), Rational(1, 2)}, {set}};
}

bool is_all_of_space(const RefitCase& c) {
  const auto balls = balls_of<double>(c);
  ControlLists<double> lists;
  const gen::NodeOf<double> node(c);
  const auto ball = refit_dual_quaternion<NearSmallestBalls>(node.node(), lists);
  return balls.size() == 1 && std::isinf(balls[0].radius) && balls[0].center == lift<double>(c.reference.center) &&
         ball.center == balls[0].center && std::isinf(ball.radius);
}

void control_balls_and_what_they_need(Suite& t) {
  t.holds("the hull of the control balls holds every vertex of S with admissible weights, most of them exactly",
          oracle::options_of_hull("dual quaternion blending"), check_hull);
  t.refuted("it does without the terms T_kl", {.number_type = "rational"}, [] {
    const RefitCase c = *gen::refit_case(gen::Turns::moderate);
    RefitCase still = c;
    for (auto& set : still.sets)
      for (auto& dual : set.palette.duals) dual.setZero();
    assert_holds(c, balls_of<Rational>(still), Verdict::holds);
  });
  t.refuted("it holds every vertex of spherical skinning", {.number_type = "rational"}, [] {
    const RefitCase c = *gen::refit_case(gen::Turns::moderate);
    const auto balls = balls_of<Rational>(c);
    const auto rounded = balls_of<double>(c);
    for (const auto& sample : gen::samples(c, Blending::spherical, rounded[0].center)) {
      const auto v = gen::skinned(c, sample, Blending::spherical);
      const Point3 away = oracle::direction_away(rounded, lift<double>(*v));
      RC_ASSERT(oracle::reaches<Rational>(balls, *v, convert<Rational>(away)) == Verdict::holds);
    }
  });
  t.holds("up to a right angle between joints no root is taken and nothing is halved",
          {.form = "dual quaternion blending",
           .number_type = "rational",
           .cases = 150,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5},
          oracle::check_moderate_turns<DualQuaternionHull>);
  t.holds("halving ends: at most 16 m (m + 1) / 2 balls for m weight vertices, all of them finite, or one ball of all of space",
          {.number_type = "double", .cases = 1500, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5},
          [] { oracle::check_halving_ends<DualQuaternionHull>(true); });
  t.holds("a ball of each piece's own serves its vertices as S serves all", {.number_type = "rational", .cases = 200},
          oracle::check_own_balls<DualQuaternionHull>);
}

void weight_vertices_by_hand(Suite& t) {
  const RationalVec<3> none(0, 0, 0), aside(1, 0, 0);
  const gen::RationalQuaternion one(1, 0, 0, 0), i(0, 1, 0, 0);
  t.example("opposite quaternions: no ball holds the vertices near a blend of 0", {}, [=] {
    return is_all_of_space(by_hand({{one, none}, {-one, aside}})) && is_all_of_space(by_hand({{one, none}, {-one, none}}));
  });
  t.example("a weight vertex that is 0 beside another: no ball either; by itself it is no rotation", {}, [=] {
    RefitCase c = by_hand({{one, none}, {-one, aside}});
    c.sets[0].weights.vertices = {{1, 0}, {Rational(1, 2), Rational(1, 2)}};
    const bool beside = is_all_of_space(c);
    c.sets[0].weights.vertices = {{Rational(1, 2), Rational(1, 2)}};
    return beside && is_all_of_space(c);
  });
  t.example("a piece without a bound takes the other pieces with it", {}, [=] {
    RefitCase c = by_hand({{one, aside}});
    c.sets.push_back(by_hand({{one, none}, {-one, aside}}).sets[0]);
    c.sets.push_back(c.sets[0]);
    return is_all_of_space(c);
  });
  t.example("two half-turns are bounded, and equal weight vertices add nothing new", {.number_type = "rational"}, [=] {
    RefitCase c = by_hand({{one, none}, {i, aside}});
    const auto balls = balls_of<Rational>(c);
    c.sets[0].weights.vertices = {{1, 0}, {1, 0}, {0, 1}};
    bool known = true;
    for (const auto& b : balls_of<Rational>(c)) {
      bool found = false;
      for (const auto& a : balls) found = found || (a.center == b.center && a.radius == b.radius);
      known = known && found;
    }
    return balls.size() == 12 && known;
  });
  t.example("two joints are halved from a right angle on, and once is enough", {.number_type = "rational"}, [=] {
    const gen::RationalQuaternion turned_87(Rational(21, 29), Rational(20, 29), 0, 0);
    const gen::RationalQuaternion turned_92(Rational(20, 29), Rational(21, 29), 0, 0);
    return balls_of<Rational>(by_hand({{one, none}, {turned_87, aside}})).size() == 3 &&
           balls_of<Rational>(by_hand({{one, none}, {turned_92, aside}})).size() == 6;
  });
  t.example("a node moved by one joint has the moved reference ball", {.number_type = "rational"}, [=] {
    const auto balls = balls_of<Rational>(by_hand({{i, aside}}));
    return balls.size() == 1 && balls[0].center == RationalVec<3>(2, -2, -3) && balls[0].radius == Rational(1, 2);
  });
}

}  // namespace

PROPTEST(refit_dual_quaternion) {
  control_balls_and_what_they_need(t);
  t.holds("without any halving the fallback holds every vertex, or says that there is no bound",
          {.number_type = "multiprecision interval", .cases = 300}, [] {
            using S = MultiprecisionInterval;
            const auto blend = any_weight_vertices();
            const std::size_t m = blend.weight_vertex_count();
            ControlLists<S> lists;
            for (std::size_t k = 0; k < m; ++k)
              lists.dual_weight_vertices.push_back({lift<S>(blend.rotations[k]), lift<S>(blend.duals[k])});
            DualQuaternionPiece<S> piece(lift<S>(blend.point), S(0));
            ControlHull(piece, lists.dual_weight_vertices, lists).cover(m, 0);
            RC_ASSERT(lists.dual_weight_vertices.empty() && piece.is_bounded() == !lists.cap.balls.empty());
            RC_CLASSIFY(!piece.is_bounded(), "no bound");
            RC_CLASSIFY(piece.is_bounded() && lists.cap.balls.size() == 1 && m > 1, "fallback");
            if (!piece.is_bounded()) {
              const auto u = nearest_point_coefficients<4>(blend.rotations);
              const auto nearest = combine<Rational, 4>(u, blend.rotations);
              // Otherwise there was a bound to be found.
              RC_ASSERT(squared_norm(nearest) < Rational(1, 10));
              return;
            }
            const auto rounded = oracle::middles(lists.cap.balls);
            for (int i = 0; i < 4; ++i) {
              const auto at = blend.at(*gen::convex_weights(static_cast<int>(m)));
              RC_ASSERT(at.denominator > 0);
              const RationalVec<3> v = at.numerator / at.denominator;
              const auto d = convert<Rational>(oracle::direction_away(rounded, lift<double>(v)));
              RC_ASSERT(oracle::reaches<S>(lists.cap.balls, lift<S>(v), lift<S>(d)) != Verdict::fails);
            }
          });
  oracle::balls_in_double<DualQuaternionHull>(t);
  t.example("the fallback finds an axis where the weight vertices' mean is behind one, and its ball has all of r", {}, [] {
    const Quaternion<double> ahead(1, 0, 0, 0), behind(-1, 0.5, 0, 0), still(0, 0, 0, 0);
    const auto ball = [&](double radius) {
      ControlLists<double> lists;
      lists.dual_weight_vertices = {{ahead, still}, {ahead, still}, {behind, still}};
      DualQuaternionPiece<double> piece(Point3(0, 1, 0), radius);
      ControlHull(piece, lists.dual_weight_vertices, lists).cover(3, 0);
      return piece.is_bounded() && lists.cap.balls.size() == 1 ? lists.cap.balls[0].radius : -1;
    };
    return ball(0) > 0 && std::abs(ball(5) - ball(0) - 5) < 1e-12;
  });

  weight_vertices_by_hand(t);
  t.example("without a radius and up to 120 degrees apart, the control balls are nearly as small as the truth",
            {.number_type = "double"}, [] { return oracle::measure_tightness<DualQuaternionHull>(2007); });
}

}  // namespace proptests::suite_refit_dual_quaternion
