// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/growth/joints.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/methods.hpp"

namespace refitlab {
namespace {

JointGrowth measure(int joints, const SpeedSettings& speed) {
  const auto snake = bake_animated(make_snake(joints));
  const Method& below = method(default_variant(Skinning::spherical).name + "_through_descendants");
  const RefitVariant& variant = *below.variant;
  const auto palette = make_skinning_palette(snake.mesh, snake.sets, snake.clips[0].sample(0.5), variant.skinning);
  std::vector<int> many;
  for (std::size_t n = 0; n < snake.tree.nodes.size(); ++n)
    if (snake.tree.nodes[n].piece_count > below.options.most_joint_sets && snake.tree.nodes[n].child_count > 0)
      many.push_back(static_cast<int>(n));

  FrameRefits own(snake, variant), through_descendants(snake, variant, below.options);
  std::vector<Timed> timed;
  for (auto& [name, frame] : {std::pair("own", &own), std::pair("through_descendants", &through_descendants)}) {
    timed.push_back({std::string(name) + "_root", 1, [&palette, frame = frame] {
                       frame->begin(palette);
                       benchmark::DoNotOptimize((*frame)[0]);
                     }});
    if (!many.empty())
      timed.push_back({name, 1, [&palette, &many, frame = frame] {
                         frame->begin(palette);
                         for (const int n : many) benchmark::DoNotOptimize((*frame)[n]);
                       }});
  }
  through_descendants.begin(palette);
  through_descendants.refit_all();
  std::vector<Ball3<double>> cut;
  for (const int n : through_descendants.cut(0)) cut.push_back(through_descendants[n]);
  if (!cut.empty()) timed.push_back({"known", 1, [&cut] { benchmark::DoNotOptimize(few_balls_ball(cut)); }});
  const auto times = ns_per_item(timed, speed);
  const auto time = [&](const char* name) { return times.count(name) ? median(times.at(name)) : 0.0; };
  JointGrowth out{joints,
                  snake.sets.count(),
                  static_cast<int>(many.size()),
                  time("own"),
                  time("through_descendants"),
                  time("own_root"),
                  time("through_descendants_root"),
                  time("known"),
                  0,
                  0};
  const auto deformed = skin(snake.mesh, snake.sets, palette, variant.skinning);
  const double optimal = as_ball(smallest_ball<double, 3>(deformed)).radius;
  out.root_ratio = own[0].radius / optimal;
  out.root_ratio_through_descendants = through_descendants[0].radius / optimal;
  return out;
}

}  // namespace

std::vector<JointGrowth> run_joint_growth(const SpeedSettings& settings) {
  std::vector<JointGrowth> rows;
  for (const int joints : {10, 30, 100, 300, 1000}) {
    std::cout << "[growth] a snake of " << joints << " joints; the last will have 1000" << std::endl;
    rows.push_back(measure(joints, settings));
    const JointGrowth& r = rows.back();
    std::printf(
        "  %4d joint-sets, %3d nodes of many: %7.1f us in all, %7.1f from below; the root %7.1f us, %7.1f from below, %5.1f if "
        "the frame "
        "knows its cut; %.3f and %.3f times optimal\n",
        r.joint_sets, r.many, r.own / 1000, r.through_descendants / 1000, r.own_root / 1000, r.root_through_descendants / 1000,
        r.root_from_known / 1000, r.root_ratio, r.root_ratio_through_descendants);
  }
  return rows;
}

void write_joint_growth(const std::vector<JointGrowth>& rows, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "joints"});
  for (const JointGrowth& r : rows) {
    const auto add = [&](const char* variant, const char* quantity, double value, const char* unit) {
      file.add({"joint_growth", "snake of " + std::to_string(r.joints) + " joints", "wave", variant, "all", quantity,
                format_number(value), unit, std::to_string(r.joints)});
    };
    add("own", "joint_sets", r.joint_sets, "1");
    add("own", "nodes_of_many_joint_sets", r.many, "1");
    if (r.many > 0) {
      add("own", "ns_of_nodes_of_many", r.own, "ns");
      add("through_descendants", "ns_of_nodes_of_many", r.through_descendants, "ns");
      add("through_descendants", "ns_of_root_from_known_cut", r.root_from_known, "ns");
    }
    add("own", "ns_of_root", r.own_root, "ns");
    add("through_descendants", "ns_of_root", r.root_through_descendants, "ns");
    add("own", "radius_ratio_to_optimal_of_root", r.root_ratio, "1");
    add("through_descendants", "radius_ratio_to_optimal_of_root", r.root_ratio_through_descendants, "1");
  }
  file.write(path);
}

}  // namespace refitlab
