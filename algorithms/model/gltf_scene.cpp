// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_scene.hpp"

#include <filesystem>

#include "algorithms/model/gltf_animations.hpp"
#include "algorithms/model/gltf_meshes.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

Scene gltf_scene(const std::string& bytes, const std::string& path) {
  const DefaultFloatEnvironment environment;
  const tinygltf::Model source = read_gltf(bytes, path);
  const GltfNumbers numbers(source, path);
  const GltfNodes nodes = convert_nodes(source, path);
  Scene scene{path, nodes.nodes, convert_meshes(source, numbers, path), convert_skins(source, nodes, numbers, path), {}, {}};
  scene.shown = convert_shown(source, nodes, scene);
  note_other_scenes(source, nodes, scene);
  scene.animations = convert_animations(source, nodes, numbers, path, scene.notes);
  return scene;
}

bool is_gltf(const std::string& bytes, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return bytes.starts_with("glTF") || extension == ".glb" || extension == ".gltf" || extension == ".GLB" || extension == ".GLTF";
}

}  // namespace refitlab
