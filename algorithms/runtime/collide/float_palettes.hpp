// SPDX-License-Identifier: MIT
// FloatPalettes has the palettes of a placed pose for skinning in float. Each is made when it is first asked for in a frame.
//
// A pack makes eight joint-sets in the time of one, so others of as many joints are made along with the one that is asked for.
// Bodies move little from one frame to the next, so these are the ones that were asked for latest.
#pragma once

#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/refit/frame_stamps.hpp"

namespace refitlab {

class FloatPalettes {
 public:
  // packs must outlive this.
  explicit FloatPalettes(const PalettePacks& packs);

  // Starts a frame, of which nothing is made yet. Both must stay until the next frame. Without a pose, nothing may be asked for.
  void begin(const Pose* pose, const FloatPlacement& placement);

  // Returns the palette of a joint-set. The pose must be as check_pose requires.
  const FloatPaletteEntry& operator[](int joint_set) {
    if (at_[joint_set].place >= orders_[at_[joint_set].joints].asked) ask(joint_set);
    return entries_[joint_set];
  }
  // Makes those of all joint-sets.
  void make_all();

  // Returns them all by joint-set. Those that were not asked for in this frame may be old.
  const FloatPaletteEntry* data() const { return entries_.data(); }
  // Returns how many packs were made since begin.
  int packs_made() const { return packs_made_; }

 private:
  // An Order has the joint-sets of one number of joints. Those that were asked for in this frame come first, and then, about,
  // those that were asked for latest.
  struct Order {
    std::vector<int> sets;
    int asked = 0, passed = 0;  // how many of them were asked for, and how many were looked at for being made along
  };
  struct At {
    int joints, place;  // 0 joints if a pack does not take so many, and the place in the order
  };

  void ask(int joint_set);
  void make_along(int joint_set, Order& order);
  void make(std::span<const int> joint_sets);

  const PalettePacks& packs_;
  const Pose* pose_ = nullptr;
  const FloatPlacement* placement_ = nullptr;
  std::vector<FloatPaletteEntry> entries_;  // by joint-set
  FrameStamps made_;                        // likewise
  std::vector<At> at_;                      // likewise
  Order orders_[most_palette_joints + 1];   // by number of joints
  int packs_made_ = 0;
};

}  // namespace refitlab
