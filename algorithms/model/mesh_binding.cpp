// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/mesh_binding.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <tuple>

namespace refitlab {
namespace {

// A mesh may be placed by any map, as its joints undo it, but what a joint has flattened at rest comes back as rounding alone.
// This is the least that a map may stretch, as a share of the most: rounding grows by the square of its inverse.
constexpr double least_stretch = 1e-3;

bool can_place(const Eigen::Matrix4d& map) {
  if (!map.allFinite()) return false;
  const Eigen::Vector3d stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(map.topLeftCorner<3, 3>()).singularValues();
  return stretches[2] > least_stretch * stretches[0];
}

using Corners = std::vector<Eigen::Vector4d>;

// Returns the corners of the box of these points, or of these displacements if w is 0. Two maps that agree there agree on all of
// them.
Corners box_corners(const std::vector<Eigen::Vector3d>& points, double w) {
  Eigen::Vector3d low = points[0], high = low;
  for (const Eigen::Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Corners corners;
  for (int c = 0; c < 8; ++c)
    corners.emplace_back(c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2], w);
  return corners;
}

// Holds where the vertices of a primitive are, and by what its morph targets move them.
struct Extent {
  Corners box;
  std::vector<Corners> displacements;  // by target
};
Extent extent_of(const ScenePrimitive& primitive) {
  Extent out{box_corners(primitive.positions, 1), {}};
  for (const auto& target : primitive.targets) out.displacements.push_back(box_corners(target, 0));
  return out;
}

double farthest_apart(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, const Corners& corners) {
  double out = 0;
  for (const auto& corner : corners) out = std::max(out, ((a - b) * corner).head<3>().norm());
  return out;
}

// a and b take the box to the same place, within `tolerance` of its diagonal.
bool agree(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, const Corners& box, double tolerance) {
  return farthest_apart(a, b, box) <= tolerance * (a * (box[7] - box[0])).head<3>().norm();
}

// a and b do the same to the vertices, wherever morph targets move them: a flat mesh may be moved out of its plane.
bool agree(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, const Extent& extent, double tolerance) {
  return agree(a, b, extent.box, tolerance) &&
         std::all_of(extent.displacements.begin(), extent.displacements.end(), [&](const Corners& moved) {
           return farthest_apart(a, b, moved) <= tolerance * farthest_apart(a, Eigen::Matrix4d::Zero(), moved);
         });
}

constexpr double same_joint_tolerance = 1e-12;  // rounding of double: a joint stands for another one only if it does the same
// Any placement is right. The file's coordinates are kept where the mesh is alone, or the frames differ by the rounding of float.
constexpr double same_frame_tolerance = 1e-6, same_frame_tolerance_alone = 1e-3;

constexpr double affine_tolerance = 1e-6;  // of the last row of an offset matrix

class Binder {
 public:
  explicit Binder(const Scene& scene) : scene_(scene) { globals_ = global_transforms(scene.nodes, Animation{}, 0); }

  BoundPrimitive bind(int shown, int primitive) {
    const ShownMesh& use = scene_.shown[shown];
    BoundPrimitive bound{shown, primitive, Eigen::Matrix4d::Identity(), {}};
    const Extent extent = extent_of(scene_.meshes[use.mesh].primitives[primitive]);
    if (use.skin < 0) bind_to_node(use.node, extent, bound);
    else bind_to_skin(scene_.skins[use.skin], extent, bound);
    return bound;
  }

  std::vector<BoundJoint> joints_;

 private:
  void bind_to_skin(const SceneSkin& skin, const Extent& extent, BoundPrimitive& bound) {
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const Eigen::Matrix4d& offset = skin.offsets[j];
      const std::string thing = "bone '" + scene_.nodes[skin.joints[j]].name + "'";
      if (!offset.allFinite() || offset.determinant() == 0)
        throw ModelError(scene_.file, thing, "its offset matrix is singular or not finite");
      if ((offset.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() > affine_tolerance)
        throw ModelError(scene_.file, thing, "its offset matrix is not affine");
    }
    if (!joints_.empty()) bound.placement = placement(skin.joints, skin.offsets, extent.box);
    const Eigen::Matrix4d back = bound.placement.inverse();
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      bound.joints.push_back(joint(skin.joints[j], skin.offsets[j], skin.offsets[j] * back, bound.placement, extent));
  }

  void bind_to_node(int node, const Extent& extent, BoundPrimitive& bound) {
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].node == node && made_[j].own == identity) {  // of the mesh's primitives, or as a skin has it
        bound.placement = made_[j].placement, bound.joints = {static_cast<int>(j)};
        return;
      }
    bound.placement = rest_frame(node);
    // A node that is hidden by a scale of 0 carries its mesh in its own frame.
    if (!can_place(bound.placement)) bound.placement = identity;
    bound.joints = {joint(node, identity, bound.placement.inverse(), bound.placement, extent)};
  }

  int joint_of_node(int node) const {
    const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const auto& j) { return j.node == node; });
    return found == joints_.end() ? -1 : static_cast<int>(found - joints_.begin());
  }

  // Returns the map from a node's frame to the reference pose, as the file has it relative to the nearest joint.
  Eigen::Matrix4d rest_frame(int node) const {
    int nearest = -1;
    for (int n = node; n >= 0 && nearest < 0; n = scene_.nodes[n].parent) nearest = joint_of_node(n);
    const BoundJoint& j = joints_[std::max(nearest, 0)];
    if (j.node == node) return j.offset.inverse();
    return (globals_[j.node] * j.offset).inverse() * globals_[node];
  }

  // Returns the map from the mesh's frame to the reference pose, by a bone that another mesh has used, or else by its first bone.
  Eigen::Matrix4d placement(const std::vector<int>& nodes, const std::vector<Eigen::Matrix4d>& offsets,
                            const Corners& box) const {
    std::size_t b = 0;
    while (b < nodes.size() && joint_of_node(nodes[b]) < 0) ++b;
    const double tolerance = b < nodes.size() ? same_frame_tolerance : same_frame_tolerance_alone;
    if (b == nodes.size()) b = 0;
    const Eigen::Matrix4d found = rest_frame(nodes[b]) * offsets[b];
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    const bool keep = !can_place(found) || agree(identity, found, box, tolerance);
    return keep ? identity : found;
  }

  // Returns the joint of a node whose offset, after the mesh's placement, does what `own` does to the mesh. Makes it if there is
  // none. Where one was made of the same matrices, it is the same in any unit.
  int joint(int node, const Eigen::Matrix4d& own, const Eigen::Matrix4d& offset, const Eigen::Matrix4d& placement,
            const Extent& extent) {
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].node == node && ((made_[j].own == own && made_[j].placement == placement) ||
                                      agree(own, joints_[j].offset * placement, extent, same_joint_tolerance)))
        return static_cast<int>(j);
    joints_.push_back({scene_.nodes[node].name, node, -1, offset});
    made_.push_back({own, placement});
    return static_cast<int>(joints_.size()) - 1;
  }

  // Holds what a joint was made of: the offset that the file has, and the placement of the mesh.
  struct Made {
    Eigen::Matrix4d own, placement;
  };

  const Scene& scene_;
  std::vector<Made> made_;  // by joint
  std::vector<Eigen::Matrix4d> globals_;
};

// Puts joints in the order of their nodes, so that parents come first, and gives each its parent. Returns the new index by the
// old one.
std::vector<int> order_joints(std::vector<BoundJoint>& joints, const std::vector<SceneNode>& nodes) {
  std::vector<int> old(joints.size()), fresh(joints.size()), first_of_node(nodes.size(), -1);
  for (std::size_t j = 0; j < old.size(); ++j) old[j] = static_cast<int>(j);
  std::stable_sort(old.begin(), old.end(), [&](int a, int b) { return joints[a].node < joints[b].node; });
  std::vector<BoundJoint> ordered;
  for (const int j : old) {
    const int index = static_cast<int>(ordered.size());
    fresh[j] = index;
    ordered.push_back(joints[j]);
    BoundJoint& joint = ordered.back();
    for (int n = nodes[joint.node].parent; n >= 0 && joint.parent < 0; n = nodes[n].parent) joint.parent = first_of_node[n];
    if (first_of_node[joint.node] < 0) first_of_node[joint.node] = index;
  }
  joints = std::move(ordered);
  return fresh;
}

bool weights_move(const Scene& scene, int node) {
  for (const Animation& motion : scene.animations)
    for (const WeightTrack& track : motion.weight_tracks)
      if (track.node == node) return true;
  return false;
}

}  // namespace

BoundScene bind_meshes(const Scene& scene) {
  BoundScene out;
  // The joints of a skinned mesh say where it is, so it is there once, however many nodes show it. The key is the mesh, the skin,
  // the weights of morph targets, and, if a clip moves these, the node that has them.
  std::map<std::tuple<int, int, std::vector<double>, int>, int> skinned;
  for (std::size_t s = 0; s < scene.shown.size(); ++s) {
    const ShownMesh& use = scene.shown[s];
    const int node = weights_move(scene, use.node) ? use.node : -1;
    if (use.skin >= 0) {
      const auto [first, is_new] = skinned.try_emplace({use.mesh, use.skin, use.weights, node}, static_cast<int>(s));
      if (!is_new) out.repeated.push_back({static_cast<int>(s), first->second});
      if (!is_new) continue;
    }
    const std::vector<ScenePrimitive>& primitives = scene.meshes[use.mesh].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p)
      if (!primitives[p].triangles.empty())
        out.primitives.push_back({static_cast<int>(s), static_cast<int>(p), Eigen::Matrix4d::Identity(), {}});
  }
  const auto is_skinned = [&](const BoundPrimitive& bound) { return scene.shown[bound.shown].skin >= 0; };
  if (std::none_of(out.primitives.begin(), out.primitives.end(), is_skinned)) {
    const bool shows_skin =
        std::any_of(scene.shown.begin(), scene.shown.end(), [](const ShownMesh& use) { return use.skin >= 0; });
    throw ModelError(scene.file, "file",
                     shows_skin            ? "no triangle: of the meshes that have bones, none has triangles"
                     : scene.skins.empty() ? "no skin: no mesh has bones"
                                           : "no skin: the scene shows no mesh with bones, though the file has skins");
  }

  Binder binder(scene);
  for (const bool skinned_first : {true, false})
    for (BoundPrimitive& bound : out.primitives)
      if (is_skinned(bound) == skinned_first) bound = binder.bind(bound.shown, bound.primitive);
  out.joints = std::move(binder.joints_);
  const std::vector<int> fresh = order_joints(out.joints, scene.nodes);
  for (BoundPrimitive& bound : out.primitives)
    for (int& joint : bound.joints) joint = fresh[joint];
  return out;
}

}  // namespace refitlab
