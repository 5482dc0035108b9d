// One run of the tests: its options, its suites, and the outcomes so far.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "proptests/harness.hpp"

namespace proptests {

class Session {
 public:
  static Session& get();

  std::map<std::string, std::vector<SuiteFunction>>& suites() { return suites_; }
  std::uint64_t seed() const { return seed_; }
  double scale() const { return scale_; }
  const std::vector<Outcome>& outcomes() const { return outcomes_; }

  void set(std::uint64_t seed, double scale) { seed_ = seed, scale_ = scale; }
  void announce(const std::string& stem, const std::string& sentence) const;
  void add(Outcome outcome);

 private:
  std::map<std::string, std::vector<SuiteFunction>> suites_;  // by stem: in a fixed order whatever the link order
  std::vector<Outcome> outcomes_;
  std::uint64_t seed_ = 2006;  // fixed unless --seed says otherwise
  double scale_ = 1;
};

}  // namespace proptests
