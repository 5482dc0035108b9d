// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the reader of glTF files, binary and text: it returns a valid model with a skin matrix for each joint, or refuses.
#include "algorithms/model/gltf_scene.hpp"

#include "algorithms/model/model_of_scene.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

FUZZ_TARGET(gltf_scene, bytes) try {
  const Scene scene = refitlab::gltf_scene(bytes, "fuzz.glb");
  for (const Joints joints : {Joints::rigid, Joints::affine})
    for (const Morphs morphs : {Morphs::constant, Morphs::moving}) try {
        const Model model = model_of_scene(scene, {joints, morphs});
        try {
          validate(model);
        } catch (const ModelError&) {
          check(false, "a model is valid");
        }
        for (const SourcePrimitive& source : model.sources)
          for (const int vertex : source.vertices)
            check(vertex < static_cast<int>(model.vertices.size()), "a source's vertices are the model's");
        for (const Clip& clip : model.clips) {
          const auto matrices = skin_matrices(model.skeleton, clip.animation, clip.duration / 2);
          check(matrices.size() == model.joints.size(), "there is a matrix for each joint");
        }
      } catch (const ModelError& e) {
        check(std::string(e.what()).starts_with("fuzz.glb: "), "a refusal names the file");
      }
} catch (const ModelError& e) {
  check(std::string(e.what()).starts_with("fuzz.glb: "), "a refusal names the file");
}
