// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything, refits axis-aligned boxes bottom-up, eight triangles a leaf: what one would write by hand today. A
// node has the boxes of up to eight children in SIMD lanes, in float; the children of the lowest nodes are triangles.
#include <algorithm>
#include <array>
#include <bit>

#include "algorithms/runtime/collide/box_block.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/float_boxes.hpp"
#include "experiments/baselines/median_split.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

constexpr int width = 8;

// Of each box, whose corners were moved in float, in units of the coordinates' size: three products and sums.
constexpr float rounding_slack = 0x1p-20f;

using Boxes = std::array<RowBox<float>, width>;

// The first three columns of four rows, to the rows of a block.
void put_columns(const Row<float, 4>& a, const Row<float, 4>& b, const Row<float, 4>& c, const Row<float, 4>& d,
                 float (*to)[width], int first) {
  Row<float, 4> rows[4] = {a, b, c, d};
  transpose(rows);
  for (int i = 0; i < 3; ++i) write_row(rows[i], to[i] + first);
}
void put_boxes(const Boxes& b, BoxBlock<float>& block) {
  for (int i = 0; i < width; i += 4) {
    put_columns(b[i].low, b[i + 1].low, b[i + 2].low, b[i + 3].low, block.side, i);
    put_columns(b[i].high, b[i + 1].high, b[i + 2].high, b[i + 3].high, block.side + 3, i);
  }
}

// Nodes come before their children, and all of the lowest are equally deep: so two trees of one shape are descended in
// step.
struct Shape {
  bool is_lowest;
  int count;
  int child[width];  // nodes; of a lowest node, triangles
};

class Builder {
 public:
  explicit Builder(const SkinnedMesh& model) : split_(model) {
    std::size_t capacity = width;
    while (capacity < split_.triangles().size()) capacity *= width;
    build(split_.triangles(), capacity);
  }
  std::vector<Shape> shapes;

 private:
  int build(std::span<int> triangles, std::size_t capacity) {
    const int at = static_cast<int>(shapes.size());
    const std::size_t each = capacity / width, count = (triangles.size() + each - 1) / each;
    shapes.push_back({each == 1, static_cast<int>(count), {}});
    if (each == 1) {
      std::copy(triangles.begin(), triangles.end(), shapes[at].child);
      return at;
    }
    std::vector<std::span<int>> parts;
    split(triangles, count, parts);
    for (std::size_t i = 0; i < count; ++i) {
      const int child = build(parts[i], each);
      shapes[at].child[i] = child;
    }
    return at;
  }

  // Into so many parts, by halves along the longest extent of the centroids; but for one, parts are multiples of the
  // width.
  void split(std::span<int> triangles, std::size_t count, std::vector<std::span<int>>& parts) {
    if (count == 1) return parts.push_back(triangles);
    const std::size_t share = triangles.size() * (count / 2) / count, cut = (share + width - 1) / width * width;
    split_.split(triangles, cut);
    split(triangles.first(cut), count / 2, parts);
    split(triangles.subspan(cut), count - count / 2, parts);
  }

  MedianSplit split_;
};

// The boxes of both bodies are in the first one's model space.
class SkinAllSimd : public SkinningDetector {
 public:
  explicit SkinAllSimd(const Character& character)
      : SkinningDetector(character, Placing::when_asked),
        shapes_(Builder(character.mesh).shapes) {
    for (Side& s : sides_) {
      s.lanes.resize(shapes_.size());
      s.boxes.resize(shapes_.size());
    }
    renumber();
  }

  void refit() override {
    const RigidTransform<double> to_first = this->to_first();
    sides_[0].vertices.set(skinned(0), order_, {});
    sides_[1].vertices.set(skinned(1), order_, to_first);
    for (Side& s : sides_) refit(s);
    const auto most = [](const Row<float, 4>& p) { return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}); };
    const auto size = [&](const RowBox<float>& b) { return most(b.low) + most(b.high); };
    slack_ =
        rounding_slack * (size(sides_[0].boxes[0]) + size(sides_[1].boxes[0]) + static_cast<float>(norm(to_first.translation)));
    counts_.nodes_refitted += 2 * static_cast<long>(shapes_.size());
  }

  std::vector<TrianglePair> query(Query query) override {
    std::vector<TrianglePair> found;
    pending_.assign(1, {0, 0});
    while (!pending_.empty() && !(query == Query::yes_no && !found.empty())) {
      const auto [a, b] = pending_.back();
      pending_.pop_back();
      visit(a, b, query, found);
    }
    return found;
  }

 private:
  struct Side {
    FloatVertices vertices;
    std::vector<BoxBlock<float>> lanes;  // by node: its children's boxes
    std::vector<RowBox<float>> boxes;    // by node: its own
  };

  void refit(Side& s) const {
    for (std::size_t n = shapes_.size(); n-- > 0;) {
      const Shape& shape = shapes_[n];
      Boxes boxes;
      RowBox<float> own = RowBox<float>::empty();
      for (int i = 0; i < shape.count; ++i) {
        boxes[i] = shape.is_lowest ? s.vertices.box(corners_[n * width + i]) : s.boxes[shape.child[i]];
        own.merge(boxes[i]);
      }
      std::fill(boxes.begin() + shape.count, boxes.end(), RowBox<float>::empty());
      put_boxes(boxes, s.lanes[n]);
      s.boxes[n] = own;
    }
  }

  // A byte for each child whose box, grown by the slack, meets the other.
  std::uint64_t meeting_grown(const BoxBlock<float>& children, Box<float> box) const {
    box.grow(slack_);
    return meeting(children, box);
  }

  void visit(int a, int b, Query query, std::vector<TrianglePair>& found) {
    counts_.volume_tests += width;
    for (std::uint64_t near = meeting_grown(sides_[1].lanes[b], box_of<float>(sides_[0].boxes[a])); near; near &= near - 1) {
      const int j = std::countr_zero(near) / 8;
      counts_.volume_tests += width;
      for (std::uint64_t both = meeting_grown(sides_[0].lanes[a], sides_[1].lanes[b].get(j)); both; both &= both - 1) {
        const int i = std::countr_zero(both) / 8;
        const int p = shapes_[a].child[i], q = shapes_[b].child[j];
        if (!shapes_[a].is_lowest) {
          pending_.emplace_back(p, q);
        } else if (touch(p, q)) {
          found.push_back({p, q});
          if (query == Query::yes_no) return;
        }
      }
    }
  }

  // Numbers the vertices as the lowest nodes' triangles come to them, which lie side by side then.
  void renumber() {
    std::vector<int> number(model().vertices.size(), -1);
    corners_.resize(shapes_.size() * width);
    for (std::size_t n = shapes_.size(); n-- > 0;)
      for (int i = 0; shapes_[n].is_lowest && i < shapes_[n].count; ++i)
        for (int k = 0; k < 3; ++k) {
          const int v = model().triangles[shapes_[n].child[i]][k];
          if (number[v] < 0) {
            number[v] = static_cast<int>(order_.size());
            order_.push_back(v);
          }
          corners_[n * width + i][k] = number[v];
        }
  }

  const std::vector<Shape> shapes_;
  std::vector<int> order_;         // the vertices as they are numbered here
  std::vector<Triangle> corners_;  // of the lowest nodes' triangles, by node and lane, so numbered
  Side sides_[2];
  float slack_ = 0;
  std::vector<std::pair<int, int>> pending_;
};

}  // namespace

std::unique_ptr<Detector> make_skin_all_simd(const Character& character) { return std::make_unique<SkinAllSimd>(character); }

}  // namespace refitlab
