// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the statements that cases can be about. Each judges a case in exact arithmetic and in intervals.
#pragma once

#include "lemmas/exact/ladder.hpp"
#include "proptests/cases/case_file.hpp"

namespace proptests::cases {

struct Judgement {
  refitlab::Verdict hypotheses = refitlab::Verdict::holds, conclusion;
};

struct Statement {
  // These are the lemma's file, "printed", "repaired" or "beyond", and what is claimed.
  std::string stem, form, claim;
  // The cases of a statement of R^d say which d, of 1 to 4.
  bool has_dimension;
  std::function<Judgement(const Case&)> exact, interval;
};

// Return the statements of Lemmas 1 to 5, and those of section 4 and beyond. judge_refit judges refits.
std::vector<Statement> lemma_statements();
std::vector<Statement> section_statements();
const std::vector<Statement>& statements();

// Returns the statement of a case, or nothing if it is about Algorithm 1. Throws CaseError if there is none, if the case has a
// dimension that the statement has not, or expects what it cannot be.
const Statement* statement_of(const Case& c);

// Holds the judgement of Algorithm 1 on a vertex: "encloses", "misses" or "undefined" (a division by zero), decided by intervals
// of growing precision, at last exactly. interval is what intervals of doubles say: the same, or "undecided".
struct RefitJudgement {
  std::string decided, interval;
};
RefitJudgement judge_refit(const Case& c);

// --- For the definition of statements ---

// Returns the lists after one another.
std::vector<Statement> joined(std::vector<std::vector<Statement>> lists);

// Holds the inputs of a case over the number type S, with points in R^D.
template <class S, int D>
struct Inputs {
  using Number = S;
  Fields fields;

  S number(const char* name) const { return refitlab::lift<S>(fields.number(name)); }
  std::vector<S> numbers(const char* name) const { return refitlab::lift<S>(fields.numbers(name)); }
  auto point(const char* name) const { return refitlab::lift<S>(fields.point<D>(name)); }
  auto points(const char* name) const { return refitlab::lift<S>(fields.points<D>(name)); }
  auto ball(const char* name) const { return refitlab::lift<S>(fields.ball<D>(name)); }
  auto squared_ball(const char* name) const { return refitlab::lift<S>(fields.squared_ball<D>(name)); }
  auto half_space(const char* name) const { return refitlab::lift<S>(fields.half_space<D>(name)); }
  auto cap(const char* name) const { return refitlab::lift<S>(fields.cap<D>(name)); }
  // It may be any quaternion, also 0.
  auto quaternion(const char* name) const { return refitlab::lift<S>(fields.point<4>(name)); }
  auto non_zero_quaternion(const char* name) const { return refitlab::lift<S>(fields.non_zero_quaternion(name)); }
  auto quaternions(const char* name) const { return refitlab::lift<S>(fields.points<4>(name)); }
  auto bounds(const char* name) const { return refitlab::lift<S>(fields.bounds(name)); }
  auto rows(const char* name, std::size_t width) const { return refitlab::lift<S>(fields.rows(name, width)); }
  // Returns one number for each element of another list.
  std::vector<S> numbers(const char* name, std::size_t count) const {
    const Numbers out = fields.numbers(name);
    if (out.size() != count) fields.fail(name, "needs " + std::to_string(count) + " numbers, has " + std::to_string(out.size()));
    return refitlab::lift<S>(out);
  }
};

// Returns a statement about R^3. judge is a function of Inputs<S, D> for every S.
template <class Judge>
Statement in_space(const char* stem, const char* form, const char* claim, Judge judge) {
  return {stem,
          form,
          claim,
          false,
          [=](const Case& c) { return judge(Inputs<Rational, 3>{c.fields()}); },
          [=](const Case& c) { return judge(Inputs<refitlab::Interval, 3>{c.fields()}); }};
}

template <class S, class Judge>
Judgement in_dimension_of(const Case& c, Judge judge) {
  switch (c.dimension) {
    case 1: return judge(Inputs<S, 1>{c.fields()});
    case 2: return judge(Inputs<S, 2>{c.fields()});
    case 3: return judge(Inputs<S, 3>{c.fields()});
    default: return judge(Inputs<S, 4>{c.fields()});
  }
}

// Returns a statement about the R^d of the case.
template <class Judge>
Statement in_any_dimension(const char* stem, const char* form, const char* claim, Judge judge) {
  return {stem,
          form,
          claim,
          true,
          [=](const Case& c) { return in_dimension_of<Rational>(c, judge); },
          [=](const Case& c) { return in_dimension_of<refitlab::Interval>(c, judge); }};
}

}  // namespace proptests::cases
