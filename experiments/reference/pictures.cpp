// SPDX-License-Identifier: GPL-3.0-or-later
// The program reference_pictures writes what is drawn of each lemma, as a table of shapes.   usage: reference_pictures FILE.csv
#include <iostream>
#include <stdexcept>

#include "experiments/drawings/drawings.hpp"

int main(int argc, char **argv) try {
  if (argc != 2) throw std::invalid_argument("usage: reference_pictures FILE.csv");
  refitlab::drawings::write_drawings(argv[1]);
} catch (const std::exception &e) {
  std::cerr << "reference_pictures: " << e.what() << '\n';
  return 1;
}
