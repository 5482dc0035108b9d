// SPDX-License-Identifier: GPL-3.0-or-later
// Tests rotation centers against a stacked least-squares solution and against their neighbours.
#include "algorithms/runtime/skinning/rotation_center.hpp"

#include "lemmas/exact/lift.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/rotation_center.hpp"

namespace proptests::suite_rotation_center {
namespace {

using namespace refitlab;
using Transforms = std::vector<RigidTransform<double>>;

// Draws rotations about one axis, so that all differences leave the axis undetermined.
rc::Gen<std::vector<gen::RationalTransform>> parallel_axes() {
  const auto turn = rc::gen::pair(gen::small_integer(), gen::rational_vector<3>());
  return rc::gen::apply(
      [](const gen::RationalVec<3>& axis, const std::vector<std::pair<int, gen::RationalVec<3>>>& turns) {
        std::vector<gen::RationalTransform> out;
        for (const auto& [w, translation] : turns) {
          // q = (w, axis) turns about the axis; q^2 / |q|^2 turns twice as far and is of unit length.
          const gen::RationalQuaternion q(w, axis[0], axis[1], axis[2]);
          out.push_back({multiply(q, q) / squared_norm(q), translation});
        }
        return out;
      },
      gen::nonzero_vector<3>(), rc::gen::mapcat(rc::gen::inRange(2, 6), [turn](int n) {
        return rc::gen::container<std::vector<std::pair<int, gen::RationalVec<3>>>>(n, turn);
      }));
}

rc::Gen<std::vector<gen::RationalTransform>> any_transforms() {
  return rc::gen::weightedOneOf<std::vector<gen::RationalTransform>>({{3, gen::rigid_transforms(1, 5)}, {1, parallel_axes()}});
}

// Returns joints that differ by little, or about nearly one axis, or both: rotations of about this size about axes tilted by
// about this much against each other.
Transforms nearly_degenerate(double angle, double tilt) {
  const auto drawn = [] { return lift<double>(*gen::rational_vector<3>()); };
  const auto common = lift<double>(*gen::rigid_transform());
  const Point3 axis = lift<double>(*gen::nonzero_vector<3>()).normalized();
  Transforms out;
  for (int n = *rc::gen::inRange(2, 7); n > 0; --n) {
    const Point3 v = (axis * (1 + drawn().norm()) + drawn() * tilt) * angle;
    const Quaternion<double> turn(1, v[0], v[1], v[2]);
    out.push_back({multiply(common.rotation, Quaternion<double>(turn.normalized())), drawn()});
  }
  return out;
}

double size_of(const Transforms& transforms, const Point3& prior) {
  double size = 1 + prior.norm();
  for (const auto& c : transforms) size += c.translation.norm();
  return size;
}

}  // namespace

PROPTEST(rotation_center) {
  t.holds("it is the minimiser nearest to the prior, as a singular value decomposition finds it",
          {.number_type = "double", .degenerate_at_least = 0.3}, [] {
            const auto exact = *any_transforms();
            const Point3 prior = lift<double>(*gen::rational_vector<3>());
            const Transforms c = lift<double>(exact);
            const auto expected = oracle::rotation_center(c, prior);
            // Otherwise rounding picks the rank.
            RC_PRE(expected.nearest_to_tolerance > 0.01);
            RC_CLASSIFY(expected.rank < 3, "degenerate");
            RC_TAG("rank " + std::to_string(expected.rank));
            // The normal equations square the condition number, at most 1e3 by the tolerance.
            RC_ASSERT((rotation_center<double>(c, prior) - expected.point).norm() <= 1e-8 * size_of(c, prior));
          });
  t.holds("of small rotations and of nearly parallel axes too",
          {.number_type = "double", .cases = 5000, .degenerate_at_least = 0.3}, [] {
            const double angle = std::pow(10, -*rc::gen::inRange(0, 7)), tilt = std::pow(10, -*rc::gen::inRange(0, 7));
            const Transforms c = nearly_degenerate(angle, tilt);
            const Point3 prior = lift<double>(*gen::rational_vector<3>());
            const auto expected = oracle::rotation_center(c, prior);
            // The largest eigenvalue is taken to be 4 t, the smallest to be the determinant over t^2.
            RC_PRE(expected.nearest_to_tolerance > 0.25);
            RC_CLASSIFY(expected.rank < 3, "degenerate");
            RC_TAG("rank " + std::to_string(expected.rank));
            // The slack is for rounding, magnified by the inverses of the angles, of the weakest direction's part and of its
            // square.
            const double slack = 1e-6 / std::max(angle, 1e-4) * size_of(c, prior);
            RC_ASSERT((rotation_center<double>(c, prior) - expected.point).norm() <= slack);
          });
  t.holds("no other point has closer images", {.number_type = "double", .degenerate_at_least = 0.2}, [] {
    const Transforms c = lift<double>(*any_transforms());
    const Point3 prior = lift<double>(*gen::rational_vector<3>());
    const Point3 step = lift<double>(*gen::nonzero_vector<3>());
    const auto expected = oracle::rotation_center(c, prior);
    RC_PRE(expected.rank == 3 || expected.nearest_to_tolerance > 4);  // a neglected direction may still fall a little
    RC_CLASSIFY(expected.rank < 3, "degenerate");
    const Point3 center = rotation_center<double>(c, prior);
    const double at_center = oracle::sum_over_pairs(c, center);
    for (const double length : {1e-3, 1e-1, 1.0, 10.0})
      RC_ASSERT(oracle::sum_over_pairs(c, center + length * step) >= at_center - 1e-9 * size_of(c, prior) * size_of(c, prior));
  });
  t.holds("it moves away from the prior only in directions that the transforms determine",
          {.number_type = "double", .tags_at_least = {{"rank 0", 0.02}, {"rank 2", 0.3}}}, [] {
            const Transforms c = lift<double>(*parallel_axes());
            const Point3 prior = lift<double>(*gen::rational_vector<3>());
            const auto expected = oracle::rotation_center(c, prior);
            RC_ASSERT(expected.rank <= 2);
            RC_TAG("rank " + std::to_string(expected.rank));
            const Point3 moved = rotation_center<double>(c, prior) - prior;
            RC_ASSERT((expected.undetermined * moved).norm() <= 1e-8 * size_of(c, prior));
          });
  t.holds("of a single joint, and of equal transforms, it is the prior",
          {.number_type = "double", .cases = 300, .tags_at_least = {{"one joint", 0.1}, {"several", 0.3}}}, [] {
            const auto c = lift<double>(*gen::rigid_transform());
            const Point3 prior = lift<double>(*gen::rational_vector<3>());
            const int joints = *rc::gen::inRange(1, 5);
            RC_TAG(joints == 1 ? "one joint" : "several");
            RC_ASSERT(rotation_center<double>(Transforms(joints, c), prior) == prior);
          });
  t.holds("of two joints it is the point of the relative rotation's axis nearest to the prior",
          {.number_type = "double", .cases = 500}, [] {
            const auto parent = *gen::rigid_transform();
            const auto turn = *gen::unit_quaternion();
            const auto joint = *gen::rational_vector<3>();
            const auto prior = *gen::rational_vector<3>();
            const auto axis = imaginary(turn);
            RC_PRE(squared_norm(axis) > Rational(1, 100));
            // The child turns about the joint that both share, so the axis goes through the joint.
            const gen::RationalTransform child = compose(parent, {turn, joint - rotate(turn, joint)});
            RC_ASSERT(apply(child, joint) == apply(parent, joint));
            const auto nearest = joint + axis * (dot<Rational, 3>(prior - joint, axis) / squared_norm(axis));
            const Transforms c{lift<double>(parent), lift<double>(child)};
            RC_ASSERT((rotation_center<double>(c, lift<double>(prior)) - lift<double, 3>(nearest)).norm() <=
                      1e-8 * size_of(c, lift<double>(prior)));
          });
}

}  // namespace proptests::suite_rotation_center
