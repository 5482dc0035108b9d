// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/posed_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace proptests::gen {

using namespace refitlab;

namespace {

class BodiesMaker {
 public:
  BodiesMaker(std::mt19937& random, BodiesKind kind) : random_(random), kind_(kind) {}

  TwoBodies make() {
    TwoBodies out{kind_, body("first"), {}};
    grid_ = 1 + pick(4);
    place(out.first);
    if (kind_ == BodiesKind::same || kind_ == BodiesKind::moved) {
      out.second = out.first;
      out.second.name = "second";
      std::shuffle(out.second.triangles.begin(), out.second.triangles.end(), random_);
    } else {
      out.second = body("second");
      place(out.second);
    }
    if (kind_ == BodiesKind::moved) move(out.second);
    if (kind_ == BodiesKind::touching) touch(out.first, out.second);
    const int exponent = pick(4) ? 0 : std::array{-1074, -600, -60, 60, 600, 1020}[pick(6)];
    for (PosedBody* body : {&out.first, &out.second})
      for (Point3& p : body->vertices)
        for (double& x : p) x = std::ldexp(x, exponent);
    return out;
  }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  PosedBody body(const char* name) {
    PosedBody out{name, {}, {}};
    const int most = std::array{1, 2, 8, 8, 8, 30}[pick(6)], triangles = 1 + pick(most), vertices = 3 + pick(2 * most);
    out.vertices.resize(vertices);
    for (int t = 0; t < triangles; ++t) out.triangles.push_back({pick(vertices), pick(vertices), pick(vertices)});
    return out;
  }

  void place(PosedBody& body) {
    const bool is_anywhere = kind_ == BodiesKind::anywhere || kind_ == BodiesKind::touching;
    const int free = kind_ == BodiesKind::in_a_plane ? 2 : kind_ == BodiesKind::on_a_line ? 1 : 3;
    for (Point3& p : body.vertices) {
      p = {0, 0, 0};
      for (int i = 0; i < free; ++i) p[i] = is_anywhere ? uniform(-1, 1) : pick(2 * grid_ + 1) - grid_;
    }
  }

  void move(PosedBody& body) {
    const int axis = pick(3);
    const bool is_a_step = pick(2);
    for (Point3& p : body.vertices)
      p[axis] = is_a_step ? p[axis] + 1 : std::nextafter(p[axis], std::numeric_limits<double>::infinity());
  }

  void touch(const PosedBody& first, PosedBody& second) {
    for (Point3& p : second.vertices) {
      if (pick(2)) continue;
      const TrianglePoints t = first.triangle(pick(static_cast<int>(first.triangles.size())));
      const double s = std::array{0., 0.5, 1., uniform(0, 1)}[pick(4)], u = std::array{0., 1., uniform(0, 1)}[pick(3)];
      p = t[0] * (1 - s) + (t[1] * (1 - u) + t[2] * u) * s;
    }
  }

  std::mt19937& random_;
  const BodiesKind kind_;
  int grid_ = 1;
};

}  // namespace

TwoBodies two_bodies(std::mt19937& random) {
  const int kind = std::uniform_int_distribution<int>(0, bodies_kind_count - 1)(random);
  return two_bodies(random, static_cast<BodiesKind>(kind));
}

TwoBodies two_bodies(std::mt19937& random, BodiesKind kind) { return BodiesMaker(random, kind).make(); }

}  // namespace proptests::gen
