// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of the program have in common: exit codes, options and the progress bar.
#pragma once

#include <boost/program_options.hpp>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// done: and nothing is wrong. found: a check found an error. usage: the call is wrong. refused: a file cannot be used.
enum ExitCode : int { exit_done = 0, exit_found = 1, exit_usage = 2, exit_refused = 3 };

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// One of the program's commands. run: with the arguments behind the command's name; results go to out, all else to errors.
// Throws UsageError, ModelError, and std::runtime_error for files that cannot be written.
struct Command {
  const char *name, *summary;
  int (*run)(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);
};

extern const Command bake_command, check_command, collide_command, info_command;

// The values of a command's options and of its files, which are options by position. Throws UsageError. Help was asked for where
// "help" has a value: then required files may be missing.
boost::program_options::variables_map parse_arguments(const std::vector<std::string>& arguments,
                                                      const boost::program_options::options_description& options,
                                                      const std::vector<std::string>& files);

const char* name_of(Skinning skinning);
Skinning skinning_of(const std::string& name);  // throws UsageError

// A line for each of the model's notes.
void print_notes(const Model& model, std::ostream& to);

// "[#####     ]  50 %", written over itself on a terminal; nothing elsewhere.
class ProgressBar {
 public:
  explicit ProgressBar(std::ostream& errors, bool is_shown);
  ~ProgressBar();
  void show(double share);

 private:
  std::ostream& errors_;
  bool is_shown_;
  int percent_ = -1;
};

}  // namespace refitlab
