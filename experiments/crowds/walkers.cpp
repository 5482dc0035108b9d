// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/walkers.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace refitlab {
namespace {

constexpr double metres_per_second = 1.2, frames_per_second = 30;

}  // namespace

Walkers::Walkers(const Clip& walk, int count, const Spacing& spacing) {
  std::mt19937 random(seed);
  const double side = spacing.edge * std::sqrt(count);
  const int in_a_row = static_cast<int>(std::ceil(std::sqrt(count)));
  std::uniform_real_distribution<double> place(0, side), angle(0, 2 * std::numbers::pi), share(0, 1);
  for (int i = 0; i < count; ++i) {
    const double turn = angle(random), start = share(random);
    double x = place(random), z = place(random);
    if (spacing.is_even) x = spacing.edge * (i % in_a_row), z = spacing.edge * (i / in_a_row);
    for (int f = 0; f < frames; ++f) {
      poses_[f].push_back(walk.sample(std::fmod(start + f / frames_per_second / walk.duration, 1.0) * walk.duration));
      const double ahead = metres_per_second * f / frames_per_second;
      placements_[f].push_back(
          {{std::cos(turn / 2), 0, std::sin(turn / 2), 0}, {x + ahead * std::sin(turn), 0, z + ahead * std::cos(turn)}});
    }
  }
}

}  // namespace refitlab
