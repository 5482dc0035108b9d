// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything and hashes the cells of a uniform grid that the boxes of the first body's triangles meet [Teschner et al.
// 2003]. The second body's triangles are compared with those in their own cells. As in the source, a cell is as wide as the edges
// of the mesh are long on average, and the hash is made with three large primes.
#include <cmath>

#include "algorithms/runtime/balls/box.hpp"
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

double mean_edge(const SkinnedMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) sum += norm<double, 3>(mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]);
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

class SpatialHash : public SkinningDetector {
 public:
  explicit SpatialHash(const Character& character)
      : SkinningDetector(character, Placing::all),
        edge_(std::max(mean_edge(character.mesh), 1e-9)),
        last_asked_(character.mesh.triangles.size()) {
    std::size_t size = 1;
    while (size < 2 * character.mesh.triangles.size()) size *= 2;
    heads_.resize(size);
  }

  void refit() override {
    std::fill(heads_.begin(), heads_.end(), -1);
    entries_.clear();
    boxes_.clear();
    for (int t = 0; t < count(); ++t) {
      boxes_.push_back(box(0, t));
      for_each_cell(boxes_.back(), [&](std::size_t cell) {
        entries_.push_back({t, heads_[cell]});
        heads_[cell] = static_cast<int>(entries_.size()) - 1;
        return true;
      });
    }
    counts_.nodes_refitted += static_cast<long>(entries_.size());
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    std::fill(last_asked_.begin(), last_asked_.end(), -1);
    for (int t = 0; t < count() && !candidates_.is_done(); ++t) {
      const Box<double> own = box(1, t);
      for_each_cell(own, [&](std::size_t cell) {
        for (int e = heads_[cell]; e >= 0; e = entries_[e].next) {
          const int other = entries_[e].triangle;
          if (last_asked_[other] == t) continue;  // they share several cells
          last_asked_[other] = t;
          ++counts_.volume_tests;
          if (!are_apart(boxes_[other], own)) candidates_.add(other, t);
        }
        return !candidates_.is_done();
      });
    }
    return candidates_.found();
  }

 private:
  struct Entry {
    int triangle, next;  // next: -1 at the end of a cell's list
  };

  int count() const { return static_cast<int>(model().triangles.size()); }
  Box<double> box(int side, int triangle) const {
    Box<double> out = Box<double>::empty();
    for (const int v : model().triangles[triangle]) out.merge(placed(side)[v]);
    return out;
  }
  std::int64_t cell_of(double x) const { return static_cast<std::int64_t>(std::floor(x / edge_)); }
  // Calls visit for each cell that a box meets, until it says false.
  template <class Visit>
  void for_each_cell(const Box<double>& box, const Visit& visit) const {
    std::int64_t low[3], high[3];
    for (int i = 0; i < 3; ++i) low[i] = cell_of(box.low[i]), high[i] = cell_of(box.high[i]);
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto hash = static_cast<std::uint64_t>(x) * 73856093u ^ static_cast<std::uint64_t>(y) * 19349663u ^
                            static_cast<std::uint64_t>(z) * 83492791u;
          if (!visit(hash & (heads_.size() - 1))) return;
        }
  }

  const double edge_;
  std::vector<int> heads_;  // by cell: of its entries
  std::vector<Entry> entries_;
  std::vector<Box<double>> boxes_;  // of the first body's triangles
  std::vector<int> last_asked_;     // by triangle of the first body: the second one's triangle that it was last compared with
};

}  // namespace

std::unique_ptr<Detector> make_spatial_hash(const Character& character) { return std::make_unique<SpatialHash>(character); }

}  // namespace refitlab
