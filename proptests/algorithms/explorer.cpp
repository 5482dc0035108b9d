// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what the explorer shows of a character, the models that are packed for it, and its pages of lemmas.
#include "experiments/explorer/explorer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/explorer/packed_model.hpp"
#include "experiments/explorer/pages/all.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/twist.hpp"
#include "experiments/tightness/misses.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_explorer {
namespace {

using namespace refitlab;
using nlohmann::json;

// Makes an explorer that has a man of few triangles, whose name is "few".
Explorer explorer_of_few() {
  Model model = make_man(400);
  model.name = "few";
  Explorer explorer;
  explorer.add(pack(model));
  return explorer;
}

ExplorerSettings settings_of_few(const AnimatedCharacter& character) {
  const auto& joints = character.mesh.joints;
  const auto waist = std::find_if(joints.begin(), joints.end(), [](const Joint& joint) { return joint.name == "waist"; });
  return {.model = "few",
          .variant = "spherical_repaired",
          .clip = "walk",
          .time = 0.3,
          .joint = static_cast<int>(waist - joints.begin()),
          .twist = 170 * std::numbers::pi / 180,
          .level = 5,
          .ball = 0};
}

void views_of_a_pose(Suite& t) {
  t.example("a view has the joints and the vertices where the pose of the clip, with its twist, has them", {}, [] {
    Explorer explorer = explorer_of_few();
    const AnimatedCharacter& c = explorer.character("few");
    const ExplorerSettings settings = settings_of_few(c);
    const ExplorerView view = explorer.view(settings);
    const auto walk = std::find_if(c.clips.begin(), c.clips.end(), [](const Clip& clip) { return clip.name == "walk"; });
    const Pose pose = twisted(c.mesh, walk->sample(settings.time), settings.joint, settings.twist);
    if (view.joints.size() != pose.size()) return Checked(false, 0, "not all joints");
    long moved = 0;
    double farthest = 0;
    for (std::size_t j = 0; j < pose.size(); ++j) {
      const Point3& origin = c.mesh.joints[j].origin;
      const Point3 at = rotate(pose[j].rotation, origin) + pose[j].translation;
      farthest = std::max(farthest, (view.joints[j] - at).norm());
      moved += (view.joints[j] - origin).norm() > 0.01;
    }
    const auto palette = make_skinning_palette(c.mesh, c.sets, pose, Skinning::spherical);
    const auto vertices = skin(c.mesh, c.sets, palette, Skinning::spherical);
    for (std::size_t v = 0; v < vertices.size(); ++v) farthest = std::max(farthest, (view.vertices.at(v) - vertices[v]).norm());
    return Checked(moved > 10 && farthest < 1e-9, moved, std::to_string(farthest));
  });
  t.example("of the ball that is looked at a view has its own vertices, their smallest ball, and the variant's radius", {}, [] {
    Explorer explorer = explorer_of_few();
    const AnimatedCharacter& c = explorer.character("few");
    ExplorerSettings settings = settings_of_few(c);
    const std::vector<int> nodes = nodes_of_level(c.tree, settings.level);
    std::string wrong;
    std::set<double> radii;
    for (int ball = 0; ball < static_cast<int>(nodes.size()); ++ball) {
      settings.ball = ball;
      const ExplorerView view = explorer.view(settings);
      std::vector<Point3> points;
      for (const int v : c.vertices[nodes[static_cast<std::size_t>(ball)]])
        points.push_back(view.vertices[static_cast<std::size_t>(v)]);
      const double optimal = std::sqrt(smallest_ball<double, 3>(points).squared_radius);
      radii.insert(optimal);
      const Ball3<double>& own = view.balls.at(static_cast<std::size_t>(ball));
      const auto chosen = std::find_if(view.summaries.begin(), view.summaries.end(),
                                       [&](const VariantSummary& s) { return s.variant == settings.variant; });
      if (view.ball != ball || view.ball_vertices != static_cast<int>(points.size()) ||
          std::abs(view.ball_optimal - optimal) > 1e-12 || chosen == view.summaries.end() || chosen->ball_radius != own.radius ||
          chosen->balls != static_cast<int>(nodes.size()))
        wrong += "ball " + std::to_string(ball) + "; ";
    }
    return Checked(wrong.empty() && radii.size() > 3, static_cast<long>(nodes.size()), wrong);
  });
  t.example(
      "a view as the page opens says how far the printed algorithm leaves a vertex outside, and of how many it does", {}, [] {
        Explorer explorer;
        const AnimatedCharacter& c = explorer.character("man");
        ExplorerSettings settings = settings_of_few(c);
        settings.model = "man", settings.variant = "spherical_printed_signed", settings.clip = "", settings.time = 0,
        settings.level = std::min(13, c.tree.level_count());
        const ExplorerView view = explorer.view(settings);
        const std::vector<int> nodes = nodes_of_level(c.tree, settings.level);
        const double tolerance = miss_tolerance * c.tree.nodes[0].reference.radius;
        double worst = 0;
        std::set<int> outside;
        for (std::size_t b = 0; b < nodes.size(); ++b) {
          const Ball3<double>& ball = view.balls.at(b);
          if (!(ball.radius >= 0)) continue;
          for (const int v : c.vertices[nodes[b]])
            if (const double by = (view.vertices[static_cast<std::size_t>(v)] - ball.center).norm() - ball.radius; by > tolerance)
              worst = std::max(worst, by), outside.insert(v);
        }
        std::string wrong;
        for (const VariantSummary& s : view.summaries)
          if (s.variant == settings.variant &&
              (std::abs(s.worst_miss - worst) > 1e-12 || s.vertices_outside != static_cast<int>(outside.size())))
            wrong += std::to_string(s.worst_miss) + " for " + std::to_string(worst);
        return Checked(wrong.empty() && !outside.empty() &&
                           std::count(view.outside.begin(), view.outside.end(), true) == static_cast<long>(outside.size()),
                       static_cast<long>(outside.size()), wrong);
      });
}

// Returns which parts of a model differ when it is unpacked, but for rounding, and for names of which there are two.
std::string other_in(const Model& model, const Model& unpacked) {
  std::string wrong;
  const auto near = [](const auto& a, const auto& b) { return (a - b).norm() < 1e-5; };
  if (model.joints.size() != unpacked.joints.size() || model.clips.size() != unpacked.clips.size()) return "as many of them";
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint &a = model.joints[j], &b = unpacked.joints[j];
    if (a.parent != b.parent || !b.name.starts_with(a.name) || !near(a.origin, b.origin)) wrong += "joint " + a.name + "; ";
  }
  for (std::size_t i = 0; i < model.clips.size(); ++i) {
    const Clip &a = model.clips[i], &b = unpacked.clips[i];
    if (a.duration != b.duration || !b.name.starts_with(a.name)) wrong += "clip " + a.name + "; ";
    // Sampling shows the nearest of 24 poses a second. No time is in the middle between two of them.
    const double steps = std::clamp(std::ceil(a.duration * 24), 1., 120.);
    for (int k = 0; k <= 47; ++k) {
      const double time = a.duration * k / 47;
      const Pose shown = b.sample(time), expected = a.sample(std::round(steps * k / 47) * a.duration / steps);
      for (std::size_t j = 0; j < shown.size(); ++j)
        if (!near(shown[j].rotation, expected[j].rotation) || !near(shown[j].translation, expected[j].translation))
          return wrong + "a pose of " + a.name;
    }
  }
  return wrong;
}

void packed_models(Suite& t) {
  t.example("a packed model has the joints below the same ones, and the clips with their poses", {}, [] {
    const Model model = make_man(400);
    const Model unpacked = unpack(pack(model));
    std::string wrong = other_in(model, unpacked);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (unpacked.joints[j].name != model.joints[j].name) wrong += "a name; ";
    return Checked(wrong.empty(), static_cast<long>(model.joints.size()), wrong);
  });
  t.example("joints and clips of one name have names of their own when they are unpacked", {}, [] {
    Model model = make_man(400);
    const char* const names[] = {"bone", "bone #4", "bone", "bone", "bone"};
    for (std::size_t j = 0; j < 5; ++j) model.joints[j].name = names[j];
    for (Clip& clip : model.clips) clip.name = "clip";
    const Model unpacked = unpack(pack(model));
    std::string wrong = other_in(model, unpacked);
    std::set<std::string> of_joints, of_clips;
    for (const Joint& joint : unpacked.joints) of_joints.insert(joint.name);
    for (const Clip& clip : unpacked.clips) of_clips.insert(clip.name);
    if (of_joints.size() != model.joints.size() || of_clips.size() != model.clips.size()) wrong += "a name twice; ";
    if (unpacked.joints[0].name != "bone" || unpacked.clips[0].name != "clip" || unpacked.clips[1].name != "clip #2")
      wrong += "names; ";
    return Checked(wrong.empty() && model.clips.size() > 1, 2, wrong);
  });
}

json scene_of(const std::string& page, const explorer::Values& values) {
  return explorer::page_scene<Rational>(page, values, [](const Rational& x) { return CGAL::to_double(x); });
}

void pages_of_lemmas(Suite& t) {
  t.example("a slider says its angle in degrees, its tenths and its number", {}, [] {
    using namespace refitlab::explorer;
    return circle_text(0) == "0°" && circle_text(4) == "37°" && circle_text(12) == "90°" && circle_text(half_turn) == "180°" &&
           tenths_text(-5) == "−0.5" && tenths_text(0) == "0.0" && tenths_text(12) == "1.2" && tenths_text(-30) == "−3.0" &&
           plain_text(7) == "7";
  });
  t.example("on the pages of lemmas no repaired statement fails, and of each page a printed one does",
            {.number_type = "rational"}, [] {
              long tried = 0;
              std::string wrong;
              for (const auto& live : explorer::live_pages<Rational>()) {
                const explorer::Page& page = live.page;
                std::vector<explorer::Values> all;
                for (const explorer::Preset& preset : page.presets) all.push_back(preset.values);
                for (std::size_t s = 0; s < page.sliders.size(); ++s)
                  for (int k = 0; k <= 4; ++k) {
                    all.emplace_back();
                    for (const explorer::Slider& slider : page.sliders) all.back().push_back(slider.start);
                    all.back()[s] = page.sliders[s].low + (page.sliders[s].high - page.sliders[s].low) * k / 4;
                  }
                bool is_refuted = false;
                for (const explorer::Values& values : all) {
                  const json scene = scene_of(page.id, values);
                  if (scene["texts"].size() != page.sliders.size()) wrong += page.id + ": texts; ";
                  for (const json& verdict : scene["verdicts"]) {
                    const bool holds = verdict["verdict"] == "holds";
                    if (verdict["form"] == "repaired" && !holds)
                      wrong += page.id + ": " + verdict["says"].get<std::string>() + "; ";
                    is_refuted = is_refuted || (verdict["form"] == "printed" && !holds);
                    ++tried;
                  }
                }
                if (!is_refuted) wrong += page.id + ": no printed statement fails; ";
              }
              return Checked(wrong.empty(), tried, wrong);
            });
  t.example("the point of the page of Lemma 5 goes from the apex of each cap to its rim, and no farther",
            {.number_type = "rational"}, [] {
              long tried = 0, wrong = 0;
              for (int angle = 0; angle <= explorer::half_turn; ++angle) {
                double last = 1;
                for (int place = 0; place <= 10; ++place, ++tried) {
                  const json scene = scene_of("lemma5", {angle, place});
                  const json& at = scene["points"].back()["at"];
                  const double along = (2 * at[0].get<double>() + 2 * at[1].get<double>() + at[2].get<double>()) / 3,
                               cosine = scene["caps"][0]["cos"];
                  wrong += scene["points"].back()["label"] != "x" || along > last + 1e-12 || along < cosine - 1e-12 ||
                           (place == 0 && along < 1 - 1e-12) || (place == 10 && along > cosine + 1e-12);
                  last = along;
                }
              }
              return Checked(wrong == 0, tried, std::to_string(wrong) + " are elsewhere");
            });
}

}  // namespace

PROPTEST(explorer) {
  views_of_a_pose(t);
  packed_models(t);
  pages_of_lemmas(t);
}

}  // namespace proptests::suite_explorer
