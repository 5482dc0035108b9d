// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/posed_model.hpp"

#include <ostream>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "lemmas/exact/lift.hpp"

namespace proptests::gen {
namespace {

using namespace refitlab;

struct JointPlan {
  // The parent is this many joints back (beyond the root, it is the one before).
  int up;
  RationalVec<3> origin;
  RationalQuaternion turn;
};

struct VertexPlan {
  RationalVec<3> position;
  // A part is a joint and a share of the weight; joints are taken modulo their number.
  std::vector<std::pair<int, int>> parts;
};

template <class T>
rc::Gen<std::vector<T>> list_of(int low, int high, const rc::Gen<T>& element) {
  return rc::gen::mapcat(rc::gen::inRange(low, high + 1),
                         [element](int n) { return rc::gen::container<std::vector<T>>(n, element); });
}

RigidTransform<double> turn_about(const Point3& origin, const Quaternion<double>& turn) {
  return {turn, origin - rotate(turn, origin)};
}

PosedModel assemble(const std::vector<JointPlan>& joints, const std::vector<VertexPlan>& vertices) {
  PosedModel out;
  SkinnedMesh& m = out.mesh;
  m.name = "generated";
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int parent = j == 0 ? -1 : std::max(0, static_cast<int>(j) - 1 - joints[j].up);
    m.joints.push_back({"j" + std::to_string(j), parent, lift<double>(joints[j].origin)});
    const auto local = turn_about(m.joints[j].origin, lift<double>(joints[j].turn));
    out.pose.push_back(parent < 0 ? local : compose(out.pose[parent], local));
    out.turns.push_back(joints[j].turn);
  }
  for (const VertexPlan& v : vertices) {
    m.vertices.push_back(lift<double>(v.position));
    std::vector<std::pair<int, double>> weights;
    for (const auto& [joint, share] : v.parts) weights.push_back({joint % static_cast<int>(joints.size()), share});
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
  }
  for (int v = 0; v + 2 < static_cast<int>(m.vertices.size()); ++v) m.triangles.push_back({v, v + 1, v + 2});
  validate(m);
  return out;
}

}  // namespace

rc::Gen<PosedModel> posed_model() {
  const auto joint = rc::gen::apply(
      [](int up, const RationalVec<3>& origin, const RationalQuaternion& turn) {
        return JointPlan{up, origin, turn};
      },
      rc::gen::inRange(0, 3), rational_vector<3>(), unit_quaternion());
  const auto vertex = rc::gen::apply(
      [](const RationalVec<3>& p, const std::vector<std::pair<int, int>>& parts) {
        return VertexPlan{p, parts};
      },
      rational_vector<3>(), list_of(1, 5, rc::gen::pair(rc::gen::inRange(0, 60), small_positive_integer())));
  return rc::gen::apply(assemble, list_of(1, 6, joint), list_of(3, 8, vertex));
}

void showValue(const PosedModel& posed, std::ostream& out) {
  for (std::size_t j = 0; j < posed.turns.size(); ++j) {
    const Joint& joint = posed.mesh.joints[j];
    out << "\n  joint " << j << " of parent " << joint.parent << " at (" << joint.origin.transpose() << ") turned by ";
    rc::show(posed.turns[j], out);
  }
  for (std::size_t v = 0; v < posed.mesh.vertices.size(); ++v) {
    out << "\n  vertex (" << posed.mesh.vertices[v].transpose() << ")";
    for (const auto& i : posed.mesh.influences[v]) out << " " << i.weight << " of joint " << i.joint;
  }
}

}  // namespace proptests::gen
