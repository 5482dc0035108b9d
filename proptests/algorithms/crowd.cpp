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
  t.example(
      "a dense crowd, each body in contact with most others, is the same on many threads as on one, and nothing is "
      "worked out twice",
      {}, [] {
        const Character c(gen::make_mesh({gen::MeshKind::tube, 40, 24, 4, 3}));
        const ClusterTree tree(c, {.most_triangles = 20, .most_children = 5});
        constexpr int count = 12;
        std::vector<std::unique_ptr<ClusterBody>> owned;
        std::vector<ClusterBody*> bodies;
        for (int i = 0; i < count; ++i)
          owned.push_back(std::make_unique<ClusterBody>(tree, Skinning::spherical)), bodies.push_back(owned.back().get());
        bool ok = true;
        long contacts = 0;
        for (int frame = 0; frame < 4; ++frame) {
          std::vector<Contact> expected;
          std::vector<long> work;
          CrowdCounts sequential;
          for (const int threads : {1, has_threads() ? 8 : 1}) {
            std::mt19937 random(frame + 1);
            std::normal_distribution<double> normal;
            for (auto* body : bodies)
              body->begin(gen::random_posture(c.model, random, 0.2),
                          {gen::random_rotation(random, 1), Point3(normal(random), normal(random), normal(random))});
            CrowdCounts counts;
            auto found = collide_all(bodies, Query::full, counts, threads);
            for (Contact& contact : found) contact.pairs = sorted(contact.pairs);
            std::vector<long> done;
            for (const auto* body : bodies)
              done.insert(done.end(), {body->nodes_bounded(), body->clusters_skinned(), body->corners_skinned()});
            if (expected.empty()) {
              expected = found, work = done, sequential = counts, contacts += static_cast<long>(found.size());
              continue;
            }
            ok = ok && done == work && counts.pairs_of_boxes == sequential.pairs_of_boxes &&
                 counts.queries.ball_tests == sequential.queries.ball_tests &&
                 counts.queries.triangle_tests == sequential.queries.triangle_tests && found.size() == expected.size();
            for (std::size_t i = 0; ok && i < found.size(); ++i)
              ok = found[i].first == expected[i].first && found[i].second == expected[i].second &&
                   found[i].pairs == expected[i].pairs;
          }
        }
        return Checked(ok && contacts > 100, contacts);
      });
  t.example("what is counted of a crowd: pairs of reaches that meet, and what their queries count, added to what was", {},
            [] {
              const Character c(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
              const ClusterTree tree(c);
              std::vector<std::unique_ptr<ClusterBody>> owned;
              std::vector<ClusterBody*> bodies;
              for (const double x : {0.0, 0.3, 0.6, 50.0, 100.0, 100.2}) {
                owned.push_back(std::make_unique<ClusterBody>(tree, Skinning::linear));
                owned.back()->begin(reference_posture(c.model), {identity_quaternion<double>(), {x, 0, 0}});
                bodies.push_back(owned.back().get());
              }
              QueryCounts one_by_one;
              for (const auto& [i, k] : {std::pair(0, 1), {0, 2}, {1, 2}, {4, 5}})
                collide(*bodies[i], *bodies[k], Query::full, one_by_one);
              CrowdCounts counts{7, {11, 13}};
              const auto found = collide_all(bodies, Query::full, counts);
              return Checked(found.size() == 4 && counts.pairs_of_boxes == 7 + 4 &&
                             counts.queries.ball_tests == 11 + one_by_one.ball_tests &&
                             counts.queries.triangle_tests == 13 + one_by_one.triangle_tests);
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
