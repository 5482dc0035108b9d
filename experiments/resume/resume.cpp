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

void add_clip(Fingerprint& print, const Clip& clip) {
  print.add(std::string_view(clip.name));
  print.add(clip.duration);
  for (int i = 0; i < times_per_clip; ++i) try {
      for (const RigidTransform<double>& c : clip.sample(clip.duration * i / (times_per_clip - 1))) {
        add_numbers(print, c.rotation);
        add_numbers(print, c.translation);
      }
    } catch (const ModelError& e) {  // a pose that no experiment need come across
      print.add(std::string_view(e.what()));
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
  for (const Clip& clip : model.clips) add_clip(print, clip);
  return print.text();
}

}  // namespace refitlab
