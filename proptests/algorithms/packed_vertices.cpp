// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/batch/packed_vertices.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/posed_model.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_packed_vertices {
namespace {

using namespace refitlab;

// Says whether two images are identical. A blend of quaternions that vanishes has no image, and then both must say so.
bool are_identical(const Point3& a, const Point3& b) {
  for (int i = 0; i < 3; ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i]) && !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

// Says whether every group and the whole model, by every target, are as skin() makes them.
bool is_as_skin(const PackedVertices& packed, const SkinnedMesh& model, const JointSets& sets,
                const SkinningPalette<double>& palette, Skinning skinning) {
  const auto expected = skin(model, sets, palette, skinning);
  const Point3 untouched(7, 7, 7);
  for (const Target target : available_targets()) {
    std::vector<Point3> all(expected.size(), untouched);
    packed.skin_all(palette, skinning, all, target);
    std::set<int> grouped;
    SkinnedVertices skinned;
    for (int g = 0; g < packed.group_count(); ++g) {
      packed.skin_group(g, palette, skinning, skinned, target);
      const auto vertices = packed.vertices(g);
      for (std::size_t place = 0; place < vertices.size(); ++place) {
        if (!are_identical(skinned[static_cast<int>(place)], expected[vertices[place]])) return false;
        grouped.insert(vertices[place]);
      }
    }
    for (std::size_t v = 0; v < all.size(); ++v)
      if (!are_identical(all[v], grouped.count(static_cast<int>(v)) ? expected[v] : untouched)) return false;
  }
  return true;
}

}  // namespace

PROPTEST(packed_vertices) {
  t.holds("by every target, groups of vertices are skinned bit by bit as skin() does",
          {.number_type = "double pack", .cases = 1000, .degenerate_at_least = 0.05}, [] {
            const auto posed = *gen::posed_model();
            const JointSets sets(posed.mesh);
            const int vertex_count = static_cast<int>(posed.mesh.vertices.size());
            std::vector<std::vector<int>> groups(*rc::gen::inRange(1, 4));
            for (int v = 0; v < vertex_count; ++v)
              for (auto& group : groups)
                if (*rc::gen::inRange(0, 2)) group.push_back(v);
            RC_CLASSIFY(std::any_of(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }), "degenerate");
            const PackedVertices packed(posed.mesh, sets, groups);
            RC_ASSERT(packed.group_count() == static_cast<int>(groups.size()));
            for (int g = 0; g < packed.group_count(); ++g) {
              const auto vertices = packed.vertices(g);
              RC_ASSERT(std::set<int>(vertices.begin(), vertices.end()) == std::set<int>(groups[g].begin(), groups[g].end()));
            }
            const Skinning skinning = gen::drawn_skinning();
            const auto palette = make_skinning_palette(posed.mesh, sets, posed.pose, skinning);
            RC_ASSERT(is_as_skin(packed, posed.mesh, sets, palette, skinning));
          });
  t.holds(
      "also at the ends of what is accepted: up to 90 joints a joint-set, tiny and huge, quaternions off unit length",
      {.number_type = "double pack", .cases = 200}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const gen::WideModel wide = gen::wide_model(random);
        const JointSets sets(wide.mesh);
        const PackedVertices packed(wide.mesh, sets);
        for (const Skinning skinning : gen::all_skinnings)
          RC_ASSERT(is_as_skin(packed, wide.mesh, sets, make_skinning_palette(wide.mesh, sets, wide.pose, skinning), skinning));
      });
  t.example("the built-in man and creature are, as a whole, in mid-clip", {.number_type = "double pack"}, [] {
    long checked = 0;
    for (const Model& model : {make_man(), make_creature()}) {
      const JointSets sets(model);
      const PackedVertices packed(model, sets);
      for (const Skinning skinning : gen::all_skinnings) {
        const auto& clip = model.clips[0];
        const auto palette = make_skinning_palette(model, sets, clip.sample(0.4 * clip.duration), skinning);
        if (!is_as_skin(packed, model, sets, palette, skinning)) return Checked(false, checked, model.name);
        checked += static_cast<long>(model.vertices.size());
      }
    }
    return Checked(true, checked, std::to_string(available_targets().size()) + " targets");
  });
}

}  // namespace proptests::suite_packed_vertices
