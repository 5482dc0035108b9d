// SPDX-License-Identifier: GPL-3.0-or-later
// Tests points under chains of joints that move.
#include "lemmas/c4_chain_motion.hpp"

#include "proptests/counterexamples/c4_chain_motion.hpp"
#include "proptests/gen/chain.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_c4_chain_motion {
namespace {

using namespace refitlab;
using gen::MovingChain;
using gen::RationalMotion;
using gen::RationalVec;
using Links = std::span<const LinkMoment<Rational>>;
using Motions = std::span<const LinkMotion<Rational>>;

// Judges a chain of two links in a row. Its numbers, which are lifted, are three moments and motions for each link, and the
// point's.
template <class S>
Verdict two_links_move(const std::vector<Vec<S, 4>>& numbers) {
  std::size_t next = 0;
  const auto four = [&] { return Moment<S, 4>{numbers[next], numbers[next + 1], numbers[(next += 3) - 1]}; };
  const auto three = [&] {
    const Moment<S, 4> m = four();
    return Moment<S, 3>{imaginary(m.value), imaginary(m.velocity), imaginary(m.acceleration)};
  };
  const auto motion = [&] {
    const Vec<S, 4> m = numbers[next++];
    return Motion<S>{m[0], m[1], m[2]};
  };
  std::vector<LinkMoment<S>> links;
  std::vector<LinkMotion<S>> motions;
  for (int k = 0; k < 2; ++k) {
    const Moment<S, 3> translation = three();
    const Moment<S, 4> rotation = four();
    links.push_back({translation, rotation, three()});
    const Motion<S> of_translation = motion(), of_rotation = motion();
    motions.push_back({of_translation, of_rotation, motion()});
  }
  const Moment<S, 3> point = three();
  return chain_moves<S>(links, motions, point, motion()).verdict;
}

void points_move_within_the_bounds_of_their_chain(Suite& t) {
  t.holds("a point under a chain moves within the bounds, as matrices of jets say too",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.7}, [] {
            const MovingChain c(4);
            for (std::size_t k = 0; k < c.links.size(); ++k)
              RC_ASSERT(link_hypotheses(c.links[k], c.motions[k]) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.links.empty(), "no links");
            const auto found = chain_moves<Rational>(c.links, c.motions, c.point, c.below);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(are_chain_steps<Rational>(c.links, c.motions, c.point, c.below, found.steps) == Verdict::holds);
            const auto twin = gen::chain_by_jets(c);
            RC_ASSERT(twin.value == found.steps.back().value);
            RC_ASSERT(twin.velocity == found.steps.back().velocity);
            RC_ASSERT(twin.acceleration == found.steps.back().acceleration);
          });
  t.holds("bounds multiplied from the point up are those from the root down, and so is the rotation's",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const MovingChain c(4);
            RationalMotion up = c.below, turn = at_rest(Rational(1));
            for (std::size_t k = c.motions.size(); k-- > 0;) {
              const auto& m = c.motions[k];
              up = product(product(product(m.rotation, m.rotation), m.scale), up) + m.translation;
              turn = product(m.rotation, turn);
            }
            const auto chain = chain_motion<Rational>(c.motions);
            const auto down = carried_motion(chain, c.below);
            RC_ASSERT(up.size == down.size && up.speed == down.speed && up.acceleration == down.acceleration);
            RC_ASSERT(chain.rotation.speed == turn.speed && chain.rotation.acceleration == turn.acceleration);
            Moment<Rational, 4> q{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
            for (const auto& link : c.links)
              q = product(q, link.rotation, [](const auto& a, const auto& b) { return multiply<Rational>(a, b); });
            RC_ASSERT(moves_within(q, chain.rotation) == Verdict::holds);
          });
  t.holds("hinges in a row that turn one way about one axis reach the bounds",
          {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
            // The links are stretched along x, and all turn about z: nothing is lost between the products.
            const RationalVec<3> none = RationalVec<3>::Zero();
            MovingChain c(0);
            const int count = *rc::gen::inRange(1, 5);
            for (int k = 0; k < count; ++k) {
              const Rational speed = *gen::positive_rational(), bone = *gen::positive_rational();
              const auto turn = gen::turning_moment({1, 0, 0, 0}, RationalVec<3>(0, 0, speed), none);
              c.links.push_back({{RationalVec<3>(bone, 0, 0), none, none}, turn, {RationalVec<3>(1, 1, 1), none, none}});
              c.motions.push_back({at_rest(bone), circle_motion(speed), at_rest(Rational(1))});
            }
            const Rational arm = *gen::positive_rational();
            const auto found =
                chain_moves<Rational>(c.links, c.motions, {RationalVec<3>(arm, 0, 0), none, none}, at_rest(arm)).steps.back();
            const auto bounds = carried_motion(chain_motion<Rational>(c.motions), at_rest(arm));
            RC_ASSERT(squared_norm(found.value) == sq(bounds.size) && squared_norm(found.velocity) == sq(bounds.speed) &&
                      squared_norm(found.acceleration) == sq(bounds.acceleration));
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    std::vector<Vec<Rational, 4>> numbers;
    const auto add = [&](const auto& m) {
      for (const auto& x : {m.value, m.velocity, m.acceleration})
        if constexpr (std::is_same_v<std::decay_t<decltype(m)>, Moment<Rational, 3>>) numbers.push_back({0, x[0], x[1], x[2]});
        else numbers.push_back(x);
    };
    const auto add_bound = [&](const RationalMotion& m) { numbers.push_back({m.size, m.speed, m.acceleration, 0}); };
    const Rational share = *rc::gen::element(Rational(1), Rational(1, 4));
    for (int k = 0; k < 2; ++k) {
      const auto turn = gen::turning_quaternion();
      const LinkMotion<Rational> m{gen::any_motion(), turn.motion, gen::any_motion()};
      add(gen::moment_within<3>(m.translation)), add(turn.moment), add(gen::moment_within<3>(m.scale));
      add_bound(m.translation), add_bound({share, m.rotation.speed * share, m.rotation.acceleration * share}), add_bound(m.scale);
    }
    const auto below = gen::any_motion();
    add(gen::moment_within<3>(below)), add_bound(below);
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n) { return two_links_move<S>(n); }, numbers);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const MovingChain c(3);
    auto steps = chain_moves<Rational>(c.links, c.motions, c.point, c.below).steps;
    const std::size_t k = gen::any_place(steps.size());
    const auto i = static_cast<int>(gen::any_place(3));
    const Rational amount = *gen::excess();
    switch (gen::any_place(4)) {
      case 0: steps[k].value[i] += amount; break;
      case 1: steps[k].velocity[i] += amount; break;
      case 2: steps[k].acceleration[i] += amount; break;
      default: steps.pop_back();
    }
    RC_ASSERT(are_chain_steps<Rational>(c.links, c.motions, c.point, c.below, steps) == Verdict::fails);
  });
  t.holds("true steps that leave the bounds are rejected", {.number_type = "rational", .cases = 200}, [] {
    MovingChain c(0);
    const RationalVec<3> none = RationalVec<3>::Zero();
    const Rational speed = *gen::positive_rational(), little = Rational(999, 1000);
    const auto turn = gen::turning_moment(*gen::unit_quaternion(), RationalVec<3>(0, 0, speed), none);
    c.links.push_back({{none, none, none}, turn, {RationalVec<3>(1, 1, 1), none, none}});
    c.motions.push_back({at_rest(Rational(0)), circle_motion(speed), at_rest(Rational(1))});
    c.point = {RationalVec<3>(1, 0, 0), none, none}, c.below = at_rest(Rational(1));
    const auto steps = chain_moves<Rational>(c.links, c.motions, c.point, c.below).steps;
    // The turn's axis is z only before q: seen from the point it is another one, which may leave it at rest.
    RC_PRE(squared_norm(steps[1].velocity) == Rational(4) * speed * speed);
    (*rc::gen::arbitrary<bool>() ? c.motions[0].rotation.speed : c.motions[0].rotation.acceleration) *= little * little;
    RC_ASSERT(are_chain_steps<Rational>(c.links, c.motions, c.point, c.below, steps) == Verdict::fails);
    RC_ASSERT(chain_moves<Rational>(c.links, c.motions, c.point, c.below).verdict == Verdict::fails);
    RC_ASSERT(are_chain_steps<Rational>(c.links, {}, c.point, at_rest(Rational(1, 2)), steps) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "a chain needs each part of the hypotheses", {.parts = 12, .share = 0.1},
      [] {
        // Hinges about z reach the bounds in size, speed and acceleration, so that a broken bound is seen.
        const RationalVec<3> none = RationalVec<3>::Zero();
        const RationalVec<3> x(1, 0, 0);
        LinkMoment<Rational> link{{x, x, x},
                                  gen::turning_moment({1, 0, 0, 0}, none, none),
                                  {RationalVec<3>(1, 1, 1), RationalVec<3>(1, 1, 1), RationalVec<3>(1, 1, 1)}};
        const Motion<Rational> one{Rational(1), Rational(1), Rational(1)};
        LinkMotion<Rational> motion{one, at_rest(Rational(1)), one};
        const Moment<Rational, 3> point{x, none, none};
        std::string part;
        const Rational more = Rational(1) + *gen::excess();
        const auto break_of = [&](auto& m, Motion<Rational>& bounds, const std::string& name) {
          const std::size_t what = gen::any_place(4);
          if (what == 0) m.value *= more, part = name + "'s size";
          if (what == 1) m.velocity *= more, part = name + "'s speed";
          if (what == 2) m.acceleration *= more, part = name + "'s acceleration";
          if (what == 3) bounds.speed = -more, part = name + "'s bound is negative";
        };
        switch (gen::any_place(3)) {
          case 0: break_of(link.translation, motion.translation, "the translation"); break;
          case 1: break_of(link.scale, motion.scale, "the scale"); break;
          default: {
            link.rotation = gen::turning_moment({1, 0, 0, 0}, RationalVec<3>(0, 0, 1), none);
            motion.rotation = circle_motion(Rational(1));
            // The link is at rest but for the turn, so that what is across counts.
            link.translation = {none, none, none}, motion.translation = at_rest(Rational(0));
            link.scale = {RationalVec<3>(1, 1, 1), none, none}, motion.scale = at_rest(Rational(1));
            break_of(link.rotation, motion.rotation, "the rotation");
          }
        }
        const std::vector links{link};
        const std::vector motions{motion};
        const bool asked = part.find("negative") == std::string::npos;
        return Weakening{
            part, link_hypotheses(link, motion),
            asked ? std::optional(chain_moves<Rational>(links, motions, point, at_rest(Rational(1))).verdict) : std::nullopt};
      },
      900);
}

void pinned_cases(Suite& t) {
  t.example("an arm of two hinges that turn one way reaches its bounds", {.form = "beyond"}, [] {
    using namespace c4;
    const std::vector<Link> links{hinge, bone};
    const std::vector<LinkMotion> motions{of_hinge, of_bone};
    const auto found = chain_moves<Q>(links, motions, tip, one);
    const auto bounds = carried_motion(chain_motion<Q>(motions), one);
    // The outer turn carries a length of 2 at the speed 2, and the inner one a length of 1 at the speed 2 more. The acceleration
    // is 4 * 2 + 4 + 2 * 2 * 2.
    return found.verdict == Verdict::holds && bounds.size == 2 && bounds.speed == 6 && bounds.acceleration == 20 &&
           squared_norm(found.steps.back().acceleration) == 400;
  });
  t.example("without the products of speeds an arm of two hinges leaves its bounds",
            {.form = "beyond", .hypothesis = "speeds multiply too"}, [] {
              using namespace c4;
              const std::vector<Link> links{hinge, bone};
              const auto found = chain_moves<Q>(links, std::vector<LinkMotion>{of_hinge, of_bone}, tip, one).steps.back();
              return squared_norm(found.acceleration) > sq(Q(12));
            });
  t.example("no links leave a point where it is", {.form = "beyond"}, [] {
    using namespace c4;
    const auto found = chain_moves<Q>(std::vector<Link>{}, std::vector<LinkMotion>{}, tip, one);
    const auto bounds = carried_motion(no_links<Q>(), Motion{1, 2, 3});
    return found.verdict == Verdict::holds && found.steps.size() == 1 && bounds.size == 1 && bounds.speed == 2 &&
           bounds.acceleration == 3;
  });
}

PROPTEST(c4_chain_motion) {
  points_move_within_the_bounds_of_their_chain(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c4_chain_motion
