// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the budgets of rounding in float of the batch refit, of the motion bound, and of the boxes in float that collisions
// compare. It works as float_budgets.cpp does, for kernels whose steps are repeated here with the templates that they call.
#include <random>

#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/refit_kernel.hpp"
#include "algorithms/runtime/collide/affine_boxes.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/cluster_pairs.hpp"
#include "algorithms/runtime/collide/motion_bound_lanes.hpp"
#include "algorithms/runtime/collide/motion_bound_packs.hpp"
#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/collide/pose_change_kernel.hpp"
#include "algorithms/runtime/skinning/palette_rounding.hpp"
#include "lemmas/a1_affine_image.hpp"
#include "lemmas/b9_pose_change.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/cap_budget.hpp"
#include "proptests/oracles/derived_budgets.hpp"
#include "proptests/oracles/norm_budget.hpp"
#include "proptests/oracles/rounded_scales.hpp"

namespace proptests::suite_bound_budgets {
namespace {

using namespace refitlab;
using oracle::Budget;
using oracle::DerivedBudgets;
using oracle::of_length;
using oracle::rounded_scales;
using oracle::whole;
constexpr double u = Budget::u;
// This stands in place of 0, with which sums would be exact.
constexpr double tiny = 1e-30;

// Returns a vector that is rounded to float.
template <int D>
Vec<Budget, D> rounded_input(double length) {
  return of_length<0, D>(length, u * length);
}

// --- The refit ---

// Returns the error of a blend of vectors that are rounded.
template <int D>
double error_of_blend(int joints) {
  return oracle::error_of_blend<D>(joints, u);
}

// Returns what Algorithm 1 may lose per ||x|| and kappa = 1 / min ||q'_k||.
double error_of_cap(int joints, double kappa) {
  // p, r_c and their difference are rounded: 2 u ||x|| + 2 u ||r_c||. The centers are measured from the ball's center less the
  // offset, which is at most 2 ||x|| and the center images.
  return (oracle::error_of_cap(error_of_blend<4>(joints) * kappa + oracle::error_of_unit(), 2 * u) + 2) / kappa;
}

// Returns the error of r, which joints stretch to s r: of the product, of the sums with the slack and with a distance, and of the
// sum with r.
double error_of_added_stretch(double added) {
  const Budget product = Budget(added) * Budget(1, 0, tiny);
  return (product + Budget(tiny) + Budget(tiny) + Budget(1)).in_u();
}

Checked check_refit() {
  DerivedBudgets budgets;
  for (const int n : {2, 3, 4, 8, 64})
    for (const double kappa : {1.0, 1.5, 16.0}) {
      char name[80];
      std::snprintf(name, sizeof name, "%d joints, per kappa |x| at kappa %g", n, kappa);
      budgets.add(name, error_of_cap(n, kappa), algorithm1_slack(n) / u);
    }
  budgets.add("1 joint, per |x|", whole(rotate<Budget>(rounded_input<4>(1), of_length<0, 3>(1, 2 * u))).in_u() + 2,
              algorithm1_slack(1) / u);
  for (const int n : {1, 2, 3, 4, 8, 64}) {
    // The unit is the size max ||r|| + 2 ||r_c||. The blended center images and the ball's center less the offset add to the
    // error; r_c has 2 in x, and so in the offset and in the radius.
    budgets.add(std::to_string(n) + " joints, per size", std::max(error_of_blend<3>(n) + 2, 2.0 * 2), algorithm1_slack(n) / u);
    // In linear blending the rows are rounded, which is sqrt 3 ||p|| of the image, and so is a row's dot product, of three
    // roundings each.
    const Vec<Budget, 3> p = rounded_input<3>(1), row = rounded_input<3>(1);
    const double image = std::sqrt(3.0) * (dot(row, p) + Budget(tiny, 0, 0)).in_u();
    const double translation = 1 + (Budget(tiny, 0, 0) + Budget(1, 0, 0)).in_u();
    // This is the error of the blends, and of the ball's center less that.
    const double more = error_of_blend<3>(n) - 1 + 1;
    budgets.add(std::to_string(n) + " joints, linear, per |p|", image + more, linear_refit_slack(n) / u);
    budgets.add(std::to_string(n) + " joints, linear, per |t|", translation + more, linear_refit_slack(n) / u);
    // The rows of affine joints have other lengths, whose squares add up to F^2.
    budgets.add(std::to_string(n) + " joints, affine, per F |p|", image / std::sqrt(3.0) + more, linear_refit_slack(n) / u);
  }
  for (const double s : {0.0, 0.01, 0.5, 1.0, 1.5, 4.0, 1000.0}) {
    const double added = added_stretch(s);
    budgets.add("stretched by " + std::to_string(s), error_of_added_stretch(std::abs(added)), (added - (s - 1)) / u);
  }
  // The errors of a distance and of sums of radii are relative to the radius.
  const Vec<Budget, 3> difference = of_length<0, 3>(1, u);
  const Budget squared = squared_norm(difference), far = root(Budget(1, squared.error, 1));
  const Budget whole_radius = (far + Budget(tiny, 0, tiny) + Budget(tiny, 0, tiny)) * Budget(1 + 2 * u);
  budgets.add("per radius", whole_radius.in_u() + 1, (refit_radius_stretch - 1) / u);
  return budgets.checked();
}

// --- The motion bound ---

// Each quaternion whose squared length is off by 1e-6 turns with an error of 2e-6.
constexpr double stretch = 2e-6 / u;

// Returns the error of an image under a joint that the placement has turned, per ||f|| and per ||t||.
template <class Image>
double error_of_image(double f, double t, const Image& image) {
  const RigidTransform<Budget> placement{rounded_input<4>(1), of_length<0, 3>(0)},
      joint{rounded_input<4>(1), rounded_input<3>(t)};
  return image(compose(placement, joint), rounded_input<3>(f)) + 3 * stretch;
}
double image_by_quaternion(const RigidTransform<Budget>& joint, const Vec<Budget, 3>& f) { return whole(apply(joint, f)).in_u(); }
// Returns the same for images by matrices. A row has three entries, each with an error of its own, and a length of 1; so have the
// images' coordinates. An error of the quaternion has the same effect.
double image_by_matrix(const RigidTransform<Budget>& joint, const Vec<Budget, 3>& f) {
  const Budget q = whole(joint.rotation), v = whole(f);
  const double of_quaternion = 2 * (2 * q.error + q.error * q.error) * (v.most + v.error);
  double of_entry = 0;
  for (const auto& row : rotation_rows<oracle::PlainBudget>(oracle::exact<4>(q)))
    for (int i = 0; i < 3; ++i) of_entry = std::max(of_entry, row[i].error);
  const Vec<Budget, 3> row = of_length<0, 3>(1, std::sqrt(3.0) * of_entry);
  return std::sqrt(3.0) * (dot(row, f) + joint.translation[0]).in_u() + of_quaternion / u;
}

// Returns the error of A of as many images as a pack takes, relative to itself: n sum ||y_k||^2 is at most n A^2.
double error_of_spread() {
  const int n = most_motion_bound_joints;
  Vec<Budget, 3> sum = of_length<0, 3>(tiny);
  Budget squares(tiny, 0, 0);
  for (int k = 1; k < n; ++k) {
    const Vec<Budget, 3> y = of_length<0, 3>(1 / std::sqrt(n - 1.0), u / std::sqrt(n - 1.0));
    sum = sum + y, squares = squares + squared_norm(y);
  }
  return squared_spread_of_sums(Budget(n), squares, sum).in_u();
}

// Returns the error of a coordinate of images that are shrunk by least weights, which are rounded, beside that of the images.
double error_of_shrunk(int n) {
  const Budget image(1, 0, tiny);
  Budget at_least(tiny, 0, 0);
  for (int k = 0; k < n; ++k) at_least = at_least + Budget(1.0 / n, 0, tiny) * image;
  return shrunk_by_least(at_least, Budget(1, u, tiny), image).in_u();
}

Checked check_motion_bound() {
  DerivedBudgets budgets;
  // The share of A is at most the root of 9 / 16 and what is added for errors, so that an image's error e adds up to (1 + share
  // sqrt(n (n - 1) / 2) 2) e.
  const double share = std::sqrt(squared_deviation_share(0.0)) + baseline::positive + error_share(1e-6);
  for (const bool is_matrix : {false, true})
    for (int n = 1; n <= most_motion_bound_joints; ++n) {
      const double all = 1 + share * std::sqrt(n * (n - 1) / 2.0) * 2;
      const auto add = [&](const char* what, double f, double t) {
        const double e = error_of_image(f, t, is_matrix ? image_by_matrix : image_by_quaternion);
        char name[80];
        std::snprintf(name, sizeof name, "%d joints%s, per %s", n, is_matrix ? " by matrices" : "", what);
        // The box grows by a radius, with one rounding on each side. Images of a single joint are not shrunk.
        budgets.add(name, all * (e + 2) + (n == 1 ? 0 : error_of_shrunk(n)), lost_of_motion_bound * n / u);
      };
      add("|f|", 1, tiny), add("|t|", tiny, 1);
    }
  // The radius is rounded, and joints stretch it; so do they with a box's half diagonal, which matrices turn.
  const Quaternion<Budget> turned = multiply(rounded_input<4>(1), rounded_input<4>(1));
  const double of_half = image_by_matrix({turned, of_length<0, 3>(tiny)}, rounded_input<3>(1));
  budgets.add("per radius", 3 * stretch + 3, lost_of_motion_bound / u);
  budgets.add("per half diagonal", of_half + 3 * stretch + 3, lost_of_motion_bound / u);
  // This is the error of a dot product of two joints' quaternions, whose squared lengths are off by 2e-6 with the placement's.
  budgets.add("cosine", dot(turned, turned).in_u() + stretch, baseline::positive / u);
  // The share of A that is added for errors also has to hold those of A, of the share and of their product, relative to
  // themselves.
  budgets.add("A", share * (error_of_spread() + 8), error_share(0) / u);
  // This is the error of what is computed of | ||q||^2 - 1 |, beside 1e-6.
  const double of_square = squared_norm(rounded_input<4>(1)).in_u();
  budgets.add("surely rigid", of_square, (1e-6 - surely_rigid) / u);
  budgets.add("surely not rigid", of_square, (surely_not_rigid - 1e-6) / u);
  return budgets.checked();
}

// Checks what a box of an earlier pose allows for, beside what it allowed for in that pose: the errors of a motion bound of the later
// pose, and those of how far joints have moved, which is between images of both poses.
Checked check_pose_change() {
  DerivedBudgets budgets;
  const double share = std::sqrt(squared_deviation_share(0.0)) + error_share(1e-6);
  for (int n = 1; n <= most_motion_bound_joints; ++n) {
    const double of_later = 1 + share * std::sqrt(n * (n - 1) / 2.0) * 2,
                 of_moved = growth_by_change(1.0, share, spread_after_change(0.0, double(n), 1.0));
    const auto add = [&](const char* what, double f, double later, double earlier, double allowed) {
      const double e = error_of_image(f, later, image_by_quaternion), e_before = error_of_image(f, earlier, image_by_quaternion);
      // Both are rounded once more in their difference, whose length takes as much of itself as a motion bound does.
      budgets.add(std::to_string(n) + " joints, per " + what, of_later * (e + 2) + of_moved * (e + e_before + 2), allowed / u);
    };
    add("|f|", 1, tiny, tiny, lost_of_growth(n, 1, 0, 0));
    add("later |t|", tiny, 1, tiny, lost_of_growth(n, 0, 0, 1));
    add("earlier |t|", tiny, tiny, 1, lost_of_growth(n, 0, 1, 0));
    // A turn is between two rounded quaternions, and a point is at most twice as far from its anchor as from the origin.
    const Quaternion<Budget> difference = rounded_input<4>(1) - rounded_input<4>(1);
    const double of_turn = whole(difference).in_u() + stretch / 2;
    budgets.add("a turn", of_turn, lost_of_turn / u);
    budgets.add("a turn of a point about an anchor", of_moved * moved_at_most(0.0, of_turn, 2.0),
                lost_of_growth(n, 1, 0, 0) / u - of_later * (error_of_image(1, tiny, image_by_quaternion) + 2) -
                    2 * of_moved * (error_of_image(1, tiny, image_by_quaternion) + 1));
  }
  budgets.add("a cosine of the later pose", stretch, lost_of_cosine / u);
  // A length takes three roundings of itself, and its product with a radius and the sum one each.
  const Budget squared = squared_norm(of_length<0, 3>(1, 0)), far = root(Budget(1, squared.error, 1));
  budgets.add("per growth", (far + Budget(1, 0, 0) * far).in_u() + 4, lost_of_motion_bound / u);
  // Where the share of a turn is of the earlier pose's A alone, no share for errors holds those of A.
  budgets.add("A of the earlier pose", error_of_spread() + 8, lost_of_motion_bound / u);
  return budgets.checked();
}

// --- Boxes in float, and placed bodies ---

Budget scalar(double most, double error = 0) { return {most, error, 0}; }

// Returns the error of a box of a cluster or of a node whose coordinates are at most this large, converted to float or not, grown
// by so much.
double error_of_grown_box(double coordinate, bool is_converted, double by) {
  Box<Budget> box{of_length<0, 3>(coordinate, is_converted ? u * coordinate : 0), {}};
  box.high = box.low;
  box.grow(scalar(by));
  return whole(box.low).in_u();
}
// Returns the error of what ClusterPairs::moved finds, for a coordinate of a box and one of the offset between two origins. That
// of place is the same, without the second rounding.
double error_of_moved_box(double coordinate, double offset) {
  return (scalar(coordinate) + scalar(offset, u * offset) - scalar(tiny)).in_u();
}

Checked check_float_boxes() {
  DerivedBudgets budgets;
  constexpr double spare = four_roundings / u, twice = 2 * spare;
  budgets.add("a cluster's box, with what is to spare", error_of_grown_box(1, false, tiny) + spare, twice);
  // The slack by which it grows is rounded to float, added up and subtracted. float_slack_and_more makes room for this.
  budgets.add("a cluster's box, per slack", 2 + error_of_grown_box(tiny, false, 1) + spare, (float_slack_and_more - 1) / u);
  budgets.add("a cluster's box of doubles, with what is to spare", error_of_grown_box(1, true, tiny) + spare, twice);
  budgets.add("a node's box, with what is to spare", error_of_grown_box(1, true, tiny) + spare, roundings_of_float_box / u);
  budgets.add("a moved box, per coordinate", error_of_moved_box(1, tiny), spare);
  budgets.add("a moved box, per offset", error_of_moved_box(tiny, 1), spare);
  // The moved box is then grown.
  budgets.add("a box moved back, per coordinate", error_of_moved_box(1, tiny) + error_of_grown_box(1, false, tiny), twice);
  budgets.add("a box moved back, per offset", error_of_moved_box(tiny, 1) + error_of_grown_box(1, false, tiny), twice);
  // In u of double, turned + translation and translation - origin are rounded, and so is what these leave of the world's
  // coordinates.
  const double translation = scalar(1).rounded().in_u() * 3, origin = scalar(1).rounded().in_u() * 2;
  budgets.add("the world's doubles, per translation", translation, lost_in_world / 0x1p-53);
  budgets.add("the world's doubles, per origin", origin, lost_in_world / 0x1p-53);
  return budgets.checked();
}

// Checks hulls of whole images of more joints than a pack takes, in u of double: those of the box, and those of the vertices.
// Each budget is relative to the lengths of the parts of an image.
Checked check_hulls() {
  DerivedBudgets budgets;
  const Quaternion<Budget> unit = of_length<0, 4>(1);
  for (const int n : {5, 8, 64, 1024}) {
    const std::string joints = std::to_string(n) + " joints, ";
    // A blend of n images has an error of n.
    const auto error_of_linear = [&](double point, double translation) {
      const Vec<Budget, 3> p = of_length<0, 3>(point), t = of_length<0, 3>(translation), image = rotate<Budget>(unit, p) + t;
      const Vec<Budget, 3> vertex = of_length<0, 3>(point + translation, whole(image).error + n * u * (point + translation));
      return (whole(rotate<Budget>(unit, image)).error + whole(rotate<Budget>(unit, vertex)).error) / u;
    };
    // Besides, the sum of lengths and the sides of the box are rounded, which is less than 16 of the same.
    budgets.add(joints + "linear, per center", error_of_linear(1, tiny) + 16, lost_of_hull(n) / 0x1p-53);
    budgets.add(joints + "linear, per translation", error_of_linear(tiny, 1) + 16, lost_of_hull(n) / 0x1p-53);
    // Skinning takes x = v - r_c, which loses a rounding of its parts; turning it, and the center's image, are as skinning has
    // them, for blends of any length.
    const PaletteRounding<double> rounding = rounding_spherical(PaletteScales<double>{double(n), 1, 1, 1, 0});
    const double of_x = rounding.vertex.per_length / 0x1p-53, of_image = rounding.vertex.offset / 0x1p-53;
    const double of_turn = whole(rotate<Budget>(unit, of_length<0, 3>(1))).in_u();
    budgets.add(joints + "spherical, per center or rotation center", 2 + of_turn + 16, lost_of_hull(n) / 0x1p-53);
    budgets.add(joints + "spherical, per center image", of_image + 2 * of_turn + 16, lost_of_hull(n) / 0x1p-53);
    // x is within the reach, which is stretched for quaternions off unit length by more than its rounding.
    budgets.add(joints + "spherical, per reach", of_x + 2 * of_turn + 16, lost_of_hull(n) / 0x1p-53);
  }
  budgets.add("per reach, for quaternions off unit length", 2 * 2e-6 / 0x1p-53, (stretch_of_hull - 1) / 0x1p-53);
  return budgets.checked();
}

// Returns the error, in u of double, of boxes around the images of pieces by affine joints of a Frobenius norm of 1, and of the
// skinned vertices that they hold. The lengths are those of a point, a half extent and an offset, and twice a radius.
double error_of_affine_boxes(int joints, double point, double half_extent, double radius, double offset) {
  const Quaternion<Budget> unit = of_length<0, 4>(1);
  const double of_blend = oracle::error_of_blend<3>(joints, 0) * u;
  double worst = 0;
  // Errors are linear in the products of coordinates and columns. Three products turn a column, which have lengths of sqrt 3 in
  // all.
  for (int k = 0; k < 3; ++k) {
    AffineMap<Budget> turn{{rotate<Budget>(unit, of_length<0, 3>(1)), of_length<0, 3>(tiny), of_length<0, 3>(tiny)},
                           of_length<0, 3>(tiny)};
    std::swap(turn.columns[0], turn.columns[k]);
    Vec<Budget, 3> blended = of_length<0, 3>(tiny);
    blended[k] = Budget(std::sqrt(3.0), of_blend, 0);
    AffineMap<Budget> map{{of_length<0, 3>(tiny), of_length<0, 3>(tiny), of_length<0, 3>(tiny)}, of_length<0, 3>(tiny)};
    map.columns[k] = of_length<0, 3>(1, whole(turned_by(turn, blended)).error);
    map.offset = of_length<0, 3>(offset, offset * whole(turned_by(turn, blended)).error);
    // The box's center and half extents are rounded.
    Vec<Budget, 3> center = of_length<0, 3>(tiny), half = of_length<0, 3>(tiny);
    center[k] = Budget(point, u * point, 0), half[k] = Budget(half_extent, u * half_extent, 0);
    const HalfBox<Budget> image = image_of_box<Budget>(map, {center, half});
    const Budget squared = squared_norm(Vec<Budget, 3>(map.columns[k])), row = root(Budget(1, squared.error, 1));
    const double of_box = (whole(image.center) - whole(image.half)).rounded().in_u();
    const double of_ball = (whole(image.center) - row * Budget(2 * radius, 0, 0)).rounded().in_u();
    const Vec<Budget, 3> skinned = of_length<0, 3>(
        point + offset, (point * (oracle::error_of_blend<3>(joints, 4 * u)) + offset * oracle::error_of_blend<3>(joints, u)) * u);
    worst = std::max(worst, std::max(of_box, of_ball) + whole(rotate<Budget>(unit, skinned)).in_u());
  }
  return worst;
}

Checked check_affine_boxes() {
  DerivedBudgets budgets;
  for (const int n : {1, 2, 4, 8, 64, 1024}) {
    const std::string joints = std::to_string(n) + " joints, per ";
    const double allowed = lost_of_affine_box(n) / 0x1p-53;
    double worst = 0;
    const auto add = [&](const char* what, double derived) {
      budgets.add(joints + what, derived, allowed);
      worst = std::max(worst, derived);
    };
    add("F |p|", error_of_affine_boxes(n, 1, tiny, tiny, tiny));
    add("F |half extent|", error_of_affine_boxes(n, tiny, 1, tiny, tiny));
    // Where the ball decides, it reaches no farther than the box, which has twice the lengths.
    add("F r", error_of_affine_boxes(n, tiny, tiny, 1, tiny));
    add("|t|", error_of_affine_boxes(n, tiny, tiny, tiny, 1));
    budgets.add(joints + "all, not a quarter more", allowed / 1.25, worst);
  }
  return budgets.checked();
}

// Checks the rounding of placements, in u of double.
Checked check_placements() {
  DerivedBudgets budgets;
  const auto transform = [](double translation) {
    return RigidTransform<Budget>{of_length<0, 4>(1), of_length<0, 3>(translation)};
  };
  const auto error = [&](double of_first, double of_second, double center) {
    const RigidTransform<Budget> first = transform(of_first), second = transform(of_second);
    const Vec<Budget, 3> at = of_length<0, 3>(center);
    // The terms are those of the ball's center, of the triangles' corners of both bodies, and of the distance and the reach.
    return whole(apply(compose(inverse(first), second), at)).in_u() + whole(apply(first, at)).in_u() +
           whole(apply(second, at)).in_u() + 10;
  };
  constexpr double allowed = lost_of_placements / 0x1p-53;
  budgets.add("two bodies, per center", error(tiny, tiny, 1), allowed);
  budgets.add("two bodies, per first translation", error(1, tiny, tiny), allowed);
  budgets.add("two bodies, per second translation", error(tiny, 1, tiny), allowed);
  return budgets.checked();
}

// --- Skinned vertices ---

// Returns the greatest error of a formula that turns x by a quaternion of length 1, for all angles. All exact sums in it are at
// most this long. formula(q) returns the image.
template <class Formula>
double error_of_turn(double longest, const Formula& formula) {
  using oracle::PlainBudget;
  constexpr int cells = 512;
  double worst = 0;
  PlainBudget::longest = longest, PlainBudget::least_squared_norm = 1;
  for (int cell = 0; cell < cells; ++cell) {
    Quaternion<PlainBudget> q = of_length<1, 4>(std::sin((cell + 1) * std::acos(0.0) / cells));
    q[0] = PlainBudget(std::cos(cell * std::acos(0.0) / cells), 0, 0);
    worst = std::max(worst, whole(formula(q)).in_u());
  }
  PlainBudget::longest = HUGE_VAL, PlainBudget::least_squared_norm = 0;
  return worst;
}

// Holds what the formulas of skinned vertices lose of a given blend, in u of any type.
struct ErrorsOfVertices {
  double spherical, of_center_image;  // per ||x|| and per center image
  double linear, of_translation;      // per ||p|| and per translation
  double dual, of_dual_translation;
};
ErrorsOfVertices errors_of_vertices() {
  using oracle::PlainBudget;
  // keep x + along v is symmetric in x, of eigenvalues 1 and w^2 - ||v||^2.
  const auto spherical = [&](double x, double image) {
    return error_of_turn(x + image, [&](const Quaternion<PlainBudget>& q) {
      return turn_and_place<PlainBudget>({q, of_length<1, 3>(image)}, squared_norm(q), of_length<1, 3>(x));
    });
  };
  const auto linear = [&](double p, double translation) {
    return error_of_turn(p + translation, [&](const Quaternion<PlainBudget>& q) {
      return apply(RigidTransform<PlainBudget>{q, of_length<1, 3>(translation)}, of_length<1, 3>(p));
    });
  };
  // Duals are as long as half the translation.
  const auto dual = [&](double p, double translation) {
    return error_of_turn(p + translation, [&](const Quaternion<PlainBudget>& q) {
      return move_rigidly<PlainBudget>({q, of_length<1, 4>(translation / 2)}, squared_norm(q), of_length<1, 3>(p));
    });
  };
  // x has an error of 1.
  return {1 + spherical(1, tiny), spherical(tiny, 1), linear(1, tiny), linear(tiny, 1), dual(1, tiny), dual(tiny, 1)};
}

// Checks the rates of palette_rounding.hpp for a skinned vertex. b8_blend_error bounds how far the blend's own error turns and
// moves it.
Checked check_vertices() {
  DerivedBudgets budgets;
  const double u_double = 0x1p-53;
  const ErrorsOfVertices errors = errors_of_vertices();
  for (const int n : {1, 2, 4, 64})
    for (const double kappa : {1.0, 1.5, 16.0}) {
      char joints[60];
      std::snprintf(joints, sizeof joints, "%d joints, kappa %g, ", n, kappa);
      const auto add = [&](const char* what, double derived, double rate) {
        budgets.add(std::string(joints) + what, derived, rate / u_double);
      };
      const double of_rotation = oracle::error_of_blend<4>(n, 0), of_center = oracle::error_of_blend<3>(n, 0);
      const auto of_spherical = rounding_spherical(rounded_scales(n, kappa, 1, 0)).vertex,
                 of_linear = rounding_linear(rounded_scales(n, kappa, 0, 1)).vertex,
                 of_dual = rounding_dual_quaternion(rounded_scales(n, kappa, 0, 1)).vertex;
      add("spherical, per |x|", errors.spherical + turn_of_error(of_rotation, kappa), of_spherical.per_length);
      add("spherical, per center image", errors.of_center_image + of_center, of_spherical.offset);
      add("linear, per |p|", errors.linear + of_center, of_linear.per_length);
      add("linear, per |t|", errors.of_translation + of_center, of_linear.offset);
      add("dual quaternions, per |p|", errors.dual + turn_of_error(of_rotation, kappa), of_dual.per_length);
      // A blend of length 1 / kappa moves by kappa |t|.
      const double moved = move_of_error<double>({of_rotation, of_rotation / 2, 0.5, kappa});
      add("dual quaternions, per |t|", errors.of_dual_translation * kappa + moved, of_dual.offset);
    }
  return budgets.checked();
}

// Checks that rates which do not grow with kappa and joints are what was derived, or less than a unit more.
Checked check_constants_of_vertices() {
  DerivedBudgets budgets;
  const double u_double = 0x1p-53;
  const ErrorsOfVertices errors = errors_of_vertices();
  const auto add = [&](const char* what, double derived, double rate) {
    budgets.add_up_to_a_unit(what, derived, rate / u_double);
  };
  const auto of_spherical = rounding_spherical(rounded_scales(0, 1, 1, 0)).vertex,
             of_linear = rounding_linear(rounded_scales(0, 1, 0, 1)).vertex,
             of_dual = rounding_dual_quaternion(rounded_scales(0, 1, 0, 1)).vertex;
  add("spherical, per |x|", errors.spherical, of_spherical.per_length);
  add("spherical, per center image", errors.of_center_image, of_spherical.offset);
  add("linear, per |p|", errors.linear, of_linear.per_length);
  add("linear, per |t|", errors.of_translation, of_linear.offset);
  add("dual quaternions, per |p|", errors.dual, of_dual.per_length);
  add("dual quaternions, per |t|", errors.of_dual_translation, of_dual.offset);
  return budgets.checked();
}

// Checks the least cosine between a lane's joints, of quaternions in float: what is used is below the exact one, and not by much.
Checked check_cosines() {
  constexpr int cases = 20000, width = baseline::width;
  std::mt19937 random(2006);
  std::normal_distribution<double> normal;
  const auto unit = [&] {
    return Quaternion<double>(normal(random), normal(random), normal(random), normal(random)).normalized();
  };
  bool ok = true;
  for (int i = 0; i < cases && ok; ++i) {
    alignas(64) float numbers[2][4][width];
    double exact[width];
    for (int lane = 0; lane < width; ++lane) {
      const Quaternion<float> p = unit().cast<float>(), q = unit().cast<float>();
      for (int d = 0; d < 4; ++d) numbers[0][d][lane] = p[d], numbers[1][d][lane] = q[d];
      exact[lane] = std::abs(dot<double, 4>(p.cast<double>(), q.cast<double>()));
    }
    baseline::Rotations<2> rotations;
    for (int k = 0; k < 2; ++k) {
      Quaternion<baseline::S> packed;
      for (int d = 0; d < 4; ++d) packed[d] = baseline::load(numbers[k][d]);
      rotations.add(k, packed);
    }
    const baseline::S cosine = rotations.cosine();
    for (int lane = 0; lane < width; ++lane)
      ok = ok && cosine[lane] < exact[lane] && cosine[lane] > exact[lane] - 2 * baseline::positive;
  }
  return Checked(ok, cases * width);
}

}  // namespace

PROPTEST(bound_budgets) {
  const Options options{.number_type = "bounds of float"};
  t.example("the refit's slack allows for what float may lose", options, check_refit);
  t.example("the motion bound allows for what float may lose of images", options, check_motion_bound);
  t.example("a box of an earlier pose allows for what float may lose of how far joints have moved", options, check_pose_change);
  t.example("the cosine that the motion bound uses is below the exact one", {.number_type = "float against double"},
            check_cosines);
  t.example("boxes in float allow for what growing and moving them may lose", options, check_float_boxes);
  t.example("boxes of affine images allow for what double may lose", {.number_type = "bounds of double"}, check_affine_boxes);
  t.example("hulls of whole images allow for what double may lose", {.number_type = "bounds of double"}, check_hulls);
  t.example("the rates of skinned vertices allow for what the formulas may lose", {.number_type = "bounds of any float"},
            check_vertices);
  t.example("the constants of skinned vertices are derived up to a unit", {.number_type = "bounds of any float"},
            check_constants_of_vertices);
  t.example("the traversal of placed bodies allows for what double may lose", {.number_type = "bounds of double"},
            check_placements);
}

}  // namespace proptests::suite_bound_budgets
