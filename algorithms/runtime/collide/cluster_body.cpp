// SPDX-License-Identifier: MIT
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
      motion_bound_(tree.character().mesh, tree.character().sets, skinning),
      palette_packs_(tree.character().mesh, tree.character().sets, skinning),
      palette_arrays_(palette_packs_.room(palette_)),
      palettes_made_(palette_packs_.part_count()),
      joints_(tree.character().sets),
      wide_nodes_made_(tree.wide_nodes().size()),
      clusters_made_(tree.clusters().size()),
      groups_made_(tree.group_count()),
      wide_node_boxes_(tree.wide_nodes().size()),
      skinned_(tree.clusters().size()) {
  int blocks = 0, most = 0;
  for (const WideNode& f : tree.wide_nodes())
    first_block_of_wide_node_.push_back(blocks), blocks += blocks_of(f.child_count), most = std::max(most, f.child_count);
  wide_node_blocks_.resize(blocks);
  flipped_.resize(most), boxes_.resize(most);
  for (std::size_t c = 0; c < tree.clusters().size(); ++c) {
    auto& parts = parts_of_cluster_.emplace_back();
    for (const int v : tree.vertices().vertices(static_cast<int>(c)))
      parts.push_back(palette_packs_.part_of(tree.character().sets.of_vertex(v)));
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  }
  for (int part = 0; part < palette_packs_.part_count(); ++part) all_parts_.push_back(part);
}

void ClusterBody::begin(const Pose& pose, const RigidTransform<double>& placement) {
  const DefaultFloatEnvironment environment;
  check_placement(placement, "a body's placement");
  const SkinnedMesh& mesh = tree_.character().mesh;
  bool is_rigid = pose.size() == mesh.joints.size();
  are_joints_placed_ = false;  // if this throws, motion_bound_ is no longer the frame's
  const Box<double> bound = is_rigid ? motion_bound_.box(pose, placement, is_rigid) : Box<double>::empty();
  if (!is_rigid) check_pose(mesh, pose);
  pose_ = pose;
  placement_ = placement;
  motion_bound_box_ = bound;
  are_joints_placed_ = std::isfinite(bound.low[0]);
  are_floats_filled_ = false;
  palettes_made_.begin(), wide_nodes_made_.begin(), clusters_made_.begin(), groups_made_.begin();
  nodes_bounded_ = clusters_skinned_ = corners_skinned_ = 0;
}

void ClusterBody::make_palettes(std::span<const int> parts) {
  for (const int part : parts)
    if (!palettes_made_.is_made(part)) palette_packs_.make_part(part, pose_, palette_arrays_), palettes_made_.mark(part);
}

const BoxBlock<double>* ClusterBody::wide_node_boxes(int wide_node) {
  if (!wide_nodes_made_.is_made(wide_node)) bound_wide_node(wide_node);
  return &wide_node_blocks_[first_block_of_wide_node_[wide_node]];
}

const Box<double>& ClusterBody::wide_node_box(int wide_node) {
  if (!wide_nodes_made_.is_made(wide_node)) bound_wide_node(wide_node);
  return wide_node_boxes_[wide_node];
}

void ClusterBody::bound_wide_node(int f) {
  const DefaultFloatEnvironment environment;
  const WideNode& wide_node = tree_.wide_nodes()[f];
  const std::span<FlippedBox> flipped(flipped_.data(), wide_node.child_count);
  const std::span<Box<double>> boxes(boxes_.data(), wide_node.child_count);
  if (wide_node.motion_bounds.empty() || skinning_ == Skinning::hejl || !are_joints_placed_ ||
      !motion_bound_.boxes(wide_node.motion_bounds, pose_, placement_, flipped, boxes))
    bound_by_control_points(wide_node, flipped, boxes);
  BoxBlock<double>* blocks = &wide_node_blocks_[first_block_of_wide_node_[f]];
  Box<double>& whole = wide_node_boxes_[f] = Box<double>::empty();
  for (int i = 0; i < wide_node.child_count; ++i) {
    whole.merge(boxes[i]);
    put_box(blocks, i, boxes[i]);
  }
  wide_nodes_made_.mark(f);
  nodes_bounded_ += wide_node.child_count;
}

void ClusterBody::bound_by_control_points(const WideNode& wide_node, std::span<FlippedBox> flipped,
                                          std::span<Box<double>> boxes) {
  make_palettes(all_parts_);
  if (!are_floats_filled_) joints_.fill(palette_, skinning_), are_floats_filled_ = true;
  bound_boxes(wide_node.pieces, skinning_, joints_, palette_, placement_.rotation, flipped);
  for (int i = 0; i < wide_node.child_count; ++i) {
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
    out.corners.resize(cluster.padded_vertex_count);
    out.groups.resize(blocks_of(cluster.group_count));
    out.triangles.resize(cluster.group_count);
  }
  make_palettes(parts_of_cluster_[n]);
  tree_.vertices().skin_group(n, palette_, skinning_, unplaced_);
  const double placement[] = {placement_.rotation[0],   placement_.rotation[1],    placement_.rotation[2],
                              placement_.rotation[3],   placement_.translation[0], placement_.translation[1],
                              placement_.translation[2]};
  kernels_.place(unplaced_.blocks.data(), cluster.padded_vertex_count / Lanes<double>::count, placement, out.corners.data());
  kernels_.box_groups(&tree_.group(n, 0), cluster.group_count, out.corners.data(), out.groups.data(), out.box);
  clusters_made_.mark(n);
  ++clusters_skinned_;
  corners_skinned_ += cluster.padded_vertex_count;
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
    const int v = c.mesh.triangles[triangle][i], part = palette_packs_.part_of(c.sets.of_vertex(v));
    make_palettes({&part, 1});
    out[i] = apply(placement_, blend<double>(skinning_, palette_[c.sets.of_vertex(v)], c.sets.weights(v), c.mesh.vertices[v]));
  }
  return out;
}

}  // namespace refitlab
