// SPDX-License-Identifier: GPL-3.0-or-later
// Members are added to objects of a JSON text. Every other byte stays.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace refitlab {

// A JsonPath has the steps from a JSON value to one inside it: the names of members, and indices of arrays.
using JsonPath = std::vector<std::variant<std::string, std::size_t>>;

// Gives the object at a path a member of this name and value, which is JSON. If there is such a member, its value is replaced;
// else it becomes the last member. Objects that are missing on the way are added likewise. text must be JSON, and have the arrays
// and their members of the path. Throws std::invalid_argument if the path does not lead to an object, and says to what it leads.
std::string with_member(const std::string& text, const JsonPath& path, const std::string& name, const std::string& value);

}  // namespace refitlab
