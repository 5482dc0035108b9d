// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/json_splice.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace refitlab {
namespace {

// A Scanner is at a place in JSON that is known to be well formed.
class Scanner {
 public:
  explicit Scanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) { skip_space(); }

  std::size_t at() const { return at_; }
  char here() const { return text_[at_]; }

  // Goes past one character and the space behind it.
  void step() { ++at_, skip_space(); }

  // Returns the string here with its escapes resolved, and goes past it.
  std::string string() {
    const std::size_t start = at_;
    skip_string();
    return nlohmann::json::parse(text_.substr(start, at_ - start)).get<std::string>();
  }

  // Goes past the value here, but not past the space behind it.
  void skip_value() {
    if (here() == '"') return skip_string();
    int depth = 0;
    do {
      if (here() == '"') skip_string();
      else if (here() == '{' || here() == '[') ++depth, ++at_;
      else if (here() == '}' || here() == ']') --depth, ++at_;
      else if (depth > 0) ++at_;
      else
        while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(here()) == std::string_view::npos) ++at_;
    } while (depth > 0);
  }

  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(here()) != std::string_view::npos) ++at_;
  }

 private:
  void skip_string() {
    for (++at_; here() != '"'; ++at_)
      if (here() == '\\') ++at_;
    ++at_;
  }

  std::string_view text_;
  std::size_t at_;
};

constexpr std::size_t nowhere = std::string::npos;

// Returns where the value of a member of the object here begins, or nowhere if there is none. end is set behind the last member's
// value.
std::size_t find_member(Scanner scanner, const std::string& name, std::size_t& end, bool& is_empty) {
  std::size_t found = nowhere;
  end = scanner.at() + 1;
  scanner.step();
  is_empty = scanner.here() == '}';
  while (scanner.here() != '}') {
    const std::string member = scanner.string();
    scanner.skip_space();
    scanner.step();                            // the colon
    if (member == name) found = scanner.at();  // of several of one name, readers take the last
    scanner.skip_value();
    end = scanner.at();
    scanner.skip_space();
    if (scanner.here() == ',') scanner.step();
  }
  return found;
}

std::size_t find_element(Scanner scanner, std::size_t index) {
  scanner.step();
  for (std::size_t i = 0; i < index; ++i) {
    scanner.skip_value();
    scanner.skip_space();
    scanner.step();  // the comma
  }
  return scanner.at();
}

std::string text_of(const JsonPath& path, std::size_t steps) {
  std::string text;
  for (std::size_t i = 0; i < steps; ++i)
    text += std::holds_alternative<std::string>(path[i]) ? "/" + std::get<std::string>(path[i])
                                                         : "/" + std::to_string(std::get<std::size_t>(path[i]));
  return text;
}

}  // namespace

std::string with_member(const std::string& text, const JsonPath& path, const std::string& name, const std::string& value) {
  JsonPath whole = path;
  whole.push_back(name);
  std::size_t at = Scanner(text, text.starts_with("\xEF\xBB\xBF") ? 3 : 0).at();  // behind a byte order mark
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (std::holds_alternative<std::size_t>(whole[i])) {
      at = find_element(Scanner(text, at), std::get<std::size_t>(whole[i]));
      continue;
    }
    if (text[at] != '{') throw std::invalid_argument(text_of(whole, i) + " is no object");
    const std::string& member = std::get<std::string>(whole[i]);
    std::size_t end;
    bool is_empty;
    const std::size_t found = find_member(Scanner(text, at), member, end, is_empty);
    if (found == nowhere) {
      std::string added = value;
      for (std::size_t k = whole.size(); k-- > i;)
        added = (k > i ? "{" : "") + nlohmann::json(std::get<std::string>(whole[k])).dump() + ":" + added + (k > i ? "}" : "");
      return text.substr(0, end) + (is_empty ? "" : ",") + added + text.substr(end);
    }
    at = found;
  }
  Scanner old(text, at);
  old.skip_value();
  return text.substr(0, at) + value + text.substr(old.at());
}

}  // namespace refitlab
