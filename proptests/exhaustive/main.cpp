// SPDX-License-Identifier: GPL-3.0-or-later
// The program exhaustive proves a theorem on all of a box of parameters, and writes a certificate for proptests/exhaustive/check.
#include <boost/program_options.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "algorithms/results/write_whole.hpp"
#include "proptests/exhaustive/certificate.hpp"
#include "proptests/exhaustive/theorems.hpp"

namespace proptests::exhaustive {

std::vector<Theorem> all_theorems() {
  std::vector<Theorem> out;
  for (const auto& some :
       {theorems_of_lemma5(), theorems_of_rotation_bound(), theorems_of_control_hulls(), theorems_of_motion_bound()})
    out.insert(out.end(), some.begin(), some.end());
  return out;
}

Theorem theorem_named(const std::string& name) {
  std::string names;
  for (Theorem& theorem : all_theorems()) {
    if (theorem.name == name) return theorem;
    names += " " + theorem.name;
  }
  throw std::runtime_error("there is no theorem '" + name + "'; there are" + names);
}

namespace {

struct Part {
  std::size_t index, count;
};

// Returns the part that a text names: "2/8" is the third of eight.
Part part_of(const std::string& text) {
  unsigned index = 0, count = 0;
  char rest;
  if (std::sscanf(text.c_str(), "%u/%u%c", &index, &count, &rest) != 2 || count == 0 || count > cell_count || index >= count)
    throw std::runtime_error("--shard " + text + " is not I/N with I < N <= " + std::to_string(cell_count));
  return {index, count};
}

// Writes lines that say how much is proved, and about how long the rest takes.
class Progress {
 public:
  Progress(std::string name, double all) : name_(std::move(name)), all_(all) {}

  void say(const Counts& counts) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(5)) return;
    last_ = now;
    const double passed = std::chrono::duration<double>(now - start_).count(), share = counts.measure / all_;
    std::fprintf(stderr, "%s: %zu boxes proved, %zu outside, %.2f %% of the domain, about %.0f s left if the rest is no harder\n",
                 name_.c_str(), counts.proved, counts.outside, 100 * share, passed * (1 - share) / share);
  }

 private:
  const std::string name_;
  const double all_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
};

int run(int argc, char** argv) {
  namespace po = boost::program_options;
  po::options_description options("exhaustive: proves a theorem on a box of parameters and writes the certificate");
  options.add_options()("help", "prints this")(
      "list", "prints the theorems: names, the least constants that are known to be needed, statements")(
      "prove", po::value<std::string>(), "the theorem's name")("real", "with the constant of a real run, not of a small one")(
      "constant", po::value<double>(), "with another constant")(
      "shard", po::value<std::string>(), "I/N: only the I-th of N parts, counted from 0, for proptests/exhaustive/parts.py")(
      "out", po::value<std::string>(), "the certificate's file");
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  if (given.count("help")) {
    std::cout << options;
    return 0;
  }
  if (given.count("list")) {
    std::cout.precision(8);
    for (const Theorem& t : all_theorems()) std::cout << t.name << '\t' << t.needed << '\t' << t.statement << '\n';
    return 0;
  }
  if (!given.count("prove") || !given.count("out"))
    throw std::runtime_error("--prove and --out are needed; --help says what they are");
  const Theorem theorem = theorem_named(given["prove"].as<std::string>());
  const double constant = given.count("constant") ? given["constant"].as<double>()
                          : given.count("real")   ? theorem.real
                                                  : theorem.small;
  if (!(0 < constant && constant <= 1024) || constant * 0x1p30 != std::floor(constant * 0x1p30))
    throw std::runtime_error("--constant is to be a positive multiple of 2^-30, at most 1024");
  const Part part = given.count("shard") ? part_of(given["shard"].as<std::string>()) : Part{0, 1};
  const std::size_t first = part.index * cell_count / part.count, end = (part.index + 1) * cell_count / part.count;
  Progress progress(theorem.name, double(end - first) / cell_count);
  const auto cells = prove_cells(theorem, constant, first, end, [&](const Counts& c) { progress.say(c); });
  refitlab::write_whole(given["out"].as<std::string>(),
                        given.count("shard") ? shard_of(theorem, constant, cells) : certificate_of(theorem, constant, cells));
  return 0;
}

}  // namespace
}  // namespace proptests::exhaustive

int main(int argc, char** argv) {
  try {
    return proptests::exhaustive::run(argc, argv);
  } catch (const proptests::exhaustive::NotProved& e) {
    std::cerr << "exhaustive: " << e.what() << '\n';
    return 1;
    // This says nothing of the theorem.
  } catch (const std::exception& e) {
    std::cerr << "exhaustive: " << e.what() << '\n';
    return 3;
  }
}
