// Reach: a box that holds all of a skinned character, from the transforms of its joints alone.
//
// What a query asks first: it needs no rotation centers and no blends, and its price goes by joints and joint-sets, not
// by vertices. By b7_reach a vertex v of a joint-set is within ||v - f|| + 3/4 sqrt(1 - c) A of the hull of the images
// C_k f of any point f, where c is the least (q_k, q_l) of its joints and A^2 the sum of ||C_k f - C_l f||^2 over their
// pairs. What holds for some joints holds for fewer of them: so joint-sets all of whose joints another one has share
// its f, and few groups are left.
#pragma once

#include <Eigen/Core>

#include "algorithms/collide/box_kernel.hpp"
#include "algorithms/weights/joint_sets.hpp"

namespace refitlab {

class Reach {
 public:
  // model and sets outlive this.
  Reach(const Model& model, const JointSets& sets, Skinning skinning);

  // In the world, around all that apply(placement, skin()) yields. posture and placement are rigid, as check_posture
  // has it. Infinite where nothing is known: for dual quaternions more than half a turn apart, and for numbers that are
  // not finite or beyond 1e15.
  Box6 box(const Posture& posture, const RigidTransform<double>& placement) const;

 private:
  using Four = Eigen::Array4f;  // x, y, z and an unused fourth; or a quaternion

  // Joint-sets within one of them.
  struct Group {
    std::vector<int> sets;    // the largest first
    Ball3<double> reference;  // around their vertices: about f, which is the rotation center for Skinning::hejl
    std::vector<int> joints;
    Four center;             // f
    float radius, unsolved;  // with what may be lost; what A may lack, see reach.cpp
  };
  // A joint's transform and then the placement's rotation.
  struct Turned {
    Four axes[3], origin, rotation;
  };
  struct Bounds {
    Four low, high;
    void add(const Four& l, const Four& h) { low = low.min(l), high = high.max(h); }
  };

  std::vector<Group> make_groups() const;
  template <bool strays>
  static bool add(const Group& group, const Turned* turned, Bounds& bounds);
  void add_about_centers(const Group& group, const Posture& posture, const Quaternion<double>& rotation,
                         Box6& box) const;

  const Model& model_;
  const JointSets& sets_;
  const Skinning skinning_;
  const std::vector<Group> groups_;
};

}  // namespace refitlab
