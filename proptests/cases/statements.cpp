// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/cases/statements.hpp"

#include "algorithms/methods/refit/algorithm1_printed.hpp"
#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/refits/refit_ladder.hpp"

namespace proptests::cases {
namespace {

using namespace refitlab;

// Algorithm 1 has two printed claims: one with the signs of line 3, and one with the skinning's.
const char* const of_matrices = "ball_encloses_vertex";
const char* const of_skinning = "ball_encloses_vertex_with_skinning_signs";

template <Signs signs>
struct Printed {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    RefitLists<S> lists;
    return refit_algorithm1_printed<MeanBalls>(node, signs, lists);
  }
  static RigidTransform<Rational> seen(RigidTransform<Rational> c) {
    if (signs == Signs::of_matrices) c.rotation = matrix_to_quaternion(c.rotation);
    return c;
  }
};

struct Repaired {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    RefitLists<S> lists;
    return refit_algorithm1_repaired<MeanBalls>(node, lists);
  }
};

gen::RefitCase as_refit_case(const SyntheticCase& query) {
  gen::RefitCase out{query.reference, {}};
  for (const SyntheticSet& set : query.sets) out.sets.push_back({set.palette, {set.bounds, set.weight_vertices}});
  return out;
}

// Says whether a weight vertex of the printed algorithm blends to 0 (line 9), or the mean of the normalised blends is 0 (line
// 12).
template <Signs signs>
bool divides_by_zero(const SyntheticCase& query) {
  for (const SyntheticSet& set : query.sets) {
    OwnedPaletteEntry<Rational> seen = set.palette;
    for (auto& c : seen.transforms) c = Printed<signs>::seen(c);
    Vec<ExactRoot, 4> sum = Vec<ExactRoot, 4>::Constant(ExactRoot(0));
    for (const auto& weight_vertex : set.weight_vertices) {
      const Quaternion blend = blend_quaternion<Rational>(seen, weight_vertex);
      if (squared_norm(blend) == 0) return true;
      const Vec<ExactRoot, 4> lifted = lift<ExactRoot>(blend);
      sum = sum + lifted / root(squared_norm(lifted));
    }
    if (squared_norm(sum) == ExactRoot(0)) return true;
  }
  return false;
}

std::string word(Verdict v) { return v == Verdict::holds ? "encloses" : v == Verdict::fails ? "misses" : "undecided"; }

template <class Refit>
RefitJudgement judge(const gen::RefitCase& c, const Point<3>& vertex, std::optional<oracle::RootBall> squared_form) {
  oracle::RefitLadder ladder(c, Refit{}, std::move(squared_form));
  return {word(ladder.encloses(vertex).verdict),
          word(encloses(Refit{}(gen::NodeOf<Interval>(c).node()), lift<Interval>(vertex)))};
}

template <Signs signs>
RefitJudgement judge_printed(const RefitInput& input, const gen::RefitCase& c, const Point<3>& vertex) {
  RefitJudgement out = judge<Printed<signs>>(c, vertex, std::nullopt);
  if (divides_by_zero<signs>(input.query)) out.decided = "undefined";
  return out;
}

}  // namespace

std::vector<Statement> joined(std::vector<std::vector<Statement>> lists) {
  std::vector<Statement> out;
  for (auto& list : lists) out.insert(out.end(), std::make_move_iterator(list.begin()), std::make_move_iterator(list.end()));
  return out;
}

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = joined({lemma_statements(), section_statements()});
  return all;
}

const Statement* statement_of(const Case& c) {
  const auto fail = [&](const std::string& reason) { throw CaseError(c.file + ": case '" + c.name + "': " + reason); };
  const auto expects = [&](std::initializer_list<const char*> words) {
    std::string known;
    for (const char* w : words) {
      if (c.expected == w) return;
      known += (known.empty() ? "" : ", ") + std::string(w);
    }
    fail("'expected' is '" + c.expected + "', must be one of: " + known);
  };
  if (c.statement == "algorithm1") {
    if (!(c.form == "repaired" && c.claim == of_matrices) &&
        !(c.form == "printed" && (c.claim == of_matrices || c.claim == of_skinning)))
      fail("unknown statement: algorithm1 has no " + c.form + " claim '" + c.claim + "'");
    expects({"encloses", "misses", "undefined"});
    return nullptr;
  }
  std::string known;
  for (const Statement& s : statements()) {
    if (s.stem != c.statement) continue;
    known += (known.empty() ? "" : ", ") + s.form + " " + s.claim;
    if (s.form != c.form || s.claim != c.claim) continue;
    if (s.has_dimension && c.dimension == 0) fail("'dimension' is missing: the statement is one of R^d");
    if (!s.has_dimension && c.dimension != 0) fail("'dimension' is given, but the statement is not one of R^d");
    expects({"holds", "fails"});
    return &s;
  }
  if (known.empty()) fail("unknown statement '" + c.statement + "'");
  fail("unknown statement: " + c.statement + " has no " + c.form + " claim '" + c.claim + "'; there are: " + known);
  return nullptr;
}

RefitJudgement judge_refit(const Case& c) {
  const RefitInput input = read_refit(c.fields());
  const gen::RefitCase refit = as_refit_case(input.query);
  const Point<3> vertex = *gen::skinned(refit, {input.joint_set, input.weights, input.position}, gen::Blending::spherical);
  if (c.form == "repaired") return judge<Repaired>(refit, vertex, oracle::repaired_ball(refit, oracle::Gather::at_mean));
  return c.claim == of_skinning ? judge_printed<Signs::of_skinning>(input, refit, vertex)
                                : judge_printed<Signs::of_matrices>(input, refit, vertex);
}

}  // namespace proptests::cases
