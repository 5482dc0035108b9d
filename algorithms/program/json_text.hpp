// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that names files. Names need not be UTF-8, as JSON must be; what is none is replaced by U+FFFD.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace refitlab {

// indent: spaces a level, or -1 for one line.
template <class Json>
std::string text_of(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace refitlab
