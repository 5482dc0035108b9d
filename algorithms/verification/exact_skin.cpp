// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/verification/exact_skin.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/skinning/convert_palette.hpp"

namespace refitlab {

ExactSkin::ExactSkin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette, Skinning skinning,
                     const Deformation& deformation)
    : mesh_(mesh),
      sets_(sets),
      palette_(palette),
      skinning_(skinning),
      weights_(deformation.weights),
      scales_(make_scale_palette(mesh, sets, deformation.scales)),
      quick_(mesh.vertices.size()),
      exact_(mesh.vertices.size()) {}

template <class S>
Vec<S, 3> ExactSkin::skinned(int vertex) const {
  const OwnedPaletteEntry<S> palette = convert<S>(palette_[sets_.of_vertex(vertex)]);
  std::vector<S> weights;
  for (const double w : sets_.weights(vertex)) weights.push_back(S(w));
  OwnedPaletteEntry<S> scales;
  if (scales_.is_affine()) scales = convert<S>(scales_[sets_.of_vertex(vertex)]);
  std::vector<Displacement<S>> displacements;
  for (const auto& d : mesh_.displacements(vertex)) displacements.push_back({d.target, convert<S>(d.by)});
  std::vector<S> by_target;
  for (const double weight : weights_) by_target.push_back(S(weight));
  const Vec<S, 3> v = deformed<S>(convert<S>(mesh_.vertices[vertex]), displacements, by_target, scales, weights);
  return blend<S>(skinning_, palette, weights, v);
}

const Vec<Rational, 3>& ExactSkin::exact(int vertex) {
  auto& known = exact_[vertex];
  if (!known) known = skinned<Rational>(vertex);
  return *known;
}

const ExactSkin::Enclosure& ExactSkin::enclosure(int vertex) {
  auto& known = quick_[vertex];
  if (!known) {
    const Vec<Interval, 3> v = skinned<Interval>(vertex);
    known.emplace();
    known->error = 0;
    for (int i = 0; i < 3; ++i) {
      const double about = known->about[i] = (v[i].inf() + v[i].sup()) / 2;
      known->error += std::max(v[i].sup() - about, about - v[i].inf());
    }
  }
  return *known;
}

bool ExactSkin::is_in(const Ball3<double>& ball, int vertex) {
  const DefaultFloatEnvironment environment;
  if (!ball.center.allFinite()) return false;
  if (!std::isfinite(ball.radius)) return ball.radius == HUGE_VAL;
  const Enclosure& quick = enclosure(vertex);
  const double distance = norm<double, 3>(quick.about - ball.center);
  const double unsure = 2 * quick.error + 1e-14 * (distance + ball.radius) + 1e-150;  // far more than is rounded here
  if (distance + unsure < ball.radius) return true;
  if (distance - unsure > ball.radius) return false;
  return encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, exact(vertex)) == Verdict::holds;
}

bool ExactSkin::is_in(const Box<double>& box, int vertex) {
  const DefaultFloatEnvironment environment;
  const Enclosure& quick = enclosure(vertex);
  for (int i = 0; i < 3; ++i) {
    if (std::isnan(box.low[i]) || std::isnan(box.high[i])) return false;
    // This is how far it is inside of the nearer wall.
    const double depth = std::min(quick.about[i] - box.low[i], box.high[i] - quick.about[i]);
    const double unsure = 2 * quick.error + 1e-14 * std::abs(quick.about[i]) + 1e-150;
    if (depth > unsure) continue;
    if (depth < -unsure) return false;
    const Rational& at = exact(vertex)[i];
    if (std::isfinite(box.low[i]) && at < Rational(box.low[i])) return false;
    if (std::isfinite(box.high[i]) && at > Rational(box.high[i])) return false;
  }
  return true;
}

}  // namespace refitlab
