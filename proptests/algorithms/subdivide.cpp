// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/subdivide.hpp"

#include <algorithm>
#include <set>

#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_subdivide {
namespace {

using namespace refitlab;
using Corners = std::array<Point3, 3>;

Corners corners(const Model& m, const Triangle& t) { return {m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]]}; }

std::set<std::pair<int, int>> edges_of(const Model& m) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  return edges;
}

// Returns a vector of twice a triangle's area in length, which points to the side that it faces.
Point3 area(const Corners& c) { return cross(Point3(c[1] - c[0]), Point3(c[2] - c[0])); }

double weight_of(const std::vector<Influence>& influences, int joint) {
  for (const Influence& i : influences)
    if (i.joint == joint) return i.weight;
  return 0;
}

bool same(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Influence& x, const Influence& y) { return x.joint == y.joint && x.weight == y.weight; });
}

}  // namespace

PROPTEST(subdivide) {
  t.holds(
      "every triangle becomes four of a quarter of its area that face its way, its corners at corners and edges' "
      "middles",
      {.cases = 300, .degenerate_at_least = 0.3}, [] {
        const auto plan = *gen::mesh_plan();
        RC_CLASSIFY(is_degenerate(plan), "degenerate");
        const Model m{make_mesh(plan)}, fine = subdivide(m);
        RC_ASSERT(fine.triangles.size() == 4 * m.triangles.size());
        for (std::size_t i = 0; i < m.triangles.size(); ++i) {
          const Corners whole = corners(m, m.triangles[i]);
          std::multiset<std::array<double, 3>> found, expected;
          for (int k = 0; k < 4; ++k) {
            const Corners part = corners(fine, fine.triangles[4 * i + k]);
            RC_ASSERT((area(part) - area(whole) / 4).norm() <= 1e-13 * (1 + area(whole).norm()));
            for (const Point3& p : part) found.insert({p[0], p[1], p[2]});
          }
          for (int k = 0; k < 3; ++k) {
            const Point3 middle = (whole[k] + whole[(k + 1) % 3]) / 2;
            expected.insert({whole[k][0], whole[k][1], whole[k][2]});
            for (int times = 0; times < 3; ++times) expected.insert({middle[0], middle[1], middle[2]});
          }
          RC_ASSERT(found == expected);
        }
      });

  t.holds("the model's vertices come first and unchanged, and there is one more for each edge",
          {.cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(is_degenerate(plan), "degenerate");
            const Model m{make_mesh(plan)}, fine = subdivide(m);
            std::size_t edges = 0;
            for (const auto& [a, b] : edges_of(m)) edges += a != b;
            RC_ASSERT(fine.vertices.size() == m.vertices.size() + edges);
            for (std::size_t v = 0; v < m.vertices.size(); ++v) {
              RC_ASSERT(fine.vertices[v] == m.vertices[v]);
              RC_ASSERT(same(fine.influences[v], m.influences[v]));
            }
          });

  t.holds("a middle has the mean of its ends' weights, the four largest in their proportions",
          {.cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(is_degenerate(plan), "degenerate");
            const Model m{make_mesh(plan)}, fine = subdivide(m);
            for (std::size_t i = 0; i < m.triangles.size(); ++i) {
              const Triangle &whole = m.triangles[i], &inner = fine.triangles[4 * i + 3];
              for (int k = 0; k < 3; ++k) {
                const auto &a = m.influences[whole[k]], &b = m.influences[whole[(k + 1) % 3]],
                           &middle = fine.influences[inner[k]];
                RC_ASSERT(middle.size() <= 4u);
                std::vector<double> means;
                for (std::size_t j = 0; j < m.joints.size(); ++j)
                  means.push_back((weight_of(a, int(j)) + weight_of(b, int(j))) / 2);
                std::vector<double> sorted = means;
                std::sort(sorted.rbegin(), sorted.rend());
                sorted.resize(std::max<std::size_t>(sorted.size(), 4));
                const double kept = sorted[0] + sorted[1] + sorted[2] + sorted[3], least = sorted[3];
                for (std::size_t j = 0; j < means.size(); ++j) {
                  const double weight = weight_of(middle, int(j)), share = means[j] / kept;
                  if (means[j] > least) RC_ASSERT(std::abs(weight - share) < 0x1p-23);
                  else RC_ASSERT(weight == 0 || std::abs(weight - least / kept) < 0x1p-23);
                }
              }
            }
          });
}

}  // namespace proptests::suite_subdivide
