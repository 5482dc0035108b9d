// SPDX-License-Identifier: MIT
// A character as bytes: what baking made, kept in a file that the runtime reads without any other library.
//
// Format, version 1; all numbers little-endian, lists as a count (8 bytes) and their members one after the other:
//   "refitlab"                            8 bytes
//   version, size, checksum               4 + 8 + 8 bytes: of what follows; the checksum is FNV-1a of 64 bits
//   the mesh, the tree, the piece tables  their members in the order of the structs; int 4 bytes, size_t 8, double 8 (IEEE 754),
//                                         strings as lists of bytes
// The joint-sets and the nodes' vertices are made anew from these.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

std::string bytes_of(const Character& character);

// file: for errors. Throws ModelError for bytes that are no such file, have another version, end early, or do not have the
// checksum that they say; and, whatever the checksum, for indices out of range, a mesh that validate refuses, a tree whose
// nodes are not the parts of their parents, balls and weights that are none. That balls and polytopes enclose what they
// should is not looked at: that is as they were baked.
Character character_of(std::string_view bytes, const std::string& file);

// Throws ModelError for a file that cannot be read too.
Character read_character(const std::string& path);

}  // namespace refitlab
