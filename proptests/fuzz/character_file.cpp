// SPDX-License-Identifier: GPL-3.0-or-later
// Tries baked characters: whatever the bytes, with a checksum that fits them, they are refused or make a character that can be
// refitted.
#include "algorithms/runtime/tree/character_file.hpp"

#include "algorithms/runtime/refit/deformed_reference.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "proptests/fuzz/resealed.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

FUZZ_TARGET(character_file, bytes) try {
  const Character c = character_of(proptests::fuzz::resealed(bytes), "fuzz");
  validate(c.mesh);
  const Deformation deformation{std::vector<double>(static_cast<std::size_t>(c.mesh.targets.count), 0.5), {}};
  for (const RefitVariant& variant : refit_variants())
    if (c.has(variant.pieces)) {
      const auto palette = make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), variant.skinning);
      refit_all(c, variant, palette);
      DeformedReference reference(c, variant.pieces);
      reference.begin(deformation);
      for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) variant.refit(reference.refit_node(n, palette));
    }
  check(bytes_of(character_of(bytes_of(c), "fuzz")) == bytes_of(c), "a character that was read is written as it was");
} catch (const ModelError&) {
}
