// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a baked character read from its bytes is as it was, and that bytes that are no such file, or do not fit together,
// are refused.
#include "algorithms/runtime/tree/character_file.hpp"

#include <array>
#include <cmath>
#include <functional>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests::suite_character_file {
namespace {

using namespace refitlab;

// Returns a character with a morph target that moves every second vertex.
Character small_character() {
  SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
  mesh.targets = {2, std::vector<std::vector<Displacement<double>>>(mesh.vertices.size())};
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 2) mesh.targets.of_vertex[v] = {{1, Point3(0.1, 0, 0.2)}};
  return bake(std::move(mesh));
}

// Returns the message of the refusal, or nothing if the bytes are read.
std::string refusal(std::string_view bytes) {
  try {
    character_of(bytes, "man.refitlab");
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

// Holds a change of a character, and words of the refusal of its bytes.
struct Fault {
  const char* words;
  std::function<void(Character&)> make;
};

PieceTable& mixed(Character& c) { return c.pieces[static_cast<std::size_t>(Pieces::mixed)]; }
PieceTable& of_joint_sets(Character& c) { return c.pieces[static_cast<std::size_t>(Pieces::joint_sets)]; }

// Puts nodes with all triangles above the root, so that it is below so many others.
void deepen(Character& c, int levels) {
  std::vector<TreeNode> nodes;
  const std::vector<NodePiece> own(c.tree.pieces.begin(), c.tree.pieces.begin() + c.tree.nodes[0].piece_count);
  for (int level = 1; level <= levels; ++level) {
    TreeNode above = c.tree.nodes[0];
    above.first_piece = static_cast<int>(own.size()) * (level - 1);
    c.tree.pieces.insert(c.tree.pieces.begin(), own.begin(), own.end());
    above.parent = level - 2, above.first_child = level, above.child_count = 1, above.level = level;
    nodes.push_back(above);
  }
  for (TreeNode node : c.tree.nodes) {
    node.parent += levels, node.first_child += levels, node.level += levels;
    node.first_piece += static_cast<int>(own.size()) * levels;
    nodes.push_back(node);
  }
  c.tree.nodes = std::move(nodes);
}

// Adds a node behind the last one, equal to it.
void lengthen(Character& c) {
  TreeNode node = c.tree.nodes.back();
  const std::vector<NodePiece> own(c.tree.pieces.end() - node.piece_count, c.tree.pieces.end());
  node.first_piece += node.piece_count;
  c.tree.nodes.push_back(node);
  c.tree.pieces.insert(c.tree.pieces.end(), own.begin(), own.end());
}

// Puts this in place of the first weight vertex of three joints.
void set_weight_vertices(Character& c, const std::array<double, 3>& weights) {
  c = bake(gen::make_mesh({gen::MeshKind::tube, 4, 6, 3, 1}));
  for (const NodePiece& piece : c.tree.pieces)
    if (c.sets.joints(piece.joint_set).size() == 3)
      for (int i = 0; i < 3; ++i) c.tree.weight_vertices[static_cast<std::size_t>(piece.first_weight + i)] = weights[i];
}
// Puts a weight vertex beside the simplex, although no weight is above 1 and their sum is 1.
void leave_simplex(Character& c) { set_weight_vertices(c, {-0.25, 1, 0.25}); }

// Lets a piece begin at a weight vertex in the midst of those of an earlier piece of its joint-set.
void begin_within_another(std::vector<NodePiece>& pieces, const JointSets& sets) {
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      if (pieces[i].joint_set != pieces[j].joint_set || pieces[i].weight_vertex_count < 2) continue;
      const auto joints = static_cast<int>(sets.joints(pieces[i].joint_set).size());
      pieces[j].first_weight = pieces[i].first_weight + joints, pieces[j].weight_vertex_count = 1;
      return;
    }
}

// Gives all triangles of the root's second child to its first.
void empty_a_child(std::vector<TreeNode>& nodes) {
  nodes[1].triangle_count += nodes[2].triangle_count, nodes[2].first_triangle += nodes[2].triangle_count;
  nodes[2].triangle_count = nodes[2].vertex_count = 0;
}

// Returns faults that put numbers out of range at either end, or at neither, in nodes, pieces and displacements.
std::vector<Fault> faults_of_ranges() {
  const auto node = [](auto change) { return [=](Character& c) { change(c.tree.nodes); }; };
  const auto levels = [](int by) {
    return [=](Character& c) {
      for (TreeNode& n : c.tree.nodes) n.level += by;
    };
  };
  std::vector<Fault> out{
      {"is no root", node([](auto& n) { n[0].parent = -2; })},
      {"is no root", levels(-1)},
      {"is no root", levels(1)},
      {"not part of its parent's", node(empty_a_child)},
      {"not part of its parent's", node([](auto& n) { n[2].triangle_count = -1; })},
      {"not in [0, 1]", [](Character& c) { c.tree.weight_vertices[0] = -0x1p-24; }},
      {"not in [0, 1]", [](Character& c) { c.tree.weight_vertices[0] = 1 + 0x1p-24; }},
      {"not in [0, 1]", leave_simplex},
      {"one has a weight vertex with a weight that is not in", [](Character& c) { mixed(c).weight_vertices[0] = -1; }},
      {"weight vertices of another one", [](Character& c) { begin_within_another(c.tree.pieces, c.sets); }},
      {"weight vertices of another one", [](Character& c) { begin_within_another(of_joint_sets(c).pieces, c.sets); }},
      {"a joint-set names a joint-set", [](Character& c) { c.tree.pieces[0].joint_set = -1; }},
      {"a joint-set names weight vertices", [](Character& c) { c.tree.pieces[0].weight_vertex_count = 1 << 30; }},
      {"a joint-set names weight vertices", [](Character& c) { c.tree.pieces[0].first_weight = 1 << 30; }},
      {"name a ball out of range", [](Character& c) { mixed(c).pieces[0].reference = -1; }},
      {"one names a joint-set", [](Character& c) { mixed(c).pieces[0].joint_set = 1 << 30; }},
      {"vertices out of range", node([](auto& n) { n.back().first_vertex = 1 << 30; })},
      {"joint index", [](Character& c) { c.mesh.influences[0][0].joint = 2; }},
      {"vertex index", [](Character& c) { c.mesh.triangles[1][2] = -1; }},
  };
  for (const double radius : {-1e-300, 4.1e40, 1e300, HUGE_VAL, std::nan("")}) {
    out.push_back({"its ball is none", node([=](auto& n) { n[2].reference.radius = radius; })});
    out.push_back({"have a ball that is none", [=](Character& c) { mixed(c).references.back().radius = radius; }});
    out.push_back(
        {"tree: its displacements have a ball", [=](Character& c) { c.tree.displacements.balls[0].ball.radius = radius; }});
  }
  for (const double x : {-1.1e40, 1.1e40, -HUGE_VAL})
    out.push_back({"its ball is none", node([=](auto& n) { n[2].reference.center[1] = x; })});
  for (const int target : {-1, 2}) {
    out.push_back({"increasing targets", [=](Character& c) { c.mesh.targets.of_vertex[0][0].target = target; }});
    out.push_back({"tree: its displacements are not by", [=](Character& c) { c.tree.displacements.balls[0].target = target; }});
    out.push_back(
        {"pieces: their displacements are not by", [=](Character& c) { mixed(c).displacements.balls[0].target = target; }});
  }
  return out;
}

std::vector<Fault> faults() {
  const auto node = [](auto change) { return [=](Character& c) { change(c.tree.nodes); }; };
  return {
      {"vertex index", [](Character& c) { c.mesh.triangles[1][2] = 1 << 20; }},
      {"joint index", [](Character& c) { c.mesh.influences[0][0].joint = -1; }},
      {"not finite", [](Character& c) { c.mesh.vertices[3][1] = std::nan(""); }},
      {"tree: has no nodes", [](Character& c) { c.tree.nodes.clear(); }},
      {"each triangle once", [](Character& c) { c.tree.triangle_order[0] = c.tree.triangle_order[1]; }},
      {"each triangle once", [](Character& c) { c.tree.triangle_order.pop_back(); }},
      {"is no root", node([](auto& n) { n[0].parent = 0; })},
      {"does not have all triangles", node([](auto& n) { --n[0].triangle_count; })},
      {"its ball is none", node([](auto& n) { n[2].reference.radius = -1; })},
      {"its ball is none", node([](auto& n) { n[2].reference.center[0] = INFINITY; })},
      {"its ball is none", node([](auto& n) { n[2].reference.center[0] = std::nan(""); })},
      {"its ball is none", node([](auto& n) { n[2].reference.center[1] = std::nan(""); })},
      {"its ball is none", node([](auto& n) { n[2].reference.center[2] = std::nan(""); })},
      {"its ball is none", node([](auto& n) { n[2].reference.radius = std::nan(""); })},
      {"is below more than 63 others", [](Character& c) { deepen(c, 63); }},
      {"not part of its parent's", node([](auto& n) { n.back().triangle_count = 1 << 30; })},
      {"less than no children", node([](auto& n) { n.back().child_count = -1; })},
      {"not those that follow", node([](auto& n) { n[0].first_child = 0; })},
      {"not those that follow", node([](auto& n) { n[0].child_count = 1 << 30; })},
      {"its vertices are not those", node([](auto& n) { n.back().vertex_count = 1; })},
      {"vertices out of range", node([](auto& n) { n.back().first_vertex = -1; })},
      {"not the child of its parent", node([](auto& n) { n.back().parent = 0; })},
      {"not the child of its parent", node([](auto& n) { n.back().level += 1; })},
      {"not part of its parent's", node([](auto& n) { n[n[0].first_child].first_triangle += 1; })},
      {"do not have all of its triangles", node([](auto& n) { ++n[n[0].child_count].triangle_count; })},
      {"joint-sets out of range", node([](auto& n) { n[1].first_piece = 1 << 30; })},
      {"without a parent", lengthen},
      {"a joint-set names a joint-set", [](Character& c) { c.tree.pieces[0].joint_set = 99; }},
      {"a joint-set names weight vertices", [](Character& c) { c.tree.pieces[0].weight_vertex_count = 0; }},
      {"a joint-set names weight vertices", [](Character& c) { c.tree.pieces[0].first_weight = -1; }},
      {"not in [0, 1]", [](Character& c) { c.tree.weight_vertices[0] = std::nan(""); }},
      {"do not sum to 1", [](Character& c) { c.tree.weight_vertices[0] *= 0.5; }},
      {"belong to no node", [](Character& c) { mixed(c).first.clear(); }},
      {"as many nodes", [](Character& c) { mixed(c).first.pop_back(); }},
      {"order of the nodes", [](Character& c) { mixed(c).first[1] = 1 << 30; }},
      {"missing for a node", [](Character& c) { mixed(c).first[1] = mixed(c).first[0]; }},
      {"have a ball that is none", [](Character& c) { mixed(c).references.back().radius = -1; }},
      {"have a ball that is none", [](Character& c) { mixed(c).references.back().center[1] = std::nan(""); }},
      {"name a ball out of range", [](Character& c) { mixed(c).pieces[0].reference = 1 << 30; }},
      {"one names a joint-set", [](Character& c) { mixed(c).pieces[0].joint_set = -1; }},
      {"one has a weight vertex", [](Character& c) { mixed(c).weight_vertices[0] = 2; }},
      {"not one list of displacements", [](Character& c) { c.mesh.targets.of_vertex.pop_back(); }},
      {"not one list of displacements", [](Character& c) { c.mesh.targets.count = -1; }},
      {"increasing targets", [](Character& c) { c.mesh.targets.of_vertex[0][0].target = 2; }},
      {"increasing targets", [](Character& c) { c.mesh.targets.of_vertex[0].push_back(c.mesh.targets.of_vertex[0][0]); }},
      {"its displacement is not finite", [](Character& c) { c.mesh.targets.of_vertex[0][0].by[1] = std::nan(""); }},
      {"its displacement is out of range", [](Character& c) { c.mesh.targets.of_vertex[0][0].by[1] = -2e40; }},
      {"tree: its displacements are missing", [](Character& c) { c.tree.displacements = {}; }},
      {"tree: its displacements are not of as many", [](Character& c) { c.tree.displacements.first.pop_back(); }},
      {"tree: its displacements have a ball", [](Character& c) { c.tree.displacements.balls[0].ball.radius = -1; }},
      {"pieces: their displacements are missing", [](Character& c) { mixed(c).displacements = {}; }},
      {"pieces: their displacements are not by", [](Character& c) { mixed(c).displacements.balls[0].target = 7; }},
      {"belong to no node", [](Character& c) { c.pieces[0].displacements.first = {0}; }},
      {"belong to no node",
       [](Character& c) {
         c.pieces[0].references = {{{0, 0, 0}, 0}};
       }},
      {"belong to no node", [](Character& c) { c.pieces[0].weight_vertices = {1}; }},
      {"those of nodes as a whole are the tree's", [](Character& c) { c.pieces[0] = mixed(c); }},
      {"a joint-set names a ball", [](Character& c) { c.tree.pieces.back().reference = 1 << 29; }},
      {"its joint-sets are not those that follow", node([](auto& n) { n[1].first_piece = n[0].first_piece; })},
      {"weight vertices of another one", [](Character& c) { c.tree.pieces.back().first_weight = c.tree.pieces[0].first_weight; }},
  };
}

// Makes a mesh with most of its vertices on a face of the cube in which coordinates are accepted, and some on an edge or at a
// corner of it.
SkinnedMesh on_faces_of_the_cube(std::mt19937& random) {
  constexpr double end = 1e40;
  std::uniform_real_distribution<double> anywhere(-end, end);
  const auto axis = random() % 3;
  const double side = random() % 2 ? end : -end;
  SkinnedMesh m;
  m.name = "on the cube";
  m.joints = {{"a", -1, {0, 0, 0}}, {"b", 0, {side, 0, 0}}};
  const auto count = 4 + static_cast<int>(random() % 8);
  for (int v = 0; v < count; ++v) {
    Point3 p(anywhere(random), anywhere(random), anywhere(random));
    if (v > 0 || random() % 2) p[static_cast<int>(axis)] = side;
    if (random() % 4 == 0) p[static_cast<int>((axis + 1) % 3)] = random() % 2 ? end : -end;
    m.vertices.push_back(p);
    if (random() % 2) m.influences.push_back({{0, 1.0}});
    else m.influences.push_back({{0, 0.75}, {1, 0.25}});
  }
  for (int v = 0; v + 2 < count; ++v) m.triangles.push_back({v, v + 1, v + 2});
  if (random() % 2) {
    m.targets = {1, {}};
    for (int v = 0; v < count; ++v) m.targets.of_vertex.push_back({{0, Point3(side, anywhere(random), -end)}});
  }
  validate(m);
  return m;
}

void characters_at_the_end_of_what_is_accepted(Suite& t) {
  t.holds("a character with vertices on the faces of the cube of what is accepted is read as it was written",
          {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.2, .degenerate_at_most = 0.8}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const Character c = bake(on_faces_of_the_cube(random), {.triangles_per_leaf = *rc::gen::inRange(1, 10)});
            RC_CLASSIFY(c.mesh.targets.count > 0, "degenerate");
            const double farthest = c.tree.nodes[0].reference.center.cwiseAbs().maxCoeff();
            RC_CLASSIFY(farthest > 1e40, "the root's center is beyond the face by rounding");
            const std::string bytes = bytes_of(c), refused = refusal(bytes);
            RC_LOG() << refused;
            RC_ASSERT(refused.empty());
            RC_ASSERT(bytes_of(character_of(bytes, "any")) == bytes);
          });
}

void spoiled_files_are_refused(Suite& t) {
  t.example("a file that ends at any byte is refused, and so is one with a byte more", {}, [] {
    const std::string bytes = bytes_of(small_character());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      if (refusal(std::string_view(bytes).substr(0, size)).empty()) return Checked(false, long(size), "it is read");
    return Checked(refusal(bytes).empty() && !refusal(bytes + "x").empty(), static_cast<long>(bytes.size()));
  });
  t.example("a file with a byte changed is refused, whichever it is", {}, [] {
    const std::string bytes = bytes_of(small_character());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ 0x10);
      if (refusal(changed).empty()) return Checked(false, long(at), "it is read");
    }
    return Checked(true, static_cast<long>(bytes.size()));
  });
  t.example("parts that do not fit each other are refused for what they are, whatever the checksum", {}, [] {
    std::vector<Fault> all = faults();
    for (const Fault& fault : faults_of_ranges()) all.push_back(fault);
    std::string wrong;
    for (const Fault& fault : all) {
      Character c = small_character();
      fault.make(c);
      if (const std::string found = refusal(bytes_of(c)); found.find(fault.words) == std::string::npos)
        wrong += std::string(fault.words) + ": '" + found + "'; ";
    }
    return Checked(wrong.empty(), static_cast<long>(all.size()), wrong);
  });
  t.example("weight vertices at corners of the simplex are read", {}, [] {
    Character c = small_character();
    set_weight_vertices(c, {0, 1, 0});
    return refusal(bytes_of(c)).empty();
  });
  t.example("balls at the end of what is accepted are read", {}, [] {
    Character c = small_character();
    c.tree.nodes[1].reference = {Point3(-1e40, -1e40, -1e40), 4e40}, c.tree.nodes[2].reference = {Point3(0, 1e40, 0), 0};
    const std::string refused = refusal(bytes_of(c));
    return Checked(refused.empty(), 2, refused);
  });
  t.example("what is no baked character, of another version, or not there is refused by name", {}, [] {
    std::string bytes = bytes_of(small_character()), other = bytes;
    other[8] = 3;
    const bool named = refusal("solid cube") == "man.refitlab: file: is no baked character" &&
                       refusal(other) == "man.refitlab: baked character: is of version 3, not 2, which is read: bake it again" &&
                       refusal(bytes + "x") == "man.refitlab: baked character: goes on after its end" &&
                       refusal(bytes.substr(0, 40)) == "man.refitlab: baked character: ends early";
    bytes.back() ^= 1;
    const bool sum = refusal(bytes) == "man.refitlab: baked character: its checksum is not that of its bytes";
    try {
      read_character("/nowhere/man.refitlab");
    } catch (const ModelError& e) {
      return Checked(named && sum && e.what() == std::string("/nowhere/man.refitlab: file: cannot be read"), 6, e.what());
    }
    return Checked(false);
  });
}

}  // namespace

PROPTEST(character_file) {
  t.holds("a character that was read refits as the one that was written, to the last bit, and has the same bytes",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3, .tags_at_least = {{"morphed", 0.5}}}, [] {
            const auto plan = gen::classified_plan();
            std::mt19937 random(plan.seed);
            SkinnedMesh mesh = gen::make_mesh(plan);
            gen::add_targets(mesh, random);
            RC_CLASSIFY(mesh.targets.count > 0, "morphed");
            const Character c = bake(mesh, {.triangles_per_leaf = *rc::gen::element(1, 3)});
            const std::string bytes = bytes_of(c);
            const Character read = character_of(bytes, "any");
            RC_ASSERT(bytes_of(read) == bytes);
            const Deformation deformation{gen::random_weights(mesh, random), {}};
            DeformedReference there(c, Pieces::mixed), here(read, Pieces::mixed);
            there.begin(deformation), here.begin(deformation);
            for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) RC_ASSERT(there.vertex(v) == here.vertex(v));
            for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
              const auto a = there.refit_node(n, {}).reference, b = here.refit_node(n, {}).reference;
              RC_ASSERT(a.center == b.center && a.radius == b.radius);
            }
            const Pose pose = gen::random_pose(c.mesh, random, 1);
            for (const RefitVariant& variant : refit_variants()) {
              const auto written = refit_all(c, variant, make_skinning_palette(c.mesh, c.sets, pose, variant.skinning)),
                         again = refit_all(read, variant, make_skinning_palette(read.mesh, read.sets, pose, variant.skinning));
              RC_ASSERT(written.size() == again.size());
              for (std::size_t n = 0; n < written.size(); ++n)
                RC_ASSERT(written[n].center == again[n].center && written[n].radius == again[n].radius);
            }
          });
  characters_at_the_end_of_what_is_accepted(t);
  spoiled_files_are_refused(t);
  t.example("a character baked without the pieces of a refit says so", {}, [] {
    const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}), {}, {});
    const Character read = character_of(bytes_of(c), "any");
    const RefitVariant& variant = refit_variant("control_mixed");
    int refused = 0;
    try {
      refit_all(read, variant, make_skinning_palette(c.mesh, c.sets, reference_pose(c.mesh), variant.skinning));
    } catch (const std::invalid_argument& e) {
      refused += std::string(e.what()).ends_with("baked without the pieces that the refit needs");
    }
    try {
      FrameRefits(read, variant);
    } catch (const std::invalid_argument& e) {
      refused += std::string(e.what()).ends_with("baked without the pieces of the refit control_mixed");
    }
    return Checked(refused == 2, 2);
  });
}

}  // namespace proptests::suite_character_file
