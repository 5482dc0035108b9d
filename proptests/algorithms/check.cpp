// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the independent checker, proptests/certificate/check: each of its conditions at its edge, its answers to hostile files,
// and that it refuses what would take long before it begins.
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "algorithms/certificate/limits.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/skinned_piece.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/bounds.hpp"
#include "proptests/oracles/checked_folder.hpp"

namespace proptests::suite_check {
namespace {

using namespace refitlab;
using nlohmann::json;
using oracle::CheckedFolder;
using oracle::sealed;
using By = Bound::By;
using Texts = std::vector<std::string>;

// --- Documents from parts ---

json point(const char* x, const char* y, const char* z) { return {x, y, z}; }
const json origin = point("0", "0", "0"), unturned = {"1", "0", "0", "0"}, zero_dual = {"0", "0", "0", "0"};

json ball(const json& center, const json& radius) { return {{"center", center}, {"radius", radius}}; }
const json units = {{"1", "0", "0"}, {"0", "1", "0"}, {"0", "0", "1"}}, small = ball(origin, "1");

// Returns a list of one, which braces alone do not make.
json alone(const json& item) { return json::array({item}); }
json nested(const json& list) { return list.front().is_structured() ? list : alone(list); }
const json one_weight_vertex = alone(alone("1"));

json piece(const json& weight_vertices, const json& reference, const json& bound) {
  return {{"joint_set", 0}, {"weight_vertices", weight_vertices}, {"reference", reference}, {"bound", bound}};
}

// Makes a document. For affine joints, rotations are the three columns of each.
json document(const char* skinning, const json& rotations, const json& data, const json& pieces, const json& around) {
  const bool is_affine = skinning == std::string("affine");
  json set{{"joints", json::array()}};
  json& of_joints = set[is_affine ? "columns" : "rotations"] = is_affine ? rotations : nested(rotations);
  for (std::size_t i = 0; i < of_joints.size(); ++i) set["joints"].push_back(i);
  if (is_affine) set["offsets"] = nested(data);
  else if (skinning == std::string("linear")) set["translations"] = nested(data);
  else if (skinning == std::string("dual_quaternion")) set["duals"] = nested(data);
  else set["center_images"] = nested(data), set["rotation_center"] = origin;
  return oracle::with_weight_vertex_vertices({{"about", ""},
                                              {"ball", around},
                                              {"joint_sets", alone(set)},
                                              {"model", std::string(64, '0')},
                                              {"node", 0},
                                              {"pieces", pieces.is_array() ? pieces : alone(pieces)},
                                              {"pose", std::string(64, 'f')},
                                              {"skinning", skinning}});
}

json repeated(const json& item, std::size_t times) { return json(json::array_t(times, item)); }

const json control{{"by", "control"}}, all_rotations{{"by", "all_rotations"}};
json cap(const json& axis) { return {{"by", "cap"}, {"axis", axis}}; }
json reach(const json& axis, const json& center) { return {{"by", "reach"}, {"axis", axis}, {"center", center}}; }
json halves(int k, int l, const json& first, const json& second) {
  return {{"by", "halves"}, {"edge", {k, l}}, {"halves", {first, second}}};
}

json stretch(const json& of_joints, const json& of_weight_vertices) {
  return {{"by", "stretch"}, {"of_joints", of_joints}, {"of_weight_vertices", of_weight_vertices}};
}
json columns(const json& x, const json& y, const json& z) { return json::array({x, y, z}); }
json scale(const char* x, const char* y, const char* z) {
  return columns(point(x, "0", "0"), point("0", y, "0"), point("0", "0", z));
}

json exactly(double x) { return as_text(Rational(x)); }
template <int D>
json exactly(const Vec<double, D>& v) {
  json out;
  for (int i = 0; i < D; ++i) out.push_back(exactly(v[i]));
  return out;
}

json document(const gen::SkinnedPiece& p, const json& bound, const Ball3<double>& around) {
  json rotations, data, weight_vertices;
  for (std::size_t i = 0; i < p.palette.transforms.size(); ++i) {
    rotations.push_back(exactly<4>(p.palette.transforms[i].rotation));
    data.push_back(p.skinning == Skinning::linear      ? exactly<3>(p.palette.transforms[i].translation)
                   : p.skinning == Skinning::spherical ? exactly<3>(p.palette.center_images[i])
                                                       : exactly<4>(p.palette.duals[i]));
  }
  for (const auto& w : p.weight_vertices) {
    json weights;
    for (const double x : w) weights.push_back(exactly(x));
    weight_vertices.push_back(weights);
  }
  json out = document(p.skinning == Skinning::linear      ? "linear"
                      : p.skinning == Skinning::spherical ? "spherical"
                                                          : "dual_quaternion",
                      rotations, data,
                      {piece(weight_vertices, ball(exactly<3>(p.reference.center), exactly(p.reference.radius)), bound)},
                      ball(exactly<3>(around.center), exactly(around.radius)));
  if (p.skinning == Skinning::spherical) out["joint_sets"][0]["rotation_center"] = exactly<3>(p.palette.rotation_center);
  return out;
}

// --- Any bound, against what the twin needs ---

Bound some_bound(const gen::SkinnedPiece& p, std::mt19937& random, int depth) {
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t m = p.weight_vertices.size();
  if (depth > 0 && pick(2)) {
    Bound out{.by = By::halves, .edge = {pick(m), pick(m)}};
    for (int i = 0; i < 2; ++i) out.halves.push_back(some_bound(p, random, depth - 1));
    return out;
  }
  Quaternion<double> axis = p.palette.transforms[pick(p.palette.transforms.size())].rotation;
  if (pick(2)) axis += p.palette.transforms[0].rotation * std::normal_distribution<double>(0.5, 1)(random);
  if (pick(2)) return {.by = By::control};
  if (p.skinning == Skinning::dual_quaternion)
    return {.by = By::reach, .axis = axis, .center = p.palette.transforms[0].translation};
  return pick(3) ? Bound{.by = By::cap, .axis = axis} : Bound{.by = By::all_rotations};
}

json as_json(const Bound& b) {
  switch (b.by) {
    case By::control: return control;
    case By::all_rotations: return all_rotations;
    case By::cap: return cap(exactly<4>(b.axis));
    case By::reach: return reach(exactly<4>(b.axis), exactly<3>(b.center));
    default: return halves(int(b.edge[0]), int(b.edge[1]), as_json(b.halves[0]), as_json(b.halves[1]));
  }
}

// Checks documents of random pieces and bounds, of balls just large enough and just too small. A degenerate case has bounds that
// prove nothing, for which every ball is too small.
void check_least_radii() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const bool proves_nothing = gen::any_place(3) == 0;
  RC_CLASSIFY(proves_nothing, "degenerate");
  CheckedFolder folder;
  std::vector<bool> is_large_enough;
  for (int i = 0; i < 60 || is_large_enough.empty(); ++i) {
    const Skinning skinning = std::array{Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}[i % 3];
    const gen::SkinnedPiece p(random, skinning, 4);
    const Bound bound = skinning == Skinning::linear ? Bound{.by = By::control} : some_bound(p, random, 3);
    Vec<double, 3> center;
    for (double& x : center) x = std::normal_distribution<double>(0, i % 4)(random);
    const double needed =
        skinning == Skinning::linear
            ? oracle::needed_radius_linear(p.palette, p.weight_vertices, p.reference, center)
            : p.reference.radius + oracle::needed_radius(oracle::blend_at_weight_vertices(p.palette, p.weight_vertices,
                                                                                          p.reference.center, skinning),
                                                         bound, center);
    if (std::isinf(needed) != proves_nothing) continue;
    if (proves_nothing) {
      folder.add(sealed(document(p, as_json(bound), {center, 1e12}))), is_large_enough.push_back(false);
    } else if (needed < 1e4) {
      const double margin = 1e-9 * (1 + needed + center.norm());
      folder.add(sealed(document(p, as_json(bound), {center, needed + margin}))), is_large_enough.push_back(true);
      folder.add(sealed(document(p, as_json(bound), {center, needed - margin}))), is_large_enough.push_back(false);
    }
  }
  const auto lines = folder.check();
  for (std::size_t i = 0; i < lines.size(); ++i) RC_ASSERT(lines[i].is_accepted() == is_large_enough[i]);
}

// --- Equality at each place of each list, and the smallest step beyond it ---

struct Tight {
  const char* what;
  json document;
};

// Puts vertices at the edge of their piece: on its sphere, of mixed weight vertices, of the same weight vertex twice, of a share
// of 0.
json with_vertices_at_edges(json document) {
  document["vertices"][0]["position"] = point("2/3", "2/3", "-1/3");
  document["vertices"][1].update(
      {{"weight_vertices", {2, 0, 2}}, {"shares", {"1/2", "5", "9/2"}}, {"weights", {"1/2", "0", "1/2"}}});
  document["vertices"][2].update({{"weight_vertices", {1, 2}}, {"shares", {"7", "0"}}, {"weights", {"0", "1", "0"}}});
  return document;
}

// Returns documents each of which holds with equality, of a radius that is a fraction.
std::vector<Tight> tight_documents() {
  std::vector<Tight> out;
  const json left = {"2", "1", "0", "0"}, right = {"2", "-1", "0", "0"};
  for (int far = 0; far < 3; ++far) {  // The number says which weight vertex is the farthest.
    json moved = repeated(origin, 3), duals = repeated(zero_dual, 3);
    moved[far] = point("12", "0", "0");
    duals[far] = {"0", "6", "0", "0"};
    const json same = repeated(unturned, 3), around = ball(point("0", "5", "0"), "14");
    out.push_back({"linear", document("linear", same, moved, {piece(units, small, control)}, around)});
    out.push_back({"spherical control", document("spherical", same, moved, {piece(units, small, control)}, around)});
    out.push_back({"all rotations", document("spherical", same, moved, {piece(units, small, all_rotations)}, around)});
    out.push_back({"dual control", document("dual_quaternion", same, duals, {piece(units, small, control)}, around)});
    out.push_back({"reach", document("dual_quaternion", same, duals, {piece(units, small, reach({"3", "0", "0", "0"}, origin))},
                                     ball(point("0", "5", "0"), "18"))});
    json turned = same;
    turned[far] = left;
    out.push_back({"cap", document("spherical", turned, repeated(origin, 3),
                                   {piece(units, ball(point("0", "0", "5"), "1"), cap({"7", "0", "0", "0"}))},
                                   ball(point("0", "0", "3"), "5"))});
    json pieces = repeated(piece(units, small, control), 3);
    pieces[far]["reference"]["radius"] = "2";
    out.push_back({"pieces", document("linear", same, repeated(origin, 3), pieces, ball(origin, "2"))});
    out.push_back({"vertices", with_vertices_at_edges(out.back().document)});
  }
  const json both = json::array({json::array({"1", "0"}), json::array({"0", "1"})}), two = repeated(origin, 2);
  const json turns = {{"1", "1/2", "0", "0"}, {"1", "-1/2", "0", "0"}};
  out.push_back(
      {"mixed control points", document("spherical", turns, two, {piece(both, ball(point("0", "0", "1"), "1"), control)},
                                        ball(point("0", "0", "17/55"), "107/55"))});
  out.push_back({"mixed dual control points",  // N_12 / W_12 is (0, 0, 5/3), the weight vertices' images are (0, -+4/5, 3/5)
                 document("dual_quaternion", turns, repeated(zero_dual, 2),
                          {piece(both, ball(point("0", "0", "1"), "1"), control)}, ball(point("0", "0", "0"), "8/3"))});
  out.push_back({"a longer joint", document("linear", {{"2", "0", "0", "0"}}, {origin},
                                            {piece(one_weight_vertex, small, control)}, ball(origin, "7"))});
  out.push_back({"a shorter joint", document("linear", {{"1/2", "0", "0", "0"}}, {origin},
                                             {piece(one_weight_vertex, small, control)}, ball(origin, "1"))});
  // These are two joints, one of which scales by 2, at three weight vertices.
  const json halfway = json::array({json::array({"1", "0"}), json::array({"1/2", "1/2"}), json::array({"0", "1"})});
  const json twice = json::array({scale("2", "2", "2"), scale("1", "1", "1")}), above = ball(point("0", "0", "1"), "1");
  const json doubled = stretch(json::array({"2", "1"}), json::array({"2", "3/2", "1"}));
  out.push_back({"a scale", document("affine", twice, two, {piece(halfway, above, doubled)}, ball(origin, "4"))});
  out.push_back({"a scale moved", document("affine", twice, json::array({origin, point("0", "0", "-12")}),
                                           {piece(halfway, above, doubled)}, ball(origin, "12"))});
  const json mirrors = json::array({scale("1", "1", "1"), scale("-1", "-1", "-1")}),
             middle = json::array({json::array({"1/2", "1/2"})});
  out.push_back({"a blend that is flat",
                 document("affine", mirrors, json::array({point("12", "0", "0"), origin}),
                          {piece(middle, above, stretch(json::array({"1", "1"}), alone("0")))}, ball(origin, "6"))});
  out.push_back({"a joint that is flat",
                 document("affine", alone(scale("0", "0", "0")), alone(origin),
                          {piece(one_weight_vertex, small, stretch(alone("0"), alone("0")))}, ball(point("3", "0", "0"), "3"))});
  for (const int away : {0, 1, 2}) {  // a row of A^T A has 1 and 8; in another place each time
    json sheared = columns(point("1/2", "0", "0"), point("-2", "2", "0"), point("0", "0", "1"));
    std::rotate(sheared.begin(), sheared.begin() + away, sheared.end());
    out.push_back({"a shear", document("affine", alone(sheared), alone(origin),
                                       {piece(one_weight_vertex, small, stretch(alone("3"), alone("3")))}, ball(origin, "3"))});
  }
  out.push_back({"nothing but the reference",
                 document("spherical", {unturned}, {origin}, {piece(one_weight_vertex, small, control)}, ball(origin, "1"))});
  out.push_back(
      {"halves", document("spherical", {unturned, unturned}, {point("12", "0", "0"), origin},
                          {piece(both, small, halves(0, 1, control, all_rotations))}, ball(point("0", "5", "0"), "14"))});
  json deep = all_rotations;  // The halves are nested as deep as they may be.
  for (int depth = 0; depth < 32; ++depth) deep = halves(1, 0, all_rotations, deep);
  out.push_back({"halves of halves", document("spherical", {unturned, unturned}, {point("12", "0", "0"), origin},
                                              {piece(both, small, deep)}, ball(point("0", "5", "0"), "14"))});
  out.push_back(
      {"other halves", document("spherical", {unturned, unturned}, {point("12", "0", "0"), origin},
                                {piece(both, small, halves(1, 0, all_rotations, control))}, ball(point("0", "5", "0"), "14"))});
  return out;
}

// Lowers the radius by the smallest fraction that a document may have.
json with_less_radius(json document) {
  Rational radius(document["ball"]["radius"].get<std::string>());
  radius -= 1 / Rational("1" + std::string(380, '0'));
  document["ball"]["radius"] = as_text(radius);
  return document;
}

Checked check_tight() {
  CheckedFolder folder;
  const auto list = tight_documents();
  for (const Tight& t : list) folder.add(sealed(t.document)), folder.add(sealed(with_less_radius(t.document)));
  const auto lines = folder.check();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool is_less = i % 2, is_said = lines[i].is_rejected_for("outside") || lines[i].is_rejected_for("smaller than");
    if (is_less ? !is_said : !lines[i].is_accepted()) return Checked(false, long(i), list[i / 2].what + (": " + lines[i].text));
  }
  return Checked(true, long(lines.size()));
}

// --- One broken condition each, with the reason of the rejection ---

struct Broken {
  std::string what;
  json document;
  const char* reason;
};

// Adds a good document with another value at a place, which is rejected for a reason.
struct WithOther {
  void operator()(const std::string& pointer, const json& value, const char* reason) const {
    json changed = good;
    changed[json::json_pointer(pointer)] = value;
    out.push_back({pointer + " = " + value.dump(), changed, reason});
  }
  const json& good;
  std::vector<Broken>& out;
};

// Adds lists of a fixed length with an item less and one more, objects with a member less and one more, and values that are
// neither.
void add_other_shapes(const json& good, const Texts& lists, const Texts& objects, std::vector<Broken>& out) {
  const WithOther with{good, out};
  for (const std::string& place : lists) {
    const json list = good.at(json::json_pointer(place));
    json less = list, more = list;
    less.erase(list.size() - 1), more.push_back(list.back());
    with(place, less, " items, not "), with(place, more, " items, not ");
    for (const json& none : {json::array(), json::object(), json("012"), json(nullptr), json{{"0", "1"}, {"1", "1"}, {"2", "1"}}})
      with(place, none, "is no list of something");
  }
  for (const std::string& place : objects) {
    const json object = good.at(json::json_pointer(place));
    for (const auto& [name, member] : object.items()) {
      json less = object;
      less.erase(name);
      if (name != "skinning") with(place, less, name == "by" ? "no bound of this skinning" : "has not the members");
    }
    json more = object;
    more["more"] = "1";
    with(place, more, "has not the members");
    if (place.empty()) continue;
    for (const json& none : {json::array({"1"}), json("1"), json(nullptr)})
      with(place, none, place.find("/bound") != std::string::npos ? "is no dict" : "has not the members");
  }
}

// Adds broken documents of two affine joints, one of which shears.
void add_broken_affine(std::vector<Broken>& out) {
  const json sheared = columns(point("1/2", "0", "0"), point("-2", "2", "0"), point("0", "0", "1"));
  const json both = json::array({json::array({"1", "0"}), json::array({"0", "1"})});
  const json good = document("affine", json::array({sheared, scale("1", "-2", "1")}), repeated(origin, 2),
                             {piece(both, small, stretch(json::array({"3", "2"}), json::array({"3", "2"})))}, ball(origin, "3"));
  const WithOther with{good, out};
  const std::string nines = std::string(380, '9'), one = "1" + std::string(380, '0'), bound = "/pieces/0/bound/";
  const json less_than_3 = "2" + nines + "/" + one, less_than_2 = "1" + nines + "/" + one;
  const char *joint = "a joint stretches more", *blend = "the blend at a weight vertex stretches more",
             *others = "the stretches are of other joints or weight vertices";
  with(bound + "of_joints/0", less_than_3, joint), with(bound + "of_joints/1", less_than_2, joint);
  with(bound + "of_joints/0", "-3", joint), with(bound + "of_joints/1", "-2", joint);
  with(bound + "of_weight_vertices/0", less_than_3, blend), with(bound + "of_weight_vertices/1", less_than_2, blend);
  with(bound + "of_weight_vertices/0", "-3", blend), with(bound + "of_weight_vertices/1", "-2", blend);
  for (const char* list : {"of_joints", "of_weight_vertices"})
    for (const json& changed : {json::array({"3"}), json::array({"3", "3", "3"})}) with(bound + list, changed, others);
  with("/joint_sets/0/offsets/2", origin, "lists differ in length");
  with(bound + "by", "control", "no bound of this skinning");
  with("/pieces/0/reference/radius", "1000001/1000000", "the ball of a bound is outside");
  add_other_shapes(good, {"/joint_sets/0/columns/1", "/joint_sets/0/columns/0/2", "/joint_sets/0/offsets/1"},
                   {"/joint_sets/0", "/pieces/0/bound"}, out);
}

// Makes a document of three vertices at the origin, each in a piece of its own of three joints.
json three_pieces() {
  return document("linear", repeated(unturned, 3), repeated(origin, 3), repeated(piece(units, small, control), 3),
                  ball(origin, "1"));
}
// This is the denominator of the smallest fraction that a document may have.
const std::string tiny = "/1" + std::string(380, '0');

void add_broken_pieces(const json& good, std::vector<Broken>& out) {
  const WithOther with{good, out};
  for (const std::string p : {"0", "1", "2"}) {
    const std::string at = "/pieces/" + p + "/";
    for (const std::string k : {"0", "1", "2"}) {
      const std::string weight_vertex = at + "weight_vertices/" + k;
      for (int i = 0; i < 3; ++i) {
        json weights = {"1/3", "1/3", "1/3"};
        weights[i] = "1" + std::string(380, '0') + "/3" + std::string(379, '0') + "1";
        with(weight_vertex, weights, "weights are not convex");  // the sum is a little less
        weights[i] = "1" + std::string(379, '0') + "1/3" + std::string(380, '0');
        with(weight_vertex, weights, "weights are not convex");  // a little more
        weights = {"0", "0", "0"};
        weights[i] = "-1" + tiny;
        weights[(i + 1) % 3] = "1" + std::string(379, '0') + "1" + tiny;
        with(weight_vertex, weights, "weights are not convex");  // one below 0
      }
      with(weight_vertex, {"1", "0"}, "weights are not convex");
      with(weight_vertex, {"1", "0", "0", "0"}, "weights are not convex");
      with(weight_vertex, json::array(), "is no list of something");
    }
    with(at + "reference/radius", "-1" + tiny, "reference.radius is negative");
    with(at + "joint_set", 1, "joint_set is none of them");
    with(at + "joint_set", -1, "joint_set is none of them");
    with(at + "joint_set", true, "joint_set is no int");
    with(at + "joint_set", "0", "joint_set is no int");
    with(at + "joint_set", 0.0, "no integer");
    with(at + "joint_set", 1234567890, "no integer");
    with(at + "joint_set", 123456789, "joint_set is none of them");
    with(at + "weight_vertices", json::array(), "is no list of something");
    with(at + "bound/axis", unturned, "has not the members");
    with(at + "bound/by", "all_rotations", "no bound of this skinning");
    with(at + "bound/by", "halves", "no bound of this skinning");
  }
}

void add_broken_vertices(const json& good, std::vector<Broken>& out) {
  const WithOther with{good, out};
  for (const std::string v : {"0", "1", "2"}) {
    const std::string at = "/vertices/" + v + "/";
    with(at + "piece", 3, "piece is none of them");
    with(at + "piece", -1, "piece is none of them");
    with(at + "weight_vertices/0", 3, "a share is of no weight vertex");
    with(at + "weight_vertices/0", -1, "a share is of no weight vertex");
    with(at + "weight_vertices", {0, 0}, "a share is of no weight vertex");
    with(at + "shares", {"1", "0"}, "a share is of no weight vertex");
    with(at + "shares", {"0"}, "the shares are not convex");
    with(at + "shares", {"-1"}, "the shares are not convex");
    with(at + "weight_vertices/0", 1, "the weights are not what the shares make");
    with(at + "weights", {"1", "0"}, "the weights are not what the shares make");
    with(at + "weights", {"1", "0", "0", "0"}, "the weights are not what the shares make");
    with(at + "weights", {"1", "0", "1" + tiny}, "the weights are not what the shares make");
    with(at + "weights", {"1" + std::string(379, '0') + "1" + tiny, "0", "0"}, "the weights are not what the shares make");
    for (const int axis : {0, 1, 2}) {
      json outside = origin;
      outside[axis] = "-1" + std::string(379, '0') + "1" + tiny;
      with(at + "position", outside, "the position is outside the reference ball");
    }
  }
  // The shares have the sum 1 and make the weights, and one of them is below 0.
  json negative = good;
  negative["vertices"][1]["weight_vertices"] = {0, 1, 1}, negative["vertices"][1]["shares"] = {"1", "1", "-1"};
  out.push_back({"a share below 0", negative, "vertices[1]: the shares are not convex"});
}

void add_broken_shapes(const json& good, std::vector<Broken>& out) {
  add_other_shapes(
      good,
      {"/ball/center", "/vertices/1/position", "/pieces/2/reference/center", "/joint_sets/0/rotations/2",
       "/joint_sets/0/translations/1"},
      {"", "/ball", "/joint_sets/0", "/pieces/0", "/pieces/2", "/pieces/1/reference", "/pieces/1/bound", "/vertices/2"}, out);
  const auto alone_with = [&](const char* skinning, const json& bound) {
    return document(skinning, repeated(unturned, 3), repeated(skinning == std::string("spherical") ? origin : zero_dual, 3),
                    piece(units, small, bound), ball(origin, "1000"));
  };
  const Texts in_halves{"/pieces/0/bound/edge", "/pieces/0/bound/halves"};
  add_other_shapes(alone_with("spherical", cap(unturned)),
                   {"/joint_sets/0/center_images/2", "/joint_sets/0/rotation_center", "/pieces/0/bound/axis"},
                   {"/joint_sets/0", "/pieces/0/bound"}, out);
  add_other_shapes(alone_with("spherical", halves(0, 1, control, control)), in_halves,
                   {"/pieces/0/bound", "/pieces/0/bound/halves/1"}, out);
  add_other_shapes(alone_with("dual_quaternion", reach(unturned, origin)),
                   {"/joint_sets/0/duals/2", "/pieces/0/bound/axis", "/pieces/0/bound/center"},
                   {"/joint_sets/0", "/pieces/0/bound"}, out);
  add_other_shapes(alone_with("dual_quaternion", halves(0, 1, control, control)), in_halves, {"/pieces/0/bound"}, out);
}

void add_broken_numbers(const json& good, std::vector<Broken>& out) {
  const WithOther with{good, out};
  for (const char* number : {"1.0",  "1e0",  "+1",  " 1", "1 ", "1\n", "1_0", "0x1",  "1/",     "/1",   "1/0",
                             "1/-1", "1/+1", "--1", "",   "-",  "inf", "NaN", "1/01", "\u00b2", "1/1/1"})
    for (const char* place :
         {"/ball/radius", "/ball/center/0", "/ball/center/2", "/joint_sets/0/rotations/1/3", "/joint_sets/0/translations/2/0"})
      with(place, number, "is no Fraction");
  for (const json& value : {json(1), json(true), json(nullptr), json::array({"1"}), json::object()})
    with("/ball/radius", value, "is no Fraction");
  with("/about", 1, "certificate.about is no str");
  with("/ball/radius", std::string(401, '1'), "is no Fraction of at most 400 digits");
  with("/ball/radius", "1/1" + std::string(400, '0'), "is no Fraction of at most 400 digits");
  with("/joint_sets/0/translations/3", origin, "lists differ in length");
  with("/joint_sets", json::array(), "is no list of something");
}

// Adds bounds of rigid joints that do not prove what they should.
void add_broken_bounds(std::vector<Broken>& out) {
  const auto rigid = [&](const char* what, const json& rotations, const json& bound, const char* reason,
                         const char* skinning = "spherical") {
    const bool is_dual = skinning != std::string("spherical");
    out.push_back({what,
                   document(skinning, rotations, repeated(is_dual ? zero_dual : origin, 3), {piece(units, small, bound)},
                            ball(origin, "1000")),
                   reason});
  };
  // The control point of all three is at the distance 5 / sqrt 3, and all others at sqrt 5 at most.
  out.push_back({"the control point of three different weight vertices",
                 document("spherical", {{"1", "1", "0", "0"}, {"1", "0", "1", "0"}, {"1", "0", "0", "1"}}, repeated(origin, 3),
                          {piece(units, ball(point("1", "1", "1"), "0"), control)}, ball(origin, "57/20")),
                 "a control point is outside"});
  const json across = {"0", "1", "0", "0"};
  for (int k = 0; k < 3; ++k) {
    json turned = repeated(unturned, 3);
    turned[k] = across;
    for (const char* skinning : {"spherical", "dual_quaternion"}) {
      rigid("a right angle", turned, control, "a right angle apart", skinning);
      rigid("halves with a right angle", turned, halves((k + 1) % 3, (k + 2) % 3, control, control), "a right angle apart",
            skinning);
      for (const int edge : {-1, 3}) {
        rigid("an edge from nowhere", repeated(unturned, 3), halves(edge, k, control, control), "edge ends at no weight vertex",
              skinning);
        rigid("an edge to nowhere", repeated(unturned, 3), halves(k, edge, control, control), "edge ends at no weight vertex",
              skinning);
      }
    }
    rigid("a cap across", turned, cap(unturned), "not ahead");
    rigid("a reach across", turned, reach(unturned, origin), "not ahead", "dual_quaternion");
    turned[k] = {"-1", "0", "0", "0"};
    rigid("a cap behind", turned, cap(unturned), "not ahead");
    rigid("a reach behind", turned, reach(unturned, origin), "not ahead", "dual_quaternion");
  }
  json deep = control;
  for (int depth = 0; depth < 33; ++depth) deep = depth % 2 ? halves(0, 1, deep, control) : halves(0, 1, control, deep);
  rigid("halves too deep", repeated(unturned, 3), deep, "has too many halves of halves");
  for (const int half : {0, 1}) {
    json bound = halves(0, 1, control, control);
    bound["halves"][half] = cap({"0", "1", "0", "0"});
    rigid("a half that proves nothing", repeated(unturned, 3), bound, "not ahead");
    bound["halves"][half] = {{"by", "reach"}};
    rigid("a half by another skinning's bound", repeated(unturned, 3), bound, "no bound of this skinning");
    bound["halves"][half] = "control";
    rigid("a half that is a text", repeated(unturned, 3), bound, "is no dict");
  }
}

std::vector<Broken> broken_documents() {
  std::vector<Broken> out;
  add_broken_affine(out);
  const json good = three_pieces();
  add_broken_pieces(good, out);
  add_broken_vertices(good, out);
  add_broken_shapes(good, out);
  add_broken_numbers(good, out);
  add_broken_bounds(out);
  return out;
}

Checked check_broken() {
  CheckedFolder folder;
  const auto list = broken_documents();
  for (const Broken& b : list) folder.add(sealed(b.document));
  const auto lines = folder.check();
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!lines[i].is_rejected_for(list[i].reason)) return Checked(false, long(i), list[i].what + ": " + lines[i].text);
  return Checked(true, long(lines.size()));
}

Checked check_digests() {
  const json good =
      document("linear", {unturned}, {origin}, {piece(one_weight_vertex, ball(origin, "1"), control)}, ball(origin, "1"));
  const json whole = json::parse(sealed(good));
  const std::string digest = whole["digest"];
  CheckedFolder folder;
  folder.add(sealed(good));
  Texts others{"", std::string(64, '0'), digest + "0", digest.substr(1), digest.substr(0, 63), " " + digest};
  for (const std::size_t at : {0, 31, 63}) others.push_back(digest), others.back()[at] = digest[at] == '0' ? '1' : '0';
  others.push_back(digest);
  for (char& c : others.back()) c = static_cast<char>(std::toupper(c));
  for (const std::string& other : others) {
    json changed = whole;
    changed["digest"] = other;
    folder.add(changed.dump(1) + "\n");
  }
  const auto lines = folder.check();
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (!lines[i].is_rejected_for("digest")) return Checked(false, long(i), lines[i].text);
  return Checked(lines[0].is_accepted(), long(lines.size()), lines[0].text);
}

// Checks the same document in other layouts, each with the digest of that layout if it has a digest.
Checked check_layouts() {
  const json good =
      document("linear", {unturned}, {origin}, {piece(one_weight_vertex, ball(origin, "1"), control)}, ball(origin, "1"));
  const std::string text = sealed(good);
  std::string late = text;  // The keys are in another order.
  const std::string about = " \"about\": \"\",\n";
  late.erase(late.find(about), about.size());
  late.insert(late.find(" \"skinning\""), about);
  CheckedFolder folder;
  for (const std::string& other :
       Texts{text.substr(0, text.size() - 1), text + "\n", text + " ", " " + text, text + "\r\n", late,
             json::parse(text).dump() + "\n", json::parse(text).dump(2) + "\n", "[]\n", "[\n 1\n]\n", "\"x\"\n"})
    folder.add(other);
  const auto lines = folder.check();
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!lines[i].is_rejected_for("canonical form")) return Checked(false, long(i), lines[i].text);
  return Checked(true, long(lines.size()));
}

// --- Work ---

// Returns a number of so many digits, which is no power of two and different for each seed.
std::string digits(int count, int seed) {
  std::string out = "9";
  for (int i = 1; i < count; ++i) out += static_cast<char>('1' + (i * i + 7 * seed + i * seed) % 9);
  return out;
}

json with_weight_vertices(const char* skinning, std::size_t m, const json& bound) {
  const json data = skinning == std::string("dual_quaternion") ? zero_dual : origin;
  return document(skinning, {unturned}, {data}, {piece(repeated(alone("1"), m), ball(origin, "1"), bound)}, ball(origin, "1"));
}

json halved(int depth) { return depth == 0 ? control : halves(0, 1, halved(depth - 1), halved(depth - 1)); }

// Says whether the writer of such a certificate predicts the checker's refusal, with the same reason and figures, or that there
// is none.
bool is_known_to_writer(const std::string& certificate, const oracle::CheckedLine& line, bool is_refused = true) {
  const std::string refusal = refusal_of_certificate(certificate);
  return refusal.empty() ? !is_refused : is_refused && line.text.ends_with(refusal);
}

Checked check_work() {
  std::vector<Broken> list;
  const char* work = "the proofs take too much work";
  list.push_back({"thousands of weight vertices", with_weight_vertices("spherical", 4000, control), work});
  list.push_back({"thousands of weight vertices, of degree 2", with_weight_vertices("dual_quaternion", 4000, control), work});
  list.push_back({"halves of halves of halves", with_weight_vertices("dual_quaternion", 40, halved(10)), work});
  json pieces = with_weight_vertices("spherical", 60, control);
  pieces["pieces"] = repeated(pieces["pieces"][0], 60);
  list.push_back({"many pieces", pieces, work});
  json wide = with_weight_vertices("linear", 1, control);
  wide["pieces"][0]["weight_vertices"] = one_weight_vertex;
  wide["joint_sets"][0] = {
      {"joints", repeated(0, 900)}, {"rotations", repeated(unturned, 900)}, {"translations", repeated(origin, 900)}};
  json weights = repeated("0", 900);
  weights[0] = "1/1" + std::string(390, '0');
  wide["pieces"][0]["weight_vertices"] = repeated(weights, 40);
  list.push_back({"many joints", wide, work});
  // The lists are walked from their beginning for each place in them.
  for (const bool is_wide : {true, false}) {
    const std::size_t joints = is_wide ? 5000 : 1, places = is_wide ? 1 : 10000, shares = is_wide ? 20 : 50000;
    json walked = with_weight_vertices("linear", places, control);
    json weights = repeated("0", joints);
    weights[0] = "1";
    walked["joint_sets"][0] = {
        {"joints", repeated(0, joints)}, {"rotations", repeated(unturned, joints)}, {"translations", repeated(origin, joints)}};
    walked["pieces"][0]["weight_vertices"] = repeated(weights, places);
    for (json& vertex : walked["vertices"]) vertex["weights"] = weights;
    walked["vertices"][0]["weight_vertices"] = repeated(0, shares), walked["vertices"][0]["shares"] = repeated("1", shares);
    list.push_back({is_wide ? "many weights of a vertex" : "many shares in many weight vertices", walked, work});
  }
  json dense = with_weight_vertices("spherical", 60, control);
  dense["ball"]["radius"] = "1/1" + std::string(390, '0');
  dense["pieces"][0]["reference"]["radius"] = digits(400, 1) + "/7" + std::string(390, '0');
  list.push_back({"long numbers", dense, work});
  for (const std::string& number : {digits(401, 1), "-1/" + digits(401, 1)}) {
    dense["ball"]["radius"] = number;
    list.push_back({"longer numbers", dense, "is no Fraction of at most 400 digits each"});
  }
  dense["ball"]["radius"] = "-" + digits(400, 1) + "/" + digits(400, 3);
  list.push_back({"the longest numbers", dense, work});
  json coprime = with_weight_vertices("spherical", 2, control);
  for (int i = 0; i < 8; ++i) {
    json q = {"1", "1/" + digits(390, 3 * i), "1/" + digits(391, 3 * i + 1), "1/" + digits(392, 3 * i + 2)};
    coprime["joint_sets"][0]["rotations"].push_back(q), coprime["joint_sets"][0]["center_images"].push_back(origin);
  }
  list.push_back({"denominators without common divisors", coprime, "the common denominator has more than 8192 bits"});
  CheckedFolder folder;
  for (const Broken& b : list) folder.add(sealed(b.document));
  const Texts texts{"{\n \"about\": " + std::string(100000, '9') + "\n}\n",
                    "{\n \"about\": 0." + std::string(100000, '9') + "\n}\n", "{\n \"about\": 1e400\n}\n",
                    "{\n \"about\": NaN\n}\n", "{\n \"about\": -Infinity\n}\n"};
  for (const std::string& text : texts) folder.add(text);
  // A nested text is much longer in canonical form: it has 900 spaces for each of 30000 numbers.
  std::string nested = std::string(900, '[') + "1";
  for (int i = 0; i < 30000; ++i) nested += ",1";
  folder.add("{\"a\":" + nested + std::string(900, ']') + "}\n");
  folder.add(std::string((1 << 24) + 1, ' '));
  folder.add(std::string(1 << 24, ' '));
  const auto lines = folder.check();
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!lines[i].is_rejected_for(list[i].reason) || !is_known_to_writer(folder.text(i), lines[i]))
      return Checked(false, long(i), list[i].what + ": " + lines[i].text);
  std::size_t at = list.size();
  for (std::size_t i = 0; i < texts.size(); ++i, ++at)
    if (!lines[at].is_rejected_for("no integer of at most 9 digits")) return Checked(false, long(at), lines[at].text);
  // The writer of a certificate knows of the same length.
  const char* const too_long = "the file has more than 16777216 bytes";
  return Checked(lines[at].is_rejected() && lines[at + 1].is_rejected_for(too_long) &&
                     lines[at + 2].is_rejected_for("Expecting value") && refusal_of_length((1 << 24) + 1) == too_long &&
                     refusal_of_length(1 << 24).empty() && refusal_of_length(0).empty(),
                 long(lines.size()), lines[at].text + lines[at + 1].text + lines[at + 2].text);
}

// --- The edge of what is too much work ---

// Returns the document with a ball far too small, which is seen without work, and denominators whose least common multiple has
// exactly so many bits.
json with_denominators(json document, int bits) {
  struct Power {
    int base, exponent;
    const char* place;
  };
  static const Power powers[] = {{3, 830, "/ball/center/0"},
                                 {5, 570, "/ball/center/1"},
                                 {7, 470, "/ball/center/2"},
                                 {11, 380, "/pieces/0/reference/center/0"},
                                 {13, 355, "/pieces/0/reference/center/1"},
                                 {17, 320, "/pieces/0/reference/center/2"}};
  const auto put = [&](int base, int exponent, const char* place) {
    Rational number(1);
    for (int i = 0; i < exponent; ++i) number /= base;
    document[json::json_pointer(place)] = as_text(number);
  };
  double odd = 0;
  for (const Power& p : std::span(powers, bits > 7000 ? 6 : 4)) {
    put(p.base, p.exponent, p.place);
    odd += p.exponent * std::log2(p.base);
  }
  put(2, bits - static_cast<int>(std::floor(odd)) - 1, "/ball/radius");
  return document;
}

struct Sized {
  json bound;
  std::size_t weight_vertices;
};

json of_sizes(const char* skinning, std::size_t joints, const std::vector<Sized>& sizes) {
  const json data = skinning == std::string("dual_quaternion") ? zero_dual : origin;
  json weights = repeated("0", joints), pieces = json::array();
  weights[0] = "1";
  for (const Sized& s : sizes) pieces.push_back(piece(repeated(weights, s.weight_vertices), ball(origin, "1"), s.bound));
  json out = document(skinning, repeated(unturned, joints), repeated(data, joints), pieces, ball(origin, "1"));
  out["vertices"].erase(out["vertices"].begin() + 1, out["vertices"].end());
  return out;
}

// Checks the limit of work. With 6144 to 6399 bits a unit of work counts as 25^2, so that 800 units are all that is allowed.
Checked check_work_edges() {
  const json turned = cap(unturned), reached = reach(unturned, origin);
  const struct {
    const char* skinning;
    std::size_t joints;
    // The sizes make 800 units in all: m n, (m + d - 1 choose d) for each bound, 1 + n for a vertex.
    std::vector<Sized> sizes;
    // This document has two units for one joint and weight vertex.
    json least;
  } sized[] = {
      {"linear", 1, {{control, 399}}, control},
      {"linear", 9, {{control, 79}}, control},
      {"linear", 1, {{control, 100}, {control, 250}, {control, 49}}, control},
      {"spherical", 1, {{control, 14}, {all_rotations, 112}}, all_rotations},
      {"spherical", 1, {{all_rotations, 399}}, all_rotations},
      {"spherical", 3, {{turned, 199}}, turned},
      {"spherical", 1, {{halves(0, 1, control, control), 12}, {turned, 23}}, turned},
      {"spherical", 1, {{halves(0, 1, turned, halves(0, 1, control, control)), 8}, {turned, 263}}, all_rotations},
      {"dual_quaternion", 1, {{control, 37}, {reached, 29}}, control},
      {"dual_quaternion", 1, {{reached, 399}}, reached},
      {"dual_quaternion", 1, {{halves(0, 1, control, control), 26}, {reached, 22}}, reached},
  };
  CheckedFolder folder;
  Texts expected;
  const auto add = [&](const json& document, const char* reason) { folder.add(sealed(document)), expected.push_back(reason); };
  // These are parts of two reasons: the ball of a bound is outside, or it is smaller than the reference.
  const char *too_much = "too much work", *little = "the ball";
  for (const auto& s : sized) {
    const json whole = of_sizes(s.skinning, s.joints, s.sizes);
    auto more = s.sizes;
    more.push_back({s.least, 1});
    const json beyond = of_sizes(s.skinning, s.joints, more);
    add(with_denominators(whole, 6144), little), add(with_denominators(whole, 6399), little);
    add(with_denominators(beyond, 6144), too_much), add(with_denominators(beyond, 6143), little);
    add(with_denominators(whole, 6400), too_much);
    for (const char* longer : {"2", "-2"}) {
      json changed = with_denominators(whole, 6399);
      changed["pieces"][0]["reference"]["center"][2] = longer;
      add(changed, too_much);
    }
  }
  // The vertices take 1 + 2 * 3 units for three shares of two weights, and the piece takes 2 + 1.
  json listed = of_sizes("linear", 2, {{control, 1}});
  json vertex = listed["vertices"][0];
  vertex["weight_vertices"] = {0, 0, 0}, vertex["shares"] = {"1", "1", "1"};
  listed["vertices"] = repeated(vertex, 113);  // The sum is 794 units.
  for (const int more : {1, 2}) {
    vertex["weight_vertices"].erase(0), vertex["shares"].erase(0);
    listed["vertices"].push_back(vertex);  // The vertex takes 5 units, then 3.
    add(with_denominators(listed, 6144), more == 1 ? little : too_much);
  }
  const json one = with_weight_vertices("linear", 1, control);
  add(with_denominators(one, 8192), little), add(with_denominators(one, 8193), "the common denominator has more than 8192 bits");
  const auto lines = folder.check();
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!lines[i].is_rejected_for(expected[i]) || !is_known_to_writer(folder.text(i), lines[i], expected[i] != little))
      return Checked(false, long(i), std::to_string(i) + ": " + lines[i].text);
  return Checked(true, long(lines.size()));
}

// Checks as many denominators as a file has room for. Their least common multiple alone would take minutes.
Checked check_many_denominators() {
  json many = with_weight_vertices("spherical", 1, control);
  for (int i = 0; i < 12000; ++i) {
    json q = {"1"};
    for (int k = 0; k < 3; ++k) q.push_back("1/1" + std::string(380, '0') + std::to_string(100001 + 6 * i + 2 * k));
    many["joint_sets"][0]["rotations"].push_back(q);
  }
  CheckedFolder folder;
  folder.add(sealed(many));
  const auto line = folder.check()[0];
  return Checked(line.is_rejected_for("the common denominator has more than 8192 bits"), 36000, line.text);
}

// --- Names and texts from outside ---

// Says whether each line begins with a verdict and is printable ASCII, and there are as many lines as files.
bool is_orderly(const oracle::CheckerRun& run, std::size_t files, const std::string& verdict) {
  for (const std::string& line : run.lines) {
    if (!line.starts_with(verdict + ": \"")) return false;
    for (const char c : line)
      if (c < ' ' || c > '~') return false;
  }
  return run.lines.size() == files;
}

Checked check_names() {
  const json good =
      document("linear", {unturned}, {origin}, {piece(one_weight_vertex, ball(origin, "1"), control)}, ball(origin, "1"));
  const Texts names{"a\nb",
                    "x\naccepted: \"good.json\": 1 linear pieces",
                    "\naccepted: y",
                    "\x1b[2J\x1b[1;1Haccepted: z",
                    "\xff\xfe",
                    "\r",
                    "\t",
                    "accepted: \"good.json\": 1 linear pieces",
                    "q\": accepted",
                    "b\\",
                    "\xc3\xa4",
                    "\xe2\x80\xa8",
                    "\x7f",
                    " ",
                    "-",
                    "$(id)",
                    "'",
                    "*"};
  for (const bool is_good : {false, true}) {
    TemporaryFolder folder;
    for (const std::string& name : names) std::ofstream(folder.file(name + ".json")) << (is_good ? sealed(good) : "");
    const auto run = oracle::run_checker(folder.path());
    if (run.status != (is_good ? 0 : 1) || !is_orderly(run, names.size(), is_good ? "accepted" : "rejected"))
      return Checked(false, long(run.lines.size()), run.lines.empty() ? "nothing said" : run.lines[0]);
  }
  CheckedFolder abouts;
  for (const std::string& about :
       Texts{"x\naccepted: \"y\": 1 linear pieces", "\x1b[2J", "\r", "\x7f", "\u00e4\u2028", "\"", std::string(100000, 'x')}) {
    json named = good;
    named["about"] = about;
    abouts.add(sealed(named));
  }
  if (!is_orderly(oracle::run_checker(abouts.path()), abouts.size(), "accepted")) return Checked(false, 0, "about");
  CheckedFolder texts;
  const std::string forged = "x\naccepted: \"y\": 1 linear pieces\x1b[2J\u00e4";
  for (const char* place :
       {"/skinning", "/ball/radius", "/ball/center/0", "/pieces/0/bound/by", "/pieces/0/joint_set", "/digest"}) {
    json changed = good;
    changed[json::json_pointer(place)] = forged;
    texts.add(sealed(changed));
  }
  for (const char* place : {"", "/ball", "/pieces/0", "/pieces/0/bound", "/joint_sets/0"}) {
    json changed = good;
    changed[json::json_pointer(place)][forged] = forged;
    texts.add(sealed(changed));
  }
  texts.add(forged), texts.add("{\"" + forged), texts.add("{" + forged);
  // Sealing overwrites the digest that was put there, so this one is accepted.
  const auto run = oracle::run_checker(texts.path());
  for (const std::string& line : run.lines)
    if (!line.starts_with("rejected: \"") &&
        !line.starts_with("accepted: \"" + texts.path() + "/000005.json\": 1 linear pieces, said to be \"\""))
      return Checked(false, 0, line);
  return Checked(run.lines.size() == texts.size(), long(names.size() + abouts.size() + texts.size()));
}

// --- What cannot be read ---

Checked check_statuses() {
  const json good =
      document("linear", {unturned}, {origin}, {piece(one_weight_vertex, ball(origin, "1"), control)}, ball(origin, "1"));
  TemporaryFolder folder, empty;
  const std::string accepted = folder.file("good"), rejected = folder.file("bad"), absent = folder.file("absent"),
                    odd = folder.file("odd");
  std::ofstream(accepted) << sealed(good);
  std::ofstream(rejected) << "";
  std::filesystem::create_directories(odd + "/folder.json");
  std::filesystem::create_symlink(absent, odd + "/link.json");
  std::ofstream(odd + "/z.json") << sealed(good);
  const std::string pipes = folder.file("pipes");
  std::filesystem::create_directories(pipes);
  if (::mkfifo((pipes + "/a.json").c_str(), 0600) != 0) return Checked(false, 0, "no pipe could be made");
  std::filesystem::create_symlink("/dev/zero", pipes + "/b.json");
  std::ofstream(pipes + "/c.json") << sealed(good);
  struct Case {
    std::string arguments;
    int status;
    Texts verdicts;
  };
  const Case cases[] = {{accepted, 0, {"accepted"}},
                        {rejected, 1, {"rejected"}},
                        {absent, 2, {"unreadable"}},
                        {empty.path(), 2, {"unreadable"}},
                        {accepted + " " + rejected, 1, {"accepted", "rejected"}},
                        {rejected + " " + accepted, 1, {"rejected", "accepted"}},
                        {absent + " " + rejected + " " + accepted, 2, {"unreadable", "rejected", "accepted"}},
                        {rejected + " " + absent, 2, {"rejected", "unreadable"}},
                        {accepted + " " + empty.path(), 2, {"accepted", "unreadable"}},
                        {odd, 2, {"unreadable", "unreadable", "accepted"}},
                        {pipes, 2, {"unreadable", "unreadable", "accepted"}},
                        {accepted + " " + pipes + "/a.json", 2, {"accepted", "unreadable"}}};
  for (const Case& c : cases) {
    const auto run = oracle::run_checker(c.arguments);
    bool is_said = run.status == c.status && run.lines.size() == c.verdicts.size();
    for (std::size_t i = 0; is_said && i < c.verdicts.size(); ++i) is_said = run.lines[i].starts_with(c.verdicts[i] + ": \"");
    if (!is_said) return Checked(false, run.status, c.arguments + ": " + (run.lines.empty() ? "" : run.lines[0]));
  }
  return Checked(oracle::run_checker("").status == 2, std::size(cases));
}

}  // namespace

PROPTEST(check) {
  t.holds("a ball is accepted if its bound needs as little, and a slightly smaller one is rejected", {.cases = 12},
          check_least_radii);
  t.example(
      "equality is accepted, and a radius smaller by 1e-380 rejected, whichever weight vertex, triple or piece is the farthest",
      {}, check_tight);
  t.example("each condition broken alone is rejected for its reason", {}, check_broken);
  t.example("another digest is rejected", {}, check_digests);
  t.example("another layout of the same document is rejected", {}, check_layouts);
  t.example("what would take long is rejected before it begins", {}, check_work);
  t.example("the work that is allowed, and one unit more", {}, check_work_edges);
  t.example("a file full of denominators is rejected before they are multiplied", {}, check_many_denominators);
  t.example("no name and no text of a file forges a verdict", {}, check_names);
  t.example("exit status and verdicts of files that are accepted, rejected and unreadable", {}, check_statuses);
}

}  // namespace proptests::suite_check
