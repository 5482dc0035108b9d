// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Triangles = std::span<const int>;

void require_whole(const PosedBody& body) {
  if (body.triangles.empty()) throw std::invalid_argument("separation: a body has no triangles");
  for (const Point3& p : body.vertices)
    if (!p.allFinite()) throw std::invalid_argument("separation: a coordinate is not finite");
  for (const auto& triangle : body.triangles)
    for (const int v : triangle)
      if (v < 0 || v >= static_cast<int>(body.vertices.size()))
        throw std::invalid_argument("separation: a triangle has a vertex that is not there");
}

// Returns the sides of the box around the middles of triangles, which are multiplied by 3.
Point3 extent_of(const PosedBody& body, Triangles set, std::vector<Point3>& middles) {
  Point3 low = Point3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const int t : set) {
    middles[t] = body.triangle(t)[0] + body.triangle(t)[1] + body.triangle(t)[2];
    low = low.cwiseMin(middles[t]), high = high.cwiseMax(middles[t]);
  }
  return high - low;
}

// Orders the triangles so that each half, and each half of a half, is cut at the middle along the longest side of its box.
void put_in_order(const PosedBody& body, std::span<int> set, std::vector<Point3>& middles) {
  if (set.size() < 2) return;
  Eigen::Index axis;
  extent_of(body, set, middles).maxCoeff(&axis);
  const std::size_t half = set.size() / 2;
  std::nth_element(set.begin(), set.begin() + half, set.end(), [&](int s, int t) { return middles[s][axis] < middles[t][axis]; });
  put_in_order(body, set.first(half), middles);
  put_in_order(body, set.subspan(half), middles);
}
std::vector<int> ordered(const PosedBody& body) {
  std::vector<int> order(body.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Point3> middles(order.size());
  put_in_order(body, order, middles);
  return order;
}

class SetVertices {
 public:
  SetVertices(const PosedBody& body, Triangles set, std::vector<int>& stamps, int stamp) {
    Point3 low = Point3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const int t : set)
      for (const int v : body.triangles[t]) {
        if (stamps[v] == stamp) continue;
        stamps[v] = stamp;
        const Point3& p = body.vertices[v];
        points_.push_back(p);
        low = low.cwiseMin(p), high = high.cwiseMax(p);
      }
    middle_ = low / 2 + high / 2;
    size_ = (high - low).norm();
    largest_ = low.cwiseAbs().cwiseMax(high.cwiseAbs());
  }

  const Point3& middle() const { return middle_; }
  double size() const { return size_; }
  const Point3& largest() const { return largest_; }  // |coordinates|
  // Returns the least product with the normal, and the point that has it.
  std::pair<double, Point3> least(const Point3& normal) const {
    std::pair<double, Point3> out{std::numeric_limits<double>::infinity(), points_[0]};
    for (const Point3& p : points_)
      if (const double d = normal.dot(p); d < out.first) out = {d, p};
    return out;
  }

 private:
  std::vector<Point3> points_;
  Point3 middle_, largest_;
  double size_;
};

// Returns a plane with this normal in short numbers, if it certainly parts the sets. A dot product in double is off by less than
// 4 roundings of the sum of its products' absolute values; 16 leave room for those of sums, of this bound and of underflow. The
// offset differs from the middle of the gap by at most an eighth of it.
std::optional<PartingPlane> plane_between(const SetVertices& a, const SetVertices& b, const Point3& normal) {
  const double highest = -a.least(-normal).first, lowest = b.least(normal).first, gap = lowest - highest;
  const double off = 16 * 0x1p-53 * normal.cwiseAbs().dot(a.largest().cwiseMax(b.largest())) + 0x1p-1000;
  if (!(gap > 4 * off) || !std::isfinite(gap)) return {};
  const double grid = std::exp2(std::floor(std::log2(gap)) - 2), offset = std::round((highest / 2 + lowest / 2) / grid) * grid;
  return PartingPlane{convert<Rational>(normal), Rational(offset)};
}

constexpr int most_directions = 20;  // So many are tried before a set is halved.

// Returns a plane between the sets, if one is found soon. It comes from the point of the difference of their hulls that is
// nearest to 0. That is approached along segments to the points that are farthest towards 0 [Gilbert 1966].
std::optional<PartingPlane> find_plane(const SetVertices& a, const SetVertices& b) {
  Point3 nearest = b.middle() - a.middle();
  for (int i = 0; i < most_directions; ++i) {
    const double length = nearest.cwiseAbs().maxCoeff();
    if (!(length > 0x1p-900 && length < 0x1p900)) return {};
    const Point3 direction = nearest / length;
    const Point3 farthest = b.least(direction).second - a.least(-direction).second;
    if (direction.dot(farthest) > 0)
      for (const double whole : {16., 256., 0x1p20, 0x1p40})
        if (auto plane = plane_between(a, b, (direction * whole).array().round().matrix())) return plane;
    const Point3 step = nearest - farthest;
    const double share = nearest.dot(step) / step.squaredNorm();
    if (!(share > 0)) return {};
    nearest -= std::min(share, 1.) * step;
  }
  return {};
}

class Separator {
 public:
  Separator(const PosedBody& first, const PosedBody& second)
      : first_(first),
        second_(second),
        first_stamps_(first.vertices.size(), -1),
        second_stamps_(second.vertices.size(), -1) {}

  Separation run() {
    out_.first_order = ordered(first_), out_.second_order = ordered(second_);
    part(out_.first_order, out_.second_order);
    return std::move(out_);
  }

 private:
  void part(Triangles first, Triangles second) {
    const SetVertices a(first_, first, first_stamps_, stamp_), b(second_, second, second_stamps_, stamp_);
    ++stamp_;
    if (auto plane = find_plane(a, b)) {
      out_.steps.push_back(*std::move(plane));
    } else if (first.size() == 1 && second.size() == 1) {
      part_exactly(first[0], second[0]);
    } else if (second.size() == 1 || (first.size() > 1 && a.size() >= b.size())) {
      out_.steps.push_back(Halved::first);
      part(first.first(first.size() / 2), second), part(first.subspan(first.size() / 2), second);
    } else {
      out_.steps.push_back(Halved::second);
      part(first, second.first(second.size() / 2)), part(first, second.subspan(second.size() / 2));
    }
  }
  void part_exactly(int s, int t) {
    auto found = common_point(first_.triangle(s), second_.triangle(t));
    if (auto* point = std::get_if<CommonPoint>(&found)) {
      out_.contacts.push_back({{s, t}, std::move(*point)});
      out_.steps.push_back(Touching{});
    } else {
      out_.steps.push_back(std::get<PartingPlane>(std::move(found)));
    }
  }

  const PosedBody &first_, &second_;
  std::vector<int> first_stamps_, second_stamps_;  // by vertex: the last pair of sets that had it
  int stamp_ = 0;
  Separation out_;
};

}  // namespace

Separation separate(const PosedBody& first, const PosedBody& second) {
  const DefaultFloatEnvironment environment;
  require_whole(first), require_whole(second);
  return Separator(first, second).run();
}

}  // namespace refitlab
