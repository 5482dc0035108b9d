// SPDX-License-Identifier: MIT
// A binary glTF 2.0 file consists of chunks [Khronos 2021, "glTF 2.0 specification", section 4.4].
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace refitlab {

struct GlbChunk {
  std::uint32_t type;
  std::string data;  // as in the file, with its padding
};

inline constexpr std::uint32_t json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;
// This is "RFLB", the type of refitlab's chunk. Readers skip chunks of types that they do not know.
inline constexpr std::uint32_t refitlab_chunk = 0x424C4652;

// Returns the chunks in order. The first one is JSON. file is for error messages. Throws ModelError for bytes that are no binary
// glTF 2.0, that end early or late, whose chunks do not fit, or whose JSON begins with a byte order mark or has a NUL
// character. NULs behind the JSON are left out.
std::vector<GlbChunk> read_glb(const std::string& bytes, const std::string& file);

// Returns the bytes of a file with these chunks. Data is padded to a multiple of four, JSON with spaces and all else with zeros.
// Throws ModelError if the file would be longer than 2^32 - 1 bytes.
std::string glb_of(const std::vector<GlbChunk>& chunks, const std::string& file);

}  // namespace refitlab
