// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "algorithms/results/write_whole.hpp"
#include "experiments/catalogue/catalogue.hpp"
#include "experiments/explorer/packed_model.hpp"

namespace refitlab {
namespace {

const char* const procedural[] = {"man", "creature"};

// Checks that the explorer will have the model of the run, up to rounding to float. What has a name twice has another one there.
void check(const Model& model, const Model& unpacked) {
  double size = 0;
  for (const Point3& v : model.vertices) size = std::max(size, v.norm());
  const auto near = [&](const Point3& a, const Point3& b) { return (a - b).norm() <= 1e-6 * std::max(size, a.norm()); };
  bool same = model.triangles == unpacked.triangles && model.vertices.size() == unpacked.vertices.size() &&
              model.clips.size() == unpacked.clips.size() && model.joints.size() == unpacked.joints.size();
  for (std::size_t j = 0; same && j < model.joints.size(); ++j) {
    const Joint &a = model.joints[j], &b = unpacked.joints[j];
    same = a.parent == b.parent && b.name.starts_with(a.name) && near(a.origin, b.origin);
  }
  for (std::size_t v = 0; same && v < model.vertices.size(); ++v) {
    const auto &a = model.influences[v], &b = unpacked.influences[v];
    same = near(model.vertices[v], unpacked.vertices[v]) &&
           std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Influence& x, const Influence& y) { return x.joint == y.joint && x.weight == y.weight; });
  }
  for (std::size_t i = 0; same && i < model.clips.size(); ++i) {
    const Clip &from = model.clips[i], &to = unpacked.clips[i];
    const int steps = packed_steps(from);
    same = from.duration == to.duration && to.name.starts_with(from.name);
    for (int k = 0; same && k <= steps; ++k) {
      const Pose a = from.sample(from.duration * k / steps), b = to.sample(from.duration * k / steps);
      for (std::size_t j = 0; same && j < a.size(); ++j)
        same = near(apply(a[j], model.joints[j].origin), apply(b[j], unpacked.joints[j].origin));
    }
  }
  if (!same) throw std::logic_error("packed models: " + model.name + " is another model when it is unpacked");
}

}  // namespace

std::vector<std::string> pack_models(const std::vector<Model>& models, const std::string& folder) {
  std::vector<std::string> out;
  for (const Model& model : models) {
    out.emplace_back();
    if (std::find(std::begin(procedural), std::end(procedural), model.name) != std::end(procedural)) continue;
    const auto bytes = pack(model);
    check(model, unpack(bytes));
    const std::filesystem::path name = std::to_string(out.size()) + ".model";
    write_whole((folder / name).string(), {bytes.begin(), bytes.end()});
    out.back() = (std::filesystem::path(folder).filename() / name).string();
  }
  return out;
}

}  // namespace refitlab
