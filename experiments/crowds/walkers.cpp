// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/walkers.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace refitlab {

Walkers::Walkers(const Clip& walk, int count, const Spacing& spacing, int starts)
    : poses_(starts * frames_of_a_start),
      placements_(starts * frames_of_a_start) {
  std::mt19937 random(seed);
  const double side = spacing.edge * std::sqrt(count);
  const int in_a_row = static_cast<int>(std::ceil(std::sqrt(count)));
  std::uniform_real_distribution<double> place(0, side), angle(0, 2 * std::numbers::pi), share(0, 1);
  for (int first = 0; first < frames(); first += frames_of_a_start)
    for (int i = 0; i < count; ++i) {
      const double turn = angle(random), start = share(random);
      double x = place(random), z = place(random);
      if (spacing.is_even) x = spacing.edge * (i % in_a_row), z = spacing.edge * (i / in_a_row);
      for (int f = 0; f < frames_of_a_start; ++f) {
        const double seconds = f / frames_per_second, ahead = metres_per_second * seconds;
        poses_[first + f].push_back(walk.sample(std::fmod(start + seconds / walk.duration, 1.0) * walk.duration));
        placements_[first + f].push_back(
            {{std::cos(turn / 2), 0, std::sin(turn / 2), 0}, {x + ahead * std::sin(turn), 0, z + ahead * std::cos(turn)}});
      }
    }
}

}  // namespace refitlab
