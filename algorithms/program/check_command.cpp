// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <mutex>
#include <ostream>
#include <random>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/program/baked_file.hpp"
#include "algorithms/program/command.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

namespace po = boost::program_options;

struct Tally {
  long vertices = 0, missed = 0, undecided = 0;
  std::string worst;  // of what is missed, what is missed by most
  double by = 0;
};

// How far a vertex is beyond a bound, at most 0 if it is inside.
double beyond(const BoundedPart& part, const Point3& p) {
  double most = norm<double, 3>(p - part.ball.center.cast<double>()) - part.ball.radius;
  for (int i = 0; i < 3; ++i) most = std::max({most, part.box.low[i] - p[i], p[i] - part.box.high[i]});
  return most;
}

// Looks at one cluster in one clip at random times, and where they show a vertex to be nearest to the bound, ever closer to it.
class ClusterCheck {
 public:
  ClusterCheck(const AnimatedJoints& joints, const MovingVertices& vertices, const BoundedPart& bound)
      : joints_(joints),
        vertices_(vertices),
        bound_(bound) {}

  void look(const std::vector<double>& times) {
    std::vector<double> closeness;
    for (const double time : times) closeness.push_back(look_at(time));
    const auto nearest = std::max_element(closeness.begin(), closeness.end()) - closeness.begin();
    const double duration = joints_.times().back();
    double middle = times[nearest], step = duration / static_cast<double>(times.size()), best = closeness[nearest];
    for (int i = 0; i < 20; ++i, step /= 2)
      for (const double time : {middle - step, middle + step})
        if (time >= 0 && time <= duration)
          if (const double close = look_at(time); close > best) best = close, middle = time;
  }

  Tally tally;

 private:
  double look_at(double time) {
    const std::vector<double>& times = joints_.times();
    const auto after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
    const int part = std::clamp(static_cast<int>(after) - 1, 0, joints_.part_count() - 1);
    const double error = vertices_.placing_error(joints_.cell(part, times[part], times[part + 1]));
    vertices_.place(*joints_.at(time, Side::after), Followed::skinned, points_);
    double nearest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double out = beyond(bound_, points_[i]);
      nearest = std::max(nearest, out);
      ++tally.vertices;
      if (out > error) {
        ++tally.missed;
        if (out > tally.by)
          tally.by = out,
          tally.worst = "vertex " + std::to_string(vertices_.vertices()[i]) + " at " + std::to_string(time) + " s";
      } else if (out > -error) {
        ++tally.undecided;
      }
    }
    return nearest;
  }

  const AnimatedJoints& joints_;
  const MovingVertices& vertices_;
  const BoundedPart& bound_;
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

Tally check_clip(const Model& model, const JointSets& sets, const BakedFile& baked, const ClusterBounds::Clip& clip,
                 const Animation& animation, int samples, unsigned seed, const std::string& file) {
  const AnimatedJoints joints(model, animation, baked.skinning != Skinning::linear);
  std::vector<double> times = joints.times();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(0, std::max(clip.duration, 1e-300));
  for (int i = 0; i < samples; ++i) times.push_back(std::min(any(random), joints.times().back()));
  Tally all;
  std::mutex guard;
  parallel_for(baked.clusters.clusters.size(), [&](std::size_t c) {
    const DefaultFloatEnvironment environment;
    const std::vector<int> vertices = vertices_of(model, baked.clusters, baked.clusters.clusters[c], file);
    if (vertices.empty()) return;
    const MovingVertices moving(model, sets, baked.skinning, vertices);
    ClusterCheck check(joints, moving, clip.clusters[c]);
    check.look(times);
    const std::lock_guard lock(guard);
    all.vertices += check.tally.vertices, all.missed += check.tally.missed, all.undecided += check.tally.undecided;
    if (check.tally.by > all.by) all.by = check.tally.by, all.worst = "cluster " + std::to_string(c) + ", " + check.tally.worst;
  });
  return all;
}

int run_check(const std::vector<std::string>& arguments, std::ostream& out, std::ostream&) {
  po::options_description options("options");
  options.add_options()("help", "this text")("samples", po::value<int>()->default_value(1000), "random times a clip")(
      "seed", po::value<unsigned>()->default_value(1), "of the random times");
  const po::variables_map map = parse_arguments(arguments, options, {"FILE.glb"});
  if (map.count("help")) {
    out << "usage: refitlab check [OPTION...] FILE.glb\n\nSkins a baked file's vertices at the keys' times, at random times and "
           "where they\n"
           "come closest to their bounds, and says whether one is outside of its cluster's box or ball. Vertices that are\n"
           "nearer to a bound than skinning in double is exact are counted as undecided.\n\n"
        << options;
    return exit_done;
  }
  if (map["samples"].as<int>() < 1) throw UsageError("--samples takes a number above 0");
  const std::string file = map["FILE.glb"].as<std::string>();
  const BakedFile baked = read_baked(file);
  const Model model =
      load_model(file, {.joints = baked.skinning == Skinning::linear ? Joints::affine : Joints::rigid, .morphs = Morphs::moving});
  if (baked.clusters.clips.size() != model.clips.size() + 1)
    throw ModelError(file, "clips", "there are not as many as were baked");
  const JointSets sets(model);
  const Animation rest;
  long missed = 0;
  for (std::size_t c = 0; c < baked.clusters.clips.size(); ++c) {
    const ClusterBounds::Clip& clip = baked.clusters.clips[c];
    const Animation& animation = c < model.clips.size() ? model.clips[c].animation : rest;
    const Tally tally =
        check_clip(model, sets, baked, clip, animation, map["samples"].as<int>(), map["seed"].as<unsigned>(), file);
    missed += tally.missed;
    out << (c < model.clips.size() ? "clip '" + clip.name + "'" : "rest pose") << ": " << tally.vertices
        << " places of vertices, " << tally.missed << " outside, " << tally.undecided << " undecided";
    if (tally.missed > 0) out << "; farthest: " << tally.worst << ", by " << tally.by;
    out << '\n';
  }
  return missed > 0 ? exit_found : exit_done;
}

}  // namespace

const Command check_command = {"check", "looks for vertices outside of a baked file's bounds", run_check};

}  // namespace refitlab
