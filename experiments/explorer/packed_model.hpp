// SPDX-License-Identifier: GPL-3.0-or-later
// A packed model is small enough to stand in a page, because the explorer has no reader of model files.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns the model as CBOR (RFC 8949). Coordinates, and rotations and translations of clips, are rounded to float; weights are
// kept as they are. A clip has 24 poses a second, but at most 121.
std::vector<std::uint8_t> pack(const Model& model);

// Returns the number of a clip's packed poses without the first. They are evenly spread from its start to its end.
int packed_steps(const Clip& clip);

// Returns the model. Its clips have the pose that is nearest in time. Throws ModelError or nlohmann::json::exception for bytes
// that pack has not made.
Model unpack(const std::vector<std::uint8_t>& packed);

}  // namespace refitlab
