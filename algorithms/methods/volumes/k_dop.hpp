// SPDX-License-Identifier: MIT
// A KDop is a discrete-orientation polytope, the points between k/2 pairs of parallel planes of fixed directions [Klosowski et
// al. 1998, "Efficient collision detection using bounding volume hierarchies of k-DOPs"].
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "algorithms/methods/volumes/polytope.hpp"
#include "algorithms/runtime/balls/slab_directions.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

template <class S, int k>
struct KDop {
  static constexpr std::array<SlabDirection, k / 2> directions = slab_directions<k>();

  // For each direction d, (x, d) of its points is within [low, high], in length units of the model times ||d||.
  std::array<S, k / 2> low, high;

  // Returns the smallest KDop that encloses all balls, up to the rounding of ||d||. balls is not empty.
  static KDop around(std::span<const Ball3<S>> balls) {
    KDop out;
    for_each_slab([&]<std::size_t i>() {
      out.low[i] = lowest<i>(balls[0]);
      out.high[i] = highest<i>(balls[0]);
    });
    for (const Ball3<S>& ball : balls.subspan(1))
      for_each_slab([&]<std::size_t i>() {
        out.low[i] = min_of(out.low[i], lowest<i>(ball));
        out.high[i] = max_of(out.high[i], highest<i>(ball));
      });
    return out;
  }

  Verdict contains(const Vec<S, 3>& x) const {
    Verdict all = Verdict::holds;
    for_each_slab([&]<std::size_t i>() {
      const S at = along<directions[i]>(x);
      all &= less_equal(low[i], at) & less_equal(at, high[i]);
    });
    return all;
  }

  // Judges whether no slab separates the two. It fails only if they are disjoint; for k = 6 it holds only if they are not.
  Verdict overlaps(const KDop& other) const {
    Verdict all = Verdict::holds;
    for (std::size_t i = 0; i < directions.size(); ++i)
      all &= less_equal(low[i], other.high[i]) & less_equal(other.low[i], high[i]);
    return all;
  }

  S volume() const { return polytope().volume(); }
  S surface_area() const { return polytope().surface_area(); }

 private:
  template <class Visit>
  static void for_each_slab(const Visit& visit) {
    [&]<std::size_t... i>(std::index_sequence<i...>) { (visit.template operator()<i>(), ...); }
    (std::make_index_sequence<k / 2>());
  }

  template <std::size_t i>
  static S lowest(const Ball3<S>& b) {
    return along<directions[i]>(b.center) - b.radius * S(length_bound(directions[i]));
  }
  template <std::size_t i>
  static S highest(const Ball3<S>& b) {
    return along<directions[i]>(b.center) + b.radius * S(length_bound(directions[i]));
  }

  // Returns the polytope as seen from the middle of its box, where it loses no digits.
  Polytope<S> polytope() const {
    Vec<S, 3> middle;
    S reach(0);
    for (int i = 0; i < 3; ++i) {
      middle[i] = (low[i] + high[i]) / S(2);
      reach = reach + (high[i] - low[i]) / S(2);
    }
    std::vector<HalfSpace<S, 3>> half_spaces;
    for_each_slab([&]<std::size_t i>() {
      const SlabDirection& d = directions[i];
      const Vec<S, 3> normal{S(d[0]), S(d[1]), S(d[2])};
      const S at = along<directions[i]>(middle);
      half_spaces.push_back({normal, low[i] - at});
      half_spaces.push_back({-normal, at - high[i]});
    });
    return {std::move(half_spaces), reach};
  }
};

}  // namespace refitlab
