// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of all parts of a model: which parts there are, and that what is of all clips encloses what is of each.
#include "algorithms/bake/over_time/model_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/results/write_whole.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/model_of_nodes.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/gen/temporary_folder.hpp"
#include "proptests/harness.hpp"

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

// A triangle about the second of two nodes, which jumps eighty times in one clip and turns by a right angle and more each second, for
// twenty seconds, in the other one.
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
    // The whole crossfade in one cell, of which no speeds are known.
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

void parts_of_crossfades_and_what_is_refused(Suite& t) {
  t.example("while one clip fades to another, the box of each skin, mesh and primitive is that of its own clusters together", {},
            [] {
              const gen::TemporaryFolder folder;
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
            const double off = joints * way * 0x1p-25;  // of weights that are 2^-25 less and more
            if (!(part.box.low[0] <= -off && part.box.high[0] >= 1e-3 + off)) return Checked(false, tried, std::to_string(way));
            if (!(part.ball.radius >= off && part.ball.radius <= 1e-3 + 2e-6 * way * 8)) return Checked(false, tried, "ball");
            ++tried;
          }
        }
    return Checked(true, tried);
  });
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
    far = two_nodes_with_two_clips(true);
    far.morphs = {{0, {std::numeric_limits<double>::infinity()}, {}}};
    refused(far, "a weight of a morph target is not finite");
    return Checked(wrong.empty(), 3, wrong);
  });
}

}  // namespace

PROPTEST(model_bounds) {
  clusters_and_moments(t);
  volumes_around_what_is_sampled(t);
  crossfades(t);
  parts_of_crossfades_and_what_is_refused(t);
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
