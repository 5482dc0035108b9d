// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b7_motion_bound.hpp"

#include "proptests/counterexamples/b7_motion_bound.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_b7_motion_bound {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Span = std::span<const Rational>;
using Transforms = std::vector<RigidTransform<Rational>>;

// Returns a solution of the normal equations, by elimination. What they leave free is 0.
RationalVec<3> least_squares_center(const Transforms& list) {
  std::array<std::array<Rational, 4>, 3> rows{};
  const RationalVec<3> none = RationalVec<3>::Zero();
  for (std::size_t k = 0; k < list.size(); ++k)
    for (std::size_t l = k + 1; l < list.size(); ++l) {
      const auto a = oracle::affine_of(list[k].rotation, list[k].translation),
                 b = oracle::affine_of(list[l].rotation, list[l].translation);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
          for (int m = 0; m < 3; ++m) rows[i][j] += (a[m][i] - b[m][i]) * (a[m][j] - b[m][j]);
    }
  RationalVec<3> center = none;
  std::array<int, 3> pivot_row{-1, -1, -1};
  int used = 0;
  for (int column = 0; column < 3; ++column) {
    int row = used;
    while (row < 3 && rows[row][column] == 0) ++row;
    if (row == 3) continue;
    std::swap(rows[row], rows[used]);
    for (int other = 0; other < 3; ++other) {
      if (other == used) continue;
      const Rational factor = rows[other][column] / rows[used][column];
      for (int j = 0; j < 4; ++j) rows[other][j] -= factor * rows[used][j];
    }
    pivot_row[column] = used++;
  }
  for (int i = 0; i < 3; ++i)
    if (pivot_row[i] >= 0) center[i] = -rows[pivot_row[i]][3] / rows[pivot_row[i]][i];
  return center;
}

struct ReachCase {
  Transforms transforms;
  Rational cosine;
  RationalVec<3> point = *gen::rational_vector<3>(), vertex = *gen::rational_vector<3>();
  std::vector<Rational> weights;
  explicit ReachCase(int most) {
    transforms = *gen::rigid_transforms(1, most);
    const Rational least = *rc::gen::element(Rational(0), Rational(3, 5));
    gen::draw_together(transforms, least);
    cosine = gen::least_cosine(transforms);
    if (*rc::gen::inRange(0, 5) == 0) cosine = cosine / Rational(2);
    weights = *gen::convex_weights(static_cast<int>(transforms.size()));
  }
  // Says whether the sharp bound applies.
  bool are_close() const { return cosine >= Rational(3, 5); }
  Span u() const { return weights; }
  std::vector<Rational> w() const { return weights; }
  bool is_degenerate() const { return transforms.size() == 1 || cosine == 0 || cosine == 1 || vertex == point; }
};

void shares_and_spreads_are_computed(Suite& t) {
  t.holds(
      "the share that kernels compute is no less than either bound, exact where joints turn as much as 106 degrees or not at all",
      {.number_type = "rational", .cases = 400, .degenerate_at_least = 0.05}, [] {
        const Rational c =
            *rc::gen::oneOf(gen::unit_interval_rational(), rc::gen::element(Rational(0), Rational(3, 5), Rational(1)));
        const Rational share = squared_deviation_share(c), sharp = (Rational(1) - c) / (Rational(4) * (Rational(1) + c));
        const bool is_close = c >= Rational(3, 5);
        RC_CLASSIFY(c == Rational(3, 5) || c == Rational(1) || c == Rational(0), "degenerate");
        RC_ASSERT(share >= (is_close ? sharp : Rational(Rational(9, 16) * (Rational(1) - c))));
        RC_ASSERT(share <= (is_close ? Rational(sharp * Rational(33, 32)) : Rational(Rational(9, 16) * (Rational(1) - c))));
        if (c == Rational(3, 5)) RC_ASSERT(share == sharp);
        RC_ASSERT(deviates_little(Rational(sharp), c, Rational(1)) ==
                  verdict_of(is_close || sharp * 16 <= (Rational(1) - c) * 9));
      });
  t.holds("the spread of images is that of their sums, as seen from any point", {.number_type = "rational", .cases = 300}, [] {
    const auto images = *rc::gen::nonEmpty(rc::gen::container<std::vector<RationalVec<3>>>(gen::rational_vector<3>()));
    const RationalVec<3> from = *gen::rational_vector<3>();
    RationalVec<3> sum(0, 0, 0);
    Rational squares(0);
    for (const auto& y : images) sum += y - from, squares += squared_distance(y, from);
    RC_ASSERT(squared_spread_of_sums(Rational(static_cast<int>(images.size())), squares, sum) == squared_spread(images));
  });
}

void blends_deviate_within_the_bound(Suite& t) {
  t.holds("dual quaternions deviate from the linear blend by no more than the bound, and turn what is not at the point",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const ReachCase c(4);
            RC_ASSERT(deviation_hypotheses(c.transforms, c.cosine, c.u()) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.are_close(), "close");
            const auto found = dual_quaternion_deviation(c.transforms, c.cosine, c.point, c.u(), c.vertex);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_deviated_vertex(c.transforms, c.cosine, c.point, c.u(), c.vertex, found) == Verdict::holds);
            const RationalVec<3> sum = found.carried + found.turned + found.deviated;
            RC_ASSERT(sum == oracle::dual_quaternion(c.transforms, c.w(), c.vertex));
          });
  t.holds("so does spherical blending about a least-squares center",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const ReachCase c(4);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const auto center = least_squares_center(c.transforms);
            RC_ASSERT(is_least_squares_center(c.transforms, center) == Verdict::holds);
            RC_ASSERT(splits_spread(c.transforms, center, c.point) == Verdict::holds);
            const auto found = spherical_deviation(c.transforms, c.cosine, center, c.point, c.u(), c.vertex);
            RC_ASSERT(found.verdict == Verdict::holds);
            const RationalVec<3> sum = found.carried + found.turned + found.deviated;
            RC_ASSERT(sum == oracle::spherical(c.transforms, c.w(), center, c.vertex));
          });
  t.holds("about any center nothing deviates if that is the point, and linear blending never does",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const ReachCase c(4);
            const auto found = spherical_deviation(c.transforms, Rational(1), c.point, c.point, c.u(), c.vertex);
            RC_ASSERT(squared_norm(found.deviated) == 0 && squared_norm(found.turned) == squared_distance(c.vertex, c.point));
            const RationalVec<3> sum = found.carried + found.turned;
            RC_ASSERT(sum == oracle::spherical(c.transforms, c.w(), c.point, c.vertex));
            const RationalVec<3> left = oracle::linear(c.transforms, c.w(), c.vertex) - found.carried;
            RC_ASSERT(squared_norm(left) <= squared_distance(c.vertex, c.point));
          });
  t.holds("pair by pair the proof's identity holds, whatever the signs",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const Transforms any = *gen::rigid_transforms(1, 4);
            const auto weights = *gen::convex_weights(static_cast<int>(any.size()));
            const RationalVec<3> point = *gen::rational_vector<3>();
            RC_ASSERT(deviates_by_pairs(any, point, Span(weights)) == Verdict::holds);
          });
  t.holds(
      "for given weights, dual and spherical blends stay within the share of those weights, whatever the signs",
      {.number_type = "rational", .cases = 400, .degenerate_at_least = 0.05}, [] {
        const ReachCase c(4);
        Transforms transforms = c.transforms;
        for (auto& t : transforms)
          if (*rc::gen::inRange(0, 3) == 0) t.rotation = -t.rotation;
        const auto blend = dual_blend(transforms, c.point);
        const Rational length = squared_norm(combine<Rational, 4>(c.u(), blend.rotations));
        RC_PRE(length > Rational(1, 1000));
        std::vector<Rational> cosines;
        const bool is_sharp = *rc::gen::arbitrary<bool>();
        for (std::size_t k = 0; k < transforms.size(); ++k)
          for (std::size_t l = k + 1; l < transforms.size(); ++l)
            cosines.push_back(dot(transforms[k].rotation, transforms[l].rotation) -
                              (is_sharp ? Rational(0) : *gen::unit_interval_rational()));
        const Rational least = is_sharp ? length : length * Rational(1, 2);
        const auto at = blend.at(c.u());
        const auto images = images_of<Rational>(transforms, c.point);
        const RationalVec<3> deviation = at.numerator / at.denominator - combine<Rational, 3>(c.u(), images);
        RC_CLASSIFY(transforms.size() == 1, "degenerate");
        RC_ASSERT(squared_norm(deviation) <= squared_deviation_share<Rational>(c.u(), cosines, least) * squared_spread(images));
        // The bound by pairs holds with any a, as the versines are shares of it.
        const Rational a = *rc::gen::element(Rational(1), Rational(2), Rational(1, 3));
        std::vector<Rational> versines;
        for (std::size_t k = 0; k < transforms.size(); ++k)
          for (std::size_t l = k + 1; l < transforms.size(); ++l)
            versines.push_back((Rational(1) - dot(transforms[k].rotation, transforms[l].rotation)) / a);
        const Rational share = a * deviation_share_of_pairs<Rational>(c.u(), versines, a);
        RC_ASSERT(squared_norm(deviation) <= share * squared_spread(images));
        if (is_sharp) RC_ASSERT(share <= squared_deviation_share<Rational>(c.u(), cosines, least));
      });
}

void what_is_known_of_weights_makes_bounds_tighter(Suite& t) {
  t.holds("weights no less than some are in the hull of images that are shrunk by these",
          {.form = "beyond", .number_type = "rational", .cases = 300, .degenerate_at_least = 0.05}, [] {
            const ReachCase c(5);
            const auto images = images_of<Rational>(c.transforms, c.point);
            std::vector<Rational> least, left;
            Rational rest(1);
            for (const Rational& w : c.weights) {
              least.push_back(w * *rc::gen::oneOf(gen::unit_interval_rational(), rc::gen::element(Rational(0), Rational(1))));
              rest -= least.back();
            }
            RC_CLASSIFY(rest == 0, "degenerate");
            const RationalVec<3> at_least = combine<Rational, 3>(Span(least), images);
            std::vector<RationalVec<3>> corners;
            for (const auto& image : images) {
              corners.emplace_back();
              for (int i = 0; i < 3; ++i) corners.back()[i] = shrunk_by_least(at_least[i], rest, image[i]);
            }
            for (std::size_t k = 0; k < least.size(); ++k)
              left.push_back(rest == 0 ? least[k] : Rational((c.weights[k] - least[k]) / rest));
            RC_ASSERT(is_convex(Span(left)) == Verdict::holds);
            RC_ASSERT((combine<Rational, 3>(Span(left), corners)) == (combine<Rational, 3>(c.u(), images)));
          });
  t.holds("blends deviate by no more than the products of their weights, and the squares of these, allow",
          {.form = "beyond",
           .number_type = "rational",
           .cases = 600,
           .degenerate_at_least = 0.05,
           .tags_at_least = {{"tighter", 0.2}}},
          [] {
            const ReachCase c(4);
            Rational products(0), squares(0);
            for (std::size_t k = 0; k < c.weights.size(); ++k)
              for (std::size_t l = k + 1; l < c.weights.size(); ++l)
                products += c.weights[k] * c.weights[l], squares += sq(Rational(c.weights[k] * c.weights[l]));
            // Of several vertices the greatest is known.
            const Rational more = *rc::gen::element(Rational(0), Rational(0), Rational(1, 100), Rational(1, 8));
            products += more, squares += more;
            RC_PRE(2 * (1 - c.cosine) * products < 1);
            RC_CLASSIFY(c.transforms.size() == 1 || c.cosine == 1, "degenerate");
            const Rational share = squared_share_of_products(c.cosine, products, squares);
            RC_TAG(share < squared_deviation_share(c.cosine) ? "tighter" : "not tighter");
            const Rational spread = squared_spread(images_of<Rational>(c.transforms, c.point));
            const auto dual = dual_quaternion_deviation(c.transforms, c.cosine, c.point, c.u(), c.vertex);
            RC_ASSERT(squared_norm(dual.deviated) <= share * spread);
            const auto center = least_squares_center(c.transforms);
            const auto spherical = spherical_deviation(c.transforms, c.cosine, center, c.point, c.u(), c.vertex);
            RC_ASSERT(squared_norm(spherical.deviated) <= share * spread);
          });
  t.example("two halves 106 degrees apart deviate by 1/16 of A^2, where their products allow 5/64, and eighths by much less", {},
            [] {
              const Rational c(3, 5), half(1, 2), eighths(7, 64);
              const auto& halves = b7::halves;
              const Transforms apart{{b7::identity, b7::origin}, {{c, Rational(4, 5), 0, 0}, b7::origin}};
              const auto found = dual_quaternion_deviation(apart, c, b7::y_axis, Span(halves), b7::y_axis);
              const Rational spread = squared_spread(images_of<Rational>(apart, b7::y_axis));
              return squared_norm(found.deviated) == spread / 16 &&
                     squared_share_of_products(c, Rational(half * half), Rational(1, 16)) == Rational(5, 64) &&
                     squared_share_of_products(c, eighths, Rational(eighths * eighths)) == Rational(245, 21316);
            });
}

void joints_spread_within_the_bound(Suite& t) {
  t.example("two halves that are half a turn apart deviate by half of A^2, or 9/16 of it where no cosine is known", {}, [] {
    const std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)}, cosines{Rational(0)};
    // There are as many as are required.
    const std::vector<Rational> low{Rational(-1)}, thirds(3, Rational(1, 3)), ones(3, Rational(1));
    return squared_deviation_share<Rational>(halves, cosines, Rational(1, 2)) == Rational(1, 2) &&
           squared_deviation_share<Rational>(halves, low, Rational(1, 2)) == Rational(9, 16) &&
           squared_deviation_share<Rational>(std::vector<Rational>{Rational(1)}, {}, Rational(1)) == Rational(0) &&
           deviation_share_of_pairs<Rational>(halves, ones, Rational(1)) == Rational(1, 4) &&
           deviation_share_of_pairs<Rational>(halves, ones, Rational(2, 5)) == Rational(5, 32) &&
           deviation_share_of_pairs<Rational>(thirds, ones, Rational(1)) == Rational(1, 3);
  });
  t.holds("rotations spread a vector by no more than its length and c allow",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const ReachCase c(5);
            RC_ASSERT(turns_little(c.transforms, c.cosine, c.vertex) == Verdict::holds);
          });
  t.holds("a part of the joints has no more spread and no smaller cosine",
          {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
            const ReachCase c(4);
            const Transforms part(c.transforms.begin(),
                                  c.transforms.begin() + *rc::gen::inRange<int>(1, static_cast<int>(c.transforms.size()) + 1));
            RC_ASSERT(squared_spread(images_of<Rational>(part, c.point)) <=
                      squared_spread(images_of<Rational>(c.transforms, c.point)));
            RC_ASSERT(gen::least_cosine(part) >= gen::least_cosine(c.transforms));
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const ReachCase c(3);
    const Rational cosine = *rc::gen::element(c.cosine, Rational(1));
    decide_by_all(
        []<class S>(const std::vector<RigidTransform<S>>& transforms, const S& cosine, const Vec<S, 3>& point,
                    const std::vector<S>& u, const Vec<S, 3>& vertex) {
          return dual_quaternion_deviation<S>(transforms, cosine, point, u, vertex).verdict;
        },
        c.transforms, cosine, c.point, c.weights, c.vertex);
  });

  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const ReachCase c(4);
    const auto good = dual_quaternion_deviation(c.transforms, c.cosine, c.point, c.u(), c.vertex);
    const auto rejected = [&](const DeviatedVertex<Rational>& w) {
      return is_deviated_vertex(c.transforms, c.cosine, c.point, c.u(), c.vertex, w) == Verdict::fails;
    };
    auto carried = good, turned = good, deviated = good;
    carried.carried += *gen::nonzero_vector<3>();
    turned.turned =
        turned.turned * Rational(2) + *gen::nonzero_vector<3>() * (Rational(8) * (Rational(1) + squared_norm(good.turned)));
    deviated.deviated +=
        RationalVec<3>(1, 0, 0) * (Rational(8) * (Rational(1) + squared_spread(images_of<Rational>(c.transforms, c.point))));
    RC_ASSERT(rejected(carried) && rejected(deviated));
    RC_ASSERT(rejected(turned) || squared_norm(turned.turned) == squared_norm(good.turned));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each quaternion, each pair and each bound of the hypotheses is looked at by itself", {.parts = 15, .share = 0.02},
      [] {
        auto transforms = *rc::gen::container<Transforms>(3, gen::rigid_transform());
        gen::draw_together(transforms, Rational(1, 2));
        Rational cosine = gen::least_cosine(transforms);
        auto weights = *gen::convex_weights(3);
        const std::size_t k = gen::any_place(3), l = (k + 1 + gen::any_place(2)) % 3;
        std::string part;
        std::optional<RationalVec<3>> point = *gen::rational_vector<3>();
        const std::size_t kind = gen::any_place(5);
        if (kind == 0) {
          part = gen::place(k, 3) + " is too long";
          transforms[k].rotation *= *rc::gen::element(Rational(2), Rational(1001, 1000), Rational(100));
        } else if (kind == 1) {
          part = gen::place(k, 3) + " is too short";
          // It is still at the cosine from the others, so that its length alone is wrong.
          cosine = 0, transforms[k].rotation *= *rc::gen::element(Rational(1, 2), Rational(999, 1000), Rational(1, 100));
        } else if (kind == 2) {
          part = "the pair of " + gen::place(std::min(k, l), 3) + " and " + gen::place(std::max(k, l), 3);
          const std::size_t other = 3 - k - l;
          transforms[k].rotation = *gen::unit_quaternion(), transforms[l].rotation = *gen::unit_quaternion();
          for (const std::size_t i : {k, l})
            if (dot(transforms[i].rotation, transforms[other].rotation) < 0) transforms[i].rotation = -transforms[i].rotation;
          cosine = std::min<Rational>(dot(transforms[k].rotation, transforms[other].rotation),
                                      dot(transforms[l].rotation, transforms[other].rotation));
          RC_PRE(dot(transforms[k].rotation, transforms[l].rotation) < cosine);
        } else if (kind == 3) {
          part = "the cosine is negative";
          cosine = -*gen::excess();
          // For three that are close the bound then holds too.
          point.reset();
        } else {
          const auto broken = gen::broken_weights(weights);
          part = broken.part, weights = broken.weights;
          // Far from the origin a sum that is not 1 shows, however close the images are.
          const Rational away = *rc::gen::element(Rational(0), Rational(10'000));
          for (auto& transform : transforms) transform.translation[0] += away;
        }
        const Verdict hypothesis = deviation_hypotheses(transforms, cosine, Span(weights));
        RC_PRE(blend_has_image(dual_blend(transforms, RationalVec<3>(0, 0, 0)), Span(weights)) == Verdict::holds);
        // A little off unit length the bound, which is sharp at one place only, has room. So it has for a close pair.
        if (!point || kind == 1 || kind == 2) return Weakening{part, hypothesis, {}};
        return Weakening{part, hypothesis, dual_quaternion_deviation(transforms, cosine, *point, Span(weights), *point).verdict};
      },
      1800);
  t.holds("the hypotheses hold up to their edges", {.number_type = "rational", .cases = 300}, [] {
    const ReachCase c(4);
    const Rational least = gen::least_cosine(c.transforms), excess = *gen::excess();
    RC_ASSERT(are_within(c.transforms, least) == Verdict::holds && are_within(c.transforms, Rational(0)) == Verdict::holds);
    if (c.transforms.size() > 1) RC_ASSERT(are_within(c.transforms, Rational(least + excess)) == Verdict::fails);
    RC_ASSERT(are_within(c.transforms, Rational(-excess)) == Verdict::fails);
  });
  t.holds("a center is not least-squares if one of the normal equations is not met", {.number_type = "rational", .cases = 50},
          [] {
            const Rational amount = *gen::excess();
            for (int axis = 0; axis < 3; ++axis)
              for (int i = 0; i < 3; ++i) {
                RationalQuaternion half_turn(0, 0, 0, 0);
                half_turn[1 + axis] = 1;
                const Transforms joints{{{1, 0, 0, 0}, {0, 0, 0}}, {half_turn, {0, 0, 0}}};
                RationalVec<3> center(0, 0, 0);
                // The gradient is 8 times as much in this coordinate, or 0 along the axis.
                center[i] = amount;
                RC_ASSERT(is_least_squares_center(joints, center) == verdict_of(i == axis));
              }
          });
}

void each_part_of_a_witness_is_checked(Suite& t) {
  t.holds("both bounds of a deviation are those of the statement, at their edges too", {.number_type = "rational", .cases = 1000},
          [] {
            const Rational excess = *gen::excess(),
                           spread = *rc::gen::oneOf(gen::positive_rational(), rc::gen::just(Rational(0)));
            const Rational cosine = *rc::gen::oneOf(
                rc::gen::element(Rational(0), Rational(3, 5), Rational(3, 5) - excess / (1 + 2 * excess), Rational(1)),
                gen::unit_interval_rational());
            const Rational first = Rational(9, 16) * (1 - cosine) * spread, second = (1 - cosine) * spread / (4 * (1 + cosine));
            const Rational length =
                *rc::gen::element(first, second, Rational(first + excess), Rational(second + excess), Rational(0));
            const bool within = length <= first && (cosine < Rational(3, 5) || length <= second);
            RC_CLASSIFY(length <= first && !within, "only the sharp bound is missed");
            RC_CLASSIFY(length <= first && length > second && within, "between both, too far apart for the sharp one");
            RC_ASSERT(deviates_little(length, cosine, spread) == verdict_of(within));
          });
  t.holds("each part of a witness is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    const ReachCase c(4);
    const auto good = dual_quaternion_deviation(c.transforms, c.cosine, c.point, c.u(), c.vertex);
    const auto rejected = [&](const DeviatedVertex<Rational>& w, const Rational& cosine) {
      return is_deviated_vertex(c.transforms, cosine, c.point, c.u(), c.vertex, w) == Verdict::fails;
    };
    const Rational amount = *gen::excess();
    for (int i = 0; i < 3; ++i) {
      auto carried = good;
      carried.carried[i] += amount;
      RC_ASSERT(rejected(carried, c.cosine));
    }
    auto longer = good, shorter = good;
    longer.turned *= Rational(1) + amount, shorter.turned /= Rational(1) + amount;
    if (c.vertex != c.point) RC_ASSERT(rejected(longer, c.cosine) && rejected(shorter, c.cosine));
    // Where the cosine is 1 nothing may deviate.
    if (squared_norm(good.deviated) > 0) RC_ASSERT(rejected(good, Rational(1)));
    RC_ASSERT(good.verdict == Verdict::holds);
    auto none = dual_quaternion_deviation(c.transforms, Rational(1), c.point, c.u(), c.vertex);
    RC_ASSERT(none.verdict == verdict_of(squared_norm(none.deviated) == 0));
    none = spherical_deviation(c.transforms, Rational(1), c.vertex, c.point, c.u(), c.vertex);
    RC_ASSERT(none.verdict == verdict_of(squared_norm(none.deviated) == 0));
  });
}

void pairs_and_spreads_need_each_part(Suite& t) {
  needs_each_part(
      t, "the identity of the pairs needs unit quaternions and weights of sum 1", {.parts = 7, .share = 0.2},
      [] {
        auto transforms = *rc::gen::container<Transforms>(3, gen::rigid_transform());
        auto weights = *gen::convex_weights(3);
        const std::size_t k = gen::any_place(3);
        std::string part;
        if (*rc::gen::arbitrary<bool>()) {
          part = gen::place(k, 3) + " is no unit";
          transforms[k].rotation *= *rc::gen::element(Rational(2), Rational(999, 1000));
          // Without a weight it is in no blend: only the length of its pairs shows it.
          if (*rc::gen::arbitrary<bool>()) {
            part += ", nor in the blend";
            weights[(k + 1) % 3] += weights[k], weights[k] = 0;
          }
        } else {
          part = "the sum of the weights";
          weights[k] += *gen::excess();
        }
        return Weakening{part, deviation_hypotheses(transforms, Rational(0), Span(weights)),
                         deviates_by_pairs(transforms, *gen::rational_vector<3>(), Span(weights))};
      },
      800);
  t.holds("a sum of pairs that is wrong in one coordinate is seen", {.number_type = "rational", .cases = 50}, [] {
    for (int i = 0; i < 3; ++i) {
      RationalVec<3> moved(0, 0, 0);
      moved[i] = *gen::excess();
      const Transforms shifted{{{1, 0, 0, 0}, {0, 0, 0}}, {{1, 0, 0, 0}, moved}};
      // With weights of sum s, the image is s times too long, in this coordinate alone.
      const std::vector<Rational> twice{1, 1};
      RC_ASSERT(deviates_by_pairs(shifted, RationalVec<3>(0, 0, 0), Span(twice)) == Verdict::fails);
    }
  });
  t.holds("what rotations spread is compared with the bound of the statement, on both sides",
          {.number_type = "rational", .cases = 400}, [] {
            const ReachCase c(4);
            Rational spread(0);
            for (std::size_t k = 0; k < c.transforms.size(); ++k)
              for (std::size_t l = 0; l < k; ++l) {
                const RationalVec<3> none(0, 0, 0);
                const RationalVec<3> gap = oracle::times(oracle::affine_of(c.transforms[k].rotation, none), c.vertex) -
                                           oracle::times(oracle::affine_of(c.transforms[l].rotation, none), c.vertex);
                spread += gap.dot(gap);
              }
            const Rational n(static_cast<int>(c.transforms.size())),
                cosine = *rc::gen::oneOf(gen::unit_interval_rational(), rc::gen::just(c.cosine));
            const bool little = spread <= 2 * n * (n - 1) * (1 - cosine * cosine) * c.vertex.dot(c.vertex);
            RC_CLASSIFY(!little, "a cosine that is not theirs");
            RC_ASSERT(turns_little(c.transforms, cosine, c.vertex) == verdict_of(little));
          });
  t.holds("of a center that is not least-squares nothing is said", {.number_type = "rational", .cases = 300}, [] {
    const ReachCase c(4);
    const RationalVec<3> center = *gen::rational_vector<3>();
    RC_ASSERT(splits_spread(c.transforms, center, c.point) == Verdict::holds);
    const Rational split = squared_spread(images_of<Rational>(c.transforms, center)) +
                           squared_spread(images_of<Rational>(rotations_alone(c.transforms), RationalVec<3>(center - c.point)));
    RC_CLASSIFY(squared_spread(images_of<Rational>(c.transforms, c.point)) != split, "the spread does not split");
  });
}

void pinned_cases(Suite& t) {
  const auto deviates_without = [&t](const std::string& hypothesis, const std::string& sentence, const b7::Transforms& transforms,
                                     const b7::Q& cosine, const std::vector<b7::Q>& u) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      return deviation_hypotheses(transforms, cosine, Span(u)) == Verdict::fails &&
             dual_quaternion_deviation(transforms, cosine, b7::y_axis, Span(u), b7::y_axis).verdict == Verdict::fails;
    });
  };
  deviates_without("the quaternions are less than a right angle apart", "on the long way round a point deviates too far",
                   b7::long_way, b7::Q(-24, 25), b7::halves);
  deviates_without("the cosine is no greater than theirs", "a greater cosine promises too much", b7::short_way, b7::Q(1),
                   b7::halves);
  deviates_without("the quaternions are of unit length", "a long quaternion outweighs the others", b7::unequal, b7::short_cosine,
                   b7::halves);
  deviates_without("the weights are convex", "beyond the joints a point deviates too far", b7::short_way, b7::short_cosine,
                   b7::beyond_the_first);
  t.example("two joints at halves deviate by just the second bound", {.form = "beyond"}, [] {
    const auto found = dual_quaternion_deviation(b7::short_way, b7::short_cosine, b7::y_axis, Span(b7::halves), b7::y_axis);
    const b7::Q spread = squared_spread(images_of<Rational>(b7::short_way, b7::y_axis));
    return found.verdict == Verdict::holds && spread > 0 &&
           4 * (1 + b7::short_cosine) * squared_norm(found.deviated) == (1 - b7::short_cosine) * spread;
  });
  t.example("about a center that is not least-squares a point deviates where the joints do not move it",
            {.form = "beyond", .hypothesis = "the center is least-squares"}, [] {
              const Span u(b7::halves);
              return is_least_squares_center(b7::short_way, b7::elsewhere) == Verdict::fails &&
                     spherical_deviation(b7::short_way, b7::short_cosine, b7::elsewhere, b7::origin, u, b7::origin).verdict ==
                         Verdict::fails;
            });
}

PROPTEST(b7_motion_bound) {
  shares_and_spreads_are_computed(t);
  blends_deviate_within_the_bound(t);
  what_is_known_of_weights_makes_bounds_tighter(t);
  joints_spread_within_the_bound(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  each_part_of_a_witness_is_checked(t);
  pairs_and_spreads_need_each_part(t);
  reaches_share(t, "cases of several joints that differ, close and not", 0.35, [] { return !ReachCase(4).is_degenerate(); });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b7_motion_bound
