// SPDX-License-Identifier: GPL-3.0-or-later
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include "algorithms/model/gltf_file.hpp"

#include <algorithm>
#include <filesystem>

#include "algorithms/model/gltf_description.hpp"
#include "algorithms/model/model.hpp"
#include "algorithms/model/regular_file.hpp"

namespace refitlab {
namespace {

// Beside is the folder of the file that is read. tinygltf reads the buffers beside it once each, in order.
struct Beside {
  std::string folder;
  std::vector<std::size_t> lengths;  // of the buffers that are left to read, the next one last
};

// Returns whether a file is beside the one that refers to it. It may be nowhere else, but tinygltf looks into the working
// directory too.
bool is_beside(const std::string& path, void* beside) {
  std::error_code error;
  return path.starts_with(static_cast<const Beside*>(beside)->folder) && std::filesystem::is_regular_file(path, error);
}

// Reads as much of a file as the buffer has. There may be more.
bool read_beside(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* beside) {
  std::vector<std::size_t>& lengths = static_cast<Beside*>(beside)->lengths;
  const auto bytes = bytes_of_regular_file(path);
  if (!bytes || lengths.empty()) return *error = "cannot be read", false;
  out->assign(bytes->begin(), bytes->begin() + static_cast<std::ptrdiff_t>(std::min(lengths.back(), bytes->size())));
  lengths.pop_back();
  return true;
}

std::string as_it_is(const std::string& path, void*) { return path; }

}  // namespace

tinygltf::Model read_gltf(const std::string& bytes, const std::string& path) {
  const GltfGeometry geometry = gltf_geometry(bytes, path);
  Beside beside{std::filesystem::path(path).parent_path().string(), {geometry.lengths.rbegin(), geometry.lengths.rend()}};
  std::string &folder = beside.folder, error, warning;
  folder = folder.empty() ? "./" : folder.ends_with("/") ? folder : folder + "/";
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks({is_beside, as_it_is, read_beside, nullptr, &beside});
  tinygltf::Model out;
  bool is_read = false;
  try {
    is_read = reader.LoadBinaryFromMemory(&out, &error, &warning, reinterpret_cast<const unsigned char*>(geometry.glb.data()),
                                          static_cast<unsigned>(geometry.glb.size()), folder, tinygltf::NO_REQUIRE);
  } catch (const std::exception& e) {
    error += e.what();
  }
  if (!is_read || !error.empty()) {
    error.resize(error.find_last_not_of(" \n") + 1);  // its reasons are lines
    throw ModelError(path, "glTF description", "tinygltf cannot read it: " + error.substr(0, 200));
  }
  return out;
}

}  // namespace refitlab
