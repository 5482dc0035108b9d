// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/pairs_certificate.hpp"

#include <algorithm>

#include "algorithms/certificate/exact_json.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

json json_of(const PosedBody& body) {
  json out{{"name", body.name}, {"triangles", body.triangles}};
  for (const Point3& p : body.vertices) out["vertices"].push_back(exact_json(p));
  return out;
}

json json_of(const Rational& number) {
  const std::string text = as_text(number);
  if (has_too_many_digits(text)) throw NoProof("a reason has a number of more than 400 digits, which checkers refuse");
  return text;
}

template <class Numbers>
json json_of_all(const Numbers& numbers) {
  json out;
  for (const Rational& n : numbers) out.push_back(json_of(n));
  return out;
}

json json_of(const SeparationStep& step) {
  if (std::holds_alternative<Touching>(step)) return "contact";
  if (const auto* halved = std::get_if<Halved>(&step)) return *halved == Halved::first ? "first" : "second";
  const auto& plane = std::get<PartingPlane>(step);
  return {{"normal", json_of_all(plane.normal)}, {"offset", json_of(plane.offset)}};
}

void require_same(const std::vector<TrianglePair>& listed, const std::vector<TrianglePair>& found) {
  std::vector<TrianglePair> other;
  std::ranges::set_symmetric_difference(listed, found, std::back_inserter(other));
  if (other.empty()) return;
  const std::string names = std::to_string(other[0].first) + " and " + std::to_string(other[0].second);
  if (std::ranges::binary_search(listed, other[0])) throw NoProof("triangles " + names + " do not meet, but are listed");
  throw NoProof("triangles " + names + " meet, but are not listed once");
}

}  // namespace

std::string pairs_certificate(const std::string& about, const PosedBody& first, const PosedBody& second,
                              std::vector<TrianglePair> pairs) {
  const DefaultFloatEnvironment environment;
  const Separation separation = separate(first, second);
  std::vector<TrianglePair> found;
  for (const auto& contact : separation.contacts) found.push_back(contact.pair);
  std::ranges::sort(found), std::ranges::sort(pairs);
  require_same(pairs, found);

  json document{{"about", about},
                {"contacts", json::array()},
                {"digest", ""},
                {"first", json_of(first)},
                {"first_order", separation.first_order},
                {"second", json_of(second)},
                {"second_order", separation.second_order}};
  for (const auto& [pair, point] : separation.contacts)
    document["contacts"].push_back(
        {{"pair", {pair.first, pair.second}}, {"first", json_of_all(point.first)}, {"second", json_of_all(point.second)}});
  for (const SeparationStep& step : separation.steps) document["steps"].push_back(json_of(step));
  document["digest"] = sha256(canonical(document));
  return canonical(document);
}

std::string body_document(const PosedBody& body) {
  const DefaultFloatEnvironment environment;
  return canonical(json_of(body));
}

}  // namespace refitlab
