// SPDX-License-Identifier: GPL-3.0-or-later
// Gives bytes the header that belongs to them, as algorithms/runtime/tree/binary.hpp seals them: a fuzzer does not guess
// checksums.
#pragma once

#include <cstdint>
#include <string>

namespace proptests::fuzz {

// Returns the bytes with the size and the checksum in the header that belong to them. Nothing behind it is changed.
inline std::string resealed(std::string bytes) {
  constexpr std::size_t size_at = 12, sum_at = 20, body_at = 28;
  if (bytes.size() < body_at) return bytes;
  std::uint64_t sum = 0xcbf29ce484222325, size = bytes.size() - body_at;
  for (std::size_t i = body_at; i < bytes.size(); ++i) sum = (sum ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
  for (int i = 0; i < 8; ++i)
    bytes[size_at + i] = static_cast<char>(size >> 8 * i), bytes[sum_at + i] = static_cast<char>(sum >> 8 * i);
  return bytes;
}

}  // namespace proptests::fuzz
