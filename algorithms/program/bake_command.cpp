// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "algorithms/bake/bake.hpp"
#include "algorithms/bake/over_time/half_turns.hpp"
#include "algorithms/bake/over_time/model_bounds.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/program/bound_json.hpp"
#include "algorithms/program/clip_certificate.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/extras.hpp"
#include "algorithms/program/json_text.hpp"
#include "algorithms/program/peak_memory.hpp"
#include "algorithms/program/report.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

struct BakeCall {
  std::string in, out, json, report, certificate;
  ModelBoundsOptions bounds;
  bool with_character = true, with_nodes = false;
};

// Bounds are wider by 2^-19 of the distance from the origin, for what a renderer rounds (ModelBoundsOptions), which is more than this
// share of their volume. A search for less than that would halve its intervals tens of thousands of times, for nothing.
constexpr double least_tolerance = 1e-6;

po::options_description options() {
  po::options_description description("options");
  description.add_options()("help", "this text")("for", po::value<std::string>()->default_value("clip"),
                                                 "clip: the file's animations; crossfade: while any of them fades to any other, "
                                                 "too; any: however code turns the joints, "
                                                 "too")("skinning", po::value<std::string>()->default_value("linear"),
                                                        "linear, as glTF says; dual-quaternion; or spherical")(
      "clusters", po::value<int>()->default_value(128),
      "most triangles of a cluster, a multiple of 4 up to 512; 0 bakes no clusters")(
      "dop", po::value<int>()->default_value(6),
      "6, 14, 18 or 26: bounds are k-DOPs of as many planes, of which the box is a part")(
      "nodes", "bound each node of the character's tree, too; in clips alone")(
      "no-character", "leave out the character for refits on demand, which takes most of the memory and of the file")(
      "tolerance", po::value<double>()->default_value(0.01), "how much larger than needed a volume may be: from 1e-6 to 1")(
      "crossfade-tolerance", po::value<double>()->default_value(0.2, "0.2"), "the same of crossfades")(
      "rotations", po::value<std::string>()->default_value("slerp"),
      "slerp or nlerp: how crossfades blend rotations, on the shorter way; all else they blend linearly")(
      "json", po::value<std::string>(), "write what was measured to this file too")(
      "report", po::value<std::string>(),
      "write a page that shows the bounds, and what sampling would have missed, to this file")(
      "certificate", po::value<std::string>(), "write why the bounds hold to this file, for others to verify")(
      "quiet", "show no progress and no notes");
  return description;
}

// Returns the files that a call writes besides OUT.
std::vector<NamedFile> written_beside(const po::variables_map& map) { return files_of(map, {"json", "report", "certificate"}); }

BakeCall parse(const po::variables_map& map) {
  BakeCall call{map["IN.glb"].as<std::string>(), map["OUT.glb"].as<std::string>(), "", "", "", {}};
  if (map.count("json")) call.json = map["json"].as<std::string>();
  if (map.count("report")) call.report = map["report"].as<std::string>();
  call.bounds.skinning = skinning_of(map["skinning"].as<std::string>());
  if (map.count("certificate")) {
    if (call.bounds.skinning != Skinning::linear) throw UsageError("--certificate is for linear skinning alone");
    call.certificate = map["certificate"].as<std::string>();
    call.bounds.with_intervals = true;
  }
  call.with_character = !map.count("no-character"), call.with_nodes = map.count("nodes");
  if (call.with_nodes && !call.with_character)
    throw UsageError("--nodes are those of the character that --no-character leaves out");
  call.bounds.dop = map["dop"].as<int>();
  if (!is_dop_size(call.bounds.dop)) throw UsageError("--dop takes 6, 14, 18 or 26");
  const std::string purpose = map["for"].as<std::string>();
  if (purpose != "clip" && purpose != "crossfade" && purpose != "any")
    throw UsageError("--for " + purpose + ": there are clip, crossfade and any");
  call.bounds.any_pose = purpose == "any";
  call.bounds.crossfades = purpose == "crossfade";
  const std::string rotations = map["rotations"].as<std::string>();
  if (rotations != "slerp" && rotations != "nlerp") throw UsageError("--rotations " + rotations + ": there are slerp and nlerp");
  for (const char* name : {"rotations", "crossfade-tolerance"})
    if (!call.bounds.crossfades && !map[name].defaulted())
      throw UsageError("--" + std::string(name) + " is that of crossfades, which --for crossfade bounds");
  call.bounds.rotations = rotations == "slerp" ? RotationBlend::slerp : RotationBlend::nlerp;
  call.bounds.cluster_triangles = map["clusters"].as<int>();
  const int c = call.bounds.cluster_triangles;
  if (c != 0 && (c < 4 || c > 512 || c % 4 != 0)) throw UsageError("--clusters takes a multiple of 4 from 4 to 512, or 0");
  for (const auto& [name, tolerance] :
       {std::pair("tolerance", &call.bounds.tolerance), std::pair("crossfade-tolerance", &call.bounds.crossfade_tolerance)}) {
    *tolerance = map[name].as<double>();
    if (!(*tolerance >= least_tolerance && *tolerance <= 1))
      throw UsageError("--" + std::string(name) +
                       " takes a number from 1e-6 to 1; bounds leave more room than that for rounding");
  }
  if (call.out.empty()) throw UsageError("OUT.glb takes a file");
  check_written({{"IN.glb", call.in}, {"OUT.glb", call.out}}, written_beside(map));
  return call;
}

nlohmann::ordered_json json_of_parts(const ModelBounds& bounds, const std::vector<BoundedPart>& bounded) {
  nlohmann::ordered_json out;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    nlohmann::ordered_json part = {{"kind", name_of(bounds.parts[p].kind)}, {"index", bounds.parts[p].index}};
    part.update(json_of_bound<nlohmann::ordered_json>(bounded[p]));
    out.push_back(part);
  }
  return out;
}

// The first is the peak until the bounds were made, and the second until the file was written.
struct PeakMemory {
  std::optional<double> bounding, all;
};

std::string summary_json(const Model& model, const ModelBounds& bounds, const BakeCall& call, double seconds,
                         const PeakMemory& peak) {
  nlohmann::ordered_json out = {{"file", call.in},
                                {"skinning", name_of(bounds.skinning)},
                                {"tolerance", call.bounds.tolerance},
                                {"triangles", model.triangles.size()},
                                {"vertices", model.vertices.size()},
                                {"seconds", seconds},
                                {"moments", bounds.moments},
                                {"clips", nlohmann::ordered_json::array()}};
  if (!bounds.crossfades.empty()) out["crossfade_tolerance"] = call.bounds.crossfade_tolerance;
  if (peak.bounding && peak.all) out["peak_megabytes_bounding"] = *peak.bounding, out["peak_megabytes"] = *peak.all;
  for (const BoundedClip& clip : bounds.clips)
    out["clips"].push_back({{"name", clip.name}, {"duration", clip.duration}, {"parts", json_of_parts(bounds, clip.parts)}});
  for (const BoundedCrossfade& fade : bounds.crossfades)
    out["crossfades"].push_back({{"first", bounds.clips[fade.first].name},
                                 {"second", bounds.clips[fade.second].name},
                                 {"parts", json_of_parts(bounds, fade.parts)}});
  return text_of(out, 1) + "\n";
}

Character baked_character(const Model& model) {
  SkinnedMesh mesh = skinned_mesh(model);
  mesh.name.clear();  // what is written does not depend on where the file was
  return bake(std::move(mesh), {}, {Pieces::mixed}, joints_of(model));
}

// Returns a note for each part that no node's ball encloses in any pose.
std::vector<std::string> parts_without_ball(const ModelBounds& bounds) {
  std::vector<std::string> out;
  for (std::size_t p = 0; p < bounds.any_pose.size(); ++p)
    if (!bounds.any_pose[p])
      out.push_back(name_of(bounds.parts[p].kind) +
                    (bounds.parts[p].index < 0 ? std::string() : ' ' + std::to_string(bounds.parts[p].index)) +
                    ": has no ball for any pose: no node is above all of its joints, or a vertex of three joints or more is not "
                    "blended linearly");
  return out;
}

// Returns a note if the description names other files, and is to be in another folder, from which their paths do not lead to
// them.
std::vector<std::string> files_left_behind(const std::string& description, const BakeCall& call) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto folder = [&](const std::string& file) {
    return fs::weakly_canonical(fs::absolute(file, error), error).parent_path();
  };
  if (folder(call.in) == folder(call.out)) return {};
  const auto json = nlohmann::json::parse(description);
  std::vector<std::string> names;
  for (const char* array : {"buffers", "images"})
    for (const auto& thing : json.value(array, nlohmann::json::array()))
      if (const std::string uri = thing.value("uri", "data:"); !uri.starts_with("data:")) names.push_back(uri);
  if (names.empty()) return {};
  return {"names " + std::to_string(names.size()) + (names.size() == 1 ? " file" : " files") + ", such as '" + names[0] +
          "', by the path from its own folder; to be found, they have to be copied there, too"};
}

int run_bake(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  const po::variables_map map = parse_arguments(arguments, options(), {"IN.glb", "OUT.glb"});
  if (map.count("help")) {
    out << "usage: refitlab bake [OPTION...] IN.glb OUT.glb\n\n"
           "Writes IN.glb again with bounds that hold at every time of its animations: boxes and balls as extras of its\n"
           "skins, meshes, primitives and animations, and clusters of triangles with their bounds in a chunk of its own.\n"
           "Nothing else in the file changes. A folder that is missing is made. OUT.glb may be IN.glb, which it then replaces\n"
           "once all is done. Bounds are in the frame of the scene, in the units of the file.\n\n"
        << options();
    return exit_done;
  }
  const BakeCall call = parse(map);
  std::vector<GlbChunk> chunks = read_glb(read_whole(call.in), call.in);
  const bool is_linear = call.bounds.skinning == Skinning::linear;
  const Model model = load_model(call.in, {.joints = is_linear ? Joints::affine : Joints::rigid, .morphs = Morphs::moving});

  // What cannot be written is told before the bounds take their time.
  for (const std::string* file : {&call.certificate, &call.report, &call.json, &call.out})
    if (!file->empty()) check_writable(*file);
  if (!call.report.empty()) check_report(model, call.in);
  if (!map.count("quiet")) {
    print_notes(call.in, model.notes, errors);
    print_notes(call.in, half_turns(model), errors);
    if (call.bounds.crossfades && model.clips.size() < 2)
      print_notes(call.in, {"has fewer than two clips, between which there could be a crossfade"}, errors);
  }

  ModelBoundsOptions bounded = call.bounds;
  std::optional<Character> character;
  if (call.with_nodes) {
    character = baked_character(model);
    for (int n = 0; n < static_cast<int>(character->tree.nodes.size()); ++n)
      bounded.nodes.emplace_back(character->vertices[n].begin(), character->vertices[n].end());
  }
  const auto start = std::chrono::steady_clock::now();
  ModelBounds bounds;
  {
    ProgressBar bar(errors, !map.count("quiet") && isatty(STDERR_FILENO) != 0);
    bounded.progress = [&](double share) { bar.show(share); };
    bounds = bound_model(model, bounded);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto peak_of_bounding = peak_megabytes();
  if (!map.count("quiet")) {
    print_notes(call.in, parts_without_ball(bounds), errors);
    print_notes(call.out, files_left_behind(chunks[0].data, call), errors);
  }

  chunks[0].data = with_extras(chunks[0].data, model, bounds, call.bounds, call.in);
  std::erase_if(chunks, [](const GlbChunk& chunk) { return chunk.type == refitlab_chunk; });
  // The second chunk is for buffers. Where there is none, many readers refuse another kind in its place; one of zeros harms
  // nothing.
  if (chunks.size() < 2 || chunks[1].type != bin_chunk) chunks.insert(chunks.begin() + 1, {bin_chunk, std::string(4, '\0')});
  BakedFile baked_file{bounds.skinning, bounds.rotations, std::nullopt, clusters_of(model, bounds)};
  if (call.with_character) baked_file.character = character ? *std::move(character) : baked_character(model);
  chunks.push_back({refitlab_chunk, chunk_of(baked_file)});
  const std::string baked = glb_of(chunks, call.out), report = call.report.empty() ? "" : report_page(model, bounds, call.in);
  // OUT comes last: where another file cannot be written, nothing has taken its place, which may be IN's.
  if (!call.certificate.empty()) write_whole(call.certificate, clip_certificate(model, bounds, baked));
  if (!call.report.empty()) write_whole(call.report, report);
  if (!call.json.empty())
    write_whole(call.json, summary_json(model, bounds, call, seconds, {peak_of_bounding, peak_megabytes()}));
  write_whole(call.out, baked);

  long clusters = 0;
  for (const ModelPart& part : bounds.parts) clusters += part.kind == PartKind::cluster;
  std::vector<NamedFile> written = written_beside(map);
  written.push_back({"OUT.glb", call.out});
  std::ostream& told = told_to(written, out, errors);
  told << printable(call.out) << ": " << model.triangles.size() << " triangles in " << clusters << " clusters, "
       << bounds.clips.size() << " clips, " << bounds.crossfades.size() << " crossfades, " << name_of(bounds.skinning)
       << " skinning; " << std::fixed << std::setprecision(2) << seconds << " s\n";
  return exit_done;
}

}  // namespace

const Command bake_command = {"bake", "writes bounds over time into a glTF file", run_bake};

}  // namespace refitlab
