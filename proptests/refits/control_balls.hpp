// SPDX-License-Identifier: GPL-3.0-or-later
// Tests control balls, those of spherical and those of dual quaternion skinning alike. Hull is one of the two kinds.
#pragma once

#include <cmath>
#include <cstdio>
#include <random>

#include "algorithms/runtime/refit/control_hull.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/hull_of_balls.hpp"
#include "proptests/oracles/rational_root.hpp"  // The control points need no root, only the fallback does.

namespace proptests::oracle {

struct SphericalHull {
  static constexpr gen::Blending blending = gen::Blending::spherical;
  static std::size_t control_point_count(std::size_t m) { return m * (m + 1) * (m + 2) / 6; }
  template <class S>
  static auto balls(const refitlab::RefitNode<S>& node, refitlab::ControlLists<S>& lists) {
    return control_balls(node, lists);
  }
  template <class Policy>
  static refitlab::Ball3<double> refit(const refitlab::RefitNode<double>& node, refitlab::ControlLists<double>& lists) {
    return refitlab::refit_control_hull<Policy>(node, lists);
  }
};

struct DualQuaternionHull {
  static constexpr gen::Blending blending = gen::Blending::dual_quaternion;
  static std::size_t control_point_count(std::size_t m) { return m * (m + 1) / 2; }
  template <class S>
  static auto balls(const refitlab::RefitNode<S>& node, refitlab::ControlLists<S>& lists) {
    return control_balls_dual_quaternion(node, lists);
  }
  template <class Policy>
  static refitlab::Ball3<double> refit(const refitlab::RefitNode<double>& node, refitlab::ControlLists<double>& lists) {
    return refitlab::refit_dual_quaternion<Policy>(node, lists);
  }
};

template <class Hull, class S>
std::vector<refitlab::Ball3<S>> balls_of(const gen::RefitCase& c) {
  const gen::NodeOf<S> node(c);
  refitlab::ControlLists<S> lists;
  const auto balls = Hull::template balls<S>(node.node(), lists);
  return {balls.begin(), balls.end()};
}

// Returns how many balls a case has if nothing is halved.
template <class Hull>
std::size_t count_without_halving(const gen::RefitCase& c) {
  std::size_t sum = 0;
  for (const auto& set : c.sets) {
    const std::size_t m = set.weights.vertices.size();
    sum += m == 1 ? 1 : Hull::control_point_count(m);
  }
  return sum;
}

// Asserts that the hull of the balls has every sample of the case, as far as a random direction and the best found one show.
template <class Hull, class S>
void assert_holds(const gen::RefitCase& c, const std::vector<refitlab::Ball3<S>>& balls, refitlab::Verdict at_least) {
  using namespace refitlab;
  const auto rounded = balls_of<Hull, double>(c);
  for (const auto& sample : gen::samples(c, Hull::blending, rounded[0].center)) {
    const auto v = gen::skinned(c, sample, Hull::blending);
    if (!v) continue;
    const Point3 away = direction_away(rounded, lift<double>(*v));
    std::vector<gen::RationalVec<3>> directions{*gen::nonzero_vector<3>()};
    // A ball that is all of space gives no such direction.
    if (away.allFinite()) directions.push_back(convert<Rational>(away));
    for (const auto& d : directions) RC_ASSERT(reaches<S>(balls, lift<S>(*v), lift<S>(d)) >= at_least);
  }
}

// Draws a case as random ones are made, and counts its degeneracies.
inline gen::RefitCase random_case(gen::Turns turns) {
  const gen::RefitCase c = *gen::refit_case(turns);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  return c;
}

// Says how often the balls of random cases should be exact, halved, or those of the fallback.
inline Options options_of_hull(const std::string& form) {
  return {.form = form,
          .number_type = "rational",
          .cases = 300,
          .degenerate_at_least = 0.2,
          .degenerate_at_most = 0.5,
          .tags_at_least = {{"exact", 0.5}, {"halved", 0.05}, {"fallback", 0.02}}};
}

// Checks that the hull holds the case's samples in rationals, or in intervals on the fallback. There is no rational for all of
// space: then this throws what all_of_space does.
template <class Hull>
void check_hull(const gen::RefitCase& c) {
  using namespace refitlab;
  for (const auto& kind : gen::degeneracies(c)) RC_TAG(kind);
  try {
    const auto balls = balls_of<Hull, Rational>(c);
    RC_TAG("exact");
    RC_CLASSIFY(balls.size() > count_without_halving<Hull>(c), "halved");
    assert_holds<Hull, Rational>(c, balls, Verdict::holds);
  } catch (const NoRationalRoot&) {
    RC_TAG("fallback");
    assert_holds<Hull, MultiprecisionInterval>(c, balls_of<Hull, MultiprecisionInterval>(c),
                                               // Such a sample is on the boundary of a cap's ball.
                                               Verdict::undecided);
  }
}

template <class Hull>
void check_moderate_turns() {
  using namespace refitlab;
  const gen::RefitCase c = random_case(gen::Turns::moderate);
  const auto balls = balls_of<Hull, Rational>(c);
  RC_ASSERT(balls.size() == count_without_halving<Hull>(c));
  for (const auto& b : balls) RC_ASSERT(b.radius == c.reference.radius);
  assert_holds<Hull, Rational>(c, balls, Verdict::holds);
}

// Checks that there are at most 16 times the control points of each piece, all of them finite, or one ball of all of space.
template <class Hull>
void check_halving_ends(bool may_be_unbounded) {
  const gen::RefitCase c = random_case(gen::Turns::any);
  const auto balls = balls_of<Hull, double>(c);
  std::size_t most = 0;
  for (const auto& set : c.sets) most += 16 * Hull::control_point_count(set.weights.vertices.size());
  for (const auto& b : balls) RC_ASSERT(b.center.allFinite() && b.radius >= 0);
  if (may_be_unbounded && balls.size() == 1) return;
  RC_ASSERT(balls.size() <= most && balls.size() >= c.sets.size());
  for (const auto& b : balls) RC_ASSERT(std::isfinite(b.radius));
}

// Checks that a piece with a ball of its own has the balls that it has alone, with that ball for its reference.
template <class Hull>
void check_own_balls() {
  using namespace refitlab;
  const gen::RefitCase c = *gen::refit_case(gen::Turns::moderate);
  const gen::NodeOf<Rational> storage(c);
  auto node = storage.node();
  std::vector<Ball3<Rational>> own;
  for (std::size_t i = 0; i < c.sets.size(); ++i) own.push_back({*gen::rational_vector<3>(), *gen::positive_rational()});
  node.piece_references = own;
  ControlLists<Rational> lists;
  const auto balls = Hull::template balls<Rational>(node, lists);
  std::size_t first = 0;
  for (std::size_t i = 0; i < c.sets.size(); ++i)
    for (const auto& b : balls_of<Hull, Rational>({own[i], {c.sets[i]}})) {
      RC_ASSERT(first < balls.size());
      RC_ASSERT(b.center == balls[first].center && b.radius == balls[first].radius);
      ++first;
    }
  RC_ASSERT(first == balls.size());
}

// Checks how far the policy's ball of double misses the exactly skinned vertices of the same doubles: at most 1e-12 of the
// coordinates' size.
template <class Hull, class Policy>
void check_double() {
  using namespace refitlab;
  const gen::RefitCase c = gen::rounded_to_double(random_case(gen::Turns::any));
  ControlLists<double> lists;
  const gen::NodeOf<double> node(c);
  const Ball3<double> ball = Hull::template refit<Policy>(node.node(), lists);
  RC_ASSERT(ball.center.allFinite() && ball.radius >= 0);
  RC_CLASSIFY(std::isinf(ball.radius), "unbounded");
  if (std::isinf(ball.radius)) return;
  double size = ball.center.norm() + ball.radius + lift<double>(c.reference.center).norm();
  for (const auto& set : c.sets) {
    size += lift<double>(set.palette.rotation_center).norm();
    for (const auto& joint : set.palette.transforms) size += lift<double>(joint.translation).norm();
  }
  const Ball3<Rational> around{convert<Rational>(ball.center), Rational(ball.radius) + Rational(1e-12 * size)};
  for (const auto& sample : gen::samples(c, Hull::blending, ball.center))
    if (const auto v = gen::skinned(c, sample, Hull::blending)) RC_ASSERT(encloses(around, *v) == Verdict::holds);
}

template <class Hull>
void balls_in_double(Suite& t) {
  const Options options{.number_type = "double", .cases = 700, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5};
  t.holds("the mean ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", options,
          check_double<Hull, refitlab::MeanBalls>);
  t.holds("the near-smallest ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", options,
          check_double<Hull, refitlab::NearSmallestBalls>);
  t.holds("the smallest ball encloses every exactly skinned vertex up to 1e-12 of the coordinates' size", options,
          check_double<Hull, refitlab::SmallestBalls>);
}

// Returns balls with the middles of the intervals.
inline std::vector<refitlab::Ball3<double>> middles(const std::vector<refitlab::Ball3<refitlab::MultiprecisionInterval>>& balls) {
  const auto middle = [](const refitlab::MultiprecisionInterval& x) { return static_cast<double>(median(x)); };
  std::vector<refitlab::Ball3<double>> out;
  for (const auto& b : balls) out.push_back({{middle(b.center[0]), middle(b.center[1]), middle(b.center[2])}, middle(b.radius)});
  return out;
}

// Measures the smallest ball of the control points over the smallest ball of densely sampled true positions. It draws random
// joint-sets of joints that turn about near points by at most 120 degrees against each other, with r = 0. The weight vertices are
// drawn towards their middle.
template <class Hull>
Checked measure_tightness(unsigned seed) {
  using namespace refitlab;
  std::mt19937_64 random(seed);
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
    bool near = true;
    for (const auto& a : palette.transforms)
      for (const auto& b : palette.transforms) near = near && dot(a.rotation, b.rotation) >= 0.5;
    if (!near) continue;
    place_rotation_center<double>(palette, rotation_center<double>(palette.transforms, Point3::Zero()));
    place_duals(palette);
    const Ball3<double> reference{2 * vector(), 0};
    std::vector<double> weight_vertices;
    for (int k = 0; k < n; ++k)
      for (int i = 0, share = count / 3 % 3; i < n; ++i)
        weight_vertices.push_back((i == k ? 1 - 0.3 * share : 0.0) + 0.3 * share / n);
    SkinningPalette<double> frame;
    frame.push_back(palette);
    const NodePiece set{0, 0, n};
    ControlLists<double> lists;
    const double bound = Hull::template refit<SmallestBalls>({reference, {&set, 1}, weight_vertices.data(), frame}, lists).radius;
    std::vector<Point3> positions;
    const int steps[] = {400, 40, 20};
    for_each_index(n, steps[n - 2], [&](const std::vector<std::size_t>& index) {
      std::vector<double> w(n, 0.0);
      for (const auto k : index)
        for (int i = 0; i < n; ++i) w[i] += weight_vertices[k * n + i] / double(index.size());
      positions.push_back(blend<double>(Hull::blending, palette, w, reference.center));
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

}  // namespace proptests::oracle
