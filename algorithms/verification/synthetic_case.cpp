// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/verification/synthetic_case.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/verification/portable_random.hpp"

namespace refitlab {
namespace {

using Json = nlohmann::ordered_json;
using RationalQuaternion = Quaternion<Rational>;
using RationalPoint = Vec<Rational, 3>;
using Transforms = std::vector<RigidTransform<Rational>>;

constexpr int weight_unit = 1 << weight_bits;

// --- Pieces of a synthetic case ---

// q^2 / ||q||^2 has unit length, and is the rotation by twice the angle.
RationalQuaternion unit_of(const RationalQuaternion& q) { return multiply(q, q) / squared_norm(q); }

RationalQuaternion any_rotation(PortableRandom& random) {
  RationalQuaternion q{random.between(-6, 6), random.between(-6, 6), random.between(-6, 6), random.between(-6, 6)};
  if (squared_norm(q) == 0) q[0] = 1;
  return unit_of(q);
}

// Returns a rotation by up to about 70 degrees.
RationalQuaternion small_turn(PortableRandom& random) {
  return unit_of({random.between(12, 40), random.between(-4, 4), random.between(-4, 4), random.between(-4, 4)});
}

// Returns a rotation about the given axis by any angle.
RationalQuaternion twist(PortableRandom& random, const RationalPoint& axis) {
  const Rational x(random.between(-8, 8), 4);
  return unit_of({Rational(1), x * axis[0], x * axis[1], x * axis[2]});
}

RationalPoint any_point(PortableRandom& random, int most, int denominator) {
  const auto coordinate = [&] { return Rational(random.between(-most, most), denominator); };
  const Rational x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

Transforms any_transforms(PortableRandom& random) {
  const int joints = random.between(1, 5), kind = random.between(0, 2);
  const RationalPoint axis{random.between(-3, 3), random.between(-3, 3), random.between(1, 3)};
  Transforms out{{any_rotation(random), any_point(random, 40, 8)}};
  while (static_cast<int>(out.size()) < joints) {
    const RationalQuaternion q = kind == 0   ? any_rotation(random)
                                 : kind == 1 ? multiply(out[0].rotation, small_turn(random))
                                             : multiply(out[0].rotation, twist(random, axis));
    out.push_back({q, any_point(random, 40, 8)});
  }
  return out;
}

// Returns multiples of 2^-24 with the sum 1. Some are 0.
RationalWeights vertex_weights(PortableRandom& random, std::size_t n) {
  std::vector<long> parts(n);
  for (long& part : parts) part = random.one_in(4) ? 0 : random.between(1, 4095);
  long sum = 0, rest = weight_unit;
  for (const long part : parts) sum += part;
  if (sum == 0) sum = parts[0] = 1;
  for (long& part : parts) rest -= part = part * weight_unit / sum;
  parts[0] += rest;
  RationalWeights w;
  for (const long part : parts) w.push_back(Rational(static_cast<int>(part), weight_unit));
  return w;
}

// Returns the bounds of the weights of one to four vertices, or of all weights.
WeightBounds<Rational> any_bounds(PortableRandom& random, std::size_t n) {
  if (random.one_in(5)) return {RationalWeights(n, Rational(0)), RationalWeights(n, Rational(1))};
  WeightBounds<Rational> bounds;
  bounds.low = bounds.high = vertex_weights(random, n);
  for (int more = random.between(0, 3); more > 0; --more) {
    const RationalWeights w = vertex_weights(random, n);
    for (std::size_t i = 0; i < n; ++i) {
      bounds.low[i] = std::min(bounds.low[i], w[i]);
      bounds.high[i] = std::max(bounds.high[i], w[i]);
    }
  }
  return bounds;
}

// --- Degenerate synthetic cases ---

// Does something to one joint-set that chance would not bring about. Some of it needs a second joint; without one the pose is at
// rest.
std::string make_degenerate(PortableRandom& random, SyntheticSet& set) {
  Transforms& c = set.palette.transforms;
  const int kind = random.between(c.size() > 1 ? 0 : 4, 7);
  const RationalQuaternion half_turn(0, 1, 0, 0);
  switch (kind) {
    case 0: c[1].rotation = c[0].rotation; return "equal quaternions";
    case 1: c[1].rotation = -c[0].rotation; return "antipodal quaternions";
    case 2: c[1].rotation = multiply(c[0].rotation, half_turn); return "half a turn";
    case 3:
      c[1].rotation = -c[0].rotation;
      set.bounds.low.assign(c.size(), Rational(0));
      set.bounds.high.assign(c.size(), Rational(1, 2));
      set.bounds.low[0] = Rational(1, 2);
      set.bounds.high[0] = 1;
      return "zero blend at a weight vertex";
    case 4: set.reference.radius = 0; return "r = 0";
    case 5: set.bounds.high = set.bounds.low = vertex_weights(random, c.size()); return "one weight vertex";
    case 6: set.palette.rotation_center = set.reference.center; return "rotation center at p";
    default: c.assign(c.size(), {}); return "at rest";
  }
}

Json json_of(const Rational& x) { return as_text(x); }

template <int D>
Json json_of(const Vec<Rational, D>& v) {
  Json out = Json::array();
  for (int i = 0; i < D; ++i) out.push_back(as_text(v[i]));
  return out;
}

Json json_of(const RationalWeights& w) {
  Json out = Json::array();
  for (const Rational& x : w) out.push_back(as_text(x));
  return out;
}

Json json_of(const Ball3<Rational>& ball) { return {{"center", json_of(ball.center)}, {"radius", json_of(ball.radius)}}; }

Json json_of(const SyntheticSet& set) {
  Json transforms = Json::array();
  for (const auto& c : set.palette.transforms)
    transforms.push_back({{"rotation", json_of(c.rotation)}, {"translation", json_of(c.translation)}});
  return {{"transforms", transforms},
          {"rotation_center", json_of(set.palette.rotation_center)},
          {"bounds", {{"low", json_of(set.bounds.low)}, {"high", json_of(set.bounds.high)}}},
          {"reference", json_of(set.reference)}};
}

}  // namespace

SyntheticCase make_synthetic_case(std::uint64_t seed, std::uint64_t number) {
  const DefaultFloatEnvironment environment;
  PortableRandom random(seed, number);
  SyntheticCase synthetic;
  synthetic.reference.center = any_point(random, 40, 8);
  synthetic.reference.radius = 0;
  const int sets = std::max(1, random.between(-2, 3));  // two thirds have one joint-set
  const bool is_degenerate = random.one_in(4);
  for (int z = 0; z < sets; ++z) {
    SyntheticSet set;
    const Rational away(sets == 1 ? 0 : random.between(0, 24), 16);
    set.reference.center = synthetic.reference.center + rotate(any_rotation(random), RationalPoint(away, 0, 0));
    const int denominator = random.one_in(3) ? 200 : 20;  // drawn first, in whichever order a compiler takes arguments
    set.reference.radius = Rational(random.between(1, 40), denominator);
    set.palette.transforms = any_transforms(random);
    Transforms& c = set.palette.transforms;
    if (!random.one_in(4)) make_signs_consistent<Rational>(c);
    set.bounds = any_bounds(random, c.size());
    set.palette.rotation_center = set.reference.center + any_point(random, 30, 10);
    if (is_degenerate && z == 0) synthetic.degeneracy = make_degenerate(random, set);
    if (random.one_in(2))  // the joints share a point, as bones of a skeleton do
      for (auto& other : c) {
        const RationalPoint& center = set.palette.rotation_center;
        other.translation = apply(c[0], center) - rotate(other.rotation, center);
      }
    place_rotation_center<Rational>(set.palette, RationalPoint(set.palette.rotation_center));
    set.weight_vertices = *enumerate_weight_vertices(set.bounds, std::numeric_limits<std::size_t>::max());
    synthetic.reference.radius = std::max(synthetic.reference.radius, Rational(away + set.reference.radius));
    synthetic.sets.push_back(std::move(set));
  }
  return synthetic;
}

std::vector<RationalWeights> sampled_weights(const SyntheticSet& set) {
  const DefaultFloatEnvironment environment;
  constexpr int most_weight_vertices = 10, pairs = 8, mixtures = 8;
  PortableRandom random(set.weight_vertices.size(), set.palette.transforms.size());
  const std::size_t m = set.weight_vertices.size(), n = set.palette.transforms.size();
  std::vector<RationalWeights> out;
  const auto add = [&](const std::vector<int>& shares) {
    int sum = 0;
    for (const int share : shares) sum += share;
    RationalWeights w(n, Rational(0));
    for (std::size_t k = 0; k < m; ++k)
      if (shares[k] > 0)
        for (std::size_t i = 0; i < n; ++i) w[i] += set.weight_vertices[k][i] * Rational(shares[k], sum);
    if (squared_norm(blend_quaternion<Rational>(set.palette, w)) != 0) out.push_back(std::move(w));
  };
  const std::size_t step = 1 + (m - 1) / most_weight_vertices;
  for (std::size_t k = 0; k < m; k += step) {
    std::vector<int> shares(m, 0);
    shares[k] = 1;
    add(shares);
  }
  if (m == 1) return out;
  add(std::vector<int>(m, 1));
  for (int pair = 0; pair < pairs; ++pair) {
    std::vector<int> shares(m, 0);
    shares[random.between(0, static_cast<int>(m) - 1)] += random.between(1, 7);
    shares[random.between(0, static_cast<int>(m) - 1)] += random.between(1, 7);
    add(shares);
  }
  for (int mixture = 1; mixture < mixtures; ++mixture) {
    std::vector<int> shares(m);
    for (int& share : shares) share = random.between(0, 7);
    shares[0] += 1;
    add(shares);
  }
  return out;
}

std::string synthetic_cases_as_case_file(std::uint64_t seed, int count) {
  std::string cases;  // a line each
  for (int number = 0; number < count; ++number) {
    const SyntheticCase synthetic = make_synthetic_case(seed, number);
    Json sets = Json::array();
    for (const SyntheticSet& set : synthetic.sets) sets.push_back(json_of(set));
    const Json one{{"name", "synthetic case " + std::to_string(number) + " of seed " + std::to_string(seed)},
                   {"statement", "algorithm1"},
                   {"form", "repaired"},
                   {"claim", "ball_encloses_vertex"},
                   {"inputs",
                    {{"reference", json_of(synthetic.reference)},
                     {"joint_sets", sets},
                     {"vertex",
                      {{"joint_set", 0},
                       {"weights", json_of(sampled_weights(synthetic.sets[0]).back())},
                       {"position", json_of(synthetic.sets[0].reference.center)}}}}},
                   {"expected", "encloses"},
                   {"note", synthetic.degeneracy.empty() ? "general" : synthetic.degeneracy}};
    cases += (number == 0 ? "\n" : ",\n") + one.dump();
  }
  return "{\"format\": \"refitlab cases 1\", \"cases\": [" + cases + "\n]}\n";
}

}  // namespace refitlab
