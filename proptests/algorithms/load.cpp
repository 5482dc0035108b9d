// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the loading of rigged files against assimp's own matrices, and what is refused.
#include "algorithms/model/load.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "algorithms/model/gltf_scene.hpp"
#include "algorithms/program/guarded_load.hpp"
#include "proptests/gen/broken_rigs.hpp"
#include "proptests/gen/random_rig.hpp"
#include "proptests/gen/two_bone_x.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"
#include "proptests/oracles/file_skinning.hpp"

namespace proptests::suite_load {
namespace {

using namespace refitlab;
using gen::RiggedGltf;
using Folder = TemporaryFolder;

Model load(const RiggedGltf& scene) {
  const Folder folder;
  write_glb(scene, folder.file("rig.glb"));
  return load_model(folder.file("rig.glb"));
}

std::string read_all(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_all(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

// Returns the message of the refusal, or nothing if the file loads.
std::string refusal(const std::string& path) {
  try {
    load_model(path);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

// Checks that loading is refused with a message that has the file and all of the words.
Checked refuses(const std::string& path, const std::vector<std::string>& words) {
  const std::string message = refusal(path);
  bool complete = message.find(path) != std::string::npos;
  for (const std::string& word : words) complete = complete && message.find(word) != std::string::npos;
  return {complete, 1, message.empty() ? "it loads" : message};
}

std::vector<Point3> blend_linearly(const Model& model, const Pose& pose) {
  std::vector<Point3> posed;
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    Point3 sum(0, 0, 0);
    for (const Influence& i : model.influences[v]) sum += i.weight * apply(pose[i.joint], model.vertices[v]);
    posed.push_back(sum);
  }
  return posed;
}

// Returns the largest distance between a corner as the model and as the file has it, over the size of the posed file; infinity if
// they do not have the same triangles.
double deviation(const Model& model, const oracle::FileSkinning& file, unsigned clip, double time) {
  const std::vector<Point3> posed = blend_linearly(model, model.clips[clip].sample(time));
  const auto expected = file.posed_triangles(clip, time);
  if (expected.size() != model.triangles.size()) return INFINITY;
  double worst = 0, size = 0;
  for (std::size_t t = 0; t < expected.size(); ++t) {
    // The loader turns the triangles of a mesh around if its placement mirrors it.
    double apart[2] = {0, 0};
    for (int k = 0; k < 3; ++k) {
      const aiVector3D& e = expected[t][k];
      const Point3 corner(e.x, e.y, e.z);
      size = std::max(size, corner.norm());
      apart[0] = std::max(apart[0], (posed[model.triangles[t][k]] - corner).norm());
      apart[1] = std::max(apart[1], (posed[model.triangles[t][(3 - k) % 3]] - corner).norm());
    }
    worst = std::max(worst, std::min(apart[0], apart[1]));
  }
  return worst / size;
}

double worst_deviation(const Model& model, const std::string& path, int times) {
  const oracle::FileSkinning file(path);
  double worst = 0;
  for (std::size_t c = 0; c < model.clips.size(); ++c)
    for (int i = 0; i < times; ++i)
      worst = std::max(worst, deviation(model, file, static_cast<unsigned>(c), model.clips[c].duration * i / (times - 1)));
  return worst;
}

// Returns the worst deviation at so many times of keys, where it does not matter that assimp takes splines and steps for straight
// lines.
double worst_deviation_at_keys(const Model& model, const std::string& path, std::size_t times) {
  const oracle::FileSkinning file(path);
  double worst = 0;
  for (std::size_t c = 0; c < model.clips.size(); ++c)
    for (const double time : key_times(model.clips[c].animation, times))
      worst = std::max(worst, deviation(model, file, static_cast<unsigned>(c), time));
  return worst;
}

// Says whether the rotations are unit quaternions, each in the half-space of its parent's.
bool well_formed(const Model& model, const Pose& pose) {
  bool good = pose.size() == model.joints.size();
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const int parent = model.joints[j].parent;
    const auto& q = pose[j].rotation;
    good = good && std::abs(squared_norm(q) - 1) < 1e-14;
    good = good && (parent < 0 ? q[0] : dot(q, pose[parent].rotation)) >= 0;
  }
  return good;
}

struct RealModel {
  const char* name;
  std::size_t triangles, joints, clips;
  bool is_large = false;  // A large model is fetched on request.
};
// What is known of the files of experiments/fetch_models; proptests/lists says if one is missing.
constexpr RealModel known_models[] = {{"BCN_Epileptic.X", 5126, 54, 1},   {"Testwuson.X", 3732, 37, 3},
                                      {"Soldier.glb", 11376, 49, 4},      {"leftHandHigh.glb", 2320, 16, 7},
                                      {"rightHandHigh.glb", 2320, 16, 7}, {"genericHandLeft.glb", 2314, 25, 0},
                                      {"dancing.fbx", 55320, 52, 1, true}};

// Runs a check over the real models that experiments/fetch_models has left in out/models of the working directory.
template <class Check>
Checked over_real_models(const Check& check) {
  bool passed = true;
  long used = 0;
  std::string detail, absent;
  for (const RealModel& m : known_models) {
    const std::string path = std::string("out/models/") + m.name;
    if (!std::filesystem::exists(path)) {
      if (!m.is_large) absent += absent.empty() ? m.name : std::string(", ") + m.name;
      continue;
    }
    ++used;
    const std::string complaint = check(m, path);
    passed = passed && complaint.empty();
    detail += complaint.empty() ? "" : "; " + std::string(m.name) + ": " + complaint;
  }
  if (passed && !absent.empty()) return Checked::skip("not in out/models: " + absent);
  return {passed, used, std::to_string(used) + " of " + std::to_string(std::size(known_models)) + " real models" + detail};
}

void rigs_and_real_models_as_their_files_say(Suite& t) {
  t.holds("a loaded rig is posed as the file's own matrices palette it", {.cases = 300, .degenerate_at_least = 0.05}, [] {
    const gen::RigTraits traits = gen::draw_traits();
    RC_CLASSIFY(traits.joints == 1 || traits.split_joint, "degenerate");
    RC_CLASSIFY(traits.mirrored, "mirrored");
    RC_CLASSIFY(traits.loose_mesh, "with a mesh without bones");
    const Folder folder;
    const std::string path = folder.file("rig.glb");
    write_glb(random_rig(traits), path);
    const Model model = load_model(path);
    const bool split = traits.second_skin && traits.split_joint && traits.joints > 1;
    // A second skin, whose matrices are rounded to float, shares a joint of the first one where it does exactly the same.
    const int least = traits.joints + split + traits.other_joints + traits.loose_mesh,
              joints = static_cast<int>(model.joints.size());
    RC_ASSERT(joints >= least && joints <= least + (traits.second_skin ? traits.joints : 0));
    RC_ASSERT(model.rigidity_defect < 1e-5);
    RC_ASSERT(worst_deviation(model, path, 5) < 1e-5);
    for (const double share : {0.0, 0.3, 1.0})
      RC_ASSERT(well_formed(model, model.clips[0].sample(share * model.clips[0].duration)));
  });

  t.example("the real models are posed at their keys as their own matrices palette them", {}, [] {
    return over_real_models([](const RealModel&, const std::string& path) -> std::string {
      const double worst = worst_deviation_at_keys(load_model(path), path, 4);
      return worst < 1e-5 ? "" : "deviates by " + std::to_string(worst) + " of its size";
    });
  });
  t.example("the real models have the triangles, joints and clips that are known of them", {}, [] {
    return over_real_models([](const RealModel& known, const std::string& path) -> std::string {
      const Model m = load_model(path);
      const bool as_known =
          m.triangles.size() == known.triangles && m.joints.size() == known.joints && m.clips.size() == known.clips;
      return as_known && m.rigidity_defect < 1e-5 ? "" : "it has others, or is not rigid";
    });
  });
}

void what_a_tube_is_loaded_as(Suite& t) {
  t.example("the bones of a tube are its joints, parents first, with their origins and names", {}, [] {
    const Model m = load(gen::bending_tube(4));
    bool good = m.joints.size() == 4 && m.vertices.size() == 36 && m.triangles.size() == 64;
    for (int j = 0; good && j < 4; ++j)
      good = m.joints[j].name == "j" + std::to_string(j) && m.joints[j].parent == j - 1 &&
             (m.joints[j].origin - Point3(0, j, 0)).norm() < 1e-12;
    return Checked(good);
  });
  t.example("a constant scale is multiplied into vertices and origins", {}, [] {
    RiggedGltf scene = gen::bending_tube(4);
    scene.nodes[0].scale = {0.01f, 0.01f, 0.01f};
    const Model small = load(scene), tube = load(gen::bending_tube(4));
    bool good = small.vertices.size() == tube.vertices.size();
    for (std::size_t v = 0; good && v < small.vertices.size(); ++v)
      good = (small.vertices[v] - 0.01 * tube.vertices[v]).norm() < 1e-8;
    return Checked(good && (small.joints[3].origin - Point3(0, 0.03, 0)).norm() < 1e-8);
  });
  t.example("the triangles of a mirrored skin face outwards as those of a plain one do", {}, [] {
    RiggedGltf scene = gen::bending_tube(3);
    const Model plain = load(scene);
    scene.nodes[0].scale = {1, 1, -1};
    const Model mirrored = load(scene);
    bool good = true;
    for (const Model* m : {&plain, &mirrored})
      for (const Triangle& triangle : m->triangles) {
        const Point3 a = m->vertices[triangle[0]], b = m->vertices[triangle[1]], c = m->vertices[triangle[2]];
        // It points away from the tube's axis.
        const Point3 outwards(a[0] + b[0] + c[0], 0, a[2] + b[2] + c[2]);
        good = good && dot(cross<double>(b - a, c - a), outwards) > 0;
      }
    return Checked(good && mirrored.vertices[1][0] == -plain.vertices[1][0], 2);
  });
  t.example("a text file with its bytes in a data URI loads as the binary one", {}, [] {
    const Folder folder;
    write_gltf(gen::bending_tube(3), folder.file("rig.gltf"));
    const Model text = load_model(folder.file("rig.gltf")), binary = load(gen::bending_tube(3));
    return Checked(text.vertices == binary.vertices && text.triangles == binary.triangles);
  });
  t.example("accessors that share one view, each from its own offset, load as those that have a view each", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.gltf");
    write_gltf(gen::bending_tube(3), path);
    auto shared = nlohmann::json::parse(read_all(path));
    for (auto& accessor : shared["accessors"]) {
      const std::size_t view = accessor["bufferView"];
      accessor["byteOffset"] = shared["bufferViews"][view]["byteOffset"];
      accessor["bufferView"] = 0;
    }
    shared["bufferViews"][0]["byteLength"] = shared["buffers"][0]["byteLength"];
    write_all(path, shared.dump());
    const Model one = load_model(path), each = load(gen::bending_tube(3));
    return Checked(one.vertices == each.vertices && one.triangles == each.triangles && one.joints.size() == each.joints.size());
  });
}

void vertices_that_are_merged_dropped_or_kept(Suite& t) {
  t.example("vertices of one position are one exactly where their weights agree", {}, [] {
    RiggedGltf seams = gen::bending_tube(3);
    gen::GltfMesh& mesh = seams.meshes[0];
    const gen::GltfMesh whole = mesh;
    mesh.positions.clear(), mesh.joints[0].clear(), mesh.weights[0].clear();
    for (std::size_t i = 0; i < whole.indices.size(); ++i) {
      mesh.positions.push_back(whole.positions[whole.indices[i]]);
      mesh.joints[0].push_back(whole.joints[0][whole.indices[i]]);
      mesh.weights[0].push_back(whole.weights[0][whole.indices[i]]);
      mesh.indices[i] = static_cast<std::uint32_t>(i);
    }
    const std::size_t welded = load(seams).vertices.size();
    mesh.joints[0][0] = {1, 0, 0, 0};
    const std::size_t other_weights = load(seams).vertices.size();
    return Checked(welded == whole.positions.size() && other_weights == welded + 1, 2);
  });
  t.example("a triangle with two equal vertices is dropped, and so is a vertex without a triangle", {}, [] {
    RiggedGltf scene = gen::bending_tube(3);
    scene.meshes[0].indices.insert(scene.meshes[0].indices.end(), {2, 2, 3});
    scene.meshes[0].positions.push_back({9, 9, 9});
    scene.meshes[0].joints[0].push_back({0, 0, 0, 0});
    scene.meshes[0].weights[0].push_back({1, 0, 0, 0});
    const Model m = load(scene), tube = load(gen::bending_tube(3));
    return Checked(m.triangles == tube.triangles && m.vertices == tube.vertices);
  });
  t.example("more than four influences of a vertex are all kept", {}, [] {
    const gen::RigTraits traits{.joints = 8, .many_influences = true, .seed = 1};
    const Model m = load(gen::random_rig(traits));
    bool good = true;
    for (const auto& influences : m.influences) good = good && influences.size() == 8;
    return Checked(good, static_cast<long>(m.influences.size()));
  });
}

void influences_that_are_lost(Suite& t) {
  t.example("a joint whose weight is rounded to 0 is told of, with its share, and one of weight 0 is not", {}, [] {
    RiggedGltf scene = gen::bending_tube(3);
    const auto give = [&](std::size_t vertex, std::array<float, 4> weights) {
      scene.meshes[0].joints[0][vertex] = {2, 0, 1, 0}, scene.meshes[0].weights[0][vertex] = weights;
    };
    // Joint 0 is listed twice. Neither weight is lost unless both together are.
    give(3, {1, 1e-9f, 0, 2e-9f}), give(5, {1e-9f, 1, 1e-8f, 0}), give(7, {1, 0x1p-26f, 0, 0x1p-25f}),
        give(9, {0.5f, 0, 0.5f, 0});
    const Model m = load(scene);
    std::vector<std::string> wrong;
    const auto expect = [&](int vertex, const std::vector<std::pair<int, double>>& lost) {
      const int at = m.sources[0].vertices[static_cast<std::size_t>(vertex)];
      const auto found = lost_influences(m, at);
      bool same = found.size() == lost.size();
      for (std::size_t i = 0; same && i < lost.size(); ++i)
        same = found[i].vertex == at && found[i].joint == lost[i].first && std::abs(found[i].share / lost[i].second - 1) < 1e-6;
      if (!same) wrong.push_back(std::to_string(vertex));
    };
    expect(3, {{0, 3e-9}}), expect(5, {{1, 1e-8}, {2, 1e-9}}), expect(7, {}), expect(9, {}), expect(0, {});
    const auto& all = m.lost_influences;
    const bool in_order = std::is_sorted(all.begin(), all.end(), [](const LostInfluence& a, const LostInfluence& b) {
      return std::pair(a.vertex, a.joint) < std::pair(b.vertex, b.joint);
    });
    return Checked(wrong.empty() && all.size() == 3 && in_order, 6, wrong.empty() ? "" : "vertex " + wrong[0]);
  });
}

void how_rigid_a_clip_has_to_be(Suite& t) {
  t.example("a scale that wavers within the tolerance is measured, and one beyond it is refused", {}, [] {
    const auto wavering = [](float by) {
      RiggedGltf scene = gen::bending_tube(3);
      scene.clips[0].tracks.push_back({2, "scale", {0, 1}, {1, 1, 1, 1 + by, 1 + by, 1 + by}});
      return scene;
    };
    const double defect = load(wavering(5e-4f)).rigidity_defect;
    bool refused = false;
    try {
      load(wavering(1.5e-3f));
    } catch (const ModelError&) {
      refused = true;
    }
    return Checked(std::abs(defect - std::sqrt(3) * 1e-3) < 1e-5 && refused, 2, std::to_string(defect));
  });
  t.example("the rigidity defect is the largest of all clips and times, wherever that is", {}, [] {
    const auto with_waver_in = [](int clip, int key) {
      RiggedGltf scene = gen::bending_tube(3);
      scene.clips.resize(3, scene.clips[0]);
      for (int c = 0; c < 3; ++c) scene.clips[c].name = "clip " + std::to_string(c);
      gen::GltfTrack track{2, "scale", {0, 0.25f, 0.5f, 1}, std::vector<float>(12, 1)};
      for (int i = 0; i < 3; ++i) track.values[3 * key + i] = 1 + 5e-4f;
      scene.clips[clip].tracks.push_back(track);
      return load(scene).rigidity_defect;
    };
    bool good = true;
    for (int clip = 0; clip < 3; ++clip)
      for (int key = 1; key < 4; ++key) good = good && std::abs(with_waver_in(clip, key) - std::sqrt(3) * 1e-3) < 1e-5;
    return Checked(good, 9);
  });
  t.example(
      "accepted at the edge: the last joint and vertex, weights that sum to nearly 1, keys that coincide, a matrix too many", {},
      [] {
        const auto complaint = [](const std::function<void(RiggedGltf&)>& change) -> std::string {
          RiggedGltf scene = gen::bending_tube(3);
          change(scene);
          try {
            load(scene);
          } catch (const ModelError& e) {
            return std::string(e.what()) + "; ";
          }
          return "";
        };
        const auto weights = [](float a, float b) {
          return [=](RiggedGltf& s) { s.meshes[0].joints[0][7] = {0, 2, 0, 0}, s.meshes[0].weights[0][7] = {a, b, 0, 0}; };
        };
        std::string wrong = complaint(weights(0, 1)) + complaint(weights(0.5f, 0.4001f)) + complaint(weights(0.5f, 0.5999f)) +
                            complaint([](RiggedGltf& s) {
                              s.meshes[0].joints[0][7] = {0, 99, 0, 0}, s.meshes[0].weights[0][7] = {1, 0, 0, 0};
                            }) +
                            complaint([](RiggedGltf& s) {
                              s.meshes[0].indices[5] = static_cast<std::uint32_t>(s.meshes[0].positions.size()) - 1;
                            }) +
                            complaint([](RiggedGltf& s) {
                              s.clips[0].tracks[1].times = {1, 1};
                            }) +
                            complaint([](RiggedGltf& s) {
                              s.clips[0].tracks[1].times = {0, 0};
                            }) +
                            complaint([](RiggedGltf& s) { s.clips.clear(); }) + complaint([](RiggedGltf& s) {
                              for (auto& track : s.clips[0].tracks)
                                track.times = {0}, track.values.resize(track.values.size() / 2);
                            }) +
                            complaint([](RiggedGltf& s) { s.skins[0].inverse_bind.push_back(s.skins[0].inverse_bind[0]); });
        for (const auto& [a, b] : {std::pair{0.5f, 0.3999f}, {0.5f, 0.6001f}})
          if (complaint(weights(a, b)).empty()) wrong += "weights of " + std::to_string(a + b) + " load; ";
        // The count is the first index that is out of range. The last two are negative as signed integers.
        for (const std::uint32_t index : {28u, 29u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
          if (complaint([=](RiggedGltf& s) { s.meshes[0].indices[5] = index; }).find("index 5 names a vertex out of range") ==
              std::string::npos)
            wrong += "the index " + std::to_string(index) + " of 28 vertices loads; ";
        return Checked(wrong.empty(), 17, wrong);
      });
}

void keys_and_their_times(Suite& t) {
  t.example("quaternions in keys may be of any length but nearly 0", {}, [] {
    const auto scaled = [](float by) {
      RiggedGltf scene = gen::bending_tube(3);
      for (auto& track : scene.clips[0].tracks)
        if (track.path == "rotation")
          for (float& x : track.values) x *= by;
      return load(scene).clips[0].sample(0.7);
    };
    const Pose plain = scaled(1);
    double worst = 0;
    for (const float by : {1e-3f, 0.3f, 1e3f}) {
      const Pose pose = scaled(by);
      for (std::size_t j = 0; j < plain.size(); ++j)
        worst = std::max(worst, norm<double, 4>(pose[j].rotation - plain[j].rotation));
    }
    return Checked(worst < 1e-5, 3, std::to_string(worst));
  });
  t.example("a pose between the times that loading checks is refused when it is sampled", {}, [] {
    RiggedGltf scene = gen::bending_tube(3);
    gen::GltfTrack track{1, "scale", {}, {}};
    for (int k = 0; k <= 1000; ++k) {
      track.times.push_back(0.001f * static_cast<float>(k));
      const float scale = k == 500 ? 2 : 1;
      track.values.insert(track.values.end(), {scale, scale, scale});
    }
    scene.clips[0].tracks.push_back(track);
    const Model m = load(scene);
    std::string message;
    try {
      m.clips[0].sample(0.5);
    } catch (const ModelError& e) {
      message = e.what();
    }
    for (const char* word : {"clip 'bend'", "joint 'j1'", "0.5 s", "scales by 2"})
      if (message.find(word) == std::string::npos) return Checked(false, 1, message);
    return Checked(true, 1, message);
  });
  t.example("ticks of an X file become seconds at its own rate, or at 25 where it gives none", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.X");
    gen::write_x({.ticks_per_second = "7", .last_key = "14"}, path);
    const Model odd = load_model(path);
    const double worst = worst_deviation(odd, path, 5);
    gen::write_x({.ticks_per_second = "", .last_key = "50"}, path);
    const Model silent = load_model(path);
    return Checked(odd.clips[0].duration == 2 && silent.clips[0].duration == 2 && worst < 1e-5, 2);
  });
}

void broken_rigs_and_what_is_no_model(Suite& t) {
  for (const gen::BrokenRig& broken : gen::broken_rigs())
    t.example(std::string("refused, with file, thing and reason: ") + broken.what, {}, [&] {
      const Folder folder;
      RiggedGltf scene = gen::bending_tube(3);
      broken.break_it(scene);
      write_glb(scene, folder.file("rig.glb"));
      write_gltf(scene, folder.file("rig.gltf"));
      const Checked binary = refuses(folder.file("rig.glb"), broken.words);
      return Checked(binary.passed && refuses(folder.file("rig.gltf"), broken.words).passed, 2, binary.detail);
    });
  t.example("refused: a file that is missing, or no model whatever its name says", {}, [] {
    const Folder folder;
    bool good = refuses(folder.file("missing.glb"), {"does not exist"}).passed && refuses("/", {"does not exist"}).passed;
    for (const char* name : {"text.glb", "text.gltf", "text.X", "text.fbx", "text.dae", "text.txt"})
      for (const char* content : {"", "hello", "glTF", "{}", "[1, 2]", "xof 0303txt 0032\n", "<?xml version=\"1.0\"?>"}) {
        write_all(folder.file(name), content);
        good = good && refuses(folder.file(name), {}).passed;
      }
    return Checked(good, 44);
  });
  t.example("a file is read as glTF by its ending or its first bytes, and so is one in text with an ending of large letters", {},
            [] {
              const std::pair<const char*, const char*> as_gltf[] = {{"{}", "a.gltf"},
                                                                     {"{}", "a.GLTF"},
                                                                     {"", "a.b.glb"},
                                                                     {"", "A.GLB"},
                                                                     {"glTF\2", "a.X"}},
                                                        others[] = {
                                                            {"xof", "a.X"}, {"", "gltf"}, {" glTF", "a.fbx"}, {"", "a.gltf.dae"}};
              bool good = true;
              for (const auto& [bytes, name] : as_gltf) good = good && is_gltf(bytes, name);
              for (const auto& [bytes, name] : others) good = good && !is_gltf(bytes, name);
              return Checked(good, 9);
            });
}

void spoiled_gltf_files(Suite& t) {
  t.example("refused: a glTF file that ends early, wherever that is", {}, [] {
    const Folder folder;
    write_glb(gen::bending_tube(3), folder.file("rig.glb"));
    write_gltf(gen::bending_tube(3), folder.file("rig.gltf"));
    long cases = 0;
    for (const std::string name : {"rig.glb", "rig.gltf"}) {
      const std::string whole = read_all(folder.file(name));
      for (std::size_t length = 0; length < whole.size(); length += 37, ++cases) {
        write_all(folder.file("cut " + name), whole.substr(0, length));
        if (!refuses(folder.file("cut " + name), {}).passed) return Checked(false, cases, "cut at " + std::to_string(length));
      }
    }
    return Checked(true, cases);
  });
  t.example("refused: a glTF file of version 1, or of integers where there have to be floats", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.gltf");
    write_gltf(gen::bending_tube(3), path);
    const auto edited = [&](const std::string& old, const std::string& fresh) {
      std::string text = read_all(path);
      for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += fresh.size())
        text.replace(at, old.size(), fresh);
      write_all(folder.file("edited.gltf"), text);
      return folder.file("edited.gltf");
    };
    const bool version = refuses(edited("\"2.0\"", "\"1.0\""), {"version 1.0"}).passed;
    return Checked(version && refuses(edited("5126", "5121"), {"not of floats"}).passed, 2);
  });
  t.example("refused: a spline of two values a time, and joints that are three a vertex", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.gltf");
    RiggedGltf scene = gen::bending_tube(3);
    for (auto& track : scene.clips[0].tracks) track.values.resize(2 * track.values.size());
    auto& mesh = scene.meshes[0];
    mesh.joints.push_back(mesh.joints[0]), mesh.weights.push_back(mesh.weights[0]);
    for (auto& weights : mesh.weights[1]) weights = {0, 0, 0, 0};
    write_gltf(scene, path);
    const auto whole = nlohmann::json::parse(read_all(path));
    // There are values to spare, and a set of weights that are 0.
    bool good = refusal(path).empty();
    auto changed = whole;
    for (auto& sampler : changed["animations"][0]["samplers"]) sampler["interpolation"] = "CUBICSPLINE";
    write_all(path, changed.dump());
    good = good && refuses(path, {"'bend'", "2 times but 4 values"}).passed;
    // There are three for each vertex.
    for (const char* list : {"JOINTS_0", "WEIGHTS_0"}) {
      changed = whole;
      const std::size_t accessor = changed["meshes"][0]["primitives"][0]["attributes"][list];
      changed["accessors"][accessor]["type"] = "VEC3";
      write_all(path, changed.dump());
      good = good && refuses(path, {"mesh 0", "is of another type"}).passed;
    }
    return Checked(good, 4);
  });
  t.example("refused: a binary glTF file whose length, or whose chunk's, is more than there is, by however little", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.glb");
    write_glb(gen::bending_tube(3), path);
    const std::string whole = read_all(path);
    const auto word = [&](std::size_t at) {
      std::uint32_t value;
      std::memcpy(&value, whole.data() + at, 4);
      return value;
    };
    std::string wrong;
    // These are the places of the sizes of the file and of the second chunk.
    for (const std::size_t at : {std::size_t{8}, 20 + std::size_t{word(12)}})
      for (const std::uint32_t more : {1u, 4u, 8u}) {
        std::string bytes = whole;
        const std::uint32_t value = word(at) + more;
        std::memcpy(bytes.data() + at, &value, 4);
        write_all(path, bytes);
        const std::string reason = at == 8 ? "bytes, but has " : "chunk 1: the file ends in its data";
        if (!refuses(path, {reason}).passed) wrong += std::to_string(more) + " more at " + std::to_string(at) + "; ";
      }
    return Checked(wrong.empty(), 6, wrong);
  });
}

void spoiled_descriptions_and_x_files(Suite& t) {
  t.example("refused: a glTF file whose description refers to what is not there", {}, [] {
    const struct {
      const char *old, *fresh, *word;
    } changes[] = {
        {"\"uri\":\"data:application/octet-stream;base64,", "\"uri\":\"other", "File not found : other"},
        {"\"uri\":\"data:application/octet-stream;base64,", "\"uri\":\"/dev/zero\",\"not\":\"", "File not found : /dev/zero"},
        {"\"uri\"", "\"url\"", "buffer 0: has no bytes"},
        {"\"bufferView\"", "\"sparse\"", "is not an object of the description"},
        {"\"buffer\":0", "\"buffer\":1", "is in a buffer that there is not"},
        {"\"byteOffset\":0}", "\"byteOffset\":99999}", "reaches past the end of its buffer"},
        {"\"componentType\"", "\"type\"", "glTF description"},
    };
    const Folder folder;
    write_gltf(gen::bending_tube(3), folder.file("rig.gltf"));
    const std::string whole = read_all(folder.file("rig.gltf"));
    std::string wrong;
    for (const auto& change : changes) {
      std::string text = whole;
      const std::string old = change.old;
      for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += std::strlen(change.fresh))
        text.replace(at, old.size(), change.fresh);
      write_all(folder.file("changed.gltf"), text);
      const Checked refused = refuses(folder.file("changed.gltf"), {change.word});
      if (!refused.passed) wrong += old + ": " + refused.detail + "; ";
    }
    return Checked(wrong.empty(), std::size(changes), wrong);
  });
  t.example("refused: an X file that crashes assimp, by weights of a vertex far out of range", {}, [] {
    const Folder folder;
    gen::write_x({.weighted = "0, 1, 2, 3, 4, 4000000000"}, folder.file("rig.X"));
    try {
      load_model_guarded(folder.file("rig.X"));
    } catch (const ModelError& e) {
      const std::string message = e.what();
      return Checked(message == folder.file("rig.X") + ": file: assimp crashes on it, or does not end", 1, message);
    }
    return Checked(false, 1, "it loads");
  });
  t.example("refused: an X file of two nodes of one name", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.X");
    gen::write_x({}, path);
    const std::string text = read_all(path),
                      frame = "Frame tip {\n FrameTransformMatrix {\n1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1;;\n}\n}\n";
    if (!refusal(path).empty()) return Checked(false, 1, refusal(path));
    write_all(path, text + frame);
    return refuses(path, {"node 'tip'", "two nodes have this name"});
  });
  t.example("refused: an X file of a vertex without weight, or with a negative weight, which assimp drops", {}, [] {
    const Folder folder;
    const std::string path = folder.file("rig.X");
    gen::write_x({.root_weights = "1, 1, 0.5, 0.5, 0, 0.25", .tip_weights = "0, 0, 0.5, 0.5, 0, 0.75"}, path);
    const Checked none = refuses(path, {"no weight"});
    gen::write_x({.root_weights = "1, 1, 0.5, 0.5, -0.5, 0.25", .tip_weights = "0, 0, 0.5, 0.5, 1.5, 0.75"}, path);
    const Checked negative = refuses(path, {"sum to 1.5"});
    return Checked(none.passed && negative.passed, 2, none.detail + "; " + negative.detail);
  });
}

}  // namespace

PROPTEST(load) {
  rigs_and_real_models_as_their_files_say(t);
  what_a_tube_is_loaded_as(t);
  vertices_that_are_merged_dropped_or_kept(t);
  influences_that_are_lost(t);
  how_rigid_a_clip_has_to_be(t);
  keys_and_their_times(t);
  broken_rigs_and_what_is_no_model(t);
  spoiled_gltf_files(t);
  spoiled_descriptions_and_x_files(t);
}

}  // namespace proptests::suite_load
