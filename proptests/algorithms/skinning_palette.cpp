// SPDX-License-Identifier: GPL-3.0-or-later
// Tests a frame's skinning data and the skinned vertices of whole models.
#include "algorithms/runtime/skinning/skinning_palette.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/posed_model.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_skinning_palette {
namespace {

using namespace refitlab;
using gen::PosedModel;

double size_of(const PosedModel& posed) {
  double size = 1;
  for (const Point3& v : posed.mesh.vertices) size = std::max(size, v.norm());
  for (const auto& c : posed.pose) size = std::max(size, c.translation.norm());
  for (const auto& j : posed.mesh.joints) size = std::max(size, j.origin.norm());
  return size;
}

// Says whether two joints of one joint-set are turned against each other by 180 degrees, so that neither sign is the short way.
bool has_half_turn(const SkinningPalette<double>& palette) {
  for (std::size_t s = 0; s < palette.size(); ++s)
    for (const auto& a : palette[s].transforms)
      for (const auto& b : palette[s].transforms)
        if (std::abs(dot(a.rotation, b.rotation)) < 1e-12) return true;
  return false;
}

bool same(const PaletteRounding<double>& a, const PaletteRounding<double>& b) {
  return a.vertex.per_length == b.vertex.per_length && a.vertex.per_radius == b.vertex.per_radius &&
         a.vertex.offset == b.vertex.offset && a.weight_vertices.per_length == b.weight_vertices.per_length &&
         a.weight_vertices.per_radius == b.weight_vertices.per_radius && a.weight_vertices.offset == b.weight_vertices.offset;
}

bool same(const SkinningPalette<double>& a, const SkinningPalette<double>& b) {
  const auto same_transform = [](const RigidTransform<double>& x, const RigidTransform<double>& y) {
    return x.rotation == y.rotation && x.translation == y.translation;
  };
  const auto same_map = [](const AffineMap<double>& x, const AffineMap<double>& y) {
    return x.columns == y.columns && x.offset == y.offset;
  };
  if (a.size() != b.size() || a.is_affine() != b.is_affine() || a.is_measured() != b.is_measured()) return false;
  for (std::size_t s = 0; s < a.size(); ++s) {
    if (!std::ranges::equal(a[s].transforms, b[s].transforms, same_transform) || a[s].rotation_center != b[s].rotation_center ||
        !std::ranges::equal(a[s].center_images, b[s].center_images) || !std::ranges::equal(a[s].duals, b[s].duals) ||
        !std::ranges::equal(a[s].maps, b[s].maps, same_map) || !std::ranges::equal(a[s].stretches, b[s].stretches))
      return false;
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
      if (!same(a.rounding(s, skinning), b.rounding(s, skinning))) return false;
  }
  return true;
}

// Draws affine joints with entries and offsets of some size.
AffinePose drawn_affine(std::size_t joints) {
  const auto number = [] { return *rc::gen::inRange(-3000, 3001) / 1000.0; };
  AffinePose out(joints);
  for (AffineMap<double>& map : out) {
    for (Point3& column : map.columns) column = {number(), number(), number()};
    map.offset = {number(), number(), number()};
  }
  return out;
}

// Fills a palette with a pose of rigid joints or, for linear skinning, with one of affine ones.
void fill(SkinningPalette<double>& palette, const PosedModel& posed, const JointSets& sets, Skinning skinning,
          const AffinePose& affine) {
  if (affine.empty()) make_skinning_palette(posed.mesh, sets, posed.pose, skinning, palette);
  else make_skinning_palette(posed.mesh, sets, affine, palette);
}

double worst_difference(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

std::string message_of(const Pose& pose, const PosedModel& posed) {
  const JointSets sets(posed.mesh);
  try {
    make_skinning_palette(posed.mesh, sets, pose, Skinning::spherical);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

PosedModel two_joints() {
  PosedModel p;
  p.mesh.name = "pair";
  p.mesh.joints = {{"hip", -1, {0, 0, 0}}, {"knee", 0, {0, 1, 0}}};
  p.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.mesh.influences = {{{0, 1.0}}, {{0, 0.5}, {1, 0.5}}, {{1, 1.0}}};
  p.mesh.triangles = {{0, 1, 2}};
  p.pose = reference_pose(p.mesh);
  return p;
}

bool names(const std::string& message, std::initializer_list<const char*> parts) {
  for (const char* part : parts)
    if (message.find(part) == std::string::npos) return false;
  return true;
}

void consistent_signs_keep_blends_from_vanishing(Suite& t) {
  // The reason is that, with <q_1, q_i> >= 0 for all i, <q_1, sum w_i q_i> >= w_1 |q_1|^2 > 0.
  t.holds("with consistent signs and a positive first weight no blend vanishes",
          {.number_type = "rational", .degenerate_at_least = 0.1}, [] {
            OwnedPaletteEntry<Rational> palette;
            palette.transforms = *gen::rigid_transforms(1, 5);
            auto w = *gen::convex_weights(static_cast<int>(palette.transforms.size()));
            bool opposite = false;
            for (auto& c : palette.transforms) {
              if (*rc::gen::inRange(0, 8) == 0) c.rotation = -palette.transforms[0].rotation;
              opposite = opposite || c.rotation == -palette.transforms[0].rotation;
            }
            RC_CLASSIFY(opposite, "degenerate");
            const Quaternion<Rational> first = palette.transforms[0].rotation;
            std::vector<Quaternion<Rational>> before;
            for (const auto& c : palette.transforms) before.push_back(c.rotation);
            make_signs_consistent<Rational>(palette.transforms);
            RC_ASSERT(palette.transforms[0].rotation == first);
            for (std::size_t i = 0; i < before.size(); ++i) {
              const auto& q = palette.transforms[i].rotation;
              RC_ASSERT(q == before[i] || q == -before[i]);
              RC_ASSERT(dot(first, q) >= 0);
            }
            RC_PRE(w[0] > 0);
            RC_ASSERT(dot(first, blend_quaternion<Rational>(palette, w)) >= w[0]);
          });
  t.example("with a first weight of zero a blend of consistent signs can vanish",
            {.number_type = "rational", .hypothesis = "w_1 > 0"}, [] {
              OwnedPaletteEntry<Rational> palette;
              palette.transforms.resize(3);
              palette.transforms[1].rotation = {0, 1, 0, 0};
              palette.transforms[2].rotation = {0, -1, 0, 0};
              make_signs_consistent<Rational>(palette.transforms);
              const std::vector<Rational> w{Rational(0), Rational(1, 2), Rational(1, 2)};
              return squared_norm(blend_quaternion<Rational>(palette, w)) == 0;
            });
}

void vertices_and_data_of_joint_sets(Suite& t) {
  t.holds("the skinned vertices are those of Eigen's matrices and quaternions, up to 1e-11 of the model's size",
          {.number_type = "double", .cases = 500, .degenerate_at_least = 0.2}, [] {
            const PosedModel posed = *gen::posed_model();
            const JointSets sets(posed.mesh);
            const auto spherical = make_skinning_palette(posed.mesh, sets, posed.pose, Skinning::spherical);
            const auto by_points = skin(posed.mesh, sets, spherical, Skinning::linear);
            const auto by_quaternions = skin(posed.mesh, sets, spherical, Skinning::spherical);
            const auto dual = make_skinning_palette(posed.mesh, sets, posed.pose, Skinning::dual_quaternion);
            const auto by_dual_quaternions = skin(posed.mesh, sets, dual, Skinning::dual_quaternion);
            RC_CLASSIFY(has_half_turn(spherical) || posed.mesh.joints.size() == 1, "degenerate");
            for (std::size_t v = 0; v < posed.mesh.vertices.size(); ++v) {
              const auto& set = spherical[sets.of_vertex(static_cast<int>(v))];
              const auto w = sets.weights(static_cast<int>(v));
              // The least-squares center may lie far away, and rounding grows with its distance.
              const double tolerance = 1e-11 * (size_of(posed) + set.rotation_center.norm());
              RC_ASSERT((by_points[v] - oracle::linear_by_eigen(set.transforms, w, posed.mesh.vertices[v])).norm() <= tolerance);
              if (norm(blend_quaternion<double>(set, w)) < 0.01) continue;
              RC_ASSERT(
                  (by_quaternions[v] - oracle::spherical_by_eigen(set.transforms, w, set.rotation_center, posed.mesh.vertices[v]))
                      .norm() <= tolerance);
              RC_ASSERT(
                  (by_dual_quaternions[v] - oracle::dual_quaternion_by_eigen(set.transforms, w, posed.mesh.vertices[v])).norm() <=
                  tolerance);
            }
          });
  t.holds(
      "the data of a joint-set are its joints' transforms in order, with images of one common center",
      {.number_type = "double", .cases = 300}, [] {
        const PosedModel posed = *gen::posed_model();
        const JointSets sets(posed.mesh);
        const auto palette = make_skinning_palette(posed.mesh, sets, posed.pose, gen::drawn_skinning());
        RC_ASSERT(palette.size() == static_cast<std::size_t>(sets.count()));
        for (int s = 0; s < sets.count(); ++s) {
          RC_ASSERT(palette[s].transforms.size() == sets.joints(s).size());
          RC_ASSERT(palette[s].center_images.size() == sets.joints(s).size());
          RC_ASSERT(palette[s].duals.size() == sets.joints(s).size());
          for (std::size_t i = 0; i < sets.joints(s).size(); ++i) {
            const auto& given = posed.pose[sets.joints(s)[i]];
            const auto& c = palette[s].transforms[i];
            RC_ASSERT(c.translation == given.translation);
            RC_ASSERT(c.rotation == given.rotation || c.rotation == -given.rotation);
            RC_ASSERT((palette[s].center_images[i] -
                       oracle::times<double>(oracle::affine_of(given.rotation, given.translation), palette[s].rotation_center))
                          .norm() <= 1e-12 * (size_of(posed) + palette[s].rotation_center.norm()));
            const auto& t = given.translation;
            const auto twice_dual = oracle::hamilton<double>({0, t[0], t[1], t[2]}, c.rotation);
            RC_ASSERT((palette[s].duals[i] * 2 - twice_dual).norm() <= 1e-12 * size_of(posed));
          }
        }
      });
  t.holds("the signs of a pose's quaternions move no vertex, but where joints of a set differ by a half-turn",
          {.number_type = "double", .cases = 500}, [] {
            const PosedModel posed = *gen::posed_model();
            const JointSets sets(posed.mesh);
            const Skinning skinning = *rc::gen::element(Skinning::spherical, Skinning::dual_quaternion);
            const auto palette = make_skinning_palette(posed.mesh, sets, posed.pose, skinning);
            RC_PRE(!has_half_turn(palette));
            Pose negated = posed.pose;
            for (auto& c : negated)
              if (*rc::gen::arbitrary<bool>()) c.rotation = -c.rotation;
            const auto other = make_skinning_palette(posed.mesh, sets, negated, skinning);
            RC_ASSERT(worst_difference(skin(posed.mesh, sets, palette, skinning), skin(posed.mesh, sets, other, skinning)) == 0);
          });
}

void palettes_that_are_filled_again(Suite& t) {
  t.holds("a palette that is filled again is the one made anew, whatever it held, and stays as it is if the pose is refused",
          {.number_type = "double", .cases = 300, .tags_at_least = {{"affine after affine", 0.1}, {"rigid after affine", 0.1}}},
          [] {
            SkinningPalette<double> palette;
            bool was_affine = false;
            for (int frame = 0; frame < 4; ++frame) {
              const PosedModel posed = *gen::posed_model();
              const JointSets sets(posed.mesh);
              const Skinning skinning = *rc::gen::element(Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion);
              const bool is_affine = *rc::gen::arbitrary<bool>();
              const AffinePose affine = is_affine ? drawn_affine(posed.mesh.joints.size()) : AffinePose();
              SkinningPalette<double> anew;
              fill(palette, posed, sets, skinning, affine), fill(anew, posed, sets, skinning, affine);
              RC_ASSERT(same(palette, anew));
              RC_ASSERT_THROWS_AS(make_skinning_palette(posed.mesh, sets, Pose(), skinning, palette), ModelError);
              RC_ASSERT_THROWS_AS(make_skinning_palette(posed.mesh, sets, AffinePose(), palette), ModelError);
              RC_ASSERT(same(palette, anew));
              RC_CLASSIFY(was_affine && is_affine, "affine after affine");
              RC_CLASSIFY(was_affine && !is_affine, "rigid after affine");
              was_affine = is_affine;
            }
          });
}

void where_rotation_centers_are(Suite& t) {
  t.holds(
      "the joint that two neighbouring bones share is where their transforms agree, and blending about it is blending "
      "about any point of the relative rotation's axis",
      {.number_type = "rational", .degenerate_at_least = 0.1}, [] {
        const auto parent = *gen::rigid_transform();
        const auto turn = *gen::unit_quaternion();
        const auto joint = *gen::rational_vector<3>();
        const auto vertex = *gen::rational_vector<3>();
        const Rational along = *gen::rational();
        OwnedPaletteEntry<Rational> about_joint;
        about_joint.transforms = {parent, compose(parent, {turn, joint - rotate(turn, joint)})};
        make_signs_consistent<Rational>(about_joint.transforms);
        OwnedPaletteEntry<Rational> about_axis = about_joint;
        place_rotation_center<Rational>(about_joint, joint);
        const gen::RationalVec<3> elsewhere = joint + imaginary(turn) * along;
        place_rotation_center<Rational>(about_axis, elsewhere);
        RC_CLASSIFY(squared_norm(imaginary(turn)) == 0 || turn[0] == 0 || vertex == joint, "degenerate");
        RC_ASSERT(about_joint.center_images[0] == about_joint.center_images[1]);
        const auto w = *gen::convex_weights(2);
        RC_ASSERT(blend_spherical<Rational>(about_joint, w, vertex) == blend_spherical<Rational>(about_axis, w, vertex));
      });
  t.holds("for neighbouring bones Hejl's center is the shared joint, and skinning about it is spherical skinning",
          {.number_type = "double", .cases = 500}, [] {
            const PosedModel posed = *gen::posed_model();
            const JointSets sets(posed.mesh);
            const auto hejl = make_skinning_palette(posed.mesh, sets, posed.pose, Skinning::hejl);
            const auto spherical = make_skinning_palette(posed.mesh, sets, posed.pose, Skinning::spherical);
            const auto a = skin(posed.mesh, sets, hejl, Skinning::hejl);
            const auto b = skin(posed.mesh, sets, spherical, Skinning::spherical);
            int seen = 0;
            for (std::size_t v = 0; v < a.size(); ++v) {
              const int s = sets.of_vertex(static_cast<int>(v));
              const auto joints = sets.joints(s);
              if (joints.size() != 2 || posed.mesh.joints[joints[1]].parent != joints[0]) continue;
              ++seen;
              RC_ASSERT(hejl[s].rotation_center == posed.mesh.joints[joints[1]].origin);
              RC_ASSERT((hejl[s].center_images[0] - hejl[s].center_images[1]).norm() <= 1e-12 * size_of(posed));
              RC_ASSERT((a[v] - b[v]).norm() <= 1e-8 * (size_of(posed) + spherical[s].rotation_center.norm()));
            }
            RC_PRE(seen > 0);
          });
  t.holds(
      "a rotation center is nearest to the mean of its joints' origins; Hejl's is that of the last joint whose parent is in the "
      "joint-set, or of the first joint",
      {.number_type = "double",
       .cases = 500,
       .tags_at_least = {{"several shared", 0.1}, {"none shared", 0.1}, {"one joint", 0.1}}},
      [] {
        const PosedModel posed = *gen::posed_model();
        const JointSets sets(posed.mesh);
        std::set<std::string> seen;
        for (int s = 0; s < sets.count(); ++s) {
          const auto joints = sets.joints(s);
          Point3 sum = Point3::Zero();
          int shared = -1, count = 0;
          for (const int j : joints) {
            sum += posed.mesh.joints[j].origin;
            if (std::ranges::find(joints, posed.mesh.joints[j].parent) != joints.end()) shared = j, ++count;
          }
          const Point3 mean = sum / static_cast<double>(joints.size());
          for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
            RC_ASSERT((center_prior(posed.mesh, joints, skinning) - mean).norm() <= 1e-13 * size_of(posed));
          RC_ASSERT(center_prior(posed.mesh, joints, Skinning::hejl) ==
                    posed.mesh.joints[shared < 0 ? joints[0] : shared].origin);
          seen.insert(joints.size() == 1 ? "one joint"
                      : count == 0       ? "none shared"
                      : count == 1       ? "one shared"
                                         : "several shared");
        }
        for (const std::string& tag : seen) RC_TAG(tag);
      });
}

void affine_roundings(Suite& t) {
  t.example("affine joints have the roundings of affine joints, and none of a skinning of rotations", {}, [] {
    const SkinnedMesh model = two_joints().mesh;
    const JointSets sets(model);
    AffinePose pose(model.joints.size(), identity_map<double>());
    for (AffineMap<double>& map : pose) map.columns[0] *= 1000;
    const auto palette = make_skinning_palette(model, sets, pose);
    bool good = true;
    for (std::size_t s = 0; s < static_cast<std::size_t>(sets.count()); ++s) {
      const PaletteRounding<double> expected = rounding_affine(palette.scales(s)), found = palette.rounding(s, Skinning::linear);
      good = good && found.vertex.per_length == expected.vertex.per_length && found.vertex.per_length > 4000 * 0x1p-53 &&
             found.weight_vertices.per_radius == expected.weight_vertices.per_radius &&
             std::isinf(palette.rounding(s, Skinning::spherical).vertex.per_length) &&
             std::isinf(palette.rounding(s, Skinning::dual_quaternion).vertex.per_length);
    }
    return Checked(good, sets.count());
  });
}

void refused_poses(Suite& t) {
  t.example("a pose that is refused leaves the palette as it was", {}, [] {
    const PosedModel p = two_joints();
    const JointSets sets(p.mesh);
    Pose other = p.pose;
    other[1].translation = {1, 2, 3};
    SkinningPalette<double> palette = make_skinning_palette(p.mesh, sets, other, Skinning::spherical);
    const SkinningPalette<double> before = palette;
    other[1].rotation[0] = NAN;
    try {
      make_skinning_palette(p.mesh, sets, other, Skinning::spherical, palette);
    } catch (const ModelError&) {
      return same(palette, before) && palette.size() == static_cast<std::size_t>(sets.count()) && palette.is_measured();
    }
    return false;
  });
  t.example("a pose with a transform too few is refused with the counts", {}, [] {
    PosedModel p = two_joints();
    p.pose.pop_back();
    return names(message_of(p.pose, p), {"pair", "1 transforms", "2 joints"});
  });
  t.example("affine joints that are not finite or out of range are refused with the joint's name, and those in range are not", {},
            [] {
              const SkinnedMesh model = two_joints().mesh;
              const auto reason = [&](const auto& change) -> std::string {
                AffinePose pose(model.joints.size(), identity_map<double>());
                change(pose.back());
                try {
                  check_pose(model, pose);
                  return "";
                } catch (const ModelError& e) {
                  return e.what();
                }
              };
              const auto is_refused = [&](const std::string& said, const auto& change) {
                const std::string whole = reason(change);
                return whole.find(said) != std::string::npos && whole.find(model.joints.back().name) != std::string::npos;
              };
              using Map = AffineMap<double>;
              long tried = 0;
              bool good = true;
              for (int i = 0; i < 12; ++i) {  // the first nine are those of the matrix
                const auto put = [=](double x) {
                  return [=](Map& m) { (i < 9 ? m.columns[static_cast<std::size_t>(i / 3)][i % 3] : m.offset[i - 9]) = x; };
                };
                for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)})
                  good = good && is_refused("its transform is not finite", put(bad)), ++tried;
                const double end = i < 9 ? 1e4 : 1e40;
                for (const double sign : {-1.0, 1.0}) {
                  good = good && reason(put(sign * end)).empty(), ++tried;
                  good = good && is_refused(i < 9 ? "its matrix is out of range" : "its translation is out of range",
                                            put(sign * end * (1 + 0x1p-52)));
                }
              }
              return Checked(good, tried);
            });
  t.example("a number in a pose that is not finite is refused with the joint's name", {}, [] {
    int refused = 0;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      for (int i = 0; i < 7; ++i) {
        PosedModel p = two_joints();
        (i < 4 ? p.pose[1].rotation[i] : p.pose[1].translation[i - 4]) = bad;
        refused += names(message_of(p.pose, p), {"pair", "joint 1", "knee", "not finite"});
      }
    return Checked(refused == 14, 14);
  });
  t.example("a rotation that is not of unit length, zero above all, is refused with the joint's name", {}, [] {
    int refused = 0;
    for (const double length : {0.0, 0.5, 1.01, 1e200}) {
      PosedModel p = two_joints();
      p.pose[1].rotation *= length;
      refused += names(message_of(p.pose, p), {"pair", "joint 1", "knee", "unit length"});
    }
    PosedModel rounded = two_joints();
    rounded.pose[1].rotation *= 1 + 1e-9;
    return Checked(refused == 4 && message_of(rounded.pose, rounded).empty(), 5);
  });
}

}  // namespace

PROPTEST(skinning_palette) {
  consistent_signs_keep_blends_from_vanishing(t);
  vertices_and_data_of_joint_sets(t);
  palettes_that_are_filled_again(t);
  where_rotation_centers_are(t);
  refused_poses(t);
  affine_roundings(t);
}

}  // namespace proptests::suite_skinning_palette
