// SPDX-License-Identifier: GPL-3.0-or-later
// This is FCL with BVHModels refitted bottom-up and its traversal. Our own leaf test is in place of its inexact one.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/utility.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/traversal_recurse.h>

#include <type_traits>
#include <utility>

#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

// FCL moves only oriented volumes. For the others it takes vertices in the world.
template <class Volume>
constexpr bool is_oriented = std::is_same_v<Volume, fcl::OBBRSS<double>>;

template <class Volume>
using TraversalNode = std::conditional_t<is_oriented<Volume>, fcl::detail::MeshCollisionTraversalNodeOBBRSS<double>,
                                         fcl::detail::MeshCollisionTraversalNode<Volume>>;

template <class Volume>
class Fcl : public SkinningDetector {
 public:
  explicit Fcl(const Character& character)
      : SkinningDetector(character, is_oriented<Volume> ? Placing::when_asked : Placing::all) {
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : character.mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    for (auto& tree : trees_) {
      tree.beginModel();
      tree.addSubModel(character.mesh.vertices, triangles);
      tree.endModel();
    }
  }

  void refit() override {
    for (int side = 0; side < 2; ++side) {
      trees_[side].beginReplaceModel();
      trees_[side].replaceSubModel(is_oriented<Volume> ? skinned(side) : placed(side));
      trees_[side].endReplaceModel(true, true);
      counts_.nodes_refitted += trees_[side].getNumBVs();
    }
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    Traversal traversal(*this);
    TraversalNode<Volume>& node = traversal;
    fcl::Transform3<double> at[] = {transform(0), transform(1)};
    const fcl::CollisionRequest<double> request;
    fcl::CollisionResult<double> unused;
    if constexpr (is_oriented<Volume>)
      fcl::detail::initialize(node, std::as_const(trees_[0]), std::as_const(at[0]), std::as_const(trees_[1]),
                              std::as_const(at[1]), request, unused);
    else fcl::detail::initialize(node, trees_[0], at[0], trees_[1], at[1], request, unused);
    fcl::detail::collisionRecurse<double>(&traversal, 0, 0, nullptr);
    counts_.volume_tests += traversal.num_bv_tests;
    return candidates_.found();
  }

 private:
  class Traversal : public TraversalNode<Volume> {
   public:
    explicit Traversal(Fcl& self) : self_(self) { this->enable_statistics = true; }
    void leafTesting(int first, int second) const override {
      self_.candidates_.add(self_.trees_[0].getBV(first).primitiveId(), self_.trees_[1].getBV(second).primitiveId());
    }
    bool canStop() const override { return self_.candidates_.is_done(); }

   private:
    Fcl& self_;
  };

  fcl::Transform3<double> transform(int side) const {
    fcl::Transform3<double> out = fcl::Transform3<double>::Identity();
    if constexpr (is_oriented<Volume>) {
      const auto& [q, t] = placement(side);
      out.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
      out.translation() = t;
    }
    return out;
  }

  fcl::BVHModel<Volume> trees_[2];
};

}  // namespace

std::unique_ptr<Detector> make_fcl_aabb(const Character& c) { return std::make_unique<Fcl<fcl::AABB<double>>>(c); }
std::unique_ptr<Detector> make_fcl_kdop16(const Character& c) { return std::make_unique<Fcl<fcl::KDOP<double, 16>>>(c); }
std::unique_ptr<Detector> make_fcl_obbrss(const Character& c) { return std::make_unique<Fcl<fcl::OBBRSS<double>>>(c); }

}  // namespace refitlab
