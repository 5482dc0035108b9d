// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/growth/triangles.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "algorithms/results/result_file.hpp"
#include "experiments/collisions/detectors.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/procedural/subdivide.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr const char* scene_names[] = {"far", "near", "light", "heavy"};
constexpr const char* reference = "skin_all_float";
constexpr const char* detectors[] = {
    "clusters",      "clusters_without_memory", "spherical_repaired", "control_mixed", "control_mixed_through_descendants",
    reference,       "skin_all_float_384",      "skin_all_float_512", "embree",        "floor_of_contacts",
    "floor_of_boxes"};

// The man is made with so many triangles, and then subdivided so many times.
struct Size {
  int triangles, subdivisions;
};

std::vector<Size> sizes(int most_subdivisions) {
  std::vector<Size> out{{1034, 0}, {2068, 0}, {4134, 0}, {8270, 0}, {16540, 0}, {8270, 1}, {8270, 2}, {8270, 3}, {16540, 3}};
  std::erase_if(out, [&](const Size& size) { return size.subdivisions > most_subdivisions; });
  return out;
}

Model make(const Size& size) {
  Model man = make_man(size.triangles);
  for (int i = 0; i < size.subdivisions; ++i) man = subdivide(man);
  man.name += " of " + std::to_string(man.triangles.size()) + " triangles";
  return man;
}

}  // namespace

std::vector<TriangleGrowth> run_triangle_growth(const TriangleGrowthSettings& settings) {
  std::vector<Scenario> scenes;
  for (Scenario& e : scenarios(bake_animated(make_man()), settings.frames))
    if (std::find(std::begin(scene_names), std::end(scene_names), e.name) != std::end(scene_names))
      scenes.push_back(std::move(e));
  std::vector<const DetectorKind*> kinds;
  for (const char* name : detectors) kinds.push_back(&detector_kind(name));

  std::vector<TriangleGrowth> rows;
  const auto all = sizes(settings.subdivisions);
  int begun = 0;
  for (const Size& size : all) {
    const auto man = bake_animated(make(size));
    const int triangles = static_cast<int>(man.mesh.triangles.size());
    std::cout << "[growth] " << man.mesh.name << ", " << man.sets.count() << " joint-sets (" << ++begun << "/" << all.size()
              << ")" << std::endl;
    for (const Scenario& scene : scenes) {
      PairLists expected;
      const auto first = detector_kind(reference).make(man);
      for (const ScenarioFrame& frame : scene.frames) {
        expected.push_back(first->pairs(frame, Query::full));
        std::sort(expected.back().begin(), expected.back().end());
      }
      for (const CollisionResult& r : measure(man, scene, Query::full, kinds, expected, settings.speed)) {
        rows.push_back({triangles, r});
        std::printf("  %-6s %-26s %7.1f pairs %10.1f us %9.1f nodes refitted %9.1f vertices skinned\n", r.scene.c_str(),
                    r.detector.c_str(), r.pairs, r.us_per_frame, r.nodes_refitted, r.vertices_skinned);
      }
    }
  }
  return rows;
}

void write_triangle_growth(const std::vector<TriangleGrowth>& rows, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "scene", "triangles"});
  for (const TriangleGrowth& r : rows) {
    const auto add = [&](const char* quantity, double value, const char* unit) {
      file.add({"triangle_growth", r.result.model, r.result.pose, r.result.detector, "all", quantity, format_number(value), unit,
                r.result.scene, std::to_string(r.triangles)});
    };
    add("us_per_frame", r.result.us_per_frame, "us");
    add("pairs", r.result.pairs, "1");
    // The one engine there is Embree.
    if (r.result.ratio_to_engine > 0) add("time_ratio_to_engine", r.result.ratio_to_engine, "1");
  }
  file.write(path);
}

}  // namespace refitlab
