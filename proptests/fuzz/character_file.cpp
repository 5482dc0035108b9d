// SPDX-License-Identifier: GPL-3.0-or-later
// Baked characters: whatever the bytes, with a checksum that fits them, they are refused or make a character that can be refitted.
#include "algorithms/runtime/tree/character_file.hpp"

#include "algorithms/runtime/refit/variants.hpp"
#include "proptests/fuzz/resealed.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

FUZZ_TARGET(character_file, bytes) try {
  const Character c = character_of(proptests::fuzz::resealed(bytes), "fuzz");
  validate(c.mesh);
  for (const RefitVariant& variant : refit_variants())
    if (c.has(variant.pieces))
      refit_all(c, variant, make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), variant.skinning));
  check(bytes_of(character_of(bytes_of(c), "fuzz")) == bytes_of(c), "a character that was read is written as it was");
} catch (const ModelError&) {
}
