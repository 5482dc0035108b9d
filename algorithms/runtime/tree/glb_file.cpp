// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/glb_file.hpp"

#include <limits>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {
namespace {

constexpr std::uint32_t glb_magic = 0x46546C67, glb_version = 2;
constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

void put_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(word >> 8 * i & 0xFF));
}

}  // namespace

std::vector<GlbChunk> read_glb(const std::string& bytes, const std::string& file) {
  if (bytes.size() < header_size || word_at(bytes, 0) != glb_magic) throw ModelError(file, "file", "it is no binary glTF (.glb)");
  if (word_at(bytes, 4) != glb_version)
    throw ModelError(file, "file", "it is glTF " + std::to_string(word_at(bytes, 4)) + ", and only glTF 2 is read");
  if (word_at(bytes, 8) != bytes.size())
    throw ModelError(
        file, "file",
        "it says that it has " + std::to_string(word_at(bytes, 8)) + " bytes, but has " + std::to_string(bytes.size()));
  std::vector<GlbChunk> chunks;
  for (std::size_t at = header_size; at < bytes.size();) {
    const std::string thing = "chunk " + std::to_string(chunks.size());
    if (bytes.size() - at < chunk_header_size) throw ModelError(file, thing, "the file ends in its header");
    const std::uint32_t size = word_at(bytes, at), type = word_at(bytes, at + 4);
    at += chunk_header_size;
    if (bytes.size() - at < size) throw ModelError(file, thing, "the file ends in its data");
    if (size % 4 != 0) throw ModelError(file, thing, "its size is no multiple of four");
    chunks.push_back({type, bytes.substr(at, size)});
    at += size;
  }
  if (chunks.empty() || chunks[0].type != json_chunk) throw ModelError(file, "chunk 0", "it is not JSON");
  // Some exporters fill the chunk up with NULs, where glTF has spaces. JSON has them nowhere.
  std::string& text = chunks[0].data;
  text.erase(text.find_last_not_of('\0') + 1);
  if (text.find('\0') != std::string::npos) throw ModelError(file, "chunk 0", "its JSON has a NUL character");
  // glTF is to be written without it, and RFC 8259 (8.1) lets readers take it for an error.
  if (text.starts_with("\xef\xbb\xbf"))
    throw ModelError(file, "chunk 0", "its JSON begins with a byte order mark, which is to be left out");
  return chunks;
}

std::string glb_of(const std::vector<GlbChunk>& chunks, const std::string& file) {
  std::string body;
  for (const GlbChunk& chunk : chunks) {
    std::string data = chunk.data;
    data.resize((data.size() + 3) / 4 * 4, chunk.type == json_chunk ? ' ' : '\0');
    if (header_size + body.size() + chunk_header_size + data.size() > std::numeric_limits<std::uint32_t>::max())
      throw ModelError(file, "file", "it would have more than 2^32 bytes, which binary glTF cannot say");
    put_word(body, static_cast<std::uint32_t>(data.size()));
    put_word(body, chunk.type);
    body += data;
  }
  std::string bytes;
  put_word(bytes, glb_magic), put_word(bytes, glb_version),
      put_word(bytes, static_cast<std::uint32_t>(header_size + body.size()));
  return bytes + body;
}

}  // namespace refitlab
