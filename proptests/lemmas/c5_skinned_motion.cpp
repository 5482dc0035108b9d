// SPDX-License-Identifier: GPL-3.0-or-later
// Tests vertices that are skinned while their joints move.
#include "lemmas/c5_skinned_motion.hpp"

#include "lemmas/c6_interval_hull.hpp"
#include "proptests/counterexamples/c5_skinned_motion.hpp"
#include "proptests/gen/chain.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_c5_skinned_motion {
namespace {

using namespace refitlab;
using gen::RationalMotion;
using gen::RationalQuaternion;
using gen::RationalVec;
using Jet = oracle::Jet<Rational>;
using Motions = std::span<const RationalMotion>;

RationalMotion bounds_of(const Moment<Rational, 3>& m) {
  return {upper_root(squared_norm(m.value)), upper_root(squared_norm(m.velocity)), upper_root(squared_norm(m.acceleration))};
}

// Draws rigid joints that turn and move, and holds what they make of a point.
struct Skin {
  std::vector<RigidTransform<Jet>> joints;
  std::vector<RationalMotion> rotations, images;
  SkinMoment<Rational> skin;
  Rational least;  // This is no more than the blend's length, and close.
  RationalVec<3> point = *gen::rational_vector<3>(), from = *gen::rational_vector<3>();
  explicit Skin(int most) : least(0) {
    const std::size_t count = 1 + gen::any_place(static_cast<std::size_t>(most));
    skin.weights = *gen::convex_weights(static_cast<int>(count));
    if (*rc::gen::inRange(0, 3) != 0)  // all of them positive
      for (auto& w : skin.weights) w = (w + Rational(1, static_cast<int>(count))) / Rational(2);
    for (std::size_t k = 0; k < count; ++k) {
      auto turn = gen::turning_quaternion();
      skin.rotations.push_back(turn.moment), rotations.push_back(turn.motion);
      joints.push_back({oracle::jets_of(turn.moment), oracle::jets_of(gen::moment_within<3>(gen::any_motion()))});
    }
    see_from(from);
    const Rational squared = squared_norm(blended<Rational, 4>(skin.weights, skin.rotations).value);
    if (squared == 0) return;
    const Rational above = upper_root(squared);
    least = above * above == squared ? above : Rational(above * Rational(999, 1000));
  }
  // Sets the images of the point, as seen from a place.
  void see_from(const RationalVec<3>& f) {
    images.clear(), skin.images.clear();
    for (const auto& joint : joints) {
      const Vec<Jet, 3> image = oracle::times<Jet>(oracle::affine_of<Jet>(joint.rotation, joint.translation), point.cast<Jet>());
      skin.images.push_back(oracle::moment_of<Rational, 3>(Vec<Jet, 3>(image - f.cast<Jet>())));
      images.push_back(bounds_of(skin.images.back()));
    }
  }
  std::vector<Jet> weights() const { return {skin.weights.begin(), skin.weights.end()}; }
  bool is_degenerate() const {
    bool still = joints.size() == 1;
    for (const auto& w : skin.weights) still = still || w == 1;
    return still;
  }
};

bool same(const Moment<Rational, 3>& a, const Moment<Rational, 3>& b) {
  return a.value == b.value && a.velocity == b.velocity && a.acceleration == b.acceleration;
}

void skinned_vertices_move_within_the_bounds(Suite& t) {
  t.holds("a vertex skinned by dual quaternions moves within the bounds, as jets say too",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const Skin s(4);
            RC_PRE(s.least > 0);
            RC_ASSERT(skin_hypotheses<Rational>(s.skin, s.images, s.rotations, s.least) == Verdict::holds);
            RC_CLASSIFY(s.is_degenerate(), "degenerate");
            const auto found = dual_moves<Rational>(s.skin, s.images, s.rotations, s.least);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_dual_moment<Rational>(s.skin, s.images, s.rotations, s.least, found.vertex) == Verdict::holds);
            const Vec<Jet, 3> twin =
                oracle::dual_quaternion<Jet>(s.joints, s.weights(), s.point.cast<Jet>()) - s.from.cast<Jet>();
            RC_ASSERT(same(found.vertex, oracle::moment_of<Rational, 3>(twin)));
          });
  t.holds("so does one by spherical blending about a fixed center, and by linear blending",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            Skin s(4);
            RC_PRE(s.least > 0);
            RC_CLASSIFY(s.is_degenerate(), "degenerate");
            s.see_from(RationalVec<3>::Zero());  // the point is the center
            const RationalVec<3> arm = *gen::rational_vector<3>();
            const Rational distance = upper_root(squared_norm(arm));
            const auto found = spherical_moves<Rational>(s.skin, arm, s.images, s.rotations, distance, s.least);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_spherical_moment<Rational>(s.skin, arm, s.images, s.rotations, distance, s.least, found.vertex) ==
                      Verdict::holds);
            const RationalVec<3> vertex = s.point + arm;
            RC_ASSERT(same(found.vertex, oracle::moment_of<Rational, 3>(oracle::spherical<Jet>(
                                             s.joints, s.weights(), s.point.cast<Jet>(), vertex.cast<Jet>()))));
            const auto linear = linear_moves<Rational>(s.skin, s.images);
            RC_ASSERT(linear.verdict == Verdict::holds);
            RC_ASSERT(same(linear.vertex,
                           oracle::moment_of<Rational, 3>(oracle::linear<Jet>(s.joints, s.weights(), s.point.cast<Jet>()))));
          });
  t.holds("what all joints do alike may be left out",
          {.form = "beyond", .number_type = "rational", .cases = 300, .degenerate_at_most = 0.6}, [] {
            // The point is seen in the frame of a rigid chain, which carries what the joints below it make of the point.
            const Skin s(3);
            RC_PRE(s.least > 0);
            RC_CLASSIFY(s.is_degenerate(), "degenerate");
            const auto turn = gen::turning_quaternion();
            const RationalMotion translation = gen::any_motion();
            const Moment<Rational, 3> moved = gen::moment_within<3>(translation);
            const auto quaternion = oracle::jets_of(turn.moment);
            std::vector<RigidTransform<Jet>> all;
            for (const auto& joint : s.joints)
              all.push_back({multiply<Jet>(quaternion, joint.rotation),
                             oracle::times<Jet>(oracle::affine_of<Jet>(quaternion, oracle::jets_of(moved)), joint.translation)});
            const auto vertex =
                oracle::moment_of<Rational, 3>(oracle::dual_quaternion<Jet>(all, s.weights(), s.point.cast<Jet>()));
            Skin seen = s;
            seen.see_from(RationalVec<3>::Zero());
            const ChainMotion<Rational> common = chain_of<Rational>({translation, turn.motion, at_rest(Rational(1))});
            const auto bounds = carried_motion(common, dual_motion<Rational>(seen.images, seen.rotations, seen.least));
            RC_ASSERT(moves_within(vertex, bounds) == Verdict::holds);
          });
}

void vertices_of_chains_are_near_their_chords(Suite& t) {
  t.holds(
      "over an interval a vertex of two joints in a chain is as near to its chord as the bounds of their channels say, "
      "by all three",
      {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_most = 0.7}, [] {
        const gen::RationalTurn outer, inner;
        const RationalVec<3> from = *gen::rational_vector<3>(), to = *gen::rational_vector<3>(),
                             bone = *gen::rational_vector<3>(), vertex = *gen::rational_vector<3>(),
                             pivot = *gen::rational_vector<3>(), none = RationalVec<3>::Zero();
        const Rational duration = *gen::unit_interval_rational() + Rational(1, 100), share = *gen::unit_interval_rational();
        const auto w = *gen::convex_weights(2);
        RC_CLASSIFY(w[0] == 1 || w[1] == 1 || share == 0 || share == 1 || (outer.rate == 0 && inner.rate == 0), "degenerate");
        const auto length = [](const RationalVec<3>& x) { return upper_root(squared_norm(x)); };
        // These are the channels' bounds, and those of the chains.
        const LinkMotion<Rational> of_outer{
            {std::max(length(from), length(to)), length(RationalVec<3>(to - from)) / duration, Rational(0)},
            outer.motion(),
            at_rest(Rational(1))},
            of_inner{at_rest(length(bone)), inner.motion(), at_rest(Rational(1))};
        const ChainMotion<Rational> first = chain_of(of_outer), second = compose(first, chain_of(of_inner));
        const auto images = [&](const RationalVec<3>& x) {
          return std::vector<RationalMotion>{carried_motion(first, at_rest(length(x))),
                                             carried_motion(second, at_rest(length(x)))};
        };
        const std::vector<RationalMotion> rotations{first.rotation, second.rotation};
        const auto joints = [&](const Rational& passed, const Rational& sign) {
          const RationalQuaternion q = outer.at(passed * duration);
          const RigidTransform<Rational> root{q, between<Rational, 3>(from, to, passed)},
              local{RationalQuaternion(inner.at(passed * duration) * sign), bone};
          return std::vector{root, compose(root, local)};
        };
        // The blend takes the shorter way, on which the cosine has a least value.
        Rational sign(1);
        const auto cosine_at = [&](const Rational& passed) {
          const auto c = joints(passed, sign);
          return Rational(dot(c[0].rotation, c[1].rotation));
        };
        if (cosine_at(Rational(0)) < 0) sign = Rational(-1);
        const Rational cosine = least_over_interval<Rational>(cosine_at(Rational(0)), cosine_at(Rational(1)),
                                                              chord_slack(product(rotations[0], rotations[1]), duration));
        RC_PRE(cosine > Rational(-99, 100));
        const Rational least = gen::lower_root(least_squared_blend<Rational>(cosine, 2));
        const auto near = [&](const auto& skinned, const RationalMotion& motion) {
          const RationalVec<3> at = skinned(joints(share, sign)), start = skinned(joints(Rational(0), sign)),
                               end = skinned(joints(Rational(1), sign));
          RC_ASSERT((is_near_chord<Rational, 3>(start, end, at, motion.acceleration, duration, share) &
                     is_near_chord_to_first_order<Rational, 3>(start, end, at, motion.speed, duration, share)) == Verdict::holds);
        };
        near([&](const auto& c) { return oracle::linear(c, w, vertex); }, widest<Rational>(images(vertex)));
        near([&](const auto& c) { return oracle::spherical(c, w, pivot, vertex); },
             spherical_motion<Rational>(images(pivot), rotations, length(RationalVec<3>(vertex - pivot)), least));
        near([&](const auto& c) { return oracle::dual_quaternion(c, w, vertex); },
             dual_motion<Rational>(images(vertex), rotations, least));
        // The point is seen in the frame of the outer joint, which turns both: the inner one alone makes the blend.
        const std::vector<RationalMotion> below{at_rest(length(vertex)),
                                                carried_motion(chain_of(of_inner), at_rest(length(vertex)))},
            turns{at_rest(Rational(1)), of_inner.rotation};
        near([&](const auto& c) { return oracle::dual_quaternion(c, w, vertex); },
             carried_motion(first, dual_motion<Rational>(below, turns, least)));
      });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const Skin s(3);
    RC_PRE(s.least > 0);
    const Rational share = *rc::gen::element(Rational(1), Rational(1, 4));
    std::vector<Vec<Rational, 4>> numbers;
    for (std::size_t k = 0; k < s.images.size(); ++k) {
      const auto& x = s.skin.images[k];
      const auto& q = s.skin.rotations[k];
      for (const auto& y : {x.value, x.velocity, x.acceleration}) numbers.push_back({0, y[0], y[1], y[2]});
      for (const auto& y : {q.value, q.velocity, q.acceleration}) numbers.push_back(y);
      const RationalMotion i = s.images[k], r = s.rotations[k];
      numbers.push_back({i.size * share, i.speed * share, i.acceleration * share, 0});
      numbers.push_back({r.size, r.speed * share, r.acceleration * share, 0});
    }
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 4>>& n, const std::vector<S>& weights, const S& least) {
          SkinMoment<S> skin{{}, {}, weights};
          std::vector<Motion<S>> images, rotations;
          for (std::size_t i = 0; i < n.size(); i += 8) {
            skin.images.push_back({imaginary(n[i]), imaginary(n[i + 1]), imaginary(n[i + 2])});
            skin.rotations.push_back({n[i + 3], n[i + 4], n[i + 5]});
            images.push_back({n[i + 6][0], n[i + 6][1], n[i + 6][2]});
            rotations.push_back({n[i + 7][0], n[i + 7][1], n[i + 7][2]});
          }
          return dual_moves<S>(skin, images, rotations, least).verdict;
        },
        numbers, s.skin.weights, s.least);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    Skin s(3);
    RC_PRE(s.least > 0);
    const RationalVec<3> arm = *gen::rational_vector<3>();
    const Rational distance = upper_root(squared_norm(arm));
    auto dual = dual_moves<Rational>(s.skin, s.images, s.rotations, s.least).vertex;
    auto spherical = spherical_moves<Rational>(s.skin, arm, s.images, s.rotations, distance, s.least).vertex;
    const auto i = static_cast<int>(gen::any_place(3));
    const Rational amount = *gen::excess();
    const std::size_t what = gen::any_place(3);
    for (auto* m : {&dual, &spherical}) (what == 0 ? m->value : what == 1 ? m->velocity : m->acceleration)[i] += amount;
    RC_ASSERT(is_dual_moment<Rational>(s.skin, s.images, s.rotations, s.least, dual) == Verdict::fails);
    RC_ASSERT(is_spherical_moment<Rational>(s.skin, arm, s.images, s.rotations, distance, s.least, spherical) == Verdict::fails);
  });
  t.holds("true moments that leave the bounds are rejected", {.number_type = "rational", .cases = 200}, [] {
    Skin s(1);
    const RationalVec<3> arm = gen::unit_direction();
    const auto dual = dual_moves<Rational>(s.skin, s.images, s.rotations, s.least).vertex;
    auto spherical = spherical_moves<Rational>(s.skin, arm, s.images, s.rotations, Rational(1), s.least).vertex;
    RC_ASSERT(is_spherical_moment<Rational>(s.skin, arm, s.images, s.rotations, Rational(1, 2), s.least, spherical) ==
              Verdict::fails);
    RC_PRE(squared_norm(dual.velocity) > 0);
    for (auto& m : s.images) m.speed = Rational(0);
    for (auto& m : s.rotations) m.speed = Rational(0);
    RC_ASSERT(is_dual_moment<Rational>(s.skin, s.images, s.rotations, s.least, dual) == Verdict::fails);
    RC_PRE(squared_norm(spherical.velocity) > 0);
    RC_ASSERT(is_spherical_moment<Rational>(s.skin, arm, s.images, s.rotations, Rational(1), s.least, spherical) ==
              Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "skinned motion needs each part of the hypotheses", {.parts = 11, .share = 0.2},
      [] {
        // Two joints at right angles or less turn alike: the blend is as short as it is said to be.
        const RationalVec<3> still = RationalVec<3>::Zero();
        const RationalVec<3> axis = gen::unit_direction(), image = gen::unit_direction();
        const RationalQuaternion a = *gen::unit_quaternion();
        Skin s(1);
        s.skin.weights = {Rational(1, 2), Rational(1, 2)};
        const auto q = gen::turning_moment(a, axis, still);
        s.skin.rotations = {q, q}, s.rotations = {circle_motion(Rational(1)), circle_motion(Rational(1))};
        s.skin.images = {{image, still, still}, {image, still, still}}, s.images = {at_rest(Rational(1)), at_rest(Rational(1))};
        s.least = Rational(1);
        const std::size_t k = gen::any_place(2);
        const Rational more = Rational(1) + *rc::gen::element(Rational(30), Rational(5));
        std::string part;
        bool asked = true;
        switch (gen::any_place(8)) {
          case 0: part = "an image's size", s.skin.images[k].value *= more * more; break;
          case 1: part = "an image's speed", s.skin.images[k].velocity = image * more; break;
          case 2: part = "an image's acceleration", s.skin.images[k].acceleration = image * Rational(more * more); break;
          case 3: part = "a quaternion's speed", s.skin.rotations[k].velocity *= more * Rational(10); break;
          case 4:
            part = "a quaternion's acceleration",
            s.skin.rotations[k].acceleration = gen::turning_moment(a, axis, axis * Rational(more * more)).acceleration;
            break;
          case 5: {
            const auto broken = gen::broken_weights(s.skin.weights);
            part = broken.part, s.skin.weights = broken.weights, asked = false;
            break;
          }
          case 6: part = "the least is not positive", s.least = Rational(0) - *gen::excess(), asked = false; break;
          default: part = "a quaternion is no unit", s.skin.rotations[k].value *= Rational(1, 2), asked = false;
        }
        const Verdict hypothesis = skin_hypotheses<Rational>(s.skin, s.images, s.rotations, s.least);
        if (!asked) return Weakening{part, hypothesis, std::nullopt};
        // The verdict is taken where it shows: in the linear blend, or in one of the turns.
        const Verdict conclusion = linear_moves<Rational>(s.skin, s.images).verdict &
                                   dual_moves<Rational>(s.skin, s.images, s.rotations, s.least).verdict &
                                   spherical_moves<Rational>(s.skin, image, s.images, s.rotations, Rational(1), s.least).verdict;
        return Weakening{part, hypothesis, conclusion};
      },
      2100);
}

void pinned_cases(Suite& t) {
  t.example("a short blend turns faster than its joints: without its length the vertex is faster than said",
            {.form = "beyond", .hypothesis = "||q|| >= m"}, [] {
              using namespace c5;
              const c5::Skin skin{{at_origin, at_origin}, {ahead, behind}, halves};
              const std::vector<Motion> images{resting, resting}, rotations{turning, turning};
              const Point arm(1, 0, 0);
              return skin_hypotheses<Q>(skin, images, rotations, length) == Verdict::holds &&
                     spherical_moves<Q>(skin, arm, images, rotations, Q(1), length).verdict == Verdict::holds &&
                     skin_hypotheses<Q>(skin, images, rotations, Q(2)) == Verdict::fails &&
                     spherical_moves<Q>(skin, arm, images, rotations, Q(1), Q(2)).verdict == Verdict::fails;
            });
  t.example("weights that change are more than the joints' motion", {.form = "beyond", .hypothesis = "the weights are convex"},
            [] {
              using namespace c5;
              const c5::Skin skin{{at_x, at_origin}, {ahead, behind}, {Q(2), Q(-1)}};
              const std::vector<Motion> images{{1, 0, 0}, resting};
              return linear_moves<Q>(skin, images).verdict == Verdict::fails;
            });
  t.example("joints that turn as fast, far apart, move a vertex within the bounds of their short blend", {.form = "beyond"}, [] {
    using namespace c5;
    const c5::Skin skin{{at_x, at_origin}, {ahead, along}, halves};
    const std::vector<Motion> images{{1, 0, 0}, {1, 0, 0}}, rotations{turning, turning};
    return dual_moves<Q>(skin, images, rotations, length).verdict == Verdict::holds;
  });
}

PROPTEST(c5_skinned_motion) {
  skinned_vertices_move_within_the_bounds(t);
  vertices_of_chains_are_near_their_chords(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c5_skinned_motion
