// SPDX-License-Identifier: GPL-3.0-or-later
// This is CGAL's AABB_tree. It is built anew over the first body's triangles each frame, and asked with the box of each triangle
// of the second body. It has no query of tree against tree.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;

class CgalAabb : public SkinningDetector {
 public:
  explicit CgalAabb(const Character& character) : SkinningDetector(character, Placing::all) {}

  void refit() override {
    fill(0);
    fill(1);
    tree_.rebuild(triangles_[0].cbegin(), triangles_[0].cend());
    tree_.build();
    counts_.nodes_refitted += static_cast<long>(triangles_[0].size()) - 1;
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    Visit visit{*this, 0};
    const CGAL::Bbox_3 all = tree_.bbox();
    for (std::size_t i = 0; i < triangles_[1].size() && visit.go_further(); ++i) {
      const CGAL::Bbox_3 box = triangles_[1][i].bbox();
      visit.second = static_cast<int>(i);
      if (CGAL::do_overlap(all, box)) tree_.traversal(box, visit);
    }
    return candidates_.found();
  }

 private:
  struct Visit {
    CgalAabb& self;
    int second;
    bool go_further() const { return !self.candidates_.is_done(); }
    void intersection(const CGAL::Bbox_3& box, const Primitive& primitive) {
      if (!CGAL::do_overlap(box, primitive.id()->bbox())) return;
      self.candidates_.add(static_cast<int>(primitive.id() - self.triangles_[0].cbegin()), second);
    }
    template <class Node>
    bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const {
      ++self.counts_.volume_tests;
      return CGAL::do_overlap(box, node.bbox());
    }
  };

  void fill(int side) {
    triangles_[side].clear();
    for (const Triangle& t : model().triangles) {
      const auto point = [&](int v) { return Kernel::Point_3(placed(side)[v][0], placed(side)[v][1], placed(side)[v][2]); };
      triangles_[side].emplace_back(point(t[0]), point(t[1]), point(t[2]));
    }
  }

  Triangles triangles_[2];
  CGAL::AABB_tree<Traits> tree_;
};

}  // namespace

std::unique_ptr<Detector> make_cgal_aabb(const Character& character) { return std::make_unique<CgalAabb>(character); }

}  // namespace refitlab
