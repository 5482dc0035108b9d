#include "algorithms/collide/cluster_collide.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "algorithms/model/procedural.hpp"
#include "proptests/gen/random_posture.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using oracle::sorted;

Skinning drawn_skinning() {
  return *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion);
}
ClusterOptions drawn_options() {
  return {.most_triangles = *rc::gen::element(1, 3, 10, 25, 1000), .most_children = *rc::gen::element(2, 3, 9, 32)};
}

}  // namespace

PROPTEST(cluster_collide) {
  t.holds("finds the pairs that testing all pairs finds, in every skinning, for clusters and fans of any size",
          {.number_type = "double", .cases = 200, .degenerate_at_least = 0.3}, [] {
            const auto plan_a = *gen::mesh_plan(), plan_b = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
            Model other = gen::make_mesh(plan_b);  // in units of its own, which are taken as they are
            const double unit = *rc::gen::element(1.0, 1.0, 0.01, 100.0);
            for (Point3& v : other.vertices) v *= unit;
            for (auto& joint : other.joints) joint.origin *= unit;
            const Character a(gen::make_mesh(plan_a), {.triangles_per_leaf = *rc::gen::element(1, 40)}),
                b(std::move(other));
            const ClusterTree tree_a(a, drawn_options()), tree_b(b, drawn_options());
            const Skinning skinning = drawn_skinning();
            ClusterBody first(tree_a, skinning), second(tree_b, skinning);
            PairMemory memory;
            std::mt19937 random(plan_a.seed);
            std::normal_distribution<double> normal;
            for (int frame = 0; frame < 3; ++frame) {
              const Posture posture_a = gen::random_posture(a.model, random),
                            posture_b = gen::random_posture(b.model, random);
              const double apart = frame == 2 ? 3 : 0.5;
              const RigidTransform<double> at_a{gen::random_rotation(random, 1), {normal(random), 0, 0}},
                  at_b{gen::random_rotation(random, 1),
                       at_a.translation + Point3(normal(random), normal(random), 0) * apart};
              first.begin(posture_a, at_a), second.begin(posture_b, at_b);
              const auto expected = oracle::all_pairs({a, posture_a, at_a}, {b, posture_b, at_b}, skinning);
              QueryCounts counts;
              const auto one = collide(first, second, Query::yes_no, counts);
              RC_ASSERT(one.size() == (expected.empty() ? 0u : 1u));
              if (!one.empty()) RC_ASSERT(std::find(expected.begin(), expected.end(), one[0]) != expected.end());
              const auto again = collide(first, second, Query::yes_no, counts, &memory);
              RC_ASSERT(again.size() == one.size());
              if (!one.empty()) RC_ASSERT(std::find(expected.begin(), expected.end(), again[0]) != expected.end());
              RC_ASSERT(sorted(collide(first, second, Query::full, counts, &memory)) == expected);
              RC_TAG(expected.empty() ? "apart" : "in contact");
            }
          });
  t.holds("a character against itself in another place, by two bodies that share a tree",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Character c(gen::make_mesh(plan));
            const ClusterTree tree(c, drawn_options());
            const Skinning skinning = drawn_skinning();
            std::mt19937 random(plan.seed);
            const Posture posture = gen::random_posture(c.model, random);
            const RigidTransform<double> at{gen::random_rotation(random, 1), {0.3, 0, 0.1}}, here{};
            ClusterBody first(tree, skinning), second(tree, skinning);
            first.begin(posture, here), second.begin(posture, at);
            QueryCounts counts;
            RC_ASSERT(sorted(collide(first, second, Query::full, counts)) ==
                      oracle::all_pairs({c, posture, here}, {c, posture, at}, skinning));
          });
  t.example(
      "two walking men: nothing is bounded or skinned far apart, a part close by, and the pairs are those of the "
      "sphere trees",
      {}, [] {
        const Character man(make_man());
        const ClusterTree tree(man);
        const Clip& walk = man.model.clips[0];
        const Posture early = walk.sample(0.2 * walk.duration), late = walk.sample(0.7 * walk.duration);
        ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical);
        Body p(man, refit_variant("spherical_repaired")), q(man, refit_variant("spherical_repaired"));
        bool ok = true;
        std::string text;
        for (const double distance : {5.0, 0.6, 0.1}) {
          const RigidTransform<double> at{identity_quaternion<double>(), {distance, 0, 0}};
          a.begin(early, {}), b.begin(late, at), p.begin(early), q.begin(late);
          QueryCounts counts, unused;
          const auto pairs = sorted(collide(a, b, Query::full, counts));
          ok = ok && pairs == sorted(collide({p}, {q, at}, Query::full, unused));
          const long skinned = a.clusters_skinned() + b.clusters_skinned();
          const auto all = 2 * static_cast<long>(tree.clusters().size());
          if (distance == 5.0) ok = ok && a.nodes_bounded() + b.nodes_bounded() == 0;  // their reaches are apart
          ok = ok && (distance == 5.0 ? skinned == 0 : distance == 0.1 ? pairs.size() > 100 : skinned < all / 2);
          text += std::to_string(skinned) + " of " + std::to_string(all) + " clusters skinned for " +
                  std::to_string(pairs.size()) + " pairs; ";
        }
        return Checked(ok, 3, text);
      });
  t.example(
      "triangles that touch in a point, an edge or a plane are found, and boxes that only touch hide none", {}, [] {
        Model m;
        m.name = "triangle";
        m.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}};
        m.triangles = {{0, 1, 2}};
        m.joints = {{"root", -1, {0, 0, 0}}};
        m.influences.assign(3, {{0, 1.0}});
        const Character c(std::move(m));
        const ClusterTree tree(c);
        ClusterBody first(tree, Skinning::spherical), second(tree, Skinning::spherical);
        const Posture still = reference_posture(c.model);
        first.begin(still, {});
        const auto pairs = [&](double x, double y, double z) {
          second.begin(still, {identity_quaternion<double>(), {x, y, z}});
          QueryCounts counts;
          return collide(first, second, Query::full, counts).size();
        };
        return Checked(pairs(2, 0, 0) == 1 && pairs(1, 1, 0) == 1 && pairs(0, 0, 0) == 1 && pairs(0.5, 0, 0) == 1 &&
                           pairs(2, 0, 1e-300) == 0 && pairs(std::nextafter(2, 3), 0, 0) == 0,
                       6);
      });
  t.example("a remembered pair that still touches answers a yes/no query, and no cluster is skinned for it", {}, [] {
    const Character man(make_man());
    const ClusterTree tree(man);
    const Clip& walk = man.model.clips[0];
    ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical);
    const RigidTransform<double> at{identity_quaternion<double>(), {0.1, 0, 0}},
        away{identity_quaternion<double>(), {1, 0, 0}};
    PairMemory memory;
    QueryCounts counts;
    bool ok = true;
    for (const double time : {0.2, 0.2, 0.201}) {
      a.begin(walk.sample(time * walk.duration), {}), b.begin(walk.sample((time + 0.5) * walk.duration), at);
      ok = ok && collide(a, b, Query::yes_no, counts, &memory).size() == 1;
    }
    ok = ok && a.clusters_skinned() == 0 && !memory.pairs().empty();
    b.begin(walk.sample(0.7 * walk.duration), away);
    ok = ok && collide(a, b, Query::yes_no, counts, &memory).empty();
    b.begin(walk.sample(0.7 * walk.duration), at);
    const auto pairs = collide(a, b, Query::full, counts, &memory);
    const auto& kept = memory.pairs();
    for (const TrianglePair& pair : kept) ok = ok && std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
    const std::size_t remembered = kept.size();
    for (const bool was_near : {true, false}) {  // reaches are compared again once the bounds have been found apart
      a.begin(walk.sample(0.2 * walk.duration), {});
      b.begin(walk.sample(0.7 * walk.duration), {identity_quaternion<double>(), {5, 0, 0}});
      ok = ok && memory.are_near == was_near && collide(a, b, Query::full, counts, &memory).empty() &&
           (a.nodes_bounded() > 0) == was_near;
    }
    return Checked(ok && remembered == PairMemory::most, 5,
                   std::to_string(pairs.size()) + " pairs found, " + std::to_string(remembered) + " remembered");
  });
  t.example("options out of range, a placement that is not rigid and a posture with a NaN are refused by name", {}, [] {
    const Character c(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const auto message = [](const auto& call) -> std::string {
      try {
        call();
        return "";
      } catch (const std::exception& e) {
        return e.what();
      }
    };
    const std::string small = message([&] { ClusterTree(c, {.most_triangles = 0}); }),
                      narrow = message([&] { ClusterTree(c, {.most_children = 1}); });
    const ClusterTree tree(c);
    ClusterBody body(tree, Skinning::spherical);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Posture still = reference_posture(c.model);
    const std::string stretched = message([&] {
      body.begin(still, {{2, 0, 0, 0}, {0, 0, 0}});
    }),
                      lost = message([&] {
                        body.begin(still, {{1, 0, 0, 0}, {nan, 0, 0}});
                      });
    Posture posture = still;
    posture[1].translation[2] = nan;
    const std::string refused = message([&] { body.begin(posture, {}); });
    return Checked(small.find("most_triangles is 0") != std::string::npos &&
                       narrow.find("most_children is 1") != std::string::npos &&
                       stretched.find("not rigid") != std::string::npos &&
                       lost.find("not finite") != std::string::npos && refused.find("joint 1") != std::string::npos,
                   5, small + "; " + narrow + "; " + stretched + "; " + lost + "; " + refused);
  });
}

}  // namespace proptests
