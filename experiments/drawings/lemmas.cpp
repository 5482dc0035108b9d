// SPDX-License-Identifier: GPL-3.0-or-later
// These are the drawings of the paper's lemmas.
#include "experiments/drawings/common.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

namespace refitlab::drawings {
namespace {

void lemma1(Plane &p) {
  const HalfSpace<double, 2> h{{1.2, 0.5}, 0.6};
  p.circle("surface", {0, 0}, 1);
  const auto made = cap_of_half_space_by_root(unit_circle, h);
  p.cap(made.cap);
  p.border(h);
  p.path("line", {{0, 0}, made.cap.apex});
  p.dot("dot", {0, 0}, "c"), p.dot("dot_in", made.cap.apex, "a");
}

void lemma2(Plane &p) {
  const VecList<double, 2> q{on_circle(-20) * 1.6, on_circle(35) * 0.7, on_circle(110) * 1.3};
  const auto lengths = lengths_by_roots<double, 2>(q);
  const auto n = divided<double, 2>(q, lengths);
  const std::vector<double> w{0.3, 0.3, 0.4};
  const auto partner = weights_on_same_ray(w, lengths);
  const Point a = combine<double, 2>(w, q), b = combine<double, 2>(partner.weights, n);
  p.circle("surface", {0, 0}, 1);
  p.path("hull", q, true), p.path("line", n, true);
  p.path("curve", {{0, 0}, a[0] * a[0] + a[1] * a[1] > b.squaredNorm() ? a : b});
  for (int i = 0; i < 3; ++i) p.dot("dot", q[i], "q" + std::to_string(i + 1)), p.dot("dot_in", n[i]);
  p.dot("dot", {0, 0}, "0"), p.dot("dot", a, "a"), p.dot("dot_in", b, "b");
}

void lemma3(Plane &p) {
  const SquaredBall<double, 2> ball{on_circle(25) * 1.1, 0.36};
  draw_surface_and_cap(p, ball);
  p.ball("ball", ball);
  const auto foot = nearest_point_of_intersection_cap(unit_circle, ball).foot;
  p.path("line", {{0, 0}, foot});
  p.dot("dot", {0, 0}, "0"), p.dot("dot", ball.center, "b"), p.dot("dot_in", foot, "d_H");
}

void lemma4(Plane &p) { draw_hull_in_cap(p, {on_circle(-35), on_circle(20), on_circle(70)}); }

void lemma5(Plane &p) {
  const Cap<double, 2> cap{{0, 0}, on_circle(20), -0.6};
  p.circle("surface", {0, 0}, 1);
  p.ball("ball", cap_ball_repaired(cap));
  p.ball("printed", cap_ball_printed(cap));
  p.cap(cap);
  p.dot("dot_out", cap.apex, "apex"), p.dot("dot", cap_ball_printed(cap).center, "printed"), p.dot("dot_in", {0, 0}, "repaired");
}

}  // namespace

const std::vector<Drawing> &drawings_of_lemmas() {
  static const std::vector<Drawing> all{{"lemma1_cap_definitions", lemma1,
                                         "The half-space (its border green) cuts the cap (yellow) with apex a "
                                         "from the circle about c."},
                                        {"lemma2_normalization", lemma2,
                                         "The hull of the q (filled) and that of the same vectors at length 1: "
                                         "the blend a and its partner b are on one "
                                         "ray from 0."},
                                        {"lemma3_sphere_surface_intersection", lemma3,
                                         "The ball about b cuts the cap (yellow) from the circle; its half-space "
                                         "is at the distance d from 0."},
                                        {"lemma4_quaternion_hull", lemma4,
                                         "Three unit vectors, their mean ball about c and its cap (yellow): the "
                                         "blend b, brought back to the circle, is "
                                         "in the cap."},
                                        {"lemma5_cap_enclosing_sphere", lemma5,
                                         "A cap (yellow) with cos α = −0.6: its apex is outside the printed ball "
                                         "(dashed); the repaired one is the whole "
                                         "circle’s."}};
  return all;
}

}  // namespace refitlab::drawings
