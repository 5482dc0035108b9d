// SPDX-License-Identifier: GPL-3.0-or-later
// Tests any pose of a chain of joints.
#include "lemmas/c8_any_pose.hpp"

#include "proptests/counterexamples/c8_any_pose.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_c8_any_pose {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Links = std::vector<PosedLink<Rational>>;
using Ranges = std::vector<LinkRange<Rational>>;

struct Chain {
  Links links;
  Ranges ranges;
  RationalVec<3> point;
  Rational distance;
  explicit Chain(int most, bool scaled = true) {
    for (std::size_t k = gen::any_place(6) == 0 ? 0 : 1 + gen::any_place(static_cast<std::size_t>(most)); k > 0; --k) {
      const Rational length = abs(*gen::rational());
      const RationalVec<3> scale = scaled ? *gen::rational_vector<3>() : RationalVec<3>(1, 1, 1);
      links.push_back({*gen::unit_quaternion(), gen::unit_direction() * length, scale});
      ranges.push_back({length + *rc::gen::element(Rational(0), Rational(1)), by_greatest_factor(scale)});
    }
    point = *gen::rational_vector<3>(), distance = upper_root(squared_norm(point));
  }
  bool is_degenerate() const {
    bool still = links.empty() || distance == 0;
    for (const auto& r : ranges) still = still || r.stretch == 0;
    return still;
  }
};

void points_stay_within_the_reach_of_their_chain(Suite& t) {
  t.holds("a point stays within the reach of its chain, in any pose",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const Chain c(4);
            for (std::size_t k = 0; k < c.links.size(); ++k) RC_ASSERT(is_in_range(c.links[k], c.ranges[k]) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.links.empty(), "no links");
            const auto found = stays_in_reach<Rational>(c.links, c.ranges, c.point, c.distance);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(are_reach_steps<Rational>(c.links, c.ranges, c.point, c.distance, found.steps) == Verdict::holds);
            RationalVec<3> twin = c.point;
            for (std::size_t k = c.links.size(); k-- > 0;) {
              const RationalVec<3> scaled = c.links[k].scale.cwiseProduct(twin);
              twin = oracle::times<Rational>(oracle::affine_of<Rational>(c.links[k].rotation, c.links[k].translation), scaled);
            }
            RC_ASSERT(twin == found.steps.back());
          });
  t.holds("stretched out it reaches it", {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
    Chain c(4);
    const Rational arm = *gen::positive_rational();
    c.point = RationalVec<3>(arm, 0, 0);
    for (std::size_t k = 0; k < c.links.size(); ++k) {
      const Rational length = abs(*gen::rational()), stretch = abs(*gen::rational());
      c.links[k] = {{1, 0, 0, 0}, RationalVec<3>(length, 0, 0), RationalVec<3>(stretch, 0, 0)}, c.ranges[k] = {length, stretch};
    }
    const Rational reach = reach_of_chain<Rational>(c.ranges, arm);
    RC_ASSERT(squared_norm(stays_in_reach<Rational>(c.links, c.ranges, c.point, arm).steps.back()) == reach * reach);
  });
  t.holds("two joints stay together",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.1, .degenerate_at_most = 0.7}, [] {
            const Chain common(2), first(2), second(2);
            RC_CLASSIFY(first.is_degenerate() || second.is_degenerate(), "degenerate");
            const auto place = [](const Chain& c) {
              return stays_in_reach<Rational>(c.links, c.ranges, c.point, c.distance).steps.back();
            };
            const Rational reach = reach_of_chain<Rational>(first.ranges, first.distance),
                           other = reach_of_chain<Rational>(second.ranges, second.distance);
            RC_ASSERT(stay_together<Rational>(common.links, common.ranges, place(first), place(second), reach, other) ==
                      Verdict::holds);
          });
}

void skinned_vertices_stay_in_their_balls(Suite& t) {
  t.holds(
      "a skinned vertex stays in its ball: by linear and spherical blending, and by dual quaternions with the pairs' "
      "sum",
      {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_most = 0.7}, [] {
        // The vertex belongs to the joints of some rigid chains from one root.
        const std::size_t count = 1 + gen::any_place(3);
        const RationalVec<3> vertex = *gen::rational_vector<3>(), center = *gen::rational_vector<3>(),
                             none = RationalVec<3>::Zero();
        const Rational length = upper_root(squared_norm(vertex)), of_center = upper_root(squared_norm(center)),
                       arm = upper_root(squared_distance(vertex, center));
        std::vector<RigidTransform<Rational>> joints;
        std::vector<Rational> reaches;
        Rational reach(0), center_reach(0), spread(0);
        bool still = count == 1 || length == 0;
        for (std::size_t k = 0; k < count; ++k) {
          const Chain c(2, false);
          still = still || c.links.empty();
          RigidTransform<Rational> all;
          for (const auto& link : c.links) all = compose(all, {link.rotation, link.translation});
          // The sign is the one that is nearer to the first.
          if (k > 0 && dot(all.rotation, joints[0].rotation) < 0) all.rotation = -all.rotation;
          joints.push_back(all), reaches.push_back(reach_of_chain<Rational>(c.ranges, length));
          reach = std::max(reach, reaches.back()),
          center_reach = std::max(center_reach, reach_of_chain<Rational>(c.ranges, of_center));
          for (std::size_t l = 0; l < k; ++l) spread += sq(apart_at_most<Rational>({}, reaches[k], reaches[l]));
        }
        RC_CLASSIFY(still, "degenerate");
        const auto w = *gen::convex_weights(static_cast<int>(count));
        RC_ASSERT(squared_norm(oracle::linear(joints, w, vertex)) <= reach * reach);
        RationalVec<3> blend = none;
        const Quaternion<Rational> q = blended_rotation<Rational>(joints, w);
        RC_PRE(squared_norm(q) > 0);
        RC_ASSERT(squared_norm(oracle::spherical(joints, w, center, vertex)) <= sq(Rational(center_reach + arm)));
        Rational cosine(1);
        for (const auto& a : joints)
          for (const auto& b : joints) cosine = std::min(cosine, dot(a.rotation, b.rotation));
        if (cosine < 0) return;
        blend = oracle::dual_quaternion(joints, w, vertex);
        RC_ASSERT(squared_norm(blend) <= sq(Rational(reach + upper_root(squared_deviation_in_any_pose(spread)))));
      });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Chain c(1);
    RC_PRE(c.links.size() == 1);
    const Rational length = c.ranges[0].length * *rc::gen::element(Rational(1), Rational(1, 3));
    decide_by_all(
        []<class S>(const Quaternion<S>& q, const Vec<S, 3>& translation, const Vec<S, 3>& scale, const S& length,
                    const S& stretch, const Vec<S, 3>& point, const S& distance) {
          const std::vector links{PosedLink<S>{q, translation, scale}};
          const std::vector ranges{LinkRange<S>{length, stretch}};
          return stays_in_reach<S>(links, ranges, point, distance).verdict;
        },
        c.links[0].rotation, c.links[0].translation, c.links[0].scale, length, c.ranges[0].stretch, c.point, c.distance);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Chain c(3);
    auto steps = stays_in_reach<Rational>(c.links, c.ranges, c.point, c.distance).steps;
    const std::size_t k = gen::any_place(steps.size() + 1);
    if (k == steps.size()) steps.pop_back();
    else steps[k][static_cast<int>(gen::any_place(3))] += *gen::excess();
    RC_ASSERT(are_reach_steps<Rational>(c.links, c.ranges, c.point, c.distance, steps) == Verdict::fails);
  });
  t.holds("true steps that are too far are rejected", {.number_type = "rational", .cases = 200}, [] {
    const Chain c(3);
    RC_PRE(c.distance > 0);
    const auto steps = stays_in_reach<Rational>(c.links, c.ranges, c.point, c.distance).steps;
    RC_ASSERT(are_reach_steps<Rational>(c.links, c.ranges, c.point, Rational(c.distance * Rational(999, 1000)), steps) ==
              Verdict::fails);
    auto shorter = c.ranges;
    for (auto& r : shorter) r = {Rational(0), Rational(0)};
    bool moved = false;
    for (std::size_t k = 1; k < steps.size(); ++k) moved = moved || squared_norm(steps[k]) > 0;
    RC_ASSERT(are_reach_steps<Rational>(c.links, shorter, c.point, c.distance, steps) == verdict_of(!moved));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(t, "a reach needs each part of its hypotheses", {.parts = 4, .share = 0.2}, [] {
    const Rational length = *gen::positive_rational(), stretch = *gen::positive_rational(), more = Rational(1) + *gen::excess();
    LinkRange<Rational> range{length, stretch};
    PosedLink<Rational> link{{1, 0, 0, 0}, RationalVec<3>(length, 0, 0), RationalVec<3>(stretch, stretch, stretch)};
    const RationalVec<3> point(1, 0, 0);
    std::string part;
    bool asked = true;
    switch (gen::any_place(4)) {
      case 0: part = "the translation is longer", link.translation *= more; break;
      case 1: part = "the scale stretches more", link.scale[0] *= more; break;
      case 2: part = "the rotation is none", link.rotation[1] = Rational(2), asked = false; break;
      default: part = "the length is negative", range.length = -length, asked = false;
    }
    return Weakening{
        part, is_in_range(link, range),
        asked ? std::optional(stays_in_reach<Rational>(std::vector{link}, std::vector{range}, point, Rational(1)).verdict)
              : std::nullopt};
  });
}

void pinned_cases(Suite& t) {
  t.example("an arm that is bent in the reference pose reaches 3 times as far stretched", {.form = "beyond"}, [] {
    using namespace c8;
    const std::vector<Link> bent{shoulder, bent_elbow}, stretched{shoulder, elbow};
    const std::vector<Range> ranges{bone, bone};
    const auto folded = stays_in_reach<Q>(bent, ranges, hand, Q(1)), out = stays_in_reach<Q>(stretched, ranges, hand, Q(1));
    return folded.verdict == Verdict::holds && out.verdict == Verdict::holds && reach_of_chain<Q>(ranges, Q(1)) == 3 &&
           stays_in_guess(folded.steps.back(), out.steps.back(), Q(2)) == Verdict::fails && squared_norm(out.steps.back()) == 9;
  });
  t.example("a bone that is longer than said reaches farther", {.form = "beyond", .hypothesis = "||t|| <= l"}, [] {
    using namespace c8;
    const std::vector<Link> links{{straight, Point(2, 0, 0), ones}};
    const std::vector<Range> ranges{bone};
    return is_in_range(links[0], bone) == Verdict::fails &&
           stays_in_reach<Q>(links, ranges, hand, Q(1)).verdict == Verdict::fails;
  });
  t.example("a scale that stretches more than said reaches farther", {.form = "beyond", .hypothesis = "the scale is at most f"},
            [] {
              using namespace c8;
              const std::vector<Link> links{{straight, Point(1, 0, 0), twice}};
              const std::vector<Range> ranges{bone};
              return is_in_range(links[0], bone) == Verdict::fails &&
                     stays_in_reach<Q>(links, ranges, hand, Q(1)).verdict == Verdict::fails;
            });
  t.example("no links reach as far as the point", {.form = "beyond"},
            [] { return reach_of_chain<c8::Q>({}, c8::Q(5)) == 5 && apart_at_most<c8::Q>({}, 1, 2) == 3; });
}

PROPTEST(c8_any_pose) {
  points_stay_within_the_reach_of_their_chain(t);
  skinned_vertices_stay_in_their_balls(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c8_any_pose
