// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/load.hpp"

#include "algorithms/model/assimp_scene.hpp"
#include "algorithms/model/gltf_scene.hpp"
#include "algorithms/model/model_of_scene.hpp"
#include "algorithms/model/regular_file.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

Model load_model(const std::string& path, const LoadOptions& options) {
  const DefaultFloatEnvironment environment;
  const auto bytes = bytes_of_regular_file(path);
  if (!bytes) throw ModelError(path, "file", "does not exist, or is no regular file that can be read");
  return model_of_scene(is_gltf(*bytes, path) ? gltf_scene(*bytes, path) : assimp_scene(path), options);
}

}  // namespace refitlab
