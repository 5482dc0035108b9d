// SPDX-License-Identifier: MIT
// The rotation center of a joint-set is the point whose images under the joint-set's transforms lie closest together [Kavan and
// Zara 2005b].
//
// For two joints a and b, let (w, v) be the relative rotation q_a* q_b. Let e = R_a^T (C_a p - C_b p), the difference of
// the two images of the prior p, seen from joint a. Then R_a^T (C_a (p + x) - C_b (p + x)) = e + (1 - R) x. Further, (1 -
// R)^T (1 - R) = 4 (||v||^2 - v v^T) and (1 - R)^T e = 2 (w v x e - v x (v x e)). So the normal equations M x = g of n
// joints are sums over their pairs. They need no trigonometry, and have no cancellation at small angles. For two joints the
// solution nearest to 0 is x = (v x (v x e) - w v x e) / (2 ||v||^2).
//
// Let V be the sum of the v v^T, and t its trace. Then M = 4 (t - V). All eigenvalues of M are at most 4 t. Only one of
// them can be below 2 t, because two eigenvalues of V are never both above t/2. So the rank of M is 0, 2 or 3, and the only
// direction that can be undetermined is the eigenvector of V's largest eigenvalue. No eigensolver is needed: where that
// eigenvalue of M is small, the eighth power of M's adjugate is almost a product n n^T, and n is the direction.
#pragma once

#include <span>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {
namespace rotation_centers {

// A Symmetric matrix is stored as its distinct entries, row by row, from the diagonal on.
template <class S>
struct Symmetric {
  using Point = Vec<S, 3>;
  S xx{0}, xy{0}, xz{0}, yy{0}, yz{0}, zz{0};

  S trace() const { return xx + yy + zz; }
  void add_product(const Point& v, const S& factor) {  // adds factor v v^T
    const Point f = v * factor;
    xx += f[0] * v[0], xy += f[0] * v[1], xz += f[0] * v[2], yy += f[1] * v[1], yz += f[1] * v[2], zz += f[2] * v[2];
  }
  Point operator*(const Point& v) const {
    return {xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2], xz * v[0] + yz * v[1] + zz * v[2]};
  }
  Symmetric adjugate() const {
    return {yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
  }
  S determinant(const Symmetric& adjugate) const { return xx * adjugate.xx + xy * adjugate.xy + xz * adjugate.xz; }
  // Returns the square of the matrix, divided by the square of its trace.
  Symmetric scaled_square() const {
    const S s = S(1) / (trace() * trace());
    return {s * (xx * xx + xy * xy + xz * xz), s * (xx * xy + xy * yy + xz * yz), s * (xx * xz + xy * yz + xz * zz),
            s * (xy * xy + yy * yy + yz * yz), s * (xy * xz + yy * yz + yz * zz), s * (xz * xz + yz * yz + zz * zz)};
  }
  Point longest_column() const {
    const Point second = choose(yy >= zz, Point(xy, yy, yz), Point(xz, yz, zz));
    return choose(xx >= yy && xx >= zz, Point(xx, xy, xz), second);
  }
};

// Accumulates V and g / 2 of the normal equations, one pair of joints after another.
template <class S>
class NormalEquations {
  using Point = Vec<S, 3>;

 public:
  explicit NormalEquations(const Point& prior) : prior_(prior) {}

  void add_pair(const RigidTransform<S>& a, const RigidTransform<S>& b) {
    const Quaternion<S> back = conjugate(a.rotation), relative = multiply(back, b.rotation);
    const Point v = imaginary(relative), e = rotate<S>(back, apply(a, prior_) - apply(b, prior_));
    const Point t = cross(v, e);
    v_.add_product(v, S(1));
    half_g_ = half_g_ + (cross(v, t) - t * relative[0]);
  }

  // Returns the solution x nearest to 0.
  Point solve() const {
    const S t = v_.trace();
    Symmetric<S> m{t - v_.xx, -v_.xy, -v_.xz, t - v_.yy, -v_.yz, t - v_.zz};  // a quarter of M
    const Symmetric<S> adjugate = m.adjugate();
    const S determinant = m.determinant(adjugate);
    const Point regular = adjugate * half_g_ / (determinant * S(2));
    // Where the smallest eigenvalue is small, the other two are about t.
    const S smallest = determinant / (t * t);
    const auto has_full_rank = smallest > S(squared_angle / 4) && smallest > t * S(squared_ratio);
    const auto is_determined = t * S(4) > S(squared_angle);
    const auto is_singular = is_determined && !has_full_rank;
    Point x = regular;
    if (any_lane(is_singular)) {
      // The eigenvector of the smallest eigenvalue is that of the largest one of the adjugate. Nothing moves along it. So g
      // gets no component along it, and m gets one that makes it regular.
      const Symmetric<S> power = adjugate.scaled_square().scaled_square().scaled_square();
      const Point column = power.longest_column(), axis = column / norm<S, 3>(column);
      const Point g = half_g_ - axis * dot<S, 3>(axis, half_g_);
      m.add_product(axis, t);
      const Symmetric<S> inverse = m.adjugate();
      const Point singular = inverse * g / (m.determinant(inverse) * S(2));
      x = choose(is_singular, singular, regular);
    }
    const Point zero(S(0), S(0), S(0));
    return choose(is_determined, x, zero);
  }

  // Returns the same for one pair, whose V is v v^T and whose g is at right angles to v.
  Point solve_pair() const {
    const S t = v_.trace();
    const Point x = half_g_ / (t * S(2)), zero(S(0), S(0), S(0));
    return choose(t * S(4) > S(squared_angle), x, zero);
  }

 private:
  static constexpr double squared_angle = 1e-8, squared_ratio = 1e-6;  // the squares of the tolerances

  Point prior_;
  Symmetric<S> v_;
  Point half_g_{S(0), S(0), S(0)};
};

}  // namespace rotation_centers

// Returns argmin_r of the sum over all pairs a < b of ||C_a r - C_b r||^2. The minimum is not unique for a single joint,
// equal transforms or parallel axes, where any point of a line or plane will do. Then the function returns the minimiser
// nearest to prior. A direction counts as undetermined if the rotations differ in it by less than 1e-3 of their largest
// difference, or by less than 1e-4 rad. Such a direction could only move the center far away for nothing. (Differences are
// square roots of sums over pairs. The largest is taken to be that of the sum over all directions, 2 sqrt(t), which it
// reaches for parallel axes.) All points are in the reference frame. The rotations have unit length and any signs. S is a
// floating-point number or a pack of them.
template <class S>
Vec<S, 3> rotation_center(std::span<const RigidTransform<S>> transforms, const Vec<S, 3>& prior) {
  rotation_centers::NormalEquations<S> equations(prior);
  for (std::size_t a = 0; a < transforms.size(); ++a)
    for (std::size_t b = a + 1; b < transforms.size(); ++b) equations.add_pair(transforms[a], transforms[b]);
  const Vec<S, 3> offset = transforms.size() == 2 ? equations.solve_pair() : equations.solve();
  return prior + offset;
}

}  // namespace refitlab
