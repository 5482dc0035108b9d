// SPDX-License-Identifier: GPL-3.0-or-later
// Tries files that refitlab bake wrote: whatever the bytes, with checksums that fit them, the chunk of refitlab is refused or
// read, and what is read is written as it was.
#include "algorithms/runtime/tree/baked_file.hpp"

#include "algorithms/runtime/tree/glb_file.hpp"
#include "proptests/fuzz/resealed.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

namespace {

// Returns the chunk with checksums that fit, also of its two parts if their sizes fit. The bytes that pad it to words are not
// kept.
std::string resealed_chunk(std::string chunk) {
  constexpr std::size_t parts_at = 28 + 8;
  for (std::size_t at = parts_at, part = 1; part <= 2 && at + 8 <= chunk.size(); ++part) {
    std::uint64_t size = 0;
    for (int i = 7; i >= 0; --i) size = size << 8 | static_cast<unsigned char>(chunk[at + i]);
    at += 8;
    if (size > chunk.size() - at) break;
    chunk.replace(at, size, proptests::fuzz::resealed(chunk.substr(at, size)));
    at += size;
    if (part == 2 && chunk.size() - at < 4) chunk.resize(at);
  }
  return proptests::fuzz::resealed(chunk);
}

}  // namespace

FUZZ_TARGET(baked_file, bytes) try {
  for (const GlbChunk& chunk : read_glb(bytes, "fuzz")) {
    if (chunk.type != refitlab_chunk) continue;
    // A character without a name gets the file's, so the first chunk that is written is compared, not the one that was read.
    const std::string written = chunk_of(baked_of(resealed_chunk(chunk.data), "fuzz"));
    check(chunk_of(baked_of(written, "fuzz")) == written, "a chunk that was read is written as it was");
  }
} catch (const ModelError& e) {
  check(std::string(e.what()).starts_with("fuzz: "), "a refusal names the file");
}
