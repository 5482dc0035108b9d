#include "algorithms/skinning/rotation_center.hpp"

namespace refitlab {
namespace {

// A symmetric matrix by its distinct entries: row by row, from the diagonal on.
struct Symmetric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  double trace() const { return xx + yy + zz; }
  void add_product(const Point3& v, double factor) {  // factor v v^T
    const Point3 f = v * factor;
    xx += f[0] * v[0], xy += f[0] * v[1], xz += f[0] * v[2], yy += f[1] * v[1], yz += f[1] * v[2], zz += f[2] * v[2];
  }
  Point3 operator*(const Point3& v) const {
    return {xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2], xz * v[0] + yz * v[1] + zz * v[2]};
  }
  Symmetric adjugate() const {
    return {yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
  }
  double determinant(const Symmetric& adjugate) const { return xx * adjugate.xx + xy * adjugate.xy + xz * adjugate.xz; }
  // Its square, divided by the square of the trace.
  Symmetric scaled_square() const {
    const double s = 1 / (trace() * trace());
    return {s * (xx * xx + xy * xy + xz * xz), s * (xx * xy + xy * yy + xz * yz), s * (xx * xz + xy * yz + xz * zz),
            s * (xy * xy + yy * yy + yz * yz), s * (xy * xz + yy * yz + yz * zz), s * (xz * xz + yz * yz + zz * zz)};
  }
  Point3 longest_column() const {
    if (xx >= yy && xx >= zz) return {xx, xy, xz};
    return yy >= zz ? Point3(xy, yy, yz) : Point3(xz, yz, zz);
  }
};

// V and g / 2 of the normal equations, a pair of joints after the other.
class NormalEquations {
 public:
  explicit NormalEquations(const Point3& prior) : prior_(prior) {}

  void add_pair(const RigidTransform<double>& a, const RigidTransform<double>& b) {
    const Quaternion<double> back = conjugate(a.rotation), relative = multiply(back, b.rotation);
    const Point3 v = imaginary(relative), e = rotate<double>(back, apply(a, prior_) - apply(b, prior_));
    const Point3 t = cross(v, e);
    v_.add_product(v, 1);
    half_g_ = half_g_ + (cross(v, t) - t * relative[0]);
  }

  // The x nearest to 0.
  Point3 solve() const {
    const double t = v_.trace();
    if (!(4 * t > squared_angle)) return Point3::Zero();
    Symmetric m{t - v_.xx, -v_.xy, -v_.xz, t - v_.yy, -v_.yz, t - v_.zz};  // a quarter of M
    const Symmetric adjugate = m.adjugate();
    const double determinant = m.determinant(adjugate);
    // The other two eigenvalues are about t where the smallest is small.
    const double smallest = determinant / (t * t);
    if (smallest > std::max(squared_angle / 4, squared_ratio * t)) return adjugate * half_g_ / (2 * determinant);
    // The eigenvector of the smallest is the largest's of the adjugate. Along it nothing moves: g has no part, and m a
    // part that makes it regular.
    const Symmetric power = adjugate.scaled_square().scaled_square().scaled_square();
    const Point3 column = power.longest_column(), axis = column / norm(column);
    const Point3 g = half_g_ - axis * dot(axis, half_g_);
    m.add_product(axis, t);
    const Symmetric inverse = m.adjugate();
    return inverse * g / (2 * m.determinant(inverse));
  }

 private:
  static constexpr double squared_angle = 1e-8, squared_ratio = 1e-6;  // squares of the tolerances

  Point3 prior_;
  Symmetric v_;
  Point3 half_g_ = Point3::Zero();
};

}  // namespace

Point3 rotation_center(std::span<const RigidTransform<double>> transforms, const Point3& prior) {
  NormalEquations equations(prior);
  for (std::size_t a = 0; a < transforms.size(); ++a)
    for (std::size_t b = a + 1; b < transforms.size(); ++b) equations.add_pair(transforms[a], transforms[b]);
  return prior + equations.solve();
}

}  // namespace refitlab
