// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/meeting_boxes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_meeting_boxes {
namespace {

using namespace refitlab;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Compares all with all, by the definition.
std::vector<std::pair<int, int>> all_that_meet(const std::vector<Box<double>>& boxes) {
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < static_cast<int>(boxes.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(boxes.size()); ++b) {
      bool meet = true;
      for (int i = 0; i < 3; ++i) meet = meet && boxes[a].low[i] <= boxes[b].high[i] && boxes[b].low[i] <= boxes[a].high[i];
      if (meet) pairs.push_back({a, b});
    }
  return pairs;
}

// Makes boxes whose sides are whole multiples of a unit, so that many touch, in a cube whose edges have so many units.
std::vector<Box<double>> boxes_on_a_grid(int count, const std::array<int, 3>& edges, int longest, double unit,
                                         std::mt19937& random) {
  const auto up_to = [&](int most) { return static_cast<int>(random() % (static_cast<unsigned>(most) + 1)); };
  std::vector<Box<double>> boxes;
  for (int n = 0; n < count; ++n) {
    Box<double> box;
    for (int i = 0; i < 3; ++i) box.low[i] = unit * up_to(edges[i]), box.high[i] = box.low[i] + unit * up_to(longest);
    boxes.push_back(box);
  }
  return boxes;
}

void pairs_are_those_of_all(Suite& t) {
  t.holds("the boxes that meet are those of all pairs that do, wherever they are and however large",
          {.number_type = "double", .cases = 400, .degenerate_at_least = 0.3, .tags_at_least = {{"some", 0.5}, {"none", 0.05}}},
          [] {
            std::mt19937 random(*gen::between(0u, 1u << 30));
            const int count = *rc::gen::weightedElement<int>({{1, 0}, {1, 1}, {1, 2}, {3, 30}, {3, 300}});
            std::array<int, 3> edges;
            for (int& edge : edges) edge = *rc::gen::weightedElement<int>({{1, 0}, {1, 1}, {5, 20}, {5, 400}});
            // The smallest units are not normal, and with the greatest some lengths are infinite.
            const double unit =
                *rc::gen::weightedElement<double>({{4, 1.0}, {4, 0.1}, {1, 5e-324}, {1, 1e-310}, {1, 4e305}, {1, 1.7e308 / 400}});
            auto boxes = boxes_on_a_grid(count, edges, *rc::gen::element(0, 1, 20, 200), unit, random);
            const int infinite_in_ten = *rc::gen::weightedElement<int>({{4, 0}, {1, 1}, {1, 10}});
            bool is_any_infinite = false;
            for (auto& box : boxes)
              for (int i = 0; i < 3; ++i) {
                if (random() % 2) box.low[i] -= unit * edges[i] * 0.5;  // below zero, too
                if (static_cast<int>(random() % 10) >= infinite_in_ten) continue;
                is_any_infinite = true;
                if (random() % 3) box.low[i] = -infinity;
                if (random() % 3) box.high[i] = infinity;
              }
            const bool is_flat = *std::min_element(edges.begin(), edges.end()) == 0;
            RC_CLASSIFY(is_any_infinite || is_flat || unit < 1e-300 || unit > 1e300, "degenerate");
            const auto expected = all_that_meet(boxes);
            RC_TAG(expected.empty() ? "none" : "some");
            RC_ASSERT(meeting_boxes(boxes) == expected);
          });
}

void pairs_of_squares(Suite& t) {
  t.example("of two thousand men in a square, whichever way it lies, and in a row, those who meet are found", {}, [] {
    long pairs = 0, wrong = 0, tried = 0;
    for (const Point3& edges : {Point3(60, 0, 60), Point3(60, 60, 0), Point3(0, 60, 60), Point3(0, 0, 1000)}) {
      std::mt19937 random(7);
      std::uniform_real_distribution<double> share(0, 1);
      std::vector<Box<double>> boxes;
      for (int n = 0; n < 2000; ++n) {
        const Point3 low = edges.cwiseProduct(Point3(share(random), share(random), share(random)));
        boxes.push_back({low, low + Point3(0.7, 1.8, 0.5)});
      }
      const auto expected = all_that_meet(boxes);
      wrong += meeting_boxes(boxes) != expected, pairs += static_cast<long>(expected.size()), ++tried;
    }
    return Checked(wrong == 0 && pairs > 1000, tried, std::to_string(pairs) + " pairs");
  });
}

}  // namespace

PROPTEST(meeting_boxes) { pairs_are_those_of_all(t), pairs_of_squares(t); }

}  // namespace proptests::suite_meeting_boxes
