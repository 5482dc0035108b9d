// SPDX-License-Identifier: GPL-3.0-or-later
// Writes JSON that names files. Names need not be UTF-8, as JSON must be; bytes that are none are replaced by U+FFFD.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace refitlab {

// Returns the text with `indent` spaces a level, or in one line for -1.
template <class Json>
std::string text_of(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace refitlab
