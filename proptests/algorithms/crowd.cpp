#include "algorithms/collide/crowd.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>

#include "proptests/gen/random_posture.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using oracle::sorted;

}  // namespace

PROPTEST(crowd) {
  t.holds("the contacts of a crowd are those of its pairs, one after the other, on one thread and on two",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Character c(gen::make_mesh(plan));
            const ClusterTree tree(c, {.most_triangles = 10, .most_children = 9});
            std::mt19937 random(plan.seed);
            std::uniform_real_distribution<double> place(-6, 6);
            // Dual quaternions far apart have no bound at all: such a body is compared with all others.
            const Skinning skinning = *rc::gen::element(Skinning::spherical, Skinning::dual_quaternion);
            const double spread = *rc::gen::element(0.5, 3.0);
            const int count = *rc::gen::inRange(0, 12);
            std::vector<std::unique_ptr<ClusterBody>> owned;
            std::vector<ClusterBody*> bodies;
            for (int i = 0; i < count; ++i) {
              owned.push_back(std::make_unique<ClusterBody>(tree, skinning));
              owned.back()->begin(gen::random_posture(c.model, random, spread),
                                  {gen::random_rotation(random, 1), {place(random), place(random), 0}});
              bodies.push_back(owned.back().get());
            }
            std::vector<Contact> expected;
            for (int i = 0; i < count; ++i)
              for (int k = i + 1; k < count; ++k) {
                QueryCounts counts;
                if (auto pairs = collide(*bodies[i], *bodies[k], Query::full, counts); !pairs.empty())
                  expected.push_back({i, k, sorted(pairs)});
              }
            RC_TAG(expected.empty() ? "apart" : "in contact");
            for (int threads = 1; threads <= (has_threads() ? 2 : 1); ++threads) {
              CrowdCounts counts;
              const auto found = collide_all(bodies, Query::full, counts, threads);
              RC_ASSERT(found.size() == expected.size());
              RC_ASSERT(counts.pairs_of_boxes >= static_cast<long>(found.size()));
              for (std::size_t i = 0; i < found.size(); ++i) {
                RC_ASSERT(found[i].first == expected[i].first && found[i].second == expected[i].second);
                RC_ASSERT(sorted(found[i].pairs) == expected[i].pairs);
              }
              const auto answers = collide_all(bodies, Query::yes_no, counts, threads);
              RC_ASSERT(answers.size() == expected.size());
              for (const Contact& answer : answers) RC_ASSERT(answer.pairs.size() == 1u);
            }
          });
  t.example("no thread at all is refused", {}, [] {
    try {
      CrowdCounts counts;
      collide_all({}, Query::full, counts, 0);
      return Checked(false);
    } catch (const std::invalid_argument& e) {
      return Checked(true, 1, e.what());
    }
  });
}

}  // namespace proptests
