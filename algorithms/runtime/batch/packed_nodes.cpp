// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/packed_nodes.hpp"

#include <algorithm>
#include <map>

#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr int lanes = Lanes<float>::count;

// A node is refitted whole with others of its joint-sets if these are few and the nodes fill a good part of the lanes.
constexpr std::size_t most_sets = most_sets_of_whole_nodes, fewest_nodes = 4;

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
  std::map<std::pair<int, int>, std::vector<Item>> pieces;  // by joint-set and count of weight vertices
  std::vector<int> merged;
  for (auto& [names, items] : by_sets) {
    if (names.size() == 1 || (names.size() <= most_sets && items.size() >= fewest_nodes)) {
      std::stable_sort(items.begin(), items.end(), has_fewer_weight_vertices);
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
        pieces[{s.joint_set, s.weight_vertex_count}].push_back({item.node, {&s, 1}, record});
        record += s.weight_vertex_count;
      }
      record_count_ += (count + 3) / 4 * 4;
    }
  }
  for (const auto& [key, items] : pieces) add(tree, sets, items, pieces_);
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
  for (std::size_t first = 0; first < items.size(); first += lanes)
    add_block(tree, sets, items.subspan(first, std::min<std::size_t>(lanes, items.size() - first)), to);
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
    int fewest = items[0].sets[e].weight_vertex_count, most = 0;
    for (const Item& it : items) {
      fewest = std::min(fewest, it.sets[e].weight_vertex_count);
      most = std::max(most, it.sets[e].weight_vertex_count);
    }
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
  for (int lane = 0; lane < lanes; ++lane) to.targets.push_back(item(lane).target);
}

NodeBlocks PackedNodes::Blocks::view() const {
  return {blocks.data(), static_cast<int>(blocks.size()), sets.data(), data.data(), targets.data(), most_weight_vertices};
}

}  // namespace refitlab
