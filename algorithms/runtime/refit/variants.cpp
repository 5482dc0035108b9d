// SPDX-License-Identifier: MIT
#include "algorithms/runtime/refit/variants.hpp"

#include <stdexcept>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "algorithms/runtime/refit/control_hull.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/refit/rounding.hpp"

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

// This is flattened, because otherwise GCC at -O2 calls each product of two vectors.
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

template <Skinning skinning, Refit refit>
Ball3<double> certified_refit(const RefitNode<double>& node) {
  const DefaultFloatEnvironment environment;
  return certified<skinning>(refit(node), node);
}

template <Refit refit>
Ball3<double> refit_in_default_environment(const RefitNode<double>& node) {
  const DefaultFloatEnvironment environment;
  return refit(node);
}

template <Skinning skinning, Refit refit>
RefitVariant sound(std::string name, std::string description, Pieces pieces) {
  return {std::move(name),
          std::move(description),
          skinning,
          true,
          pieces,
          certified_refit<skinning, refit>,
          refit_in_default_environment<refit>};
}

}  // namespace

const std::vector<RefitVariant>& refit_variants() {
  using enum Skinning;
  using P = Pieces;
  static const std::vector<RefitVariant> variants{
      sound<linear, refitlab::linear<MeanBalls>>("linear", "linear blending, mean balls [Kavan and Zara 2005a]", P::node),
      sound<linear, refitlab::linear<SmallestBalls>>(
          "linear_pieces", "linear blending, a ball and a weight hull per joint-set, smallest balls", P::joint_sets),
      sound<linear, refitlab::linear<MeanBalls>>(
          "linear_pieces_mean", "linear blending, a ball and a weight hull per joint-set, mean balls", P::joint_sets),
      sound<linear, refitlab::linear<NearSmallestBalls>>(
          "linear_pieces_near", "linear blending, a ball and a weight hull per joint-set, near-smallest balls", P::joint_sets),
      sound<linear, refitlab::linear<NearSmallestBalls>>(
          "linear_mixed", "linear blending, joint-sets or their vertices as control_mixed has them, near-smallest balls",
          P::mixed),
      sound<spherical, repaired<MeanBalls>>("spherical_repaired", "Algorithm 1 repaired", P::node),
      sound<spherical, repaired<SmallestBalls>>("spherical_miniball", "Algorithm 1 repaired, with smallest balls in R4 and R3",
                                                P::node),
      sound<spherical, control<MeanBalls>>("control_mean", "control hull, mean ball", P::node),
      sound<spherical, control<SmallestBalls>>("control_miniball", "control hull, smallest ball", P::node),
      sound<spherical, control<NearSmallestBalls>>(
          "control_sets_near", "control hull, a ball and a weight hull per joint-set, near-smallest ball", P::joint_sets),
      sound<spherical, control<SmallestBalls>>(
          "control_sets_miniball", "control hull, a ball and a weight hull per joint-set, smallest ball", P::joint_sets),
      sound<spherical, control<NearSmallestBalls>>(
          "control_mixed", "control hull, or the vertices one by one where that is about as cheap, near-smallest ball", P::mixed),
      sound<spherical, control<SmallestBalls>>("control_many_pieces", "control hull, up to 512 pieces a node, smallest ball",
                                               P::many),
      sound<dual_quaternion, refitlab::dual_quaternion<MeanBalls>>("dual_quaternion_control_mean",
                                                                   "control hull of dual quaternions, mean ball", P::node),
      sound<dual_quaternion, refitlab::dual_quaternion<NearSmallestBalls>>(
          "dual_quaternion_control_near",
          "control hull of dual quaternions, a ball and a weight hull per joint-set, near-smallest ball", P::joint_sets),
      sound<dual_quaternion, refitlab::dual_quaternion<SmallestBalls>>(
          "dual_quaternion_control_miniball",
          "control hull of dual quaternions, a ball and a weight hull per joint-set, smallest ball", P::joint_sets),
      sound<dual_quaternion, refitlab::dual_quaternion<NearSmallestBalls>>(
          "dual_quaternion_mixed",
          "control hull of dual quaternions, or the vertices one by one as control_mixed has them, near-smallest ball", P::mixed),
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

const RefitVariant& variant_named(const std::string& name, const std::vector<RefitVariant>& variants) {
  std::string known;
  for (const auto& v : variants) {
    if (v.name == name) return v;
    known += (known.empty() ? "" : ", ") + v.name;
  }
  throw std::invalid_argument("no refit variant named '" + name + "'; there are: " + known);
}

const RefitVariant& refit_variant(const std::string& name) { return variant_named(name, refit_variants()); }

void check_palette(const SkinningPalette<double>& palette, const RefitVariant& variant) {
  if (!palette.is_measured()) throw std::invalid_argument("refit: the palette was filled by hand, and not measured");
  if (palette.is_affine() && variant.skinning != Skinning::linear)
    throw std::invalid_argument("refit: a palette of affine joints is for linear skinning, which " + variant.name +
                                " does not bound");
}

std::vector<Ball3<double>> refit_all(const Character& character, const RefitVariant& variant,
                                     const SkinningPalette<double>& palette) {
  check_palette(palette, variant);
  std::vector<Ball3<double>> balls;
  for (std::size_t n = 0; n < character.tree.nodes.size(); ++n)
    balls.push_back(variant.refit(character.refit_node(static_cast<int>(n), palette, variant.pieces)));
  return balls;
}

}  // namespace refitlab
