// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/crowd.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/workers_on_threads.hpp"

namespace proptests::suite_crowd {
namespace {

using namespace refitlab;
using oracle::sorted;

// Holds what a query of a crowd leaves behind.
struct CrowdOutcome {
  std::vector<Contact> contacts;   // their pairs sorted
  std::vector<long> counts, work;  // of the queries, and of the bodies

  bool operator==(const CrowdOutcome& o) const {
    const auto is_same = [](const Contact& a, const Contact& b) {
      return a.first == b.first && a.second == b.second && a.pairs == b.pairs;
    };
    return counts == o.counts && work == o.work &&
           std::equal(contacts.begin(), contacts.end(), o.contacts.begin(), o.contacts.end(), is_same);
  }
};

// A CrowdQuery is one of the two functions called collide_all.
template <class CrowdQuery>
CrowdOutcome outcome_of(std::span<ClusterBody* const> bodies, const CrowdQuery& query) {
  CrowdCounts counts;
  CrowdOutcome out{query(counts), {}, {}};
  for (Contact& contact : out.contacts) contact.pairs = sorted(contact.pairs);
  out.counts = {counts.pairs_of_boxes, counts.queries.ball_tests, counts.queries.triangle_tests};
  for (const auto* body : bodies)
    out.work.insert(out.work.end(), {body->nodes_bounded(), body->clusters_skinned(), body->vertices_skinned()});
  return out;
}
CrowdOutcome outcome_of(std::span<ClusterBody* const> bodies, const Workers& workers) {
  return outcome_of(bodies, [&](CrowdCounts& counts) { return collide_all(bodies, Query::full, counts, workers); });
}

// Says whether the body is in a frame.
bool has_begun(ClusterBody& body) {
  try {
    body.motion_bound();
    return true;
  } catch (const std::logic_error&) {
    return false;
  }
}

// Checks that new bodies have the contacts of those that have begun the frame, from poses and placements, on one thread and on two,
// and that at first no body begins the frame in vain.
void check_bodies_that_begin_on_demand(std::span<ClusterBody* const> begun, const ClusterTree& tree, Skinning skinning,
                                       const std::vector<Pose>& poses, const std::vector<RigidTransform<double>>& placements,
                                       const std::vector<Contact>& expected) {
  std::vector<std::unique_ptr<ClusterBody>> owned;
  std::vector<ClusterBody*> bodies;
  for (std::size_t i = 0; i < begun.size(); ++i)
    owned.push_back(std::make_unique<ClusterBody>(tree, skinning)), bodies.push_back(owned.back().get());
  CrowdCounts of_begun;
  collide_all(begun, Query::full, of_begun);
  for (int times = 0; times < 3; ++times) {
    CrowdCounts counts;
    const Workers workers = times == 1 ? oracle::workers_on_threads<2>() : one_worker();
    const auto found = collide_all(bodies, poses, placements, Query::full, counts, workers);
    RC_ASSERT(counts.pairs_of_boxes == of_begun.pairs_of_boxes && found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].first == expected[i].first && found[i].second == expected[i].second);
      RC_ASSERT(sorted(found[i].pairs) == expected[i].pairs);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const bool has_neighbours = std::any_of(begun.begin(), begun.end(), [&](ClusterBody* other) {
        return other != begun[i] && !are_apart(other->motion_bound(), begun[i]->motion_bound());
      });
      // A coarse bound, which is that of an earlier pose, may meet another one in vain.
      const bool begins = has_begun(*bodies[i]);
      RC_ASSERT((times == 0 ? begins == has_neighbours : begins || !has_neighbours));
      RC_ASSERT(bodies[i]->has_neighbours() == has_neighbours);
      RC_TAG(has_neighbours ? "has neighbours" : "has no neighbours");
    }
  }
  // All are somewhere else, where those that had neighbours have none, and then where they were again.
  std::vector<RigidTransform<double>> away = placements;
  for (std::size_t i = 0; i < away.size(); ++i) away[i].translation = {1000.0 * static_cast<double>(i), 0, 0};
  CrowdCounts counts;
  if (skinning != Skinning::dual_quaternion) {  // some of these have no bound
    RC_ASSERT(collide_all(bodies, poses, away, Query::full, counts).empty() && counts.pairs_of_boxes == 0);
    for (const ClusterBody* body : bodies) RC_ASSERT(!body->has_neighbours());
  }
  RC_ASSERT(collide_all(bodies, poses, placements, Query::yes_no, counts).size() == expected.size());
}

void contacts_are_those_of_all_pairs(Suite& t) {
  t.holds("the contacts of a crowd are those of its pairs, one after the other, on one thread and on two",
          {.number_type = "double",
           .cases = 60,
           .degenerate_at_least = 0.3,
           .tags_at_least = {{"in contact", 0.3}, {"has neighbours", 0.5}, {"has no neighbours", 0.2}}},
          [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan));
            const ClusterTree tree(c, {.most_triangles = 10, .most_children = 9});
            std::mt19937 random(plan.seed);
            std::uniform_real_distribution<double> place(-3, 3);
            // Dual quaternions far apart have no bound at all, and such a body is compared with all others.
            const Skinning skinning = *rc::gen::element(Skinning::spherical, Skinning::dual_quaternion);
            const double spread = *rc::gen::element(0.5, 3.0);
            const int count = *rc::gen::inRange(0, 12);
            std::vector<std::unique_ptr<ClusterBody>> owned;
            std::vector<ClusterBody*> bodies;
            std::vector<Pose> poses;
            std::vector<RigidTransform<double>> placements;
            for (int i = 0; i < count; ++i) {
              owned.push_back(std::make_unique<ClusterBody>(tree, skinning));
              poses.push_back(gen::random_pose(c.mesh, random, spread));
              placements.push_back({gen::random_rotation(random, 1), {place(random), place(random), 0}});
              owned.back()->begin(poses.back(), placements.back());
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
            for (const Workers& workers : {one_worker(), oracle::workers_on_threads<2>()}) {
              CrowdCounts counts;
              const auto found = collide_all(bodies, Query::full, counts, workers);
              RC_ASSERT(found.size() == expected.size());
              RC_ASSERT(counts.pairs_of_boxes >= static_cast<long>(found.size()));
              for (std::size_t i = 0; i < found.size(); ++i) {
                RC_ASSERT(found[i].first == expected[i].first && found[i].second == expected[i].second);
                RC_ASSERT(sorted(found[i].pairs) == expected[i].pairs);
              }
              const auto answers = collide_all(bodies, Query::yes_no, counts, workers);
              RC_ASSERT(answers.size() == expected.size());
              for (const Contact& answer : answers) RC_ASSERT(answer.pairs.size() == 1u);
            }
            check_bodies_that_begin_on_demand(bodies, tree, skinning, poses, placements, expected);
          });
}

void a_dense_crowd(Suite& t) {
  t.example(
      "a dense crowd, each body in work with most others at once, is the same on many threads as on one, and nothing is "
      "worked out twice",
      {}, [] {
        const auto man = bake_animated(make_man());
        const ClusterTree tree(man);
        constexpr int count = 12;
        constexpr long frames = 16;
        std::vector<std::unique_ptr<ClusterBody>> owned;
        std::vector<ClusterBody*> bodies;
        for (int i = 0; i < count; ++i)
          owned.push_back(std::make_unique<ClusterBody>(tree, Skinning::spherical)), bodies.push_back(owned.back().get());
        long contacts = 0;
        for (long frame = 0; frame < frames; ++frame) {
          std::mt19937 random(static_cast<unsigned>(frame));
          std::uniform_real_distribution<double> place(-0.3, 0.3), time(0, man.clips[0].duration);
          std::vector<Pose> poses;
          std::vector<RigidTransform<double>> placements;
          for (int i = 0; i < count; ++i) {
            poses.push_back(man.clips[0].sample(time(random)));
            placements.push_back({identity_quaternion<double>(), Point3(place(random), place(random), place(random))});
          }
          const auto begin = [&] {
            for (int i = 0; i < count; ++i) bodies[i]->begin(poses[i], placements[i]);
          };
          begin();
          const CrowdOutcome one = outcome_of(bodies, one_worker());
          begin();
          const auto many = oracle::workers_on_threads<8>();
          if (!(outcome_of(bodies, many) == one)) return Checked(false, frame, "frame " + std::to_string(frame));
          if (!(outcome_of(bodies, [&](CrowdCounts& counts) {
                  return collide_all(bodies, poses, placements, Query::full, counts, many);
                }) == one))
            return Checked(false, frame, "frame " + std::to_string(frame) + ", from poses");
          contacts += static_cast<long>(one.contacts.size());
        }
        return Checked(contacts > 30 * frames, frames, std::to_string(contacts) + " contacts");
      });
}

// Holds a body of a crowd, and where its vertices are in the world.
struct Member {
  const ClusterTree& tree;
  ClusterBody body;
  std::vector<Point3> points = {};

  Member(const ClusterTree& of, Skinning skinning) : tree(of), body(of, skinning) {}
};

// Begins a frame of rigid joints or of affine ones, deformed or not.
void begin(Member& member, Skinning skinning, std::mt19937& random, const RigidTransform<double>& at) {
  const Character& c = member.tree.character();
  const auto kind = static_cast<gen::JointKind>(random() % 5);
  const std::vector<double> weights = random() % 2 ? gen::random_weights(c.mesh, random) : std::vector<double>();
  const auto skinned = [&](const Pose& pose, const Deformation& deformation) {
    return skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose, skinning), skinning, deformation);
  };
  if (random() % 2) {
    const AffinePose pose = gen::random_affine_pose(c.mesh, kind, random);
    member.body.begin(pose, at, weights);
    if (skinning == Skinning::linear) {
      member.points = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose), skinning, {weights, {}});
    } else {
      const SplitPose parts = split(c.mesh, pose);
      member.points = skinned(parts.pose, {weights, parts.scales});
    }
    RC_TAG("affine");
  } else {
    const Pose pose = gen::random_pose(c.mesh, random);
    const Deformation deformation{weights, random() % 2 ? gen::random_scales(c.mesh, kind, random) : AffinePose()};
    member.body.begin(pose, at, deformation);
    member.points = skinned(pose, deformation);
    if (!deformation.is_none()) RC_TAG("deformed");
  }
  for (Point3& p : member.points) p = apply(at, p);
}

// Checks bodies of two characters and three trees, each skinned and deformed in its own way, against all pairs of their
// triangles.
void check_crowd_of_all_kinds() {
  const auto plan_a = *gen::mesh_plan(), plan_b = *gen::mesh_plan();
  RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
  std::mt19937 random(plan_a.seed);
  SkinnedMesh meshes[] = {gen::make_mesh(plan_a), gen::make_mesh(plan_b)};
  for (SkinnedMesh& mesh : meshes) gen::add_targets(mesh, random);
  const Character a = bake(meshes[0]), b = bake(meshes[1], {.triangles_per_leaf = 1});
  const ClusterTree trees[] = {ClusterTree(a, {.most_triangles = 10, .most_children = 9}), ClusterTree(b),
                               ClusterTree(a, {.most_triangles = 3, .most_children = 2})};
  const int count = *rc::gen::inRange(2, 6);
  std::vector<std::unique_ptr<Member>> owned;
  std::vector<ClusterBody*> bodies;
  std::vector<Skinning> skinnings;
  for (int i = 0; i < count; ++i) {
    skinnings.push_back(
        std::array{Skinning::linear, Skinning::spherical, Skinning::dual_quaternion, Skinning::hejl}[random() % 4]);
    owned.push_back(std::make_unique<Member>(trees[random() % 3], skinnings.back()));
    bodies.push_back(&owned.back()->body);
  }
  std::uniform_real_distribution<double> place(-2, 2);
  for (int frame = 0; frame < 2; ++frame) {
    for (int i = 0; i < count; ++i)
      begin(*owned[i], skinnings[i], random, {gen::random_rotation(random, 1), {place(random), place(random), 0}});
    std::vector<Contact> expected;
    for (int i = 0; i < count; ++i)
      for (int k = i + 1; k < count; ++k)
        if (auto pairs = oracle::all_pairs(owned[i]->tree.character().mesh.triangles, owned[i]->points,
                                           owned[k]->tree.character().mesh.triangles, owned[k]->points);
            !pairs.empty())
          expected.push_back({i, k, std::move(pairs)});
    RC_TAG(expected.empty() ? "apart" : "in contact");
    CrowdCounts counts;
    const auto found = collide_all(bodies, Query::full, counts, frame == 0 ? one_worker() : oracle::workers_on_threads<2>());
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].first == expected[i].first && found[i].second == expected[i].second);
      RC_ASSERT(sorted(found[i].pairs) == expected[i].pairs);
    }
  }
}

void in_another_order(Suite& t) {
  t.example("workers that take the tasks in another order find the same contacts", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical), c(tree, Skinning::spherical),
        d(tree, Skinning::spherical);
    ClusterBody* const bodies[] = {&a, &b, &c, &d};
    const auto begin = [&](ClusterBody& body, int place) {
      body.begin(man.clips[0].sample(0.2 * place), {identity_quaternion<double>(), {0.25 * place, 0, 0}});
    };
    const auto outcome = [&](const Workers& workers) {
      for (int i = 0; i < 4; ++i) begin(*bodies[i], i);
      return outcome_of(bodies, workers);
    };
    const Workers backwards{[](void*, std::size_t count, void (*task)(void*, std::size_t), void* data) {
      while (count-- > 0) task(data, count);
    }};
    const CrowdOutcome one = outcome(one_worker());
    const bool is_same = one.contacts.size() >= 3 && outcome(backwards) == one;
    // Afterwards a query by itself works as with bodies that were in no crowd.
    ClusterBody new_a(tree, Skinning::spherical), new_b(tree, Skinning::spherical);
    begin(a, 0), begin(b, 1), begin(new_a, 0), begin(new_b, 1);
    QueryCounts after, fresh;
    collide(a, b, Query::full, after), collide(new_a, new_b, Query::full, fresh);
    return Checked(is_same && after.ball_tests == fresh.ball_tests && a.nodes_bounded() == new_a.nodes_bounded(), 3);
  });
}

void made_on_several_threads(Suite& t) {
  t.example("bodies of a new tree, skinned in all ways and made on eight threads at once, share what bodies of their way share",
            {}, [] {
              const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 4, 1}));
              constexpr int count = 32;
              long wrong = 0;
              for (int times = 0; times < 5; ++times) {
                const ClusterTree tree(c);
                std::array<const WayOfSkinning*, count> ways{};
                std::array<std::unique_ptr<ClusterBody>, count> bodies;
                for_each(oracle::workers_on_threads<8>(), count, [&](std::size_t i) {
                  const Skinning skinning = gen::all_skinnings[i % std::size(gen::all_skinnings)];
                  bodies[i] = std::make_unique<ClusterBody>(tree, skinning);
                  ways[i] = &tree.way_of(skinning);
                  bodies[i]->begin(reference_pose(c.mesh), {});
                });
                const ClusterTree copy = tree;
                for (std::size_t i = 0; i < count; ++i) {
                  const std::size_t way = i % std::size(gen::all_skinnings);
                  wrong += ways[i] != ways[way] || ways[i] != &copy.way_of(gen::all_skinnings[way]);
                  wrong += bodies[i]->motion_bound().low != bodies[way]->motion_bound().low;
                }
              }
              return Checked(wrong == 0, 5 * count);
            });
}

void bodies_of_all_ways_in_one_list(Suite& t) {
  t.example("bodies of two trees, skinned in all ways, take turns in a list, and have the contacts of those that have begun", {},
            [] {
              const auto small = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1})),
                         large = bake(gen::make_mesh({gen::MeshKind::tube, 8, 7, 5, 2}));
              const ClusterTree trees[] = {ClusterTree(small, {.most_triangles = 5}), ClusterTree(large, {.most_triangles = 9})};
              std::mt19937 random(5);
              std::uniform_real_distribution<double> place(-6, 6);
              constexpr int count = 40;
              std::vector<std::unique_ptr<ClusterBody>> owned;
              std::vector<ClusterBody*> bodies;
              for (int i = 0; i < count; ++i) {
                const Skinning skinning = gen::all_skinnings[i / 3 % std::size(gen::all_skinnings)];
                owned.push_back(std::make_unique<ClusterBody>(trees[i / 2 % 2], skinning)), bodies.push_back(owned.back().get());
              }
              std::size_t contacts = 0;
              bool ok = true;
              for (int frame = 0; frame < 6; ++frame) {
                std::vector<Pose> poses;
                std::vector<RigidTransform<double>> placements;
                for (const ClusterBody* body : bodies) {
                  poses.push_back(gen::random_pose(body->tree().character().mesh, random, 0.3));
                  placements.push_back({gen::random_rotation(random, 1), {place(random), place(random), place(random)}});
                }
                CrowdCounts counts, of_begun;
                auto found = collide_all(bodies, poses, placements, Query::full, counts);
                for (int i = 0; i < count; ++i) bodies[i]->begin(poses[i], placements[i]);
                auto expected = collide_all(bodies, Query::full, of_begun);
                ok = ok && found.size() == expected.size() && counts.pairs_of_boxes == of_begun.pairs_of_boxes;
                for (std::size_t i = 0; ok && i < found.size(); ++i)
                  ok = found[i].first == expected[i].first && found[i].second == expected[i].second &&
                       sorted(found[i].pairs) == sorted(expected[i].pairs);
                contacts += found.size();
              }
              return Checked(ok && contacts > 20, 6 * count, std::to_string(contacts) + " contacts");
            });
}

void refused_lists(Suite& t) {
  t.example("a body that is listed twice, and one that is not there, are refused by their places", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const ClusterTree tree(c);
    ClusterBody a(tree, Skinning::linear), b(tree, Skinning::linear);
    for (ClusterBody* body : {&a, &b}) body->begin(reference_pose(c.mesh), {});
    const auto refusal = [](std::vector<ClusterBody*> bodies) -> std::string {
      CrowdCounts counts;
      try {
        collide_all(bodies, Query::full, counts);
      } catch (const std::invalid_argument& e) {
        return e.what();
      }
      return "";
    };
    return Checked(refusal({&b, &a}).empty() && refusal({&a, &b, &a}) == "collide_all: body 2 is body 0 again" &&
                       refusal({&a, &a}) == "collide_all: body 1 is body 0 again" &&
                       refusal({&b, nullptr}) == "collide_all: body 1 is null",
                   4);
  });
  t.example("so are poses or placements that are too few or too many, and those that no frame takes", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const ClusterTree tree(c);
    ClusterBody a(tree, Skinning::linear), b(tree, Skinning::linear);
    ClusterBody* const bodies[] = {&a, &b};
    const Pose still = reference_pose(c.mesh);
    Pose wrong = still;
    wrong[0].translation[1] = infinite;
    const RigidTransform<double> here;
    const RigidTransform<double> longer{identity_quaternion<double>() * 2.0, {0, 0, 0}};
    const auto refusal = [&](const std::vector<Pose>& poses,
                             const std::vector<RigidTransform<double>>& placements) -> std::string {
      CrowdCounts counts;
      try {
        collide_all(bodies, poses, placements, Query::full, counts);
      } catch (const std::exception& e) {
        return e.what();
      }
      return "";
    };
    const auto says = [](const std::string& all, const char* part) { return all.find(part) != std::string::npos; };
    bool ok = true;
    for (int times = 0; times < 2; ++times) {  // at first, no body is known to have neighbours
      ok = ok && refusal({still}, {here, here}) == "collide_all: 2 bodies, but 1 poses" &&
           refusal({still, still}, {here, here, here}) == "collide_all: 2 bodies, but 3 placements";
      ok = ok && says(refusal({still, wrong}, {here, here}), "its transform is not finite") &&
           says(refusal({still, still}, {here, longer}), "the body's placement is not rigid") &&
           says(refusal({still, Pose()}, {here, here}), "has 0 transforms for");
      ok = ok && has_begun(a) == (times > 0) && refusal({still, still}, {here, here}).empty() && has_begun(a) && has_begun(b);
    }
    return Checked(ok, 12, refusal({still, Pose()}, {here, here}));
  });
}

}  // namespace

PROPTEST(crowd) {
  contacts_are_those_of_all_pairs(t);
  a_dense_crowd(t);
  made_on_several_threads(t);
  t.holds(
      "contacts of bodies of different trees and skinnings, affine and deformed ones among them, are those of testing all pairs",
      {.number_type = "double",
       .cases = 40,
       .degenerate_at_least = 0.3,
       .tags_at_least = {{"in contact", 0.3}, {"affine", 0.5}, {"deformed", 0.5}}},
      check_crowd_of_all_kinds);
  t.example("what is counted of a crowd: pairs of motion bounds that meet, and what their queries count, added to what was", {},
            [] {
              const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
              const ClusterTree tree(c);
              std::vector<std::unique_ptr<ClusterBody>> owned;
              std::vector<ClusterBody*> bodies;
              for (const double x : {0.0, 0.3, 0.6, 50.0, 100.0, 100.2}) {
                owned.push_back(std::make_unique<ClusterBody>(tree, Skinning::linear));
                owned.back()->begin(reference_pose(c.mesh), {identity_quaternion<double>(), {x, 0, 0}});
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
  bodies_of_all_ways_in_one_list(t);
  refused_lists(t);
  t.example("a body that has begun no frame is refused by name, whichever thread comes upon it", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const ClusterTree tree(c);
    long tried = 0;
    for (const Workers& workers : {one_worker(), oracle::workers_on_threads<2>()})
      for (std::size_t late = 0; late < 3; ++late) {
        ClusterBody a(tree, Skinning::linear), b(tree, Skinning::linear), d(tree, Skinning::linear);
        ClusterBody* const bodies[] = {&a, &b, &d};
        for (std::size_t i = 0; i < 3; ++i)
          if (i != late) bodies[i]->begin(reference_pose(c.mesh), {});
        CrowdCounts counts;
        ++tried;
        try {
          collide_all(bodies, Query::full, counts, workers);
          return Checked(false, tried, "not refused");
        } catch (const std::logic_error& e) {
          if (std::string(e.what()).find(": no frame was begun") == std::string::npos) return Checked(false, tried, e.what());
        }
      }
    return Checked(true, tried);
  });
  in_another_order(t);
}

}  // namespace proptests::suite_crowd
