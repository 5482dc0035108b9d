// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a glTF file that has at once whatever of the format matters to geometry, and says where its vertices are, by its own
// formulas.
//
// It has two skins in different frames, whose joints are in an order of their own and have nodes between them; a root that scales
// and turns; two nodes of one name; a node with a matrix; a mesh of two primitives (triangles and a strip without indices) with
// two morph targets, one of them sparse, shown by two nodes; a fan of sparse positions; quantised and normalised positions;
// weights as normalised bytes, shorts, and floats in two sets; linear, step and cubic channels, of normalised integers too.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "proptests/gen/gltf_builder.hpp"

namespace proptests::gen {

struct RichPrimitive {
  int node, mesh, primitive, skin;  // indices in the file; -1 for no skin
  std::vector<std::array<int, 3>> triangles;
  std::vector<Eigen::Vector3d> positions;  // as the file has them
  std::vector<std::vector<Eigen::Vector3d>> targets;
  std::vector<std::vector<std::pair<int, double>>> weights;  // by vertex: joint of the skin, weight
};

class RichGltf {
 public:
  // uneven makes the joint "tip" scale by another factor along one axis, as its clip says. moving makes the morph weights move.
  // turning makes a joint turn along a spline, whose quaternions are off unit length.
  RichGltf(bool uneven, bool moving, bool turning = true);

  // Returns the primitives in the order in which the scene shows them. A mesh that a second node shows with the same skin is
  // there once for each.
  const std::vector<RichPrimitive>& primitives() const { return primitives_; }
  // Returns the vertices of a primitive in the world at a time of the clip "move" in [0, 2].
  std::vector<Eigen::Vector3d> posed(const RichPrimitive& primitive, double time) const;
  // Returns the transform from the frame of a node of the file to the world, at a time of that clip. Nodes are not in the order
  // in which the scene has them.
  Eigen::Matrix4d global(int node, double time) const;

  GltfBuilder file;

 private:
  Eigen::Matrix4d local(int node, double time) const;
  std::vector<double> morph_weights(double time) const;
  void add_nodes();
  void add_skins();
  void add_body();
  void add_fan();
  void add_loose();
  void add_clip();

  bool uneven_, moving_, turning_;
  std::vector<RichPrimitive> primitives_;
  std::vector<std::vector<int>> joints_;               // by skin
  std::vector<std::vector<Eigen::Matrix4d>> offsets_;  // by skin
};

}  // namespace proptests::gen
