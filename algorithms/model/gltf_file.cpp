// SPDX-License-Identifier: GPL-3.0-or-later
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include "algorithms/model/gltf_file.hpp"

#include <filesystem>

#include "algorithms/model/gltf_description.hpp"
#include "algorithms/model/model.hpp"
#include "algorithms/model/regular_file.hpp"

namespace refitlab {
namespace {

// Returns whether a file is beside the one that refers to it. It may be nowhere else, but tinygltf looks into the working
// directory too.
bool is_beside(const std::string& path, void* folder) {
  std::error_code error;
  return path.starts_with(*static_cast<const std::string*>(folder)) && std::filesystem::is_regular_file(path, error);
}

bool read_beside(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
  const auto bytes = bytes_of_regular_file(path);
  if (!bytes) *error = "cannot be read";
  else out->assign(bytes->begin(), bytes->end());
  return bytes.has_value();
}

std::string as_it_is(const std::string& path, void*) { return path; }

}  // namespace

tinygltf::Model read_gltf(const std::string& bytes, const std::string& path) {
  const std::string geometry = gltf_geometry(bytes, path);
  std::string folder = std::filesystem::path(path).parent_path().string(), error, warning;
  folder = folder.empty() ? "./" : folder.ends_with("/") ? folder : folder + "/";
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks({is_beside, as_it_is, read_beside, nullptr, &folder});
  tinygltf::Model out;
  bool is_read = false;
  try {
    is_read = reader.LoadBinaryFromMemory(&out, &error, &warning, reinterpret_cast<const unsigned char*>(geometry.data()),
                                          static_cast<unsigned>(geometry.size()), folder, tinygltf::NO_REQUIRE);
  } catch (const std::exception& e) {
    error += e.what();
  }
  if (!is_read || !error.empty()) throw ModelError(path, "glTF description", "tinygltf cannot read it: " + error.substr(0, 200));
  return out;
}

}  // namespace refitlab
