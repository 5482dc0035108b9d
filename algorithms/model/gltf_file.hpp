// SPDX-License-Identifier: GPL-3.0-or-later
// A glTF 2.0 file is read into tinygltf's types.
#pragma once

#include <tiny_gltf.h>

#include <string>

namespace refitlab {

// Returns the geometry only (see gltf_description.hpp), with the bytes of all buffers. Indices are not checked: they may be out
// of range. path is for error messages, and the other files that the file refers to are beside it. Throws ModelError that names
// the file and says what tinygltf says.
tinygltf::Model read_gltf(const std::string& bytes, const std::string& path);

}  // namespace refitlab
