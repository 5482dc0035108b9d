// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/cases/case_file.hpp"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace proptests::cases {
namespace {

using namespace refitlab;

bool is_integer(const std::string& text, bool may_be_negative) {
  const std::size_t start = may_be_negative && !text.empty() && text[0] == '-' ? 1 : 0;
  return text.size() > start && text.find_first_not_of("0123456789", start) == std::string::npos;
}

[[noreturn]] void fail_at(const std::string& where, const std::string& reason) { throw CaseError(where + ": " + reason); }

// Shows a value: objects and lists as they stand in the file, and a list of numbers as a vector.
std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  std::string out;
  if (value.is_array()) {
    for (const Json& x : value) out += (out.empty() ? "" : ", ") + shown(x);
    return "(" + out + ")";
  }
  if (!value.is_object()) return value.dump();
  for (const auto& [key, x] : value.items()) out += (out.empty() ? "" : ", ") + key + " = " + shown(x);
  return "[" + out + "]";
}

SyntheticSet read_set(const Fields& f, const Ball3<Rational>& reference) {
  SyntheticSet set;
  set.reference = f.has("reference") ? f.ball<3>("reference") : reference;
  if (set.reference.radius < 0) f.fail("reference", "has a negative radius");
  set.palette.transforms = f.transforms("transforms");
  const std::size_t n = set.palette.transforms.size();
  place_rotation_center<Rational>(set.palette, f.point<3>("rotation_center"));
  set.bounds = f.bounds("bounds");
  if (set.bounds.low.size() != n)
    f.fail("bounds", "are of " + std::to_string(set.bounds.low.size()) + " weights, the transforms of " + std::to_string(n));
  constexpr std::size_t most_weight_vertices = 100000;
  auto weight_vertices = enumerate_weight_vertices(set.bounds, most_weight_vertices);
  if (!weight_vertices) f.fail("bounds", "have more than " + std::to_string(most_weight_vertices) + " weight vertices");
  set.weight_vertices = std::move(*weight_vertices);
  if (set.weight_vertices.empty()) f.fail("bounds", "let no weights through");
  return set;
}

}  // namespace

Rational parse_rational(const Json& value) {
  if (!value.is_string()) throw CaseError("numbers are strings like \"3/5\", not " + value.dump());
  const std::string text = value.get<std::string>();
  const std::size_t slash = text.find('/');
  const std::string above = text.substr(0, slash), below = slash == std::string::npos ? "1" : text.substr(slash + 1);
  if (!is_integer(above, true) || !is_integer(below, false))
    throw CaseError("'" + text + "' is no number; write an integer or a fraction like \"-3/5\"");
  const CGAL::Gmpz numerator(above), denominator(below);
  if (denominator == 0) throw CaseError("'" + text + "' has a zero denominator");
  return {numerator, denominator};
}

Fields::Fields(const Json& object, std::string where) : object_(&object), where_(std::move(where)) {
  if (!object.is_object()) fail_at(where_, "is not an object");
}

void Fields::fail(const std::string& name, const std::string& reason) const { fail_at(where_, "'" + name + "' " + reason); }

const Json& Fields::value(const std::string& name) const {
  const auto found = object_->find(name);
  if (found == object_->end()) fail(name, "is missing");
  return *found;
}

Fields Fields::object(const std::string& name) const { return Fields(value(name), where_ + "." + name); }

std::vector<Fields> Fields::objects(const std::string& name) const {
  const Json& list = value(name);
  if (!list.is_array() || list.empty()) fail(name, "is not a list of one or more objects");
  std::vector<Fields> out;
  for (const Json& x : list) out.emplace_back(x, where_ + "." + name + "[" + std::to_string(out.size()) + "]");
  return out;
}

std::string Fields::text(const std::string& name) const {
  if (!value(name).is_string()) fail(name, "is not a text");
  return value(name).get<std::string>();
}

int Fields::integer(const std::string& name, int low, int high) const {
  const Json& x = value(name);
  if (!x.is_number_integer() || x < low || x > high)
    fail(name, "is not an integer from " + std::to_string(low) + " to " + std::to_string(high));
  return x.get<int>();
}

Rational Fields::number(const std::string& name) const try { return parse_rational(value(name)); } catch (const CaseError& e) {
  // It is missing.
  if (std::string(e.what()).rfind(where_, 0) == 0) throw;
  fail_at(where_ + "." + name, e.what());
}

Numbers Fields::numbers(const std::string& name) const {
  const Json& list = value(name);
  if (!list.is_array()) fail(name, "is not a list of numbers");
  Numbers out;
  for (const Json& x : list) try {
      out.push_back(parse_rational(x));
    } catch (const CaseError& e) {
      fail_at(where_ + "." + name + "[" + std::to_string(out.size()) + "]", e.what());
    }
  return out;
}

std::vector<Numbers> Fields::rows(const std::string& name, std::size_t width) const {
  const Json& list = value(name);
  if (!list.is_array() || list.empty()) fail(name, "is not a list of one or more lists of numbers");
  std::vector<Numbers> out;
  for (const Json& row : list) {
    const std::string index = name + "[" + std::to_string(out.size()) + "]";
    const Json wrapped{{index, row}};
    out.push_back(Fields(wrapped, where_).numbers(index));
    if (out.back().size() != width)
      fail(index, "needs " + std::to_string(width) + " numbers, has " + std::to_string(out.back().size()));
  }
  return out;
}

Numbers Fields::convex_weights(const std::string& name, std::size_t count) const {
  Numbers w = numbers(name);
  if (w.size() != count) fail(name, "needs " + std::to_string(count) + " weights, has " + std::to_string(w.size()));
  if (is_convex<Rational>(w) != Verdict::holds) fail(name, "is off the simplex: weights are at least 0 and sum to 1");
  return w;
}

Quaternion Fields::non_zero_quaternion(const std::string& name) const {
  const Quaternion q = point<4>(name);
  if (squared_norm(q) == 0) fail(name, "is the zero quaternion, which is no rotation");
  return q;
}

Quaternion Fields::unit_quaternion(const std::string& name) const {
  const Quaternion q = non_zero_quaternion(name);
  if (squared_norm(q) != 1) fail(name, "is not of unit length: its squared length is " + as_text(squared_norm(q)));
  return q;
}

WeightBounds<Rational> Fields::bounds(const std::string& name) const {
  const Fields f = object(name);
  WeightBounds<Rational> out{f.numbers("low"), f.numbers("high")};
  if (out.low.empty() || out.low.size() != out.high.size()) fail(name, "needs as many low as high numbers, and at least one");
  return out;
}

std::vector<RigidTransform<Rational>> Fields::transforms(const std::string& name) const {
  std::vector<RigidTransform<Rational>> out;
  for (const Fields& f : objects(name)) out.push_back({f.unit_quaternion("rotation"), f.point<3>("translation")});
  return out;
}

RefitInput read_refit(const Fields& inputs) {
  RefitInput out;
  out.query.reference = inputs.ball<3>("reference");
  if (out.query.reference.radius < 0) inputs.fail("reference", "has a negative radius");
  for (const Fields& f : inputs.objects("joint_sets")) out.query.sets.push_back(read_set(f, out.query.reference));
  const Fields vertex = inputs.object("vertex");
  out.joint_set = vertex.integer("joint_set", 0, static_cast<int>(out.query.sets.size()) - 1);
  const SyntheticSet& set = out.query.sets[out.joint_set];
  out.weights = vertex.convex_weights("weights", set.palette.transforms.size());
  if (admits<Rational>(set.bounds, out.weights) != Verdict::holds) vertex.fail("weights", "are outside the joint-set's bounds");
  if (squared_norm(blend_quaternion<Rational>(set.palette, out.weights)) == 0)
    vertex.fail("weights", "blend to the zero quaternion, which is no rotation");
  out.position = vertex.point<3>("position");
  if (encloses(out.query.reference, out.position) != Verdict::holds) vertex.fail("position", "is outside the reference ball");
  return out;
}

std::vector<Case> read_cases(const std::string& file, const StatementCheck& check) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw CaseError(file + ": cannot be read");
  return parse_cases({std::istreambuf_iterator<char>(in), {}}, file, check);
}

std::vector<Case> parse_cases(const std::string& text, const std::string& file, const StatementCheck& check) {
  Json whole;
  try {
    whole = Json::parse(text, [&](int depth, Json::parse_event_t, const Json&) {
      constexpr int most_levels = 32;
      if (depth > most_levels) throw CaseError(file + ": nested more than " + std::to_string(most_levels) + " deep");
      return true;
    });
    // The syntax is wrong, or a number is beyond double.
  } catch (const Json::exception& e) {
    throw CaseError(file + ": malformed JSON: " + e.what());
  }
  const Fields top(whole, file);
  if (top.text("format") != "refitlab cases 1") top.fail("format", "is not \"refitlab cases 1\"");
  std::vector<Case> out;
  std::set<std::string> names;
  for (const Fields& numbered : top.objects("cases")) {
    const std::string name = numbered.text("name");
    const Json& object = whole["cases"][out.size()];
    const Fields f(object, file + ": case '" + name + "'");
    if (!names.insert(name).second) f.fail("name", "is not the only one of its kind");
    Case c{name, f.text("statement"), f.text("form"), f.text("claim"), f.text("expected")};
    if (f.has("without")) c.without = f.text("without");
    c.note = f.text("note");
    if (f.has("dimension")) c.dimension = f.integer("dimension", 1, 4);
    f.object("inputs");  // Throws if it is missing.
    c.inputs = object["inputs"];
    c.file = file;
    check(c);
    out.push_back(std::move(c));
  }
  return out;
}

std::string as_markdown(const std::vector<Case>& cases) {
  std::ostringstream out;
  std::string statement;
  for (const Case& c : cases) {
    if (c.statement != statement) out << "## " << (statement = c.statement) << "\n\n";
    out << "### " << c.name << "\n\n" << c.note << "\n\n";
    for (const auto& [key, value] : c.inputs.items()) out << "- " << key << ": " << shown(value) << '\n';
    out << "\nThe " << c.form << " claim *" << c.claim << "*";
    if (!c.without.empty()) out << ", without the hypothesis that " << c.without << ',';
    out << ' ' << (c.expected == "undefined" ? "is " : "") << "**" << c.expected << "**.\n\n";
  }
  return out.str();
}

}  // namespace proptests::cases
