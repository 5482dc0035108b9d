// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/command.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <span>

namespace refitlab {
namespace {

constexpr std::pair<const char*, Skinning> skinning_names[] = {
    {"linear", Skinning::linear}, {"dual-quaternion", Skinning::dual_quaternion}, {"spherical", Skinning::spherical}};

// Returns the same for two paths of one file, be it there or not.
std::filesystem::path place_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  const std::filesystem::path place = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : place;
}

// Returns the option that a word names, or none.
const boost::program_options::option_description* option_of(const boost::program_options::options_description& options,
                                                            const std::string& word) {
  return word.starts_with("--") && word.size() > 2 ? options.find_nothrow(word.substr(2, word.find('=') - 2), true) : nullptr;
}

// A forgotten value is not the option behind it. One that begins like an option is given as --option=value.
void check_values(const boost::program_options::options_description& options, std::span<const std::string> words) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const auto* const option = option_of(options, words[i]);
    if (option && option->semantic()->min_tokens() > 0 && words[i].find('=') == std::string::npos &&
        option_of(options, words[i + 1]))
      throw UsageError(words[i] + " takes a value, and " + words[i + 1] + " is an option");
  }
}

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
  constexpr const char* more = "more files";
  all.add_options()(more, po::value<std::vector<std::string>>());
  positions.add(more, -1);
  std::vector<std::string> words = arguments;
  const auto end = std::find(words.begin(), words.end(), "--");
  std::replace(words.begin(), end, std::string("-h"), std::string("--help"));
  po::variables_map map;
  try {
    // There are no other short options: what begins with one dash is a number below 0, or a file.
    using Style = po::command_line_style::style_t;
    const int style = Style::default_style & ~Style::allow_short;
    check_values(options, {words.begin(), end});
    po::store(po::command_line_parser(words).options(all).positional(positions).style(style).run(), map);
    po::notify(map);
  } catch (const po::error& e) {
    throw UsageError(e.what());
  }
  if (map.count(more)) throw UsageError("it takes no file more: " + map[more].as<std::vector<std::string>>()[0]);
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
  for (const std::string& note : notes) to << "note: " << printable(file) << ": " << printable(note) << '\n';
}

std::vector<NamedFile> files_of(const boost::program_options::variables_map& map, const std::vector<std::string>& options) {
  std::vector<NamedFile> out;
  for (const std::string& option : options)
    if (map.count(option)) out.push_back({"--" + option, map[option].as<std::string>()});
  return out;
}

void check_written(std::vector<NamedFile> others, const std::vector<NamedFile>& written) {
  for (const NamedFile& file : written) {
    if (file.path.empty()) throw UsageError(file.of + " takes a file");
    for (const NamedFile& other : others)
      if (place_of(file.path) == place_of(other.path)) throw UsageError(file.of + " is the file of " + other.of + ", too");
    others.push_back(file);
  }
}

bool is_standard_output(const std::string& path) {
  struct stat file {
  }, standard{};
  return ::stat(path.c_str(), &file) == 0 && ::fstat(STDOUT_FILENO, &standard) == 0 && file.st_dev == standard.st_dev &&
         file.st_ino == standard.st_ino;
}

std::ostream& told_to(const std::vector<NamedFile>& written, std::ostream& out, std::ostream& errors) {
  const bool is_any = std::any_of(written.begin(), written.end(), [](const auto& file) { return is_standard_output(file.path); });
  return is_any ? errors : out;
}

const char* name_of(Skinning skinning) {
  for (const auto& [name, value] : skinning_names)
    if (value == skinning) return name;
  return "hejl";
}

const char* name_of(RotationBlend rotations) { return rotations == RotationBlend::slerp ? "slerp" : "nlerp"; }

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
