// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/batch_refit.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "algorithms/runtime/batch/single_precision.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

template <int D>
void append(std::vector<float>& to, const Vec<double, D>& v) {
  for (int i = 0; i < D; ++i) to.push_back(static_cast<float>(v[i]));
}

// Appends a joint-set of affine joints in the layout of rigid ones. Float loses a share of F ||p|| of an image, as of ||p||
// there.
void append_affine(std::vector<float>& to, const PaletteEntry<double>& set, const PaletteScales<double>& scales,
                   float largest_reference) {
  const double lengths = 1.001 * (scales.translation + scales.matrix * largest_reference);
  to.push_back(linear_refit_slack(static_cast<int>(set.maps.size())) * static_cast<float>(checked_single(lengths)));
  double stretch = 0;
  for (const double s : set.stretches) stretch = max_of(stretch, s);
  to.push_back(added_stretch(stretch));
  for (const AffineMap<double>& map : set.maps)
    for (int row = 0; row < 3; ++row)
      append<4>(to, {map.columns[0][row], map.columns[1][row], map.columns[2][row], map.offset[row]});
}

}  // namespace

float added_stretch(double stretch) {
  const DefaultFloatEnvironment environment;
  constexpr double lost = 4 * static_cast<double>(std::numeric_limits<float>::epsilon());
  return float_above(stretch - 1 + lost * max_of(stretch, 1.0));
}

const PackedBalls& BatchRefit::spherical(const SkinningPalette<double>& palette, Target target) {
  const DefaultFloatEnvironment environment;
  if (palette.is_affine()) throw std::invalid_argument("batch: a palette of affine joints is for linear skinning");
  numbers_.clear(), first_number_.clear();
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const PaletteEntry<double> set = palette[s];
    first_number_.push_back(static_cast<int>(numbers_.size()));
    double size = 0;
    for (const auto& image : set.center_images) size = std::max(size, squared_norm(image));
    append(numbers_, set.rotation_center);
    numbers_.push_back(static_cast<float>(checked_single(1.001 * (std::sqrt(size) + 2 * norm(set.rotation_center)))));
    for (std::size_t i = 0; i < set.transforms.size(); ++i) {
      // The kernel assumes that the quaternion of a single joint has unit length. That of a pose has it up to 1e-6.
      const Quaternion<double>& q = set.transforms[i].rotation;
      append(numbers_, set.transforms.size() == 1 ? Quaternion<double>(q / norm(q)) : q);
      append(numbers_, set.center_images[i]);
    }
  }
  const RefitKernels& kernels = refit_kernels(target);
  return refit(kernels.spherical_nodes, kernels.spherical_pieces, kernels.merge);
}

const PackedBalls& BatchRefit::linear(const SkinningPalette<double>& palette, Target target) {
  const DefaultFloatEnvironment environment;
  numbers_.clear(), first_number_.clear();
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const PaletteEntry<double> set = palette[s];
    first_number_.push_back(static_cast<int>(numbers_.size()));
    if (palette.is_affine()) {
      append_affine(numbers_, set, palette.scales(s), packed_.largest_reference());
      continue;
    }
    double size = 0, defect = 0;
    for (const auto& t : set.transforms) {
      size = std::max(size, squared_norm(t.translation));
      defect = std::max(defect, std::abs(squared_norm(t.rotation) - 1));
    }
    numbers_.push_back(linear_refit_slack(static_cast<int>(set.transforms.size())) *
                       (static_cast<float>(checked_single(1.001 * std::sqrt(size))) + packed_.largest_reference()));
    numbers_.push_back(float_above(error_of_rotate(defect + 0x1p-48)));  // what is below the rounding of ||q||^2 included
    for (const auto& t : set.transforms) {
      const auto rows = rotation_rows(t.rotation);
      for (int i = 0; i < 3; ++i) append<4>(numbers_, {rows[i][0], rows[i][1], rows[i][2], t.translation[i]});
    }
  }
  const RefitKernels& kernels = refit_kernels(target);
  return refit(kernels.linear_nodes, kernels.linear_pieces, kernels.merge);
}

const PackedBalls& BatchRefit::refit(RefitNodes nodes, RefitPieces pieces, MergeNodes merge) {
  checked_single(packed_.largest_reference());
  const FrameNumbers frame{numbers_.data(), first_number_.data()};
  nodes(packed_.nodes(), frame, balls_.data());
  pieces(packed_.pieces(), frame, records_.data());
  merge(packed_.merged().data(), static_cast<int>(packed_.merged().size()), records_.data(), balls_.numbers());
  return balls_;
}

}  // namespace refitlab
