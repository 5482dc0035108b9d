// SPDX-License-Identifier: MIT
// SkinnedClusters has the clusters of a placed character in one frame. They are skinned in float on demand, and vertices in
// double where floats do not decide.
#pragma once

#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/collide/float_palettes.hpp"
#include "algorithms/runtime/refit/deformed_reference.hpp"

namespace refitlab {

// Boxes in float have this share of their coordinates to spare.
inline constexpr float four_roundings = 0x1p-22f;
// The doubles of the world lose this share of how far the placement and the origin are from the world's origin.
inline constexpr double lost_in_world = 0x1p-51;

// The unit of work is what skinning a block of sixteen vertices in float takes, which is 12 ns as measured with AVX-512. These
// are the work of a pack of palettes, of a pack of motion bounds, and of a bounded node besides. They only choose between
// ways that find the same.
inline constexpr int work_of_palettes = 20, work_of_motion_bounds = 10, work_of_bounded_node = 3;

// A FloatCluster has a cluster's vertices in float. Coordinates are those of the world, seen from SkinnedClusters::origin().
struct FloatCluster {
  // The slack bounds how far each coordinate is from the doubles of apply(placement, skin()) less the origin, plus four
  // roundings. It is infinite where floats say nothing; then so is the box.
  float slack;
  Box<float> box;    // around the doubles, less the origin
  const float* xyz;  // x by position, then y, then z, with FloatVertices::room for each; one block behind them can be read
};

class SkinnedClusters {
 public:
  // tree must outlive this.
  SkinnedClusters(const ClusterTree& tree, Skinning skinning);
  SkinnedClusters(const SkinnedClusters&) = delete;  // a copy would write into the arrays of this one

  // Starts a frame, of which nothing is computed yet. pose and placement must be as check_pose and check_placement require,
  // and stay until the next frame. Floats are coordinates as seen from origin. They are more exact the nearer that is. If there
  // is a reference, its deformation moves the vertices first; it must stay, too. Then all skinning is in double.
  void begin(const Pose& pose, const RigidTransform<double>& placement, const Point3& origin,
             const DeformedReference* reference = nullptr);
  // Does the same for linear skinning by affine joints. pose need not stay.
  void begin(const AffinePose& pose, const RigidTransform<double>& placement, const Point3& origin,
             const DeformedReference* reference = nullptr);

  // Throws std::logic_error before the first frame, and so does what is below that makes something.
  void require_frame() const;
  // Ends the frame. Another one is to be begun before anything is asked for.
  void end();

  const ClusterTree& tree() const { return tree_; }
  const Point3& origin() const { return origin_; }

  // These make all joint-sets and all clusters at once, for those who need them all.
  void make_all_palettes();
  void skin_all();
  bool is_all_skinned() const { return is_all_skinned_; }

  // These are for when all clusters are skinned: their boxes, in blocks, those around each block, in blocks likewise, and that around
  // all of them.
  const BoxBlock<float>* boxes() const { return boxes_.data(); }
  const BoxBlock<float>* boxes_around_blocks() const { return boxes_around_blocks_.data(); }
  const Box<float>& box_around_all() const { return box_around_all_; }

  bool is_skinned(int cluster) const { return clusters_made_.is_made(cluster); }
  const FloatCluster& cluster(int cluster) {
    if (!clusters_made_.is_made(cluster)) skin_cluster(cluster);
    return clusters_[cluster];
  }

  // Returns a cluster's vertex in the world, by position. It is the very doubles that apply(placement, skin()) yields.
  const PaddedVertex& padded_vertex(int cluster, int position) {
    const int place = tree_.floats().places(cluster)[position], at = tree_.clusters()[cluster].first_vertex + place;
    if (!blocks_made_.is_made(at / Lanes<double>::count)) skin_block(cluster, place / Lanes<double>::count);
    return padded_vertices_[at];
  }
  // Returns the vertices of a single triangle of the model in the world. They are the same doubles.
  TrianglePoints triangle(int triangle);

  // Returns the rounding error of each coordinate in the world, in double.
  double lost() const { return float_placement_.lost; }
  // Returns the palette of all joint-sets in double.
  const SkinningPalette<double>& whole_palette();
  // Returns the same, measured, as refits need it. A palette of rigid joints is measured each time.
  const SkinningPalette<double>& measured_palette();

  // work() is the work done for floats since begin, and work_of_all() is that of making everything.
  long work() const { return work_ + work_of_palettes * long{float_palettes_.packs_made()}; }
  long work_of_all() const { return work_of_all_; }

  // These counts are since begin.
  long clusters_skinned() const { return clusters_skinned_; }
  long vertices_skinned() const { return vertices_skinned_; }  // in float or in double

 private:
  void start(const RigidTransform<double>& placement, const Point3& origin, const DeformedReference* reference);
  const SkinningPalette<double>& palette() const { return pose_ ? palette_ : affine_palette_; }
  bool can_skin_in_float(int cluster);
  void skin_cluster(int cluster);
  void skin_in_float(int cluster, float* xyz, FloatCluster& out);
  void skin_in_double(int cluster, float* xyz, FloatCluster& out);
  void skin_block(int cluster, int block);
  void make_palette(int joint_set);
  void put_boxes();
  Point3 vertex_in_world(int vertex);

  const ClusterTree& tree_;
  const Skinning skinning_;
  const PalettePacks& palette_packs_;
  const Pose* pose_ = nullptr;                    // none where joints are affine
  const DeformedReference* reference_ = nullptr;  // none where vertices are those of the mesh
  RigidTransform<double> placement_;
  Point3 origin_ = Point3::Zero();
  FloatPlacement float_placement_;
  FloatPalettes float_palettes_;
  FrameStamps palettes_made_;               // by part of palette_packs_
  SkinningPalette<double> palette_;         // of what parts were made
  SkinningPalette<double> affine_palette_;  // of all joint-sets, where joints are affine
  const SkinningPalette<double>::Arrays palette_arrays_;
  FrameStamps clusters_made_, blocks_made_;
  std::vector<FloatCluster> clusters_;
  std::vector<BoxBlock<float>> boxes_, boxes_around_blocks_;  // made when all clusters are first skinned
  Box<float> box_around_all_ = Box<float>::empty();
  // What clusters have by place or by position is in one array, so that those that are skinned together are near each other. Each
  // array is made when the first of it is asked for.
  std::vector<Lanes<float>> float_vertices_;
  std::vector<PaddedVertex> padded_vertices_;
  const long work_of_all_;
  long clusters_skinned_ = 0, vertices_skinned_ = 0, work_ = 0;
  bool is_begun_ = false, is_all_skinned_ = false;
};

}  // namespace refitlab
