// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the control balls hold every vertex: exactly, in rationals, where no root is needed, and by intervals on the
// fallback.
#include "algorithms/runtime/refit/control_hull.hpp"

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/refits/control_balls.hpp"

namespace proptests::suite_control_hull {
namespace {

using namespace refitlab;
using gen::RationalVec;
using gen::RefitCase;
using oracle::direction_away;
using oracle::random_case;
using oracle::reaches;
using oracle::SphericalHull;

template <class S>
std::vector<Ball3<S>> balls_of(const RefitCase& c) {
  return oracle::balls_of<SphericalHull, S>(c);
}
template <class S>
void assert_holds(const RefitCase& c, const std::vector<Ball3<S>>& balls, Verdict at_least) {
  oracle::assert_holds<SphericalHull, S>(c, balls, at_least);
}

// Makes a joint-set by hand: rotations about the origin without translation, and weight vertices.
RefitCase by_hand(const std::vector<gen::RationalQuaternion>& rotations,
                  const std::vector<std::vector<Rational>>& weight_vertices) {
  gen::SetCase set;
  for (const auto& q : rotations) set.palette.transforms.push_back({q, RationalVec<3>::Zero()});
  place_rotation_center<Rational>(set.palette, RationalVec<3>(0, 0, 0));
  set.weights.vertices = weight_vertices;
  return {{RationalVec<3>(1, 2, 3), Rational(1, 2)}, {set}};
}

std::vector<std::vector<Rational>> whole_simplex(std::size_t n) {
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n, Rational(0)));
  for (std::size_t i = 0; i < n; ++i) rows[i][i] = 1;
  return rows;
}

// Says whether the balls hold every vertex that moves by blends of the weight vertices at multiples of 1/8, in double.
bool holds_on_a_grid(const RefitCase& c) {
  const auto balls = balls_of<double>(c);
  for (const auto& b : balls)
    if (!b.center.allFinite() || !(b.radius >= 0)) return false;
  const gen::NodeOf<double> storage(c);
  const auto node = storage.node();
  const auto& set = node.pieces[0];
  bool all = true;
  for_each_index(set.weight_vertex_count, 8, [&](const std::vector<std::size_t>& index) {
    std::vector<double> w(node.palette[0].transforms.size(), 0.0);
    for (const auto k : index)
      for (std::size_t i = 0; i < w.size(); ++i) w[i] += node.weight_vertex(set, static_cast<int>(k))[i] / 8;
    if (blend_quaternion<double>(node.palette[0], w).norm() < 1e-9) return;
    const Point3 v = blend_spherical<double>(node.palette[0], w, node.reference.center);
    const Point3 d = direction_away(balls, v);
    double reach = -1e300;
    for (const auto& b : balls) reach = std::max(reach, (b.center - v).dot(d) + b.radius * d.norm());
    all = all && reach >= node.reference.radius * d.norm() - 1e-9;  // All of the reference ball must be inside.
  });
  return all;
}

void the_fallback_alone(Suite& t) {
  t.holds("without any halving the fallback holds every vertex",
          {.number_type = "multiprecision interval", .cases = 300, .degenerate_at_least = 0.2}, [] {
            using S = MultiprecisionInterval;
            const auto c = *gen::blend_case(gen::Spread::any, 4);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            ControlLists<S> lists;
            for (std::size_t k = 0; k < c.blend.weight_vertex_count(); ++k)
              lists.weight_vertices.push_back({lift<S>(c.blend.rotations[k]), lift<S>(c.blend.center_images[k])});
            SphericalPiece<S> piece(lift<S>(c.blend.x), S(0));
            ControlHull(piece, lists.weight_vertices, lists).cover(c.blend.weight_vertex_count(), 0);
            RC_ASSERT(lists.weight_vertices.empty() && !lists.cap.balls.empty());
            const auto rounded = oracle::middles(lists.cap.balls);
            for (const auto& u : {c.weights, *gen::convex_weights(static_cast<int>(c.weights.size()))}) {
              const auto at = c.blend.at(u);
              if (at.denominator == 0) continue;
              const RationalVec<3> v = at.numerator / at.denominator;
              const RationalVec<3> d = convert<Rational>(direction_away(rounded, lift<double>(v)));
              RC_ASSERT(reaches<S>(lists.cap.balls, lift<S>(v), lift<S>(d)) != Verdict::fails);
            }
          });
  t.holds("the fallback depends on the rotations' directions, and not on their lengths",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.2}, [] {
            const auto c = *gen::blend_case(gen::Spread::any, 4);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const SphericalPiece<double> piece(lift<double>(c.blend.x), 0.5);
            std::vector<BlendedJoints<double>> whole, shorter;
            for (std::size_t k = 0; k < c.blend.weight_vertex_count(); ++k) {
              whole.push_back({lift<double>(c.blend.rotations[k]), lift<double>(c.blend.center_images[k])});
              shorter.push_back({whole[k].rotation * std::ldexp(1.0, -*rc::gen::inRange(0, 20)), whole[k].center_image});
            }
            ControlLists<double> of_whole, of_shorter;
            piece.fall_back(whole, of_whole);
            piece.fall_back(shorter, of_shorter);
            const auto &a = of_whole.cap.balls, &b = of_shorter.cap.balls;
            RC_ASSERT(a.size() == whole.size() && b.size() == a.size());
            // Powers of 2 are not rounded.
            for (std::size_t k = 0; k < a.size(); ++k) RC_ASSERT(a[k].center == b[k].center && a[k].radius == b[k].radius);
          });
}

void weight_vertices_that_vanish_or_turn_far(Suite& t) {
  t.example("a weight vertex that is 0 beside two near ones: all rotations are allowed for it", {}, [] {
    const RefitCase c =
        by_hand({{1, 0, 0, 0}, {-1, 0, 0, 0}}, {{1, 0}, {Rational(3, 4), Rational(1, 4)}, {Rational(1, 2), Rational(1, 2)}});
    bool all_of_them = false;
    for (const auto& b : balls_of<double>(c)) all_of_them = all_of_them || b.radius >= 0.5 + std::sqrt(14.0) - 1e-9;
    return all_of_them && holds_on_a_grid(c);
  });
  t.example("antipodal quaternions: all rotations, whose ball is about the rotation center", {}, [] {
    const RefitCase c = by_hand({{1, 0, 0, 0}, {-1, 0, 0, 0}}, whole_simplex(2));
    return holds_on_a_grid(c);
  });
  t.example("one, two and three half-turns about perpendicular axes, and equal weight vertices", {}, [] {
    const gen::RationalQuaternion one(1, 0, 0, 0), i(0, 1, 0, 0), j(0, 0, 1, 0), k(0, 0, 0, 1);
    return holds_on_a_grid(by_hand({one, i}, whole_simplex(2))) && holds_on_a_grid(by_hand({one, i, j}, whole_simplex(3))) &&
           holds_on_a_grid(by_hand({one, i, j, k}, whole_simplex(4))) &&
           holds_on_a_grid(by_hand({one, i}, {{1, 0}, {1, 0}, {0, 1}, {0, 1}}));
  });
  t.example("two joints are halved from 120 degrees on, and once is enough", {.number_type = "rational"}, [] {
    const gen::RationalQuaternion one(1, 0, 0, 0);
    const gen::RationalQuaternion turned_106(Rational(3, 5), Rational(4, 5), 0, 0);
    const gen::RationalQuaternion turned_135(Rational(5, 13), Rational(12, 13), 0, 0);
    return balls_of<Rational>(by_hand({one, turned_106}, whole_simplex(2))).size() == 4 &&
           balls_of<Rational>(by_hand({one, turned_135}, whole_simplex(2))).size() == 8;
  });
  t.example("a vertex at the rotation center moves as its linear part alone", {.number_type = "rational"}, [] {
    RefitCase c = by_hand({{1, 0, 0, 0}, {Rational(3, 5), Rational(4, 5), 0, 0}}, whole_simplex(2));
    c.reference = {RationalVec<3>(0, 0, 0), 0};
    c.sets[0].palette.transforms[1].translation = RationalVec<3>(1, 0, 0);
    place_rotation_center<Rational>(c.sets[0].palette, RationalVec<3>(0, 0, 0));
    bool on_the_way = true;
    for (const auto& b : balls_of<Rational>(c))
      on_the_way = on_the_way && b.radius == 0 && b.center[0] >= 0 && b.center[0] <= 1 && b.center[1] == 0 && b.center[2] == 0;
    return on_the_way;
  });
}

}  // namespace

PROPTEST(control_hull) {
  t.holds("the hull of the control balls holds every vertex of S with admissible weights, most of them exactly",
          oracle::options_of_hull("beyond"), [] { oracle::check_hull<SphericalHull>(random_case(gen::Turns::any)); });
  t.holds("up to a right angle between joints no root is taken and nothing is halved",
          {.form = "beyond", .number_type = "rational", .cases = 150, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5},
          oracle::check_moderate_turns<SphericalHull>);
  t.holds("halving ends: at most 16 m (m + 1) (m + 2) / 6 balls for m weight vertices, all of them finite",
          {.number_type = "double", .cases = 1500, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5},
          [] { oracle::check_halving_ends<SphericalHull>(false); });
  t.holds("a ball of each piece's own serves its vertices as S serves all", {.number_type = "rational", .cases = 200},
          oracle::check_own_balls<SphericalHull>);
  the_fallback_alone(t);
  oracle::balls_in_double<SphericalHull>(t);
  weight_vertices_that_vanish_or_turn_far(t);
  t.example("without a radius and up to 120 degrees apart, the control balls are nearly as small as the truth",
            {.number_type = "double"}, [] { return oracle::measure_tightness<SphericalHull>(2006); });
}

}  // namespace proptests::suite_control_hull
