// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/refit_case.hpp"

#include <limits>
#include <ostream>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/list.hpp"

namespace proptests::gen {
namespace {

using namespace refitlab;
using Transforms = std::vector<RationalTransform>;

// Draws a rotation by at most about 50 degrees: (k, a, b, c)^2, normalised, with k well above the rest.
rc::Gen<RationalQuaternion> small_turn() {
  return rc::gen::apply(
      [](int a, int b, int c, int extra) {
        const RationalQuaternion q(5 * (1 + std::abs(a) + std::abs(b) + std::abs(c)) + extra, a, b, c);
        return RationalQuaternion(multiply(q, q) / squared_norm(q));
      },
      small_integer(), small_integer(), small_integer(), rc::gen::inRange(0, 30));
}

RationalQuaternion half_turn(int axis) {
  RationalQuaternion q = RationalQuaternion::Zero();
  q[1 + axis] = 1;
  return q;
}

// Draws transforms with relations between the rotations of a joint-set that chance would not bring about.
Transforms any_transforms() {
  Transforms c = *rigid_transforms(1, 5);
  const int n = static_cast<int>(c.size());
  const int relation = *rc::gen::inRange(0, 8);
  if (relation == 4 && n > 1) c[1].rotation = -c[0].rotation;
  if (relation >= 5 && n > 1) c[1].rotation = multiply(c[0].rotation, half_turn(*rc::gen::inRange(0, 3)));
  // The two are perpendicular to the first, so signs stay: they make a zero blend.
  if (relation >= 6 && n > 2) c[2].rotation = -c[1].rotation;
  return c;
}

Transforms moderate_transforms() {
  const auto first = *rigid_transform();
  return *rc::gen::suchThat(rc::gen::map(list_with_repeats(1, 5, rc::gen::pair(small_turn(), rational_vector<3>())),
                                         [first](const std::vector<std::pair<RationalQuaternion, RationalVec<3>>>& turns) {
                                           Transforms c;
                                           for (const auto& [turn, translation] : turns)
                                             c.push_back({multiply(first.rotation, turn), translation});
                                           return c;
                                         }),
                            [](const Transforms& c) {
                              for (const auto& a : c)
                                for (const auto& b : c)
                                  if (const Rational d = dot(a.rotation, b.rotation); d < 0 || d * d < Rational(1, 2))
                                    return false;
                              return true;
                            });
}

// Draws from the whole range, at any size of RapidCheck's.

// Draws several joints, no two of which are turned alike or by 180 degrees against each other.
Transforms generic_transforms(Turns turns) {
  const RationalQuaternion first = *unit_quaternion();
  const auto rotation = turns == Turns::any ? unit_quaternion() : rc::gen::map(small_turn(), [first](const auto& turn) {
    return RationalQuaternion(multiply(first, turn));
  });
  const auto transform = rc::gen::apply(
      [](const RationalQuaternion& q, const RationalVec<3>& t) {
        return RationalTransform{q, t};
      },
      rotation, rational_vector<3>());
  return *rc::gen::suchThat(rc::gen::container<Transforms>(*between(2, 5), transform), [turns](const Transforms& c) {
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Rational d = dot(c[i].rotation, c[k].rotation);
        if (d == 0 || d * d == 1 || (turns == Turns::moderate && (d < 0 || d * d < Rational(1, 2)))) return false;
      }
    return true;
  });
}

bool may_be_zero(const SetCase& set) {
  for (const auto& weight_vertex : set.weights.vertices)
    if (squared_norm(blend_quaternion<Rational>(set.palette, weight_vertex)) == 0) return true;
  return false;
}

// Draws a generic joint-set. What a generator is given lives as long as RapidCheck may shrink, so it is captured by value.
SetCase generic_set(Turns turns, const RationalVec<3>& p) {
  SetCase set;
  set.palette.transforms = generic_transforms(turns);
  auto& c = set.palette.transforms;
  if (turns == Turns::any && *between(0, 3) > 0) make_signs_consistent<Rational>(c);
  const RationalVec<3> center = *rc::gen::suchThat(rational_vector<3>(), [p](const RationalVec<3>& r) { return r != p; });
  if (*between(0, 2) == 1)  // a common joint
    for (auto& other : c) other.translation = apply(c[0], center) - rotate(other.rotation, center);
  place_rotation_center<Rational>(set.palette, center);
  place_duals(set.palette);
  set.weights = *rc::gen::suchThat(bounds_of_vertices(static_cast<int>(c.size())), [set](const WeightPolytope& w) {
    SetCase weighted = set;
    weighted.weights = w;
    return w.vertices.size() > 1 && !may_be_zero(weighted);
  });
  return set;
}

SetCase set_case(Turns turns, const RationalVec<3>& p) {
  SetCase set;
  set.palette.transforms = turns == Turns::any ? any_transforms() : moderate_transforms();
  auto& c = set.palette.transforms;
  if (turns == Turns::any && *rc::gen::inRange(0, 3) > 0) make_signs_consistent<Rational>(c);
  RationalVec<3> center = p;
  const int place = *rc::gen::inRange(0, 4);
  if (place < 3) center = *rational_vector<3>();
  // This is a common joint, where all transforms agree.
  if (place == 2)
    for (auto& other : c) other.translation = apply(c[0], center) - rotate(other.rotation, center);
  place_rotation_center<Rational>(set.palette, center);
  place_duals(set.palette);
  set.weights = *bounds_of_vertices(static_cast<int>(c.size()));
  return set;
}

Rational as_rational(double x) { return Rational(x); }

Rational to_grid(const Rational& w, bool up) {
  const double scaled = std::ldexp(CGAL::to_double(w), weight_bits);
  return as_rational(std::ldexp(up ? std::ceil(scaled) : std::floor(scaled), -weight_bits));
}

}  // namespace

rc::Gen<RefitCase> refit_case(Turns turns) {
  return rc::gen::exec([turns] {
    RefitCase c;
    c.reference.center = *rational_vector<3>();
    if (*between(0, 100) >= 35) {
      c.reference.radius = *positive_rational();
      const int sets = *between(1, 3);
      for (int s = 0; s < sets; ++s) c.sets.push_back(generic_set(turns, c.reference.center));
      return c;
    }
    c.reference.radius = *rc::gen::weightedOneOf<Rational>(
        {{1, rc::gen::just(Rational(0))}, {2, positive_rational()}, {1, rc::gen::map(positive_rational(), [](const Rational& r) {
                                                                       return Rational(r / Rational(100));
                                                                     })}});
    const int sets = *rc::gen::inRange(1, 4);
    for (int s = 0; s < sets; ++s) c.sets.push_back(set_case(turns, c.reference.center));
    return c;
  });
}

std::vector<std::string> degeneracies(const RefitCase& c) {
  std::vector<std::string> out;
  const auto note = [&](bool is, const char* word) {
    if (is && std::find(out.begin(), out.end(), word) == out.end()) out.push_back(word);
  };
  note(c.reference.radius == 0, "r = 0");
  for (const SetCase& set : c.sets) {
    const auto& joints = set.palette.transforms;
    note(joints.size() == 1, "one joint");
    note(set.weights.vertices.size() == 1, "one weight vertex");
    note(set.palette.rotation_center == c.reference.center, "center at p");
    note(may_be_zero(set), "zero blend");
    for (std::size_t i = 0; i < joints.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Rational d = dot(joints[i].rotation, joints[k].rotation);
        note(d == 1, "equal quaternions");
        note(d == -1, "antipodal quaternions");
        note(d == 0, "half-turn");
      }
  }
  return out;
}

RefitCase rounded_to_double(const RefitCase& c) {
  const auto round = [](const auto& v) {
    auto out = v;
    for (int i = 0; i < v.size(); ++i) out[i] = as_rational(CGAL::to_double(v[i]));
    return out;
  };
  RefitCase out;
  out.reference = {round(c.reference.center), as_rational(CGAL::to_double(c.reference.radius))};
  for (const SetCase& set : c.sets) {
    SetCase s;
    OwnedPaletteEntry<double> palette{lift<double>(set.palette.transforms), {}, {}, {}};
    place_rotation_center<double>(palette, lift<double>(set.palette.rotation_center));
    place_duals(palette);
    s.palette.rotation_center = round(set.palette.rotation_center);
    for (const auto& joint : set.palette.transforms)
      s.palette.transforms.push_back({round(joint.rotation), round(joint.translation)});
    for (const auto& image : palette.center_images)
      s.palette.center_images.push_back({as_rational(image[0]), as_rational(image[1]), as_rational(image[2])});
    for (const auto& dual : palette.duals) s.palette.duals.push_back(convert<Rational>(dual));
    for (std::size_t i = 0; i < set.weights.bounds.low.size(); ++i) {
      s.weights.bounds.low.push_back(to_grid(set.weights.bounds.low[i], false));
      s.weights.bounds.high.push_back(to_grid(set.weights.bounds.high[i], true));
    }
    s.weights.vertices = *enumerate_weight_vertices(s.weights.bounds, std::numeric_limits<std::size_t>::max());
    out.sets.push_back(s);
  }
  return out;
}

void showValue(const RefitCase& c, std::ostream& out) {
  out << "S = ";
  rc::show(c.reference, out);
  for (const SetCase& set : c.sets) {
    out << "; a joint-set of ";
    rc::show(set.palette.transforms, out);
    out << " about ";
    rc::show(set.palette.rotation_center, out);
    out << " with weight ";
    rc::show(set.weights.bounds, out);
  }
}

}  // namespace proptests::gen
