// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/cases/pinned_inputs.hpp"

#include "proptests/counterexamples/algorithm1.hpp"
#include "proptests/counterexamples/lemma1_cap_definitions.hpp"
#include "proptests/counterexamples/lemma2_normalization.hpp"
#include "proptests/counterexamples/lemma3_sphere_surface_intersection.hpp"
#include "proptests/counterexamples/lemma4_quaternion_hull.hpp"
#include "proptests/counterexamples/lemma5_cap_enclosing_sphere.hpp"
#include "proptests/counterexamples/s41_weight_vertices_span.hpp"
#include "proptests/counterexamples/s42_linear_part_hull.hpp"
#include "proptests/counterexamples/s43_distance_range.hpp"
#include "proptests/counterexamples/s43_minkowski_sum.hpp"
#include "proptests/counterexamples/s43_rotated_cap.hpp"
#include "proptests/counterexamples/s43_whole_sphere_fallback.hpp"
#include "proptests/counterexamples/s44_joint_sets.hpp"
#include "proptests/counterexamples/s44_sum_of_bounds.hpp"
#include "proptests/counterexamples/t3_min_dot_distance.hpp"
#include "proptests/counterexamples/t3_one_cap.hpp"
#include "proptests/counterexamples/t3_smallest_ball_smallest_cap.hpp"

namespace proptests::cases {
namespace {

using namespace refitlab;

Json json(const Rational& x) { return as_text(x); }
template <int D>
Json json(const Vec<Rational, D>& v) {
  Json out = Json::array();
  for (int i = 0; i < D; ++i) out.push_back(as_text(v[i]));
  return out;
}
template <int D>
Json json(const Ball<Rational, D>& b) {
  return {{"center", json(b.center)}, {"radius", json(b.radius)}};
}
template <int D>
Json json(const SquaredBall<Rational, D>& b) {
  return {{"center", json(b.center)}, {"squared_radius", json(b.squared_radius)}};
}
template <int D>
Json json(const HalfSpace<Rational, D>& h) {
  return {{"normal", json(h.normal)}, {"offset", json(h.offset)}};
}
template <int D>
Json json(const Cap<Rational, D>& c) {
  return {{"center", json(c.center)}, {"apex", json(c.apex)}, {"cos_angle", json(c.cos_angle)}};
}
Json json(const RigidTransform<Rational>& c) { return {{"rotation", json(c.rotation)}, {"translation", json(c.translation)}}; }
Json json(const PosedJointSet<Rational>& set);
Json json(const gen::SetCase& set);
template <class X>
Json json(const std::vector<X>& list) {
  Json out = Json::array();
  for (const X& x : list) out.push_back(json(x));
  return out;
}
Json json(const WeightBounds<Rational>& b) { return {{"low", json(b.low)}, {"high", json(b.high)}}; }
Json json(const PosedJointSet<Rational>& s) {
  return {{"transforms", json(s.transforms)},
          {"rotation_center", json(s.rotation_center)},
          {"weight_vertices", json(s.weight_vertices)}};
}
Json json(const gen::SetCase& s) {
  return {{"transforms", json(s.palette.transforms)},
          {"rotation_center", json(s.palette.rotation_center)},
          {"bounds", json(s.weights.bounds)}};
}

void add_cap_definitions(std::vector<PinnedInputs>& out) {
  using namespace lemma1;
  const auto add = [&](const std::string& name, const Circle& s, const HalfPlane& h) {
    out.push_back({name, {{"surface", json(s)}, {"half_space", json(h)}}});
  };
  for (const std::string form : {"printed", "repaired"}) {
    add("half-space that holds the circle, " + form, unit_circle, holds_all);
    add("negative scalar, " + form, unit_circle, right_half);
    add("normal of length 0, " + form, unit_circle, whole_plane);
  }
  add("half-space that misses the circle", unit_circle, misses);
  add("wrong length of the apex", unit_circle, beyond_a_half);
  add("radius 0", single_point, right_half);
  out.push_back({"cap of radius 0", {{"cap", json(no_radius)}}});
  out.push_back({"cap without an angle", {{"cap", json(no_angle)}}});
}

void add_normalization(std::vector<PinnedInputs>& out) {
  using namespace lemma2;
  const auto add = [&](const char* name, const Quaternions& q, const Weights& factors, const Weights& w) {
    out.push_back({name, {{"vectors", json(q)}, {"factors", json(factors)}, {"weights", json(w)}}});
  };
  add("1 and -1, printed", antipodal, ones, halves);
  add("1 and -1, repaired", antipodal, ones, halves);
  add("three quaternions that cancel, printed", three_around, three_ones, cancelling);
  add("negative factor", right_angle, one_negative, halves);
  add("a factor of 0", with_zero, zero_and_one, only_first);
  add("weights off the simplex", right_angle, ones, not_convex);
}

void add_surface_intersection(std::vector<PinnedInputs>& out) {
  using namespace lemma3;
  const auto add = [&](const std::string& name, const Disc& b) {
    out.push_back({name, {{"surface", json(unit_circle)}, {"ball", json(b)}}});
  };
  for (const std::string form : {"printed", "repaired"}) {
    add("disc inside the circle, " + form, inside);
    add("disc beyond the circle, " + form, beyond);
    add("concentric small disc, " + form, concentric_small);
    add("concentric large disc, " + form, concentric_large);
  }
  add("point inside, printed", point_inside);
  add("point beyond, printed", point_beyond);
  add("point off the circle", through_center);
  add("disc with most of the circle", holds_most);
  out.push_back({"distance about 0, printed", {{"ball", json(concentric_small)}}});
  out.push_back({"disc inside the circle, printed", {{"point", json(on_circle)}}});
}

void add_quaternion_hull(std::vector<PinnedInputs>& out) {
  using namespace lemma4;
  const auto add = [&](const char* name, const Disc& b, const Units& n, const Weights& w) {
    out.push_back({name, {{"ball", json(b)}, {"units", json(n)}, {"weights", json(w)}}});
  };
  out.push_back(
      {"mean disc of radius 6/5, printed border", {{"ball", json(mean_of_three_and_one)}, {"units", json(three_and_one)}}});
  add("mean disc of radius 6/5, repaired", mean_of_three_and_one, three_and_one, quarters);
  add("mean disc past a half", mean_of_three_and_wide, three_and_wide, quarters);
  add("blend behind the disc", around_behind, behind, halves);
  add("blend behind the disc, as a rotation", around_behind, behind, halves);
  add("blend behind the disc, in integers", around_left_and_down, left_and_down, halves);
  add("antipodal pair at the border", around_up_and_down, up_and_down, halves);
  add("vector of length 1/sqrt 2", only_not_unit, not_unit, alone);
  add("vector outside the disc", only_right, up, alone);
  add("weights outside the hull", mean_of_right_and_up, right_and_up, not_convex);
}

void add_cap_ball(std::vector<PinnedInputs>& out) {
  using namespace lemma5;
  for (const std::string form : {"printed", "repaired"}) {
    out.push_back({"apex of a wide cap, " + form, {{"cap", json(wide)}}});
    out.push_back({"whole circle, " + form, {{"cap", json(whole_circle)}}});
    out.push_back({"hardly wide cap, " + form, {{"cap", json(hardly_wide)}}});
  }
  out.push_back({"no points", {{"cap", json(no_points)}}});
  out.push_back({"cap on a line", {{"cap", json(on_a_line)}, {"other", json(point_on_a_line)}}});
  out.push_back({"smallest ball of a narrow cap",
                 {{"cap", json(narrow)}, {"sine", json(sine_of_narrow)}, {"rim_direction", json(perpendicular)}}});
  out.push_back({"slanted direction", {{"cap", json(narrow)}, {"sine", json(sine_of_narrow)}, {"rim_direction", json(slanted)}}});
  out.push_back(
      {"sine of another angle", {{"cap", json(narrow)}, {"sine", json(not_its_sine)}, {"rim_direction", json(perpendicular)}}});
}

void add_weight_vertices_span(std::vector<PinnedInputs>& out) {
  using namespace s41;
  for (const std::string form : {"printed", "repaired"}) {
    out.push_back({"low bounds too high, " + form, {{"bounds", json(low_too_high)}}});
    out.push_back({"high bounds too low, " + form, {{"bounds", json(high_too_low)}}});
    out.push_back({"crossed bounds, " + form, {{"bounds", json(crossed)}}});
  }
  out.push_back(
      {"a weight vertex is missing", {{"bounds", json(segment)}, {"weight_vertices", json(one_end)}, {"weights", json(middle)}}});
  out.push_back({"weights out of bounds",
                 {{"bounds", json(segment)}, {"weight_vertices", json(both_ends)}, {"weights", json(beyond_the_segment)}}});
  out.push_back({"a weight vertex too far",
                 {{"bounds", json(segment)}, {"weight_vertices", json(too_far)}, {"coefficients", json(only_the_first)}}});
  out.push_back({"a weight vertex twice", {{"bounds", json(segment)}, {"weight_vertices", json(repeated)}}});
}

void add_linear_part_hull(std::vector<PinnedInputs>& out) {
  using namespace s42;
  out.push_back(
      {"image of a missing weight vertex",
       {{"bounds", json(segment)}, {"weight_vertices", json(first_only)}, {"points", json(points)}, {"weights", json(second)}}});
  out.push_back({"image of a weight vertex too far",
                 {{"bounds", json(segment)},
                  {"weight_vertices", json(too_far)},
                  {"points", json(points)},
                  {"coefficients", json(only_the_first)}}});
}

void add_distance_range(std::vector<PinnedInputs>& out) {
  using namespace s43_range;
  const auto add = [&](const char* name, const s43_range::Case& c) {
    out.push_back({name, {{"center", json(c.center)}, {"radius", json(c.radius)}}});
  };
  add("ball outside, printed", outside);
  add("ball outside, repaired", outside);
  add("ball inside", inside);
  add("ball past a half", past_half);
  add("ball about 0", about_zero);
}

void add_minkowski_sum(std::vector<PinnedInputs>& out) {
  using namespace s43_minkowski;
  out.push_back({"corner of a box",
                 {{"blend", json(turn)}, {"ball", json(unit_ball)}, {"pivot", json(pivot)}, {"point", json(box_corner)}}});
}

void add_rotated_cap(std::vector<PinnedInputs>& out) {
  using namespace s43_cap;
  const auto add = [&](const char* name, const Q& cosine) {
    out.push_back(
        {name, {{"apex", json(no_turn)}, {"cos_angle", json(cosine)}, {"rotation", json(half_turn_about_x)}, {"v", json(y)}}});
  };
  add("half turn past a right angle, printed", past_right_angle);
  add("half turn past a right angle, repaired", past_right_angle);
  add("half turn outside the cap", before_right_angle);
}

void add_whole_sphere_fallback(std::vector<PinnedInputs>& out) {
  using namespace s43_fallback;
  const auto ball = [](const s43_fallback::Case& c) -> Json {
    return {{"units", json(c.units)}, {"center", json(c.center)}, {"squared_radius", json(c.squared_radius)}};
  };
  const auto add = [&](const char* name, const s43_fallback::Case& c) {
    out.push_back({name, ball(c)});
    out.back().fields["coefficients"] = json(c.coefficients);
  };
  out.push_back({"mean ball of radius 6/5, printed", ball(thrown_away)});
  add("mean ball of radius 6/5, repaired", thrown_away);
  out.push_back({"mean ball past a half, line 15", ball(negative_radius)});
  out.push_back({"mean of 1 and -1, line 15", ball(zero_center)});
  add("ball past a half, as a cap", past_half);
  add("short quaternion", short_one);
  add("quaternion outside the ball", not_enclosed);
  add("coefficients off the simplex", not_convex);
}

void add_joint_sets(std::vector<PinnedInputs>& out) {
  using namespace s44_joints;
  const auto add = [&](const char* name, const s44_joints::Case& c) {
    out.push_back({name, {{"joint_sets", json(c.sets)}, {"reference", json(c.reference)}, {"ball", json(c.ball)}}});
  };
  add("one rotation center for two joint-sets, printed", rotation_center);
  add("one list of weight vertices for two joint-sets, printed", weight_vertices);
}

void add_sum_of_bounds(std::vector<PinnedInputs>& out) {
  using namespace s44_sum;
  const auto add = [&](const char* name, const s44_sum::Case& c) {
    out.push_back({name,
                   {{"ball", json(c.ball)},
                    {"linear", json(c.bounds.linear)},
                    {"spherical", json(c.bounds.spherical)},
                    {"inflation", json(c.bounds.inflation)},
                    {"coefficients", json(c.parts.coefficients)},
                    {"spherical_part", json(c.parts.spherical)},
                    {"offset", json(c.parts.offset)}}});
  };
  add("farthest sum", extreme);
  add("linear part off the hull", not_convex);
  add("spherical part off its ball", spherical_outside);
  add("offset too long", offset_too_long);
  add("ball of points", ball_of_points);
  add("ball of one", ball_of_one);
}

void add_min_dot_distance(std::vector<PinnedInputs>& out) {
  using namespace t3_dot;
  const auto add = [&](const char* name, const t3_dot::Case& c) {
    out.push_back({name, {{"units", json(c.units)}, {"center", json(c.center)}, {"squared_radius", json(c.squared_radius)}}});
  };
  add("vector of length 2", not_unit);
  add("radius too large", too_large);
  add("radius too small", too_small);
  add("radius of the nearest unit", of_the_nearest);
  add("units about 0", about_zero);
}

void add_one_cap(std::vector<PinnedInputs>& out) {
  using namespace t3_cap;
  const auto blend = [](const t3_cap::Case& c) -> Json {
    return {{"quaternions", json(c.quaternions)}, {"axis", json(c.axis)}, {"coefficients", json(c.coefficients)}};
  };
  const auto add = [&](const char* name, const t3_cap::Case& c) {
    out.push_back({name, blend(c)});
    out.back().fields["squared_cosine"] = json(c.squared_cosine);
  };
  add("quaternion behind the axis", behind);
  add("only the quaternion behind the axis", only_behind);
  add("kappa too large", too_narrow);
  add("coefficients beyond the second", not_convex);
  out.push_back({"right angles to the axis", blend(right_angles)});
}

void add_smallest_cap(std::vector<PinnedInputs>& out) {
  using namespace t3_smallest;
  const auto add = [&](const char* name, const t3_smallest::Case& c) {
    out.push_back({name, {{"units", json(c.units)}, {"coefficients", json(c.coefficients)}}});
  };
  add("vectors of different lengths", not_units);
  add("not the nearest point", not_nearest);
  add("0 in the hull", zero_inside);
  add("x and y", once);
  add("x twice, and y", twice);
}

void add_algorithm1(std::vector<PinnedInputs>& out) {
  const char* const names[] = {"cap beyond a right angle, printed", "negative radius, printed",
                               "zero blend at a weight vertex, signed", "zero mean, signed", "lost sign, printed"};
  const auto& pinned = counterexamples::algorithm1();
  for (std::size_t i = 0; i < pinned.size(); ++i) {
    const auto& [finding, input, weights, undefined] = pinned[i];
    out.push_back({i < std::size(names) ? names[i] : "a case for: " + finding,
                   {{"reference", json(input.reference)},
                    {"joint_sets", json(input.sets)},
                    {"vertex", {{"joint_set", 0}, {"weights", json(weights)}, {"position", json(input.reference.center)}}}}});
  }
}

// Returns a layout in which objects, and lists of them, have one line for each field, and lists of numbers have one line.
std::string laid_out(const Json& value, const std::string& indent) {
  const bool is_list = value.is_array() && !value.empty() && value.front().is_structured();
  if (!value.is_object() && !is_list) {
    std::string line;
    for (const char c : value.dump()) line += c == ',' && value.is_array() ? ", " : std::string(1, c);
    return line;
  }
  std::string out;
  for (const auto& [name, element] : value.items())
    out += (out.empty() ? "\n " : ",\n ") + indent + (is_list ? "" : Json(name).dump() + ": ") + laid_out(element, indent + " ");
  return (is_list ? "[" : "{") + out + "\n" + indent + (is_list ? "]" : "}");
}

}  // namespace

std::vector<PinnedInputs> pinned_inputs() {
  std::vector<PinnedInputs> out;
  for (const auto add : {add_cap_definitions, add_normalization, add_surface_intersection, add_quaternion_hull, add_cap_ball,
                         add_weight_vertices_span, add_linear_part_hull, add_distance_range, add_minkowski_sum, add_rotated_cap,
                         add_whole_sphere_fallback, add_joint_sets, add_sum_of_bounds, add_min_dot_distance, add_one_cap,
                         add_smallest_cap, add_algorithm1})
    add(out);
  return out;
}

std::string with_pinned_inputs(const std::string& text) {
  Json file = Json::parse(text);
  for (const auto& [name, fields] : pinned_inputs()) {
    Json* found = nullptr;
    for (Json& c : file.at("cases"))
      if (c.at("name") == name) found = &c;
    if (!found) throw CaseError("no case is named '" + name + "', after a counterexample that is pinned");
    (*found)["inputs"].update(fields);
  }
  return laid_out(file, "") + "\n";
}

}  // namespace proptests::cases
