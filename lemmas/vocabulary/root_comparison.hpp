// SPDX-License-Identifier: MIT
// Comparisons with a square root, in squared form: + - * alone decide them.
#pragma once

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

// a <= sqrt(q), for q >= 0.
template <class S>
Verdict at_most_root(const S& a, const S& q) {
  return less_equal(a, S(0)) | less_equal(sq(a), q);
}

// a sqrt(q) <= b, for q >= 0 and any signs of a and b.
template <class S>
Verdict multiple_of_root_at_most(const S& a, const S& q, const S& b) {
  const S left = sq(a) * q, right = sq(b);
  const Verdict a_up = less_equal(S(0), a), a_down = less_equal(a, S(0));
  const Verdict b_up = less_equal(S(0), b), b_down = less_equal(b, S(0));
  return (a_down & b_up) | (a_up & b_up & less_equal(left, right)) | (a_down & b_down & less_equal(right, left));
}

}  // namespace refitlab
