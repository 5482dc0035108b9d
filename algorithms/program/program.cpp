// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/program.hpp"

#include <new>
#include <ostream>

#include "algorithms/program/command.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

const Command* const commands[] = {&bake_command, &info_command, &check_command, &collide_command};

void describe(std::ostream& out) {
  out << "refitlab: bounds of skinned characters that hold, in every pose and at every time\n\n"
         "usage: refitlab COMMAND [OPTION...] FILE...\n\ncommands:\n";
  for (const Command* command : commands)
    out << "  " << command->name << std::string(10 - std::string(command->name).size(), ' ') << command->summary << '\n';
  out << "\nrefitlab COMMAND --help says what a command takes.\n"
         "exit codes: 0 all is well; 1 a check found an error; 2 the call is wrong; 3 a file cannot be used\n";
}

// What a message quotes of a file may neither steer a terminal nor begin a line.
std::string shown(const std::exception& error) { return printable(error.what()); }

}  // namespace

int run_program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  const DefaultFloatEnvironment environment;
  if (arguments.empty()) return describe(errors), exit_usage;
  if (arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "help") return describe(out), exit_done;
  for (const Command* command : commands) {
    if (arguments[0] != command->name) continue;
    try {
      return command->run({arguments.begin() + 1, arguments.end()}, out, errors);
    } catch (const UsageError& e) {
      errors << "refitlab " << command->name << ": " << shown(e) << "\nrefitlab " << command->name
             << " --help says what it takes.\n";
      return exit_usage;
    } catch (const std::bad_alloc&) {
      std::string files;
      for (std::size_t i = 1; i < arguments.size(); ++i) files += ' ' + printable(arguments[i]);
      errors << "refitlab " << command->name << files << ": there is not enough memory for what this asks for\n";
      return exit_refused;
    } catch (const std::exception& e) {
      errors << "refitlab " << command->name << ": " << shown(e) << '\n';
      return exit_refused;
    }
  }
  errors << "refitlab: there is no command " << printable(arguments[0]) << "; refitlab --help lists them.\n";
  return exit_usage;
}

}  // namespace refitlab
