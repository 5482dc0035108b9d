#include "algorithms/collide/cluster_body.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "algorithms/skinning/blend.hpp"

namespace refitlab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box6 no_box{infinity, infinity, infinity, -infinity, -infinity, -infinity};

void check(const RigidTransform<double>& placement) {
  if (!placement.rotation.allFinite() || !placement.translation.allFinite())
    throw std::invalid_argument("a body's placement is not finite");
  if (!(std::abs(squared_norm(placement.rotation) - 1) <= 1e-6))
    throw std::invalid_argument("a body's placement is not rigid: its rotation is no quaternion of unit length");
}

int blocks_of(int boxes) { return (boxes + 7) / 8; }

void put(BoxBlock* blocks, int i, const Box6& box) {
  for (int k = 0; k < 6; ++k) blocks[i / 8].side[k][i % 8] = box[k];
}
Box6 get(const BoxBlock* blocks, int i) {
  Box6 box;
  for (int k = 0; k < 6; ++k) box[k] = blocks[i / 8].side[k][i % 8];
  return box;
}

}  // namespace

ClusterBody::ClusterBody(const ClusterTree& tree, Skinning skinning)
    : tree_(tree), skinning_(skinning), kernels_(box_kernels(best_target())), joints_(tree.character().sets),
      fans_made_(tree.fans().size()), clusters_made_(tree.clusters().size()), groups_made_(tree.groups().size()),
      group_blocks_(tree.groups().size()), cluster_boxes_(tree.clusters().size()), corners_(tree.vertices().size()) {
  int blocks = 0, most = 0;
  for (const Fan& f : tree.fans()) first_block_of_fan_.push_back(blocks), blocks += blocks_of(f.child_count), most = std::max(most, f.child_count);
  fan_blocks_.resize(blocks);
  flipped_.resize(most);
  blocks = 0;
  for (const Cluster& c : tree.clusters()) first_block_of_cluster_.push_back(blocks), blocks += blocks_of(c.group_count);
  cluster_blocks_.resize(blocks);
}

void ClusterBody::begin(const Posture& posture, const RigidTransform<double>& placement) {
  check(placement);
  const Character& c = tree_.character();
  pose_ = make_skinning_pose(c.model, c.sets, posture, skinning_);
  placement_ = placement;
  are_floats_filled_ = false;
  fans_made_.begin(), clusters_made_.begin(), groups_made_.begin();
  fans_bounded_ = clusters_skinned_ = 0;
}

const BoxBlock* ClusterBody::fan_boxes(int fan) {
  if (!fans_made_.is_made(fan)) bound_fan(fan);
  return &fan_blocks_[first_block_of_fan_[fan]];
}

Box6 ClusterBody::child_box(int fan, int child) { return get(fan_boxes(fan), child); }

void ClusterBody::bound_fan(int f) {
  if (!are_floats_filled_) joints_.fill(pose_, skinning_), are_floats_filled_ = true;
  const Fan& fan = tree_.fans()[f];
  const std::span<FlippedBox> boxes(flipped_.data(), fan.child_count);
  bound_boxes(fan.pieces, skinning_, joints_, pose_, placement_.rotation, boxes);
  BoxBlock* blocks = &fan_blocks_[first_block_of_fan_[f]];
  for (int i = 0; i < fan.child_count; ++i) {
    Box6 box;
    for (int k = 0; k < 3; ++k) {
      const double low = boxes[i].of[k], high = -boxes[i].of[4 + k], at = placement_.translation[k];
      const double lost = 1e-14 * (std::max(std::abs(low), std::abs(high)) + std::abs(at));
      box[k] = low + at - lost, box[3 + k] = high + at + lost;
    }
    put(blocks, i, box);
  }
  fans_made_.mark(f);
  ++fans_bounded_;
}

const BoxBlock* ClusterBody::group_boxes(int cluster) {
  if (!clusters_made_.is_made(cluster)) skin_cluster(cluster);
  return &cluster_blocks_[first_block_of_cluster_[cluster]];
}

const Box6& ClusterBody::cluster_box(int cluster) {
  if (!clusters_made_.is_made(cluster)) skin_cluster(cluster);
  return cluster_boxes_[cluster];
}

void ClusterBody::skin_cluster(int n) {
  const Cluster& cluster = tree_.clusters()[n];
  const Character& c = tree_.character();
  for (int i = cluster.first_vertex; i < cluster.first_vertex + cluster.vertex_count; ++i) {
    const int v = tree_.vertices()[i];
    const Point3 p = apply(placement_, blend<double>(skinning_, pose_[c.sets.of_vertex(v)], c.sets.weights(v), c.model.vertices[v]));
    corners_[i] = {p[0], p[1], p[2], 0};
  }
  BoxBlock* blocks = &cluster_blocks_[first_block_of_cluster_[n]];
  Box6 all = no_box;
  for (int g = 0; g < cluster.group_count; ++g) {
    const TriangleGroup& group = tree_.groups()[cluster.first_group + g];
    Box6 box = no_box;
    for (int t = 0; t < group.count; ++t)
      for (const std::uint16_t position : group.corners[t]) {
        const Corner& p = corner(cluster, position);
        for (int k = 0; k < 3; ++k) box[k] = std::min(box[k], p.of[k]), box[3 + k] = std::max(box[3 + k], p.of[k]);
      }
    for (int k = 0; k < 3; ++k) all[k] = std::min(all[k], box[k]), all[3 + k] = std::max(all[3 + k], box[3 + k]);
    put(blocks, g, box);
  }
  cluster_boxes_[n] = all;
  clusters_made_.mark(n);
  ++clusters_skinned_;
}

const BoxBlock& ClusterBody::triangle_boxes(int n, int g) {
  const Cluster& cluster = tree_.clusters()[n];
  const int at = cluster.first_group + g;
  BoxBlock& block = group_blocks_[at];
  if (groups_made_.is_made(at)) return block;
  const TriangleGroup& group = tree_.groups()[at];
  for (int t = 0; t < group.count; ++t) {
    const auto& [a, b, c] = group.corners[t];
    const Corner &p = corner(cluster, a), &q = corner(cluster, b), &r = corner(cluster, c);
    for (int k = 0; k < 3; ++k) {
      block.side[k][t] = std::min(std::min(p.of[k], q.of[k]), r.of[k]);
      block.side[3 + k][t] = std::max(std::max(p.of[k], q.of[k]), r.of[k]);
    }
  }
  groups_made_.mark(at);
  return block;
}

TrianglePoints ClusterBody::triangle(int n, int g, int t) const {
  const Cluster& cluster = tree_.clusters()[n];
  const auto& corners = tree_.groups()[cluster.first_group + g].corners[t];
  TrianglePoints out;
  for (int i = 0; i < 3; ++i) {
    const Corner& p = corner(cluster, corners[i]);
    out[i] = {p.of[0], p.of[1], p.of[2]};
  }
  return out;
}

}  // namespace refitlab
