// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_meshes.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace refitlab {
namespace {

using Indices = std::vector<std::uint32_t>;

std::string mesh_label(const tinygltf::Model& source, std::size_t mesh) {
  const std::string& name = source.meshes[mesh].name;
  return "mesh " + std::to_string(mesh) + (name.empty() ? "" : " '" + name + "'");
}

class PrimitiveReader {
 public:
  PrimitiveReader(const tinygltf::Primitive& source, const GltfNumbers& numbers, bool quantized, const std::string& label,
                  const std::string& file)
      : source_(source),
        numbers_(numbers),
        quantized_(quantized),
        label_(label),
        file_(file) {}

  // Returns one without triangles where there are no positions, since glTF says that such a primitive is not shown.
  ScenePrimitive read() const {
    if (attribute("POSITION") < 0) return {label_, {}, {}, {}, std::vector<std::vector<Eigen::Vector3d>>(source_.targets.size())};
    ScenePrimitive out{label_, positions(), {}, {}, {}};
    const Indices vertices = indices(out.positions.size());
    out.triangles = triangles(vertices);
    out.weights = weights(out.positions.size());
    for (std::size_t t = 0; t < source_.targets.size(); ++t) out.targets.push_back(displacements(t, out.positions.size()));
    return out;
  }

 private:
  int attribute(const std::string& name) const {
    const auto found = source_.attributes.find(name);
    return found == source_.attributes.end() ? -1 : found->second;
  }

  std::vector<Eigen::Vector3d> positions() const {
    const int accessor = attribute("POSITION");
    const NumberTable table = numbers_.read(accessor, TINYGLTF_TYPE_VEC3, quantized_ ? Numbers::any : Numbers::floats, label_);
    if (table.rows == 0) throw ModelError(file_, label_, "is empty");
    if (table.rows > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw ModelError(file_, label_, "has too many vertices");
    std::vector<Eigen::Vector3d> out;
    for (std::size_t v = 0; v < table.rows; ++v) {
      out.emplace_back(table.at(v, 0), table.at(v, 1), table.at(v, 2));
      if (!out.back().allFinite())
        throw ModelError(file_, label_, "the position of vertex " + std::to_string(v) + " is not finite");
    }
    return out;
  }

  // Returns the displacements by a target. They are zeros if it moves something else than positions.
  std::vector<Eigen::Vector3d> displacements(std::size_t target, std::size_t vertices) const {
    const auto found = source_.targets[target].find("POSITION");
    std::vector<Eigen::Vector3d> out(vertices, Eigen::Vector3d::Zero());
    if (found == source_.targets[target].end()) return out;
    const std::string thing = label_ + ", morph target " + std::to_string(target);
    const NumberTable table =
        numbers_.read(found->second, TINYGLTF_TYPE_VEC3, quantized_ ? Numbers::any : Numbers::floats, thing);
    if (table.rows != vertices) throw ModelError(file_, thing, "does not fit the vertices");
    for (std::size_t v = 0; v < vertices; ++v) {
      out[v] = {table.at(v, 0), table.at(v, 1), table.at(v, 2)};
      if (!out[v].allFinite())
        throw ModelError(file_, thing, "the displacement of vertex " + std::to_string(v) + " is not finite");
    }
    return out;
  }

  Indices indices(std::size_t vertices) const {
    Indices out;
    if (source_.indices < 0) {
      for (std::size_t v = 0; v < vertices; ++v) out.push_back(static_cast<std::uint32_t>(v));
      return out;
    }
    const NumberTable table = numbers_.read(source_.indices, TINYGLTF_TYPE_SCALAR, Numbers::unsigned_integers, label_);
    for (std::size_t i = 0; i < table.rows; ++i) {
      if (table.at(i, 0) >= static_cast<double>(vertices))
        throw ModelError(file_, label_, "index " + std::to_string(i) + " names a vertex out of range");
      out.push_back(static_cast<std::uint32_t>(table.at(i, 0)));
    }
    return out;
  }

  std::vector<Triangle> triangles(const Indices& vertices) const {
    const auto vertex = [&](std::size_t i) { return static_cast<int>(vertices[i]); };
    const std::size_t strip = vertices.size() < 3 ? 0 : vertices.size() - 2;
    std::vector<Triangle> out;
    switch (source_.mode) {
      case TINYGLTF_MODE_POINTS:
      case TINYGLTF_MODE_LINE:
      case TINYGLTF_MODE_LINE_LOOP:
      case TINYGLTF_MODE_LINE_STRIP: break;
      case TINYGLTF_MODE_TRIANGLES:
        if (vertices.size() % 3 != 0)
          throw ModelError(file_, label_, "its triangles have " + std::to_string(vertices.size()) + " indices in all");
        for (std::size_t i = 0; i < vertices.size(); i += 3) out.push_back({vertex(i), vertex(i + 1), vertex(i + 2)});
        break;
      case TINYGLTF_MODE_TRIANGLE_STRIP:  // every other one is turned around
        for (std::size_t i = 0; i < strip; ++i) out.push_back({vertex(i), vertex(i + 1 + i % 2), vertex(i + 2 - i % 2)});
        break;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 0; i < strip; ++i) out.push_back({vertex(i + 1), vertex(i + 2), vertex(0)});
        break;
      default: throw ModelError(file_, label_, "is of mode " + std::to_string(source_.mode) + ", which glTF has not");
    }
    return out;
  }

  // Returns the weights by vertex, from all sets of joints and weights.
  std::vector<std::vector<std::pair<int, double>>> weights(std::size_t vertices) const {
    std::vector<std::vector<std::pair<int, double>>> out;
    for (int set = 0;; ++set) {
      const std::string suffix = "_" + std::to_string(set), name = "joints and weights of set " + std::to_string(set);
      const int joints = attribute("JOINTS" + suffix), weights = attribute("WEIGHTS" + suffix);
      if ((joints < 0) != (weights < 0)) throw ModelError(file_, label_, name + " do not go together");
      if (joints < 0) {
        check_last_set(set);
        return out;
      }
      const NumberTable j = numbers_.read(joints, TINYGLTF_TYPE_VEC4, Numbers::unsigned_integers, label_);
      const NumberTable w = numbers_.read(weights, TINYGLTF_TYPE_VEC4, Numbers::floats_or_normalized, label_);
      if (j.rows != vertices || w.rows != vertices) throw ModelError(file_, label_, name + " do not fit the vertices");
      out.resize(vertices);
      const auto refuse = [&](std::size_t v, const std::string& reason) {
        throw ModelError(file_, label_ + ", vertex " + std::to_string(v), reason);
      };
      for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t k = 0; k < 4; ++k) {
          const double weight = w.at(v, k);
          if (!std::isfinite(weight)) refuse(v, "a weight is not a finite number");
          if (weight < 0) refuse(v, "weight " + std::to_string(weight) + " is negative");
          if (weight > 0) out[v].emplace_back(static_cast<int>(std::min(j.at(v, k), greatest_joint)), weight);
        }
    }
  }

  // Sets are numbered from 0 on. Sets behind a gap would get lost, so they are refused.
  void check_last_set(int count) const {
    for (const auto& [name, accessor] : source_.attributes)
      for (const char* kind : {"JOINTS_", "WEIGHTS_"})
        if (name.starts_with(kind) && std::atoi(name.c_str() + std::string(kind).size()) >= count)
          throw ModelError(file_, label_, name + ", but no set " + std::to_string(count) + " of joints and weights");
  }

  static constexpr double greatest_joint = std::numeric_limits<int>::max();  // out of range in any case

  const tinygltf::Primitive& source_;
  const GltfNumbers& numbers_;
  bool quantized_;
  const std::string &label_, &file_;
};

void check_joints(const ScenePrimitive& primitive, std::size_t joints, const std::string& file) {
  if (primitive.weights.empty() && !primitive.triangles.empty())
    throw ModelError(file, primitive.label, "is shown with a skin, but has no joints and weights");
  for (std::size_t v = 0; v < primitive.weights.size(); ++v)
    for (const auto& [joint, weight] : primitive.weights[v])
      if (static_cast<std::size_t>(joint) >= joints)
        throw ModelError(file, primitive.label + ", vertex " + std::to_string(v),
                         "joint index " + std::to_string(joint) + " is out of range 0.." + std::to_string(joints - 1));
}

// Returns the node's own weights, or else the mesh's, or else zeros.
std::vector<double> default_weights(const tinygltf::Model& source, const tinygltf::Node& node, const SceneMesh& mesh,
                                    const std::string& file, const std::string& thing) {
  const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives[0].targets.size();
  const std::vector<double>& weights =
      node.weights.empty() ? source.meshes[static_cast<std::size_t>(node.mesh)].weights : node.weights;
  if (weights.empty()) return std::vector<double>(targets, 0);
  if (weights.size() != targets)
    throw ModelError(file, thing,
                     "has " + std::to_string(weights.size()) + " weights for " + std::to_string(targets) + " morph targets");
  return weights;
}

}  // namespace

std::vector<SceneMesh> convert_meshes(const tinygltf::Model& source, const GltfNumbers& numbers, const std::string& file) {
  bool quantized = false;
  for (const std::string& extension : source.extensionsUsed) quantized = quantized || extension == "KHR_mesh_quantization";
  std::vector<SceneMesh> out;
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    SceneMesh& mesh = out.emplace_back();
    const std::vector<tinygltf::Primitive>& primitives = source.meshes[m].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::string label =
          mesh_label(source, m) + (primitives.size() > 1 ? ", primitive " + std::to_string(p) : std::string());
      mesh.primitives.push_back(PrimitiveReader(primitives[p], numbers, quantized, label, file).read());
      if (mesh.primitives[p].targets.size() != mesh.primitives[0].targets.size())
        throw ModelError(file, label, "has another number of morph targets than the mesh's first primitive");
    }
  }
  return out;
}

std::vector<SceneSkin> convert_skins(const tinygltf::Model& source, const GltfNodes& nodes, const GltfNumbers& numbers,
                                     const std::string& file) {
  std::vector<SceneSkin> out;
  for (std::size_t s = 0; s < source.skins.size(); ++s) {
    const tinygltf::Skin& skin = source.skins[s];
    const std::string thing = "skin " + std::to_string(s);
    SceneSkin& converted = out.emplace_back();
    if (skin.joints.empty()) throw ModelError(file, thing, "has no joints");
    for (const int joint : skin.joints) {
      if (static_cast<std::size_t>(joint) >= nodes.places.size()) throw ModelError(file, thing, "has a joint that there is not");
      converted.joints.push_back(nodes.places[joint]);
    }
    converted.offsets.assign(skin.joints.size(), Eigen::Matrix4d::Identity());
    if (skin.inverseBindMatrices < 0) continue;
    const NumberTable matrices = numbers.read(skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4, Numbers::floats, thing);
    if (matrices.rows < skin.joints.size())
      throw ModelError(file, thing,
                       "only " + std::to_string(matrices.rows) + " inverse bind matrices for " +
                           std::to_string(skin.joints.size()) + " joints");
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      converted.offsets[j] = Eigen::Map<const Eigen::Matrix4d>(matrices.values.data() + 16 * j);
  }
  return out;
}

std::vector<ShownMesh> convert_shown(const tinygltf::Model& source, const GltfNodes& nodes, const Scene& scene) {
  std::vector<ShownMesh> out;
  for (int n = 0; n < nodes.shown; ++n) {
    const int index = nodes.nodes[n].source;
    const tinygltf::Node& node = source.nodes[static_cast<std::size_t>(index)];
    if (node.mesh < 0) continue;
    const std::string thing = "node " + std::to_string(index) + " '" + nodes.nodes[n].name + "'";
    if (static_cast<std::size_t>(node.mesh) >= scene.meshes.size())
      throw ModelError(scene.file, thing, "shows a mesh that there is not");
    if (node.skin >= 0 && static_cast<std::size_t>(node.skin) >= scene.skins.size())
      throw ModelError(scene.file, thing, "has a skin that there is not");
    if (node.skin >= 0)
      for (const ScenePrimitive& primitive : scene.meshes[node.mesh].primitives)
        check_joints(primitive, scene.skins[node.skin].joints.size(), scene.file);
    out.push_back({n, node.mesh, node.skin, default_weights(source, node, scene.meshes[node.mesh], scene.file, thing)});
  }
  return out;
}

void note_other_scenes(const tinygltf::Model& source, const GltfNodes& nodes, Scene& scene) {
  std::size_t others = 0;
  for (std::size_t n = static_cast<std::size_t>(nodes.shown); n < nodes.nodes.size(); ++n)
    others += source.nodes[static_cast<std::size_t>(nodes.nodes[n].source)].mesh >= 0;
  if (others > 0)
    scene.notes.push_back(std::to_string(others) + (others == 1 ? " node that shows a mesh is" : " nodes that show meshes are") +
                          " not in the default scene, and left out; bounds do not have what other scenes show");
}

}  // namespace refitlab
