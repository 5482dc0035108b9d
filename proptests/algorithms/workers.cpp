// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the tests' own processes: nothing of a suite gets lost between them.
#include "proptests/harness/workers.hpp"

#include <unistd.h>

#include <stdexcept>

namespace proptests::suite_workers {
namespace {

const std::vector<std::string> stems = {"a", "b", "c", "d", "e"};

SuiteResult result_of(const std::string& stem) {
  Outcome outcome{.stem = stem, .sentence = "a \"sentence\", of\ntwo lines", .kind = "refuted"};
  outcome.options = {
      .form = "printed", .number_type = "rational", .cases = 7, .hypothesis = "w > 0", .tags_at_least = {{"tag", 0.1}}};
  outcome.passed = stem != "b", outcome.skipped = stem == "b";
  outcome.cases = 1l << 40, outcome.degenerate_share = 1.0 / 3, outcome.seed = ~std::uint64_t{0} - 5;
  outcome.tags = {{"tag", 3}}, outcome.detail = "x = \xff", outcome.seconds = 0.1;
  return {{outcome, Outcome{.stem = stem, .sentence = "another", .kind = "example"}}, {"an error of " + stem, "another"}};
}

bool is_that_of(const SuiteResult& found, const std::string& stem) {
  const SuiteResult wanted = result_of(stem);
  const Outcome &f = found.outcomes.at(0), &w = wanted.outcomes.at(0);
  return found.messages == wanted.messages && found.outcomes.size() == 2 && found.outcomes[1].sentence == "another" &&
         f.stem == w.stem && f.sentence == w.sentence && f.kind == w.kind && f.passed == w.passed && f.skipped == w.skipped &&
         f.cases == w.cases && f.degenerate_share == w.degenerate_share && f.seed == w.seed && f.tags == w.tags &&
         f.seconds == w.seconds && f.options.form == w.options.form && f.options.number_type == w.options.number_type &&
         f.options.cases == w.options.cases && f.options.hypothesis == w.options.hypothesis &&
         // Bytes that are no text are replaced in it.
         f.options.tags_at_least == w.options.tags_at_least && f.detail.starts_with("x = ");
}

PROPTEST(workers) {
  t.example("results come in the order of the suites, with all that they hold, from one process to more than there are suites",
            {}, [] {
              for (const int workers : {1, 2, 4, 8}) {
                // The first suite to begin is the last to end.
                const auto found = run_in_processes(stems, workers, [](const std::string& stem) {
                  if (stem == "a") ::usleep(100'000);
                  return result_of(stem);
                });
                if (found.size() != stems.size()) return Checked(false);
                for (std::size_t k = 0; k < stems.size(); ++k)
                  if (!is_that_of(found[k], stems[k])) return Checked(false, workers, stems[k]);
              }
              return Checked(true, 20);
            });
  t.example("a process that ends before its time is an error that names the suite; so is one that throws", {}, [] {
    for (const bool throws : {false, true}) {
      try {
        run_in_processes(stems, 2, [&](const std::string& stem) {
          if (stem == "c" && throws) throw std::runtime_error("not from a test");
          if (stem == "c") ::_exit(0);
          return result_of(stem);
        });
        return Checked(false, 1, "no error");
      } catch (const std::runtime_error& e) {
        if (std::string(e.what()) != "a process of the tests ended before its time; these suites have no result: c")
          return Checked(false, 1, e.what());
      }
    }
    return Checked(true, 2);
  });
}

}  // namespace
}  // namespace proptests::suite_workers
