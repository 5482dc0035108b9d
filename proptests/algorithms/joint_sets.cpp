// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/mesh/joint_sets.hpp"

#include <set>

#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_joint_sets {

using namespace refitlab;

PROPTEST(joint_sets) {
  t.holds("each vertex has the joint-set of its influences and their weights, and no two joint-sets are equal",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            const JointSets sets(model);
            std::set<std::vector<int>> expected;
            for (std::size_t v = 0; v < model.vertices.size(); ++v) {
              const int set = sets.of_vertex(static_cast<int>(v));
              RC_ASSERT(set >= 0 && set < sets.count());
              std::vector<int> joints;
              std::vector<double> weights;
              for (const auto& i : model.influences[v]) joints.push_back(i.joint), weights.push_back(i.weight);
              expected.insert(joints);
              const auto own = sets.joints(set);
              const auto own_weights = sets.weights(static_cast<int>(v));
              RC_ASSERT(std::vector<int>(own.begin(), own.end()) == joints);
              RC_ASSERT(std::vector<double>(own_weights.begin(), own_weights.end()) == weights);
            }
            RC_ASSERT(static_cast<std::size_t>(sets.count()) == expected.size());
            std::set<std::vector<int>> listed;
            for (int s = 0; s < sets.count(); ++s) listed.emplace(sets.joints(s).begin(), sets.joints(s).end());
            RC_ASSERT(listed == expected);
          });
}

}  // namespace proptests::suite_joint_sets
