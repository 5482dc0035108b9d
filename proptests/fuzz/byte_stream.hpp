// SPDX-License-Identifier: GPL-3.0-or-later
// Takes small choices from bytes, for targets whose input has a structure. Past the end all choices are the first.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace proptests::fuzz {

class ByteStream {
 public:
  explicit ByteStream(const std::string& bytes) : bytes_(bytes) {}

  std::uint8_t byte() { return at_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at_++]) : 0; }
  // Returns one of 0 .. count - 1, for a count from 1 to 256.
  unsigned below(unsigned count) { return byte() % count; }
  bool one_in(unsigned count) { return below(count) == count - 1; }
  // Returns any float, from its four bytes.
  float any_float() {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | byte();
    float out;
    std::memcpy(&out, &bits, sizeof out);
    return out;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace proptests::fuzz
