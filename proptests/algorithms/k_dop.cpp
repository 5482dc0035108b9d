// SPDX-License-Identifier: GPL-3.0-or-later
// Tests k-DOPs of every k, in exact arithmetic. The axis-aligned box is the one of k = 6.
#include "algorithms/methods/volumes/k_dop.hpp"

#include <algorithm>

#include "lemmas/exact/lift.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/ball_lists.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_k_dop {
namespace {

using namespace refitlab;
using gen::RationalBalls;
using gen::RationalVec;

gen::BallList draw() {
  auto list = *gen::ball_list();
  RC_CLASSIFY(list.is_degenerate, "degenerate");
  return list;
}

RationalBalls moved(RationalBalls balls, const RationalVec<3>& by) {
  for (auto& b : balls) b.center += by;
  return balls;
}

// Returns (x, d), by multiplication.
Rational product(const SlabDirection& d, const RationalVec<3>& x) {
  return x[0] * Rational(d[0]) + x[1] * Rational(d[1]) + x[2] * Rational(d[2]);
}

RationalVec<3> as_vector(const SlabDirection& d) { return {d[0], d[1], d[2]}; }

template <int k>
void check_holds_hull() {
  const auto list = draw();
  const auto statement = [](const auto& balls, const auto& x) {
    using S = std::decay_t<decltype(balls[0].radius)>;
    return KDop<S, k>::around(balls).contains(x);
  };
  RC_ASSERT(decide_by_all(statement, list.balls, gen::hull_point(list.balls)) == Verdict::holds);
}

// Says whether reach is r ||d|| for a ball of radius r, or above it by 2^-50 of it: (reach / r)^2 is ||d||^2.
bool is_tight(const Rational& reach, const Rational& radius, int squared_length) {
  const Rational least = radius * radius * Rational(squared_length), square = reach * reach;
  return reach >= 0 && square >= least && square <= least * Rational(1 + 0x1p-50) && (squared_length > 1 || square == least);
}

template <int k>
void check_faces_touch() {
  const auto list = draw();
  const auto dop = KDop<Rational, k>::around(list.balls);
  for (std::size_t i = 0; i < dop.directions.size(); ++i) {
    const SlabDirection& d = dop.directions[i];
    bool low = false, high = false;
    for (const auto& b : list.balls) {
      const Rational at = product(d, b.center);
      low = low || is_tight(at - dop.low[i], b.radius, squared_length(d));
      high = high || is_tight(dop.high[i] - at, b.radius, squared_length(d));
    }
    RC_ASSERT(low);
    RC_ASSERT(high);
  }
}

template <int k>
void check_outside() {
  const auto list = draw();
  const auto dop = KDop<Rational, k>::around(list.balls);
  const RationalVec<3> inside = gen::hull_point(list.balls);
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, k / 2);
  const RationalVec<3> d = as_vector(dop.directions[i]);
  const Rational at = dot(inside, d), beyond = *gen::positive_rational() * Rational(0x1p-60);
  const Rational to = *rc::gen::arbitrary<bool>() ? dop.high[i] + beyond : dop.low[i] - beyond;
  const RationalVec<3> outside = inside + d * Rational((to - at) / squared_norm(d));
  RC_ASSERT(dop.contains(outside) == Verdict::fails);
}

template <int k>
Verdict overlap_by_all(const RationalBalls& a, const RationalBalls& b) {
  const auto statement = [](const auto& x, const auto& y) {
    using S = std::decay_t<decltype(x[0].radius)>;
    return KDop<S, k>::around(x).overlaps(KDop<S, k>::around(y));
  };
  const Verdict verdict = decide_by_all(statement, a, b);
  RC_ASSERT(statement(b, a) == verdict);
  return verdict;
}

// Moves b until a point of its hull is one of a's. In a quarter of the cases the two only touch there, and in another b is a.
template <int k>
void check_common_point() {
  const auto a = draw(), b = draw();
  const int kind = *gen::between(0, 4);
  if (kind == 0) {
    RC_TAG("equal");
    RC_ASSERT(overlap_by_all<k>(a.balls, a.balls) == Verdict::holds);
  } else if (kind == 1) {
    const auto d = as_vector(slab_directions<k>()[*rc::gen::inRange<std::size_t>(0, k / 2)]);
    const auto farther = [&](const auto& x, const auto& y) { return dot(x.center, d) < dot(y.center, d); };
    auto points_a = a.balls, points_b = b.balls;
    for (auto& x : points_a) x.radius = 0;
    for (auto& x : points_b) x.radius = 0;
    const auto top = std::max_element(points_a.begin(), points_a.end(), farther)->center;
    const auto bottom = std::min_element(points_b.begin(), points_b.end(), farther)->center;
    RC_TAG("touching");
    RC_ASSERT(overlap_by_all<k>(points_a, moved(points_b, top - bottom)) == Verdict::holds);
  } else {
    const RationalVec<3> by = gen::hull_point(a.balls) - gen::hull_point(b.balls);
    RC_ASSERT(overlap_by_all<k>(a.balls, moved(b.balls, by)) == Verdict::holds);
  }
}

template <int k>
void check_separated() {
  const auto a = draw(), b = draw();
  const auto around_a = KDop<Rational, k>::around(a.balls), around_b = KDop<Rational, k>::around(b.balls);
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, k / 2);
  const auto d = as_vector(around_a.directions[i]);
  const Rational gap = *gen::positive_rational() * Rational(0x1p-20);
  const bool above = *rc::gen::arbitrary<bool>();
  const Rational by = above ? around_a.high[i] + gap - around_b.low[i] : around_a.low[i] - gap - around_b.high[i];
  RC_ASSERT(overlap_by_all<k>(a.balls, moved(b.balls, d * Rational(by / squared_norm(d)))) == Verdict::fails);
}

template <int k>
void check_k(Suite& t) {
  const std::string dop = std::to_string(k) + "-DOP";
  const auto options = [](int cases) { return Options{.number_type = "rational", .cases = cases, .degenerate_at_least = 0.4}; };
  t.holds("the " + dop + " holds every point of the balls' hull", options(400), check_holds_hull<k>);
  t.holds("each face of the " + dop + " touches a ball", options(300), check_faces_touch<k>);
  t.holds("a point beyond a face is not in the " + dop, options(300), check_outside<k>);
  t.holds("two of " + dop + " that share a point overlap", options(400), check_common_point<k>);
  t.holds("two of " + dop + " that a slab separates do not overlap", options(300), check_separated<k>);
}

template <int inner, int outer>
void check_smaller() {
  const auto list = draw();
  const auto less = KDop<Rational, inner>::around(list.balls);
  const auto more = KDop<Rational, outer>::around(list.balls);
  RC_ASSERT(less.volume() <= more.volume());
}

}  // namespace

PROPTEST(k_dop) {
  t.example("the directions are different, none is another's opposite, and as many as k / 2", {}, [] {
    const auto all = slab_directions<26>();
    bool good = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const RationalVec<3> a = as_vector(all[i]);
      for (std::size_t j = 0; j < i; ++j) good = good && squared_norm<Rational, 3>(cross(a, as_vector(all[j]))) != 0;
    }
    const auto count = [](const auto& directions, int squared) {
      return std::count_if(directions.begin(), directions.end(),
                           [&](const SlabDirection& d) { return squared_length(d) == squared; });
    };
    return good && count(slab_directions<6>(), 1) == 3 && count(slab_directions<14>(), 1) == 3 &&
           count(slab_directions<14>(), 3) == 4 && count(slab_directions<18>(), 1) == 3 && count(slab_directions<18>(), 2) == 6 &&
           count(all, 1) == 3 && count(all, 2) == 6 && count(all, 3) == 4;
  });
  t.example("the lengths of the directions are bounded from above, by less than 2^-51 of them", {}, [] {
    bool good = true;
    for (const SlabDirection& d : slab_directions<26>()) {
      const Rational bound(length_bound(d)), square = bound * bound, exact(squared_length(d));
      good = good && square >= exact && square <= exact * Rational(1 + 0x1p-50);
    }
    return good;
  });
  check_k<6>(t);
  check_k<14>(t);
  check_k<18>(t);
  check_k<26>(t);
  const Options volumes{.number_type = "rational", .cases = 100, .degenerate_at_least = 0.4};
  t.holds("the 14-DOP is no larger than the 6-DOP", volumes, check_smaller<14, 6>);
  t.holds("the 18-DOP is no larger than the 6-DOP", volumes, check_smaller<18, 6>);
  t.holds("the 26-DOP is no larger than the 14-DOP", volumes, check_smaller<26, 14>);
  t.holds("the 26-DOP is no larger than the 18-DOP", volumes, check_smaller<26, 18>);
}

}  // namespace proptests::suite_k_dop
