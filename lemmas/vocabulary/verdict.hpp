// SPDX-License-Identifier: MIT
// A Verdict is the three-valued answer of a checked statement.
//
// An interval may not decide a comparison, so a statement holds, fails, or stays undecided. Combine verdicts with
// & | ! (never && ||: they would cut the evaluation short and treat undecided as a bool).
#pragma once

#include <ostream>

namespace refitlab {

enum class Verdict { fails, undecided, holds };

constexpr Verdict verdict_of(bool b) { return b ? Verdict::holds : Verdict::fails; }

// This is Kleene's strong three-valued logic: with fails < undecided < holds, & is the lesser and | the greater of both.
constexpr Verdict operator&(Verdict a, Verdict b) { return a < b ? a : b; }
constexpr Verdict operator|(Verdict a, Verdict b) { return a < b ? b : a; }
constexpr Verdict operator!(Verdict a) { return a == Verdict::undecided ? a : verdict_of(a == Verdict::fails); }
constexpr Verdict& operator&=(Verdict& a, Verdict b) { return a = a & b; }
constexpr Verdict& operator|=(Verdict& a, Verdict b) { return a = a | b; }

// "If p then q" fails only when p holds and q fails.
constexpr Verdict implies(Verdict p, Verdict q) { return (!p) | q; }

inline const char* name_of(Verdict v) { return v == Verdict::holds ? "holds" : v == Verdict::fails ? "fails" : "undecided"; }
inline std::ostream& operator<<(std::ostream& out, Verdict v) { return out << name_of(v); }

}  // namespace refitlab
