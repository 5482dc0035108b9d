// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the file of clusters with bounds over time.
#include "algorithms/runtime/tree/cluster_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "algorithms/runtime/tree/binary.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_cluster_bounds {
namespace {

using namespace refitlab;

float real() { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 7; }

BoundedPart drawn_bound(int dop) {
  BoundedPart part{{}, {{real(), real(), real()}, std::abs(real())}};
  for (int i = 0; i < 3; ++i) part.box.low[i] = real(), part.box.high[i] = part.box.low[i] + std::abs(real());
  for (int k = 3; k < dop / 2; ++k) {
    const float low = real();
    part.slabs.push_back({low, low + std::abs(real())});
  }
  return part;
}
std::vector<BoundedPart> drawn_bounds(std::size_t count, int dop) {
  std::vector<BoundedPart> out;
  while (out.size() < count) out.push_back(drawn_bound(dop));
  return out;
}

bool are_equal(const std::vector<BoundedPart>& a, const std::vector<BoundedPart>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BoundedPart& x, const BoundedPart& y) {
    return x.box.low == y.box.low && x.box.high == y.box.high && x.ball.center == y.ball.center &&
           x.ball.radius == y.ball.radius &&
           std::equal(x.slabs.begin(), x.slabs.end(), y.slabs.begin(), y.slabs.end(),
                      [](const Slab<float>& s, const Slab<float>& t) { return s.low == t.low && s.high == t.high; });
  });
}

ClusterBounds drawn_bounds() {
  ClusterBounds out{.dop = *rc::gen::elementOf(dop_sizes)};
  const auto nodes = static_cast<std::size_t>(*rc::gen::inRange(0, 4));
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) out.primitives.push_back({n, *rc::gen::inRange(-1, 3), 0, -1});
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
    out.clusters.push_back({*rc::gen::inRange(0, static_cast<int>(out.primitives.size())),
                            *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 100))});
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) {
    out.clips.push_back({*rc::gen::element<std::string>("", "Walk", "\xC3\xA4\""), std::abs(static_cast<double>(real())),
                         drawn_bounds(out.clusters.size(), out.dop), drawn_bounds(nodes, out.dop)});
  }
  for (int n = out.clips.size() > 1 ? *rc::gen::inRange(0, 3) : 0; n > 0; --n) {
    const auto clip = [&] { return *rc::gen::inRange(0, static_cast<int>(out.clips.size()) - 1); };
    out.crossfades.push_back({clip(), clip(), drawn_bounds(out.clusters.size(), out.dop)});
  }
  return out;
}

std::string reason_against(const std::string& bytes) {
  try {
    cluster_bounds_of(bytes, "test");
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

// Checks that each change of good bounds makes them refused, for the reason that belongs to it.
Checked spoiled_bounds_are_refused() {
  ClusterBounds good{.dop = 14};
  good.primitives = {{0, 0, 0, 0}}, good.clusters = {{0, {0, 1}}};
  const BoundedPart bound{{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, 2}, {{0, 3}, {-1, 2}, {-1, 2}, {-2, 1}}};
  good.clips = {{"", 0, {bound}, {bound, bound}}};
  const float nan = std::nanf(""), infinite = HUGE_VALF;
  const auto part = [](ClusterBounds& b) -> BoundedPart& { return b.clips[0].clusters[0]; };
  const auto fade = [](int first, int second, bool is_bounded) {
    return [=](ClusterBounds& b) {
      b.clips.push_back(b.clips[0]);
      b.crossfades = {{first, second, is_bounded ? b.clips[0].clusters : std::vector<BoundedPart>()}};
    };
  };
  const std::pair<std::function<void(ClusterBounds&)>, const char*> spoiled[] = {
      {[](auto& b) { b.clusters[0].primitive = 1; }, "test: cluster 0: its primitive is out of range"},
      {[](auto& b) { b.clusters[0].primitive = -1; }, "test: cluster 0: its primitive is out of range"},
      {[](auto& b) { b.clusters[0].triangles[1] = -1; }, "test: cluster 0: a triangle is out of range"},
      {[](auto& b) { b.clips.clear(); }, "test: clips: the rest pose is missing"},
      {[](auto& b) { b.clips[0].duration = -1; }, "test: clip '': its duration is not a time"},
      {[](auto& b) { b.clips[0].duration = HUGE_VAL; }, "test: clip '': its duration is not a time"},
      {[](auto& b) { b.clips[0].duration = std::nan(""); }, "test: clip '': its duration is not a time"},
      {[](auto& b) { b.clips[0].clusters.clear(); }, "test: clip '': it does not have a bound for each cluster"},
      {[=](auto& b) { part(b).box.low[1] = 2; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).box.low[0] = -infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).box.high[0] = infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).box.high[2] = nan; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).ball.center[0] = nan; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).ball.center[1] = infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).ball.radius = -1; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).ball.radius = infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).ball.radius = nan; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).slabs[3].low = 2; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).slabs[1].low = -infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { part(b).slabs[2].high = infinite; }, "test: clip '', cluster 0: its bound is none"},
      {[=](auto& b) { b.clips[0].nodes[1].slabs[0].high = nan; }, "test: clip '', node 1: its bound is none"},
      {[=](auto& b) { b.clips[0].nodes[1].ball.radius = infinite; }, "test: clip '', node 1: its bound is none"},
      {[](auto& b) { b.clips.push_back(b.clips[0]), b.clips[1].nodes.pop_back(); },
       "test: clip '': it does not have a bound for each node"},
      {[](auto& b) { b.dop = 16, b.clusters.clear(), b.clips[0].clusters.clear(), b.clips[0].nodes.clear(); },
       "test: k-DOPs: there are none of 16 planes"},
      {fade(0, 1, true), "test: crossfades: a clip is out of range"},
      {fade(1, 0, true), "test: crossfades: a clip is out of range"},
      {fade(-1, 0, true), "test: crossfades: a clip is out of range"},
      {fade(0, -1, true), "test: crossfades: a clip is out of range"},
      {fade(0, 0, false), "test: crossfade of '' and '': it does not have a bound for each cluster"}};
  std::string wrong = reason_against(bytes_of(good));
  for (const auto& [change, reason] : spoiled) {
    ClusterBounds bad = good;
    change(bad);
    if (const std::string given = reason_against(bytes_of(bad)); given != reason)
      wrong += "'" + given + "', not '" + reason + "'; ";
  }
  return Checked(wrong.empty(), 1 + static_cast<long>(std::size(spoiled)), wrong);
}

}  // namespace

PROPTEST(cluster_bounds) {
  t.holds("what is read is what was written", {.number_type = "float", .cases = 300}, [] {
    const ClusterBounds bounds = drawn_bounds();
    const std::string bytes = bytes_of(bounds);
    const ClusterBounds again = cluster_bounds_of(bytes, "test");
    RC_ASSERT(bytes_of(again) == bytes);
    RC_ASSERT(again.dop == bounds.dop && again.clusters.size() == bounds.clusters.size() &&
              again.clips.size() == bounds.clips.size());
    for (std::size_t k = 0; k < bounds.clips.size(); ++k) {
      RC_ASSERT(again.clips[k].name == bounds.clips[k].name && again.clips[k].duration == bounds.clips[k].duration);
      RC_ASSERT(are_equal(again.clips[k].clusters, bounds.clips[k].clusters));
      RC_ASSERT(are_equal(again.clips[k].nodes, bounds.clips[k].nodes));
    }
    for (std::size_t c = 0; c < bounds.clusters.size(); ++c)
      RC_ASSERT(again.clusters[c].triangles == bounds.clusters[c].triangles);
  });
  t.holds("a file that ends anywhere, or has another byte, is refused", {.number_type = "float", .cases = 50}, [] {
    const std::string bytes = bytes_of(drawn_bounds());
    for (std::size_t size = 0; size < bytes.size(); ++size) RC_ASSERT(!reason_against(bytes.substr(0, size)).empty());
    RC_ASSERT(!reason_against(bytes + '\0').empty());
    for (int n = 0; n < 20; ++n) {
      std::string other = bytes;
      other[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^= static_cast<char>(1 << *rc::gen::inRange(0, 8));
      RC_ASSERT(!reason_against(other).empty());
    }
  });
  t.holds("with a checksum that fits, any bytes are read or refused", {.number_type = "float", .cases = 500}, [] {
    std::string bytes = bytes_of(drawn_bounds());
    for (int n = *rc::gen::inRange(1, 4); n > 0; --n)
      bytes[*rc::gen::inRange<std::size_t>(28, bytes.size())] = *rc::gen::arbitrary<char>();
    const std::string sealed_again = sealed("rfltimes", 3, std::string_view(bytes).substr(28));
    reason_against(sealed_again);
  });
  t.example(
      "indices out of range, reversed boxes and slabs, numbers that are none, and a list without a rest pose are refused by name",
      {}, spoiled_bounds_are_refused);
}

}  // namespace proptests::suite_cluster_bounds
