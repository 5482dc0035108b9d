// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <ostream>
#include <random>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/crossfaded_joints.hpp"
#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

struct Tally {
  long vertices = 0, missed = 0, undecided = 0;
  std::string worst;  // of what is missed, what is missed by most
  double by = 0;
};

// Returns how far a vertex is beyond a bound. It is at most 0 if the vertex is inside.
double beyond(const BoundedPart& part, const Point3& p) {
  double most = norm<double, 3>(p - part.ball.center.cast<double>()) - part.ball.radius;
  for (int i = 0; i < 3; ++i) most = std::max({most, part.box.low[i] - p[i], p[i] - part.box.high[i]});
  const auto directions = slab_directions(static_cast<int>(2 * part.slabs.size() + 6)).subspan(3);
  for (std::size_t k = 0; k < part.slabs.size(); ++k) {
    const SlabDirection& d = directions[k];
    const double along = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
    most = std::max(most, std::max(part.slabs[k].low - along, along - part.slabs[k].high) / length_bound(d));
  }
  return most;
}

// A PartCheck looks at one cluster or node at some moments. Near the moments at which a vertex is nearest to the bound, it looks
// ever closer.
class PartCheck {
 public:
  PartCheck(const MovingJoints& joints, const MovingVertices& vertices, const BoundedPart& bound)
      : joints_(joints),
        vertices_(vertices),
        bound_(bound) {
    for (const ParameterBox& box : joints.boxes()) error_ = std::max(error_, vertices.placing_error(joints.cell(box)));
  }

  // ranges are by parameter.
  void look(const std::vector<ParameterMoment>& moments, const std::vector<std::pair<double, double>>& ranges) {
    std::vector<double> closeness;
    for (const ParameterMoment& moment : moments) closeness.push_back(look_at(moment));
    const auto nearest = std::max_element(closeness.begin(), closeness.end()) - closeness.begin();
    ParameterMoment best = moments[nearest];
    double most = closeness[nearest],
           step = 1 / std::pow(static_cast<double>(moments.size()), 1.0 / static_cast<double>(ranges.size()));
    for (int i = 0; i < 20; ++i, step /= 2)
      for (std::size_t k = 0; k < ranges.size(); ++k)
        for (const double sign : {-1.0, 1.0}) {
          ParameterMoment moment = best;
          double& value = moment.coordinates[k].value;
          value += sign * step * (ranges[k].second - ranges[k].first);
          if (value < ranges[k].first || value > ranges[k].second) continue;
          if (const double close = look_at(moment); close > most) most = close, best = moment;
        }
  }

  Tally tally;

 private:
  double look_at(const ParameterMoment& moment) {
    vertices_.place(*joints_.at(moment), Followed::skinned, points_);
    double nearest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double out = beyond(bound_, points_[i]);
      nearest = std::max(nearest, out);
      ++tally.vertices;
      if (out > error_) {
        ++tally.missed;
        if (out > tally.by) {
          tally.by = out;
          tally.worst =
              "vertex " + std::to_string(vertices_.vertices()[i]) + " at " + std::to_string(moment.coordinates[0].value) + " s";
          if (moment.coordinates.size() == 3)
            tally.worst += " and " + std::to_string(moment.coordinates[1].value) + " s, weight " +
                           std::to_string(moment.coordinates[2].value);
        }
      } else if (out > -error_) {
        ++tally.undecided;
      }
    }
    return nearest;
  }

  const MovingJoints& joints_;
  const MovingVertices& vertices_;
  const BoundedPart& bound_;
  double error_ = 0;
  std::vector<Point3> points_;
};

std::vector<int> vertices_of(const Model& model, const ClusterBounds& bounds, const ClusterBounds::Cluster& cluster,
                             const std::string& file) {
  const auto fail = [&] { throw ModelError(file, "clusters", "they are not of this file's triangles"); };
  std::vector<int> vertices;
  for (const int t : cluster.triangles) {
    int of_model = t;
    if (!model.sources.empty()) {
      const ClusterBounds::Primitive& p = bounds.primitives[cluster.primitive];
      const auto source = std::find_if(model.sources.begin(), model.sources.end(), [&](const SourcePrimitive& s) {
        return s.node == p.node && s.mesh == p.mesh && s.primitive == p.primitive;
      });
      if (source == model.sources.end() || t >= static_cast<int>(source->triangles.size())) fail();
      of_model = source->triangles[t];
    }
    if (of_model < 0 || of_model >= static_cast<int>(model.triangles.size())) fail();
    vertices.insert(vertices.end(), model.triangles[of_model].begin(), model.triangles[of_model].end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// CheckedParts are the parts of which a file has bounds, with the vertices of each.
struct CheckedParts {
  std::string kind;
  std::vector<std::vector<int>> vertices;
};

CheckedParts clusters_of(const Model& model, const ClusterBounds& bounds, const std::string& file) {
  CheckedParts out{"cluster", {}};
  for (const ClusterBounds::Cluster& cluster : bounds.clusters) out.vertices.push_back(vertices_of(model, bounds, cluster, file));
  return out;
}

// Returns the nodes, or none for a file that has no bounds of nodes.
CheckedParts nodes_of(const Model& model, const BakedFile& baked, const std::string& file) {
  CheckedParts out{"node", {}};
  const std::size_t count = baked.clusters.clips[0].nodes.size();
  if (count > 0 && baked.character->mesh.vertices.size() != model.vertices.size())
    throw ModelError(file, "nodes", "they are not of this file's vertices");
  for (std::size_t n = 0; n < count; ++n) {
    const auto vertices = baked.character->vertices[static_cast<int>(n)];
    out.vertices.emplace_back(vertices.begin(), vertices.end());
  }
  return out;
}

// Checks all parts at these moments, and at as many random ones as there are samples.
Tally check_parts(const Model& model, const JointSets& sets, Skinning skinning, const MovingJoints& joints,
                  const CheckedParts& parts, const std::vector<BoundedPart>& bounds, std::vector<ParameterMoment> moments,
                  int samples, unsigned seed) {
  const std::vector<ParameterBox> boxes = joints.boxes();
  std::vector<std::pair<double, double>> ranges;
  for (std::size_t k = 0; k < boxes[0].ranges.size(); ++k)
    ranges.emplace_back(boxes.front().ranges[k].start, boxes.back().ranges[k].end);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < samples; ++i) {
    ParameterMoment moment;
    for (const auto& [start, end] : ranges)
      moment.coordinates.push_back({std::min(start + share(random) * (end - start), end), Side::after});
    moments.push_back(std::move(moment));
  }
  Tally all;
  std::mutex guard;
  parallel_for(parts.vertices.size(), [&](std::size_t p) {
    const DefaultFloatEnvironment environment;
    if (parts.vertices[p].empty()) return;
    const MovingVertices moving(model, sets, skinning, parts.vertices[p]);
    PartCheck check(joints, moving, bounds[p]);
    check.look(moments, ranges);
    const std::lock_guard lock(guard);
    all.vertices += check.tally.vertices, all.missed += check.tally.missed, all.undecided += check.tally.undecided;
    if (check.tally.by > all.by)
      all.by = check.tally.by, all.worst = parts.kind + " " + std::to_string(p) + ", " + check.tally.worst;
  });
  return all;
}

// Returns the times of an animation's keys.
std::vector<ParameterMoment> moments_of_keys(const AnimatedJoints& joints) {
  std::vector<ParameterMoment> out;
  for (const double time : joints.times()) out.push_back({{{time, Side::after}}});
  return out;
}

// So many moments take about a gigabyte.
constexpr int most_samples = 10'000'000;

// An option that is unsigned would take a number below 0 for a great one.
unsigned seed_of(const po::variables_map& map) {
  const auto seed = map["seed"].as<std::int64_t>();
  if (seed < 0 || seed > std::numeric_limits<unsigned>::max()) throw UsageError("--seed takes a number from 0 to 4294967295");
  return static_cast<unsigned>(seed);
}

int run_check(const std::vector<std::string>& arguments, std::ostream& out, std::ostream&) {
  po::options_description options("options");
  options.add_options()("help", "this text")("samples", po::value<int>()->default_value(1000),
                                             "random times a clip, and moments a crossfade")(
      "seed", po::value<std::int64_t>()->default_value(1), "of the random times");
  const po::variables_map map = parse_arguments(arguments, options, {"FILE.glb"});
  if (map.count("help")) {
    out << "usage: refitlab check [OPTION...] FILE.glb\n\nSkins a baked file's vertices at the keys' times, at random times and "
           "where they\n"
           "come closest to their bounds, and says whether one is outside of its cluster's or node's bounds. Vertices that are\n"
           "nearer to a bound than skinning in double is exact are counted as undecided.\n\n"
        << options;
    return exit_done;
  }
  if (const int n = map["samples"].as<int>(); n < 1 || n > most_samples)
    throw UsageError("--samples takes a number from 1 to " + std::to_string(most_samples));
  const unsigned seed = seed_of(map);
  const std::string file = map["FILE.glb"].as<std::string>();
  const BakedFile baked = read_baked(file);
  const Model model =
      load_model(file, {.joints = baked.skinning == Skinning::linear ? Joints::affine : Joints::rigid, .morphs = Morphs::moving});
  if (baked.clusters.clips.size() != model.clips.size() + 1)
    throw ModelError(file, "clips", "there are not as many as were baked");
  const JointSets sets(model);
  const CheckedParts clusters = clusters_of(model, baked.clusters, file), nodes = nodes_of(model, baked, file);
  if (clusters.vertices.empty() && nodes.vertices.empty())
    throw ModelError(file, "clusters", "it has no bounds of them or of nodes, which are what is checked");
  const int samples = map["samples"].as<int>();
  const bool needs_pose = baked.skinning != Skinning::linear;
  long missed = 0;
  const auto report = [&](const std::string& what, const Tally& tally) {
    missed += tally.missed;
    out << printable(what) << ": " << tally.vertices << " places of vertices, " << tally.missed << " outside, " << tally.undecided
        << " undecided";
    if (tally.missed > 0) out << "; farthest: " << tally.worst << ", by " << tally.by;
    out << '\n';
  };
  const Animation rest;
  for (std::size_t c = 0; c < baked.clusters.clips.size(); ++c) {
    const ClusterBounds::Clip& clip = baked.clusters.clips[c];
    const AnimatedJoints joints(model, c < model.clips.size() ? model.clips[c].animation : rest, needs_pose);
    const std::vector<ParameterMoment> keys = moments_of_keys(joints);
    report(joints.name(), check_parts(model, sets, baked.skinning, joints, clusters, clip.clusters, keys, samples, seed));
    if (!nodes.vertices.empty())
      report(joints.name() + ", nodes of the tree",
             check_parts(model, sets, baked.skinning, joints, nodes, clip.nodes, keys, samples, seed));
  }
  const std::vector<int> all = indices_below(model.joints.size());
  for (const ClusterBounds::Crossfade& fade : baked.clusters.crossfades) {
    const Clip &first = model.clips[fade.first], &second = model.clips[fade.second];
    const CrossfadedJoints joints(model, first.animation, second.animation, all, baked.rotations, needs_pose);
    report(joints.name(), check_parts(model, sets, baked.skinning, joints, clusters, fade.clusters, {}, samples, seed));
  }
  return missed > 0 ? exit_found : exit_done;
}

}  // namespace

const Command check_command = {"check", "looks for vertices outside of a baked file's bounds", run_check};

}  // namespace refitlab
