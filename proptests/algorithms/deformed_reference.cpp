// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every sound refit of affine joints, of morph targets and of joints that scale in two phases, against vertices that are
// skinned exactly and as skin() does. None may be outside, exactly.
#include "algorithms/runtime/refit/deformed_reference.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/certificate.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_character.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/checked_folder.hpp"
#include "proptests/oracles/volume.hpp"

namespace proptests::suite_deformed_reference {
namespace {

using namespace refitlab;
using gen::JointKind;

const char* const kind_names[] = {"rigid", "uniform", "axes", "shear", "mirrored", "flat", "extreme", "mixed"};

// Holds a mesh, its skinning, and what deforms it. Linear skinning has affine joints, other skinning rigid ones and scales.
struct Deformed {
  gen::WidePlan plan = *gen::wide_plan(-1074, 130);
  Skinning skinning = gen::drawn_skinning();
  JointKind kind = *rc::gen::element(JointKind::rigid, JointKind::uniform, JointKind::axes, JointKind::shear, JointKind::mirrored,
                                     JointKind::flat, JointKind::extreme, JointKind::mixed);
  bool scales = *rc::gen::element(true, true, true, false);
  std::mt19937 random{plan.seed};
  SkinnedMesh mesh;
  AffinePose affine;
  Pose pose;
  Deformation deformation;

  Deformed() {
    plan.joints = std::min(plan.joints, 17), plan.influences = std::min(plan.influences, plan.joints);
    mesh = gen::wide_model(plan);
    gen::add_targets(mesh, random);
    if (skinning == Skinning::linear) affine = gen::random_affine_pose(mesh, kind, random);
    else pose = gen::wide_pose(plan, mesh);
    if (skinning != Skinning::linear && scales) deformation.scales = gen::random_scales(mesh, kind, random);
    if (mesh.targets.count > 0) deformation.weights = gen::random_weights(mesh, random);
    RC_TAG(kind_names[static_cast<int>(kind)]);
    RC_CLASSIFY(mesh.targets.count > 0, "morphed");
    RC_CLASSIFY(gen::is_degenerate(plan) || (deformation.is_none() && skinning != Skinning::linear), "degenerate");
  }
  SkinningPalette<double> palette(const JointSets& sets) const {
    return skinning == Skinning::linear ? make_skinning_palette(mesh, sets, affine)
                                        : make_skinning_palette(mesh, sets, pose, skinning);
  }
  Character baked() const { return bake(mesh, {.triangles_per_leaf = static_cast<int>(plan.seed % 3) * 2 + 1}); }
};

bool has(const Ball3<double>& ball, const Point3& v) {
  if (ball.radius == HUGE_VAL) return true;
  const Verdict quick = encloses(Ball3<Interval>{convert<Interval>(ball.center), Interval(ball.radius)}, convert<Interval>(v));
  if (quick != Verdict::undecided) return quick == Verdict::holds;
  return encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, convert<Rational>(v)) == Verdict::holds;
}

Skinning bounded_as(Skinning skinning) { return skinning == Skinning::hejl ? Skinning::spherical : skinning; }
bool bounds(const RefitVariant& variant, Skinning skinning) { return variant.sound && variant.skinning == bounded_as(skinning); }

void check_variants() {
  const Deformed d;
  const Character c = d.baked();
  const auto palette = d.palette(c.sets);
  const auto skinned = skin(c.mesh, c.sets, palette, d.skinning, d.deformation);
  ExactSkin exact(c.mesh, c.sets, palette, d.skinning, d.deformation);
  for (const RefitVariant& variant : compared_variants()) {
    if (!bounds(variant, d.skinning)) continue;
    DeformedReference reference(c, variant.pieces);
    reference.begin(d.deformation);
    FrameRefits frame(c, variant, {.most_joint_sets = 2, .most_in_cut = 3, .children_first = true});
    frame.begin(palette, &reference);
    frame.refit_all();
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
      const Ball3<double> ball = variant.refit(reference.refit_node(n, palette));
      for (const int v : c.vertices[n]) {
        RC_ASSERT(ball.center.allFinite() && ball.radius >= 0);
        RC_ASSERT(exact.is_in(ball, v) && exact.is_in(frame[n], v));
        RC_ASSERT(has(ball, skinned[v]) && has(frame[n], skinned[v]));
      }
    }
  }
}

// Checks volumes other than balls, of three nodes.
void check_volumes() {
  const Deformed d;
  const Character c = d.baked();
  const auto palette = d.palette(c.sets);
  const auto skinned = skin(c.mesh, c.sets, palette, d.skinning, d.deformation);
  ExactSkin exact(c.mesh, c.sets, palette, d.skinning, d.deformation);
  DeformedReference reference(c, Pieces::mixed);
  reference.begin(d.deformation);
  const int nodes = static_cast<int>(c.tree.nodes.size());
  long tried = 0;
  for (const VolumeVariant& variant : volume_variants()) {
    if (variant.skinning != bounded_as(d.skinning)) continue;
    for (const int n : {0, nodes / 2, nodes - 1}) {
      const Volume volume = variant.refit(reference.refit_node(n, palette));
      for (const int v : c.vertices[n])
        RC_ASSERT(oracle::has(volume, exact.exact(v)) && oracle::has(volume, convert<Rational>(skinned[v])));
      tried += oracle::is_all_of_space(volume) ? 0 : 1;
    }
  }
  RC_CLASSIFY(tried > 0, "bounded");
  if (d.skinning != Skinning::dual_quaternion) RC_ASSERT(tried == 15);
}

// Checks that every deformed vertex, exactly and in double, is in the ball of a piece of its joint-set, and in that of the node.
void check_references() {
  const Deformed d;
  const Character c = d.baked();
  const auto stays = make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), Skinning::dual_quaternion);
  ExactSkin exact(c.mesh, c.sets, stays, Skinning::dual_quaternion, d.deformation);
  for (const Pieces kind : {Pieces::node, Pieces::joint_sets, Pieces::mixed, Pieces::many}) {
    DeformedReference reference(c, kind);
    reference.begin(d.deformation);
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
      const RefitNode<double> node = reference.refit_node(n, stays);
      for (const int v : c.vertices[n]) {
        bool is_held = false;
        for (std::size_t i = 0; i < node.pieces.size(); ++i)
          is_held = is_held || (node.pieces[i].joint_set == c.sets.of_vertex(v) && exact.is_in(node.piece_reference(i), v) &&
                                has(node.piece_reference(i), reference.vertex(v)));
        RC_ASSERT(is_held);
        if (!d.deformation.is_none()) RC_ASSERT(exact.is_in(node.reference, v));
      }
    }
  }
}

// Checks weights in intervals: the volumes hold the vertices for all weights that are drawn in them.
void check_ranges() {
  const Deformed d;
  RC_PRE(d.mesh.targets.count > 0);
  const Character c = d.baked();
  const auto palette = d.palette(c.sets);
  std::vector<Slab<double>> ranges;
  std::mt19937 random(d.plan.seed + 1);
  for (const double w : d.deformation.weights) {
    const double other = random() % 4 == 0 ? w : w + std::uniform_real_distribution<double>(-2, 2)(random);
    ranges.push_back({std::min(w, other), std::max(w, other)});
  }
  std::vector<Deformation> samples;
  for (int i = 0; i < 4; ++i) {
    samples.push_back(d.deformation);
    for (std::size_t t = 0; t < ranges.size(); ++t) {
      const double share = std::array{0., 1., 0.5, 0.3}[random() % 4];
      samples.back().weights[t] =
          std::clamp(ranges[t].low + share * (ranges[t].high - ranges[t].low), ranges[t].low, ranges[t].high);
    }
  }
  for (const RefitVariant& variant : compared_variants()) {
    if (!bounds(variant, d.skinning)) continue;
    DeformedReference reference(c, variant.pieces);
    reference.begin(ranges, d.deformation.scales);
    if (!ranges.empty()) {
      auto reversed = ranges;
      reversed[0] = {0.5, 0.25};
      RC_ASSERT(gen::refuses<ModelError>(
          // Whatever follows still belongs to the ranges before.
          [&] { reference.begin(reversed, d.deformation.scales); }));
    }
    std::vector<Ball3<double>> balls;
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n)
      balls.push_back(variant.refit(reference.refit_node(n, palette)));
    for (const Deformation& sample : samples) {
      ExactSkin exact(c.mesh, c.sets, palette, d.skinning, sample);
      for (std::size_t n = 0; n < balls.size(); ++n)
        for (const int v : c.vertices[static_cast<int>(n)]) RC_ASSERT(exact.is_in(balls[n], v));
    }
  }
}

// Holds what a reference takes: weights in intervals, and scales.
struct Begun {
  std::vector<Slab<double>> ranges;
  AffinePose scales;
};

// Returns other ranges and scales than the last, or the last with one number changed.
Begun begun_after(const Begun& last, const Deformed& d, std::mt19937& random) {
  Begun out = last;
  const auto moved = [&](double& x) { x = x == 0 ? std::ldexp(1, d.plan.exponent) : x / 2; };
  switch (random() % 6) {
    case 0:
      for (Slab<double>& range : out.ranges) range.low -= random() % 2 ? 0.5 : 0;
      return out;
    case 1:
      for (Slab<double>& range : out.ranges) range.high += random() % 2 ? 0.5 : 0;
      return out;
    case 2:
      if (!out.scales.empty()) moved(out.scales[random() % out.scales.size()].offset[static_cast<int>(random() % 3)]);
      return out;
    case 3:
      if (!out.scales.empty()) out.scales[random() % out.scales.size()].columns[random() % 3] *= 0.5;
      return out;
    case 4: return out;
    default: break;
  }
  out = {};
  if (random() % 3)
    for (const double w : gen::random_weights(d.mesh, random)) out.ranges.push_back({w, random() % 2 ? w : w + 1});
  if (random() % 3) out.scales = gen::random_scales(d.mesh, d.kind, random);
  return out;
}

// Checks one reference for deformations that follow each other, against a new one for each.
void check_begun_again() {
  const Deformed d;
  const Character c = d.baked();
  std::mt19937 random(d.plan.seed + 2);
  const SkinningPalette<double> none;
  for (const Pieces kind : {Pieces::node, Pieces::joint_sets, Pieces::mixed, Pieces::many}) {
    DeformedReference again(c, kind);
    Begun begun;
    for (int frame = 0; frame < 8; ++frame) {
      begun = begun_after(begun, d, random);
      const auto is_point = [](const Slab<double>& range) { return range.low == range.high; };
      const bool are_points = std::all_of(begun.ranges.begin(), begun.ranges.end(), is_point);
      DeformedReference anew(c, kind);
      again.begin(begun.ranges, begun.scales), anew.begin(begun.ranges, begun.scales);
      for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
        const RefitNode<double> node = again.refit_node(n, none), expected = anew.refit_node(n, none);
        RC_ASSERT(node.reference.center == expected.reference.center && node.reference.radius == expected.reference.radius);
        for (std::size_t i = 0; i < node.pieces.size(); ++i)
          RC_ASSERT(node.piece_reference(i).center == expected.piece_reference(i).center &&
                    node.piece_reference(i).radius == expected.piece_reference(i).radius);
      }
      for (int v = 0; v < static_cast<int>(c.mesh.vertices.size()) && are_points; ++v)
        RC_ASSERT(again.vertex(v) == anew.vertex(v));
    }
  }
}

// Checks that the character made anew is skinned as the deformed one, and bounded by every variant.
void check_deformed_character() {
  const Deformed d;
  const Character c = d.baked();
  double largest = 0;
  for (const Point3& v : deformed_vertices(c.mesh, c.sets, d.deformation))
    largest = std::max(largest, v.lpNorm<Eigen::Infinity>());
  RC_PRE(largest <= largest_coordinate);
  const Character anew = deformed_character(c, d.deformation);
  const auto palette = d.palette(c.sets);
  const auto skinned = skin(c.mesh, c.sets, palette, d.skinning, d.deformation);
  RC_ASSERT(skin(anew.mesh, anew.sets, palette, d.skinning) == skinned);
  ExactSkin exact(anew.mesh, anew.sets, palette, d.skinning);
  for (const RefitVariant& variant : compared_variants()) {
    if (!bounds(variant, d.skinning)) continue;
    const auto balls = refit_all(anew, variant, palette);
    for (std::size_t n = 0; n < balls.size(); ++n)
      for (const int v : anew.vertices[static_cast<int>(n)]) RC_ASSERT(exact.is_in(balls[n], v) && has(balls[n], skinned[v]));
  }
}

// Checks that the balls of the default variants of a character made anew have proofs, which the checker accepts.
void check_certificates() {
  const auto plan = *gen::mesh_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion);
  const JointKind kind = *rc::gen::element(JointKind::uniform, JointKind::axes, JointKind::shear);
  Deformation deformation{gen::random_weights(mesh, random), {}};
  if (skinning != Skinning::linear) deformation.scales = gen::random_scales(mesh, kind, random);
  const Character c = deformed_character(bake(mesh, {}, {Pieces::mixed}), deformation);
  const auto palette = skinning == Skinning::linear
                           ? make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, kind, random))
                           : make_skinning_palette(c.mesh, c.sets, gen::random_pose(c.mesh, random, 0.3), skinning);
  const RefitVariant& variant = default_variant(skinning);
  const int nodes = static_cast<int>(c.tree.nodes.size());
  oracle::CheckedFolder folder;
  for (const int n : {0, nodes / 2, nodes - 1}) {
    const RefitNode<double> node = c.refit_node(n, palette, variant.pieces);
    const Ball3<double> ball = variant.refit(node);
    if (!std::isfinite(ball.radius)) continue;
    folder.add(
        certificate(node, skinning, ball, certified_node(c, n, "a deformed node", std::string(64, '1'), std::string(64, '2'))));
  }
  for (const auto& line : folder.check())
    if (!line.is_accepted()) RC_FAIL(line.text);
}

// Checks that the pairs of two bodies are those of all pairs of skin()'s triangles.
void check_collide() {
  const auto plan = *gen::mesh_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  const Character c = bake(mesh, {.triangles_per_leaf = *rc::gen::element(1, 3)});
  std::vector<const RefitVariant*> sound;
  for (const RefitVariant& v : compared_variants())
    if (v.sound) sound.push_back(&v);
  const RefitVariant& variant = *sound[*rc::gen::inRange<std::size_t>(0, sound.size())];
  Body bodies[] = {{c, variant, {.most_joint_sets = 2}}, {c, variant, {.children_first = true}}};
  std::vector<Point3> skinned[2];
  const auto kind = *rc::gen::element(JointKind::uniform, JointKind::axes, JointKind::shear, JointKind::mirrored);
  for (int i = 0; i < 2; ++i) {
    const AffinePose pose = gen::random_affine_pose(c.mesh, kind, random);
    const std::vector<double> weights = gen::random_weights(c.mesh, random);
    bodies[i].begin(pose, weights);
    if (variant.skinning == Skinning::linear) {
      skinned[i] = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose), variant.skinning, {weights, {}});
    } else {
      const auto [rigid, scales] = split(c.mesh, pose);
      skinned[i] = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, rigid, variant.skinning), variant.skinning,
                        {weights, scales});
    }
  }
  const RigidTransform<double> placement{gen::random_rotation(random, 1), Point3(0.1, 0.2, 0.3)};
  QueryCounts counts;
  const auto found = oracle::sorted(collide({bodies[0]}, {bodies[1], placement}, Query::full, counts));
  for (Point3& v : skinned[1]) v = apply(placement, v);
  for (Point3& v : skinned[0]) v = apply(RigidTransform<double>{}, v);
  const auto expected = oracle::all_pairs(c.mesh.triangles, skinned[0], c.mesh.triangles, skinned[1]);
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  RC_CLASSIFY(!expected.empty(), "touching");
  RC_ASSERT(found == expected);
}

// Checks one body for frames of rigid and of affine joints, deformed or not, against a new one for each.
void check_bodies_begun_again() {
  const auto plan = gen::classified_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  const Character c = bake(mesh);
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion);
  std::vector<const RefitVariant*> variants;
  for (const RefitVariant& v : compared_variants())
    if (bounds(v, skinning)) variants.push_back(&v);
  const RefitVariant& variant = *variants[random() % variants.size()];
  Body again(c, variant);
  for (int frame = 0; frame < 6; ++frame) {
    const auto joint_kind = static_cast<JointKind>(random() % 4);
    const AffinePose affine = gen::random_affine_pose(mesh, joint_kind, random);
    const Pose rigid = gen::random_pose(mesh, random, 0.5);
    const std::vector<double> weights = random() % 2 ? gen::random_weights(mesh, random) : std::vector<double>();
    const AffinePose scales = random() % 2 ? gen::random_scales(mesh, joint_kind, random) : AffinePose();
    const bool is_affine = random() % 2;
    Body anew(c, variant);
    for (Body* body : {&again, &anew})
      if (is_affine) body->begin(affine, weights);
      else body->begin(rigid, {weights, scales});
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n)
      RC_ASSERT(again.ball(n).center == anew.ball(n).center && again.ball(n).radius == anew.ball(n).radius);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) RC_ASSERT(again.triangle(t) == anew.triangle(t));
  }
}

void scaled_joints_and_their_certificates(Suite& t) {
  t.holds("a scale of all joints scales the balls by it, up to rounding", {.number_type = "double", .cases = 20}, [] {
    const auto plan = *gen::mesh_plan();
    std::mt19937 random(plan.seed);
    const Character c = bake(gen::make_mesh(plan));
    const double factor = *rc::gen::element(0.01, 0.5, 3.0);
    AffinePose scales;
    for (const Joint& j : c.mesh.joints) {
      AffineMap<double> map = identity_map<double>();
      for (auto& column : map.columns) column *= factor;
      map.offset = Point3(0, 0, 0);
      scales.push_back(map);
      (void)j;
    }
    Pose pose = gen::random_pose(c.mesh, random, 0.3), scaled = pose;
    for (auto& joint : scaled) joint.translation *= factor;
    for (const RefitVariant& variant : refit_variants()) {
      if (variant.skinning != Skinning::spherical) continue;
      DeformedReference reference(c, variant.pieces);
      reference.begin({{}, scales});
      // The rotation centers are the images' least-squares solutions, about priors that do not scale.
      SkinnedMesh mesh = c.mesh;
      for (Joint& joint : mesh.joints) joint.origin *= factor;
      const auto palette = make_skinning_palette(mesh, c.sets, scaled, variant.skinning);
      const auto before = make_skinning_palette(c.mesh, c.sets, pose, variant.skinning);
      for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
        const double was = variant.refit(c.refit_node(n, before, variant.pieces)).radius,
                     is = variant.refit(reference.refit_node(n, palette)).radius;
        // Near-smallest balls are within 5 % of the smallest.
        RC_ASSERT(is <= was * factor * 1.06 + 1e-9 && is >= was * factor * 0.94 - 1e-9);
      }
    }
  });
  t.holds("the default variants' balls of a character made anew have certificates", {.number_type = "rational", .cases = 60},
          check_certificates);
  t.example("affine joints have certificates of linear skinning alone", {}, [] {
    const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}), {}, {});
    std::mt19937 random(1);
    const auto palette = make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, JointKind::axes, random));
    const auto is_certified = [&](Skinning skinning) {
      try {
        return !certificate(c.refit_node(0, palette, Pieces::node), skinning, {{0, 0, 0}, 1e6}, certified_node(c, 0, "", "", ""))
                    .empty();
      } catch (const std::invalid_argument&) {
        return false;
      }
    };
    return is_certified(Skinning::linear) && !is_certified(Skinning::spherical) && !is_certified(Skinning::dual_quaternion);
  });
}

void ranges_of_weights_that_are_refused(Suite& t) {
  t.example("an interval of weights that ends before it begins, is not finite or too long is refused, whichever end it is", {},
            [] {
              SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
              mesh.targets = {2, std::vector<std::vector<Displacement<double>>>(mesh.vertices.size())};
              mesh.targets.of_vertex[0] = {{1, Point3(0.1, 0, 0)}};
              const Character c = bake(mesh);
              DeformedReference reference(c, Pieces::mixed);
              const auto refusal = [&](const std::vector<Slab<double>>& ranges) -> std::string {
                try {
                  reference.begin(ranges, {});
                } catch (const ModelError& e) {
                  return e.what();
                }
                return "";
              };
              const double nan = std::nan("");
              const std::string infinite = "its weight of morph target 1 is not finite", large = "sum to more than 1e4",
                                reversed = "a range of its weights ends before it begins";
              const std::pair<Slab<double>, std::string> refused[] = {{{nan, 1}, infinite},
                                                                      {{0, nan}, infinite},
                                                                      {{nan, nan}, infinite},
                                                                      {{0, HUGE_VAL}, infinite},
                                                                      {{-HUGE_VAL, 0}, infinite},
                                                                      {{0, -HUGE_VAL}, reversed},
                                                                      {{HUGE_VAL, 0}, reversed},
                                                                      {{0.5, 0.25}, reversed},
                                                                      {{-0.25, -0.5}, reversed},
                                                                      {{0, 10001}, large},
                                                                      {{-10001, 0}, large},
                                                                      {{-10001, 10001}, large},
                                                                      {{-HUGE_VAL, HUGE_VAL}, infinite}};
              std::string wrong;
              for (const auto& [range, reason] : refused)
                if (const std::string said = refusal({{0, 0}, range}); said.find(reason) == std::string::npos)
                  wrong += "'" + said + "', not '" + reason + "'; ";
              for (const Slab<double>& range : {Slab<double>{-1e4, 1e4}, {0, 0}, {-0.5, -0.5}, {-5e-324, 5e-324}})
                wrong += refusal({{0, 0}, range});
              if (refusal({{0, 0}}).find("has 1 weights for 2") == std::string::npos) wrong += "one too few; ";
              if (refusal({{0, 0}, {0, 0}, {0, 0}}).find("has 3 weights for 2") == std::string::npos) wrong += "one too many; ";
              return Checked(wrong.empty(), static_cast<long>(std::size(refused)) + 6, wrong);
            });
}

void what_a_deformation_keeps_and_refuses(Suite& t) {
  t.example("a character without the pieces is refused, and a palette of affine joints where skinning is not linear", {}, [] {
    const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}), {}, {Pieces::mixed});
    std::mt19937 random(1);
    const auto palette = make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, JointKind::axes, random));
    const auto is_refused = [](const auto& work) {
      try {
        work();
        return false;
      } catch (const std::invalid_argument&) {
        return true;
      }
    };
    FrameRefits linear(c, refit_variant("linear_mixed")), spherical(c, refit_variant("control_mixed"));
    linear.begin(palette);
    return is_refused([&] { DeformedReference(c, Pieces::many); }) && is_refused([&] { spherical.begin(palette); }) &&
           !is_refused([&] { DeformedReference(c, Pieces::mixed); });
  });
  t.example("nor are all balls refitted at once by such a palette, or by one that is not measured", {}, [] {
    const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const auto affine = make_skinning_palette(c.mesh, c.sets, AffinePose(c.mesh.joints.size(), identity_map<double>()));
    SkinningPalette<double> by_hand;
    PalettePacks(c.mesh, c.sets, Skinning::spherical).make(reference_pose(c.mesh), by_hand);
    const auto is_refused = [&](const char* variant, const SkinningPalette<double>& palette) {
      return gen::refuses<std::invalid_argument>([&] { refit_all(c, refit_variant(variant), palette); });
    };
    bool ok = is_refused("control_mixed", affine) && is_refused("control_mixed", by_hand);
    ok = ok && refit_all(c, refit_variant("linear"), affine).size() == c.tree.nodes.size();
    by_hand.measure();
    return Checked(ok && !is_refused("control_mixed", by_hand), 4);
  });
  t.example("a deformation that is the last one again keeps the balls, and another one does not", {}, [] {
    SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 6, 3, 1});
    std::mt19937 random(3);
    const Character c = bake(mesh);
    const auto palette = make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), Skinning::spherical);
    DeformedReference reference(c, Pieces::mixed);
    const Deformation one{{}, gen::random_scales(mesh, JointKind::axes, random)},
        other{{}, gen::random_scales(mesh, JointKind::axes, random)};
    const auto radius = [&](const Deformation& d) {
      reference.begin(d);
      return reference.refit_node(0, palette).reference.radius;
    };
    const double first = radius(one), again = radius(one), second = radius(other), third = radius(one);
    return first == again && first == third && first != second && radius({}) == c.tree.nodes[0].reference.radius;
  });
}

}  // namespace

PROPTEST(deformed_reference) {
  const std::map<std::string, double> tags = {{"morphed", 0.6}, {"uniform", 0.05}, {"axes", 0.05},     {"shear", 0.05},
                                              {"flat", 0.05},   {"mixed", 0.05},   {"mirrored", 0.05}, {"extreme", 0.05}};
  t.holds("no sound variant misses a vertex of affine joints, of scaled ones in two phases, or of morph targets",
          {.number_type = "double against rational",
           .cases = 1000,
           .degenerate_at_least = 0.1,
           .degenerate_at_most = 0.5,
           .tags_at_least = tags},
          check_variants);
  t.holds(
      "no box, k-DOP or oriented box misses a vertex of them either",
      {.number_type = "double against rational", .cases = 200, .degenerate_at_most = 0.5, .tags_at_least = {{"bounded", 0.7}}},
      check_volumes);
  t.holds("every deformed vertex is in the ball of a piece, exactly and in double",
          {.number_type = "double against rational", .cases = 200, .degenerate_at_most = 0.5}, check_references);
  t.holds("bounds for weights in intervals hold for every one of them",
          {.number_type = "double against rational", .cases = 150, .degenerate_at_most = 0.5}, check_ranges);
  t.holds("a reference that begins one deformation after the other is in each a new one's, to the last bit",
          {.number_type = "double", .cases = 150, .degenerate_at_most = 0.5}, check_begun_again);
  t.holds("so is a body in frames of rigid and of affine joints, with a deformation and without",
          {.number_type = "double", .cases = 100}, check_bodies_begun_again);
  t.holds("a character made anew is skinned to the last bit as the deformed one, and no sound variant misses it",
          {.number_type = "double against rational", .cases = 150, .degenerate_at_most = 0.5}, check_deformed_character);
  scaled_joints_and_their_certificates(t);
  t.holds("deformed bodies touch where all pairs of skinned triangles say so",
          {.number_type = "double", .cases = 150, .tags_at_least = {{"touching", 0.3}}}, check_collide);
  what_a_deformation_keeps_and_refuses(t);
  ranges_of_weights_that_are_refused(t);
}

}  // namespace proptests::suite_deformed_reference
