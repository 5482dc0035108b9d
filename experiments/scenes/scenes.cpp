#include "experiments/scenes/scenes.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <numbers>

#include "algorithms/model/load.hpp"
#include "algorithms/model/procedural.hpp"

namespace refitlab {
namespace {

const char* const real_models[] = {"BCN_Epileptic.X", "Testwuson.X", "Soldier.glb", "leftHandHigh.glb"};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// From a joint towards the mean origin of its children, or away from its parent where it has none.
Point3 bone_axis(const Model& model, int joint) {
  Point3 sum = Point3::Zero();
  int children = 0;
  for (const Joint& j : model.joints)
    if (j.parent == joint) sum += j.origin, ++children;
  const Point3& origin = model.joints[joint].origin;
  Point3 axis = children ? Point3(sum / children - origin) : Point3(origin - model.joints[std::max(0, model.joints[joint].parent)].origin);
  return axis.norm() > 0 ? Point3(axis.normalized()) : Point3::UnitY();
}

}  // namespace

Model load_named(const std::string& path) {
  Model model = load_model(path);
  model.name = std::filesystem::path(path).filename().string();
  return model;
}

DefaultModels default_models(const std::string& folder) {
  DefaultModels out;
  out.models.push_back(make_man());
  out.models.push_back(make_creature());
  for (const char* file : real_models) {
    const std::string path = (std::filesystem::path(folder) / file).string();
    if (std::filesystem::exists(path))
      out.models.push_back(load_named(path));
    else
      out.absent.push_back(file);
  }
  return out;
}

Posture twist_posture(const Model& model, int joint, double radians) {
  const Point3 axis = bone_axis(model, joint) * std::sin(radians / 2);
  const Point3& origin = model.joints[joint].origin;
  RigidTransform<double> turn;
  turn.rotation = {std::cos(radians / 2), axis[0], axis[1], axis[2]};
  turn.translation = origin - rotate(turn.rotation, origin);
  Posture posture = reference_posture(model);
  std::vector<bool> below(model.joints.size());
  for (std::size_t j = 0; j < model.joints.size(); ++j) {  // parents come first
    const int parent = model.joints[j].parent;
    below[j] = static_cast<int>(j) == joint || (parent >= 0 && below[parent]);
    if (below[j]) posture[j] = turn;
  }
  return posture;
}

int twist_joint(const Model& model) {
  for (const char* part : {"neck", "hals", "head", "kopf", "wrist", "spine"})
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (lower(model.joints[j].name).find(part) != std::string::npos && model.joints[j].parent >= 0) return static_cast<int>(j);
  return static_cast<int>(model.joints.size() / 2);
}

std::vector<PostureSet> posture_sets(const Model& model, int times_per_clip) {
  std::vector<PostureSet> out;
  for (const Clip& clip : model.clips) {
    PostureSet set{clip.name, {}};
    for (int i = 0; i < times_per_clip; ++i)
      set.postures.push_back(clip.sample(clip.duration * i / std::max(1, times_per_clip - 1)));
    out.push_back(std::move(set));
  }
  return out;
}

NamedPosture figure_twist(const Model& model) {
  for (const Clip& clip : model.clips)
    if (clip.name == "twist") return {"full twist", clip.sample(clip.duration)};
  const int joint = twist_joint(model);
  return {model.joints[joint].name + " twisted by 170 degrees", twist_posture(model, joint, 170 * std::numbers::pi / 180)};
}

}  // namespace refitlab
