// SPDX-License-Identifier: GPL-3.0-or-later
// Draws cases that break one part of one hypothesis: the hypothesis must say so, and the conclusion must fail for a share of
// them.
//
// A hypothesis that lost a part is another theorem, and a wrong one. A test sees it only on cases that break just that part.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proptests/gen/any_place.hpp"
#include "proptests/gen/rational.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests {

struct Weakening {
  std::string part;  // what is broken, in words: "the first quaternion"
  refitlab::Verdict hypothesis;
  // There is none where there is nothing to conclude, or the theorem has room to spare.
  std::optional<refitlab::Verdict> conclusion;
};

// Draws cases that break a part each. The hypothesis must fail on all of them, and the conclusion on at least the given share of
// those of each part, so that the theorem needs it. Nothing is required of a part whose conclusion was asked for less than 20
// times, nor of any part if the share is 0, for a predicate that no theorem comes with.
template <class Draw>
void needs_each_part(Suite& t, const std::string& sentence, double share, const Draw& draw, int cases = 300) {
  using refitlab::Verdict;
  struct Count {
    long drawn = 0, asked = 0, failed = 0;
  };
  std::map<std::string, Count> counts;
  t.holds(sentence, {.number_type = "rational", .cases = cases}, [&] {
    const Weakening w = draw();
    RC_LOG() << "broken: " << w.part << '\n';
    RC_ASSERT(w.hypothesis == Verdict::fails);
    auto& count = counts[w.part];
    ++count.drawn;
    if (!w.conclusion) return;
    RC_ASSERT(*w.conclusion != Verdict::undecided);
    ++count.asked, count.failed += *w.conclusion == Verdict::fails;
  });
  if (share <= 0) return;
  t.example(sentence + ": and then the conclusion may fail", {}, [&] {
    bool ok = !counts.empty();
    long drawn = 0;
    std::string text = "the conclusion fails";
    for (const auto& [part, count] : counts) {
      ok = ok && (count.asked < 20 || static_cast<double>(count.failed) >= share * static_cast<double>(count.asked));
      drawn += count.drawn;
      text +=
          (drawn == count.drawn ? ": " : "; ") + part + " " + std::to_string(count.failed) + " of " + std::to_string(count.asked);
      if (count.asked < count.drawn) text += " (" + std::to_string(count.drawn - count.asked) + " not asked)";
    }
    return Checked(ok, drawn, text);
  });
}

// Draws cases, of which at least the given share must be as the sentence says: generic, for example.
template <class Draw>
void reaches_share(Suite& t, const std::string& sentence, double share, const Draw& draw, int cases = 300) {
  long drawn = 0, reached = 0;
  t.holds(sentence, {.number_type = "rational", .cases = cases}, [&] {
    const bool is = draw();
    ++drawn, reached += is;
  });
  t.example(sentence + ": often enough", {}, [&] {
    return Checked(static_cast<double>(reached) >= share * static_cast<double>(drawn), drawn,
                   std::to_string(reached) + " of " + std::to_string(drawn));
  });
}

namespace gen {

// Returns a place of a list, in words.
inline std::string place(std::size_t k, std::size_t n) { return k == 0 ? "the first" : k + 1 == n ? "the last" : "a middle one"; }

// Draws by how much an inequality is missed: plainly, or by what no double would see.
inline rc::Gen<Rational> excess() {
  return rc::gen::oneOf(positive_rational(),
                        rc::gen::element(Rational(1, 1000), Rational(std::string("1/1000000000000000000000000000000"))));
}

// Holds weights that are convex but for one thing.
struct BrokenWeights {
  std::string part;
  std::vector<Rational> weights;
};
inline BrokenWeights broken_weights(std::vector<Rational> w) {
  const std::size_t n = w.size(), k = any_place(n);
  const std::size_t kind = any_place(3);
  const Rational amount = *excess();
  if (kind == 0 && n > 1) {
    const std::size_t other = (k + 1 + any_place(n - 1)) % n;
    const Rational given = w[k] + amount;
    w[k] -= given, w[other] += given;
    return {place(k, n) + " of the weights is negative", std::move(w)};
  }
  if (kind == 1) {
    const Rational rest = amount > Rational(1) ? Rational(0) : Rational(Rational(1) - amount);
    for (auto& x : w) x *= rest;
    return {"the weights' sum is less than 1", std::move(w)};
  }
  w[k] += amount;
  return {"the weights' sum is more than 1", std::move(w)};
}

}  // namespace gen
}  // namespace proptests
