// SPDX-License-Identifier: GPL-3.0-or-later
// Loading files that crash the library that reads them, for command-line tools.
#pragma once

#include <string>

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"

namespace refitlab {

// load_model, of a file that assimp reads after it was tried in a forked copy of the process. Not for programs with threads
// or open connections.
// Throws what load_model does, ModelError for a file that brings the copy down or keeps it busy for so many seconds, and
// std::system_error where there can be no copy.
Model load_model_guarded(const std::string& path, const LoadOptions& options = {}, unsigned seconds = 600);

}  // namespace refitlab
