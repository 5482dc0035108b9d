// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/limits.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/exact/exact.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

// Appends all fractions of a document.
void collect(const json& value, std::vector<std::string>& fractions) {
  static constexpr std::string_view texts[] = {"about", "by", "digest", "model", "pose", "skinning"};
  if (value.is_string()) fractions.push_back(value.get<std::string>());
  if (value.is_array())
    for (const json& item : value) collect(item, fractions);
  if (value.is_object())
    for (const auto& [key, item] : value.items())
      if (std::ranges::find(texts, key) == std::end(texts)) collect(item, fractions);
}

// Returns how many bits a whole number has; 0 has none.
std::size_t bits_of(const CGAL::Gmpz& n) { return n == 0 ? 0 : mpz_sizeinbase(n.mpz(), 2); }

// Returns the bits of the common denominator and of the longest of the fractions over it, or nothing if the denominator has more
// than checkers take.
std::optional<long> bits_of(const std::vector<std::string>& fractions) {
  std::vector<Rational> numbers;
  for (const std::string& fraction : fractions) numbers.emplace_back(fraction);
  CGAL::Gmpz scale(1);
  for (const Rational& n : numbers) {
    mpz_lcm(scale.mpz(), scale.mpz(), n.denominator().mpz());
    if (bits_of(scale) > most_certificate_bits) return std::nullopt;
  }
  std::size_t longest = 0;
  for (const Rational& n : numbers)
    longest = std::max(longest, bits_of(n.numerator()) + bits_of(CGAL::integral_division(scale, n.denominator())));
  return static_cast<long>(bits_of(scale) + longest);
}

std::string refusal_of_bits(const char* article) {
  return std::string(article) + " common denominator has more than " + std::to_string(most_certificate_bits) + " bits";
}

// Returns a refusal of this many steps with numbers of this many bits, or nothing. what: whose work it is.
std::string refusal_of_work(const char* what, long steps, long bits, long most) {
  const long factor = 1 + bits / 512;
  const CGAL::Gmpz work = CGAL::Gmpz(steps) * CGAL::Gmpz(factor * factor);
  if (work <= CGAL::Gmpz(most)) return "";
  return std::string(what) + " too much work, " + as_text(Rational(work)) + " of at most " + std::to_string(most);
}

// Returns the number of monomials of a degree in this many variables.
long monomials(long variables, int degree) {
  return degree == 1   ? variables
         : degree == 2 ? variables * (variables + 1) / 2
                       : variables * (variables + 1) * (variables + 2) / 6;
}

// Returns the terms of a bound for this many weight vertices. The control points of a skinning have its degree in the weights.
long terms_of(const json& bound, long weight_vertices, int degree) {
  long terms = monomials(weight_vertices, bound["by"] == "control" ? degree : 1);
  if (bound.contains("halves"))
    for (const json& half : bound["halves"]) terms += terms_of(half, weight_vertices, degree);
  return terms;
}

// Returns the steps of a vertex in its piece. A checker may walk lists from their beginning.
long steps_of_vertex(const json& vertex, const json& pieces) {
  const long weights = static_cast<long>(vertex["weights"].size()),
             weight_vertices = static_cast<long>(pieces.at(vertex["piece"].get<std::size_t>())["weight_vertices"].size());
  return 1 + static_cast<long>(vertex["shares"].size()) *
                 (weights + (weights * weights + weight_vertices) / list_steps_per_certificate_step);
}

long steps_of(const json& document) {
  const int degree = document["skinning"] == "spherical" ? 3 : document["skinning"] == "dual_quaternion" ? 2 : 1;
  long steps = 0;
  for (const json& piece : document["pieces"]) {
    const long vertices = static_cast<long>(piece["weight_vertices"].size());
    steps += vertices * static_cast<long>(piece["weight_vertices"][0].size()) + terms_of(piece["bound"], vertices, degree);
  }
  for (const json& vertex : document["vertices"]) steps += steps_of_vertex(vertex, document["pieces"]);
  return steps;
}

// Returns the sum of the triangles of both sets, over the steps of a certificate of pairs.
long triangles_of_steps(const json& document) {
  std::vector<std::pair<long, long>> todo{
      {static_cast<long>(document["first_order"].size()), static_cast<long>(document["second_order"].size())}};
  long sum = 0;
  for (const json& step : document["steps"]) {
    // There is no proof with more steps.
    if (todo.empty()) break;
    const auto [m, n] = todo.back();
    todo.pop_back();
    sum += m + n;
    if (step == "first") todo.insert(todo.end(), {{m - m / 2, n}, {m / 2, n}});
    if (step == "second") todo.insert(todo.end(), {{m, n - n / 2}, {m, n / 2}});
  }
  return sum;
}

}  // namespace

bool has_too_many_digits(std::string_view fraction) {
  if (fraction.starts_with('-')) fraction.remove_prefix(1);
  const std::size_t slash = std::min(fraction.find('/'), fraction.size());
  return slash > most_certificate_digits || fraction.size() > slash + 1 + most_certificate_digits;
}

std::string refusal_of_length(std::size_t bytes) {
  return bytes <= most_certificate_bytes ? "" : "the file has more than " + std::to_string(most_certificate_bytes) + " bytes";
}

std::string refusal_of_certificate(const std::string& text) {
  const DefaultFloatEnvironment environment;
  if (std::string refusal = refusal_of_length(text.size()); !refusal.empty()) return refusal;
  const json document = json::parse(text);
  std::vector<std::string> fractions;
  collect(document, fractions);
  for (const std::string& fraction : fractions)
    if (has_too_many_digits(fraction))
      return "is no Fraction of at most " + std::to_string(most_certificate_digits) + " digits each";
  const std::optional<long> bits = bits_of(fractions);
  if (!bits) return refusal_of_bits("the");
  return refusal_of_work("the proofs take", steps_of(document), *bits, most_certificate_work);
}

std::string refusal_of_pairs_certificate(const std::string& text) {
  const DefaultFloatEnvironment environment;
  if (std::string refusal = refusal_of_length(text.size()); !refusal.empty()) return refusal;
  const json document = json::parse(text);
  std::vector<json> groups{// They have a denominator each.
                           json::array({document["first"]["vertices"], document["second"]["vertices"]})};
  for (const json& step : document["steps"])
    if (step.is_object()) groups.push_back(step);
  for (const json& contact : document["contacts"]) groups.push_back(json::array({contact["first"], contact["second"]}));
  long most = 0;
  for (const json& group : groups) {
    std::vector<std::string> fractions;
    collect(group, fractions);
    const std::optional<long> bits = bits_of(fractions);
    if (!bits) return refusal_of_bits("a");
    most = std::max(most, *bits);
  }
  return refusal_of_work("the proof takes", triangles_of_steps(document), most, most_pairs_work);
}

std::string note_of_refusal(const std::string& file, const std::string& refusal) {
  return refusal.empty() ? "" : "note: " + file + ": is refused by checkers of certificates: " + refusal + "\n";
}

}  // namespace refitlab
