// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "algorithms/runtime/collide/affine_boxes.hpp"
#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns a box around another one whose coordinates may be off by lost, grown by growth_of_float_box.
Box<float> float_box(const Box<double>& box, double lost) {
  Box<float> out;
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (const double side : {box.low[i], box.high[i]}) {
      // What is undefined, or nearly beyond the range of float, may be anywhere.
      if (!(std::abs(side) < largest_box)) return Box<float>::everything();
      largest = max_of(largest, std::abs(side));
    }
  const float off = growth_of_float_box(lost, largest);
  for (int i = 0; i < 3; ++i)
    out.low[i] = static_cast<float>(box.low[i]) - off, out.high[i] = static_cast<float>(box.high[i]) + off;
  return off < std::numeric_limits<float>::infinity() ? out : Box<float>::everything();
}

// Puts box i, which may be off by lost, into blocks, and merges it into whole.
void put_float_box(const Box<double>& box, double lost, int i, BoxBlock<float>* blocks, Box<float>& whole) {
  const Box<float> in_float = float_box(box, lost);
  whole.merge(in_float);
  put_box(blocks, i, in_float);
}

}  // namespace

ClusterBody::ClusterBody(const ClusterTree& tree, Skinning skinning)
    : tree_(tree),
      way_(tree.way_of(skinning)),
      pose_change_(way_.motion_bound),
      skinning_(skinning),
      motion_bound_(way_.motion_bound),
      clusters_(tree, skinning),
      joints_(tree.character().sets),
      wide_nodes_made_(tree.wide_nodes().size()),
      wide_node_boxes_(tree.wide_nodes().size()) {
  int blocks = 0, most = 0;
  for (const WideNode& f : tree.wide_nodes())
    first_block_of_wide_node_.push_back(blocks), blocks += blocks_of(f.child_count), most = std::max(most, f.child_count);
  wide_node_blocks_.resize(blocks);
  flipped_.resize(most), boxes_.resize(most);
}

void ClusterBody::begin(const Pose& pose, const RigidTransform<double>& placement, const Deformation& deformation) try {
  const DefaultFloatEnvironment environment;
  check_placement(placement, tree_.character().mesh.name, "the body's placement");
  const SkinnedMesh& mesh = tree_.character().mesh;
  std::optional<Box<double>> bound, coarse_bound;
  are_joints_placed_ = false;  // a frame before does without them if this one is refused
  bool are_placed = false;
  if (!deformation.is_none() || need_ == Need::skin) check_pose(mesh, pose);
  else if (need_ == Need::nodes) are_placed = motion_bound_.place_checked(pose, placement);
  else if (coarse_bound = pose_change_.box(pose, placement); !coarse_bound) bound = motion_bound_.checked_box(pose, placement);
  const DeformedReference* const reference = deform(deformation);
  // Nothing is refused from here on.
  pose_ = pose;
  placement_ = placement;
  is_motion_bound_made_ = false;
  are_joints_placed_ = are_placed;
  if (bound) set_motion_bound(*bound);
  coarse_bound_ = coarse_bound;
  is_affine_ = false;
  clusters_.begin(pose_, placement_, placement_.translation, reference);
  start();
} catch (const std::bad_alloc&) {
  lose_frame();
  throw;
}

void ClusterBody::begin(const AffinePose& pose, const RigidTransform<double>& placement, const std::vector<double>& weights) try {
  if (skinning_ != Skinning::linear) {
    const auto [rigid, scales] = split(tree_.character().mesh, pose);
    return begin(rigid, placement, {weights, scales});
  }
  const DefaultFloatEnvironment environment;
  check_placement(placement, tree_.character().mesh.name, "the body's placement");
  check_pose(tree_.character().mesh, pose);
  const DeformedReference* const reference = deform({weights, {}});
  clusters_.begin(pose, placement, placement.translation, reference);
  placement_ = placement;
  is_affine_ = true;
  coarse_bound_.reset();
  is_motion_bound_made_ = !is_deformed_;
  if (!is_deformed_) motion_bound_box_ = motion_bound_.box(pose, placement);
  start();
} catch (const std::bad_alloc&) {
  lose_frame();
  throw;
}

// Returns the reference of a frame, which is none if nothing deforms it.
const DeformedReference* ClusterBody::deform(const Deformation& deformation) {
  if (deformation.is_none()) {
    is_deformed_ = false;
    return nullptr;
  }
  if (!deformed_) deformed_.emplace(tree_.character(), default_variant(skinning_));
  deformed_->reference.begin(deformation);
  deformed_->are_balls_begun = false;
  is_deformed_ = true;
  return &deformed_->reference;
}

void ClusterBody::start() {
  are_floats_filled_ = is_rather_skinned_ = is_shared_ = false;
  wide_nodes_made_.begin();
  nodes_bounded_ = work_ = 0;
  need_ = Need::bound;
}

// Some of what belongs to a frame is that of the next one already.
void ClusterBody::lose_frame() {
  clusters_.end();
  wide_nodes_made_.begin();
  is_motion_bound_made_ = false;
  coarse_bound_.reset();
}

void ClusterBody::make_motion_bound() {
  const DefaultFloatEnvironment environment;
  clusters_.require_frame();
  if (coarse_bound_) give_up_coarse_bound();
  if (!is_deformed_) return set_motion_bound(motion_bound_.box(pose_, placement_));
  motion_bound_box_ = box_of_deformed(0);
  const Point3& to = placement_.translation;
  for (int i = 0; i < 3; ++i) {
    const double lost = clusters_.lost() + lost_of_placements * (std::abs(to[i]) + std::abs(motion_bound_box_.low[i]) +
                                                                 std::abs(motion_bound_box_.high[i]));
    motion_bound_box_.low[i] += to[i] - lost, motion_bound_box_.high[i] += to[i] + lost;
  }
  is_motion_bound_made_ = true;
}

// Returns a box around the node's ball in the placement's rotation, with what is lost by it (lost_of_placements, and
// collide.cpp).
Box<double> ClusterBody::box_of_deformed(int node) {
  if (!deformed_->are_balls_begun) {
    deformed_->balls.begin(clusters_.measured_palette(), &deformed_->reference);
    deformed_->are_balls_begun = true;
  }
  const Ball3<double>& ball = deformed_->balls[node];
  const double defect = std::abs(squared_norm(placement_.rotation) - 1);
  const Point3 center = rotate<double>(placement_.rotation, ball.center);
  const double reach = ball.radius +
                       (lost_of_placements + 4 * error_of_rotate(defect)) * (upper_norm(ball.center) + ball.radius) +
                       least_float_slack;
  if (!(reach < std::numeric_limits<double>::infinity())) return Box<double>::everything();
  return {center - Point3::Constant(reach), center + Point3::Constant(reach)};
}

void ClusterBody::set_motion_bound(const Box<double>& box) {
  motion_bound_box_ = box;
  is_motion_bound_made_ = true;
  are_joints_placed_ = std::isfinite(box.low[0]);
  pose_change_.start(motion_bound_, pose_, placement_);
}

Box<double> ClusterBody::coarse_bound_of(const Pose& pose, const RigidTransform<double>& placement, MotionBound& motion_bound,
                                         bool& is_coarse) {
  check_placement(placement, tree_.character().mesh.name, "the body's placement");
  const auto coarse = pose_change_.box(pose, placement);
  is_coarse = coarse.has_value();
  if (coarse) return *coarse;
  Box<double> box = motion_bound.checked_box(pose, placement);
  pose_change_.start(motion_bound, pose, placement);
  return box;
}

void ClusterBody::skin_all() {
  if (is_all_skinned()) return;
  clusters_.skin_all();
  wide_nodes_made_.begin();
}

void ClusterBody::bound_wide_node(int f) {
  const DefaultFloatEnvironment environment;
  clusters_.require_frame();
  const WideNode& wide_node = tree_.wide_nodes()[f];
  BoxBlock<float>* const blocks = wide_node_blocks(f);
  Box<float>& whole = wide_node_boxes_[f] = Box<float>::empty();
  if (is_all_skinned() || (is_rather_skinned_ && has_only_clusters(f))) {
    box_skinned(wide_node, blocks, whole);
    if (wide_node.place.wide_node >= 0 && !is_all_skinned()) cut_box(wide_node.place, whole);
    return wide_nodes_made_.mark(f);
  }
  // The boxes are as seen from the placement's translation, which is the clusters' origin.
  if (is_deformed_ || is_affine_) {
    bound_in_double(f);
    for (int i = 0; i < wide_node.child_count; ++i) put_float_box(boxes_[i], clusters_.lost(), i, blocks, whole);
  } else {
    const double lost = clusters_.lost() + bound_in_float(wide_node);
    if (!box_kernels(best_target()).put_grown(flipped_.data(), wide_node.child_count, lost, blocks, whole))
      for (int i = 0; i < wide_node.child_count; ++i) put_float_box(flipped_[i].box(), lost, i, blocks, whole);
  }
  nodes_bounded_ += wide_node.child_count;
  work_ += work_of_motion_bounds * static_cast<long>(wide_node.motion_bounds.size()) +
           long{work_of_bounded_node} * wide_node.child_count;
  wide_nodes_made_.mark(f);
}

// Bounds the children of a wide node of a deformed body, or of affine joints.
void ClusterBody::bound_in_double(int f) {
  const WideNode& wide_node = tree_.wide_nodes()[f];
  if (is_deformed_)
    for (int i = 0; i < wide_node.child_count; ++i) boxes_[i] = box_of_deformed(tree_.child(f, i).node);
  else
    bound_affine_boxes(wide_node.simplex_pieces, clusters_.whole_palette(), placement_.rotation,
                       {boxes_.data(), static_cast<std::size_t>(wide_node.child_count)});
}

// Bounds the children of a wide node by motion bounds, or by control points where the former know nothing of some child. Returns
// what the coordinates may be off by.
double ClusterBody::bound_in_float(const WideNode& wide_node) {
  const std::span<FlippedBox> boxes(flipped_.data(), wide_node.child_count);
  if (!wide_node.motion_bounds.empty() && skinning_ != Skinning::hejl) {
    if (place_joints() && motion_bound_.boxes(wide_node.motion_bounds, pose_, boxes)) return motion_bound_.lost();
  }
  const SkinningPalette<double>& palette = clusters_.whole_palette();
  if (!are_floats_filled_) joints_.fill(palette, skinning_), are_floats_filled_ = true;
  bound_boxes(wide_node.pieces, skinning_, joints_, palette, placement_.rotation, boxes);
  return 0;
}

// Returns false if nothing is known of the joints.
bool ClusterBody::place_joints() {
  if (!are_joints_placed_ && !is_motion_bound_made_) are_joints_placed_ = motion_bound_.place_checked(pose_, placement_);
  return are_joints_placed_;
}

bool ClusterBody::has_only_clusters(int wide_node) const {
  for (int i = 0; i < tree_.wide_nodes()[wide_node].child_count; ++i)
    if (tree_.child(wide_node, i).cluster < 0) return false;
  return true;
}

// Both boxes have four roundings to spare. If the wide node is not made in this frame, its boxes are those of another one.
void ClusterBody::cut_box(ChildPlace place, const Box<float>& to) {
  if (!wide_nodes_made_.is_made(place.wide_node)) return;
  BoxBlock<float>* const blocks = wide_node_blocks(place.wide_node);
  Box<float> box = get_box(blocks, place.child);
  box.cut(to);
  put_box(blocks, place.child, box);
}

// The boxes of wide nodes below come first.
void ClusterBody::box_skinned(const WideNode& wide_node, BoxBlock<float>* blocks, Box<float>& whole) {
  for (int i = 0; i < wide_node.child_count; ++i) {
    const WideNodeChild& child = tree_.child(static_cast<int>(&wide_node - tree_.wide_nodes().data()), i);
    const Box<float> box = child.cluster >= 0 ? clusters_.cluster(child.cluster).box : wide_node_box(child.wide_node);
    whole.merge(box);
    put_box(blocks, i, box);
  }
}

}  // namespace refitlab
