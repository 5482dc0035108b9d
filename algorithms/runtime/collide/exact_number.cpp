// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/exact_number.hpp"

#include <algorithm>
#include <cmath>

namespace refitlab {
namespace {

using Digits = std::vector<std::uint32_t>;

Digits moved_up(const Digits& digits, int by) {
  Digits out(static_cast<std::size_t>(by), 0);
  out.insert(out.end(), digits.begin(), digits.end());
  return out;
}

bool is_less(const Digits& a, const Digits& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

Digits sum(const Digits& a, const Digits& b) {
  Digits out;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry != 0; ++i) {
    carry += (i < a.size() ? a[i] : 0ull) + (i < b.size() ? b[i] : 0ull);
    out.push_back(static_cast<std::uint32_t>(carry));
    carry >>= 32;
  }
  return out;
}

// Returns a - b. b is not greater than a.
Digits difference(const Digits& a, const Digits& b) {
  Digits out;
  std::int64_t borrow = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    borrow += static_cast<std::int64_t>(a[i]) - (i < b.size() ? b[i] : 0);
    out.push_back(static_cast<std::uint32_t>(borrow));
    borrow >>= 32;
  }
  return out;
}

}  // namespace

ExactNumber::ExactNumber(double x) : is_negative_(x < 0) {
  int exponent;
  const double share = std::frexp(std::abs(x), &exponent);  // x = share 2^exponent, and 2^53 share is an integer
  exponent -= 53;
  exponent_ = exponent >= 0 ? exponent / 32 : -((31 - exponent) / 32);
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(share, 53));
  const int left = exponent - 32 * exponent_;  // 0 to 31
  const std::uint64_t low = mantissa << left, high = left == 0 ? 0 : mantissa >> (64 - left);
  digits_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32), static_cast<std::uint32_t>(high)};
  drop_zeros();
}

void ExactNumber::drop_zeros() {
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
}

ExactNumber ExactNumber::operator-() const {
  ExactNumber out = *this;
  out.is_negative_ = !is_negative_;
  return out;
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  ExactNumber out;
  out.exponent_ = std::min(a.exponent_, b.exponent_);
  const Digits x = moved_up(a.digits_, a.exponent_ - out.exponent_), y = moved_up(b.digits_, b.exponent_ - out.exponent_);
  const bool is_a_less = is_less(x, y);
  out.is_negative_ = is_a_less ? b.is_negative_ : a.is_negative_;
  out.digits_ = a.is_negative_ == b.is_negative_ ? sum(x, y) : is_a_less ? difference(y, x) : difference(x, y);
  out.drop_zeros();
  return out;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber out;
  if (a.sign() == 0 || b.sign() == 0) return out;
  out.is_negative_ = a.is_negative_ != b.is_negative_;
  out.exponent_ = a.exponent_ + b.exponent_;
  out.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
  for (std::size_t i = 0; i < a.digits_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.digits_.size() || carry != 0; ++j) {
      carry += out.digits_[i + j] + (j < b.digits_.size() ? static_cast<std::uint64_t>(a.digits_[i]) * b.digits_[j] : 0);
      out.digits_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  out.drop_zeros();
  return out;
}

}  // namespace refitlab
