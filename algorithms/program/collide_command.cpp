// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/model/guarded_load.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

const Clip* clip_of(const std::vector<Clip>& clips, const std::string& file, const std::string& name) {
  if (name.empty()) return nullptr;
  const auto found = std::find_if(clips.begin(), clips.end(), [&](const Clip& clip) { return clip.name == name; });
  if (found == clips.end()) throw ModelError(file, "clip '" + name + "'", "there is no such clip");
  return &*found;
}

int run_collide(const std::vector<std::string>& arguments, std::ostream& out, std::ostream&) {
  po::options_description options("options");
  options.add_options()("help", "this text")("clip-a", po::value<std::string>()->default_value(""),
                                             "the clip of A; else it rests")(
      "time-a", po::value<double>()->default_value(0), "seconds")("clip-b", po::value<std::string>()->default_value(""),
                                                                  "the clip of B")(
      "time-b", po::value<double>()->default_value(0), "seconds")("at", po::value<std::vector<double>>()->multitoken(),
                                                                  "x, y and z: where B stands; options of files come before it")(
      "skinning", po::value<std::string>()->default_value("linear"), "linear, dual-quaternion or spherical")("pairs",
                                                                                                             "list the pairs");
  const po::variables_map map = parse_arguments(arguments, options, {"A", "B"});
  if (map.count("help")) {
    out << "usage: refitlab collide [OPTION...] A B\n\nSays which triangles of two characters touch, exactly. With --pairs a "
           "line a pair: the\n"
           "triangle of A and that of B.\n\n"
        << options;
    return exit_done;
  }
  const Skinning skinning = skinning_of(map["skinning"].as<std::string>());
  RigidTransform<double> here{{1, 0, 0, 0}, {0, 0, 0}}, there = here;
  if (map.count("at")) {
    const auto& at = map["at"].as<std::vector<double>>();
    if (at.size() != 3) throw UsageError("--at takes three numbers");
    there.translation = {at[0], at[1], at[2]};
  }
  const auto pose_of = [&](const Model& model, const std::string& file, const char* side) {
    const Clip* clip = clip_of(model.clips, file, map["clip-" + std::string(side)].as<std::string>());
    if (!clip) return model.skeleton.joints.empty() ? reference_pose(model) : pose(model.skeleton, Animation{}, 0).pose;
    const double time = map["time-" + std::string(side)].as<double>();
    if (!(time >= 0 && time <= clip->duration))
      throw UsageError("--time-" + std::string(side) + ": the clip goes from 0 to " + std::to_string(clip->duration) + " s");
    return clip->sample(time);
  };
  const std::string file_a = map["A"].as<std::string>(), file_b = map["B"].as<std::string>();
  Model a = load_model_guarded(file_a), b = load_model_guarded(file_b);
  const Pose pose_a = pose_of(a, file_a, "a"), pose_b = pose_of(b, file_b, "b");
  const Character first = bake(SkinnedMesh(std::move(a))), second = bake(SkinnedMesh(std::move(b)));
  const ClusterTree tree_a(first), tree_b(second);
  ClusterBody body_a(tree_a, skinning), body_b(tree_b, skinning);
  body_a.begin(pose_a, here), body_b.begin(pose_b, there);
  QueryCounts counts;
  std::vector<TrianglePair> pairs = collide(body_a, body_b, Query::full, counts);
  std::sort(pairs.begin(), pairs.end());
  out << pairs.size() << " pairs of triangles touch\n";
  if (map.count("pairs"))
    for (const TrianglePair& pair : pairs) out << pair.first << ' ' << pair.second << '\n';
  return exit_done;
}

}  // namespace

const Command collide_command = {"collide", "says which triangles of two characters touch", run_collide};

}  // namespace refitlab
