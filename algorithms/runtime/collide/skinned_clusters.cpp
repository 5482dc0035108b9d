// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/skinned_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {
namespace {

constexpr float unlimited = std::numeric_limits<float>::infinity();  // a slack where floats do not hold a cluster

// Returns four roundings of the greatest coordinate in a box.
float roundings(const Box<float>& box) { return four_roundings * box.greatest_coordinate(); }

// Returns how many places all clusters have.
int place_count(const ClusterTree& tree) {
  return tree.clusters().back().first_vertex + tree.clusters().back().padded_vertex_count;
}

long work_of_all(const ClusterTree& tree, int part_count) {
  long work = long{work_of_palettes} * part_count;
  for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c) work += tree.floats().block_count(c);
  return work;
}

}  // namespace

SkinnedClusters::SkinnedClusters(const ClusterTree& tree, Skinning skinning)
    : tree_(tree),
      skinning_(skinning),
      palette_packs_(tree.way_of(skinning).palettes),
      float_palettes_(palette_packs_),
      palettes_made_(palette_packs_.part_count()),
      palette_arrays_(palette_packs_.arrays(palette_)),
      clusters_made_(tree.clusters().size()),
      blocks_made_(place_count(tree) / Lanes<double>::count),
      clusters_(tree.clusters().size()),
      work_of_all_(refitlab::work_of_all(tree, palette_packs_.part_count())) {}

void SkinnedClusters::begin(const Pose& pose, const RigidTransform<double>& placement, const Point3& origin,
                            const DeformedReference* reference) {
  pose_ = &pose;
  start(placement, origin, reference);
}

void SkinnedClusters::begin(const AffinePose& pose, const RigidTransform<double>& placement, const Point3& origin,
                            const DeformedReference* reference) {
  if (skinning_ != Skinning::linear) throw std::invalid_argument("clusters: affine joints are skinned linearly");
  make_skinning_palette(tree_.character().mesh, tree_.character().sets, pose, affine_palette_);
  pose_ = nullptr;
  start(placement, origin, reference);
}

void SkinnedClusters::start(const RigidTransform<double>& placement, const Point3& origin, const DeformedReference* reference) {
  const DefaultFloatEnvironment environment;
  is_begun_ = true;
  reference_ = reference;
  placement_ = placement;
  origin_ = origin;
  for (int i = 0; i < 4; ++i) float_placement_.rotation[i] = placement.rotation[i];
  for (int i = 0; i < 3; ++i) float_placement_.translation[i] = placement.translation[i] - origin[i];
  float_placement_.defect = std::abs(squared_norm(placement.rotation) - 1);
  // The world's doubles are the sum of a turned vertex and the translation, and the origin is subtracted from both.
  float_placement_.lost = lost_in_world * (placement.translation.lpNorm<Eigen::Infinity>() + origin.lpNorm<Eigen::Infinity>());
  float_palettes_.begin(pose_, float_placement_);
  palettes_made_.begin(), clusters_made_.begin(), blocks_made_.begin();
  clusters_skinned_ = vertices_skinned_ = work_ = 0;
  is_all_skinned_ = false;
}

void SkinnedClusters::end() {
  is_begun_ = is_all_skinned_ = false;
  palettes_made_.begin(), clusters_made_.begin(), blocks_made_.begin();
}

void SkinnedClusters::require_frame() const {
  if (!is_begun_) throw std::logic_error(tree_.character().mesh.name + ": no frame was begun");
}

void SkinnedClusters::make_all_palettes() {
  const DefaultFloatEnvironment environment;
  require_frame();
  if (!pose_) return;  // affine joints have no palette in float
  float_palettes_.make_all();
}

void SkinnedClusters::skin_all() {
  if (is_all_skinned_) return;
  if (skinning_ == Skinning::spherical || skinning_ == Skinning::hejl) make_all_palettes();
  for (int c = 0; c < static_cast<int>(clusters_.size()); ++c) cluster(c);
  put_boxes();
  is_all_skinned_ = true;
}

void SkinnedClusters::put_boxes() {
  const int count = static_cast<int>(clusters_.size()), blocks = blocks_of(count);
  boxes_.resize(blocks), boxes_around_blocks_.resize(blocks_of(blocks));
  box_around_all_ = Box<float>::empty();
  for (int block = 0, c = 0; block < blocks; ++block) {
    Box<float> around = Box<float>::empty();
    for (const int end = std::min(count, boxes_of_block * (block + 1)); c < end; ++c)
      put_box(boxes_.data(), c, clusters_[c].box), around.merge(clusters_[c].box);
    put_box(boxes_around_blocks_.data(), block, around), box_around_all_.merge(around);
  }
}

void SkinnedClusters::skin_cluster(int n) {
  const DefaultFloatEnvironment environment;
  require_frame();
  FloatCluster& out = clusters_[n];
  constexpr int lanes = Lanes<float>::count;
  if (float_vertices_.empty()) float_vertices_.resize(3 * (place_count(tree_) / lanes) + 1);  // what kernels read beyond
  float* const xyz = float_vertices_[3 * (tree_.clusters()[n].first_vertex / lanes)].lane.data();
  out.xyz = xyz;
  if (can_skin_in_float(n)) skin_in_float(n, xyz, out);
  else skin_in_double(n, xyz, out);
  clusters_made_.mark(n);
  ++clusters_skinned_;
  work_ += tree_.floats().block_count(n);
  vertices_skinned_ += tree_.clusters()[n].padded_vertex_count;
}

// Returns whether cluster n can be skinned in float. Makes its palettes, too.
bool SkinnedClusters::can_skin_in_float(int n) {
  if (reference_ || (skinning_ != Skinning::spherical && skinning_ != Skinning::hejl)) return false;
  bool can = true;
  for (const FloatRun& run : tree_.floats().runs(n)) can = float_palettes_[run.joint_set].slack < unlimited && can;
  return can;
}

void SkinnedClusters::skin_in_float(int n, float* xyz, FloatCluster& out) {
  const float slack = tree_.floats().skin(n, float_palettes_.data(), xyz, out.box);
  out.slack = slack + 2 * roundings(out.box);
  out.box.grow(out.slack);
}

// Doubles that are rounded to floats are off by half of a rounding.
void SkinnedClusters::skin_in_double(int n, float* xyz, FloatCluster& out) {
  const int count = static_cast<int>(tree_.floats().places(n).size()), room = tree_.floats().room(n);
  out.box = Box<float>::empty();
  bool are_finite = true;
  for (int p = 0; p < count; ++p) {
    const PaddedVertex& v = padded_vertex(n, p);
    Vec<float, 3> x;
    for (int i = 0; i < 3; ++i) {
      const double seen = v.of[i] - origin_[i];
      are_finite = are_finite && std::abs(seen) <= largest_float_length;
      xyz[i * room + p] = x[i] = static_cast<float>(seen);
    }
    out.box.merge(x);
  }
  out.slack = are_finite ? 2 * roundings(out.box) + float_above(float_placement_.lost + least_float_slack) : unlimited;
  if (out.slack < unlimited) out.box.grow(out.slack);
  else out.box = Box<float>::everything();
}

const SkinningPalette<double>& SkinnedClusters::whole_palette() {
  require_frame();
  for (int set = 0; set < tree_.character().sets.count(); ++set) make_palette(set);
  return palette();
}

const SkinningPalette<double>& SkinnedClusters::measured_palette() {
  whole_palette();
  if (pose_) palette_.measure();
  return palette();
}

void SkinnedClusters::make_palette(int joint_set) {
  const int part = palette_packs_.part_of(joint_set);
  if (!pose_ || palettes_made_.is_made(part)) return;
  palette_packs_.make_part(part, *pose_, palette_arrays_);
  palettes_made_.mark(part);
}

void SkinnedClusters::skin_block(int n, int block) {
  const DefaultFloatEnvironment environment;
  require_frame();
  constexpr int lanes = Lanes<double>::count;
  const Cluster& cluster = tree_.clusters()[n];
  if (padded_vertices_.empty()) padded_vertices_.resize(place_count(tree_));
  PaddedVertex* const out = &padded_vertices_[cluster.first_vertex + lanes * block];
  const int* const vertices = &tree_.vertices().vertices(n)[lanes * block];
  if (reference_) {
    for (int lane = 0; lane < lanes; ++lane) {
      const Point3 p = vertex_in_world(vertices[lane]);
      out[lane] = {p[0], p[1], p[2], 0};
    }
    return blocks_made_.mark(cluster.first_vertex / lanes + block);
  }
  make_palette(tree_.character().sets.of_vertex(vertices[0]));
  Lanes<double> skinned[3];
  tree_.vertices().skin_block(n, block, palette(), skinning_, skinned);
  const double placement[] = {placement_.rotation[0],   placement_.rotation[1],    placement_.rotation[2],
                              placement_.rotation[3],   placement_.translation[0], placement_.translation[1],
                              placement_.translation[2]};
  box_kernels(best_target()).place(skinned, 1, placement, out);
  blocks_made_.mark(cluster.first_vertex / lanes + block);
}

Point3 SkinnedClusters::vertex_in_world(int v) {
  const Character& c = tree_.character();
  const int set = c.sets.of_vertex(v);
  make_palette(set);
  return apply(placement_, blend<double>(skinning_, palette()[set], c.sets.weights(v),
                                         reference_ ? reference_->vertex(v) : c.mesh.vertices[v]));
}

TrianglePoints SkinnedClusters::triangle(int triangle) {
  const DefaultFloatEnvironment environment;
  require_frame();
  const Triangle& t = tree_.character().mesh.triangles[triangle];
  return {vertex_in_world(t[0]), vertex_in_world(t[1]), vertex_in_world(t[2])};
}

}  // namespace refitlab
