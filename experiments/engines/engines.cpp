// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/engines.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>
#include <numbers>

#include "algorithms/results/result_file.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "experiments/over_time/exact_places.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/over_time/sampled_boxes.hpp"
#include "experiments/scenes/skinning_name.hpp"
#include "experiments/scenes/twist.hpp"

namespace refitlab {
namespace {

constexpr Skinning compared_skinnings[] = {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical};
// This share of a place's size is more than places in double may be off.
constexpr double error_of_places = 1e-11;
constexpr std::size_t most_keys = 100000;

std::vector<std::string> names_of_methods(bool of_clip) {
  std::vector<std::string> names = PoseMethods::methods();
  if (of_clip) names.insert(names.end(), clip_methods().begin(), clip_methods().end());
  return names;
}

class EngineExperiment {
 public:
  EngineExperiment(const Model& model, const EngineSettings& settings)
      : model_(model),
        sets_(model),
        volumes_(model),
        settings_(settings) {
    for (std::size_t c = 0; settings.unseen_clips && model.clips.size() > 1 && c < model.clips.size(); ++c)
      of_other_clips_.emplace_back(model, expected_poses(model, c));
    result_.model = model.name;
  }

  EngineResult run() {
    for (const Skinning skinning : compared_skinnings) {
      PoseMethods methods(model_, sets_, volumes_, skinning);
      for (std::size_t c = 0; c < model_.clips.size(); ++c) play(c, skinning, methods);
      twist(skinning, methods);
      measure_costs(skinning, methods);
    }
    return std::move(result_);
  }

 private:
  void play(std::size_t number, Skinning skinning, PoseMethods& methods) try {
    const Clip& clip = model_.clips[number];
    const PlayedClip played{key_times(clip.animation, most_keys), clip.sample};
    const std::vector<ClipBox> of_clip = clip_boxes(model_, played, methods);
    ExactPlaces exact(model_, clip.animation, skinning);
    std::vector<std::string> names = names_of_methods(true);
    const RoundedBoxes* const unseen = of_other_clips_.empty() ? nullptr : &of_other_clips_[number];
    if (unseen) names.push_back("rounded_boxes_of_other_clips");
    JointMatrices matrices(model_.joints.size());
    BoxMeasures measures(names, reference_method);
    for (int i = 0; i < settings_.times_per_clip; ++i) {
      const double time = clip.duration * i / std::max(1, settings_.times_per_clip - 1);
      const Pose pose = clip.sample(time);
      std::vector<Box<double>> boxes = methods.boxes(pose);
      for (const ClipBox& c : of_clip) boxes.push_back(c.box);
      if (unseen) matrices.set(pose), boxes.push_back(box_of<double>(with_room(box_of<double>(unseen->box(matrices)))));
      const Box<double> truth = methods.truth(pose);
      // If places are closer to a wall than doubles can tell, 60 digits decide.
      measures.add(truth, boxes, error_of_places * truth.greatest_coordinate(), [&](std::size_t m) {
        Verdict verdict = Verdict::holds;
        for (int v = 0; v < vertex_count(); ++v) verdict &= exact.is_in({v, time, Side::after}, box_of<float>(boxes[m]));
        return verdict;
      });
    }
    keep({clip.name, "clip", skinning, measures.measures()});
  } catch (const ModelError& e) {
    if (skinning == compared_skinnings[0]) result_.refused.push_back("clip '" + model_.clips[number].name + "': " + e.what());
  }

  // Measures poses with each joint turned about its bone by up to nearly half a turn.
  void twist(Skinning skinning, PoseMethods& methods) {
    BoxMeasures measures(names_of_methods(false), reference_method);
    for (std::size_t j = 0; j < model_.joints.size(); ++j)
      for (const double degrees : {90., 135., 170., 179.}) {
        const Pose pose = twist_pose(model_, static_cast<int>(j), degrees * std::numbers::pi / 180);
        const Box<double> truth = methods.truth(pose);
        const std::vector<Box<double>> boxes = methods.boxes(pose);
        const SkinningPalette<double> palette = make_skinning_palette(model_, sets_, pose, skinning);
        ExactSkin exact(model_, sets_, palette, skinning);
        // Of places closer to a wall than doubles can tell, rationals decide.
        measures.add(truth, boxes, error_of_places * truth.greatest_coordinate(), [&](std::size_t m) {
          for (int v = 0; v < vertex_count(); ++v)
            if (!exact.is_in(boxes[m], v)) return Verdict::fails;
          return Verdict::holds;
        });
      }
    keep({"every joint twisted", "twists", skinning, measures.measures()});
  }

  void keep(EnginePoses poses) {
    std::printf("  %-16s %-16s", table_name_of(poses.skinning), poses.name.c_str());
    for (const BoxMeasure& m : poses.measures) std::printf(" %s %.2f/%ld", m.method.c_str(), m.volume, m.misses);
    std::cout << std::endl;
    result_.poses.push_back(std::move(poses));
  }

  void measure_costs(Skinning skinning, PoseMethods& methods) {
    const Pose pose = model_.clips.empty() ? twist_pose(model_, twist_joint(model_), 2) : middle_pose();
    JointMatrices matrices(model_.joints.size());
    matrices.set(pose);
    std::vector<Timed> timed;
    for (std::size_t m = 0; m < PoseMethods::methods().size(); ++m)
      timed.push_back({PoseMethods::methods()[m], 1, [&, m] { benchmark::DoNotOptimize(methods.box(m, pose)); }});
    const std::string of_matrices = " of matrices";
    timed.push_back({"joint_boxes" + of_matrices, 1, [&] { benchmark::DoNotOptimize(volumes_.boxes.box(matrices)); }});
    timed.push_back({"joint_capsules" + of_matrices, 1, [&] { benchmark::DoNotOptimize(volumes_.capsules.box(matrices)); }});
    timed.push_back({"rounded_boxes" + of_matrices, 1, [&] { benchmark::DoNotOptimize(volumes_.rounded_boxes.box(matrices)); }});
    const auto times = ns_per_item(timed, settings_.speed);
    const auto& reference = PoseMethods::methods()[reference_method];
    for (const std::string& method : PoseMethods::methods()) {
      EngineCost cost{method, skinning, median(times.at(method)), median_ratio(times.at(method), times.at(reference))};
      if (const auto found = times.find(method + of_matrices); found != times.end()) {
        cost.ns_of_matrices = median(found->second);
        cost.ratio_of_matrices = median_ratio(found->second, times.at(reference + of_matrices));
      }
      std::printf("  %-16s %-16s %9.1f ns, %.2f of joint boxes; of matrices %.1f ns, %.2f\n", table_name_of(skinning),
                  cost.method.c_str(), cost.ns, cost.ratio, cost.ns_of_matrices, cost.ratio_of_matrices);
      result_.costs.push_back(std::move(cost));
    }
    std::cout << std::flush;
  }

  int vertex_count() const { return static_cast<int>(model_.vertices.size()); }

  Pose middle_pose() const {
    for (const Clip& clip : model_.clips) try {
        return clip.sample(clip.duration / 2);
      } catch (const ModelError&) {
      }
    return reference_pose(model_);
  }

  const Model& model_;
  const JointSets sets_;
  const JointVolumes volumes_;
  std::vector<RoundedBoxes> of_other_clips_;  // by clip: fitted to the others; of a model of one clip none
  const EngineSettings& settings_;
  EngineResult result_;
};

}  // namespace

EngineResult run_engines(const Model& made, const EngineSettings& settings) {
  const Model model = with_keys(made, settings.clips);
  return EngineExperiment(model, settings).run();
}

void write_engines(const std::vector<EngineResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "skinning", "kind"});
  for (const EngineResult& r : results) {
    const auto add = [&](const std::string& pose, const std::string& kind, const std::string& method, const char* quantity,
                         double value, const char* unit, const char* skinning) {
      file.add({"engines", r.model, pose, method, "all", quantity, format_number(value), unit, skinning, kind});
    };
    add("all", "model", "model", "refused_clips", static_cast<double>(r.refused.size()), "1", "all");
    for (const EnginePoses& p : r.poses)
      for (const BoxMeasure& m : p.measures) {
        const auto of_poses = [&](const char* quantity, double value) {
          add(p.name, p.kind, m.method, quantity, value, "1", table_name_of(p.skinning));
        };
        of_poses("poses", static_cast<double>(m.poses));
        of_poses("missed_poses", static_cast<double>(m.misses));
        of_poses("undecided", static_cast<double>(m.undecided));
        of_poses("unbounded", static_cast<double>(m.unbounded));
        if (m.unbounded == m.poses) continue;
        of_poses("miss_distance_over_box_side", m.missed_by);
        if (m.with_ratios() == 0) continue;
        of_poses("volume_ratio_to_true_box", m.volume);
        of_poses("area_ratio_to_true_box", m.area);
        of_poses("radius_ratio_to_true_box", m.radius);
        of_poses("volume_ratio_to_joint_boxes", m.to_reference);
      }
    for (const EngineCost& c : r.costs) {
      const auto of_cost = [&](const char* quantity, double value, const char* unit) {
        add("middle of the first clip", "cost", c.method, quantity, value, unit, table_name_of(c.skinning));
      };
      of_cost("ns_per_box", c.ns, "ns");
      of_cost("time_ratio_to_joint_boxes", c.ratio, "1");
      if (c.ns_of_matrices > 0) {
        of_cost("ns_per_box_from_matrices", c.ns_of_matrices, "ns");
        of_cost("time_ratio_to_joint_boxes_from_matrices", c.ratio_of_matrices, "1");
      }
    }
  }
  file.write(path);
}

}  // namespace refitlab
