// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/cluster_bounds.hpp"

#include <cmath>

#include "algorithms/runtime/tree/binary.hpp"

namespace refitlab {
namespace {

constexpr std::string_view clusters_magic = "rfltimes";
constexpr std::uint32_t clusters_version = 3;

// Returns the number of slabs besides the box. It is 0 for an unknown k, which is refused later.
std::size_t slab_count(const ClusterBounds& bounds) { return is_dop_size(bounds.dop) ? bounds.dop / 2 - 3 : 0; }

// These transfer the fields of everything in a file, for writing or for reading.
template <class Bounds>
void transfer_clusters(auto& io, Bounds& bounds) {
  const auto number = [&](auto& x) { io.number(x); };
  number(bounds.dop);
  transfer_members(io, bounds.primitives, [&](auto& p) { number(p.node), number(p.mesh), number(p.primitive), number(p.skin); });
  transfer_members(io, bounds.clusters, [&](auto& c) { number(c.primitive), transfer_members(io, c.triangles, number); });
  const auto part_bounds = [&](auto& part) {
    for (auto* point : {&part.box.low, &part.box.high, &part.ball.center})
      for (int i = 0; i < 3; ++i) number((*point)[i]);
    number(part.ball.radius);
    if constexpr (!std::is_const_v<Bounds>) part.slabs.resize(slab_count(bounds));
    for (auto& slab : part.slabs) number(slab.low), number(slab.high);
  };
  transfer_members(io, bounds.clips, [&](auto& clip) {
    transfer_members(io, clip.name, number);
    number(clip.duration);
    transfer_members(io, clip.clusters, part_bounds);
    transfer_members(io, clip.nodes, part_bounds);
  });
  transfer_members(io, bounds.crossfades, [&](auto& fade) {
    number(fade.first), number(fade.second);
    transfer_members(io, fade.clusters, part_bounds);
  });
}

void check(const std::vector<BoundedPart>& parts, const char* kind, std::size_t count, const std::string& file,
           const std::string& thing) {
  if (parts.size() != count) throw ModelError(file, thing, std::string("it does not have a bound for each ") + kind);
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (!is_sound(parts[p])) throw ModelError(file, thing + ", " + kind + " " + std::to_string(p), "its bound is none");
}

}  // namespace

bool is_sound(const BoundedPart& part) {
  for (int i = 0; i < 3; ++i)
    if (!(std::isfinite(part.box.low[i]) && std::isfinite(part.box.high[i]) && std::isfinite(part.ball.center[i]) &&
          part.box.low[i] <= part.box.high[i]))
      return false;
  for (const Slab<float>& slab : part.slabs)
    if (!(std::isfinite(slab.low) && std::isfinite(slab.high) && slab.low <= slab.high)) return false;
  return part.ball.radius >= 0 && std::isfinite(part.ball.radius);
}

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
  if (!is_dop_size(out.dop)) throw ModelError(file, "k-DOPs", "there are none of " + std::to_string(out.dop) + " planes");
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
    check(clip.clusters, "cluster", out.clusters.size(), file, thing);
    check(clip.nodes, "node", out.clips[0].nodes.size(), file, thing);
  }
  const int clips = static_cast<int>(out.clips.size()) - 1;
  for (const ClusterBounds::Crossfade& fade : out.crossfades) {
    if (fade.first < 0 || fade.first >= clips || fade.second < 0 || fade.second >= clips)
      throw ModelError(file, "crossfades", "a clip is out of range");
    check(fade.clusters, "cluster", out.clusters.size(), file,
          "crossfade of '" + out.clips[fade.first].name + "' and '" + out.clips[fade.second].name + "'");
  }
  return out;
}

}  // namespace refitlab
