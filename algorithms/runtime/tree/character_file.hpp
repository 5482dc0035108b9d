// SPDX-License-Identifier: MIT
// A character becomes bytes: the result of baking is kept in a file that the runtime reads without any other library.
//
// Format, version 2. All numbers are little-endian. A list is a count (8 bytes) and its members, one after the other.
//   "refitlab"                            8 bytes
//   version, size, checksum               4 + 8 + 8 bytes: of what follows; the checksum is FNV-1a of 64 bits
//   the mesh, the tree, the piece tables  their members in the order of the structs; int 4 bytes, size_t 8, double 8 (IEEE 754),
//                                         strings as lists of bytes
// The joint-sets and the nodes' vertices are made again from these.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Returns the character in this format.
std::string bytes_of(const Character& character);

// file is for error messages. Throws ModelError for bytes that are no such file, have another version, end early, or do not
// have the checksum that they state. Whatever the checksum, it also throws for indices out of range, for a mesh that
// validate refuses, for a tree whose nodes are not the parts of their parents, and for invalid balls and weights. It does
// not check that balls and polytopes enclose what they should; they are as they were baked.
Character character_of(std::string_view bytes, const std::string& file);

// Also throws ModelError for a file that cannot be read.
Character read_character(const std::string& path);

}  // namespace refitlab
