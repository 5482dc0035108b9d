// Scenes: the models and postures that every experiment shares, defined once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/refit/variants.hpp"
#include "algorithms/tree/pieces.hpp"

namespace refitlab {

// A model with all that is built once from it.
struct Character {
  explicit Character(Model m)
      : model(std::move(m)),
        sets(model),
        tree(build_sphere_tree(model, sets)),
        vertices(tree, model),
        joint_set_pieces(tree, vertices, model, sets, {.most_pieces = 1}),
        clusters(tree, vertices, model, sets, {.most_pieces = most_clusters}) {}

  // What a variant looks at to refit a node.
  RefitNode<double> refit_node(int node, std::span<const JointSetPose<double>> pose, Pieces pieces) const {
    switch (pieces) {
      case Pieces::joint_sets: return joint_set_pieces.refit_node(tree, node, pose);
      case Pieces::clusters: return clusters.refit_node(tree, node, pose);
      default: return tree.refit_node(node, pose);
    }
  }
  // The balls of all nodes.
  std::vector<Ball3<double>> refit_all(const RefitVariant& variant, const SkinningPose<double>& pose) const {
    std::vector<Ball3<double>> balls;
    for (std::size_t n = 0; n < tree.nodes.size(); ++n)
      balls.push_back(variant.refit(refit_node(static_cast<int>(n), pose, variant.pieces)));
    return balls;
  }

  Model model;
  JointSets sets;
  SphereTree tree;
  NodeVertices vertices;
  PieceTable joint_set_pieces, clusters;
};

// One or more postures that are reported together: the sampled times of a clip, or a single one.
struct PostureSet {
  std::string name;
  std::vector<Posture> postures;
};

// The two procedural models and the real ones found in folder, by file name; absent: the real ones that are not there.
struct DefaultModels {
  std::vector<Model> models;
  std::vector<std::string> absent;
};
// The model in a file, named as the file without its folder.
Model load_named(const std::string& path);
DefaultModels default_models(const std::string& folder);

// Every clip at this many times, evenly spread from start to end.
std::vector<PostureSet> posture_sets(const Model& model, int times_per_clip);

// The posture of the paper's Figure 5: the end of the clip "twist" if the model has one, else a neck turned by 170 degrees.
struct NamedPosture {
  std::string name;
  Posture posture;
};
NamedPosture figure_twist(const Model& model);

// The posture that turns one joint and all below it about the joint's bone axis, from the reference posture.
Posture twist_posture(const Model& model, int joint, double radians);

// The joint whose twist shows the paper's Figure 5: a neck, else a head, spine or wrist by name, else the one in the
// middle of the hierarchy.
int twist_joint(const Model& model);

}  // namespace refitlab
