// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/random_rig.hpp"

#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

namespace proptests::gen {
namespace {

class Maker {
 public:
  explicit Maker(const RigTraits& traits) : traits_(traits), random_(traits.seed) {}

  RiggedGltf make() {
    const auto scale = static_cast<float>(traits_.scale);
    add_node("root", -1, {traits_.mirrored ? -scale : scale, scale, scale});
    GltfSkin first;
    for (int j = 0; j < traits_.joints; ++j) {
      first.joints.push_back(add_node("joint " + std::to_string(j), pick(0, j), {1, 1, 1}));
      binds_.push_back(rigid());
    }
    for (const auto& bind : binds_) first.inverse_bind.push_back(columns(bind));
    add_skinned_mesh(first);
    if (traits_.second_skin) add_skinned_mesh(moved(first));
    if (traits_.other_joints) {
      GltfSkin own;
      own.joints = {add_node("other joint", pick(0, traits_.joints), {1, 1, 1})};
      own.inverse_bind = {columns(rigid())};
      add_skinned_mesh(own);
    }
    if (traits_.loose_mesh) {
      const int node = add_node("loose", pick(0, traits_.joints), {0.5f, 1, 2});
      scene_.nodes[node].mesh = add_mesh(0);
    }
    add_clip();
    return scene_;
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  float real() { return std::uniform_real_distribution<float>(-1, 1)(random_); }
  Eigen::Quaternionf rotation() { return Eigen::Quaternionf(real() + 1.1f, real(), real(), real()).normalized(); }
  Eigen::Isometry3f rigid() { return Eigen::Translation3f(real(), real(), real()) * rotation(); }

  static std::array<float, 16> columns(const Eigen::Isometry3f& transform) {
    std::array<float, 16> out;
    std::copy(transform.data(), transform.data() + 16, out.begin());
    return out;
  }

  int add_node(const std::string& name, int parent, const std::array<float, 3>& scale) {
    const Eigen::Quaternionf q = rotation();
    scene_.nodes.push_back({.name = name,
                            .parent = parent,
                            .translation = {real(), real(), real()},
                            .rotation = {q.x(), q.y(), q.z(), q.w()},
                            .scale = scale});
    return static_cast<int>(scene_.nodes.size()) - 1;
  }

  // Returns the same joints, bound in another frame: every matrix is multiplied by one rigid transform from the right, but
  // perhaps not the last one.
  GltfSkin moved(GltfSkin skin) {
    const Eigen::Isometry3f frame = rigid();
    for (std::size_t j = 0; j < binds_.size(); ++j) skin.inverse_bind[j] = columns(binds_[j] * frame);
    if (traits_.split_joint) skin.inverse_bind.back() = columns(rigid());
    return skin;
  }

  void add_skinned_mesh(const GltfSkin& skin) {
    scene_.skins.push_back(skin);
    const int mesh = add_mesh(static_cast<int>(skin.joints.size()));
    const int node = add_node("skin " + std::to_string(mesh), 0, {1, 1, 1});
    scene_.nodes[node].mesh = mesh;
    scene_.nodes[node].skin = static_cast<int>(scene_.skins.size()) - 1;
  }

  int add_mesh(int joints) {
    GltfMesh mesh;
    for (int v = 0; v < 20; ++v) mesh.positions.push_back({real(), real(), real()});
    for (std::uint32_t v = 0; v + 2 < 20; ++v) mesh.indices.insert(mesh.indices.end(), {v, v + 1, v + 2});
    const std::size_t sets = joints == 0 ? 0 : traits_.many_influences ? 2 : 1;
    mesh.joints.resize(sets), mesh.weights.resize(sets);
    for (std::size_t v = 0; v < mesh.positions.size() && sets > 0; ++v) {
      std::vector<int> by_chance(joints);
      for (int j = 0; j < joints; ++j) by_chance[j] = j;
      std::shuffle(by_chance.begin(), by_chance.end(), random_);
      by_chance.resize(std::min<std::size_t>(by_chance.size(), 4 * sets));
      std::vector<float> weights;
      float sum = 0;
      for (std::size_t k = 0; k < by_chance.size(); ++k) sum += weights.emplace_back(real() + 1.1f);
      for (std::size_t k = 0; k < 4 * sets; ++k) {
        if (k % 4 == 0) mesh.joints[k / 4].push_back({}), mesh.weights[k / 4].push_back({});
        if (k >= by_chance.size()) continue;
        mesh.joints[k / 4].back()[k % 4] = static_cast<std::uint16_t>(by_chance[k]);
        mesh.weights[k / 4].back()[k % 4] = weights[k] / sum;
      }
    }
    scene_.meshes.push_back(mesh);
    return static_cast<int>(scene_.meshes.size()) - 1;
  }

  void add_clip() {
    GltfClip clip{"clip", {}};
    for (std::size_t n = 0; n < scene_.nodes.size(); ++n)
      for (const std::string path : {"rotation", "translation"}) {
        GltfTrack track{static_cast<int>(n), path, {0.25f * static_cast<float>(pick(0, 2))}, {}};
        while (static_cast<int>(track.times.size()) < pick(2, 4)) track.times.push_back(track.times.back() + 1.1f + real());
        for (std::size_t k = 0; k < track.times.size(); ++k) {
          const Eigen::Quaternionf q = rotation();
          if (path == "rotation") track.values.insert(track.values.end(), {q.x(), q.y(), q.z(), q.w()});
          else track.values.insert(track.values.end(), {real(), real(), real()});
        }
        clip.tracks.push_back(track);
      }
    scene_.clips.push_back(clip);
  }

  RigTraits traits_;
  std::mt19937 random_;
  RiggedGltf scene_;
  std::vector<Eigen::Isometry3f> binds_;
};

}  // namespace

RigTraits draw_traits() {
  RigTraits traits;
  traits.joints = *rc::gen::inRange(1, 10);
  traits.scale = *rc::gen::element(1.0, 0.01, 1.0884, 100.0);
  traits.mirrored = *rc::gen::arbitrary<bool>();
  traits.many_influences = *rc::gen::arbitrary<bool>();
  traits.second_skin = *rc::gen::arbitrary<bool>();
  traits.split_joint = *rc::gen::arbitrary<bool>();
  traits.other_joints = *rc::gen::arbitrary<bool>();
  traits.loose_mesh = *rc::gen::arbitrary<bool>();
  traits.seed = *rc::gen::arbitrary<unsigned>();
  return traits;
}

RiggedGltf random_rig(const RigTraits& traits) { return Maker(traits).make(); }

}  // namespace proptests::gen
