// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/exact/ladder.hpp"

#include "lemmas/vocabulary/root_comparison.hpp"
#include "proptests/gen/rational.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_ladder {
namespace {

using namespace refitlab;

bool holds_number(const Interval& i, const Rational& x) { return Rational(i.inf()) <= x && x <= Rational(i.sup()); }

bool holds_number(const MultiprecisionInterval& i, const Rational& x) {
  return mpfr_cmp_q(&i.backend().data()->left, x.mpq()) <= 0 && mpfr_cmp_q(&i.backend().data()->right, x.mpq()) >= 0;
}

template <class S>
void encloses_all_operations(const Rational& x, const Rational& y) {
  const S a = lift<S>(x), b = lift<S>(y);
  RC_ASSERT(holds_number(a, x));
  RC_ASSERT(holds_number(a + b, x + y));
  RC_ASSERT(holds_number(a - b, x - y));
  RC_ASSERT(holds_number(a * b, x * y));
  RC_ASSERT(holds_number(sq(a), x * x));
  RC_ASSERT(holds_number(root(sq(a)), x < Rational(0) ? Rational(-x) : x));
  RC_ASSERT(holds_number(max_of(a, b), max_of(x, y)));
  RC_ASSERT(holds_number(min_of(a, b), min_of(x, y)));
  if (y != Rational(0)) RC_ASSERT(holds_number(a / b, x / y));
  for (const auto& [quick, exact] :
       {std::pair{less(a, b), less(x, y)}, {less_equal(a, b), less_equal(x, y)}, {equal(a, b), equal(x, y)}})
    RC_ASSERT((quick == exact || quick == Verdict::undecided));
}

const auto at_most = [](const auto& x, const auto& y) { return less_equal(x, y); };

PROPTEST(ladder) {
  t.holds("an interval of doubles encloses the result of every operation", {.number_type = "interval", .cases = 3000}, [] {
    const Rational x = *gen::rational().as("x"), y = x + *gen::nudge().as("nudge"), z = *gen::rational().as("z");
    encloses_all_operations<Interval>(x, y);
    encloses_all_operations<Interval>(x, z);
  });
  t.holds("an interval of 60 digits encloses the result of every operation",
          {.number_type = "multiprecision interval", .cases = 3000}, [] {
            const Rational x = *gen::rational().as("x"), y = x + *gen::nudge().as("nudge"), z = *gen::rational().as("z");
            encloses_all_operations<MultiprecisionInterval>(x, y);
            encloses_all_operations<MultiprecisionInterval>(x, z);
          });
  t.holds("a comparison with a root in squared form is the comparison with the root",
          {.number_type = "exact root", .cases = 500, .degenerate_at_least = 0.1}, [] {
            const Rational a = *gen::rational().as("a"), k = *gen::rational().as("k");
            const bool tie = *rc::gen::arbitrary<bool>().as("tie");
            const Rational q = tie ? Rational(k * k) : *gen::positive_rational().as("q"), b = tie ? Rational(a * k) : k;
            RC_CLASSIFY(tie || a == Rational(0), "degenerate");
            const ExactRoot rooted = lift<ExactRoot>(a) * root(lift<ExactRoot>(q));
            RC_ASSERT((multiple_of_root_at_most(a, q, b) == less_equal(rooted, lift<ExactRoot>(b))));
            RC_ASSERT((at_most_root(b, q) == less_equal(lift<ExactRoot>(b), root(lift<ExactRoot>(q)))));
          });

  t.example("each rung decides what the one below cannot", {}, [] {
    Rational tiny(1), minute(1);
    for (int i = 0; i < 30; ++i) tiny /= Rational(10);
    for (int i = 0; i < 90; ++i) minute /= Rational(10);
    const Rational third(1, 3);
    const auto rung = [&](const Rational& x, const Rational& y, Verdict expected) {
      const Decision decision = decide(at_most, x, y);
      return decision.verdict == expected ? static_cast<int>(decision.rung) : -1;
    };
    return rung(third, 1, Verdict::holds) == static_cast<int>(Rung::interval) &&
           rung(1, third, Verdict::fails) == static_cast<int>(Rung::interval) &&
           rung(third + tiny, third, Verdict::fails) == static_cast<int>(Rung::multiprecision_interval) &&
           rung(third, third + tiny, Verdict::holds) == static_cast<int>(Rung::multiprecision_interval) &&
           rung(third + minute, third, Verdict::fails) == static_cast<int>(Rung::exact) &&
           rung(third, third, Verdict::holds) == static_cast<int>(Rung::exact);
  });
  t.example("what is divided by 0, or the root of a negative number, decides nothing", {}, [] {
    const auto undecided = []<class S>(const S& one) {
      const S zero = one - one;
      return less(S(one / zero), one) == Verdict::undecided && less(S(zero / zero), one) == Verdict::undecided &&
             less(root(S(-one)), one) == Verdict::undecided && equal(root(S(-one)), one) == Verdict::undecided;
    };
    return undecided(Interval(1)) && undecided(MultiprecisionInterval(1));
  });
}

}  // namespace
}  // namespace proptests::suite_ladder
