// SPDX-License-Identifier: GPL-3.0-or-later
// Tests certificates of touching triangles and their checker, proptests/certificate/check_pairs: what is true is accepted, and
// each condition of the checker is needed to reject something false.
#include "algorithms/certificate/pairs_certificate.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/posed_bodies.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/checked_folder.hpp"

namespace proptests::suite_pairs_certificate {
namespace {

using namespace refitlab;
using nlohmann::json;
using oracle::CheckedFolder;
using oracle::sealed;

std::vector<TrianglePair> touching(const PosedBody& first, const PosedBody& second) {
  std::vector<TrianglePair> out;
  for (const auto& contact : separate(first, second).contacts) out.push_back(contact.pair);
  return out;
}

// Says whether the document has these bodies, to the last bit, and these pairs.
bool is_about(const json& document, const PosedBody& first, const PosedBody& second, const std::vector<TrianglePair>& pairs) {
  bool all = document["contacts"].size() == pairs.size();
  for (const auto& [name, body] : {std::pair{"first", &first}, std::pair{"second", &second}}) {
    const json& stated = document[name];
    all = all && stated["name"] == body->name && stated["triangles"] == json(body->triangles) &&
          stated["vertices"].size() == body->vertices.size();
    for (std::size_t v = 0; all && v < body->vertices.size(); ++v)
      for (int i = 0; i < 3; ++i)
        all = all && Rational(stated["vertices"][v][i].get<std::string>()) == Rational(body->vertices[v][i]);
  }
  for (const json& contact : document["contacts"])
    all = all && std::ranges::find(pairs, TrianglePair{contact["pair"][0], contact["pair"][1]}) != pairs.end();
  return all;
}

// Checks ten pairs of bodies of one kind, for which the checker is started once.
void check_random_bodies() {
  CheckedFolder folder(oracle::pairs_checker());
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const bool is_generic = gen::any_place(3) == 0;  // as is another one in seven of the rest
  const auto kind = is_generic ? gen::BodiesKind::anywhere : static_cast<gen::BodiesKind>(gen::any_place(gen::bodies_kind_count));
  RC_CLASSIFY(kind != gen::BodiesKind::anywhere, "degenerate");
  for (int i = 0; i < 10; ++i) {
    const auto bodies = gen::two_bodies(random, kind);
    const PosedBody &first = bodies.first, &second = bodies.second;
    auto pairs = touching(first, second);
    std::ranges::shuffle(pairs, random);
    try {
      const std::string text = pairs_certificate("", first, second, pairs);
      RC_ASSERT(is_about(json::parse(text), first, second, pairs));
      folder.add(text);
    } catch (const NoProof& error) {
      RC_TAG("too many digits");
      RC_ASSERT(std::string(error.what()).find("digits") != std::string::npos);
    }
  }
  for (const auto& line : folder.check())
    if (!line.is_accepted()) RC_FAIL(line.text);
}

// Checks what a query says of a character in two poses.
Checked check_query(const Character& c, const Pose& pose, const Pose& other, Skinning skinning, const Point3& at) {
  const ClusterTree tree(c);
  ClusterBody a(tree, skinning), b(tree, skinning);
  a.begin(pose, {{1, 0, 0, 0}, {0, 0, 0}}), b.begin(other, {{1, 0, 0, 0}, at});
  QueryCounts counts;
  const auto pairs = collide(a, b, Query::full, counts);
  CheckedFolder folder(oracle::pairs_checker());
  folder.add(pairs_certificate(c.mesh.name, posed_body(a, "first"), posed_body(b, "second"), pairs));
  const auto line = folder.check()[0];
  return Checked(line.is_accepted(), static_cast<long>(pairs.size()), line.text);
}

Checked check_file(const std::string& file) {
  const std::string path = "out/models/" + file;
  if (!std::filesystem::exists(path)) return Checked::skip(path + " is not there");
  const AnimatedCharacter c = bake_animated(load_model(path));
  const Clip& clip = c.clips.at(0);
  return check_query(c, clip.sample(0.25 * clip.duration), clip.sample(0.75 * clip.duration), Skinning::linear, {0.3, 0, 0.1});
}

// --- Forgeries ---

// The first body has two triangles in the plane z = 0, and the second has three: two touch, and one is apart.
const PosedBody flat{"flat", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}, {{0, 1, 2}, {1, 3, 2}}};
const PosedBody upright{
    "upright", {{1, 1, -1}, {1, 1, 1}, {1, 2, 2}, {3, 3, 0}, {3, 3, 5}, {4, 3, 6}, {9, 9, 9}}, {{0, 1, 2}, {3, 4, 5}, {6, 6, 6}}};

json honest() { return json::parse(pairs_certificate("", flat, upright, {{0, 0}, {1, 1}})); }

// Returns the place of the first step of a kind.
json& step_of(json& document, const std::string& kind) {
  for (json& step : document["steps"])
    if (step.is_object() ? kind == "plane" : step == kind) return step;
  throw std::logic_error("there is no step " + kind);
}

struct Forgery {
  const char* reason;
  std::function<void(json&)> change;
};

std::vector<Forgery> forged_steps() {
  return {
      {"contacts too few", [](json& d) { d["contacts"].erase(1); }},
      {"contacts too many", [](json& d) { d["contacts"].push_back(d["contacts"][1]); }},
      {"steps too few", [](json& d) { d["steps"] = json::array(); }},
      {"of another pair", [](json& d) { std::swap(d["contacts"][0], d["contacts"][1]); }},
      {"of another pair", [](json& d) { d["contacts"][0]["pair"][0] = 1; }},
      {"of another pair", [](json& d) { d["contacts"][0]["pair"][1] = 2; }},
      {"is no step", [](json& d) { d["steps"][0] = "third"; }},
      {"is no step", [](json& d) { d["steps"][0] = json::array(); }},
      {"not the members", [](json& d) { step_of(d, "plane")["more"] = "0"; }},
      {"no single triangle", [](json& d) { d["steps"] = {"contact"}; }},
      {"not before the plane", [](json& d) { step_of(d, "plane")["offset"] = "-1000"; }},
      {"not behind the plane", [](json& d) { step_of(d, "plane")["offset"] = "1000"; }},
      {"the plane",
       [](json& d) {
         step_of(d, "plane")["normal"] = {"0", "0", "0"};
       }},
      {"not before the plane",
       [](json& d) {
         step_of(d, "contact") = {{"normal", {"0", "0", "1"}}, {"offset", "0"}};
       }},
      {"not behind the plane",
       [](json& d) {
         step_of(d, "contact") = {{"normal", {"0", "0", "1"}}, {"offset", "1/2"}};
       }},
      {"not behind the plane",
       [](json& d) {
         for (json& vertex : d["second"]["vertices"]) vertex = {"0", "0", "1"};
         d["contacts"] = json::array();
         d["steps"] = json::array({{{"normal", {"0", "0", "1"}}, {"offset", "1"}}});
       }},
      {"steps too few", [](json& d) { d["steps"].erase(d["steps"].size() - 1); }},
      {"steps too many", [](json& d) { d["steps"].push_back("first"); }},
  };
}

std::vector<Forgery> forged_bodies_and_contacts() {
  return {
      {"each triangle once",
       [](json& d) {
         d["first_order"] = {0, 0};
       }},
      {"each triangle once", [](json& d) { d["first_order"] = {0}; }},
      {"each triangle once",
       [](json& d) {
         d["second_order"] = {0, 1, 2, 2};
       }},
      {"each triangle once",
       [](json& d) {
         d["second_order"] = {0, 1, 3};
       }},
      {"vertex that is not there", [](json& d) { d["first"]["triangles"][0][0] = 4; }},
      {"vertex that is not there", [](json& d) { d["first"]["triangles"][0][0] = -1; }},
      {"each triangle once", [](json& d) { d["first"]["triangles"].erase(1); }},
      {"not convex",
       [](json& d) {
         d["contacts"][0]["first"] = {"2", "-1", "0"};
       }},
      {"not convex",
       [](json& d) {
         d["contacts"][0]["second"] = {"1", "1", "0"};
       }},
      {"not convex",
       [](json& d) {
         d["contacts"][0]["first"] = d["contacts"][0]["second"] = {"0", "0", "0"};
       }},
      {"two points",
       [](json& d) {
         d["contacts"][0]["second"] = {"1", "0", "0"};
       }},
      {"two points",
       [](json& d) {
         d["contacts"][0]["second"] = {"0", "1", "0"};
       }},
      {"digits each", [](json& d) { step_of(d, "plane")["offset"] = std::string(401, '7'); }},
      {"more than 8192 bits",
       [](json& d) {
         for (int i = 0; i < 7; ++i) {
           std::string below(400, '0');
           below[0] = '1', below[399] = "1379137"[i], below[7] = static_cast<char>('0' + i);
           d["first"]["vertices"].push_back({"1/" + below, "1/" + below.replace(90, 1, "1"), "1/" + below.replace(91, 1, "1")});
         }
       }},
      {"too much work",
       [](json& d) {
         for (int i = 0; i < 20000; ++i) d["first"]["triangles"].push_back({0, 1, 2}), d["first_order"].push_back(i + 2);
         d["steps"] = json::array();
         for (int i = 0; i < 1200; ++i) d["steps"].push_back("second");
         for (int i = 0; i < 1201; ++i) d["steps"].push_back({{"normal", {"0", "0", "1"}}, {"offset", "0"}});
       }},
  };
}

Checked forged_are_rejected() {
  CheckedFolder folder(oracle::pairs_checker());
  folder.add(sealed(honest()));
  std::vector<Forgery> all = forged_steps();
  for (const Forgery& forgery : forged_bodies_and_contacts()) all.push_back(forgery);
  for (const Forgery& forgery : all) {
    json document = honest();
    forgery.change(document);
    folder.add(sealed(document));
  }
  json unsealed = honest();
  unsealed["about"] = "else";
  folder.add(unsealed.dump(1, ' ', true) + "\n");
  folder.add(honest().dump(2) + "\n");
  const auto lines = folder.check();
  std::string wrong = lines[0].is_accepted() ? "" : lines[0].text + "; ";
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!lines[i + 1].is_rejected_for(all[i].reason)) wrong += std::string(all[i].reason) + ": " + lines[i + 1].text + "; ";
  if (!lines[lines.size() - 2].is_rejected_for("digest")) wrong += "the digest; ";
  if (!lines.back().is_rejected_for("canonical")) wrong += "the layout; ";
  return Checked(wrong.empty(), long(lines.size()), wrong);
}

bool has_no_certificate(const PosedBody& first, const PosedBody& second, const std::vector<TrianglePair>& pairs) {
  try {
    pairs_certificate("", first, second, pairs);
    return false;
  } catch (const NoProof&) {
    return true;
  }
}

// Returns the checker's words for a certificate against two documents.
std::string against(const std::string& first, const std::string& second) {
  const TemporaryFolder folder;
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.file(name), std::ios::binary) << text;
    return folder.file(name);
  };
  const std::string one = put("one.json", sealed(honest()));
  const auto run =
      oracle::run_checker("--against " + put("a", first) + " " + put("b", second) + " " + one, oracle::pairs_checker());
  return run.lines.empty() ? "" : run.lines[0];
}

// --- Documents that are refused for their size alone, and prove nothing ---

struct Size {
  // These are the numbers of triangles. The first body's are halved, then the second's, in 3 and 4 steps.
  int first, second;
  // These are the most bits of each denominator of a contact, of a plane and of a body.
  int weights, plane, vertices;
  // These are the bits of the bodies' common denominator, or 0 if they do not matter.
  int common;
  // It is in the checker's words, or nothing.
  const char* reason;
};

// Returns the largest power that has no more bits than this.
CGAL::Gmpz power(int prime, int bits) {
  CGAL::Gmpz out(1);
  while (CGAL::Gmpz(out * prime).bit_size() <= static_cast<std::size_t>(bits)) out *= prime;
  return out;
}
json fraction(int prime, int bits) { return as_text(Rational(CGAL::Gmpz(1), power(prime, bits))); }

std::string sized(const Size& size) {
  const auto three = [](std::array<int, 3> primes, int bits) {
    return json{fraction(primes[0], bits), fraction(primes[1], bits), fraction(primes[2], bits)};
  };
  json document{{"about", ""}, {"contacts", json::array()}, {"digest", ""}, {"steps", {"first", "second"}}};
  document["contacts"].push_back(
      {{"pair", {0, 0}}, {"first", three({3, 5, 7}, size.weights)}, {"second", three({11, 13, 17}, size.weights)}});
  for (int i = 0; i < 3; ++i)
    document["steps"].push_back({{"normal", three({3, 5, 7}, size.plane)}, {"offset", fraction(11, size.plane)}});
  CGAL::Gmpz odd(1);
  for (const int prime : {3, 5, 7, 11, 13, 17}) odd *= power(prime, size.vertices);
  const int twos = size.common ? size.common - static_cast<int>(odd.bit_size()) : 0;
  const auto add_body = [&](const std::string& name, int count, const json& vertex) {
    document[name] = {{"name", ""}, {"vertices", json::array({vertex, three({2, 2, 2}, twos + 1)})}};
    document[name]["triangles"] = json(json::array_t(static_cast<std::size_t>(count), json{0, 0, 0}));
    for (int i = 0; i < count; ++i) document[name + "_order"].push_back(i);
  };
  add_body("first", size.first, three({3, 5, 7}, size.vertices));
  add_body("second", size.second, three({11, 13, 17}, size.vertices));
  return sealed(document);
}

// Checks whether the writer of such a certificate predicts the checker's refusal, with the same reason and figures, or that there
// is none. An even and an odd number are halved; 25^2 (3 4000 + 4 5000) is the limit.
Checked check_sizes() {
  const char *work = "the proof takes too much work", *bits = "a common denominator has more than 8192 bits";
  const std::vector<Size> sizes = {{4000, 5000, 1136, 9, 9, 0, nullptr}, {4001, 5000, 1136, 9, 9, 0, work},
                                   {4001, 4999, 1136, 9, 9, 0, nullptr}, {4000, 5000, 9, 9, 1060, 0, nullptr},
                                   {4000, 5001, 9, 9, 1060, 0, work},    {7000, 8600, 9, 1326, 9, 0, nullptr},
                                   {7001, 8600, 9, 1326, 9, 0, work},    {2, 2, 9, 9, 1320, 8192, nullptr},
                                   {2, 2, 9, 9, 1320, 8193, bits},       {2, 2, 9, 9, 9, 0, nullptr}};
  CheckedFolder folder(oracle::pairs_checker());
  for (const Size& s : sizes) folder.add(sized(s));
  const auto lines = folder.check();
  std::string wrong;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string refusal = refusal_of_pairs_certificate(folder.text(i));
    const bool is_right = sizes[i].reason ? refusal.starts_with(sizes[i].reason) && lines[i].text.ends_with(refusal)
                                          : refusal.empty() && lines[i].is_rejected_for("step");
    if (!is_right) wrong += lines[i].text + " (" + refusal + ") ";
  }
  return Checked(wrong.empty(), static_cast<long>(sizes.size()), wrong);
}

}  // namespace

PROPTEST(pairs_certificate) {
  t.holds("random bodies have certificates of their touching triangles, about these very bodies, and all are accepted",
          {.number_type = "double against rational", .cases = 40, .degenerate_at_least = 0.25}, check_random_bodies);
  t.holds("what a query finds of random meshes has a certificate, by every way of skinning, and it is accepted",
          {.number_type = "double against rational", .cases = 15, .degenerate_at_least = 0.2}, [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan));
            std::mt19937 random(plan.seed);
            const Pose pose = gen::random_pose(c.mesh, random, 0.2), other = gen::random_pose(c.mesh, random, 0.2);
            const auto skinning = *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion);
            const auto checked = check_query(c, pose, other, skinning, {*rc::gen::element(0., 0.25), 0, 0});
            if (!checked.passed) RC_FAIL(checked.detail);
          });
  for (const char* file : {"Testwuson.X", "Soldier.glb"})
    t.example("what a query finds of two moments of a clip has a certificate, and it is accepted: " + std::string(file), {},
              [=] { return check_file(file); });
  t.example("other pairs than those that touch have no certificate", {}, [] {
    return !has_no_certificate(flat, upright, {{1, 1}, {0, 0}}) && has_no_certificate(flat, upright, {{0, 0}}) &&
           has_no_certificate(flat, upright, {{0, 0}, {1, 1}, {0, 1}}) && has_no_certificate(flat, upright, {}) &&
           has_no_certificate(flat, upright, {{0, 0}, {1, 1}, {1, 1}});
  });
  t.example("a reason with more digits than checkers read has no certificate", {}, [] {
    const double small = 0x1p-1000, large = 0x1p1000;
    const PosedBody a{"", {{0, 0, 0}, {large, small, 0}, {1, large, 1}}, {{0, 1, 2}}},
        b{"", {{1, 1, -small}, {1, 2, large}, {small, 1, 1}}, {{0, 1, 2}}};
    return has_no_certificate(a, b, touching(a, b));
  });
  t.example("each way of forging a certificate is rejected, for its own reason", {}, forged_are_rejected);
  t.example("what the checker refuses for its size alone, the writer tells of, with the same figures", {}, check_sizes);
  t.example("against documents, the bodies are theirs to the last character", {}, [] {
    const auto says = [](const std::string& line, const std::string& what) { return line.find(what) != std::string::npos; };
    const std::string a = body_document(flat), b = body_document(upright);
    PosedBody moved = flat;
    moved.vertices[0][0] = 0x1p-1074;
    return against(a, b).starts_with("accepted: ") && says(against(body_document(moved), b), "the first body is another one") &&
           says(against(a, body_document(moved)), "the second body is another one") &&
           says(against(b, a), "the first body is another one") && against(a + " ", b).starts_with("unreadable: ") &&
           against(a, "{}\n").starts_with("unreadable: ");
  });
}

}  // namespace proptests::suite_pairs_certificate
