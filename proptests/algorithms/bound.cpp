// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the search for a certificate's bound, on balls that hold and on balls that do not. It must find one for the least ball
// that the bounds to be tried prove, computed anew, and none for a smaller ball.
#include "algorithms/certificate/bound.hpp"

#include <cmath>
#include <limits>

#include "algorithms/runtime/refit/control_hull.hpp"
#include "proptests/gen/skinned_piece.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/bounds.hpp"

namespace proptests::suite_bound {
namespace {

using namespace refitlab;
using By = Bound::By;
using gen::SkinnedPiece;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int halvings = most_halvings + 3;

double random_number(std::mt19937& random) { return std::normal_distribution<double>(0, 1)(random); }

oracle::BlendsAtWeightVertices weight_vertices_of(const SkinnedPiece& piece) {
  return oracle::blend_at_weight_vertices(piece.palette, piece.weight_vertices, piece.reference.center, piece.skinning);
}

// Returns the least radius about the center for which a bound is found.
double least_radius(const SkinnedPiece& piece, const Vec<double, 3>& center) {
  if (piece.skinning == Skinning::linear)
    return oracle::needed_radius_linear(piece.palette, piece.weight_vertices, piece.reference, center);
  return piece.reference.radius + oracle::least_found_radius(weight_vertices_of(piece), center, halvings);
}

// Says whether the bound proves the ball, by the oracle's own computation.
bool proves(const SkinnedPiece& piece, const Bound& bound, const Ball3<double>& ball, double margin) {
  if (piece.skinning == Skinning::linear)
    return bound.by == By::control && least_radius(piece, ball.center) <= ball.radius + margin;
  return oracle::needed_radius(weight_vertices_of(piece), bound, ball.center) + piece.reference.radius <= ball.radius + margin;
}

std::optional<Bound> found(const SkinnedPiece& piece, const Ball3<double>& ball) {
  return find_bound(piece.node(), 0, piece.skinning, ball);
}

const char* name_of(By by) {
  switch (by) {
    case By::control: return "control";
    case By::cap: return "cap";
    case By::all_rotations: return "all rotations";
    case By::reach: return "reach";
    default: return "halves";
  }
}

// Returns the least ball about a center among the images, or far from them, where any image may be the farthest.
Ball3<double> ball_to_try(const SkinnedPiece& piece, std::mt19937& random) {
  Ball3<double> out{{0, 0, 0}, 0};
  const double far = std::array{0., 0.1, 1., 30.}[std::uniform_int_distribution<int>(0, 3)(random)];
  for (int i = 0; i < 3; ++i) out.center[i] = far * random_number(random);
  if (std::uniform_int_distribution<int>(0, 1)(random) && piece.skinning == Skinning::spherical)
    out.center += piece.palette.center_images[0];
  out.radius = least_radius(piece, out.center);
  return out;
}

void check_least_radius(Skinning skinning, int most_weight_vertices) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const SkinnedPiece piece(random, skinning, most_weight_vertices);
  Ball3<double> ball = ball_to_try(piece, random);
  RC_CLASSIFY(piece.weight_vertices.size() == 1, "degenerate");
  if (piece.has_relation) {  // It is not specified which of several equally wide edges is halved.
    RC_TAG("exact relation");
    for (const double radius : {0.5, 1., 2., 4., 8., 1e9})
      if (const auto bound = found(piece, {ball.center, radius}))
        RC_ASSERT(proves(piece, *bound, {ball.center, radius}, 1e-9 * radius));
    return;
  }
  // Some blend is 0, or so near to 0 that double cannot tell.
  if (!(ball.radius < 1e4)) {
    if (ball.radius == infinity) {
      RC_TAG("no bound");
      RC_ASSERT(!found(piece, {ball.center, 1e9}));
    }
    return;
  }
  const double margin = 1e-9 * (1 + ball.radius + ball.center.norm());
  const auto bound = found(piece, {ball.center, ball.radius + margin});
  RC_ASSERT(bound.has_value());
  RC_TAG(name_of(bound->by));
  RC_ASSERT(proves(piece, *bound, {ball.center, ball.radius + margin}, margin / 2));
  RC_ASSERT(!found(piece, {ball.center, ball.radius - margin}));
  const double share = std::uniform_real_distribution<double>(0, 1)(random);
  RC_ASSERT(!found(piece, {ball.center, share * (ball.radius - margin)}));
}

// Checks that hints are those of the refits: what they prove at once is not left to control points, nor to halves.
void check_first_tried(Skinning skinning) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const SkinnedPiece piece(random, skinning, 5);
  const Ball3<double> ball = ball_to_try(piece, random);
  for (const Bound& first : oracle::first_tried(weight_vertices_of(piece))) {
    const double radius = piece.reference.radius + oracle::needed_radius(weight_vertices_of(piece), first, ball.center);
    if (piece.has_relation || !(radius < 1e4)) continue;
    const auto bound = found(piece, {ball.center, radius + 1e-9 * (1 + radius + ball.center.norm())});
    RC_ASSERT(bound.has_value());
    RC_ASSERT(bound->by == By::cap || bound->by == By::all_rotations || bound->by == By::reach);
  }
}

// --- The least radius is a double: it is found exactly, and no bound is found one ulp below ---

OwnedPaletteEntry<double> palette_of(std::vector<Quaternion<double>> rotations) {
  OwnedPaletteEntry<double> out;
  for (const auto& q : rotations) {
    out.transforms.push_back({q, {0, 0, 0}});
    out.center_images.push_back({0, 0, 0});
    out.duals.push_back({0, 0, 0, 0});
  }
  return out;
}

bool is_edge(const SkinnedPiece& piece, const Ball3<double>& ball, By by) {
  const auto at = found(piece, ball);
  return at && at->by == by && !found(piece, {ball.center, std::nextafter(ball.radius, 0)});
}

}  // namespace

PROPTEST(bound) {
  const Options options{.number_type = "double against rational", .cases = 150, .degenerate_at_least = 0.05};
  t.holds("linear blending: found for the least ball, and for no smaller one", options,
          [] { check_least_radius(Skinning::linear, 6); });
  t.holds("spherical blending: found for the least ball, and for no smaller one", options,
          [] { check_least_radius(Skinning::spherical, 4); });
  t.holds("dual quaternions: found for the least ball, and for no smaller one", options,
          [] { check_least_radius(Skinning::dual_quaternion, 4); });
  t.example("where the least radius is a double, it is found there and not one ulp below", {}, [] {
    const Quaternion<double> one{1, 0, 0, 0}, left{2, 1, 0, 0}, right{2, -1, 0, 0}, two{2, 0, 0, 0};
    const std::vector<std::vector<double>> single{{1}}, both{{1, 0}, {0, 1}};
    auto moved = palette_of({one, one});
    moved.center_images[1] = {12, 0, 0};
    auto translated = moved;
    translated.transforms[1].translation = {12, 0, 0};
    auto dual = palette_of({one, one});
    dual.duals[1] = {0, 6, 0, 0};
    const bool linear = is_edge({Skinning::linear, translated, both, {{0, 0, 0}, 1}}, {{0, 5, 0}, 14}, By::control);
    const bool longer = is_edge({Skinning::linear, palette_of({two}), single, {{0, 0, 0}, 1}}, {{0, 0, 0}, 7}, By::control);
    const bool any = is_edge({Skinning::spherical, moved, both, {{0, 0, 0}, 1}}, {{0, 5, 0}, 14}, By::all_rotations);
    const bool cap = is_edge({Skinning::spherical, palette_of({left, right}), both, {{0, 0, 5}, 1}}, {{0, 0, 3}, 5}, By::cap);
    const bool reach = is_edge({Skinning::dual_quaternion, palette_of({one}), single, {{3, 4, 0}, 1}}, {{0, 0, 0}, 6}, By::reach);
    const bool mixed = is_edge({Skinning::dual_quaternion, dual, both, {{0, 0, 0}, 1}}, {{0, 5, 0}, 14}, By::control);
    return Checked(linear && longer && any && cap && reach && mixed, 6,
                   std::to_string(linear) + std::to_string(longer) + std::to_string(any) + std::to_string(cap) +
                       std::to_string(reach) + std::to_string(mixed));
  });
  t.holds("spherical blending: caps are tried first, about both axes", {.cases = 150},
          [] { check_first_tried(Skinning::spherical); });
  t.holds("dual quaternions: the reach is tried first, about the mean image", {.cases = 150},
          [] { check_first_tried(Skinning::dual_quaternion); });
  t.example("weight vertices at a right angle have no control points before they are halved", {}, [] {
    for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
      const SkinnedPiece piece(skinning, palette_of({{1, 0, 0, 0}, {0, 1, 0, 0}}), {{1, 0}, {0, 1}}, {{0, 0, 1}, 0});
      const auto bound = found(piece, {{10, 0, 0}, 10.5});
      if (!bound || bound->by != By::halves) return false;
    }
    return true;
  });
  t.example("a weight vertex behind the axis, or at a right angle to it, has no cap and no reach", {}, [] {
    for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion})
      for (const Quaternion<double>& last : {Quaternion<double>{-1, 0, 0, 0}, {-2, 0, 0, 0}, {-2, 1, 0, 0}}) {
        const std::vector<std::vector<double>> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const SkinnedPiece piece(skinning, palette_of({{1, 0, 0, 0}, {1, 0, 0, 0}, last}), all, {{0, 0, 3}, 1});
        if (found(piece, {{0, 0, 3}, 1.5})) return false;
      }
    const SkinnedPiece zero(Skinning::spherical, palette_of({{1, 0, 0, 0}, {0, 0, 0, 0}}), {{1, 0}, {0, 1}}, {{3, 0, 0}, 1});
    return !found(zero, {{3, 0, 0}, 1.5}) && found(zero, {{0, 0, 0}, 4})->by == By::all_rotations;
  });
  t.example("weight vertices so long that their mean overflows have no axis, and no error", {}, [] {
    const SkinnedPiece piece(Skinning::dual_quaternion, palette_of({{1.5e308, 0, 0, 0}, {1.5e308, 1e300, 0, 0}}),
                             {{1, 0}, {0, 1}}, {{0, 0, 0}, 1});
    return found(piece, {{0, 0, 0}, 2}).has_value();
  });
  t.example("a ball smaller than the reference ball is found nothing, and one as large is", {}, [] {
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      const SkinnedPiece piece(skinning, palette_of({{1, 0, 0, 0}}), {{1}}, {{0, 0, 0}, 1});
      if (!found(piece, {{0, 0, 0}, 1}) || found(piece, {{0, 0, 0}, std::nextafter(1, 0)}) || found(piece, {{0, 0, 0}, 0}) ||
          found(piece, {{0, 0, 0}, -2}))
        return false;
    }
    return true;
  });
}

}  // namespace proptests::suite_bound
