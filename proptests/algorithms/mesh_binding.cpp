// SPDX-License-Identifier: GPL-3.0-or-later
// Tests meshes in one reference pose: whatever shape they have, and whatever frames a scene has them in, joints and morph targets
// take the model's vertices where the scene's own formulas take them.
#include "algorithms/model/mesh_binding.hpp"

#include <Eigen/LU>
#include <random>

#include "algorithms/model/model_of_scene.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_mesh_binding {
namespace {

using namespace refitlab;
using Eigen::Matrix4d, Eigen::Vector3d;

class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

  Scene scene() {
    Scene s{"scene", {{"root", -1, Matrix4d::Identity()}}, {}, {}, {}, {}};
    const int joints = 1 + below(3);
    for (int j = 0; j < joints; ++j) s.nodes.push_back({"joint", below(1 + j), transform(below(4) == 0 ? 1e5 : 1)});
    for (int j = 0; j < joints; ++j)  // some of them have one offset
      offsets_.push_back(j > 0 && below(3) == 0 ? offsets_.back() : transform(below(4) == 0 ? 1e4 : 1));
    const int skinned = 1 + below(3), rigid = below(2);
    for (int m = 0; m < skinned + rigid; ++m) add_mesh(s, m < skinned);
    return s;
  }
  bool has_flat_morphed = false, has_two_frames = false;

 private:
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3d vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  Matrix4d transform(double far) {
    Matrix4d out = Matrix4d::Identity();
    out.topLeftCorner<3, 3>() = Eigen::AngleAxisd(between(0, 3), vector().normalized()).toRotationMatrix() *
                                Vector3d(between(0.5, 2), between(0.5, 2), between(0.5, 2)).asDiagonal();
    out.topRightCorner<3, 1>() = far * vector();
    return out;
  }
  // Returns a matrix that stretches those axes of a mesh's frame along which the mesh is flat: z, y and z, or all.
  Matrix4d stretched(int flat) {
    Matrix4d out = Matrix4d::Identity();
    for (int i = 3 - flat; i < 3; ++i) out(i, i) = between(2, 3);
    return out;
  }

  // Adds a mesh of three points or more. Where it is flat, all of them are in a plane of its frame, or on a line, or in one
  // point.
  void add_mesh(Scene& s, bool is_skinned) {
    const int flat = below(s.meshes.empty() ? 3 : 4);  // not all are points, which have no triangles
    const int targets = below(3), primitives = 1 + below(2), joints = static_cast<int>(offsets_.size());
    const bool is_other_frame = below(3) == 0, is_told_apart = below(2) == 0;
    ShownMesh shown{is_skinned ? 0 : 1 + below(joints), static_cast<int>(s.meshes.size()), -1, {}};
    SceneSkin skin;
    if (is_skinned) {
      shown.skin = static_cast<int>(s.skins.size());
      const Matrix4d frame = is_other_frame ? transform(below(2) == 0 ? 1e3 : 1) : Matrix4d::Identity();
      has_two_frames = has_two_frames || (is_other_frame && !s.meshes.empty());
      const int listed = 1 + below(3);
      for (int k = 0; k < listed; ++k) {
        const int j = below(joints);
        skin.joints.push_back(1 + j);
        // The offset belongs to the same node, but it may act differently off the plane.
        skin.offsets.push_back(offsets_[static_cast<std::size_t>(j)] * frame *
                               (is_told_apart && below(2) == 0 ? stretched(flat) : Matrix4d::Identity()));
      }
      s.skins.push_back(skin);
    }
    has_flat_morphed = has_flat_morphed || (is_skinned && is_told_apart && flat > 0 && targets > 0);
    for (int t = 0; t < targets; ++t) shown.weights.push_back(between(-2, 2));
    SceneMesh mesh;
    for (int p = 0; p < primitives; ++p)
      mesh.primitives.push_back(primitive(flat, targets, static_cast<int>(skin.joints.size())));
    s.meshes.push_back(mesh), s.shown.push_back(shown);
  }
  ScenePrimitive primitive(int flat, int targets, int joints) {
    ScenePrimitive out{"primitive", {}, {}, {}, {}};
    const int count = 3 + below(5);
    out.targets.resize(static_cast<std::size_t>(targets));
    for (int v = 0; v < count; ++v) {
      Vector3d at = vector();
      for (int i = 3 - flat; i < 3; ++i) at[i] = 0;
      out.positions.push_back(at);
      for (auto& target : out.targets) target.push_back(below(3) == 0 ? Vector3d::Zero() : vector());
      if (v >= 2) out.triangles.push_back({v - 2, v - 1, v});
      if (joints == 0) continue;
      std::vector<std::pair<int, double>> weights;
      double sum = 0;
      for (int j = 0; j < joints; ++j) weights.emplace_back(j, 1 + below(4)), sum += weights.back().second;
      for (auto& [j, weight] : weights) weight /= sum;
      out.weights.push_back(weights);
    }
    return out;
  }

  std::mt19937 random_;
  std::vector<Matrix4d> offsets_;  // by joint
};

struct Placed {
  Vector3d at;
  double size;  // This is the size of the terms that were summed up.
};

// Returns a vertex where the scene's own formulas have it, with these weights of its mesh's morph targets.
Placed by_scene(const Scene& s, const std::vector<Matrix4d>& globals, const ShownMesh& shown, const ScenePrimitive& primitive,
                std::size_t v, const std::vector<double>& weights) {
  Vector3d at = primitive.positions[v];
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) at += weights[t] * primitive.targets[t][v];
  if (shown.skin < 0) {
    const Matrix4d& g = globals[static_cast<std::size_t>(shown.node)];
    return {(g * at.homogeneous()).head<3>(), g.norm() * at.homogeneous().norm()};
  }
  const SceneSkin& skin = s.skins[static_cast<std::size_t>(shown.skin)];
  Placed out{Vector3d::Zero(), 0};
  for (const auto& [j, w] : primitive.weights[v]) {
    const Matrix4d &g = globals[static_cast<std::size_t>(skin.joints[static_cast<std::size_t>(j)])],
                   &offset = skin.offsets[static_cast<std::size_t>(j)];
    out.at += w * (g * offset * at.homogeneous()).head<3>();
    out.size += w * g.norm() * offset.norm() * at.homogeneous().norm();
  }
  return out;
}

// Returns the model's vertex where its joints and targets take it.
Vector3d by_model(const Model& model, const std::vector<Matrix4d>& matrices, int node, int vertex,
                  const std::vector<double>& weights) {
  Vector3d v = model.vertices[static_cast<std::size_t>(vertex)];
  for (const MorphedMesh& mesh : model.morphs) {
    if (mesh.node != node) continue;
    for (std::size_t t = 0; t < mesh.targets.size(); ++t)
      for (const auto& [moved, by] : mesh.targets[t].displacements)
        if (moved == vertex) v += weights[t] * by;
  }
  Vector3d out = Vector3d::Zero();
  for (const Influence& i : model.influences[static_cast<std::size_t>(vertex)])
    out += i.weight * (matrices[static_cast<std::size_t>(i.joint)] * v.homogeneous()).head<3>();
  return out;
}

void check_places() {
  const auto seed = *gen::between<unsigned>(0, 1u << 30);
  RC_LOG() << "seed " << seed;
  SceneMaker maker(seed);
  Scene s = maker.scene();
  // Each mesh is shown by a node of its own, so that it has weights of its own.
  for (ShownMesh& shown : s.shown) {
    s.nodes.push_back({"shows", shown.skin < 0 ? shown.node : -1, Matrix4d::Identity()});
    shown.node = static_cast<int>(s.nodes.size()) - 1;
  }
  if (maker.has_flat_morphed) RC_TAG("flat, and moved by targets");
  if (maker.has_two_frames) RC_TAG("two frames");
  const Model model = model_of_scene(s, {.joints = Joints::affine, .morphs = Morphs::moving});
  const auto globals = global_transforms(s.nodes, Animation{}, 0);
  const auto matrices = skin_matrices(model.skeleton, Animation{}, 0);
  std::mt19937 random(seed);
  std::size_t source = 0;
  for (const ShownMesh& shown : s.shown) {
    std::vector<double> weights;
    for (std::size_t t = 0; t < shown.weights.size(); ++t)
      weights.push_back(std::uniform_real_distribution<double>(-10, 10)(random));
    for (const ScenePrimitive& primitive : s.meshes[static_cast<std::size_t>(shown.mesh)].primitives) {
      const SourcePrimitive& from = model.sources.at(source++);
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        if (from.vertices[v] < 0) continue;
        const Placed expected = by_scene(s, globals, shown, primitive, v, weights);
        const Vector3d found = by_model(model, matrices, shown.node, from.vertices[v], weights);
        // Weights are rounded to 2^-24, and placements are undone by joints.
        RC_ASSERT((found - expected.at).norm() <= 1e-6 * expected.size);
      }
    }
  }
  RC_ASSERT(source == model.sources.size());
}

// Counts the joints of a scene in which two skins have one joint in two frames, so far apart, and a node shows a mesh without a
// skin. All of them are as large as this. Each mesh has so many primitives.
std::size_t joints_of_parts(double size, double angle, double far, double bind, std::size_t parts) {
  const Vector3d axis = Vector3d(1, 2, 3).normalized();
  const auto turned = [&](double angle, const Vector3d& to) {
    Matrix4d out = Matrix4d::Identity();
    out.topLeftCorner<3, 3>() = 0.7 * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    out.topRightCorner<3, 1>() = size * to;
    return out;
  };
  Scene s{"file", {{"joint", -1, turned(1, far * Vector3d(1, 0.3, -0.2))}, {"skinned", -1, Matrix4d::Identity()}}, {}, {}, {},
          {}};
  s.nodes.push_back({"rigid", -1, turned(2, far * Vector3d(0.1, -1, 0.5))});
  s.nodes.push_back({"other", -1, Matrix4d::Identity()});
  SceneMesh rigid;
  for (std::size_t p = 0; p < parts; ++p) {
    rigid.primitives.push_back({"part", {{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}, {}, {}});
    for (Vector3d& v : rigid.primitives.back().positions) v += static_cast<double>(p) * Vector3d(0.3, 0.2, 0.7) * size;
  }
  SceneMesh skinned = rigid;
  for (ScenePrimitive& primitive : skinned.primitives) primitive.weights.assign(3, {{0, 1.0}});
  s.meshes = {skinned, rigid};
  const Matrix4d offset = turned(angle, {0.2, 0.1, -0.3});
  s.skins = {{{0}, {offset}}, {{0}, {offset * turned(0.6, bind * Vector3d(0.1, 1, 0.7))}}};
  s.shown = {{1, 0, 0, {}}, {2, 1, -1, {}}, {3, 0, 1, {}}};
  return model_of_scene(s, {.joints = Joints::affine}).joints.size();
}

Checked check_joints_of_parts() {
  long tried = 0;
  for (const double size : {1e-30, 1e-9, 1e-5, 1.0, 1e5})
    for (const double far : {0.0, 1.0, 1e5, 1e9})
      for (const double bind : {0.0, 1.0, 1e5, 1e9}) {
        const double angle = 0.1 * static_cast<double>(1 + tried);
        const std::size_t one = joints_of_parts(size, angle, far, bind, 1), three = joints_of_parts(size, angle, far, bind, 3);
        ++tried;
        // Where a frame is far away, its joint is a separate one, since placing the mesh rounds too much.
        if (three != one || (bind <= 1 && one != 2))
          return Checked(false, tried,
                         std::to_string(size) + " " + std::to_string(far) + " " + std::to_string(bind) + ": " +
                             std::to_string(one) + " and " + std::to_string(three) + " joints");
      }
  return Checked(true, tried);
}

}  // namespace

PROPTEST(mesh_binding) {
  t.holds("joints and morph targets take each vertex where the scene has it, whatever the weights",
          {.number_type = "double", .cases = 3000, .tags_at_least = {{"flat, and moved by targets", 0.2}, {"two frames", 0.1}}},
          check_places);
  t.example("primitives of one mesh have the same joints, in any unit, frame and place", {}, check_joints_of_parts);
  t.example("a scene that shows no mesh with bones is refused for that, if the file has skins", {}, [] {
    Scene s{"file", {{"node", -1, Matrix4d::Identity()}}, {}, {}, {}, {}};
    s.meshes = {{{{"mesh 0", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}}};
    s.shown = {{0, 0, -1, {}}};
    std::string wrong;
    for (const char* expected : {"file: file: no skin: no mesh has bones",
                                 "file: file: no skin: the scene shows no mesh with bones, though the file has skins"}) {
      try {
        model_of_scene(s);
        wrong += "it is accepted";
      } catch (const ModelError& e) {
        if (e.what() != std::string(expected)) wrong += e.what();
      }
      s.skins = {{{0}, {Matrix4d::Identity()}}};
    }
    return Checked(wrong.empty(), 2, wrong);
  });
}

}  // namespace proptests::suite_mesh_binding
