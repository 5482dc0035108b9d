// SPDX-License-Identifier: MIT
// ExactNumber is an integer of any length times a power of two. Every finite double is such a number, and so are sums,
// differences and products. So signs of polynomials in doubles are decided without rounding, overflow or underflow.
#pragma once

#include <cstdint>
#include <vector>

namespace refitlab {

class ExactNumber {
 public:
  ExactNumber() = default;
  // x must be finite.
  explicit ExactNumber(double x);

  // Returns -1, 0 or 1.
  int sign() const { return digits_.empty() ? 0 : is_negative_ ? -1 : 1; }

  ExactNumber operator-() const;
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return a + -b; }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

 private:
  void drop_zeros();

  bool is_negative_ = false;
  std::vector<std::uint32_t> digits_;  // to the base 2^32, the least first; the last is not 0
  int exponent_ = 0;                   // the value is that of the digits times 2^(32 exponent_)
};

}  // namespace refitlab
