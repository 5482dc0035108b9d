// SPDX-License-Identifier: GPL-3.0-or-later
// Refitting for dual quaternion skinning: the control balls hold every vertex, exactly in rationals where no root is
// needed, and by intervals on the fallback.
#include <cstdio>
#include <optional>
#include <random>

#include "algorithms/runtime/refit/dual_quaternion.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/hull_of_balls.hpp"
#include "proptests/oracles/nearest_point.hpp"
#include "proptests/oracles/rational_root.hpp"  // the control points need no root, only the fallback does

// There is no rational for it.
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

template <class S>
std::vector<Ball3<S>> balls_of(const RefitCase& c) {
  const gen::NodeOf<S> node(c);
  ControlLists<S> lists;
  const auto balls = control_balls_dual_quaternion(node.node(), lists);
  return {balls.begin(), balls.end()};
}

template <class S>
void assert_holds(const RefitCase& c, const std::vector<Ball3<S>>& balls, Verdict at_least) {
  const auto rounded = balls_of<double>(c);
  for (const auto& sample : gen::samples(c, Blending::dual_quaternion, rounded[0].center)) {
    const auto v = gen::skinned(c, sample, Blending::dual_quaternion);
    if (!v) continue;
    const Point3 away = oracle::direction_away(rounded, lift<double>(*v));
    std::vector<RationalVec<3>> directions{*gen::nonzero_vector<3>()};
    if (away.allFinite()) directions.push_back(convert<Rational>(away));
    for (const auto& d : directions) RC_ASSERT(oracle::reaches<S>(balls, lift<S>(*v), lift<S>(d)) >= at_least);
  }
}

std::size_t control_point_count(std::size_t m) { return m * (m + 1) / 2; }

std::size_t without_halving(const RefitCase& c) {
  std::size_t sum = 0;
  for (const auto& set : c.sets) sum += set.weights.vertices.size() == 1 ? 1 : control_point_count(set.weights.vertices.size());
  return sum;
}

// A joint-set's weight vertices blend to 0 somewhere, by a slow search; nothing if it has too many for it.
std::optional<bool> may_vanish(const gen::SetCase& set) {
  std::vector<gen::RationalQuaternion> weight_vertices;
  for (const auto& w : set.weights.vertices) weight_vertices.push_back(blend_quaternion<Rational>(set.palette, w));
  if (weight_vertices.size() > 8) return std::nullopt;
  return squared_norm(combine<Rational, 4>(nearest_point_coefficients<4>(weight_vertices), weight_vertices)) == 0;
}

void check_hull() {
  const RefitCase c = *gen::refit_case(gen::Turns::any);
  for (const auto& kind : gen::degeneracies(c)) RC_TAG(kind);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  try {
    const auto balls = balls_of<Rational>(c);
    RC_TAG("exact");
    RC_CLASSIFY(balls.size() > without_halving(c), "halved");
    assert_holds(c, balls, Verdict::holds);
  } catch (const Unbounded&) {
    RC_TAG("unbounded");
    bool some_vanishes = false;
    for (const auto& set : c.sets) some_vanishes = some_vanishes || may_vanish(set).value_or(true);
    RC_ASSERT(some_vanishes);
  } catch (const NoRationalRoot&) {
    RC_TAG("fallback");
    assert_holds(c, balls_of<MultiprecisionInterval>(c), Verdict::undecided);  // on the boundary of a ball
  }
}

// How far the policy's ball of double misses the exactly skinned vertices of the same doubles: at most 1e-12 of the
// coordinates' size.
template <class Policy>
void check_double() {
  const RefitCase c = gen::rounded_to_double(*gen::refit_case(gen::Turns::any));
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  ControlLists<double> lists;
  const gen::NodeOf<double> node(c);
  const Ball3<double> ball = refit_dual_quaternion<Policy>(node.node(), lists);
  RC_ASSERT(ball.center.allFinite() && ball.radius >= 0);
  RC_CLASSIFY(std::isinf(ball.radius), "unbounded");
  if (std::isinf(ball.radius)) return;
  double size = ball.center.norm() + ball.radius + lift<double>(c.reference.center).norm();
  for (const auto& set : c.sets)
    for (const auto& joint : set.palette.transforms) size += lift<double>(joint.translation).norm();
  const Ball3<Rational> around{convert<Rational>(ball.center), Rational(ball.radius) + Rational(1e-12 * size)};
  for (const auto& sample : gen::samples(c, Blending::dual_quaternion, ball.center))
    if (const auto v = gen::skinned(c, sample, Blending::dual_quaternion)) RC_ASSERT(encloses(around, *v) == Verdict::holds);
}

// Dual quaternions as weight vertices, of any length and not of unit norm: what a node's weight vertices never are all
// at once.
DualQuaternionBlend<Rational> any_weight_vertices() {
  const auto blend = (*gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), 4)).blend;
  DualQuaternionBlend<Rational> out{blend.rotations, {}, blend.x};
  for (std::size_t k = 0; k < out.rotations.size(); ++k) out.duals.push_back(*gen::rational_vector<4>());
  return out;
}

// A joint-set by hand: all of its weights, and a vertex with a ball of radius 1/2.
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

// Random joint-sets of joints that turn about near points by at most 120 degrees against each other, r = 0: the
// smallest ball of the control points over the smallest ball of densely sampled true positions.
Checked measure_tightness() {
  std::mt19937_64 random(2007);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Point3(normal(random), normal(random), normal(random)); };
  double sum = 0, worst = 0;
  int count = 0;
  while (count < 300) {
    const int n = 2 + count % 3;
    OwnedPaletteEntry<double> palette;
    for (int i = 0; i < n; ++i) {
      Quaternion<double> q(normal(random), normal(random), normal(random), normal(random));
      q.normalize();
      const Point3 pivot = 0.3 * vector();
      palette.transforms.push_back({q, pivot - rotate(q, pivot)});
    }
    make_signs_consistent<double>(palette.transforms);
    place_duals(palette);
    place_rotation_center(palette, Point3(0, 0, 0));
    bool near = true;
    for (const auto& a : palette.transforms)
      for (const auto& b : palette.transforms) near = near && dot(a.rotation, b.rotation) >= 0.5;
    if (!near) continue;
    std::vector<double> weight_vertices;
    for (int k = 0; k < n; ++k)
      for (int i = 0; i < n; ++i) weight_vertices.push_back(i == k);
    SkinningPalette<double> frame;
    frame.push_back(palette);
    const NodePiece set{0, 0, n};
    const Ball3<double> reference{2 * vector(), 0};
    const RefitNode<double> node{reference, {&set, 1}, weight_vertices.data(), frame};
    ControlLists<double> lists;
    const double bound = refit_dual_quaternion<SmallestBalls>(node, lists).radius;
    std::vector<Point3> positions;
    const int steps[] = {400, 40, 20};
    for_each_index(n, steps[n - 2], [&](const std::vector<std::size_t>& index) {
      std::vector<double> w(n, 0.0);
      for (const auto k : index) w[k] += 1 / double(index.size());
      positions.push_back(blend_dual_quaternion<double>(palette, w, reference.center));
    });
    const double truth = as_ball(smallest_ball<double, 3>(positions)).radius;
    if (!(truth > 1e-6)) continue;
    sum += bound / truth;
    worst = std::max(worst, bound / truth);
    ++count;
  }
  char text[100];
  std::snprintf(text, sizeof text, "control balls over sampled positions: mean %.4f, worst %.4f", sum / count, worst);
  return Checked(sum / count <= 1.02, count, text);
}

}  // namespace

PROPTEST(refit_dual_quaternion) {
  t.holds("the hull of the control balls holds every vertex of S with admissible weights, most of them exactly",
          {.form = "dual quaternion blending",
           .number_type = "rational",
           .cases = 300,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"exact", 0.5}, {"halved", 0.05}, {"fallback", 0.02}}},
          check_hull);
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
          [] {
            const RefitCase c = *gen::refit_case(gen::Turns::moderate);
            RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
            const auto balls = balls_of<Rational>(c);
            RC_ASSERT(balls.size() == without_halving(c));
            for (const auto& b : balls) RC_ASSERT(b.radius == c.reference.radius);
            assert_holds(c, balls, Verdict::holds);
          });
  t.holds("halving ends: at most 16 m (m + 1) / 2 balls for m weight vertices, all of them finite, or one ball of all of space",
          {.number_type = "double", .cases = 1500, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5}, [] {
            const RefitCase c = *gen::refit_case(gen::Turns::any);
            RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
            const auto balls = balls_of<double>(c);
            std::size_t most = 0;
            for (const auto& set : c.sets) most += 16 * control_point_count(set.weights.vertices.size());
            for (const auto& b : balls) RC_ASSERT(b.center.allFinite() && b.radius >= 0);
            if (balls.size() == 1) return;
            RC_ASSERT(balls.size() <= most && balls.size() >= c.sets.size());
            for (const auto& b : balls) RC_ASSERT(std::isfinite(b.radius));
          });
  t.holds("a ball of each piece's own serves its vertices as S serves all", {.number_type = "rational", .cases = 200}, [] {
    const RefitCase c = *gen::refit_case(gen::Turns::moderate);
    const gen::NodeOf<Rational> storage(c);
    auto node = storage.node();
    std::vector<Ball3<Rational>> own;
    for (std::size_t i = 0; i < c.sets.size(); ++i) own.push_back({*gen::rational_vector<3>(), *gen::positive_rational()});
    node.piece_references = own;
    ControlLists<Rational> lists;
    const auto balls = control_balls_dual_quaternion(node, lists);
    std::size_t first = 0;
    for (std::size_t i = 0; i < c.sets.size(); ++i)
      for (const auto& b : balls_of<Rational>({own[i], {c.sets[i]}})) {
        RC_ASSERT(first < balls.size());
        RC_ASSERT(b.center == balls[first].center && b.radius == balls[first].radius);
        ++first;
      }
    RC_ASSERT(first == balls.size());
  });
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
              RC_ASSERT(squared_norm(nearest) < Rational(1, 10));  // or a bound was there to be found
              return;
            }
            std::vector<Ball3<double>> rounded;
            for (const auto& b : lists.cap.balls) {
              const auto middle = [](const S& x) { return static_cast<double>(median(x)); };
              rounded.push_back({{middle(b.center[0]), middle(b.center[1]), middle(b.center[2])}, middle(b.radius)});
            }
            for (int i = 0; i < 4; ++i) {
              const auto at = blend.at(*gen::convex_weights(static_cast<int>(m)));
              RC_ASSERT(at.denominator > 0);
              const RationalVec<3> v = at.numerator / at.denominator;
              const auto d = convert<Rational>(oracle::direction_away(rounded, lift<double>(v)));
              RC_ASSERT(oracle::reaches<S>(lists.cap.balls, lift<S>(v), lift<S>(d)) != Verdict::fails);
            }
          });
  const Options in_double{.number_type = "double", .cases = 700, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5};
  t.holds("the mean ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", in_double,
          [] { check_double<MeanBalls>(); });
  t.holds("the near-smallest ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", in_double,
          [] { check_double<NearSmallestBalls>(); });
  t.holds("the smallest ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", in_double,
          [] { check_double<SmallestBalls>(); });

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
  t.example("without a radius and up to 120 degrees apart, the control balls are nearly as small as the truth",
            {.number_type = "double"}, measure_tightness);
}

}  // namespace proptests::suite_refit_dual_quaternion
