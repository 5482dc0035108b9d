// SPDX-License-Identifier: MIT
#include "algorithms/results/result_table.hpp"

#include <algorithm>
#include <charconv>

#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Takes records off the front of the text.
class Records {
 public:
  Records(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  bool at_end() const { return at_ == text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> next() {
    std::vector<std::string> fields;
    do fields.push_back(peek() == '"' ? quoted() : bare());
    while (take(','));
    end_line();
    return fields;
  }

 private:
  // '\0' at the end, which is no character that means something here.
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  bool take(char c) { return !at_end() && text_[at_] == c && (++at_, true); }
  [[noreturn]] void fail(const std::string& reason) const { throw ResultError(file_, line_, reason); }

  std::string bare() {
    const std::size_t end = std::min(text_.find_first_of(",\"\r\n", at_), text_.size());
    std::string field(text_.substr(at_, end - at_));
    at_ = end;
    if (peek() == '"') fail("a quote inside a field that does not start with one");
    return field;
  }

  std::string quoted() {
    const std::size_t first_line = line_;
    std::string field;
    for (++at_;; ++at_) {
      if (at_end()) throw ResultError(file_, first_line, "a quote is never closed");
      if (take('"') && peek() != '"') return field;  // else this is the second of two
      line_ += peek() == '\n';
      field += text_[at_];
    }
  }

  void end_line() {
    if (at_end()) fail("ends early: the last line has no end");
    const bool carriage_return = take('\r');
    if (!take('\n')) fail(carriage_return ? "a carriage return alone" : "text after a closing quote");
    ++line_;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

std::size_t ResultTable::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw ResultError(file, 1, "there is no column '" + std::string(name) + "'");
  return static_cast<std::size_t>(found - columns.begin());
}

double ResultTable::number(std::size_t row, std::string_view name) const {
  const DefaultFloatEnvironment environment;
  const std::string& text = value(row, name);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw ResultError(file, lines[row], "'" + std::string(name) + "' is no number: '" + text + "'");
  return number;
}

ResultTable parse_results(std::string_view text, const std::string& file) {
  Records records(text, file);
  if (records.at_end()) throw ResultError(file, 1, "is empty: it has no columns");
  ResultTable table{file, records.next(), {}, {}};
  for (auto name = table.columns.begin(); name != table.columns.end(); ++name) {
    if (name->empty()) throw ResultError(file, 1, "a column has no name");
    if (std::find(table.columns.begin(), name, *name) != name)
      throw ResultError(file, 1, "two columns are named '" + *name + "'");
  }
  while (!records.at_end()) {
    table.lines.push_back(records.line());
    table.rows.push_back(records.next());
    if (table.rows.back().size() != table.columns.size())
      throw ResultError(
          file, table.lines.back(),
          std::to_string(table.rows.back().size()) + " values for " + std::to_string(table.columns.size()) + " columns");
  }
  return table;
}

ResultTable read_results(const std::string& path) { return parse_results(read_whole(path), path); }

}  // namespace refitlab
