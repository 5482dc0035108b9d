// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "algorithms/program/guarded_load.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/real_models.hpp"

namespace refitlab {

Model load_named(const std::string& path, const LoadOptions& options) {
  Model model = load_model_guarded(path, options);
  model.name = std::filesystem::path(path).filename().string();
  return model;
}

DefaultModels default_models(const std::string& folder) {
  DefaultModels out;
  out.models.push_back(make_man());
  out.models.push_back(make_creature());
  for (const char* file : real_models) {
    const std::string path = (std::filesystem::path(folder) / file).string();
    if (std::filesystem::exists(path)) out.models.push_back(load_named(path));
    else out.absent.push_back(file);
  }
  return out;
}

std::vector<PoseSet> pose_sets(const AnimatedCharacter& character, int times_per_clip) {
  std::vector<PoseSet> out;
  for (const Clip& clip : character.clips) {
    PoseSet set{clip.name, {}};
    for (int i = 0; i < times_per_clip; ++i)
      set.poses.push_back(clip.sample(clip.duration * i / std::max(1, times_per_clip - 1)));
    out.push_back(std::move(set));
  }
  return out;
}

NamedPose figure_twist(const AnimatedCharacter& character) {
  for (const Clip& clip : character.clips)
    if (clip.name == "twist") return {"full twist", clip.sample(clip.duration)};
  const int joint = twist_joint(character.mesh);
  return {character.mesh.joints[joint].name + " twisted by 170 degrees",
          twist_pose(character.mesh, joint, 170 * std::numbers::pi / 180)};
}

}  // namespace refitlab
