// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the chunk of a baked file is the same once it is written and read again. program.cpp tests what is refused of
// damaged files.
#include "algorithms/runtime/tree/baked_file.hpp"

#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/tree/character_file.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_baked_file {
namespace {

using namespace refitlab;

ClusterBounds without_clusters() {
  ClusterBounds clusters;
  clusters.clips.push_back({"", 0, {}, {}});
  return clusters;
}

void chunks_are_read_as_they_were_written(Suite& t) {
  t.example("a chunk of each skinning and blend of rotations, with a character and without, is read as it was written", {}, [] {
    const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    std::string wrong;
    long tried = 0;
    for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical})
      for (const RotationBlend rotations : {RotationBlend::slerp, RotationBlend::nlerp})
        for (const bool is_with_character : {false, true}) {
          BakedFile baked{skinning, rotations, std::nullopt, without_clusters()};
          if (is_with_character) baked.character = c;
          const std::string chunk = chunk_of(baked);
          const BakedFile read = baked_of(chunk, "any");
          ++tried;
          if (read.skinning != skinning || read.rotations != rotations || read.character.has_value() != is_with_character ||
              (read.character && bytes_of(*read.character) != bytes_of(c)) || chunk_of(read) != chunk)
            wrong += std::to_string(tried) + "; ";
        }
    return Checked(wrong.empty(), tried, wrong);
  });
  t.example("no chunk is written for Hejl's skinning, which no reader would accept", {}, [] {
    try {
      chunk_of({Skinning::hejl, RotationBlend::slerp, std::nullopt, without_clusters()});
    } catch (const std::invalid_argument& e) {
      return Checked(std::string(e.what()) == "chunk_of: a file has no bounds of Hejl's skinning", 1, e.what());
    }
    return Checked(false, 1, "it is written");
  });
}

}  // namespace

PROPTEST(baked_file) { chunks_are_read_as_they_were_written(t); }

}  // namespace proptests::suite_baked_file
