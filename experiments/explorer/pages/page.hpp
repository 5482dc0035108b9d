// SPDX-License-Identifier: GPL-3.0-or-later
// A page of a lemma has sliders and the scene that they make. The lemma's own code computes it in exact rational numbers.
//
// A slider has whole numbers, so that all coordinates are rational and every verdict is decided. Scenes are in R^3. The lemmas
// hold in every dimension, by the same templates, and S_2 is the slice of the quaternions (w, x, y, 0).
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab::explorer {

using Values = std::vector<int>;  // of the sliders, in their order

struct Slider {
  std::string label;
  int low, high, start;
  std::string (*text)(int);  // what the value says
};

struct Preset {
  std::string label;
  Values values;
};

struct Page {
  std::string id, title, text;
  std::vector<Slider> sliders;
  std::vector<Preset> presets;
};

// --- Rational data from whole numbers ---

// A point of the unit circle has the cosine and sine of 2 arctan(k / 12), or of half a turn for k = half_turn.
inline constexpr int half_turn = 73;
template <class S>
Vec<S, 2> on_circle(int k) {
  if (k == half_turn) return {S(-1), S(0)};
  const S t = S(k) / S(12), n = S(1) + t * t;
  return {(S(1) - t * t) / n, S(2) * t / n};
}
inline std::string circle_text(int k) {
  const Vec<double, 2> x = on_circle<double>(k);
  return std::to_string(static_cast<int>(std::lround(std::atan2(x[1], x[0]) * 180 / 3.14159265358979323846))) + "°";
}
// Returns a number of tenths as text.
inline std::string tenths_text(int k) {
  const std::string text = std::to_string(std::abs(k) / 10) + "." + std::to_string(std::abs(k) % 10);
  return k < 0 ? "−" + text : text;
}
inline std::string plain_text(int k) { return std::to_string(k); }

// --- The scene ---

// A Scene collects what is drawn, the verdicts and the numbers. as_double converts the number type.
template <class S>
class Scene {
 public:
  explicit Scene(std::function<double(const S&)> as_double) : as_double_(std::move(as_double)) {
    for (const char* list : {"points", "balls", "caps", "planes", "lines", "verdicts", "numbers"})
      json_[list] = nlohmann::json::array();
  }

  // role names a color and a form.
  void point(const char* role, const std::string& label, const Vec<S, 3>& at) {
    json_["points"].push_back({{"role", role}, {"label", label}, {"at", coordinates(at)}});
  }
  void ball(const char* role, const SquaredBall<S, 3>& b) {
    const double square = as_double_(b.squared_radius);
    if (square < 0) return;
    json_["balls"].push_back({{"role", role}, {"center", coordinates(b.center)}, {"radius", std::sqrt(square)}});
  }
  void cap(const char* role, const Cap<S, 3>& c) {
    json_["caps"].push_back(
        {{"role", role}, {"center", coordinates(c.center)}, {"apex", coordinates(c.apex)}, {"cos", as_double_(c.cos_angle)}});
  }
  // Draws the points of the unit sphere in a half-space, whose normal need not have a rational length. Draws nothing if there are
  // none.
  void half_space_cap(const char* role, const HalfSpace<S, 3>& h) {
    const double length = std::sqrt(as_double_(squared_norm(h.normal))), cosine = as_double_(h.offset) / length;
    if (cosine > 1) return;
    nlohmann::json apex = coordinates(Vec<S, 3>::Constant(S(0)));
    for (int i = 0; i < 3; ++i) apex[i] = apex[i].get<double>() + as_double_(h.normal[i]) / length;
    json_["caps"].push_back(
        {{"role", role}, {"center", coordinates(Vec<S, 3>::Constant(S(0)))}, {"apex", apex}, {"cos", std::max(cosine, -1.)}});
  }
  // Draws the point of the unit sphere in the direction of v, or nothing for 0.
  void direction(const char* role, const std::string& label, const Vec<S, 3>& v) {
    const double length = std::sqrt(as_double_(squared_norm(v)));
    if (length == 0) return;
    nlohmann::json at;
    for (int i = 0; i < 3; ++i) at.push_back(as_double_(v[i]) / length + (i == 0 ? shift_ : 0));
    json_["points"].push_back({{"role", role}, {"label", label}, {"at", at}});
  }
  void plane(const char* role, const HalfSpace<S, 3>& h) {
    const Vec<S, 3> foot = h.normal * S(h.offset / squared_norm(h.normal));
    json_["planes"].push_back({{"role", role}, {"foot", coordinates(foot)}, {"normal", plain(h.normal)}});
  }
  void line(const char* role, const Vec<S, 3>& a, const Vec<S, 3>& b) {
    json_["lines"].push_back({{"role", role}, {"from", coordinates(a)}, {"to", coordinates(b)}});
  }
  // Adds a verdict. form is "printed", "repaired", or empty for a hypothesis.
  void verdict(const char* form, const std::string& says, Verdict v) {
    json_["verdicts"].push_back({{"form", form}, {"says", says}, {"verdict", name_of(v)}});
  }
  void number(const std::string& label, const S& value) {
    json_["numbers"].push_back({{"label", label}, {"value", as_double_(value)}});
  }

  // Draws everything that follows this far along x.
  void move_right(double by) { shift_ = by; }

  const nlohmann::json& json() const { return json_; }

 private:
  nlohmann::json plain(const Vec<S, 3>& v) const { return {as_double_(v[0]), as_double_(v[1]), as_double_(v[2])}; }
  nlohmann::json coordinates(const Vec<S, 3>& v) const { return {as_double_(v[0]) + shift_, as_double_(v[1]), as_double_(v[2])}; }

  std::function<double(const S&)> as_double_;
  nlohmann::json json_;
  double shift_ = 0;
};

template <class S>
Vec<S, 3> vec3(int x, int y, int z) {
  return {S(x), S(y), S(z)};
}
template <class S>
SquaredBall<S, 3> unit_sphere() {
  return {vec3<S>(0, 0, 0), S(1)};
}

}  // namespace refitlab::explorer
