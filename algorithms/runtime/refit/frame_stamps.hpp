// SPDX-License-Identifier: MIT
// FrameStamps records which objects were made in the current frame. A new frame forgets all of them at once. Nothing is made
// before the first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace refitlab {

class FrameStamps {
 public:
  explicit FrameStamps(std::size_t count) : frame_of_(count) {}

  void begin() {
    if (++frame_ == 0) {  // the counter went round: nothing may pass for this frame's
      std::fill(frame_of_.begin(), frame_of_.end(), 0);
      frame_ = 1;
    }
  }
  bool is_made(int i) const { return frame_of_[i] == frame_; }
  void mark(int i) { frame_of_[i] = frame_; }

 private:
  std::uint32_t frame_ = 1;
  std::vector<std::uint32_t> frame_of_;  // 0 for none
};

}  // namespace refitlab
