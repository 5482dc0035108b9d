// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/sha256.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace refitlab {
namespace {

// These are the first 32 bits of the fractional parts of the square roots (initial state) and cube roots (constants of the
// rounds) of the first primes. Doubles have 15 bits more, which do not matter for any of these primes.
struct Constants {
  std::array<std::uint32_t, 8> state;
  std::array<std::uint32_t, 64> rounds;

  Constants() {
    std::size_t count = 0;
    for (int n = 2; count < rounds.size(); ++n) {
      bool is_prime = true;
      for (int d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
      if (!is_prime) continue;
      if (count < state.size()) state[count] = fraction(std::sqrt(double(n)));
      rounds[count++] = fraction(std::cbrt(double(n)));
    }
  }
  static std::uint32_t fraction(double x) { return static_cast<std::uint32_t>((x - std::floor(x)) * 4294967296.0); }
};

// Returns the message, a 1, zeros, and the message's length in bits as 64 bits. Together they are whole blocks of 64 bytes.
std::string padded(std::string_view bytes) {
  std::string out(bytes);
  out += '\x80';
  while (out.size() % 64 != 56) out += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) out += static_cast<char>(std::uint64_t(bytes.size()) * 8 >> shift);
  return out;
}

void digest_block(const char* block, const Constants& constants, std::array<std::uint32_t, 8>& state) {
  using std::rotr;
  std::array<std::uint32_t, 64> w;
  for (int i = 0; i < 16; ++i) {
    w[i] = 0;
    for (int byte = 0; byte < 4; ++byte) w[i] = w[i] << 8 | static_cast<unsigned char>(block[4 * i + byte]);
  }
  for (int i = 16; i < 64; ++i)
    w[i] = w[i - 16] + w[i - 7] + (rotr(w[i - 15], 7) ^ rotr(w[i - 15], 18) ^ w[i - 15] >> 3) +
           (rotr(w[i - 2], 17) ^ rotr(w[i - 2], 19) ^ w[i - 2] >> 10);
  auto [a, b, c, d, e, f, g, h] = state;
  for (int i = 0; i < 64; ++i) {
    const std::uint32_t first = h + (rotr(e, 6) ^ rotr(e, 11) ^ rotr(e, 25)) + ((e & f) ^ (~e & g)) + constants.rounds[i] + w[i];
    const std::uint32_t second = (rotr(a, 2) ^ rotr(a, 13) ^ rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const std::array<std::uint32_t, 8> change{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += change[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  static const Constants constants;
  auto state = constants.state;
  const std::string message = padded(bytes);
  for (std::size_t i = 0; i < message.size(); i += 64) digest_block(message.data() + i, constants, state);
  std::string out;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) out += "0123456789abcdef"[word >> shift & 15];
  return out;
}

}  // namespace refitlab
