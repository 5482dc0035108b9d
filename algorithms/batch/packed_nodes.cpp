#include "algorithms/batch/packed_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace refitlab {
namespace {

constexpr int lanes = Lanes<float>::count;

// A node is refitted whole with others of its joint-sets if these are few and the nodes fill a good part of the lanes.
constexpr std::size_t most_sets = most_sets_of_whole_nodes, fewest_nodes = 4;

float round_up(double x) {
  const auto f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

std::span<const NodeJointSet> joint_sets(const SphereTree& tree, const TreeNode& node) {
  return {tree.joint_sets.data() + node.first_joint_set, static_cast<std::size_t>(node.joint_set_count)};
}

std::vector<int> names_of(std::span<const NodeJointSet> sets) {
  std::vector<int> out;
  for (const NodeJointSet& s : sets) out.push_back(s.joint_set);
  return out;
}

int corner_count(std::span<const NodeJointSet> sets) {
  int sum = 0;
  for (const NodeJointSet& s : sets) sum += s.corner_count;
  return sum;
}

}  // namespace

PackedNodes::PackedNodes(const SphereTree& tree, const JointSets& sets) : places_(tree.nodes.size()) {
  std::map<std::vector<int>, std::vector<Item>> by_sets;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const TreeNode& node = tree.nodes[n];
    const auto own = joint_sets(tree, node);
    by_sets[names_of(own)].push_back({&node, own, static_cast<int>(n)});
    largest_reference_ = std::max(largest_reference_, round_up(node.reference.center.norm()));
  }
  std::map<std::pair<int, int>, std::vector<Item>> pieces;  // by joint-set and count of corners
  std::vector<int> merged;
  for (auto& [names, items] : by_sets) {
    if (names.size() == 1 || (names.size() <= most_sets && items.size() >= fewest_nodes)) {
      add(tree, sets, std::move(items), nodes_, [&](const Item& item, int block, int lane) {
        places_[item.target] = 4 * block * lanes + lane;
      });
      continue;
    }
    for (const Item& item : items) {
      int corner = static_cast<int>(merged_corners_.size());
      const int count = corner_count(item.sets);
      merged.push_back(item.target);
      merged_.push_back({corner, count, round_up(item.node->reference.radius), 0});
      merged_corners_.resize(merged_corners_.size() + count);
      most_merged_corners_ = std::max(most_merged_corners_, count);
      for (const NodeJointSet& s : item.sets) {
        pieces[{s.joint_set, s.corner_count}].push_back({item.node, {&s, 1}, corner});
        corner += s.corner_count;
      }
    }
  }
  for (auto& [key, items] : pieces) {
    const int corners = key.second, lanes_a_block = 1 + 3 * corners, before = static_cast<int>(pieces_.blocks.size()),
              first = piece_lanes_;
    add(tree, sets, std::move(items), pieces_, [&, first, corners](const Item& item, int block, int lane) {
      const int radius = (first + (block - before) * lanes_a_block) * lanes + lane;
      for (int k = 0; k < corners; ++k) merged_corners_[item.target + k] = {radius, radius + (1 + 3 * k) * lanes};
    });
    piece_lanes_ += (static_cast<int>(pieces_.blocks.size()) - before) * lanes_a_block;
  }
  // The merged nodes' balls come after the others.
  int block = static_cast<int>(nodes_.blocks.size()), lane = 0;
  for (std::size_t i = 0; i < merged_.size(); ++i) {
    merged_[i].place = places_[merged[i]] = 4 * block * lanes + lane;
    if (++lane == lanes) lane = 0, ++block;
  }
  ball_lanes_ = 4 * (block + 1);
}

template <class Found>
void PackedNodes::add(const SphereTree& tree, const JointSets& sets, std::vector<Item> items, Blocks& to, Found&& found) {
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    const auto counts = [](const Item& i) {
      std::vector<int> out;
      for (const NodeJointSet& s : i.sets) out.push_back(s.corner_count);
      return out;
    };
    return std::pair(corner_count(a.sets), counts(a)) < std::pair(corner_count(b.sets), counts(b));
  });
  for (std::size_t first = 0; first < items.size(); first += lanes) {
    const auto in_block = std::span(items).subspan(first, std::min<std::size_t>(lanes, items.size() - first));
    for (std::size_t lane = 0; lane < in_block.size(); ++lane)
      found(in_block[lane], static_cast<int>(to.blocks.size()), static_cast<int>(lane));
    add_block(tree, sets, in_block, to);
  }
}

void PackedNodes::add_block(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to) {
  const std::size_t set_count = items[0].sets.size();
  to.blocks.push_back({static_cast<int>(to.sets.size()), static_cast<int>(set_count), static_cast<int>(to.data.size())});
  const auto item = [&](int lane) -> const Item& { return items[std::min<std::size_t>(lane, items.size() - 1)]; };
  const auto add_row = [&](auto&& number) {
    Lanes<float> row;
    for (int lane = 0; lane < lanes; ++lane) row.lane[lane] = number(item(lane));
    to.data.push_back(row);
  };
  for (int i = 0; i < 3; ++i) add_row([&](const Item& it) { return static_cast<float>(it.node->reference.center[i]); });
  add_row([](const Item& it) { return round_up(it.node->reference.radius); });
  add_row([](const Item& it) { return 1 / static_cast<float>(corner_count(it.sets)); });
  int corners = 0;
  for (std::size_t e = 0; e < set_count; ++e) {
    const int set = items[0].sets[e].joint_set, joints = static_cast<int>(sets.joints(set).size());
    int most = 0;
    for (const Item& it : items) most = std::max(most, it.sets[e].corner_count);
    to.sets.push_back({set, joints, most});
    corners += most;
    for (int k = 0; k < most; ++k) {
      add_row([&](const Item& it) { return k < it.sets[e].corner_count ? 1.f : 0.f; });
      for (int i = 0; i < joints; ++i)
        add_row([&](const Item& it) {
          const NodeJointSet& s = it.sets[e];
          return static_cast<float>(tree.corner_weights[s.first_weight + std::min(k, s.corner_count - 1) * joints + i]);
        });
    }
  }
  to.most_corners = std::max(to.most_corners, corners);
}

NodeBlocks PackedNodes::Blocks::view() const {
  return {blocks.data(), static_cast<int>(blocks.size()), sets.data(), data.data(), most_corners};
}

}  // namespace refitlab
