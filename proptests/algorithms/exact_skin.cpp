// SPDX-License-Identifier: GPL-3.0-or-later
// Tests ExactSkin, by which balls are judged, against matrices in rationals and against balls that end at the vertex itself.
#include "algorithms/verification/exact_skin.hpp"

#include <cmath>
#include <random>

#include "lemmas/exact/lift.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/posed_model.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_exact_skin {
namespace {

using namespace refitlab;
using RationalPoint = Vec<Rational, 3>;

struct Skinned {
  Skinned(gen::PosedModel drawn, Skinning of)
      : posed(std::move(drawn)),
        sets(posed.mesh),
        skinning(of),
        palette(make_skinning_palette(posed.mesh, sets, posed.pose, skinning)),
        exact(posed.mesh, sets, palette, skinning) {}
  gen::PosedModel posed;
  JointSets sets;
  Skinning skinning;
  SkinningPalette<double> palette;
  ExactSkin exact;
};

// Skins a vertex by matrices, which are exact rotations. This is possible for spherical blending only, where all but the blended
// quaternion is given.
RationalPoint by_matrix(const Skinned& s, int v) {
  const auto set = s.palette[s.sets.of_vertex(v)];
  Quaternion<Rational> q = Quaternion<Rational>::Zero();
  RationalPoint image = RationalPoint::Zero();
  const auto w = s.sets.weights(v);
  for (std::size_t i = 0; i < w.size(); ++i) {
    q += convert<Rational>(set.transforms[i].rotation) * Rational(w[i]);
    image += convert<Rational>(set.center_images[i]) * Rational(w[i]);
  }
  const RationalPoint arm = convert<Rational>(s.posed.mesh.vertices[v]) - convert<Rational>(set.rotation_center);
  return oracle::times<Rational>(oracle::affine_of<Rational>(q, image), arm);
}

// Checks balls about a random place, near by or so far away that the distance is rounded by more than the vertex is. The radius
// ends at the vertex, or a little before or beyond it.
void check_verdicts(Skinned& s, int v) {
  const Vec<Rational, 3> at = s.exact.exact(v);
  const double far = *rc::gen::element(1.0, 1.0, 1e4, 1e8, 1e16, 1e100);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::uniform_real_distribution<double> coordinate(-4 * far, 4 * far);
  RC_CLASSIFY(far > 1, "far");
  Ball3<double> ball{{coordinate(random), coordinate(random), coordinate(random)}, 0};
  // The center is within rounding of the vertex.
  if (*rc::gen::inRange(0, 4) == 0) ball.center = lift<double>(at);
  const double about = std::sqrt(CGAL::to_double(squared_distance<Rational, 3>(at, convert<Rational>(ball.center))));
  bool in = false, out = false;
  for (const double factor : {0.0, 0.5, 1 - 1e-9, 1 - 0x1p-52, 1.0, 1 + 0x1p-52, 1 + 1e-9, 1.5}) {
    ball.radius = about * factor;
    const bool expected = encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, at) == Verdict::holds;
    RC_ASSERT(s.exact.is_in(ball, v) == expected);
    (expected ? in : out) = true;
  }
  RC_CLASSIFY(in && out, "in and out");
  ball.radius = -1;
  RC_ASSERT(!s.exact.is_in(ball, v));
  ball.radius = NAN;
  RC_ASSERT(!s.exact.is_in(ball, v));
  ball.radius = INFINITY;
  RC_ASSERT(s.exact.is_in(ball, v));
  ball = {{0, NAN, 0}, 1e300};
  RC_ASSERT(!s.exact.is_in(ball, v));
}

// Checks boxes whose walls are at a vertex, within its last bits, or far away.
void check_boxes(Skinned& s, int v) {
  const Vec<Rational, 3> at = s.exact.exact(v);
  Box<double> box;
  bool expected = true;
  const auto wall = [&](int i, double outward) {
    const double near = lift<double>(at)[i];
    switch (*rc::gen::inRange(0, 9)) {
      case 0: return near;
      case 1: return std::nextafter(near, INFINITY);
      case 2: return std::nextafter(near, -INFINITY);
      case 3: return near + outward * 1e-7;
      case 4: return outward * INFINITY;
      default: return near + outward;
    }
  };
  for (int i = 0; i < 3; ++i) {
    box.low[i] = wall(i, -1), box.high[i] = wall(i, 1);
    expected = expected && (std::isinf(box.low[i]) || Rational(box.low[i]) <= at[i]);
    expected = expected && (std::isinf(box.high[i]) || at[i] <= Rational(box.high[i]));
  }
  RC_CLASSIFY(expected, "in");
  RC_ASSERT(s.exact.is_in(box, v) == expected);
  Box<double> beside = Box<double>::everything();
  RC_ASSERT(s.exact.is_in(beside, v));
  const int axis = *rc::gen::inRange(0, 3);
  beside.low[axis] = CGAL::to_double(at[axis]) + 1;
  RC_ASSERT(!s.exact.is_in(beside, v));
  beside.low[axis] = NAN;
  RC_ASSERT(!s.exact.is_in(beside, v));
  beside = Box<double>::everything();
  beside.high[axis] = NAN;
  RC_ASSERT(!s.exact.is_in(beside, v));
}

}  // namespace

PROPTEST(exact_skin) {
  t.holds("a vertex under spherical blending is where matrices in rationals have it", {.number_type = "rational", .cases = 100},
          [] {
            Skinned s(*gen::posed_model(), *rc::gen::element(Skinning::spherical, Skinning::hejl));
            for (int v = 0; v < static_cast<int>(s.posed.mesh.vertices.size()); ++v)
              RC_ASSERT(s.exact.exact(v) == by_matrix(s, v));
          });
  t.holds("a ball has a vertex exactly if rationals say so, to the last bit of its radius",
          {.number_type = "rational", .cases = 3000, .tags_at_least = {{"in and out", 0.7}, {"far", 0.4}}}, [] {
            const Skinning skinning = gen::drawn_skinning();
            Skinned s(*gen::posed_model(), skinning);
            check_verdicts(s, *rc::gen::inRange(0, static_cast<int>(s.posed.mesh.vertices.size())));
          });
  t.holds("a box has a vertex exactly if rationals say so, to the last bit of its walls",
          {.number_type = "rational", .cases = 300, .tags_at_least = {{"in", 0.1}}}, [] {
            Skinned s(*gen::posed_model(), *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion));
            check_boxes(s, *rc::gen::inRange(0, static_cast<int>(s.posed.mesh.vertices.size())));
          });
}

}  // namespace proptests::suite_exact_skin
