// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/json_splice.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

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

// A Member of an object is at a place in the text: its name begins at `begin`, its value at `value`, and ends at `end`.
struct Member {
  std::string name;
  std::size_t begin, value, end;
};

// Returns the members of the object here.
std::vector<Member> members_of(Scanner scanner) {
  std::vector<Member> out;
  scanner.step();
  while (scanner.here() != '}') {
    const std::size_t begin = scanner.at();
    std::string name = scanner.string();
    scanner.skip_space();
    scanner.step();  // the colon
    const std::size_t value = scanner.at();
    scanner.skip_value();
    out.push_back({std::move(name), begin, value, scanner.at()});
    scanner.skip_space();
    if (scanner.here() == ',') scanner.step();
  }
  return out;
}

// Returns where the elements of the array here begin.
std::vector<std::size_t> elements_of(Scanner scanner) {
  std::vector<std::size_t> out;
  scanner.step();
  while (scanner.here() != ']') {
    out.push_back(scanner.at());
    scanner.skip_value();
    scanner.skip_space();
    if (scanner.here() == ',') scanner.step();
  }
  return out;
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

// Returns what is to stand where there was no value; nothing if it is only to be removed.
std::string made(const JsonEdit& edit) {
  if (!edit.value.empty()) return edit.value;
  std::string out;
  for (const auto& [name, inner] : edit.members)
    if (const std::string value = made(inner); !value.empty()) out += (out.empty() ? "" : ",") + quoted(name) + ":" + value;
  return out.empty() ? out : "{" + out + "}";
}

class Splicer {
 public:
  explicit Splicer(const std::string& text) : text_(text) {}

  void apply(const JsonEdit& edit, std::size_t at, const std::string& path) {
    if (!edit.elements.empty()) {
      const std::vector<std::size_t> elements = elements_of(Scanner(text_, at));
      for (const auto& [index, inner] : edit.elements) apply(inner, elements.at(index), path + "/" + std::to_string(index));
    } else if (!edit.value.empty()) {
      replace(at, end_of(at), edit.value);
    } else if (text_[at] == '{') {
      apply_to_object(edit, at, path);
    } else if (const std::string value = made(edit); !value.empty()) {
      if (text_.compare(at, 4, "null") != 0) throw std::invalid_argument(path + " is no object");
      replace(at, end_of(at), value);
    }
  }

  // Returns the text with all that was edited.
  std::string result() {
    out_.append(text_, done_, std::string::npos);
    return std::move(out_);
  }

 private:
  std::size_t end_of(std::size_t value) const {
    Scanner scanner(text_, value);
    scanner.skip_value();
    return scanner.at();
  }

  // Edits come in the order of the text.
  void replace(std::size_t from, std::size_t to, const std::string& by) {
    out_.append(text_, done_, from - done_).append(by);
    done_ = to;
  }

  void apply_to_object(const JsonEdit& edit, std::size_t at, const std::string& path) {
    const std::vector<Member> members = members_of(Scanner(text_, at));
    std::map<std::string, std::size_t> last;  // of several of one name, readers take the last
    for (std::size_t i = 0; i < members.size(); ++i) last[members[i].name] = i;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Member& member = members[i];
      const auto found = edit.members.find(member.name);
      if (found != edit.members.end() && found->second.is_removed) {
        // The comma and space before it are removed with it, or those behind it if no member is left before it.
        const bool is_last = i + 1 == members.size();
        replace(kept > 0 ? members[i - 1].end : member.begin, kept > 0 || is_last ? member.end : members[i + 1].begin, "");
        continue;
      }
      ++kept;
      if (found != edit.members.end() && last[member.name] == i) apply(found->second, member.value, path + "/" + member.name);
    }
    for (const auto& [name, inner] : edit.members) {
      const std::string value = last.contains(name) ? "" : made(inner);
      if (value.empty()) continue;
      const std::size_t end = std::max(done_, members.empty() ? at + 1 : members.back().end);
      replace(end, end, (kept++ > 0 ? "," : "") + quoted(name) + ":" + value);
    }
  }

  const std::string& text_;
  std::string out_;
  std::size_t done_ = 0;  // of the text
};

}  // namespace

std::string edited(const std::string& text, const JsonEdit& edit) {
  Splicer splicer(text);
  splicer.apply(edit, Scanner(text, text.starts_with("\xEF\xBB\xBF") ? 3 : 0).at(), "");  // behind a byte order mark
  return splicer.result();
}

}  // namespace refitlab
