// SPDX-License-Identifier: GPL-3.0-or-later
// States section 4 and what goes beyond the paper about cases.
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_distance_range.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/s43_whole_sphere_fallback.hpp"
#include "lemmas/s44_joint_sets.hpp"
#include "lemmas/s44_sum_of_bounds.hpp"
#include "lemmas/t3_one_cap.hpp"
#include "lemmas/t3_smallest_ball_smallest_cap.hpp"
#include "proptests/cases/statements.hpp"

namespace proptests::cases {
namespace {

using namespace refitlab;

template <class In>
using NumberOf = typename std::decay_t<In>::Number;

template <class S>
std::vector<PosedJointSet<S>> posed_joint_sets(const Fields& f) {
  std::vector<PosedJointSet<S>> out;
  for (const Fields& set : f.objects("joint_sets")) {
    const auto transforms = set.transforms("transforms");
    out.push_back(
        {lift<S>(transforms), lift<S>(set.point<3>("rotation_center")), lift<S>(set.rows("weight_vertices", transforms.size()))});
    if (out.back().transforms.size() != out[0].transforms.size())
      set.fail("transforms", "are not as many as those of the first joint-set");
  }
  return out;
}

// Judges section 4.4 for the printed or the repaired balls of the joint-sets.
template <bool repaired, class In>
Judgement joint_sets(const In& in) {
  using S = NumberOf<In>;
  const auto sets = posed_joint_sets<S>(in.fields);
  const auto reference = in.ball("reference"), ball = in.ball("ball");
  const Fields vertex = in.fields.object("vertex");
  const Inputs<S, 3> at{vertex};
  const auto& set = sets[vertex.integer("joint_set", 0, static_cast<int>(sets.size()) - 1)];
  const auto w = at.numbers("weights", set.transforms.size()), u = at.numbers("coefficients", set.weight_vertices.size());
  const auto v = at.point("position");
  const auto balls =
      repaired ? joint_set_balls_repaired<S>(sets, reference.center) : joint_set_balls_printed<S>(sets, reference.center);
  return {encloses_parts<S>(ball, balls) & is_vertex_of<S>(set, reference, w, v, u),
          joint_set_vertex<S>(ball, set, reference, w, v).verdict};
}

template <bool repaired, class In>
Judgement rotated_vectors(const In& in) {
  const auto apex = in.non_zero_quaternion("apex"), q = in.non_zero_quaternion("rotation");
  const auto cosine = in.number("cos_angle");
  return {rotated_cap_hypotheses(apex, cosine, q),
          rotated_cap(apex, q, in.point("v"), repaired ? rotated_cap_cosine_repaired(cosine) : rotated_cap_cosine_printed(cosine))
              .verdict};
}

std::vector<Statement> of_weights() {
  return {
      in_space("s41_weight_vertices_span", "printed", "weight_vertices_exist",
               [](const auto& in) -> Judgement {
                 return {Verdict::holds, weight_vertices_exist_printed(in.bounds("bounds"))};
               }),
      in_space("s41_weight_vertices_span", "repaired", "weight_vertices_exist",
               [](const auto& in) -> Judgement {
                 return {Verdict::holds, weight_vertices_exist_repaired(in.bounds("bounds"))};
               }),
      in_space("s41_weight_vertices_span", "printed", "weight_vertices_span",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto bounds = in.bounds("bounds");
                 const std::size_t n = bounds.low.size();
                 const auto weight_vertices = in.rows("weight_vertices", n);
                 const auto w = in.numbers("weights", n);
                 return {weight_vertices_span_hypotheses(bounds, weight_vertices) & admits<S>(bounds, w),
                         weight_vertices_span(bounds, weight_vertices, w).verdict};
               }),
      in_space("s41_weight_vertices_span", "printed", "weight_vertices_combine",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto bounds = in.bounds("bounds");
                 const auto weight_vertices = in.rows("weight_vertices", bounds.low.size());
                 const auto u = in.numbers("coefficients", weight_vertices.size());
                 return {weight_vertices_are_admissible(bounds, weight_vertices) & is_convex<S>(u),
                         weight_vertices_combine(bounds, weight_vertices, u).verdict};
               }),
      in_space("s41_weight_vertices_span", "beyond", "weight_vertices_are_few",
               [](const auto& in) -> Judgement {
                 const auto bounds = in.bounds("bounds");
                 const auto weight_vertices = in.rows("weight_vertices", bounds.low.size());
                 return {weight_vertices_are_proper(bounds, weight_vertices),
                         verdict_of(weight_vertices.size() <= most_weight_vertices(bounds.low.size()))};
               }),
      in_space("s42_linear_part_hull", "printed", "linear_part_in_hull",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto bounds = in.bounds("bounds");
                 const std::size_t n = bounds.low.size();
                 const auto weight_vertices = in.rows("weight_vertices", n);
                 const auto points = in.points("points");
                 const auto w = in.numbers("weights", points.size());
                 if (points.size() != n) in.fields.fail("points", "are not one for each weight");
                 return {linear_part_hull_hypotheses<S, 3>(bounds, weight_vertices, points) & admits<S>(bounds, w),
                         linear_part_in_hull<S, 3>(bounds, weight_vertices, points, w).verdict};
               }),
      in_space("s42_linear_part_hull", "printed", "hull_in_linear_part",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto bounds = in.bounds("bounds");
                 const auto weight_vertices = in.rows("weight_vertices", bounds.low.size());
                 const auto points = in.points("points");
                 const auto u = in.numbers("coefficients", weight_vertices.size());
                 if (points.size() != bounds.low.size()) in.fields.fail("points", "are not one for each weight");
                 return {linear_part_hull_hypotheses<S, 3>(bounds, weight_vertices, points) & is_convex<S>(u),
                         hull_in_linear_part<S, 3>(bounds, weight_vertices, points, u).verdict};
               }),
  };
}

std::vector<Statement> of_rotations() {
  return {
      in_any_dimension("s43_distance_range", "printed", "distance_is_in_range",
                       [](const auto& in) -> Judgement {
                         const auto c = in.point("center");
                         const auto r = in.number("radius");
                         return {distance_range_hypotheses_printed(c, r), distance_range(c, r).verdict};
                       }),
      in_any_dimension("s43_distance_range", "repaired", "distance_is_in_range",
                       [](const auto& in) -> Judgement {
                         const auto c = in.point("center");
                         const auto r = in.number("radius");
                         return {distance_range_hypotheses_repaired(c, r), distance_range(c, r).verdict};
                       }),
      in_space("s43_minkowski_sum", "printed", "turned_ball_is_sum",
               [](const auto& in) -> Judgement {
                 const auto q = in.non_zero_quaternion("blend");
                 const auto ball = in.ball("ball");
                 const auto x = in.point("point");
                 return {encloses(ball, x), turned_ball_in_sum(q, ball, in.point("pivot"), x).verdict};
               }),
      in_space("s43_rotated_cap", "printed", "rotated_vectors_in_doubled_cap",
               [](const auto& in) { return rotated_vectors<false>(in); }),
      in_space("s43_rotated_cap", "repaired", "rotated_vectors_in_doubled_cap",
               [](const auto& in) { return rotated_vectors<true>(in); }),
      in_space("s43_whole_sphere_fallback", "printed", "fallback_is_needed",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto c = in.quaternion("center");
                 const auto r2 = in.number("squared_radius");
                 return {units_in_ball<S>(in.quaternions("units"), c, r2) & fallback_is_needed_printed(r2),
                         fallback_is_needed_repaired(c, r2)};
               }),
      in_space("s43_whole_sphere_fallback", "printed", "line_15_makes_ball",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto c = in.quaternion("center");
                 const auto r2 = in.number("squared_radius");
                 return {units_in_ball<S>(in.quaternions("units"), c, r2), line_15_makes_ball_printed(c, r2)};
               }),
      in_space("s43_whole_sphere_fallback", "repaired", "blend_is_in_cap",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto c = in.quaternion("center");
                 const auto r2 = in.number("squared_radius");
                 const auto units = in.quaternions("units");
                 const auto u = in.numbers("coefficients", units.size());
                 return {units_in_ball<S>(units, c, r2) & ball_makes_cap(c, r2) & is_convex<S>(u),
                         blend_in_cap<S>(units, c, r2, u).verdict};
               }),
  };
}

std::vector<Statement> of_joint_sets() {
  return {
      in_space("s44_joint_sets", "printed", "ball_encloses_vertex", [](const auto& in) { return joint_sets<false>(in); }),
      in_space("s44_joint_sets", "repaired", "ball_encloses_vertex", [](const auto& in) { return joint_sets<true>(in); }),
      in_space("s44_sum_of_bounds", "printed", "ball_encloses_sum",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const PartBounds<S> bounds{in.points("linear"), in.ball("spherical"), in.number("inflation")};
                 const Parts<S> parts{in.numbers("coefficients", bounds.linear.size()), in.point("spherical_part"),
                                      in.point("offset")};
                 const auto ball = in.ball("ball");
                 return {sum_of_bounds_hypotheses(ball, bounds, parts), sum_of_bounds(ball, bounds, parts).verdict};
               }),
  };
}

std::vector<Statement> beyond_the_paper() {
  return {
      in_any_dimension("t3_min_dot_distance", "beyond", "distance_is_least_dot",
                       [](const auto& in) -> Judgement {
                         using S = NumberOf<decltype(in)>;
                         const auto units = in.points("units");
                         const auto c = in.point("center");
                         const auto r2 = in.number("squared_radius");
                         constexpr int d = std::decay_t<decltype(c)>::RowsAtCompileTime;
                         return {min_dot_distance_hypotheses<S, d>(units, c, r2), min_dot_distance<S, d>(units, c, r2).verdict};
                       }),
      in_space("t3_one_cap", "beyond", "cap_holds_blend",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto q = in.quaternions("quaternions");
                 const auto axis = in.non_zero_quaternion("axis");
                 const auto kappa2 = in.number("squared_cosine");
                 const auto u = in.numbers("coefficients", q.size());
                 return {one_cap_hypotheses<S>(q, axis, kappa2, u), one_cap<S>(q, axis, kappa2, u).verdict};
               }),
      in_space("t3_one_cap", "beyond", "blend_is_not_zero",
               [](const auto& in) -> Judgement {
                 using S = NumberOf<decltype(in)>;
                 const auto q = in.quaternions("quaternions");
                 const auto axis = in.non_zero_quaternion("axis");
                 const auto u = in.numbers("coefficients", q.size());
                 Verdict ahead = is_convex<S>(u);
                 for (const auto& x : q) ahead &= less(S(0), dot(x, axis));
                 return {ahead, less(S(0), squared_norm(combine<S, 4>(u, q)))};
               }),
      in_any_dimension("t3_smallest_ball_smallest_cap", "beyond", "nearest_point_makes_both",
                       [](const auto& in) -> Judgement {
                         using S = NumberOf<decltype(in)>;
                         const auto units = in.points("units");
                         const auto u = in.numbers("coefficients", units.size());
                         constexpr int d = std::decay_t<decltype(units[0])>::RowsAtCompileTime;
                         return {smallest_cap_hypotheses<S, d>(units, u), smallest_cap<S, d>(units, u).verdict};
                       }),
  };
}

}  // namespace

std::vector<Statement> section_statements() {
  return joined({of_weights(), of_rotations(), of_joint_sets(), beyond_the_paper()});
}

}  // namespace proptests::cases
