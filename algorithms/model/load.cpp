// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/load.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>

#include "algorithms/model/gltf_audit.hpp"
#include "algorithms/model/model_of_scene.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// What assimp says of its last failure; some of its messages quote the rest of the file.
std::string complaint(const Assimp::Importer& importer) { return std::string(importer.GetErrorString()).substr(0, 200); }

// The scene as the file has it, checked, then triangulated.
const aiScene& read_scene(Assimp::Importer& importer, const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw ModelError(path, "file", "does not exist");
  audit_gltf(path);
  const aiScene* scene = importer.ReadFile(path, 0);
  if (!scene) throw ModelError(path, "file", "assimp cannot read it: " + complaint(importer));
  check_scene(*scene, path);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (!scene) throw ModelError(path, "file", "assimp cannot triangulate it: " + complaint(importer));
  return *scene;
}

}  // namespace

Model load_model(const std::string& path, const LoadOptions&) {
  const DefaultFloatEnvironment environment;
  Assimp::Importer importer;
  return model_of_scene(read_scene(importer, path), path);
}

}  // namespace refitlab
