// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/float_palettes.hpp"

#include <cstring>
#include <random>
#include <set>

#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_float_palettes {
namespace {

using namespace refitlab;

// Asks for palettes frame by frame, and has the same numbers made one by one.
struct Scene {
  explicit Scene(const SkinnedMesh& model, Skinning skinning = Skinning::spherical)
      : mesh(model),
        sets(mesh),
        packs(mesh, sets, skinning),
        palettes(packs) {}

  void begin(const Pose& posed) {
    pose = posed;
    palettes.begin(&pose, at);
  }

  // Asks for one palette, and says whether it is as when it is made by itself. Unused numbers of an entry are not compared.
  bool is_right(int set) {
    const FloatPaletteEntry& found = palettes[set];
    std::vector<FloatPaletteEntry> alone(sets.count());
    packs.make_floats({&set, 1}, pose, at, alone.data());
    const FloatPaletteEntry& expected = alone[set];
    const int joints = static_cast<int>(sets.joints(set).size());
    if (packs.packed_joints(set) != (joints <= most_palette_joints ? joints : 0)) return false;
    if (joints > most_palette_joints) return std::isinf(found.slack) && std::isinf(expected.slack);
    return std::memcmp(found.center, expected.center, sizeof found.center) == 0 && found.slack == expected.slack &&
           (joints == 1 || std::memcmp(found.first, expected.first, sizeof found.first) == 0) &&
           std::memcmp(found.more, expected.more, (joints == 1 ? 2 : joints - 1) * sizeof found.more[0]) == 0;
  }

  // Returns how many packs it takes to make these.
  int packs_for(const std::set<int>& of) const {
    int counts[most_palette_joints + 1] = {};
    for (const int set : of) ++counts[packs.packed_joints(set)];
    int out = counts[0];
    for (int joints = 1; joints <= most_palette_joints; ++joints) out += (counts[joints] + palette_lanes - 1) / palette_lanes;
    return out;
  }

  const SkinnedMesh mesh;
  const JointSets sets;
  const PalettePacks packs;
  const FloatPlacement at{{0.8, 0, -0.6, 0}, {1, 2, -3}, 0, 0};
  Pose pose;
  FloatPalettes palettes;
};

// Asks for joint-sets of a list that come in any order, some of them again. Returns whether all are right.
bool are_right(Scene& scene, std::vector<int> list, std::mt19937& random) {
  std::shuffle(list.begin(), list.end(), random);
  bool ok = true;
  for (const int set : list)
    ok = ok && scene.is_right(set) && (random() % 4 != 0 || scene.is_right(list[random() % list.size()]));
  return ok;
}

std::vector<int> some_of(const std::vector<int>& list, double share, std::mt19937& random) {
  std::vector<int> out;
  for (const int x : list)
    if (std::generate_canonical<double, 32>(random) < share) out.push_back(x);
  return out;
}

// Checks that a frame which asks for what an earlier one asked for makes no more packs than that needs, if the frames between
// asked for nothing else.
void check_frames(Scene& scene, std::mt19937& random, const std::function<Pose()>& pose) {
  std::vector<int> all(scene.sets.count()), known;
  for (int s = 0; s < scene.sets.count(); ++s) all[s] = s;
  for (int frame = 0; frame < 12; ++frame) {
    scene.begin(pose());
    const bool is_new = random() % 3 == 0;
    if (is_new) known = some_of(all, *rc::gen::element(0.05, 0.3, 0.7, 1.0), random);
    const std::vector<int> asked = is_new || random() % 2 ? known : some_of(known, 0.5, random);
    RC_ASSERT(are_right(scene, asked, random));
    const int needed = scene.packs_for({asked.begin(), asked.end()}), packs = scene.palettes.packs_made();
    RC_ASSERT(packs >= needed && (is_new || packs <= scene.packs_for({known.begin(), known.end()})));
    RC_TAG(is_new ? "new" : asked.empty() ? "nothing" : asked.size() < known.size() ? "some asked again" : "asked again");
    if (random() % 4 != 0) continue;
    scene.palettes.make_all();
    const int made = scene.palettes.packs_made();
    RC_ASSERT(are_right(scene, all, random) && scene.palettes.packs_made() == made);
    scene.palettes.make_all();
    RC_ASSERT(scene.palettes.packs_made() == made);
  }
}

}  // namespace

PROPTEST(float_palettes) {
  t.holds(
      "whatever was asked for before, each palette is that of its joint-set alone, and what is asked for again is made in as few "
      "packs "
      "as can be",
      {.cases = 200, .tags_at_least = {{"asked again", 0.3}, {"new", 0.2}, {"some asked again", 0.05}}}, [] {
        const auto plan = *gen::mesh_plan();
        std::mt19937 random(plan.seed);
        const auto skinning = *rc::gen::element(Skinning::spherical, Skinning::hejl);
        Scene scene(gen::make_mesh(plan), skinning);
        check_frames(scene, random, [&] { return gen::random_pose(scene.mesh, random, 0.3); });
      });
  t.holds("so it is with joint-sets of up to 90 joints, which floats do not skin", {.cases = 60}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const gen::WideModel wide = gen::wide_model(random);
    Scene scene(wide.mesh);
    check_frames(scene, random, [&] { return wide.pose; });
  });
  t.holds("so it is with a walking man, who has more joint-sets of each number of joints than a pack", {.cases = 40}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    static const Model man = make_man();
    Scene scene(man);
    check_frames(scene, random, [&] { return man.clips[0].sample(0.001 * (random() % 1000) * man.clips[0].duration); });
  });
  t.example("to make all takes a pack for each part, and for each that is not made yet", {}, [] {
    Scene scene(make_man());
    scene.begin(reference_pose(scene.mesh));
    scene.palettes.make_all();
    const int all = scene.palettes.packs_made();
    scene.begin(reference_pose(scene.mesh));
    bool ok = all == scene.packs.part_count() && scene.palettes.packs_made() == 0;
    for (const int set : scene.packs.sets_of(0)) ok = ok && scene.is_right(set);
    scene.palettes.make_all();
    return Checked(ok && scene.palettes.packs_made() == all, all, std::to_string(all) + " packs");
  });
}

}  // namespace proptests::suite_float_palettes
