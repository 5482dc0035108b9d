// SPDX-License-Identifier: GPL-3.0-or-later
// This is Bullet's btDbvt with a leaf for each triangle. Its volumes are refitted from the leaves up, as btSoftBody does with its
// faces.
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/float_boxes.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

btDbvtVolume volume_of(const RowBox<float>& b) {
  return btDbvtVolume::FromMM({b.low[0], b.low[1], b.low[2]}, {b.high[0], b.high[1], b.high[2]});
}

class BulletDbvt : public SkinningDetector {
 public:
  explicit BulletDbvt(const Character& character) : SkinningDetector(character, Placing::all) {
    const SkinnedMesh& m = character.mesh;
    vertices_.set(m.vertices);
    btDbvt scattered;
    for (std::size_t i = 0; i < m.triangles.size(); ++i)
      scattered.insert(volume_of(vertices_.box(m.triangles[i])), nullptr)->dataAsInt = static_cast<int>(i);
    scattered.optimizeTopDown();
    btDbvt::IClone nothing_more;
    for (btDbvt& tree : trees_) scattered.clone(tree, &nothing_more);  // its nodes lie side by side where they belong together
  }

  void refit() override {
    for (int side = 0; side < 2; ++side) {
      vertices_.set(placed(side));
      refit(trees_[side].m_root);
    }
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    Collider collider(candidates_);
    try {
      trees_[0].collideTT(trees_[0].m_root, trees_[1].m_root, collider);
    } catch (const Stop&) {
    }
    return candidates_.found();
  }

 private:
  struct Stop {};  // Bullet has no other way out of the traversal

  struct Collider : btDbvt::ICollide {
    explicit Collider(CandidatePairs& candidates) : candidates(candidates) {}
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      candidates.add(a->dataAsInt, b->dataAsInt);
      if (candidates.is_done()) throw Stop();
    }
    CandidatePairs& candidates;
  };

  void refit(btDbvtNode* node) {
    ++counts_.nodes_refitted;
    if (node->isleaf()) {
      node->volume = volume_of(vertices_.box(model().triangles[node->dataAsInt]));
      return;
    }
    refit(node->childs[0]);
    refit(node->childs[1]);
    Merge(node->childs[0]->volume, node->childs[1]->volume, node->volume);
  }

  btDbvt trees_[2];
  RoundedVertices vertices_;  // of the body at hand
};

}  // namespace

std::unique_ptr<Detector> make_bullet_dbvt(const Character& character) { return std::make_unique<BulletDbvt>(character); }

}  // namespace refitlab
