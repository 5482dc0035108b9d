// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/report.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/program/json_text.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "refitlab_report_template.hpp"

namespace refitlab {
namespace {

constexpr int frames_shown = 32;       // of a clip
constexpr int moments_between = 8;     // looked at between two sampled times
constexpr double longest_clip = 3600;  // seconds
constexpr int moments_on_chart = 100;  // or more
constexpr double least_miss = 1e-6;    // as a share of a side: less is rounding

std::vector<const ModelPart*> clusters_in(const ModelBounds& bounds, std::vector<std::size_t>& positions) {
  std::vector<const ModelPart*> out;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p)
    if (bounds.parts[p].kind == PartKind::cluster) out.push_back(&bounds.parts[p]), positions.push_back(p);
  return out;
}

// Returns the sampled times, and some more between any two of them.
std::vector<double> more_times(const std::vector<double>& times, int between = moments_between) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (int k = 0; k < between; ++k) out.push_back(times[i] + (times[i + 1] - times[i]) * k / between);
  out.push_back(times.back());
  return out;
}

void merge_at(const AnimatedJoints& joints, const MovingVertices& vertices, double time, Box<double>& box) {
  std::vector<Point3> points;
  vertices.place(*joints.at(time, Side::after), Followed::skinned, points);
  for (const Point3& p : points) box.merge(p);
}

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

void put_16_bits(std::string& bytes, long x) { bytes += static_cast<char>(x & 0xFF), bytes += static_cast<char>(x >> 8 & 0xFF); }
void put_32_bits(std::string& bytes, long x) { put_16_bits(bytes, x & 0xFFFF), put_16_bits(bytes, x >> 16); }

nlohmann::json numbers(const Box<float>& box) {
  nlohmann::json out = nlohmann::json::array();
  for (const auto* point : {&box.low, &box.high})
    for (const float x : *point) out.push_back(x);
  return out;
}

// Returns vertices with 16 bits for each coordinate, as shares of the box of the whole.
std::string frames_of(const AnimatedJoints& joints, const MovingVertices& all, const Box<float>& box) {
  std::string bytes;
  std::vector<Point3> points;
  for (int f = 0; f < frames_shown; ++f) {
    all.place(*joints.at(joints.times().back() * f / (frames_shown - 1), Side::after), Followed::skinned, points);
    for (const Point3& p : points)
      for (int i = 0; i < 3; ++i) {
        const double side = std::max(static_cast<double>(box.high[i]) - box.low[i], 1e-30);
        put_16_bits(bytes, std::lround(std::clamp((p[i] - box.low[i]) / side, 0.0, 1.0) * 65535));
      }
  }
  return base64(bytes);
}

// Returns, over time, the coordinate in which the cluster leaves the box of its keys by most.
nlohmann::json chart_of(const AnimatedJoints& joints, const MovingVertices& cluster, const BoundedPart& bound) {
  Box<double> of_keys = Box<double>::empty(), of_all = of_keys;
  for (const double time : joints.times()) merge_at(joints, cluster, time, of_keys);
  const int parts = joints.part_count();
  const std::vector<double> times = more_times(joints.times(), std::max(moments_between, moments_on_chart / parts));
  std::vector<Box<double>> boxes(times.size(), Box<double>::empty());
  for (std::size_t i = 0; i < times.size(); ++i) merge_at(joints, cluster, times[i], boxes[i]), of_all.merge(boxes[i]);
  int axis = 0;
  bool is_low = false;
  double most = -1;
  for (int i = 0; i < 3; ++i) {
    if (const double by = of_keys.low[i] - of_all.low[i]; by > most) most = by, axis = i, is_low = true;
    if (const double by = of_all.high[i] - of_keys.high[i]; by > most) most = by, axis = i, is_low = false;
  }
  nlohmann::json out = {{"axis", axis}, {"low", is_low}, {"keys", joints.times()}};
  for (std::size_t i = 0; i < times.size(); ++i)
    out["curve"].push_back({times[i], is_low ? boxes[i].low[axis] : boxes[i].high[axis]});
  out["of_keys"] = is_low ? of_keys.low[axis] : of_keys.high[axis];
  out["bound"] = is_low ? bound.box.low[axis] : bound.box.high[axis];
  return out;
}

}  // namespace

SampledMisses misses_of_sampling(const Model& model, const ModelBounds& bounds, std::size_t clip, Sampling sampling) {
  const DefaultFloatEnvironment environment;
  const JointSets sets(model);
  const AnimatedJoints joints(model, model.clips[clip].animation, bounds.skinning != Skinning::linear);
  const std::vector<double> sampled =
                                sampling == Sampling::keys ? joints.times() : times_at_rate(sampled_rate, joints.times().back()),
                            all = more_times(sampled);
  std::vector<std::size_t> positions;
  const auto clusters = clusters_in(bounds, positions);
  SampledMisses out;
  std::mutex guard;
  parallel_for(clusters.size(), [&](std::size_t c) {
    const DefaultFloatEnvironment own_environment;
    const MovingVertices vertices(model, sets, bounds.skinning, clusters[c]->vertices);
    Box<double> known = Box<double>::empty();
    for (const double time : sampled) merge_at(joints, vertices, time, known);
    double most = 0, when = 0;
    for (const double time : all) {
      Box<double> box = Box<double>::empty();
      merge_at(joints, vertices, time, box);
      if (const double by = beyond_box(box, known); by > most) most = by, when = time;
    }
    const double share = most / known.edges().maxCoeff();
    const std::lock_guard lock(guard);
    if (!(share > least_miss)) return;  // NaN of a cluster that stays a point
    ++out.clusters;
    if (share > out.by) out.by = share, out.worst = static_cast<int>(c), out.time = when;
  });
  return out;
}

void check_report(const Model& model, const std::string& file) {
  for (const Clip& clip : model.clips)
    if (!(clip.duration <= longest_clip))
      throw ModelError(file, "clip '" + clip.name + "'", "it is longer than an hour, too long to be sampled for a report");
}

std::string report_page(const Model& model, const ModelBounds& bounds, const std::string& file) {
  const DefaultFloatEnvironment environment;
  const JointSets sets(model);
  std::vector<std::size_t> positions;
  const auto clusters = clusters_in(bounds, positions);
  nlohmann::json data = {{"file", std::filesystem::path(file).filename().string()},
                         {"skinning", name_of(bounds.skinning)},
                         {"clusters", clusters.size()},
                         {"frames", frames_shown}};
  std::string triangles, cluster_of;
  for (const Triangle& t : model.triangles)
    for (const int v : t) put_32_bits(triangles, v);
  std::vector<int> clusters_of_triangles(model.triangles.size());
  for (std::size_t c = 0; c < clusters.size(); ++c)
    for (const int t : clusters[c]->triangles) clusters_of_triangles[t] = static_cast<int>(c);
  for (const int c : clusters_of_triangles) put_32_bits(cluster_of, c);
  data["triangles"] = base64(triangles), data["cluster_of"] = base64(cluster_of);
  for (std::size_t c = 0; c < bounds.clips.size(); ++c) {
    const BoundedClip& clip = bounds.clips[c];
    const AnimatedJoints joints(model, model.clips[c].animation, bounds.skinning != Skinning::linear);
    const MovingVertices all(model, sets, bounds.skinning, bounds.parts[0].vertices);
    nlohmann::json of_clip = {{"name", clip.name},
                              {"duration", clip.duration},
                              {"box", numbers(clip.parts[0].box)},
                              {"positions", frames_of(joints, all, clip.parts[0].box)}};
    for (const std::size_t p : positions) of_clip["boxes"].push_back(numbers(clip.parts[p].box));
    if (!clusters.empty()) {
      for (const Sampling sampling : {Sampling::keys, Sampling::fixed_rate}) {
        const SampledMisses misses = misses_of_sampling(model, bounds, c, sampling);
        of_clip[sampling == Sampling::keys ? "keys" : "rate"] = {
            {"clusters", misses.clusters}, {"worst", misses.worst}, {"by", misses.by}, {"time", misses.time}};
      }
      if (const int worst = of_clip["keys"]["worst"]; worst >= 0)
        of_clip["chart"] =
            chart_of(joints, {model, sets, bounds.skinning, clusters[worst]->vertices}, clip.parts[positions[worst]]);
    }
    data["clips"].push_back(of_clip);
  }
  std::string page = report_template;
  const std::string mark = "/*DATA*/";
  // A "<" could end the script.
  std::string json = text_of(data);
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return page.replace(page.find(mark), mark.size(), json);
}

}  // namespace refitlab
