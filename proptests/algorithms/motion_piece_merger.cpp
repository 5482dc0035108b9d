// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/motion_piece_merger.hpp"

#include <algorithm>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/collide/motion_bound_packs.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/motion_pieces.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_motion_piece_merger {
namespace {

using namespace refitlab;
using Lists = std::vector<std::vector<int>>;

bool has_joints_of(const Character& c, const MotionPiece& piece, int vertex) {
  const auto many = c.sets.joints(piece.joint_set), few = c.sets.joints(c.sets.of_vertex(vertex));
  return std::includes(many.begin(), many.end(), few.begin(), few.end());
}

// Says whether the piece's weights are those of some vertices, of which this is one.
bool are_weights_known(const Character& c, const MotionPiece& piece, int vertex) {
  const auto joints = c.sets.joints(piece.joint_set), own = c.sets.joints(c.sets.of_vertex(vertex));
  const auto weights = c.sets.weights(vertex);
  bool ok = piece.weights.least.size() == joints.size();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto at = std::find(own.begin(), own.end(), joints[k]);
    ok = ok && piece.weights.least[k] <= (at == own.end() ? 0 : weights[static_cast<std::size_t>(at - own.begin())]);
  }
  double products = 0, squares = 0;
  for (std::size_t k = 0; k < own.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) products += weights[k] * weights[l], squares += sq(weights[k] * weights[l]);
  return ok && products <= piece.weights.products * (1 + 1e-15) && squares <= piece.weights.squared_products * (1 + 1e-15);
}

// Says whether a piece bounds the vertex as one of those that it was made of.
bool bounds(const Character& c, const MotionPiece& piece, int vertex) {
  const Point3& v = c.mesh.vertices[vertex];
  const Point3 prior = center_prior(c.mesh, c.sets.joints(c.sets.of_vertex(vertex)), Skinning::spherical);
  return has_joints_of(c, piece, vertex) && oracle::holds(piece.box, v) &&
         (v - piece.reference.center).norm() <= piece.reference.radius &&
         (piece.reference.center - prior).norm() <= piece.to_prior && are_weights_known(c, piece, vertex);
}

// Returns the extents of each target's box, summed up over the compared poses. It is empty if some are not known.
std::vector<double> extents(const Character& c, std::span<const MotionPiece> pieces, std::size_t targets) {
  const auto packs = make_motion_bound_packs(c, pieces);
  MotionBound bound(c.mesh, c.sets, Skinning::spherical);
  std::vector<FlippedBox> boxes(targets);
  std::vector<double> out(targets);
  for (const Pose& pose : compared_poses(c.mesh)) {
    if (packs.empty() || !bound.place_checked(pose, {}) || !bound.boxes(packs, pose, boxes)) return {};
    for (std::size_t i = 0; i < targets; ++i) out[i] += boxes[i].box().extent();
  }
  return out;
}

void merged_pieces_bound_all(Suite& t) {
  t.holds("each vertex is in a piece of its list whose joint-set has all of its joints, and bounds grow by no more than is said",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3, .tags_at_least = {{"merged", 0.2}}}, [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = *rc::gen::element(1, 10)});
            const Lists lists = oracle::vertices_of_nodes(c);
            const auto merged = MotionPieceMerger(c).pieces(lists), single = oracle::motion_pieces(c, lists);
            RC_TAG(merged.size() < single.size() ? "merged" : "not merged");
            RC_ASSERT(merged.size() <= single.size());
            for (std::size_t list = 0; list < lists.size(); ++list)
              for (const int v : lists[list])
                RC_ASSERT(std::any_of(merged.begin(), merged.end(), [&](const MotionPiece& p) {
                  return p.target == static_cast<int>(list) && bounds(c, p, v);
                }));
            const auto before = extents(c, single, lists.size()), after = extents(c, merged, lists.size());
            RC_ASSERT(before.size() == after.size());
            for (std::size_t i = 0; i < before.size(); ++i)
              RC_ASSERT(after[i] <= before[i] * (1 + MotionPieceMerger::most_growth) * (1 + 1e-6));
          });
}

void what_is_merged(Suite& t) {
  t.example("of a man's wide nodes, a fifth of the packs or more are spared", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    std::size_t single = 0, packs = 0;
    for (const WideNode& wide_node : tree.wide_nodes()) {
      single += (wide_node.simplex_pieces.size() + motion_bound_lanes - 1) / motion_bound_lanes;
      packs += wide_node.motion_bounds.size();
    }
    return Checked(packs > 0 && 5 * packs <= 4 * single, static_cast<long>(tree.wide_nodes().size()),
                   std::to_string(packs) + " packs, of single joint-sets " + std::to_string(single));
  });
  t.example("where a piece has too many joints, those of all lists are of one joint-set each, and have no packs", {}, [] {
    SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 5, 12, 1});
    mesh.influences[0] = {{0, 0.5}};
    for (int j = 1; j < 9; ++j) mesh.influences[0].push_back({j, 1.0 / 16});
    const auto c = bake(mesh);
    const Lists lists{oracle::vertices_of_nodes(c)[0]};
    const auto merged = MotionPieceMerger(c).pieces(lists);
    return merged.size() == oracle::motion_pieces(c, lists).size() && make_motion_bound_packs(c, merged).empty();
  });
  t.example("compared poses turn joints about their own origins, neighbours by other rotations", {}, [] {
    const SkinnedMesh man = make_man();
    const auto poses = compared_poses(man);
    bool ok = !poses.empty();
    for (const Pose& pose : poses) {
      ok = ok && pose.size() == man.joints.size();
      for (std::size_t j = 0; j < pose.size(); ++j) {
        ok = ok && (apply(pose[j], man.joints[j].origin) - man.joints[j].origin).norm() < 1e-12;
        ok = ok && std::abs(pose[j].rotation.norm() - 1) < 1e-12;
        if (j > 0) ok = ok && std::abs(dot(pose[j].rotation, pose[j - 1].rotation)) < 0.995;
      }
    }
    return Checked(ok, static_cast<long>(poses.size()));
  });
}

}  // namespace

PROPTEST(motion_piece_merger) {
  merged_pieces_bound_all(t);
  what_is_merged(t);
}

}  // namespace proptests::suite_motion_piece_merger
