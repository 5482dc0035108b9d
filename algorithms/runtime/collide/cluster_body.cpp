#include "algorithms/runtime/collide/cluster_body.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {
namespace {

int blocks_of(int boxes) { return (boxes + 7) / 8; }

}  // namespace

ClusterBody::ClusterBody(const ClusterTree& tree, Skinning skinning)
    : tree_(tree),
      skinning_(skinning),
      kernels_(box_kernels(best_target())),
      reach_(tree.character().mesh, tree.character().sets, skinning),
      pose_packs_(tree.character().mesh, tree.character().sets, skinning),
      pose_arrays_(pose_packs_.room(pose_)),
      poses_made_(pose_packs_.part_count()),
      joints_(tree.character().sets),
      fans_made_(tree.fans().size()),
      clusters_made_(tree.clusters().size()),
      groups_made_(tree.group_count()),
      fan_boxes_(tree.fans().size()),
      skinned_(tree.clusters().size()) {
  int blocks = 0, most = 0;
  for (const Fan& f : tree.fans())
    first_block_of_fan_.push_back(blocks), blocks += blocks_of(f.child_count), most = std::max(most, f.child_count);
  fan_blocks_.resize(blocks);
  flipped_.resize(most), boxes_.resize(most);
  for (std::size_t c = 0; c < tree.clusters().size(); ++c) {
    auto& parts = parts_of_cluster_.emplace_back();
    for (const int v : tree.vertices().vertices(static_cast<int>(c)))
      parts.push_back(pose_packs_.part_of(tree.character().sets.of_vertex(v)));
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  }
  for (int part = 0; part < pose_packs_.part_count(); ++part) all_parts_.push_back(part);
}

void ClusterBody::begin(const Posture& posture, const RigidTransform<double>& placement) {
  const DefaultFloatEnvironment environment;
  check_placement(placement, "a body's placement");
  const SkinnedMesh& mesh = tree_.character().mesh;
  bool is_rigid = posture.size() == mesh.joints.size();
  are_joints_placed_ = false;  // if this throws, reach_ is no longer the frame's
  const Box<double> reach = is_rigid ? reach_.box(posture, placement, is_rigid) : Box<double>::empty();
  if (!is_rigid) check_posture(mesh, posture);
  posture_ = posture;
  placement_ = placement;
  reach_box_ = reach;
  are_joints_placed_ = std::isfinite(reach.low[0]);
  are_floats_filled_ = false;
  poses_made_.begin(), fans_made_.begin(), clusters_made_.begin(), groups_made_.begin();
  nodes_bounded_ = clusters_skinned_ = corners_skinned_ = 0;
}

void ClusterBody::make_poses(std::span<const int> parts) {
  for (const int part : parts)
    if (!poses_made_.is_made(part)) pose_packs_.make_part(part, posture_, pose_arrays_), poses_made_.mark(part);
}

const BoxBlock<double>* ClusterBody::fan_boxes(int fan) {
  if (!fans_made_.is_made(fan)) bound_fan(fan);
  return &fan_blocks_[first_block_of_fan_[fan]];
}

const Box<double>& ClusterBody::fan_box(int fan) {
  if (!fans_made_.is_made(fan)) bound_fan(fan);
  return fan_boxes_[fan];
}

void ClusterBody::bound_fan(int f) {
  const DefaultFloatEnvironment environment;
  const Fan& fan = tree_.fans()[f];
  const std::span<FlippedBox> flipped(flipped_.data(), fan.child_count);
  const std::span<Box<double>> boxes(boxes_.data(), fan.child_count);
  if (fan.reach.empty() || skinning_ == Skinning::hejl || !are_joints_placed_ ||
      !reach_.boxes(fan.reach, posture_, placement_, flipped, boxes))
    bound_by_control_points(fan, flipped, boxes);
  BoxBlock<double>* blocks = &fan_blocks_[first_block_of_fan_[f]];
  Box<double>& whole = fan_boxes_[f] = Box<double>::empty();
  for (int i = 0; i < fan.child_count; ++i) {
    whole.merge(boxes[i]);
    put_box(blocks, i, boxes[i]);
  }
  fans_made_.mark(f);
  nodes_bounded_ += fan.child_count;
}

void ClusterBody::bound_by_control_points(const Fan& fan, std::span<FlippedBox> flipped, std::span<Box<double>> boxes) {
  make_poses(all_parts_);
  if (!are_floats_filled_) joints_.fill(pose_, skinning_), are_floats_filled_ = true;
  bound_boxes(fan.pieces, skinning_, joints_, pose_, placement_.rotation, flipped);
  for (int i = 0; i < fan.child_count; ++i) {
    boxes[i] = flipped[i].box();
    for (int k = 0; k < 3; ++k) {
      double &low = boxes[i].low[k], &high = boxes[i].high[k];
      const double at = placement_.translation[k];
      const double lost = 1e-14 * (std::max(std::abs(low), std::abs(high)) + std::abs(at));
      low = low + at - lost, high = high + at + lost;
    }
  }
}

void ClusterBody::skin_cluster(int n) {
  const DefaultFloatEnvironment environment;
  const Cluster& cluster = tree_.clusters()[n];
  Skinned& out = skinned_[n];
  if (out.corners.empty()) {
    out.corners.resize(cluster.corner_count);
    out.groups.resize(blocks_of(cluster.group_count));
    out.triangles.resize(cluster.group_count);
  }
  make_poses(parts_of_cluster_[n]);
  tree_.vertices().skin_group(n, pose_, skinning_, unplaced_);
  const double placement[] = {placement_.rotation[0],   placement_.rotation[1],    placement_.rotation[2],
                              placement_.rotation[3],   placement_.translation[0], placement_.translation[1],
                              placement_.translation[2]};
  kernels_.place(unplaced_.blocks.data(), cluster.corner_count / Lanes<double>::count, placement, out.corners.data());
  kernels_.box_groups(&tree_.group(n, 0), cluster.group_count, out.corners.data(), out.groups.data(), out.box);
  clusters_made_.mark(n);
  ++clusters_skinned_;
  corners_skinned_ += cluster.corner_count;
}

const BoxBlock<double>& ClusterBody::triangle_boxes(int cluster, int g) {
  const DefaultFloatEnvironment environment;
  const int at = tree_.clusters()[cluster].first_group + g;
  const Skinned& own = skinned(cluster);
  BoxBlock<double>& block = skinned_[cluster].triangles[g];
  if (!groups_made_.is_made(at)) {
    kernels_.box_triangles(tree_.group(cluster, g), own.corners.data(), block);
    groups_made_.mark(at);
  }
  return block;
}

TrianglePoints ClusterBody::triangle(int triangle) {
  const DefaultFloatEnvironment environment;
  const Character& c = tree_.character();
  TrianglePoints out;
  for (int i = 0; i < 3; ++i) {
    const int v = c.mesh.triangles[triangle][i], part = pose_packs_.part_of(c.sets.of_vertex(v));
    make_poses({&part, 1});
    out[i] =
        apply(placement_, blend<double>(skinning_, pose_[c.sets.of_vertex(v)], c.sets.weights(v), c.mesh.vertices[v]));
  }
  return out;
}

}  // namespace refitlab
