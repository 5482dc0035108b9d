// SPDX-License-Identifier: MIT
// A SkinningPalette has the data that skinning prepares once a frame for each joint-set. They are the transforms with signed
// quaternions, the rotation centers and their images (paper 3). A palette of affine joints is for linear skinning alone. It has
// their maps and nothing else.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/palette_rounding.hpp"

namespace refitlab {

enum class Skinning {
  linear,          // v' = sum w_i C_i v
  spherical,       // Equation (1): QLERP about the rotation center of the joint-set [Kavan and Zara 2005b]
  hejl,            // Equation (1) about the joint that neighbouring bones share [Hejl 2004]
  dual_quaternion  // the rigid transform of the normalised blend of dual quaternions [Kavan et al. 2007]
};

// A PaletteEntry is the palette of one joint-set in one pose, for reading. Arrays are by position in the joint-set.
template <class S>
struct PaletteEntry {
  // These are the transforms C_{j_i}. The signs of the rotations are the skinning's. They are consistent within the joint-set, so
  // that QLERP takes the short way from the first joint to each other one. Bounds must use these signs, because q and -q blend
  // differently.
  std::span<const RigidTransform<S>> transforms;
  Vec<S, 3> rotation_center;                 // r_c, reference frame
  std::span<const Vec<S, 3>> center_images;  // C_{j_i} r_c
  std::span<const Quaternion<S>> duals;      // d_i = t_i q_i / 2 of the dual quaternions q_i + eps d_i of the C_{j_i}
  std::span<const AffineMap<S>> maps;        // of affine joints, which are the C_{j_i} then; of rigid ones there are none
  std::span<const S> stretches;              // likewise: no less than what they stretch by (a1_affine_image)
};

// Negates quaternions so that each has a non-negative dot product with the first. Then no blend with a positive first
// weight vanishes.
template <class S>
void make_signs_consistent(std::span<RigidTransform<S>> transforms) {
  for (auto& t : transforms.subspan(1)) {
    const Quaternion<S> other = -t.rotation;
    t.rotation = choose(dot(transforms[0].rotation, t.rotation) < S(0), other, t.rotation);
  }
}

// An OwnedPaletteEntry is the palette of one joint-set with its own storage.
template <class S>
struct OwnedPaletteEntry {
  std::vector<RigidTransform<S>> transforms;
  Vec<S, 3> rotation_center = {S(0), S(0), S(0)};
  std::vector<Vec<S, 3>> center_images;
  std::vector<Quaternion<S>> duals;
  std::vector<AffineMap<S>> maps;
  std::vector<S> stretches;

  operator PaletteEntry<S>() const { return {transforms, rotation_center, center_images, duals, maps, stretches}; }
};

// Fills center_images from transforms and rotation_center.
template <class S>
void place_rotation_center(OwnedPaletteEntry<S>& palette, const Vec<S, 3>& rotation_center) {
  palette.rotation_center = rotation_center;
  palette.center_images.clear();
  for (const auto& t : palette.transforms) palette.center_images.push_back(apply(t, rotation_center));
}

// Fills duals from transforms.
template <class S>
void place_duals(OwnedPaletteEntry<S>& palette) {
  palette.duals.clear();
  for (const auto& t : palette.transforms) palette.duals.push_back(dual_part(t));
}

// A SkinningPalette has the palettes of all joint-sets in one pose, in flat arrays. A refit reads a few of them for each node.
template <class S>
class SkinningPalette {
 public:
  std::size_t size() const { return rotation_centers_.size(); }
  std::size_t joint_count(std::size_t joint_set) const { return first_[joint_set + 1] - first_[joint_set]; }
  PaletteEntry<S> operator[](std::size_t joint_set) const {
    const std::size_t first = first_[joint_set], count = first_[joint_set + 1] - first;
    const std::size_t first_map = is_affine() ? first : 0, map_count = is_affine() ? count : 0;
    return {{transforms_.data() + first, count},    rotation_centers_[joint_set],
            {center_images_.data() + first, count}, {duals_.data() + first, count},
            {maps_.data() + first_map, map_count},  {stretches_.data() + first_map, map_count}};
  }
  // Says whether the joints are affine. Then the palette is for linear skinning, and there is nothing but maps in it.
  bool is_affine() const { return !maps_.empty(); }
  const Vec<S, 3>& rotation_center(std::size_t joint_set) const { return rotation_centers_[joint_set]; }
  // Scales and roundings exist in float and double. For a palette whose arrays were filled by hand, call measure() first. Those
  // of spherical skinning are those of Hejl's, too.
  const PaletteScales<S>& scales(std::size_t joint_set) const { return scales_[joint_set]; }
  const PaletteRounding<S>& rounding(std::size_t joint_set, Skinning skinning) const {
    return roundings_[joint_set][skinning == Skinning::linear ? 0 : skinning == Skinning::dual_quaternion ? 2 : 1];
  }

  // Removes all joint-sets and keeps the storage.
  void clear() {
    first_.resize(1);
    transforms_.clear(), rotation_centers_.clear(), center_images_.clear(), duals_.clear(), scales_.clear(), roundings_.clear();
    maps_.clear(), stretches_.clear();
  }

  // Appends a joint-set of joint_count joints, whose transforms the caller sets. Then the caller must call complete().
  std::span<RigidTransform<S>> append(std::size_t joint_count) {
    transforms_.resize(first_.back() + joint_count);
    return {transforms_.data() + first_.back(), joint_count};
  }
  // Gives the appended joint-set its rotation center, the images of that, and the dual parts.
  void complete(const Vec<S, 3>& rotation_center) {
    rotation_centers_.push_back(rotation_center);
    for (std::size_t i = first_.back(); i < transforms_.size(); ++i) {
      center_images_.push_back(apply(transforms_[i], rotation_center));
      duals_.push_back(dual_part(transforms_[i]));
    }
    first_.push_back(transforms_.size());
    measure_last();
  }

  // Appends a joint-set of affine joints. All joint-sets of a palette must be affine, or none.
  void push_back_affine(std::span<const AffineMap<S>> maps) {
    const std::size_t slots = first_.back() + maps.size();
    rotation_centers_.push_back(Vec<S, 3>(S(0), S(0), S(0)));
    transforms_.resize(slots), center_images_.resize(slots, rotation_centers_.back());
    duals_.resize(slots, Quaternion<S>(S(0), S(0), S(0), S(0)));
    maps_.insert(maps_.end(), maps.begin(), maps.end());
    for (const AffineMap<S>& map : maps) stretches_.push_back(stretch_of(map));
    first_.push_back(slots);
    measure_last();
  }

  // These are the arrays themselves, joint-set after joint-set, for code that fills many of them at a time.
  struct Arrays {
    Vec<S, 3>* rotation_centers;  // by joint-set; all other arrays are by joint
    RigidTransform<S>* transforms;
    Vec<S, 3>* center_images;
    Quaternion<S>* duals;
  };
  // Makes room for joint-sets that begin at these positions of the arrays by joint. The last position is the arrays' size.
  Arrays resize(std::span<const std::size_t> first) {
    first_.assign(first.begin(), first.end());
    rotation_centers_.resize(first.size() - 1);
    transforms_.resize(first.back()), center_images_.resize(first.back()), duals_.resize(first.back());
    scales_.clear(), roundings_.clear(), maps_.clear(), stretches_.clear();
    return {rotation_centers_.data(), transforms_.data(), center_images_.data(), duals_.data()};
  }

  // Refits need these measures beyond the arrays. complete and push_back make them by themselves.
  bool is_measured() const { return roundings_.size() == size(); }
  void measure() {
    scales_.clear(), roundings_.clear();
    for (std::size_t s = 0; s < size(); ++s) measure((*this)[s]);
  }

  // Appends a complete joint-set, of affine joints if it has maps. What it has not of center images and dual parts is 0.
  void push_back(const PaletteEntry<S>& palette) {
    if (!palette.maps.empty()) return push_back_affine(palette.maps);
    transforms_.insert(transforms_.end(), palette.transforms.begin(), palette.transforms.end());
    rotation_centers_.push_back(palette.rotation_center);
    center_images_.insert(center_images_.end(), palette.center_images.begin(), palette.center_images.end());
    duals_.insert(duals_.end(), palette.duals.begin(), palette.duals.end());
    center_images_.resize(transforms_.size(), Vec<S, 3>(S(0), S(0), S(0)));
    duals_.resize(transforms_.size(), Quaternion<S>(S(0), S(0), S(0), S(0)));
    first_.push_back(transforms_.size());
    measure_last();
  }

 private:
  void measure(const PaletteEntry<S>& set) {
    if constexpr (std::is_floating_point_v<S>) {
      const DefaultFloatEnvironment environment;
      scales_.push_back(set.maps.empty() ? measure_palette(set.transforms, set.center_images) : measure_affine_palette(set.maps));
      roundings_.push_back(set.maps.empty() ? roundings_of(scales_.back()) : affine_roundings_of(scales_.back()));
    }
  }
  void measure_last() { measure((*this)[size() - 1]); }

  std::vector<std::size_t> first_ = {0};  // by joint-set, and one past the last: positions in the arrays by joint
  std::vector<Vec<S, 3>> rotation_centers_;
  std::vector<RigidTransform<S>> transforms_;
  std::vector<Vec<S, 3>> center_images_;
  std::vector<Quaternion<S>> duals_;
  std::vector<AffineMap<S>> maps_;  // of affine joints; else this and the next are empty
  std::vector<S> stretches_;
  std::vector<PaletteScales<S>> scales_;  // by joint-set
  std::vector<PaletteRoundings<S>> roundings_;
};

// Throws ModelError if a pose of so many transforms has the wrong length.
void check_joint_count(const SkinnedMesh& mesh, std::size_t count);

// Throws ModelError if pose has the wrong length, a number that is not finite, a translation beyond largest_coordinate, or
// a rotation whose squared length differs from 1 by more than 1e-6.
void check_pose(const SkinnedMesh& mesh, const Pose& pose);

// Throws ModelError if pose has the wrong length, a number that is not finite, an offset beyond largest_coordinate, or a number
// in a matrix beyond largest_stretch.
void check_pose(const SkinnedMesh& mesh, const AffinePose& pose);

// Returns the prior of a joint-set's rotation center, which the center is nearest to where it is not determined. It is the
// mean of the joints' origins. For Skinning::hejl it is the rotation center itself: the origin of the joint that two
// neighbouring bones share.
Point3 center_prior(const SkinnedMesh& mesh, std::span<const int> joints, Skinning skinning);

// Returns the palette of every joint-set for one frame. pose is by joint, as check_pose requires.
SkinningPalette<double> make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const Pose& pose,
                                              Skinning skinning);

// Does the same, but overwrites palette and uses its storage again. If it refuses the pose, palette is unchanged.
void make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const Pose& pose, Skinning skinning,
                           SkinningPalette<double>& palette);

// Do the same for linear skinning by affine joints.
SkinningPalette<double> make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& pose);
void make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& pose,
                           SkinningPalette<double>& palette);

}  // namespace refitlab
