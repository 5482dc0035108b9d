// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bounds throughout an interval.
#include "lemmas/c6_interval_hull.hpp"

#include "lemmas/vocabulary/quaternion.hpp"
#include "proptests/counterexamples/c6_interval_hull.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_c6_interval_hull {
namespace {

using namespace refitlab;
using gen::RationalMotion;
using gen::RationalVec;
using Curve = CubicCurve<Rational, 3>;
using Span = std::span<const Rational>;

// Draws points of one duration, and what holds them at both ends.
struct MovingPoints {
  std::vector<Curve> curves;
  Rational acceleration, share = *gen::unit_interval_rational(), direction_length;
  RationalVec<3> direction = *gen::nonzero_vector<3>();
  Slab<Rational> start, end;
  Ball3<Rational> both{*gen::rational_vector<3>(), Rational(0)};
  MovingPoints() {
    acceleration = abs(*gen::rational());
    const Rational duration = *gen::positive_rational();
    const std::size_t count = 1 + gen::any_place(3);
    for (std::size_t k = 0; k < count; ++k) {
      const RationalVec<3> bend = gen::unit_direction() * acceleration;
      const Rational share_of_bend = *rc::gen::oneOf(rc::gen::just(Rational(1)), gen::unit_interval_rational());
      curves.push_back(
          gen::cubic_between(*gen::rational_vector<3>(), *gen::rational_vector<3>(), bend, bend * share_of_bend, duration));
    }
    enclose();
  }
  void enclose() {
    direction_length = upper_root(squared_norm(direction));
    Rational farthest(0);
    for (const auto& c : curves) {
      const Rational a = direction.dot(c.points[0]), b = direction.dot(c.points[3]);
      const bool first = &c == curves.data();
      start = {first ? a : std::min(start.low, a), first ? a : std::max(start.high, a)};
      end = {first ? b : std::min(end.low, b), first ? b : std::max(end.high, b)};
      for (const auto& p : {c.points[0], c.points[3]}) farthest = std::max(farthest, squared_distance(p, both.center));
    }
    both.radius = upper_root(farthest);
  }
  bool is_degenerate() const { return acceleration == 0 || share == 0 || share == 1; }
  Verdict hypotheses() const { return interval_hypotheses<Rational>(curves, acceleration, start, end, direction, both, share); }
  Verdict conclusion() const {
    return stays_in_interval<Rational>(curves, acceleration, start, end, direction, direction_length, both, share);
  }
};

// Draws one to three parameters. A parameter's bends are the same at its two ends.
struct Patch {
  BentPatch<Rational> patch;
  std::vector<RationalMotion> motions;
  std::vector<Rational> shares;
  Patch() {
    const std::size_t count = 1 + gen::any_place(3), corners = std::size_t(1) << count;
    for (std::size_t k = 0; k < corners; ++k) patch.corners.push_back(*gen::rational_vector<3>());
    for (std::size_t i = 0; i < count; ++i) {
      motions.push_back({Rational(0), Rational(0), abs(*gen::rational())});
      patch.sides.push_back(abs(*gen::rational()));
      shares.push_back(*gen::unit_interval_rational());
      std::vector<RationalVec<3>> bends(corners);
      for (std::size_t k = 0; k < corners; ++k)
        bends[k] =
            k >> i & 1 ? bends[k ^ (std::size_t(1) << i)] : RationalVec<3>(gen::unit_direction() * motions[i].acceleration);
      patch.bends.push_back(bends);
    }
  }
  bool is_degenerate() const {
    bool still = true;
    for (std::size_t i = 0; i < shares.size(); ++i)
      still = still && (motions[i].acceleration == 0 || patch.sides[i] == 0 || shares[i] == 0 || shares[i] == 1);
    return still;
  }
};

void points_stay_in_the_hull_of_their_interval(Suite& t) {
  t.holds("points stay in the slab and the ball of the interval",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.05, .degenerate_at_most = 0.5}, [] {
            const MovingPoints c;
            RC_ASSERT(c.hypotheses() == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(c.conclusion() == Verdict::holds);
            const auto keys = slab_of_keys(c.start, c.end);
            for (const auto& curve : c.curves) {
              RC_CLASSIFY(in_slab(keys, c.direction, curve.at(c.share)) == Verdict::fails, "outside of the slab of the ends");
              RC_ASSERT(in_slab(keys, c.direction, curve.points[0]) == Verdict::holds);
            }
          });
  t.holds("a parabola at right angles to a slab reaches its border, and half of the interval has a quarter of the slack",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const RationalVec<3> n = gen::unit_direction(), at = *gen::rational_vector<3>();
            const Rational bend = *gen::positive_rational(), duration = *gen::positive_rational(),
                           length = *gen::positive_rational();
            const Curve up = gen::cubic_between(at, at, n * Rational(-bend), n * Rational(-bend), duration);
            const Rational slack = chord_slack(bend, duration), level = n.dot(at) * length;
            const auto slab = interval_slab<Rational>({level, level}, {level, level}, slack, length);
            const RationalVec<3> direction = n * length;
            RC_ASSERT(direction.dot(up.at(Rational(1, 2))) == slab.high);
            RC_ASSERT(slab.low == level - length * slack);
            RC_ASSERT(chord_slack(bend, Rational(duration / Rational(2))) * Rational(4) == slack);
            const auto apart = interval_slab<Rational>({level, level + 1}, {level - 2, level - 1}, slack, length);
            RC_ASSERT(apart.low == slab.low - 2 && apart.high == slab.high + 1);
            RC_ASSERT(least_over_interval<Rational>(level, level - 1, slack) == level - 1 - slack);
            RC_ASSERT(interval_ball<Rational>({at, length}, slack).radius == length + slack);
          });
}

void patches_are_near_the_hull_of_their_corners(Suite& t) {
  t.holds("a function of several parameters is near the hull of its corners",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.03, .degenerate_at_most = 0.5}, [] {
            const Patch c;
            RC_ASSERT(patch_hypotheses<Rational>(c.patch, c.motions, c.shares) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.shares.size() == 3, "three parameters");
            const auto found = point_near_hull<Rational>(c.patch, c.motions, c.shares);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_near_hull<Rational>(c.patch, c.motions, c.shares, found) == Verdict::holds);
            const RationalVec<3> twin = BentPatch<Rational>::interpolated(c.patch.corners, c.shares);
            RC_ASSERT(twin == found.in_hull);
            // The formula is that of the programs, where speeds say nothing.
            std::vector<RationalMotion> fast = c.motions;
            Rational slack(0);
            for (std::size_t i = 0; i < fast.size(); ++i) {
              fast[i].speed = c.motions[i].acceleration * c.patch.sides[i] + Rational(1);
              slack += c.motions[i].acceleration * c.patch.sides[i] * c.patch.sides[i] / Rational(8);
            }
            RC_ASSERT(box_slack<Rational>(fast, c.patch.sides) == slack);
          });
  t.holds("bends of all parameters one way, in the middle, reach the sum of the slacks",
          {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
            Patch c;
            const RationalVec<3> way = gen::unit_direction();
            Rational slack(0);
            for (std::size_t i = 0; i < c.shares.size(); ++i) {
              for (auto& bend : c.patch.bends[i]) bend = way * c.motions[i].acceleration;
              c.shares[i] = Rational(1, 2), slack += chord_slack(c.motions[i].acceleration, c.patch.sides[i]);
            }
            const auto found = point_near_hull<Rational>(c.patch, c.motions, c.shares);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(squared_distance(c.patch.at(c.shares), found.in_hull) == slack * slack);
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const MovingPoints c;
    const Rational part = *rc::gen::element(Rational(1), Rational(1, 2));
    const std::vector<RationalVec<3>> points(c.curves[0].points.begin(), c.curves[0].points.end());
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& p, const S& duration, const S& acceleration, const S& share, const Vec<S, 3>& n,
                    const S& length, const std::vector<S>& slabs, const Ball<S, 3>& both) {
          const std::vector curves{CubicCurve<S, 3>{{p[0], p[1], p[2], p[3]}, duration}};
          return stays_in_interval<S>(curves, acceleration, {slabs[0], slabs[1]}, {slabs[2], slabs[3]}, n, length, both, share);
        },
        points, c.curves[0].duration, Rational(c.acceleration * part), c.share, c.direction, c.direction_length,
        std::vector<Rational>{c.start.low, c.start.high, c.end.low, c.end.high}, c.both);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Patch c;
    auto found = point_near_hull<Rational>(c.patch, c.motions, c.shares);
    const Rational amount = *gen::excess();
    const std::size_t k = gen::any_place(found.weights.size());
    if (*rc::gen::arbitrary<bool>()) found.in_hull[static_cast<int>(gen::any_place(3))] += amount;
    else found.weights[k] += amount;
    RC_ASSERT(is_near_hull<Rational>(c.patch, c.motions, c.shares, found) == Verdict::fails);
  });
  t.holds("a true point of the hull that is too far is rejected", {.number_type = "rational", .cases = 200}, [] {
    Patch c;
    c.shares[0] = Rational(1, 2), c.motions[0].acceleration = *gen::positive_rational(),
    c.patch.sides[0] = *gen::positive_rational();
    const RationalVec<3> way = gen::unit_direction();
    for (std::size_t i = 0; i < c.shares.size(); ++i)
      for (auto& bend : c.patch.bends[i])
        bend = i == 0 ? RationalVec<3>(way * c.motions[0].acceleration) : RationalVec<3>::Zero();
    auto less = c.motions;
    for (auto& m : less) m.acceleration = Rational(0);
    less[0].acceleration = c.motions[0].acceleration * Rational(999, 1000);
    RC_ASSERT(is_near_hull<Rational>(c.patch, less, c.shares, point_near_hull<Rational>(c.patch, c.motions, c.shares)) ==
              Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "an interval needs each part of the hypotheses", {.parts = 6, .share = 0.2},
      [] {
        MovingPoints c;
        const std::size_t k = gen::any_place(c.curves.size());
        c.acceleration = *gen::positive_rational(), c.share = Rational(1, 2);
        for (auto& curve : c.curves)
          curve = gen::cubic_between(curve.points[0], curve.points[3], RationalVec<3>::Zero(), RationalVec<3>::Zero(),
                                     curve.duration);
        c.enclose();
        const RationalVec<3> away = c.direction;
        const Rational huge(1000000);
        switch (gen::any_place(6)) {
          case 0: {
            c.curves[k] = gen::cubic_between(c.curves[k].points[0], c.curves[k].points[3],
                                             away * huge * c.acceleration / (c.curves[k].duration * c.curves[k].duration),
                                             away * huge * c.acceleration / (c.curves[k].duration * c.curves[k].duration),
                                             c.curves[k].duration);
            return Weakening{"a bend", c.hypotheses(), c.conclusion()};
          }
          case 1:
            c.start = {c.start.low - huge, c.start.low - Rational(huge / Rational(2))};
            c.end = c.start;
            return Weakening{"the slab at an end", c.hypotheses(),
                             c.acceleration * c.curves[k].duration * c.curves[k].duration < 100 ? std::optional(c.conclusion())
                                                                                                : std::nullopt};
          case 2:
            c.both.center += away * huge;
            return Weakening{"the ball", c.hypotheses(),
                             c.acceleration * c.curves[k].duration * c.curves[k].duration < 100 ? std::optional(c.conclusion())
                                                                                                : std::nullopt};
          case 3: c.share = -*gen::excess(); return Weakening{"the share is negative", c.hypotheses(), std::nullopt};
          case 4:
            c.share = Rational(1) + *gen::excess();
            return Weakening{"the share is more than 1", c.hypotheses(), std::nullopt};
          default:
            c.curves[k].duration = -c.curves[k].duration;
            return Weakening{"the duration is negative", c.hypotheses(), std::nullopt};
        }
      },
      500);
  needs_each_part(t, "a patch needs each part of the hypotheses", {.parts = 5, .share = 0.2}, [] {
    Patch c;
    const std::size_t i = gen::any_place(c.shares.size());
    const Rational amount = *gen::excess();
    std::string part;
    bool asked = false;
    switch (gen::any_place(5)) {
      case 0: part = "a share is negative", c.shares[i] = -amount; break;
      case 1: part = "a share is more than 1", c.shares[i] = Rational(1) + amount; break;
      case 2: part = "a side is negative", c.patch.sides[i] = -Rational(1) - amount; break;
      case 3: part = "a bound is negative", c.motions[i].acceleration = -c.motions[i].acceleration - amount; break;
      default: {
        part = "a bend", asked = true;
        const RationalVec<3> way = gen::unit_direction();
        for (std::size_t l = 0; l < c.shares.size(); ++l) {
          c.shares[l] = Rational(1, 2), c.patch.sides[l] = Rational(1);
          const Rational longer = l == i ? Rational(c.motions[l].acceleration + amount) : c.motions[l].acceleration;
          for (auto& bend : c.patch.bends[l]) bend = way * longer;
        }
      }
    }
    return Weakening{part, patch_hypotheses<Rational>(c.patch, c.motions, c.shares),
                     asked ? std::optional(point_near_hull<Rational>(c.patch, c.motions, c.shares).verdict) : std::nullopt};
  });
}

void pinned_cases(Suite& t) {
  t.example("a hand that turns leaves the box of its keys, not that of the interval", {.form = "beyond"}, [] {
    using namespace c6;
    const Slab keys = slab_of_keys(hand_slab, hand_slab),
               interval = interval_slab(hand_slab, hand_slab, chord_slack(hand_bends, Q(1)), Q(1));
    return in_slab(keys, x_axis, hand_start) == Verdict::holds && in_slab(keys, x_axis, hand_end) == Verdict::holds &&
           in_slab(keys, x_axis, hand_middle) == Verdict::fails && in_slab(interval, x_axis, hand_middle) == Verdict::holds;
  });
  const auto thrown = [](const c6::Q& acceleration, const c6::Q& share) {
    using namespace c6;
    const std::vector curves{throw_up};
    return std::pair(interval_hypotheses<Q>(curves, acceleration, ground, ground, x_axis, at_ground, share),
                     stays_in_interval<Q>(curves, acceleration, ground, ground, x_axis, Q(1), at_ground, share));
  };
  t.example("what bends more than said leaves the interval's slab and ball", {.form = "beyond", .hypothesis = "||f''|| <= M"},
            [&] {
              return thrown(8, c6::Q(1, 2)) == std::pair(Verdict::holds, Verdict::holds) &&
                     thrown(7, c6::Q(1, 2)) == std::pair(Verdict::fails, Verdict::fails);
            });
  t.example("beyond the interval nothing holds", {.form = "beyond", .hypothesis = "0 <= s <= 1"},
            [&] { return thrown(8, c6::Q(2)) == std::pair(Verdict::fails, Verdict::fails); });
  t.example("a set that holds one end alone says nothing of the other", {.form = "beyond", .hypothesis = "K holds both ends"},
            [] {
              using namespace c6;
              const std::vector curves{Curve{{origin, Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0)}, 1}};
              return interval_hypotheses<Q>(curves, Q(0), ground, ground, x_axis, at_ground, Q(1, 2)) == Verdict::fails &&
                     stays_in_interval<Q>(curves, Q(0), ground, ground, x_axis, Q(1), at_ground, Q(1, 2)) == Verdict::fails;
            });
}

PROPTEST(c6_interval_hull) {
  points_stay_in_the_hull_of_their_interval(t);
  patches_are_near_the_hull_of_their_corners(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c6_interval_hull
