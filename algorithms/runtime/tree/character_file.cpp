// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/character_file.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/tree/check_character.hpp"
#include "algorithms/runtime/tree/fingerprint.hpp"

namespace refitlab {
namespace {

constexpr std::string_view magic = "refitlab";
constexpr std::uint32_t version = 1;

std::uint64_t checksum_of(std::string_view bytes) {
  Fingerprint of_bytes;
  of_bytes.add_bytes(bytes);
  return of_bytes.value();
}

// The fields of all that is in a file, once for writing and once for reading: `io` has a function for each kind of number.
void transfer(auto& io, auto& x);

template <class T>
void transfer_list(auto& io, T& list) {
  std::uint64_t count = list.size();
  io.number(count);
  if constexpr (!std::is_const_v<T>) list.resize(io.checked_count(count));
  for (auto& member : list) transfer(io, member);
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
  } else if constexpr (std::is_same_v<T, SkinnedMesh>) {
    transfer_list(io, x.name), transfer_list(io, x.vertices), transfer_list(io, x.triangles), transfer_list(io, x.joints);
    transfer_list(io, x.influences);
  } else if constexpr (std::is_same_v<T, TreeNode>) {
    transfer(io, x.reference);
    for (auto* member : {&x.parent, &x.first_child, &x.child_count, &x.level, &x.first_triangle, &x.triangle_count,
                         &x.first_vertex, &x.vertex_count, &x.first_piece, &x.piece_count})
      io.number(*member);
  } else if constexpr (std::is_same_v<T, NodePiece>) {
    for (auto* member : {&x.joint_set, &x.first_weight, &x.weight_vertex_count, &x.reference}) io.number(*member);
  } else if constexpr (std::is_same_v<T, SphereTree>) {
    transfer_list(io, x.nodes), transfer_list(io, x.triangle_order), transfer_list(io, x.leaf_vertices);
    transfer_list(io, x.pieces), transfer_list(io, x.weight_vertices);
  } else if constexpr (std::is_same_v<T, PieceTable>) {
    transfer_list(io, x.first), transfer_list(io, x.pieces), transfer_list(io, x.references),
        transfer_list(io, x.weight_vertices);
  } else {
    transfer_list(io, x);  // a list of lists
  }
}

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint8_t>>;

struct Writer {
  template <class T>
  void number(const T& x) {
    const auto bits = std::bit_cast<Bits<T>>(x);
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
  std::string bytes;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  template <class T>
  void number(T& x) {
    if (bytes_.size() < sizeof(T)) throw ModelError(file_, "file", "ends early");
    Bits<T> bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bits = static_cast<Bits<T>>(bits | static_cast<Bits<T>>(static_cast<unsigned char>(bytes_[i])) << (8 * i));
    x = std::bit_cast<T>(bits);
    bytes_.remove_prefix(sizeof(T));
  }
  // A member of a list takes a byte at least: what a count makes room for is no more than what the file could have.
  std::size_t checked_count(std::uint64_t count) const {
    if (count > bytes_.size()) throw ModelError(file_, "file", "ends early");
    return static_cast<std::size_t>(count);
  }
  std::string_view take(std::size_t count) {
    if (bytes_.size() < count) throw ModelError(file_, "file", "ends early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
  const std::string& file_;
};

}  // namespace

std::string bytes_of(const Character& character) {
  Writer body;
  transfer(body, character.mesh), transfer(body, character.tree);
  for (const PieceTable& table : character.pieces) transfer(body, table);
  Writer out{std::string(magic)};
  out.number(version), out.number(std::uint64_t(body.bytes.size())), out.number(checksum_of(body.bytes));
  return out.bytes + body.bytes;
}

Character character_of(std::string_view bytes, const std::string& file) {
  const DefaultFloatEnvironment environment;
  Reader in(bytes, file);
  if (bytes.substr(0, magic.size()) != magic) throw ModelError(file, "file", "is no baked character");
  in.take(magic.size());
  std::uint32_t of_file = 0;
  in.number(of_file);
  if (of_file != version)
    throw ModelError(file, "file", "is of version " + std::to_string(of_file) + ", not " + std::to_string(version));
  std::uint64_t size = 0, checksum = 0;
  in.number(size), in.number(checksum);
  if (size > in.rest().size()) throw ModelError(file, "file", "ends early");
  if (size < in.rest().size()) throw ModelError(file, "file", "goes on after its end");
  if (checksum_of(in.rest()) != checksum) throw ModelError(file, "file", "its checksum is not that of its bytes");

  SkinnedMesh mesh;
  SphereTree tree;
  std::array<PieceTable, piece_kinds> pieces;
  transfer(in, mesh), transfer(in, tree);
  for (PieceTable& table : pieces) transfer(in, table);
  if (!in.rest().empty()) throw ModelError(file, "file", "goes on after its end");
  mesh.name = mesh.name.empty() ? file : mesh.name;
  validate(mesh);
  JointSets sets(mesh);
  check_tree(tree, mesh, sets, file);
  for (const PieceTable& table : pieces) check_pieces(table, tree, sets, file);
  NodeVertices vertices(tree, mesh);
  return {std::move(mesh), std::move(sets), std::move(tree), std::move(vertices), std::move(pieces)};
}

Character read_character(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw ModelError(path, "file", "cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw ModelError(path, "file", "cannot be read");
  return character_of(bytes, path);
}

}  // namespace refitlab
