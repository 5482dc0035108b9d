// reference_pictures: the drawing of each lemma as an SVG file, and their style
// sheet.   usage: reference_pictures FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>

#include "experiments/drawings/drawings.hpp"
#include "experiments/drawings/style.hpp"

namespace {

void write(const std::filesystem::path &path, const std::string &text) {
  std::ofstream file(path);
  if (!(file << text)) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

int main(int argc, char **argv) try {
  if (argc != 2) throw std::invalid_argument("usage: reference_pictures FOLDER");
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const auto &drawing : refitlab::drawings::all_drawings()) write(folder / (drawing.stem + ".svg"), drawing.svg());
  write(folder / "drawings.css", refitlab::drawings::style);
} catch (const std::exception &e) {
  std::cerr << "reference_pictures: " << e.what() << '\n';
  return 1;
}
