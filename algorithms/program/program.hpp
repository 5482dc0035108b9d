// SPDX-License-Identifier: GPL-3.0-or-later
// The program `refitlab` makes bounds over time for glTF files, for people who have never heard of refits.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace refitlab {

// Runs the program with the arguments behind its name and returns its exit code (ExitCode). Errors are one line each.
int run_program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);

}  // namespace refitlab
