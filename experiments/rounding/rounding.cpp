// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/rounding/rounding.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

std::vector<Pose> sampled_poses(const AnimatedCharacter& c, int count) {
  std::vector<Pose> out;
  const auto clips = static_cast<int>(c.clips.size());
  if (clips == 0) return {reference_pose(c.mesh)};
  for (int i = 0; i < count; ++i) {
    const Clip& clip = c.clips[i % clips];
    const double share = (i / clips + 0.3718) / ((count + clips - 1) / clips);  // no key times, where poses are simple
    out.push_back(clip.sample(share * clip.duration));
  }
  return out;
}

// VariantChecks are one variant's checks in one pose after the other.
class VariantChecks {
 public:
  VariantChecks(const AnimatedCharacter& c, const RefitVariant& variant, const RoundingSettings& settings)
      : c_(c),
        variant_(variant),
        vertices_(settings.vertices_per_node),
        random_(settings.seed) {
    result_.model = c.mesh.name, result_.variant = variant.name;
  }

  void add(const SkinningPalette<double>& palette, std::span<const Point3> skinned, ExactSkin& exact) {
    for (std::size_t i = 0; i < c_.tree.nodes.size(); ++i) {
      const int n = static_cast<int>(i);
      const RefitNode<double> node = c_.refit_node(n, palette, variant_.pieces);
      const Ball3<double> ball = variant_.refit(node), bare = variant_.refit_as_computed(node);
      const Ball3<float> small = rounded_outward(ball);
      const Ball3<double> of_floats{small.center.cast<double>(), small.radius};
      if (std::isfinite(ball.radius)) {
        inflations_.push_back(static_cast<float>((ball.radius - bare.radius) / bare.radius));
        float_inflations_.push_back(static_cast<float>((of_floats.radius - bare.radius) / bare.radius));
      }
      for (const int v : some_vertices(ball, c_.vertices[n], skinned)) {
        ++result_.checks;
        result_.misses += !exact.is_in(ball, v);
        result_.float_misses += !exact.is_in(of_floats, v);
        result_.misses_as_computed += !exact.is_in(bare, v);
      }
    }
  }

  RoundingResult result() {
    result_.inflation = median({inflations_.begin(), inflations_.end()});
    result_.float_inflation = median({float_inflations_.begin(), float_inflations_.end()});
    return result_;
  }

 private:
  const std::vector<int>& some_vertices(const Ball3<double>& ball, std::span<const int> all, std::span<const Point3> skinned) {
    const auto farther = [&](int a, int b) {
      return squared_distance(skinned[a], ball.center) < squared_distance(skinned[b], ball.center);
    };
    some_.assign(1, *std::max_element(all.begin(), all.end(), farther));
    std::sample(all.begin(), all.end(), std::back_inserter(some_), vertices_ - 1, random_);
    return some_;
  }

  const AnimatedCharacter& c_;
  const RefitVariant& variant_;
  const int vertices_;
  std::mt19937_64 random_;
  RoundingResult result_;
  std::vector<float> inflations_, float_inflations_;
  std::vector<int> some_;
};

// Returns the cost of all nodes with the slack over that without.
double cost_of(const AnimatedCharacter& c, const RefitVariant& variant, const SkinningPalette<double>& palette,
               const SpeedSettings& settings) {
  const auto all_nodes = [&](Refit refit) {
    return [&c, &variant, &palette, refit] {
      for (std::size_t n = 0; n < c.tree.nodes.size(); ++n)
        benchmark::DoNotOptimize(refit(c.refit_node(static_cast<int>(n), palette, variant.pieces)));
    };
  };
  const int count = static_cast<int>(c.tree.nodes.size());
  const auto times = ns_per_item(
      {{"certified", count, all_nodes(variant.refit)}, {"as computed", count, all_nodes(variant.refit_as_computed)}}, settings);
  return median_ratio(times.at("certified"), times.at("as computed"));
}

}  // namespace

std::vector<RoundingResult> run_rounding(const AnimatedCharacter& c, const NamedPose& timed, const RoundingSettings& settings) {
  const auto poses = sampled_poses(c, settings.poses);
  std::vector<RoundingResult> results;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
    std::vector<VariantChecks> checks;
    std::vector<const RefitVariant*> variants;
    for (const RefitVariant& v : compared_variants())
      if (v.sound && v.skinning == skinning) variants.push_back(&v), checks.emplace_back(c, v, settings);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      std::cout << "\r[rounding] " << c.mesh.name << ", " << variants.size() << " variants, pose " << i + 1 << " of "
                << poses.size() << "   " << std::flush;
      const auto palette = make_skinning_palette(c.mesh, c.sets, poses[i], skinning);
      const auto skinned = skin(c.mesh, c.sets, palette, skinning);
      ExactSkin exact(c.mesh, c.sets, palette, skinning);
      for (VariantChecks& v : checks) v.add(palette, skinned, exact);
    }
    const auto palette = make_skinning_palette(c.mesh, c.sets, timed.pose, skinning);
    for (std::size_t v = 0; v < variants.size(); ++v) {
      results.push_back(checks[v].result());
      results.back().cost = cost_of(c, *variants[v], palette, settings.speed);
    }
  }
  std::cout << '\n';
  for (const RoundingResult& r : results)
    std::printf("  %-30s %9ld exact checks, %ld misses (float %ld; without slack %ld), inflation %.1e (float %.1e), cost %.2f\n",
                r.variant.c_str(), r.checks, r.misses, r.float_misses, r.misses_as_computed, r.inflation, r.float_inflation,
                r.cost);
  return results;
}

void write_rounding(const std::vector<RoundingResult>& results, const RoundingSettings& settings, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit"});
  for (const RoundingResult& r : results) {
    const auto add = [&](const char* quantity, double value) {
      file.add({"rounding", r.model, "all", r.variant, "all", quantity, format_number(value), "1"}, settings.seed);
    };
    add("exact_checks", static_cast<double>(r.checks));
    add("missed_vertices", static_cast<double>(r.misses));
    add("missed_vertices_in_float", static_cast<double>(r.float_misses));
    add("missed_vertices_without_slack", static_cast<double>(r.misses_as_computed));
    add("inflation_median", r.inflation);
    add("float_inflation_median", r.float_inflation);
    add("time_ratio_to_without_slack", r.cost);
  }
  file.write(path);
}

}  // namespace refitlab
