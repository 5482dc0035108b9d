// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/error_list.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "algorithms/results/write_whole.hpp"

namespace proptests {
namespace {

const std::string gap = "...";

// Returns the texts between the gaps of a pattern.
std::vector<std::string> parts_of(const std::string& pattern) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = pattern.find(gap, from)) != std::string::npos; from = at + gap.size())
    parts.push_back(pattern.substr(from, at - from));
  parts.push_back(pattern.substr(from));
  return parts;
}

std::vector<std::string> sources() {
  std::vector<std::string> out;
  for (const char* folder : {"algorithms", "lemmas", "proptests/cases"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

std::string without_comments(const std::string& text) { return std::regex_replace(text, std::regex("(^|\\s)//[^\\n]*"), ""); }

// Returns the texts that stand in quotes in a statement, if they have a letter.
std::vector<std::string> literals_of(const std::string& statement) {
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<std::string> out;
  for (std::sregex_iterator i(statement.begin(), statement.end(), literal), end; i != end; ++i) {
    const std::string text = std::regex_replace((*i)[1].str(), std::regex(R"re(\\(["\\]))re"), "$1");
    if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c); })) out.push_back(text);
  }
  return out;
}

}  // namespace

bool is_like(const std::string& message, const std::string& pattern) {
  const auto parts = parts_of(pattern);
  if (parts.size() == 1) return message == pattern;
  if (!message.starts_with(parts.front())) return false;
  std::size_t at = parts.front().size();
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
    const std::size_t found = message.find(parts[i], at);
    if (found == std::string::npos) return false;
    at = found + parts[i].size();
  }
  return message.size() >= at + parts.back().size() && message.ends_with(parts.back());
}

std::vector<ListedError> read_error_list(const std::string& file) {
  const std::string text = refitlab::read_whole(file);
  static const std::regex row(R"(\| `(.*)` \| `(.*)` \| `(.*)` \|)");
  std::vector<ListedError> out;
  for (std::size_t from = 0, end; (end = text.find('\n', from)) != std::string::npos; from = end + 1) {
    const std::string line = text.substr(from, end - from);
    std::smatch fields;
    if (!line.starts_with("| `")) continue;
    if (!std::regex_match(line, fields, row)) throw std::runtime_error(file + ": no row of the list: " + line);
    out.push_back({fields[1], fields[2], fields[3]});
  }
  return out;
}

std::vector<std::string> unlisted_errors(const std::vector<ListedError>& list) {
  static const std::regex statement(R"((throw|fail|fail_at|refuse)\b[ (][^;{]*;)");
  std::vector<std::string> out;
  for (const std::string& file : sources()) {
    std::string listed;
    for (const ListedError& error : list)
      if (error.file == file) listed += error.message + "\n";
    const std::string text = without_comments(refitlab::read_whole(file));
    for (std::sregex_iterator i(text.begin(), text.end(), statement), end; i != end; ++i) {
      if (listed.empty() && (*i)[1] == "throw" && i->str() != "throw;") out.push_back(file + ": " + i->str());
      for (const std::string& literal : literals_of(i->str()))
        if (listed.find(literal) == std::string::npos) out.push_back(file + ": \"" + literal + "\"");
    }
  }
  return out;
}

std::vector<std::string> unseen_errors(const std::vector<ListedError>& list, const std::set<std::string>& suites,
                                       const std::map<std::string, std::set<std::string>>& messages) {
  std::vector<std::string> out;
  for (const ListedError& error : list) {
    if (!suites.contains(error.suite)) continue;
    const auto of_suite = messages.find(error.suite);
    const bool seen =
        of_suite != messages.end() && std::any_of(of_suite->second.begin(), of_suite->second.end(),
                                                  [&](const std::string& message) { return is_like(message, error.message); });
    if (!seen) out.push_back(error.suite + ": " + error.message);
  }
  return out;
}

}  // namespace proptests
