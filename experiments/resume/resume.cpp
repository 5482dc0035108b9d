// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/resume/resume.hpp"

#include "algorithms/runtime/tree/fingerprint.hpp"

namespace refitlab {
namespace {

constexpr int times_per_clip = 4096;

template <class Vector>
void add_numbers(Fingerprint& print, const Vector& v) {
  for (int i = 0; i < static_cast<int>(v.size()); ++i) print.add(v[i]);
}

void add_affine_pose(Fingerprint& print, const AffinePose& pose) {
  for (const AffineMap<double>& map : pose) {
    for (const auto& column : map.columns) add_numbers(print, column);
    add_numbers(print, map.offset);
  }
}

void add_morphs(Fingerprint& print, const Model& model) {
  for (const MorphedMesh& mesh : model.morphs) {
    print.add(mesh.node);
    add_numbers(print, mesh.weights);
    for (const MorphTarget& target : mesh.targets)
      for (const auto& [vertex, by] : target.displacements) {
        print.add(vertex);
        add_numbers(print, by);
      }
  }
}

void add_clip(Fingerprint& print, const Model& model, const Clip& clip) {
  print.add(std::string_view(clip.name));
  print.add(clip.duration);
  for (int i = 0; i < times_per_clip; ++i) {
    const double time = clip.duration * i / (times_per_clip - 1);
    if (!model.morphs.empty()) add_numbers(print, morph_weights(model, clip.animation, time));
    try {
      for (const RigidTransform<double>& c : clip.sample(time)) {
        add_numbers(print, c.rotation);
        add_numbers(print, c.translation);
      }
    } catch (const ModelError& e) {
      print.add(std::string_view(e.what()));
      if (!model.skeleton.joints.empty()) add_affine_pose(print, affine_pose(model.skeleton, clip.animation, time));
    }
  }
}

}  // namespace

std::string identify(const Model& model) {
  Fingerprint print;
  print.add(std::string_view(model.name));
  for (const Point3& p : model.vertices) add_numbers(print, p);
  for (const Triangle& t : model.triangles) add_numbers(print, t);
  for (const Joint& j : model.joints) {
    print.add(std::string_view(j.name));
    print.add(j.parent);
    add_numbers(print, j.origin);
  }
  for (const auto& influences : model.influences) {
    print.add(influences.size());
    for (const Influence& i : influences) print.add(i.joint), print.add(i.weight);
  }
  add_morphs(print, model);
  for (const Clip& clip : model.clips) add_clip(print, model, clip);
  return print.text();
}

}  // namespace refitlab
