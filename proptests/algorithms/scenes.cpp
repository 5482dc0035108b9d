// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what the experiments share: methods by their names, and the poses of a model.
#include "experiments/scenes/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <regex>
#include <set>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/methods.hpp"
#include "experiments/scenes/real_models.hpp"
#include "experiments/scenes/twist.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_scenes {
namespace {

using namespace refitlab;

const Skinning skinnings[] = {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion};

bool is_method(const std::string& name) {
  return std::any_of(methods().begin(), methods().end(), [&](const Method& m) { return m.name == name; });
}

// Checks that each method is found by its name, and that each compared variant stands alone under its own.
Checked check_names() {
  std::string wrong;
  std::set<std::string> names;
  for (const Method& m : methods()) {
    if (!names.insert(m.name).second) wrong += "two methods are named " + m.name + "; ";
    if (&method(m.name) != &m) wrong += m.name + " is another method; ";
  }
  for (const RefitVariant& v : compared_variants()) {
    const Method& m = method(v.name);
    if (m.variant->name != v.name || !m.stands_alone() || m.description != v.description) wrong += v.name + " is not itself; ";
  }
  return Checked(wrong.empty(), static_cast<long>(names.size()), wrong);
}

// Checks the defaults. The lists of variants are copies of each other, so that a variant has an address in each.
Checked check_defaults() {
  std::string wrong;
  std::size_t expected = compared_variants().size();
  for (const Skinning s : skinnings) {
    const std::string name = default_variant(s).name;
    const auto at = std::find_if(methods().begin(), methods().end(), [&](const Method& m) { return m.name == name; });
    if (methods().end() - at < 3) return Checked(false, 0, name + " has none behind it");
    const Method &through = at[1], &children = at[2];
    if (through.name != name + "_through_descendants" || through.variant->name != name || through.stands_alone() ||
        through.options.most_joint_sets == 0 || through.options.children_first)
      wrong += through.name + " is not " + name + " through descendants; ";
    if (children.name != name + "_children_first" || children.variant->name != name || children.stands_alone() ||
        children.options.most_joint_sets != 0 || !children.options.children_first)
      wrong += children.name + " is not " + name + ", children first; ";
    expected += 2;
  }
  if (methods().size() != expected) wrong += std::to_string(methods().size()) + " methods; ";
  return Checked(wrong.empty(), static_cast<long>(expected), wrong);
}

// Checks what the experiments, the report and the paper write in quotes and looks like a variant's name.
Checked check_quoted_names() {
  // This is a comparison: the linear refit of a spherical skin.
  const std::set<std::string> others{"linear_under_spherical",
                                     "control_near"};  // The reference tells a researcher to add this row.
  const std::regex quoted(R"re(["']((?:spherical|control|linear|dual_quaternion)_[a-z_]+)["'])re");
  std::string wrong;
  std::set<std::string> seen;
  for (const char* folder : {"experiments", "paper"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string kind = entry.path().extension().string();
      if (!entry.is_regular_file() ||
          (kind != ".cpp" && kind != ".hpp" && kind != ".py" && kind != ".js" && kind != ".mjs" && kind != ""))
        continue;
      const std::string text = read_whole(entry.path().string());
      for (auto m = std::sregex_iterator(text.begin(), text.end(), quoted); m != std::sregex_iterator(); ++m) {
        const std::string name = (*m)[1];
        if (!is_method(name) && !others.count(name)) wrong += entry.path().string() + " names " + name + "; ";
        seen.insert(name);
      }
    }
  return Checked(wrong.empty() && seen.size() >= 10, static_cast<long>(seen.size()), wrong);
}

const AnimatedCharacter& man() {
  static const AnimatedCharacter character = bake_animated(make_man());
  return character;
}

bool holds_all(const Ball3<double>& ball, const std::vector<Point3>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Point3& p) { return (p - ball.center).norm() <= ball.radius * (1 + 1e-9); });
}

// Checks for each sound method that its root ball holds all vertices. A method that looks at children first is nowhere larger,
// and one that knows more of a frame has another ball somewhere.
Checked check_balls() {
  std::string wrong;
  const NamedPose twist = figure_twist(man());
  long balls = 0;
  for (const Skinning s : skinnings) {
    const auto palette = make_skinning_palette(man().mesh, man().sets, twist.pose, s);
    const std::vector<Point3> vertices = skin(man().mesh, man().sets, palette, s);
    for (const Method& m : methods()) {
      if (m.variant->skinning != s) continue;
      const auto own = refit_all(man(), m, palette), alone = refit_all(man(), *m.variant, palette);
      if (own.size() != man().tree.nodes.size()) return Checked(false, 0, m.name + " has not a ball a node");
      if (m.variant->sound && !holds_all(own[0], vertices)) wrong += m.name + " misses a vertex; ";
      bool are_others = m.stands_alone();
      for (std::size_t n = 0; n < own.size(); ++n, ++balls) {
        are_others = are_others || own[n].radius != alone[n].radius;
        // The radius may be NaN in both for a printed form.
        const bool are_alike = own[n].radius == alone[n].radius || std::isnan(own[n].radius);
        if (m.stands_alone() && !are_alike) wrong += m.name + " is not its variant; ";
        if (m.options.children_first && own[n].radius > alone[n].radius * (1 + 1e-12)) wrong += m.name + " is larger; ";
      }
      if (!are_others) wrong += m.name + " knows nothing more; ";
    }
  }
  return Checked(wrong.empty(), balls, wrong);
}

double angle_between(const RigidTransform<double>& a, const RigidTransform<double>& b) {
  return 2 * std::acos(std::min(1., std::abs(dot(a.rotation, b.rotation))));
}

// Makes a chain of four joints along x, one of which has a name.
SkinnedMesh chain(int named, const char* name) {
  SkinnedMesh mesh;
  for (int j = 0; j < 4; ++j) mesh.joints.push_back({j == named ? name : "bone", j - 1, Point3(j, 0, 0)});
  return mesh;
}

}  // namespace

PROPTEST(scenes) {
  t.example("each method is found by its name, and each compared variant stands alone under its own", {}, check_names);
  t.example("each default variant, and no other, is followed by itself through descendants and children first", {},
            check_defaults);
  t.example("a name that is none is refused, and so is the beginning of one", {}, [] {
    long refused = 0;
    for (const char* name : {"control_hull", "spherical_repair"}) try {
        method(name);
      } catch (const std::invalid_argument& e) {
        refused += e.what() == std::string("no method named '") + name + "'";
      }
    return Checked(refused == 2, 2);
  });
  t.example("what the experiments, the report and the paper write in quotes like a variant's name is a method's", {},
            check_quoted_names);
  t.example("the balls of a sound method hold all vertices, and those that look at children first are no larger",
            {.number_type = "double"}, check_balls);
  t.example("without the fetched models there are the two procedural ones, and the others are named", {}, [] {
    const DefaultModels found = default_models("no/such/folder");
    return Checked(found.models.size() == 2 && found.models[0].name == "man" && found.models[1].name == "creature" &&
                       found.absent == std::vector<std::string>(real_models.begin(), real_models.end()),
                   2 + static_cast<long>(real_models.size()));
  });
  t.example("a clip is sampled from its start to its end, and a single time is its start", {}, [] {
    bool ok = true;
    const auto sets = pose_sets(man(), 5), single = pose_sets(man(), 1);
    ok = ok && sets.size() == man().clips.size() && single.size() == sets.size();
    for (std::size_t i = 0; ok && i < sets.size(); ++i) {
      const Clip& clip = man().clips[i];
      ok = sets[i].name == clip.name && sets[i].kind == "clip" && sets[i].poses.size() == 5 && single[i].poses.size() == 1;
      for (int k = 0; ok && k < 5; ++k) {
        const Pose expected = clip.sample(clip.duration * k / 4);
        for (std::size_t j = 0; j < expected.size(); ++j)
          ok = ok && sets[i].poses[k][j].rotation == expected[j].rotation &&
               sets[i].poses[k][j].translation == expected[j].translation;
      }
      ok = ok && single[i].poses[0][0].translation == clip.sample(0)[0].translation;
    }
    return Checked(ok, static_cast<long>(sets.size()));
  });
  t.example("a twist turns a joint and all below it about the bone, and nothing else", {.number_type = "double"}, [] {
    const SkinnedMesh mesh = chain(2, "Neck_01");
    const double angle = 170 * std::numbers::pi / 180;
    const Pose rest = reference_pose(mesh), turned = twist_pose(mesh, 2, angle);
    bool ok = twist_joint(mesh) == 2 && (bone_axis(mesh, 2) - Point3(1, 0, 0)).norm() < 1e-15 &&
              (bone_axis(mesh, 3) - Point3(1, 0, 0)).norm() < 1e-15;
    for (int j = 0; j < 4; ++j) ok = ok && std::abs(angle_between(turned[j], rest[j]) - (j >= 2 ? angle : 0)) < 1e-7;
    // A point of the bone stays, and one beside it moves around it.
    ok = ok && norm(Point3(apply(turned[3], Point3(2.5, 0, 0)) - Point3(2.5, 0, 0))) < 1e-14;
    return ok && norm(Point3(apply(turned[3], Point3(2.5, 1, 0)) - Point3(2.5, std::cos(angle), std::sin(angle)))) < 1e-14;
  });
  t.example("the joint that is twisted is a neck, else a head or a wrist by name, else one in the middle", {}, [] {
    return twist_joint(chain(1, "LeftWRIST")) == 1 && twist_joint(chain(3, "Kopf")) == 3 && twist_joint(chain(1, "tail")) == 2 &&
           // A root has no bone to be twisted about.
           twist_joint(chain(0, "neck")) == 2;
  });
  t.example("the twist of the paper's figure ends the clip of that name, else a joint is twisted by 170 degrees", {}, [] {
    AnimatedCharacter c = man();
    c.clips.clear();
    const int joint = twist_joint(c.mesh);
    const NamedPose by_name = figure_twist(c);
    const Pose expected = twist_pose(c.mesh, joint, 170 * std::numbers::pi / 180);
    bool ok = by_name.name == c.mesh.joints[joint].name + " twisted by 170 degrees" && by_name.kind == "twist";
    for (std::size_t j = 0; j < expected.size(); ++j) ok = ok && by_name.pose[j].rotation == expected[j].rotation;
    c.clips.push_back({"walk", 1, [&](double) { return expected; }});
    c.clips.push_back({"twist", 2, [&](double time) { return Pose(3, {expected[0].rotation, {time, 0, 0}}); }});
    const NamedPose of_clip = figure_twist(c);
    return ok && of_clip.name == "full twist" && of_clip.pose.size() == 3 && of_clip.pose[0].translation == Point3(2, 0, 0);
  });
}

}  // namespace proptests::suite_scenes
