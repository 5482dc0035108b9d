// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line tools load files with this, because some files crash the library that reads them.
#pragma once

#include <string>

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"

namespace refitlab {

// Does load_model, but tries a file that assimp reads in a forked copy of the process first. It is not for programs with threads
// or open connections. Throws what load_model throws, ModelError for a file that brings the copy down or keeps it busy for so
// many seconds, and std::system_error if there can be no copy.
Model load_model_guarded(const std::string& path, const LoadOptions& options = {}, unsigned seconds = 600);

}  // namespace refitlab
