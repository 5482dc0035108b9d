// SPDX-License-Identifier: GPL-3.0-or-later
// Compares derived and allowed budgets of rounding, by name. No allowance may be less than what was derived.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "proptests/harness/harness.hpp"

namespace proptests::oracle {

class DerivedBudgets {
 public:
  // Adds a budget. Both numbers are in u, the unit roundoff of the kernel's numbers.
  void add(const std::string& name, double derived, double allowed) {
    char text[200];
    std::snprintf(text, sizeof text, "%s: derived %.4g u, allowed %.4g u; ", name.c_str(), derived, allowed);
    ++count_;
    if (!(derived > 0 && derived <= allowed)) too_little_ += text;
    if (derived / allowed > greatest_share_) greatest_share_ = derived / allowed, tightest_ = text;
  }
  // Adds the budget of a constant, which may be no unit more than was derived.
  void add_up_to_a_unit(const std::string& name, double derived, double allowed) {
    add(name, derived, allowed);
    add(name + ", not a unit more", std::max(1e-30, allowed - 1), derived);
  }
  // Names what is too little, and the tightest.
  Checked checked() const {
    if (!too_little_.empty()) return Checked(false, count_, "TOO LITTLE: " + too_little_);
    return Checked(true, count_, "the tightest of " + std::to_string(count_) + ": " + tightest_);
  }

 private:
  long count_ = 0;
  double greatest_share_ = 0;
  std::string too_little_, tightest_;
};

}  // namespace proptests::oracle
