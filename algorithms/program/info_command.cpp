// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "algorithms/model/load.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/guarded_load.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/binary.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

// Returns whether a clip's poses are rigid at the times that are checked on loading, as refits on demand require, or else why
// not.
std::string rigid_or_why(const Clip& clip) {
  try {
    for (const double time : key_times(clip.animation, max_checked_times)) clip.sample(time);
    return "rigid";
  } catch (const ModelError& e) {
    return std::string("not rigid: ") + e.what();
  }
}

// Says what refitlab's chunk in a binary glTF file has, if there is one.
void print_baked(const std::string& file, std::ostream& out) {
  const std::string bytes = read_bytes(file);
  if (!bytes.starts_with("glTF")) return;
  for (const GlbChunk& chunk : read_glb(bytes, file)) {
    if (chunk.type != refitlab_chunk) continue;
    const BakedFile baked = baked_of(chunk.data, file);
    const ClusterBounds& bounds = baked.clusters;
    out << "  baked         for " << name_of(baked.skinning) << " skinning: " << bounds.clusters.size() << " clusters";
    if (bounds.dop > 6) out << " in " << bounds.dop << "-DOPs";
    if (!bounds.crossfades.empty()) out << ", " << bounds.crossfades.size() << " crossfades by " << name_of(baked.rotations);
    if (!baked.character) out << ", no character";
    else {
      out << ", a character of " << baked.character->tree.nodes.size() << " nodes";
      if (!bounds.clips[0].nodes.empty()) out << " with bounds over time";
    }
    out << '\n';
  }
}

int run_info(const std::vector<std::string>& arguments, std::ostream& out, std::ostream&) {
  po::options_description options("options");
  options.add_options()("help", "this text");
  const po::variables_map map = parse_arguments(arguments, options, {"FILE"});
  if (map.count("help")) {
    out << "usage: refitlab info FILE\n\nSays what is in a rigged model: glTF, or whatever assimp reads. Of a file that cannot "
           "be\n"
           "used, it says why.\n\n"
        << options;
    return exit_done;
  }
  const std::string file = map["FILE"].as<std::string>();
  const Model model = load_model_guarded(file, {.joints = Joints::affine, .morphs = Morphs::moving});
  const JointSets sets(model);
  std::size_t most = 0;
  for (const auto& influences : model.influences) most = std::max(most, influences.size());
  out << printable(file) << '\n'
      << "  triangles     " << model.triangles.size() << '\n'
      << "  vertices      " << model.vertices.size() << ", of different positions and weights\n"
      << "  joints        " << model.joints.size() << '\n'
      << "  joint-sets    " << sets.count() << ", of " << most << " joints at most\n"
      << "  primitives    " << model.sources.size() << '\n'
      << "  morph targets " << morph_targets(model).count << '\n'
      << "  clips         " << model.clips.size() << '\n';
  int number = 0;
  for (const Clip& clip : model.clips) {
    std::size_t keys = 0;
    for (const NodeTrack& track : clip.animation.tracks)
      keys += track.positions.keys.size() + track.rotations.keys.size() + track.scales.keys.size();
    out << "    #" << ++number << ' ' << printable(clip.name) << ": " << format_number(clip.duration) << " s, " << keys
        << " keys, " << rigid_or_why(clip) << '\n';
  }
  print_baked(file, out);
  print_notes(model.name, model.notes, out);
  return exit_done;
}

}  // namespace

const Command info_command = {"info", "says what is in a model, or why it cannot be used", run_info};

}  // namespace refitlab
