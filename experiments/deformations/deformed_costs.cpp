// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deformed_costs.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <memory>

#include "algorithms/runtime/refit/frame_refits.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr Skinning timed_skinnings[] = {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion};
constexpr double shares[] = {0.25, 0.75};  // of the first clip
constexpr const char* kept = " (kept)";
constexpr DeformationKind deformed_kinds[] = {scaled_kind, scaled_along_axes_kind, morphed_kind, both_kind};

// Refits all nodes in the first two of these poses by turns. The deformation is made anew for each, unless it is kept.
class Refitted {
 public:
  Refitted(const Character& c, const std::vector<DeformedPose>& poses, const RefitVariant& variant, bool is_kept)
      : frame_(c, variant),
        reference_(c, variant.pieces),
        is_rigid_(poses[0].scales.empty() && poses[0].weights.empty()) {
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = frame_of(c, poses[i], variant.skinning);
    if (is_kept) now_[1].deformation = now_[0].deformation;
  }

  void refit() {
    const DeformedFrame& now = now_[++count_ % now_.size()];
    if (!is_rigid_) reference_.begin(now.deformation);
    frame_.begin(now.palette, is_rigid_ ? nullptr : &reference_);
    frame_.refit_all();
    benchmark::DoNotOptimize(frame_[0]);
  }

 private:
  FrameRefits frame_;
  DeformedReference reference_;
  const bool is_rigid_;
  std::array<DeformedFrame, 2> now_;
  std::size_t count_ = 0;
};

Timed timed(const std::string& name, const Character& c, const std::vector<DeformedPose>& poses, const RefitVariant& variant,
            bool is_kept) {
  const auto refitted = std::make_shared<Refitted>(c, poses, variant, is_kept);
  return {name, static_cast<int>(c.tree.nodes.size()), [refitted] { refitted->refit(); }};
}

Timed timed(const AnimatedCharacter& c, const DeformationKind& kind, const RefitVariant& variant, bool is_kept) {
  return timed(std::string(kind.name) + (is_kept ? kept : ""), c, deformed_poses(c, kind, shares), variant, is_kept);
}

}  // namespace

std::vector<DeformedCost> deformed_costs(const DeformingCharacters& characters, const SpeedSettings& settings) {
  std::vector<DeformedCost> out;
  for (const Skinning skinning : timed_skinnings) {
    const RefitVariant& variant = default_variant(skinning);
    std::vector<Timed> calls{timed(characters.of(rigid_kind), rigid_kind, variant, false)};
    for (const DeformationKind& kind : deformed_kinds)
      for (const bool is_kept : {false, true}) calls.push_back(timed(characters.of(kind), kind, variant, is_kept));
    const auto times = ns_per_item(calls, settings);
    const auto& rigid = times.at(rigid_kind.name);
    for (const DeformationKind& kind : deformed_kinds) {
      const auto &changing = times.at(kind.name), &staying = times.at(std::string(kind.name) + kept);
      out.push_back({kind.name, variant.name, median(changing), median_ratio(changing, rigid), median_ratio(staying, rigid)});
      std::printf("  %-22s %-18s %7.1f ns per sphere, %.2f of a rigid refit; %.2f where the deformation stays\n",
                  variant.name.c_str(), kind.name, out.back().ns_per_sphere, out.back().to_rigid, out.back().to_rigid_kept);
    }
    std::fflush(stdout);
  }
  return out;
}

std::vector<ReducedCost> reduced_costs(const ReducedCharacter& character, const SpeedSettings& settings) {
  std::vector<DeformedPose> poses;
  for (const std::size_t frame : {std::size_t(0), character.basis.coordinates.size() - 1})
    poses.push_back({reference_pose(character.ours.mesh), {}, {}, character.basis.coordinates[frame]});
  const RefitVariant &balls = reference_balls(), &mixed = default_variant(Skinning::spherical);
  const auto times =
      ns_per_item({timed("bd_tree", character.bd_tree, poses, balls, false),
                   timed("smallest", character.ours, poses, balls, false), timed("mixed", character.ours, poses, mixed, false)},
                  settings);
  std::vector<ReducedCost> out;
  const auto add = [&](const char* name, const RefitVariant& variant, DisplacementBalls of) {
    out.push_back({variant.name, of, median(times.at(name)), median_ratio(times.at(name), times.at("bd_tree"))});
    std::printf("  reduced: %-10s %-16s %7.1f ns per sphere, %.2f of BD-tree\n", name, variant.name.c_str(),
                out.back().ns_per_sphere, out.back().to_bd_tree);
  };
  add("bd_tree", balls, DisplacementBalls::bd_tree);
  add("smallest", balls, DisplacementBalls::smallest);
  add("mixed", mixed, DisplacementBalls::smallest);
  std::fflush(stdout);
  return out;
}

}  // namespace refitlab
