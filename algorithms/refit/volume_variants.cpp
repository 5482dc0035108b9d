#include "algorithms/refit/volume_variants.hpp"

#include "algorithms/refit/volume_refit.hpp"

namespace refitlab {
namespace {

template <class V>
Volume refit(const RefitNode<double>& node) {
  thread_local ControlLists<double> reused;
  return refit_volume<V>(node, reused);
}

template <class V>
Volume around(std::span<const Ball3<double>> balls) {
  return V::around(balls);
}

template <class V>
VolumeVariant of_sets(std::string name, const std::string& kind) {
  return {std::move(name), "control hull, a ball and a weight hull per joint-set, " + kind, Pieces::joint_sets,
          refit<V>, around<V>};
}

}  // namespace

const std::vector<VolumeVariant>& volume_variants() {
  static const std::vector<VolumeVariant> variants{
      of_sets<Aabb<double>>("aabb_sets", "axis-aligned box"),
      of_sets<KDop<double, 14>>("dop14_sets", "14-DOP"),
      of_sets<KDop<double, 18>>("dop18_sets", "18-DOP"),
      of_sets<KDop<double, 26>>("dop26_sets", "26-DOP"),
      of_sets<Obb<double>>("obb_sets", "oriented box"),
  };
  return variants;
}

}  // namespace refitlab
