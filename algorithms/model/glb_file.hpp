// SPDX-License-Identifier: GPL-3.0-or-later
// A binary glTF 2.0 file as the chunks that it consists of [Khronos 2021, "glTF 2.0 specification", section 4.4].
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
// "RFLB", the chunk of refitlab. Readers skip chunks of types that they do not know.
inline constexpr std::uint32_t refitlab_chunk = 0x424C4652;

// The chunks, in order; the first one is JSON. file: for errors. Throws ModelError for bytes that are no binary glTF 2.0, that end
// early or late, or whose chunks do not fit.
std::vector<GlbChunk> read_glb(const std::string& bytes, const std::string& file);

// The bytes of a file with these chunks. Data is padded to a multiple of four: JSON with spaces, all else with zeros. Throws
// ModelError where it would be longer than 2^32 - 1 bytes.
std::string glb_of(const std::vector<GlbChunk>& chunks, const std::string& file);

}  // namespace refitlab
