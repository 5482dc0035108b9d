#include "algorithms/refit/variants.hpp"

#include <stdexcept>

#include "algorithms/refit/algorithm1_printed.hpp"
#include "algorithms/refit/algorithm1_repaired.hpp"
#include "algorithms/refit/control_hull.hpp"
#include "algorithms/refit/dual_quaternion.hpp"
#include "algorithms/refit/linear.hpp"

namespace refitlab {
namespace {

RefitLists<double>& lists() {
  thread_local RefitLists<double> reused;
  return reused;
}

ControlLists<double>& control_lists() {
  thread_local ControlLists<double> reused;
  return reused;
}

// Flattened, as otherwise GCC at -O2 calls each product of two vectors.
template <class Policy, Signs signs>
[[gnu::flatten]] Ball3<double> printed(const RefitNode<double>& node) {
  return refit_algorithm1_printed<Policy>(node, signs, lists());
}
template <class Policy>
[[gnu::flatten]] Ball3<double> linear(const RefitNode<double>& node) {
  return refit_linear<Policy>(node, control_lists());
}
template <class Policy>
[[gnu::flatten]] Ball3<double> control(const RefitNode<double>& node) {
  return refit_control_hull<Policy>(node, control_lists());
}
template <class Policy>
[[gnu::flatten]] Ball3<double> dual_quaternion(const RefitNode<double>& node) {
  return refit_dual_quaternion<Policy>(node, control_lists());
}
template <class Policy>
[[gnu::flatten]] Ball3<double> repaired(const RefitNode<double>& node) {
  return refit_algorithm1_repaired<Policy>(node, lists());
}

}  // namespace

const std::vector<RefitVariant>& refit_variants() {
  using enum Skinning;
  using P = Pieces;
  static const std::vector<RefitVariant> variants{
      {"linear", "linear blending, mean balls [Kavan and Zara 2005a]", linear, true, P::node, refitlab::linear<MeanBalls>},
      {"linear_pieces", "linear blending, a ball and a weight hull per joint-set, smallest balls", linear, true, P::joint_sets,
       refitlab::linear<SmallestBalls>},
      {"linear_pieces_mean", "linear blending, a ball and a weight hull per joint-set, mean balls", linear, true,
       P::joint_sets, refitlab::linear<MeanBalls>},
      {"linear_pieces_near", "linear blending, a ball and a weight hull per joint-set, near-smallest balls", linear, true,
       P::joint_sets, refitlab::linear<NearSmallestBalls>},
      {"linear_mixed", "linear blending, joint-sets or their vertices as control_mixed has them, near-smallest balls", linear,
       true, P::mixed, refitlab::linear<NearSmallestBalls>},
      {"spherical_printed", "Algorithm 1 as printed", spherical, false, P::node, printed<MeanBalls, Signs::of_matrices>},
      {"spherical_printed_signed", "Algorithm 1 as printed, but with the skinning's quaternion signs", spherical, false, P::node,
       printed<MeanBalls, Signs::of_skinning>},
      {"spherical_printed_exact", "the same with smallest balls in R4 and R3", spherical, false, P::node,
       printed<SmallestBalls, Signs::of_skinning>},
      {"spherical_repaired", "Algorithm 1 repaired", spherical, true, P::node, repaired<MeanBalls>},
      {"spherical_exact", "Algorithm 1 repaired, with smallest balls in R4 and R3", spherical, true, P::node,
       repaired<SmallestBalls>},
      {"control_mean", "control hull, mean ball", spherical, true, P::node, control<MeanBalls>},
      {"control_exact", "control hull, smallest ball", spherical, true, P::node, control<SmallestBalls>},
      {"control_sets_near", "control hull, a ball and a weight hull per joint-set, near-smallest ball", spherical, true,
       P::joint_sets, control<NearSmallestBalls>},
      {"control_sets_exact", "control hull, a ball and a weight hull per joint-set, smallest ball", spherical, true,
       P::joint_sets, control<SmallestBalls>},
      {"control_mixed", "control hull, or the vertices one by one where that is about as cheap, near-smallest ball",
       spherical, true, P::mixed, control<NearSmallestBalls>},
      {"control_clusters", "control hull, up to 512 pieces a node, smallest ball", spherical, true, P::clusters,
       control<SmallestBalls>},
      {"dual_quaternion_control_mean", "control hull of dual quaternions, mean ball", dual_quaternion, true, P::node,
       refitlab::dual_quaternion<MeanBalls>},
      {"dual_quaternion_control_near",
       "control hull of dual quaternions, a ball and a weight hull per joint-set, near-smallest ball", dual_quaternion,
       true, P::joint_sets, refitlab::dual_quaternion<NearSmallestBalls>},
      {"dual_quaternion_control_exact",
       "control hull of dual quaternions, a ball and a weight hull per joint-set, smallest ball", dual_quaternion, true,
       P::joint_sets, refitlab::dual_quaternion<SmallestBalls>},
      {"dual_quaternion_mixed",
       "control hull of dual quaternions, or the vertices one by one as control_mixed has them, near-smallest ball",
       dual_quaternion, true, P::mixed, refitlab::dual_quaternion<NearSmallestBalls>},
  };
  return variants;
}

const RefitVariant& default_variant(Skinning skinning) {
  switch (skinning) {
    case Skinning::linear: return refit_variant("linear_mixed");
    case Skinning::dual_quaternion: return refit_variant("dual_quaternion_mixed");
    default: return refit_variant("control_mixed");
  }
}

const RefitVariant& refit_variant(const std::string& name) {
  std::string known;
  for (const auto& v : refit_variants()) {
    if (v.name == name) return v;
    known += (known.empty() ? "" : ", ") + v.name;
  }
  throw std::invalid_argument("no refit variant named '" + name + "'; there are: " + known);
}

}  // namespace refitlab
