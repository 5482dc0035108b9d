// SPDX-License-Identifier: GPL-3.0-or-later
// Tests common points: triangles that meet have one, and all others have a plane between them, both exactly.
#include "algorithms/certificate/common_point.hpp"

#include "proptests/gen/posed_bodies.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/parted.hpp"
#include "proptests/oracles/triangles_meet.hpp"

namespace proptests::suite_common_point {
namespace {

using namespace refitlab;

void check_two_triangles() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto bodies = gen::two_bodies(random);
  const TrianglePoints a = bodies.first.triangle(0), b = bodies.second.triangle(0);
  const bool meet = oracle::triangles_meet(a, b);
  RC_CLASSIFY(gen::is_degenerate(bodies), "degenerate");
  RC_CLASSIFY(meet, "meet");
  const auto found = common_point(a, b);
  if (const auto* point = std::get_if<CommonPoint>(&found)) {
    RC_ASSERT(meet);
    RC_ASSERT(oracle::is_common_point(*point, a, b));
  } else {
    RC_ASSERT(!meet);
    RC_ASSERT(oracle::parts(std::get<PartingPlane>(found), a, b));
  }
}

}  // namespace

PROPTEST(common_point) {
  t.holds("two triangles have a common point, or a plane between them, as exact arithmetic has it",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.5}, check_two_triangles);
  t.example("a plane between triangles in the smallest units has a short normal", {}, [] {
    const double u = 0x1p-1074;
    const TrianglePoints a{Point3(0, 0, 0), Point3(u, 0, 0), Point3(0, u, 0)},
        b{Point3(u, u, 0), Point3(2 * u, u, 0), Point3(u, 2 * u, 3 * u)};
    const auto found = common_point(a, b);
    const auto* plane = std::get_if<PartingPlane>(&found);
    if (!plane || !oracle::parts(*plane, a, b)) return Checked(false);
    for (const Rational& n : plane->normal)
      if (n.denominator() != 1 || abs(n) > 100) return Checked(false, 1, as_text(n));
    return Checked(true);
  });
}

}  // namespace proptests::suite_common_point
