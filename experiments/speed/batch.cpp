// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/batch.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

struct Kind {
  std::string name;
  Skinning skinning;
};
const Kind kinds[] = {
    {"linear", Skinning::linear}, {"spherical", Skinning::spherical}, {"dual_quaternion", Skinning::dual_quaternion}};

class BatchExperiment {
 public:
  BatchExperiment(const AnimatedCharacter& c, const NamedPose& pose, const SpeedSettings& settings)
      : c_(c),
        pose_(pose),
        settings_(settings),
        packed_(c.mesh, c.sets),
        batch_(c.tree, c.sets) {}

  std::vector<BatchSpeed> run() {
    for (const Kind& kind : kinds) skin(kind);
    for (const Kind& kind : {kinds[0], kinds[1]}) refit(kind);
    compare_refits();
    palette();
    return std::move(results_);
  }

 private:
  void skin(const Kind& kind) {
    const auto palette = palette_of(kind);
    const auto expected = refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning);
    std::vector<Point3> out(expected.size());
    std::vector<Timed> timed{{"scalar", size_of(expected),
                              [&] { benchmark::DoNotOptimize(refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning)); }}};
    for (const Target target : available_targets()) {
      packed_.skin_all(palette, kind.skinning, out, target);
      if (out != expected) fail("skinning, " + kind.name + ", is not bit-identical", name_of(target));
      timed.push_back({name_of(target), size_of(expected), [&, target] {
                         packed_.skin_all(palette, kind.skinning, out, target);
                         benchmark::DoNotOptimize(out.data());
                       }});
    }
    measure("skin_" + kind.name, "vertex", timed);
  }

  void refit(const Kind& kind) {
    const auto palette = palette_of(kind);
    const bool is_linear = kind.skinning == Skinning::linear;
    const RefitVariant& variant = compared_variant(is_linear ? "linear" : "spherical_repaired");
    std::vector<Timed> timed{{"scalar", size_of(c_.tree.nodes), [&] {
                                for (int n = 0; n < size_of(c_.tree.nodes); ++n)
                                  benchmark::DoNotOptimize(variant.refit(c_.tree.refit_node(n, palette)));
                              }}};
    const auto refit_all = [&, is_linear](Target target) -> const PackedBalls& {
      return is_linear ? batch_.linear(palette, target) : batch_.spherical(palette, target);
    };
    for (const Target target : available_targets()) {
      const PackedBalls& balls = refit_all(target);
      require_no_miss(
          kind, [&](int n) { return balls[n]; }, palette, name_of(target));
      timed.push_back({name_of(target), size_of(c_.tree.nodes), [&, target] { benchmark::DoNotOptimize(refit_all(target)[0]); }});
    }
    measure("refit_" + kind.name, "sphere", timed);
  }

  void palette() {
    SkinningPalette<double> palette;
    const auto prepare = [&] {
      make_skinning_palette(c_.mesh, c_.sets, pose_.pose, Skinning::spherical, palette);
      benchmark::DoNotOptimize(palette.size());
    };
    measure("skinning_palette", "joint_set", {{"scalar", c_.sets.count(), prepare}});
  }

  template <class Balls>
  void require_no_miss(const Kind& kind, const Balls& balls, const SkinningPalette<double>& palette,
                       const std::string& how) const {
    const auto deformed = refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning);
    for (int n = 0; n < size_of(c_.tree.nodes); ++n) {
      const Ball3<float> ball = balls(n);
      for (const int v : c_.vertices[n])
        if (!((deformed[v] - ball.center.cast<double>()).norm() <= ball.radius))
          fail("refit, " + kind.name + ": node " + std::to_string(n) + " misses vertex " + std::to_string(v), how);
    }
  }

  void measure(const std::string& what, const std::string& item, const std::vector<Timed>& timed) {
    const auto times = ns_per_item(timed, settings_);
    for (const Timed& t : timed) {
      results_.push_back({c_.mesh.name, pose_.name, what, t.name, item, median(times.at(t.name)),
                          median_ratio(times.at(t.name), times.at("scalar")), 0});
      const BatchSpeed& r = results_.back();
      std::printf("  %-22s %-9s %8.2f ns per %s, 1/%.1f of scalar\n", what.c_str(), r.how.c_str(), r.ns, item.c_str(),
                  1 / r.ratio);
    }
  }

  // Compares spherical with linear refits, done in the same way.
  void compare_refits() {
    for (BatchSpeed& r : results_)
      for (const BatchSpeed& linear : results_)
        if (r.item == "sphere" && linear.what == "refit_linear" && linear.how == r.how) r.to_linear = r.ns / linear.ns;
  }

  SkinningPalette<double> palette_of(const Kind& kind) const {
    return make_skinning_palette(c_.mesh, c_.sets, pose_.pose, kind.skinning);
  }
  template <class T>
  static int size_of(const std::vector<T>& list) {
    return static_cast<int>(list.size());
  }
  [[noreturn]] void fail(const std::string& what, const std::string& how) const {
    throw std::logic_error("batch: " + c_.mesh.name + ": " + what + ", by " + how);
  }

  const AnimatedCharacter& c_;
  const NamedPose& pose_;
  const SpeedSettings settings_;
  PackedVertices packed_;
  BatchRefit batch_;
  std::vector<BatchSpeed> results_;
};

}  // namespace

std::vector<BatchSpeed> run_batch_speed(const AnimatedCharacter& c, const NamedPose& pose, const SpeedSettings& settings) {
  std::cout << "[speed] in batches: " << c.mesh.name << ", " << pose.name << std::endl;
  return BatchExperiment(c, pose, settings).run();
}

void write_batch_speed(const std::vector<BatchSpeed>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "operation"});
  for (const BatchSpeed& r : results) {
    const auto add = [&](const std::string& quantity, double value, const char* unit) {
      file.add({"batch_speed", r.model, r.pose, r.how, "all", quantity, format_number(value), unit, r.what});
    };
    add("ns_per_" + r.item, r.ns, "ns");
    add("time_ratio_to_scalar", r.ratio, "1");
    if (r.to_linear > 0) add("time_ratio_to_linear", r.to_linear, "1");
  }
  file.write(path);
}

}  // namespace refitlab
