// SPDX-License-Identifier: MIT
// GrowingSupport is the support of a ball that grows. It has at most D + 1 affinely independent points of R^D, and the ball's
// center as their convex combination. Points enter and leave at the cost of a few products [the dual active set method of
// Goldfarb and Idnani 1983, for the smallest ball's quadratic program].
//
// A support point's gradient is that of its affine coordinate: coordinate k of x in the support's hull is
// coefficient_k + (gradient_k, x - center). Gradients add up to 0. They change by a multiple of one vector when a point enters or
// leaves, so no system is ever solved.
#pragma once

#include <array>
#include <limits>

#include "algorithms/runtime/balls/quad.hpp"

namespace refitlab {

template <class S, int D>
class GrowingSupport {
 public:
  int size() const { return size_; }
  int index(int k) const { return index_[k]; }
  S coefficient(int k) const { return coefficient_[k]; }
  const Quad<S>& position(int k) const { return position_[k]; }
  const Quad<S>& gradient(int k) const { return gradient_[k]; }

  bool contains(int index) const {
    bool found = false;
    for (int k = 0; k < size_; ++k) found |= index_[k] == index;
    return found;
  }

  Quad<S> center() const {
    Quad<S> sum = position_[0] * coefficient_[0];
    for (int k = 1; k < size_; ++k) sum = sum + position_[k] * coefficient_[k];
    return sum;
  }

  void start(int index, const Quad<S>& position) {
    size_ = 1;
    set(0, index, position, Quad<S>{}, S(1));
  }

  // Starts with two different points. The center is at the share of the way from a to b.
  void start(int index_a, const Quad<S>& a, int index_b, const Quad<S>& b, S share) {
    const Quad<S> edge = b - a, gradient = edge * (S(1) / squared_norm(edge));
    size_ = 2;
    set(0, index_a, a, gradient * S(-1), S(1) - share);
    set(1, index_b, b, gradient, share);
  }

  // Makes the smallest ball of the support and of a point outside, which becomes support. excess is the point's squared distance
  // from the center less the support's (or its power, if the squared distances are raised by a weight each). A point that is
  // nearer to the support's hull than noise counts as in it. Returns false if rounding leaves no support.
  bool enter(int index, const Quad<S>& point, const Quad<S>& center, S excess, S squared_noise) {
    // The center moves along the point's component that is normal to the hull, away from the support by as much as the
    // coordinate of the point grows, until the point is as near as the support is.
    const Quad<S> offset = point - center;
    Quad<S> normal = point;
    for (int k = 0; k < size_; ++k) {
      share_[k] = coefficient_[k] + dot(gradient_[k], offset);
      normal = normal - position_[k] * share_[k];
    }
    S squared_length = squared_norm(normal), entered(0), step;
    if (size_ == D + 1 || squared_length <= squared_noise) {
      normal = Quad<S>{}, squared_length = S(0);
      step = std::numeric_limits<S>::infinity();
    } else {
      step = excess / (S(2) * squared_length);
    }
    // If a coefficient reaches 0 before that, its point leaves.
    for (int left; (left = first_to_leave(step)) >= 0;) {
      if (size_ == 1) return false;
      entered += step;
      excess -= S(2) * step * squared_length;
      const S share = share_[left];
      const Quad<S> gradient = move_and_drop(left, step);
      normal = normal + gradient * (share / squared_norm(gradient));
      squared_length = squared_norm(normal);
      step = excess / (S(2) * squared_length);
    }
    if (!(step < std::numeric_limits<S>::infinity())) return false;
    const Quad<S> gradient = normal * (S(1) / squared_length);
    for (int k = 0; k < size_; ++k) {
      coefficient_[k] -= step * share_[k];
      gradient_[k] = gradient_[k] - gradient * share_[k];
    }
    set(size_++, index, point, gradient, entered + step);
    return true;
  }

  // Moves the center by the vector times the step within the hull, but if a coefficient would become negative, only until its
  // point leaves. Returns the step made.
  S move(const Quad<S>& vector, S step) {
    for (int k = 0; k < size_; ++k) share_[k] = -dot(gradient_[k], vector);
    if (const int left = first_to_leave(step); left >= 0) {
      move_and_drop(left, step);
    } else {
      for (int k = 0; k < size_; ++k) coefficient_[k] -= step * share_[k];
    }
    return step;
  }

 private:
  void set(int k, int index, const Quad<S>& position, const Quad<S>& gradient, S coefficient) {
    index_[k] = index, position_[k] = position, gradient_[k] = gradient, coefficient_[k] = coefficient;
  }

  // Returns the position of the first point whose coefficient, which falls by share for each unit of the step, reaches 0 before
  // the step ends. The step is then shortened to there. Returns -1 if there is none.
  int first_to_leave(S& step) const {
    bool any = false;
    for (int k = 0; k < size_; ++k) any |= coefficient_[k] < step * share_[k];
    if (!any) return -1;
    int first = -1;
    for (int k = 0; k < size_; ++k)
      if (share_[k] > S(0) && coefficient_[k] < step * share_[k]) step = coefficient_[k] / share_[k], first = k;
    return first;
  }

  // Lowers all coefficients by step times share. The coefficient of the point that leaves becomes 0. Returns its gradient.
  Quad<S> move_and_drop(int left, S step) {
    const Quad<S> gradient = gradient_[left];
    const S share = share_[left], scale = S(1) / squared_norm(gradient);
    for (int k = 0; k < size_; ++k) coefficient_[k] = max_of(S(0), S(coefficient_[k] - step * share_[k]));
    --size_;
    set(left, index_[size_], position_[size_], gradient_[size_], coefficient_[size_]);
    share_[left] = share_[size_];
    for (int k = 0; k < size_; ++k) {
      const S common = dot(gradient_[k], gradient) * scale;
      gradient_[k] = gradient_[k] - gradient * common;
      share_[k] -= share * common;
    }
    return gradient;
  }

  int size_ = 0;
  std::array<int, D + 1> index_;
  std::array<Quad<S>, D + 1> position_, gradient_;
  std::array<S, D + 1> coefficient_;
  std::array<S, D + 1> share_;  // what the step under way takes from each coefficient
};

}  // namespace refitlab
