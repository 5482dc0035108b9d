// SPDX-License-Identifier: GPL-3.0-or-later
// Tests certificates of bounds over time. A checker that shares no code with what bakes them accepts each that is true, and
// rejects what is false of the file, or not proven.
#include "algorithms/program/clip_certificate.hpp"

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "algorithms/certificate/sha256.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/model/write_gltf.hpp"
#include "algorithms/program/program.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/gen/model_of_nodes.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/gen/rigged_gltf.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"
#include "proptests/oracles/animated_skin.hpp"
#include "proptests/oracles/checked_folder.hpp"

namespace proptests::suite_clip_certificate {
namespace {

using namespace refitlab;
using nlohmann::json;

// Holds a baked file and its certificate, in a folder of their own.
class Certified {
 public:
  explicit Certified(const std::string& bytes, const std::string& tolerance = "0.01", const std::string& dop = "14") {
    write_whole(in(), bytes);
    std::ostringstream out, errors;
    if (run_program({"bake", "--clusters", "4", "--tolerance", tolerance, "--dop", dop, "--certificate", folder_.file("it.json"),
                     in(), baked()},
                    out, errors) != 0) {
      refusal = errors.str();
      return;
    }
    document = json::parse(read_whole(folder_.file("it.json")));
  }

  std::string in() const { return folder_.file("in.glb"); }
  std::string baked() const { return folder_.file("out.glb"); }
  std::string text() const { return read_whole(folder_.file("it.json")); }

  // Returns what the checker says of certificates against a file, verdict and reason, in order.
  std::vector<std::string> judged(const std::vector<std::string>& texts, const std::string& file) {
    std::string arguments = "--against " + file;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      write_whole(name(i), texts[i]);
      arguments += " " + name(i);
    }
    const oracle::CheckerRun run = oracle::run_clip_checker(arguments);
    if (run.status == 2) return std::vector<std::string>(texts.size(), run.lines.empty() ? "" : run.lines[0]);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < run.lines.size(); ++i) {
      const std::string quoted = ": \"" + name(i) + "\": ";
      const std::size_t at = run.lines[i].find(quoted);
      out.push_back(at == std::string::npos ? run.lines[i]
                                            : run.lines[i].substr(0, at) + ": " + run.lines[i].substr(at + quoted.size()));
    }
    if (out.size() != texts.size()) out.assign(texts.size(), "not a line for each: " + (out.empty() ? "" : out.back()));
    const bool all_accepted =
        std::all_of(out.begin(), out.end(), [](const auto& line) { return line.starts_with("accepted: "); });
    if (run.status != (all_accepted ? 0 : 1))
      out.assign(texts.size(), "the checker ends with status " + std::to_string(run.status));
    return out;
  }
  std::vector<std::string> judged(const std::vector<json>& documents) {
    std::vector<std::string> texts;
    for (const json& d : documents) texts.push_back(d.dump());
    return judged(texts, baked());
  }

  // Returns the verdict against the baked file with other chunks. The certificate is made to name that file.
  std::string judged_with(const std::function<void(std::vector<GlbChunk>&)>& change) {
    std::vector<GlbChunk> chunks = read_glb(read_whole(baked()), baked());
    change(chunks);
    return judged_against(glb_of(chunks, "other.glb"));
  }
  // Returns the verdict against a file of these bytes. The certificate is made to name that file.
  std::string judged_against(const std::string& bytes) {
    const std::string file = folder_.file("other.glb");
    write_whole(file, bytes);
    json changed = document;
    changed["file"] = sha256(bytes);
    return judged({changed.dump()}, file)[0];
  }

  json document;
  // This says why the file cannot be baked, and is empty if it was.
  std::string refusal;

 private:
  std::string name(std::size_t i) const { return folder_.file("c" + std::to_string(i) + ".json"); }
  TemporaryFolder folder_;
};

bool is_accepted(const std::string& verdict) { return verdict.starts_with("accepted: "); }
bool is_rejected_for(const std::string& verdict, const std::string& reason) {
  return verdict.starts_with("rejected: ") && verdict.find(reason) != std::string::npos;
}
bool is_unreadable_for(const std::string& verdict, const std::string& reason) {
  return verdict.starts_with("unreadable: ") && verdict.find(reason) != std::string::npos;
}

// Returns the bound of a part in the first clip.
json& bound_of(json& document, std::size_t part) { return document["clips"][0]["bounds"][part]; }
json& intervals_of(json& document) { return bound_of(document, 0)["box_intervals"]; }

// Returns the first of two consecutive intervals whose common end is no key, but comes from the search.
std::size_t halves_in(const json& intervals, const std::vector<double>& keys) {
  for (std::size_t i = 0; i + 1 < intervals.size(); ++i)
    if (std::find(keys.begin(), keys.end(), intervals[i][1].get<double>()) == keys.end()) return i;
  return intervals.size();
}
void join(json& intervals, std::size_t i) {
  intervals[i][1] = intervals[i + 1][1];
  intervals.erase(i + 1);
}

struct Forgery {
  const char *what, *reason;
  std::function<void(json&)> forge;
};

void add(json& x, double by) { x = x.get<double>() + by; }

// Lists forgeries of a certificate of a rich file, whose clip "move" has a key at 1 s.
std::vector<Forgery> forged_bounds() {
  return {
      {"a box is narrower on one side", "a vertex may leave its box",
       [](json& d) { add(bound_of(d, 0)["box"][4], -0.02 * bound_of(d, 0)["box"][4].get<double>()); }},
      {"a ball is smaller", "a vertex may leave its ball",
       [](json& d) { bound_of(d, 0)["ball"][3] = 0.97 * bound_of(d, 0)["ball"][3].get<double>(); }},
      {"a box is wider than the file's", "is not what the certificate implies",
       [](json& d) { add(bound_of(d, 0)["box"][4], 1); }},
      {"a ball is elsewhere", "is not what the certificate implies", [](json& d) { add(bound_of(d, 0)["ball"][1], 10); }},
      {"a slab is narrower at its low side", "a vertex may leave its box",
       [](json& d) { add(bound_of(d, 0)["slabs"][1][0], 0.05); }},
      {"a slab is narrower at its high side", "a vertex may leave its box",
       [](json& d) { add(bound_of(d, 0)["slabs"][3][1], -0.05); }},
      {"a slab is wider than the file's", "is not what the certificate implies",
       [](json& d) { add(bound_of(d, 0)["slabs"][2][1], 1); }},
      {"a slab is missing", "has not 4", [](json& d) { bound_of(d, 0)["slabs"].erase(3); }},
      {"two directions are exchanged", "other directions", [](json& d) { std::swap(d["directions"][0], d["directions"][1]); }},
      {"a direction is none", "no direction",
       [](json& d) {
         d["directions"][0] = {0, 0, 0};
       }},
      {"a direction is longer", "no direction",
       [](json& d) {
         d["directions"][0] = {2, 1, 1};
       }},
  };
}

std::vector<Forgery> forged_intervals() {
  return {
      {"an interval is left out", "do not cover", [](json& d) { intervals_of(d).erase(1); }},
      {"the first interval is left out", "do not cover", [](json& d) { intervals_of(d).erase(0); }},
      {"the last interval is left out", "do not cover", [](json& d) { intervals_of(d).erase(intervals_of(d).size() - 1); }},
      {"an interval is there twice", "do not cover", [](json& d) { intervals_of(d).push_back(intervals_of(d).back()); }},
      {"an interval goes back", "do not cover", [](json& d) { std::swap(intervals_of(d)[0][0], intervals_of(d)[0][1]); }},
      {"an interval is stretched over a key", "goes across a key",
       [](json& d) {
         json& intervals = intervals_of(d);
         for (std::size_t i = 0; i + 1 < intervals.size(); ++i)
           if (intervals[i][1] == 1.0) return join(intervals, i);
       }},
      {"two halves are one interval, with the slack of a half", "a slack of its box is less",
       [](json& d) {
         join(intervals_of(d), halves_in(intervals_of(d), {0.5, 1, 1.5, 2}));
       }},
      {"a slack is stated too small", "a slack of its box is less",
       [](json& d) {
         for (json& interval : intervals_of(d)) interval[2] = 0.25 * interval[2].get<double>();
       }},
      {"a slack is stated too large", "a vertex may leave its box",
       [](json& d) {
         for (json& interval : intervals_of(d)) interval[2] = 10.0;
       }},
      {"the clip ends before its last key", "out of the time",
       [](json& d) {
         d["clips"][0]["duration"] = 1.0;
         for (json& bound : d["clips"][0]["bounds"])
           for (const char* list : {"box_intervals", "ball_intervals"}) {
             json kept = json::array();
             for (const json& interval : bound[list])
               if (interval[1] <= 1.0) kept.push_back(interval);
             bound[list] = kept;
           }
       }},
  };
}

std::vector<Forgery> forged_parts() {
  return {
      {"it is of another file", "the file is another one", [](json& d) { d["file"] = sha256("another"); }},
      {"two parts are exchanged", "is not what the certificate implies",
       [](json& d) { std::swap(d["parts"][0], d["parts"][1]); }},
      {"a part has the vertices of another one, too", "a vertex may leave its",
       [](json& d) {
         std::vector<json*> clusters;
         for (json& part : d["parts"])
           if (part[0]["kind"] == "cluster") clusters.push_back(&part);
         json other = clusters.back()->at(0);
         other["triangles"].push_back(other["triangles"][0]);
         clusters.front()->push_back(other);
       }},
      {"a part is left out", "that the certificate has not",
       [](json& d) {
         d["parts"].erase(1);
         for (json& clip : d["clips"]) clip["bounds"].erase(1);
       }},
      {"a cluster has another triangle", "that the certificate has not",
       [](json& d) {
         for (json& part : d["parts"])
           for (json& thing : part)
             if (thing.contains("triangles")) thing["triangles"] = {0};
       }},
      {"a triangle is not there", "is not there",
       [](json& d) {
         d["parts"].push_back({{{"kind", "cluster"}, {"node", 2}, {"mesh", 0}, {"primitive", 0}, {"triangles", {99999}}}});
         for (json& clip : d["clips"]) clip["bounds"].push_back(clip["bounds"][0]);
       }},
      {"a part is of nothing", "has no triangles",
       [](json& d) {
         d["parts"][0].push_back({{"kind", "mesh"}, {"mesh", 77}});
       }},
  };
}

std::vector<Forgery> forged_clips_and_members() {
  return {
      {"the clip is left out", "not about the rest pose and each animation", [](json& d) { d["clips"].erase(0); }},
      {"the rest pose is left out", "not about the rest pose and each animation", [](json& d) { d["clips"].erase(1); }},
      {"the clip is taken for the rest pose", "not about the rest pose and each animation",
       [](json& d) { d["clips"].erase(1), d["clips"][0]["animation"] = -1; }},
      {"the clip and the rest pose are exchanged", "implies",
       [](json& d) { d["clips"][0]["animation"] = -1, d["clips"][1]["animation"] = 0; }},
      {"a clip is there twice", "two clips", [](json& d) { d["clips"].push_back(d["clips"][0]); }},
      {"there is no such clip", "an animation is not there",
       [](json& d) { d["clips"].push_back(d["clips"][0]), d["clips"][2]["animation"] = 1; }},
      {"it is of another skinning", "linear skinning", [](json& d) { d["skinning"] = "spherical"; }},
      {"it is of another version", "version 2", [](json& d) { d["version"] = 1; }},
      {"it has a member more", "has not the members", [](json& d) { d["trust"] = "me"; }},
      {"a bound has a member less", "has not the members", [](json& d) { bound_of(d, 0).erase("ball"); }},
      {"a number is a text", "no number", [](json& d) { bound_of(d, 0)["box"][0] = "-1000"; }},
      {"a number is missing", "has not 6", [](json& d) { bound_of(d, 0)["box"].erase(5); }},
      {"an interval has no slack", "no list of 3", [](json& d) { intervals_of(d)[0].erase(2); }},
      {"there are no intervals", "no list of something", [](json& d) { intervals_of(d) = json::array(); }},
      {"true is an index", "no int", [](json& d) { d["clips"][0]["animation"] = true; }},
      {"it would take too long", "too much work",
       [](json& d) {
         json many = json::array();
         for (int i = 0; i < 700000; ++i) many.push_back({i, i + 1, 0});
         intervals_of(d) = many;
       }},
  };
}

std::vector<Forgery> forgeries() {
  std::vector<Forgery> all = forged_bounds();
  for (const auto& part : {forged_intervals(), forged_parts(), forged_clips_and_members()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Holds the box, and the farthest point from a center, of what is seen.
struct Seen {
  explicit Seen(const json& ball) : center(ball[0], ball[1], ball[2]) {}
  void add(const Eigen::Vector3d& p) {
    low = low.cwiseMin(p), high = high.cwiseMax(p);
    farthest = std::max(farthest, (p - center).norm());
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      const SlabDirection n = slab_directions<26>()[k + 3];
      const double along = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
      slabs[k] = {std::min(slabs[k].low, along), std::max(slabs[k].high, along)};
    }
  }
  // Returns a bound that is cut to leave out something that was seen: a side of the box, from 0 to 5, the ball's radius, or a
  // side of one of the ten slabs of a 26-DOP.
  json cut(json bound, int side, double by) const {
    if (side > 6) {
      json& slab = bound["slabs"][(side - 7) / 2];
      if (side % 2 == 1) slab[0] = slabs[(side - 7) / 2].low + by;
      else slab[1] = slabs[(side - 7) / 2].high - by;
      return bound;
    }
    if (side < 3) bound["box"][side] = low[side] + by;
    else if (side < 6) bound["box"][side] = high[side - 3] - by;
    else bound["ball"][3] = farthest - by;
    return bound;
  }
  Eigen::Vector3d center, low = Eigen::Vector3d::Constant(1e300), high = -low;
  double farthest = 0;
  std::vector<Slab<double>> slabs = std::vector<Slab<double>>(10, {1e300, -1e300});
};

// Makes two nodes, one below the other, that turn, move and grow at once, from one key to the next, with a vertex near each, and
// one that both move.
Model growing_arm() {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Model model = gen::model_of_nodes("arm", {{"upper", -1, identity}, {"lower", 0, identity}});
  model.vertices = {{1, 0, 0}, {0, 1, 0.5}, {1, 1, 0}};
  model.triangles = {{0, 1, 2}}, model.influences = {{{0, 1}}, {{1, 1}}, {{0, 0.5}, {1, 0.5}}};
  Animation animation{"clip", 1, {}};
  for (const int node : {0, 1}) {
    const auto turned = [&](double angle) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(angle, node == 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX()));
    };
    animation.tracks.push_back({node,
                                {{{0, {0, 1, 0}}, {1, {1.5, 1, 0}}}},
                                {{{0, turned(-0.5)}, {1, turned(0.5)}}},
                                {{{0, {1, 1, 1}}, {1, {1.75, 1.5, 1.25}}}}});
  }
  model.clips.push_back({"clip", 1, {}, animation});
  return model;
}

bool has_splines(const Animation& animation) {
  return std::any_of(animation.tracks.begin(), animation.tracks.end(), [](const NodeTrack& track) {
    return track.positions.interpolation == Interpolation::cubic || track.rotations.interpolation == Interpolation::cubic ||
           track.scales.interpolation == Interpolation::cubic;
  });
}

void replace_all(std::string& bytes, const std::string& from, const std::string& to) {
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
    bytes.replace(at, from.size(), to);
}

// Compares what the checker says with what it should say.
struct Verdicts {
  // Compares the verdict with the reason for which it should reject or be unable to read, which is empty if it should accept.
  void expect(const std::string& what, const std::string& reason, const std::string& verdict) {
    ++tried;
    if (reason.empty() ? !is_accepted(verdict) : !is_rejected_for(verdict, reason) && !is_unreadable_for(verdict, reason))
      wrong += what + ": " + verdict + "; ";
  }
  Checked checked() const { return Checked(wrong.empty(), tried, wrong); }
  std::string wrong;
  long tried = 0;
};

using ChunkChange = std::function<void(std::vector<GlbChunk>&)>;
// Expects a certificate to be rejected for a reason, or accepted if the reason is empty, once the file's chunks are changed.
using Expect = std::function<void(const std::string& what, const std::string& reason, const ChunkChange&)>;

ChunkChange in_description(const std::function<void(json&)>& change) {
  return [=](std::vector<GlbChunk>& chunks) {
    json description = json::parse(chunks[0].data);
    change(description);
    chunks[0].data = description.dump();
  };
}
ChunkChange in_clusters(const std::function<void(ClusterBounds&)>& change) {
  return [=](std::vector<GlbChunk>& chunks) {
    TemporaryFolder folder;
    write_whole(folder.file("one.glb"), glb_of(chunks, "one.glb"));
    BakedFile baked = read_baked(folder.file("one.glb"));
    change(baked.clusters);
    chunks.back().data = chunk_of(baked);
  };
}

void change_bounds_of_the_file(const Expect& expect) {
  const auto narrower = [](json& bound) { add(bound["box"][3], -0.01); };
  const auto flatter = [](json& bound) { add(bound["slabs"][1][0], 0.01); };
  const auto smaller = [](json& bound) { bound["ball"][3] = 0.999 * bound["ball"][3].get<double>(); };
  for (const char* owners : {"animations", "skins", "meshes"}) {
    expect(std::string("a box of ") + owners, "is not what the certificate implies",
           in_description([&](json& d) { narrower(d[owners][0]["extras"]["refitlab"]); }));
    expect(std::string("a ball of ") + owners, "is not what the certificate implies",
           in_description([&](json& d) { smaller(d[owners][0]["extras"]["refitlab"]); }));
    expect(std::string("a slab of ") + owners, "is not what the certificate implies",
           in_description([&](json& d) { flatter(d[owners][0]["extras"]["refitlab"]); }));
    expect(std::string("skinning of ") + owners, "is not of version 1 and linear skinning",
           in_description([&](json& d) { d[owners][0]["extras"]["refitlab"]["skinning"] = "dual-quaternion"; }));
    expect(std::string("version of ") + owners, "is not of version 1 and linear skinning",
           in_description([&](json& d) { d[owners][0]["extras"]["refitlab"]["version"] = 2; }));
    expect(std::string("directions of ") + owners, "other directions", in_description([&](json& d) {
             d[owners][0]["extras"]["refitlab"]["directions"][2] = {1, 0, 1};
           }));
  }
  for (const char* parts : {"skins", "meshes", "primitives"})
    expect(std::string("a box of an animation's ") + parts, "is not what the certificate implies",
           in_description([&](json& d) { narrower(d["animations"][0]["extras"]["refitlab"][parts][0]); }));
  expect("skinning of a primitive", "is not of version 1 and linear skinning",
         in_description([](json& d) { d["meshes"][0]["primitives"][0]["extras"]["refitlab"]["skinning"] = "spherical"; }));
  expect("a box of a primitive", "is not what the certificate implies",
         in_description([&](json& d) { narrower(d["meshes"][0]["primitives"][0]["extras"]["refitlab"]); }));
}

void change_clusters_of_the_file(const Expect& expect) {
  expect("a box of a cluster", "cluster 0 of clip 0 is not what the certificate implies",
         in_clusters([](ClusterBounds& clusters) {
           clusters.clips[0].clusters[0].box.high[0] = clusters.clips[0].clusters[0].box.low[0];
         }));
  expect("a slab of a cluster", "cluster 0 of clip 0 is not what the certificate implies",
         in_clusters([](ClusterBounds& clusters) {
           clusters.clips[0].clusters[0].slabs[3].low = clusters.clips[0].clusters[0].slabs[3].high;
         }));
  expect("k of the clusters", "k-DOPs of other directions", in_clusters([](ClusterBounds& clusters) {
           clusters.dop = 6;
           for (auto& clip : clusters.clips)
             for (auto& bound : clip.clusters) bound.slabs.clear();
         }));
  expect("a ball of a cluster in the rest pose", "of clip 1 is not what the certificate implies",
         in_clusters([](ClusterBounds& clusters) { clusters.clips[1].clusters[0].ball.radius *= 0.5f; }));
  expect("a cluster's triangle", "that the certificate has not",
         in_clusters([](ClusterBounds& clusters) { clusters.clusters[0].triangles[0] += 1; }));
}

void change_what_moves(const Expect& expect) {
  expect("a channel of a pointer", "a channel moves what a pointer names", in_description([](json& d) {
           json& target = d["animations"][0]["channels"][0]["target"];
           target.erase("node");
           target["extensions"]["KHR_animation_pointer"] = {{"pointer", "/nodes/0/scale"}};
         }));
  expect("instances", "a node is shown in many places", in_description([](json& d) {
           for (json& node : d["nodes"])
             if (node.contains("mesh")) node["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", json::object()}};
         }));
  expect("the times of keys", "", in_description([](json& d) { d["asset"]["generator"] = "another"; }));
  expect("a node", "part 0", in_description([](json& d) {
           for (json& node : d["nodes"])
             if (node.contains("translation")) node["translation"][0] = node["translation"][0].get<double>() + 0.5;
         }));
  expect("a clip's way to interpolate", "less than what its vertices may be off the chord", in_description([](json& d) {
           for (json& sampler : d["animations"][0]["samplers"])
             if (sampler["interpolation"] == "STEP") sampler["interpolation"] = "LINEAR";
         }));
  expect("a node above the first, which moves nothing", "", in_description([](json& d) {
           d["scenes"].at(1)["nodes"] = {d["nodes"].size()};  // This replaces node 0.
           d["nodes"].push_back({{"children", {0}}});
         }));
  expect("a channel of no node, which readers ignore", "", in_description([](json& d) {
           json channel = d["animations"][0]["channels"][0];
           channel["target"].erase("node");
           d["animations"][0]["channels"].push_back(channel);
         }));
  expect("which scene is the first, where the file does not say which it shows", "", in_description([](json& d) {
           std::swap(d["scenes"][0], d["scenes"][1]);
           d.erase("scene");
         }));
  expect("the first scene, which is empty", "the file shows no mesh", in_description([](json& d) { d.erase("scene"); }));
  expect("a node that a channel moves has a matrix", "a node that has a matrix is moved", in_description([](json& d) {
           for (const json& channel : d["animations"][0]["channels"])
             if (channel["target"]["path"] == "translation")
               d["nodes"].at(channel["target"]["node"].get<std::size_t>())["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0,
                                                                                        0, 0, 1, 0, 0, 1, 0, 1};
         }));
  for (const int beyond : {0, 1, -1})
    expect("a joint that is not there", "a skin has a joint that is not there", in_description([=](json& d) {
             const int count = static_cast<int>(d["nodes"].size());
             d["skins"][0]["joints"][1] = beyond < 0 ? -1 : count + beyond;
           }));
  // As many nodes are reached from the roots as there are: one is reached twice, and one, which is below itself, never.
  expect("a node below two", "a node is below two", in_description([](json& d) {
           json& nodes = d["nodes"];
           int leaf = -1;
           for (const json& node : nodes)
             for (const int child : node.value("children", std::vector<int>()))
               if (!nodes[child].contains("children")) leaf = child;
           nodes.push_back({{"children", {leaf}}});
           nodes.push_back({{"children", {nodes.size()}}});
         }));
  expect("an extension of geometry", "which is not read",
         in_description([](json& d) { d["extensionsRequired"].push_back("KHR_draco_mesh_compression"); }));
  expect("the bytes of positions and keys", "part 0", [](std::vector<GlbChunk>& chunks) {
    // This changes all numbers that are 1 in positions, tangents and offsets.
    const float one = 1, other = 1.25f;
    replace_all(chunks[1].data, std::string(reinterpret_cast<const char*>(&one), 4),
                std::string(reinterpret_cast<const char*>(&other), 4));
  });
}

// Checks that the certificate of a random model is accepted, and rejected with a bound that leaves out what is seen, or with a
// slack that is too small.
void check_random_models() {
  gen::AnimatedPlan plan = gen::draw_animated_plan(false);
  plan.targets = 0, plan.vertices = std::max(plan.vertices, 3);
  RC_LOG() << plan;
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  Model made = gen::animated_model(plan);
  // A file gives no matrix of nodes that it moves.
  for (const NodeTrack& track : made.clips[0].animation.tracks)
    made.skeleton.nodes[track.node].local = Eigen::Matrix4d::Identity();
  std::string bytes;
  try {
    bytes = gltf_bytes(made);
  } catch (const ModelError&) {
    RC_TAG("no file");
    return;
  }
  const char* const dops[] = {"6", "14", "18", "26"};
  Certified certified(bytes, plan.seed % 3 == 0 ? "0.3" : "0.01", dops[plan.seed % 4]);
  if (!certified.refusal.empty()) {
    RC_TAG("refused");
    return;
  }
  RC_TAG("certified");
  const Model model = load_model(certified.in(), {.joints = Joints::affine, .morphs = Morphs::moving});
  const Animation animation = model.clips.empty() ? Animation{} : model.clips[0].animation;
  Seen seen(bound_of(certified.document, 0)["ball"]);
  std::mt19937 random(plan.seed);
  try {
    oracle::AnimatedSkin<double> skin(model, animation, Skinning::linear);
    for (int i = 0; i < 30; ++i) {
      skin.pose(animation.duration * (static_cast<double>(random() % 1000) / 999), Side::after);
      for (std::size_t v = 0; v < model.vertices.size(); ++v) seen.add(skin.vertex(static_cast<int>(v)));
    }
  } catch (const oracle::Ambiguous&) {
    RC_TAG("ambiguous");
  }
  std::vector<json> documents = {certified.document};
  const double size = seen.farthest, off = 1e-12 * (plan.far + plan.away + 1) * plan.unit * 1e4;
  if (size > 0 && off < 1e-3 * size) {
    RC_TAG("cut");
    documents.push_back(certified.document);
    json& bound = bound_of(documents.back(), 0);
    bound = seen.cut(bound, static_cast<int>(random() % 7), std::max(off, 1e-9 * size));
  }
  const std::size_t cuts = documents.size();
  // The checker bounds splines interval by interval, and its angles of other rotations are tighter by 1/3 %.
  json& intervals = intervals_of(certified.document);
  if (json& slack = intervals[random() % intervals.size()][2]; !has_splines(animation) && slack > 1e-6 * size) {
    RC_TAG("slack");
    slack = 0.98 * slack.get<double>();
    documents.push_back(certified.document);
  }
  const auto verdicts = certified.judged(documents);
  RC_LOG() << verdicts[0];
  if (is_rejected_for(verdicts[0], "as far apart as can be")) {
    RC_TAG("half a turn");
    return;
  }
  // A box of a single point, the origin, has nothing to spare for rounding.
  if (const json& box = bound_of(certified.document, 0)["box"]; box == json({0.0, 0.0, 0.0, 0.0, 0.0, 0.0})) {
    RC_TAG("nothing to spare");
    return;
  }
  // Where most terms of a sum cancel, the checker's rounding may be more than the bounds allow for.
  if (const bool cancels = plan.far > 0 || plan.away > 0; !cancels || is_accepted(verdicts[0])) {
    RC_TAG("accepted");
    RC_ASSERT(is_accepted(verdicts[0]));
  }
  for (std::size_t i = 1; i < verdicts.size(); ++i) {
    RC_LOG() << i << ": " << verdicts[i];
    RC_ASSERT(is_rejected_for(verdicts[i], i < cuts ? "a vertex may leave its " : "a slack of its box is less"));
  }
}

void bounds_that_leave_something_out_are_rejected(Suite& t) {
  t.example(
      "certificates of files of all features are accepted, and rejected if a bound leaves out what the file's own formulas "
      "say of one of 400 times",
      {.number_type = "double"}, [] {
        std::string wrong;
        long looked_at = 0;
        for (const bool uneven : {false, true})
          for (const bool moving : {false, true}) {
            const gen::RichGltf rich(uneven, moving);
            Certified certified(rich.file.binary_file(), "0.01", "26");
            if (!certified.refusal.empty()) return Checked(false, 1, certified.refusal);
            Seen seen(bound_of(certified.document, 0)["ball"]);
            for (const auto& primitive : rich.primitives()) {
              std::vector<char> is_used(primitive.positions.size(), 0);
              for (const auto& triangle : primitive.triangles)
                for (const int v : triangle) is_used[v] = 1;
              for (int i = 0; i < 400; ++i) {
                const auto posed = rich.posed(primitive, 2.0 * i / 399);
                for (std::size_t v = 0; v < posed.size(); ++v)
                  if (is_used[v]) seen.add(posed[v]);
              }
            }
            std::vector<json> documents = {certified.document};
            for (int side = 0; side < 27; ++side) {
              documents.push_back(certified.document);
              json& bound = bound_of(documents.back(), 0);
              bound = seen.cut(bound, side, 1e-9);
            }
            const auto verdicts = certified.judged(documents);
            for (std::size_t i = 0; i < verdicts.size(); ++i)
              if (i == 0 ? !is_accepted(verdicts[i]) : !is_rejected_for(verdicts[i], "a vertex may leave its "))
                wrong += std::to_string(i) + ", " + verdicts[i] + "; ";
            looked_at += static_cast<long>(verdicts.size());
          }
        return Checked(wrong.empty(), looked_at, wrong);
      });
  t.example("a forged certificate is rejected, for the reason that fits", {}, [] {
    Certified certified(gen::RichGltf(true, true).file.binary_file());
    const std::vector<Forgery> all = forgeries();
    std::vector<json> documents;
    std::string wrong;
    for (const Forgery& forgery : all) {
      documents.push_back(certified.document);
      forgery.forge(documents.back());
      if (documents.back() == certified.document) wrong += std::string(forgery.what) + " changes nothing; ";
    }
    const auto verdicts = certified.judged(documents);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!is_rejected_for(verdicts[i], all[i].reason)) wrong += std::string(all[i].what) + ": " + verdicts[i] + "; ";
    return Checked(wrong.empty(), static_cast<long>(all.size()), wrong);
  });
}

void what_bounds_are_not_about(Suite& t) {
  t.example(
      "weights that move nothing but lines have no keys for a certificate, and a whole number may be written with a point", {},
      [] {
        gen::RichGltf rich(false, true);
        json& file = rich.file.json;
        const std::size_t times = rich.file.add_accessor<float>({0, 0.3F, 0.7F, 2}, "SCALAR", gen::gltf_float),
                          weights = rich.file.add_accessor<float>({0, 1, 0.5F, 1}, "SCALAR", gen::gltf_float),
                          positions =
                              rich.file.add_accessor<std::array<float, 3>>({{0, 0, 0}, {1, 0, 0}}, "VEC3", gen::gltf_float);
        const json lines = {{"mode", 1}, {"attributes", {{"POSITION", positions}}}, {"targets", {{{"POSITION", positions}}}}};
        file["meshes"].push_back({{"primitives", {lines}}});
        file["nodes"].push_back({{"mesh", file["meshes"].size() - 1}});
        file["scenes"][1]["nodes"].push_back(file["nodes"].size() - 1);
        json& clip = file["animations"][0];
        clip["samplers"].push_back({{"input", times}, {"output", weights}});
        clip["channels"].push_back(
            {{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", file["nodes"].size() - 1}, {"path", "weights"}}}});
        file["scene"] = 1.0;
        Certified it(rich.file.binary_file());
        if (!it.refusal.empty()) return Checked(false, 1, it.refusal);
        const std::string verdict = it.judged({it.document})[0];
        return Checked(is_accepted(verdict), 1, verdict);
      });
}

// Makes a file with a far vertex of the first joint, which has a little weight of the second, and a near one of the first joint
// alone, which a morph target moves far. Bounds that took both for vertices of the same joints would be those of one vertex that
// is both far and moved far.
std::string file_of_light_weight(float weight) {
  gen::RiggedGltf scene = gen::bending_tube(2);
  gen::GltfMesh& mesh = scene.meshes[0];
  mesh.positions = {{5, 0, 0}, {0, 1, 0.5f}, {1, 1, 0}};
  mesh.indices = {0, 1, 2};
  mesh.joints = {{{0, 1, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}}};
  mesh.weights = {{{1, weight, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}}};
  gen::GltfBuilder file = gen::built(scene);
  const std::vector<std::array<float, 3>> displacements{{0, 0, 0}, {0, 0, 30}, {0, 0, 0}};
  const std::size_t target = file.add_accessor(displacements, "VEC3", gen::gltf_float);
  file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  file.json["meshes"][0]["weights"] = {1};
  return file.binary_file();
}

// Makes a file with a triangle of which two vertices have the same place, joints and weights, these in other slots. Nothing shows it in
// any pose, and no bound is about it.
std::string file_of_other_slots() {
  gen::RiggedGltf scene = gen::bending_tube(2);
  gen::GltfMesh& mesh = scene.meshes[0];
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {5, 5, 5}, {5, 5, 5}};
  mesh.indices = {0, 1, 2, 3, 4, 5};
  mesh.joints = {{{0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}};
  mesh.weights = {
      {{0.3f, 0.7f, 0, 0}, {0.3f, 0.7f, 0, 0}, {0.3f, 0.7f, 0, 0}, {0.3f, 0.7f, 0, 0}, {0.3f, 0.7f, 0, 0}, {0.7f, 0.3f, 0, 0}}};
  return gen::built(scene).binary_file();
}

void slacks_of_bounds(Suite& t) {
  t.example("a slack that is 3 % less than needed is rejected, of lines and of splines", {}, [] {
    std::string wrong;
    long tried = 0;
    for (const bool is_rich : {false, true}) {
      // (A rotation along a spline is bounded more loosely than the checker bounds it, too.)
      Certified certified(is_rich ? gen::RichGltf(true, true, false).file.binary_file() : gltf_bytes(growing_arm()));
      if (!certified.refusal.empty()) return Checked(false, 1, certified.refusal);
      std::vector<json> documents;
      for (std::size_t part = 0; part < certified.document["parts"].size(); ++part) {
        // The bounds of two morphed meshes together are looser than the checker's.
        if (is_rich && certified.document["parts"][part][0]["kind"] != "cluster") continue;
        for (const char* list : {"box_intervals", "ball_intervals"}) {
          const std::size_t count = bound_of(certified.document, part)[list].size();
          for (std::size_t i = 0; i < count; i += is_rich ? 1 + count / 3 : 1) {
            documents.push_back(certified.document);
            json& slack = bound_of(documents.back(), part)[list][i][2];
            slack = 0.97 * slack.get<double>();
          }
        }
      }
      const auto verdicts = certified.judged(documents);
      for (std::size_t i = 0; i < verdicts.size(); ++i)
        if (!is_rejected_for(verdicts[i], " is less than what its vertices may be off the chord"))
          wrong += std::to_string(i) + ": " + verdicts[i] + "; ";
      tried += static_cast<long>(verdicts.size());
    }
    return Checked(wrong.empty(), tried, wrong);
  });
  // 2^-24 is 6e-8: two of the weights are rounded to nothing, one is rounded up and two stay.
  t.example("a weight that is next to none does not matter, whether bounds are made for it or not", {}, [] {
    Verdicts verdicts;
    for (const float weight : {1e-9f, 2.5e-8f, 4e-8f, 7e-8f, 1.1e-7f}) {
      Certified certified(file_of_light_weight(weight));
      if (!certified.refusal.empty()) return Checked(false, 1, certified.refusal);
      verdicts.expect(std::to_string(1e9 * weight) + " billionths", "", certified.judged({certified.document})[0]);
    }
    return verdicts.checked();
  });
}

// Makes a file of one triangle, at the first three of these points, with a morph target for each further three.
std::string file_of_triangle(json node, const std::vector<float>& numbers) {
  std::string bytes(numbers.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  json description = {{"asset", {{"version", "2.0"}}},
                      {"scene", 0},
                      {"scenes", {{{"nodes", {0}}}}},
                      {"buffers", {{{"byteLength", bytes.size()}}}}};
  json primitive = {{"attributes", {{"POSITION", 0}}}};
  for (std::size_t i = 0; 9 * i < numbers.size(); ++i) {
    description["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 36 * i}, {"byteLength", 36}});
    description["accessors"].push_back({{"bufferView", i}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    if (i > 0) primitive["targets"].push_back({{"POSITION", i}});
  }
  node["mesh"] = 0;
  description["nodes"] = json::array({node});
  description["meshes"] = json::array({{{"primitives", json::array({primitive})}}});
  return glb_of({{json_chunk, description.dump()}, {bin_chunk, bytes}}, "triangle.glb");
}

void slots_of_weights(Suite& t) {
  t.example("vertices that differ only in the slots of their joints are one, to the writer and to the checker", {}, [] {
    Certified certified(file_of_other_slots());
    if (!certified.refusal.empty()) return Checked(false, 1, certified.refusal);
    const std::string verdict = certified.judged({certified.document})[0];
    return Checked(is_accepted(verdict), 1, verdict);
  });
}

void numbers_that_underflow(Suite& t) {
  t.example("what underflows in doubles, and a matrix or nothing enlarges, is not lost", {}, [] {
    Certified certified(gltf_bytes(growing_arm()));
    const auto verdict_of = [&](const std::string& bytes, double side, double radius) {
      const json still = {{0, 0, 0}};
      const json bound = {{"ball", {0, 0, 0, radius}},
                          {"ball_intervals", still},
                          {"box", {-side, -side, -side, side, side, side}},
                          {"box_intervals", still},
                          {"slabs", json::array()}};
      certified.document = {{"clips", {{{"animation", -1}, {"bounds", json::array({bound})}, {"duration", 0}}}},
                            {"directions", json::array()},
                            {"file", ""},
                            {"parts", {{{{"kind", "whole"}}}}},
                            {"skinning", "linear"},
                            {"version", 2}};
      return certified.judged_against(bytes);
    };
    const std::vector<float> axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    Verdicts verdicts;
    const std::string tiny = file_of_triangle({{"scale", {1e-165, 1e-165, 1e-165}}}, axes);
    verdicts.expect("a ball of 1e-179 around what is 1e-165 away", "a vertex may leave its ball",
                    verdict_of(tiny, 1e-164, 1e-179));
    verdicts.expect("a ball of 1e-160", "", verdict_of(tiny, 1e-164, 1e-160));
    // Each displacement times its weight is 2e-324, and all of them are enlarged to 1.3e-15.
    constexpr int targets = 64;
    std::vector<float> moved(9, 0);
    for (int k = 0; k < targets; ++k)
      for (const float x : axes) moved.push_back(1e-37f * x);
    const std::string enlarged =
        file_of_triangle({{"scale", {1e307, 1e307, 1e307}}, {"weights", std::vector<double>(targets, 2e-287)}}, moved);
    verdicts.expect("a box of 2e-16 around what is 1.3e-15 away", "a vertex may leave its ", verdict_of(enlarged, 2e-16, 2e-16));
    verdicts.expect("a box of 1e-13", "", verdict_of(enlarged, 1e-13, 1e-13));
    return verdicts.checked();
  });
}

void certificates_are_of_the_file(Suite& t) {
  t.example("a certificate is of the file: what moves, what is bound and what the file says of it", {}, [] {
    Certified certified(gen::RichGltf(true, true).file.binary_file());
    Verdicts verdicts;
    const Expect expect = [&](const std::string& what, const std::string& reason, const ChunkChange& change) {
      verdicts.expect(what, reason, certified.judged_with(change));
    };
    expect("nothing changes", "", [](auto&) {});
    change_bounds_of_the_file(expect);
    change_clusters_of_the_file(expect);
    change_what_moves(expect);
    return verdicts.checked();
  });
  t.example("a file's accessors and chunks are read as they are, and refused where they are not whole", {}, [] {
    Certified certified(gen::RichGltf(true, true).file.binary_file());
    Verdicts verdicts;
    // change takes the description and the accessor of the first primitive's positions, or of the first target's offsets, which
    // is sparse.
    const auto with = [&](const char* of, const std::function<void(json&, json&)>& change) {
      return certified.judged_with([&](std::vector<GlbChunk>& chunks) {
        json description = json::parse(chunks[0].data);
        const json& primitive = description["meshes"][0]["primitives"][0];
        const json& attributes = of == std::string("positions") ? primitive["attributes"] : primitive["targets"][0];
        change(description, description["accessors"].at(attributes["POSITION"].get<std::size_t>()));
        chunks[0].data = description.dump();
      });
    };
    verdicts.expect("a view that is a byte shorter", "reaches past the end", with("positions", [](json& d, json& accessor) {
                      json& length = d["bufferViews"].at(accessor["bufferView"].get<std::size_t>())["byteLength"];
                      length = length.get<int>() - 1;
                    }));
    verdicts.expect("positions of two numbers each", "is no VEC3",
                    with("positions", [](json&, json& accessor) { accessor["type"] = "VEC2"; }));
    // The offsets belong to vertices 2 and 5, of 12.
    const auto with_indices = [&](const char* uri, std::size_t size, int type) {
      return with("offsets", [=](json& d, json& accessor) {
        json& indices = accessor["sparse"]["indices"];
        indices = {{"bufferView", d["bufferViews"].size()}, {"componentType", type}};
        d["bufferViews"].push_back({{"buffer", d["buffers"].size()}, {"byteLength", size}});
        d["buffers"].push_back({{"byteLength", size}, {"uri", std::string("data:application/octet-stream;base64,") + uri}});
      });
    };
    verdicts.expect("indices 2 and 5 in bytes", "", with_indices("AgU=", 2, 5121));
    verdicts.expect("indices 2 and 5 in four bytes each", "", with_indices("AgAAAAUAAAA=", 8, 5125));
    verdicts.expect("indices with a sign", "indices are no indices", with_indices("AgAFAA==", 4, 5122));
    verdicts.expect("an index that is one too great", "out of range or order", with_indices("Agw=", 2, 5121));
    verdicts.expect("the last index", "part ", with_indices("Ags=", 2, 5121));
    verdicts.expect("indices in another order", "out of range or order", with_indices("BQI=", 2, 5121));
    // The third mesh has corners at 1 and -1, as normalised shorts.
    verdicts.expect("the same positions in normalised bytes", "", certified.judged_with(in_description([](json& d) {
      json& accessor = d["accessors"].at(d["meshes"][2]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>());
      accessor["componentType"] = gen::gltf_byte, accessor["bufferView"] = d["bufferViews"].size();
      accessor["byteOffset"] = 0;
      d["bufferViews"].push_back({{"buffer", d["buffers"].size()}, {"byteLength", 12}, {"byteStride", 4}});
      d["buffers"].push_back({{"byteLength", 12}, {"uri", "data:application/octet-stream;base64,fwAABQCBAAUAAIAF"}});
    })));
    verdicts.expect("a file of its description alone", "has a buffer without bytes",
                    certified.judged_with([](std::vector<GlbChunk>& chunks) { chunks.resize(1); }));
    const std::string bytes = read_whole(certified.baked());
    for (const std::size_t more : {1, 4, 7, 8}) {
      std::string longer = bytes + std::string(more, '\0');
      for (int i = 0; i < 4; ++i) longer[8 + i] = static_cast<char>(longer.size() >> 8 * i);
      verdicts.expect("bytes after the chunks: " + std::to_string(more), more < 8 ? "ends in the header of a chunk" : "",
                      certified.judged_against(longer));
    }
    return verdicts.checked();
  });
}

void half_turns_intervals_and_what_is_no_certificate(Suite& t) {
  t.example("which way a rotation goes between keys half a turn apart is told exactly, and a bound of the other way is rejected",
            {}, [] {
              // Each key is a half turn, about x = y or x = -y. Their product is the third number's, less than the rounding of
              // the others'. Doubles take it for 0, and what is bounded is the way to the second key itself.
              const float third = std::ldexp(1.f, -30), root = std::sqrt(0.5f);
              std::string wrong;
              long tried = 0;
              for (const float sign : {1.f, -1.f}) {
                Model model = growing_arm();
                model.clips[0].animation.tracks.pop_back();
                auto& keys = model.clips[0].animation.tracks[0].rotations.keys;
                std::string from, to;
                for (std::size_t k = 0; k < 2; ++k) {
                  const Eigen::Quaterniond& q = keys[k].value;
                  const float written[4] = {float(q.x()), float(q.y()), float(q.z()), float(q.w())},
                              wanted[4] = {root, k == 0 ? root : -root, k == 0 ? third : sign * third, 0};
                  from.append(reinterpret_cast<const char*>(written), 16), to.append(reinterpret_cast<const char*>(wanted), 16);
                }
                std::string bytes = gltf_bytes(model);
                if (bytes.find(from) == std::string::npos) return Checked(false, 1, "the file has not the keys");
                replace_all(bytes, from, to);
                Certified certified(bytes);
                ++tried;
                const std::string verdict =
                    certified.refusal.empty() ? certified.judged({certified.document})[0] : certified.refusal;
                if (sign > 0 ? !is_accepted(verdict) : !is_rejected_for(verdict, "a vertex may leave its box"))
                  wrong += verdict + "; ";
              }
              return Checked(wrong.empty(), tried, wrong);
            });
  t.example("the checker's intervals hold what fractions say of their ends and of numbers between them", {}, [] {
    const oracle::CheckerRun run = oracle::run_interval_test();
    const std::string said = run.lines.empty() ? "" : run.lines.back();
    return Checked(run.status == 0, run.status == 0 ? std::stol(said) : 1, said);
  });
  t.example("a checker that lacks numpy says so, and rejects nothing", {}, [] {
    const TemporaryFolder folder;
    write_whole(folder.path() + "/numpy.py", "raise ImportError('there is none')");
    const oracle::CheckerRun run = oracle::run_clip_checker("x", folder.path());
    return run.status == 2 && run.lines == std::vector<std::string>{"check_clip: numpy is needed: there is none"};
  });
  t.example("what is no certificate is rejected or unreadable, without a word of its own", {}, [] {
    Certified certified(gen::RichGltf(false, true).file.binary_file());
    const std::string text = certified.text();
    std::vector<std::string> texts = {
        "", "{", "[]", "{\"version\":1,\"version\":1}", std::string(100000, '['), "\xC3\xA4", text.substr(0, text.size() / 2)};
    std::mt19937 random(7);
    for (int i = 0; i < 40; ++i) {
      std::string changed = text;
      const std::size_t at = random() % (changed.size() - 1);
      changed.replace(at, 1 + random() % 3, std::string(1, "0123456789-.,[]{}\"eN"[random() % 20]));
      texts.push_back(changed);
    }
    std::string wrong;
    for (const std::string& verdict : certified.judged(texts, certified.baked()))
      if (!is_rejected_for(verdict, "") && !is_accepted(verdict)) wrong += verdict + "; ";
    for (const std::string& arguments :
         {"--against /nonexistent " + certified.baked(), certified.baked(), std::string("--against"), std::string()}) {
      const auto run = oracle::run_clip_checker(arguments);
      if (run.status != 2) wrong += arguments + ": " + std::to_string(run.status) + "; ";
    }
    const std::string listed = certified.judged_against(glb_of({{json_chunk, "[]"}}, "list.glb"));
    if (!is_unreadable_for(listed, "the file's description is no object")) wrong += listed;
    const std::string marked = certified.judged_with([](auto& chunks) { chunks[0].data.insert(0, "\xef\xbb\xbf"); });
    if (!is_unreadable_for(marked, "the file's JSON begins with a byte order mark, which is to be left out")) wrong += marked;
    return Checked(wrong.empty(), static_cast<long>(texts.size()) + 6, wrong);
  });
}

}  // namespace

PROPTEST(clip_certificate) {
  what_bounds_are_not_about(t);
  bounds_that_leave_something_out_are_rejected(t);
  slacks_of_bounds(t);
  slots_of_weights(t);
  numbers_that_underflow(t);
  certificates_are_of_the_file(t);
  half_turns_intervals_and_what_is_no_certificate(t);
  t.holds("certificates of random models are accepted, and rejected if a bound leaves out a vertex that is seen",
          {.number_type = "double",
           .cases = 40,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"certified", 0.5}, {"accepted", 0.4}, {"cut", 0.3}}},
          check_random_models);
}

}  // namespace proptests::suite_clip_certificate
