// SPDX-License-Identifier: GPL-3.0-or-later
// This is Bullet's GImpact. Its quantised box sets are updated in model space, and its traversal moves boxes by the placements.
#include <BulletCollision/Gimpact/btGImpactQuantizedBvh.h>

#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/float_boxes.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

// GImpact asks this class for the triangles' boxes.
class Boxes : public btPrimitiveManagerBase {
 public:
  explicit Boxes(const SkinnedMesh& model) : model_(model) {}
  void set(const std::vector<Point3>& vertices, float margin) {
    vertices_.set(vertices);
    margin_ = margin;
  }

  bool is_trimesh() const override { return true; }
  int get_primitive_count() const override { return static_cast<int>(model_.triangles.size()); }
  void get_primitive_box(int triangle, btAABB& out) const override {
    const RowBox<float> b = vertices_.box(model_.triangles[triangle]);
    out.m_min.setValue(b.low[0] - margin_, b.low[1] - margin_, b.low[2] - margin_);
    out.m_max.setValue(b.high[0] + margin_, b.high[1] + margin_, b.high[2] + margin_);
  }
  void get_primitive_triangle(int, btPrimitiveTriangle&) const override {}  // only its own triangle tests would ask

 private:
  const SkinnedMesh& model_;
  RoundedVertices vertices_;
  float margin_ = 0;
};

class BulletGimpact : public SkinningDetector {
 public:
  explicit BulletGimpact(const Character& character)
      : SkinningDetector(character, Placing::when_asked),
        boxes_{Boxes(character.mesh), Boxes(character.mesh)} {
    // Boxes are rounded to 2^16 steps within the bounds at the build, and cut off there. So these get a margin that no
    // pose leaves, and each box later a margin of one step.
    const float reach = static_cast<float>(2 * character.tree.nodes[0].reference.radius);
    for (int side = 0; side < 2; ++side) {
      boxes_[side].set(character.mesh.vertices, reach);
      sets_[side].setPrimitiveManager(&boxes_[side]);
      sets_[side].buildSet();
    }
    const btAABB bounds = sets_[0].getGlobalBox();
    step_ = (bounds.m_max - bounds.m_min).length() / 65535;
  }

  void refit() override {
    for (int side = 0; side < 2; ++side) {
      boxes_[side].set(skinned(side), step_);
      sets_[side].update();
      counts_.nodes_refitted += sets_[side].getNodeCount();
    }
  }

  std::vector<TrianglePair> query(Query query) override {
    btPairSet pairs;  // all: GImpact cannot be stopped
    btGImpactQuantizedBvh::find_collision(&sets_[0], transform(0), &sets_[1], transform(1), pairs);
    candidates_.ask(query);
    for (int i = 0; i < pairs.size() && !candidates_.is_done(); ++i) candidates_.add(pairs[i].m_index1, pairs[i].m_index2);
    return candidates_.found();
  }

 private:
  btTransform transform(int side) const {
    const auto& [q, t] = placement(side);
    return btTransform(btQuaternion(float(q[1]), float(q[2]), float(q[3]), float(q[0])),
                       btVector3(float(t[0]), float(t[1]), float(t[2])));
  }

  float step_ = 0;
  Boxes boxes_[2];
  btGImpactQuantizedBvh sets_[2];
};

}  // namespace

std::unique_ptr<Detector> make_bullet_gimpact(const Character& character) { return std::make_unique<BulletGimpact>(character); }

}  // namespace refitlab
