// SPDX-License-Identifier: GPL-3.0-or-later
// Tests units of a run: they are found again only if nothing about them changed, and a run killed at any moment resumes.
#include "experiments/resume/run_folder.hpp"

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "algorithms/results/result_file.hpp"
#include "algorithms/results/write_whole.hpp"
#include "proptests/harness/child_process.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests::suite_run_folder {
namespace {

using namespace refitlab;

// Returns the file of the one unit that a folder has.
std::string only_unit(const TemporaryFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() == ".unit") return entry.path();
  return "";
}

void damage(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// A run has this many units, with all that an interrupted run can get wrong: its result, and what it did for it.
constexpr int units = 30;

std::string result_of(int unit) { return std::string(2000, static_cast<char>('a' + unit % 26)) + std::to_string(unit); }

std::string run_in(const std::string& folder, const std::string& log) {
  const RunFolder run(folder);
  std::string rows;
  for (int i = 0; i < units; ++i) {
    const std::string name = "unit " + std::to_string(i);
    std::optional<std::string> result = run.find(name, "options");
    if (!result) {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      result = result_of(i);
      std::ofstream(log, std::ios::app) << name << std::endl;
      run.keep(name, "options", *result);
    }
    rows += *result + "\n";
  }
  return rows;
}

Checked interrupted_run_has_the_same_rows() {
  const TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const std::string uninterrupted = run_in(folder.file("whole"), folder.file("whole log"));
  // Disks differ in speed.
  const auto whole = std::chrono::steady_clock::now() - start;
  std::mt19937_64 random(Session::get().seed());
  long kills = 0;
  for (int trial = 0; trial < 5 || (kills <= 10 && trial < 100); ++trial) {
    const std::string units_folder = folder.file("units " + std::to_string(trial));
    const std::string log = folder.file("log " + std::to_string(trial)), out = folder.file("out " + std::to_string(trial));
    long kills_here = 0;
    while (!std::filesystem::exists(out)) {
      ChildProcess run([&] { write_whole(out, run_in(units_folder, log)); });
      std::this_thread::sleep_for(whole * static_cast<double>(random() % 1000) / 8000 * ++kills_here);
      run.kill_now();
    }
    if (read_whole(out) != uninterrupted) return {false, kills, "other rows"};
    const std::string done = read_whole(log);
    const long computed = std::count(done.begin(), done.end(), '\n');
    if (computed > units + kills_here) return {false, kills, std::to_string(computed) + " units computed"};
    kills += kills_here;
  }
  return {kills > 10, kills, std::to_string(kills) + " runs"};
}

void units_are_found_under_their_names(Suite& t) {
  t.holds("a unit is found under its name and inputs only, and the latest of its name", {.cases = 50}, [] {
    const TemporaryFolder folder;
    const RunFolder run(folder.path());
    const auto name = *rc::gen::arbitrary<std::string>(), inputs = *rc::gen::arbitrary<std::string>();
    const auto result = *rc::gen::arbitrary<std::string>(), other = *rc::gen::arbitrary<std::string>();
    RC_ASSERT(!run.find(name, inputs));
    run.keep(name, inputs, result);
    RC_ASSERT(run.find(name, inputs) == result);
    if (other != inputs) RC_ASSERT(!run.find(name, other));
    if (other != name) RC_ASSERT(!run.find(other, inputs));
    run.keep(name, other, inputs);
    RC_ASSERT(run.find(name, other) == inputs);
    if (other != inputs) RC_ASSERT(!run.find(name, inputs));
  });
  t.holds("a unit whose file was changed or cut, in any place, is not found", {.cases = 1000}, [] {
    static const TemporaryFolder folder;
    static const RunFolder run(folder.path());
    static const std::string whole = (run.keep("unit", "inputs", "the result"), read_whole(only_unit(folder)));
    const std::string path = only_unit(folder);
    const auto at = *rc::gen::inRange<std::size_t>(0, whole.size());
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ *rc::gen::inRange(1, 256));
    damage(path, changed);
    RC_ASSERT(!run.find("unit", "inputs"));
    damage(path, whole.substr(0, at));
    RC_ASSERT(!run.find("unit", "inputs"));
    damage(path, whole);
    RC_ASSERT(run.find("unit", "inputs") == "the result");
  });
  t.example("a unit says what made it: its name, commit, compiler, flags, processor, program and inputs", {}, [] {
    const TemporaryFolder folder;
    RunFolder(folder.path()).keep("a unit", "some inputs", "the result");
    const std::string text = read_whole(only_unit(folder));
    for (const char* word : {"unit: a unit\n", "\ncommit: ", "\ncompiler: ", "\nflags: ", "\ncpu: ", "\nprogram: ",
                             "\ninputs: some inputs\n", "\nresult: 10 bytes, "})
      if (text.find(word) == std::string::npos) return Checked(false, 1, word);
    return Checked(text.ends_with("\nthe result"));
  });
  t.example("units whose names differ by one character, whichever and wherever, are kept side by side", {}, [] {
    const TemporaryFolder folder;
    const RunFolder run(folder.path());
    const std::string longest(300, 'u');
    const std::vector<std::string> names{"unit 1",
                                         "unit_1",
                                         "unit-1",
                                         "unit.1",
                                         "Unit 1",
                                         "unit 1 ",
                                         "unit  1",
                                         "",
                                         "_",
                                         longest,
                                         longest + "u",
                                         longest + "v",
                                         std::string(299, 'u') + "w",
                                         "v" + std::string(299, 'u')};
    for (const auto& name : names) run.keep(name, "inputs", "of " + name);
    std::string wrong;
    for (const auto& name : names)
      if (run.find(name, "inputs") != "of " + name) wrong += "'" + name.substr(0, 20) + "'; ";
    return Checked(wrong.empty(), static_cast<long>(names.size()), wrong);
  });
}

void heads_of_units_and_runs_that_start_anew(Suite& t) {
  t.example("a unit's head has the commit with its state, and the program by 16 hexadecimal digits", {}, [] {
    const TemporaryFolder folder;
    RunFolder(folder.path()).keep("a unit", "some inputs", "the result");
    const std::string text = read_whole(only_unit(folder));
    const Provenance& p = Provenance::of_this_build();
    const std::size_t program = text.find("\nprogram: ") + 10;
    return text.find("\ncommit: " + p.commit + " " + p.dirty + "\ncompiler: " + p.compiler + "\nflags: " + p.flags +
                     "\ncpu: " + p.cpu + "\nprogram: ") != std::string::npos &&
           text.find_first_not_of("0123456789abcdef", program) == program + 16;
  });
  t.example("a run that starts anew leaves what are no units", {}, [] {
    const TemporaryFolder folder;
    write_whole(folder.file("notes.txt"), "mine");
    RunFolder(folder.path()).keep("unit", "inputs", "result");
    const RunFolder anew(folder.path(), true);
    return only_unit(folder).empty() && read_whole(folder.file("notes.txt")) == "mine" &&
           std::filesystem::exists(folder.file("lock"));
  });
  t.example("a run that starts anew forgets all units, and one that does not forgets none", {}, [] {
    const TemporaryFolder folder;
    RunFolder(folder.path()).keep("unit", "inputs", "result");
    const bool kept = RunFolder(folder.path()).find("unit", "inputs").has_value();
    const bool forgotten = !RunFolder(folder.path(), true).find("unit", "inputs");
    return Checked(kept && forgotten && only_unit(folder).empty(), 2);
  });
}

}  // namespace

PROPTEST(run_folder) {
  units_are_found_under_their_names(t);
  heads_of_units_and_runs_that_start_anew(t);
  t.example("two runs at once: the second is refused", {}, [] {
    const TemporaryFolder folder;
    const RunFolder run(folder.path());
    try {
      const RunFolder second(folder.path(), true);
    } catch (const std::runtime_error& e) {
      return Checked(std::string(e.what()).find("in use by another run") != std::string::npos, 1, e.what());
    }
    return Checked(false, 1, "it was not");
  });
  t.example("a run killed at random moments until it is done has the rows of an uninterrupted one, and does no unit twice", {},
            interrupted_run_has_the_same_rows);
}

}  // namespace proptests::suite_run_folder
