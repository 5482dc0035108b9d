// SPDX-License-Identifier: GPL-3.0-or-later
// The axis-aligned box is the k-DOP of k = 6, whose suite tests it; here is what boxes alone have.
#include "algorithms/methods/volumes/aabb.hpp"

#include "proptests/gen/ball_lists.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_aabb {
namespace {

using namespace refitlab;
using gen::RationalVec;

}  // namespace

PROPTEST(aabb) {
  const Options options{.number_type = "rational", .cases = 300, .degenerate_at_least = 0.4};
  Options of_two = options;
  of_two.tags_at_least = {{"share a point", 0.17}, {"share none", 0.17}};
  t.holds("two boxes overlap only if they share a point", of_two, [] {
    const auto list_a = *gen::ball_list();
    auto list_b = *gen::ball_list();
    RC_CLASSIFY(list_a.is_degenerate || list_b.is_degenerate, "degenerate");
    const RationalVec<3> by = gen::hull_point(list_a.balls) - gen::hull_point(list_b.balls) + *gen::rational_vector<3>();
    for (auto& ball : list_b.balls) ball.center += by;
    const auto a = Aabb<Rational>::around(list_a.balls), b = Aabb<Rational>::around(list_b.balls);
    RationalVec<3> shared;
    for (int i = 0; i < 3; ++i) shared[i] = max_of(a.low[i], b.low[i]);
    const Verdict both = a.contains(shared) & b.contains(shared);
    RC_TAG(both == Verdict::holds ? "share a point" : "share none");
    RC_ASSERT(a.overlaps(b) == both);
  });
  t.holds("the volume is the product of the edges", options, [] {
    const auto list = *gen::ball_list();
    RC_CLASSIFY(list.is_degenerate, "degenerate");
    const auto box = Aabb<Rational>::around(list.balls);
    Rational product(1);
    for (int i = 0; i < 3; ++i) product *= box.high[i] - box.low[i];
    RC_ASSERT(box.volume() == product);
  });
  t.example("the box of two balls, face by face", {.number_type = "rational"}, [] {
    const gen::RationalBalls balls{{{1, 2, 3}, Rational(1, 2)}, {{5, -1, 3}, 2}};
    const auto box = Aabb<Rational>::around(balls);
    return box.low[0] == Rational(1, 2) && box.high[0] == 7 && box.low[1] == -3 && box.high[1] == Rational(5, 2) &&
           box.low[2] == 1 && box.high[2] == 5;
  });
}

}  // namespace proptests::suite_aabb
