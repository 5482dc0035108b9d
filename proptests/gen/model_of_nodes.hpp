// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a model without vertices, of which every node is a joint of its own frame.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/model.hpp"

namespace proptests::gen {

refitlab::Model model_of_nodes(const std::string& name, const std::vector<refitlab::SceneNode>& nodes);

}  // namespace proptests::gen
