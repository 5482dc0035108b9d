// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/mesh_binding.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <set>

namespace refitlab {
namespace {

// The corners of the box of a mesh: where two placements agree there, they agree on the mesh.
std::vector<Eigen::Vector4d> box_corners(const aiMesh& mesh) {
  Eigen::Vector3d low = to_eigen(mesh.mVertices[0]), high = low;
  for (unsigned v = 1; v < mesh.mNumVertices; ++v) {
    low = low.cwiseMin(to_eigen(mesh.mVertices[v]));
    high = high.cwiseMax(to_eigen(mesh.mVertices[v]));
  }
  std::vector<Eigen::Vector4d> corners;
  for (int c = 0; c < 8; ++c)
    corners.emplace_back(c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2], 1);
  return corners;
}

// a and b take the box to the same place, within `tolerance` of its diagonal.
bool agree(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, const std::vector<Eigen::Vector4d>& box, double tolerance) {
  double apart = 0;
  for (const auto& corner : box) apart = std::max(apart, ((a - b) * corner).norm());
  return apart <= tolerance * (a * (box[7] - box[0])).norm();
}

constexpr double same_joint_tolerance = 1e-6;  // float rounding of offset matrices
constexpr double same_frame_tolerance = 1e-3;  // of a mesh alone, any placement is right: keep the file's coordinates

class Binder {
 public:
  Binder(const NodeTree& tree, const std::string& file) : tree_(tree), file_(file) {
    globals_ = global_transforms(tree.nodes(), Animation{}, 0);
  }

  BoundMesh bind_skinned(const aiMesh& mesh) {
    BoundMesh bound{&mesh, Eigen::Matrix4d::Identity(), {}};
    const auto box = box_corners(mesh);
    std::vector<int> nodes;
    std::vector<Eigen::Matrix4d> offsets;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const std::string thing = "bone '" + std::string(bone.mName.C_Str()) + "'";
      nodes.push_back(tree_.find(bone.mName.C_Str()));
      offsets.push_back(to_eigen(bone.mOffsetMatrix));
      if (nodes.back() < 0) throw ModelError(file_, thing, "no node has this name");
      if (!offsets.back().allFinite() || offsets.back().determinant() == 0)
        throw ModelError(file_, thing, "its offset matrix is singular or not finite");
    }
    if (!joints_.empty()) bound.placement = placement(nodes, offsets, box);
    const Eigen::Matrix4d back = bound.placement.inverse();
    for (std::size_t b = 0; b < nodes.size(); ++b)
      bound.joints.push_back(joint(nodes[b], offsets[b], offsets[b] * back, bound.placement, box));
    return bound;
  }

  BoundMesh bind_to_node(const aiMesh& mesh, int node) {
    const Eigen::Matrix4d rest = rest_frame(node);
    if (!rest.allFinite() || rest.determinant() == 0)
      throw ModelError(file_, "node '" + tree_.nodes()[node].name + "'", "its transform is singular");
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    return {&mesh, rest, {joint(node, identity, rest.inverse(), rest, box_corners(mesh))}};
  }

  std::vector<BoundJoint> joints_;

 private:
  int joint_of_node(int node) const {
    const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const auto& j) { return j.node == node; });
    return found == joints_.end() ? -1 : static_cast<int>(found - joints_.begin());
  }

  // The frame of a node, to the reference pose, as it is in the file relative to the nearest joint.
  Eigen::Matrix4d rest_frame(int node) const {
    int nearest = -1;
    for (int n = node; n >= 0 && nearest < 0; n = tree_.nodes()[n].parent) nearest = joint_of_node(n);
    const BoundJoint& j = joints_[std::max(nearest, 0)];
    if (j.node == node) return j.offset.inverse();
    return (globals_[j.node] * j.offset).inverse() * globals_[node];
  }

  // From the mesh's frame to the reference pose, by a bone that another mesh has used, or else by its first.
  Eigen::Matrix4d placement(const std::vector<int>& nodes, const std::vector<Eigen::Matrix4d>& offsets,
                            const std::vector<Eigen::Vector4d>& box) const {
    std::size_t b = 0;
    while (b < nodes.size() && joint_of_node(nodes[b]) < 0) ++b;
    const double tolerance = b < nodes.size() ? same_joint_tolerance : same_frame_tolerance;
    if (b == nodes.size()) b = 0;
    const Eigen::Matrix4d found = rest_frame(nodes[b]) * offsets[b];
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    const bool keep = !found.allFinite() || found.determinant() == 0 || agree(identity, found, box, tolerance);
    return keep ? identity : found;
  }

  // The joint of a node whose offset, after the mesh's placement, does what `own` does to the mesh; made where there is
  // none.
  int joint(int node, const Eigen::Matrix4d& own, const Eigen::Matrix4d& offset, const Eigen::Matrix4d& placement,
            const std::vector<Eigen::Vector4d>& box) {
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].node == node && agree(own, joints_[j].offset * placement, box, same_joint_tolerance))
        return static_cast<int>(j);
    joints_.push_back({tree_.nodes()[node].name, node, -1, offset});
    return static_cast<int>(joints_.size()) - 1;
  }

  const NodeTree& tree_;
  std::string file_;
  std::vector<Eigen::Matrix4d> globals_;
};

// Joints in the order of their nodes, so that parents come first; gives each its parent. Returns new index by old.
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

}  // namespace

BoundScene bind_meshes(const aiScene& scene, const NodeTree& tree, const std::string& file) {
  struct Use {
    int node;
    const aiMesh* mesh;
  };
  std::vector<Use> uses;
  std::set<const aiMesh*> skinned;
  for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
    const aiNode& source = tree.source(static_cast<int>(n));
    for (unsigned m = 0; m < source.mNumMeshes; ++m) {
      const aiMesh* mesh = scene.mMeshes[source.mMeshes[m]];
      const auto is_triangle = [](const aiFace& face) { return face.mNumIndices == 3; };
      if (std::none_of(mesh->mFaces, mesh->mFaces + mesh->mNumFaces, is_triangle)) continue;
      // The bones of a skinned mesh say where it is; it is there once, however many nodes refer to it.
      if (!mesh->HasBones() || skinned.insert(mesh).second) uses.push_back({static_cast<int>(n), mesh});
    }
  }
  if (skinned.empty()) throw ModelError(file, "file", "no skin: no mesh has bones");

  BoundScene out;
  out.meshes.resize(uses.size());
  Binder binder(tree, file);
  for (std::size_t u = 0; u < uses.size(); ++u)
    if (uses[u].mesh->HasBones()) out.meshes[u] = binder.bind_skinned(*uses[u].mesh);
  for (std::size_t u = 0; u < uses.size(); ++u)
    if (!uses[u].mesh->HasBones()) out.meshes[u] = binder.bind_to_node(*uses[u].mesh, uses[u].node);
  out.joints = std::move(binder.joints_);
  const std::vector<int> fresh = order_joints(out.joints, tree.nodes());
  for (BoundMesh& mesh : out.meshes)
    for (int& joint : mesh.joints) joint = fresh[joint];
  return out;
}

}  // namespace refitlab
