// SPDX-License-Identifier: GPL-3.0-or-later
// explorer_numbers prints what the library itself, compiled for this machine, says to what the explorer shows in a browser.
//
// Reads a JSON list from standard input: settings as the page sends them (see ExplorerSettings), or {"page", "values"}
// of a lemma's page. Models other than the procedural ones are in the files (see pack) that it is given. Writes the
// list of answers. A character's answers come from the library's own whole-tree functions and its exact predicates. A lemma's
// answers are in another exact number type than the browser's.
#include <iostream>
#include <set>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/explorer/packed_model.hpp"
#include "experiments/explorer/pages/all.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/twist.hpp"
#include "experiments/tightness/measure.hpp"
#include "lemmas/exact/exact.hpp"

namespace {

using nlohmann::json;
using namespace refitlab;

// Returns the models in the files that the program is given, by name.
std::map<std::string, Model>& packed_models() {
  static std::map<std::string, Model> all;
  return all;
}

const AnimatedCharacter& character(const std::string& name) {
  static std::map<std::string, AnimatedCharacter> made;
  if (const auto packed = packed_models().find(name); packed != packed_models().end() && !made.count(name))
    made.emplace(name, bake_animated(packed->second));
  if (const auto known = made.find(name); known != made.end()) return known->second;
  return made.emplace(name, bake_animated(name == "man"        ? make_man()
                                          : name == "creature" ? make_creature()
                                                               : make_snake(24)))
      .first->second;
}

Pose pose_of(const AnimatedCharacter& c, const json& settings) {
  Pose pose = reference_pose(c.mesh);
  for (const Clip& clip : c.clips)
    if (clip.name == settings.at("clip")) pose = clip.sample(settings.at("time"));
  return twisted(c.mesh, pose, settings.at("joint"), settings.at("twist"));
}

json character_numbers(const json& settings) {
  const AnimatedCharacter& c = character(settings.at("model"));
  const RefitVariant& variant = compared_variant(settings.at("variant"));
  const Pose pose = pose_of(c, settings);
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose, variant.skinning);
  const auto deformed = skin(c.mesh, c.sets, palette, variant.skinning);
  const auto balls = refit_all(c, variant, palette);
  const auto optimal = optimal_balls(c.tree, c.vertices, deformed);
  const double slack = miss_tolerance * c.tree.nodes[0].reference.radius;

  std::set<int> outside;
  int count = 0, undefined = 0, ball = settings.at("ball");
  double radii = 0, optimal_radii = 0, worst = 0;
  json out;
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const Point3 at = apply(pose[j], c.mesh.joints[j].origin);
    out["joints"].push_back({at[0], at[1], at[2]});
  }
  for (std::size_t n = 0; n < balls.size(); ++n) {
    if (c.tree.nodes[n].level != settings.at("level")) continue;
    if (count++ == ball) {
      out["ball_radius"] = balls[n].radius, out["ball_optimal"] = optimal[n].radius;
      out["ball_vertices"] = c.vertices[static_cast<int>(n)].size();
    }
    if (!(balls[n].radius >= 0)) {
      ++undefined;
      continue;
    }
    radii += balls[n].radius, optimal_radii += optimal[n].radius;
    for (const int v : c.vertices[static_cast<int>(n)])
      if (encloses(inflate(balls[n], slack), deformed[v]) != Verdict::holds) {
        outside.insert(v);
        worst = std::max(worst, norm<double, 3>(deformed[v] - balls[n].center) - balls[n].radius);
      }
  }
  out["balls"] = count, out["undefined"] = undefined, out["vertices_outside"] = outside.size();
  out["worst_miss"] = worst;
  out["mean_radius"] = radii / (count - undefined), out["mean_over_optimal"] = radii / optimal_radii;
  return out;
}

}  // namespace

int main(int argc, char** argv) try {
  for (int i = 1; i < argc; ++i) {
    const std::string bytes = read_whole(argv[i]);
    Model model = unpack({bytes.begin(), bytes.end()});
    packed_models().emplace(model.name, std::move(model));
  }
  json answers = json::array();
  for (const json& question : json::parse(std::cin))
    answers.push_back(question.contains("page")
                          ? explorer::page_scene<Rational>(question.at("page"), question.at("values").get<std::vector<int>>(),
                                                           [](const Rational& x) { return CGAL::to_double(x); })
                          : character_numbers(question));
  std::cout << answers.dump(1) << '\n';
} catch (const std::exception& e) {
  std::cerr << "explorer_numbers: " << e.what() << '\n';
  return 1;
}
