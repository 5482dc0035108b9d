// SPDX-License-Identifier: GPL-3.0-or-later
// A Scene is what a model file says, in double and whatever its format, before its meshes are bound to one reference pose.
//
// Lengths are in units of the file, times in seconds, and matrices act on columns.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

struct ScenePrimitive {
  std::string label;  // for errors, such as "mesh 2 'body', primitive 1"
  std::vector<Eigen::Vector3d> positions;
  std::vector<Triangle> triangles;
  // Each vertex has a list of joints of the skin with weights. A primitive without weights has none.
  std::vector<std::vector<std::pair<int, double>>> weights = {};
  // Displacements are by morph target and vertex.
  std::vector<std::vector<Eigen::Vector3d>> targets = {};
};

struct SceneMesh {
  std::vector<ScenePrimitive> primitives;  // with the same number of morph targets
};

struct SceneSkin {
  std::vector<int> joints;               // nodes of the scene
  std::vector<Eigen::Matrix4d> offsets;  // by joint: the inverse bind matrices
};

// A ShownMesh is a node that shows a mesh. skin is -1 if there is none.
struct ShownMesh {
  int node, mesh, skin;
  std::vector<double> weights = {};  // by morph target, where no clip moves them
};

struct Scene {
  std::string file;
  std::vector<SceneNode> nodes;  // depth first, parents before their children
  std::vector<SceneMesh> meshes;
  std::vector<SceneSkin> skins;
  std::vector<ShownMesh> shown;  // in the order of their nodes
  std::vector<Animation> animations;
  std::vector<std::string> notes = {};  // what of the file is not here, in sentences
};

}  // namespace refitlab
