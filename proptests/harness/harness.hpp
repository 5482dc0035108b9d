// SPDX-License-Identifier: GPL-3.0-or-later
// The test harness: properties that say what they tried, and a run whose result is the conjunction of all of them.
//
//   PROPTEST(lemma5_cap_enclosing_sphere) {
//     t.holds("the repaired ball encloses every point of the cap", {.form = "repaired", .number_type = "rational",
//             .cases = 2000, .degenerate_at_least = 0.1}, [] { ... RC_TAG("degenerate"); RC_ASSERT(...); });
//     t.refuted("the printed ball encloses every point of the cap", {.form = "printed"}, [] { ... });
//     t.example("the pinned counterexample refutes the printed statement", {}, [] { return verdict == Verdict::fails; });
//   }
//
// A test case is degenerate when its property calls RC_CLASSIFY(condition, "degenerate") with a true condition.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace proptests {

// What a record belongs to and how much is to be tried.
struct Options {
  std::string form =
      "";  // "printed", "implied" by what is, "repaired", "beyond", or empty for a check that is no statement of a lemma
  std::string number_type = "";    // "rational", "interval", "double", ...
  int cases = 1000;                // random cases, unless --cases says otherwise
  int max_size = 100;              // RapidCheck's size: how wild a generated value may be
  double degenerate_at_least = 0;  // the share of degenerate cases below which the test fails
  double degenerate_at_most = 1;   // the share above which it fails: too few generic cases then test the statement
  std::string hypothesis = "";     // the hypothesis whose necessity this shows, for a counterexample without it
  std::map<std::string, double> tags_at_least = {};  // by label of RC_TAG: the share of cases below which the test fails
};

struct Outcome {
  std::string stem;      // the file under lemmas/ or algorithms/ that is tested
  std::string sentence;  // the property, an English sentence
  std::string kind;      // "holds", "refuted", "example"
  Options options;
  bool passed = false;
  bool skipped = false;         // what it looks at is not there: not failed, but counted apart from what passed
  long cases = 0;               // tried; for "refuted" the number of cases until the first failure
  double degenerate_share = 0;  // of the cases tried
  std::uint64_t seed = 0;
  std::map<std::string, long> tags;  // how often each RC_TAG / RC_CLASSIFY label was seen
  std::string detail;                // the counterexample, or what a deterministic check has to say
  double seconds = 0;
};

// What a deterministic check returns: whether it passed, how much it looked at, and a line about it.
struct Checked {
  Checked(bool ok) : passed(ok) {}  // NOLINT: an example may simply return a bool
  Checked(bool ok, long n, std::string text = "") : passed(ok), cases(n), detail(std::move(text)) {}
  // Of data that are not there. A run prints how many checks it skipped.
  static Checked skip(std::string reason) {
    Checked out(false, 0, std::move(reason));
    out.skipped = true;
    return out;
  }
  bool passed, skipped = false;
  long cases = 1;
  std::string detail;
};

class Suite {
 public:
  explicit Suite(std::string stem) : stem_(std::move(stem)) {}

  // Passes if no case fails, all cases were run, and the shares of degenerate cases and of labels are as wanted. A property takes no
  // arguments, and draws what it needs. All of them have one type here: RapidCheck would compile some forty functions for each.
  void holds(const std::string& sentence, const Options& options, std::function<void()> property);
  template <class Property>
  requires(!std::is_void_v<std::invoke_result_t<Property>>) void holds(const std::string&, const Options&, Property) =
      delete;  // what it returns would be thrown away
  // Passes if random testing finds a counterexample: the statement is wrong, and the test is able to see it.
  void refuted(const std::string& sentence, const Options& options, std::function<void()> property);
  template <class Property>
  requires(!std::is_void_v<std::invoke_result_t<Property>>) void refuted(const std::string&, const Options&, Property) = delete;
  // A check without randomness: a pinned counterexample, a table of known values.
  void example(const std::string& sentence, const Options& options, const std::function<Checked()>& check);

 private:
  void run(const std::string& sentence, const std::string& kind, const Options& options, std::function<void()> property);
  std::string stem_;
};

using SuiteFunction = void (*)(Suite&);
struct Registration {
  Registration(const char* stem, SuiteFunction function);
};

#define PROPTEST(stem)                                                            \
  static void proptest_##stem(::proptests::Suite& t);                             \
  static const ::proptests::Registration register_##stem(#stem, proptest_##stem); \
  static void proptest_##stem([[maybe_unused]] ::proptests::Suite& t)

}  // namespace proptests
