// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/documents.hpp"

#include "algorithms/certificate/exact_json.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

using nlohmann::json;

std::string model_document(const Character& character) {
  const DefaultFloatEnvironment environment;
  const auto& [model, sets, tree] = std::tie(character.mesh, character.sets, character.tree);
  json document{{"name", model.name}};
  for (const TreeNode& node : tree.nodes) document["nodes"].push_back({node.first_triangle, node.triangle_count});
  for (const int t : tree.triangle_order) document["triangles"].push_back(model.triangles[t]);
  for (int v = 0; v < static_cast<int>(model.vertices.size()); ++v)
    document["vertices"].push_back({{"joints", sets.joints(sets.of_vertex(v))},
                                    {"position", exact_json(model.vertices[v])},
                                    {"weights", exact_json(sets.weights(v))}});
  return canonical(document);
}

std::string pose_document(const Character& character, const SkinningPalette<double>& palette, Skinning skinning) {
  const DefaultFloatEnvironment environment;
  json document{{"skinning", certified_name(palette, skinning)}};
  for (int s = 0; s < character.sets.count(); ++s)
    document["joint_sets"].push_back(exact_json(palette[s], character.sets.joints(s), skinning));
  return canonical(document);
}

CertifiedNode certified_node(const Character& character, int node, const std::string& about, const std::string& model_digest,
                             const std::string& pose_digest) {
  CertifiedNode out{about, node, {}, {}, model_digest, pose_digest};
  const JointSets& sets = character.sets;
  for (const int v : character.vertices[node])
    out.vertices.push_back({v, character.mesh.vertices[v], sets.of_vertex(v), sets.weights(v)});
  for (int s = 0; s < sets.count(); ++s) out.joints.push_back(sets.joints(s));
  return out;
}

}  // namespace refitlab
