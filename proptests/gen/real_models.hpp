// SPDX-License-Identifier: GPL-3.0-or-later
// Visits the real models that experiments/fetch_models has left in out/models of the working directory: none, some or all.
#pragma once

#include <filesystem>
#include <ostream>

#include "algorithms/model/load.hpp"
#include "experiments/scenes/real_models.hpp"

namespace proptests::gen {

// Calls use(model) for each that is there, and says on out which these are.
template <class Use>
void for_each_real_model(std::ostream& out, const Use& use) {
  std::string names;
  for (const std::string name : refitlab::real_models) {
    if (!std::filesystem::exists("out/models/" + name)) continue;
    use(refitlab::load_model("out/models/" + name));
    names += " " + name;
  }
  out << "real models:" << (names.empty() ? " none, as out/models has none" : names) << '\n';
}

}  // namespace proptests::gen
