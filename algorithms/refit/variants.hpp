// The refit variants by name: one interface, each node by itself in any order, no vertex touched.
#pragma once

#include <string>
#include <vector>

#include "algorithms/tree/refit_node.hpp"
#include "algorithms/skinning/skinning_pose.hpp"

namespace refitlab {

// The ball of one node in the posture of node.pose. Thread-safe.
using Refit = Ball3<double> (*)(const RefitNode<double>& node);

// How finely a variant wants each node described: which pieces its RefitNode has.
enum class Pieces {
  node,        // the node's ball and weight boxes, as in the paper (SphereTree::refit_node)
  joint_sets,  // a ball and a weight hull for each joint-set (PieceTable)
  mixed,       // the same, or the vertices one by one where that is about as cheap: few vertices, many control points
  clusters     // up to 512 pieces a node
};
inline constexpr int piece_kinds = 4;
inline constexpr int most_clusters = 512;

struct RefitVariant {
  std::string name;         // as in result files: snake_case, fixed
  std::string description;  // one line for tables and reports
  Skinning skinning;        // whose vertices it bounds
  bool sound;               // proved to enclose; the printed algorithm is not
  Pieces pieces;
  // If the variant is sound, certified: encloses the node's vertices, whether skinned exactly from the pose's numbers or by
  // skin(), with the slack for all rounding in the radius (rounding.hpp).
  Refit refit;
  // The same without that slack: what it costs and how much it adds is measured against this.
  Refit refit_as_computed;
};

const std::vector<RefitVariant>& refit_variants();

// The one to take unless there is a reason for another: no dearer than Algorithm 1 (most nodes hold so few vertices that
// skinning these costs less than bounding them, and their ball is known from those that touched it in the reference
// posture), on the experiments' characters within a tenth of the smallest ball on average, and exact at the leaves.
const RefitVariant& default_variant(Skinning skinning);

// Throws std::invalid_argument that lists the names there are.
const RefitVariant& refit_variant(const std::string& name);

}  // namespace refitlab
