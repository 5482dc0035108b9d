// SPDX-License-Identifier: MIT
// An Obb is a box of any orientation, kept as three slabs along orthonormal axes [Gottschalk et al. 1996, "OBBTree: a
// hierarchical structure for rapid interference detection"].
//
// The axes come from a quaternion of any length, so that they are exactly orthonormal in an exact number type.
#pragma once

#include <array>
#include <span>
#include <type_traits>
#include <utility>

#include "algorithms/methods/volumes/box_orientation.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

template <class S>
struct Obb {
  std::array<Vec<S, 3>, 3> axes;  // orthonormal, right-handed
  Vec<S, 3> low, high;            // (x, axis) of its points is within [low, high], by axis; length units of the model

  // Returns the smallest box of this orientation that encloses all balls. balls is not empty, and orientation is not 0. Its
  // rotation takes the coordinate axes to the box's axes.
  static Obb around(std::span<const Ball3<S>> balls, const Quaternion<S>& orientation) {
    Obb out;
    const S squared_length = squared_norm(orientation);
    for (int i = 0; i < 3; ++i) {
      Vec<S, 3> unit(S(0), S(0), S(0));
      unit[i] = S(1);
      out.axes[i] = rotate_scaled(orientation, unit) / squared_length;
      out.low[i] = dot(balls[0].center, out.axes[i]) - balls[0].radius;
      out.high[i] = dot(balls[0].center, out.axes[i]) + balls[0].radius;
      for (const Ball3<S>& ball : balls.subspan(1)) {
        const S at = dot(ball.center, out.axes[i]);
        out.low[i] = min_of(out.low[i], S(at - ball.radius));
        out.high[i] = max_of(out.high[i], S(at + ball.radius));
      }
    }
    return out;
  }

  // Returns the box of least surface area among a few cheap orientations. The least of all orientations takes O(n^3) [O'Rourke
  // 1985].
  static Obb around(std::span<const Ball3<S>> balls) requires std::is_same_v<S, double> {
    const auto orientations = box_orientations(balls);
    Obb best = around(balls, orientations[0]);
    for (const auto& orientation : std::span(orientations).subspan(1))
      if (const Obb box = around(balls, orientation); box.surface_area() < best.surface_area()) best = box;
    return best;
  }

  Verdict contains(const Vec<S, 3>& x) const {
    Verdict all = Verdict::holds;
    for (int i = 0; i < 3; ++i) {
      const S at = dot(x, axes[i]);
      all &= less_equal(low[i], at) & less_equal(at, high[i]);
    }
    return all;
  }

  // Judges whether no axis separates the two. It tries the normals of all faces and the products of all pairs of edges, which is
  // enough. The product of parallel edges is 0 or a vector of rounding errors, which separates no boxes that meet.
  Verdict overlaps(const Obb& other) const {
    Verdict all = Verdict::holds;
    const auto check = [&](const Vec<S, 3>& direction) {
      const auto a = extent(direction), b = other.extent(direction);
      all &= less_equal(a.first, b.second) & less_equal(b.first, a.second);
    };
    for (int i = 0; i < 3 && all != Verdict::fails; ++i) {
      check(axes[i]);
      check(other.axes[i]);
    }
    for (int i = 0; i < 3 && all != Verdict::fails; ++i)
      for (int j = 0; j < 3; ++j) check(cross(axes[i], other.axes[j]));
    return all;
  }

  S volume() const { return edge(0) * edge(1) * edge(2); }
  S surface_area() const { return S(2) * (edge(0) * edge(1) + edge(1) * edge(2) + edge(2) * edge(0)); }

 private:
  S edge(int i) const { return high[i] - low[i]; }

  // Returns the least and the greatest (x, d) of its points.
  std::pair<S, S> extent(const Vec<S, 3>& d) const {
    S least(0), greatest(0);
    for (int i = 0; i < 3; ++i) {
      const S share = dot(d, axes[i]);
      if (equal(share, S(0)) == Verdict::holds) continue;  // a side may be infinite
      const S a = share * low[i], b = share * high[i];
      least = least + min_of(a, b);
      greatest = greatest + max_of(a, b);
    }
    return {least, greatest};
  }
};

}  // namespace refitlab
