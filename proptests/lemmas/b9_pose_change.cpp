// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b9_pose_change.hpp"

#include "proptests/counterexamples/b9_pose_change.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_b9_pose_change {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Span = std::span<const Rational>;
using Transform = RigidTransform<Rational>;
using Transforms = std::vector<Transform>;
using Points = std::vector<RationalVec<3>>;
using Bounds = PoseChangeBounds<Rational>;

const RationalQuaternion no_turn(1, 0, 0, 0);

// Draws a rotation whose quaternion is no farther than the root of room from that of no turn.
RationalQuaternion small_turn(const Rational& room) {
  RationalQuaternion q = *gen::unit_quaternion();
  while (squared_distance<Rational, 4>(q, no_turn) > room) q = gen::drawn_in(q);
  return q;
}

// Returns the transform with this rotation that carries the point to the image.
Transform carrying(const RationalQuaternion& rotation, const RationalVec<3>& point, const RationalVec<3>& image) {
  return {rotation, RationalVec<3>(image - rotate<Rational>(rotation, point))};
}

// Returns the least bounds of a change, but for the rounding of their roots.
Bounds least_bounds(const Transforms& old, const Transforms& now, const RationalVec<3>& point) {
  Rational turn(0), moved(0);
  for (std::size_t k = 0; k < old.size(); ++k) {
    turn = std::max(turn, squared_distance<Rational, 4>(now[k].rotation, old[k].rotation));
    moved = std::max(moved, squared_distance<Rational, 3>(apply(now[k], point), apply(old[k], point)));
  }
  return {gen::least_cosine(old), upper_root(turn), upper_root(moved),
          upper_root(squared_spread(images_of<Rational>(old, point)))};
}

// Joints in two poses. Some do not turn, some leave the image of the point where it is, and most do neither.
struct PoseCase {
  Transforms old, now;
  RationalVec<3> point = *gen::rational_vector<3>(), vertex = *gen::rational_vector<3>();
  std::vector<Rational> weights;
  Bounds bounds;
  PoseCase(int least, int most) {
    old = *gen::rigid_transforms(least, most);
    gen::draw_together(old, Rational(1, 2));
    const Rational cosine = gen::least_cosine(old),
                   size = *rc::gen::element(Rational(1), Rational(1), Rational(1, 10), Rational(1, 10), Rational(0));
    const bool turns = gen::any_place(8) != 0;
    for (const auto& t : old) {
      const RationalQuaternion turn = turns ? small_turn(sq(cosine) / Rational(8)) : no_turn;
      const RationalVec<3> moved = *gen::rational_vector<3>() * size, image = apply(t, point) + moved;
      now.push_back(carrying(multiply(turn, t.rotation), point, image));
    }
    weights = *gen::convex_weights(static_cast<int>(old.size()));
    if (gen::any_place(3) == 0) vertex = point;
    measure();
  }
  void measure() {
    bounds = least_bounds(old, now, point);
    if (gen::any_place(4) == 0) bounds.cosine = std::max(Rational(2) * bounds.turn, Rational(bounds.cosine * Rational(9, 10)));
  }
  // Moves the joints of the new pose to where this center is least-squares: all carry it to one image, or two of them to images
  // that are apart along the axis about which they turn against one another.
  void center_at(const RationalVec<3>& center) {
    const RationalVec<3> image = apply(now[0], center);
    for (auto& t : now) t = carrying(t.rotation, center, image);
    if (now.size() == 2)
      now[1].translation += imaginary<Rational>(multiply(now[0].rotation, conjugate(now[1].rotation))) * *gen::rational();
    measure();
  }
  Verdict hypotheses() const { return is_pose_change(old, now, bounds, point) & is_convex(u()); }
  Rational share() const { return upper_root(squared_deviation_share(bounds.cosine_after())); }
  Span u() const { return weights; }
  bool is_degenerate() const { return old.size() == 1 || bounds.turn == 0 || bounds.moved == 0 || bounds.spread == 0; }
};

void formulas_are_those_of_the_statement(Suite& t) {
  const auto are_right = []<class S>(const S& one) {
    const S half = one / S(2);
    return moved_at_most<S>(one, half, S(3)) == S(4) && cosine_after_change<S>(one, half / S(2)) == half &&
           spread_after_change<S>(one, S(4), half) == S(3) && growth_by_change<S>(one, half, S(8)) == S(5) &&
           growth_of_bound<S>(half, S(3), S(5), one / S(8), S(4)) == half + S(15) + half * half && has_sharp_share<S>(one) &&
           !has_sharp_share<S>(half);
  };
  t.example("1 + 2 / 2 3 = 4, 1 - 2 / 4 = 1 / 2, 1 + 4 / 2 = 3, 1 + 8 / 2 = 5 and 1 / 2 + 3 5 + 4 / 2 / 8, in each number type",
            {}, [&] { return are_right(Rational(1)) && are_right(1.0) && are_right(1.0F); });
}

void points_move_within_the_bound(Suite& t) {
  t.holds(
      "a point moves by no more than the anchor does and by what the quaternion turns",
      {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.04, .degenerate_at_most = 0.6}, [] {
        const Transform old = *gen::rigid_transform();
        const bool is_near = *rc::gen::arbitrary<bool>();
        Transform now = *gen::rigid_transform();
        if (is_near) now.rotation = multiply(small_turn(Rational(1, 100)), old.rotation);
        const RationalVec<3> anchor = *gen::rational_vector<3>(), point = *gen::rational_vector<3>();
        const Rational turn = upper_root(squared_distance<Rational, 4>(now.rotation, old.rotation));
        RC_CLASSIFY(turn == 0 || anchor == point, "degenerate");
        RC_CLASSIFY(is_near, "near");
        RC_ASSERT(turns_at_most(old.rotation, now.rotation, turn) == Verdict::holds);
        const auto found = moved_point(old, now, turn, anchor, point);
        RC_ASSERT(found.verdict == Verdict::holds);
        RC_ASSERT(is_moved_point(old, now, turn, anchor, point, found) == Verdict::holds);
        const auto before = oracle::affine_of(old.rotation, old.translation),
                   after = oracle::affine_of(now.rotation, now.translation);
        const RationalVec<3> from = oracle::times(before, point), to = oracle::times(after, point),
                             sum = found.anchor + found.turned;
        RC_ASSERT(sum == to - from);
        const Rational anchor_moved =
                           upper_root(squared_distance<Rational, 3>(oracle::times(after, anchor), oracle::times(before, anchor))),
                       to_anchor = upper_root(squared_distance<Rational, 3>(point, anchor));
        RC_ASSERT(moves_little(from, to, anchor_moved, turn, to_anchor) == Verdict::holds);
        const RationalVec<3> none(0, 0, 0);
        RC_ASSERT(moves_little<Rational>(none, found.turned, 0, turn, to_anchor) == Verdict::holds);
      });
  t.holds("a turn about an axis across x moves it by e sqrt(4 - e^2) ||x||",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const RationalQuaternion old = *gen::unit_quaternion(),
                                     turn = small_turn(*rc::gen::element(Rational(4), Rational(1, 100))),
                                     now = multiply(turn, old);
            const RationalVec<3> across = cross<Rational>(imaginary(turn), *gen::rational_vector<3>()),
                                 x = rotate(conjugate(old), across);
            const Rational squared = squared_distance<Rational, 4>(now, old);
            const Rational moved = squared_distance<Rational, 3>(rotate(now, x), rotate(old, x));
            RC_ASSERT(moved == squared * (Rational(4) - squared) * squared_norm(x));
            // A turn that is said to be smaller is judged by just that.
            const Transform before{old, *gen::rational_vector<3>()}, after{now, *gen::rational_vector<3>()};
            const RationalVec<3> anchor = *gen::rational_vector<3>(), point = anchor + x;
            const Rational said = upper_root(squared) * *rc::gen::element(Rational(9, 10), Rational(1, 2), Rational(1));
            const bool is_enough = moved <= Rational(4) * sq(said) * squared_norm(x);
            RC_ASSERT(moved_point(before, after, said, anchor, point).verdict == verdict_of(is_enough));
          });
}

void images_spread_within_the_bound(Suite& t) {
  t.holds("hull and spread of the images grow by no more than the statement says",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const std::size_t count = 1 + gen::any_place(5);
            Points old, now;
            Rational moved(0);
            for (std::size_t k = 0; k < count; ++k) {
              old.push_back(*gen::rational_vector<3>());
              now.push_back(old.back() + *gen::rational_vector<3>() * *rc::gen::element(Rational(1), Rational(1, 10)));
              moved = std::max(moved, squared_distance<Rational, 3>(now[k], old[k]));
            }
            const auto u = *gen::convex_weights(static_cast<int>(count));
            const Rational most = upper_root(moved), spread = upper_root(squared_spread(old));
            RC_CLASSIFY(count == 1 || most == 0 || spread == 0, "degenerate");
            for (std::size_t k = 0; k < count; ++k) RC_ASSERT(moves_at_most(old[k], now[k], most) == Verdict::holds);
            RC_ASSERT(spreads_at_most(old, spread) == Verdict::holds);
            RC_ASSERT(hull_moves_little(old, now, most, Span(u)) == Verdict::holds);
            RC_ASSERT(spread_grows_little(now, spread, most) == Verdict::holds);
            RC_ASSERT(squared_spread(now) <= sq(Rational(spread + Rational(static_cast<int>(count)) * most)));
          });
  t.holds("half of the images that go one way and half that go the other reach it",
          {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
            const std::size_t half = 1 + gen::any_place(4);
            const RationalVec<3> middle = *gen::rational_vector<3>();
            const Rational height = *gen::positive_rational(), moved = *gen::positive_rational();
            const RationalVec<3> way = rotate<Rational>(*gen::unit_quaternion(), RationalVec<3>(1, 0, 0));
            Points old, now;
            for (std::size_t k = 0; k < 2 * half; ++k) {
              const Rational side(k < half ? 1 : -1);
              old.push_back(middle + way * (side * height)), now.push_back(old.back() + way * (side * moved));
            }
            const Rational count(static_cast<int>(2 * half)), spread = count * height;
            RC_ASSERT(squared_spread(old) == sq(spread));
            RC_ASSERT(squared_spread(now) == sq(spread_after_change(spread, count, moved)));
            RC_ASSERT(spread_grows_little(now, spread, Rational(moved * Rational(999, 1000))) == Verdict::fails);
          });
}

void cosines_fall_within_the_bound(Suite& t) {
  t.holds("cosines fall by no more than the quaternions turn, whatever the signs of skinning",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.05}, [] {
            const RationalQuaternion a = *gen::unit_quaternion(), b = *gen::unit_quaternion();
            const Rational room = *rc::gen::element(Rational(4), Rational(1), Rational(1, 100));
            const bool turns = gen::any_place(8) != 0;
            const RationalQuaternion a_now = turns ? multiply(small_turn(room), a) : a,
                                     b_now = turns ? multiply(small_turn(room), b) : b;
            const Rational turn = upper_root(
                               std::max(squared_distance<Rational, 4>(a_now, a), squared_distance<Rational, 4>(b_now, b))),
                           sign = *rc::gen::element(Rational(1), Rational(-1));
            const Rational cosine = sign * dot(a, b);
            RC_CLASSIFY(turn == 0, "degenerate");
            const RationalQuaternion signed_now = b_now * sign;
            RC_ASSERT(cosine_falls_little(a_now, signed_now, cosine, turn) == Verdict::holds);
            RC_ASSERT(dot(a_now, signed_now) >= cosine - Rational(2) * turn);
          });
  t.holds("quaternions at a right angle that turn away from each other come as near to it as their chords to their arcs",
          {.form = "beyond", .number_type = "rational", .cases = 100}, [] {
            // Both turn by an angle of the sine s: the cosine falls by 2 s c, and e^2 = 2 - 2 c, so that the share is at least c.
            const Rational tangent = *gen::positive_rational() / Rational(1000),
                           scale = Rational(1) / (Rational(1) + sq(tangent));
            const Rational s = Rational(2) * tangent * scale, c = (Rational(1) - sq(tangent)) * scale;
            RC_PRE(c > 0);
            const RationalQuaternion a_now(c, -s, 0, 0), b_now(-s, c, 0, 0);
            const Rational turn = upper_root(Rational(2) - Rational(2) * c);
            RC_ASSERT(cosine_falls_little(a_now, b_now, Rational(0), turn) == Verdict::holds);
            RC_ASSERT(cosine_falls_little(a_now, b_now, Rational(0), Rational(turn * c * Rational(999, 1000))) == Verdict::fails);
          });
}

// Draws a number from 0 to most, either end now and then.
Rational up_to(const Rational& most) {
  const int parts = 1000, part = gen::any_place(8) == 0 ? *rc::gen::element(0, parts) : *gen::between(0, parts + 1);
  return most * Rational(part, parts);
}

void shares_grow_within_the_bound(Suite& t) {
  t.holds("the share of the cosine that is left is at most those of the old one and of the turn together",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.05, .degenerate_at_most = 0.6},
          [] {
            // c and 2 e, with c - 2 e >= 3/5.
            const Rational lost = up_to(Rational(2, 5)), turns = up_to(Rational(2, 5) - lost), cosine = Rational(1) - lost,
                           after = cosine_after_change(cosine, Rational(turns / Rational(2)));
            RC_CLASSIFY(lost == 0 || turns == 0, "degenerate");
            RC_TAG(after == Rational(3, 5) ? "at 3/5" : "above 3/5");
            RC_ASSERT(has_sharp_share(after));
            const Rational share = upper_root(squared_deviation_share(cosine)),
                           of_turn = upper_root(squared_deviation_share(Rational(Rational(1) - turns)));
            RC_ASSERT(is_deviation_share(share, cosine) == Verdict::holds);
            RC_ASSERT(is_deviation_share(of_turn, Rational(Rational(1) - turns)) == Verdict::holds);
            RC_ASSERT(share_grows_little(after, share, of_turn) == Verdict::holds);
            // The same as the statement writes it.
            const Rational x = lost + turns;
            RC_ASSERT(x / Rational(8) + Rational(5) * sq(x) / Rational(64) <= sq(Rational(share + of_turn)));
            // If either is 0, nothing is lost.
            if ((lost == 0 || turns == 0) && x > 0)
              RC_ASSERT(share_grows_little(after, Rational(share * Rational(99, 100)), Rational(of_turn * Rational(99, 100))) ==
                        Verdict::fails);
          });
  t.example("of smaller cosines it may be more", {.form = "beyond", .hypothesis = "c - 2 e >= 3/5"}, [] {
    using namespace b9;
    return has_sharp_share(at_the_jump) && !has_sharp_share(beyond_the_jump) &&
           is_deviation_share(share_at_the_jump, at_the_jump) == Verdict::holds &&
           is_deviation_share(share_of_the_step, Q(Q(1) - (at_the_jump - beyond_the_jump))) == Verdict::holds &&
           share_grows_little(beyond_the_jump, share_at_the_jump, share_of_the_step) == Verdict::fails;
  });
}

// Asserts that the image of the vertex in the new pose is as the lemma says of the old one.
void assert_stays_near(const PoseCase& c, const DeviatedVertex<Rational>& in_new_pose, const RationalVec<3>& image,
                       const Rational& share) {
  const auto found = vertex_after_change(c.old, c.bounds, c.point, c.u(), c.vertex, in_new_pose);
  RC_ASSERT(found.verdict == Verdict::holds);
  RC_ASSERT(is_vertex_after_change(c.old, c.bounds, c.point, c.u(), c.vertex, found) == Verdict::holds);
  const RationalVec<3> sum = found.carried + found.moved + found.turned + found.deviated;
  RC_ASSERT(sum == image);
  const Rational arm = upper_root(squared_distance<Rational, 3>(c.vertex, c.point));
  RC_ASSERT(stays_near_old_hull(c.old, c.bounds, share, c.point, c.u(), image, arm) == Verdict::holds);
  // The same as the statement writes it.
  const Rational n(static_cast<int>(c.old.size())), most = arm + c.bounds.moved + share * (c.bounds.spread + n * c.bounds.moved);
  RC_ASSERT(squared_norm(RationalVec<3>(image - found.carried)) <= sq(most));
  if (!has_sharp_share(c.bounds.cosine_after())) return;
  RC_TAG("of a sharp share");
  const Rational none(0),
      before = share == 0 ? none : upper_root(squared_deviation_share(c.bounds.cosine)),
      of_turn = share == 0 ? none : upper_root(squared_deviation_share(Rational(Rational(1) - Rational(2) * c.bounds.turn)));
  RC_ASSERT(stays_in_grown_bound(c.old, c.bounds, {before, of_turn, share}, c.point, c.u(), image, arm) == Verdict::holds);
  const Rational no_more =
      arm + before * c.bounds.spread + c.bounds.moved + of_turn * c.bounds.spread + share * n * c.bounds.moved;
  RC_ASSERT(squared_norm(RationalVec<3>(image - found.carried)) <= sq(no_more));
}

void skinned_vertices_stay_near_the_old_hull(Suite& t) {
  const Options options{
      .form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2, .degenerate_at_most = 0.8};
  t.holds("dual quaternions leave a vertex near the old hull", options, [] {
    const PoseCase c(1, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    RC_ASSERT(c.hypotheses() == Verdict::holds);
    RC_ASSERT(is_deviation_share(c.share(), c.bounds.cosine_after()) == Verdict::holds);
    RC_ASSERT(are_within(c.now, c.bounds.cosine_after()) == Verdict::holds);
    assert_stays_near(c, dual_quaternion_deviation(c.now, c.bounds.cosine_after(), c.point, c.u(), c.vertex),
                      oracle::dual_quaternion(c.now, c.weights, c.vertex), c.share());
  });
  t.holds("so does spherical blending about a center that is least-squares in the new pose", options, [] {
    PoseCase c(1, 4);
    const RationalVec<3> center = *gen::rational_vector<3>();
    c.center_at(center);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    RC_ASSERT(is_least_squares_center(c.now, center) == Verdict::holds);
    RC_ASSERT(c.hypotheses() == Verdict::holds);
    assert_stays_near(c, spherical_deviation(c.now, c.bounds.cosine_after(), center, c.point, c.u(), c.vertex),
                      oracle::spherical(c.now, c.weights, center, c.vertex), c.share());
  });
  t.holds("spherical blending about the point itself does without a share", options, [] {
    const PoseCase c(1, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    assert_stays_near(c, spherical_deviation(c.now, c.bounds.cosine_after(), c.point, c.point, c.u(), c.vertex),
                      oracle::spherical(c.now, c.weights, c.point, c.vertex), Rational(0));
  });
  t.holds("linear blending does without a share too, and the old box grown by d holds the vertex", options, [] {
    const PoseCase c(1, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const auto split = linear_deviation(c.now, c.point, c.u(), c.vertex);
    RC_ASSERT(split.verdict == Verdict::holds);
    const RationalVec<3> image = oracle::linear(c.now, c.weights, c.vertex);
    assert_stays_near(c, split, image, Rational(0));
    if (c.vertex == c.point)
      RC_ASSERT(is_in_grown_box(images_of<Rational>(c.old, c.point), c.bounds.moved, image) == Verdict::holds);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const PoseCase c(1, 3);
    const Rational spread = c.bounds.spread * *rc::gen::element(Rational(1), Rational(1, 1000)),
                   moved = c.bounds.moved * *rc::gen::element(Rational(1), Rational(1, 2));
    decide_by_all(
        []<class S>(const std::vector<RigidTransform<S>>& old, const std::vector<RigidTransform<S>>& now, const S& cosine,
                    const S& turn, const S& moved, const S& spread, const Vec<S, 3>& point, const std::vector<S>& u,
                    const Vec<S, 3>& vertex) {
          const PoseChangeBounds<S> bounds{cosine, turn, moved, spread};
          const std::span<const S> weights(u);
          const auto after = dual_quaternion_deviation<S>(now, bounds.cosine_after(), point, weights, vertex);
          return is_pose_change<S>(old, now, bounds, point) &
                 vertex_after_change<S>(old, bounds, point, weights, vertex, after).verdict;
        },
        c.old, c.now, c.bounds.cosine, c.bounds.turn, moved, spread, c.point, c.weights, c.vertex);
  });
  t.holds("mutated witnesses are rejected, each part by itself", {.number_type = "rational", .cases = 400}, [] {
    const PoseCase c(1, 4);
    const auto good = vertex_after_change(c.old, c.bounds, c.point, c.u(), c.vertex,
                                          dual_quaternion_deviation(c.now, c.bounds.cosine_after(), c.point, c.u(), c.vertex));
    const auto rejected = [&](const VertexAfterChange<Rational>& w) {
      return is_vertex_after_change(c.old, c.bounds, c.point, c.u(), c.vertex, w) == Verdict::fails;
    };
    const Rational amount = *gen::excess(), n(static_cast<int>(c.old.size()));
    auto carried = good, moved = good, turned = good, deviated = good;
    const int axis = static_cast<int>(gen::any_place(3));
    const auto along = [&](const Rational& length) {
      RationalVec<3> v(0, 0, 0);
      v[axis] = length;
      return v;
    };
    carried.carried[axis] += amount;
    moved.moved = along(c.bounds.moved + amount);
    turned.turned = along(upper_root(squared_distance<Rational, 3>(c.vertex, c.point)) + amount);
    deviated.deviated = along(c.share() * (c.bounds.spread + n * c.bounds.moved) * Rational(33, 32) + amount);
    RC_ASSERT(rejected(carried) && rejected(moved) && rejected(turned) && rejected(deviated));
    // All are accepted up to their edges.
    moved.moved = along(c.bounds.moved), turned.turned = good.turned, carried.carried = good.carried;
    RC_ASSERT(!rejected(moved) && !rejected(turned) && !rejected(carried));
  });
  t.holds("of how a point moves, each part of a witness is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    const Transform old = *gen::rigid_transform(), now = *gen::rigid_transform();
    const RationalVec<3> anchor = *gen::rational_vector<3>(), point = *gen::rational_vector<3>();
    const Rational turn = upper_root(squared_distance<Rational, 4>(now.rotation, old.rotation));
    const auto good = moved_point(old, now, turn, anchor, point);
    const auto rejected = [&](const MovedPoint<Rational>& w) {
      return is_moved_point(old, now, turn, anchor, point, w) == Verdict::fails;
    };
    RationalVec<3> wrong(0, 0, 0);
    wrong[static_cast<int>(gen::any_place(3))] = *gen::excess();
    auto other_anchor = good, other_turn = good, both = good;
    other_anchor.anchor += wrong, other_turn.turned += wrong, both.anchor += wrong, both.turned -= wrong;
    RC_ASSERT(!rejected(good) && rejected(other_anchor) && rejected(other_turn) && rejected(both));
    RC_ASSERT(moved_point(old, now, Rational(0), anchor, point).verdict == verdict_of(squared_norm(good.turned) == 0));
  });
}

// Draws three joints that do not change but for one. What is wrong of that one is the only part of the hypothesis that fails.
Weakening one_joint_is_wrong() {
  PoseCase c(3, 3);
  c.now = c.old, c.measure();
  const std::size_t k = gen::any_place(3), kind = gen::any_place(6);
  const std::string which = gen::place(k, 3);
  const auto refused = [&] { return is_pose_change(c.old, c.now, c.bounds, c.point) & is_convex(c.u()); };
  RC_ASSERT(refused() == Verdict::holds);
  if (kind < 4) {
    Transforms& pose = kind < 2 ? c.old : c.now;
    pose[k].rotation *= kind % 2 == 0 ? Rational(1001, 1000) : Rational(999, 1000);
    c.bounds = least_bounds(c.old, c.now, c.point);
    return {which + (kind % 2 == 0 ? " is too long in " : " is too short in ") + (kind < 2 ? "the old pose" : "the new pose"),
            refused(),
            {}};
  }
  if (kind == 4) {
    RationalQuaternion turn = small_turn(sq(c.bounds.cosine) / Rational(8));
    if (turn == no_turn) turn = {Rational(399, 401), Rational(40, 401), 0, 0};
    c.now[k] = carrying(multiply(turn, c.old[k].rotation), c.point, apply(c.old[k], c.point));
    const Rational truly = upper_root(squared_distance<Rational, 4>(turn, no_turn));
    c.bounds.turn = truly * *rc::gen::element(Rational(0), Rational(1, 2), Rational(9, 10));
    // The farther point is across the axis.
    const RationalVec<3> across = cross<Rational>(imaginary(turn), *gen::nonzero_vector<3>()),
                         arm = rotate(conjugate(c.old[k].rotation), across);
    return {which + " turns farther", refused(),
            moved_point(c.old[k], c.now[k], c.bounds.turn, c.point, RationalVec<3>(c.point + arm)).verdict};
  }
  const Rational moved = *gen::positive_rational();
  c.now[k].translation[static_cast<int>(gen::any_place(3))] += moved;
  c.bounds.moved = moved / (Rational(1) + *gen::excess());
  std::vector<Rational> alone(3, Rational(0));
  alone[k] = 1;
  return {
      which + " moves the point farther", refused(),
      hull_moves_little(images_of<Rational>(c.old, c.point), images_of<Rational>(c.now, c.point), c.bounds.moved, Span(alone))};
}

// Two joints that turn about the x axis by opposite angles, whose half is the angle of the cosine and the sine. The image of a
// point off the axis then deviates as far as b7_motion_bound allows. at_rest is the same images without a turn.
struct Bulge {
  Rational cosine, sine, radius = *gen::positive_rational();
  RationalVec<3> point{0, radius, 0};
  Transforms turned, at_rest;
  std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)};
  Bulge() {
    const Rational tangent = *rc::gen::element(Rational(1, 5), Rational(1, 7), Rational(1, 10)),
                   scale = Rational(1) / (Rational(1) + sq(tangent));
    cosine = (Rational(1) - sq(tangent)) * scale, sine = Rational(2) * tangent * scale;
    const RationalVec<3> away = *gen::rational_vector<3>();
    for (const int side : {1, -1}) turned.push_back({{cosine, sine * Rational(side), 0, 0}, away});
    for (const auto& t : turned) at_rest.push_back(carrying(no_turn, point, apply(t, point)));
  }
  Rational of_both() const { return sq(cosine) - sq(sine); }
  Rational spread() const { return Rational(4) * sine * cosine * radius; }
};

Weakening one_bound_is_wrong() {
  Bulge b;
  Transforms old = b.turned, now = b.turned;
  Bounds bounds{b.of_both(), 0, 0, b.spread()};
  auto u = b.halves;
  std::string part;
  bool asked = true;
  const Rational excess = *gen::excess();
  switch (gen::any_place(12)) {
    case 0: part = "the cosine is greater than theirs", bounds.cosine += excess; break;
    case 1: part = "the turn is negative", bounds.turn = -excess; break;
    case 2:
      part = "the turn is less than theirs", old = b.at_rest, bounds.cosine = 1;
      bounds.turn = upper_root(Rational(2) - Rational(2) * b.cosine) * *rc::gen::element(Rational(0), Rational(1, 2));
      break;
    case 3: part = "the move is negative", bounds.moved = -excess; break;
    case 4:
      part = "the move is less than theirs", bounds.moved = Rational(1) / (Rational(1) + excess);
      for (auto& t : now) t.translation[1] += Rational(1);
      break;
    case 5:
      part = "the spread is negative", bounds.spread = -b.spread();
      bounds.moved = b.spread() * *rc::gen::element(Rational(1, 2), Rational(1, 4));
      for (auto& t : now) t.translation[2] += bounds.moved;
      break;
    case 6: part = "the spread is less than theirs", bounds.spread = b.spread() / (Rational(1) + excess); break;
    case 7:
      part = "the cosine that is left is negative";
      old = {{no_turn, {0, 0, 0}}, {{0, 1, 0, 0}, {0, 0, 0}}};
      now = {old[0], carrying({-b.cosine, b.sine, 0, 0}, b.point, -b.point)};
      bounds = {0, upper_root(Rational(2) - Rational(2) * b.sine), 0, Rational(2) * b.radius};
      break;
    case 8: part = "the counts differ", now.pop_back(), asked = false; break;
    default: {
      const auto broken = gen::broken_weights(u);
      part = broken.part, u = broken.weights, asked = !part.ends_with("negative");
      for (auto* pose : {&old, &now})
        for (auto& t : *pose) t.translation[1] += Rational(100'000);
    }
  }
  const Verdict hypothesis = is_pose_change(old, now, bounds, b.point) & is_convex(Span(u));
  if (!asked) return {part, hypothesis, {}};
  RC_PRE(blend_has_image(dual_blend(now, b.point), Span(u)) == Verdict::holds);
  const auto after = dual_quaternion_deviation(now, bounds.cosine_after(), b.point, Span(u), b.point);
  return {part, hypothesis, vertex_after_change(old, bounds, b.point, Span(u), b.point, after).verdict};
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(t, "each joint is looked at by itself, in both poses", {.parts = 18, .share = 0.2}, one_joint_is_wrong, 1000);
  needs_each_part(t, "each bound of a change is needed", {.parts = 13, .share = 0.2}, one_bound_is_wrong, 1200);
  t.holds("the hypotheses hold up to their edges", {.number_type = "rational", .cases = 200}, [] {
    const Bulge b;
    const Rational least = upper_root(Rational(2) - Rational(2) * b.cosine), excess = *gen::excess();
    const auto is_change = [&](const Bounds& bounds) { return is_pose_change(b.at_rest, b.turned, bounds, b.point); };
    RC_ASSERT(is_change({1, least, 0, b.spread()}) == Verdict::holds);
    RC_ASSERT(is_change({Rational(2) * least, least, 0, b.spread()}) == Verdict::holds);
    RC_ASSERT(is_change({Rational(2) * least - excess, least, 0, b.spread()}) == Verdict::fails);
    RC_ASSERT(is_deviation_share(Rational(0), Rational(1)) == Verdict::holds);
    RC_ASSERT(is_deviation_share(Rational(1, 4), Rational(3, 5)) == Verdict::holds);
    RC_ASSERT(is_deviation_share(Rational(-1, 4), Rational(3, 5)) == Verdict::fails);
    RC_ASSERT(is_deviation_share(Rational(Rational(1, 4) / (Rational(1) + excess)), Rational(3, 5)) == Verdict::fails);
  });
}

void grown_bounds_need_each_share(Suite& t) {
  t.holds("a bound that was blown up holds a vertex that is raised from rest, and does not without the share of the turn",
          {.form = "beyond", .number_type = "rational", .cases = 100}, [] {
            Bulge b;
            const Rational tangent = Rational(1, 100 + static_cast<int>(gen::any_place(100))),
                           scale = Rational(1) / (Rational(1) + sq(tangent));
            b.cosine = (Rational(1) - sq(tangent)) * scale, b.sine = Rational(2) * tangent * scale;
            for (std::size_t k = 0; k < 2; ++k) b.turned[k].rotation = {b.cosine, k == 0 ? b.sine : -b.sine, 0, 0};
            for (std::size_t k = 0; k < 2; ++k) b.at_rest[k] = carrying(no_turn, b.point, apply(b.turned[k], b.point));
            const Bounds bounds{1, upper_root(Rational(2) - Rational(2) * b.cosine), 0, b.spread()};
            RC_ASSERT(is_pose_change(b.at_rest, b.turned, bounds, b.point) == Verdict::holds);
            RC_ASSERT(has_sharp_share(bounds.cosine_after()));
            const Rational share = upper_root(squared_deviation_share(bounds.cosine_after())), none(0);
            const RationalVec<3> image = oracle::dual_quaternion(b.turned, b.halves, b.point);
            const auto stays = [&](const Rational& before, const Rational& of_turn) {
              return stays_in_grown_bound(b.at_rest, bounds, {before, of_turn, share}, b.point, Span(b.halves), image, none);
            };
            RC_ASSERT(stays(none, share) == Verdict::holds);
            RC_ASSERT(stays(none, none) == Verdict::fails);
            // Nor does it matter which of both has the share.
            RC_ASSERT(stays(share, none) == Verdict::holds);
          });
  t.holds("a joint that only moves carries a vertex to the edge of such a bound",
          {.form = "beyond", .number_type = "rational", .cases = 100}, [] {
            const Transform old = *gen::rigid_transform();
            Transform now = old;
            const Rational moved = *gen::positive_rational(), none(0);
            now.translation[static_cast<int>(gen::any_place(3))] += moved;
            const RationalVec<3> point = *gen::rational_vector<3>();
            const std::vector<Rational> whole{Rational(1)};
            const auto stays = [&](const Rational& by) {
              return stays_in_grown_bound<Rational>({old}, {1, 0, by, 0}, {none, none, none}, point, Span(whole),
                                                    apply(now, point), none);
            };
            RC_ASSERT(stays(moved) == Verdict::holds && stays(Rational(moved * Rational(999, 1000))) == Verdict::fails);
          });
}

void pinned_cases_without_a_hypothesis(Suite& t) {
  const auto leaves_without = [&t](const std::string& hypothesis, const std::string& sentence, const Transforms& old,
                                   const Transforms& now, const Bounds& bounds) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      const Span u(b9::halves);
      const auto after = dual_quaternion_deviation(now, bounds.cosine_after(), b9::y_axis, u, b9::y_axis);
      return is_pose_change(old, now, bounds, b9::y_axis) == Verdict::fails &&
             vertex_after_change(old, bounds, b9::y_axis, u, b9::y_axis, after).verdict == Verdict::fails;
    });
  };
  leaves_without("the cosine is no greater than theirs", "a greater cosine promises too much", b9::opposed, b9::opposed,
                 b9::at_one);
  leaves_without("A(f) is no greater than said", "images that are farther apart than said deviate farther", b9::opposed,
                 b9::opposed, b9::closer);
  leaves_without("||q'_k - q_k|| <= e", "joints that turn farther than said raise the vertex", b9::still, b9::opposed,
                 b9::at_one);
  leaves_without("||C'_k f - C_k f|| <= d", "images that move farther than said carry the vertex away", b9::still, b9::gone_on,
                 b9::at_one);
  leaves_without("c - 2 e >= 0", "where a quaternion may come to take the long way round, a vertex deviates too far",
                 b9::half_a_turn, b9::long_way, b9::long_way_bounds);
}

void pinned_cases(Suite& t) {
  t.example("joints that turn in opposite directions leave both images where they are, and raise the vertex between them",
            {.form = "beyond", .hypothesis = "blending is linear"}, [] {
              using namespace b9;
              const Span u(halves);
              const auto images = images_of<Q>(still, y_axis);
              if (images != images_of<Q>(opposed, y_axis) || images != Points{upper, lower}) return false;
              const Point before = oracle::dual_quaternion(still, halves, y_axis),
                          after = oracle::dual_quaternion(opposed, halves, y_axis);
              const Q share = upper_root(squared_deviation_share(opposed_bounds.cosine_after()));
              return is_pose_change(still, opposed, opposed_bounds, y_axis) == Verdict::holds && before == origin &&
                     squared_norm(after) == bulge * bulge && after[1] * after[1] == bulge * bulge &&
                     is_in_grown_box(images, opposed_bounds.moved, before) == Verdict::holds &&
                     is_in_grown_box(images, opposed_bounds.moved, after) == Verdict::fails &&
                     stays_near_old_hull(still, opposed_bounds, Q(0), y_axis, u, after, Q(0)) == Verdict::fails &&
                     stays_near_old_hull(still, opposed_bounds, share, y_axis, u, after, Q(0)) == Verdict::holds;
            });
  t.example("the old box holds it if it is grown by what the vertex is raised", {}, [] {
    const auto images = images_of<Rational>(b9::still, b9::y_axis);
    const b9::Point after = oracle::dual_quaternion(b9::opposed, b9::halves, b9::y_axis), top(0, 0, Rational(1));
    return is_in_grown_box(images, b9::bulge, after) == Verdict::holds &&
           is_in_grown_box(images, Rational(1, 13), top) == Verdict::holds &&
           is_in_grown_box(images, Rational(1, 14), top) == Verdict::fails &&
           is_in_grown_box(images, Rational(1, 14), b9::Point(-top)) == Verdict::fails;
  });
  t.example("a turn moves x by more than its quaternion moves, so (i) needs its factor of 2", {.form = "beyond"}, [] {
    using namespace b9;
    const Point moved = rotate(far_turn, x_axis);
    return squared_distance<Q, 4>(far_turn, identity) == far_turn_squared && sq(far_turn_length) > far_turn_squared &&
           turns_at_most(identity, far_turn, far_turn_length) == Verdict::holds &&
           squared_distance<Q, 3>(moved, x_axis) > sq(far_turn_length) &&
           moves_little<Q>(x_axis, moved, 0, far_turn_length, 1) == Verdict::holds;
  });
  t.example("two quaternions that turn away from each other lose more than one of them turns, so (iii) needs its factor of 2",
            {.form = "beyond"}, [] {
              using namespace b9;
              return turns_at_most(first, first_now, turn) == Verdict::holds &&
                     turns_at_most(second, second_now, turn) == Verdict::holds && dot(first, second) == apart &&
                     dot(first_now, second_now) == apart_now && apart_now < apart - turn &&
                     cosine_falls_little(first_now, second_now, apart, turn) == Verdict::holds;
            });
}

PROPTEST(b9_pose_change) {
  formulas_are_those_of_the_statement(t);
  points_move_within_the_bound(t);
  images_spread_within_the_bound(t);
  cosines_fall_within_the_bound(t);
  shares_grow_within_the_bound(t);
  skinned_vertices_stay_near_the_old_hull(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  reaches_share(t, "cases of several joints that turn, move and are apart", 0.2, [] { return !PoseCase(1, 4).is_degenerate(); });
  grown_bounds_need_each_share(t);
  pinned_cases_without_a_hypothesis(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b9_pose_change
