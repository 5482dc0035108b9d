// SPDX-License-Identifier: GPL-3.0-or-later
// A model small enough to stand in a page: the explorer has no reader of model files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

// The model as CBOR (RFC 8949). Coordinates, and rotations and translations of clips, are rounded to float; weights are
// kept as they are. Of a clip, 24 poses a second, or 121 if that were more.
std::vector<std::uint8_t> pack(const Model& model);

// Clips have the pose that is nearest in time. Throws ModelError or nlohmann::json::exception for what pack has not
// made.
Model unpack(const std::vector<std::uint8_t>& packed);

}  // namespace refitlab
