// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/command.hpp"

#include <cmath>
#include <ostream>

namespace refitlab {
namespace {

constexpr std::pair<const char*, Skinning> skinning_names[] = {
    {"linear", Skinning::linear}, {"dual-quaternion", Skinning::dual_quaternion}, {"spherical", Skinning::spherical}};

}  // namespace

boost::program_options::variables_map parse_arguments(const std::vector<std::string>& arguments,
                                                      const boost::program_options::options_description& options,
                                                      const std::vector<std::string>& files) {
  namespace po = boost::program_options;
  po::options_description all;
  all.add(options);
  po::positional_options_description positions;
  for (const std::string& file : files) {
    all.add_options()(file.c_str(), po::value<std::string>());
    positions.add(file.c_str(), 1);
  }
  po::variables_map map;
  try {
    // There are no short options: what begins with one dash is a number below 0, or a file.
    using Style = po::command_line_style::style_t;
    const int style = Style::default_style & ~Style::allow_short;
    po::store(po::command_line_parser(arguments).options(all).positional(positions).style(style).run(), map);
    po::notify(map);
  } catch (const po::error& e) {
    throw UsageError(e.what());
  }
  if (!map.count("help"))
    for (const std::string& file : files)
      if (!map.count(file)) throw UsageError("it takes a file more: " + file);
  return map;
}

std::string printable(const std::string& text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) out += c;
    else out += std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
  }
  return out;
}

void print_notes(const std::string& file, const std::vector<std::string>& notes, std::ostream& to) {
  for (const std::string& note : notes) to << "note: " << file << ": " << printable(note) << '\n';
}

const char* name_of(Skinning skinning) {
  for (const auto& [name, value] : skinning_names)
    if (value == skinning) return name;
  return "hejl";
}

Skinning skinning_of(const std::string& name) {
  std::string names;
  for (const auto& [known, value] : skinning_names) {
    if (name == known) return value;
    names += std::string(names.empty() ? "" : ", ") + known;
  }
  throw UsageError("--skinning " + name + ": there is no such skinning; there are: " + names);
}

ProgressBar::ProgressBar(std::ostream& errors, bool is_shown) : errors_(errors), is_shown_(is_shown) {}

ProgressBar::~ProgressBar() {
  if (percent_ >= 0) errors_ << '\r' << std::string(60, ' ') << '\r' << std::flush;
}

void ProgressBar::show(double share) {
  const int percent = static_cast<int>(std::floor(100 * share));
  if (!is_shown_ || percent == percent_) return;
  percent_ = percent;
  constexpr int width = 40;
  const int filled = percent * width / 100;
  errors_ << "\r[" << std::string(filled, '#') << std::string(width - filled, ' ') << "] " << percent << " %" << std::flush;
}

}  // namespace refitlab
