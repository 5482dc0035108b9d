// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the file of cases: every case has its verdict, every pinned counterexample its case, and bad files get clear errors.
#include <map>
#include <set>

#include "algorithms/results/write_whole.hpp"
#include "proptests/cases/pinned_inputs.hpp"
#include "proptests/cases/statements.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_cases {
namespace {

using namespace refitlab;
using namespace proptests::cases;

// The path is relative to the root of the repository, from where the tests are run.
const char* const file = "proptests/cases/cases.json";

const std::vector<Case>& all_cases() {
  static const std::vector<Case> list = read_cases(file, [](const Case& c) { statement_of(c); });
  return list;
}

std::string quoted(const Case& c) { return "'" + c.name + "'"; }

// Returns what is wrong with a case of a lemma, or nothing.
std::string complaint(const Case& c, const Statement& s) {
  const Judgement exact = s.exact(c), interval = s.interval(c);
  const Verdict expected = verdict_of(c.expected == "holds"), met = verdict_of(c.without.empty());
  if (exact.hypotheses != met) return quoted(c) + (c.without.empty() ? " does not meet" : " meets") + " the hypotheses; ";
  if (exact.conclusion != expected) return quoted(c) + " " + name_of(exact.conclusion) + "; ";
  const auto contradicts = [](Verdict a, Verdict b) { return a != Verdict::undecided && a != b; };
  if (contradicts(interval.hypotheses, exact.hypotheses) || contradicts(interval.conclusion, exact.conclusion))
    return quoted(c) + " is contradicted by intervals; ";
  return "";
}

std::string complaint_about_refit(const Case& c) {
  const RefitJudgement j = judge_refit(c);
  if (j.decided != c.expected) return quoted(c) + " is decided as " + j.decided + "; ";
  if (j.interval != "undecided" && j.interval != j.decided) return quoted(c) + " " + j.interval + " by intervals; ";
  return "";
}

Checked check_all(const std::vector<Case>& list) {
  std::string complaints;
  for (const Case& c : list) {
    const Statement* s = statement_of(c);
    complaints += s ? complaint(c, *s) : complaint_about_refit(c);
  }
  return Checked(complaints.empty(), static_cast<long>(list.size()), complaints);
}

// Checks that each claim has a case, and that each form of a statement has one if it has a printed and a repaired form.
Checked check_coverage() {
  std::set<std::string> claims, forms;
  std::map<std::string, std::set<std::string>> forms_of;
  for (const Case& c : all_cases()) {
    claims.insert(c.statement + " " + c.form + " " + c.claim);
    if (c.without.empty()) forms.insert(c.statement + " " + c.form);
    forms_of[c.statement].insert(c.form);
  }
  std::string missing;
  for (const Statement& s : statements()) {
    if (!claims.count(s.stem + " " + s.form + " " + s.claim)) missing += s.stem + " " + s.form + " " + s.claim + "; ";
    if (!forms.count(s.stem + " " + s.form)) missing += s.stem + " " + s.form + " with its hypotheses; ";
  }
  if (forms_of["algorithm1"] != std::set<std::string>{"printed", "repaired"}) missing += "algorithm1; ";
  return Checked(missing.empty(), static_cast<long>(statements().size()), missing.empty() ? "" : "without a case: " + missing);
}

// --- Bad files ---

// This is a good case whose text is spoiled by replacing one part with another.
const std::string lemma_case = R"({"format": "refitlab cases 1", "cases": [{"name": "a", "statement": "t3_one_cap",
  "form": "beyond", "claim": "cap_holds_blend", "inputs": {"quaternions": [["1", "0", "0", "0"], ["1", "1", "0", "0"]],
  "axis": ["1", "0", "0", "0"], "squared_cosine": "1/2", "coefficients": ["1/2", "1/2"]},
  "expected": "holds", "note": "n"}]})";
const std::string circle_case =
    R"({"format": "refitlab cases 1", "cases": [{"name": "a", "statement": "s43_distance_range",
  "form": "repaired", "claim": "distance_is_in_range", "dimension": 2, "inputs": {"center": ["2", "0"], "radius": "1"},
  "expected": "holds", "note": "n"}]})";
const std::string refit_case = R"({"format": "refitlab cases 1", "cases": [{"name": "a", "statement": "algorithm1",
  "form": "repaired", "claim": "ball_encloses_vertex",
  "inputs": {"reference": {"center": ["1", "0", "0"], "radius": "0"},
  "joint_sets": [{"transforms": [{"rotation": ["1", "0", "0", "0"], "translation": ["0", "0", "0"]},
  {"rotation": ["-1", "0", "0", "0"], "translation": ["0", "0", "0"]}], "rotation_center": ["0", "0", "0"],
  "bounds": {"low": ["0", "0"], "high": ["1", "1"]}}],
  "vertex": {"joint_set": 0, "weights": ["3/4", "1/4"], "position": ["1", "0", "0"]}},
  "expected": "encloses", "note": "n"}]})";

struct Spoiled {
  std::string text, from, to;
  std::vector<std::string> words;  // of the error
};

std::string error_of(const std::string& text) {
  try {
    const Checked judged = check_all(parse_cases(text, "bad.json", [](const Case& c) { statement_of(c); }));
    return judged.passed ? "" : "judged: " + judged.detail;
  } catch (const CaseError& e) {
    return e.what();
  }
}

// Returns a file whose only case is the first case of a claim, changed.
std::string changed_case(const std::string& claim, const std::function<void(Json&)>& change) {
  Json whole = Json::parse(read_whole(file));
  for (Json c : Json(whole["cases"]))
    if (c["claim"] == claim && c["statement"] != "algorithm1") {
      c["name"] = "a";
      change(c["inputs"]);
      whole["cases"] = Json::array({c});
      return whole.dump();
    }
  return "";
}

std::vector<Spoiled> spoiled_cases() {
  const std::string in_case = "bad.json: case 'a'";
  return {
      {lemma_case, "{\"format\"", "\"format\"", {"bad.json", "malformed JSON", "line 1"}},
      {lemma_case, "refitlab cases 1", "cases", {"bad.json", "'format'"}},
      {lemma_case, "\"note\": \"n\"", "\"nota\": \"n\"", {in_case, "'note' is missing"}},
      {lemma_case, "\"squared_cosine\": \"1/2\", ", "", {in_case, "'squared_cosine' is missing"}},
      {lemma_case, "\"1/2\", \"coef", "\"1/0\", \"coef", {in_case, "squared_cosine", "zero denominator"}},
      {lemma_case, "\"1/2\", \"coef", "0.5, \"coef", {in_case, "squared_cosine", "numbers are strings"}},
      {lemma_case, "\"1/2\", \"coef", "\"1/-2\", \"coef", {in_case, "squared_cosine", "no number"}},
      {lemma_case, "\"1/2\", \"coef", "\"\", \"coef", {in_case, "squared_cosine", "no number"}},
      {lemma_case, "\"axis\": [\"1\"", "\"axis\": [\"0\"", {in_case, "'axis'", "zero quaternion"}},
      {lemma_case,
       "[\"1\", \"1\", \"0\", \"0\"]",
       "[\"1\", \"1\", \"0\"]",
       {in_case, "quaternions[1]", "needs 4 numbers, has 3"}},
      {lemma_case, "[\"1/2\", \"1/2\"]", "[\"1\"]", {in_case, "'coefficients'", "needs 2 numbers, has 1"}},
      {lemma_case, "t3_one_cap", "t3_two_caps", {in_case, "unknown statement 't3_two_caps'"}},
      {lemma_case, "cap_holds_blend", "cap_holds", {in_case, "no beyond claim 'cap_holds'", "cap_holds_blend"}},
      {lemma_case, "\"expected\": \"holds\"", "\"expected\": \"encloses\"", {in_case, "'expected'", "holds, fails"}},
      {lemma_case, "\"claim\"", "\"dimension\": 4, \"claim\"", {in_case, "not one of R^d"}},
      {circle_case, "\"dimension\": 2, ", "", {in_case, "'dimension' is missing"}},
      {circle_case, "\"dimension\": 2", "\"dimension\": 5", {in_case, "'dimension'", "1 to 4"}},
      {circle_case, "[\"2\", \"0\"]", "[\"2\", \"0\", \"0\"]", {in_case, "'center'", "needs 2 coordinates, has 3"}},
      {refit_case, "[\"-1\", \"0\"", "[\"0\", \"0\"", {in_case, "transforms[1]", "'rotation'", "zero quaternion"}},
      {refit_case, "[\"-1\", \"0\"", "[\"-1\", \"1\"", {in_case, "transforms[1]", "not of unit length"}},
      {refit_case, "[\"3/4\", \"1/4\"]", "[\"3/4\", \"1/2\"]", {in_case, "'weights'", "off the simplex"}},
      {refit_case, "[\"3/4\", \"1/4\"]", "[\"5/4\", \"-1/4\"]", {in_case, "'weights'", "off the simplex"}},
      {refit_case, "[\"3/4\", \"1/4\"]", "[\"1/2\", \"1/2\"]", {in_case, "'weights'", "blend to the zero quaternion"}},
      {refit_case,
       "\"high\": [\"1\", \"1\"]",
       "\"high\": [\"1/2\", \"1\"]",
       {in_case, "'weights'", "outside the joint-set's bounds"}},
      {refit_case, "\"high\": [\"1\", \"1\"]", "\"high\": [\"1/4\", \"1/4\"]", {in_case, "'bounds'", "no weights through"}},
      {refit_case, "\"high\": [\"1\", \"1\"]", "\"high\": [\"1\"]", {in_case, "'bounds'", "as many low as high"}},
      {refit_case, "\"joint_set\": 0", "\"joint_set\": 1", {in_case, "'joint_set'", "0 to 0"}},
      {refit_case, "\"position\": [\"1\"", "\"position\": [\"2\"", {in_case, "'position'", "outside the reference ball"}},
      {refit_case, "\"radius\": \"0\"", "\"radius\": \"-1\"", {in_case, "'reference'", "negative radius"}},
      {refit_case, "\"joint_sets\": [", "\"joint_sets\": [1, ", {in_case, "joint_sets[0]", "not an object"}},
      {refit_case, "\"joint_sets\": [{", "\"joint_sets\": [], \"x\": [{", {in_case, "'joint_sets'", "one or more objects"}},
      {refit_case, "\"low\": [\"0\", \"0\"]", "\"low\": \"0\"", {in_case, "'low'", "not a list of numbers"}},
      {refit_case,
       "\"low\": [\"0\", \"0\"], \"high\": [\"1\", \"1\"]",
       "\"low\": [\"0\"], \"high\": [\"1\"]",
       {in_case, "'bounds' are of 1 weights, the transforms of 2"}},
      {refit_case, "[\"3/4\", \"1/4\"]", "[\"1\"]", {in_case, "'weights'", "needs 2 weights, has 1"}},
      {refit_case, "ball_encloses_vertex", "ball_is_empty", {in_case, "algorithm1 has no repaired claim 'ball_is_empty'"}},
      {lemma_case, "\"note\": \"n\"", "\"note\": 1", {in_case, "'note' is not a text"}},
      {lemma_case,
       "[[\"1\", \"0\", \"0\", \"0\"], [\"1\", \"1\", \"0\", \"0\"]]",
       "[]",
       {in_case, "'quaternions'", "lists of numbers"}},
      {lemma_case,
       "\"axis\": [",
       "\"deep\": " + std::string(40, '[') + std::string(40, ']') + ", \"axis\": [",
       {"bad.json", "nested more than 32 deep"}},
  };
}

// Returns a list in JSON of so many equal parts, without its brackets.
std::string repeated(const std::string& part, int times) {
  std::string out = part;
  for (int i = 1; i < times; ++i) out += ", " + part;
  return out;
}

// Returns a case of 24 joints with weights in [0, 1/12], which have 24 choose 12 weight vertices.
std::string case_of_many_weight_vertices() {
  std::string many = refit_case;
  const auto put = [&](const std::string& from, const std::string& to) { many.replace(many.find(from), from.size(), to); };
  put("{\"rotation\": [\"1\"",
      repeated("{\"rotation\": [\"1\", \"0\", \"0\", \"0\"], \"translation\": [\"0\", \"0\", \"0\"]}", 22) +
          ", {\"rotation\": [\"1\"");
  put("[\"0\", \"0\"], \"high\": [\"1\", \"1\"]",
      "[" + repeated("\"0\"", 24) + "], \"high\": [" + repeated("\"1/12\"", 24) + "]");
  return many;
}

// Returns texts of cases that are spoiled in more than one place, with words of the error.
std::vector<std::pair<std::string, std::string>> cases_of_other_counts() {
  const auto drop_last = [](Json& list) { list.erase(list.size() - 1); };
  const std::string few_points =
      changed_case("linear_part_in_hull", [&](Json& inputs) { drop_last(inputs["points"]), drop_last(inputs["weights"]); });
  const std::string few_joints = changed_case("ball_encloses_vertex", [&](Json& inputs) {
    Json& sets = inputs["joint_sets"];
    sets.push_back(sets[0]);
    drop_last(sets.back()["transforms"]);
    for (Json& weight_vertex : sets.back()["weight_vertices"]) drop_last(weight_vertex);
  });
  const std::string double_name =
      lemma_case.substr(0, lemma_case.size() - 2) + ", " + lemma_case.substr(lemma_case.find("[{") + 1);
  return {{case_of_many_weight_vertices(), "'bounds' have more than 100000 weight vertices"},
          {few_points, "'points' are not one for each weight"},
          {few_joints, "'transforms' are not as many as those of the first"},
          {double_name, "not the only one"}};
}

Checked check_refusals() {
  const std::vector<Spoiled> list = spoiled_cases();
  std::string wrong;
  for (const Spoiled& s : list) {
    std::string text = s.text;
    const std::size_t at = text.find(s.from);
    if (at == std::string::npos) return Checked(false, 1, "nothing to spoil: " + s.from);
    const std::string error = error_of(text.replace(at, s.from.size(), s.to));
    for (const auto& word : s.words)
      if (error.find(word) == std::string::npos) wrong += s.from + " -> " + s.to + ": no '" + word + "' in '" + error + "'; ";
  }
  for (const auto& [text, words] : cases_of_other_counts())
    if (const std::string error = error_of(text); error.find(words) == std::string::npos)
      wrong += "no '" + words + "' in '" + error + "'; ";
  try {
    read_cases("no such file.json");
    wrong += "a file that is not there was read";
  } catch (const CaseError& e) {
    if (std::string(e.what()) != "no such file.json: cannot be read") wrong += e.what();
  }
  return Checked(wrong.empty(), static_cast<long>(list.size()) + 2, wrong);
}

}  // namespace

PROPTEST(cases) {
  const Options options{.number_type = "rational and interval"};
  t.example("every case of the file has its expected verdict, exactly, and intervals never contradict it", options,
            [] { return check_all(all_cases()); });
  t.example("each pinned counterexample is a case of the file, which --write-cases leaves as it is", {.number_type = "rational"},
            [] {
              const std::string text = read_whole(file);
              return Checked(with_pinned_inputs(text) == text, static_cast<long>(pinned_inputs().size()),
                             "proptests --write-cases changes it");
            });
  t.example("every claim has a case, and every form of a statement has one that meets its hypotheses", {}, check_coverage);
  t.example("the cases to be spoiled are good, and a wrong expectation is noticed", options, [] {
    std::string wrong = lemma_case;
    wrong.replace(wrong.find("\"holds\""), 7, "\"fails\"");
    return error_of(lemma_case).empty() && error_of(circle_case).empty() && error_of(refit_case).empty() &&
           error_of(wrong).find("judged: 'a' holds") == 0;
  });
  t.example("a bad file is refused with the file, the case and the reason", {}, check_refusals);
  t.example("the cases can be printed: each with its name, its inputs and its verdict", {}, [] {
    const std::string text = as_markdown(all_cases());
    for (const Case& c : all_cases())
      if (text.find("### " + c.name + "\n\n" + c.note) == std::string::npos) return Checked(false, 1, c.name);
    return Checked(text.find("- cap: [center = (0, 0), apex = (1, 0), cos_angle = -3/5]\n- point: (1, 0)\n\n"
                             "The printed claim *ball_encloses_cap* **fails**.") != std::string::npos,
                   static_cast<long>(all_cases().size()));
  });
}

}  // namespace proptests::suite_cases
