// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rich_gltf.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace proptests::gen {
namespace {

using Eigen::Matrix4d, Eigen::Vector3d;
using nlohmann::json;

enum : int {
  root_node,
  armature_node,
  body_node,
  bone_node,
  gap_node,
  second_bone_node,
  fan_node,
  tip_node,
  again_node,
  loose_node
};

const double half = std::sqrt(0.5);
// This is a spline of rotations: tangent in, value and tangent out, x y z w. Its keys are off unit length, as bytes would be.
const std::vector<std::array<float, 4>> bone_turn = {{0, 0, 0, 0},         {0, 0, 0, 0.996f},    {0.5f, 0.25f, 0, 0.125f},
                                                     {0, -0.25f, 0.5f, 0}, {0.6f, 0, 0, 0.805f}, {0, 0, 0, 0}};
const std::vector<double> default_weights = {0.5, 0.25}, last_weights = {1, -0.5};

Matrix4d transform(const Vector3d& translation, const Eigen::Quaterniond& rotation, const Vector3d& scale) {
  Matrix4d out = Matrix4d::Identity();
  out.topLeftCorner<3, 3>() = rotation.toRotationMatrix() * scale.asDiagonal();
  out.topRightCorner<3, 1>() = translation;
  return out;
}

Eigen::Quaterniond about(const Vector3d& axis, double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
}

std::array<float, 3> as_floats(const Vector3d& v) { return {float(v[0]), float(v[1]), float(v[2])}; }
Vector3d as_read(const std::array<float, 3>& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

std::vector<std::array<float, 3>> ring(int count, double radius) {
  std::vector<std::array<float, 3>> out;
  for (int i = 0; i < count; ++i) out.push_back(as_floats(radius * Vector3d(std::cos(i), 0.3 * i, std::sin(i))));
  return out;
}

std::vector<Vector3d> as_read(const std::vector<std::array<float, 3>>& rows) {
  std::vector<Vector3d> out;
  for (const auto& row : rows) out.push_back(as_read(row));
  return out;
}

std::size_t add_sparse(GltfBuilder& file, const std::vector<std::uint16_t>& rows,
                       const std::vector<std::array<float, 3>>& values) {
  const std::size_t indices = file.add_view(rows.data(), 2 * rows.size()),
                    view = file.add_view(values.data(), 12 * values.size());
  file.json["accessors"].push_back({{"componentType", gltf_float},
                                    {"type", "VEC3"},
                                    {"sparse",
                                     {{"count", rows.size()},
                                      {"indices", {{"bufferView", indices}, {"componentType", gltf_ushort}}},
                                      {"values", {{"bufferView", view}}}}}});
  return file.json["accessors"].size() - 1;
}

std::size_t add_normalized(GltfBuilder& file, std::size_t accessor) {
  file.json["accessors"][accessor]["normalized"] = true;
  return accessor;
}

}  // namespace

RichGltf::RichGltf(bool uneven, bool moving, bool turning) : uneven_(uneven), moving_(moving), turning_(turning) {
  add_nodes();
  add_skins();
  add_body();
  add_fan();
  add_loose();
  add_clip();
  // These are the body's two once more, by another node.
  RichPrimitive other = primitives_[0];
  for (int p = 0; p < 2; ++p) {
    other = primitives_[p];
    other.node = again_node;
    primitives_.push_back(other);
  }
}

void RichGltf::add_nodes() {
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.json["scenes"] = {{{"nodes", {tip_node}}}, {{"nodes", {root_node}}}};
  // This scene is not the default one.
  file.json["scenes"][0]["nodes"] = json::array();
  file.json["scene"] = 1;
  const auto add = [&](const char* name, const json& more) {
    json node = more;
    if (*name) node["name"] = name;
    file.json["nodes"].push_back(node);
  };
  add("root", {{"children", {armature_node, fan_node, again_node}},
               {"translation", {1, 2, 3}},
               {"rotation", {0, half, 0, half}},
               {"scale", {0.5, 0.5, 0.5}}});
  add("", {{"children", {body_node, bone_node}}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 1, 0, 1}}});
  add("skin", {{"mesh", 0}, {"skin", 0}, {"translation", {9, 9, 9}}, {"scale", {7, 8, 9}}});
  add("bone", {{"children", {gap_node}}, {"translation", {0, 1, 0}}});
  add("between", {{"children", {second_bone_node}}, {"rotation", {half, 0, 0, half}}});
  add("bone", {{"children", {tip_node, loose_node}}, {"translation", {0, 1, 0}}});
  add("skin", {{"mesh", 1}, {"skin", 1}});
  add("tip", {{"translation", {0, 1, 0}}});
  add("again", {{"mesh", 0}, {"skin", 0}});
  add("loose", {{"mesh", 2}, {"translation", {0.25, 0, 0}}, {"scale", {3, 3, 3}}});
}

Matrix4d RichGltf::local(int node, double t) const {
  const Vector3d ones = Vector3d::Ones(), up = Vector3d::UnitY();
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  switch (node) {
    case root_node: return transform({1, 2, 3}, about(up, 90), 0.5 * ones);
    case armature_node: return transform(up, still, 2 * ones);
    case bone_node: {
      const double s = t / 2;
      const Vector3d from(0, 1, 0), to(1, 1, 0.5), out(1, 0, 2), into(0, 1, -1);
      const double parts[] = {2 * s * s * s - 3 * s * s + 1, 2 * (s * s * s - 2 * s * s + s), 2 * (s * s * s - s * s),
                              3 * s * s - 2 * s * s * s};
      Eigen::Vector4d turned = Eigen::Vector4d::Zero();
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 4; ++i) turned[i] += parts[k] * double(bone_turn[1 + k][i]);
      return transform(parts[0] * from + parts[1] * out + parts[3] * to + parts[2] * into,
                       turning_ ? Eigen::Quaterniond(turned).normalized() : still, ones);
    }
    case gap_node: return transform(Vector3d::Zero(), about(Vector3d::UnitX(), 90), ones);
    case second_bone_node: return transform(up, about(Vector3d::UnitZ(), 90 * std::min(t, 2 - t)), ones);
    case tip_node: return transform(up, about(Vector3d::UnitX(), t >= 0.5 && t < 1.5 ? 60 : 0), {1, uneven_ ? 1 + t / 4 : 1, 1});
    case loose_node: return transform({0.25, 0, 0}, still, 3 * ones);
    default: return Matrix4d::Identity();
  }
}

Matrix4d RichGltf::global(int node, double time) const {
  constexpr int parents[] = {-1,       root_node, armature_node,    armature_node, bone_node,
                             gap_node, root_node, second_bone_node, root_node,     second_bone_node};
  Matrix4d out = local(node, time);
  for (int n = parents[node]; n >= 0; n = parents[n]) out = local(n, time) * out;
  return out;
}

void RichGltf::add_skins() {
  joints_ = {{second_bone_node, bone_node, tip_node}, {tip_node, second_bone_node}};
  // These lead from each mesh's frame to the world as it rests.
  const Matrix4d frames[] = {transform({1, 0, 0}, about({0, 0, 1}, 30), 4 * Vector3d::Ones()),
                             transform({0, 2, 0}, about({1, 0, 0}, 45), 40 * Vector3d::Ones())};
  for (int s = 0; s < 2; ++s) {
    std::vector<std::array<float, 16>> rows;
    offsets_.emplace_back();
    for (const int joint : joints_[s]) {
      const Eigen::Matrix4f offset = (global(joint, 0).inverse() * frames[s]).cast<float>();
      std::copy(offset.data(), offset.data() + 16, rows.emplace_back().begin());
      offsets_.back().push_back(offset.cast<double>());
    }
    file.json["skins"].push_back({{"joints", joints_[s]}, {"inverseBindMatrices", file.add_accessor(rows, "MAT4", gltf_float)}});
  }
}

void RichGltf::add_body() {
  json mesh = {{"name", "body"}, {"weights", default_weights}};
  {
    const auto positions = ring(12, 0.1);
    RichPrimitive p{body_node, 0, 0, 0, {}, as_read(positions), {}, {}};
    std::vector<std::uint16_t> indices;
    std::vector<std::array<std::uint8_t, 4>> joints, weights;
    std::vector<std::array<float, 3>> second;
    for (int i = 0; i < 12; ++i) {
      if (i < 10) p.triangles.push_back({i, i + 1, i + 2});
      if (i < 10)
        for (int k = 0; k < 3; ++k) indices.push_back(static_cast<std::uint16_t>(i + k));
      joints.push_back({std::uint8_t(i % 3), std::uint8_t((i + 1) % 3), 0, 0});
      weights.push_back({204, 51, 0, 0});
      p.weights.push_back({{i % 3, 0.8}, {(i + 1) % 3, 0.2}});
      second.push_back({0.015625f * static_cast<float>(i), 0, 0.25f});
    }
    const std::vector<std::array<float, 3>> moved = {{0.125f, 0.25f, 0.5f}, {-0.125f, 0, 0.0625f}};
    const std::size_t sparse = add_sparse(file, {2, 5}, moved);
    file.json["accessors"][sparse]["count"] = 12;
    p.targets = {std::vector<Vector3d>(12, Vector3d::Zero()), as_read(second)};
    p.targets[0][2] = as_read(moved[0]), p.targets[0][5] = as_read(moved[1]);
    mesh["primitives"].push_back(
        {{"attributes",
          {{"POSITION", file.add_accessor(positions, "VEC3", gltf_float)},
           {"JOINTS_0", file.add_accessor(joints, "VEC4", gltf_ubyte)},
           {"WEIGHTS_0", add_normalized(file, file.add_accessor(weights, "VEC4", gltf_ubyte))}}},
         {"indices", file.add_accessor(indices, "SCALAR", gltf_ushort)},
         {"targets", {{{"POSITION", sparse}}, {{"POSITION", file.add_accessor(second, "VEC3", gltf_float)}}}}});
    primitives_.push_back(p);
  }
  const auto positions = ring(6, 0.2);
  RichPrimitive p{body_node, 0, 1, 0, {}, as_read(positions), {}, {}};
  // The triangles make a strip: every other triangle is turned around.
  p.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  const std::vector<std::array<std::uint16_t, 4>> first(6, {0, 1, 2, 0}), second(6, {1, 2, 0, 0});
  const std::vector<std::array<float, 4>> first_weights(6, {0.25f, 0.25f, 0.125f, 0.125f}),
      second_weights(6, {0.125f, 0.125f, 0, 0});
  p.weights.assign(6, {{0, 0.25}, {1, 0.25}, {2, 0.125}, {0, 0.125}, {1, 0.125}, {2, 0.125}});
  const auto up = std::vector<std::array<float, 3>>(6, {0, 1, 0});
  p.targets = {as_read(up), as_read(up)};
  const std::size_t target = file.add_accessor(up, "VEC3", gltf_float);
  mesh["primitives"].push_back({{"attributes",
                                 {{"POSITION", file.add_accessor(positions, "VEC3", gltf_float)},
                                  {"JOINTS_0", file.add_accessor(first, "VEC4", gltf_ushort)},
                                  {"JOINTS_1", file.add_accessor(second, "VEC4", gltf_ushort)},
                                  {"WEIGHTS_0", file.add_accessor(first_weights, "VEC4", gltf_float)},
                                  {"WEIGHTS_1", file.add_accessor(second_weights, "VEC4", gltf_float)}}},
                                {"mode", 5},
                                {"targets", {{{"POSITION", target}}, {{"POSITION", target}}}}});
  primitives_.push_back(p);
  file.json["meshes"].push_back(mesh);
}

void RichGltf::add_fan() {
  auto positions = ring(5, 0.02);
  RichPrimitive p{fan_node, 1, 0, 1, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}, as_read(positions), {}, {}};
  const std::vector<std::array<float, 3>> other = {{0.03125f, 0.0625f, 0.125f}};
  p.positions[1] = as_read(other[0]);
  const std::size_t base = file.add_accessor(positions, "VEC3", gltf_float), sparse = add_sparse(file, {1}, other);
  file.json["accessors"][base]["sparse"] = file.json["accessors"][sparse]["sparse"];
  file.json["accessors"][sparse]["count"] = 5;
  const std::vector<std::uint8_t> indices = {0, 1, 2, 3, 4};
  const std::vector<std::array<std::uint8_t, 4>> joints(5, {0, 1, 0, 0});
  const std::vector<std::array<std::uint16_t, 4>> weights(5, {13107, 52428, 0, 0});
  p.weights.assign(5, {{0, 0.2}, {1, 0.8}});
  file.json["meshes"].push_back({{"primitives",
                                  {{{"attributes",
                                     {{"POSITION", base},
                                      {"JOINTS_0", file.add_accessor(joints, "VEC4", gltf_ubyte)},
                                      {"WEIGHTS_0", add_normalized(file, file.add_accessor(weights, "VEC4", gltf_ushort))}}},
                                    {"indices", file.add_accessor(indices, "SCALAR", gltf_ubyte)},
                                    {"mode", 6}}}}});
  primitives_.push_back(p);
}

void RichGltf::add_loose() {
  // Three of four shorts are in a row, and the smallest one stands for -1 too.
  const std::vector<std::array<std::int16_t, 4>> rows = {{32767, 0, 0, 5}, {0, -32767, 0, 5}, {0, 0, -32768, 5}};
  const std::size_t accessor = add_normalized(file, file.add_accessor(rows, "VEC3", gltf_short));
  file.json["bufferViews"][std::size_t(file.json["accessors"][accessor]["bufferView"])]["byteStride"] = 8;
  file.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
  primitives_.push_back({loose_node, 2, 0, -1, {{0, 1, 2}}, {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {}, {}});
}

void RichGltf::add_clip() {
  json channels = json::array(), samplers = json::array();
  const auto add = [&](int node, const char* path, const std::vector<float>& times, std::size_t values,
                       const char* interpolation) {
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers.push_back(
        {{"input", file.add_accessor(times, "SCALAR", gltf_float)}, {"output", values}, {"interpolation", interpolation}});
  };
  const std::vector<std::array<float, 3>> spline = {{0, 0, 0}, {0, 1, 0}, {1, 0, 2}, {0, 1, -1}, {1, 1, 0.5f}, {0, 0, 0}};
  add(bone_node, "translation", {0, 2}, file.add_accessor(spline, "VEC3", gltf_float), "CUBICSPLINE");
  if (turning_) add(bone_node, "rotation", {0, 2}, file.add_accessor(bone_turn, "VEC4", gltf_float), "CUBICSPLINE");
  const std::vector<std::array<std::int16_t, 4>> turns = {{0, 0, 0, 32767}, {0, 0, 23170, 23170}, {0, 0, 0, 32767}};
  add(second_bone_node, "rotation", {0, 1, 2}, add_normalized(file, file.add_accessor(turns, "VEC4", gltf_short)), "LINEAR");
  const float cosine = static_cast<float>(std::sqrt(0.75));
  const std::vector<std::array<float, 4>> steps = {{0, 0, 0, 1}, {0.5f, 0, 0, cosine}, {0, 0, 0, 1}};
  add(tip_node, "rotation", {0, 0.5f, 1.5f}, file.add_accessor(steps, "VEC4", gltf_float), "STEP");
  const std::vector<std::array<float, 3>> scales = {{1, 1, 1}, {1, uneven_ ? 1.5f : 1, 1}};
  add(tip_node, "scale", {0, 2}, file.add_accessor(scales, "VEC3", gltf_float), "LINEAR");
  if (moving_) {
    std::vector<float> weights;
    for (const auto* list : {&default_weights, &last_weights})
      for (const double w : *list) weights.push_back(static_cast<float>(w));
    add(body_node, "weights", {0, 2}, file.add_accessor(weights, "SCALAR", gltf_float), "LINEAR");
  }
  file.json["animations"] = {{{"name", "move"}, {"channels", channels}, {"samplers", samplers}}};
}

std::vector<double> RichGltf::morph_weights(double time) const {
  std::vector<double> out = default_weights;
  for (int t = 0; moving_ && t < 2; ++t) out[t] += time / 2 * (last_weights[t] - default_weights[t]);
  return out;
}

std::vector<Vector3d> RichGltf::posed(const RichPrimitive& primitive, double time) const {
  const std::vector<double> moving = primitive.node == body_node ? morph_weights(time) : default_weights;
  std::vector<Vector3d> out;
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    Vector3d position = primitive.positions[v];
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) position += moving[t] * primitive.targets[t][v];
    if (primitive.skin < 0) {
      out.push_back((global(primitive.node, time) * position.homogeneous()).head<3>());
      continue;
    }
    Vector3d sum = Vector3d::Zero();
    for (const auto& [joint, weight] : primitive.weights[v])
      sum += weight *
             (global(joints_[primitive.skin][joint], time) * offsets_[primitive.skin][joint] * position.homogeneous()).head<3>();
    out.push_back(sum);
  }
  return out;
}

}  // namespace proptests::gen
