// SPDX-License-Identifier: GPL-3.0-or-later
// Files that refitlab bake wrote: whatever the bytes, with checksums that fit them, the chunk of refitlab is refused or read, and what
// is read is written as it was.
#include "algorithms/program/baked_file.hpp"

#include "algorithms/program/glb_file.hpp"
#include "proptests/fuzz/resealed.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

namespace {

// The chunk with checksums that fit, of its two parts too, where their sizes do.
std::string resealed_chunk(std::string chunk) {
  constexpr std::size_t parts_at = 28 + 8;
  for (std::size_t at = parts_at, part = 0; part < 2 && at + 8 <= chunk.size(); ++part) {
    std::uint64_t size = 0;
    for (int i = 7; i >= 0; --i) size = size << 8 | static_cast<unsigned char>(chunk[at + i]);
    at += 8;
    if (size > chunk.size() - at) break;
    chunk.replace(at, size, proptests::fuzz::resealed(chunk.substr(at, size)));
    at += size;
  }
  return proptests::fuzz::resealed(chunk);
}

}  // namespace

FUZZ_TARGET(baked_file, bytes) try {
  for (const GlbChunk& chunk : read_glb(bytes, "fuzz")) {
    if (chunk.type != refitlab_chunk) continue;
    const std::string resealed = resealed_chunk(chunk.data);
    const BakedFile baked = baked_of(resealed, "fuzz");
    check(chunk_of(baked) == resealed, "a chunk that was read is written as it was");
  }
} catch (const ModelError& e) {
  check(std::string(e.what()).starts_with("fuzz: "), "a refusal names the file");
}
