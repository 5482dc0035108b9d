// SPDX-License-Identifier: GPL-3.0-or-later
// What geometry needs of a glTF 2.0 file, and nothing else, for the library that reads it.
//
// tinygltf 2.7 takes a number that does not fit for another number, and what is not a number for what is missing; it
// descends into extras without a limit, and reads images. So the description is taken over member by member, each of the
// type that glTF says.
#pragma once

#include <string>

namespace refitlab {

// bytes: of a .glb or a .gltf file; path: for errors. The result is a .glb file whose description has what is said of
// nodes, meshes, skins, animations and the buffers below them; animation channels without a node are left out.
// Throws ModelError that names the file, the object of the description and the reason: a file that ends early or is not
// glTF 2, a member of another type than it must have, an extension that changes geometry (compression among them), a
// buffer without bytes.
std::string gltf_geometry(const std::string& bytes, const std::string& path);

}  // namespace refitlab
