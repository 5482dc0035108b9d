// SPDX-License-Identifier: GPL-3.0-or-later
// Draws cases that break one part of one hypothesis: the hypothesis must say so, and the conclusion must fail for a share of
// them.
//
// A hypothesis that lost a part is another theorem, and a wrong one. A test sees it only on cases that break just that part.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proptests/gen/any_place.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/rational.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests {

// Says what a case that violates one part of a hypothesis, and no other, makes of the theorem.
struct Weakening {
  Weakening(std::string p, refitlab::Verdict h, std::optional<refitlab::Verdict> c)
      : part(std::move(p)),
        hypothesis(h),
        conclusion(c) {}
  Weakening(refitlab::Verdict h, refitlab::Verdict c) : hypothesis(h), conclusion(c) {}
  std::string part;  // what is broken, in words, if there is more than one: "the first quaternion"
  refitlab::Verdict hypothesis;
  // There is none where there is nothing to conclude, or the theorem has room to spare.
  std::optional<refitlab::Verdict> conclusion;
};

// Says how many parts of the hypothesis are broken, and of which share of the cases of each the conclusion fails at least, so that
// the theorem needs it. The share is 0 for a predicate that no theorem comes with.
struct Wanted {
  std::size_t parts;
  double share;
};

// A part is drawn at least this often, and its conclusion is asked for at least this often or never.
inline constexpr long cases_of_a_part = 20;

namespace weakening {

struct Count {
  long drawn = 0, asked = 0, failed = 0;
};
inline constexpr const char *fails = ": the conclusion fails", *holds = ": the conclusion holds",
                            *is_not_asked = ": nothing to conclude";

// Returns how often each part was drawn. The labels are those of needs_each_part().
inline std::map<std::string, Count> counts_of(const std::map<std::string, long>& labels) {
  std::map<std::string, Count> out;
  for (const auto& [label, cases] : labels)
    for (const std::string end : {fails, holds, is_not_asked}) {
      if (!label.ends_with(end)) continue;
      Count& count = out[label.substr(0, label.size() - end.size())];
      count.drawn += cases;
      if (end != is_not_asked) count.asked += cases;
      if (end == fails) count.failed += cases;
    }
  return out;
}

// Returns which part was drawn or asked for too rarely, or with a conclusion that failed too rarely, or nothing. A run of fewer
// cases than the property asks for complains only of parts that it saw often enough.
inline std::string complaint_about(const Wanted& wanted, int cases, const std::map<std::string, long>& labels) {
  const auto counts = counts_of(labels);
  long drawn = 0;
  for (const auto& [part, count] : counts) drawn += count.drawn;
  const bool is_whole = drawn >= cases;
  if (is_whole && counts.size() != wanted.parts)
    return std::to_string(counts.size()) + " parts were broken, not " + std::to_string(wanted.parts);
  for (const auto& [part, count] : counts) {
    const std::string text = part + ": drawn " + std::to_string(count.drawn) + " times, asked for " +
                             std::to_string(count.asked) + " times, and the conclusion fails " + std::to_string(count.failed) +
                             " times";
    const bool is_rare = count.drawn < cases_of_a_part || (count.asked > 0 && count.asked < cases_of_a_part);
    if (is_whole && is_rare) return "too few cases: " + text;
    if (!is_rare && static_cast<double>(count.failed) < wanted.share * static_cast<double>(count.asked))
      return "the conclusion fails too rarely: " + text;
  }
  return "";
}

}  // namespace weakening

// Draws cases that break a part each. The hypothesis must fail on all of them, and the conclusion on at least the wanted share of
// those of each part whose conclusion is asked for. Each part must be seen often enough to judge that.
inline void needs_each_part(Suite& t, const std::string& sentence, const Wanted& wanted, const std::function<Weakening()>& draw,
                            int cases = 300) {
  using refitlab::Verdict;
  const auto complaint = [wanted, cases](const auto& labels) { return weakening::complaint_about(wanted, cases, labels); };
  t.holds(sentence, {.number_type = "rational", .cases = cases, .complaint_about_labels = complaint}, [draw] {
    const Weakening w = draw();
    RC_LOG() << "broken: " << w.part << '\n';
    RC_ASSERT(w.hypothesis == Verdict::fails);
    RC_ASSERT(w.conclusion != Verdict::undecided);
    const bool is_needed = w.conclusion == Verdict::fails;
    RC_TAG(w.part + (!w.conclusion ? weakening::is_not_asked : is_needed ? weakening::fails : weakening::holds));
  });
}

// Does the same of a single part, which draw() does not name.
inline void needs_part(Suite& t, const std::string& part, const std::function<Weakening()>& draw, int cases = 200) {
  const auto named = [part, draw] {
    Weakening w = draw();
    w.part = part;
    return w;
  };
  needs_each_part(t, "the hypothesis needs this part: " + part, {.parts = 1, .share = 0.02}, named, cases);
}

// Does the same of a theorem of R^d: draw(d) breaks the part in one of R^low ... R^high, which is drawn for each case.
template <int low, int high, class Draw>
void needs_part_in(Suite& t, const std::string& part, const Draw& draw, int cases = 200) {
  const auto in_some_dimension = [draw] {
    std::optional<Weakening> w;
    gen::for_some_dimension<low, high>([&](auto d) { w = draw(d); });
    return *w;
  };
  needs_part(t, part, in_some_dimension, cases);
}

// Draws cases, of which at least the given share must be as the sentence says: generic, for example.
inline void reaches_share(Suite& t, const std::string& sentence, double share, const std::function<bool()>& draw) {
  const Options options{.number_type = "rational", .cases = 300, .tags_at_least = {{"as the sentence says", share}}};
  t.holds(sentence, options, [draw] { RC_CLASSIFY(draw(), "as the sentence says"); });
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
  // The first, a middle one or the last may be negative.
  const std::size_t kind = any_place(5);
  const Rational amount = *excess();
  if (kind > 1 && n > 1) {
    const std::size_t other = (k + 1 + any_place(n - 1)) % n;
    const Rational given = w[k] + amount;
    w[k] -= given, w[other] += given;
    return {place(k, n) + " of the weights is negative", std::move(w)};
  }
  if (kind == 0) {
    const Rational rest = amount > Rational(1) ? Rational(0) : Rational(Rational(1) - amount);
    for (auto& x : w) x *= rest;
    return {"the weights' sum is less than 1", std::move(w)};
  }
  w[k] += amount;
  return {"the weights' sum is more than 1", std::move(w)};
}

}  // namespace gen
}  // namespace proptests
