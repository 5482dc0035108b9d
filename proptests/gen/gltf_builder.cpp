// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/gltf_builder.hpp"

#include <cstdint>
#include <cstring>

namespace proptests::gen {
namespace {

std::string word(std::size_t number) {
  const auto value = static_cast<std::uint32_t>(number);
  std::string out(4, '\0');
  std::memcpy(out.data(), &value, 4);
  return out;
}

}  // namespace

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return out;
}

GltfBuilder::GltfBuilder() { json["asset"] = {{"version", "2.0"}}; }

std::size_t GltfBuilder::add_view(const void* data, std::size_t length) {
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}});
  bytes_.append(static_cast<const char*>(data), length);
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  return json["bufferViews"].size() - 1;
}

nlohmann::json GltfBuilder::with_buffer(const std::string& uri) const {
  nlohmann::json out = json;
  nlohmann::json buffer = {{"byteLength", bytes_.size()}};
  if (!uri.empty()) buffer["uri"] = uri;
  out["buffers"] = nlohmann::json::array({buffer});
  return out;
}

std::string GltfBuilder::binary_file() const {
  std::string text = with_buffer("").dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string body = word(text.size()) + "JSON" + text + word(bytes_.size()) + std::string("BIN\0", 4) + bytes_;
  return "glTF" + word(2) + word(12 + body.size()) + body;
}

std::string GltfBuilder::text_file() const {
  return with_buffer("data:application/octet-stream;base64," + base64(bytes_)).dump();
}

}  // namespace proptests::gen
