// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/refits/refit_ladder.hpp"

#include <cstdio>

namespace proptests::oracle {

long RungTally::total() const {
  long sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

double RungTally::share(const std::string& name) const {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : double(found->second) / double(total());
}

std::string RungTally::text() const {
  std::string out = std::to_string(total()) + " points decided by";
  for (const auto& [name, count] : counts) {
    char part[80];
    std::snprintf(part, sizeof part, " %s: %.2f %%,", name.c_str(), 100 * share(name));
    out += part;
  }
  out.pop_back();
  return out;
}

}  // namespace proptests::oracle
