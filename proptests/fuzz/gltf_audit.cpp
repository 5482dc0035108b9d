// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of glTF files, binary and text: it ends, without an error or with a ModelError.
#include "algorithms/model/gltf_audit.hpp"

#include "algorithms/model/model.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

FUZZ_TARGET(gltf_audit, bytes) try { audit_gltf_bytes(bytes, "fuzz.glb"); } catch (const ModelError& e) {
  check(std::string(e.what()).starts_with("fuzz.glb: "), "a refusal names the file");
}
