// SPDX-License-Identifier: GPL-3.0-or-later
// Builds a glTF file: its description, and the one buffer that its accessors point into.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace proptests::gen {

// These are the component types of accessors.
enum : int { gltf_byte = 5120, gltf_ubyte = 5121, gltf_short = 5122, gltf_ushort = 5123, gltf_uint = 5125, gltf_float = 5126 };

class GltfBuilder {
 public:
  GltfBuilder();

  // Both return the index of what they add. type is a name such as "VEC3", and Row holds its numbers, one behind the other.
  std::size_t add_view(const void* data, std::size_t length);
  template <class Row>
  std::size_t add_accessor(const std::vector<Row>& rows, const char* type, int component) {
    const std::size_t view = add_view(rows.data(), rows.size() * sizeof(Row));
    json["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", rows.size()}, {"type", type}});
    return json["accessors"].size() - 1;
  }

  std::string binary_file() const;  // .glb
  std::string text_file() const;    // .gltf, with its bytes in a data URI

  nlohmann::json json;

 private:
  nlohmann::json with_buffer(const std::string& uri) const;
  std::string bytes_;
};

std::string base64(const std::string& bytes);

}  // namespace proptests::gen
