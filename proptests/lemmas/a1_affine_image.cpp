// SPDX-License-Identifier: GPL-3.0-or-later
// What affine maps make of balls, boxes and hulls.
#include "lemmas/a1_affine_image.hpp"

#include "proptests/counterexamples/a1_affine_image.hpp"
#include "proptests/gen/affine.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_a1_affine_image {
namespace {

using namespace refitlab;
using gen::RationalVec;

// A point of the ball, on its surface as often as not.
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

template <class S>
AffineMap<S> lifted(const std::vector<Vec<S, 3>>& parts) {
  return {{parts[0], parts[1], parts[2]}, parts[3]};
}
std::vector<RationalVec<3>> parts_of(const AffineMap<Rational>& m) {
  return {m.columns[0], m.columns[1], m.columns[2], m.offset};
}

PROPTEST(a1_affine_image) {
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
    // In the box of the images, as in any convex set that holds them.
    for (int i = 0; i < 3; ++i) {
      const auto by = [&](const auto& a, const auto& b) { return a[i] < b[i]; };
      RC_ASSERT(at[i] >= (*std::min_element(images.begin(), images.end(), by))[i] &&
                at[i] <= (*std::max_element(images.begin(), images.end(), by))[i]);
    }
  });
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
  needs_each_part(t, "a hull needs each part of the hypotheses", 0.2, [] {
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
      asked = part.find("sum") != std::string::npos;  // a sum of 1 is enough for the identity, not for the hull
      squared = Rational(0), beside = RationalVec<3>::Zero();
    } else {
      beside *= Rational(1) + *gen::excess();
    }
    const std::span<const Rational> u(w);
    return Weakening{part, is_near_points(u, beside, squared),
                     asked ? std::optional(hull_is_carried<Rational>(map, points, u, beside, squared)) : std::nullopt};
  });
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
    // (1 + sqrt(5)) / 2 squared is 2.618..., the row sum is 3.
    return squared_stretch(shear) == 3 && ball_is_carried(shear, unit_ball, pole).verdict == Verdict::holds;
  });
  t.example("weights beyond the joints leave the hull of their images",
            {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
              using namespace a1;
              const std::vector<Map> maps{twice, shear};
              return is_convex<Q>(beyond) == Verdict::fails && linear_blend<Q>(maps, beyond, pole)[0] == 4 - 6;
            });
}

}  // namespace
}  // namespace proptests::suite_a1_affine_image
