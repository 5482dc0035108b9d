// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/character_file.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/tree/binary.hpp"
#include "algorithms/runtime/tree/check_character.hpp"

namespace refitlab {
namespace {

constexpr std::string_view magic = "refitlab";
constexpr std::uint32_t version = 2;

// Transfers the fields of everything in a file, for writing or for reading. `io` has a function for each kind of number.
void transfer(auto& io, auto& x);

void transfer_list(auto& io, auto& list) {
  transfer_members(io, list, [&](auto& member) { transfer(io, member); });
}

void transfer(auto& io, auto& x) {
  using T = std::remove_cvref_t<decltype(x)>;
  if constexpr (std::is_arithmetic_v<T>) {
    io.number(x);
  } else if constexpr (std::is_same_v<T, Point3> || std::is_same_v<T, Triangle>) {
    for (int i = 0; i < 3; ++i) io.number(x[i]);
  } else if constexpr (std::is_same_v<T, Ball3<double>>) {
    transfer(io, x.center), io.number(x.radius);
  } else if constexpr (std::is_same_v<T, Joint>) {
    transfer_list(io, x.name), io.number(x.parent), transfer(io, x.origin);
  } else if constexpr (std::is_same_v<T, Influence>) {
    io.number(x.joint), io.number(x.weight);
  } else if constexpr (std::is_same_v<T, Displacement<double>>) {
    io.number(x.target), transfer(io, x.by);
  } else if constexpr (std::is_same_v<T, TargetBall>) {
    io.number(x.target), transfer(io, x.ball);
  } else if constexpr (std::is_same_v<T, DisplacementTable>) {
    transfer_list(io, x.first), transfer_list(io, x.balls);
  } else if constexpr (std::is_same_v<T, SkinnedMesh>) {
    transfer_list(io, x.name), transfer_list(io, x.vertices), transfer_list(io, x.triangles), transfer_list(io, x.joints);
    transfer_list(io, x.influences), io.number(x.targets.count), transfer_list(io, x.targets.of_vertex);
  } else if constexpr (std::is_same_v<T, TreeNode>) {
    transfer(io, x.reference);
    for (auto* member : {&x.parent, &x.first_child, &x.child_count, &x.level, &x.first_triangle, &x.triangle_count,
                         &x.first_vertex, &x.vertex_count, &x.first_piece, &x.piece_count})
      io.number(*member);
  } else if constexpr (std::is_same_v<T, NodePiece>) {
    for (auto* member : {&x.joint_set, &x.first_weight, &x.weight_vertex_count, &x.reference}) io.number(*member);
  } else if constexpr (std::is_same_v<T, SphereTree>) {
    transfer_list(io, x.nodes), transfer_list(io, x.triangle_order), transfer_list(io, x.leaf_vertices);
    transfer_list(io, x.pieces), transfer_list(io, x.weight_vertices), transfer(io, x.displacements);
  } else if constexpr (std::is_same_v<T, PieceTable>) {
    transfer_list(io, x.first), transfer_list(io, x.pieces), transfer_list(io, x.references);
    transfer_list(io, x.weight_vertices), transfer(io, x.displacements);
  } else {
    transfer_list(io, x);  // a list of lists
  }
}

}  // namespace

std::string bytes_of(const Character& character) {
  BinaryWriter body;
  transfer(body, character.mesh), transfer(body, character.tree);
  for (const PieceTable& table : character.pieces) transfer(body, table);
  return sealed(magic, version, body.bytes);
}

Character character_of(std::string_view bytes, const std::string& file) {
  const DefaultFloatEnvironment environment;
  BinaryReader in = opened(bytes, magic, version, "baked character", file);
  SkinnedMesh mesh;
  SphereTree tree;
  std::array<PieceTable, piece_kinds> pieces;
  transfer(in, mesh), transfer(in, tree);
  for (PieceTable& table : pieces) transfer(in, table);
  in.end();
  mesh.name = mesh.name.empty() ? file : mesh.name;
  validate(mesh);
  JointSets sets(mesh);
  check_tree(tree, mesh, sets, file);
  if (!pieces[static_cast<std::size_t>(Pieces::node)].first.empty())
    throw ModelError(file, "pieces", "those of nodes as a whole are the tree's");
  for (const PieceTable& table : pieces) check_pieces(table, tree, mesh, sets, file);
  NodeVertices vertices(tree, mesh);
  return {std::move(mesh), std::move(sets), std::move(tree), std::move(vertices), std::move(pieces)};
}

Character read_character(const std::string& path) { return character_of(read_bytes(path), path); }

}  // namespace refitlab
