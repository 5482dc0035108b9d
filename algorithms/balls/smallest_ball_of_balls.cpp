#include "algorithms/balls/smallest_ball_of_balls.hpp"

#include <CGAL/Cartesian.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Min_sphere_of_spheres_d_traits_3.h>

#include <cmath>
#include <limits>
#include <vector>

namespace refitlab {

Ball3<double> smallest_ball_of_balls(std::span<const Ball3<double>> balls) {
  using Kernel = CGAL::Cartesian<double>;
  using Traits = CGAL::Min_sphere_of_spheres_d_traits_3<Kernel, double, CGAL::Tag_true>;  // square roots, not exact
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  for (const auto& b : balls)
    if (!b.center.allFinite() || !(b.radius >= 0) || !std::isfinite(b.radius))
      return {Vec<double, 3>::Constant(undefined), undefined};
  std::vector<Traits::Sphere> spheres;
  spheres.reserve(balls.size());
  for (const auto& b : balls) spheres.emplace_back(Kernel::Point_3(b.center[0], b.center[1], b.center[2]), b.radius);
  CGAL::Min_sphere_of_spheres_d<Traits> smallest(spheres.begin(), spheres.end());
  const double* c = smallest.center_cartesian_begin();
  Ball3<double> out{{c[0], c[1], c[2]}, 0};
  for (const auto& b : balls) out.radius = std::max(out.radius, norm<double, 3>(b.center - out.center) + b.radius);
  return out;
}

}  // namespace refitlab
