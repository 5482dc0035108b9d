// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers become exact fractions in JSON, and JSON gets its one canonical form.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/exact/exact.hpp"  // as_text
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns a fraction as a string, such as "-3/8" or "5". Throws std::invalid_argument for a number that is not finite.
inline nlohmann::json exact_json(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("certificate: a number is not finite");
  return as_text(Rational(x));
}
inline nlohmann::json exact_json(std::span<const double> numbers) {
  nlohmann::json out = nlohmann::json::array();
  for (const double x : numbers) out.push_back(exact_json(x));
  return out;
}
template <int D>
nlohmann::json exact_json(const Vec<double, D>& v) {
  return exact_json(std::span<const double>(v.data(), D));
}
inline nlohmann::json exact_json(const Ball3<double>& ball) {
  return {{"center", exact_json(ball.center)}, {"radius", exact_json(ball.radius)}};
}
// Returns a joint-set of a palette, with the numbers of its joints in the model and the data that the skinning reads.
nlohmann::json exact_json(const PaletteEntry<double>& palette, std::span<const int> joints, Skinning skinning);

// Returns the name of the skinning. It is "spherical" for Hejl's too, and "affine" for linear skinning by affine joints.
const char* certified_name(const SkinningPalette<double>& palette, Skinning skinning);

// Returns the document in ASCII with sorted keys, indented by one space and ended by a line feed.
inline std::string canonical(const nlohmann::json& document) {
  return document.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace refitlab
