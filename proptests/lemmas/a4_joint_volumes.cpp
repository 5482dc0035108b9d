// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that volumes that joints carry, grown by radii, hold linearly skinned vertices.
#include "lemmas/a4_joint_volumes.hpp"

#include "proptests/counterexamples/a4_joint_volumes.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_a4_joint_volumes {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Volumes = std::vector<CarriedVolume<Rational>>;

Rational lack(const Volumes& volumes, const std::vector<Rational>& w) {
  Rational sum(0);
  for (std::size_t k = 0; k < volumes.size(); ++k) sum += lack_of_growth(w[k], volumes[k].distance, volumes[k].growth);
  return sum;
}

// Draws a vertex and the volumes of one to five joints, which grow exactly as much as the inequality requires, or more.
struct VolumesCase {
  Volumes volumes;
  std::vector<Rational> w;
  RationalVec<3> vertex = *gen::rational_vector<3>();
  bool is_tight = *rc::gen::arbitrary<bool>();
  VolumesCase() {
    const std::size_t count = 1 + gen::any_place(5);
    w = *gen::convex_weights(static_cast<int>(count));
    for (std::size_t k = 0; k < count; ++k) {
      const auto joint = *gen::rigid_transform();
      const RationalVec<3> point = gen::any_place(8) == 0 ? vertex : *gen::rational_vector<3>();
      const Rational distance = upper_root(squared_norm<Rational, 3>(vertex - point));
      volumes.push_back({joint, point, distance, Rational(2) * *gen::unit_interval_rational() * distance});
    }
    // One joint with a weight gets what lacks, or all get as much.
    const Rational more = lack(volumes, w) + (is_tight ? Rational(0) : Rational(*gen::excess()));
    const std::size_t k = gen::any_place(w.size());
    if (more <= 0 && !is_tight) return;
    if (w[k] > 0 && volumes[k].growth + more / w[k] >= 0) volumes[k].growth += more / w[k];
    else
      for (auto& volume : volumes) volume.growth += more;
  }
  // Says whether fewer than two joints matter.
  bool is_degenerate() const {
    int matter = 0;
    for (std::size_t k = 0; k < w.size(); ++k) matter += w[k] > 0 && volumes[k].distance > 0;
    return matter < 2;
  }
};

RationalVec<3> unit_direction() { return rotate<Rational>(*gen::unit_quaternion(), RationalVec<3>(0, 0, 1)); }

// Draws the pose of (iii): the turn of each joint takes the vector from its point to the vertex to the common direction.
struct OpposedCase {
  Volumes volumes;
  std::vector<Rational> w;
  RationalVec<3> vertex = *gen::rational_vector<3>(), direction = unit_direction();
  OpposedCase() {
    const auto count = 1 + gen::any_place(4);
    w = *gen::convex_weights(static_cast<int>(count));
    for (std::size_t k = 0; k < count; ++k) {
      RigidTransform<Rational> joint;
      joint.rotation = *gen::unit_quaternion();
      const Rational distance = *gen::positive_rational(), growth = Rational(2) * *gen::unit_interval_rational() * distance;
      const RationalVec<3> point = vertex - rotate<Rational>(conjugate(joint.rotation), RationalVec<3>(direction * distance));
      joint.translation = -direction * growth - rotate<Rational>(joint.rotation, point);
      volumes.push_back({joint, point, distance, growth});
    }
  }
};

void vertices_are_in_the_hull_of_grown_volumes(Suite& t) {
  t.holds("a vertex is in the ball of the mean growth about the mean of the carried points",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const VolumesCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(c.is_tight, "no more than asked");
            RC_ASSERT(volumes_hypotheses<Rational>(c.volumes, c.w, c.vertex) == Verdict::holds);
            const auto found = stays_in_mean_ball<Rational>(c.volumes, c.w, c.vertex);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_vertex_among<Rational>(c.volumes, c.w, c.vertex, found.beside) == Verdict::holds);
            std::vector<gen::RationalTransform> joints;
            for (const auto& k : c.volumes) joints.push_back(k.joint);
            RC_ASSERT((skinned_among<Rational>(c.volumes, c.w, c.vertex)) == (oracle::linear<Rational>(joints, c.w, c.vertex)));
          });
  t.holds("no direction shows it beyond all grown volumes",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const VolumesCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(stays_below_reach<Rational>(c.volumes, c.w, c.vertex, unit_direction()) == Verdict::holds);
          });
  t.holds("in some pose it is beyond them just if the mean growth is less than the mean distance",
          {.form = "beyond", .number_type = "rational", .cases = 400, .tags_at_least = {{"less", 0.2}, {"enough", 0.2}}}, [] {
            const OpposedCase c;
            const bool is_enough = lack(c.volumes, c.w) <= 0;
            RC_TAG(is_enough ? "enough" : "less");
            RC_ASSERT(volumes_hypotheses<Rational>(c.volumes, c.w, c.vertex) == verdict_of(is_enough));
            RC_ASSERT(reach_along<Rational>(c.volumes, c.direction) == 0);
            RC_ASSERT(stays_below_reach<Rational>(c.volumes, c.w, c.vertex, c.direction) == verdict_of(is_enough));
          });
  t.refuted("it is enough that the volume of one of its joints has the vertex", {.number_type = "rational"}, [] {
    VolumesCase c;
    c.volumes[0].point = c.vertex, c.volumes[0].distance = Rational(0);
    RC_ASSERT(stays_with_its_own_joint<Rational>(c.volumes, c.w, c.vertex, unit_direction()) == Verdict::holds);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const VolumesCase c;
    const auto& k = c.volumes[0];
    const Rational growth = k.growth * *rc::gen::element(Rational(1), Rational(1, 3));
    decide_by_all(
        []<class S>(const Quaternion<S>& q, const Vec<S, 3>& translation, const Vec<S, 3>& point, const S& distance,
                    const S& growth, const Vec<S, 3>& vertex) {
          const RigidTransform<S> joint{q, translation};
          const std::vector volumes{CarriedVolume<S>{joint, point, distance, growth}};
          const std::vector<S> w{S(1)};
          return stays_in_mean_ball<S>(volumes, w, vertex).verdict;
        },
        k.joint.rotation, k.joint.translation, k.point, k.distance, growth, c.vertex);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const VolumesCase c;
    auto beside = stays_in_mean_ball<Rational>(c.volumes, c.w, c.vertex).beside;
    const std::size_t k = gen::any_place(beside.size() + 1);
    if (k == beside.size()) beside.pop_back();
    else beside[k][static_cast<int>(gen::any_place(3))] += *gen::excess();
    RC_ASSERT(is_vertex_among<Rational>(c.volumes, c.w, c.vertex, beside) == Verdict::fails);
  });
  t.holds("a true witness of distances or growths that are too small is rejected", {.number_type = "rational", .cases = 300}, [] {
    OpposedCase c;
    const auto beside = stays_in_mean_ball<Rational>(c.volumes, c.w, c.vertex).beside;
    RC_ASSERT(is_vertex_among<Rational>(c.volumes, c.w, c.vertex, beside) == verdict_of(lack(c.volumes, c.w) <= 0));
    const std::size_t k = gen::any_place(c.w.size());
    RC_PRE(c.w[k] > 0);
    c.volumes[k].distance *= Rational(999, 1000);
    RC_ASSERT(is_vertex_among<Rational>(c.volumes, c.w, c.vertex, beside) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "the hull needs each part of the hypotheses", {.parts = 8, .share = 0.2},
      [] {
        OpposedCase c;
        for (auto& k : c.volumes) k.growth = k.distance;
        for (auto& k : c.volumes) k.joint.translation = -c.direction * k.growth - rotate<Rational>(k.joint.rotation, k.point);
        std::string part;
        bool asked = true;
        const std::size_t k = gen::any_place(c.w.size());
        switch (gen::any_place(6)) {
          case 0: {
            part = "the inequality";
            const Rational share = Rational(1) - *gen::unit_interval_rational();
            RC_PRE(c.w[k] > 0 && share > 0);
            c.volumes[k].growth -= share * c.volumes[k].distance;
            c.volumes[k].joint.translation += c.direction * (share * c.volumes[k].distance);
            break;
          }
          case 1:
            part = "the distance";
            c.vertex += rotate<Rational>(conjugate(c.volumes[k].joint.rotation), c.direction) * Rational(*gen::excess());
            asked = c.volumes.size() == 1;
            break;
          case 2: part = "the distance is negative", c.volumes[k].distance = -c.volumes[k].distance, asked = false; break;
          default: {
            const auto broken = gen::broken_weights(c.w);
            part = broken.part, c.w = broken.weights, asked = false;
          }
        }
        return Weakening{
            part, volumes_hypotheses<Rational>(c.volumes, c.w, c.vertex),
            asked ? std::optional(stays_below_reach<Rational>(c.volumes, c.w, c.vertex, c.direction)) : std::nullopt};
      },
      1200);
}

void pinned_cases(Suite& t) {
  t.example("a vertex in the volume of its own joint is pulled out of it by another", {}, [] {
    using namespace a4;
    return stays_with_its_own_joint<Q>(pulled(0), weights, vertex, ahead) == Verdict::fails &&
           skinned_among<Q>(pulled(0), weights, vertex)[0] == 1;
  });
  t.example("grown by 1 they hold it, by less they do not", {.form = "beyond", .hypothesis = "sum w_k d_k <= sum w_k r_k"}, [] {
    using namespace a4;
    const Q less(99, 100);
    return volumes_hypotheses<Q>(pulled(1), weights, vertex) == Verdict::holds &&
           stays_below_reach<Q>(pulled(1), weights, vertex, ahead) == Verdict::holds &&
           volumes_hypotheses<Q>(pulled(less), weights, vertex) == Verdict::fails &&
           stays_below_reach<Q>(pulled(less), weights, vertex, ahead) == Verdict::fails;
  });
  t.example("a vertex farther from its point than said gets out", {.form = "beyond", .hypothesis = "||v - p_k|| <= d_k"}, [] {
    using namespace a4;
    auto volumes = pulled(1);
    const Point farther(1, 0, 0);
    return volumes_hypotheses<Q>(volumes, weights, farther) == Verdict::fails &&
           stays_below_reach<Q>(volumes, weights, farther, ahead) == Verdict::fails;
  });
}

PROPTEST(a4_joint_volumes) {
  vertices_are_in_the_hull_of_grown_volumes(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_a4_joint_volumes
