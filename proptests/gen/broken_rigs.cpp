// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/broken_rigs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proptests::gen {

std::vector<BrokenRig> broken_rigs() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto weights = [](std::array<float, 4> w) { return [=](RiggedGltf& s) { s.meshes[0].weights[0][7] = w; }; };
  const auto scale_track = [](int node, std::vector<float> values) {
    return [=](RiggedGltf& s) { s.clips[0].tracks.push_back({node, "scale", {0, 1}, values}); };
  };
  return {
      {"a negative weight", weights({1.5f, -0.5f, 0, 0}), {"vertex 7", "weight -0.5", "negative"}},
      {"a weight that is NaN", weights({nan, 1, 0, 0}), {"vertex 7", "weight", "not a finite number"}},
      {"an infinite weight", weights({INFINITY, 0, 0, 0}), {"vertex 7", "weight", "not a finite number"}},
      {"a vertex without weight", weights({0, 0, 0, 0}), {"vertex 7", "no weight"}},
      {"weights far from a sum of 1", weights({0.5f, 0, 0, 0}), {"vertex 7", "sum to 0.5"}},
      {"a joint index beyond the skin",
       [](auto& s) {
         s.meshes[0].joints[0][7] = {3, 0, 0, 0};
       },
       {"vertex 7", "joint index 3 is out of range 0..2"}},
      {"sets of joints and weights of different lengths",
       [](auto& s) { s.meshes[0].weights[0].pop_back(); },
       {"mesh 0", "do not fit the vertices"}},
      {"joints without weights", [](auto& s) { s.meshes[0].weights.clear(); }, {"mesh 0", "do not go together"}},
      {"a mesh without vertices",
       [](auto& s) {
         s.meshes[0] = {{}, {}, {{}}, {{}}};
       },
       {"mesh 0", "is empty"}},
      {"a vertex at NaN", [](auto& s) { s.meshes[0].positions[3][1] = nan; }, {"vertex 3", "not finite"}},
      {"a triangle of a vertex out of range", [](auto& s) { s.meshes[0].indices[5] = 999; }, {"index 5", "out of range"}},
      {"too few inverse bind matrices",
       [](auto& s) { s.skins[0].inverse_bind.pop_back(); },
       {"skin", "2 inverse bind matrices for 3 joints"}},
      {"a singular inverse bind matrix", [](auto& s) { s.skins[0].inverse_bind[1] = {}; }, {"bone 'j1'", "singular"}},
      {"no skin",
       [](auto& s) { s.nodes.back().skin = -1, s.skins.clear(), s.meshes[0].joints.clear(), s.meshes[0].weights.clear(); },
       {"no skin"}},
      {"fewer keys than times", [](auto& s) { s.clips[0].tracks[1].values.resize(4); }, {"'bend'", "2 times but 1 values"}},
      {"a channel without keys",
       [](auto& s) { s.clips[0].tracks[1].times.clear(), s.clips[0].tracks[1].values.clear(); },
       {"'bend'", "0 times but 0 values"}},
      {"a NaN in a rotation key",
       [](auto& s) { s.clips[0].tracks[1].values[5] = nan; },
       {"clip 'bend'", "joint 'j1'", "1.000000 s", "not finite"}},
      {"a NaN in a position key",
       [](auto& s) { s.clips[0].tracks[3].values[3] = nan; },
       {"clip 'bend'", "joint 'j0'", "1.000000 s", "not finite"}},
      {"a NaN in a key's time", [](auto& s) { s.clips[0].tracks[1].times[1] = nan; }, {"clip 'bend'", "joint 'j1'", "nan s"}},
      {"a zero quaternion",
       [](auto& s) { std::fill_n(s.clips[0].tracks[1].values.begin() + 4, 4, 0.0f); },
       {"clip 'bend'", "joint 'j1'", "zero quaternion"}},
      {"keys that go back in time",
       [](auto& s) {
         s.clips[0].tracks[1].times = {1, 0};
       },
       {"clip 'bend'", "joint 'j1'", "order of time"}},
      {"an uneven scale",
       [](auto& s) {
         s.nodes[2].scale = {1, 2, 1};
       },
       {"clip 'bend'", "joint 'j2'", "scales unevenly", "1 to 2"}},
      {"a shear", [](auto& s) { s.skins[0].inverse_bind[2][4] = 0.5f; }, {"joint 'j2'", "shears"}},
      {"a joint that is larger than others",
       [](auto& s) {
         s.nodes[2].scale = {2, 2, 2};
       },
       {"joint 'j2'", "scales by 2"}},
      {"a joint that is mirrored alone",
       [](auto& s) {
         s.nodes[2].scale = {-1, 1, 1};
       },
       {"joint 'j2'", "mirrors"}},
      {"a scale that grows in a clip", scale_track(0, {1, 1, 1, 3, 3, 3}), {"clip 'bend'", "joint 'j0'", "1 s", "scales by 3"}},
      {"a shear without any clip",
       [](auto& s) { s.clips.clear(), s.skins[0].inverse_bind[2][4] = 0.5f; },
       {"joint 'j2'", "shears"}},
  };
}

}  // namespace proptests::gen
