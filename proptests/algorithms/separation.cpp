// SPDX-License-Identifier: GPL-3.0-or-later
// Tests separation: its steps come to each pair of triangles once, and what they say of it is true, exactly.
#include "algorithms/certificate/separation.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/posed_bodies.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/harness/harness.hpp"
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

// Follows the steps, and returns what is wrong with them.
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

// Makes a small body beside a long one. Two corners of the long body are farther away than the small one is large by as much as
// double has digits, at a right angle to the direction in which the bodies are apart. The products with that direction cancel,
// and their rounding is as large as the gap.
std::pair<PosedBody, PosedBody> small_beside_long(std::mt19937& random) {
  const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  const auto real = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Point3 apart, along;
  do {
    for (double& x : apart) x = whole(-16, 16);
    apart[whole(0, 2)] = whole(0, 1) == 1 ? 16 : -16;
    along = apart.cross(Point3(whole(-16, 16), whole(-16, 16), whole(-16, 16)));
  } while (along.isZero());
  Point3 far = along * std::ldexp(real(1, 2), whole(-20, 20));
  for (double& x : far) x *= 1 + whole(-1, 1) * 0x1p-52;
  const double gap = std::exp2(std::floor(std::log2(far.norm() / apart.norm())) - 53 + whole(-1, 1));
  const Point3 corner = 0x1p-6 * Point3(whole(-8, 8), whole(-8, 8), whole(-8, 8));
  PosedBody small{"small", {}, {{0, 1, 2}}}, wide{"long", {far, -far, far + apart * real(0, 2) * far.norm()}, {}};
  for (const double share : {1., -1., real(-1, 1)}) small.vertices.push_back(gap * (share * corner - apart));
  wide.triangles.push_back({0, 1, 1});
  if (whole(0, 3) == 0) wide.triangles.push_back({0, 1, 2});
  return {small, wide};
}

void check_bodies(const PosedBody& first, const PosedBody& second, std::mt19937& random) {
  const Separation found = separate(first, second);
  RC_CLASSIFY(!found.contacts.empty(), "touch");
  const std::string wrong = wrong_with(found, first, second);
  if (!wrong.empty()) RC_FAIL(wrong);
  // Some pairs are decided in another way.
  std::vector<TrianglePair> pairs;
  for (const auto& contact : found.contacts) pairs.push_back(contact.pair);
  for (std::size_t i = 0; i < std::min<std::size_t>(10, first.triangles.size() * second.triangles.size()); ++i) {
    const int t = std::uniform_int_distribution<int>(0, int(first.triangles.size()) - 1)(random),
              u = std::uniform_int_distribution<int>(0, int(second.triangles.size()) - 1)(random);
    RC_ASSERT(oracle::triangles_meet(first.triangle(t), second.triangle(u)) ==
              (std::ranges::find(pairs, TrianglePair{t, u}) != pairs.end()));
  }
}

void check_two_bodies() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto bodies = gen::two_bodies(random);
  RC_CLASSIFY(gen::is_degenerate(bodies), "degenerate");
  check_bodies(bodies.first, bodies.second, random);
}

void check_small_beside_long() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto [small, wide] = small_beside_long(random);
  check_bodies(small, wide, random);
  check_bodies(wide, small, random);
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
  t.holds(
      "beside corners so far away that their products are rounded by as much as the bodies are apart, planes and contacts are "
      "right",
      {.number_type = "double against rational", .cases = 200}, check_small_beside_long);
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
