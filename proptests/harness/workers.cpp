// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/workers.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "algorithms/results/write_whole.hpp"
#include "proptests/harness/child_process.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Options, form, number_type, cases, max_size, degenerate_at_least, degenerate_at_most,
                                   hypothesis, tags_at_least)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Outcome, stem, sentence, kind, options, passed, skipped, cases, degenerate_share, seed, tags,
                                   detail, seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SuiteResult, outcomes, messages)

namespace {

// Passes numbers of suites between processes. A pipe hands out as few bytes as these whole, whoever asks.
class Numbers {
 public:
  Numbers() {
    if (::pipe(ends_) != 0) throw std::system_error(errno, std::generic_category(), "a pipe between the tests' processes");
  }
  ~Numbers() {
    ::close(ends_[0]);
    no_more();
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  void put(unsigned number) const {
    if (::write(ends_[1], &number, sizeof number) != sizeof number)
      throw std::runtime_error("a pipe between the tests' processes is broken");
  }
  // Says that this process puts no more. Whoever takes then gets nothing when all are taken and no other process can put any.
  void no_more() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  std::optional<unsigned> take() const {
    unsigned number = 0;
    ssize_t read = 0;
    do read = ::read(ends_[0], &number, sizeof number);
    while (read < 0 && errno == EINTR);
    return read == sizeof number ? std::optional(number) : std::nullopt;
  }

 private:
  int ends_[2] = {-1, -1};
};

// Returns a result as JSON text. A failure's detail may hold bytes that are no text, which are replaced.
std::string json_text(const SuiteResult& result) {
  return nlohmann::json(result).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::vector<SuiteResult> run_in_processes(const std::vector<std::string>& stems, int workers,
                                          const std::function<SuiteResult(const std::string&)>& run) {
  const TemporaryFolder folder;
  Numbers waiting, ended;
  const auto work = [&] {
    waiting.no_more();
    while (const auto number = waiting.take()) {
      const std::string& stem = stems[*number];
      if (!std::freopen(folder.file(stem + ".txt").c_str(), "w", stdout)) throw std::runtime_error("cannot redirect the output");
      const SuiteResult result = run(stem);
      std::cout.flush(), std::fflush(stdout);
      refitlab::write_whole(folder.file(stem + ".json"), json_text(result));
      ended.put(*number);
    }
  };
  // Otherwise each process would print it again.
  std::cout.flush(), std::fflush(stdout);
  std::vector<std::unique_ptr<ChildProcess>> processes;
  for (int k = 0; k < workers; ++k) processes.push_back(std::make_unique<ChildProcess>(work));
  for (unsigned number = 0; number < stems.size(); ++number) waiting.put(number);
  waiting.no_more(), ended.no_more();

  std::vector<std::optional<SuiteResult>> results(stems.size());
  std::size_t done = 0;
  while (const auto number = ended.take()) {
    const std::string& stem = stems[*number];
    std::cout << "[" << ++done << "/" << stems.size() << "] " << stem << '\n'
              << refitlab::read_whole(folder.file(stem + ".txt")) << std::flush;
    results[*number] = nlohmann::json::parse(refitlab::read_whole(folder.file(stem + ".json"))).get<SuiteResult>();
  }
  std::vector<SuiteResult> out;
  std::string missing;
  for (std::size_t k = 0; k < stems.size(); ++k) {
    if (results[k]) {
      out.push_back(std::move(*results[k]));
      continue;
    }
    missing += (missing.empty() ? "" : ", ") + stems[k];
    // It had begun.
    if (std::filesystem::exists(folder.file(stems[k] + ".txt")))
      std::cout << stems[k] << '\n' << refitlab::read_whole(folder.file(stems[k] + ".txt")) << std::flush;
  }
  if (!missing.empty())
    throw std::runtime_error("a process of the tests ended before its time; these suites have no result: " + missing);
  return out;
}

}  // namespace proptests
