// SPDX-License-Identifier: GPL-3.0-or-later
// A BakedFile is what `refitlab bake` wrote into a glTF file, read back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "algorithms/bake/over_time/crossfaded_joints.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "algorithms/runtime/tree/character.hpp"
#include "algorithms/runtime/tree/cluster_bounds.hpp"

namespace refitlab {

struct BakedFile {
  Skinning skinning;
  RotationBlend rotations;             // of crossfades
  std::optional<Character> character;  // none where it was left out
  ClusterBounds clusters;
};

// Returns the chunk of refitlab, which has the skinning, how crossfades blend rotations, the baked character and the clusters.
std::string chunk_of(const BakedFile& baked);

// Returns what a chunk has. There may be up to three zeros behind it. Throws ModelError for a chunk that is damaged.
BakedFile baked_of(std::string_view chunk, const std::string& file);

// Reads the chunk of a file. Throws ModelError for a file that is no binary glTF, has no such chunk, or a damaged one.
BakedFile read_baked(const std::string& path);

}  // namespace refitlab
