// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/weight_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using WeightRow = std::vector<double>;

std::vector<WeightRow> distinct(const std::vector<std::span<const double>>& weights) {
  std::vector<WeightRow> rows;
  for (const auto& w : weights) rows.emplace_back(w.begin(), w.end());
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

// The last weight is 1 minus the others, so the hull lives in the others' coordinates; 1 - sum is exact for such weights.
WeightRow complete(WeightRow first) {
  double last = 1;
  for (const double w : first) last -= w;
  first.push_back(last);
  return first;
}

std::vector<WeightRow> hull_of_three(const std::vector<WeightRow>& rows) {
  std::vector<Kernel::Point_2> points, hull;
  for (const WeightRow& r : rows) points.emplace_back(r[0], r[1]);
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  std::vector<WeightRow> out;
  for (const auto& p : hull) out.push_back(complete({p.x(), p.y()}));
  return out;
}

std::vector<WeightRow> hull_of_four(const std::vector<WeightRow>& rows) {
  std::vector<Kernel::Point_3> points;
  for (const WeightRow& r : rows) points.emplace_back(r[0], r[1], r[2]);
  std::vector<WeightRow> out;
  CGAL::Object hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  if (CGAL::Polyhedron_3<Kernel> body; CGAL::assign(body, hull))
    for (auto v = body.points_begin(); v != body.points_end(); ++v) out.push_back(complete({v->x(), v->y(), v->z()}));
  else out = rows;                    // in a plane or on a line: their weight vertices are rarely fewer
  std::sort(out.begin(), out.end());  // CGAL's order goes by where its memory happens to be
  return out;
}

}  // namespace

std::vector<WeightRow> extreme_rows(const std::vector<std::span<const double>>& weights) {
  const DefaultFloatEnvironment environment;
  auto rows = distinct(weights);
  if (rows.size() <= 2) return rows;
  switch (rows[0].size()) {
    case 2: return {rows.front(), rows.back()};
    case 3: return hull_of_three(rows);
    case 4: return rows.size() > 4 ? hull_of_four(rows) : rows;
    default: return rows;
  }
}

std::vector<WeightRow> weight_polytope(const std::vector<std::span<const double>>& weights) {
  const DefaultFloatEnvironment environment;
  auto hull = extreme_rows(weights);
  WeightBounds<double> bounds{{weights[0].begin(), weights[0].end()}, {weights[0].begin(), weights[0].end()}};
  for (const auto& w : weights)
    for (std::size_t i = 0; i < w.size(); ++i) {
      bounds.low[i] = std::min(bounds.low[i], w[i]);
      bounds.high[i] = std::max(bounds.high[i], w[i]);
    }
  auto box = weight_vertices_or_simplex(bounds);
  return hull.size() <= box.size() ? std::move(hull) : std::move(box);
}

}  // namespace refitlab
