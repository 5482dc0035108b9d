// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "algorithms/program/program.hpp"

int main(int argc, char** argv) { return refitlab::run_program({argv + 1, argv + argc}, std::cout, std::cerr); }
