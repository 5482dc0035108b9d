// SPDX-License-Identifier: GPL-3.0-or-later
// This takes what geometry needs from a glTF 2.0 file, and nothing else, for the library that reads it.
//
// tinygltf 2.7 takes a number that does not fit for another number, and a member that is not a number for a missing one. It
// descends into extras without a limit, and reads images. So the description is copied member by member, and each must have the
// type that glTF says.
#pragma once

#include <string>
#include <vector>

namespace refitlab {

struct GltfGeometry {
  std::string glb;
  std::vector<std::size_t> lengths;  // in bytes, of the buffers in files of their own, in order
};

// bytes are those of a .glb or a .gltf file, and path is for error messages. Returns a .glb file whose description has the nodes,
// meshes, skins, animations and the buffers below them. Its data URIs have as many bytes as the buffers, even if they had more,
// and its other URIs are as tinygltf reads them, which takes "+" for a space. Animation channels without a node are left out.
// Throws ModelError that names the file, the object of the description and the reason. The reasons are a file that ends early or
// is not glTF 2, a member of another type than it must have, an extension that changes geometry (compression and instancing among
// them), and a buffer without bytes.
GltfGeometry gltf_geometry(const std::string& bytes, const std::string& path);

}  // namespace refitlab
