// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/session.hpp"

#include <cstdio>
#include <iostream>

namespace proptests {

Session& Session::get() {
  static Session session;
  return session;
}

void Session::announce(const std::string& stem, const std::string& sentence) const {
  std::cout << (is_watched() ? "  [ .... ] " : "  ") << stem << ": " << sentence << std::flush;
}

void Session::progress(long done, long of) const {
  if (!is_watched()) return;
  std::printf("\r  [ %2ld %% ]", 100 * done / of);
  std::fflush(stdout);
}

void Session::add(Outcome o) {
  char summary[96];
  std::snprintf(summary, sizeof summary, "%ld case%s, %.0f %% degenerate, %.2f s", o.cases, o.cases == 1 ? "" : "s",
                100 * o.degenerate_share, o.seconds);
  const char* const verdict = o.skipped ? "[ SKIP ]" : o.passed ? "[  ok  ]" : "[ FAIL ]";
  if (is_watched()) std::cout << "\r  " << verdict << ' ' << o.stem << ": " << o.sentence;
  else std::cout << "  " << verdict;
  std::cout << "  (" << o.kind;
  if (!o.options.form.empty()) std::cout << ", " << o.options.form;
  if (!o.options.number_type.empty()) std::cout << ", " << o.options.number_type;
  std::cout << "; " << summary << ")\n";
  if (!o.detail.empty() && (!o.passed || o.kind != "holds")) std::cout << "           " << o.detail.substr(0, 600) << '\n';
  if (!o.passed && !o.skipped)
    std::cout << "           again: proptests/run --only " << o.stem << " --seed " << seed_
              << (cases_ ? " --cases " + std::to_string(cases_) : "") << '\n';
  std::cout << std::flush;
  outcomes_.push_back(std::move(o));
}

}  // namespace proptests
