// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/batch.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/collide/cluster_body.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/speed/latencies.hpp"
#include "experiments/speed/longest_chain.hpp"

namespace refitlab {
namespace {

struct Kind {
  std::string name;
  Skinning skinning;
};
const Kind kinds[] = {
    {"linear", Skinning::linear}, {"spherical", Skinning::spherical}, {"dual_quaternion", Skinning::dual_quaternion}};

class BatchExperiment {
 public:
  BatchExperiment(const AnimatedCharacter& c, const NamedPose& pose, const SpeedSettings& settings)
      : c_(c),
        pose_(pose),
        settings_(settings),
        latencies_(measure_latencies({settings.seconds_per_run / 10, settings.repetitions})),
        packed_(c.mesh, c.sets),
        batch_(c.tree, c.sets) {}

  std::vector<BatchSpeed> run() {
    for (const Kind& kind : kinds) skin(kind);
    for (const Kind& kind : {kinds[0], kinds[1]}) refit(kind);
    compare_refits();
    bound_opened_nodes(pose_);
    if (!c_.clips.empty()) {
      const Clip& clip = c_.clips[0];
      bound_opened_nodes({"halfway through " + clip.name, clip.sample(clip.duration / 2)});
    }
    palette();
    return std::move(results_);
  }

 private:
  void skin(const Kind& kind) {
    const auto palette = palette_of(kind);
    const auto expected = refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning);
    std::vector<Point3> out(expected.size());
    std::vector<Timed> timed{{"scalar", size_of(expected),
                              [&] { benchmark::DoNotOptimize(refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning)); }}};
    for (const Target target : available_targets()) {
      packed_.skin_all(palette, kind.skinning, out, target);
      if (out != expected) fail("skinning, " + kind.name + ", is not bit-identical", name_of(target));
      timed.push_back({name_of(target), size_of(expected), [&, target] {
                         packed_.skin_all(palette, kind.skinning, out, target);
                         benchmark::DoNotOptimize(out.data());
                       }});
    }
    measure("skin_" + kind.name, "vertex", timed);
  }

  void refit(const Kind& kind) {
    const auto palette = palette_of(kind);
    const bool is_linear = kind.skinning == Skinning::linear;
    const RefitVariant& variant = compared_variant(is_linear ? "linear" : "spherical_repaired");
    std::vector<Timed> timed{{"scalar", size_of(c_.tree.nodes), [&] {
                                for (int n = 0; n < size_of(c_.tree.nodes); ++n)
                                  benchmark::DoNotOptimize(variant.refit(c_.tree.refit_node(n, palette)));
                              }}};
    const auto refit_all = [&, is_linear](Target target) -> const PackedBalls& {
      return is_linear ? batch_.linear(palette, target) : batch_.spherical(palette, target);
    };
    for (const Target target : available_targets()) {
      const PackedBalls& balls = refit_all(target);
      require_no_miss(
          kind, [&](int n) { return balls[n]; }, palette, name_of(target));
      timed.push_back({name_of(target), size_of(c_.tree.nodes), [&, target] { benchmark::DoNotOptimize(refit_all(target)[0]); }});
    }
    measure("refit_" + kind.name, "sphere", timed);
    const double chain = longest_chain(c_.tree, palette, is_linear, latencies_), lanes_used = used_lanes();
    for (BatchSpeed& r : results_)
      if (r.what == "refit_" + kind.name) {
        if (r.how == "scalar") r.chain_share = chain / r.ns;
        else r.lanes_used = lanes_used;
      }
  }

  // Returns the share of lanes that have a weight vertex of their own in a batch.
  double used_lanes() const {
    const PackedNodes packed(c_.tree, c_.sets);
    double used = 0, taken = 0;
    for (const TreeNode& n : c_.tree.nodes)
      for (int i = 0; i < n.piece_count; ++i) used += c_.tree.pieces[n.first_piece + i].weight_vertex_count;
    for (const NodeBlocks& blocks : {packed.nodes(), packed.pieces()})
      for (const NodeBlock* block = blocks.blocks; block != blocks.blocks + blocks.block_count; ++block)
        for (int e = 0; e < block->set_count; ++e)
          taken += Lanes<float>::count * blocks.sets[block->first_set + e].weight_vertex_count;
    return used / taken;
  }

  // A query that opens a node bounds a wide node's children at a time, from the joints alone. This does so for all wide nodes, and by
  // Algorithm 1 repaired for the same children one by one, which are given the frame's palette.
  void bound_opened_nodes(const NamedPose& pose) {
    const auto palette = make_skinning_palette(c_.mesh, c_.sets, pose.pose, Skinning::spherical);
    const ClusterTree tree(c_);
    ClusterBody body(tree, Skinning::spherical);
    const RigidTransform<double> placement{identity_quaternion<double>(), Point3::Zero()};
    const int wide_nodes = size_of(tree.wide_nodes());
    const RefitVariant& variant = compared_variant("spherical_repaired");
    const auto bound_all = [&] {
      body.begin(pose.pose, placement);
      for (int w = 0; w < wide_nodes; ++w) benchmark::DoNotOptimize(body.wide_node_box(w));
    };
    bound_all();
    const auto deformed = refitlab::skin(c_.mesh, c_.sets, palette, Skinning::spherical);
    std::vector<int> nodes;
    for (int w = 0; w < wide_nodes; ++w)
      for (int i = 0; i < tree.wide_nodes()[w].child_count; ++i) {
        const WideNodeChild& child = tree.child(w, i);
        nodes.push_back(child.node);
        if (child.cluster >= 0) require_in_box(body, w, i, tree.vertices().vertices(child.cluster), deformed);
        else require_in_box(body, w, i, c_.vertices[child.node], deformed);
      }
    measure("bound_opened_nodes", "node",
            {{"scalar", size_of(nodes),
              [&] {
                for (const int n : nodes) benchmark::DoNotOptimize(variant.refit(c_.tree.refit_node(n, palette)));
              }},
             {name_of(best_target()), size_of(nodes), bound_all}},
            pose.name);
  }

  void require_in_box(ClusterBody& body, int wide_node, int i, std::span<const int> vertices,
                      const std::vector<Point3>& deformed) const {
    const Box<float> box = get_box(body.wide_node_boxes(wide_node), i);
    for (const int v : vertices)
      for (int k = 0; k < 3; ++k)
        if (!(box.low[k] <= deformed[v][k] && deformed[v][k] <= box.high[k]))
          fail(
              "child " + std::to_string(i) + " of wide node " + std::to_string(wide_node) + " misses vertex " + std::to_string(v),
              name_of(best_target()));
  }

  void palette() {
    SkinningPalette<double> palette;
    const auto prepare = [&] {
      make_skinning_palette(c_.mesh, c_.sets, pose_.pose, Skinning::spherical, palette);
      benchmark::DoNotOptimize(palette.size());
    };
    measure("skinning_palette", "joint_set", {{"scalar", c_.sets.count(), prepare}});
  }

  template <class Balls>
  void require_no_miss(const Kind& kind, const Balls& balls, const SkinningPalette<double>& palette,
                       const std::string& how) const {
    const auto deformed = refitlab::skin(c_.mesh, c_.sets, palette, kind.skinning);
    for (int n = 0; n < size_of(c_.tree.nodes); ++n) {
      const Ball3<float> ball = balls(n);
      for (const int v : c_.vertices[n])
        if (!((deformed[v] - ball.center.cast<double>()).norm() <= ball.radius))
          fail("refit, " + kind.name + ": node " + std::to_string(n) + " misses vertex " + std::to_string(v), how);
    }
  }

  void measure(const std::string& what, const std::string& item, const std::vector<Timed>& timed) {
    measure(what, item, timed, pose_.name);
  }
  void measure(const std::string& what, const std::string& item, const std::vector<Timed>& timed, const std::string& pose) {
    const auto times = ns_per_item(timed, settings_);
    for (const Timed& t : timed) {
      results_.push_back({c_.mesh.name, pose, what, t.name, item, median(times.at(t.name)),
                          median_ratio(times.at(t.name), times.at("scalar")), 0});
      const BatchSpeed& r = results_.back();
      std::printf("  %-22s %-9s %8.2f ns per %s, 1/%.1f of scalar\n", what.c_str(), r.how.c_str(), r.ns, item.c_str(),
                  1 / r.ratio);
    }
  }

  // Compares spherical with linear refits, done in the same way.
  void compare_refits() {
    for (BatchSpeed& r : results_)
      for (const BatchSpeed& linear : results_)
        if (r.item == "sphere" && linear.what == "refit_linear" && linear.how == r.how) r.to_linear = r.ns / linear.ns;
  }

  SkinningPalette<double> palette_of(const Kind& kind) const {
    return make_skinning_palette(c_.mesh, c_.sets, pose_.pose, kind.skinning);
  }
  template <class T>
  static int size_of(const std::vector<T>& list) {
    return static_cast<int>(list.size());
  }
  [[noreturn]] void fail(const std::string& what, const std::string& how) const {
    throw std::logic_error("batch: " + c_.mesh.name + ": " + what + ", by " + how);
  }

  const AnimatedCharacter& c_;
  const NamedPose& pose_;
  const SpeedSettings settings_;
  const Latencies latencies_;
  PackedVertices packed_;
  BatchRefit batch_;
  std::vector<BatchSpeed> results_;
};

}  // namespace

std::vector<BatchSpeed> run_batch_speed(const AnimatedCharacter& c, const NamedPose& pose, const SpeedSettings& settings) {
  std::cout << "[speed] in batches: " << c.mesh.name << ", " << pose.name << std::endl;
  return BatchExperiment(c, pose, settings).run();
}

void write_batch_speed(const std::vector<BatchSpeed>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "operation"});
  for (const BatchSpeed& r : results) {
    const auto add = [&](const std::string& quantity, double value, const char* unit) {
      file.add({"batch_speed", r.model, r.pose, r.how, "all", quantity, format_number(value), unit, r.what});
    };
    add("ns_per_" + r.item, r.ns, "ns");
    add("time_ratio_to_scalar", r.ratio, "1");
    if (r.to_linear > 0) add("time_ratio_to_linear", r.to_linear, "1");
    if (r.chain_share > 0) add("longest_chain_share", r.chain_share, "1");
    if (r.lanes_used > 0) add("lanes_used", r.lanes_used, "1");
  }
  file.write(path);
}

}  // namespace refitlab
