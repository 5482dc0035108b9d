// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what makes a model, or a pose of it, one that is refused.
#include "algorithms/runtime/mesh/skinned_mesh.hpp"

#include <cmath>
#include <functional>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_skinned_mesh {
namespace {

using namespace refitlab;

SkinnedMesh tube() { return gen::make_mesh({gen::MeshKind::tube, 3, 4, 3, 7}); }

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

struct Broken {
  std::function<void(SkinnedMesh&)> break_it;
  std::string message;
};

constexpr double unit = 0x1p-24, beyond = 1e40 * (1 + 0x1p-52);

// Returns a change that adds two morph targets, of which one vertex of twelve has these displacements.
using Displacements = std::vector<Displacement<double>>;
std::function<void(SkinnedMesh&)> displaced(const Displacements& list) {
  return [=](SkinnedMesh& m) { m.targets = {2, std::vector<Displacements>(12)}, m.targets.of_vertex[4] = list; };
}

// Lists broken models of three joints and twelve vertices. Most are as near to what is accepted (accepted_models) as numbers can
// be.
std::vector<Broken> broken_models() {
  const auto weights = [](std::vector<Influence> list) { return [=](SkinnedMesh& m) { m.influences[2] = list; }; };
  const Point3 some(0.1, 0, 0);
  return {
      {[](SkinnedMesh& m) { m.joints.clear(); }, "skeleton: no joints"},
      {[](SkinnedMesh& m) { m.vertices.clear(); }, "mesh: no triangles, or none of three vertices that differ"},
      {[](SkinnedMesh& m) { m.triangles.clear(); }, "mesh: no triangles, or none of three vertices that differ"},
      {[](SkinnedMesh& m) { m.influences.pop_back(); }, "mesh: not one list of influences a vertex"},
      {[](SkinnedMesh& m) { m.influences.push_back(m.influences[0]); }, "mesh: not one list of influences a vertex"},
      {[](SkinnedMesh& m) { m.joints[0].parent = 0; }, "joint 0 (joint 0): its parent does not come before it"},
      {[](SkinnedMesh& m) { m.joints[1].parent = 2; }, "joint 1 (joint 1): its parent does not come before it"},
      {[](SkinnedMesh& m) { m.joints[1].parent = 1; }, "joint 1 (joint 1): its parent does not come before it"},
      {[](SkinnedMesh& m) { m.joints[1].parent = -2; }, "joint 1 (joint 1): its parent does not come before it"},
      {[](SkinnedMesh& m) { m.joints[2].origin[1] = NAN; }, "joint 2 (joint 2): its origin is not finite"},
      {[](SkinnedMesh& m) { m.joints[2].origin[0] = -INFINITY; }, "joint 2 (joint 2): its origin is not finite"},
      {[](SkinnedMesh& m) { m.joints[2].origin[0] = beyond; }, "joint 2 (joint 2): its origin is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.joints[0].origin[1] = -beyond; }, "joint 0 (joint 0): its origin is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.joints[1].origin[2] = beyond; }, "joint 1 (joint 1): its origin is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.vertices[4][2] = INFINITY; }, "vertex 4: its position is not finite"},
      {[](SkinnedMesh& m) { m.vertices[11][0] = NAN; }, "vertex 11: its position is not finite"},
      {[](SkinnedMesh& m) { m.vertices[4][2] = -beyond; }, "vertex 4: its position is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.vertices[0][0] = beyond; }, "vertex 0: its position is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.vertices[11][1] = beyond; }, "vertex 11: its position is out of range, beyond 1e40"},
      {[](SkinnedMesh& m) { m.triangles[3][1] = -1; }, "triangle 3: vertex index -1 is out of range"},
      {[](SkinnedMesh& m) { m.triangles[3][1] = 12; }, "triangle 3: vertex index 12 is out of range"},
      {[](SkinnedMesh& m) { m.triangles[0][0] = 12; }, "triangle 0: vertex index 12 is out of range"},
      {[](SkinnedMesh& m) { m.triangles.back()[2] = 12; }, "triangle 15: vertex index 12 is out of range"},
      {weights({{3, 1.0}}), "vertex 2: joint index 3 is out of range 0..2"},
      {weights({{-1, 1.0}}), "vertex 2: joint index -1 is out of range 0..2"},
      {weights({{1, 0.5}, {0, 0.5}}), "vertex 2: influences are not in increasing order of distinct joints"},
      {weights({{1, 0.5}, {1, 0.5}}), "vertex 2: influences are not in increasing order of distinct joints"},
      {weights({{0, 0.0}, {1, 1.0}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, 1.5}, {1, -0.5}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, NAN}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, 0.1}, {1, 0.9}}), "vertex 2: a weight is not a multiple of 2^-24"},
      {weights({{0, 1 + unit}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, unit / 2}, {1, 1 - unit / 2}}), "vertex 2: a weight is not a multiple of 2^-24"},
      {weights({{0, 0.5 + unit / 2}, {1, 0.5 - unit / 2}}), "vertex 2: a weight is not a multiple of 2^-24"},
      {weights({{0, 0.5}, {1, 0.25}}), "vertex 2: the weights do not sum to 1"},
      {weights({{0, 0.5}, {1, 0.5 - unit}}), "vertex 2: the weights do not sum to 1"},
      {weights({{0, 0.5}, {1, 0.5 + unit}}), "vertex 2: the weights do not sum to 1"},
      {weights({{0, 1.0}, {1, unit}}), "vertex 2: the weights do not sum to 1"},
      {weights({}), "vertex 2: the weights do not sum to 1"},
      {[](SkinnedMesh& m) { m.targets.count = -1; }, "morph targets: not one list of displacements a vertex"},
      {[](SkinnedMesh& m) { m.targets.count = 1; }, "morph targets: not one list of displacements a vertex"},
      {[](SkinnedMesh& m) { m.targets.of_vertex.resize(12); }, "morph targets: not one list of displacements a vertex"},
      {[](SkinnedMesh& m) {
         m.targets = {2, std::vector<Displacements>(11)};
       },
       "morph targets: not one list of displacements a vertex"},
      {[](SkinnedMesh& m) {
         m.targets = {2, std::vector<Displacements>(13)};
       },
       "morph targets: not one list of displacements a vertex"},
      {displaced({{-1, some}}), "vertex 4: displacements are not by increasing targets of the mesh"},
      {displaced({{2, some}}), "vertex 4: displacements are not by increasing targets of the mesh"},
      {displaced({{0, some}, {0, some}}), "vertex 4: displacements are not by increasing targets of the mesh"},
      {displaced({{1, some}, {0, some}}), "vertex 4: displacements are not by increasing targets of the mesh"},
      {displaced({{0, some}, {1, Point3(0, NAN, 0)}}), "vertex 4: its displacement is not finite"},
      {displaced({{0, Point3(-INFINITY, 0, 0)}}), "vertex 4: its displacement is not finite"},
      {displaced({{1, Point3(0, 0, beyond)}}), "vertex 4: its displacement is out of range, beyond 1e40"},
      {displaced({{1, Point3(-beyond, 0, 0)}}), "vertex 4: its displacement is out of range, beyond 1e40"},
  };
}

// Lists changes that are at the edge of the above, and accepted.
std::vector<std::function<void(SkinnedMesh&)>> accepted_models() {
  const auto weights = [](std::vector<Influence> list) { return [=](SkinnedMesh& m) { m.influences[2] = list; }; };
  std::vector<std::function<void(SkinnedMesh&)>> out{
      [](SkinnedMesh& m) { m.name.clear(), m.joints[0].name.clear(); },
      [](SkinnedMesh& m) { m.joints[1].parent = m.joints[2].parent = -1; },
      [](SkinnedMesh& m) { m.joints[2].parent = 1; },
      [](SkinnedMesh& m) { m.triangles.resize(1); },
      [](SkinnedMesh& m) {
        m.triangles[3] = {11, 11, 11};
      },
      [](SkinnedMesh& m) {
        m.triangles[3] = {0, 0, 11};
      },
      [](SkinnedMesh& m) {
        m.vertices.resize(1), m.influences.resize(1), m.triangles = {{0, 0, 0}};
      },
      [](SkinnedMesh& m) {
        m.joints.resize(1), m.influences.assign(m.vertices.size(), {{0, 1.0}});
      },
      weights({{2, 1.0}}),
      weights({{0, unit}, {2, 1 - unit}}),
      weights({{0, unit}, {1, unit}, {2, 1 - 2 * unit}}),
      displaced({}),
      displaced({{1, Point3(0, 0, 0)}}),
      displaced({{0, Point3(1e40, 0, 0)}, {1, Point3(0, -1e40, 0)}}),
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : {1e40, -1e40, 5e-324, -0.0}) {
      out.push_back([=](SkinnedMesh& m) { m.vertices[11][axis] = end; });
      out.push_back([=](SkinnedMesh& m) { m.joints[2].origin[axis] = end; });
    }
  return out;
}

// Returns the scale of the quaternion 1 that is farthest from 1, in this direction, among those whose square is within 1e-6 of 1.
double last_accepted_scale(double direction) {
  double s = std::sqrt(1 + (direction > 1 ? 1e-6 : -1e-6));
  const auto is_within = [](double x) { return std::abs(x * x - 1) <= 1e-6; };
  while (is_within(s)) s = std::nextafter(s, direction);
  while (!is_within(s)) s = std::nextafter(s, 1.0);
  return s;
}

std::string refusal_of_rotation(const Quaternion<double>& q) {
  const SkinnedMesh m = tube();
  Pose pose = reference_pose(m);
  pose[2].rotation = q;
  return refusal([&] { check_pose(m, pose); });
}

}  // namespace

PROPTEST(skinned_mesh) {
  t.example("a model at the edge of what is refused is accepted", {}, [] {
    std::string wrong;
    const auto list = accepted_models();
    for (std::size_t i = 0; i < list.size(); ++i) {
      SkinnedMesh m = tube();
      list[i](m);
      const std::string message = refusal([&] { validate(m); });
      if (!message.empty()) wrong += std::to_string(i) + ": " + message + "; ";
    }
    return Checked(wrong.empty(), static_cast<long>(list.size()), wrong);
  });
  t.example("a rotation is refused from where its squared length differs from 1 by more than 1e-6, on both sides", {}, [] {
    const std::string reason = "tube: pose, joint 2 (joint 2): its rotation is not a quaternion of unit length";
    bool good = true;
    for (const double direction : {0.0, 2.0}) {
      const double last = last_accepted_scale(direction), next = std::nextafter(last, direction);
      for (int i = 0; i < 4; ++i)
        for (const double sign : {-1.0, 1.0}) {
          const Quaternion<double> axis = sign * Quaternion<double>::Unit(i);
          good = good && refusal_of_rotation(axis * last).empty() && refusal_of_rotation(axis * next) == reason;
        }
    }
    return good && refusal_of_rotation({0, 0, 0, 0}) == reason;
  });
  t.holds("a quaternion of unit length that was rounded to float is accepted", {.number_type = "float", .cases = 3000}, [] {
    const auto coordinate = rc::gen::map(rc::gen::arbitrary<int>(), [](int x) { return double(x); });
    Quaternion<double> q(*coordinate, *coordinate, *coordinate, *coordinate);
    RC_PRE(q.norm() > 0);
    RC_ASSERT(refusal_of_rotation(q.normalized().cast<float>().cast<double>()).empty());
  });
  t.example("a pose is refused for a joint too few and one too many, and for any number that is not finite", {}, [] {
    const SkinnedMesh m = tube();
    const auto refused = [&](const std::function<void(Pose&)>& change) {
      Pose pose = reference_pose(m);
      change(pose);
      return refusal([&] { check_pose(m, pose); });
    };
    bool good = refused([](Pose&) {}).empty() &&
                refused([](Pose& p) { p.clear(); }) == "tube: pose: has 0 transforms for 3 joints" &&
                refused([](Pose& p) { p.pop_back(); }) == "tube: pose: has 2 transforms for 3 joints" &&
                refused([](Pose& p) { p.emplace_back(); }) == "tube: pose: has 4 transforms for 3 joints";
    const std::string infinite = "tube: pose, joint 2 (joint 2): its transform is not finite",
                      far = "tube: pose, joint 2 (joint 2): its translation is out of range, beyond 1e40";
    for (const double x : {double(NAN), double(INFINITY), -double(INFINITY)}) {
      for (int i = 0; i < 4; ++i) good = good && refused([&](Pose& p) { p[2].rotation[i] = x; }) == infinite;
      for (int i = 0; i < 3; ++i) good = good && refused([&](Pose& p) { p[2].translation[i] = x; }) == infinite;
    }
    for (int i = 0; i < 3; ++i)
      for (const double sign : {-1.0, 1.0})
        good = good && refused([&](Pose& p) { p[2].translation[i] = sign * 1e40; }).empty() &&
               refused([&](Pose& p) { p[2].translation[i] = sign * beyond; }) == far;
    return good;
  });
  t.example("a model with one thing wrong is refused with its name, the thing and the reason", {}, [] {
    std::string wrong = refusal([] { validate(tube()); });
    for (const Broken& broken : broken_models()) {
      SkinnedMesh m = tube();
      broken.break_it(m);
      const std::string message = refusal([&] { validate(m); });
      if (message != "tube: " + broken.message) wrong += "'" + message + "', not '" + broken.message + "'; ";
    }
    return Checked(wrong.empty(), static_cast<long>(broken_models().size()), wrong);
  });
  t.example("a pose that moves a joint out of range is refused, and one at its end is not", {}, [] {
    const SkinnedMesh m = tube();
    Pose pose = reference_pose(m);
    pose[1].translation[2] = -largest_coordinate;
    const std::string at_the_end = refusal([&] { check_pose(m, pose); });
    pose[1].translation[2] *= 1.1;
    const std::string message = refusal([&] { check_pose(m, pose); });
    return Checked(at_the_end.empty() && message == "tube: pose, joint 1 (joint 1): its translation is out of range, beyond 1e40",
                   2, message);
  });
}

}  // namespace proptests::suite_skinned_mesh
