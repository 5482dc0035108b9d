// SPDX-License-Identifier: MIT
// Numbers become little-endian bytes. The envelope of refitlab's binary files is a magic, a version, a size and a checksum.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {
namespace binary {
template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint8_t>>;
}

struct BinaryWriter {
  template <class T>
  void number(const T& x) {
    const auto bits = std::bit_cast<binary::Bits<T>>(x);
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
  std::string bytes;
};

// Throws ModelError, which names the file and what of it is read, for bytes that end early.
class BinaryReader {
 public:
  // bytes and file must outlive this.
  BinaryReader(std::string_view bytes, const std::string& what, const std::string& file)
      : bytes_(bytes),
        what_(what),
        file_(file) {}

  template <class T>
  void number(T& x) {
    const std::string_view taken = take(sizeof(T));
    binary::Bits<T> bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bits = static_cast<binary::Bits<T>>(bits | static_cast<binary::Bits<T>>(static_cast<unsigned char>(taken[i])) << (8 * i));
    x = std::bit_cast<T>(bits);
  }
  std::string_view take(std::uint64_t count) {
    if (bytes_.size() < count) throw ModelError(file_, what_, "ends early");
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() const { return bytes_; }
  // Throws ModelError if there is more.
  void end() const {
    if (!bytes_.empty()) throw ModelError(file_, what_, "goes on after its end");
  }

 private:
  std::string_view bytes_;
  std::string what_;
  const std::string& file_;
};

// Transfers the length of a list, to a BinaryWriter or from a BinaryReader, and then each member by transfer(member). What is
// read is appended to the list, which is empty, one by one: a length that no file could have makes room for no more than the file
// has.
template <class List>
void transfer_members(auto& io, List& list, const auto& transfer_member) {
  std::uint64_t count = list.size();
  io.number(count);
  if constexpr (std::is_const_v<List>) {
    for (const auto& member : list) transfer_member(member);
  } else {
    for (; count > 0; --count) {
      list.resize(list.size() + 1);
      transfer_member(list.back());
    }
  }
}

// Returns the magic, the version, the body's size and checksum (FNV-1a of 64 bits), and the body.
std::string sealed(std::string_view magic, std::uint32_t version, std::string_view body);

// Returns a reader of the body of such bytes. what says what they should be, for errors. Throws ModelError unless all is as
// stated.
BinaryReader opened(std::string_view bytes, std::string_view magic, std::uint32_t version, const std::string& what,
                    const std::string& file);

// Returns the bytes of a file. Throws ModelError for one that cannot be read.
std::string read_bytes(const std::string& path);

}  // namespace refitlab
