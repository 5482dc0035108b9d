// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the baseline that crowds are compared with, and the men of whom they are.
#include "experiments/crowds/skinned_crowd.hpp"

#include <cmath>

#include "experiments/crowds/walkers.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/workers_on_threads.hpp"

namespace proptests::suite_skinned_crowd {
namespace {

using namespace refitlab;

constexpr Spacing crowded{"crowded", 0.7, false}, even{"even", 4, true};

const Model& small_man() {
  static const Model man = make_man(400);
  return man;
}

// Returns the contacts of a frame, by testing all pairs of triangles of all men.
std::vector<Contact> all_contacts(const Character& man, const Walkers& walkers, int frame) {
  std::vector<std::vector<Point3>> points;
  for (int i = 0; i < walkers.count(); ++i)
    points.push_back(oracle::Posed{man, walkers.poses(frame)[static_cast<std::size_t>(i)],
                                   walkers.placements(frame)[static_cast<std::size_t>(i)]}
                         .vertices(Skinning::spherical));
  std::vector<Contact> out;
  for (int a = 0; a < walkers.count(); ++a)
    for (int b = a + 1; b < walkers.count(); ++b)
      if (auto pairs = oracle::all_pairs(man.mesh.triangles, points[static_cast<std::size_t>(a)], man.mesh.triangles,
                                         points[static_cast<std::size_t>(b)]);
          !pairs.empty())
        out.push_back({a, b, std::move(pairs)});
  return out;
}

// Says whether the contacts are the expected ones: with all of their pairs, or with one of these for Query::yes_no.
bool are_same(const std::vector<Contact>& expected, const std::vector<Contact>& found, Query query) {
  bool ok = expected.size() == found.size();
  for (std::size_t i = 0; ok && i < found.size(); ++i) {
    ok = expected[i].first == found[i].first && expected[i].second == found[i].second;
    const auto pairs = oracle::sorted(found[i].pairs);
    if (query == Query::full) ok = ok && pairs == expected[i].pairs;
    else ok = ok && pairs.size() == 1 && std::binary_search(expected[i].pairs.begin(), expected[i].pairs.end(), pairs[0]);
  }
  return ok;
}

void contacts_are_those_of_all_pairs(Suite& t) {
  t.example(
      "a dozen walking men, all skinned or where motion bounds meet, on one thread and on two: the contacts are those of all "
      "pairs of triangles",
      {}, [] {
        const auto man = bake_animated(small_man());
        const Walkers walkers(man.clips[0], 12, crowded, 2);
        const ClusterTree tree(man);
        SkinnedCrowd crowd(tree, walkers.count());
        std::vector<std::vector<Contact>> expected;
        long contacts = 0, wrong = 0, tried = 0;
        for (int f = 0; f < walkers.frames(); f += 3) {
          expected.push_back(all_contacts(man, walkers, f));
          contacts += static_cast<long>(expected.back().size());
        }
        for (const auto skinned : {SkinnedCrowd::Skinned::all, SkinnedCrowd::Skinned::where_motion_bounds_meet})
          for (const Query query : {Query::full, Query::yes_no})
            for (const Workers& workers : {one_worker(), oracle::workers_on_threads<2>()})
              for (std::size_t i = 0; i < expected.size(); ++i) {
                const int f = 3 * static_cast<int>(i);
                const auto found = crowd.frame(walkers.poses(f), walkers.placements(f), skinned, query, workers);
                wrong += !are_same(expected[i], found, query), ++tried;
              }
        return Checked(wrong == 0 && contacts >= 10, tried, std::to_string(contacts) + " contacts");
      });
  t.example("a pose that no query accepts is refused by the thread that asked, whoever found it", {}, [] {
    const auto man = bake_animated(small_man());
    const ClusterTree tree(man);
    const Walkers walkers(man.clips[0], 3, crowded, 1);
    auto poses = walkers.poses(0);
    poses[1][2].rotation *= 2;
    SkinnedCrowd crowd(tree, 3);
    long refused = 0;
    for (const auto skinned : {SkinnedCrowd::Skinned::all, SkinnedCrowd::Skinned::where_motion_bounds_meet})
      for (const Workers& workers : {one_worker(), oracle::workers_on_threads<2>()}) {
        try {
          crowd.frame(poses, walkers.placements(0), skinned, Query::full, workers);
        } catch (const ModelError&) {
          ++refused;
        }
      }
    return Checked(refused == 4, 4);
  });
}

void men_walk_ahead(Suite& t) {
  t.example("men walk 1.2 metres a second where they look, and start elsewhere each time, in a square with room for each", {},
            [] {
              const Model& man = small_man();
              constexpr int count = 50, starts = 3;
              bool ok = true;
              for (const Spacing& spacing : {crowded, even}) {
                const Walkers walkers(man.clips[0], count, spacing, starts);
                ok = ok && walkers.count() == count && walkers.frames() == starts * Walkers::frames_of_a_start;
                for (int i = 0; i < count; ++i)
                  for (int f = 0; f < walkers.frames(); ++f) {
                    const auto& at = walkers.placements(f)[static_cast<std::size_t>(i)];
                    const bool is_start = f % Walkers::frames_of_a_start == 0;
                    ok = ok && walkers.poses(f).size() == std::size_t(count);
                    if (is_start) {
                      const double side = spacing.edge * std::ceil(std::sqrt(count));
                      ok = ok && at.translation[0] >= 0 && at.translation[0] <= side && at.translation[2] >= 0 &&
                           at.translation[2] <= side;
                      continue;
                    }
                    const auto& before = walkers.placements(f - 1)[static_cast<std::size_t>(i)];
                    const Point3 step = at.translation - before.translation, ahead = rotate(at.rotation, Point3(0, 0, 1.2 / 30));
                    ok = ok && (step - ahead).norm() < 1e-12 && at.rotation == before.rotation;
                  }
                const auto& first = walkers.placements(0)[7];
                ok = ok && first.rotation != walkers.placements(Walkers::frames_of_a_start)[7].rotation;
              }
              return Checked(ok, 2 * count * starts * Walkers::frames_of_a_start);
            });
  t.example("evenly spaced men are as far apart as they should be, and no two have the same pose", {}, [] {
    const Model& man = small_man();
    const Walkers walkers(man.clips[0], 10, even, 1);
    bool ok = true;
    for (std::size_t a = 0; a < 10; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const Point3 between = walkers.placements(0)[a].translation - walkers.placements(0)[b].translation;
        ok = ok && between.norm() >= even.edge && walkers.poses(0)[a][3].rotation != walkers.poses(0)[b][3].rotation;
      }
    return Checked(ok, 45);
  });
}

}  // namespace

PROPTEST(skinned_crowd) {
  contacts_are_those_of_all_pairs(t);
  men_walk_ahead(t);
}

}  // namespace proptests::suite_skinned_crowd
