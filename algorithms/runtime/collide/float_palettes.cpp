// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/float_palettes.hpp"

#include <algorithm>

namespace refitlab {

FloatPalettes::FloatPalettes(const PalettePacks& packs)
    : packs_(packs),
      entries_(packs.set_count()),
      made_(packs.set_count()),
      at_(packs.set_count()) {
  for (int part = 0; part < packs.part_count(); ++part)
    for (const int set : packs.sets_of(part)) {
      Order& order = orders_[packs.packed_joints(set)];
      at_[set] = {packs.packed_joints(set), static_cast<int>(order.sets.size())};
      order.sets.push_back(set);
    }
}

void FloatPalettes::begin(const Pose* pose, const FloatPlacement& placement) {
  pose_ = pose;
  placement_ = &placement;
  made_.begin();
  for (Order& order : orders_) order.asked = order.passed = 0;
  packs_made_ = 0;
}

void FloatPalettes::make_all() {
  for (int part = 0; part < packs_.part_count(); ++part) {
    const auto sets = packs_.sets_of(part);
    if (!std::all_of(sets.begin(), sets.end(), [&](int set) { return made_.is_made(set); })) make(sets);
  }
  for (Order& order : orders_) order.asked = static_cast<int>(order.sets.size());
}

// Puts the joint-set behind those that were asked for in this frame, in exchange for the one that is there.
void FloatPalettes::ask(int joint_set) {
  At& at = at_[joint_set];
  Order& order = orders_[at.joints];
  if (!made_.is_made(joint_set)) make_along(joint_set, order);
  if (at.place != order.asked) {
    const int other = order.sets[order.asked];
    order.sets[at.place] = other, at_[other].place = at.place;
    order.sets[order.asked] = joint_set, at.place = order.asked;
  }
  ++order.asked;
}

void FloatPalettes::make_along(int joint_set, Order& order) {
  int lanes[palette_lanes] = {joint_set}, count = 1;
  if (at_[joint_set].joints > 0)
    for (const int size = static_cast<int>(order.sets.size()); count < palette_lanes && order.passed < size; ++order.passed)
      if (const int set = order.sets[order.passed]; set != joint_set && !made_.is_made(set)) lanes[count++] = set;
  make({lanes, static_cast<std::size_t>(count)});
}

void FloatPalettes::make(std::span<const int> joint_sets) {
  packs_.make_floats(joint_sets, *pose_, *placement_, entries_.data());
  for (const int set : joint_sets) made_.mark(set);
  ++packs_made_;
}

}  // namespace refitlab
