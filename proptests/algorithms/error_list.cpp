// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the list of errors is complete. Whether the suites that it names provoke them is checked when they have run
// (main.cpp).
#include "proptests/harness/error_list.hpp"

#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_error_list {
namespace {

const std::vector<ListedError>& list() {
  static const std::vector<ListedError> all = read_error_list("proptests/errors.md");
  return all;
}

Checked none_of(const std::vector<std::string>& complaints) {
  std::string text;
  for (const std::string& complaint : complaints) text += complaint + "; ";
  return {complaints.empty(), static_cast<long>(list().size()), text};
}

}  // namespace

PROPTEST(error_list) {
  t.example("whatever throws an error is on the list", {}, [] { return none_of(unlisted_errors(list())); });
  t.example("every error of the list names a suite that there is, or why it cannot be provoked", {}, [] {
    std::vector<std::string> unknown;
    for (const ListedError& error : list())
      if (!error.suite.starts_with("none: ") && !Session::get().suites().contains(error.suite)) unknown.push_back(error.suite);
    return none_of(unknown);
  });
  t.example("an error that nobody provokes, or lists, is noticed", {}, [] {
    const std::vector<ListedError> some = {{"a: ...: is b", "file", "suite"}};
    const bool seen = unseen_errors(some, {"suite"}, {{"suite", {"x", "a: 1: is b"}}}).empty();
    const bool unseen = unseen_errors(some, {"suite"}, {{"suite", {"a: 1: is c"}}, {"other", {"a: 1: is b"}}}).size() == 1;
    return seen && unseen && unseen_errors(some, {"other"}, {}).empty() && unlisted_errors(some).size() > 50;
  });
  t.example("a pattern is like what has its parts in order", {}, [] {
    return is_like("abc", "abc") && !is_like("abcd", "abc") && is_like("abcd", "ab...") && is_like("abcd", "...cd") &&
           is_like("abcd", "a...d") && !is_like("abcd", "b...d") && !is_like("aba", "ab...ba") && is_like("a1b2c", "a...b...c") &&
           !is_like("a1c2b", "a...b...c");
  });
}

}  // namespace proptests::suite_error_list
