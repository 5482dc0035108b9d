// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the slack for rounding: its rates are at least what the code's own operations can be off by, and not much more; the
// scales that they are multiplied by bound what they claim to; and no ball misses, in awkward cases.
//
// The rates are compared with running error bounds of the same templates. In the rates, the errors of weight vertices and blends
// turn a vertex once (palette_rounding.hpp); a running error would follow them into every product. So the templates run on blends
// as they stand, and the blends' share is added by hand.
#include <algorithm>
#include <cstdio>
#include <random>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/refit_case.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/running_error.hpp"

namespace proptests::suite_palette_rounding {
namespace {

using namespace refitlab;
using oracle::error_length;
using Running = oracle::RunningError;
constexpr double u = Running::u;
constexpr int samples = 40000;

// Draws numbers with all digits in use. Some of them are equal or 0 in a third of all draws, where sums are at their largest.
class Draw {
 public:
  Running coordinate() {
    if (std::uniform_int_distribution<int>(0, 2)(random_) == 0)
      return last_ * double(std::uniform_int_distribution<int>(-1, 1)(random_));
    return last_ = std::uniform_real_distribution<double>(-1, 1)(random_);
  }
  Vec<Running, 3> point() { return {coordinate(), coordinate(), coordinate()}; }
  Quaternion<Running> unit() {
    for (;;) {
      Quaternion<double> q;
      for (int i = 0; i < 4; ++i) q[i] = coordinate().value;
      if (squared_norm(q) > 0.01) return convert<Running>(Quaternion<double>(q / norm(q)));
    }
  }
  // Returns a quaternion of unit length, up to 4 u, at most this far from another one.
  Quaternion<Running> near(const Quaternion<Running>& other, double distance) {
    Quaternion<double> q;
    for (int i = 0; i < 4; ++i) q[i] = other[i].value + distance * coordinate().value / 2;
    return convert<Running>(Quaternion<double>(q / norm(q)));
  }

 private:
  std::mt19937_64 random_{2006};
  double last_ = 0.7;
};

double length(const Vec<Running, 3>& v) { return std::hypot(v[0].value, v[1].value, v[2].value); }

// Says whether Gappa proves a script's statement with a bound of this many u.
bool is_proved(const std::string& script, int bound) {
  // The path is relative to the root of the repository.
  std::string text = read_whole("proptests/gappa/" + script + ".g");
  const std::string place = "BOUND";
  const std::size_t at = text.rfind(place);
  if (at == std::string::npos) throw std::runtime_error("proptests/gappa/" + script + ".g: without a BOUND");
  text.replace(at, place.size(), std::to_string(bound) + "b-53");
  FILE* gappa = popen("gappa >/dev/null 2>&1", "w");
  if (!gappa) throw std::runtime_error("gappa could not be started");
  std::fwrite(text.data(), 1, text.size(), gappa);
  return pclose(gappa) == 0;
}

Checked check_elementary() {
  // These bounds are for each component. norm_budget.hpp has rules for the vector.
  const std::pair<const char*, int> bounds[] = {
      {"squared_length", 5}, {"rotate", 24}, {"rotate_scaled", 24}, {"mix_weight", 6}, {"mix_numerator", 27}};
  bool passed = true;
  std::string text;
  for (const auto& [script, bound] : bounds) {
    const bool whole = is_proved(script, bound), less = is_proved(script, bound * 3 / 4);
    text += std::string(script) + " " + std::to_string(bound) + " u" + (whole ? "" : " NOT PROVED") +
            (less ? ", but less too" : "") + "; ";
    passed = passed && whole && !less;
  }
  return Checked(passed, std::size(bounds), text);
}

// Records the greatest share of an allowance that errors make use of. It is at most 1 for soundness, and at least a floor, as
// otherwise the allowance could be halved without anyone noticing. The floor is for cases without translations.
class Share {
 public:
  explicit Share(double at_least) : at_least_(at_least) {}
  void see(double error, double allowance, bool is_at_origin = true) {
    if (error == 0) return;
    double& greatest = is_at_origin ? turned_ : moved_;
    greatest = std::max(greatest, error / allowance), ++count_;
  }
  Checked checked() const {
    char text[120];
    std::snprintf(text, sizeof text, "%.0f %% of the allowance used (with translations %.0f %%), %.0f %% asked for",
                  100 * turned_, 100 * moved_, 100 * at_least_);
    constexpr double all = 1 + 1e-9;  // the bounds themselves are rounded
    return Checked(turned_ <= all && moved_ <= all && turned_ >= at_least_, count_, text);
  }

 private:
  double at_least_, turned_ = 0, moved_ = 0;
  long count_ = 0;
};

// Returns scales of n joints whose quaternions are equal, of this size.
PaletteScales<double> scales(int n, double size) { return {double(n), size, size, 1, 0}; }
// Returns what is left of rates for coordinates of this length and scales of this size, less the shares of blends: so many times
// kappa and ||x||, and so many times the size.
double left(const RoundingRates<double>& rates, double length, double of_length, double of_size, double size) {
  return rates.per_length * length + rates.offset - u * (of_length * length + of_size * size);
}

Checked check_spherical_vertex() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples; ++i) {
    const BlendedJoints<Running> blend{draw.unit(), draw.point() * Running(i % 3)};
    const Vec<Running, 3> x = draw.point();
    const double size = length(blend.center_image);
    const auto placed = turn_and_place<Running>(blend, squared_norm(blend.rotation), x);
    // The error of x is 1 u, and that of the blends n u.
    share.see(error_length(placed), left(rounding_spherical(scales(2, size)).vertex, length(x), 1 + 4, 2, size), size == 0);
  }
  return share.checked();
}

Checked check_linear_vertex() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples; ++i) {
    std::vector<RigidTransform<Running>> transforms;
    const std::size_t n = 1 + i % 4;
    double size = 0;
    for (std::size_t j = 0; j < n; ++j) {
      transforms.push_back({draw.unit(), draw.point() * Running(i % 3)});
      size = std::max(size, length(transforms.back().translation));
    }
    std::vector<Running> w(n, Running(1.0 / double(n)));
    const Vec<Running, 3> v = draw.point();
    const auto placed = blend_linear<Running>({transforms, v, {}, {}}, w, v);
    share.see(error_length(placed), left(rounding_linear(scales(int(n), size)).vertex, length(v), 0, 0, size), size == 0);
  }
  return share.checked();
}

AffineMap<Running> draw_map(Draw& draw, int i) {
  return {{draw.point(), draw.point(), draw.point()}, draw.point() * Running(i % 3)};
}
double matrix_length(const AffineMap<Running>& map) {
  return std::hypot(length(map.columns[0]), length(map.columns[1]), length(map.columns[2]));
}
// Returns scales of n affine joints, with matrices and offsets of these sizes.
PaletteScales<double> affine_scales(std::size_t n, double matrix, double offset) { return {double(n), 0, offset, 1, 0, matrix}; }

Checked check_affine_vertex() {
  Draw draw;
  Share share(0.4);
  for (int i = 0; i < samples; ++i) {
    std::vector<AffineMap<Running>> maps;
    const std::size_t n = 1 + i % 4;
    double matrix = 0, offset = 0;
    for (std::size_t j = 0; j < n; ++j) {
      maps.push_back(draw_map(draw, i));
      matrix = std::max(matrix, matrix_length(maps.back())), offset = std::max(offset, length(maps.back().offset));
    }
    const std::vector<Running> w(n, Running(1.0 / double(n)));
    const Vec<Running, 3> v = draw.point();
    const auto placed = blend_linear<Running>({{}, v, {}, {}, maps, {}}, w, v);
    share.see(error_length(placed), left(rounding_affine(affine_scales(n, matrix, offset)).vertex, length(v), 0, 0, 0),
              offset == 0);
  }
  return share.checked();
}

// Checks the factor by which a radius is stretched, for joints with factors so great that the blended matrix counts.
Checked check_affine_stretch() {
  Draw draw;
  Share share(0.2);
  for (int i = 0; i < samples; ++i) {
    std::vector<AffineMap<Running>> maps;
    const std::size_t n = 1 + i % 4;
    double matrix = 0;
    for (std::size_t j = 0; j < n; ++j) {
      maps.push_back(draw_map(draw, 0));
      matrix = std::max(matrix, matrix_length(maps.back()));
    }
    const std::vector<Running> w(n, Running(1.0 / double(n))), factors(n, Running(100.0));
    const Running stretch = root(blended_squared_stretch<Running>(maps, factors, w)) * Running(0.7);
    share.see(stretch.error, 0.7 * rounding_affine(affine_scales(n, matrix, 0)).weight_vertices.per_radius);
  }
  return share.checked();
}

Checked check_dual_quaternion_vertex() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples; ++i) {
    const double translation = double(i % 4);
    const BlendedDuals<Running> blend{draw.unit(), draw.unit() * Running(translation / 2)};
    const Vec<Running, 3> v = draw.point();
    const auto placed = move_rigidly<Running>(blend, squared_norm(blend.rotation), v);
    // The blends have errors of n each, which turn by 2 n and move by n of d and n of q.
    share.see(error_length(placed), left(rounding_dual_quaternion(scales(1, translation)).vertex, length(v), 2, 2, translation),
              translation == 0);
  }
  return share.checked();
}

RoundingRates<double> difference(const PaletteRounding<double>& r) {
  return {r.weight_vertices.per_length - r.vertex.per_length, 0, r.weight_vertices.offset - r.vertex.offset};
}

// Draws simplices of near weight vertices of unit length, and returns their control balls by way of the halving code.
template <class Piece, class WeightVertex, class MakeWeightVertex>
std::vector<Ball3<Running>> control_balls_of(Piece piece, double distance, Draw& draw, MakeWeightVertex make) {
  ControlLists<Running> lists;
  std::vector<WeightVertex> weight_vertices;
  const Quaternion<Running> first = draw.unit();
  for (int k = 0; k < 3; ++k) weight_vertices.push_back(make(draw.near(first, distance)));
  ControlHull<Piece>(piece, weight_vertices, lists).cover(3, 0);
  return lists.cap.balls;
}

Checked check_spherical_weight_vertices() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples / 4; ++i) {
    const Vec<Running, 3> x = draw.point();
    double size = 0;
    const auto balls = control_balls_of<SphericalPiece<Running>, BlendedJoints<Running>>(
        SphericalPiece<Running>(x, Running(0)), i % 2 ? 0.1 : 0.7, draw, [&](const Quaternion<Running>& q) {
          const BlendedJoints<Running> weight_vertex{q, draw.point() * Running(i % 3)};
          size = std::max(size, length(weight_vertex.center_image));
          return weight_vertex;
        });
    // The error of x is 1. Weight vertices have errors of n + 4, which turn by twice that, and a cap's angle by more: 2.25 times
    // is allowed for.
    const double allowance = left(difference(rounding_spherical(scales(1, size))), length(x), 1 + 2.25 * 5, 5, size);
    for (const auto& b : balls) share.see(error_length(b.center), allowance, size == 0);
  }
  return share.checked();
}

Checked check_cap() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples / 4; ++i) {
    const Quaternion<Running> first = draw.unit();
    std::vector<Quaternion<Running>> unit;
    for (int k = 0; k < 3; ++k) {
      unit.push_back(draw.near(first, i % 3 ? 0.6 : 0.05));
      // Their normalisation has this error.
      for (int c = 0; c < 4; ++c) unit.back()[c].error = 5 * u * std::abs(unit.back()[c].value);
    }
    const std::span<const Quaternion<Running>> span(unit);
    Quaternion<Running> direction = mean_center(span);
    // Any direction is allowed.
    for (int c = 0; c < 4; ++c) direction[c].error = 0;
    const RotationBound<Running> bound = bound_rotations(span, direction);
    const Vec<Running, 3> x = draw.point();
    const Vec<Running, 3> offset = rotate<Running>(bound.apex, x) * bound.center_ratio;
    const Running radius = bound.radius_ratio * norm(x);
    const double allowance = left(difference(rounding_spherical(scales(1, 0))), length(x), 1 + 2.25 * 5, 0, 0);
    share.see(error_length(offset) + radius.error, allowance);
  }
  return share.checked();
}

Checked check_dual_quaternion_weight_vertices() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples / 4; ++i) {
    const Vec<Running, 3> p = draw.point();
    const double translation = double(i % 4);
    const auto balls = control_balls_of<DualQuaternionPiece<Running>, BlendedDuals<Running>>(
        DualQuaternionPiece<Running>(p, Running(0)), i % 2 ? 0.1 : 0.6, draw, [&](const Quaternion<Running>& q) {
          return BlendedDuals<Running>{q, draw.unit() * Running(translation / 2)};
        });
    const double allowance =
        left(difference(rounding_dual_quaternion(scales(1, translation))), length(p), 2 * 5, 2 * 5, translation);
    for (const auto& b : balls) share.see(error_length(b.center), allowance, translation == 0);
  }
  return share.checked();
}

// Checks the radius that a distance and a radius are raised to, relative to their sum, against the sixteen u of rounded_up.
Checked check_measured_radius() {
  Draw draw;
  Share share(0.5);
  for (int i = 0; i < samples; ++i) {
    const Vec<Running, 3> a = draw.point(), b = draw.point() * Running(1.0 / (1 + i % 7));
    const Running radius = norm<Running, 3>(a - b) + Running(0.1 * (i % 3)), raised = radius + Running(0);
    if (radius.value == 0) continue;
    const Ball3<double> up = rounded_up(Ball3<double>{{0, 0, 0}, radius.value});
    share.see(raised.error, up.radius - radius.value);
  }
  return share.checked();
}

Rational as_rational(double x) { return Rational(x); }

// Returns a case with rotations off unit length, as those read from floats are, or by all that is accepted. The images and dual
// parts stay.
gen::RefitCase with_stretched_rotations(gen::RefitCase c) {
  for (gen::SetCase& set : c.sets)
    for (auto& transform : set.palette.transforms)
      transform.rotation = transform.rotation * *rc::gen::element(Rational(1), Rational(1 + 0x1p-22), Rational(1 - 0x1p-22),
                                                                  Rational(1 + 0.4999e-6), Rational(1 - 0.4999e-6));
  return c;
}

// Checks the scales of the joint-sets of awkward cases in doubles, in exact numbers.
void check_scales() {
  const gen::RefitCase c = with_stretched_rotations(gen::rounded_to_double(*gen::refit_case(gen::Turns::any)));
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  const gen::NodeOf<double> storage(c);
  const SkinningPalette<double>& palette = storage.node().palette;
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const PaletteScales<double>& scales = palette.scales(s);
    const auto& exact = c.sets[s].palette;
    const std::size_t n = exact.transforms.size();
    RC_ASSERT(scales.joints == double(n));
    // This is at least the squared length of a quaternion.
    const Rational longest = sq(1 + as_rational(scales.unit_defect));
    for (std::size_t j = 0; j < n; ++j) {
      RC_ASSERT(squared_norm(exact.center_images[j]) <= sq(as_rational(scales.center_image)));
      RC_ASSERT(squared_norm(exact.transforms[j].translation) * longest <= sq(as_rational(scales.translation)));
      const Rational defect = squared_norm(exact.transforms[j].rotation) - 1;
      RC_ASSERT((defect < 0 ? Rational(-defect) : defect) <= as_rational(scales.unit_defect));
    }
    const Rational least = sq(Rational(1) / as_rational(scales.inverse_blend));
    const Rational shortest = Rational(least_squared_length<double>()) / 2;
    RC_ASSERT(least >= shortest * Rational(0.999));
    if (least <= shortest) continue;  // nothing is claimed of smaller blends
    std::vector<std::vector<Rational>> weights = c.sets[s].weights.vertices;
    weights.push_back(std::vector<Rational>(n, Rational(1) / Rational(long(n))));
    weights.push_back(*gen::convex_weights(static_cast<int>(n)));
    for (const auto& w : weights) {
      Quaternion<Rational> blend = exact.transforms[0].rotation * w[0];
      for (std::size_t j = 1; j < n; ++j) blend = blend + exact.transforms[j].rotation * w[j];
      // A computed blend may be shorter by n u.
      const Rational shorter = Rational(1) - Rational(long(n)) * as_rational(u) * as_rational(scales.inverse_blend);
      RC_ASSERT(squared_norm(blend) * sq(shorter) >= least * longest);
    }
  }
}

// Checks joints that turn alike, whose blends are of unit length.
Checked check_kappa_of_many() {
  long cases = 0;
  for (const int n : {1, 2, 64, 1000, 10000}) {
    const std::vector<RigidTransform<double>> transforms(static_cast<std::size_t>(n), {{0.6, 0, 0.8, 0}, Vec<double, 3>::Zero()});
    const std::vector<Vec<double, 3>> images(transforms.size(), Vec<double, 3>::Zero());
    const Rational kappa = as_rational(measure_palette<double>(transforms, images).inverse_blend);
    const Rational squared = squared_norm(convert<Rational>(transforms[0].rotation));
    const Rational computed = Rational(1) - Rational(long(n)) * as_rational(u);
    ++cases;
    if (sq(kappa * computed) * squared < 1) return Checked(false, cases, std::to_string(n) + " joints");
  }
  return Checked(true, cases);
}

// Checks every sound variant of a kind of skinning, and takes its ball as it stands.
void check_no_miss(Skinning skinning) {
  const gen::RefitCase c = with_stretched_rotations(gen::rounded_to_double(*gen::refit_case(gen::Turns::any)));
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  const gen::NodeOf<double> storage(c);
  for (const RefitVariant& variant : compared_variants()) {
    if (!variant.sound || variant.skinning != skinning) continue;
    const Ball3<double> ball = variant.refit(storage.node());
    // Such a ball is all of space.
    if (ball.radius == HUGE_VAL) continue;
    RC_ASSERT(ball.center.allFinite() && std::isfinite(ball.radius));
    const Ball3<Rational> exact{convert<Rational>(ball.center), Rational(ball.radius)};
    const Ball3<float> small = rounded_outward(ball);
    const Ball3<Rational> of_floats{convert<Rational>(Point3(small.center.cast<double>())), Rational(double(small.radius))};
    RC_ASSERT(encloses(of_floats, exact) == Verdict::holds);
    for (const auto& sample : gen::samples(c, skinning, ball.center))
      if (const auto v = gen::skinned(c, sample, skinning)) RC_ASSERT(encloses(exact, *v) == Verdict::holds);
  }
}

// Checks all nodes of a model in a pose: what a variant adds to its ball is at least what its pieces' rates ask for; and the
// node's reference ball, and that of one of its joint-set's pieces, have each vertex, exactly.
Checked check_nodes() {
  const auto c = bake_animated(make_snake(24));
  const Pose pose = c.clips[0].sample(0.37 * c.clips[0].duration);
  long pieces = 0, vertices_alone = 0, too_little = 0, outside = 0;
  for (const RefitVariant& variant : compared_variants()) {
    if (!variant.sound) continue;
    const auto palette = make_skinning_palette(c.mesh, c.sets, pose, variant.skinning);
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); n += 3) {
      const RefitNode<double> node = c.refit_node(n, palette, variant.pieces);
      const double added = variant.refit(node).radius - variant.refit_as_computed(node).radius;
      for (std::size_t i = 0; i < node.pieces.size(); ++i) {
        const NodePiece& set = node.pieces[i];
        const Ball3<double>& reference = node.piece_reference(i);
        const bool is_alone = reference.radius == 0 && set.weight_vertex_count == 1;
        const PaletteRounding<double>& rounding = palette.rounding(set.joint_set, variant.skinning);
        const RoundingRates<double>& rates = is_alone ? rounding.vertex : rounding.weight_vertices;
        const Point3 origin = variant.skinning == Skinning::spherical ? palette.rotation_center(set.joint_set) : Point3(0, 0, 0);
        const double length = (reference.center - origin).norm() + reference.radius;
        too_little += added < 0.999 * (rates.per_length * length + rates.per_radius * reference.radius + rates.offset);
        ++pieces, vertices_alone += is_alone;
      }
      for (const int v : c.vertices[n]) {
        const auto has = [&](const Ball3<double>& ball) {
          return encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)},
                          convert<Rational>(c.mesh.vertices[v])) == Verdict::holds;
        };
        bool in_piece = false;
        for (std::size_t i = 0; i < node.pieces.size(); ++i)
          in_piece = in_piece || (node.pieces[i].joint_set == c.sets.of_vertex(v) && has(node.piece_reference(i)));
        outside += !in_piece || !has(node.reference);
      }
    }
  }
  return Checked(too_little == 0 && outside == 0 && vertices_alone > 0 && vertices_alone < pieces, pieces,
                 std::to_string(vertices_alone) + " pieces are vertices; " + std::to_string(too_little) +
                     " nodes add too little, " + std::to_string(outside) + " vertices are outside");
}

}  // namespace

PROPTEST(palette_rounding) {
  const Options options{.number_type = "running error of double"};
  t.example("Gappa proves the elementary bounds, and not three quarters of them", {.number_type = "double"}, check_elementary);
  t.example("a vertex under spherical blending is off by no more than its rate, and by half", options, check_spherical_vertex);
  t.example("a vertex under linear blending is off by no more than its rate, and by half", options, check_linear_vertex);
  t.example("a vertex under linear blending by affine joints is off by no more than its rate, and by two fifths", options,
            check_affine_vertex);
  t.example("what a radius is stretched by is off by no more than its rate, and by a fifth", options, check_affine_stretch);
  t.example("a vertex under dual quaternion blending is off by no more than its rate, and by half", options,
            check_dual_quaternion_vertex);
  t.example("control points of degree 3 are off by no more than the weight vertices' rate, and by half", options,
            check_spherical_weight_vertices);
  t.example("a cap's center and radius are off by no more than the weight vertices' rate", options, check_cap);
  t.example("control points of dual quaternions are off by no more than the weight vertices' rate, and by half", options,
            check_dual_quaternion_weight_vertices);
  t.example("a measured radius is off by no more than it is raised", options, check_measured_radius);
  t.holds("the scales of a palette bound its lengths, its defects and all of its blends",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5}, check_scales);
  t.example("kappa is that of blends as computed, which are shorter by a rounding for each joint, of thousands of them", options,
            check_kappa_of_many);
  t.example("every variant adds at least what its pieces ask for, and the reference balls have their vertices", {}, check_nodes);
  t.example("what a vertex loses depends on no radius, in any skinning", {}, [] {
    const PaletteScales<double> scales{4, 2, 3, 1.5, 1e-16, 5};
    const PaletteRoundings<double> rigid = roundings_of(scales), affine = affine_roundings_of(scales);
    for (const PaletteRounding<double>* rounding : {&rigid[0], &rigid[1], &rigid[2], &affine[0]})
      if (rounding->vertex.per_radius != 0 || !(rounding->vertex.per_length < 1e-13)) return false;
    return true;
  });
  const Options awkward{
      .number_type = "double against rational", .cases = 400, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5};
  t.holds("no ball of a linear variant misses an exactly skinned vertex of an awkward case, nor rounded to float", awkward,
          [] { check_no_miss(Skinning::linear); });
  t.holds("no ball of a spherical variant misses an exactly skinned vertex of an awkward case, nor rounded to float", awkward,
          [] { check_no_miss(Skinning::spherical); });
  t.holds("no ball of a dual quaternion variant misses an exactly skinned vertex of an awkward case, nor rounded to float",
          awkward, [] { check_no_miss(Skinning::dual_quaternion); });
}

}  // namespace proptests::suite_palette_rounding
