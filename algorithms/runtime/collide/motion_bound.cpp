// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/collide/affine_boxes.hpp"
#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/packs/look_up.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {

MotionBound::MotionBound(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning)
    : mesh_(mesh),
      sets_(sets),
      skinning_(skinning),
      padded_joints_(look_up_size(static_cast<int>(mesh.joints.size()))),
      groups_(std::make_shared<const Groups>(pack(make_groups()))),
      numbers_(8 * padded_joints_ / Lanes<float>::count),
      unbounded_(groups_->packs.size()) {}

std::vector<MotionBound::Group> MotionBound::make_groups() const {
  const DefaultFloatEnvironment environment;
  std::vector<std::vector<Point3>> vertices(sets_.count());
  std::vector<Point3> priors;
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
    vertices[sets_.of_vertex(static_cast<int>(v))].push_back(mesh_.vertices[v]);
  for (int s = 0; s < sets_.count(); ++s) priors.push_back(center_prior(mesh_, sets_.joints(s), skinning_));

  const auto is_within = [&](int s, int t) {
    const auto a = sets_.joints(s), b = sets_.joints(t);
    return s != t && std::includes(b.begin(), b.end(), a.begin(), a.end()) &&
           (skinning_ != Skinning::hejl || priors[s] == priors[t]);
  };
  const auto ball_of = [&](const std::vector<int>& list) {
    std::vector<Point3> points;
    for (const int s : list) points.insert(points.end(), vertices[s].begin(), vertices[s].end());
    const Point3 center = skinning_ == Skinning::hejl ? priors[list[0]] : smallest_ball<double, 3>(points).center;
    double radius = 0;
    for (const Point3& p : points) radius = std::max(radius, (p - center).norm());
    return Ball3<double>{center, radius};
  };

  std::vector<Group> groups;
  std::vector<int> others;
  for (int s = 0; s < sets_.count(); ++s) {
    bool is_other = false;
    for (int t = 0; t < sets_.count(); ++t) is_other = is_other || is_within(s, t);
    if (is_other) others.push_back(s);
    else groups.push_back({{s}, ball_of({s}), Box<double>::empty(), {sets_.joints(s).begin(), sets_.joints(s).end()}, 0, 0});
  }
  // Each joint-set joins the group whose ball grows least.
  for (const int s : others) {
    Group* best = nullptr;
    Ball3<double> ball{Point3::Zero(), 0};
    for (Group& g : groups) {
      if (!is_within(s, g.sets[0])) continue;
      std::vector<int> list = g.sets;
      list.push_back(s);
      const Ball3<double> grown = ball_of(list);
      if (!best || grown.radius - g.reference.radius < ball.radius - best->reference.radius) best = &g, ball = grown;
    }
    best->sets.push_back(s);
    best->reference = ball;
  }

  for (Group& g : groups) {
    g.to_prior = 0;
    for (const int s : g.sets)
      for (const Point3& p : vertices[s]) g.box.merge(p);
    if (skinning_ == Skinning::spherical)
      for (const int s : g.sets) g.to_prior = std::max(g.to_prior, (g.reference.center - priors[s]).norm());
    g.radius = static_cast<float>(g.reference.radius * (1 + lost_of_motion_bound) +
                                  lost_of_motion_bound * static_cast<double>(g.joints.size()) * g.reference.center.norm());
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.joints.size() > b.joints.size(); });
  return groups;
}

// Puts the groups into packs. A group that does not deviate is in the hull of its joints' images, so it takes a few joints at a
// time.
MotionBound::Groups MotionBound::pack(std::vector<Group> groups) const {
  const DefaultFloatEnvironment environment;
  Groups out;
  out.all = std::move(groups), out.anchors = make_anchors(out.all);
  int lane = 0;
  for (std::size_t i = 0; i < out.all.size(); ++i) {
    const Group& g = out.all[i];
    const std::span<const int> joints = g.joints;
    out.most_joints = std::max(out.most_joints, static_cast<int>(joints.size()));
    out.are_bounded = out.are_bounded && can_be_bounded(g.reference);
    if (deviates() && joints.size() > most_motion_bound_joints) {
      out.others.push_back(static_cast<int>(i));
      continue;
    }
    for (std::size_t first = 0; first < joints.size(); first += most_motion_bound_joints) {
      if (lane == 0) out.packs.emplace_back();
      put_lane(out.packs.back(), lane,
               joints.subspan(first, std::min<std::size_t>(most_motion_bound_joints, joints.size() - first)), g.reference,
               g.to_prior, static_cast<int>(i));
      lane = (lane + 1) % motion_bound_lanes;
    }
  }
  return out;
}

JointAnchors MotionBound::make_anchors(const std::vector<Group>& groups) const {
  std::vector<std::vector<Point3>> points(mesh_.joints.size());
  for (const Group& g : groups)
    for (const int j : g.joints) points[static_cast<std::size_t>(j)].push_back(g.reference.center);
  return make_joint_anchors(points);
}

// Bounds a group by its rotation centers. Whatever the rotations, a vertex is within its distance to the rotation center of the
// hull of the center's images.
void MotionBound::add_about_centers(const Group& g, const Pose& pose, const Quaternion<double>& rotation,
                                    Box<double>& box) const {
  for (const int s : g.sets) {
    std::vector<RigidTransform<double>> transforms;
    for (const int j : sets_.joints(s)) transforms.push_back(pose[j]);
    const Point3 center = rotation_center<double>(transforms, center_prior(mesh_, sets_.joints(s), skinning_));
    for (const auto& t : transforms) {
      const Point3 image = apply(t, center), at = rotate(rotation, image);
      const double radius = (norm<double, 3>(center - g.reference.center) + g.radius) * (1 + lost_of_motion_bound) +
                            lost_of_motion_bound * norm(image);
      Box<double> about{at, at};
      about.grow(radius);
      box.merge(about);
    }
  }
}

// Runs the kernel on some packs, which places the joints, too. Returns false if nothing is known of them.
bool MotionBound::run(std::span<const MotionBoundPack> packs, const Pose& pose, const RigidTransform<double>& placement,
                      bool& is_rigid, Target target) {
  check_joint_count(mesh_, pose.size());
  defect_.reset();
  target_ = target;
  is_bounded_ = false;
  motion_bound_kernels(target).bound(pose[0].rotation.data(), static_cast<int>(pose.size()), placement.rotation.data(),
                                     packs.data(), static_cast<int>(packs.size()), deviates(), numbers_.data()->lane.data(),
                                     padded_joints_, bounds_, unbounded_.data());
  const float defect = bounds_.high[3], squared_farthest = -bounds_.low[3];
  const bool is_finite = squared_farthest < infinite;
  is_rigid = is_finite && defect <= surely_rigid;
  lost_of_joints_ = lost_of_motion_bound * groups_->most_joints * std::sqrt(static_cast<double>(squared_farthest));
  return is_finite && defect <= surely_not_rigid && groups_->are_bounded;
}

Box<double> MotionBound::box(const Pose& pose, const RigidTransform<double>& placement, bool& is_rigid, Target target) {
  const DefaultFloatEnvironment environment;
  const auto& packs = groups_->packs;
  if (!run(packs, pose, placement, is_rigid, target)) return Box<double>::everything();
  Box<double> box{{bounds_.low[0], bounds_.low[1], bounds_.low[2]}, {bounds_.high[0], bounds_.high[1], bounds_.high[2]}};
  const auto add_unbounded = [&](int group) {
    if (skinning_ == Skinning::dual_quaternion) box = Box<double>::everything();
    else add_about_centers(groups_->all[group], pose, placement.rotation, box);
  };
  for (const int group : groups_->others) add_unbounded(group);
  for (std::size_t p = 0; p < packs.size(); ++p)
    for (std::uint32_t lanes = unbounded_[p]; lanes; lanes &= lanes - 1) add_unbounded(packs[p].target[std::countr_zero(lanes)]);
  is_bounded_ = std::isfinite(box.low[0]);
  move_box(box, placement.translation, lost());
  return box;
}

bool MotionBound::place_checked(const Pose& pose, const RigidTransform<double>& placement) {
  const DefaultFloatEnvironment environment;
  bool is_rigid;
  const bool is_known = run({}, pose, placement, is_rigid, best_target());
  if (!is_rigid) check_pose(mesh_, pose);
  return is_known;
}

std::optional<MotionBound::Posed> MotionBound::posed() const {
  const DefaultFloatEnvironment environment;
  if (!is_bounded_ || !groups_->others.empty()) return {};
  Posed out{{{bounds_.low[0], bounds_.low[1], bounds_.low[2]}, {bounds_.high[0], bounds_.high[1], bounds_.high[2]}},
            *std::min_element(std::begin(bounds_.cosine), std::end(bounds_.cosine)),
            *std::max_element(std::begin(bounds_.spread), std::end(bounds_.spread)),
            std::sqrt(-static_cast<double>(bounds_.low[3]))};
  out.turned.grow(lost());
  return out;
}

Box<double> MotionBound::checked_box(const Pose& pose, const RigidTransform<double>& placement) {
  bool is_rigid;
  Box<double> out = box(pose, placement, is_rigid);
  if (!is_rigid) check_pose(mesh_, pose);
  return out;
}

Box<double> MotionBound::box(const AffinePose& pose, const RigidTransform<double>& placement) const {
  const DefaultFloatEnvironment environment;
  check_joint_count(mesh_, pose.size());
  AffinePose placed;
  for (const AffineMap<double>& map : pose) placed.push_back(turned(placement.rotation, map));
  auto box = Box<double>::empty();
  for (const Group& g : groups_->all)
    for (const int j : g.joints) {
      // A vertex of all of these joints is off by as many roundings.
      const AffineMap<double>& map = placed[static_cast<std::size_t>(j)];
      box.merge(box_of_image(map, g.reference, g.box, sizes_of(map, static_cast<int>(g.joints.size()))));
    }
  move_box(box, placement.translation, 0);
  return box;
}

bool MotionBound::boxes(std::span<const MotionBoundPiecePack> packs, const Pose& pose, std::span<FlippedBox> out) {
  const DefaultFloatEnvironment environment;
  for (FlippedBox& b : out) b.set_all(std::numeric_limits<float>::infinity());
  if (!defect_) {
    defect_ = 0;
    for (const auto& joint : pose) defect_ = std::max(*defect_, std::abs(squared_norm(joint.rotation) - 1));
  }
  return bound_motion_pieces(target_)(numbers_.data()->lane.data(), static_cast<int>(pose.size()), padded_joints_, packs.data(),
                                      static_cast<int>(packs.size()), deviates(), error_share(*defect_), out.data());
}

}  // namespace refitlab
