// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/meeting_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// A Range has the least and the greatest finite lower side of the boxes along an axis.
struct Range {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;

  double length() const { return greatest > least ? greatest - least : 0; }
};

Range range_of_lower_sides(std::span<const Box<double>> boxes, int axis) {
  Range range;
  for (const auto& box : boxes)
    if (const double low = box.low[axis]; std::isfinite(low))
      range.least = std::min(range.least, low), range.greatest = std::max(range.greatest, low);
  return range;
}

// Strips are parts of an axis, as long as each other but for the first and the last one, which go on to infinity.
class Strips {
 public:
  Strips(const Range& range, int count) : range_(range), count_(count), per_length_(count / range.length()) {}

  int count() const { return count_; }
  // Returns the strip of a coordinate. Of two coordinates, the greater one's is not in front of the other's, however this rounds.
  int of(double x) const {
    if (!(x > range_.least)) return 0;
    if (x >= range_.greatest) return count_ - 1;
    return static_cast<int>(std::min<double>(count_ - 1, (x - range_.least) * per_length_));
  }

 private:
  Range range_;
  int count_;
  double per_length_;
};

}  // namespace

// It sweeps along the axis on which the lower sides are spread most [Baraff 1992]. As that alone compares each box with all those
// across, each strip of a second axis is swept by itself. Two boxes may share several strips. They are listed in the first of them,
// which is that of the greater of their lower sides.
std::vector<std::pair<int, int>> meeting_boxes(std::span<const Box<double>> boxes) {
  const DefaultFloatEnvironment environment;
  std::vector<std::pair<int, int>> pairs;
  if (boxes.empty()) return pairs;
  int axes[] = {0, 1, 2};
  Range ranges[3];
  for (const int axis : axes) ranges[axis] = range_of_lower_sides(boxes, axis);
  std::sort(std::begin(axes), std::end(axes), [&](int a, int b) { return ranges[a].length() > ranges[b].length(); });
  const int along = axes[0], across = axes[1];

  // If the boxes fill a rectangle, a strip is about two of them wide. If they are in one row, or a length is infinite, one strip is
  // enough: that only saves time.
  const double share = ranges[across].length() / ranges[along].length();  // a NaN if both are 0, or infinite
  const double side = share > 0 ? std::sqrt(share * static_cast<double>(boxes.size())) / 2 : 0;
  const Strips strips(ranges[across], 1 + static_cast<int>(side));

  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return boxes[a].low[along] < boxes[b].low[along]; });
  std::vector<std::vector<int>> of_strip(strips.count());  // in this order
  for (const int i : order) {
    const int last = strips.of(boxes[i].high[across]);
    for (int s = strips.of(boxes[i].low[across]); s <= last; ++s) of_strip[s].push_back(i);
  }

  for (int s = 0; s < strips.count(); ++s)
    for (auto first = of_strip[s].begin(); first != of_strip[s].end(); ++first) {
      const Box<double>& box = boxes[*first];
      for (auto second = first + 1; second != of_strip[s].end() && boxes[*second].low[along] <= box.high[along]; ++second)
        if (!are_apart(box, boxes[*second]) && strips.of(std::max(box.low[across], boxes[*second].low[across])) == s)
          pairs.push_back(std::minmax(*first, *second));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace refitlab
