// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/model_bounds.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr int most_meshlet_vertices = 255, most_meshlet_triangles = 512;

// This is for one part. Most parts need fewer halvings; where both clips' rotations come half a turn apart, no number makes the
// bound tight.
constexpr std::size_t most_halvings_of_crossfade = 4096;

std::vector<int> in_order(std::vector<int> vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<int> vertices_of(const Model& model, std::span<const int> triangles) {
  std::vector<int> vertices;
  for (const int t : triangles) vertices.insert(vertices.end(), model.triangles[t].begin(), model.triangles[t].end());
  return in_order(std::move(vertices));
}

// Returns the triangles as meshlets, each of which is a list of triangles.
std::vector<std::vector<int>> meshlets(const Model& model, const std::vector<int>& triangles, int most_triangles) {
  std::vector<unsigned> indices;
  std::map<Triangle, std::vector<int>> triangle_of;  // meshlets name vertices, whose triangles may be there twice
  for (const int t : triangles) {
    indices.insert(indices.end(), model.triangles[t].begin(), model.triangles[t].end());
    Triangle key = model.triangles[t];
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    triangle_of[key].push_back(t);
  }
  // The positions are seen at a size of 1, where floats neither overflow nor underflow when they are squared.
  double size = 0;
  for (const unsigned v : indices) size = std::max(size, model.vertices[v].cwiseAbs().maxCoeff());
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  std::vector<float> positions(3 * model.vertices.size(), 0);
  for (const unsigned v : indices)
    for (unsigned i = 0; i < 3; ++i) positions[3 * v + i] = static_cast<float>(std::ldexp(model.vertices[v][i], -exponent));
  const auto triangle_limit = static_cast<std::size_t>(most_triangles);
  std::vector<meshopt_Meshlet> found(meshopt_buildMeshletsBound(indices.size(), most_meshlet_vertices, triangle_limit));
  std::vector<unsigned> vertices(found.size() * most_meshlet_vertices);
  std::vector<unsigned char> local_vertices(found.size() * triangle_limit * 3);
  found.resize(meshopt_buildMeshlets(found.data(), vertices.data(), local_vertices.data(), indices.data(), indices.size(),
                                     positions.data(), model.vertices.size(), 3 * sizeof(float), most_meshlet_vertices,
                                     triangle_limit, 0));
  std::vector<std::vector<int>> out;
  for (const meshopt_Meshlet& meshlet : found) {
    auto& list = out.emplace_back();
    for (unsigned t = 0; t < meshlet.triangle_count; ++t) {
      Triangle key;
      for (int k = 0; k < 3; ++k)
        key[k] = static_cast<int>(vertices[meshlet.vertex_offset + local_vertices[meshlet.triangle_offset + 3 * t + k]]);
      std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
      auto& left = triangle_of.at(key);
      list.push_back(left.back());
      left.pop_back();
    }
    std::sort(list.begin(), list.end());
  }
  return out;
}

// Parts and nodes with the same vertices have the same bounds. Returns the first of them for each.
std::vector<std::size_t> firsts_of(const std::vector<const std::vector<int>*>& vertices) {
  const auto less = [](const std::vector<int>* a, const std::vector<int>* b) { return *a < *b; };
  std::map<const std::vector<int>*, std::size_t, decltype(less)> known(less);
  std::vector<std::size_t> first;
  for (std::size_t p = 0; p < vertices.size(); ++p) first.push_back(known.try_emplace(vertices[p], p).first->second);
  return first;
}

std::vector<Point3> directions_of_dop(int dop) {
  std::vector<Point3> out;
  for (const SlabDirection& d : slab_directions(dop)) out.emplace_back(d[0], d[1], d[2]);
  return out;
}

// Widens a bound by what renderers lose, and by what a vertex is off because its weights are multiples of 2^-24 (quantize.hpp),
// each of them off by less than that, and those that are rounded to 0 by themselves. Throws ModelError, with this thing of the
// file, if floats do not hold the bound.
BoundedPart outward(const BoundOverTime& bound, int joints, double renderer_rounding, const std::string& file,
                    const std::string& thing) {
  Box<double> box = box_of(bound.slabs);
  const double farthest = box.greatest_coordinate();
  const double more = renderer_rounding * bound.errors.per_rounding +
                      std::ldexp(joints > 1 ? joints : 0, -weight_bits) * bound.errors.per_weight +
                      bound.errors.of_lost_influences;
  box.grow(more);
  BoundedPart out = {rounded_outward(box), rounded_outward(Ball3<double>{bound.ball.center, bound.ball.radius + more})};
  const auto directions = slab_directions(static_cast<int>(2 * bound.slabs.size()));
  for (std::size_t d = 3; d < directions.size(); ++d) {
    // Three terms are summed up, and rounded.
    const double wider = (more + 0x1p-50 * farthest) * length_bound(directions[d]);
    out.slabs.push_back({float_below(bound.slabs[d].low - wider), float_above(bound.slabs[d].high + wider)});
  }
  if (!is_sound(out)) throw ModelError(file, thing, "its vertices go beyond the range of float");
  return out;
}

// Throws ModelError if what is around bounds of several clips, or in any pose, goes beyond the range of float.
void check_range(const Model& model, const ModelBounds& bounds) {
  bool is_in_range = true;
  for (const BoundedPart& part : bounds_of_all(bounds)) is_in_range = is_in_range && is_sound(part);
  for (const auto& any : bounds.any_pose) is_in_range = is_in_range && (!any || any->radius <= std::numeric_limits<float>::max());
  if (!is_in_range) throw ModelError(model.name, "all clips together", "its vertices go beyond the range of float");
}

// Returns whether the part has all triangles of the cluster.
bool has(const Model& model, const ModelPart& part, const ModelPart& cluster) {
  switch (part.kind) {
    case PartKind::whole: return true;
    case PartKind::skin: return model.sources[cluster.index].skin == part.index;
    case PartKind::mesh: return model.sources[cluster.index].mesh == part.index;
    case PartKind::primitive: return part.index == cluster.index;
    case PartKind::cluster: break;
  }
  return false;
}

class ProgressCount {
 public:
  ProgressCount(std::size_t total, const std::function<void(double)>& tell) : total_(total), tell_(tell) {}
  void add(std::size_t done) {
    if (!tell_) return;
    const std::lock_guard lock(guard_);
    tell_(static_cast<double>(done_ += done) / static_cast<double>(total_));
  }

 private:
  std::size_t total_, done_ = 0;
  const std::function<void(double)>& tell_;
  std::mutex guard_;
};

}  // namespace

const char* name_of(PartKind kind) {
  switch (kind) {
    case PartKind::whole: return "whole";
    case PartKind::skin: return "skin";
    case PartKind::mesh: return "mesh";
    case PartKind::primitive: return "primitive";
    case PartKind::cluster: break;
  }
  return "cluster";
}

std::vector<ModelPart> parts_of(const Model& model, int cluster_triangles) {
  const DefaultFloatEnvironment environment;
  if (cluster_triangles != 0 &&
      (cluster_triangles < 4 || cluster_triangles > most_meshlet_triangles || cluster_triangles % 4 != 0))
    throw std::invalid_argument("parts_of: clusters have a multiple of 4 triangles, from 4 to 512");
  std::vector<ModelPart> parts = {{PartKind::whole, -1, indices_below(model.vertices.size()), {}}}, primitives, clusters;
  std::map<std::pair<PartKind, int>, std::vector<int>> joined;  // vertices of skins and meshes
  const auto add = [&](int source, const std::vector<int>& triangles) {
    if (triangles.empty()) return;
    primitives.push_back({PartKind::primitive, source, vertices_of(model, triangles), {}});
    if (source >= 0) {
      const SourcePrimitive& from = model.sources[source];
      for (const auto& key : {std::pair{PartKind::skin, from.skin}, {PartKind::mesh, from.mesh}})
        if (key.second >= 0) {
          auto& list = joined[key];
          list.insert(list.end(), primitives.back().vertices.begin(), primitives.back().vertices.end());
        }
    }
    if (cluster_triangles != 0)
      for (auto& list : meshlets(model, triangles, cluster_triangles))
        clusters.push_back({PartKind::cluster, source, vertices_of(model, list), list});
  };
  for (std::size_t s = 0; s < model.sources.size(); ++s) {
    std::vector<int> triangles;
    for (const int t : model.sources[s].triangles)
      if (t >= 0) triangles.push_back(t);
    add(static_cast<int>(s), triangles);
  }
  if (model.sources.empty()) {
    const std::vector<int> triangles = indices_below(model.triangles.size());
    add(-1, triangles);
  }
  for (auto& [key, vertices] : joined) parts.push_back({key.first, key.second, in_order(std::move(vertices)), {}});
  for (auto* more : {&primitives, &clusters}) std::move(more->begin(), more->end(), std::back_inserter(parts));
  return parts;
}

ModelBounds bound_model(const Model& model, const ModelBoundsOptions& options) {
  const DefaultFloatEnvironment environment;
  if (!is_dop_size(options.dop)) throw std::invalid_argument("bound_model: there are k-DOPs of 6, 14, 18 and 26 planes");
  const JointSets sets(model);
  ModelBounds out{.skinning = options.skinning,
                  .parts = parts_of(model, options.cluster_triangles),
                  .rotations = options.rotations,
                  .dop = options.dop};
  const std::vector<Point3> directions = directions_of_dop(options.dop);
  const Animation none;
  std::deque<AnimatedJoints> clips;  // the last one rests
  const bool needs_pose = options.skinning != Skinning::linear;
  for (const Clip& clip : model.clips) clips.emplace_back(model, clip.animation, needs_pose);
  clips.emplace_back(model, none, needs_pose);

  std::vector<const std::vector<int>*> vertices_of_thing;  // parts, then nodes
  for (const ModelPart& part : out.parts) vertices_of_thing.push_back(&part.vertices);
  for (const std::vector<int>& node : options.nodes) vertices_of_thing.push_back(&node);
  const std::size_t things = vertices_of_thing.size();
  const std::vector<std::size_t> first = firsts_of(vertices_of_thing);
  struct Task {
    std::size_t clip, thing, cost;
  };
  std::vector<Task> tasks;
  std::size_t cost = 0;
  for (std::size_t i = 0; i < things; ++i)
    for (std::size_t c = 0; first[i] == i && c < clips.size(); ++c) {
      tasks.push_back({c, i, vertices_of_thing[i]->size() * clips[c].times().size()});
      cost += tasks.back().cost;
    }
  // The largest tasks come first, so that no processor is left with one at the end.
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.cost > b.cost; });

  std::vector<std::size_t> looked_at;  // in crossfades: clusters, or what has the same vertices
  for (std::size_t p = 0; p < out.parts.size(); ++p)
    if (options.cluster_triangles == 0 || out.parts[p].kind == PartKind::cluster) looked_at.push_back(first[p]);
  std::sort(looked_at.begin(), looked_at.end());
  looked_at.erase(std::unique(looked_at.begin(), looked_at.end()), looked_at.end());
  // A part costs some hundred times as much in a crossfade as in a clip.
  const std::size_t fades = options.crossfades ? model.clips.size() * (model.clips.size() - 1) / 2 : 0,
                    cost_of_fade = 100 * cost / std::max<std::size_t>(1, tasks.size());
  ProgressCount progress(cost + fades * looked_at.size() * cost_of_fade, options.progress);
  std::vector<std::vector<BoundedPart>> bounded(clips.size(), std::vector<BoundedPart>(things));
  std::vector<std::vector<PartIntervals>> intervals(clips.size());
  if (options.with_intervals) intervals.assign(clips.size(), std::vector<PartIntervals>(things));
  std::atomic<long> moments = 0;
  const auto bound_of = [&](std::span<const MovingJoints* const> joints, const MovingVertices& vertices,
                            const OverTimeOptions& how, PartIntervals* kept) {
    BoundOverTime bound = bound_over_time(joints, vertices, how);
    moments += bound.moments;
    if (kept) *kept = {std::move(bound.slab_intervals), std::move(bound.ball_intervals)};
    return outward(bound, vertices.most_joints(), options.renderer_rounding, model.name, joints.back()->name());
  };
  const auto share_among_same = [&](auto& parts) {
    for (std::size_t p = 0; p < parts.size(); ++p) parts[p] = parts[first[p]];
  };
  parallel_for(tasks.size(), [&](std::size_t t) {
    const DefaultFloatEnvironment own_environment;
    const Task& task = tasks[t];
    const MovingJoints* const joints[] = {&clips[task.clip]};
    PartIntervals* const kept = options.with_intervals ? &intervals[task.clip][task.thing] : nullptr;
    bounded[task.clip][task.thing] = bound_of(joints, {model, sets, options.skinning, *vertices_of_thing[task.thing]},
                                              {.tolerance = options.tolerance, .directions = directions}, kept);
    progress.add(task.cost);
  });
  for (auto& parts : bounded) share_among_same(parts);
  for (auto& parts : intervals) share_among_same(parts);
  for (int a = 0; fades > 0 && a < static_cast<int>(model.clips.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(model.clips.size()); ++b) {
      BoundedCrossfade& bounds = out.crossfades.emplace_back(BoundedCrossfade{a, b, std::vector<BoundedPart>(out.parts.size())});
      parallel_for(looked_at.size(), [&](std::size_t i) {
        const DefaultFloatEnvironment own_environment;
        const std::size_t p = looked_at[i];
        const MovingVertices vertices(model, sets, options.skinning, out.parts[p].vertices);
        const CrossfadedJoints fade(model, model.clips[a].animation, model.clips[b].animation, vertices.joints(),
                                    options.rotations, needs_pose);
        const MovingJoints* const joints[] = {&clips[a], &clips[b], &fade};
        bounds.parts[p] = bound_of(
            joints, vertices,
            {.tolerance = options.crossfade_tolerance, .directions = directions, .most_halvings = most_halvings_of_crossfade},
            nullptr);
        progress.add(cost_of_fade);
      });
      share_among_same(bounds.parts);
      // A part that consists of clusters gets the bound around theirs, because they are looked at more closely than it would be.
      for (std::size_t p = 0; options.cluster_triangles != 0 && p < out.parts.size(); ++p) {
        if (out.parts[p].kind == PartKind::cluster) continue;
        std::vector<BoundedPart> within;
        for (std::size_t c = 0; c < out.parts.size(); ++c)
          if (out.parts[c].kind == PartKind::cluster && has(model, out.parts[p], out.parts[c])) within.push_back(bounds.parts[c]);
        bounds.parts[p] = around(within);
      }
    }
  const auto without_nodes = [&](std::vector<BoundedPart>& bounds) {
    const auto nodes = bounds.begin() + static_cast<std::ptrdiff_t>(out.parts.size());
    std::vector<BoundedPart> taken(std::make_move_iterator(nodes), std::make_move_iterator(bounds.end()));
    bounds.erase(nodes, bounds.end());
    return taken;
  };
  for (std::size_t c = 0; c < model.clips.size(); ++c) {
    if (options.with_intervals) intervals[c].resize(out.parts.size());
    std::vector<BoundedPart> nodes = without_nodes(bounded[c]);
    out.clips.push_back(
        {model.clips[c].name, model.clips[c].duration, std::move(bounded[c]), std::move(intervals[c]), std::move(nodes)});
  }
  out.rest_nodes = without_nodes(bounded.back());
  out.rest = std::move(bounded.back());
  out.moments = moments;
  if (options.any_pose)
    for (const ModelPart& part : out.parts)
      if (part.kind != PartKind::cluster)
        out.any_pose.push_back(bound_any_pose(model, sets, part.vertices, options.skinning, options.renderer_rounding));
  check_range(model, out);
  return out;
}

BoundedPart around(std::span<const BoundedPart> parts) {
  const DefaultFloatEnvironment environment;
  BoundedPart out = parts[0];
  std::vector<Ball3<double>> balls;
  for (const BoundedPart& part : parts) {
    out.box.merge(part.box);
    for (std::size_t d = 0; d < out.slabs.size(); ++d)
      out.slabs[d] = {std::min(out.slabs[d].low, part.slabs[d].low), std::max(out.slabs[d].high, part.slabs[d].high)};
    balls.push_back({part.ball.center.cast<double>(), part.ball.radius});
  }
  if (parts.size() > 1) out.ball = rounded_outward(smallest_ball_of_balls(balls));
  return out;
}

std::vector<BoundedPart> bounds_of_all(const ModelBounds& bounds) {
  const DefaultFloatEnvironment environment;
  std::vector<BoundedPart> out;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    std::vector<BoundedPart> of_clips = {bounds.rest[p]};
    for (const BoundedClip& clip : bounds.clips) of_clips.push_back(clip.parts[p]);
    for (const BoundedCrossfade& fade : bounds.crossfades) of_clips.push_back(fade.parts[p]);
    out.push_back(around(of_clips));
  }
  return out;
}

ClusterBounds clusters_of(const Model& model, const ModelBounds& bounds) {
  ClusterBounds out{.dop = bounds.dop};
  std::vector<int> in_source = indices_below(model.triangles.size());  // by triangle of the model; its own without sources
  for (const SourcePrimitive& s : model.sources) out.primitives.push_back({s.node, s.mesh, s.primitive, s.skin});
  if (model.sources.empty()) out.primitives.push_back({-1, -1, -1, -1});
  std::vector<std::size_t> parts;
  int current = -2;
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    const ModelPart& part = bounds.parts[p];
    if (part.kind != PartKind::cluster) continue;
    if (part.index != current && part.index >= 0) {
      const std::vector<int>& triangles = model.sources[part.index].triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t)
        if (triangles[t] >= 0) in_source[triangles[t]] = static_cast<int>(t);
    }
    current = part.index;
    ClusterBounds::Cluster cluster{std::max(part.index, 0), {}};
    for (const int t : part.triangles) cluster.triangles.push_back(in_source[t]);
    out.clusters.push_back(std::move(cluster));
    parts.push_back(p);
  }
  const auto add = [&](const std::string& name, double duration, const std::vector<BoundedPart>& of_parts,
                       const std::vector<BoundedPart>& of_nodes) {
    ClusterBounds::Clip clip{name, duration, {}, of_nodes};
    for (const std::size_t p : parts) clip.clusters.push_back(of_parts[p]);
    out.clips.push_back(std::move(clip));
  };
  for (const BoundedClip& clip : bounds.clips) add(clip.name, clip.duration, clip.parts, clip.nodes);
  add("", 0, bounds.rest, bounds.rest_nodes);
  for (const BoundedCrossfade& fade : bounds.crossfades) {
    ClusterBounds::Crossfade crossfade{fade.first, fade.second, {}};
    for (const std::size_t p : parts) crossfade.clusters.push_back(fade.parts[p]);
    out.crossfades.push_back(std::move(crossfade));
  }
  return out;
}

}  // namespace refitlab
