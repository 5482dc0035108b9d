// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <iostream>

#include "algorithms/program/command.hpp"
#include "algorithms/program/program.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // writing more than is allowed then fails as writing to a full disk does
  const int code = refitlab::run_program({argv + 1, argv + argc}, std::cout, std::cerr);
  if (std::cout.flush()) return code;
  std::cerr << "refitlab: standard output: cannot be written\n";
  return code == refitlab::exit_done ? refitlab::exit_refused : code;
}
