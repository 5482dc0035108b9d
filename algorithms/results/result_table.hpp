// SPDX-License-Identifier: MIT
// ResultTable: a result file as it was written, for the report, the paper and other programs.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace refitlab {

// Names the file, the line and the reason.
struct ResultError : std::runtime_error {
  ResultError(const std::string& file, std::size_t line, const std::string& reason)
      : std::runtime_error(file + ": line " + std::to_string(line) + ": " + reason) {}
};

struct ResultTable {
  std::string file;
  std::vector<std::string> columns;            // at least one; distinct, none empty
  std::vector<std::vector<std::string>> rows;  // a value for each column
  std::vector<std::size_t> lines;              // of the file, where each row starts, from 1

  // Throws ResultError if there is no such column.
  std::size_t column(std::string_view name) const;
  const std::string& value(std::size_t row, std::string_view name) const { return rows[row][column(name)]; }
  // What format_number wrote: "nan", "inf" and "-inf" too. Throws ResultError for anything else.
  double number(std::size_t row, std::string_view name) const;
};

// CSV by RFC 4180: fields with commas, quotes or line ends stand in quotes, quotes in them twice. Lines, the last one
// too, end with LF or CRLF. Throws ResultError: a quote inside a bare field, text after a closing quote, a field
// without its closing quote, a carriage return alone, a last line that does not end, rows that do not fit the columns,
// no or equal or empty column names. file: for errors.
ResultTable parse_results(std::string_view text, const std::string& file);

// The same of a file; std::runtime_error if it cannot be read.
ResultTable read_results(const std::string& path);

}  // namespace refitlab
