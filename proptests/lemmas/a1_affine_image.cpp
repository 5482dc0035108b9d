// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what affine maps make of balls, boxes and hulls.
#include "lemmas/a1_affine_image.hpp"

#include "proptests/counterexamples/a1_affine_image.hpp"
#include "proptests/gen/affine.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_a1_affine_image {
namespace {

using namespace refitlab;
using gen::RationalVec;

// Draws a ball and a point of it, which is on its surface in half of the cases.
struct BallCase {
  gen::RandomAffine affine = gen::affine_map();
  SquaredBall<Rational, 3> ball;
  RationalVec<3> point;
  BallCase() {
    const Rational radius = abs(*gen::rational());
    ball = {*gen::rational_vector<3>(), radius * radius};
    const RationalVec<3> way = gen::RationalVec<3>(rotate<Rational>(*gen::unit_quaternion(), RationalVec<3>(0, 0, 1)));
    point =
        ball.center + way * Rational(*rc::gen::arbitrary<bool>() ? radius : Rational(radius * *gen::unit_interval_rational()));
  }
  bool is_degenerate() const { return ball.squared_radius == 0 || squared_stretch(affine.map) == 0; }
};

// Draws joints with factors that are no less than what they stretch by, some of them tight, and weight vertices.
struct ControlBallCase {
  BallCase ball;
  std::vector<AffineMap<Rational>> maps;
  std::vector<Rational> stretches, coefficients;
  std::vector<std::vector<Rational>> weight_vertices;
  ControlBallCase() {
    const std::size_t joints = 1 + gen::any_place(4), count = 1 + gen::any_place(3);
    const bool are_rotations = *rc::gen::arbitrary<bool>();
    for (std::size_t i = 0; i < joints; ++i) {
      maps.push_back(gen::affine_map().map);
      const auto turn = *gen::unit_quaternion();
      for (int j = 0; are_rotations && j < 3; ++j)
        maps.back().columns[static_cast<std::size_t>(j)] = rotate<Rational>(turn, RationalVec<3>::Unit(j));
      stretches.push_back(upper_root(squared_stretch(maps.back())) * *rc::gen::element(Rational(1), Rational(1), Rational(3)));
    }
    for (std::size_t k = 0; k < count; ++k) weight_vertices.push_back(*gen::convex_weights(static_cast<int>(joints)));
    coefficients = *gen::convex_weights(static_cast<int>(count));
  }
  Rational squared_of_factors(std::span<const Rational> w) const {
    Rational sum(0);
    for (std::size_t i = 0; i < w.size(); ++i) sum += stretches[i] * w[i];
    return sum * sum;
  }
};

template <class S>
AffineMap<S> lifted(const std::vector<Vec<S, 3>>& parts) {
  return {{parts[0], parts[1], parts[2]}, parts[3]};
}
std::vector<RationalVec<3>> parts_of(const AffineMap<Rational>& m) {
  return {m.columns[0], m.columns[1], m.columns[2], m.offset};
}

void images_are_in_their_hulls(Suite& t) {
  t.holds("the image of a ball is in its ball, which columns at right angles need",
          {.form = "beyond",
           .number_type = "rational",
           .degenerate_at_least = 0.02,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"at right angles", 0.2}}},
          [] {
            const BallCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.affine.at_right_angles, "at right angles");
            RC_ASSERT(encloses(c.ball, c.point) == Verdict::holds);
            const auto found = ball_is_carried(c.affine.map, c.ball, c.point);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_carried(c.affine.map, c.ball, c.point, found) == Verdict::holds);
            if (!c.affine.at_right_angles) return;
            Rational longest(0);
            for (const auto& column : c.affine.map.columns) longest = std::max(longest, squared_norm(column));
            RC_ASSERT(squared_stretch(c.affine.map) == longest);
          });
  t.holds("the image of a box is in its box, and its corners reach every side",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_most = 0.5}, [] {
            const auto map = gen::affine_map().map;
            HalfBox<Rational> box{*gen::rational_vector<3>(), *gen::rational_vector<3>()};
            for (int i = 0; i < 3; ++i) box.half[i] = abs(box.half[i]);
            RC_CLASSIFY(box.half[0] == 0 || box.half[1] == 0 || box.half[2] == 0, "degenerate");
            RationalVec<3> point = box.center;
            for (int i = 0; i < 3; ++i) point[i] += box.half[i] * (Rational(1) - Rational(2) * *gen::unit_interval_rational());
            RC_ASSERT(encloses(box, point) == Verdict::holds);
            RC_ASSERT(box_is_carried(map, box, point) == Verdict::holds);
            const auto image = image_of_box(map, box);
            for (int i = 0; i < 3; ++i) {
              RationalVec<3> corner = box.center;
              for (int j = 0; j < 3; ++j)
                corner[j] += map.columns[static_cast<std::size_t>(j)][i] < 0 ? Rational(-box.half[j]) : box.half[j];
              RC_ASSERT(apply(map, corner)[i] == image.center[i] + image.half[i]);
            }
            const RationalVec<3> n = *gen::rational_vector<3>();
            const RationalVec<3> before = direction_before(map, n);
            RC_ASSERT(before.dot(point) == n.dot(apply(map, point)) - n.dot(map.offset));
            // The image of a ball reaches as far as that of its point along A^T n.
            const Rational reach = upper_root(squared_norm(before));
            for (const RationalVec<3>& way : {point, before}) {
              const Rational along = n.dot(turned_by(map, way));
              RC_ASSERT(along * along <= reach * reach * squared_norm(way));
              if (way == before) RC_ASSERT(along * along == squared_norm(before) * squared_norm(way));
            }
          });
  t.holds("what is near the hull of points is carried near the hull of theirs",
          {.form = "beyond", .number_type = "rational", .cases = 400}, [] {
            const auto map = gen::affine_map().map;
            const auto points = *gen::vectors<3>(1, 5);
            const auto w = *gen::convex_weights(static_cast<int>(points.size()));
            const RationalVec<3> beside = *gen::rational_vector<3>();
            const std::span<const Rational> u(w);
            RC_ASSERT(is_near_points(u, beside, squared_norm(beside)) == Verdict::holds);
            RC_ASSERT(hull_is_carried<Rational>(map, points, u, beside, squared_norm(beside)) == Verdict::holds);
          });
}

void blended_vertices_are_in_the_control_balls(Suite& t) {
  t.holds("linear blending is the blended matrix", {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
    const std::vector<AffineMap<Rational>> maps{gen::affine_map().map, gen::affine_map().map, gen::affine_map().map};
    const auto w = *gen::convex_weights(3);
    const RationalVec<3> v = *gen::rational_vector<3>();
    AffineMap<Rational> blend{{RationalVec<3>::Zero(), RationalVec<3>::Zero(), RationalVec<3>::Zero()}, RationalVec<3>::Zero()};
    std::vector<RationalVec<3>> images;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) blend.columns[j] += maps[i].columns[j] * w[i];
      blend.offset += maps[i].offset * w[i];
      images.push_back(apply(maps[i], v));
    }
    const RationalVec<3> at = linear_blend<Rational>(maps, w, v);
    RC_ASSERT(at == apply(blend, v));
    // The point is in the box of the images, as in any convex set that holds them.
    for (int i = 0; i < 3; ++i) {
      const auto by = [&](const auto& a, const auto& b) { return a[i] < b[i]; };
      RC_ASSERT(at[i] >= (*std::min_element(images.begin(), images.end(), by))[i] &&
                at[i] <= (*std::max_element(images.begin(), images.end(), by))[i]);
    }
  });
  t.holds("a vertex of weights between weight vertices is in the hull of the control balls there",
          {.form = "beyond",
           .number_type = "rational",
           .cases = 500,
           .degenerate_at_least = 0.02,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"by the blended matrix", 0.1}, {"by the blended factors", 0.05}}},
          [] {
            const ControlBallCase c;
            RC_CLASSIFY(c.ball.is_degenerate(), "degenerate");
            RC_ASSERT(are_stretches<Rational>(c.maps, c.stretches) == Verdict::holds);
            RationalVec<3> between = RationalVec<3>::Zero();
            std::vector<Rational> w(c.maps.size(), Rational(0));
            for (std::size_t k = 0; k < c.weight_vertices.size(); ++k) {
              const std::span<const Rational> at(c.weight_vertices[k]);
              RC_ASSERT(is_in_control_ball<Rational>(c.maps, c.stretches, at, c.ball.ball, c.ball.point) == Verdict::holds);
              between += linear_blend<Rational>(c.maps, at, c.ball.point) * c.coefficients[k];
              for (std::size_t i = 0; i < w.size(); ++i) w[i] += c.coefficients[k] * at[i];
              RC_CLASSIFY(blended_squared_stretch<Rational>(c.maps, c.stretches, at) < c.squared_of_factors(at),
                          "by the blended matrix");
              RC_CLASSIFY(
                  blended_squared_stretch<Rational>(c.maps, c.stretches, at) < squared_stretch(blended_map<Rational>(c.maps, at)),
                  "by the blended factors");
            }
            // Its image is that combination of points that are in the balls.
            RC_ASSERT(linear_blend<Rational>(c.maps, w, c.ball.point) == between);
            RC_ASSERT(apply(blended_map<Rational>(c.maps, w), c.ball.point) == between);
          });
  t.holds("rigid joints leave the radius of a control ball, and a scale of all of them is exact",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const Rational scale = abs(*gen::rational());
            std::vector<AffineMap<Rational>> maps(3);
            for (auto& map : maps) {
              const auto turn = *gen::unit_quaternion();
              for (int j = 0; j < 3; ++j)
                map.columns[static_cast<std::size_t>(j)] =
                    rotate<Rational>(turn, RationalVec<3>(RationalVec<3>::Unit(j) * scale));
              map.offset = *gen::rational_vector<3>();
            }
            const std::vector<Rational> stretches(3, scale), w = *gen::convex_weights(3), one{1, 0, 0};
            RC_ASSERT(blended_squared_stretch<Rational>(maps, stretches, w) <= scale * scale);
            RC_ASSERT(blended_squared_stretch<Rational>(maps, stretches, one) == scale * scale);
          });
  t.example("factors that are less than what a joint stretches by lose a vertex",
            {.form = "beyond", .hypothesis = "no factor stretches less than its joint"}, [] {
              using namespace a1;
              const std::vector<Map> maps{twice};
              const std::vector<Q> less{1}, one{1};
              return are_stretches<Q>(maps, less) == Verdict::fails &&
                     is_in_control_ball<Q>(maps, less, one, unit_ball, pole) == Verdict::fails &&
                     is_in_control_ball<Q>(maps, {{2}}, one, unit_ball, pole) == Verdict::holds;
            });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const BallCase c;
    const Rational squared = c.ball.squared_radius * *rc::gen::element(Rational(1), Rational(1, 3));
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& parts, const Vec<S, 3>& center, const S& squared_radius,
                    const Vec<S, 3>& point) {
          return ball_is_carried<S>(lifted<S>(parts), {center, squared_radius}, point).verdict;
        },
        parts_of(c.affine.map), c.ball.center, squared, c.point);
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& parts, const Vec<S, 3>& center, const Vec<S, 3>& point) {
          return box_is_carried<S>(lifted<S>(parts), {center, Vec<S, 3>(S(1), S(2), S(3))}, point);
        },
        parts_of(c.affine.map), c.ball.center, c.point);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const BallCase c;
    auto found = ball_is_carried(c.affine.map, c.ball, c.point);
    const auto i = static_cast<int>(gen::any_place(3));
    (*rc::gen::arbitrary<bool>() ? found.image : found.beside)[i] += *gen::excess();
    RC_ASSERT(is_carried(c.affine.map, c.ball, c.point, found) == Verdict::fails);
  });
  t.holds("a true image of a point outside of the ball is rejected", {.number_type = "rational", .cases = 200}, [] {
    AffineMap<Rational> map;
    const auto turn = *gen::unit_quaternion();
    for (int j = 0; j < 3; ++j) map.columns[static_cast<std::size_t>(j)] = rotate<Rational>(turn, RationalVec<3>::Unit(j));
    map.offset = *gen::rational_vector<3>();
    const SquaredBall<Rational, 3> ball{*gen::rational_vector<3>(), Rational(1)};
    const Rational far = Rational(1) + *gen::excess();
    const RationalVec<3> point = ball.center + rotate<Rational>(*gen::unit_quaternion(), RationalVec<3>(far, 0, 0));
    const auto found = ball_is_carried(map, ball, point);
    RC_ASSERT(found.verdict == Verdict::fails && is_carried(map, ball, point, found) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "a hull needs each part of the hypotheses", {.parts = 5, .share = 0.2},
      [] {
        const auto turn = *gen::unit_quaternion();
        AffineMap<Rational> map;
        for (int j = 0; j < 3; ++j) map.columns[static_cast<std::size_t>(j)] = rotate<Rational>(turn, RationalVec<3>::Unit(j));
        map.offset = RationalVec<3>(1000, 0, 0);
        const std::vector<RationalVec<3>> points{*gen::rational_vector<3>(), *gen::rational_vector<3>()};
        std::vector<Rational> w = *gen::convex_weights(2);
        RationalVec<3> beside = *gen::nonzero_vector<3>();
        Rational squared = squared_norm(beside);
        std::string part = "what is beside";
        bool asked = true;
        if (*rc::gen::arbitrary<bool>()) {
          const auto broken = gen::broken_weights(w);
          part = broken.part, w = broken.weights;
          // A sum of 1 is enough for the identity, not for the hull.
          asked = part.find("sum") != std::string::npos;
          squared = Rational(0), beside = RationalVec<3>::Zero();
        } else {
          beside *= Rational(1) + *gen::excess();
        }
        const std::span<const Rational> u(w);
        return Weakening{part, is_near_points(u, beside, squared),
                         asked ? std::optional(hull_is_carried<Rational>(map, points, u, beside, squared)) : std::nullopt};
      },
      600);
}

void pinned_cases(Suite& t) {
  t.example("a scale leaves the ball of a rigid joint", {.form = "beyond", .hypothesis = "the radius is stretched"}, [] {
    using namespace a1;
    return ball_is_carried_rigidly(twice, unit_ball, pole) == Verdict::fails &&
           ball_is_carried(twice, unit_ball, pole).verdict == Verdict::holds && squared_stretch(twice) == 4;
  });
  t.example("a point outside of the ball is carried outside", {.form = "beyond", .hypothesis = "the point is in the ball"}, [] {
    using namespace a1;
    return encloses(unit_ball, Point(2, 0, 0)) == Verdict::fails &&
           ball_is_carried(twice, unit_ball, Point(2, 0, 0)).verdict == Verdict::fails;
  });
  t.example("of a shear the bound is by 7 % too great", {.form = "beyond"}, [] {
    using namespace a1;
    // (1 + sqrt(5)) / 2 squared is 2.618..., and the row sum is 3.
    return squared_stretch(shear) == 3 && ball_is_carried(shear, unit_ball, pole).verdict == Verdict::holds;
  });
  t.example("weights beyond the joints leave the hull of their images",
            {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
              using namespace a1;
              const std::vector<Map> maps{twice, shear};
              return is_convex<Q>(beyond) == Verdict::fails && linear_blend<Q>(maps, beyond, pole)[0] == 4 - 6;
            });
}

PROPTEST(a1_affine_image) {
  images_are_in_their_hulls(t);
  blended_vertices_are_in_the_control_balls(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_a1_affine_image
