// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/growth.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "algorithms/model/write_gltf.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/tree/fingerprint.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/over_time/repeated.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/procedural/subdivide.hpp"

namespace refitlab {
namespace {

constexpr int finest_man_triangles = 16540, finest_subdivisions = 3;

long cluster_count(const Model& model) {
  const auto parts = parts_of(model, ModelBoundsOptions{}.cluster_triangles);
  return std::count_if(parts.begin(), parts.end(), [](const ModelPart& part) { return part.kind == PartKind::cluster; });
}

OverTimeGrowth longer(const Model& walk, int walk_cycles, int repetitions) {
  Model model = walk;
  model.clips[0].animation = repeated(walk.clips[0].animation, walk_cycles);
  OverTimeGrowth out{"walk_cycles", walk_cycles, static_cast<long>(model.triangles.size()), cluster_count(model), infinite, 0, 0};
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    bound_model(model);
    out.seconds = std::min(out.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return out;
}

// A ScratchFolder is a folder of its own for files that are not kept.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "refitlab-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("there is no room for files in " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

OverTimeGrowth finer(const Model& walk, int repetitions) {
  const ScratchFolder folder;
  const std::string in = folder.file("in.glb"), summary = folder.file("summary.json");
  write_gltf(walk, in);
  OverTimeGrowth out{"triangles", 1, static_cast<long>(walk.triangles.size()), cluster_count(walk), infinite, 0, 0};
  for (int i = 0; i < repetitions; ++i) {
    const std::string command =  // in pages as a user has them, since its memory is measured
        "GLIBC_TUNABLES= '" REFITLAB_PROGRAM "' bake --quiet --json '" + summary + "' '" + in + "' '" + folder.file("out.glb") +
        "' >/dev/null";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("this command fails: " + command);
    const auto json = nlohmann::json::parse(std::ifstream(summary));
    out.seconds = std::min(out.seconds, json["seconds"].get<double>());
    out.peak_of_bounding = std::max(out.peak_of_bounding, json["peak_megabytes_bounding"].get<double>());
    out.peak_of_all = std::max(out.peak_of_all, json["peak_megabytes"].get<double>());
  }
  return out;
}

}  // namespace

std::string identify_baking_program() {
  Fingerprint print;
  print.add_bytes(read_whole(REFITLAB_PROGRAM));
  return print.text();
}

std::vector<OverTimeGrowth> run_over_time_growth(const OverTimeGrowthSettings& settings) {
  std::vector<OverTimeGrowth> rows;
  const auto add = [&](const OverTimeGrowth& row) {
    rows.push_back(row);
    std::printf("  by %-11s %2ld walks, %7ld triangles, %4ld clusters: %7.3f s", row.grown.c_str(), row.walk_cycles,
                row.triangles, row.clusters, row.seconds);
    if (row.peak_of_all > 0) std::printf("; peak %.0f MB, with the character %.0f MB", row.peak_of_bounding, row.peak_of_all);
    std::cout << std::endl;
  };
  const Model man = with_keys(make_man(), 1);  // whose first clip is the walk
  for (const int walk_cycles : {1, 2, 4, 8, 16}) add(longer(man, walk_cycles, settings.repetitions));
  Model fine = man;
  for (int i = 0; i <= settings.subdivisions; ++i) {
    if (i > 0) fine = subdivide(fine);
    add(finer(fine, settings.repetitions));
  }
  if (settings.up_to_a_million) {
    fine = with_keys(make_man(finest_man_triangles), 1);
    for (int i = 0; i < finest_subdivisions; ++i) fine = subdivide(fine);
    add(finer(fine, settings.repetitions));
  }
  return rows;
}

void write_over_time_growth(const std::vector<OverTimeGrowth>& rows, const std::string& path) {
  ResultFile file(
      {"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "walk_cycles", "triangles", "clusters"});
  for (const OverTimeGrowth& r : rows) {
    const auto add = [&](const char* quantity, double value, const char* unit) {
      file.add({"over_time_growth", "man", "walk", r.grown, "all", quantity, format_number(value), unit,
                std::to_string(r.walk_cycles), std::to_string(r.triangles), std::to_string(r.clusters)});
    };
    add("bounding_seconds", r.seconds, "s");
    if (r.peak_of_all == 0) continue;
    add("peak_megabytes_bounding", r.peak_of_bounding, "MB");
    add("peak_megabytes", r.peak_of_all, "MB");
  }
  file.write(path);
}

}  // namespace refitlab
