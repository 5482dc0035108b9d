// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/refits/root_ball.hpp"

#include "algorithms/runtime/skinning/blend.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace proptests::oracle {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Balls = std::vector<SquaredBall<Rational, 3>>;

std::optional<Rational> rational_root(const Rational& x) {
  const CGAL::Gmpz n = x.numerator(), d = x.denominator();
  if (!mpz_perfect_square_p(n.mpz()) || !mpz_perfect_square_p(d.mpz())) return std::nullopt;
  return Rational(CGAL::sqrt(n), CGAL::sqrt(d));
}

// Returns a quaternion along the sum of q_k / ||q_k||, if the lengths are in rational ratios.
std::optional<RationalQuaternion> mean_direction(const std::vector<RationalQuaternion>& blends) {
  RationalQuaternion sum = RationalQuaternion::Zero();
  for (const auto& q : blends) {
    const auto ratio = rational_root(squared_norm(q) / squared_norm(blends[0]));
    if (!ratio) return std::nullopt;
    sum += q / *ratio;
  }
  return sum;
}

// Returns the ball of the images of u under the blends.
std::optional<SquaredBall<Rational, 3>> images(const std::vector<RationalQuaternion>& blends, const RationalVec<3>& u,
                                               Gather gather) {
  const SquaredBall<Rational, 3> all{RationalVec<3>::Zero(), squared_norm(u)};
  for (const auto& q : blends)
    if (squared_norm(q) == 0) return all;
  const auto axis = gather == Gather::at_first ? blends[0] : mean_direction(blends);
  if (!axis) return std::nullopt;
  for (const auto& q : blends)
    if (dot(q, *axis) <= 0) return all;
  const RationalVec<3> apex = rotate_scaled(*axis, u) / squared_norm(*axis);
  const Rational cosine = Rational(2) * squared_cap_cosine<Rational>(blends, *axis) - Rational(1);
  return cap_ball_repaired(Cap<Rational, 3>{RationalVec<3>::Zero(), apex, cosine});
}

RootBall gathered(const Balls& balls, Gather gather, const Rational& extra) {
  RootBall out{balls[0].center, {}, extra};
  if (gather == Gather::at_mean) {
    for (std::size_t i = 1; i < balls.size(); ++i) out.center += balls[i].center;
    out.center /= Rational(static_cast<int>(balls.size()));
  }
  for (const auto& b : balls) out.reaches.push_back({squared_distance(b.center, out.center), b.squared_radius});
  return out;
}

}  // namespace

bool encloses(const RootBall& ball, const RationalVec<3>& point) {
  const ExactRoot distance = root(lift<ExactRoot>(squared_distance(point, ball.center)));
  for (const auto& reach : ball.reaches) {
    const ExactRoot radius =
        root(lift<ExactRoot>(reach.squared_distance)) + root(lift<ExactRoot>(reach.squared_radius)) + lift<ExactRoot>(ball.extra);
    if (distance <= radius) return true;
  }
  return false;
}

std::optional<RootBall> repaired_ball(const gen::RefitCase& c, Gather gather) {
  Balls balls;
  for (const auto& set : c.sets) {
    std::vector<RationalQuaternion> blends;
    for (const auto& weight_vertex : set.weights.vertices)
      blends.push_back(blend_quaternion<Rational>(set.palette, weight_vertex));
    const auto turned = images(blends, c.reference.center - set.palette.rotation_center, gather);
    if (!turned) return std::nullopt;
    for (const auto& weight_vertex : set.weights.vertices)
      balls.push_back({blend_center<Rational>(set.palette, weight_vertex) + turned->center, turned->squared_radius});
  }
  return gathered(balls, gather, c.reference.radius);
}

RootBall linear_ball(const gen::RefitCase& c) {
  Balls balls;
  for (const auto& set : c.sets)
    for (const auto& weight_vertex : set.weights.vertices)
      balls.push_back({blend_linear<Rational>(set.palette, weight_vertex, c.reference.center), Rational(0)});
  return gathered(balls, Gather::at_mean, c.reference.radius);
}

}  // namespace proptests::oracle
