// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the test harness: properties that say what they tried, and a run whose result is the conjunction of all of them.
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

namespace proptests {

// Says what a record belongs to and how much is to be tried.
struct Options {
  // The form is "printed", "implied" by what is, "repaired", "beyond", or empty for a check that is no statement of a lemma.
  std::string form = "";
  std::string number_type = "";  // "rational", "interval", "double", ...
  int cases = 1000;              // random cases, unless --cases says otherwise
  // RapidCheck's size says how wild a generated value may be.
  int max_size = 100;
  // The test fails if the share of degenerate cases is less.
  double degenerate_at_least = 0;
  // It also fails if the share is more: too few generic cases then test the statement. A test that is about degenerate cases alone,
  // or has too few cases to promise a share, says 1.
  double degenerate_at_most = 0.95;
  // This is the hypothesis whose necessity the test shows, for a counterexample without it.
  std::string hypothesis = "";
  // For each label of RC_TAG, the test fails if the share of cases with it is less.
  std::map<std::string, double> tags_at_least = {};
  // Returns what else is wrong with how many cases had each label, if anything. Then the test fails.
  std::function<std::string(const std::map<std::string, long>& labels)> complaint_about_labels = {};
};

struct Outcome {
  // This is the suite: the file that is tested, or a whole area.
  std::string stem;
  std::string sentence;  // the property, an English sentence
  std::string kind;      // "holds", "refuted", "example"
  Options options;
  bool passed = false;
  // What it looks at is not there: it has not failed, but is counted apart from what passed.
  bool skipped = false;
  // This many were tried; for "refuted" it is the number of cases until the first failure.
  long cases = 0;
  double degenerate_share = 0;  // of the cases tried
  std::uint64_t seed = 0;
  // These are the numbers of times that each RC_TAG / RC_CLASSIFY label was seen.
  std::map<std::string, long> tags;
  // This is the counterexample, or what a deterministic check has to say.
  std::string detail;
  double seconds = 0;
};

// Holds what a deterministic check returns: whether it passed, how much it looked at, and a line about it.
struct Checked {
  Checked(bool ok) : passed(ok) {}  // NOLINT: an example may simply return a bool
  Checked(bool ok, long n, std::string text = "") : passed(ok), cases(n), detail(std::move(text)) {}
  // Returns a check whose data are not there. A run prints how many checks it skipped.
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

  // Passes if no case fails, all cases were run, and the shares of degenerate cases and of labels are as wanted. A property takes
  // no arguments, and draws what it needs. All of them have one type here: RapidCheck would compile some forty functions for
  // each.
  void holds(const std::string& sentence, const Options& options, std::function<void()> property);
  template <class Property>
  requires(!std::is_void_v<std::invoke_result_t<Property>>) void holds(const std::string&, const Options&, Property) =
      // What it returns would be thrown away.
      delete;
  // Passes if random testing finds a counterexample: the statement is wrong, and the test is able to see it.
  void refuted(const std::string& sentence, const Options& options, std::function<void()> property);
  template <class Property>
  requires(!std::is_void_v<std::invoke_result_t<Property>>) void refuted(const std::string&, const Options&, Property) = delete;
  // Runs a check without randomness: a pinned counterexample, a table of known values.
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
