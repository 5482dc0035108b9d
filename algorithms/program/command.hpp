// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program have exit codes, options and the progress bar in common.
#pragma once

#include <boost/program_options.hpp>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/skinning/rotation_blend.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// done: nothing is wrong. found: a check found an error. usage: the call is wrong. refused: a file cannot be used.
enum ExitCode : int { exit_done = 0, exit_found = 1, exit_usage = 2, exit_refused = 3 };

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A Command is one of the program's commands. run takes the arguments behind the command's name. Results go to out, and all else
// to errors. It throws UsageError, ModelError, and std::runtime_error for files that cannot be written.
struct Command {
  const char *name, *summary;
  int (*run)(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);
};

extern const Command bake_command, check_command, collide_command, info_command;

// Returns the values of a command's options and of its files, which are options by position. Throws UsageError. If "help" has a
// value, help was asked for, by --help or -h, and required files may be missing.
boost::program_options::variables_map parse_arguments(const std::vector<std::string>& arguments,
                                                      const boost::program_options::options_description& options,
                                                      const std::vector<std::string>& files);

// A NamedFile is the path of a file, and the option or the position that names it in a call.
struct NamedFile {
  std::string of, path;
};

// Returns the files of those of these options that were given.
std::vector<NamedFile> files_of(const boost::program_options::variables_map& map, const std::vector<std::string>& options);

// Throws UsageError if a file that is to be written has no name, or is one of the others or of those that are written too.
void check_written(std::vector<NamedFile> others, const std::vector<NamedFile>& written);

// Returns whether what is written to this file comes out of the program's standard output.
bool is_standard_output(const std::string& path);

// Returns where to write what a person reads: to errors, if one of the files that are written comes out of the standard output,
// which is to be read by a program then.
std::ostream& told_to(const std::vector<NamedFile>& written, std::ostream& out, std::ostream& errors);

// Returns the name that --skinning takes.
const char* name_of(Skinning skinning);
Skinning skinning_of(const std::string& name);  // throws UsageError
// Returns the name that --rotations takes.
const char* name_of(RotationBlend rotations);

// Returns a text of a file as it is printed: with "\\x1b" and such for control characters, so that it stays on its line.
std::string printable(const std::string& text);

// Prints a line for each of the notes on a file.
void print_notes(const std::string& file, const std::vector<std::string>& notes, std::ostream& to);

// A ProgressBar such as "[#####     ]  50 %" is written over itself on a terminal. Elsewhere it writes nothing.
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
