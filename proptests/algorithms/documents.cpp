// SPDX-License-Identifier: GPL-3.0-or-later
// Tests certificates that are bound to documents of their model and palette: one that is about these is accepted against them,
// and any other statement in it about a vertex, a node or a joint is noticed.
#include "algorithms/certificate/documents.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/checked_folder.hpp"

namespace proptests::suite_documents {
namespace {

using namespace refitlab;
using nlohmann::json;
using oracle::sealed;

// Holds a certificate of a node, with its documents.
struct Bound {
  Bound(const Character& c, const Pose& pose, const RefitVariant& variant, int n) {
    const auto palette = make_skinning_palette(c.mesh, c.sets, pose, variant.skinning);
    const auto node = c.refit_node(n, palette, variant.pieces);
    model = model_document(c), pose_text = pose_document(c, palette, variant.skinning);
    text = certificate(node, variant.skinning, variant.refit(node),
                       certified_node(c, n, variant.name, sha256(model), sha256(pose_text)));
  }
  json document() const { return json::parse(text); }

  std::string model, pose_text, text;
};

// Returns what the checker says of a certificate against a model and a palette.
std::string said(const std::string& text, const std::string& model, const std::string& palette) {
  TemporaryFolder folder;
  const auto put = [&](const char* name, const std::string& content) {
    std::ofstream(folder.file(name), std::ios::binary) << content;
    return folder.file(name);
  };
  const auto run = oracle::run_checker("--against " + put("model", model) + " --pose " + put("pose", palette) + " " +
                                       put("certificate", text));
  return run.lines.size() == 1 ? run.lines[0] : "nothing said, or too much";
}

bool is_rejected(const std::string& line, const char* reason) {
  return line.starts_with("rejected: ") && line.find(reason) != std::string::npos;
}

void check_random_meshes() {
  const auto plan = gen::classified_plan();
  const auto c = bake(gen::make_mesh(plan));
  std::mt19937 random(plan.seed);
  const Pose pose = gen::random_pose(c.mesh, random, 0.2);
  for (const char* name : {"linear", "control_mixed", "control_miniball"}) {
    const int n = *rc::gen::inRange(0, static_cast<int>(c.tree.nodes.size()));
    const Bound b(c, pose, compared_variant(name), n);
    const std::string line = said(b.text, b.model, b.pose_text);
    // A whole mesh whose weights make a polytope of a hundred vertices is more than the checker accepts.
    if (line.find(": the proofs take too much work") != std::string::npos) {
      RC_TAG("too much work");
      return;
    }
    if (!line.starts_with("accepted: ")) RC_FAIL(line);
    RC_ASSERT(line.find("; all " + std::to_string(c.vertices[n].size()) + " vertices of node " + std::to_string(n) + " of ") !=
              std::string::npos);
  }
  RC_TAG("all accepted");
}

Character tube() { return bake(gen::make_mesh({gen::MeshKind::tube, 6, 4, 3, 2006})); }
Bound of_tube(const Character& c, int n) {
  std::mt19937 random(2006);
  return {c, gen::random_pose(c.mesh, random, 0.2), compared_variant("control_miniball"), n};
}

Checked check_foreign() {
  const Character c = tube();
  const Bound b = of_tube(c, 0);
  struct Foreign {
    const char* what;
    std::string text, model, palette;
    const char* reason;
  };
  std::vector<Foreign> list;
  const auto changed = [&](const char* what, const char* reason, const auto& change) {
    json document = b.document();
    change(document);
    list.push_back({what, sealed(document), b.model, b.pose_text, reason});
  };
  const auto piece_of = [](json& d, int v) -> json& { return d["pieces"][d["vertices"][v]["piece"].get<std::size_t>()]; };
  changed("another model's digest", "the model is another one", [](json& d) { d["model"] = std::string(64, '0'); });
  changed("another pose's digest", "the pose is another one", [](json& d) { d["pose"] = std::string(64, '0'); });
  changed("no such node", "node is none of the model's", [&](json& d) { d["node"] = c.tree.nodes.size(); });
  changed("a node below 0", "node is none of the model's", [](json& d) { d["node"] = -1; });
  changed("a vertex left out", "is left out", [](json& d) { d["vertices"].erase(1); });
  changed("no such vertex", "id is none of the model's", [&](json& d) {
    d["vertices"].push_back(d["vertices"][0]);
    d["vertices"].back()["id"] = c.mesh.vertices.size();
  });
  changed("a vertex below 0", "id is none of the model's", [&](json& d) {
    d["vertices"].push_back(d["vertices"][0]);
    d["vertices"].back()["id"] = -1;
  });
  changed("a vertex that is moved to the middle of its piece", "is not as the model has it",
          [&](json& d) { d["vertices"][1]["position"] = piece_of(d, 1)["reference"]["center"]; });
  changed("a vertex with a weight vertex's weights", "is not as the model has it", [&](json& d) {
    for (std::size_t v = 0; v < d["vertices"].size(); ++v) {
      const json& weight_vertices = piece_of(d, static_cast<int>(v))["weight_vertices"];
      if (weight_vertices.size() == 1 || d["vertices"][v]["weights"] == weight_vertices[0]) continue;
      d["vertices"][v].update({{"weights", weight_vertices[0]}, {"weight_vertices", {0}}, {"shares", {"1"}}});
      return;
    }
  });
  changed("joints of other numbers", "is not as the model has it", [](json& d) { d["joint_sets"][0]["joints"][0] = 9; });
  changed("a vertex with another's number", "is left out", [](json& d) { d["vertices"][1]["id"] = d["vertices"][0]["id"]; });
  json palette = json::parse(b.pose_text);
  palette["joint_sets"][0]["rotation_center"][0] = "7";
  const std::string other_pose = palette.dump(1) + "\n";
  json renamed = b.document();
  renamed["pose"] = sha256(other_pose);
  list.push_back({"joints of another pose", sealed(renamed), b.model, other_pose, "joint_sets[0] is not as the pose has it"});
  json model = json::parse(b.model);
  model["vertices"][0]["position"][0] = "7";
  const std::string other_model = model.dump(1) + "\n";
  list.push_back({"another model", b.text, other_model, b.pose_text, "the model is another one"});
  renamed = b.document();
  renamed["model"] = sha256(other_model);
  list.push_back(
      {"another model by its digest", sealed(renamed), other_model, b.pose_text, "vertices[0] is not as the model has it"});
  if (const auto line = said(b.text, b.model, b.pose_text); !line.starts_with("accepted: ")) return Checked(false, 0, line);
  for (const Foreign& f : list)
    if (const auto line = said(f.text, f.model, f.palette); !is_rejected(line, f.reason))
      return Checked(false, 0, f.what + (": " + line));
  return Checked(true, long(list.size()));
}

Checked check_bad_documents() {
  const Bound b = of_tube(tube(), 0);
  json nowhere = json::parse(b.model), no_member = json::parse(b.pose_text);
  nowhere["nodes"][0][1] = 100000;
  no_member["joint_sets"][0].erase("joints");
  const std::pair<std::string, std::string> pairs[] = {{"", b.pose_text},
                                                       {b.model + "\n", b.pose_text},
                                                       {b.pose_text, b.pose_text},
                                                       {nowhere.dump(1) + "\n", b.pose_text},
                                                       {b.model, ""},
                                                       {b.model, b.model},
                                                       {b.model, no_member.dump(1) + "\n"}};
  for (const auto& [model, palette] : pairs)
    if (const auto line = said(b.text, model, palette); !line.starts_with("unreadable: ")) return Checked(false, 0, line);
  return Checked(oracle::run_checker("--against").status == 2 && oracle::run_checker("--against absent x").status == 2,
                 std::size(pairs));
}

}  // namespace

PROPTEST(documents) {
  t.holds("certificates of random meshes are accepted against their model and palette, with all of the node's vertices",
          {.number_type = "double against rational",
           .cases = 15,
           .degenerate_at_least = 0.3,
           .tags_at_least = {{"all accepted", 0.6}}},
          check_random_meshes);
  t.example("a certificate of another node, vertex, model or palette is rejected, each for its reason", {}, check_foreign);
  t.example("what is no model or no palette is unreadable", {}, check_bad_documents);
  t.example("a node's vertices are those of its triangles in the document", {}, [] {
    const auto c = bake(make_snake(5));
    const json model = json::parse(model_document(c));
    for (std::size_t n = 0; n < c.tree.nodes.size(); ++n) {
      std::vector<int> vertices;
      const int first = model["nodes"][n][0], count = model["nodes"][n][1];
      for (int t = first; t < first + count; ++t)
        for (const int v : model["triangles"][t]) vertices.push_back(v);
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      if (!std::ranges::equal(vertices, c.vertices[static_cast<int>(n)])) return Checked(false, long(n));
    }
    return Checked(model["vertices"].size() == c.mesh.vertices.size(), long(c.tree.nodes.size()));
  });
}

}  // namespace proptests::suite_documents
