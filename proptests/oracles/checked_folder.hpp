// SPDX-License-Identifier: GPL-3.0-or-later
// Running proptests/certificate/check or check_pairs on certificates in a folder, and proptests/certificate/check_clip on some.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "proptests/harness/temporary_folder.hpp"

namespace proptests::oracle {

struct CheckerRun {
  int status;
  std::vector<std::string> lines;  // of both its streams
};
std::string checker();        // the path of its program
std::string pairs_checker();  // and of check_pairs
// path: a file or folder without spaces, or several, or nothing. A run of more than two minutes of processor time is ended.
CheckerRun run_checker(const std::string& path, const std::string& program = checker());
// The same of proptests/certificate/check_clip; arguments are separated by spaces.
CheckerRun run_clip_checker(const std::string& arguments);
// Of the checker's intervals: its last line says how many cases it tried, or what is wrong.
CheckerRun run_interval_test();

// The document with one vertex a piece in place of its own: at the center of the reference, with the first weight
// vertex's weights.
nlohmann::json with_weight_vertex_vertices(nlohmann::json document);

// A document as a certificate's text, with the digest that fits: a forger can do that too.
std::string sealed(nlohmann::json document);

// What the checker says of a file: verdict and reason.
struct CheckedLine {
  std::string text;
  bool is_accepted() const { return text.starts_with("accepted: "); }
  bool is_rejected() const { return text.starts_with("rejected: "); }
  bool is_rejected_for(const std::string& reason) const { return is_rejected() && text.find(reason) != std::string::npos; }
};

// A folder of its own, gone afterwards.
class CheckedFolder {
 public:
  explicit CheckedFolder(std::string program = checker()) : program_(std::move(program)) {}
  void add(const std::string& text);
  std::size_t size() const { return count_; }
  std::string text(std::size_t number) const;  // of one that was added
  std::string path() const { return folder_.path(); }

  // A line for each file, in the order in which they were added. Throws std::runtime_error if the checker says anything
  // else, such as a traceback, or if its exit status is not that of its lines.
  std::vector<CheckedLine> check() const;

 private:
  std::string file(std::size_t number) const;

  std::string program_;
  TemporaryFolder folder_;
  std::size_t count_ = 0;
};

}  // namespace proptests::oracle
