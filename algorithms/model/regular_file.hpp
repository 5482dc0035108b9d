// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of files that end: a device or a pipe need not.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace refitlab {

// Nothing for what is no regular file, or cannot be read.
std::optional<std::string> bytes_of_regular_file(const std::filesystem::path& path);

}  // namespace refitlab
