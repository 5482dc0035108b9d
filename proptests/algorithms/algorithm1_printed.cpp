// SPDX-License-Identifier: GPL-3.0-or-later
// Tests where Algorithm 1 as printed fails, and where it is right.
#include "algorithms/methods/refit/algorithm1_printed.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>

#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "proptests/counterexamples/algorithm1.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/refits/refit_ladder.hpp"

namespace proptests::suite_algorithm1_printed {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RefitCase;
using gen::Sample;

template <Signs signs>
struct Printed {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    RefitLists<S> lists;
    return refit_algorithm1_printed<MeanBalls>(node, signs, lists);
  }
};

struct Repaired {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    RefitLists<S> lists;
    return refit_algorithm1_repaired<MeanBalls>(node, lists);
  }
};

// Checks the theorem that the repaired algorithm is tested with. Only a certain miss counts, not a ball that is undefined.
template <Signs signs>
void check_theorem(gen::Turns turns) {
  const RefitCase c = *gen::refit_case(turns);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  oracle::RefitLadder ladder(c, Printed<signs>{});
  const Ball3<double> ball = Repaired{}(gen::NodeOf<double>(c).node());
  for (const Sample& sample : gen::samples(c, Blending::spherical, ball.center))
    if (const auto v = gen::skinned(c, sample, Blending::spherical)) RC_ASSERT(ladder.encloses(*v).verdict != Verdict::fails);
}

bool is_finite(const Ball3<double>& ball) { return ball.center.allFinite() && std::isfinite(ball.radius); }

// Checks that the printed ball misses the vertex for sure, or in double is no ball, and that the repaired one encloses it.
Checked replay(const counterexamples::PinnedRefit& pinned) {
  const Sample sample{0, pinned.weights, pinned.input.reference.center};
  const auto v = gen::skinned(pinned.input, sample, Blending::spherical);
  if (!v || admits<Rational>(pinned.input.sets[0].weights.bounds, pinned.weights) != Verdict::holds)
    return Checked(false, 1, "the pinned vertex is not admissible");
  // The printed algorithm reads the matrices; only the finding about signs needs that to fail.
  oracle::RefitLadder as_printed(pinned.input, Printed<Signs::of_matrices>{});
  oracle::RefitLadder repaired(pinned.input, Repaired{}, oracle::repaired_ball(pinned.input, oracle::Gather::at_mean));
  const bool printed_fails = pinned.undefined
                                 ? !is_finite(Printed<Signs::of_skinning>{}(gen::NodeOf<double>(pinned.input).node()))
                                 : as_printed.encloses(*v).verdict == Verdict::fails;
  return printed_fails && repaired.encloses(*v).verdict == Verdict::holds;
}

// Counts balls of nodes of a single weight vertex in floating point. In exact arithmetic their quaternions' sphere has radius 0,
// and line 13 takes the arccos of 1. The joints' rotations are products of five unit quaternions, as along a limb.
struct OneWeightVertex {
  long balls = 0, not_a_number = 0, repaired_wrong = 0;
};

template <class S>
OneWeightVertex refit_one_weight_vertex(int joints, int balls) {
  std::mt19937 random(2006);
  std::normal_distribution<double> gauss;
  const auto unit = [&] {
    const Quaternion<double> q(gauss(random), gauss(random), gauss(random), gauss(random));
    return Quaternion<S>((q / norm(q)).template cast<S>());
  };
  OneWeightVertex out;
  RefitLists<S> lists;
  const std::vector<S> weights(joints, S(1) / S(joints));
  for (; out.balls < balls; ++out.balls) {
    SkinningPalette<S> palette;
    const auto transforms = palette.append(static_cast<std::size_t>(joints));
    for (int j = 0; j < joints; ++j) {
      Quaternion<S> q = unit();
      for (int turn = 1; turn < 5; ++turn) q = multiply(q, unit());
      transforms[j].rotation = q;
    }
    make_signs_consistent(transforms);
    palette.complete(Vec<S, 3>::Zero());
    const NodePiece set{0, 0, 1};
    const RefitNode<S> node{{Vec<S, 3>(1, 2, 3), S(1)}, {&set, 1}, weights.data(), palette};
    out.not_a_number += std::isnan(refit_algorithm1_printed<MeanBalls>(node, Signs::of_skinning, lists).radius);
    const Ball3<S> repaired = refit_algorithm1_repaired<MeanBalls>(node, lists);
    const Vec<S, 3> image = blend_spherical<S>(palette[0], weights, node.reference.center);
    out.repaired_wrong += !(norm<S, 3>(repaired.center - image) < 1e-5 && repaired.radius >= 1 && repaired.radius < S(1.00001));
  }
  return out;
}

template <class S>
Checked share_not_a_number(int joints, double at_least) {
  const OneWeightVertex n = refit_one_weight_vertex<S>(joints, 100000);
  const double share = double(n.not_a_number) / double(n.balls);
  char text[80];
  std::snprintf(text, sizeof text, "%.1f %% of the printed balls are not a number", 100 * share);
  return Checked(share > at_least && n.repaired_wrong == 0, n.balls, text);
}

// Checks any unit quaternion against Eigen's conversion of its matrix. Rounding decides where it is not clear which coordinate is
// the largest, or whether the trace is positive.
void check_conversion() {
  Quaternion<double> q;
  do
    for (double& x : q) x = *gen::between(-10, 11);
  while (q.isZero());
  if (*rc::gen::inRange(0, 3) > 0) q[0] = *rc::gen::element(0, 0, 1, -1);
  if (q.isZero()) q[*rc::gen::inRange(1, 4)] = *rc::gen::element(1, -1);
  q.normalize();
  const Eigen::Matrix3d matrix = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  Eigen::Index largest;
  Eigen::Vector3d diagonal = matrix.diagonal();
  const double trace = diagonal.sum(), most = diagonal.maxCoeff(&largest);
  diagonal[largest] = -2;
  if (std::abs(trace) < 1e-9 || (trace < 0 && most - diagonal.maxCoeff() < 1e-9)) {
    RC_TAG("by rounding");
    return;
  }
  RC_TAG(trace > 0 ? "by the real part" : std::array{"by x", "by y", "by z"}[static_cast<std::size_t>(largest)]);
  const Eigen::Quaterniond usual(matrix);
  const Quaternion<double> expected(usual.w(), usual.x(), usual.y(), usual.z()), found = matrix_to_quaternion(q);
  RC_ASSERT((found - expected).norm() < 1e-12);
  RC_ASSERT(found == q || found == -q);
}

}  // namespace

PROPTEST(algorithm1_printed) {
  t.holds("a quaternion from a matrix has the sign of the usual conversion, and is else the rotation's own",
          {.number_type = "double",
           .cases = 500,
           .tags_at_least = {{"by the real part", 0.1}, {"by x", 0.1}, {"by y", 0.1}, {"by z", 0.1}}},
          check_conversion);
  for (const auto& pinned : counterexamples::algorithm1())
    t.example("the repaired ball encloses the pinned vertex, the printed one does not: " + pinned.finding,
              {.form = "printed", .number_type = "interval to exact"}, [&pinned] { return replay(pinned); });
  t.example("the pinned cap beyond 90 degrees fails with the skinning's signs too",
            {.form = "printed", .number_type = "interval to exact"}, [] {
              const auto& pinned = counterexamples::algorithm1()[0];
              oracle::RefitLadder ladder(pinned.input, Printed<Signs::of_skinning>{});
              const auto v = gen::skinned(pinned.input, {0, pinned.weights, pinned.input.reference.center}, Blending::spherical);
              return ladder.encloses(*v).verdict == Verdict::fails;
            });
  t.example("the pinned quaternions of lost sign are bounded once the skinning's signs are used",
            {.number_type = "interval to exact"}, [] {
              const auto& pinned = counterexamples::algorithm1().back();
              oracle::RefitLadder ladder(pinned.input, Printed<Signs::of_skinning>{});
              const auto v = gen::skinned(pinned.input, {0, pinned.weights, pinned.input.reference.center}, Blending::spherical);
              return ladder.encloses(*v).verdict != Verdict::fails;  // the ball is the vertex
            });
  t.refuted("the ball encloses every vertex of S with admissible weights, given the skinning's signs",
            {.form = "printed", .number_type = "interval to exact", .cases = 2000},
            [] { check_theorem<Signs::of_skinning>(gen::Turns::any); });
  t.refuted("the ball encloses every vertex of S with admissible weights, with signs of matrices, for turns up to 90 degrees",
            {.form = "printed", .number_type = "interval to exact", .cases = 2000},
            [] { check_theorem<Signs::of_matrices>(gen::Turns::moderate); });
  t.holds(
      "where any two joints of a set differ by at most 90 degrees, mean balls and the skinning's signs enclose every "
      "vertex",
      {.form = "printed", .number_type = "interval to exact", .cases = 1000, .degenerate_at_least = 0.2},
      [] { check_theorem<Signs::of_skinning>(gen::Turns::moderate); });
  t.example("in double, balls of nodes moved by one joint are often not a number; repaired never",
            {.form = "printed", .number_type = "double"}, [] { return share_not_a_number<double>(1, 0.01); });
  t.example("in float, balls of nodes moved by one joint are often not a number; repaired never",
            {.form = "printed", .number_type = "float"}, [] { return share_not_a_number<float>(1, 0.01); });
  t.example("in double, balls of nodes with equal weights of two joints are often not a number; repaired never",
            {.form = "printed", .number_type = "double"}, [] { return share_not_a_number<double>(2, 0.1); });
  t.example("in float, balls of nodes with equal weights of two joints are often not a number; repaired never",
            {.form = "printed", .number_type = "float"}, [] { return share_not_a_number<float>(2, 0.1); });
}

}  // namespace proptests::suite_algorithm1_printed
