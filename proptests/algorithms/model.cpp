// What makes a model, or a posture of it, one that is refused.
#include "algorithms/model/model.hpp"

#include <cmath>
#include <functional>

#include "algorithms/skinning/skinning_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness.hpp"

namespace proptests {
namespace {

using namespace refitlab;

Model tube() { return gen::make_mesh({gen::MeshKind::tube, 3, 4, 3, 7}); }

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

struct Broken {
  std::function<void(Model&)> break_it;
  std::string message;
};

// With ten joints and two influences of vertex 2.
std::vector<Broken> broken_models() {
  const auto weights = [](std::vector<Influence> list) { return [=](Model& m) { m.influences[2] = list; }; };
  return {
      {[](Model& m) { m.joints.clear(); }, "skeleton: no joints"},
      {[](Model& m) { m.vertices.clear(); }, "mesh: no triangles"},
      {[](Model& m) { m.triangles.clear(); }, "mesh: no triangles"},
      {[](Model& m) { m.influences.pop_back(); }, "mesh: not one list of influences a vertex"},
      {[](Model& m) { m.joints[1].parent = 1; }, "joint 1 (joint 1): its parent does not come before it"},
      {[](Model& m) { m.joints[1].parent = -2; }, "joint 1 (joint 1): its parent does not come before it"},
      {[](Model& m) { m.joints[2].origin[1] = NAN; }, "joint 2 (joint 2): its origin is not finite"},
      {[](Model& m) { m.joints[2].origin[1] = 2e40; }, "joint 2 (joint 2): its origin is out of range, beyond 1e40"},
      {[](Model& m) { m.vertices[4][2] = INFINITY; }, "vertex 4: its position is not finite"},
      {[](Model& m) { m.vertices[4][2] = -2e40; }, "vertex 4: its position is out of range, beyond 1e40"},
      {[](Model& m) { m.triangles[3][1] = -1; }, "triangle 3: vertex index -1 is out of range"},
      {[](Model& m) { m.triangles[3][1] = 12; }, "triangle 3: vertex index 12 is out of range"},
      {weights({{3, 1.0}}), "vertex 2: joint index 3 is out of range 0..2"},
      {weights({{-1, 1.0}}), "vertex 2: joint index -1 is out of range 0..2"},
      {weights({{1, 0.5}, {0, 0.5}}), "vertex 2: influences are not in increasing order of distinct joints"},
      {weights({{1, 0.5}, {1, 0.5}}), "vertex 2: influences are not in increasing order of distinct joints"},
      {weights({{0, 0.0}, {1, 1.0}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, 1.5}, {1, -0.5}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, NAN}}), "vertex 2: a weight is not in (0, 1]"},
      {weights({{0, 0.1}, {1, 0.9}}), "vertex 2: a weight is not a multiple of 2^-24"},
      {weights({{0, 0.5}, {1, 0.25}}), "vertex 2: the weights do not sum to 1"},
      {weights({}), "vertex 2: the weights do not sum to 1"},
  };
}

}  // namespace

PROPTEST(model) {
  t.example("a model with one thing wrong is refused with its name, the thing and the reason", {}, [] {
    std::string wrong = refusal([] { validate(tube()); });
    for (const Broken& broken : broken_models()) {
      Model m = tube();
      broken.break_it(m);
      const std::string message = refusal([&] { validate(m); });
      if (message != "tube: " + broken.message) wrong += "'" + message + "', not '" + broken.message + "'; ";
    }
    return Checked(wrong.empty(), static_cast<long>(broken_models().size()), wrong);
  });
  t.example("a posture that moves a joint out of range is refused, and one at its end is not", {}, [] {
    const Model m = tube();
    Posture posture = reference_posture(m);
    posture[1].translation[2] = -largest_coordinate;
    const std::string at_the_end = refusal([&] { check_posture(m, posture); });
    posture[1].translation[2] *= 1.1;
    const std::string message = refusal([&] { check_posture(m, posture); });
    return Checked(at_the_end.empty() &&
                       message == "tube: posture, joint 1 (joint 1): its translation is out of range, beyond 1e40",
                   2, message);
  });
}

}  // namespace proptests
