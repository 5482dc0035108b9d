// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bounds of all parts of a model: which parts there are, and that the bounds of all clips enclose those of each.
#include "algorithms/bake/over_time/model_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/half_turns.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/model/model_of_scene.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/model_of_nodes.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"
#include "proptests/oracles/reweighted_vertex.hpp"

namespace proptests::suite_model_bounds {
namespace {

using namespace refitlab;

const Model& man() {
  static const Model model = keyed(make_man(1500), 10);
  return model;
}

const ModelBounds& bounds() {
  static const ModelBounds made = bound_model(man(), {.cluster_triangles = 128});
  return made;
}

bool encloses(const BoundedPart& outer, const BoundedPart& inner) {
  const double apart = (outer.ball.center.cast<double>() - inner.ball.center.cast<double>()).norm();
  return (outer.box.low.array() <= inner.box.low.array()).all() && (outer.box.high.array() >= inner.box.high.array()).all() &&
         apart + inner.ball.radius <= outer.ball.radius * (1 + 1e-6);
}

// Makes a triangle about the second of two nodes, which jumps eighty times in one clip, and turns by a right angle and more each
// second, for twenty seconds, in the other one.
Model two_nodes_with_two_clips(bool jumps) {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Model model = gen::model_of_nodes("two clips", {{"a", -1, identity}, {"b", 0, identity}});
  model.vertices = {{1, 0, 0}, {0, 1, 0.5}, {1, 1, 0}};
  model.triangles = {{0, 1, 2}}, model.influences.assign(3, {{1, 1}});
  for (const int clip : {0, 1}) {
    NodeTrack track{1, {}, {}, {}};
    track.positions.keys = {{0, {0, 0, 0}}}, track.scales.keys = {{0, {1, 1, 1}}};
    track.rotations.keys = {{0, Eigen::Quaterniond::Identity()}};
    for (int k = 1; k < 80; ++k) {
      const double time = k / 4.0;
      if (jumps) track.positions.keys.push_back({time, {std::cos(3.0 * k + clip), std::sin(5.0 * k), 0.25 * clip}});
      else
        track.rotations.keys.push_back(
            {time, Eigen::Quaterniond(Eigen::AngleAxisd((clip == 0 ? 2.1 : 1.6) * time, Eigen::Vector3d::UnitZ()))});
    }
    if (jumps) track.positions.interpolation = Interpolation::step;
    const std::string name = clip == 0 ? "a" : "b";
    model.clips.push_back({name, 80 / 4.0, {}, {name, 80 / 4.0, {track}}});
  }
  return model;
}

// Makes a triangle about the second of two nodes, which is this far from the origin along each axis, on one side in one clip and
// on the other side in the other one.
Model at_opposite_ends(double far) {
  Model model = two_nodes_with_two_clips(true);
  for (const std::size_t clip : {0u, 1u})
    model.clips[clip].animation.tracks[0].positions = {{{0, Eigen::Vector3d::Constant(clip == 0 ? -far : far)}}};
  return model;
}

bool holds(const BoundedPart& part, const std::vector<Point3>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Point3& x) {
    return (x.array() >= part.box.low.cast<double>().array()).all() &&
           (x.array() <= part.box.high.cast<double>().array()).all() &&
           (x - part.ball.center.cast<double>()).norm() <= part.ball.radius;
  });
}

void clusters_and_moments(Suite& t) {
  t.example("clusters have each triangle once, as many as allowed at most, and the vertices of these; other sizes are refused",
            {}, [] {
              bool good = true;
              for (const int most : {4, 128, 512}) {
                std::vector<int> seen(man().triangles.size(), 0);
                for (const ModelPart& part : parts_of(man(), most)) {
                  if (part.kind != PartKind::cluster) continue;
                  good = good && static_cast<int>(part.triangles.size()) <= most && !part.triangles.empty();
                  for (const int t : part.triangles) {
                    ++seen[t];
                    for (const int v : man().triangles[t])
                      good = good && std::binary_search(part.vertices.begin(), part.vertices.end(), v);
                  }
                }
                good = good && std::count(seen.begin(), seen.end(), 1) == static_cast<long>(seen.size());
              }
              for (const int most : {-4, 2, 6, 516}) {
                try {
                  parts_of(man(), most);
                  good = false;
                } catch (const std::invalid_argument&) {
                }
              }
              return Checked(good && parts_of(man(), 0).back().kind == PartKind::primitive, 8);
            });
  t.example("the moments that were looked at are counted, two of each part and clip at least", {}, [] {
    const auto parts = static_cast<long>(bounds().parts.size()), clips = static_cast<long>(bounds().clips.size());
    return Checked(bounds().moments >= 2 * clips * parts / 2, bounds().moments);
  });
  t.example("every clip and the rest pose are inside of what is of all, clusters inside of the whole; and so is what is sampled",
            {}, [] {
              const auto all = bounds_of_all(bounds());
              bool good = bounds().clips.size() == man().clips.size();
              long looked_at = 0;
              for (std::size_t p = 0; p < all.size(); ++p) {
                good = good && encloses(all[p], bounds().rest[p]);
                for (const BoundedClip& clip : bounds().clips) good = good && encloses(all[p], clip.parts[p]);
              }
              const JointSets sets(man());
              for (std::size_t c = 0; c < man().clips.size(); ++c) {
                const AnimatedJoints joints(man(), man().clips[c].animation, false);
                for (std::size_t p = 0; p < all.size(); ++p) {
                  const MovingVertices vertices(man(), sets, Skinning::linear, bounds().parts[p].vertices);
                  std::vector<Point3> points;
                  for (int i = 0; i < 40; ++i) {
                    vertices.place(*joints.at(joints.times().back() * i / 39, Side::after), Followed::skinned, points);
                    const BoundedPart& part = bounds().clips[c].parts[p];
                    for (const Point3& x : points) {
                      ++looked_at;
                      good = good && (x.array() >= part.box.low.cast<double>().array()).all() &&
                             (x.array() <= part.box.high.cast<double>().array()).all() &&
                             (x - part.ball.center.cast<double>()).norm() <= part.ball.radius;
                    }
                  }
                }
              }
              return Checked(good, looked_at);
            });
}

void volumes_around_what_is_sampled(Suite& t) {
  t.example("k-DOPs and the nodes of a tree hold what is sampled, and are of what was asked for; other k are refused", {}, [] {
    bool good = true;
    long looked_at = 0;
    const Character character = bake(SkinnedMesh(man()), {}, {});
    std::vector<std::vector<int>> nodes;
    for (int n = 0; n < static_cast<int>(character.tree.nodes.size()); n += n < 40 ? 1 : 50)
      nodes.emplace_back(character.vertices[n].begin(), character.vertices[n].end());
    const JointSets sets(man());
    for (const int k : dop_sizes) {
      const ModelBounds made = bound_model(man(), {.tolerance = 0.1, .cluster_triangles = 512, .dop = k, .nodes = nodes});
      const auto directions = slab_directions(k);
      const auto all = bounds_of_all(made);
      good = good && made.dop == k && made.rest_nodes.size() == nodes.size() && clusters_of(man(), made).dop == k;
      for (std::size_t c = 0; c < man().clips.size(); ++c) {
        const AnimatedJoints joints(man(), man().clips[c].animation, false);
        const BoundedClip& clip = made.clips[c];
        good = good && clip.nodes.size() == nodes.size() && clip.parts.size() == made.parts.size();
        for (std::size_t i = 0; i < made.parts.size() + nodes.size(); ++i) {
          const bool is_part = i < made.parts.size();
          const BoundedPart& bound = is_part ? clip.parts[i] : clip.nodes[i - made.parts.size()];
          const auto& of = is_part ? made.parts[i].vertices : nodes[i - made.parts.size()];
          const MovingVertices vertices(man(), sets, Skinning::linear, of);
          good = good && bound.slabs.size() == directions.size() - 3;
          for (std::size_t d = 0; is_part && d < bound.slabs.size(); ++d)
            good = good && all[i].slabs[d].low <= bound.slabs[d].low && bound.slabs[d].high <= all[i].slabs[d].high;
          std::vector<Point3> points;
          std::vector<Slab<double>> seen(bound.slabs.size(), {1e300, -1e300});
          for (int step = 0; step < 40; ++step) {
            vertices.place(*joints.at(joints.times().back() * step / 39, Side::after), Followed::skinned, points);
            for (const Point3& x : points) {
              ++looked_at;
              good = good && (x.array() >= bound.box.low.cast<double>().array()).all() &&
                     (x.array() <= bound.box.high.cast<double>().array()).all();
              for (std::size_t d = 0; d < seen.size(); ++d) {
                const SlabDirection& n = directions[d + 3];
                const double along = n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
                seen[d] = {std::min(seen[d].low, along), std::max(seen[d].high, along)};
              }
            }
          }
          const double size = bound.ball.radius;
          for (std::size_t d = 0; d < seen.size(); ++d)
            good = good && bound.slabs[d].low <= seen[d].low && seen[d].high <= bound.slabs[d].high &&
                   bound.slabs[d].high - bound.slabs[d].low <= seen[d].high - seen[d].low + 0.25 * size;
        }
      }
    }
    try {
      bound_model(man(), {.dop = 8});
      good = false;
    } catch (const std::invalid_argument&) {
    }
    return Checked(good, looked_at);
  });
  t.example("the box of the whole is little larger than those of its clusters together", {}, [] {
    bool good = true;
    for (const BoundedClip& clip : bounds().clips) {
      Box<float> joined = Box<float>::empty();
      for (std::size_t p = 0; p < bounds().parts.size(); ++p)
        if (bounds().parts[p].kind == PartKind::cluster) joined.merge(clip.parts[p].box);
      good = good && clip.parts[0].box.edges().prod() <= 1.02f * joined.edges().prod();
    }
    return Checked(good, static_cast<long>(bounds().clips.size()));
  });
}

Checked check_clips_of_many_keys() {
  long looked_at = 0;
  for (const bool jumps : {true, false}) {
    const Model model = two_nodes_with_two_clips(jumps);
    const ModelBounds faded = bound_model(model, {.tolerance = 0.1, .cluster_triangles = 0, .crossfades = true});
    const BoundedPart& part = faded.crossfades.at(0).parts[0];
    const JointSets sets(model);
    const MovingVertices vertices(model, sets, Skinning::linear, faded.parts[0].vertices);
    const CrossfadedJoints joints(model, model.clips[0].animation, model.clips[1].animation, vertices.joints(),
                                  RotationBlend::slerp, false);
    std::vector<Point3> points;
    double farthest = 0;
    // The whole crossfade is in one cell, in which no speeds are known.
    const JointCell cell = joints.cell(joints.boxes()[0]);
    const CellSlack slack = vertices.slack(cell, Finite::must_be);
    std::vector<std::vector<Point3>> corners;
    for (const ParameterMoment& corner : cell.corners) vertices.place(*joints.at(corner), slack.followed, corners.emplace_back());
    for (int i = 0; i < 3000; ++i) {
      const double shares[] = {i % 97 / 96.0, i % 89 / 88.0, i % 7 / 6.0};
      vertices.place(*joints.at({{{shares[0] * model.clips[0].duration, Side::after},
                                  {shares[1] * model.clips[1].duration, Side::after},
                                  {shares[2], Side::after}}}),
                     Followed::skinned, points);
      for (std::size_t v = 0; v < points.size(); ++v) {
        const Point3& x = points[v];
        Point3 between = Point3::Zero();
        for (std::size_t c = 0; c < corners.size(); ++c) {
          double weight = 1;
          for (std::size_t k = 0; k < 3; ++k) weight *= c >> k & 1 ? shares[k] : 1 - shares[k];
          between += weight * corners[c][v];
        }
        if (!((x - between).norm() <= slack.chord && slack.chord < 30)) return Checked(false, looked_at, "a chord is longer");
        ++looked_at, farthest = std::max(farthest, x.norm());
        if ((x.array() < part.box.low.cast<double>().array()).any() || (x.array() > part.box.high.cast<double>().array()).any())
          return Checked(false, looked_at, "a vertex is outside");
      }
    }
    if (!(part.box.edges().norm() < 20 * farthest && part.ball.radius < 20 * farthest))
      return Checked(false, looked_at, "too wide");
  }
  return Checked(true, looked_at);
}

void crossfades(Suite& t) {
  t.example(
      "what is seen while one clip fades to another is inside of the crossfade's bounds, and these of what is of all", {}, [] {
        bool good = true;
        long looked_at = 0;
        for (const int clusters : {0, 512}) {
          const ModelBounds faded = bound_model(
              man(), {.tolerance = 0.1, .cluster_triangles = clusters, .crossfades = true, .rotations = RotationBlend::nlerp});
          const std::size_t clips = man().clips.size();
          good = good && faded.crossfades.size() == clips * (clips - 1) / 2 && faded.rotations == RotationBlend::nlerp;
          const auto all = bounds_of_all(faded);
          const JointSets sets(man());
          for (const BoundedCrossfade& fade : faded.crossfades) {
            good = good && fade.first < fade.second;
            for (std::size_t p = 0; p < all.size(); ++p) {
              const MovingVertices vertices(man(), sets, Skinning::linear, faded.parts[p].vertices);
              const Clip &first = man().clips[fade.first], &second = man().clips[fade.second];
              const CrossfadedJoints joints(man(), first.animation, second.animation, vertices.joints(), RotationBlend::nlerp,
                                            false);
              const BoundedPart& part = fade.parts[p];
              good = good && encloses(all[p], part);
              std::vector<Point3> points;
              for (int i = 0; i < 60; ++i) {
                const double shares[] = {i % 7 / 6.0, i % 5 / 4.0, i % 4 / 3.0};
                vertices.place(*joints.at({{{shares[0] * first.duration, Side::after},
                                            {shares[1] * second.duration, Side::after},
                                            {shares[2], Side::after}}}),
                               Followed::skinned, points);
                for (const Point3& x : points) {
                  ++looked_at;
                  good = good && (x.array() >= part.box.low.cast<double>().array()).all() &&
                         (x.array() <= part.box.high.cast<double>().array()).all() &&
                         (x - part.ball.center.cast<double>()).norm() <= part.ball.radius;
                }
              }
            }
          }
        }
        return Checked(good, looked_at);
      });
  t.example("clips that jump or turn many times have finite bounds of their crossfades, which hold what is seen", {},
            check_clips_of_many_keys);
}

void parts_of_crossfades_and_rounded_weights(Suite& t) {
  t.example("while one clip fades to another, the box of each skin, mesh and primitive is that of its own clusters together", {},
            [] {
              const TemporaryFolder folder;
              write_whole(folder.file("rich.glb"), gen::RichGltf(false, true, false).file.binary_file());
              Model model = load_model(folder.file("rich.glb"), {.joints = Joints::affine, .morphs = Morphs::moving});
              model.clips.push_back(model.clips[0]);
              model.clips[1].name = "again";
              const ModelBounds faded =
                  bound_model(model, {.tolerance = 0.5, .cluster_triangles = 4, .crossfades = true, .crossfade_tolerance = 1});
              long looked_at = 0, smaller = 0;
              for (std::size_t p = 0; p < faded.parts.size(); ++p) {
                if (faded.parts[p].kind == PartKind::cluster) continue;
                const std::vector<BoundedPart>& bounds = faded.crossfades.at(0).parts;
                const std::set<int> own(faded.parts[p].vertices.begin(), faded.parts[p].vertices.end());
                Box<float> joined = Box<float>::empty();
                for (std::size_t c = 0; c < faded.parts.size(); ++c) {
                  const auto& vertices = faded.parts[c].vertices;
                  if (faded.parts[c].kind == PartKind::cluster &&
                      std::all_of(vertices.begin(), vertices.end(), [&](int v) { return own.contains(v); }))
                    joined.merge(bounds[c].box);
                }
                if (bounds[p].box.low != joined.low || bounds[p].box.high != joined.high)
                  return Checked(false, looked_at, name_of(faded.parts[p].kind));
                ++looked_at, smaller += joined.low != bounds[0].box.low || joined.high != bounds[0].box.high;
              }
              return Checked(smaller > 2, looked_at, std::to_string(smaller) + " of them smaller than the whole");
            });
  t.example("bounds hold for weights that were rounded to multiples of 2^-24, of images that cancel, too", {}, [] {
    long tried = 0;
    for (const bool is_rendered_exactly : {false, true})
      for (const int joints : {2, 3, 4})
        for (const double way : {1.0, 1e3, 1e6}) {
          std::vector<SceneNode> nodes;
          for (int j = 0; j < joints; ++j) {
            nodes.push_back({"node", -1, Eigen::Matrix4d::Identity()});
            nodes.back().local(0, 3) = j == 0 ? way : -way;
          }
          Model model = gen::model_of_nodes("cancelling", nodes);
          model.vertices = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}};
          model.triangles = {{0, 1, 2}};
          std::vector<Influence> influences;
          double left = 1;
          for (int j = 0; j < joints; ++j) {
            influences.push_back({j, j + 1 < joints ? left / 2 : left});
            left -= influences.back().weight;
          }
          model.influences.assign(3, influences);
          ModelBoundsOptions options;
          if (is_rendered_exactly) options.renderer_rounding = 0;
          for (const BoundedPart& part : bound_model(model, options).rest) {
            // Such weights are 2^-25 less and more.
            const double off = joints * way * 0x1p-25;
            if (!(part.box.low[0] <= -off && part.box.high[0] >= 1e-3 + off)) return Checked(false, tried, std::to_string(way));
            if (!(part.ball.radius >= off && part.ball.radius <= 1e-3 + 2e-6 * way * 8)) return Checked(false, tried, "ball");
            ++tried;
          }
        }
    return Checked(true, tried);
  });
}

void what_is_refused(Suite& t) {
  t.example("what is not finite, or beyond the range of float, is refused with the clip", {}, [] {
    std::string wrong;
    const auto refused = [&](const Model& model, const std::string& reason) {
      try {
        bound_model(model, {.cluster_triangles = 0});
        wrong += "accepted: " + reason + "; ";
      } catch (const ModelError& e) {
        if (std::string(e.what()).find(reason) == std::string::npos) wrong += e.what();
      }
    };
    Model far = two_nodes_with_two_clips(true);
    far.clips[1].animation.tracks[0].positions.keys[3].value = {0, 1e39, 0};
    refused(far, "clip 'b': its vertices go beyond the range of float");
    far.clips[1].animation.tracks.push_back(
        {0, {{{0, {0, 0, 0}}}}, {{{0, Eigen::Quaterniond::Identity()}}}, {{{0, Eigen::Vector3d::Constant(1e300)}}}});
    refused(far, "joint 'b', time");
    far = at_opposite_ends(2.5e38);
    refused(far, "all clips together: its vertices go beyond the range of float");
    far = two_nodes_with_two_clips(true);
    far.morphs = {{0, {std::numeric_limits<double>::infinity()}, {}}};
    refused(far, "a weight of a morph target is not finite");
    return Checked(wrong.empty(), 4, wrong);
  });
  t.example("a ball for any pose beyond the range of float is refused, where the clips' bounds are within it", {}, [] {
    Model model = at_opposite_ends(2.4e38);
    model.clips.pop_back();
    model.influences.assign(3, {{0, 0.5}, {1, 0.5}});
    for (const bool any_pose : {false, true}) {
      bool is_refused = false;
      try {
        bound_model(model, {.cluster_triangles = 0, .any_pose = any_pose});
      } catch (const ModelError& e) {
        is_refused =
            std::string(e.what()).find("all clips together: its vertices go beyond the range of float") != std::string::npos;
      }
      if (is_refused != any_pose) return Checked(false, 2, any_pose ? "accepted" : "refused without it");
    }
    return Checked(true, 2);
  });
}

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  Point3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  Eigen::Quaterniond turn() {
    std::normal_distribution<double> number;
    return Eigen::Quaterniond(number(random_), number(random_), number(random_), number(random_)).normalized();
  }

 private:
  std::mt19937 random_;
};

unsigned drawn_seed() { return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<unsigned>()); }

// Makes triangles between any of some vertices, perhaps of one alone or with one twice, and two nodes that move in each clip. All
// lengths are in this unit; those of the clips are at most `way` units.
Model heap_of_triangles(double unit, double way, int triangles, int clips, unsigned seed) {
  Numbers random(seed);
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  const NodeTransform rest{Point3::Zero(), Eigen::Vector3d::Ones(), Eigen::Quaterniond::Identity()};
  Model model = gen::model_of_nodes("heap", {{"a", -1, identity, -1, rest}, {"b", 0, identity, -1, rest}});
  const int vertices = 1 + random.below(60);
  for (int v = 0; v < vertices; ++v) {
    model.vertices.emplace_back(unit * random.vector());
    if (random.below(2) == 0) model.influences.push_back({{0, 0.25}, {1, 0.75}});
    else model.influences.push_back({{random.below(2), 1}});
  }
  for (int t = 0; t < triangles; ++t)
    model.triangles.push_back({random.below(vertices), random.below(vertices), random.below(vertices)});
  for (int clip = 0; clip < clips; ++clip) {
    Animation animation{"clip", 1, {}};
    for (const int node : {0, 1})
      animation.tracks.push_back({node,
                                  {{{0, way * unit * random.vector()}, {1, way * unit * random.vector()}}},
                                  {{{0, random.turn()}, {1, random.turn()}}},
                                  {{{0, Eigen::Vector3d::Ones()}}}});
    model.clips.push_back({"clip", 1, {}, animation});
  }
  validate(model);
  return model;
}

bool have_each_triangle_once(const Model& model, const std::vector<ModelPart>& parts) {
  std::vector<int> seen(model.triangles.size(), 0);
  for (const ModelPart& part : parts)
    for (const int t : part.triangles) {
      ++seen[static_cast<std::size_t>(t)];
      for (const int v : model.triangles[static_cast<std::size_t>(t)])
        if (!std::binary_search(part.vertices.begin(), part.vertices.end(), v)) return false;
    }
  return std::count(seen.begin(), seen.end(), 1) == static_cast<long>(seen.size());
}

// Says whether the vertices of all parts are inside of their bounds at some moments of these joints.
bool hold_what_is_sampled(const Model& model, const std::vector<ModelPart>& parts, const std::vector<BoundedPart>& bounds,
                          const MovingJoints& joints, const std::vector<ParameterMoment>& moments) {
  const JointSets sets(model);
  std::vector<Point3> points;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const MovingVertices vertices(model, sets, Skinning::linear, parts[p].vertices);
    for (const ParameterMoment& moment : moments) {
      vertices.place(*joints.at(moment), Followed::skinned, points);
      if (!holds(bounds[p], points)) return false;
    }
  }
  return true;
}

void check_any_lengths() {
  const double unit = *rc::gen::element(1e-40, 1e-6, 1.0, 1e6, 1e18, 1e20, 1e30, 1e37), way = *rc::gen::element(1.0, 1.0, 60.0);
  const int triangles = *gen::between(1, 601), clips = *rc::gen::element(0, 1, 2, 2);
  const int clustered = *rc::gen::element(0, 16, 128, 512);
  const bool fades = clips == 2 && *rc::gen::arbitrary<bool>();
  const unsigned seed = drawn_seed();
  RC_LOG() << "unit " << unit << ", way " << way << ", " << triangles << " triangles, " << clips << " clips, clusters of "
           << clustered << (fades ? ", crossfades" : "") << ", seed " << seed;
  RC_CLASSIFY(unit < 1e-6 || unit > 1e6, "degenerate");
  const Model model = heap_of_triangles(unit, way, triangles, clips, seed);
  if (clustered != 0) RC_ASSERT(have_each_triangle_once(model, parts_of(model, clustered)));
  ModelBounds made{};
  try {
    made = bound_model(model, {.tolerance = 0.1,
                               .cluster_triangles = clustered,
                               .crossfades = fades,
                               .crossfade_tolerance = 1,
                               .rotations = RotationBlend::nlerp});
  } catch (const ModelError& e) {
    RC_TAG("refused");
    RC_ASSERT(std::string(e.what()).find("its vertices go beyond the range of float") != std::string::npos);
    RC_ASSERT(unit * way >= 1e37);
    return;
  }
  RC_TAG(fades ? "bounded with crossfades" : "bounded");
  for (const BoundedPart& part : bounds_of_all(made)) RC_ASSERT(is_sound(part));
  for (const BoundedPart& part : made.rest) RC_ASSERT(is_sound(part));
  std::vector<ParameterMoment> moments, faded;
  for (const double share : {0.0, 0.31, 0.5, 1.0}) {
    moments.push_back({{{share, Side::after}}});
    for (const double other : {0.0, 0.73}) faded.push_back({{{share, Side::after}, {other, Side::after}, {share, Side::after}}});
  }
  for (std::size_t c = 0; c < made.clips.size(); ++c) {
    for (const BoundedPart& part : made.clips[c].parts) RC_ASSERT(is_sound(part));
    const AnimatedJoints joints(model, model.clips[c].animation, false);
    RC_ASSERT(hold_what_is_sampled(model, made.parts, made.clips[c].parts, joints, moments));
  }
  const std::vector<int> both = {0, 1};
  for (const BoundedCrossfade& fade : made.crossfades) {
    const CrossfadedJoints joints(model, model.clips[0].animation, model.clips[1].animation, both, RotationBlend::nlerp, false);
    RC_ASSERT(hold_what_is_sampled(model, made.parts, fade.parts, joints, faded));
  }
}

void any_lengths(Suite& t) {
  t.holds(
      "whatever the unit of lengths is, clusters have each triangle once, and bounds are finite and hold what is sampled, or the "
      "model is refused because it is beyond the range of float",
      {.number_type = "double",
       .cases = 40,
       .degenerate_at_least = 0.3,
       .degenerate_at_most = 0.9,
       .tags_at_least = {{"bounded", 0.3}, {"bounded with crossfades", 0.05}}},
      check_any_lengths);
}

// --- Blends of rotations, in long double ---

using Turns = std::vector<Eigen::Quaterniond>;

// Makes joints below a base, with these turns and places, that move the three vertices of a triangle, all of them at v.
Model joints_below_a_base(const Turns& turns, const std::vector<Point3>& places,
                          const std::vector<std::pair<int, double>>& weights, const Point3& v) {
  std::vector<SceneNode> nodes = {{"base", -1, Eigen::Matrix4d::Identity()}};
  for (std::size_t j = 0; j < turns.size(); ++j) {
    nodes.push_back({"joint " + std::to_string(j), 0, Eigen::Matrix4d::Identity()});
    nodes.back().local.topLeftCorner<3, 3>() = turns[j].toRotationMatrix();
    nodes.back().local.topRightCorner<3, 1>() = places[j];
  }
  Model model = gen::model_of_nodes("below a base", nodes);
  model.vertices.assign(3, v), model.triangles = {{0, 1, 2}};
  std::vector<Influence> influences;
  for (const auto& [joint, weight] : weights) influences.push_back({joint + 1, weight});
  model.influences.assign(3, influences);
  validate(model);
  return model;
}

// Makes a node that is at a place and turns from one rotation to the other in a second.
NodeTrack turning(int node, const Point3& place, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  return {node, {{{0, place}}}, {{{0, from}, {1, to}}}, {{{0, Eigen::Vector3d::Ones()}}}};
}

// Returns the image of v by dual quaternion skinning: with the images x_j by the joints and q = sum w_j q_j, it is the imaginary
// part of sum w_j x_j q_j q* over the square of the length of q.
Point3 blended_exactly(const Turns& turns, const std::vector<Point3>& places, const std::vector<double>& weights,
                       const Point3& v) {
  using Exact = Eigen::Quaternion<long double>;
  Eigen::Matrix<long double, 4, 1> blend = Eigen::Matrix<long double, 4, 1>::Zero(), carried = blend;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    const Exact q = turns[j].cast<long double>().normalized();
    const Eigen::Matrix<long double, 3, 1> x = q * v.cast<long double>() + places[j].cast<long double>();
    blend += weights[j] * q.coeffs();
    carried += weights[j] * (Exact(0, x[0], x[1], x[2]) * q).coeffs();
  }
  return ((Exact(carried) * Exact(blend).conjugate()).vec() / blend.squaredNorm()).cast<double>();
}

// Returns the image of the model's first vertex by spherical skinning, in double.
Point3 blended_spherically(const Model& model, const Turns& turns, const std::vector<Point3>& places,
                           const std::vector<double>& weights) {
  Pose transforms;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    const Eigen::Quaterniond q = turns[j].normalized();
    transforms.push_back({{q.w(), q.x(), q.y(), q.z()}, places[j]});
  }
  return oracle::reweighted_vertex(model, Skinning::spherical, transforms, weights);
}

// Returns weights of a base joint and of others that share the rest nearly equally. Those of even and of odd joints are rounded
// in opposite directions.
std::vector<double> weights_between_multiples(int joints, double first, double odd, double even) {
  std::vector<double> weights(static_cast<std::size_t>(joints));
  double left = 1;
  for (int j = 1; j < joints; ++j) {
    weights[static_cast<std::size_t>(j)] =
        std::ldexp(std::floor(std::ldexp((1 - first) / (joints - 1), weight_bits)) + (j % 2 == 1 ? odd : even), -weight_bits);
    left -= weights[static_cast<std::size_t>(j)];
  }
  weights[0] = left;
  return weights;
}

// Returns the turns of one joint, and of others that are turned against it by nearly half a turn, to either side.
Turns turned_to_either_side(const Eigen::Quaterniond& base, int joints, double cosine) {
  Turns out = {base};
  const double sine = std::sqrt(1 - cosine * cosine);
  for (int j = 1; j < joints; ++j) out.push_back(base * Eigen::Quaterniond(cosine, 0, 0, j % 2 == 1 ? sine : -sine));
  return out;
}

void check_unrounded_weights() {
  const int joints = *gen::between(2, 18);
  const double first = *rc::gen::element(0.11, 0.12, 0.15, 0.3, 0.8);
  const double renderer_rounding = *rc::gen::element(0.0, ModelBoundsOptions{}.renderer_rounding);
  const bool spherical = *rc::gen::arbitrary<bool>();
  const unsigned seed = drawn_seed();
  RC_LOG() << joints << " joints, the first with " << first << ", renderer " << renderer_rounding
           << (spherical ? ", spherical" : ", dual") << ", seed " << seed;
  RC_CLASSIFY(joints == 2 || first > 0.5, "degenerate");
  Numbers random(seed);
  const bool is_worst = random.below(4) != 0;
  const std::vector<double> weights =
      weights_between_multiples(joints, first, is_worst ? 0.495 : random.between(0, 1), is_worst ? 0.505 : random.between(0, 1));
  std::vector<std::pair<int, double>> listed;
  for (int j = 0; j < joints; ++j) listed.emplace_back(j, weights[static_cast<std::size_t>(j)]);
  const auto rounded = quantize_weights(listed);
  RC_ASSERT(static_cast<int>(rounded.size()) == joints);
  const Point3 v = random.vector();
  const double spread = random.below(2) == 0 ? 0 : random.between(0, 1);
  std::vector<Point3> places;
  for (int j = 0; j < joints; ++j) places.emplace_back(spread * random.vector());
  // These are the turns in the rest pose and in two clips whose joints are still.
  std::vector<Turns> turns;
  for (int moment = 0; moment < 3; ++moment)
    turns.push_back(turned_to_either_side(random.turn(), joints, std::pow(10.0, random.between(-4, -1))));
  Model model = joints_below_a_base(turns[0], places, rounded, v);
  for (const std::size_t clip : {1u, 2u}) {
    Animation still{"still", 1, {}};
    for (std::size_t j = 0; j < places.size(); ++j)
      still.tracks.push_back(turning(static_cast<int>(j) + 1, places[j], turns[clip][j], turns[clip][j]));
    model.clips.push_back({"still", 1, {}, still});
  }
  const ModelBounds made = bound_model(model, {.skinning = spherical ? Skinning::spherical : Skinning::dual_quaternion,
                                               .cluster_triangles = 0,
                                               .renderer_rounding = renderer_rounding});
  const auto blended = [&](const Turns& moment, const std::vector<double>& by) {
    return spherical ? blended_spherically(model, moment, places, by) : blended_exactly(moment, places, by, v);
  };
  std::vector<double> of_model;
  for (const auto& [joint, weight] : rounded) of_model.push_back(weight);
  double farthest = 0, off = 0;
  for (std::size_t moment = 0; moment < turns.size(); ++moment) {
    const Point3 exact = blended(turns[moment], weights);
    RC_ASSERT(holds(moment == 0 ? made.rest[0] : made.clips[moment - 1].parts[0], {exact}));
    for (std::size_t j = 0; j < places.size(); ++j) farthest = std::max(farthest, (turns[moment][j] * v + places[j]).norm());
    off = std::max(off, (exact - blended(turns[moment], of_model)).norm());
  }
  if (off > (joints * 0x1p-24 + renderer_rounding) * farthest) RC_TAG("the blend enlarges what rounding takes");
}

// Returns a turn by at most this angle.
Eigen::Quaterniond slight_turn(Numbers& random, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(random.between(0, angle), random.vector().normalized()));
}

// Checks joints with shares that are not rounded to 0, and others that are so far away that they move the vertex more than the
// rounding of the former does.
void check_lost_influences() {
  const int kept = *gen::between(1, 5), lost = *gen::between(1, 4), power = *gen::between(0, 7);
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::dual_quaternion);
  const unsigned seed = drawn_seed();
  RC_LOG() << kept << " joints, " << lost << " lost ones at 10^" << power << ", skinning " << static_cast<int>(skinning)
           << ", seed " << seed;
  RC_CLASSIFY(power == 0 || kept == 1, "degenerate");
  Numbers random(seed);
  const int joints = kept + lost;
  std::vector<std::pair<int, double>> listed;
  double sum = 0;
  for (int j = 0; j < joints; ++j) {
    const double weight = j < kept ? random.between(0.2, 1) : std::ldexp(random.between(0.1, 0.49), -weight_bits) * kept * 0.2;
    listed.emplace_back(j, weight), sum += weight;
  }
  std::vector<std::pair<int, double>> lost_shares;
  const auto rounded = quantize_weights(listed, &lost_shares);
  // All of them together may lose a multiple of 2^-24, which one of them then gets.
  RC_ASSERT(!lost_shares.empty() && rounded.size() + lost_shares.size() == listed.size());
  const Point3 v = random.vector();
  const Eigen::Quaterniond base = random.turn();
  std::vector<Point3> places;
  for (int j = 0; j < joints; ++j) places.emplace_back((j < kept ? 1 : std::pow(10.0, power)) * random.vector());
  // These are the turns in the rest pose, and in a clip.
  std::vector<Turns> turns(2);
  for (Turns& moment : turns)
    for (int j = 0; j < joints; ++j) moment.push_back(base * slight_turn(random, 0.7));
  Model model = joints_below_a_base(turns[0], places, rounded, v);
  double far_share = 0;
  for (const auto& [joint, share] : lost_shares) {
    for (const int vertex : {0, 1, 2}) model.lost_influences.push_back({vertex, joint + 1, share});
    far_share = std::max(far_share, share * places[static_cast<std::size_t>(joint)].norm());
  }
  Animation still{"still", 1, {}};
  for (std::size_t j = 0; j < places.size(); ++j)
    still.tracks.push_back(turning(static_cast<int>(j) + 1, places[j], turns[1][j], turns[1][j]));
  model.clips.push_back({"still", 1, {}, still});
  const ModelBounds made = bound_model(model, {.skinning = skinning, .cluster_triangles = 0, .renderer_rounding = 0});
  std::vector<double> shares;
  for (const auto& [joint, weight] : listed) shares.push_back(weight / sum);
  if (far_share > 10 * kept * 0x1p-24) RC_TAG("lost ones are far");
  for (std::size_t moment = 0; moment < turns.size(); ++moment) {
    Point3 exact = Point3::Zero();
    for (std::size_t j = 0; j < places.size(); ++j) exact += shares[j] * (turns[moment][j] * v + places[j]);
    if (skinning == Skinning::dual_quaternion) exact = blended_exactly(turns[moment], places, shares, v);
    RC_ASSERT(holds(moment == 0 ? made.rest[0] : made.clips[0].parts[0], {exact}));
  }
}

// Checks one joint with two meshes: one about the origin, and one that is modelled far away, which its inverse bind matrix brings
// back. A renderer in float begins with the far coordinates.
void check_far_frame() {
  const int power = *gen::between(0, 7);
  const unsigned seed = drawn_seed();
  RC_LOG() << "10^" << power << " away, seed " << seed;
  RC_CLASSIFY(power == 0, "degenerate");
  Numbers random(seed);
  const Eigen::Matrix3f turn = random.turn().toRotationMatrix().cast<float>();
  const Eigen::Vector3f away = (std::pow(10.0, power) * random.vector()).cast<float>();
  Eigen::Matrix4f back = Eigen::Matrix4f::Identity();
  back.topLeftCorner<3, 3>() = turn, back.topRightCorner<3, 1>() = -turn * away;
  Eigen::Matrix4d joint = Eigen::Matrix4d::Identity();
  joint.topLeftCorner<3, 3>() = random.turn().toRotationMatrix(), joint.topRightCorner<3, 1>() = random.vector();
  Scene scene{"far", {{"joint", -1, joint}, {"near", -1, Eigen::Matrix4d::Identity()}}, {}, {}, {}, {}};
  scene.nodes.push_back({"far", -1, Eigen::Matrix4d::Identity()});
  scene.skins = {{{0}, {Eigen::Matrix4d::Identity()}}, {{0}, {back.cast<double>()}}};
  std::vector<Point3> places;
  for (const bool is_far : {false, true}) {
    ScenePrimitive primitive{"part", {}, {{0, 1, 2}, {2, 3, 4}}, {}, {}};
    primitive.weights.assign(5, {{0, 1.0}});
    const Eigen::Matrix4f matrix = joint.cast<float>() * (is_far ? back : Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    for (int v = 0; v < 5; ++v) {
      const Eigen::Vector3f at = random.vector().cast<float>() + (is_far ? away : Eigen::Vector3f(Eigen::Vector3f::Zero()));
      primitive.positions.push_back(at.cast<double>());
      places.push_back((matrix.topLeftCorner<3, 3>() * at + matrix.topRightCorner<3, 1>()).cast<double>());
    }
    scene.meshes.push_back({{primitive}});
    scene.shown.push_back({is_far ? 2 : 1, is_far ? 1 : 0, is_far ? 1 : 0, {}});
  }
  const Model model = model_of_scene(scene);
  const ModelBounds made = bound_model(model, {.cluster_triangles = 0, .any_pose = true});
  RC_ASSERT(holds(made.rest[0], places));
  RC_ASSERT(made.any_pose[0].has_value() &&
            model.skeleton.nodes[static_cast<std::size_t>(made.any_pose[0]->node)].name == "joint");
  for (const Point3& x : places) RC_ASSERT((x - joint.topRightCorner<3, 1>()).norm() <= made.any_pose[0]->radius);
  if (power > 3) RC_TAG("far");
  if (!holds(bound_model(model, {.cluster_triangles = 0, .renderer_rounding = 0}).rest[0], places)) RC_TAG("rounding is seen");
}

// Checks a joint whose offset makes nearly nothing of a direction, and a morph target that displaces vertices along it. A
// renderer in float rounds a part of the displacements, not of their images; also where another mesh comes first, in whose frame
// the model is.
void check_flattened_displacements() {
  const int power = *gen::between(0, 9);
  const bool is_placed = *rc::gen::arbitrary<bool>();
  const unsigned seed = drawn_seed();
  RC_LOG() << "10^-" << power << " of a displacement is left, " << (is_placed ? "placed, " : "") << "seed " << seed;
  RC_CLASSIFY(power == 0, "degenerate");
  Numbers random(seed);
  const Eigen::Matrix3d before = random.turn().toRotationMatrix(), after = random.turn().toRotationMatrix();
  const Eigen::Matrix3f flat = (after * Point3(std::pow(10.0, -power), 1, 1).asDiagonal() * before.transpose()).cast<float>();
  Eigen::Matrix4d offset = Eigen::Matrix4d::Identity();
  offset.topLeftCorner<3, 3>() = flat.cast<double>();
  Scene scene{"flat", {{"joint", -1, Eigen::Matrix4d::Identity()}, {"shown", -1, Eigen::Matrix4d::Identity()}}, {}, {}, {}, {}};
  scene.skins = {{{0}, {offset}}};
  ScenePrimitive primitive{"part", {}, {{0, 1, 2}, {2, 3, 4}}, {}, {{}}};
  primitive.weights.assign(5, {{0, 1.0}});
  const float weight = 1 + static_cast<float>(seed % 4) / 2;
  const double size = *rc::gen::element(1.0, 100.0, 1e4);
  std::vector<Point3> places;
  for (int v = 0; v < 5; ++v) {
    const Eigen::Vector3f at = (1e-9 * random.vector()).cast<float>(), by = (size * (1 + 0.25 * v) * before.col(0)).cast<float>();
    primitive.positions.push_back(at.cast<double>()), primitive.targets[0].push_back(by.cast<double>());
    places.push_back((flat * (at + weight * by)).cast<double>());
  }
  if (is_placed) {
    ScenePrimitive other{"other", {}, {{0, 1, 2}}, {}, {}};
    other.weights.assign(3, {{0, 1.0}});
    for (int i = 0; i < 3; ++i) other.positions.push_back(1e-9 * Point3::Unit(i)), places.push_back(other.positions.back());
    scene.nodes.push_back({"other", -1, Eigen::Matrix4d::Identity()});
    scene.skins.insert(scene.skins.begin(), {{0}, {Eigen::Matrix4d::Identity()}});
    scene.meshes.push_back({{other}});
    scene.shown.push_back({1, 0, 0, {}});
    RC_TAG("placed");
  }
  scene.meshes.push_back({{primitive}});
  scene.shown.push_back({is_placed ? 2 : 1, is_placed, is_placed, {weight}});
  const Model model = model_of_scene(scene, {.joints = Joints::affine, .morphs = Morphs::moving});
  RC_ASSERT(holds(bound_model(model, {.cluster_triangles = 0}).rest[0], places));
  if (!holds(bound_model(model, {.cluster_triangles = 0, .renderer_rounding = 0}).rest[0], places)) RC_TAG("rounding is seen");
}

// Returns a half turn, but for this cosine of the quaternions.
Eigen::Quaterniond nearly_half_a_turn(const Point3& axis, double cosine) {
  const Point3 sine = std::sqrt(1 - cosine * cosine) * axis.normalized();
  return Eigen::Quaterniond(cosine, sine[0], sine[1], sine[2]);
}

// Checks two joints below a base, of which the second one is half a turn from the first one, or nearly so, at the end of the
// clip: it is so all the time, while the base turns, or after it moved there.
void check_both_signs() {
  const int power = *rc::gen::inRange(3, 13), sign = *rc::gen::element(-1, 0, 1, 1), kind = *rc::gen::inRange(0, 3);
  const double cosine = sign * std::pow(10.0, -power), first = *rc::gen::element(0.5, 0.25, 0.625, 0.9375);
  const Skinning skinning = *rc::gen::element(Skinning::dual_quaternion, Skinning::spherical);
  const double renderer_rounding = *rc::gen::element(0.0, ModelBoundsOptions{}.renderer_rounding);
  const unsigned seed = drawn_seed();
  RC_LOG() << "cosine " << cosine << ", weight " << first << ", skinning " << static_cast<int>(skinning) << ", kind " << kind
           << ", renderer " << renderer_rounding << ", seed " << seed;
  RC_CLASSIFY(sign == 0, "degenerate");
  Numbers random(seed);
  const Eigen::Quaterniond still = random.turn(), base = random.turn();
  const Point3 axis = random.vector(), v = random.vector();
  const Turns turns = {still, still * nearly_half_a_turn(axis, cosine)};
  // About one point, spherical blending is the same as that of dual quaternions.
  std::vector<Point3> places(2, Point3::Zero());
  if (skinning == Skinning::dual_quaternion) places = {random.vector(), random.vector()};
  Model model = joints_below_a_base(turns, places, {{0, first}, {1, 1 - first}}, v);
  Animation animation{"clip", 1, {}};
  for (const int j : {0, 1}) {
    const auto at = static_cast<std::size_t>(j);
    const bool arrives = j == 1 && kind == 2;
    animation.tracks.push_back(
        turning(j + 1, places[at], arrives ? still * nearly_half_a_turn(axis, 0.3) : turns[at], turns[at]));
  }
  if (kind == 1) animation.tracks.push_back(turning(0, Point3::Zero(), Eigen::Quaterniond::Identity(), base));
  model.clips.push_back({"clip", 1, {}, animation});
  const ModelBounds made =
      bound_model(model, {.skinning = skinning, .cluster_triangles = 0, .renderer_rounding = renderer_rounding});
  const bool either = std::abs(cosine) <= rounding_of_cosine_in_float;
  if (either) RC_TAG("either sign");
  for (const int chosen : {-1, 1}) {
    if (!either && chosen * cosine < 0) continue;
    const Turns signed_turns = {turns[0], Eigen::Quaterniond(Eigen::Vector4d(chosen * turns[1].coeffs()))};
    const Point3 image = blended_exactly(signed_turns, places, {first, 1 - first}, v);
    RC_ASSERT(holds(made.rest[0], {image}));
    RC_ASSERT(holds(made.clips[0].parts[0], {kind == 1 ? Point3(base * image) : image}));
  }
}

void blends_of_rotations(Suite& t) {
  t.holds(
      "dual quaternions and spherical blends with the weights of the file, which are not rounded, put no vertex outside, however "
      "short the blend is",
      {.number_type = "double, long double",
       .cases = 300,
       .degenerate_at_most = 0.6,
       .tags_at_least = {{"the blend enlarges what rounding takes", 0.1}}},
      check_unrounded_weights);
  t.holds("joints whose weights are rounded to 0 put no vertex outside, however far they carry it",
          {.number_type = "double", .cases = 300, .degenerate_at_most = 0.6, .tags_at_least = {{"lost ones are far", 0.3}}},
          check_lost_influences);
  t.holds("what a renderer in float rounds of a mesh that is modelled far away puts no vertex outside",
          {.number_type = "float",
           .cases = 300,
           .degenerate_at_most = 0.4,
           .tags_at_least = {{"far", 0.2}, {"rounding is seen", 0.3}}},
          check_far_frame);
  t.holds("what a renderer in float rounds of displacements that a joint makes nearly nothing of puts no vertex outside",
          {.number_type = "float",
           .cases = 300,
           .degenerate_at_most = 0.4,
           .tags_at_least = {{"rounding is seen", 0.3}, {"placed", 0.3}}},
          check_flattened_displacements);
  t.holds(
      "where two joints are half a turn apart, to within what a renderer in float rounds, the vertex is inside with either sign",
      {.number_type = "long double", .cases = 120, .degenerate_at_most = 0.6, .tags_at_least = {{"either sign", 0.3}}},
      check_both_signs);
}

}  // namespace

PROPTEST(model_bounds) {
  clusters_and_moments(t);
  volumes_around_what_is_sampled(t);
  crossfades(t);
  parts_of_crossfades_and_rounded_weights(t);
  what_is_refused(t);
  any_lengths(t);
  blends_of_rotations(t);
  t.example("progress goes up to the whole", {}, [] {
    std::vector<double> told;
    bound_model(
        man(),
        {.tolerance = 0.1, .cluster_triangles = 0, .crossfades = true, .crossfade_tolerance = 0.5, .progress = [&](double share) {
           told.push_back(share);
         }});
    return Checked(!told.empty() && std::is_sorted(told.begin(), told.end()) && told.back() == 1, static_cast<long>(told.size()));
  });
}

}  // namespace proptests::suite_model_bounds
