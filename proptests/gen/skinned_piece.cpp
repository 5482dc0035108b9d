// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/skinned_piece.hpp"

#include <array>
#include <cmath>

namespace proptests::gen {
namespace {

using namespace refitlab;

template <int D>
Vec<double, D> normal(std::mt19937& random, double size) {
  Vec<double, D> out;
  for (int i = 0; i < D; ++i) out[i] = size * std::normal_distribution<double>(0, 1)(random);
  return out;
}

// Returns a quaternion of unit length but for rounding, off by the tolerance of poses, rounded to floats, or of any length.
Quaternion<double> with_some_length(Quaternion<double> q, int kind, std::mt19937& random) {
  q /= std::sqrt(squared_norm(q));
  if (kind == 1) q *= std::uniform_int_distribution<int>(0, 1)(random) ? 1 + 5e-7 : 1 - 5e-7;
  if (kind == 2) q = q.cast<float>().cast<double>();
  if (kind == 3) q *= std::uniform_real_distribution<double>(0.5, 2)(random);
  return q;
}

// Draws weights of 64 parts, spread over some of n.
std::vector<double> some_weights(std::mt19937& random, std::size_t n) {
  std::vector<double> w(n);
  if (random() % 3 == 0) {
    w[random() % n] = 1;
    return w;
  }
  const auto any = [&] { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (int left = 64, part; left > 0; left -= part) {
    part = std::uniform_int_distribution<int>(1, left)(random);
    w[any()] += part / 64.;
  }
  return w;
}

}  // namespace

SkinnedPiece::SkinnedPiece(std::mt19937& random, Skinning skinning, int most_weight_vertices) : skinning(skinning) {
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  has_relation = pick(4) == 0;
  const int n = 1 + pick(5), kind = pick(4), m = 1 + pick(most_weight_vertices);
  const double spread = std::array{0., 0.1, 0.4, 0.8, 100.}[pick(5)];
  const bool has_other_signs = pick(6) == 0, has_other_duals = pick(4) == 0;
  const Quaternion<double> common = normal<4>(random, 1);
  palette.rotation_center = normal<3>(random, 1);
  for (int i = 0; i < n; ++i) {
    Quaternion<double> turn = normal<4>(random, spread);
    turn[0] = has_other_signs && spread > 0 ? turn[0] : 1;
    const Quaternion<double> q = with_some_length(multiply<double>(common, turn), kind, random);
    palette.transforms.push_back({q, normal<3>(random, 1)});
    palette.center_images.push_back(normal<3>(random, pick(2)));
    palette.duals.push_back(has_other_duals ? normal<4>(random, 1) : dual_part(palette.transforms[i]));
  }
  if (has_relation && n > 1) {
    const Quaternion<double> half_turn = {0, 1, 0, 0}, first = palette.transforms[0].rotation;
    palette.transforms[1].rotation = pick(2) ? Quaternion<double>(-first) : multiply<double>(first, half_turn);
    if (n > 2) palette.transforms[2].rotation = -palette.transforms[1].rotation;
  }
  for (int k = 0; k < m; ++k) weight_vertices.push_back(some_weights(random, n));
  reference = {normal<3>(random, 1), pick(4) ? std::uniform_real_distribution<double>(0, 1)(random) : 0};
  store();
}

SkinnedPiece::SkinnedPiece(Skinning skinning, OwnedPaletteEntry<double> palette, std::vector<std::vector<double>> weight_vertices,
                           const Ball3<double>& reference)
    : skinning(skinning),
      palette(std::move(palette)),
      weight_vertices(std::move(weight_vertices)),
      reference(reference) {
  store();
}

void SkinnedPiece::store() {
  palette_.push_back(palette);
  for (const auto& w : weight_vertices) weights_.insert(weights_.end(), w.begin(), w.end());
  sets_.push_back({0, 0, static_cast<int>(weight_vertices.size())});
}

}  // namespace proptests::gen
