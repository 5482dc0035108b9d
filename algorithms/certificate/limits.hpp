// SPDX-License-Identifier: GPL-3.0-or-later
// These functions say what checkers refuse for its size alone. Checkers bound their own work, so that a document from anyone can
// be checked; whoever writes a certificate says if it is beyond that. The limits and their reasons are those of
// proptests/certificate/check and check_pairs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace refitlab {

inline constexpr std::size_t most_certificate_bytes = 1 << 24;  // of balls and of pairs
inline constexpr std::size_t most_certificate_digits = 400;     // of a numerator or denominator, in decimal
inline constexpr std::size_t most_certificate_bits = 1 << 13;   // of a common denominator
inline constexpr long most_certificate_work = 500'000;          // of the proofs of a ball
inline constexpr long list_steps_per_certificate_step = 1024;   // as long as one step of a proof takes
inline constexpr long most_pairs_work = 20'000'000;             // of the proof of pairs

// Returns whether checkers of balls and of pairs refuse a fraction, such as "-3/8" or "5", for its length.
bool has_too_many_digits(std::string_view fraction);
// Returns why checkers of balls and of pairs refuse a certificate of this many bytes, or nothing.
std::string refusal_of_length(std::size_t bytes);
// Returns why checkers of balls refuse a certificate of a ball (certificate.hpp) before any of its proofs, or nothing. The reason
// is in the words of the checker in Python.
std::string refusal_of_certificate(const std::string& text);
// Returns why checkers of pairs refuse a certificate of pairs (pairs_certificate.hpp) before any of its proof, or nothing. Its
// numbers have no more digits than they read.
std::string refusal_of_pairs_certificate(const std::string& text);
// Returns a line that says so, to be shown where the file is written, or nothing if there is no refusal.
std::string note_of_refusal(const std::string& file, const std::string& refusal);

}  // namespace refitlab
