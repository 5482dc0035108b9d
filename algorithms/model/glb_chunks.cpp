// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/glb_chunks.hpp"

#include <cstdint>
#include <cstring>

#include "algorithms/model/model.hpp"

namespace refitlab {
namespace {

std::string word_bytes(std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  std::string out(4, '\0');
  std::memcpy(out.data(), &word, 4);
  return out;
}

}  // namespace

GlbChunks take_apart(const std::string& bytes, const std::string& path) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    if (at + 4 > bytes.size()) throw ModelError(path, "file", "ends early");
    std::memcpy(&value, bytes.data() + at, 4);
    return std::size_t{value};
  };
  if (word(4) != 2) throw ModelError(path, "file", "glTF of version " + std::to_string(word(4)) + ", not 2");
  if (word(8) > bytes.size()) throw ModelError(path, "file", "ends early");
  const auto chunk = [&](std::size_t at) {
    if (at + 8 + word(at) > bytes.size()) throw ModelError(path, "file", "ends early");
    return bytes.substr(at + 8, word(at));
  };
  GlbChunks out{chunk(12), {}};
  const std::size_t next = 20 + out.description.size();
  if (next + 8 <= bytes.size()) out.binary = chunk(next);
  return out;
}

std::string put_together(GlbChunks chunks) {
  const auto pad = [](std::string& chunk, char with) { chunk.resize((chunk.size() + 3) / 4 * 4, with); };
  pad(chunks.description, ' ');
  pad(chunks.binary, '\0');
  std::string out = word_bytes(chunks.description.size()) + "JSON" + chunks.description;
  if (!chunks.binary.empty()) out += word_bytes(chunks.binary.size()) + std::string("BIN\0", 4) + chunks.binary;
  return "glTF" + word_bytes(2) + word_bytes(out.size() + 12) + out;
}

}  // namespace refitlab
