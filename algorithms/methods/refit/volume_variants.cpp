// SPDX-License-Identifier: MIT
#include "algorithms/methods/refit/volume_variants.hpp"

#include "algorithms/methods/refit/volume_refit.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

template <class V>
Volume refit(const RefitNode<double>& node) {
  const DefaultFloatEnvironment environment;
  thread_local ControlLists<double> reused;
  return refit_volume<V>(node, reused);
}

template <class V>
Volume around(std::span<const Ball3<double>> balls) {
  const DefaultFloatEnvironment environment;
  return V::around(balls);
}

template <class V>
VolumeVariant variant(std::string name, const std::string& kind) {
  return {std::move(name), kind + " around the control points of control_mixed", Pieces::mixed, refit<V>, around<V>};
}

}  // namespace

const std::vector<VolumeVariant>& volume_variants() {
  static const std::vector<VolumeVariant> variants{
      variant<Aabb<double>>("aabb", "axis-aligned box"), variant<KDop<double, 14>>("dop14", "14-DOP"),
      variant<KDop<double, 18>>("dop18", "18-DOP"),      variant<KDop<double, 26>>("dop26", "26-DOP"),
      variant<Obb<double>>("obb", "oriented box"),
  };
  return variants;
}

}  // namespace refitlab
