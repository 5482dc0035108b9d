// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/batch/float_palette.hpp"
#include "algorithms/runtime/collide/box_kernel.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_box {
namespace {

using namespace refitlab;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool same(const Box<double>& a, const Box<double>& b) { return a.low == b.low && a.high == b.high; }
bool separates_nothing(const Box<double>& a, const Box<double>& b) { return !are_apart(a, b) && !are_apart(b, a); }

// Returns the box [0, 1]^3, moved by so much along an axis.
Box<double> unit_box(int axis, double by) {
  Box<double> box{Point3::Zero(), Point3::Ones()};
  box.low[axis] += by, box.high[axis] += by;
  return box;
}

// Returns the box around the same points, by rows of registers.
template <class S>
Box<double> by_rows(std::span<const Point3> points) {
  auto box = RowBox<S>::empty();
  for (const Point3& p : points) box.merge(Row<S, 4>{S(p[0]), S(p[1]), S(p[2]), S(99)});
  box.grow(S(0.5));
  return box_of<double>(box);
}

void boxes_in_blocks(Suite& t) {
  t.example("a block keeps its boxes, and says by lane which meet another, in float and double", {}, [] {
    const auto says = []<class S>(S) {
      BoxBlock<S> blocks[2];
      std::uint64_t expected = 0;
      for (int i = 0; i < 16; ++i) put_box(blocks, i, box_of<S>(unit_box(i % 3, i % 5 - 2.0)));
      bool ok = true;
      for (int i = 0; i < 16; ++i) ok = ok && same(box_of<double>(get_box(blocks, i)), unit_box(i % 3, i % 5 - 2.0));
      for (int i = 0; i < 8; ++i) expected |= std::uint64_t(std::abs(i % 5 - 2) < 2) << 8 * i;
      return ok && meeting(blocks[0], box_of<S>(unit_box(0, 0))) == expected;
    };
    return says(1.0f) && says(1.0);
  });
  t.example("of boxes in blocks those are found that meet another, in order, and none behind the last", {}, [] {
    long cases = 0;
    const auto finds = [&]<class S>(S) {
      BoxBlock<S> blocks[4];
      for (int i = 0; i < 32; ++i) put_box(blocks, i, box_of<S>(unit_box(i % 3, i * 7 % 5 - 2.0)));
      for (int count = 0; count <= 32; ++count, ++cases) {
        std::vector<int> expected, found(32);
        for (int i = 0; i < count; ++i)
          if (std::abs(i * 7 % 5 - 2) < 2) expected.push_back(i);
        found.resize(static_cast<std::size_t>(find_meeting(blocks, count, box_of<S>(unit_box(0, 0)), found.data())));
        if (found != expected) return false;
      }
      return true;
    };
    const bool ok = finds(1.0f) && finds(1.0);
    return Checked(ok, cases);
  });
}

// Holds some flipped boxes, the largest of their coordinates, and what they may be off by.
struct Flipped {
  std::vector<FlippedBox> boxes;
  float largest = 0;
  double lost = 0;
};

Flipped some_flipped_boxes(std::mt19937& random, float scale, bool are_points) {
  Flipped out;
  out.boxes.resize(std::uniform_int_distribution<std::size_t>(1, 40)(random));
  out.lost = scale * std::array{0.0, 1e-300, 1e-7, 1.0, 1e3}[random() % 5];
  std::uniform_real_distribution<float> within(-scale, scale), wide(0, are_points ? 0 : scale);
  for (FlippedBox& box : out.boxes) {
    box.set_all(std::numeric_limits<float>::infinity());  // The unused numbers stay at this value.
    for (int i = 0; i < 3; ++i) {
      box.of[i] = within(random), box.of[4 + i] = -(box.of[i] + wide(random));
      out.largest = std::max({out.largest, std::abs(box.of[i]), std::abs(box.of[4 + i])});
    }
  }
  return out;
}

// Says whether the grown box holds the flipped one with all that it may be off by, and four roundings more, and is no larger than
// that requires.
bool is_grown(const Box<float>& grown, const Box<double>& box, const Flipped& of) {
  constexpr double rounding = 0x1p-24;
  const auto is_beyond = [&](double side, double inner) {
    const double by = inner - side;
    return by - 4 * rounding * std::abs(side) >= of.lost * (1 - 8 * rounding) &&
           by <= of.lost * (1 + 4 * rounding) + 14 * rounding * of.largest + 2 * least_float_slack;
  };
  bool ok = true;
  for (int i = 0; i < 3; ++i) ok = ok && is_beyond(grown.low[i], box.low[i]) && is_beyond(-grown.high[i], -box.high[i]);
  return ok;
}

void grown_boxes(Suite& t) {
  t.holds(
      "flipped boxes are put into blocks grown by what they may be off by and little more, in a box around all, on every target",
      {.number_type = "float", .cases = 1000, .degenerate_at_least = 0.2}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const float scale = *rc::gen::element(0.f, 1e-42f, 1e-30f, 1e-3f, 1.f, 1e15f, 1e30f);
        const bool are_points = *rc::gen::element(true, false, false);
        RC_CLASSIFY(are_points || scale == 0, "degenerate");
        const Flipped given = some_flipped_boxes(random, scale, are_points);
        const int count = static_cast<int>(given.boxes.size());
        Box<float> first_whole;
        for (const Target target : available_targets()) {
          std::vector<BoxBlock<float>> blocks(static_cast<std::size_t>(blocks_of(count)));
          Box<float> whole;
          RC_ASSERT(box_kernels(target).put_grown(given.boxes.data(), count, given.lost, blocks.data(), whole));
          auto around = Box<float>::empty();
          for (int i = 0; i < count; ++i) {
            const Box<float> box = get_box(blocks.data(), i);
            RC_ASSERT(is_grown(box, given.boxes[static_cast<std::size_t>(i)].box(), given));
            around.merge(box);
          }
          RC_ASSERT(around.low == whole.low && around.high == whole.high);
          if (target == available_targets()[0]) first_whole = whole;
          RC_ASSERT(whole.low == first_whole.low && whole.high == first_whole.high);
        }
      });
  t.holds(
      "they are not put there if one of them, or what they are off by, is undefined, infinite or nearly beyond the range of "
      "float",
      {.number_type = "float", .cases = 300}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        Flipped given = some_flipped_boxes(random, 1, false);
        const int count = static_cast<int>(given.boxes.size()), place = static_cast<int>(random() % 7);
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const float bad = *rc::gen::element(float(nan), -infinity, infinity, -1.001f * largest_box);
        if (place < 6) given.boxes[random() % given.boxes.size()].of[place + place / 3] = bad;
        else given.lost = std::abs(double(bad));
        for (const Target target : available_targets()) {
          std::vector<BoxBlock<float>> blocks(static_cast<std::size_t>(blocks_of(count)), BoxBlock<float>{});
          Box<float> whole{Vec<float, 3>::Constant(7), Vec<float, 3>::Constant(8)};
          RC_ASSERT(!box_kernels(target).put_grown(given.boxes.data(), count, given.lost, blocks.data(), whole));
          RC_ASSERT(whole.low[0] == 7 && whole.high[2] == 8 && blocks[0].side[0][0] == 0);
        }
      });
}

void flipped_boxes(Suite& t) {
  t.example("a flipped box is the union of the lanes that are merged into it", {}, [] {
    using P = Pack<float>;
    constexpr int width = static_cast<int>(P::size());
    const Point3 points[] = {{1, -2, 3}, {-4, 5, 0}, {2, 2, -6}};
    FlippedBox boxes[2];
    for (FlippedBox& b : boxes) b.set_all(std::numeric_limits<float>::infinity());
    int target[width];
    Box<double> expected[2] = {Box<double>::empty(), Box<double>::empty()};
    Box<P> lanes;
    for (int lane = 0; lane < width; ++lane) {
      const Point3 p = points[lane % 3] * (1.0 + lane);
      for (int i = 0; i < 3; ++i) lanes.low[i][lane] = float(p[i]), lanes.high[i][lane] = float(p[i] + i);
      target[lane] = lane % 2;
      expected[lane % 2].merge(Box<double>{p, p + Point3(0, 1, 2)});
    }
    merge_lanes(lanes, target, boxes);
    const bool merged = same(boxes[0].box(), expected[0]) && same(boxes[1].box(), expected[1]);
    boxes[0].set_all(-std::numeric_limits<float>::infinity());
    return merged && same(boxes[0].box(), Box<double>::everything());
  });
  grown_boxes(t);
}

}  // namespace

PROPTEST(box) {
  const std::vector<Point3> points{{1, -2, 3}, {-4, 5, 0}, {2, 2, -6}};
  t.example("around points: the least and the greatest coordinates; grown in all directions; in rows of registers too", {}, [=] {
    auto box = Box<double>::empty();
    const bool was_empty = box.is_empty();
    for (const Point3& p : points) box.merge(p);
    const Box<double> around = box_around<double>(points);
    if (!same(around, box) || !box_around<double>({}).is_empty()) return false;
    box.grow(0.5);
    return was_empty && !around.is_empty() && same(around, {{-4, -2, -6}, {2, 5, 3}}) &&
           same(box, {{-4.5, -2.5, -6.5}, {2.5, 5.5, 3.5}}) && same(by_rows<float>(points), box) &&
           same(by_rows<double>(points), box) && around.extent() == 22 && around.center() == Point3(-1, 1.5, -1.5) &&
           around.edges() == Point3(6, 7, 9);
  });
  t.example("the empty box changes none that it is merged with, and everything swallows all; empty is what one axis lacks", {},
            [] {
              Box<double> box = unit_box(0, 0), all = Box<double>::everything();
              box.merge(Box<double>::empty()), all.merge(box);
              bool ok = same(box, unit_box(0, 0)) && same(all, Box<double>::everything()) && !all.is_empty();
              for (int axis = 0; axis < 3; ++axis) {
                Box<double> flat = unit_box(0, 0), gone = flat;
                flat.high[axis] = flat.low[axis], gone.high[axis] = -1;
                ok = ok && !flat.is_empty() && gone.is_empty() && are_apart(Box<double>::empty(), unit_box(axis, 0));
              }
              return ok;
            });
  t.example("a coordinate separates boxes, from either side, but not boxes that touch, and a NaN separates nothing", {}, [] {
    bool ok = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        const Box<double> box = unit_box(axis, 0);
        ok = ok && separates_nothing(box, unit_box(axis, sign)) && are_apart(box, unit_box(axis, 1.25 * sign)) &&
             separates_nothing(box, unit_box(axis, nan));
      }
    return ok;
  });
  t.example("what two boxes have in common is as wide as its least edge, and less than nothing if they are apart", {}, [] {
    bool ok = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const double by : {-1.5, -1.0, -0.75, -0.25, 0.0, 0.25, 0.75, 1.0, 1.5}) {
        Box<double> small = unit_box(axis, by);
        ok = ok && common_width(unit_box(axis, 0), small) == 1 - std::abs(by) &&
             common_width(small, unit_box(axis, 0)) == 1 - std::abs(by);
        small.high[(axis + 1) % 3] = 0.125;
        ok = ok && common_width(unit_box(axis, 0), small) == std::min(0.125, 1 - std::abs(by));
      }
    return Checked(ok, 27);
  });
  t.example("the greatest coordinate of a box is that of one of its walls, whatever its sign", {}, [] {
    bool ok = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const double by : {-5.0, -1.5, -0.5, 0.0, 0.5, 5.0})
        ok = ok && unit_box(axis, by).greatest_coordinate() == std::max(std::abs(by), std::max(1.0, std::abs(1 + by)));
    return Checked(ok, 18);
  });
  t.example("a box extends beyond another one by the most in any coordinate, and by less than nothing if it does not", {}, [] {
    const Box<double> whole{Point3::Constant(-1), Point3::Constant(2)};
    bool ok = beyond_box(whole, whole) == 0 && beyond_box(unit_box(0, 0), whole) == -1 && beyond_box(whole, unit_box(0, 0)) == 1;
    for (int axis = 0; axis < 3; ++axis)
      for (const double by : {-3.0, -1.5, -0.5, 0.25, 1.5, 3.0})
        ok = ok && beyond_box(unit_box(axis, by), whole) == std::max(-1.0, by < 0 ? -1 - by : by - 1);
    return ok;
  });
  boxes_in_blocks(t);
  flipped_boxes(t);
}

}  // namespace proptests::suite_box
