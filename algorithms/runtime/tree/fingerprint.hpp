// SPDX-License-Identifier: MIT
// A Fingerprint tells whether two contents are the same without keeping them. It is for accidents, not against forgery.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace refitlab {

// It has 64 bits by FNV-1a (Fowler, Noll, Vo), over everything that is added, in order.
class Fingerprint {
 public:
  void add_bytes(std::string_view bytes) {
    for (const char c : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  }
  // Adds the length of the text too, so that "ab", "c" differs from "a", "bc".
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(text);
  }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void add(Number number) { add_bytes({reinterpret_cast<const char*>(&number), sizeof number}); }
  std::uint64_t value() const { return hash_; }
  // Returns 16 hexadecimal digits.
  std::string text() const {
    std::string out;
    for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[hash_ >> shift & 15];
    return out;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace refitlab
