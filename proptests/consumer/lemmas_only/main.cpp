// SPDX-License-Identifier: GPL-3.0-or-later
// This program uses the lemmas alone: it bounds a twist of half a turn by its cap and by its control points.
#if __has_include(<CGAL/version.h>) || __has_include(<gmp.h>) || __has_include(<mpfi.h>) || __has_include(<boost/version.hpp>)
#error "a library that the lemmas do not need is within reach, so that this program would not show that"
#endif
#include <cstdio>
#include <numbers>

#include "lemmas/a1_affine_image.hpp"
#include "lemmas/a2_two_phase_skinning.hpp"
#include "lemmas/a3_morph_displacement.hpp"
#include "lemmas/b10_determinant_error.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/b5_rotation_axis.hpp"
#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/b8_blend_error.hpp"
#include "lemmas/b9_pose_change.hpp"
#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/c2_channel_motion.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/c5_skinned_motion.hpp"
#include "lemmas/c6_interval_hull.hpp"
#include "lemmas/c7_crossfade.hpp"
#include "lemmas/c8_any_pose.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/rotation_bound.hpp"
#include "lemmas/s41_weight_vertices_span.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_distance_range.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/s43_rotated_cap.hpp"
#include "lemmas/s43_whole_sphere_fallback.hpp"
#include "lemmas/s44_joint_sets.hpp"
#include "lemmas/s44_sum_of_bounds.hpp"
#include "lemmas/t3_min_dot_distance.hpp"
#include "lemmas/t3_one_cap.hpp"
#include "lemmas/t3_smallest_ball_smallest_cap.hpp"

int main() {
  using namespace refitlab;
  const Vec<double, 3> x(1, 0, 0);
  // This is half of the angle between the quaternions of two joints a quarter turn apart.
  const double half = std::numbers::pi / 8;
  const SphericalBlend<double> blend{{{1, 0, 0, 0}, {std::cos(2 * half), 0, 0, std::sin(2 * half)}}, {{0, 0, 0}, {0, 0, 0}}, x};
  const std::vector<double> middle{0.5, 0.5};
  const RotationBound<double> bound = bound_rotations<double>(blend.rotations, blend.rotations[0] + blend.rotations[1]);
  const Ball3<double> ball = rotated_ball(bound, x);
  const ScaledPoint<double> at = blend.at(middle);
  const Vec<double, 3> image = at.numerator / at.denominator;
  const bool is_held = encloses(ball, image) == Verdict::holds;
  std::printf("lemmas_only: %zu control points, a ball of radius %.3f, which %s the blend\n", control_points(blend).size(),
              ball.radius, is_held ? "holds" : "misses");
  return is_held && std::abs(ball.radius - std::sin(2 * half)) < 1e-12 ? 0 : 1;
}
