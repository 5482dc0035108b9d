// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the fuzz targets without a fuzzer: their corpus, whatever was ever found, and random changes of both.
#include <filesystem>
#include <set>

#include "algorithms/results/write_whole.hpp"
#include "proptests/fuzz/target.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_fuzz {
namespace {

namespace fs = std::filesystem;

// The path is relative to the root of the repository, from where the tests are run.
const fs::path folder = "proptests/fuzz";

std::vector<fs::path> files_in(const fs::path& of) {
  std::vector<fs::path> out;
  if (fs::is_directory(of))
    for (const auto& entry : fs::directory_iterator(of)) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::string> inputs_of(const std::string& target) {
  std::vector<std::string> out;
  for (const char* kind : {"corpus", "found"})
    for (const fs::path& file : files_in(folder / kind / target)) out.push_back(refitlab::read_whole(file));
  return out;
}

// Draws a change as fuzzers make it: bytes are changed, cut out, doubled, or taken from elsewhere.
std::string draw_change_of(const std::vector<std::string>& inputs) {
  const auto index = [](std::size_t count) { return *rc::gen::inRange<std::size_t>(0, count); };
  std::string text = inputs[index(inputs.size())];
  for (auto n = index(6); n > 0; --n) {
    const std::size_t at = index(text.size() + 1), length = index(std::min<std::size_t>(text.size() - at, 16) + 1);
    const std::string& other = inputs[index(inputs.size())];
    switch (index(4)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(index(256));
        break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(at, length)); break;
      default: text.insert(at, other.substr(index(other.size() + 1), index(32)));
    }
  }
  return text;
}

}  // namespace

PROPTEST(fuzz) {
  t.example("every target has a corpus, and every corpus a target", {}, [] {
    std::set<std::string> targets, corpora;
    for (const auto& target : fuzz::targets()) targets.insert(target.first);
    for (const char* kind : {"corpus", "found"})
      for (const fs::path& of : files_in(folder / kind)) corpora.insert(of.filename());
    return Checked(targets == corpora, static_cast<long>(targets.size()));
  });
  for (const auto& [name, target] : fuzz::targets()) {
    const auto inputs = inputs_of(name);
    const auto entry = target;
    t.example(name + " is right about its corpus, and about whatever was ever found", {}, [&] {
      for (const std::string& input : inputs) entry(input);
      return Checked(!inputs.empty(), static_cast<long>(inputs.size()));
    });
    t.holds(name + " is right about random changes of them", {.cases = 1000}, [&] { entry(draw_change_of(inputs)); });
  }
}

}  // namespace proptests::suite_fuzz
