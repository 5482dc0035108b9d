// SPDX-License-Identifier: GPL-3.0-or-later
// Separation: its steps come to each pair of triangles once, and what they say of it is so, to the last digit.
#include "algorithms/certificate/separation.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/posed_bodies.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/parted.hpp"
#include "proptests/oracles/triangles_meet.hpp"

namespace proptests::suite_separation {
namespace {

using namespace refitlab;
using Set = std::vector<int>;

bool is_order(std::vector<int> order, std::size_t count) {
  std::ranges::sort(order);
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return order == all;
}

std::pair<Set, Set> halves(const Set& set) {
  const auto middle = set.begin() + static_cast<std::ptrdiff_t>(set.size() / 2);
  return {Set(set.begin(), middle), Set(middle, set.end())};
}

// Follows the steps, and says what is wrong with them.
std::string wrong_with(const Separation& s, const PosedBody& first, const PosedBody& second) {
  if (!is_order(s.first_order, first.triangles.size()) || !is_order(s.second_order, second.triangles.size())) return "the orders";
  std::vector<std::pair<Set, Set>> todo{{s.first_order, s.second_order}};
  std::size_t contacts = 0;
  for (const SeparationStep& step : s.steps) {
    if (todo.empty()) return "there are steps too many";
    const auto [a, b] = todo.back();
    todo.pop_back();
    if (const auto* halved = std::get_if<Halved>(&step)) {
      const bool is_first = *halved == Halved::first;
      const auto [one, other] = halves(is_first ? a : b);
      if (one.empty() || other.empty()) return "a half is empty";
      todo.emplace_back(is_first ? other : a, is_first ? b : other);
      todo.emplace_back(is_first ? one : a, is_first ? b : one);
    } else if (const auto* plane = std::get_if<PartingPlane>(&step)) {
      for (const int t : a)
        for (const int u : b)
          if (!oracle::parts(*plane, first.triangle(t), second.triangle(u))) return "a plane";
    } else {
      if (a.size() != 1 || b.size() != 1 || contacts == s.contacts.size()) return "a contact that is none";
      const auto& [pair, point] = s.contacts[contacts++];
      if (pair != TrianglePair{a[0], b[0]}) return "a contact of another pair";
      if (!oracle::is_common_point(point, first.triangle(a[0]), second.triangle(b[0]))) return "a contact's point";
    }
  }
  return todo.empty() && contacts == s.contacts.size() ? "" : "there are steps too few";
}

void check_two_bodies() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto bodies = gen::two_bodies(random);
  const Separation found = separate(bodies.first, bodies.second);
  RC_CLASSIFY(gen::is_degenerate(bodies), "degenerate");
  RC_CLASSIFY(!found.contacts.empty(), "touch");
  const std::string wrong = wrong_with(found, bodies.first, bodies.second);
  if (!wrong.empty()) RC_FAIL(wrong);
  // Some pairs by another decision.
  std::vector<TrianglePair> pairs;
  for (const auto& contact : found.contacts) pairs.push_back(contact.pair);
  for (int i = 0; i < 10; ++i) {
    const int t = std::uniform_int_distribution<int>(0, int(bodies.first.triangles.size()) - 1)(random),
              u = std::uniform_int_distribution<int>(0, int(bodies.second.triangles.size()) - 1)(random);
    RC_ASSERT(oracle::triangles_meet(bodies.first.triangle(t), bodies.second.triangle(u)) ==
              (std::ranges::find(pairs, TrianglePair{t, u}) != pairs.end()));
  }
}

bool refuses(const PosedBody& first, const PosedBody& second) {
  try {
    separate(first, second);
    return false;
  } catch (const std::invalid_argument&) {
    return true;
  }
}

}  // namespace

PROPTEST(separation) {
  t.holds("the steps come to each pair of triangles, and their planes and contacts are right in exact arithmetic",
          {.number_type = "double against rational", .cases = 300, .degenerate_at_least = 0.5}, check_two_bodies);
  t.example("two procedural men with thousands of triangles touch where a query of all pairs finds it, in a few steps a contact",
            {}, [] {
              const auto man = bake(make_man());
              std::mt19937 random(2006);
              const ClusterTree tree(man);
              const Pose poses[] = {gen::random_pose(man.mesh, random, 0.1), gen::random_pose(man.mesh, random, 0.1)};
              const RigidTransform<double> here{{1, 0, 0, 0}, {0, 0, 0}}, there{{1, 0, 0, 0}, {0.25, 0.125, 0.25}};
              ClusterBody a(tree, Skinning::linear), b(tree, Skinning::linear);
              a.begin(poses[0], here), b.begin(poses[1], there);
              const Separation found = separate(posed_body(a, ""), posed_body(b, ""));
              std::vector<TrianglePair> pairs;
              for (const auto& contact : found.contacts) pairs.push_back(contact.pair);
              const auto wanted = oracle::all_pairs({man, poses[0], here}, {man, poses[1], there}, Skinning::linear);
              return Checked(oracle::sorted(pairs) == wanted && pairs.size() > 50 && found.steps.size() < 60 * pairs.size(),
                             long(pairs.size()), std::to_string(found.steps.size()) + " steps");
            });
  t.example("bodies far apart take one step, and in the units of the smallest numbers too many digits are not tried in double",
            {}, [] {
              const auto body = [](double x, double unit) {
                return PosedBody{"", {{x, 0, 0}, {x + unit, 0, 0}, {x, unit, 0}}, {{0, 1, 2}, {2, 1, 0}}};
              };
              const auto steps = [](const PosedBody& a, const PosedBody& b) { return separate(a, b).steps.size(); };
              return steps(body(0, 1), body(3, 1)) == 1 && steps(body(0, 0x1p-1074), body(3, 0x1p-1074)) == 1 &&
                     separate(body(0, 0x1p-1074), body(0x1p-1073, 0x1p-1074)).contacts.empty();
            });
  t.example("two long bodies beside each other, shifted by half their length, take one step", {}, [] {
    const auto bar = [](double x, double y) {
      PosedBody body{"", {}, {}};
      for (int k = 0; k <= 20; ++k)
        for (const double side : {0., 1.}) body.vertices.push_back({x + k / 2., y + side, k % 3 * 0.25});
      for (int v = 0; v + 2 < static_cast<int>(body.vertices.size()); ++v) body.triangles.push_back({v, v + 1, v + 2});
      return body;
    };
    const Separation beside = separate(bar(0, 0), bar(5, 1.5));
    return Checked(beside.steps.size() == 1 && std::holds_alternative<PartingPlane>(beside.steps[0]), 1,
                   std::to_string(beside.steps.size()) + " steps");
  });
  t.example("bodies that are none are refused", {}, [] {
    const PosedBody good{"", {{0, 0, 0}}, {{0, 0, 0}}};
    const double infinity = std::numeric_limits<double>::infinity();
    const PosedBody bad[] = {{"", {{0, 0, 0}}, {}},
                             {"", {{0, 0, 0}}, {{0, 0, 1}}},
                             {"", {{0, 0, 0}}, {{0, -1, 0}}},
                             {"", {{0, infinity, 0}}, {{0, 0, 0}}},
                             {"", {{0, std::nan(""), 0}}, {{0, 0, 0}}}};
    bool all = !refuses(good, good);
    for (const PosedBody& body : bad) all = all && refuses(body, good) && refuses(good, body);
    return all;
  });
}

}  // namespace proptests::suite_separation
