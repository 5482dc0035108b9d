// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/exhaustive/certificate.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace proptests::exhaustive {
namespace {

nlohmann::ordered_json header_of(const Theorem& theorem, double constant) {
  nlohmann::ordered_json out;
  out["theorem"] = theorem.name;
  out["statement"] = theorem.statement;
  out["constant"] = fraction_of(constant);
  for (const Parameter& p : theorem.parameters) out["domain"].push_back({p.name, fraction_of(p.low), fraction_of(p.high)});
  return out;
}

}  // namespace

std::string fraction_of(double x) {
  long long below = 1;
  while (x != std::floor(x)) x *= 2, below *= 2;
  return std::to_string(static_cast<long long>(x)) + (below > 1 ? "/" + std::to_string(below) : "");
}

std::string certificate_of(const Theorem& theorem, double constant, const std::vector<Cell>& cells) {
  auto out = header_of(theorem, constant);
  out["tree"] = joined(cells);
  return out.dump(1) + "\n";
}

std::string shard_of(const Theorem& theorem, double constant, const std::vector<Cell>& cells) {
  auto out = header_of(theorem, constant);
  for (const Cell& cell : cells) out["cells"].push_back({cell.path, cell.tree});
  return out.dump(1) + "\n";
}

}  // namespace proptests::exhaustive
