// SPDX-License-Identifier: GPL-3.0-or-later
// The baselines' trees are built by median splits of a model's triangles.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

class MedianSplit {
 public:
  explicit MedianSplit(const SkinnedMesh& model) : order_(model.triangles.size()) {
    for (const Triangle& t : model.triangles)
      centroids_.push_back((model.vertices[t[0]] + model.vertices[t[1]] + model.vertices[t[2]]) / 3);
    std::iota(order_.begin(), order_.end(), 0);
  }

  // Returns all triangles. Splits sort them.
  std::span<int> triangles() { return order_; }

  // Moves so many triangles to the front. They have the least centroids along the longest extent of all, in the reference pose.
  // triangles is a part of triangles(), not empty.
  void split(std::span<int> triangles, std::size_t count) {
    Point3 low = centroids_[triangles[0]], high = low;
    for (const int t : triangles) low = low.cwiseMin(centroids_[t]), high = high.cwiseMax(centroids_[t]);
    int axis;
    (high - low).maxCoeff(&axis);
    std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(count), triangles.end(),
                     [&](int a, int b) { return centroids_[a][axis] < centroids_[b][axis]; });
  }

 private:
  std::vector<Point3> centroids_;
  std::vector<int> order_;
};

}  // namespace refitlab
