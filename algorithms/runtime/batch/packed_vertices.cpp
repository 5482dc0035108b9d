// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/packed_vertices.hpp"

#include <algorithm>
#include <numeric>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr int lanes = Lanes<double>::count;

JointSetNumbers numbers_of(const PaletteEntry<double>& palette) {
  static_assert(sizeof(RigidTransform<double>) % sizeof(double) == 0 && sizeof(AffineMap<double>) == 12 * sizeof(double));
  return {static_cast<int>(palette.transforms.size()),
          palette.transforms[0].rotation.data(),
          sizeof(RigidTransform<double>) / sizeof(double),
          palette.rotation_center.data(),
          palette.center_images[0].data(),
          palette.duals[0].data(),
          palette.maps.empty() ? nullptr : palette.maps[0].columns[0].data()};
}

std::vector<int> all_vertices(const SkinnedMesh& mesh) {
  std::vector<int> out(mesh.vertices.size());
  std::iota(out.begin(), out.end(), 0);
  return out;
}

}  // namespace

PackedVertices::PackedVertices(const SkinnedMesh& mesh, const JointSets& sets, std::span<const std::vector<int>> groups,
                               int padding) {
  for (const auto& group : groups) add_group(mesh, sets, group, padding);
}

PackedVertices::PackedVertices(const SkinnedMesh& mesh, const JointSets& sets) {
  add_group(mesh, sets, all_vertices(mesh), lanes);
}

void PackedVertices::add_group(const SkinnedMesh& mesh, const JointSets& sets, std::vector<int> group, int padding) {
  const DefaultFloatEnvironment environment;
  std::stable_sort(group.begin(), group.end(), [&](int a, int b) { return sets.of_vertex(a) < sets.of_vertex(b); });
  for (std::size_t first = 0, next; first < group.size(); first = next) {
    const int set = sets.of_vertex(group[first]);
    next = first;
    while (next < group.size() && sets.of_vertex(group[next]) == set) ++next;
    const int count = static_cast<int>(next - first), block_count = (count + padding - 1) / padding * (padding / lanes);
    const int joints = static_cast<int>(sets.joints(set).size());
    runs_.push_back({set, static_cast<int>(data_.size()), static_cast<int>(vertices_.size()) / lanes, block_count});
    for (int place = 0; place < lanes * block_count; ++place) {
      const int v = group[first + std::min(place, count - 1)], lane = place % lanes;
      if (lane == 0) data_.resize(data_.size() + 3 + joints);
      Lanes<double>* block = data_.data() + data_.size() - 3 - joints;
      for (int i = 0; i < 3; ++i) block[i].lane[lane] = mesh.vertices[v][i];
      for (int i = 0; i < joints; ++i) block[3 + i].lane[lane] = sets.weights(v)[i];
      vertices_.push_back(v);
    }
  }
  first_run_.push_back(static_cast<int>(runs_.size()));
}

std::span<const int> PackedVertices::vertices(int group) const {
  if (first_run_[group] == first_run_[group + 1]) return {};
  const Run &first = runs_[first_run_[group]], &last = runs_[first_run_[group + 1] - 1];
  const int begin = first.first_block * lanes, end = (last.first_block + last.block_count) * lanes;
  return {vertices_.data() + begin, static_cast<std::size_t>(end - begin)};
}

void PackedVertices::skin_group(int group, const SkinningPalette<double>& palette, Skinning skinning, SkinnedVertices& out,
                                Target target) const {
  const DefaultFloatEnvironment environment;
  const SkinRun run = kernel(palette.is_affine(), skinning, target);
  const std::size_t size = 3 * vertices(group).size() / lanes;
  if (out.blocks.size() < size) out.blocks.resize(size);
  Lanes<double>* to = out.blocks.data();
  for (int r = first_run_[group]; r < first_run_[group + 1]; to += 3 * runs_[r++].block_count)
    skin_run(runs_[r], palette, run, to);
}

void PackedVertices::skin_block(int group, int block, const SkinningPalette<double>& palette, Skinning skinning,
                                Lanes<double>* out, Target target) const {
  const DefaultFloatEnvironment environment;
  const int at = runs_[first_run_[group]].first_block + block;
  const auto after = std::upper_bound(runs_.begin() + first_run_[group], runs_.begin() + first_run_[group + 1], at,
                                      [](int b, const Run& run) { return b < run.first_block; });
  Run run = after[-1];
  run.first_data += (at - run.first_block) * (3 + static_cast<int>(palette.joint_count(run.joint_set)));
  run.block_count = 1;
  skin_run(run, palette, kernel(palette.is_affine(), skinning, target), out);
}

void PackedVertices::skin_all(const SkinningPalette<double>& palette, Skinning skinning, std::span<Point3> out,
                              Target target) const {
  const DefaultFloatEnvironment environment;
  const SkinRun run = kernel(palette.is_affine(), skinning, target);
  std::vector<Lanes<double>> images;
  for (const Run& r : runs_) {
    if (images.size() < 3 * static_cast<std::size_t>(r.block_count)) images.resize(3 * r.block_count);
    skin_run(r, palette, run, images.data());
    const int* vertex = vertices_.data() + r.first_block * lanes;
    for (int block = 0; block < r.block_count; ++block, vertex += lanes) {
      const Lanes<double>* image = images.data() + 3 * block;
      for (int lane = 0; lane < lanes; ++lane)
        out[vertex[lane]] = {image[0].lane[lane], image[1].lane[lane], image[2].lane[lane]};
    }
  }
}

void PackedVertices::skin_run(const Run& run, const SkinningPalette<double>& palette, SkinRun kernel, Lanes<double>* out) const {
  kernel(numbers_of(palette[run.joint_set]), data_.data() + run.first_data, run.block_count, out);
}

SkinRun PackedVertices::kernel(bool is_affine, Skinning skinning, Target target) const {
  const SkinKernels& kernels = skin_kernels(target);
  if (is_affine) return kernels.affine;
  switch (skinning) {
    case Skinning::linear: return kernels.linear;
    case Skinning::dual_quaternion: return kernels.dual_quaternion;
    default: return kernels.spherical;
  }
}

}  // namespace refitlab
