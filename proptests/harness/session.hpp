// SPDX-License-Identifier: GPL-3.0-or-later
// Holds one run of the tests: its options, its suites, and the outcomes so far.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "proptests/harness/harness.hpp"

namespace proptests {

class Session {
 public:
  static Session& get();

  std::map<std::string, std::vector<SuiteFunction>>& suites() { return suites_; }
  std::uint64_t seed() const { return seed_; }
  // Returns how many cases to run of a property that asks for so many by default.
  int cases_for(int by_default) const { return cases_ > 0 ? cases_ : by_default; }
  const std::vector<Outcome>& outcomes() const { return outcomes_; }

  // Sets the seed and the cases of every property, or 0 cases for what each asks for.
  void set(std::uint64_t seed, int cases) { seed_ = seed, cases_ = cases; }
  void announce(const std::string& stem, const std::string& sentence) const;
  void progress(long done, long of) const;
  void add(Outcome outcome);

 private:
  // They are sorted by stem, in a fixed order whatever the link order.
  std::map<std::string, std::vector<SuiteFunction>> suites_;
  std::vector<Outcome> outcomes_;
  std::uint64_t seed_ = 2006;  // fixed unless --seed says otherwise
  int cases_ = 0;
  // Says whether the output is watched. Otherwise, in a log, a line is written once and from left to right.
  static bool is_watched() { return ::isatty(STDOUT_FILENO); }
};

}  // namespace proptests
