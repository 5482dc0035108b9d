// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/methods/volumes/box_orientation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "lemmas/exact/lift.hpp"
#include "proptests/gen/ball_lists.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_box_orientation {
namespace {

using namespace refitlab;
using Point3 = Vec<double, 3>;

std::vector<Ball3<double>> as_balls(const std::vector<Point3>& points) {
  std::vector<Ball3<double>> out;
  for (const Point3& p : points) out.push_back({p, 0.0});
  return out;
}

// Returns the extents of the balls' centers along the three axes of the orientation.
Point3 extents(const std::vector<Ball3<double>>& balls, const Quaternion<double>& q) {
  Point3 out;
  for (int i = 0; i < 3; ++i) {
    const Point3 axis = rotate<double>(q, Point3::Unit(i));
    double low = 1e300, high = -1e300;
    for (const auto& b : balls) low = std::min(low, axis.dot(b.center)), high = std::max(high, axis.dot(b.center));
    out[i] = high - low;
  }
  return out;
}

void orientations_of_clouds(Suite& t) {
  t.holds("all are unit quaternions, and no rotation comes first",
          {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.4}, [] {
            const auto list = *gen::ball_list(12);
            RC_CLASSIFY(list.is_degenerate, "degenerate");
            const auto orientations = box_orientations(lift<double>(list.balls));
            RC_ASSERT(orientations[0] == identity_quaternion<double>());
            for (const auto& q : orientations) RC_ASSERT(std::abs(q.norm() - 1) < 1e-14);
          });
  t.example("the principal axes of a long cloud lie along its three extents", {.number_type = "double"}, [] {
    std::mt19937_64 random(2006);
    std::normal_distribution<double> normal;
    bool good = true;
    for (int round = 0; round < 50; ++round) {
      const Quaternion<double> q =
          Quaternion<double>(normal(random), normal(random), normal(random), normal(random)).normalized();
      // There are pairs of points, so that the mean is exactly the middle and the covariance is diagonal.
      std::vector<Point3> points;
      for (const double s : {-1.0, 1.0})
        for (int i = 0; i < 3; ++i) points.push_back(Point3(7, 0, 0) + rotate<double>(q, Point3::Unit(i) * s * (1 << i)));
      Point3 e = extents(as_balls(points), box_orientations(as_balls(points))[1]);
      std::sort(e.data(), e.data() + 3);
      good = good && (e - Point3(2, 4, 8)).norm() < 1e-9;
    }
    return good;
  });
}

void orientations_along_a_side(Suite& t) {
  t.example("a flat triangle lies in a face of each of its side's boxes, with the side along an edge", {}, [] {
    std::mt19937_64 random(2006);
    std::normal_distribution<double> normal;
    bool good = true;
    for (int round = 0; round < 200; ++round) {
      std::vector<Point3> p;
      for (int i = 0; i < 3; ++i) p.push_back({normal(random), normal(random), normal(random)});
      const auto balls = as_balls(p);
      const auto all = box_orientations(balls);
      double sides[] = {(p[0] - p[1]).norm(), (p[1] - p[2]).norm(), (p[2] - p[0]).norm()}, found[3];
      for (int i = 0; i < 3; ++i) {
        const Point3 along = rotate<double>(all[2 + i], Point3::UnitX());
        good = good && extents(balls, all[2 + i])[1] < 1e-12;
        found[i] = 0;
        for (const double s : sides)
          for (int j = 0; j < 3; ++j) {
            const Point3 side = p[(j + 1) % 3] - p[j];
            if (cross<double>(side, along).norm() < 1e-9 * side.norm() && std::abs(side.norm() - s) < 1e-12) found[i] = s;
          }
      }
      std::sort(sides, sides + 3);
      std::sort(found, found + 3);
      for (int i = 0; i < 3; ++i) good = good && sides[i] == found[i];
    }
    return good;
  });
  t.example("the long side is found along an axis and along a diagonal, among points that reach farther along all others", {},
            [] {
              std::vector<Point3> directions;
              for (int i = 0; i < 3; ++i) directions.push_back(Point3::Unit(i));
              for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0}) directions.push_back({1, y, z});
              long tried = 0;
              for (const Point3& side : directions) {
                std::vector<Point3> points;
                for (const Point3& d : directions)
                  for (const double sign : {-1.0, 1.0})
                    points.push_back(d == side       ? Point3(side.normalized() * 10 * sign)
                                     : d.norm() == 1 ? Point3(d * 7 * sign)
                                                     : Point3(d * 3.5 * sign));
                std::mt19937_64 random(tried);
                std::shuffle(points.begin(), points.end(), random);
                const Point3 along = rotate<double>(box_orientations(as_balls(points))[2], Point3::UnitX());
                if (cross<double>(side, along).norm() > 1e-12) return Checked(false, tried, "direction " + std::to_string(tried));
                ++tried;
              }
              return Checked(true, tried);
            });
}

}  // namespace

PROPTEST(box_orientation) {
  orientations_of_clouds(t);
  orientations_along_a_side(t);
  t.example(
      "triangles however flat have their sides' boxes, but for those that rounding makes of a line or a point: these have none",
      {}, [] {
        std::mt19937_64 random(2006);
        std::normal_distribution<double> normal;
        long tried = 0;
        for (const double height : {1.0, 0.1, 0.05, 1e-3, 1e-6, 1e-9, 1e-11, 1e-14, 0.0})
          for (int round = 0; round < 50; ++round, ++tried) {
            const Quaternion<double> q =
                Quaternion<double>(normal(random), normal(random), normal(random), normal(random)).normalized();
            const double scale = std::exp2(10 * normal(random)), share = 0.3 + 0.01 * (round % 40);
            const auto point = [&](double x, double y) { return Point3(rotate<double>(q, Point3(x, y, 0) * scale)); };
            const auto balls = as_balls({point(0, 0), point(1, 0), point(share, height)});
            const auto all = box_orientations(balls);
            for (int i = 2; i < 5; ++i) {
              if ((all[i] == identity_quaternion<double>()) != (height < 1e-13))
                return Checked(false, tried, "height " + std::to_string(height));
              if (height > 1e-13 && extents(balls, all[i])[1] > 1e-14 * scale) return Checked(false, tried, "not in a face");
            }
          }
        for (int count = 1; count < 5; ++count, ++tried) {
          const auto all = box_orientations(as_balls(std::vector<Point3>(count, Point3(1, 2, 3))));
          for (int i = 2; i < 5; ++i)
            if (all[i] != identity_quaternion<double>()) return Checked(false, tried, "one point");
        }
        return Checked(true, tried);
      });
}

}  // namespace proptests::suite_box_orientation
