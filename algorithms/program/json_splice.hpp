// SPDX-License-Identifier: GPL-3.0-or-later
// Members are added to objects of a JSON text, replaced and removed. Every other byte stays.
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace refitlab {

// A JsonEdit is what becomes of a value. Either the value is given, or the value is removed from its object, or what is inside of
// it is edited: members of an object, or elements of an array.
struct JsonEdit {
  std::string value = {};  // JSON, or empty
  bool is_removed = false;
  std::map<std::string, JsonEdit> members = {};
  std::map<std::size_t, JsonEdit> elements = {};
};

// Returns the text, edited. A member that is not there becomes the last one, and objects that are missing on the way to it, or
// are null, are added likewise. To remove what is not there changes nothing. text must be JSON, and have the arrays and elements
// that are edited. Throws std::invalid_argument where something is to be put into what is no object, and names it. It takes time
// in proportion to the text, for each level of objects.
std::string edited(const std::string& text, const JsonEdit& edit);

}  // namespace refitlab
