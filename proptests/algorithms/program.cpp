// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the program as its users call it: baked files hold vertices that are skinned by formulas of the file's own. What is wrong
// is refused with a line and an exit code, and leaves no file that is half written.
#include "algorithms/program/program.hpp"

#include <sys/resource.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/model/write_gltf.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/peak_memory.hpp"
#include "algorithms/program/report.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/binary.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/model_of_nodes.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/gen/rigged_gltf.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/checked_folder.hpp"

// The system calls this main function, which is too short for a file that tests it.
#define main refitlab_main
#include "algorithms/program/main.cpp"
#undef main

namespace proptests::suite_program {
namespace {

using namespace refitlab;
using nlohmann::json;

struct Called {
  int code;
  std::string out, errors;
};

Called call(const std::vector<std::string>& arguments) {
  std::ostringstream out, errors;
  const int code = run_program(arguments, out, errors);
  return {code, out.str(), errors.str()};
}

bool is_in(const json& box, const Eigen::Vector3d& p) {
  for (int i = 0; i < 3; ++i)
    if (p[i] < box[i].get<double>() || p[i] > box[i + 3].get<double>()) return false;
  return true;
}
bool is_in_ball(const json& ball, const Eigen::Vector3d& p) {
  return (p - Eigen::Vector3d(ball[0], ball[1], ball[2])).norm() <= ball[3].get<double>();
}

// Decodes numbers of so many bytes each, the lowest first, from base 64.
std::vector<int> numbers_of(const std::string& text, std::size_t size = 2) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<int> bytes, out;
  unsigned group = 0;
  int bits = 0;
  for (const char digit : text) {
    if (digit == '=') break;
    group = group << 6 | static_cast<unsigned>(digits.find(digit)), bits += 6;
    if (bits >= 8) bytes.push_back(static_cast<int>(group >> (bits -= 8) & 255));
  }
  for (std::size_t i = 0; i + size <= bytes.size(); i += size) {
    out.push_back(0);
    for (std::size_t k = 0; k < size; ++k) out.back() += bytes[i + k] << (8 * k);
  }
  return out;
}

bool is_in_slabs(const json& directions, const json& slabs, const Eigen::Vector3d& p) {
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const double along =
        directions[k][0].get<int>() * p[0] + directions[k][1].get<int>() * p[1] + directions[k][2].get<int>() * p[2];
    if (along < slabs[k][0].get<double>() || along > slabs[k][1].get<double>()) return false;
  }
  return true;
}

json description_of(const std::string& path) { return json::parse(read_glb(read_whole(path), path)[0].data); }

// Holds a baked file of all features at once, in a folder of its own.
struct Rich {
  explicit Rich(bool uneven, bool moving, const std::vector<std::string>& more = {}) : gltf(uneven, moving) {
    write_whole(folder.file("in.glb"), gltf.file.binary_file());
    std::vector<std::string> arguments = {"bake", "--clusters", "4", folder.file("in.glb"), folder.file("out.glb")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    called = call(arguments);
  }
  TemporaryFolder folder;
  gen::RichGltf gltf;
  Called called;
};

// Writes a baked file whose clusters are changed.
void tamper(const std::string& path, const std::string& to, const std::function<void(BakedFile&)>& change) {
  BakedFile baked = read_baked(path);
  change(baked);
  std::vector<GlbChunk> chunks = read_glb(read_whole(path), path);
  chunks.back().data = chunk_of(baked);
  write_whole(to, glb_of(chunks, to));
}
// Writes a baked file with a skinning that does not exist, as the first number of the chunk's body, behind 28 bytes of a header.
void give_no_skinning(const std::string& path, const std::string& to) {
  std::vector<GlbChunk> chunks = read_glb(read_whole(path), path);
  const std::string& chunk = chunks.back().data;
  std::uint32_t version = 0;
  std::memcpy(&version, &chunk[8], sizeof(version));
  std::string body = chunk.substr(28);
  body[0] = 3;
  chunks.back().data = sealed(chunk.substr(0, 8), version, body);
  write_whole(to, glb_of(chunks, to));
}
// Writes a file whose description is changed.
void redescribe(const std::string& path, const std::string& to, const std::function<void(json&)>& change) {
  std::vector<GlbChunk> chunks = read_glb(read_whole(path), path);
  json description = json::parse(chunks[0].data);
  change(description);
  chunks[0].data = description.dump();
  write_whole(to, glb_of(chunks, to));
}
void halve_a_box(BakedFile& baked) {
  BoundedPart& bound = baked.clusters.clips[0].clusters[0];
  bound.box.high[1] = bound.box.low[1] + (bound.box.high[1] - bound.box.low[1]) / 2;
}

void bounds_hold_and_are_checked(Suite& t) {
  t.example("every vertex of a file of all features is inside of its bounds, by the file's own formulas, at 400 times",
            {.number_type = "double"}, [] {
              long looked_at = 0, missed = 0;
              for (const bool uneven : {false, true})
                for (const bool moving : {false, true}) {
                  const Rich rich(uneven, moving, {"--dop", "26"});
                  if (rich.called.code != 0) return Checked(false, 1, rich.called.errors);
                  const json file = description_of(rich.folder.file("out.glb"));
                  const json& clip = file["animations"][0]["extras"]["refitlab"];
                  if (clip["directions"].size() != 10 || clip["slabs"].size() != 10)
                    return Checked(false, 1, "slabs are missing");
                  for (const auto& primitive : rich.gltf.primitives()) {
                    const auto& bounds = clip["primitives"];
                    const auto own = std::find_if(bounds.begin(), bounds.end(), [&](const json& b) {
                      return b["node"] == primitive.node && b["mesh"] == primitive.mesh && b["primitive"] == primitive.primitive;
                    });
                    if (own == bounds.end()) return Checked(false, 1, "a primitive has no bound");
                    const json& of_mesh = file["meshes"][primitive.mesh];
                    const json& always = of_mesh["primitives"][primitive.primitive]["extras"]["refitlab"];
                    const json& mesh = of_mesh["extras"]["refitlab"];
                    std::vector<char> is_used(primitive.positions.size(), 0);
                    for (const auto& triangle : primitive.triangles)
                      for (const int v : triangle) is_used[v] = 1;
                    for (int i = 0; i < 400; ++i) {
                      const auto posed = rich.gltf.posed(primitive, 2.0 * i / 399);
                      for (std::size_t v = 0; v < posed.size(); ++v) {
                        if (!is_used[v]) continue;
                        ++looked_at;
                        for (const json* bound : {&clip, &*own, &always, &mesh})
                          missed += !is_in((*bound)["box"], posed[v]) + !is_in_ball((*bound)["ball"], posed[v]) +
                                    !is_in_slabs(clip["directions"], bound->at("slabs"), posed[v]);
                      }
                    }
                  }
                }
              return Checked(missed == 0 && looked_at > 10000, looked_at, std::to_string(missed) + " are outside");
            });
  t.example("a baked file is checked, read and baked again; a box that is half as high is found", {}, [] {
    const Rich rich(true, true, {"--for", "any", "--quiet"});
    const std::string baked = rich.folder.file("out.glb"), again = rich.folder.file("again.glb"),
                      bad = rich.folder.file("bad.glb");
    const Called checked = call({"check", "--samples", "50", baked});
    const Called twice = call({"bake", "--clusters", "4", "--for", "any", baked, again});
    tamper(baked, bad, halve_a_box);
    const Called found = call({"check", "--samples", "50", bad});
    const bool is_same = read_whole(baked) == read_whole(again);
    const std::string bare = rich.folder.file("bare.glb");
    const Called without = call({"bake", "--no-character", "--clusters", "4", baked, bare}),
                 checked_without = call({"check", "--samples", "50", bare});
    const bool is_bare =
        read_baked(baked).character && !read_baked(bare).character && read_whole(bare).size() < read_whole(baked).size();
    return Checked(rich.called.code == 0 && checked.code == 0 && twice.code == 0 && is_same && found.code == 1 &&
                       without.code == 0 && checked_without.code == 0 && is_bare &&
                       found.out.find("cluster 0, vertex ") != std::string::npos,
                   7, checked.out + found.out + twice.errors + without.errors);
  });
}

void balls_for_any_pose(Suite& t) {
  t.example(
      "in every pose of a clip the vertices of each mesh and skin are in the ball for any pose, about that node of the file", {},
      [] {
        long looked_at = 0, missed = 0;
        std::string wrong;
        for (const bool uneven : {false, true}) {
          const Rich rich(uneven, true, {"--for", "any"});
          if (rich.called.code != 0) return Checked(false, 0, rich.called.errors);
          const json file = description_of(rich.folder.file("out.glb"));
          const auto expect = [&](const json& thing, const auto& is_of_it) {
            const json any = thing["extras"]["refitlab"].value("any_pose", json());
            if (!any.is_object()) return void(wrong += "a ball is missing; ");
            for (int i = 0; i < 20; ++i) {
              const double time = 2.0 * i / 19;
              const Eigen::Vector3d origin = rich.gltf.global(any["node"].get<int>(), time).topRightCorner<3, 1>();
              for (const gen::RichPrimitive& primitive : rich.gltf.primitives()) {
                if (!is_of_it(primitive)) continue;
                const auto posed = rich.gltf.posed(primitive, time);
                for (const auto& triangle : primitive.triangles)
                  for (const int v : triangle)
                    ++looked_at, missed += (posed[static_cast<std::size_t>(v)] - origin).norm() > any["radius"].get<double>();
              }
            }
          };
          for (int m = 0; m < static_cast<int>(file["meshes"].size()); ++m)
            expect(file["meshes"][static_cast<std::size_t>(m)],
                   [m](const gen::RichPrimitive& primitive) { return primitive.mesh == m; });
          for (int s = 0; s < static_cast<int>(file["skins"].size()); ++s)
            expect(file["skins"][static_cast<std::size_t>(s)],
                   [s](const gen::RichPrimitive& primitive) { return primitive.skin == s; });
        }
        return Checked(wrong.empty() && missed == 0 && looked_at > 1000, looked_at,
                       wrong + std::to_string(missed) + " are outside");
      });
}

// Returns the weight of the moment at which a vertex leaves its bound most in a crossfade, or -1 if the output has no weight, or
// no time of each clip.
double weight_of_moment(const std::string& said, const BakedFile& baked) {
  static const std::regex moment(R"( at (-?[0-9.]+) s and (-?[0-9.]+) s, weight (-?[0-9.]+))");
  std::smatch found;
  if (!std::regex_search(said, found, moment)) return -1;
  for (int clip = 0; clip < 2; ++clip) {
    const double time = std::stod(found[1 + clip]);
    if (!(time >= 0 && time <= baked.clusters.clips[clip].duration)) return -1;
  }
  const double weight = std::stod(found[3]);
  return weight <= 1 ? weight : -1;
}

void characters_and_nodes(Suite& t) {
  t.example("the baked character has the file's morph targets, and moves its vertices as they do", {}, [] {
    const Rich rich(true, true);
    const Character character = *read_baked(rich.folder.file("out.glb")).character;
    const Model model = load_model(rich.folder.file("in.glb"), {.joints = Joints::affine, .morphs = Morphs::moving});
    const SkinnedMesh& mesh = character.mesh;
    const Animation& animation = model.clips.at(0).animation;
    long moved = 0;
    double farthest = 0;
    for (const double time : {0.0, 0.7, 1.9}) {
      const std::vector<double> weights = morph_weights(model, animation, time);
      if (mesh.targets.count != static_cast<int>(weights.size())) return Checked(false, 0, "not as many targets");
      const auto points = deformed_vertices(mesh, character.sets, {.weights = weights});
      std::vector<Point3> expected = model.vertices;
      std::size_t k = 0;
      for (const MorphedMesh& morphed : model.morphs)
        for (const MorphTarget& target : morphed.targets) {
          for (const auto& [v, by] : target.displacements) expected[static_cast<std::size_t>(v)] += weights[k] * by;
          ++k;
        }
      for (std::size_t v = 0; v < points.size(); ++v) {
        moved += expected[v] != model.vertices[v];
        farthest = std::max(farthest, (points[v] - expected[v]).norm());
      }
    }
    return Checked(moved > 10 && farthest < 1e-12, moved, std::to_string(farthest));
  });
  for (const std::size_t slabs : {4, 6, 10}) {
    const std::string dop = std::to_string(2 * slabs + 6);
    t.example("nodes and slabs are baked and checked, and found where a bound is too small: of a " + dop + "-DOP", {}, [=] {
      const Rich rich(true, true, {"--nodes", "--dop", dop});
      const std::string baked = rich.folder.file("out.glb"), bad = rich.folder.file("bad.glb");
      const Called checked = call({"check", "--samples", "50", baked});
      const BakedFile file = read_baked(baked);
      bool good = rich.called.code == 0 && checked.code == 0 &&
                  checked.out.find("clip 'move', nodes of the tree: ") != std::string::npos &&
                  file.clusters.clips[0].nodes.size() == file.character->tree.nodes.size() &&
                  std::to_string(file.clusters.dop) == dop;
      std::string found;
      const auto finds = [&](const std::string& where, const std::function<void(ClusterBounds&)>& change) {
        tamper(baked, bad, [&](BakedFile& b) { change(b.clusters); });
        const Called called = call({"check", "--samples", "50", bad});
        found += called.out;
        good = good && called.code == 1 && called.out.find(where) != std::string::npos;
      };
      const auto narrow = [](Slab<float>& slab) { slab.high = slab.low + (slab.high - slab.low) / 2; };
      for (std::size_t k = 0; k < slabs; ++k) {
        finds("cluster 0, vertex ", [&](ClusterBounds& b) { narrow(b.clips[0].clusters[0].slabs[k]); });
        finds("cluster 0, vertex ", [&](ClusterBounds& b) {
          Slab<float>& slab = b.clips[0].clusters[0].slabs[k];
          slab.low = slab.high - (slab.high - slab.low) / 2;
        });
      }
      finds("node 1, vertex ", [&](ClusterBounds& b) { narrow(b.clips[0].nodes[1].slabs[2]); });
      finds("node 0, vertex ", [](ClusterBounds& b) { b.clips[1].nodes[0].ball.radius /= 2; });
      return Checked(good, static_cast<long>(2 * slabs + 3), rich.called.errors + checked.out + found);
    });
  }
}

void crossfades(Suite& t) {
  t.example("crossfades of all clips are baked, checked, and found where a bound is too small", {}, [] {
    const TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), bad = folder.file("bad.glb");
    write_gltf(keyed(make_man(400), 4), in);
    const Called called = call({"bake", "--for", "crossfade", "--rotations", "nlerp", "--crossfade-tolerance", "0.5",
                                "--clusters", "128", in, out}),
                 checked = call({"check", "--samples", "100", out});
    // A vertex of some clusters is farthest out in the midst of the crossfade.
    std::string found;
    bool are_found = true;
    double greatest_weight = 0;
    for (std::size_t cluster = 0; cluster < 3; ++cluster)
      for (const int axis : {0, 1}) {
        tamper(out, bad, [&](BakedFile& baked) {
          BoundedPart& bound = baked.clusters.crossfades[0].clusters[cluster];
          bound.box.high[axis] = bound.box.low[axis] + (bound.box.high[axis] - bound.box.low[axis]) / 2;
        });
        const Called called_again = call({"check", "--samples", "100", bad});
        const double weight = weight_of_moment(called_again.out, read_baked(out));
        found += called_again.out;
        are_found = are_found && called_again.code == 1 && weight >= 0;
        greatest_weight = std::max(greatest_weight, weight);
      }
    const json file = description_of(out);
    const json &first = file["animations"][0]["extras"]["refitlab"], &second = file["animations"][1]["extras"]["refitlab"];
    return Checked(called.code == 0 && checked.code == 0 && checked.out.find("crossfade of '") != std::string::npos &&
                       are_found && greatest_weight > 0 && first["rotations"] == "nlerp" &&
                       first["crossfades"][0]["animation"] == 1 && second["crossfades"][0]["animation"] == 0 &&
                       first["crossfades"][0]["box"] == second["crossfades"][0]["box"],
                   10, called.errors + checked.out + found);
  });
}

// Makes two triangles of one joint, and a clip of three seconds for each axis. In the first second the first clip turns the joint
// about its axis, in the second the second, and so on; otherwise it does not turn.
Model make_turning(double degrees, const std::vector<Eigen::Vector3d>& axes) {
  Model model = gen::model_of_nodes("turning", {{"a", -1, Eigen::Matrix4d::Identity()}});
  model.vertices = {{1, 0, 0}, {2, 0, 0.5}, {1.5, 0, 0.5}, {2, 0, -0.5}};
  model.triangles = {{0, 1, 2}, {0, 3, 1}}, model.influences.assign(4, {{0, 1}});
  for (std::size_t k = 0; k < axes.size(); ++k) {
    NodeTrack track{0, {{{0, Eigen::Vector3d::Zero()}}}, {}, {{{0, Eigen::Vector3d::Ones()}}}};
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(degrees / 180 * 3.141592653589793, axes[k]));
    for (int time = 0; time < 4; ++time)
      track.rotations.keys.push_back({double(time), time <= static_cast<int>(k) ? Eigen::Quaterniond::Identity() : turned});
    const std::string name = "turn " + std::to_string(k);
    model.clips.push_back({name, 3, {}, {name, 3, {track}}});
  }
  return model;
}

// Returns the time at which a vertex is farthest outside, or -1 if none is.
double time_of_farthest(const std::string& said) {
  static const std::regex moment(R"(farthest: .* at (-?[0-9.]+) s)");
  std::smatch found;
  return std::regex_search(said, found, moment) ? std::stod(found[1]) : -1;
}

void what_leaves_its_box_between_keys(Suite& t) {
  t.example("a vertex that leaves its box between two keys alone is found, between whichever two", {}, [] {
    const TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), bad = folder.file("bad.glb");
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    write_gltf(make_turning(170, {z, z, z}), in);
    const Called called = call({"bake", "--clusters", "4", in, out}), checked = call({"check", "--samples", "20", out});
    bool good = called.code == 0 && checked.code == 0 && time_of_farthest(checked.out) == -1 &&
                checked.out.find("nodes of the tree") == std::string::npos;  // There are no bounds of such nodes.
    std::string found;
    for (std::size_t clip = 0; clip < 3; ++clip) {
      tamper(out, bad, [&](BakedFile& baked) {
        Box<float>& box = baked.clusters.clips[clip].clusters[0].box;
        box.high[1] = box.low[1] + (box.high[1] - box.low[1]) / 2;
      });
      const Called again = call({"check", "--samples", "20", bad});
      const double time = time_of_farthest(again.out), start = static_cast<double>(clip);
      found += again.out;
      good = good && again.code == 1 && start < time && time < start + 1;
    }
    return Checked(good, 4, called.errors + checked.out + found);
  });
}

// Holds what is said of the rest pose: the number of places, how many are outside, how many are undecided, and the rest of the
// line.
struct SaidOfRest {
  long places, outside, undecided;
  std::string more;
};
SaidOfRest said_of_rest(const std::string& said) {
  static const std::regex line(R"((?:^|\n)rest pose: (\d+) places of vertices, (\d+) outside, (\d+) undecided([^\n]*)\n)");
  std::smatch found;
  if (!std::regex_search(said, found, line)) return {-1, -1, -1, said};
  return {std::stol(found[1]), std::stol(found[2]), std::stol(found[3]), found[4]};
}

void check_counts_vertices(Suite& t) {
  t.example("check counts the vertices that are outside and those too near to a bound to tell, and says how far one is outside",
            {}, [] {
              const TemporaryFolder folder;
              const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), other = folder.file("other.glb");
              write_gltf(make_turning(80, {Eigen::Vector3d::UnitZ()}), in);
              const Called baked = call({"bake", "--clusters", "4", in, out});
              if (baked.code != 0) return Checked(false, 0, baked.errors);
              // Two of the four vertices have an x of 2, and the others one of 1 and 1.5.
              const auto check = [&](float high) {
                tamper(out, other, [&](BakedFile& b) { b.clusters.clips.back().clusters[0].box.high[0] = high; });
                return call({"check", "--samples", "20", other});
              };
              const Called untouched = call({"check", "--samples", "20", out}), touching = check(2), outside = check(1.75f);
              const SaidOfRest none = said_of_rest(untouched.out), near = said_of_rest(touching.out),
                               far = said_of_rest(outside.out);
              const bool is_none =
                  untouched.code == 0 && none.places > 80 && none.outside == 0 && none.undecided == 0 && none.more.empty();
              const bool is_near = touching.code == 0 && near.places > 80 && near.outside == 0 &&
                                   2 * near.undecided == near.places && near.more.empty();
              const bool is_far = outside.code == 1 && far.places > 80 && 2 * far.outside == far.places && far.undecided == 0 &&
                                  far.more.starts_with("; farthest: cluster 0, vertex ") && far.more.ends_with(" s, by 0.25");
              return Checked(is_none && is_near && is_far, 3, untouched.out + touching.out + outside.out);
            });
}

// Returns what is wrong unless the summary and the file say of three clips' crossfades what belongs to the clips that they name.
std::string wrong_of_crossfades(const json& summary, const json& file) {
  std::string wrong;
  const auto expect = [&](bool is_so, const std::string& what) {
    if (!is_so) wrong += what + "; ";
  };
  const auto extras = [&](int clip) { return file["animations"][clip]["extras"]["refitlab"]; };
  expect(summary.at("tolerance") == 0.02 && summary.at("crossfade_tolerance") == 0.5, "the summary's tolerances");
  expect(summary.at("clips").size() == 3 && summary.at("crossfades").size() == 3, "as many clips or crossfades");
  for (int clip = 0; clip < 3; ++clip) {
    const json own = extras(clip), &said = summary["clips"][clip];
    expect(own["tolerance"] == 0.02 && own["crossfade_tolerance"] == 0.5, "a clip's tolerances");
    expect(own["rotations"] == "nlerp" && own["skinning"] == "linear", "how a clip is bounded");
    expect(said["name"] == "turn " + std::to_string(clip) && said["duration"] == 3.0, "a clip's name");
    expect(said["parts"][0]["box"] == own["box"] && said["parts"][0]["ball"] == own["ball"], "a clip's bound");
    expect(own["crossfades"].size() == 2, "a clip's crossfades");
  }
  std::size_t position = 0;
  for (int first = 0; first < 3; ++first)
    for (int second = first + 1; second < 3; ++second, ++position) {
      const json& said = summary["crossfades"][position];
      expect(said["first"] == "turn " + std::to_string(first) && said["second"] == "turn " + std::to_string(second),
             "a crossfade's clips: " + said["first"].dump() + " and " + said["second"].dump());
      for (const auto& [clip, other] : {std::pair(first, second), std::pair(second, first)}) {
        const json own = extras(clip), &fades = own["crossfades"];
        const auto with =
            std::find_if(fades.begin(), fades.end(), [other = other](const json& fade) { return fade["animation"] == other; });
        expect(with != fades.end() && (*with)["box"] == said["parts"][0]["box"], "a crossfade in the file");
      }
    }
  return wrong;
}

void crossfades_unless_asked_otherwise(Suite& t) {
  t.example("crossfades are by slerp, and as tight as is said, unless asked otherwise: in the file, its chunk and on the screen",
            {}, [] {
              const TemporaryFolder folder;
              const std::string in = folder.file("in.glb"), out = folder.file("out.glb");
              const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
              write_gltf(make_turning(80, {z, -z, y, x}), in);
              std::string wrong;
              for (const std::string rotations : {"", "slerp", "nlerp"}) {
                std::vector<std::string> arguments = {"bake", "--for", "crossfade", "--clusters", "4", in, out};
                if (!rotations.empty()) arguments.insert(arguments.begin() + 1, {"--rotations", rotations});
                const Called called = call(arguments);
                if (called.code != 0) return Checked(false, 0, called.errors);
                const BakedFile baked = read_baked(out);
                const std::string said = out + ": 2 triangles in " + std::to_string(baked.clusters.clusters.size()) +
                                         " clusters, 4 clips, 6 crossfades, linear skinning; ";
                if (!called.out.starts_with(said)) wrong += called.out;
                const bool is_nlerp = rotations == "nlerp";
                if (baked.rotations != (is_nlerp ? RotationBlend::nlerp : RotationBlend::slerp)) wrong += "the chunk; ";
                const json file = description_of(out);
                for (const json& clip : file["animations"]) {
                  const json& own = clip["extras"]["refitlab"];
                  if (own["rotations"] != (is_nlerp ? "nlerp" : "slerp") || own["tolerance"] != 0.01 ||
                      own["crossfade_tolerance"] != 0.2)
                    wrong += own["rotations"].dump() + ", " + own["tolerance"].dump() + ", " + own["crossfade_tolerance"].dump() +
                             "; ";
                }
              }
              return Checked(wrong.empty(), 3, wrong);
            });
}

void a_crossfade_of_one_clip(Suite& t) {
  t.example("crossfades that are asked for of one clip alone are none, and bake says so", {}, [] {
    const TemporaryFolder folder;
    std::string said;
    bool good = true;
    for (const int clips : {1, 2}) {
      const std::string in = folder.file(std::to_string(clips) + ".glb"), out = folder.file("out.glb");
      write_gltf(make_turning(80, std::vector<Eigen::Vector3d>(clips, Eigen::Vector3d::UnitX())), in);
      const Called called = call({"bake", "--for", "crossfade", in, out}), clip = call({"bake", in, out});
      const std::string note = "note: " + in + ": has fewer than two clips, between which there could be a crossfade\n";
      good = good && called.code == 0 && clip.code == 0 && (called.errors.find(note) != std::string::npos) == (clips == 1) &&
             clip.errors.find(note) == std::string::npos;
      said += called.errors + clip.errors;
    }
    return Checked(good, 4, said);
  });
}

void crossfades_of_three_clips(Suite& t) {
  t.example("of each crossfade both clips are looked at, and what is written of it is of both", {}, [] {
    const TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), bad = folder.file("bad.glb"),
                      to = folder.file("summary.json");
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
    write_gltf(make_turning(80, {z, -z, y}), in);
    const Called called = call({"bake", "--for", "crossfade", "--tolerance", "0.02", "--crossfade-tolerance", "0.5",
                                "--rotations", "nlerp", "--clusters", "4", "--json", to, in, out}),
                 checked = call({"check", "--samples", "50", out});
    if (called.code != 0 || checked.code != 0) return Checked(false, 0, called.errors + checked.out);
    std::string wrong = wrong_of_crossfades(json::parse(read_whole(to)), description_of(out));
    // A crossfade's box that is that of one clip is left in the other clip, by that crossfade alone.
    long tried = 0;
    for (std::size_t fade = 0; fade < 3; ++fade)
      for (const bool is_first : {true, false}) {
        std::string name;
        tamper(out, bad, [&](BakedFile& baked) {
          ClusterBounds& bounds = baked.clusters;
          ClusterBounds::Crossfade& tampered = bounds.crossfades[fade];
          tampered.clusters = bounds.clips[is_first ? tampered.first : tampered.second].clusters;
          name = "crossfade of '" + bounds.clips[tampered.first].name + "' and '" + bounds.clips[tampered.second].name + "': ";
        });
        const Called again = call({"check", "--samples", "50", bad});
        std::istringstream lines(again.out);
        long found = 0;
        for (std::string line; std::getline(lines, line);) {
          if (line.find("farthest: ") == std::string::npos) continue;
          found += line.starts_with(name) && weight_of_moment(line, read_baked(bad)) >= 0 ? 1 : 100;
        }
        if (again.code != 1 || found != 1) wrong += name + again.out;
        ++tried;
      }
    return Checked(wrong.empty(), tried, wrong);
  });
}

// Makes three joints, of which each clip scales the second by factors that are evenly spread over a second.
Model make_scaling(const std::vector<std::vector<double>>& factors_of_clips) {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Model model = gen::model_of_nodes("scaling", {{"a", -1, identity}, {"b", -1, identity}, {"c", -1, identity}});
  model.vertices = {{1, 0, 0}, {0, 1, 0.5}, {1, 1, 0}}, model.triangles = {{0, 1, 2}};
  model.influences = {{{0, 1}}, {{1, 1}}, {{2, 1}}};
  for (const std::vector<double>& factors : factors_of_clips) {
    NodeTrack track{1, {{{0, Eigen::Vector3d::Zero()}}}, {{{0, Eigen::Quaterniond::Identity()}}}, {}};
    for (std::size_t k = 0; k < factors.size(); ++k)
      track.scales.keys.push_back(
          {static_cast<double>(k) / static_cast<double>(factors.size() - 1), factors[k] * Eigen::Vector3d::Ones()});
    model.clips.push_back({"clip", 1, {}, {"clip", 1, {track}}});
  }
  return model;
}

void info_says_which_clips_are_rigid(Suite& t) {
  t.example(
      "info says of each clip whether it is rigid: one is not that scales a joint at its start, at its end or between", {}, [] {
        const TemporaryFolder folder;
        std::vector<std::vector<double>> clips = {std::vector<double>(5, 1)};
        for (std::size_t k = 0; k < 5; ++k) clips.push_back(clips[0]), clips.back()[k] = 2;
        write_gltf(make_scaling(clips), folder.file("in.glb"));
        const Called info = call({"info", folder.file("in.glb")});
        bool good = info.code == 0 && info.out.find("    #1 clip: 1 s, 7 keys, rigid\n") != std::string::npos;
        for (std::size_t k = 1; k < clips.size(); ++k)
          good = good && info.out.find("    #" + std::to_string(k + 1) + " clip: 1 s, 7 keys, not rigid: ") != std::string::npos;
        return Checked(good, static_cast<long>(clips.size()), info.out + info.errors);
      });
  t.example("a clip is not rigid that scales a joint at one of many keys alone", {}, [] {
    const TemporaryFolder folder;
    std::vector<std::vector<double>> clips = {std::vector<double>(33, 1)};
    // None of these is a quarter of the clip, nor the key next to one.
    for (const std::size_t k : {2, 5, 12, 19, 30}) clips.push_back(clips[0]), clips.back()[k] = 2;
    write_gltf(make_scaling(clips), folder.file("in.glb"));
    const Called info = call({"info", folder.file("in.glb")});
    bool good = info.code == 0 && info.out.find("    #1 clip: 1 s, 35 keys, rigid\n") != std::string::npos;
    for (std::size_t k = 1; k < clips.size(); ++k)
      good = good && info.out.find("    #" + std::to_string(k + 1) + " clip: 1 s, 35 keys, not rigid: ") != std::string::npos;
    return Checked(good, static_cast<long>(clips.size()), info.out + info.errors);
  });
}

void info_counts_what_is_in_a_file(Suite& t) {
  t.example("info says of a file what is in it, and bake how much of it is bounded", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), out = rich.folder.file("out.glb");
    const Model model = load_model(in, {.joints = Joints::affine, .morphs = Morphs::moving});
    const JointSets sets(model);
    const std::size_t triangles = model.triangles.size();
    std::size_t most = 0, keys = 0;
    for (const auto& influences : model.influences) most = std::max(most, influences.size());
    for (const NodeTrack& track : model.clips.at(0).animation.tracks)
      keys += track.positions.keys.size() + track.rotations.keys.size() + track.scales.keys.size();
    std::ostringstream expected;
    expected << in << "\n  triangles     " << triangles << "\n  vertices      " << model.vertices.size()
             << ", of different positions and weights\n  joints        " << model.joints.size() << "\n  joint-sets    "
             << sets.count() << ", of " << most << " joints at most\n  primitives    " << rich.gltf.primitives().size()
             << "\n  morph targets " << morph_targets(model).count << "\n  clips         1\n    #1 move: 2 s, " << keys
             << " keys, ";
    const Called info = call({"info", in});
    const std::string line = out + ": " + std::to_string(triangles) + " triangles in " +
                             std::to_string(read_baked(out).clusters.clusters.size()) +
                             " clusters, 1 clips, 0 crossfades, linear skinning; ";
    // Otherwise one number could stand for another.
    const bool differ = model.joints.size() != model.skeleton.nodes.size() && triangles != model.vertices.size();
    return Checked(info.code == 0 && info.out.starts_with(expected.str()) && rich.called.out.starts_with(line) && differ, 2,
                   info.out + rich.called.out);
  });
}

void info_says_what_was_baked(Suite& t) {
  t.example("info says of a baked file what was baked, and of others nothing", {}, [] {
    std::string wrong;
    const auto expect = [&](const std::vector<std::string>& options, const std::string& line) {
      const Rich rich(false, false, options);
      const std::string out = rich.folder.file("out.glb");
      const Called info = call({"info", out});
      const BakedFile baked = read_baked(out);
      const std::string nodes = baked.character ? std::to_string(baked.character->tree.nodes.size()) : "no";
      std::string text =
          "\n  baked         for linear skinning: " + std::to_string(baked.clusters.clusters.size()) + " clusters" + line;
      if (const std::size_t at = text.find('N'); at != std::string::npos) text.replace(at, 1, nodes);
      if (info.code != 0 || info.out.find(text + '\n') == std::string::npos) wrong += text + ": " + info.out + info.errors;
      if (call({"info", rich.folder.file("in.glb")}).out.find("baked") != std::string::npos)
        wrong += "a file that was not baked; ";
    };
    expect({}, ", a character of N nodes");
    expect({"--dop", "14", "--no-character"}, " in 14-DOPs, no character");
    expect({"--nodes"}, ", a character of N nodes with bounds over time");
    return Checked(wrong.empty(), 6, wrong);
  });
}

void what_a_summary_says(Suite& t) {
  t.example("a summary is of its file, and has the clips that there are, none of a file without", {}, [] {
    const Rich rich(true, true);
    const std::string in = rich.folder.file("in.glb"), out = rich.folder.file("out.glb"), to = rich.folder.file("summary.json"),
                      still = rich.folder.file("still.glb");
    redescribe(in, still, [](json& description) { description.erase("animations"); });
    std::string wrong;
    for (const std::string& file : {in, still}) {
      const Called called = call({"bake", "--clusters", "4", "--json", to, file, out});
      if (called.code != 0) return Checked(false, 0, called.errors);
      const json summary = json::parse(read_whole(to));
      const json clips = summary.value("clips", json());
      const Model model = load_model(file, {.joints = Joints::affine, .morphs = Morphs::moving});
      if (summary.at("file") != file || summary.at("skinning") != "linear" || summary.at("tolerance") != 0.01 ||
          summary.at("triangles") != model.triangles.size() || summary.at("vertices") != model.vertices.size() ||
          summary.at("moments") <= 0 || !clips.is_array() || clips.size() != model.clips.size() ||
          model.triangles.size() == model.vertices.size())
        wrong += summary.dump();
    }
    return Checked(wrong.empty(), 2, wrong);
  });
}

void what_is_said_of_a_file(Suite& t) {
  t.example("the summary of a bake says how long it took and how much memory, which is no less than what is there", {}, [] {
    const Rich rich(true, true);
    const std::string in = rich.folder.file("in.glb"), out = rich.folder.file("out.glb"), to = rich.folder.file("summary.json");
    const Called called = call({"bake", "--clusters", "4", "--json", to, in, out});
    const json summary = json::parse(read_whole(to));
    constexpr std::size_t megabyte = 1000000, room = 64 * megabyte;
    const std::vector<char> touched(room, 1);
    const double peak = peak_megabytes().value_or(0);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double bounding = summary.at("peak_megabytes_bounding"), all = summary.at("peak_megabytes");
    return Checked(called.code == 0 && summary.at("seconds") > 0 && 0 < bounding && bounding <= all && all <= peak &&
                       touched.back() == 1 && peak * megabyte >= room && peak * megabyte < 2 * 1024. * usage.ru_maxrss,
                   1,
                   std::to_string(bounding) + ", " + std::to_string(all) + ", " + std::to_string(peak) + " MB; " +
                       std::to_string(usage.ru_maxrss) + " kB");
  });
  t.example("info, collide and report say what they should of a file, and help what a command takes", {}, [] {
    const Rich rich(false, false, {"--report", "report.html"});
    const std::string in = rich.folder.file("in.glb");
    const Called info = call({"info", in}), collide = call({"collide", "--pairs", in, in}),
                 apart = call({"collide", in, in, "--at", "1000", "0", "0"});
    const std::string page = read_whole("report.html");
    std::filesystem::remove("report.html");
    std::string wrong;
    const auto expect = [&](bool is_so, const std::string& what) {
      if (!is_so) wrong += what + "; ";
    };
    expect(rich.called.code == 0, "bake: " + rich.called.errors);
    expect(info.code == 0 && info.out.find("clips         1\n") != std::string::npos, "info: " + info.out + info.errors);
    expect(collide.code == 0 && !collide.out.starts_with("0 "), "collide: " + collide.out + collide.errors);
    expect(call({"collide", "--pairs", in, in, "--at", "0", "0", "0"}).out == collide.out,
           "collide: in one place, as where nothing is said");
    expect(apart.out == "0 pairs of triangles touch\n", "apart: " + apart.out + apart.errors);
    expect(page.find("\"file\":\"in.glb\"") != std::string::npos && page.find("/*DATA*/") == std::string::npos, "the report");
    for (const char* command : {"bake", "info", "check", "collide"}) {
      const Called help = call({command, "--help"});
      expect(help.code == 0 && help.out.starts_with(std::string("usage: refitlab ") + command),
             "help: " + help.out + help.errors);
    }
    expect(call({"--help"}).code == 0 && call({}).code == 2, "no command");
    return Checked(wrong.empty(), 11, wrong);
  });
}

// Makes two triangles below a node that a clip scales by 0, from its start to its end.
Model make_hidden() {
  Model model = gen::model_of_nodes("hidden", {{"a", -1, Eigen::Matrix4d::Identity()}});
  model.vertices = {{1, 0, 0}, {0, 1, 0.5}, {1, 1, 0}, {0, 0, 1}};
  model.triangles = {{0, 1, 2}, {1, 2, 3}}, model.influences.assign(4, {{0, 1}});
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const NodeTrack track{0, {{{0, zero}}}, {{{0, Eigen::Quaterniond::Identity()}}}, {{{0, zero}, {1, zero}}}};
  model.clips.push_back({"clip", 1, {}, {"clip", 1, {track}}});
  return model;
}

// Makes the same triangles below a node that moves aside and back between two times of a clip, and stays before and after.
Model make_swing(double duration, double start, double end) {
  Model model = make_hidden();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  NodeTrack track{0, {}, {{{0, Eigen::Quaterniond::Identity()}}}, {{{0, Eigen::Vector3d::Ones()}}}};
  if (start > 0) track.positions.keys.push_back({0, zero});
  track.positions.keys.insert(track.positions.keys.end(), {{start, zero}, {(start + end) / 2, {0, 3, 0}}, {end, zero}});
  if (end < duration) track.positions.keys.push_back({duration, zero});
  model.clips = {{"clip", duration, {}, {"clip", duration, {track}}}};
  return model;
}

void what_sampling_misses(Suite& t) {
  t.example("what moves between two sampled times alone is missed, between whichever two, and what moves at one is not", {}, [] {
    constexpr double step = 1 / sampled_rate;
    struct Swing {
      double duration, start, end;
      bool is_missed;
    };
    std::string wrong;
    long tried = 0;
    for (const Swing& s :
         {Swing{0.99, 0, step, true}, Swing{0.99, 14 * step, 15 * step, true}, Swing{0.99, 28 * step, 29 * step, true},
          Swing{0.99, 29 * step, 0.99, true}, Swing{0.02, 0, 0.02, true}, Swing{1, 29 * step, 1, true},
          Swing{0.99, 13.5 * step, 14.5 * step, false}, Swing{0.99, 28.5 * step, 29.5 * step, false}}) {
      const Model model = make_swing(s.duration, s.start, s.end);
      const ModelBounds bounds = bound_model(model, {.cluster_triangles = 4});
      const SampledMisses by_keys = misses_of_sampling(model, bounds, 0, Sampling::keys),
                          by_rate = misses_of_sampling(model, bounds, 0, Sampling::fixed_rate);
      if (by_keys.clusters != 0) wrong += "missed by keys; ";
      // The vertex leaves a box of one unit by three units.
      const bool is_found = by_rate.clusters == 1 && by_rate.worst == 0 && std::abs(by_rate.by - 3) < 1e-9 &&
                            std::abs(by_rate.time - (s.start + s.end) / 2) < 1e-9;
      if (s.is_missed ? !is_found : by_rate.clusters != 0)
        wrong += "from " + std::to_string(s.start) + " s: " + std::to_string(by_rate.clusters) + " clusters, by " +
                 std::to_string(by_rate.by) + " at " + std::to_string(by_rate.time) + " s; ";
      ++tried;
    }
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    const Model turning = make_turning(170, {z, z, z});
    const ModelBounds bounds = bound_model(turning, {.cluster_triangles = 4});
    for (std::size_t clip = 0; clip < 3; ++clip, ++tried) {
      const SampledMisses by_keys = misses_of_sampling(turning, bounds, clip, Sampling::keys);
      if (by_keys.clusters != 1 || !(clip < by_keys.time && by_keys.time < static_cast<double>(clip + 1)))
        wrong += "between keys; ";
    }
    return Checked(wrong.empty(), tried, wrong);
  });
}

// Returns the data that a report's page shows.
json data_of_page(const std::string& page) {
  const std::string before = "const data = ";
  const std::size_t start = page.find(before) + before.size();
  return json::parse(page.substr(start, page.find(";\n", start) - start));
}

// Makes three joints with four triangles each, each farther from the origin than the one before. In the first clip each turns
// farther than the one before, and in the second only the second turns.
Model make_turning_parts() {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Model model = gen::model_of_nodes("parts", {{"a", -1, identity}, {"b", -1, identity}, {"c", -1, identity}});
  for (int joint = 0; joint < 3; ++joint) {
    const int first = static_cast<int>(model.vertices.size());
    const double away = 10 * joint;
    for (const Point3& p :
         {Point3(1, 0, 0), Point3(2, 0, 0.5), Point3(1.5, 0.25, 1), Point3(1, 0, 1.5), Point3(0.5, 0.25, 1), Point3(0.5, 0, 0.5)})
      model.vertices.push_back(p + Point3(away, 0, 0)), model.influences.push_back({{joint, 1}});
    for (int k = 1; k < 5; ++k) model.triangles.push_back({first, first + k, first + k + 1});
  }
  for (int clip = 0; clip < 2; ++clip) {
    const std::string name = "clip " + std::to_string(clip);
    Animation animation{name, 2, {}};
    for (int joint = 0; joint < 3; ++joint) {
      const double degrees = clip == 0 ? 100 + 30 * joint : joint == 1 ? 100 : 0;
      const Eigen::Quaterniond still = Eigen::Quaterniond::Identity(),
                               turned(Eigen::AngleAxisd(degrees / 180 * 3.141592653589793, Eigen::Vector3d::UnitZ()));
      animation.tracks.push_back(
          {joint, {{{0, Eigen::Vector3d::Zero()}}}, {{{0, still}, {1, turned}, {2, still}}}, {{{0, Eigen::Vector3d::Ones()}}}});
    }
    model.clips.push_back({name, 2, {}, animation});
  }
  return model;
}

// Returns what a page says of one clip that is not about these misses, or a box that is not of these parts.
std::string wrong_of_clip(const json& said, const Model& model, const ModelBounds& bounds, std::size_t clip) {
  std::string wrong;
  for (const auto& [name, sampling] : {std::pair("keys", Sampling::keys), std::pair("rate", Sampling::fixed_rate)}) {
    const SampledMisses misses = misses_of_sampling(model, bounds, clip, sampling);
    const json expected = {{"clusters", misses.clusters}, {"worst", misses.worst}, {"by", misses.by}, {"time", misses.time}};
    if (said[name] != expected) wrong += name + (": " + said[name].dump()) + " for " + expected.dump() + "; ";
  }
  std::size_t cluster = 0;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    if (bounds.parts[p].kind != PartKind::cluster) continue;
    const Box<float>& box = bounds.clips[clip].parts[p].box;
    const json& shown = said["boxes"][cluster++];
    for (int i = 0; i < 3; ++i)
      if (shown[static_cast<std::size_t>(i)] != static_cast<double>(box.low[i]) ||
          shown[static_cast<std::size_t>(3 + i)] != static_cast<double>(box.high[i]))
        wrong += "a box is another one; ";
  }
  if (said["boxes"].size() != cluster) wrong += "other clusters; ";
  return wrong;
}

void reports_show_each_cluster(Suite& t) {
  t.example(
      "the report has each cluster's own box, its triangles in it in all frames, and what sampling misses of each clip", {}, [] {
        const Model model = make_turning_parts();
        const ModelBounds bounds = bound_model(model, {.cluster_triangles = 4});
        const json data = data_of_page(report_page(model, bounds, "parts.glb"));
        const std::vector<int> cluster_of = numbers_of(data["cluster_of"], 4), corners = numbers_of(data["triangles"], 4);
        if (data["clips"].size() != 2 || data["clusters"] < 3 || corners.size() != 3 * cluster_of.size())
          return Checked(false, 0, data.dump().substr(0, 500));
        std::string wrong;
        long tried = 0, missed = 0;
        for (std::size_t c = 0; c < 2; ++c) {
          const json& clip = data["clips"][c];
          wrong += wrong_of_clip(clip, model, bounds, c);
          const int count = clip["keys"]["clusters"], all = data["clusters"];
          if (c == 0 ? count != all : count == 0 || count == all) wrong += "as many clusters; ";
          const std::vector<int> places = numbers_of(clip["positions"]);
          const std::size_t size = 3 * model.vertices.size();
          for (std::size_t frame = 0; frame < data["frames"].get<std::size_t>(); ++frame)
            for (std::size_t k = 0; k < corners.size(); ++k) {
              const json& box = clip["boxes"].at(static_cast<std::size_t>(cluster_of[k / 3]));
              for (std::size_t i = 0; i < 3; ++i, ++tried) {
                const double low = clip["box"][i], side = clip["box"][3 + i].get<double>() - low, bit = side / 65535;
                const double at = low + places.at(frame * size + 3 * static_cast<std::size_t>(corners[k]) + i) * bit;
                missed += at < box[i].get<double>() - bit || at > box[3 + i].get<double>() + bit;
              }
            }
        }
        return Checked(wrong.empty() && missed == 0 && tried > 1000, tried, wrong + std::to_string(missed) + " are outside");
      });
}

void reports_and_progress(Suite& t) {
  t.example("the report has the clusters, each clip's frames from its start to its end, and times of the clip alone", {}, [] {
    const TemporaryFolder folder;
    const std::string in = folder.file("in.glb");
    write_gltf(keyed(make_man(), 4), in);
    const Called called = call({"bake", in, folder.file("out.glb"), "--report", folder.file("report.html")});
    if (called.code != 0) return Checked(false, 0, called.errors);
    const json data = data_of_page(read_whole(folder.file("report.html")));
    const Model model = load_model(in);
    std::string wrong;
    if (data["clips"].size() != model.clips.size()) return Checked(false, 1, "not all clips");
    const std::vector<int> cluster_of = numbers_of(data["cluster_of"], 4);
    std::vector<bool> is_there(data["clusters"].get<std::size_t>(), false);
    for (const int c : cluster_of) is_there.at(static_cast<std::size_t>(c)) = true;
    if (is_there.size() < 2 || std::count(is_there.begin(), is_there.end(), false) > 0) wrong += "a cluster has no triangle; ";
    if (cluster_of.size() != model.triangles.size()) wrong += "not each triangle is in a cluster; ";
    const JointSets sets(model);
    long charts = 0, tried = 0;
    for (std::size_t c = 0; c < model.clips.size(); ++c) {
      const json& clip = data["clips"][c];
      const double duration = model.clips[c].duration;
      const std::vector<int> frames = numbers_of(clip["positions"]);
      const std::size_t size = 3 * model.vertices.size(), count = frames.size() / size;
      if (count != data["frames"].get<std::size_t>()) wrong += "other frames than it says; ";
      for (const std::size_t f : {std::size_t(0), count / 3, count - 1}) {
        const Pose pose = model.clips[c].sample(duration * static_cast<double>(f) / static_cast<double>(count - 1));
        const auto points = skin(model, sets, make_skinning_palette(model, sets, pose, Skinning::linear), Skinning::linear);
        for (std::size_t v = 0; v < points.size(); ++v)
          for (int i = 0; i < 3; ++i, ++tried) {
            const double low = clip["box"][i], side = clip["box"][3 + i].get<double>() - low;
            const int shown = frames[f * size + 3 * v + static_cast<std::size_t>(i)];
            if (std::abs(low + side * shown / 65535 - points[v][i]) > side * 1e-4)
              return Checked(false, tried, "a vertex is elsewhere");
          }
      }
      if (!clip.contains("chart")) continue;
      ++charts;
      // With the sign of the side that the chart shows, a value is the higher, the farther out it is.
      const double sign = clip["chart"]["low"].get<bool>() ? -1 : 1;
      const std::vector<double> keys = clip["chart"]["keys"];
      double last = -1, of_keys = -1e300, of_all = of_keys;
      for (const json& point : clip["chart"]["curve"]) {
        if (point[0].get<double>() <= last) wrong += "times of the chart are not in order; ";
        last = point[0], of_all = std::max(of_all, sign * point[1].get<double>());
        if (std::find(keys.begin(), keys.end(), last) != keys.end()) of_keys = std::max(of_keys, sign * point[1].get<double>());
      }
      if (of_keys != sign * clip["chart"]["of_keys"].get<double>()) wrong += "a chart says another box of its keys; ";
      if (of_all < of_keys || of_all > sign * clip["chart"]["bound"].get<double>())
        wrong += "a chart's bound is less than its curve; ";
      if (std::abs(last - duration) > 1e-9 || clip["chart"]["curve"][0][0] != 0) wrong += "a chart is not of the whole clip; ";
    }
    return Checked(wrong.empty() && charts > 0, tried, wrong + std::to_string(charts) + " charts");
  });
  t.example("a bar of progress is shown to who wants it alone", {}, [] {
    std::ostringstream silent, shown;
    for (std::ostringstream* to : {&silent, &shown}) {
      ProgressBar bar(*to, to == &shown);
      for (const double share : {0.0, 0.25, 0.251, 1.0}) bar.show(share);
    }
    const std::string text = shown.str();
    return Checked(silent.str().empty() && text.find("] 25 %") != std::string::npos &&
                       text.find("] 100 %") != std::string::npos && std::count(text.begin(), text.end(), '%') == 3,
                   2, text);
  });
}

void collide_writes_pairs_and_certificates(Suite& t) {
  t.example("collide finds the pairs of a file whose joints scale and whose morph weights move, by the file's own formulas", {},
            [] {
              const Rich rich(true, true);
              const std::string in = rich.folder.file("in.glb"), pairs = rich.folder.file("pairs.json");
              std::vector<Triangle> triangles;
              const auto points_at = [&](double time, const Eigen::Vector3d& at) {
                std::vector<Point3> out;
                triangles.clear();
                for (const auto& primitive : rich.gltf.primitives()) {
                  const int first = static_cast<int>(out.size());
                  for (const Eigen::Vector3d& v : rich.gltf.posed(primitive, time)) out.push_back(v + at);
                  for (const auto& t : primitive.triangles) triangles.push_back({first + t[0], first + t[1], first + t[2]});
                }
                return out;
              };
              std::string found;
              long total = 0;
              // The times include the clip's start and its end.
              for (const auto& [offset, time] : {std::pair(0.0625, 1.25), {0.5, 1.25}, {0.0625, 0.0}, {0.0625, 2.0}}) {
                const auto a = points_at(time, {0, 0, 0}), b = points_at(0.5, {offset, -0.03, -0.01});
                const auto expected = oracle::all_pairs(triangles, a, triangles, b).size();
                const std::string at = std::to_string(time);
                const Called called = call({"collide", "--clip-a", "move", "--time-a", at, "--clip-b", "move", "--time-b", "0.5",
                                            "--json", pairs, in, in, "--at", std::to_string(offset), "-0.03", "-0.01"});
                if (called.code != 0) return Checked(false, 0, called.errors);
                const std::size_t count = json::parse(read_whole(pairs)).at("pairs").size();
                total += static_cast<long>(expected);
                if (count != expected) found += std::to_string(count) + " pairs for " + std::to_string(expected) + "; ";
                for (const char* skinning : {"dual-quaternion", "spherical"})
                  if (const Called two = call({"collide", "--skinning", skinning, "--clip-a", "move", "--time-a", at, in, in});
                      two.code != 0)
                    found += two.errors;
              }
              return Checked(found.empty() && total > 5, total, found);
            });
  t.example("collide writes the pairs that it prints, and a certificate of them that is accepted against its documents", {}, [] {
    const Rich rich(false, false);
    const TemporaryFolder& folder = rich.folder;
    const std::string in = folder.file("in.glb"), pairs = folder.file("pairs.json"), why = folder.file("why.json");
    std::string wrong;
    long printed = 0;
    for (const char* skinning : {"linear", "dual-quaternion", "spherical"}) {
      const Called called = call({"collide", "--pairs", "--skinning", skinning, "--clip-a", "move", "--time-a", "0", "--json",
                                  pairs, "--certificate", why, "--documents", folder.file("body"), in, in});
      if (called.code != 0) return Checked(false, 0, called.errors);
      const json summary = json::parse(read_whole(pairs)), certificate = json::parse(read_whole(why));
      std::ostringstream lines;
      lines << summary.at("pairs").size() << " pairs of triangles touch\n";
      for (const json& pair : summary.at("pairs")) lines << pair[0] << ' ' << pair[1] << '\n';
      printed += static_cast<long>(summary.at("pairs").size());
      if (lines.str() != called.out || summary.at("skinning") != skinning ||
          summary.at("first") != "in.glb, clip move at 0.000000 s" || summary.at("second") != "in.glb at rest" ||
          certificate.at("second").at("name") != "in.glb at rest")
        wrong += "the pairs; ";
      const auto checked = oracle::run_checker(
          "--against " + folder.file("body.first") + " " + folder.file("body.second") + " " + why, oracle::pairs_checker());
      if (checked.lines.size() != 1 || !checked.lines[0].starts_with("accepted: ")) wrong += "the certificate; ";
    }
    const Called both = call({"collide", "--clip-a", "move", "--time-a", "1.25", "--clip-b", "move", "--time-b", "0.5", "--json",
                              pairs, "--certificate", why, in, in});
    const json summary = json::parse(read_whole(pairs)), certificate = json::parse(read_whole(why));
    for (const auto& [side, name] :
         {std::pair("first", "in.glb, clip move at 1.250000 s"), {"second", "in.glb, clip move at 0.500000 s"}})
      if (both.code != 0 || summary.at(side) != name || certificate.at(side).at("name") != name) wrong += name;
    const Called unwritten = call({"collide", "--certificate", in + "/why.json", in, in});
    if (unwritten.code != 3 || unwritten.errors.find("in.glb") == std::string::npos) wrong += unwritten.errors;
    return Checked(wrong.empty() && printed > 0, printed, wrong);
  });
}

// Makes a file of a triangle that one of three joints moves by a matrix, and of the same triangle, so far away, which the others
// hold.
std::string file_of_moved(const TemporaryFolder& folder, const std::string& name, const Eigen::Matrix4d& by,
                          const std::vector<Point3>& corners, double away) {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Model model = gen::model_of_nodes("three", {{"a", -1, identity}, {"b", -1, by}, {"c", -1, identity}});
  model.vertices = corners, model.triangles = {{0, 1, 2}, {3, 4, 5}}, model.influences.assign(3, {{1, 1}});
  for (const Point3& p : corners) model.vertices.push_back(p - Point3(away, 0, 0));
  model.influences.resize(6, {{0, 1}}), model.influences[4] = {{2, 1}};
  write_gltf(model, folder.file(name));
  return folder.file(name);
}

void collide_scales_before_it_turns(Suite& t) {
  t.example("collide has a triangle of a joint that scales and turns where the file has it, in every skinning", {}, [] {
    const TemporaryFolder folder;
    const std::vector<Point3> corners = {{4, -1, -1}, {4, 1, -1}, {4, 0, 1}};
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    std::string wrong;
    long tried = 0;
    for (const Eigen::Vector3d& factors : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(0.25, 0.25, 0.25),
                                           Eigen::Vector3d(3, 1, 0.5), Eigen::Vector3d(-2, 1, 1)}) {
      Eigen::Matrix4d by = Eigen::Matrix4d::Identity();
      by.topLeftCorner<3, 3>() = turn * factors.asDiagonal();
      std::vector<Point3> moved;
      for (const Point3& p : corners) moved.push_back((by * p.homogeneous()).head<3>());
      // This triangle crosses the moved one in the middle, and no other.
      const Point3 middle = (moved[0] + moved[1] + moved[2]) / 3, side = (moved[1] - moved[0]).normalized() / 32,
                   up = side.cross(Point3(moved[2] - moved[0])).normalized() / 8;
      const std::string first = file_of_moved(folder, "moved.glb", by, corners, 1000),
                        second = file_of_moved(folder, "needle.glb", Eigen::Matrix4d::Identity(),
                                               {middle + up, middle - up, middle - up + side}, 2000);
      for (const char* skinning : {"linear", "dual-quaternion", "spherical"}) {
        const Called called = call({"collide", "--pairs", "--skinning", skinning, first, second});
        if (called.code != 0 || called.out != "1 pairs of triangles touch\n0 0\n")
          wrong += called.errors + skinning + ": " + called.out;
        ++tried;
      }
    }
    return Checked(wrong.empty(), tried, wrong);
  });
}

void strange_names_and_joints(Suite& t) {
  t.example("files are named as they are in what is written, in UTF-8 or not", {}, [] {
    const Rich rich(false, false);
    const TemporaryFolder& folder = rich.folder;
    const std::string strange = folder.file("a\xff.glb"), out = folder.file("out.glb"), summary = folder.file("s.json"),
                      page = folder.file("r.html");
    write_whole(strange, read_whole(folder.file("in.glb")));
    const Called baked = call({"bake", "--json", summary, "--report", page, strange, out}),
                 collided = call({"collide", "--json", folder.file("c.json"), strange, strange});
    const bool are_there = json::parse(read_whole(summary)).contains("clips") && !read_whole(page).empty() &&
                           json::parse(read_whole(folder.file("c.json"))).contains("pairs");
    return Checked(baked.code == 0 && collided.code == 0 && are_there, 3, baked.errors + collided.errors);
  });
  t.example("a cluster that a scale of 0 hides is missed by no sampling", {}, [] {
    const Model model = make_hidden();
    const ModelBounds bounds = bound_model(model, {.cluster_triangles = 4});
    const SampledMisses misses = misses_of_sampling(model, bounds, 0, Sampling::keys);
    return Checked(misses.clusters == 0 && misses.by == 0, 1, std::to_string(misses.clusters) + " clusters");
  });
  t.example("collide takes joints as they are, be they rigid but for a thousandth", {}, [] {
    const TemporaryFolder folder;
    long touching = 0;
    // There is a triangle at x = 100, by a joint of this scale, and one from about 100.06 to 100.25 that crosses it where it is
    // after scaling by 1.001.
    for (const double scale : {1.0, 1.001}) {
      const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
      Eigen::Matrix4d local = identity;
      local.topLeftCorner<3, 3>() *= scale;
      const Called called =
          call({"collide", file_of_moved(folder, "a.glb", local, {{100, -1, -1}, {100, 1, -1}, {100, 0, 1}}, 150),
                file_of_moved(folder, "b.glb", identity, {{100.0625, -0.25, 0}, {100.25, 0, 0}, {100.0625, 0.25, 0}}, 250)});
      if (called.code != 0) return Checked(false, 0, called.errors);
      touching += called.out.starts_with("1 pair") ? (scale > 1 ? 1 : 100) : 0;
    }
    return Checked(touching == 1, 2, std::to_string(touching));
  });
}

void collide_tells_of_long_certificates(Suite& t) {
  t.example("collide says of a certificate that checkers refuse for its length that they do, and nothing of others", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), why = rich.folder.file("why.json"), other = rich.folder.file("other.glb");
    // The certificate has the clip's name.
    const std::string name(most_certificate_bytes, 'n');
    redescribe(in, other, [&](json& description) { description["animations"][0]["name"] = name; });
    const Called longer = call({"collide", "--clip-a", name, "--certificate", why, other, in});
    const std::string said = "note: " + why + ": is refused by checkers of certificates: the file has more than 16777216 bytes";
    const bool is_said = longer.code == 0 && longer.errors.find(said) != std::string::npos;
    const auto refused = oracle::run_checker(why, oracle::pairs_checker());
    const bool is_refused = refused.lines.size() == 1 && refused.lines[0].ends_with("the file has more than 16777216 bytes");
    const Called shorter = call({"collide", "--certificate", why, in, in});
    return Checked(is_said && is_refused && shorter.code == 0 && shorter.errors.find("bytes") == std::string::npos, 2,
                   longer.errors.substr(0, 200) + shorter.errors);
  });
}

void options_of_what_is_not_asked_for(Suite& t) {
  t.example("options that would say nothing are refused by name", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), out = rich.folder.file("never.glb");
    std::string wrong;
    const auto fails = [&](const std::vector<std::string>& arguments, const std::string& reason) {
      const Called called = call(arguments);
      if (called.code != 2 || called.errors.find(reason) == std::string::npos || std::filesystem::exists(out))
        wrong += reason + ": " + std::to_string(called.code) + " " + called.errors + "; ";
    };
    fails({"bake", "--rotations", "slerp", in, out}, "--rotations is that of crossfades");
    fails({"bake", "--for", "any", "--crossfade-tolerance", "0.2", in, out}, "--crossfade-tolerance is that of crossfades");
    fails({"collide", "--time-a", "1", in, in}, "--time-a is that of a clip: --clip-a names it");
    fails({"collide", "--clip-a", "move", "--time-b", "0", in, in}, "--time-b is that of a clip: --clip-b names it");
    return Checked(wrong.empty(), 4, wrong);
  });
}

void numbers_beyond_either_end(Suite& t) {
  t.example("numbers beyond either end of what an option takes are refused, and the ends are taken", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), baked = rich.folder.file("out.glb"), out = rich.folder.file("never.glb");
    std::string wrong;
    long tried = 0;
    const auto says = [&](int code, const std::vector<std::string>& arguments, const std::string& option,
                          const std::vector<std::string>& values, const std::string& reason) {
      for (const std::string& value : values) {
        std::vector<std::string> all = arguments;
        all.insert(all.begin() + 1, option + "=" + value);
        const Called called = call(all);
        if (called.code != code || called.errors.find(reason) == std::string::npos || std::filesystem::exists(out) != (code == 0))
          wrong += option + " " + value + ": " + std::to_string(called.code) + " " + called.errors + "; ";
        std::filesystem::remove(out);
        ++tried;
      }
    };
    const std::vector<std::string> bake = {"bake", "--quiet", in, out}, check = {"check", baked},
                                   fade = {"bake", "--for", "crossfade", in, out},
                                   none = {"-1", "0", "1e-300", "9.9e-7", "1.001", "nan", "inf"};
    says(2, bake, "--clusters", {"-4", "1", "3", "510", "516"}, "a multiple of 4 from 4 to 512, or 0");
    says(0, bake, "--clusters", {"0", "4", "512"}, "");
    says(2, bake, "--tolerance", none, "--tolerance takes a number from 1e-6 to 1; bounds leave more room");
    says(0, bake, "--tolerance", {"1e-6", "1"}, "");
    says(2, fade, "--crossfade-tolerance", none, "--crossfade-tolerance takes a number from 1e-6 to 1; bounds leave more room");
    says(2, bake, "--dop", {"-6", "0", "4", "10", "28"}, "--dop takes 6, 14, 18 or 26");
    says(2, check, "--samples", {"-1", "0", "10000001", "2000000000"}, "--samples takes a number from 1 to 10000000");
    says(2, check, "--seed", {"-1", "4294967296", "-4294967296"}, "--seed takes a number from 0 to 4294967295");
    for (const char* seed : {"0", "4294967295"})
      if (const Called called = call({"check", "--samples", "3", "--seed", seed, baked}); called.code != 0)
        wrong += called.errors;
    for (const std::string side : {"a", "b"}) {
      const std::vector<std::string> collide = {"collide", "--clip-" + side, "move", "--json", out, in, in};
      says(2, collide, "--time-" + side, {"-1e-9", "2.000001", "-inf", "inf", "nan"}, "the clip goes from 0 to 2");
      says(0, collide, "--time-" + side, {"0", "2"}, "");
    }
    return Checked(wrong.empty(), tried, wrong);
  });
}

void ends_of_clips_as_printed(Suite& t) {
  t.example("the end of a clip is taken as info and collide print it, whatever its digits", {}, [] {
    const TemporaryFolder folder;
    static const std::regex printed(R"(#1 clip: ([^ ]*) s, )"), said(R"(the clip goes from 0 to ([^ ]*) s)");
    const std::string in = folder.file("in.glb");
    std::string wrong;
    long tried = 0;
    for (const double duration : {2.0 / 3, 25.0 / 24, 0.1, 1e-5, 12345.678, 3.0}) {
      write_gltf(make_swing(duration, 0, duration), in);
      const Called info = call({"info", in}), beyond = call({"collide", "--clip-a", "clip", "--time-a", "1e6", in, in});
      std::smatch own, other;
      if (!std::regex_search(info.out, own, printed) || beyond.code != 2 || !std::regex_search(beyond.errors, other, said) ||
          own[1] != other[1])
        return Checked(false, tried, info.out + beyond.errors);
      const Called at_end = call({"collide", "--clip-a", "clip", "--time-a", own[1].str(), in, in});
      if (at_end.code != 0) wrong += at_end.errors;
      ++tried;
    }
    return Checked(wrong.empty(), tried, wrong);
  });
}

void files_named_twice(Suite& t) {
  t.example("a file that is written is no other file of the call, however its path is written, and has a name", {}, [] {
    const Rich rich(false, false);
    const TemporaryFolder& folder = rich.folder;
    const std::string in = folder.file("in.glb"), out = folder.file("never.glb"), other = folder.file("other.json"),
                      body = folder.file("body"),
                      again = folder.path() + "/../" + std::filesystem::path(folder.path()).filename().string(),
                      link = folder.file("link"), bytes = read_whole(in);
    std::filesystem::create_directory_symlink(folder.path(), link);
    std::string wrong;
    long tried = 0;
    const auto fails = [&](const std::vector<std::string>& arguments, const std::string& reason) {
      const Called called = call(arguments);
      if (called.code != 2 || called.errors.find(reason) == std::string::npos || std::filesystem::exists(out) ||
          std::filesystem::exists(other) || read_whole(in) != bytes)
        wrong += reason + ": " + std::to_string(called.code) + " " + called.errors + "; ";
      ++tried;
    };
    for (const std::string option : {"--json", "--report", "--certificate"}) {
      fails({"bake", option, in, in, out}, option + " is the file of IN.glb, too");
      for (const std::string& path : {out, again + "/never.glb", link + "/never.glb", std::filesystem::relative(out).string()})
        fails({"bake", option, path, in, out}, option + " is the file of OUT.glb, too");
      fails({"bake", option, "", in, out}, option + " takes a file");
    }
    fails({"bake", in, ""}, "OUT.glb takes a file");
    fails({"bake", "--json", other, "--report", other, in, out}, "--report is the file of --json, too");
    fails({"bake", "--certificate", link + "/other.json", "--json", other, in, out}, "--certificate is the file of --json, too");
    for (const std::string option : {"--json", "--certificate"}) {
      fails({"collide", option, in, in, out}, option + " is the file of A, too");
      fails({"collide", option, in, out, in}, option + " is the file of B, too");
      for (const char* end : {".first", ".second"})
        fails({"collide", option, body + end, "--documents", body, in, in}, "--documents is the file of " + option + ", too");
    }
    fails({"collide", "--certificate", other, "--json", other, in, in}, "--certificate is the file of --json, too");
    fails({"collide", "--documents", "", in, in}, "--documents takes a file");
    // The names of documents have ends of their own.
    const Called named = call({"collide", "--documents", in, "--json", folder.file("pairs.json"), in, in});
    if (named.code != 0 || read_whole(in) != bytes || read_whole(in + ".first").empty()) wrong += named.errors;
    return Checked(wrong.empty(), tried, wrong);
  });
}

void help_of_each_command(Suite& t) {
  t.example("every command takes -h for --help, but no file of that name for it", {}, [] {
    std::string wrong;
    for (const char* command : {"bake", "info", "check", "collide"}) {
      const Called longer = call({command, "--help"}), shorter = call({command, "-h"});
      if (shorter.code != 0 || shorter.out != longer.out || !shorter.out.starts_with("usage: ") || !shorter.errors.empty())
        wrong += shorter.out + shorter.errors;
    }
    const Called file = call({"info", "--", "-h"});
    if (file.code != 3 || file.errors.find("-h: file: ") == std::string::npos) wrong += file.errors;
    return Checked(wrong.empty(), 5, wrong);
  });
}

void what_is_behind_a_chunk(Suite& t) {
  t.example("behind a baked chunk there are up to three zeros, and nothing else", {}, [] {
    const Rich rich(false, false);
    const std::string chunk = chunk_of(read_baked(rich.folder.file("out.glb")));
    std::string said;
    for (std::size_t zeros = 0; zeros < 4; ++zeros) baked_of(chunk + std::string(zeros, '\0'), "out.glb");
    for (const std::string& more : {std::string("x"), std::string("\0\0x", 3), std::string(4, '\0')}) try {
        baked_of(chunk + more, "out.glb");
        return Checked(false, 7, "not refused");
      } catch (const ModelError& e) {
        if (e.what() != std::string("out.glb: chunk of refitlab: goes on after its end")) said += e.what();
      }
    return Checked(said.empty(), 7, said);
  });
}

void what_a_bake_leaves_in_order(Suite& t) {
  t.example("a file without a chunk of buffers gets one before the bounds, which readers look for in the second place", {}, [] {
    TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb");
    const std::string text = gen::built(gen::bending_tube(3)).text_file();
    write_whole(in, glb_of({{json_chunk, text}}, in));
    const Called bake = call({"bake", in, out}), again = call({"bake", out, in}), check = call({"check", in});
    const std::vector<GlbChunk> chunks = read_glb(read_whole(in), in);
    return Checked(bake.code == 0 && again.code == 0 && check.code == 0 && chunks.size() == 3 && chunks[1].type == bin_chunk &&
                       chunks[1].data.size() == 4 && chunks[2].type == refitlab_chunk && read_whole(in) == read_whole(out),
                   2, bake.errors + again.errors + check.errors);
  });
  t.example("bounds of what the scene does not show any more are removed, and null extras make way", {}, [] {
    TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), moved = folder.file("moved.glb");
    json description = json::parse(gen::built(gen::bending_tube(3)).text_file());
    description["meshes"].push_back(description["meshes"][0]);
    description["meshes"][0]["extras"] = nullptr, description["meshes"][1]["extras"] = {{"mine", 1}};
    description["nodes"].push_back({{"mesh", 1}});
    const std::size_t other = description["nodes"].size() - 1;
    description["scenes"].push_back(description["scenes"][0]);
    description["scenes"][1]["nodes"].push_back(other);
    description["scene"] = 1;
    write_whole(in, glb_of({{json_chunk, description.dump()}}, in));
    const Called bake = call({"bake", in, out});
    const json baked = description_of(out);
    redescribe(out, moved, [](json& d) { d["scene"] = 0; });
    const Called again = call({"bake", moved, out});
    const json after = description_of(out);
    const auto is_bounded = [](const json& mesh) { return mesh.contains("extras") && mesh["extras"].contains("refitlab"); };
    bool good = bake.code == 0 && again.code == 0 && after["meshes"][1]["extras"] == json({{"mine", 1}});
    for (const int m : {0, 1}) {
      good = good && is_bounded(baked["meshes"][m]) && is_bounded(baked["meshes"][m]["primitives"][0]);
      good = good && is_bounded(after["meshes"][m]) == (m == 0) && is_bounded(after["meshes"][m]["primitives"][0]) == (m == 0);
    }
    return Checked(good, 8, bake.errors + again.errors + after["meshes"].dump().substr(0, 300));
  });
  t.example("who may read a file may read what comes in its place", {}, [] {
    const Rich rich(false, false);
    const std::string file = rich.folder.file("in.glb");
    namespace fs = std::filesystem;
    bool good = true;
    for (const fs::perms perms :
         {fs::perms::owner_read | fs::perms::owner_write, fs::perms::owner_all | fs::perms::others_read}) {
      fs::permissions(file, perms);
      good = good && call({"bake", file, file}).code == 0 && fs::status(file).permissions() == perms;
    }
    return Checked(good, 2);
  });
}

void what_a_bake_refuses_or_says(Suite& t) {
  t.example("a clip that is too long to be sampled is refused for a report, before anything is written", {}, [] {
    TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), out = folder.file("out.glb"), report = folder.file("report.html");
    gen::RiggedGltf rig = gen::bending_tube(3);
    rig.clips[0].tracks[0].times.back() = 1e9f;
    gen::write_glb(rig, in);
    const Called with = call({"bake", "--report", report, in, out});
    const bool is_nothing_written = !std::filesystem::exists(out) && !std::filesystem::exists(report);
    const Called without = call({"bake", in, out});
    return Checked(with.code == 3 && with.errors.find("clip 'bend': it is longer than an hour") != std::string::npos &&
                       is_nothing_written && without.code == 0,
                   2, with.errors + without.errors);
  });
  t.example("files that another one names are told of where it goes to another folder without them", {}, [] {
    TemporaryFolder folder;
    const std::string in = folder.file("in.glb"), beside = folder.file("out.glb"), away = folder.file("other/out.glb");
    json description = json::parse(gen::built(gen::bending_tube(3)).text_file());
    const std::string uri = description["buffers"][0]["uri"];
    const std::size_t length = description["buffers"][0]["byteLength"];
    write_whole(in, glb_of({{json_chunk, description.dump()}}, in));
    const Called whole = call({"bake", in, away});
    gen::write_glb(gen::bending_tube(3), in);
    write_whole(folder.file("in.bin"), read_glb(read_whole(in), in)[1].data);
    description["buffers"][0] = {{"byteLength", length}, {"uri", "in.bin"}};
    write_whole(in, glb_of({{json_chunk, description.dump()}}, in));
    const Called same = call({"bake", in, beside}), other = call({"bake", in, away});
    const std::string note = "names 1 file, such as 'in.bin', by the path from its own folder";
    return Checked(whole.code == 0 && same.code == 0 && other.code == 0 &&
                       whole.errors.find("names 1 file") == std::string::npos &&
                       same.errors.find("names 1 file") == std::string::npos && other.errors.find(note) != std::string::npos,
                   3, whole.errors + same.errors + other.errors);
  });
  t.example("the standard output is known by any of its names", {}, [] {
    TemporaryFolder folder;
    write_whole(folder.file("file"), "");
    std::ostringstream out, errors;
    const auto is_told_to = [&](const std::vector<std::string>& files, std::ostream& where) {
      std::vector<NamedFile> written;
      for (const std::string& file : files) written.push_back({"OUT", file});
      return &told_to(written, out, errors) == &where;
    };
    return Checked(is_standard_output("/proc/self/fd/1") && !is_standard_output(folder.file("file")) && !is_standard_output("") &&
                       is_told_to({}, out) && is_told_to({"", folder.file("file")}, out) &&
                       is_told_to({"", folder.file("file"), "/proc/self/fd/1"}, errors),
                   6);
  });
}

void names_that_would_leave_their_line(Suite& t) {
  t.example("control characters of a file's names are printed by their codes, on one line", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), odd = rich.folder.file("odd.glb"), out = rich.folder.file("odd_baked.glb");
    redescribe(in, odd,
               [](json& description) { description["animations"][0]["name"] = "walk\nrest pose: 0 outside\x1b[2J\x7f é"; });
    const Called info = call({"info", odd}), bake = call({"bake", odd, out}), check = call({"check", out});
    const std::string name = "walk\\x0arest pose: 0 outside\\x1b[2J\\x7f é";
    const bool good = info.out.find("#1 " + name + ": ") != std::string::npos && bake.code == 0 && check.code == 0 &&
                      check.out.find("clip '" + name + "': ") != std::string::npos && check.out.find('\x1b') == std::string::npos;
    // The names of the files themselves are escaped too, also where there is none.
    const std::string colored = rich.folder.file("a\x1b[31mb.glb"), gone = rich.folder.file("c\x1b[31md.glb");
    std::filesystem::copy_file(in, colored);
    const Called named = call({"info", colored}), missing = call({"info", gone});
    const bool are_named = named.code == 0 && named.out.find("a\\x1b[31mb.glb") != std::string::npos && missing.code == 3 &&
                           missing.errors.find("c\\x1b[31md.glb: file: does not exist") != std::string::npos &&
                           (named.out + missing.errors).find('\x1b') == std::string::npos;
    return Checked(good && are_named, 5, info.out + check.out + named.out + missing.errors);
  });
}

void clips_of_one_name(Suite& t) {
  t.example("of clips of one name collide takes one by its number, and by the name it says that there are more", {}, [] {
    const Rich rich(false, false);
    const std::string in = rich.folder.file("in.glb"), twice = rich.folder.file("twice.glb");
    std::string count;
    redescribe(in, twice, [&](json& description) {
      const json still = description["animations"][0];
      description["animations"].push_back(still);
      count = std::to_string(description["animations"].size());
    });
    const Called info = call({"info", twice}), named = call({"collide", "--clip-a", "move", "--time-a", "0.5", twice, in}),
                 first = call({"collide", "--clip-a", "#1", "--time-a", "0.5", twice, in}),
                 last = call({"collide", "--clip-a", "#" + count, "--time-a", "0.5", twice, in}),
                 none = call({"collide", "--clip-a", "#9", twice, in}), zero = call({"collide", "--clip-a", "#0", twice, in}),
                 alone = call({"collide", "--clip-a", "move", "--time-a", "0.5", in, in});
    const bool good = info.out.find("#1 move: ") != std::string::npos &&
                      info.out.find("#" + count + " move: ") != std::string::npos && named.code == 3 &&
                      named.errors.find("2 clips have this name: #1 is the first") != std::string::npos && first.code == 0 &&
                      last.code == 0 && first.out == alone.out && last.out == alone.out && none.code == 3 && zero.code == 3 &&
                      none.errors.find("there is no such clip, but move, move") != std::string::npos;
    return Checked(good, 7, info.out + named.errors + first.errors + last.errors + none.errors);
  });
}

void parts_without_a_ball_for_any_pose(Suite& t) {
  t.example(
      "a mesh whose joints have no node above all of them has no ball for any pose, and bake says so, if it can write at all", {},
      [] {
        const Rich rich(false, false);
        const std::string in = rich.folder.file("in.glb"), apart = rich.folder.file("apart.glb"),
                          out = rich.folder.file("any.glb");
        // A joint that is below others becomes a root.
        redescribe(in, apart, [](json& description) {
          const json joint = description["skins"][0]["joints"].back();
          for (json& node : description["nodes"]) {
            json left = json::array();
            for (const json& child : node.value("children", json::array()))
              if (child != joint) left.push_back(child);
            if (left.empty()) node.erase("children");
            else node["children"] = left;
          }
          description["scenes"][0]["nodes"].push_back(joint);
        });
        const Called called = call({"bake", "--for", "any", apart, out}),
                     quiet = call({"bake", "--quiet", "--for", "any", apart, out}), clip = call({"bake", apart, out}),
                     whole = call({"bake", "--for", "any", in, out}),
                     unwritable = call({"bake", "--for", "any", "--json", in + "/never.json", apart, out});
        const std::string note = "has no ball for any pose: no node is above all of its joints";
        const bool good = called.code == 0 && called.errors.find("note: " + apart + ": mesh ") != std::string::npos &&
                          called.errors.find(note) != std::string::npos && quiet.errors.find(note) == std::string::npos &&
                          clip.errors.find(note) == std::string::npos && whole.code == 0 &&
                          whole.errors.find(note) == std::string::npos && unwritable.code == 3 &&
                          unwritable.errors.find("/never.json: cannot write: Not a directory") != std::string::npos &&
                          unwritable.errors.find(note) == std::string::npos;  // The program says this once the bounds are there.
        return Checked(good, 5, called.errors + whole.errors + unwritable.errors);
      });
}

// Says whether a call exits with this code, says this and writes no file. If not, what it did is added to wrong.
bool is_refused(int code, const std::vector<std::string>& arguments, const std::string& reason, const std::string& out,
                std::string& wrong) {
  const Called called = call(arguments);
  const bool is = called.code == code && called.errors.find(reason) != std::string::npos && !std::filesystem::exists(out);
  if (!is) wrong += reason + ": " + std::to_string(called.code) + " " + called.errors + "; ";
  return is;
}

void words_in_the_wrong_place(Suite& t) {
  t.example("a forgotten value is not the option behind it, names begin no line, and OUT stays if another file cannot be written",
            {}, [] {
              const Rich rich(true, false), even(false, false);
              const TemporaryFolder& folder = rich.folder;
              const std::string rigid = even.folder.file("in.glb"), in = folder.file("in.glb"), out = folder.file("never.glb");
              std::string wrong;
              const auto fails = [&](int code, const std::vector<std::string>& arguments, const std::string& reason) {
                return is_refused(code, arguments, reason, out, wrong);
              };
              const bool good =
                  fails(2, {"bake", in, out, "--json", "--quiet"}, "--json takes a value, and --quiet is an option") &&
                  fails(2, {"collide", rigid, rigid, "--clip-a", "--time-a", "0"}, "--clip-a takes a value, and --time-a is") &&
                  fails(2, {"collide", "--at", "0", "0", "0", rigid, rigid},
                        "finite, and A and B come before it; it was given 0 0 0 " + rigid + " " + rigid) &&
                  fails(3, {"collide", rigid, rigid, "--clip-a=--pairs"}, "clip '--pairs': there is no such clip") &&
                  fails(3, {"collide", rigid, rigid, "--clip-a", "a\nb"}, "clip 'a\\x0ab': there is no such clip") &&
                  fails(3, {"bake", "--json", folder.file(""), in, out}, "cannot replace") &&
                  fails(3, {"bake", "--report", folder.file(""), in, out}, "cannot replace") &&
                  fails(3, {"bake", "--certificate", folder.file(""), in, out}, "cannot replace") &&
                  fails(3, {"collide", rigid, folder.file("")}, "is no regular file that can be read");
              return Checked(good, 9, wrong);
            });
}

void wrong_calls_and_files(Suite& t) {
  t.example("wrong calls exit with 2, files that cannot be used with 3, each with a line that says why, and nothing is written",
            {}, [] {
              const Rich rich(true, false), even(false, false);
              const TemporaryFolder& folder = rich.folder;
              const std::string rigid = even.folder.file("in.glb");
              std::string wrong;
              const std::string in = folder.file("in.glb"), out = folder.file("never.glb"), broken = folder.file("broken.glb");
              const std::string bytes = read_whole(in);
              const auto fails = [&](int code, const std::vector<std::string>& arguments, const std::string& reason) {
                return is_refused(code, arguments, reason, out, wrong);
              };
              bool good =
                  fails(2, {"bake", in}, "it takes a file more: OUT.glb") &&
                  fails(2, {"bake", in, out, "third.glb", "fourth.glb"}, "it takes no file more: third.glb") &&
                  fails(2, {"info", in, "--", "-5"}, "it takes no file more: -5") &&
                  fails(2, {"frob"}, "there is no command frob") &&
                  fails(2, {"bake", "--skinning", "cubic", in, out}, "there is no such skinning") &&
                  fails(2, {"bake", "--clusters", "5", in, out}, "a multiple of 4") &&
                  fails(2, {"bake", "--tolerance", "0", in, out}, "a number from 1e-6 to 1") &&
                  fails(2, {"bake", "--for", "ever", in, out}, "there are clip, crossfade and any") &&
                  fails(2, {"bake", "--for", "crossfade", "--rotations", "linear", in, out}, "there are slerp and nlerp") &&
                  fails(2, {"bake", "--for", "crossfade", "--crossfade-tolerance", "2", in, out}, "a number from 1e-6 to 1") &&
                  fails(2, {"bake", "--nonsense", in, out}, "nonsense") &&
                  fails(2, {"bake", "--dop", "8", in, out}, "--dop takes 6, 14, 18 or 26") &&
                  fails(2, {"bake", "--nodes", "--no-character", in, out}, "that --no-character leaves out") &&
                  fails(2, {"bake", "--skinning", "spherical", "--certificate", out, in, out}, "for linear skinning alone") &&
                  fails(2, {"check", "--samples", "0", in}, "a number from 1 to") &&
                  fails(2, {"collide", rigid, rigid, "--at", "1", "2"}, "--at takes three numbers that are finite") &&
                  fails(2, {"collide", rigid, rigid, "--at", "0", "nan", "0"}, "--at takes three numbers that are finite") &&
                  fails(2, {"collide", rigid, rigid, "--at", "0", "0", "-inf"}, "--at takes three numbers that are finite") &&
                  fails(3, {"bake", folder.file("none.glb"), out}, "none.glb") && fails(3, {"check", in}, "it was not baked") &&
                  fails(3, {"check", folder.file("")}, folder.file("") + ": file: cannot be read") &&
                  fails(3, {"collide", "--clip-a", "none", rigid, rigid}, "clip 'none'") &&
                  // Its joints scale unevenly.
                  fails(3, {"bake", "--skinning", "dual-quaternion", in, out}, "skin matrix") &&
                  fails(3, {"bake", in, in + "/x.glb"}, "in.glb");
              for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97) {
                write_whole(broken, bytes.substr(0, size));
                good = good && fails(3, {"bake", broken, out}, "broken.glb");
              }
              const std::string bare = folder.file("bare.glb");
              good = good && call({"bake", "--clusters", "0", in, bare}).code == 0 &&
                     fails(3, {"check", bare}, "no bounds of them or of nodes");
              if (call({"bake", "--clusters", "4", in, folder.file("baked.glb")}).code != 0) return Checked(false);
              const auto tampered = [&](const std::function<void(BakedFile&)>& change, const std::string& reason) {
                tamper(folder.file("baked.glb"), broken, change);
                return fails(3, {"check", broken}, reason);
              };
              give_no_skinning(folder.file("baked.glb"), broken);
              good = good && fails(3, {"check", broken}, "there is no such skinning") &&
                     tampered([](BakedFile& b) { b.rotations = static_cast<RotationBlend>(2); },
                              broken + ": chunk of refitlab: there is no such blend of rotations") &&
                     tampered([](BakedFile& b) { b.clusters.clips.pop_back(); }, "not as many as were baked") &&
                     tampered([](BakedFile& b) { b.clusters.clusters[0].triangles[0] = 1000; }, "not of this file's triangles") &&
                     tampered([](BakedFile& b) { b.clusters.primitives[0].mesh = 7; }, "not of this file's triangles") &&
                     tampered(
                         [](BakedFile& b) {
                           for (auto& clip : b.clusters.clips) clip.nodes = {clip.clusters[0]};
                         },
                         "bounds of nodes that are not the character's") &&
                     tampered(
                         [](BakedFile& b) {
                           const Model other = make_man(100);
                           b.character = bake(SkinnedMesh(other), {}, {});
                           for (auto& clip : b.clusters.clips)
                             clip.nodes.assign(b.character->tree.nodes.size(), clip.clusters[0]);
                         },
                         "nodes: they are not of this file's vertices") &&
                     fails(2, {"collide", "--clip-a", "move", "--time-a", "5", rigid, rigid}, "the clip goes from 0 to 2");
              // The extras are no object.
              const std::vector<GlbChunk> chunks = read_glb(bytes, in);
              json description = json::parse(chunks[0].data);
              description["meshes"][0]["extras"] = 7;
              std::vector<GlbChunk> other = chunks;
              other[0].data = description.dump();
              write_whole(broken, glb_of(other, broken));
              good = good && fails(3, {"bake", broken, out}, "extras: /meshes/0/extras is no object");
              return Checked(good, 125, wrong);
            });
}

}  // namespace

PROPTEST(program) {
  t.example("called by the system it does what it does with the arguments behind its name", {}, [] {
    std::string name = "refitlab", option = "--help";
    char* arguments[] = {name.data(), option.data(), nullptr};
    std::ostringstream out;
    std::streambuf* const screen = std::cout.rdbuf(out.rdbuf());
    const int code = refitlab_main(2, arguments);
    std::cout.rdbuf(screen);
    return Checked(code == 0 && out.str() == call({"--help"}).out, 1, out.str());
  });
  t.example("what cannot be written to the standard output is said, and is no success", {}, [] {
    std::string name = "refitlab", option = "--help";
    char* arguments[] = {name.data(), option.data(), nullptr};
    std::ostringstream errors;
    std::ofstream full("/dev/full");
    std::streambuf *const screen = std::cout.rdbuf(full.rdbuf()), *const other = std::cerr.rdbuf(errors.rdbuf());
    const int code = refitlab_main(2, arguments);
    std::cout.rdbuf(screen), std::cerr.rdbuf(other);
    std::cout.clear();
    return Checked(code == exit_refused && errors.str().find("standard output: cannot be written") != std::string::npos, 1,
                   errors.str());
  });
  bounds_hold_and_are_checked(t);
  characters_and_nodes(t);
  balls_for_any_pose(t);
  crossfades(t);
  what_leaves_its_box_between_keys(t);
  check_counts_vertices(t);
  crossfades_unless_asked_otherwise(t);
  a_crossfade_of_one_clip(t);
  crossfades_of_three_clips(t);
  info_says_which_clips_are_rigid(t);
  info_counts_what_is_in_a_file(t);
  info_says_what_was_baked(t);
  what_a_summary_says(t);
  what_is_said_of_a_file(t);
  what_sampling_misses(t);
  reports_show_each_cluster(t);
  reports_and_progress(t);
  strange_names_and_joints(t);
  collide_writes_pairs_and_certificates(t);
  collide_scales_before_it_turns(t);
  collide_tells_of_long_certificates(t);
  options_of_what_is_not_asked_for(t);
  numbers_beyond_either_end(t);
  ends_of_clips_as_printed(t);
  files_named_twice(t);
  help_of_each_command(t);
  what_is_behind_a_chunk(t);
  what_a_bake_leaves_in_order(t);
  what_a_bake_refuses_or_says(t);
  names_that_would_leave_their_line(t);
  clips_of_one_name(t);
  parts_without_a_ball_for_any_pose(t);
  words_in_the_wrong_place(t);
  wrong_calls_and_files(t);
}

}  // namespace proptests::suite_program
