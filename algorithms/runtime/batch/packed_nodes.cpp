// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/packed_nodes.hpp"

#include <algorithm>
#include <map>

#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr int lanes = Lanes<float>::count;

// A weight vertex of a node that is taken apart takes as long as this many lanes do where nodes are refitted whole, as measured.
constexpr double cost_apart = 2.5;

std::span<const NodePiece> pieces_of(const SphereTree& tree, const TreeNode& node) {
  return {tree.pieces.data() + node.first_piece, static_cast<std::size_t>(node.piece_count)};
}

std::vector<int> names_of(std::span<const NodePiece> sets) {
  std::vector<int> out;
  for (const NodePiece& s : sets) out.push_back(s.joint_set);
  return out;
}

int weight_vertex_count(std::span<const NodePiece> sets) {
  int sum = 0;
  for (const NodePiece& s : sets) sum += s.weight_vertex_count;
  return sum;
}

std::vector<int> weight_vertex_counts(std::span<const NodePiece> sets) {
  std::vector<int> out;
  for (const NodePiece& s : sets) out.push_back(s.weight_vertex_count);
  return out;
}

// Sorting by this gives the lanes of a block about as many weight vertices.
constexpr auto has_fewer_weight_vertices = [](const auto& a, const auto& b) {
  return std::pair(weight_vertex_count(a.sets), weight_vertex_counts(a.sets)) <
         std::pair(weight_vertex_count(b.sets), weight_vertex_counts(b.sets));
};

// Calls block(items) with the items of one block after another.
template <class Items, class Block>
void for_each_block(const Items& items, const Block& block) {
  for (std::size_t first = 0; first < items.size(); first += lanes)
    block(std::span(items).subspan(first, std::min<std::size_t>(lanes, items.size() - first)));
}

// Returns the most weight vertices that an item of a block has of joint-set e.
template <class Items>
int most_weight_vertices(const Items& block, std::size_t e) {
  int most = 0;
  for (const auto& item : block) most = std::max(most, item.sets[e].weight_vertex_count);
  return most;
}

// Returns whether nodes of the same joint-sets are refitted whole: there must be few joint-sets, and the nodes' weight vertices must
// fill a good part of the lanes.
template <class Items>
bool are_whole(const Items& items) {
  const std::size_t set_count = items[0].sets.size();
  if (set_count > most_sets_of_whole_nodes) return false;
  long used = 0, taken = 0;
  for_each_block(items, [&](auto block) {
    for (const auto& item : block) used += weight_vertex_count(item.sets);
    for (std::size_t e = 0; e < set_count; ++e) taken += lanes * most_weight_vertices(block, e);
  });
  return set_count == 1 || static_cast<double>(taken) < cost_apart * static_cast<double>(used);
}

}  // namespace

PackedNodes::PackedNodes(const SphereTree& tree, const JointSets& sets) : places_(tree.nodes.size()) {
  const DefaultFloatEnvironment environment;
  std::map<std::vector<int>, std::vector<Item>> by_sets;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const TreeNode& node = tree.nodes[n];
    const auto own = pieces_of(tree, node);
    by_sets[names_of(own)].push_back({&node, own, static_cast<int>(n)});
    largest_reference_ = std::max(largest_reference_, float_above(node.reference.center.norm()));
  }
  std::map<int, std::vector<Item>> pieces;  // by joint-set
  std::vector<int> merged;
  for (auto& [names, items] : by_sets) {
    std::stable_sort(items.begin(), items.end(), has_fewer_weight_vertices);
    if (are_whole(items)) {
      std::vector<int> nodes;
      for (const Item& item : items) nodes.push_back(item.target);
      place(nodes);
      add(tree, sets, items, nodes_);
      continue;
    }
    for (const Item& item : items) {
      const int count = weight_vertex_count(item.sets);
      merged.push_back(item.target);
      merged_.push_back({record_count_, count, float_above(item.node->reference.radius), 0});
      for (int record = record_count_; const NodePiece& s : item.sets) {
        pieces[s.joint_set].push_back({item.node, {&s, 1}, record});
        record += s.weight_vertex_count;
      }
      record_count_ += (count + 3) / 4 * 4;
    }
  }
  for (auto& [set, items] : pieces) {
    std::stable_sort(items.begin(), items.end(), has_fewer_weight_vertices);
    add(tree, sets, items, pieces_);
  }
  place(merged);
  for (std::size_t i = 0; i < merged.size(); ++i) merged_[i].place = places_[merged[i]];
}

// Places each node in a lane of new blocks of balls.
void PackedNodes::place(std::span<const int> nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i % lanes == 0) ball_lanes_ += 4;
    places_[nodes[i]] = (ball_lanes_ - 4) * lanes + static_cast<int>(i % lanes);
  }
}

void PackedNodes::add(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to) {
  for_each_block(items, [&](std::span<const Item> block) { add_block(tree, sets, block, to); });
}

void PackedNodes::add_block(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to) {
  const auto item = [&](int lane) -> const Item& { return items[std::min<std::size_t>(lane, items.size() - 1)]; };
  const auto add_row = [&](auto&& number) {
    Lanes<float> row;
    for (int lane = 0; lane < lanes; ++lane) row.lane[lane] = number(item(lane));
    to.data.push_back(row);
  };
  const auto share = [](const Item& it) { return 1 / static_cast<float>(weight_vertex_count(it.sets)); };
  // The items are sorted by the number of weight vertices.
  const bool same_share = weight_vertex_count(items.front().sets) == weight_vertex_count(items.back().sets);
  const std::size_t set_count = items[0].sets.size();
  to.blocks.push_back({static_cast<int>(to.sets.size()), static_cast<int>(set_count), static_cast<int>(to.data.size()),
                       static_cast<int>(to.targets.size()), same_share ? share(items[0]) : 0});
  for (int i = 0; i < 3; ++i) add_row([&](const Item& it) { return static_cast<float>(it.node->reference.center[i]); });
  add_row([](const Item& it) { return float_above(it.node->reference.radius); });
  if (!same_share) add_row(share);
  int weight_vertices = 0;
  for (std::size_t e = 0; e < set_count; ++e) {
    const int set = items[0].sets[e].joint_set, joints = static_cast<int>(sets.joints(set).size());
    const int most = most_weight_vertices(items, e);
    int fewest = most;
    for (const Item& it : items) fewest = std::min(fewest, it.sets[e].weight_vertex_count);
    to.sets.push_back({set, joints, fewest, most});
    weight_vertices += most;
    for (int k = 0; k < most; ++k) {
      if (k >= fewest) add_row([&](const Item& it) { return k < it.sets[e].weight_vertex_count ? 1.f : 0.f; });
      for (int i = 0; i + 1 < joints; ++i)
        add_row([&](const Item& it) {
          const NodePiece& s = it.sets[e];
          return static_cast<float>(tree.weight_vertices[s.first_weight + std::min(k, s.weight_vertex_count - 1) * joints + i]);
        });
    }
  }
  to.most_weight_vertices = std::max(to.most_weight_vertices, weight_vertices);
  for (int lane = 0; lane < lanes; ++lane)
    to.targets.push_back({item(lane).target, item(lane).target + item(lane).sets[0].weight_vertex_count - 1});
}

NodeBlocks PackedNodes::Blocks::view() const {
  return {blocks.data(), static_cast<int>(blocks.size()), sets.data(), data.data(), targets.data(), most_weight_vertices};
}

}  // namespace refitlab
