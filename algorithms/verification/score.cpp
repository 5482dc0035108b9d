// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/verification/score.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {
namespace {

template <class S>
OwnedPaletteEntry<S> lift_palette(const OwnedPaletteEntry<Rational>& palette) {
  OwnedPaletteEntry<S> out{lift<S>(palette.transforms), lift<S>(palette.rotation_center), lift<S>(palette.center_images), {}};
  place_duals(out);
  return out;
}

// Appends the parts of W' below and above the middle of its widest weight, except empty ones. Each part is halved again, `times`
// - 1 times.
void halve(const WeightBounds<Rational>& bounds, int times, std::vector<WeightBounds<Rational>>& out) {
  std::size_t widest = 0;
  for (std::size_t i = 1; i < bounds.low.size(); ++i)
    if (bounds.high[widest] - bounds.low[widest] < bounds.high[i] - bounds.low[i]) widest = i;
  if (times == 0 || bounds.low[widest] == bounds.high[widest]) return out.push_back(bounds);
  const Rational middle = (bounds.low[widest] + bounds.high[widest]) / Rational(2);
  WeightBounds<Rational> below = bounds, above = bounds;
  below.high[widest] = above.low[widest] = middle;
  halve(below, times - 1, out);
  halve(above, times - 1, out);
}

double as_double(const Interval& x) { return CGAL::to_double(x); }
double as_double(const MultiprecisionInterval& x) { return static_cast<double>(median(x)); }
double as_double(const Rational& x) { return CGAL::to_double(x); }

struct Containment {
  Verdict verdict;
  double gap = 0;  // where it fails: by how much the image reaches beyond the ball
};

template <class S>
Containment is_held(const Ball3<double>& ball, const Ball3<S>& image) {
  const Ball3<S> outer{convert<S>(ball.center), S(ball.radius)};
  const Verdict v = encloses(outer, image);
  if (v != Verdict::fails) return {v};
  const S squared = squared_distance(outer.center, image.center), slack = outer.radius - image.radius;
  const double distance = std::sqrt(as_double(squared)), reach = as_double(slack);
  // This is computed as a quotient, because the difference of distance and reach would have no digits left.
  if (reach <= 0) return {v, distance - reach};
  return {v, as_double(S(squared - sq(slack))) / (distance + reach)};
}

}  // namespace

CaseNodes::CaseNodes(const SyntheticCase& synthetic) : reference_(lift<double>(synthetic.reference)) {
  const DefaultFloatEnvironment environment;
  constexpr int halvings = 2;
  for (const SyntheticSet& set : synthetic.sets) {
    const int number = static_cast<int>(palette_.size());
    palette_.push_back(lift_palette<double>(set.palette));
    const auto add = [&](Pieces pieces, const std::vector<RationalWeights>& weight_vertices) {
      if (weight_vertices.empty()) return;
      Description& d = descriptions_[static_cast<int>(pieces)];
      d.pieces.push_back({number, static_cast<int>(d.weight_vertices.size()), static_cast<int>(weight_vertices.size()),
                          static_cast<int>(d.pieces.size())});
      if (pieces != Pieces::node) d.references.push_back(lift<double>(set.reference));
      for (const auto& weight_vertex : weight_vertices)
        for (const Rational& w : weight_vertex) d.weight_vertices.push_back(lift<double>(w));
    };
    add(Pieces::node, set.weight_vertices);
    add(Pieces::joint_sets, set.weight_vertices);
    add(Pieces::mixed, set.weight_vertices);  // a synthetic case has no vertices to list
    std::vector<WeightBounds<Rational>> boxes;
    halve(set.bounds, halvings, boxes);
    for (const auto& box : boxes) add(Pieces::many, *enumerate_weight_vertices(box, std::size_t(-1) / 2));
  }
}

SkinnedCase::SkinnedCase(const SyntheticCase& synthetic, Skinning skinning) : skinning_(skinning) {
  const DefaultFloatEnvironment environment;
  for (const SyntheticSet& set : synthetic.sets) weights_.push_back(sampled_weights(set));
  for (std::size_t z = 0; z < synthetic.sets.size(); ++z) {
    const SyntheticSet& set = synthetic.sets[z];
    size_ = std::max(size_, norm(lift<double>(set.palette.rotation_center)));
    for (const auto& image : set.palette.center_images) size_ = std::max(size_, norm(lift<double>(image)));
    const auto& [p, r] = set.reference;
    for (const RationalWeights& w : weights_[z]) {
      const auto add = [&](const Vec<Rational, 3>& vertex, const Rational& radius) {
        targets_.push_back({&set, &w, vertex, radius, {}, {}, {}});
        targets_.back().image = skinned<Interval>(targets_.back());
      };
      if (skinning != Skinning::linear || r == 0) {
        add(p, r);
        continue;
      }
      for (int i = 0; i < 3; ++i) {
        const Vec<Rational, 3> arm = Vec<Rational, 3>::Unit(i) * r;
        add(p + arm, Rational(0));
        add(p - arm, Rational(0));
      }
    }
  }
}

template <class S>
Ball3<S> SkinnedCase::skinned(const Target& target) const {
  const OwnedPaletteEntry<S> palette = lift_palette<S>(target.set->palette);
  const std::vector<S> w = lift<S>(*target.weights);
  const Vec<S, 3> v = lift<S>(target.vertex);
  return {blend<S>(skinning_, palette, w, v), lift<S>(target.radius)};
}

CaseScore SkinnedCase::score(const Ball3<double>& ball) {
  const DefaultFloatEnvironment environment;
  CaseScore out;
  if (skinning_ == Skinning::dual_quaternion && ball.center.allFinite() && ball.radius == HUGE_VAL) return {.unbounded = true};
  if (!(ball.center.allFinite() && std::isfinite(ball.radius) && ball.radius >= 0))
    return {.undefined = true, .misses = true, .worst_miss = 1};
  const double size = size_ + norm(ball.center) + ball.radius;
  for (Target& target : targets_) {
    Containment held = is_held(ball, target.image);
    if (held.verdict == Verdict::undecided) {
      if (!target.closer) target.closer = skinned<MultiprecisionInterval>(target);
      held = is_held(ball, *target.closer);
    }
    if (held.verdict == Verdict::undecided) {
      if (!target.exact) target.exact = skinned<Rational>(target);
      held = is_held(ball, *target.exact);
    }
    if (held.verdict != Verdict::fails) continue;
    out.misses = true;
    out.worst_miss = std::max(out.worst_miss, held.gap / size);
  }
  return out;
}

double SkinnedCase::smallest_radius() const {
  const DefaultFloatEnvironment environment;
  std::vector<Ball3<double>> images;
  for (const Target& target : targets_) {
    const auto& c = target.image.center;
    images.push_back({{as_double(c[0]), as_double(c[1]), as_double(c[2])}, as_double(target.image.radius)});
  }
  return smallest_ball_of_balls(images).radius;
}

}  // namespace refitlab
