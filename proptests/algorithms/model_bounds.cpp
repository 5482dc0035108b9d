// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of all parts of a model: which parts there are, and that what is of all clips encloses what is of each.
#include "algorithms/bake/over_time/model_bounds.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/model/procedural/procedural.hpp"
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

}  // namespace

PROPTEST(model_bounds) {
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
