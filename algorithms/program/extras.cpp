// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/extras.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "algorithms/program/bound_json.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/json_splice.hpp"
#include "algorithms/runtime/packs/float_above.hpp"

namespace refitlab {
namespace {

using Json = nlohmann::ordered_json;

constexpr int extras_version = 1;

Json header(const ModelBounds& bounds, const ModelBoundsOptions& options) {
  Json out = {{"version", extras_version}, {"skinning", name_of(bounds.skinning)}, {"tolerance", options.tolerance}};
  if (!bounds.crossfades.empty()) {
    out["crossfade_tolerance"] = options.crossfade_tolerance;
    out["rotations"] = name_of(bounds.rotations);
  }
  if (Json directions = json_of_directions<Json>(bounds.dop); !directions.empty()) out["directions"] = std::move(directions);
  return out;
}

// Returns the bounds in an animation or a crossfade: that of the whole, and those of skins, meshes and primitives.
Json json_of_parts(const Model& model, const ModelBounds& bounds, const std::vector<BoundedPart>& bounded) {
  Json skins = Json::array(), meshes = Json::array(), primitives = Json::array();
  Json out = Json::object();
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    const ModelPart& part = bounds.parts[p];
    Json bound = json_of_bound<Json>(bounded[p]);
    const auto with = [&](Json of) { return of.update(bound), of; };
    if (part.kind == PartKind::whole) out = bound;
    if (part.kind == PartKind::skin) skins.push_back(with({{"skin", part.index}}));
    if (part.kind == PartKind::mesh) meshes.push_back(with({{"mesh", part.index}}));
    if (part.kind == PartKind::primitive && part.index >= 0) {
      const SourcePrimitive& source = model.sources[part.index];
      primitives.push_back(with({{"node", source.node}, {"mesh", source.mesh}, {"primitive", source.primitive}}));
    }
  }
  out["skins"] = skins, out["meshes"] = meshes, out["primitives"] = primitives;
  return out;
}

// Returns the bounds in a clip, and those while it fades to each other clip.
Json json_of_clip(const Model& model, const ModelBounds& bounds, int clip) {
  Json out = json_of_parts(model, bounds, bounds.clips[clip].parts);
  for (const BoundedCrossfade& fade : bounds.crossfades) {
    if (fade.first != clip && fade.second != clip) continue;
    Json json = {{"animation", fade.first == clip ? fade.second : fade.first}};
    json.update(json_of_parts(model, bounds, fade.parts));
    out["crossfades"].push_back(json);
  }
  return out;
}

JsonEdit& element(JsonEdit& of, const char* array, std::size_t index) { return of.members[array].elements[index]; }
JsonEdit& bounds_in(JsonEdit& of) { return of.members["extras"].members["refitlab"]; }

// Returns what removes the bounds that a file has, which may be those of another scene.
JsonEdit without_bounds(const std::string& json) {
  JsonEdit out;
  const Json whole = Json::parse(json);
  const auto count = [](const Json& of, const char* array) {
    const auto found = of.find(array);
    return found != of.end() && found->is_array() ? found->size() : 0;
  };
  for (const char* array : {"skins", "animations"})
    for (std::size_t i = 0; i < count(whole, array); ++i) bounds_in(element(out, array, i)).is_removed = true;
  for (std::size_t m = 0; m < count(whole, "meshes"); ++m) {
    JsonEdit& mesh = element(out, "meshes", m);
    bounds_in(mesh).is_removed = true;
    for (std::size_t p = 0; p < count(whole["meshes"][m], "primitives"); ++p)
      bounds_in(element(mesh, "primitives", p)).is_removed = true;
  }
  return out;
}

}  // namespace

std::string with_extras(const std::string& json, const Model& model, const ModelBounds& bounds, const ModelBoundsOptions& options,
                        const std::string& file) {
  JsonEdit edit = without_bounds(json);
  const auto add = [&](JsonEdit& of, const Json& value) {
    Json whole = header(bounds, options);
    whole.update(value);
    bounds_in(of) = {whole.dump()};
  };
  const std::vector<BoundedPart> all = bounds_of_all(bounds);
  const auto json_of_part = [&](std::size_t p) {
    Json json = json_of_bound<Json>(all[p]);
    if (!bounds.any_pose.empty())
      if (const auto& any = bounds.any_pose[p])
        json["any_pose"] = {{"node", model.skeleton.nodes[any->node].source},
                            {"radius", static_cast<double>(float_above(any->radius))}};
    return json;
  };
  // A primitive that several nodes show has one place in the file, which gets a bound for all of them.
  std::map<std::pair<int, int>, std::vector<BoundedPart>> primitives;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    const ModelPart& part = bounds.parts[p];
    const auto index = static_cast<std::size_t>(part.index);
    if (part.kind == PartKind::skin) add(element(edit, "skins", index), json_of_part(p));
    if (part.kind == PartKind::mesh) add(element(edit, "meshes", index), json_of_part(p));
    if (part.kind == PartKind::primitive && part.index >= 0) {
      const SourcePrimitive& source = model.sources[index];
      primitives[{source.mesh, source.primitive}].push_back(all[p]);
    }
  }
  for (const auto& [key, bounds_of_nodes] : primitives)
    add(element(element(edit, "meshes", static_cast<std::size_t>(key.first)), "primitives", static_cast<std::size_t>(key.second)),
        json_of_bound<Json>(around(bounds_of_nodes)));
  for (std::size_t c = 0; c < bounds.clips.size(); ++c)
    add(element(edit, "animations", c), json_of_clip(model, bounds, static_cast<int>(c)));
  try {
    return edited(json, edit);
  } catch (const std::invalid_argument& e) {
    throw ModelError(file, "extras", std::string(e.what()) + ", and nothing can be added to it");
  }
}

}  // namespace refitlab
