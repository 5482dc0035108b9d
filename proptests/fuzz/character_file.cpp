// SPDX-License-Identifier: GPL-3.0-or-later
// Baked characters: whatever the bytes, with a checksum that fits them, they are refused or make a character that can be refitted.
#include "algorithms/runtime/tree/character_file.hpp"

#include "algorithms/runtime/refit/variants.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

namespace {

// The bytes with the size and the checksum in the header that belong to them; behind that nothing is changed.
std::string with_checksum(std::string bytes) {
  constexpr std::size_t size_at = 12, sum_at = 20, body_at = 28;
  if (bytes.size() < body_at) return bytes;
  std::uint64_t sum = 0xcbf29ce484222325, size = bytes.size() - body_at;
  for (std::size_t i = body_at; i < bytes.size(); ++i) sum = (sum ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
  for (int i = 0; i < 8; ++i)
    bytes[size_at + i] = static_cast<char>(size >> 8 * i), bytes[sum_at + i] = static_cast<char>(sum >> 8 * i);
  return bytes;
}

}  // namespace

FUZZ_TARGET(character_file, bytes) try {
  const Character c = character_of(with_checksum(bytes), "fuzz");
  validate(c.mesh);
  for (const RefitVariant& variant : refit_variants())
    if (c.has(variant.pieces))
      refit_all(c, variant, make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), variant.skinning));
  check(bytes_of(character_of(bytes_of(c), "fuzz")) == bytes_of(c), "a character that was read is written as it was");
} catch (const ModelError&) {
}
