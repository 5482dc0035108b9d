// SPDX-License-Identifier: GPL-3.0-or-later
// States Lemmas 1 to 5 about cases.
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "proptests/cases/statements.hpp"

namespace proptests::cases {
namespace {

using namespace refitlab;

std::vector<Statement> of_cap_definitions() {
  return {
      in_any_dimension(
          "lemma1_cap_definitions", "printed", "half_space_is_cap",
          [](const auto& in) -> Judgement {
            const auto surface = in.squared_ball("surface");
            const auto h = in.half_space("half_space");
            const auto x = in.point("point");
            return {meets(surface, h) & on_surface(surface, x), half_space_is_cap_printed(surface, h, in.number("scale"), x)};
          }),
      in_any_dimension("lemma1_cap_definitions", "repaired", "half_space_is_cap",
                       [](const auto& in) -> Judgement {
                         const auto surface = in.squared_ball("surface");
                         const auto h = in.half_space("half_space");
                         const auto scale = in.number("scale");
                         const auto x = in.point("point");
                         using S = typename std::decay_t<decltype(in)>::Number;
                         const Verdict met = cuts_cap(surface, h) & is_cap_scale(surface, h, scale) & on_surface(surface, x);
                         // For r = 0 there is no cap to build.
                         if (equal(surface.squared_radius, S(0)) != Verdict::fails) return {met, Verdict::fails};
                         const auto made = cap_of_half_space(surface, h, scale);
                         return {met, is_cap_of_half_space(surface, h, made) & definitions_agree(h, made.cap, x)};
                       }),
      in_any_dimension("lemma1_cap_definitions", "repaired", "cap_is_half_space",
                       [](const auto& in) -> Judgement {
                         const auto cap = in.cap("cap");
                         const auto x = in.point("point");
                         const auto made = half_space_of_cap(cap);
                         return {is_proper_cap(cap) & equal(squared_distance(x, cap.center), squared_radius(cap)),
                                 made.verdict & is_half_space_of_cap(cap, made) & definitions_agree(made.half_space, cap, x)};
                       }),
  };
}

std::vector<Statement> of_normalization() {
  return {
      in_space(
          "lemma2_normalization", "printed", "normalisation_keeps_rotations",
          [](const auto& in) -> Judgement {
            const auto q = in.quaternions("vectors");
            const auto lengths = in.numbers("factors", q.size()), w = in.numbers("weights", q.size());
            using S = typename std::decay_t<decltype(in)>::Number;
            return {are_lengths<S, 4>(q, lengths) & is_convex<S>(w), normalisation_keeps_rotations_printed<S, 4>(q, lengths, w)};
          }),
      in_space("lemma2_normalization", "repaired", "normalisation_keeps_rotations",
               [](const auto& in) -> Judgement {
                 const auto q = in.quaternions("vectors");
                 const auto lengths = in.numbers("factors", q.size()), w = in.numbers("weights", q.size());
                 using S = typename std::decay_t<decltype(in)>::Number;
                 // The conclusion alone, without "the element is not 0", is the printed one.
                 return {are_lengths<S, 4>(q, lengths) & is_convex<S>(w) & less(S(0), squared_norm(combine<S, 4>(w, q))),
                         normalisation_keeps_rotations_printed<S, 4>(q, lengths, w)};
               }),
      in_space("lemma2_normalization", "repaired", "normalisation_keeps_rays",
               [](const auto& in) -> Judgement {
                 const auto q = in.quaternions("vectors");
                 const auto factors = in.numbers("factors", q.size()), w = in.numbers("weights", q.size());
                 using S = typename std::decay_t<decltype(in)>::Number;
                 const Verdict met = are_positive(factors) & is_convex<S>(w);
                 S sum(0);
                 Verdict can_divide = Verdict::holds;
                 for (std::size_t i = 0; i < q.size(); ++i) {
                   can_divide &= !equal(factors[i], S(0));
                   sum = sum + w[i] * factors[i];
                 }
                 can_divide &= !equal(sum, S(0));
                 if (can_divide != Verdict::holds) return {met, can_divide};
                 return {met, is_same_ray<S, 4>(q, w, divided<S, 4>(q, factors), weights_on_same_ray(w, factors))};
               }),
  };
}

std::vector<Statement> of_surface_intersections() {
  return {
      in_any_dimension("lemma3_sphere_surface_intersection", "printed", "intersection_is_cap",
                       [](const auto& in) -> Judgement {
                         const auto surface = in.squared_ball("surface"), ball = in.squared_ball("ball");
                         const auto x = in.point("point");
                         return {on_surface(surface, x), intersection_is_cap_printed(surface, ball, x)};
                       }),
      in_any_dimension("lemma3_sphere_surface_intersection", "repaired", "intersection_is_cap",
                       [](const auto& in) -> Judgement {
                         const auto surface = in.squared_ball("surface"), ball = in.squared_ball("ball");
                         const auto x = in.point("point");
                         const auto made = intersection_cap(surface, ball);
                         return {are_eccentric(surface, ball) & surface_meets_ball(surface, ball) & on_surface(surface, x),
                                 made.verdict & is_intersection_cap(surface, ball, made) &
                                     ball_and_half_space_agree(ball, made.half_space, x)};
                       }),
      in_any_dimension(
          "lemma3_sphere_surface_intersection", "printed", "intersection_distance",
          [](const auto& in) -> Judgement {
            const auto ball = in.squared_ball("ball");
            using S = typename std::decay_t<decltype(in)>::Number;
            return {less_equal(S(0), ball.squared_radius) & less(ball.squared_radius, S(1)), intersection_distance_printed(ball)};
          }),
      in_any_dimension("lemma3_sphere_surface_intersection", "repaired", "intersection_distance",
                       [](const auto& in) -> Judgement {
                         const auto surface = in.squared_ball("surface"), ball = in.squared_ball("ball");
                         using S = typename std::decay_t<decltype(in)>::Number;
                         const Verdict apart = are_eccentric(surface, ball);
                         const Verdict met = apart & less_equal(S(0), intersection_offset(surface, ball));
                         if (apart != Verdict::holds) return {met, apart};
                         return {met, is_nearest_point(intersection_cap(surface, ball).half_space, surface.center,
                                                       nearest_point_of_intersection_cap(surface, ball))};
                       }),
  };
}

std::vector<Statement> of_quaternion_hulls() {
  return {
      in_any_dimension("lemma4_quaternion_hull", "printed", "radius_below_one_is_needed",
                       [](const auto& in) -> Judgement {
                         const auto ball = in.squared_ball("ball");
                         return {are_units_enclosed(ball, in.points("units")) & ball_keeps_hulls(ball),
                                 radius_below_one_is_needed_printed(ball)};
                       }),
      in_any_dimension("lemma4_quaternion_hull", "printed", "hull_stays_in_cap",
                       [](const auto& in) -> Judgement {
                         const auto ball = in.squared_ball("ball");
                         const auto units = in.points("units");
                         const auto w = in.numbers("weights", units.size());
                         return {hull_hypotheses_printed(ball, units, w), hull_stays_in_cap_printed(ball, units, w)};
                       }),
      in_any_dimension("lemma4_quaternion_hull", "repaired", "hull_stays_in_cap",
                       [](const auto& in) -> Judgement {
                         const auto ball = in.squared_ball("ball");
                         const auto units = in.points("units");
                         const auto w = in.numbers("weights", units.size());
                         using S = typename std::decay_t<decltype(in)>::Number;
                         const auto made = hull_element(ball, units, w);
                         // b / ||b|| is in the cap; where the cap is less than a half, b is not 0.
                         const Verdict is_direction = less(S(0), squared_norm(made.blend));
                         return {are_units_enclosed(ball, units) & is_convex<S>(w) & ball_keeps_hulls(ball),
                                 implies(less(S(0), scaled_distance(ball.center, ball.squared_radius)), is_direction) &
                                     implies(is_direction, made.verdict)};
                       }),
      in_any_dimension("lemma4_quaternion_hull", "repaired", "rotations_stay_in_cap",
                       [](const auto& in) -> Judgement {
                         const auto ball = in.squared_ball("ball");
                         const auto units = in.points("units");
                         const auto w = in.numbers("weights", units.size());
                         using S = typename std::decay_t<decltype(in)>::Number;
                         const auto made = hull_element(ball, units, w);
                         return {are_units_enclosed(ball, units) & is_convex<S>(w) & less(S(0), squared_norm(made.blend)),
                                 rotation_is_enclosed(ball, made.blend)};
                       }),
  };
}

std::vector<Statement> of_cap_balls() {
  return {
      in_any_dimension("lemma5_cap_enclosing_sphere", "printed", "ball_encloses_cap",
                       [](const auto& in) -> Judgement {
                         const auto cap = in.cap("cap");
                         const auto x = in.point("point");
                         return {cap_ball_hypotheses_printed(cap) & contains(cap, x), cap_ball_encloses_printed(cap, x)};
                       }),
      in_any_dimension("lemma5_cap_enclosing_sphere", "repaired", "ball_encloses_cap",
                       [](const auto& in) -> Judgement {
                         const auto cap = in.cap("cap");
                         const auto x = in.point("point");
                         return {cap_has_points(cap) & contains(cap, x), encloses(cap_ball_repaired(cap), x)};
                       }),
      in_any_dimension("lemma5_cap_enclosing_sphere", "repaired", "no_other_ball_is_that_small",
                       [](const auto& in) -> Judgement {
                         const auto cap = in.cap("cap");
                         const auto rim = in.point("rim_direction");
                         const auto sine = in.number("sine");
                         const auto made = smallest_cap_ball(cap, sine, rim);
                         return {cap_has_points(cap) & is_rim(cap, sine, rim),
                                 is_smallest_cap_ball(cap, made) & no_other_ball_that_small(made, in.squared_ball("other"))};
                       }),
  };
}

}  // namespace

std::vector<Statement> lemma_statements() {
  return joined({of_cap_definitions(), of_normalization(), of_surface_intersections(), of_quaternion_hulls(), of_cap_balls()});
}

}  // namespace proptests::cases
