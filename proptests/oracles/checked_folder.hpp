// SPDX-License-Identifier: GPL-3.0-or-later
// Runs proptests/certificate/check or check_pairs on certificates in a folder, and proptests/certificate/check_clip on some.
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
// Runs a checker on a file or folder without spaces, on several, or on nothing. A run of more than two minutes of processor time
// is ended.
CheckerRun run_checker(const std::string& path, const std::string& program = checker());
// Runs proptests/certificate/check_clip in the same way. Arguments are separated by spaces. Python looks into the folder `modules` first,
// if it is named.
CheckerRun run_clip_checker(const std::string& arguments, const std::string& modules = "");
// Runs the test of the checker's intervals. Its last line says how many cases it tried, or what is wrong.
CheckerRun run_interval_test();

// Returns the document with one vertex for each piece in place of its own: at the center of the reference, with the first weight
// vertex's weights.
nlohmann::json with_weight_vertex_vertices(nlohmann::json document);

// Returns a document as a certificate's text, with the digest that fits. A forger can do that too.
std::string sealed(nlohmann::json document);

// Holds what the checker says of a file: verdict and reason.
struct CheckedLine {
  std::string text;
  bool is_accepted() const { return text.starts_with("accepted: "); }
  bool is_rejected() const { return text.starts_with("rejected: "); }
  bool is_rejected_for(const std::string& reason) const { return is_rejected() && text.find(reason) != std::string::npos; }
};

// Makes a folder of its own, which is removed afterwards.
class CheckedFolder {
 public:
  explicit CheckedFolder(std::string program = checker()) : program_(std::move(program)) {}
  void add(const std::string& text);
  std::size_t size() const { return count_; }
  std::string text(std::size_t number) const;  // It was added before.
  std::string path() const { return folder_.path(); }

  // Returns a line for each file, in the order in which they were added. Throws std::runtime_error if the checker says anything
  // else, such as a traceback, or if its exit status is not that of its lines.
  std::vector<CheckedLine> check() const;

 private:
  std::string file(std::size_t number) const;

  std::string program_;
  TemporaryFolder folder_;
  std::size_t count_ = 0;
};

}  // namespace proptests::oracle
