// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/harness.hpp"

#include <chrono>
#include <sstream>

#include "proptests/harness/session.hpp"

namespace proptests {
namespace {

// Counts labels as a listener, and shows progress once a property takes long.
struct Quiet : rc::detail::TestListener {
  Quiet(const Session& s, long n) : session(s), wanted(n) {}
  void onTestCaseFinished(const rc::detail::CaseDescription& c) override {
    ++cases;
    bool degenerate = false;
    for (const auto& shown : c.tags) {
      // RapidCheck shows a label as it shows any string: in quotes.
      const bool quoted = shown.size() >= 2 && shown.front() == '"' && shown.back() == '"';
      const std::string tag = quoted ? shown.substr(1, shown.size() - 2) : shown;
      ++tags[tag];
      degenerate = degenerate || tag == "degenerate";
    }
    degenerate_cases += degenerate;
    if (const auto now = std::chrono::steady_clock::now(); now - shown_at > std::chrono::seconds(2)) {
      session.progress(std::min(cases, wanted), wanted);
      shown_at = now;
    }
  }
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
  const Session& session;
  const long wanted;
  std::chrono::steady_clock::time_point shown_at = std::chrono::steady_clock::now();
  long cases = 0, degenerate_cases = 0;
  std::map<std::string, long> tags;
};

std::string describe(const rc::detail::FailureResult& failure) {
  std::ostringstream out;
  for (const auto& [type, value] : failure.counterExample) out << (type.empty() ? "" : type + " = ") << value << "; ";
  out << failure.description;
  return out.str();
}

// Returns which kind of case there was too little or too much of, or nothing.
std::string complaint_about_shares(const Outcome& outcome) {
  const Options& options = outcome.options;
  const auto complaint = [](const std::string& what, double share, double wanted) {
    return "too few " + what + " cases: a share of " + std::to_string(share) + ", wanted " + std::to_string(wanted);
  };
  const double degenerate = outcome.degenerate_share;
  if (degenerate < options.degenerate_at_least) return complaint("degenerate", degenerate, options.degenerate_at_least);
  if (degenerate > options.degenerate_at_most) return complaint("generic", 1 - degenerate, 1 - options.degenerate_at_most);
  for (const auto& [tag, wanted] : options.tags_at_least) {
    const auto found = outcome.tags.find(tag);
    const double share =
        found == outcome.tags.end() ? 0 : static_cast<double>(found->second) / static_cast<double>(outcome.cases);
    if (share < wanted) return complaint("'" + tag + "'", share, wanted);
  }
  return options.complaint_about_labels ? options.complaint_about_labels(outcome.tags) : "";
}

}  // namespace

void Suite::holds(const std::string& sentence, const Options& options, std::function<void()> property) {
  run(sentence, "holds", options, std::move(property));
}

void Suite::refuted(const std::string& sentence, const Options& options, std::function<void()> property) {
  run(sentence, "refuted", options, std::move(property));
}

void Suite::run(const std::string& sentence, const std::string& kind, const Options& options, std::function<void()> property) {
  Session& session = Session::get();
  const auto start = std::chrono::steady_clock::now();
  session.announce(stem_, sentence);

  rc::detail::TestMetadata metadata;
  metadata.id = metadata.description = stem_ + ": " + sentence;
  rc::detail::TestParams params;
  // Each property has a stream of its own, so that adding one test does not change what the others try.
  params.seed = session.seed() ^ std::hash<std::string>{}(metadata.id);
  params.maxSuccess = session.cases_for(options.cases);
  params.maxSize = options.max_size;
  params.maxDiscardRatio = 20;
  Quiet listener(session, params.maxSuccess);
  const auto result = rc::detail::checkProperty(rc::detail::toProperty(std::move(property)), metadata, params, listener);

  Outcome outcome{.stem = stem_, .sentence = sentence, .kind = kind, .options = options};
  outcome.seed = params.seed;
  outcome.tags = listener.tags;
  outcome.degenerate_share = listener.cases ? double(listener.degenerate_cases) / double(listener.cases) : 0;
  if (result.is<rc::detail::SuccessResult>()) {
    outcome.cases = result.get<rc::detail::SuccessResult>().numSuccess;
    outcome.passed = kind == "holds" && outcome.cases >= params.maxSuccess;
    if (kind == "refuted") outcome.detail = "no counterexample found";
    if (outcome.passed) outcome.detail = complaint_about_shares(outcome);
    outcome.passed = outcome.passed && outcome.detail.empty();
  } else if (result.is<rc::detail::FailureResult>()) {
    const auto& failure = result.get<rc::detail::FailureResult>();
    outcome.cases = failure.numSuccess + 1;
    outcome.detail = describe(failure);
    outcome.passed = kind == "refuted";
  } else if (result.is<rc::detail::GaveUpResult>()) {
    outcome.cases = result.get<rc::detail::GaveUpResult>().numSuccess;
    outcome.detail = "gave up: too many cases were discarded";
  } else {
    outcome.detail = "error: " + result.get<rc::detail::Error>().description;
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  session.add(std::move(outcome));
}

void Suite::example(const std::string& sentence, const Options& options, const std::function<Checked()>& check) {
  Session& session = Session::get();
  const auto start = std::chrono::steady_clock::now();
  session.announce(stem_, sentence);
  Outcome outcome{.stem = stem_, .sentence = sentence, .kind = "example", .options = options};
  outcome.seed = session.seed();
  try {
    const Checked checked = check();
    outcome.passed = checked.passed;
    outcome.skipped = checked.skipped;
    outcome.cases = checked.cases;
    outcome.detail = checked.detail;
  } catch (const std::exception& e) {
    outcome.detail = std::string("threw: ") + e.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  session.add(std::move(outcome));
}

Registration::Registration(const char* stem, SuiteFunction function) { Session::get().suites()[stem].push_back(function); }

}  // namespace proptests
