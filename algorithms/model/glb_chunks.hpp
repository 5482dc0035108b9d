// SPDX-License-Identifier: GPL-3.0-or-later
// The two chunks of a binary glTF 2.0 file.
#pragma once

#include <string>

namespace refitlab {

struct GlbChunks {
  std::string description;  // JSON
  std::string binary;       // the bytes of its first buffer, padded to words; empty for none
};

// bytes: of a .glb file, or of a .gltf file, whose whole text is the description. path: for errors.
// Throws ModelError for a binary file that ends early or is not of version 2.
GlbChunks take_apart(const std::string& bytes, const std::string& path);

// A binary file.
std::string put_together(GlbChunks chunks);

}  // namespace refitlab
