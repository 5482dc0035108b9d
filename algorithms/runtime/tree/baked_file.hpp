// SPDX-License-Identifier: MIT
// A BakedFile is what `refitlab bake` wrote into a binary glTF file, read back.
//
// It is in a chunk of its own, of the type "RFLB" (0x424C4652). Format, version 2, as in character_file.hpp:
//   "rflbaked"                 8 bytes
//   version, size, checksum    4 + 8 + 8 bytes
//   skinning                   4 bytes: 0 linear, 1 dual quaternion, 2 spherical
//   rotations                  4 bytes: 0 slerp, 1 nlerp, as crossfades blend them
//   the character              its size (8 bytes) and its bytes, as in character_file.hpp; none where it was left out
//   the clusters               their size (8 bytes) and their bytes, as in cluster_bounds.hpp
// Up to three zeros follow, so that the chunk ends at a multiple of four bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "algorithms/runtime/skinning/rotation_blend.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "algorithms/runtime/tree/character.hpp"
#include "algorithms/runtime/tree/cluster_bounds.hpp"

namespace refitlab {

// A BakedFile is what the runtime reads of a file. Bounds of the whole model, of skins, meshes and primitives are not part of it:
// they are in the glTF's `extras`.
struct BakedFile {
  Skinning skinning;
  RotationBlend rotations;             // of crossfades
  std::optional<Character> character;  // none where it was left out
  ClusterBounds clusters;
};

// Returns the chunk of refitlab, which has the skinning, how crossfades blend rotations, the baked character and the clusters.
// Throws std::invalid_argument for Skinning::hejl, of which there are no bounds over time.
std::string chunk_of(const BakedFile& baked);

// Returns what a chunk has. There may be up to three zeros behind it. Throws ModelError for a chunk that is damaged.
BakedFile baked_of(std::string_view chunk, const std::string& file);

// Reads the chunk of a file. Throws ModelError for a file that is no binary glTF, has no such chunk, or a damaged one.
BakedFile read_baked(const std::string& path);

}  // namespace refitlab
