// SPDX-License-Identifier: GPL-3.0-or-later
// Regular files end. A device or a pipe need not, so it is not read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace refitlab {

// Returns the bytes of a file, or nothing if it is no regular file or cannot be read.
std::optional<std::string> bytes_of_regular_file(const std::filesystem::path& path);

}  // namespace refitlab
