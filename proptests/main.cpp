// SPDX-License-Identifier: GPL-3.0-or-later
// The program proptests runs every property (or those of --only STEM) and writes their verdicts.
#include <algorithm>
#include <boost/program_options.hpp>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "algorithms/results/write_whole.hpp"
#include "proptests/cases/case_file.hpp"
#include "proptests/cases/pinned_inputs.hpp"
#include "proptests/harness/error_list.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/harness/thrown.hpp"
#include "proptests/harness/verdict_table.hpp"
#include "proptests/harness/workers.hpp"

namespace {

std::uint64_t parse_seed(const std::string& text) {
  if (text == "random") return std::random_device{}() * 0x100000001ull ^ std::random_device{}();
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument("--seed takes a number or 'random', not '" + text + "'");
  return seed;
}

bool is_wanted(const std::string& stem, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& part) {
           return part.starts_with('=') ? stem == part.substr(1) : stem.find(part) != std::string::npos;
         });
}

proptests::SuiteResult run_suite(const std::string& stem) {
  auto& session = proptests::Session::get();
  const std::size_t before = session.outcomes().size();
  proptests::Suite suite(stem);
  proptests::record_errors_of(stem);
  for (const auto function : session.suites().at(stem)) function(suite);
  return {{session.outcomes().begin() + static_cast<std::ptrdiff_t>(before), session.outcomes().end()},
          proptests::recorded_errors()[stem]};
}

std::vector<proptests::SuiteResult> run_suites(const std::vector<std::string>& stems, int workers) {
  if (workers > 1 && stems.size() > 1) return proptests::run_in_processes(stems, workers, run_suite);
  std::vector<proptests::SuiteResult> results;
  for (const std::string& stem : stems) {
    std::cout << "[" << results.size() + 1 << "/" << stems.size() << "] " << stem << '\n';
    results.push_back(run_suite(stem));
  }
  return results;
}

// Checks that the errors on the list were thrown in the suites that are to throw them.
proptests::SuiteResult check_errors(const std::vector<std::string>& stems, const std::vector<proptests::SuiteResult>& results) {
  std::map<std::string, std::set<std::string>> messages;
  for (std::size_t k = 0; k < stems.size(); ++k) messages[stems[k]] = results[k].messages;
  auto& session = proptests::Session::get();
  proptests::Suite("error_list").example("the suites that ran provoked every error that is listed of them", {}, [&] {
    std::string unseen;
    const auto list = proptests::read_error_list("proptests/errors.md");
    for (const auto& error : proptests::unseen_errors(list, {stems.begin(), stems.end()}, messages)) unseen += error + "; ";
    return proptests::Checked(unseen.empty(), static_cast<long>(list.size()), unseen);
  });
  return {{session.outcomes().back()}, {}};
}

}  // namespace

int main(int argc, char** argv) try {
  namespace po = boost::program_options;
  std::vector<std::string> only;
  constexpr std::uint64_t fixed_seed = 2006;
  std::string seed_text = std::to_string(fixed_seed);
  int cases = 0, workers = 1;
  std::string out;
  po::options_description options("proptests: the property tests of refitlab");
  options.add_options()("help", "this text")("list", "the stems, a line each")(
      "only", po::value(&only)->multitoken(), "run the suites whose stem contains one of these, or is what follows '='")(
      "seed", po::value(&seed_text), "seed of the random cases, or 'random' for a fresh one (fixed unless given)")(
      "cases", po::value(&cases), "cases of every property, for a campaign as long as wanted")(
      "workers", po::value(&workers), "how many suites run at a time, each in a process (1)")(
      "out", po::value(&out), "folder for verdicts.csv")("print-cases",
                                                         "print proptests/cases/cases.json as Markdown, and nothing else")(
      "write-cases", "write what is pinned in proptests/counterexamples into proptests/cases/cases.json, and nothing else");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, options), map);
  po::notify(map);
  if (map.count("help")) return std::cout << options, 0;
  if (map.count("print-cases"))
    return std::cout << proptests::cases::as_markdown(proptests::cases::read_cases("proptests/cases/cases.json")), 0;
  if (map.count("write-cases")) {
    const std::string file = "proptests/cases/cases.json";
    return refitlab::write_whole(file, proptests::cases::with_pinned_inputs(refitlab::read_whole(file))), 0;
  }
  if (map.count("cases") && cases < 1) throw po::error("--cases must be positive");
  if (workers < 1) throw po::error("--workers must be positive");
  const std::uint64_t seed = parse_seed(seed_text);

  auto& session = proptests::Session::get();
  session.set(seed, cases);
  if (map.count("list")) {
    for (const auto& [stem, suites] : session.suites()) std::cout << stem << '\n';
    return 0;
  }
  std::cout << "proptests: seed " << seed << (cases ? ", " + std::to_string(cases) + " cases of each property" : "") << '\n';
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::string> stems;
  for (const auto& [stem, suites] : session.suites())
    if (is_wanted(stem, only)) stems.push_back(stem);
  if (stems.empty()) throw po::error("no suite's stem contains what --only names; --list lists them");
  auto results = run_suites(stems, workers);
  results.push_back(check_errors(stems, results));
  std::vector<proptests::Outcome> outcomes;
  for (const auto& result : results) outcomes.insert(outcomes.end(), result.outcomes.begin(), result.outcomes.end());
  long passed = 0, failed = 0, skipped = 0;
  for (const auto& o : outcomes) ++(o.skipped ? skipped : o.passed ? passed : failed);
  if (!out.empty()) proptests::write_verdicts(outcomes, out);
  for (const auto& o : outcomes)
    if (!o.passed)
      std::cout << (o.skipped ? "SKIPPED " : "FAILED ") << o.stem << ": " << o.sentence << "\n       " << o.detail << '\n';
  std::printf("%.0f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  std::printf("%ld passed, %ld failed", passed, failed);
  if (skipped > 0) std::printf(", %ld skipped", skipped);
  std::printf("\n");
  return failed == 0 ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << "proptests: " << e.what() << '\n';
  return 2;
}
