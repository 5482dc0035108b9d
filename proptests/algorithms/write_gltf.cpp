// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that models that are written as glTF files load back as they were, up to the rounding of floats.
#include "algorithms/model/write_gltf.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "algorithms/model/gltf_scene.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/model/model_of_scene.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests::suite_write_gltf {
namespace {

using namespace refitlab;

std::vector<Point3> posed_vertices(const Model& model, const Pose& pose) {
  std::vector<Point3> out;
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    Point3 sum(0, 0, 0);
    for (const Influence& i : model.influences[v]) sum += i.weight * apply(pose[i.joint], model.vertices[v]);
    out.push_back(sum);
  }
  return out;
}

// Returns for each joint of the model the one of the same name, among those that are not yet taken.
std::vector<int> same_joints(const Model& model, const Model& read) {
  std::vector<int> out;
  for (const Joint& joint : model.joints) {
    int found = 0;
    while (found < static_cast<int>(read.joints.size()) &&
           (read.joints[found].name != joint.name || std::find(out.begin(), out.end(), found) != out.end()))
      ++found;
    out.push_back(found);
  }
  return out;
}

// Returns how a model and what was read of its file differ, where vertices and joints are in another order; nothing if they do
// not.
std::string difference(const Model& model, const Model& read) {
  if (read.sources.size() != 1 || read.triangles.size() != model.triangles.size() || read.clips.size() != model.clips.size() ||
      read.joints.size() != model.joints.size())
    return "it has another number of triangles, joints or clips";
  const std::vector<int>& places = read.sources[0].vertices;
  const std::vector<int> joints = same_joints(model, read);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int parent = model.joints[j].parent;
    if (joints[j] >= static_cast<int>(joints.size()) || read.joints[joints[j]].parent != (parent < 0 ? -1 : joints[parent]))
      return "a joint differs";
  }
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (read.triangles[t][k] != places[model.triangles[t][k]]) return "a corner differs";
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    const auto &a = model.influences[v], &b = read.influences[places[v]];
    bool same = a.size() == b.size();
    for (const Influence& i : a)
      same = same && std::any_of(b.begin(), b.end(),
                                 [&](const Influence& k) { return k.joint == joints[i.joint] && k.weight == i.weight; });
    if (!same) return "the weights of a vertex differ";
  }
  double worst = 0;
  for (std::size_t c = 0; c < model.clips.size(); ++c) {
    if (read.clips[c].name != model.clips[c].name) return "a clip has another name";
    if (std::abs(read.clips[c].duration - model.clips[c].duration) > 1e-6) return "a clip has another duration";
    for (const double share : {0.0, 0.31, 0.77, 1.0}) {
      const double time = share * std::min(model.clips[c].duration, read.clips[c].duration);
      const auto a = posed_vertices(model, model.clips[c].sample(time)), b = posed_vertices(read, read.clips[c].sample(time));
      for (std::size_t v = 0; v < a.size(); ++v) worst = std::max(worst, (a[v] - b[places[v]]).norm());
    }
  }
  return worst < 1e-5 ? "" : "a vertex is off by " + std::to_string(worst);
}

std::string refusal(const Model& model) {
  try {
    gltf_bytes(model);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

PROPTEST(write_gltf) {
  t.example("the man, the creature and a snake load back from their files", {}, [] {
    const TemporaryFolder folder;
    std::string wrong;
    for (const Model& made : {make_man(), make_creature(), make_snake(40)}) {
      const Model model = keyed(made, 30);
      write_gltf(model, folder.file("model.glb"));
      const std::string different = difference(model, load_model(folder.file("model.glb")));
      if (!different.empty()) wrong += made.name + ": " + different + "; ";
    }
    return Checked(wrong.empty(), 3, wrong);
  });
  t.example("all influences of a vertex are written, up to four, up to eight and beyond", {}, [] {
    std::string wrong;
    for (int count = 1; count <= 9; ++count) {
      Model model = keyed(make_snake(9), 5);
      model.influences[0] = {{0, 1 - (count - 1) / 16.0}};
      for (int k = 1; k < count; ++k) model.influences[0].push_back({k, 1 / 16.0});
      const std::string different = difference(model, model_of_scene(gltf_scene(gltf_bytes(model), "again.glb")));
      if (!different.empty()) wrong += std::to_string(count) + ": " + different + "; ";
    }
    return Checked(wrong.empty(), 9, wrong);
  });
  t.example("what the file says of its positions' box is exact", {}, [] {
    Model model = keyed(make_snake(5), 2);
    const auto description = nlohmann::json::parse(read_glb(gltf_bytes(model), "again.glb")[0].data);
    const auto of = description["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
    const nlohmann::json& accessor = description["accessors"].at(of);
    for (std::size_t k = 0; k < 3; ++k) {
      float low = HUGE_VALF, high = -HUGE_VALF;
      for (const Point3& p : model.vertices)
        low = std::min(low, static_cast<float>(p[k])), high = std::max(high, static_cast<float>(p[k]));
      if (accessor["min"][k].get<float>() != low || accessor["max"][k].get<float>() != high) return false;
    }
    return true;
  });
  t.example("a node is one joint only, as glTF has it: another joint of it gets a node of its own", {}, [] {
    Model model = keyed(make_snake(2), 2);
    model.skeleton.joints.push_back(model.skeleton.joints[1]);
    const auto description = nlohmann::json::parse(read_glb(gltf_bytes(model), "again.glb")[0].data);
    return Checked(description["skins"][0]["joints"] == std::vector<int>{0, 1, 2} &&
                   description["nodes"][1]["children"] == std::vector<int>{2});
  });
  t.example("a model of a file loads back too, with splines, steps and a scale", {}, [] {
    const Model model = model_of_scene(gltf_scene(gen::RichGltf(false, false).file.text_file(), "rich"));
    const std::string different = difference(model, model_of_scene(gltf_scene(gltf_bytes(model), "again.glb")));
    return Checked(different.empty(), 1, different);
  });
  t.example(
      "refused: a model without a skeleton, with morph targets, with too many joints, with a sheared node, an unwritable file",
      {}, [] {
        std::string wrong;
        const auto expect = [&](const std::string& message, const std::string& words) {
          if (message.find(words) == std::string::npos) wrong += "'" + message + "', not '" + words + "'; ";
        };
        expect(refusal(make_snake(2)), "skeleton: there is none to write: see keyed");
        Model model = keyed(make_snake(2), 2);
        model.morphs.push_back({0, {0}, {{}}});
        expect(refusal(model), "morph targets: are not written");
        model = keyed(make_snake(2), 2);
        model.skeleton.nodes[1].local(0, 1) = 0.5;
        expect(refusal(model), "node 'spine_1': its transform is no translation, rotation and scale");
        model.skeleton.joints.resize(65536, model.skeleton.joints[0]);
        expect(refusal(model), "skeleton: has more joints than glTF can name");
        try {
          write_gltf(keyed(make_snake(2), 2), "/no such folder/model.glb");
          wrong += "it is written";
        } catch (const ModelError& e) {
          expect(e.what(), "/no such folder/model.glb: file: cannot be written");
        }
        return Checked(wrong.empty(), 5, wrong);
      });
}

}  // namespace proptests::suite_write_gltf
