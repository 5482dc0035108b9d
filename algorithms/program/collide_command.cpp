// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "algorithms/certificate/limits.hpp"
#include "algorithms/certificate/pairs_certificate.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/guarded_load.hpp"
#include "algorithms/program/json_text.hpp"
#include "algorithms/program/posed_character.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

// The clip of this name or, if none has it, of this number: "#1" is the first.
const Clip* clip_of(const std::vector<Clip>& clips, const std::string& file, const std::string& name) {
  if (name.empty()) return nullptr;
  const auto has_name = [&](const Clip& clip) { return clip.name == name; };
  const auto found = std::find_if(clips.begin(), clips.end(), has_name);
  if (found != clips.end()) {
    const auto count = std::count_if(found, clips.end(), has_name);
    if (count == 1) return &*found;
    throw ModelError(file, "clip '" + name + "'",
                     std::to_string(count) + " clips have this name: #" + std::to_string(found - clips.begin() + 1) +
                         " is the first of them by its number");
  }
  for (std::size_t c = 0; c < clips.size(); ++c)
    if (name == "#" + std::to_string(c + 1)) return &clips[c];
  std::string names;
  for (const Clip& clip : clips) names += (names.empty() ? "" : ", ") + clip.name;
  if (names.empty()) names = "none";
  throw ModelError(file, "clip '" + name + "'", "there is no such clip, but " + names);
}

// Returns a name such as "man.glb, clip walk at 0.5 s".
std::string posed_name(const std::string& file, const po::variables_map& map, const std::string& side) {
  const std::string clip = map["clip-" + side].as<std::string>(), name = std::filesystem::path(file).filename().string();
  if (clip.empty()) return name + " at rest";
  return name + ", clip " + clip + " at " + std::to_string(map["time-" + side].as<double>()) + " s";
}

// A Place is where a character stands. Boost gives validate all words behind the option up to the next one.
struct Place {
  Point3 at;
};

void validate(boost::any& value, const std::vector<std::string>& words, Place*, int) {
  Place out;
  bool is_place = words.size() == 3;
  for (int i = 0; i < 3; ++i)
    is_place = is_place && boost::conversion::try_lexical_convert(words[i], out.at[i]) && std::isfinite(out.at[i]);
  std::string given;
  for (const std::string& word : words) given += " " + word;
  if (!is_place) throw UsageError("--at takes three numbers that are finite, and A and B come before it; it was given" + given);
  value = out;
}

po::options_description collide_options() {
  po::options_description description("options");
  const auto add = [&](const char* name, const char* text, auto... value) { description.add_options()(name, value..., text); };
  add("help", "this text");
  for (const std::string side : {"a", "b"}) {
    const std::string body = side == "a" ? "A" : "B";
    add(("clip-" + side).c_str(), ("the clip of " + body + ", by its name or, as #1, its number; else it rests").c_str(),
        po::value<std::string>()->default_value(""));
    add(("time-" + side).c_str(), "seconds", po::value<double>()->default_value(0));
  }
  add("at", "x, y and z: where B stands; A and B come before it", po::value<Place>()->multitoken());
  add("skinning", "linear, dual-quaternion or spherical", po::value<std::string>()->default_value("linear"));
  add("pairs", "list the pairs");
  add("json", "write the pairs to this file", po::value<std::string>());
  add("certificate", "write why these pairs touch, and no others, to this file, for others to verify", po::value<std::string>());
  add("documents",
      "write the posed bodies to files of this name with .first and .second, for a certificate to be checked against",
      po::value<std::string>());
  return description;
}

// Returns the files that a call writes besides the standard output.
std::vector<NamedFile> written_files(const po::variables_map& map) {
  std::vector<NamedFile> out = files_of(map, {"json", "certificate", "documents"});
  if (!map.count("documents") || out.back().path.empty()) return out;
  const NamedFile documents = out.back();
  out.pop_back();
  for (const char* end : {".first", ".second"}) out.push_back({documents.of, documents.path + end});
  return out;
}

int run_collide(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  const po::variables_map map = parse_arguments(arguments, collide_options(), {"A", "B"});
  if (map.count("help")) {
    out << "usage: refitlab collide [OPTION...] A B\n\nSays which triangles of two characters touch, exactly. With --pairs a "
           "line a pair: the\n"
           "triangle of A and that of B. They count from 0 through all of a file's triangles, without those of which two "
           "vertices\n"
           "are equal.\n\n"
        << collide_options();
    return exit_done;
  }
  const Skinning skinning = skinning_of(map["skinning"].as<std::string>());
  RigidTransform<double> here{{1, 0, 0, 0}, {0, 0, 0}}, there = here;
  if (map.count("at")) there.translation = map["at"].as<Place>().at;
  const auto posed = [&](const std::string& file, const char* side) {
    Model model = load_model_guarded(file, {.joints = Joints::affine, .morphs = Morphs::moving});
    print_notes(model.name, model.notes, errors);
    const Clip* clip = clip_of(model.clips, file, map["clip-" + std::string(side)].as<std::string>());
    const po::variable_value& given = map["time-" + std::string(side)];
    if (!clip && !given.defaulted())
      throw UsageError("--time-" + std::string(side) + " is that of a clip: --clip-" + side + " names it");
    const double time = given.as<double>();
    if (clip && !(time >= 0 && time <= clip->duration))
      throw UsageError("--time-" + std::string(side) + ": the clip goes from 0 to " + format_number(clip->duration) + " s");
    const Animation animation = clip ? clip->animation : Animation{};
    return posed_character(std::move(model), animation, time, skinning);
  };
  const std::string file_a = map["A"].as<std::string>(), file_b = map["B"].as<std::string>();
  check_written({{"A", file_a}, {"B", file_b}}, written_files(map));
  const std::string name_a = posed_name(file_a, map, "a"), name_b = posed_name(file_b, map, "b");
  const PosedCharacter first = posed(file_a, "a"), second = posed(file_b, "b");
  const ClusterTree tree_a(first.character), tree_b(second.character);
  ClusterBody body_a(tree_a, skinning), body_b(tree_b, skinning);
  first.begin(body_a, here), second.begin(body_b, there);
  QueryCounts counts;
  std::vector<TrianglePair> pairs = collide(body_a, body_b, Query::full, counts);
  std::sort(pairs.begin(), pairs.end());
  if (map.count("documents")) {
    const std::string name = map["documents"].as<std::string>();
    write_whole(name + ".first", body_document(posed_body(body_a, name_a)));
    write_whole(name + ".second", body_document(posed_body(body_b, name_b)));
  }
  if (map.count("certificate")) {
    const std::string about = std::string("touching triangles, ") + name_of(skinning) + " skinning";
    const std::string file = map["certificate"].as<std::string>();
    const std::string text = pairs_certificate(about, posed_body(body_a, name_a), posed_body(body_b, name_b), pairs);
    write_whole(file, text);
    errors << note_of_refusal(file, refusal_of_pairs_certificate(text));
  }
  if (map.count("json")) {
    nlohmann::ordered_json summary = {{"first", name_a}, {"second", name_b}, {"skinning", name_of(skinning)}};
    summary["pairs"] = nlohmann::json::array();
    for (const TrianglePair& pair : pairs) summary["pairs"].push_back({pair.first, pair.second});
    write_whole(map["json"].as<std::string>(), text_of(summary) + "\n");
  }
  std::ostream& told = told_to(written_files(map), out, errors);
  told << pairs.size() << " pairs of triangles touch\n";
  if (map.count("pairs"))
    for (const TrianglePair& pair : pairs) told << pair.first << ' ' << pair.second << '\n';
  return exit_done;
}

}  // namespace

const Command collide_command = {"collide", "says which triangles of two characters touch", run_collide};

}  // namespace refitlab
