// Skins everything, refits axis-aligned boxes bottom-up, eight triangles a leaf: what one would write by hand today. A
// node has the boxes of up to eight children in SIMD lanes, in float; the children of the lowest nodes are triangles.
#include <algorithm>
#include <array>
#include <cstring>
#include <experimental/simd>
#include <limits>

#include "algorithms/runtime/packs/four.hpp"
#include "experiments/rivals/float_boxes.hpp"
#include "experiments/rivals/median_split.hpp"
#include "experiments/rivals/rivals.hpp"
#include "experiments/rivals/skinning_detector.hpp"

namespace refitlab {
namespace {

namespace stdx = std::experimental;

constexpr int width = 8;
using Lanes = stdx::fixed_size_simd<float, width>;
using LaneMask = stdx::fixed_size_simd_mask<float, width>;

// Of each box, whose corners were moved in float, in units of the coordinates' size: three products and sums.
constexpr float rounding_slack = 0x1p-20f;

struct Box : FloatBox {
  void join(const Box& b) {
    low = low.min(b.low);
    high = high.max(b.high);
  }
};

constexpr float infinity = std::numeric_limits<float>::infinity();
const Box no_box{{Eigen::Array4f::Constant(infinity), Eigen::Array4f::Constant(-infinity)}};

// The first three columns of four rows.
void transpose(const Eigen::Array4f& a, const Eigen::Array4f& b, const Eigen::Array4f& c, const Eigen::Array4f& d,
               float* x, float* y, float* z) {
  Four rows[4];
  const Eigen::Array4f* const from[] = {&a, &b, &c, &d};
  for (int i = 0; i < 4; ++i) std::memcpy(&rows[i], from[i]->data(), sizeof(Four));
  refitlab::transpose(rows);
  float* const to[] = {x, y, z};
  for (int i = 0; i < 3; ++i) std::memcpy(to[i], &rows[i], sizeof(Four));
}

struct LaneBoxes {
  alignas(32) float low[3][width], high[3][width];

  void set(const std::array<Box, width>& b) {
    for (int i = 0; i < width; i += 4) {
      transpose(b[i].low, b[i + 1].low, b[i + 2].low, b[i + 3].low, low[0] + i, low[1] + i, low[2] + i);
      transpose(b[i].high, b[i + 1].high, b[i + 2].high, b[i + 3].high, high[0] + i, high[1] + i, high[2] + i);
    }
  }
  Box box(int lane) const {
    return {{{low[0][lane], low[1][lane], low[2][lane], 0}, {high[0][lane], high[1][lane], high[2][lane], 0}}};
  }
  LaneMask overlap(const Box& b) const {
    const auto load = [](const float* p) { return Lanes(p, stdx::vector_aligned); };
    return load(low[0]) <= b.high[0] && load(high[0]) >= b.low[0] && load(low[1]) <= b.high[1] &&
           load(high[1]) >= b.low[1] && load(low[2]) <= b.high[2] && load(high[2]) >= b.low[2];
  }
};

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
      : SkinningDetector(character, Placing::when_asked), shapes_(Builder(character.mesh).shapes) {
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
    const auto size = [](const Box& b) { return b.low.abs().head<3>().maxCoeff() + b.high.abs().head<3>().maxCoeff(); };
    slack_ = rounding_slack *
             (size(sides_[0].boxes[0]) + size(sides_[1].boxes[0]) + static_cast<float>(norm(to_first.translation)));
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
    std::vector<LaneBoxes> lanes;  // by node: its children's boxes
    std::vector<Box> boxes;        // by node: its own
  };

  void refit(Side& s) const {
    for (std::size_t n = shapes_.size(); n-- > 0;) {
      const Shape& shape = shapes_[n];
      std::array<Box, width> boxes;
      Box own = no_box;
      for (int i = 0; i < shape.count; ++i) {
        boxes[i] = shape.is_lowest ? Box{s.vertices.box(corners_[n * width + i])} : s.boxes[shape.child[i]];
        own.join(boxes[i]);
      }
      std::fill(boxes.begin() + shape.count, boxes.end(), no_box);
      s.lanes[n].set(boxes);
      s.boxes[n] = own;
    }
  }

  Box widened(const Box& b) const { return {{b.low - slack_, b.high + slack_}}; }

  void visit(int a, int b, Query query, std::vector<TrianglePair>& found) {
    const LaneMask near = sides_[1].lanes[b].overlap(widened(sides_[0].boxes[a]));
    counts_.volume_tests += width;
    for (int j = 0; j < shapes_[b].count; ++j) {
      if (!near[j]) continue;
      const LaneMask both = sides_[0].lanes[a].overlap(widened(sides_[1].lanes[b].box(j)));
      counts_.volume_tests += width;
      if (stdx::none_of(both)) continue;
      for (int i = 0; i < shapes_[a].count; ++i) {
        if (!both[i]) continue;
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

std::unique_ptr<Detector> make_skin_all_simd(const Character& character) {
  return std::make_unique<SkinAllSimd>(character);
}

}  // namespace refitlab
