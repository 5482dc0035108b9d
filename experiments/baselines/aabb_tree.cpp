// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything and refits a tree of axis-aligned boxes bottom-up [van den Bergen 1997]. The tree is binary, with one triangle
// in each leaf.
#include <algorithm>
#include <numeric>
#include <span>

#include "algorithms/runtime/balls/box.hpp"
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

// Nodes are in depth-first order. A node's left child comes next, and its right child is where `right` says.
struct Node {
  int right;     // 0 at a leaf
  int triangle;  // of a leaf
};

// Builds the tree by median splits of the triangles.
class Builder {
 public:
  explicit Builder(const SkinnedMesh& model) : order_(model.triangles.size()) {
    for (const Triangle& t : model.triangles)
      centroids_.push_back((model.vertices[t[0]] + model.vertices[t[1]] + model.vertices[t[2]]) / 3);
    std::iota(order_.begin(), order_.end(), 0);
    build(order_);
  }
  std::vector<Node> nodes;

 private:
  void build(std::span<int> triangles) {
    const std::size_t at = nodes.size(), half = triangles.size() / 2;
    nodes.push_back({0, triangles[0]});
    if (triangles.size() == 1) return;
    split(triangles, half);
    build(triangles.first(half));
    nodes[at].right = static_cast<int>(nodes.size());
    build(triangles.subspan(half));
  }

  // Moves so many triangles to the front. They have the least centroids along the longest extent of all, in the reference pose.
  void split(std::span<int> triangles, std::size_t count) {
    Point3 low = centroids_[triangles[0]], high = low;
    for (const int t : triangles) low = low.cwiseMin(centroids_[t]), high = high.cwiseMax(centroids_[t]);
    int axis;
    (high - low).maxCoeff(&axis);
    std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(count), triangles.end(),
                     [&](int a, int b) { return centroids_[a][axis] < centroids_[b][axis]; });
  }

  std::vector<Point3> centroids_;
  std::vector<int> order_;
};

// The boxes of both bodies are in the first one's model space.
class AabbTree : public SkinningDetector {
 public:
  explicit AabbTree(const Character& character)
      : SkinningDetector(character, Placing::when_asked),
        nodes_(Builder(character.mesh).nodes) {
    for (auto& boxes : boxes_) boxes.resize(nodes_.size());
  }

  void refit() override {
    refit(0, skinned(0));
    const RigidTransform<double> to_first = this->to_first();
    const auto rows = rotation_rows(to_first.rotation);
    moved_.resize(skinned(1).size());
    for (std::size_t v = 0; v < moved_.size(); ++v) {
      const Point3& p = skinned(1)[v];
      moved_[v] = Point3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + to_first.translation;
    }
    refit(1, moved_);
    const auto size = [&](int side) {
      return boxes_[side][0].low.norm() + boxes_[side][0].high.norm() + placement(side).translation.norm();
    };
    slack_ = double_rounding_slack * (size(0) + size(1));
    counts_.nodes_refitted += 2 * static_cast<long>(nodes_.size());
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    pending_.assign(1, {0, 0});
    while (!pending_.empty() && !candidates_.is_done()) {
      const auto [a, b] = pending_.back();
      pending_.pop_back();
      ++counts_.volume_tests;
      const Box<double>&p = boxes_[0][a], &q = boxes_[1][b];
      Box<double> grown = p;
      grown.grow(slack_);
      if (are_apart(grown, q)) continue;
      const Node &m = nodes_[a], &n = nodes_[b];
      if (m.right == 0 && n.right == 0) {
        candidates_.add(m.triangle, n.triangle);
      } else if (n.right == 0 || (m.right != 0 && p.extent() >= q.extent())) {
        pending_.emplace_back(a + 1, b);
        pending_.emplace_back(m.right, b);
      } else {
        pending_.emplace_back(a, b + 1);
        pending_.emplace_back(a, n.right);
      }
    }
    return candidates_.found();
  }

 private:
  void refit(int side, const std::vector<Point3>& vertices) {
    auto& boxes = boxes_[side];
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      if (nodes_[n].right != 0) {
        const Box<double>&a = boxes[n + 1], &b = boxes[nodes_[n].right];
        boxes[n] = {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
        continue;
      }
      const Triangle& t = model().triangles[nodes_[n].triangle];
      const Point3 &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
      boxes[n] = {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    }
  }

  const std::vector<Node> nodes_;
  std::vector<Box<double>> boxes_[2];
  std::vector<Point3> moved_;  // the second body's vertices
  double slack_ = 0;
  std::vector<std::pair<int, int>> pending_;
};

}  // namespace

std::unique_ptr<Detector> make_aabb_tree(const Character& character) { return std::make_unique<AabbTree>(character); }

}  // namespace refitlab
