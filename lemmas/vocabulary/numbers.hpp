// SPDX-License-Identifier: MIT
// Here is what a lemma or a refit may ask of its number type S.
//
// Each statement is one template over S. The same source then runs in float and double (an answer, no claim),
// in interval arithmetic (holds / fails / undecided) and in exact arithmetic (decides). Only + - * / and sqrt are
// needed, because cos(2 arccos d) = 2d^2 - 1 and sin(2 arccos d) = 2d sqrt(1 - d^2).
#pragma once

#include <cmath>
#include <type_traits>

#include "lemmas/vocabulary/verdict.hpp"

namespace refitlab {

// refitlab needs these operations of S beyond the field operations. They are specialised where the generic form is wrong or
// loose. For example, an interval times itself does not know that both factors are the same number.
template <class S>
struct NumberTraits {
  static S square(const S& x) { return x * x; }
  static S sqrt(const S& x) {
    using std::sqrt;
    return sqrt(x);
  }
  static S max(const S& a, const S& b) { return a < b ? b : a; }
  static S min(const S& a, const S& b) { return b < a ? b : a; }
  static Verdict less_equal(const S& a, const S& b) { return verdict_of(a <= b); }
  static Verdict less(const S& a, const S& b) { return verdict_of(a < b); }
  static Verdict equal(const S& a, const S& b) { return verdict_of(a == b); }
  // Orders numbers for pivoting and for picking the farthest point. Any answer is correct; the best one is fast.
  static bool prefer_less(const S& a, const S& b) { return a < b; }
};

// A pack of numbers (algorithms/runtime/packs/pack.hpp) names the type of its numbers NumberTraits<S>::Lane.
template <class S>
concept HasLanes = requires {
  typename NumberTraits<S>::Lane;
};

// Returns a number that float has exactly.
template <class S>
S constant(double x) {
  if constexpr (HasLanes<S>) return S(typename NumberTraits<S>::Lane(x));
  else return S(x);
}
template <class S>
S sq(const S& x) {
  return NumberTraits<S>::square(x);
}
template <class S>
S root(const S& x) {
  return NumberTraits<S>::sqrt(x);
}
template <class S>
S max_of(const S& a, const S& b) {
  return NumberTraits<S>::max(a, b);
}
template <class S>
S min_of(const S& a, const S& b) {
  return NumberTraits<S>::min(a, b);
}
template <class S>
S absolute(const S& x) {
  if constexpr (requires { NumberTraits<S>::absolute(x); }) return NumberTraits<S>::absolute(x);
  else return max_of(x, S(-x));
}
// Returns the first or the second number by a comparison's answer, which is a bool or a mask of lanes
// (algorithms/runtime/packs/pack.hpp).
template <class Mask, class S>
S choose(const Mask& first, const S& a, const S& b) {
  if constexpr (std::is_convertible_v<Mask, bool>) return first ? a : b;
  else return NumberTraits<S>::choose(first, a, b);
}
// Returns whether a comparison holds, in some lane if there are several.
template <class Mask>
bool any_lane(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) return mask;
  else return any_of(mask);
}
template <class S>
Verdict less_equal(const S& a, const S& b) {
  return NumberTraits<S>::less_equal(a, b);
}
template <class S>
Verdict less(const S& a, const S& b) {
  return NumberTraits<S>::less(a, b);
}
// This is an object and not a function, because CGAL has an equal() of its own that would be as good a match for its numbers.
inline constexpr auto equal = []<class S>(const S& a, const S& b) { return NumberTraits<S>::equal(a, b); };
template <class S>
bool prefer_less(const S& a, const S& b) {
  return NumberTraits<S>::prefer_less(a, b);
}

// Returns true only if a < b is beyond doubt in S, which for intervals means for all of their members. It is false for a NaN. Packs
// get an answer for each lane.
template <class S>
auto certainly_less(const S& a, const S& b) {
  if constexpr (HasLanes<S>) return b > a;
  else return less(a, b) == Verdict::holds;
}

}  // namespace refitlab
