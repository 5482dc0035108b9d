// SPDX-License-Identifier: GPL-3.0-or-later
// Members added to objects of a JSON text, every other byte of which stays.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace refitlab {

// Steps from a JSON value to one inside it: the names of members, and indices of arrays.
using JsonPath = std::vector<std::variant<std::string, std::size_t>>;

// Gives the object at a path a member of this name and value, which is JSON: replaces its value where it has one, else adds it
// as the last member. Objects that are missing on the way are added likewise. text must be JSON, and have the arrays and their
// members of the path. Throws std::invalid_argument that says what the path leads to, where that is no object.
std::string with_member(const std::string& text, const JsonPath& path, const std::string& name, const std::string& value);

}  // namespace refitlab
