// SPDX-License-Identifier: MIT
#include "algorithms/methods/refit/volume_variants.hpp"

#include "algorithms/methods/refit/volume_refit.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

template <class V, Skinning skinning>
Volume refit(const RefitNode<double>& node) {
  const DefaultFloatEnvironment environment;
  thread_local ControlLists<double> reused;
  return refit_volume<V, skinning>(node, reused);
}

template <class V>
Volume around(std::span<const Ball3<double>> balls) {
  const DefaultFloatEnvironment environment;
  return V::around(balls);
}

template <class V, Skinning skinning>
VolumeVariant variant(std::string name, const std::string& kind) {
  const RefitVariant& balls = default_variant(skinning);
  return {std::move(name), kind + " around the control points of " + balls.name, skinning, balls.pieces, refit<V, skinning>,
          around<V>};
}

template <Skinning skinning>
void add_variants(const std::string& prefix, std::vector<VolumeVariant>& variants) {
  variants.push_back(variant<Aabb<double>, skinning>(prefix + "aabb", "axis-aligned box"));
  variants.push_back(variant<KDop<double, 14>, skinning>(prefix + "dop14", "14-DOP"));
  variants.push_back(variant<KDop<double, 18>, skinning>(prefix + "dop18", "18-DOP"));
  variants.push_back(variant<KDop<double, 26>, skinning>(prefix + "dop26", "26-DOP"));
  variants.push_back(variant<Obb<double>, skinning>(prefix + "obb", "oriented box"));
}

std::vector<VolumeVariant> make_variants() {
  std::vector<VolumeVariant> out;
  add_variants<Skinning::spherical>("", out);
  add_variants<Skinning::linear>("linear_", out);
  add_variants<Skinning::dual_quaternion>("dual_quaternion_", out);
  return out;
}

}  // namespace

const std::vector<VolumeVariant>& volume_variants() {
  static const std::vector<VolumeVariant> variants = make_variants();
  return variants;
}

}  // namespace refitlab
