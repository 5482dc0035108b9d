// SPDX-License-Identifier: GPL-3.0-or-later
// Tests result files: a reader of RFC 4180 finds in them what was added.
#include "algorithms/results/result_file.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "proptests/harness/harness.hpp"

namespace proptests::suite_result_file {
namespace {

using namespace refitlab;
using Rows = std::vector<std::vector<std::string>>;

// Draws text in which every character that CSV gives a meaning is likely.
std::string draw_text() {
  return *rc::gen::container<std::string>(rc::gen::weightedOneOf<char>(
      {{3, rc::gen::element(',', '"', '\n', '\r')}, {2, rc::gen::inRange('a', 'z')}, {1, rc::gen::arbitrary<char>()}}));
}

// Returns the records of a CSV text whose lines all end. A quote begins a quoted field only at its start, and is doubled inside
// it.
Rows records(const std::string& text) {
  Rows rows;
  for (std::size_t i = 0; i < text.size();) {
    rows.emplace_back();
    do {
      i += !rows.back().empty();  // This skips the comma.
      std::string& field = rows.back().emplace_back();
      if (text.at(i) == '"') {
        for (++i; text.at(i) != '"' || text.at(i + 1) == '"'; ++i) {
          i += text[i] == '"';
          field += text[i];
        }
        ++i;
      } else {
        for (; text.at(i) != ',' && text[i] != '\n'; ++i) {
          RC_ASSERT(text[i] != '"' && text[i] != '\r');
          field += text[i];
        }
      }
    } while (text.at(i) == ',');
    RC_ASSERT(text.at(i++) == '\n');
  }
  return rows;
}

}  // namespace

PROPTEST(result_file) {
  t.holds("what was added is what is read, with where it comes from", {.cases = 1000, .degenerate_at_least = 0.05}, [] {
    const int width = *rc::gen::inRange(1, 5), height = *rc::gen::inRange(0, 5);
    RC_CLASSIFY(height == 0, "degenerate");
    const auto draw_row = [&] {
      std::vector<std::string> row;
      for (int c = 0; c < width; ++c) row.push_back(draw_text());
      return row;
    };
    const auto& build = Provenance::of_this_build();
    const std::vector<std::string> columns = draw_row();
    ResultFile file(columns);
    Rows expected{columns};
    const std::vector<std::string> of_all{"commit", "dirty", "compiler", "flags", "cpu", "seed"};
    expected.back().insert(expected.back().end(), of_all.begin(), of_all.end());
    for (int r = 0; r < height; ++r) {
      expected.push_back(draw_row());
      const auto seed = *rc::gen::arbitrary<std::uint64_t>();
      file.add(expected.back(), seed);
      for (const auto& value : {build.commit, build.dirty, build.compiler, build.flags, build.cpu, std::to_string(seed)})
        expected.back().push_back(value);
    }
    RC_ASSERT(records(file.text()) == expected);
  });
  t.holds("a number's text is that of no other double, and no longer than its fewest digits make it", {.cases = 2000}, [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double drawn = 0;
    std::memcpy(&drawn, &bits, sizeof drawn);
    const double number = *rc::gen::element(drawn, 0.0, -0.0, INFINITY, -INFINITY, NAN, 5e-324, *rc::gen::arbitrary<double>());
    const std::string text = format_number(number);
    const double read = std::strtod(text.c_str(), nullptr);
    if (std::isnan(number)) RC_ASSERT(std::isnan(read) && text == (std::signbit(number) ? "-nan" : "nan"));
    else RC_ASSERT(std::memcmp(&read, &number, sizeof read) == 0);
    if (!std::isfinite(number)) return;
    // The text is the one with the fewest digits that reads back as the number.
    char few[40];
    for (int digits = 1;; ++digits) {
      std::snprintf(few, sizeof few, "%.*e", digits - 1, number);
      if (std::strtod(few, nullptr) == number) break;
    }
    RC_ASSERT(text.size() <= std::strlen(few));
  });
  t.example("a row of too few values or too many is refused when it is added", {}, [] {
    ResultFile file({"a", "b"});
    long refused = 0;
    for (const std::vector<std::string>& row : {std::vector<std::string>{"1"}, {"1", "2", "3"}, {}}) {
      try {
        file.add(row);
      } catch (const std::logic_error& e) {
        refused += std::string(e.what()) == "a result row must have a value per column";
      }
    }
    return Checked(refused == 3, 3);
  });
}

}  // namespace proptests::suite_result_file
