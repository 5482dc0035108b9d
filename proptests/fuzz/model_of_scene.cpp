// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the conversion of scenes: it returns a valid model whose clips give rigid poses or say why not, or refuses.
#include "algorithms/model/model_of_scene.hpp"

#include <cmath>

#include "algorithms/model/assimp_scene.hpp"
#include "proptests/fuzz/scene_of_bytes.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

namespace {

bool is_rigid(const Pose& pose) {
  bool good = true;
  for (const auto& c : pose)
    good = good && std::abs(squared_norm(c.rotation) - 1) < 1e-12 && std::isfinite(squared_norm(c.translation));
  return good;
}

}  // namespace

FUZZ_TARGET(model_of_scene, bytes) try {
  const auto scene = scene_of_bytes(bytes);
  check_assimp_scene(*scene, "fuzz");
  const Model model = refitlab::model_of_scene(convert_scene(*scene, "fuzz"));
  try {
    validate(model);
  } catch (const ModelError&) {
    check(false, "a model is valid");
  }
  check(model.rigidity_defect >= 0 && model.rigidity_defect < 0.01, "joints are nearly rigid");
  for (const Clip& clip : model.clips)
    for (int i = 0; i < 8; ++i) try {
        check(is_rigid(clip.sample(clip.duration * i / 7)), "poses are rigid");
      } catch (const ModelError& e) {
        check(std::string(e.what()).starts_with("fuzz: clip '"), "a refused pose names its clip");
      }
} catch (const ModelError& e) {
  check(std::string(e.what()).starts_with("fuzz: "), "a refusal names the file");
}
