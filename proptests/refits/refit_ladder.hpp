// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a refitted ball encloses a rational point. The refit itself runs in ever more precise intervals, and at last,
// for points on its surface, its ball in squared form is asked.
#pragma once

#include <map>
#include <optional>

#include "lemmas/exact/ladder.hpp"
#include "proptests/refits/root_ball.hpp"

namespace proptests::oracle {

// Refit is callable with a RefitNode<S> for every interval type S. Each rung's ball is computed when first asked for.
template <class Refit>
class RefitLadder {
 public:
  // exact is the same ball in squared form, where there is one.
  RefitLadder(const gen::RefitCase& c, Refit refit, std::optional<RootBall> exact = std::nullopt)
      : case_(c),
        refit_(refit),
        exact_(std::move(exact)) {}

  // Returns the decision, which is undecided only if the point is on the surface up to 60 digits and there is no squared form.
  refitlab::Decision encloses(const gen::RationalVec<3>& point) {
    using namespace refitlab;
    if (const Verdict v = on_rung(interval_, point); v != Verdict::undecided) return {v, Rung::interval};
    if (const Verdict v = on_rung(multiprecision_, point); v != Verdict::undecided) return {v, Rung::multiprecision_interval};
    return {exact_ ? verdict_of(oracle::encloses(*exact_, point)) : Verdict::undecided, Rung::exact};
  }

 private:
  template <class S>
  refitlab::Verdict on_rung(std::optional<refitlab::Ball3<S>>& ball, const gen::RationalVec<3>& point) {
    if (!ball) ball = refit_(gen::NodeOf<S>(case_).node());
    return refitlab::encloses(*ball, refitlab::lift<S>(point));
  }

  const gen::RefitCase& case_;
  Refit refit_;
  std::optional<RootBall> exact_;
  std::optional<refitlab::Ball3<refitlab::Interval>> interval_;
  std::optional<refitlab::Ball3<refitlab::MultiprecisionInterval>> multiprecision_;
};

// Counts how many points each rung decided, and how many none did.
struct RungTally {
  static constexpr const char* none = "none, on the surface to 60 digits";
  std::map<std::string, long> counts;

  void add(const refitlab::Decision& d) { ++counts[d.verdict == refitlab::Verdict::undecided ? none : name_of(d.rung)]; }
  long total() const;
  double share(const std::string& name) const;
  std::string text() const;  // "interval 91.2 %, ..."
};

}  // namespace proptests::oracle
