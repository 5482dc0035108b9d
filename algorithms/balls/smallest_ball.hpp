// The smallest enclosing ball of points of R^d, with its support, by walking [Fischer, Gaertner and Kutz 2003, "Fast
// smallest-enclosing-ball computation in high dimensions"].
//
// The center starts anywhere and the support is the point farthest from it. The center walks towards the affine hull of
// the support, so that all of the support stays equally far; a point that would fall outside stops the walk and joins the
// support. Once the center is in the hull, a support point with a negative coefficient leaves, and where there is none
// the ball is smallest. Only + - * / are needed: the same template runs in double and decides in exact rationals.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "algorithms/balls/mean_ball.hpp"

namespace refitlab {

// The certificate of a smallest ball: its center is a convex combination of support points that all lie on its boundary.
template <class S, int D>
struct SmallestBall {
  Vec<S, D> center;
  S squared_radius;                          // of the farthest point, so that the ball encloses all of them
  std::array<int, D + 1> support;            // indices of the points, the first support_size of them
  std::array<S, D + 1> coefficients;         // of the combination: non-negative, sum 1
  int support_size = 0;
  bool converged = false;                    // false only where rounding kept the walk from ending (never in exact numbers)
};

namespace detail {

// Coefficients x (one a support point, sum 1) of the projection of center onto the affine hull of the support: the Gram
// system of the differences to the first support point, by LDL^T. Nothing if the system is singular.
template <class S, int D>
std::optional<std::array<S, D + 1>> project_on_hull(const Vec<S, D>& center, std::span<const Vec<S, D>> points,
                                                    const std::array<int, D + 1>& support, int size) {
  const Vec<S, D>& base = points[support[0]];
  const int n = size - 1;
  std::array<Vec<S, D>, D> edge;
  std::array<std::array<S, D>, D> gram;
  std::array<S, D + 1> x;
  for (int i = 0; i < n; ++i) {
    edge[i] = points[support[i + 1]] - base;
    x[i + 1] = dot<S, D>(edge[i], center - base);
    for (int j = 0; j <= i; ++j) gram[i][j] = dot(edge[i], edge[j]);
  }
  for (int j = 0; j < n; ++j) {  // factorise in place: unit lower triangle below, D on the diagonal
    if (!(S(0) < gram[j][j])) return std::nullopt;
    for (int i = j + 1; i < n; ++i) {
      const S factor = gram[i][j] / gram[j][j];
      for (int k = j + 1; k <= i; ++k) gram[i][k] = gram[i][k] - factor * gram[k][j];
      x[i + 1] = x[i + 1] - factor * x[j + 1];
    }
  }
  // Now gram[i][j] below the diagonal still holds L_ij d_j, and x holds L^-1 times the right-hand side.
  S rest(1);
  for (int i = n; i-- > 0;) {
    for (int k = i + 1; k < n; ++k) x[i + 1] = x[i + 1] - gram[k][i] * x[k + 1];
    x[i + 1] = x[i + 1] / gram[i][i];
    rest = rest - x[i + 1];
  }
  x[0] = rest;
  return x;
}

}  // namespace detail

template <class S, int D>
class SmallestBallWalk {
 public:
  explicit SmallestBallWalk(std::span<const Vec<S, D>> points) : points_(points) {
    ball_.center = points[0];
    ball_.support[0] = farthest().first;
    ball_.support_size = 1;
  }

  SmallestBall<S, D> run() {
    // Dropping the most negative coefficient is fast and in rare degenerate cases cycles; the smallest index never does.
    const int patience = 20 * (static_cast<int>(points_.size()) + D);
    bool in_hull = false;  // the center is the circumcenter of the support
    for (int step = 0; step < 4 * patience && !ball_.converged; ++step) {
      const auto x = detail::project_on_hull<S, D>(ball_.center, points_, ball_.support, ball_.support_size);
      if (!x) {  // rounding made the support dependent: let its last point go
        --ball_.support_size;
        in_hull = false;
      } else if (!in_hull) {
        in_hull = walk_towards(*x);
      } else if (const int unneeded = negative_coefficient(*x, step < patience); unneeded >= 0) {
        drop(unneeded);
        in_hull = false;
      } else {
        ball_.coefficients = *x;
        ball_.converged = true;
      }
    }
    ball_.squared_radius = farthest().second;
    return ball_;
  }

 private:
  std::pair<int, S> farthest() const {
    int index = 0;
    S far = squared_distance(points_[0], ball_.center);
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      const S d = squared_distance(points_[i], ball_.center);
      if (far < d) far = d, index = i;
    }
    return {index, far};
  }

  bool in_support(int i) const {
    for (int k = 0; k < ball_.support_size; ++k)
      if (ball_.support[k] == i) return true;
    return false;
  }

  // The position in the support of the most negative coefficient, or of the negative one of smallest index; -1: none.
  int negative_coefficient(const std::array<S, D + 1>& x, bool most_negative) const {
    int found = -1;
    for (int k = 0; k < ball_.support_size; ++k)
      if (x[k] < S(0) && (found < 0 || (most_negative ? x[k] < x[found] : ball_.support[k] < ball_.support[found]))) found = k;
    return found;
  }

  void drop(int position) {
    --ball_.support_size;
    for (int k = position; k < ball_.support_size; ++k) ball_.support[k] = ball_.support[k + 1];
  }

  // Moves the center towards the point of the support's hull with coefficients x, as far as no other point falls outside.
  // True if it then is the circumcenter of the support.
  bool walk_towards(const std::array<S, D + 1>& x) {
    Vec<S, D> goal = points_[ball_.support[0]] * x[0];
    for (int k = 1; k < ball_.support_size; ++k) goal = goal + points_[ball_.support[k]] * x[k];
    const Vec<S, D> walk = goal - ball_.center;
    const Vec<S, D>& on_boundary = points_[ball_.support[0]];
    const S squared_radius = squared_distance(on_boundary, ball_.center);
    S fraction(1);
    int stop = -1;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      const S approach = dot<S, D>(points_[i] - on_boundary, walk);  // negative: the boundary moves over this point
      if (!(approach < S(0)) || in_support(i)) continue;
      const S hit = max_of(S((squared_distance(points_[i], ball_.center) - squared_radius) / (S(2) * approach)), S(0));
      if (hit < fraction) fraction = hit, stop = i;
    }
    if (stop < 0 || ball_.support_size == D + 1) {
      ball_.center = goal;
      return true;
    }
    ball_.center = ball_.center + walk * fraction;
    ball_.support[ball_.support_size++] = stop;
    return ball_.support_size == D + 1;  // its hull is the whole space
  }

  std::span<const Vec<S, D>> points_;
  SmallestBall<S, D> ball_;
};

// points is not empty. In double the result always encloses all points up to the rounding of one squared distance; it is
// smallest up to rounding if converged.
template <class S, int D>
SmallestBall<S, D> smallest_ball(std::span<const Vec<S, D>> points) {
  return SmallestBallWalk<S, D>(points).run();
}

template <class S, int D>
Ball<S, D> as_ball(const SmallestBall<S, D>& smallest) {
  return {smallest.center, root(smallest.squared_radius)};
}

}  // namespace refitlab
