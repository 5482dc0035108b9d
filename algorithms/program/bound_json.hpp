// SPDX-License-Identifier: GPL-3.0-or-later
// A bound has the same JSON in extras, summaries and certificates. Numbers are floats, written with all the digits of a double,
// so that a reader of either kind reads just these.
#pragma once

#include <nlohmann/json.hpp>

#include "algorithms/runtime/tree/cluster_bounds.hpp"

namespace refitlab {

// Returns the least and the greatest value for each direction of a slab. The list is empty for a box alone.
template <class Json>
Json json_of_slabs(const BoundedPart& part) {
  Json out = Json::array();
  for (const Slab<float>& slab : part.slabs) out.push_back({static_cast<double>(slab.low), static_cast<double>(slab.high)});
  return out;
}

// Returns an object with "box", "ball", and "slabs" if there are any.
template <class Json>
Json json_of_bound(const BoundedPart& part) {
  Json box = Json::array(), ball = Json::array();
  for (const auto* end : {&part.box.low, &part.box.high})
    for (const float x : *end) box.push_back(static_cast<double>(x));
  for (const float x : part.ball.center) ball.push_back(static_cast<double>(x));
  ball.push_back(static_cast<double>(part.ball.radius));
  Json out = {{"box", box}, {"ball", ball}};
  if (!part.slabs.empty()) out["slabs"] = json_of_slabs<Json>(part);
  return out;
}

// Returns the directions of the slabs of k-DOPs, without the axes.
template <class Json>
Json json_of_directions(int dop) {
  Json out = Json::array();
  for (const SlabDirection& d : slab_directions(dop).subspan(3)) out.push_back(d);
  return out;
}

}  // namespace refitlab
