// SPDX-License-Identifier: GPL-3.0-or-later
// JointMatrices are the matrices of a pose's joints in float, as engines hand them to shaders, laid out for packs.
#pragma once

#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/packs/lanes.hpp"
#include "experiments/engines/joint_kernel.hpp"

namespace refitlab {

// Numbers by joint, as the kernels read them (joint_kernel.hpp). The lanes behind the last joint have `padding`.
class JointNumbers {
 public:
  JointNumbers(int numbers, std::size_t joints, float padding = 0)
      : blocks_(blocks_for<float>(static_cast<int>(joints))),
        count_(numbers),
        lanes_(static_cast<std::size_t>(numbers) * blocks_) {
    for (Lanes<float>& block : lanes_) block.lane.fill(padding);
  }
  int blocks() const { return blocks_; }
  // Joints, with those that are there for whole blocks.
  int padded_count() const { return blocks_ * Lanes<float>::count; }
  float* data() { return lanes_.data()->lane.data(); }
  const float* data() const { return lanes_.data()->lane.data(); }
  float& at(int number, int joint) {
    return lanes_[static_cast<std::size_t>(joint / Lanes<float>::count * count_ + number)].lane[joint % Lanes<float>::count];
  }

 private:
  int blocks_, count_;
  std::vector<Lanes<float>> lanes_;
};

class JointMatrices {
 public:
  // The poses have so many joints, at least one.
  explicit JointMatrices(std::size_t joints) : joints_(static_cast<int>(joints)), matrices_(matrix_numbers, joints) {}

  void set(const Pose& pose, Target target = best_target()) {
    static_assert(sizeof(pose[0]) == pose_numbers * sizeof(double));
    const DefaultFloatEnvironment environment;
    joint_kernels(target).matrices(pose[0].rotation.data(), joints_, matrices_.blocks(), matrices_.data());
  }
  const float* data() const { return matrices_.data(); }

 private:
  int joints_;
  JointNumbers matrices_;
};

inline Box<float> box_of_numbers(const float (&numbers)[6]) {
  return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

}  // namespace refitlab
