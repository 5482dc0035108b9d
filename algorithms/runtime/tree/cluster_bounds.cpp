// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/cluster_bounds.hpp"

#include <cmath>

#include "algorithms/runtime/tree/binary.hpp"

namespace refitlab {
namespace {

constexpr std::string_view clusters_magic = "rfltimes";
constexpr std::uint32_t clusters_version = 2;

// The fields of all that is in a file, once for writing and once for reading.
void transfer_members(auto& io, auto& list, const auto& transfer_member) {
  std::uint64_t count = list.size();
  io.number(count);
  if constexpr (requires { io.checked_count(count); }) list.resize(io.checked_count(count));
  for (auto& member : list) transfer_member(member);
}

void transfer_clusters(auto& io, auto& bounds) {
  const auto number = [&](auto& x) { io.number(x); };
  transfer_members(io, bounds.primitives, [&](auto& p) { number(p.node), number(p.mesh), number(p.primitive), number(p.skin); });
  transfer_members(io, bounds.clusters, [&](auto& c) { number(c.primitive), transfer_members(io, c.triangles, number); });
  const auto part_bounds = [&](auto& part) {
    for (auto* point : {&part.box.low, &part.box.high, &part.ball.center})
      for (int i = 0; i < 3; ++i) number((*point)[i]);
    number(part.ball.radius);
  };
  transfer_members(io, bounds.clips, [&](auto& clip) {
    transfer_members(io, clip.name, number);
    number(clip.duration);
    transfer_members(io, clip.clusters, part_bounds);
  });
  transfer_members(io, bounds.crossfades, [&](auto& fade) {
    number(fade.first), number(fade.second);
    transfer_members(io, fade.clusters, part_bounds);
  });
}

bool is_sound(const BoundedPart& part) {
  for (int i = 0; i < 3; ++i)
    if (!(std::isfinite(part.box.low[i]) && std::isfinite(part.box.high[i]) && std::isfinite(part.ball.center[i]) &&
          part.box.low[i] <= part.box.high[i]))
      return false;
  return part.ball.radius >= 0 && std::isfinite(part.ball.radius);
}

void check(const std::vector<BoundedPart>& parts, std::size_t clusters, const std::string& file, const std::string& thing) {
  if (parts.size() != clusters) throw ModelError(file, thing, "it does not have a bound for each cluster");
  for (std::size_t c = 0; c < parts.size(); ++c)
    if (!is_sound(parts[c])) throw ModelError(file, thing + ", cluster " + std::to_string(c), "its bound is none");
}

}  // namespace

std::string bytes_of(const ClusterBounds& bounds) {
  BinaryWriter body;
  transfer_clusters(body, bounds);
  return sealed(clusters_magic, clusters_version, body.bytes);
}

ClusterBounds cluster_bounds_of(std::string_view bytes, const std::string& file) {
  BinaryReader in = opened(bytes, clusters_magic, clusters_version, "list of clusters", file);
  ClusterBounds out;
  transfer_clusters(in, out);
  in.end();
  for (std::size_t c = 0; c < out.clusters.size(); ++c) {
    const std::string thing = "cluster " + std::to_string(c);
    if (out.clusters[c].primitive < 0 || out.clusters[c].primitive >= static_cast<int>(out.primitives.size()))
      throw ModelError(file, thing, "its primitive is out of range");
    for (const int t : out.clusters[c].triangles)
      if (t < 0) throw ModelError(file, thing, "a triangle is out of range");
  }
  if (out.clips.empty()) throw ModelError(file, "clips", "the rest pose is missing");
  for (const ClusterBounds::Clip& clip : out.clips) {
    const std::string thing = "clip '" + clip.name + "'";
    if (!(clip.duration >= 0 && std::isfinite(clip.duration))) throw ModelError(file, thing, "its duration is not a time");
    check(clip.clusters, out.clusters.size(), file, thing);
  }
  const int clips = static_cast<int>(out.clips.size()) - 1;
  for (const ClusterBounds::Crossfade& fade : out.crossfades) {
    if (fade.first < 0 || fade.first >= clips || fade.second < 0 || fade.second >= clips)
      throw ModelError(file, "crossfades", "a clip is out of range");
    check(fade.clusters, out.clusters.size(), file,
          "crossfade of '" + out.clips[fade.first].name + "' and '" + out.clips[fade.second].name + "'");
  }
  return out;
}

}  // namespace refitlab
