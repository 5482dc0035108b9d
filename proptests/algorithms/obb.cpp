// SPDX-License-Identifier: GPL-3.0-or-later
// Tests oriented boxes, in exact arithmetic wherever an orientation is given: rotations of rational quaternions are rational.
#include "algorithms/methods/volumes/obb.hpp"

#include <algorithm>
#include <random>

#include "algorithms/methods/volumes/aabb.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/ball_lists.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/polytope.hpp"

namespace proptests::suite_obb {
namespace {

using namespace refitlab;
using gen::RationalBalls;
using gen::RationalQuaternion;
using gen::RationalVec;

// Holds what a box is put around, and how it is turned.
struct Content {
  RationalBalls balls;
  RationalQuaternion orientation;
  Obb<Rational> box() const { return Obb<Rational>::around(balls, orientation); }
};

Content draw() {
  const auto list = *gen::ball_list(6);
  RC_CLASSIFY(list.is_degenerate, "degenerate");
  return {list.balls, *gen::nonzero_quaternion()};
}

// Draws a second box, which is often parallel to the first, or turned about one of its edges, so that products of edges vanish.
Content draw_beside(const Content& a) {
  Content b = draw();
  const int kind = *gen::between(0, 4);
  if (kind == 0) b.orientation = a.orientation;
  if (kind == 1) b.orientation = multiply(a.orientation, RationalQuaternion(2, 0, 1, 0));
  RC_CLASSIFY(kind <= 1, "parallel edges");
  return b;
}

Content moved(Content c, const RationalVec<3>& by) {
  for (auto& b : c.balls) b.center += by;
  return c;
}

oracle::HalfSpaces half_spaces(const Obb<Rational>& box) {
  oracle::HalfSpaces out;
  for (int i = 0; i < 3; ++i) {
    out.push_back({box.axes[i], box.low[i]});
    out.push_back({-box.axes[i], -box.high[i]});
  }
  return out;
}

Verdict overlap_by_all(const Content& a, const Content& b) {
  const auto statement = [](const auto& x, const auto& p, const auto& y, const auto& q) {
    using S = std::decay_t<decltype(x[0].radius)>;
    return Obb<S>::around(x, p).overlaps(Obb<S>::around(y, q));
  };
  const Verdict verdict = decide_by_all(statement, a.balls, a.orientation, b.balls, b.orientation);
  RC_ASSERT(statement(b.balls, b.orientation, a.balls, a.orientation) == verdict);
  return verdict;
}

// Returns the least and the greatest product of d with the corners.
std::pair<Rational, Rational> extent(const Obb<Rational>& box, const RationalVec<3>& d) {
  const auto corners = oracle::vertices(half_spaces(box));
  std::pair<Rational, Rational> out{dot(corners[0], d), dot(corners[0], d)};
  for (const auto& c : corners) {
    out.first = min_of(out.first, dot(c, d));
    out.second = max_of(out.second, dot(c, d));
  }
  return out;
}

// Draws one of the 15 axes of the separating axis theorem that is not 0.
RationalVec<3> draw_axis(const Obb<Rational>& a, const Obb<Rational>& b) {
  std::vector<RationalVec<3>> axes;
  for (const auto& x : a.axes) axes.push_back(x);
  for (const auto& x : b.axes) axes.push_back(x);
  for (const auto& x : a.axes)
    for (const auto& y : b.axes)
      if (const RationalVec<3> d = cross(x, y); squared_norm(d) != 0) axes.push_back(d), axes.push_back(d);
  return axes[*rc::gen::inRange<std::size_t>(0, axes.size())];
}

void check_common_point() {
  const Content a = draw(), b = draw_beside(a);
  const int kind = *gen::between(0, 5);
  RationalVec<3> by = gen::hull_point(a.balls) - gen::hull_point(b.balls);
  // They touch: one box's corner is at the other's.
  if (kind <= 1) {
    const auto of_a = oracle::vertices(half_spaces(a.box())), of_b = oracle::vertices(half_spaces(b.box()));
    by = of_a[*rc::gen::inRange<std::size_t>(0, of_a.size())] - of_b[*rc::gen::inRange<std::size_t>(0, of_b.size())];
    RC_TAG("at a corner");
  }
  if (kind == 2) RC_TAG("equal");
  RC_ASSERT(overlap_by_all(a, kind == 2 ? a : moved(b, by)) == Verdict::holds);
}

// Moves a box along an axis until there is a gap as seen along it, which may be a negative one, and checks the result against the
// oracle.
void check_against_oracle() {
  const Content a = draw(), b = draw_beside(a);
  const auto box_a = a.box(), box_b = b.box();
  const RationalVec<3> axis = draw_axis(box_a, box_b);
  const Rational gap = *gen::rational() * *rc::gen::element(Rational(1, 8), Rational(0x1p-30));
  const Rational step = extent(box_a, axis).second - extent(box_b, axis).first + gap;
  const Content beyond = moved(b, axis * Rational(step / squared_norm(axis)));
  auto both = half_spaces(box_a);
  for (const auto& h : half_spaces(beyond.box())) both.push_back(h);
  const Verdict expected = verdict_of(!oracle::vertices(both).empty());
  if (gap > 0) RC_ASSERT(expected == Verdict::fails);
  RC_TAG(expected == Verdict::fails ? "apart" : gap == 0 ? "touch" : "meet");
  RC_ASSERT(overlap_by_all(a, beyond) == expected);
}

template <class S>
S worst_axis_error(const Obb<S>& box) {
  S worst(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const S error = dot(box.axes[i], box.axes[j]) - S(i == j);
      worst = max_of(worst, max_of(error, S(-error)));
    }
  const Vec<S, 3> third = cross(box.axes[0], box.axes[1]) - box.axes[2];
  for (int i = 0; i < 3; ++i) worst = max_of(worst, max_of(third[i], S(-third[i])));
  return worst;
}

// Says whether the corners of turned boxes give boxes of the same volumes.
bool finds_a_turned_box() {
  std::mt19937_64 random(2006);
  std::uniform_real_distribution<double> uniform(-1, 1);
  bool good = true;
  for (int round = 0; round < 200; ++round) {
    Quaternion<double> q{uniform(random), uniform(random), uniform(random), uniform(random)};
    q.normalize();
    const Vec<double, 3> edges(3, 1.5 + 0.5 * uniform(random), 0.5), place(uniform(random), 2, 3);
    std::vector<Ball3<double>> balls;
    for (int corner = 0; corner < 8; ++corner) {
      Vec<double, 3> p;
      for (int i = 0; i < 3; ++i) p[i] = edges[i] * ((corner >> i & 1) - 0.5);
      balls.push_back({place + rotate(q, p), 0.0});
    }
    good = good && std::abs(Obb<double>::around(balls).volume() / edges.prod() - 1) < 1e-6;
  }
  return good;
}

}  // namespace

PROPTEST(obb) {
  const auto options = [](int cases) { return Options{.number_type = "rational", .cases = cases, .degenerate_at_least = 0.4}; };
  t.holds("the axes are exactly orthonormal and right-handed", options(200),
          [] { RC_ASSERT(worst_axis_error(draw().box()) == 0); });
  t.holds("the box holds every point of the balls' hull", options(400), [] {
    const Content c = draw();
    const auto statement = [](const auto& balls, const auto& orientation, const auto& x) {
      using S = std::decay_t<decltype(balls[0].radius)>;
      return Obb<S>::around(balls, orientation).contains(x);
    };
    RC_ASSERT(decide_by_all(statement, c.balls, c.orientation, gen::hull_point(c.balls)) == Verdict::holds);
  });
  t.holds("each face touches a ball", options(300), [] {
    const Content c = draw();
    const auto box = c.box();
    for (int i = 0; i < 3; ++i) {
      bool low = false, high = false;
      for (const auto& b : c.balls) {
        const RationalVec<3> down = b.center - box.axes[i] * b.radius, up = b.center + box.axes[i] * b.radius;
        low = low || dot(down, box.axes[i]) == box.low[i];
        high = high || dot(up, box.axes[i]) == box.high[i];
      }
      RC_ASSERT(low);
      RC_ASSERT(high);
    }
  });
  t.holds("a point beyond a face is not in the box", options(300), [] {
    const Content c = draw();
    const auto box = c.box();
    const RationalVec<3> inside = gen::hull_point(c.balls);
    const int i = *rc::gen::inRange(0, 3);
    const Rational beyond = *gen::positive_rational() * Rational(0x1p-60), at = dot(inside, box.axes[i]);
    const Rational to = *rc::gen::arbitrary<bool>() ? box.high[i] + beyond : box.low[i] - beyond;
    RC_ASSERT(box.contains(inside + box.axes[i] * Rational(to - at)) == Verdict::fails);
  });
  t.holds("the volume and the surface area are those of the corners", options(100), [] {
    const Content c = draw();
    const auto box = c.box();
    Rational edges[3];
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = extent(box, box.axes[i]);
      edges[i] = high - low;
    }
    RC_ASSERT(box.volume() == edges[0] * edges[1] * edges[2]);
    RC_ASSERT(box.surface_area() == Rational(2) * (edges[0] * edges[1] + edges[0] * edges[2] + edges[1] * edges[2]));
  });
  t.holds("two boxes that share a point overlap", options(400), check_common_point);
  Options of_two = options(600);
  of_two.tags_at_least = {{"meet", 0.1}, {"touch", 0.02}, {"apart", 0.2}};
  t.holds("two boxes overlap exactly if the half-spaces of both have a point in common", of_two, check_against_oracle);
  t.holds("in double, the box found holds all balls up to 1e-14 of the coordinates and is no larger than the Aabb",
          {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.4}, [] {
            const auto list = *gen::ball_list(12);
            RC_CLASSIFY(list.is_degenerate, "degenerate");
            const auto balls = lift<double>(list.balls);
            const auto box = Obb<double>::around(balls);
            RC_ASSERT(worst_axis_error(box) < 4e-15);
            RC_ASSERT(box.surface_area() <= Aabb<double>::around(balls).surface_area() * (1 + 1e-12));
            double size = 0;
            for (const auto& b : balls) size = std::max(size, b.center.norm() + b.radius);
            auto larger = box;
            for (int i = 0; i < 3; ++i) larger.low[i] -= 1e-14 * size, larger.high[i] += 1e-14 * size;
            for (int n = 0; n < 5; ++n) RC_ASSERT(larger.contains(lift<double>(gen::hull_point(list.balls))) == Verdict::holds);
          });
  t.example("all of space overlaps every box and itself, and has every point", {.number_type = "double"}, [] {
    const std::vector<Ball3<double>> everywhere = {{{1, 2, 3}, HUGE_VAL}}, unit = {{{0, 0, 0}, 1}};
    bool ok = true;
    for (const Quaternion<double>& turned :
         {Quaternion<double>(1, 0, 0, 0), Quaternion<double>(0.5, 0.5, 0.5, 0.5), Quaternion<double>(0.9, 0.1, -0.3, 0.2)}) {
      const auto all = Obb<double>::around(everywhere, turned), one = Obb<double>::around(unit, {1, 0, 0, 0});
      for (const auto& [a, b] : {std::pair(all, one), {one, all}, {all, all}}) ok = ok && a.overlaps(b) == Verdict::holds;
      ok = ok && all.contains({1e300, -1e300, 0}) == Verdict::holds;
    }
    return Checked(ok, 12);
  });
  t.example("a turned box comes back from its corners", {.number_type = "double"}, finds_a_turned_box);
}

}  // namespace proptests::suite_obb
