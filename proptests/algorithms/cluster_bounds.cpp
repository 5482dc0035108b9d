// SPDX-License-Identifier: GPL-3.0-or-later
// The file of clusters with bounds over time.
#include "algorithms/runtime/tree/cluster_bounds.hpp"

#include <cmath>

#include "algorithms/runtime/tree/binary.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_cluster_bounds {
namespace {

using namespace refitlab;

float real() { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 7; }

BoundedPart drawn_bound() {
  BoundedPart part{{}, {{real(), real(), real()}, std::abs(real())}};
  for (int i = 0; i < 3; ++i) part.box.low[i] = real(), part.box.high[i] = part.box.low[i] + std::abs(real());
  return part;
}

ClusterBounds drawn_bounds() {
  ClusterBounds out;
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) out.primitives.push_back({n, *rc::gen::inRange(-1, 3), 0, -1});
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
    out.clusters.push_back({*rc::gen::inRange(0, static_cast<int>(out.primitives.size())),
                            *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 100))});
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) {
    out.clips.push_back({*rc::gen::element<std::string>("", "Walk", "\xC3\xA4\""), std::abs(static_cast<double>(real())), {}});
    for (std::size_t c = 0; c < out.clusters.size(); ++c) out.clips.back().clusters.push_back(drawn_bound());
  }
  for (int n = out.clips.size() > 1 ? *rc::gen::inRange(0, 3) : 0; n > 0; --n) {
    const auto clip = [&] { return *rc::gen::inRange(0, static_cast<int>(out.clips.size()) - 1); };
    out.crossfades.push_back({clip(), clip(), {}});
    for (std::size_t c = 0; c < out.clusters.size(); ++c) out.crossfades.back().clusters.push_back(drawn_bound());
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

}  // namespace

PROPTEST(cluster_bounds) {
  t.holds("what is read is what was written", {.number_type = "float", .cases = 300}, [] {
    const ClusterBounds bounds = drawn_bounds();
    const std::string bytes = bytes_of(bounds);
    const ClusterBounds again = cluster_bounds_of(bytes, "test");
    RC_ASSERT(bytes_of(again) == bytes);
    RC_ASSERT(again.clusters.size() == bounds.clusters.size() && again.clips.size() == bounds.clips.size());
    for (std::size_t k = 0; k < bounds.clips.size(); ++k) {
      RC_ASSERT(again.clips[k].name == bounds.clips[k].name && again.clips[k].duration == bounds.clips[k].duration);
      for (std::size_t c = 0; c < bounds.clusters.size(); ++c)
        RC_ASSERT(again.clips[k].clusters[c].box.low == bounds.clips[k].clusters[c].box.low &&
                  again.clips[k].clusters[c].box.high == bounds.clips[k].clusters[c].box.high &&
                  again.clips[k].clusters[c].ball.center == bounds.clips[k].clusters[c].ball.center &&
                  again.clips[k].clusters[c].ball.radius == bounds.clips[k].clusters[c].ball.radius);
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
    const std::string sealed_again = sealed("rfltimes", 2, std::string_view(bytes).substr(28));
    reason_against(sealed_again);
  });
  t.example(
      "indices out of range, reversed boxes, numbers that are none, and a list without a rest pose are refused by name", {}, [] {
        ClusterBounds good;
        good.primitives = {{0, 0, 0, 0}}, good.clusters = {{0, {0, 1}}};
        good.clips = {{"", 0, {{{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, 2}}}}};
        const auto reason = [&](auto&& change) {
          ClusterBounds bad = good;
          change(bad);
          return reason_against(bytes_of(bad));
        };
        const float nan = std::nanf("");
        return Checked(
            reason_against(bytes_of(good)).empty() &&
                reason([](auto& b) { b.clusters[0].primitive = 1; }) == "test: cluster 0: its primitive is out of range" &&
                reason([](auto& b) { b.clusters[0].primitive = -1; }) == "test: cluster 0: its primitive is out of range" &&
                reason([](auto& b) { b.clusters[0].triangles[1] = -1; }) == "test: cluster 0: a triangle is out of range" &&
                reason([](auto& b) { b.clips.clear(); }) == "test: clips: the rest pose is missing" &&
                reason([](auto& b) { b.clips[0].duration = -1; }) == "test: clip '': its duration is not a time" &&
                reason([](auto& b) { b.clips[0].clusters.clear(); }) ==
                    "test: clip '': it does not have a bound for each cluster" &&
                reason([](auto& b) { b.clips[0].clusters[0].box.low[1] = 2; }) == "test: clip '', cluster 0: its bound is none" &&
                reason([&](auto& b) { b.clips[0].clusters[0].box.high[2] = nan; }) ==
                    "test: clip '', cluster 0: its bound is none" &&
                reason([&](auto& b) { b.clips[0].clusters[0].ball.center[0] = nan; }) ==
                    "test: clip '', cluster 0: its bound is none" &&
                reason([](auto& b) { b.clips[0].clusters[0].ball.radius = -1; }) ==
                    "test: clip '', cluster 0: its bound is none" &&
                reason([&](auto& b) {
                  b.clips.push_back(b.clips[0]), b.crossfades = {{0, 1, b.clips[0].clusters}};
                }) == "test: crossfades: a clip is out of range" &&
                reason([&](auto& b) {
                  b.clips.push_back(b.clips[0]), b.crossfades = {{-1, 0, b.clips[0].clusters}};
                }) == "test: crossfades: a clip is out of range" &&
                reason([&](auto& b) {
                  b.clips.push_back(b.clips[0]), b.crossfades = {{0, 0, {}}};
                }) == "test: crossfade of '' and '': it does not have a bound for each cluster",
            14);
      });
}

}  // namespace proptests::suite_cluster_bounds
