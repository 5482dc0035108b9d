// SPDX-License-Identifier: GPL-3.0-or-later
// What assimp 5.2 lets pass in a glTF file: it skips weights that are negative, NaN or of a joint outside the skin,
// drops triangles whose indices are out of range, reads past the end of short tables of inverse bind matrices and of
// keys, and takes integer weights and keys for floats. So these are looked for in the file itself, before assimp reads
// it.
#pragma once

#include <string>

namespace refitlab {

// Does nothing for a file that is not named .glb or .gltf. Throws ModelError that names the file, the mesh and vertex,
// skin or animation, and the reason.
void audit_gltf(const std::string& path);

// The same of a file's bytes, be it binary or text; path: for errors, and where other files that it refers to are.
void audit_gltf_bytes(const std::string& bytes, const std::string& path);

}  // namespace refitlab
