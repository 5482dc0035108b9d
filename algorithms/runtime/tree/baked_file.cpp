// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/baked_file.hpp"

#include <algorithm>

#include "algorithms/runtime/tree/binary.hpp"
#include "algorithms/runtime/tree/character_file.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"

namespace refitlab {
namespace {

const std::string chunk_name = "chunk of refitlab";
constexpr std::string_view chunk_magic = "rflbaked";
constexpr std::uint32_t chunk_version = 2;
constexpr Skinning chunk_skinnings[] = {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical};

}  // namespace

std::string chunk_of(const BakedFile& baked) {
  BinaryWriter body;
  const auto* skinning = std::find(std::begin(chunk_skinnings), std::end(chunk_skinnings), baked.skinning);
  if (skinning == std::end(chunk_skinnings)) throw std::invalid_argument("chunk_of: a file has no bounds of Hejl's skinning");
  body.number(static_cast<std::uint32_t>(skinning - chunk_skinnings));
  body.number(static_cast<std::uint32_t>(baked.rotations));
  const auto add = [&](const std::string& part) { body.number(static_cast<std::uint64_t>(part.size())), body.bytes += part; };
  add(baked.character ? bytes_of(*baked.character) : "");
  add(bytes_of(baked.clusters));
  return sealed(chunk_magic, chunk_version, body.bytes);
}

BakedFile baked_of(std::string_view bytes, const std::string& path) {
  // The chunk is padded with up to three zeros, which its size does not count.
  constexpr std::size_t size_at = 12, header = 28;
  if (bytes.size() >= header) {
    std::uint64_t size = 0;
    BinaryReader(bytes.substr(size_at), chunk_name, path).number(size);
    if (size <= bytes.size() - header && bytes.size() - header - size < 4 &&
        bytes.find_first_not_of('\0', header + size) == std::string_view::npos)
      bytes = bytes.substr(0, header + size);
  }
  BinaryReader in = opened(bytes, chunk_magic, chunk_version, chunk_name, path);
  std::uint32_t skinning = 0, rotations = 0;
  in.number(skinning), in.number(rotations);
  if (skinning >= std::size(chunk_skinnings)) throw ModelError(path, chunk_name, "there is no such skinning");
  if (rotations > 1) throw ModelError(path, chunk_name, "there is no such blend of rotations");
  const auto part = [&] {
    std::uint64_t size = 0;
    in.number(size);
    return in.take(size);
  };
  const std::string_view character = part(), clusters = part();
  in.end();
  BakedFile out{chunk_skinnings[skinning], rotations == 1 ? RotationBlend::nlerp : RotationBlend::slerp, std::nullopt,
                cluster_bounds_of(clusters, path)};
  if (!character.empty()) out.character = character_of(character, path);
  // All clips have equally many.
  const std::size_t nodes = out.clusters.clips[0].nodes.size();
  if (nodes > 0 && (!out.character || out.character->tree.nodes.size() != nodes))
    throw ModelError(path, "clips", "they have bounds of nodes that are not the character's");
  return out;
}

BakedFile read_baked(const std::string& path) {
  const std::vector<GlbChunk> chunks = read_glb(read_bytes(path), path);
  const auto found =
      std::find_if(chunks.begin(), chunks.end(), [](const GlbChunk& chunk) { return chunk.type == refitlab_chunk; });
  if (found == chunks.end()) throw ModelError(path, "file", "it was not baked: refitlab bake writes a chunk that is not there");
  return baked_of(found->data, path);
}

}  // namespace refitlab
