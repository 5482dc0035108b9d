// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_nodes.hpp"

#include <cmath>

namespace refitlab {
namespace {

constexpr double least_quaternion = 1e-6;  // the norm of one that is taken for a rotation

std::string node_label(const tinygltf::Model& source, std::size_t node) {
  const std::string& name = source.nodes[node].name;
  return "node " + std::to_string(node) + (name.empty() ? "" : " '" + name + "'");
}

Eigen::Vector3d vector_or(const std::vector<double>& numbers, const Eigen::Vector3d& otherwise, const std::string& file,
                          const std::string& thing) {
  if (numbers.empty()) return otherwise;
  if (numbers.size() != 3) throw ModelError(file, thing, "a translation or scale does not have 3 numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

SceneNode scene_node(const tinygltf::Node& node, const std::string& name, int parent, int source, const std::string& file,
                     const std::string& thing) {
  if (node.matrix.empty()) {
    const NodeTransform rest = rest_transform(node, file, thing);
    return {name, parent, matrix_of(rest), source, rest};
  }
  if (node.matrix.size() != 16) throw ModelError(file, thing, "its matrix does not have 16 numbers");
  const Eigen::Matrix4d local = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
  if (local.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) throw ModelError(file, thing, "its matrix is no affine map");
  return {name, parent, local, source};
}

// Returns each node's parent, or -1.
std::vector<int> parents_of(const tinygltf::Model& source, const std::string& file) {
  std::vector<int> out(source.nodes.size(), -1);
  for (std::size_t n = 0; n < source.nodes.size(); ++n)
    for (const int child : source.nodes[n].children) {
      if (static_cast<std::size_t>(child) >= out.size())
        throw ModelError(file, node_label(source, n), "has a child that there is not");
      if (out[child] >= 0)
        throw ModelError(file, node_label(source, static_cast<std::size_t>(child)), "is the child of two nodes, or twice of one");
      out[child] = static_cast<int>(n);
    }
  return out;
}

std::vector<int> scene_roots(const tinygltf::Model& source, const std::vector<int>& parents, const std::string& file) {
  if (source.scenes.empty()) {
    if (source.defaultScene >= 0) throw ModelError(file, "file", "its default scene is one that there is not");
    std::vector<int> out;
    for (std::size_t n = 0; n < parents.size(); ++n)
      if (parents[n] < 0) out.push_back(static_cast<int>(n));
    return out;
  }
  const std::size_t scene = source.defaultScene < 0 ? 0 : static_cast<std::size_t>(source.defaultScene);
  if (scene >= source.scenes.size()) throw ModelError(file, "file", "its default scene is one that there is not");
  for (const int root : source.scenes[scene].nodes)
    if (static_cast<std::size_t>(root) >= parents.size() || parents[root] >= 0)
      throw ModelError(file, "scene " + std::to_string(scene),
                       "names node " + std::to_string(root) + ", which is below another or not there");
  return source.scenes[scene].nodes;
}

class Order {
 public:
  Order(const tinygltf::Model& source, const std::string& file) : source_(source), file_(file) {
    out.places.assign(source.nodes.size(), -1);
  }

  // Adds a node with all nodes below it, parents before children, and children in the order of the file.
  void add_tree(int root) {
    std::vector<std::pair<int, int>> waiting = {{root, -1}};  // a node, and its parent in this order
    while (!waiting.empty()) {
      const auto [node, parent] = waiting.back();
      waiting.pop_back();
      const auto n = static_cast<std::size_t>(node);
      if (out.places[n] >= 0) throw ModelError(file_, node_label(source_, n), "is in the scene twice");
      const int place = static_cast<int>(out.nodes.size());
      out.places[n] = place;
      const std::string& name = source_.nodes[n].name;
      out.nodes.push_back(scene_node(source_.nodes[n], name.empty() ? "node " + std::to_string(n) : name, parent, node, file_,
                                     node_label(source_, n)));
      const std::vector<int>& children = source_.nodes[n].children;
      for (auto child = children.rbegin(); child != children.rend(); ++child) waiting.emplace_back(*child, place);
    }
  }

  GltfNodes out;

 private:
  const tinygltf::Model& source_;
  const std::string& file_;
};

}  // namespace

NodeTransform rest_transform(const tinygltf::Node& node, const std::string& file, const std::string& thing) {
  if (!node.matrix.empty()) throw ModelError(file, thing, "is moved by a clip, but has a matrix");
  NodeTransform out{vector_or(node.translation, Eigen::Vector3d::Zero(), file, thing),
                    vector_or(node.scale, Eigen::Vector3d::Ones(), file, thing), Eigen::Quaterniond::Identity()};
  if (node.rotation.empty()) return out;
  if (node.rotation.size() != 4) throw ModelError(file, thing, "its rotation does not have 4 numbers");
  const Eigen::Quaterniond rotation(Eigen::Map<const Eigen::Vector4d>(node.rotation.data()));
  if (!(rotation.norm() > least_quaternion)) throw ModelError(file, thing, "its rotation is by a zero quaternion");
  if (!std::isfinite(rotation.norm())) throw ModelError(file, thing, "its rotation is by a quaternion without a length");
  out.rotation = rotation.normalized();
  return out;
}

GltfNodes convert_nodes(const tinygltf::Model& source, const std::string& file) {
  const std::vector<int> parents = parents_of(source, file);
  Order order(source, file);
  for (const int root : scene_roots(source, parents, file)) order.add_tree(root);
  order.out.shown = static_cast<int>(order.out.nodes.size());
  for (std::size_t n = 0; n < parents.size(); ++n)
    if (parents[n] < 0 && order.out.places[n] < 0) order.add_tree(static_cast<int>(n));
  for (std::size_t n = 0; n < parents.size(); ++n)
    if (order.out.places[n] < 0) throw ModelError(file, node_label(source, n), "is below itself");
  return order.out;
}

}  // namespace refitlab
