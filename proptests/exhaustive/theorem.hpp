// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a theorem about all points of a box of parameters, which is proved by cutting the box up until intervals decide.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lemmas/exact/interval.hpp"

namespace proptests::exhaustive {

using refitlab::Interval;

struct Parameter {
  std::string name;
  // These are dyadic numbers with few bits, so that all middles are exact.
  double low, high;
  // It is above 0, and boxes are to be small relative to it.
  bool is_scale = false;
};

enum class Outcome {
  open,    // to be cut
  proved,  // the statement holds at every point of the box
  outside  // no point of the box is among those that the statement is about
};

// Holds what intervals say of a box. excess is an upper bound of how much the smaller side is above the greater one, and shows
// which cut helps most. refuted says that the statement fails at every point of the box.
struct Judgement {
  Outcome outcome;
  double excess;
  bool refuted = false;
};

// Judges whether left <= right at all points of a box.
inline Judgement at_most(const Interval& left, const Interval& right) {
  const Interval excess = left - right;
  return {refitlab::less_equal(left, right) == refitlab::Verdict::holds ? Outcome::proved : Outcome::open, excess.sup(),
          excess.inf() > 0};
}
inline Judgement outside() { return {Outcome::outside, 0}; }
inline bool fails(refitlab::Verdict v) { return v == refitlab::Verdict::fails; }
inline bool holds(refitlab::Verdict v) { return v == refitlab::Verdict::holds; }

struct Theorem {
  std::string name;  // the lemma's stem, and what is said
  std::string statement;
  std::vector<Parameter> parameters;
  double small, real;  // the constant K of a small run, and of a real one
  // The statement is known to be false, or no theorem, for any K below this.
  double needed;
  Judgement (*judge)(std::span<const Interval> at, const Interval& constant);
};

}  // namespace proptests::exhaustive
