// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that each variant is what its name and description say: these pieces, this algorithm, these balls.
#include <algorithm>
#include <set>

#include "algorithms/bake/bake.hpp"
#include "algorithms/bake/build_pieces.hpp"
#include "algorithms/methods/refit/algorithm1_printed.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "algorithms/runtime/refit/control_hull.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_variants {
namespace {

using namespace refitlab;
using Node = RefitNode<double>;

template <class Policy>
Ball3<double> linear(const Node& node) {
  ControlLists<double> lists;
  return refit_linear<Policy>(node, lists);
}
template <class Policy>
Ball3<double> control(const Node& node) {
  ControlLists<double> lists;
  return refit_control_hull<Policy>(node, lists);
}
template <class Policy>
Ball3<double> dual(const Node& node) {
  ControlLists<double> lists;
  return refit_dual_quaternion<Policy>(node, lists);
}
template <class Policy>
Ball3<double> repaired(const Node& node) {
  RefitLists<double> lists;
  return refit_algorithm1_repaired<Policy>(node, lists);
}
template <class Policy, Signs signs>
Ball3<double> printed(const Node& node) {
  RefitLists<double> lists;
  return refit_algorithm1_printed<Policy>(node, signs, lists);
}

struct Named {
  const char* name;
  Skinning skinning;
  Pieces pieces;
  Refit as_computed;
  bool sound = true;
};

// This is what the names promise, written by hand: taken from the variants themselves, it would agree with any of their errors.
const Named expected_variants[] = {
    {"linear", Skinning::linear, Pieces::node, linear<MeanBalls>},
    {"linear_pieces", Skinning::linear, Pieces::joint_sets, linear<SmallestBalls>},
    {"linear_pieces_mean", Skinning::linear, Pieces::joint_sets, linear<MeanBalls>},
    {"linear_pieces_near", Skinning::linear, Pieces::joint_sets, linear<NearSmallestBalls>},
    {"linear_mixed", Skinning::linear, Pieces::mixed, linear<NearSmallestBalls>},
    {"spherical_printed", Skinning::spherical, Pieces::node, printed<MeanBalls, Signs::of_matrices>, false},
    {"spherical_printed_signed", Skinning::spherical, Pieces::node, printed<MeanBalls, Signs::of_skinning>, false},
    {"spherical_printed_miniball", Skinning::spherical, Pieces::node, printed<SmallestBalls, Signs::of_skinning>, false},
    {"spherical_repaired", Skinning::spherical, Pieces::node, repaired<MeanBalls>},
    {"spherical_miniball", Skinning::spherical, Pieces::node, repaired<SmallestBalls>},
    {"control_mean", Skinning::spherical, Pieces::node, control<MeanBalls>},
    {"control_miniball", Skinning::spherical, Pieces::node, control<SmallestBalls>},
    {"control_sets_near", Skinning::spherical, Pieces::joint_sets, control<NearSmallestBalls>},
    {"control_sets_miniball", Skinning::spherical, Pieces::joint_sets, control<SmallestBalls>},
    {"control_mixed", Skinning::spherical, Pieces::mixed, control<NearSmallestBalls>},
    {"control_many_pieces", Skinning::spherical, Pieces::many, control<SmallestBalls>},
    {"dual_quaternion_control_mean", Skinning::dual_quaternion, Pieces::node, dual<MeanBalls>},
    {"dual_quaternion_control_near", Skinning::dual_quaternion, Pieces::joint_sets, dual<NearSmallestBalls>},
    {"dual_quaternion_control_miniball", Skinning::dual_quaternion, Pieces::joint_sets, dual<SmallestBalls>},
    {"dual_quaternion_mixed", Skinning::dual_quaternion, Pieces::mixed, dual<NearSmallestBalls>},
};

// Says whether two balls are the same, exactly. Two that are undefined are the same.
bool same(const Ball3<double>& a, const Ball3<double>& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return equal(a.radius, b.radius) && equal(a.center[0], b.center[0]) && equal(a.center[1], b.center[1]) &&
         equal(a.center[2], b.center[2]);
}

std::string fault_of_piece_counts(const Character& c, const SkinningPalette<double>& palette) {
  const PieceTable sets = build_pieces(c.tree, c.vertices, c.mesh, c.sets, {}),
                   mixed = build_pieces(c.tree, c.vertices, c.mesh, c.sets,
                                        {.pieces_per_joint_set = 4. / 3, .vertices_per_control_point = 2}),
                   clusters = build_pieces(c.tree, c.vertices, c.mesh, c.sets, {.most_pieces = 512});
  const auto differs = [](const Node& a, const Node& b) {
    if (a.pieces.size() != b.pieces.size()) return true;
    for (std::size_t i = 0; i < a.pieces.size(); ++i)
      if (a.pieces[i].joint_set != b.pieces[i].joint_set || a.pieces[i].weight_vertex_count != b.pieces[i].weight_vertex_count ||
          !same(a.piece_reference(i), b.piece_reference(i)))
        return true;
    return false;
  };
  for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); n += n < 40 ? 1 : 23) {
    if (differs(c.refit_node(n, palette, Pieces::node), c.tree.refit_node(n, palette))) return "node";
    if (differs(c.refit_node(n, palette, Pieces::joint_sets), sets.refit_node(c.tree, n, palette))) return "joint_sets";
    if (differs(c.refit_node(n, palette, Pieces::mixed), mixed.refit_node(c.tree, n, palette))) return "mixed";
    if (differs(c.refit_node(n, palette, Pieces::many), clusters.refit_node(c.tree, n, palette))) return "clusters";
  }
  return "";
}

// Holds the snake in its wave.
struct Posed {
  AnimatedCharacter character = bake_animated(make_snake(24));
  SkinningPalette<double> palette(Skinning skinning) const {
    return make_skinning_palette(character.mesh, character.sets, character.clips[0].sample(0.37), skinning);
  }
  int count() const { return static_cast<int>(character.tree.nodes.size()); }
};
const Posed& snake() {
  static const Posed posed;
  return posed;
}

}  // namespace

PROPTEST(variants) {
  t.example("each variant is the algorithm, over the pieces and with the balls that it is named after, to the last bit",
            {.number_type = "double"}, [] {
              std::string wrong;
              long balls = 0;
              for (const RefitVariant& variant : compared_variants())
                if (std::none_of(std::begin(expected_variants), std::end(expected_variants),
                                 [&](const Named& expected) { return variant.name == expected.name; }))
                  wrong += variant.name + " is not in expected_variants; ";
              for (const Named& expected : expected_variants) {
                const RefitVariant& variant = compared_variant(expected.name);
                const auto palette = snake().palette(expected.skinning);
                bool good =
                    variant.skinning == expected.skinning && variant.pieces == expected.pieces && variant.sound == expected.sound;
                for (int n = 0; n < snake().count(); n += n < 100 ? 1 : 37, ++balls) {
                  const Node node = snake().character.refit_node(n, palette, expected.pieces);
                  const Ball3<double> computed = variant.refit_as_computed(node), ball = variant.refit(node);
                  good =
                      good && same(computed, expected.as_computed(node)) &&
                      (expected.sound ? ball.radius > computed.radius && ball.center == computed.center : same(ball, computed));
                }
                if (!good) wrong += std::string(expected.name) + "; ";
              }
              return Checked(wrong.empty(), balls, wrong);
            });
  t.example(
      "a smallest ball is no larger than a near-smallest one of the same pieces, that no more than 5 % larger, and no mean "
      "ball is smaller",
      {.number_type = "double"}, [] {
        long balls = 0, smaller = 0;
        const auto check = [&](Skinning skinning, Pieces pieces, Refit smallest, Refit near, Refit mean) {
          const auto palette = snake().palette(skinning);
          bool good = true;
          for (int n = 0; n < snake().count(); n += n < 100 ? 1 : 37, ++balls) {
            const Node node = snake().character.refit_node(n, palette, pieces);
            const double r = smallest(node).radius;
            good = good && r <= near(node).radius * (1 + 1e-12) && near(node).radius <= 1.05 * r * (1 + 1e-12) &&
                   r <= mean(node).radius * (1 + 1e-12);
            smaller += r < mean(node).radius * (1 - 1e-6);
          }
          return good;
        };
        bool good = true;
        for (const Pieces pieces : {Pieces::node, Pieces::joint_sets, Pieces::mixed}) {
          good = good && check(Skinning::linear, pieces, linear<SmallestBalls>, linear<NearSmallestBalls>, linear<MeanBalls>);
          good =
              good && check(Skinning::spherical, pieces, control<SmallestBalls>, control<NearSmallestBalls>, control<MeanBalls>);
          good = good && check(Skinning::dual_quaternion, pieces, dual<SmallestBalls>, dual<NearSmallestBalls>, dual<MeanBalls>);
        }
        return Checked(good && smaller * 10 > balls, balls);
      });
  t.example("the kinds of pieces are those that are documented", {}, [] {
    const std::string fault = fault_of_piece_counts(snake().character, snake().palette(Skinning::spherical));
    return Checked(fault.empty(), snake().count(), fault);
  });
  t.holds("the kinds of pieces are those that are documented, of any mesh", {.cases = 30}, [] {
    const auto c = bake(gen::make_mesh(*gen::mesh_plan()));
    const auto palette = make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), Skinning::spherical);
    RC_ASSERT(fault_of_piece_counts(c, palette) == "");
  });
  t.example("the defaults are the mixed ones, and no two variants share a name", {}, [] {
    std::set<std::string> names;
    for (const RefitVariant& variant : compared_variants()) names.insert(variant.name);
    return default_variant(Skinning::linear).name == "linear_mixed" &&
           default_variant(Skinning::spherical).name == "control_mixed" &&
           default_variant(Skinning::hejl).name == "control_mixed" &&
           default_variant(Skinning::dual_quaternion).name == "dual_quaternion_mixed" &&
           names.size() == compared_variants().size();
  });
}

}  // namespace proptests::suite_variants
