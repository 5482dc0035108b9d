// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_pairs.hpp"

#include <algorithm>
#include <cstdint>

#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/packs/common_bit.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/packs/look_up.hpp"

namespace refitlab {
namespace {

// Pairs of candidates are listed in parts of at most so many, or those of one block of the second ones. A yes/no query ends with
// the first part in which a pair touches.
constexpr int pairs_at_once = 1 << 14, pairs_at_once_of_yes_no = 1 << 8;

static_assert(most_cluster_triangles <= most_candidates);

constexpr std::uintptr_t page = 4096;  // bytes

TrianglePoints points_of(const PaddedVertex* vertices, const std::array<std::uint16_t, 3>& places) {
  const auto point = [&](int i) {
    return Point3(vertices[places[i]].of[0], vertices[places[i]].of[1], vertices[places[i]].of[2]);
  };
  return {point(0), point(1), point(2)};
}

// Returns whether the list had no such room before.
template <class T>
bool reserve_at_least(std::vector<T>& list, std::size_t size) {
  if (list.size() >= size) return false;
  list.resize(size);
  return true;
}

}  // namespace

bool Candidates::reserve(int triangles, int positions) {
  bool grows = reserve_at_least(triangle, triangles + Lanes<float>::count);
  grows = reserve_at_least(outcodes, byte_table_size(positions)) || grows;
  const std::size_t blocks = look_up_size(triangles) / Lanes<float>::count;
  for (auto& side : box) grows = reserve_at_least(side, blocks) || grows;
  for (auto& coordinate : vertices) grows = reserve_at_least(coordinate, blocks) || grows;
  return grows;
}

CandidateArrays Candidates::arrays() {
  CandidateArrays out{triangle.data(), outcodes.data(), {}, {}};
  for (int i = 0; i < 6; ++i) out.box[i] = box[i].data()->lane.data();
  for (int i = 0; i < 9; ++i) out.vertices[i] = vertices[i].data()->lane.data();
  return out;
}

void DoublePairs::add(const std::array<PaddedVertex, 3>& a, const std::array<PaddedVertex, 3>& b, TrianglePair pair) {
  TrianglePairCandidate candidate{{}, {}, pair.first, pair.second};
  for (int i = 0; i < 3; ++i) {
    candidate.a[i] = candidate.b[i] = static_cast<std::uint16_t>(vertices_a_.size());
    vertices_a_.push_back(a[i]), vertices_b_.push_back(b[i]);
  }
  pairs_.push_back(candidate);
}

void DoublePairs::decide(std::vector<TrianglePair>& found) {
  const DefaultFloatEnvironment environment;
  answers_.resize(pairs_.size());
  box_kernels(best_target())
      .filter_pairs(vertices_a_.data(), vertices_b_.data(), pairs_.data(), static_cast<int>(pairs_.size()), answers_.data());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const bool meet = answers_[p] == Filtered::unknown
                          ? triangles_meet(points_of(vertices_a_.data(), pairs_[p].a), points_of(vertices_b_.data(), pairs_[p].b))
                          : answers_[p] == Filtered::meet;
    if (meet) found.push_back({pairs_[p].first, pairs_[p].second});
  }
  clear();
}

void DoublePairs::clear() { vertices_a_.clear(), vertices_b_.clear(), pairs_.clear(); }

void ClusterPairScratch::reserve(const ClusterTree& first_tree, const ClusterTree& second_tree) {
  bool grows = first.reserve(first_tree.most_triangles(), first_tree.most_room());
  grows = second.reserve(second_tree.most_triangles(), second_tree.most_room()) || grows;
  const int triangles = std::max(first_tree.most_triangles(), second_tree.most_triangles());
  const std::size_t count = Lanes<float>::count + std::max(pairs_at_once, Lanes<float>::count * triangles);
  for (auto* list : {&meet, &unknown}) reserve_at_least(*list, count);
  grows = reserve_at_least(room_for_pairs_, count + page / sizeof(CandidatePair)) || grows;
  if (grows) place_pairs();
}

// Processors tell loads from earlier stores by the lowest bits of their addresses at first, and a load waits where these are equal.
// So the list of pairs, which is written while boxes are read, begins as far from where these do as it can within a page.
void ClusterPairScratch::place_pairs() {
  const auto place_of = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p) % page; };
  std::uintptr_t farthest = 0;
  for (std::uintptr_t shift = 0; shift < page; shift += sizeof(Lanes<float>)) {
    std::uintptr_t nearest = page;
    for (const Candidates* candidates : {&first, &second})
      for (const auto& side : candidates->box) {
        const std::uintptr_t behind = (place_of(room_for_pairs_.data()) + shift - place_of(side.data())) % page;
        nearest = std::min({nearest, behind, page - behind});
      }
    if (nearest > farthest) farthest = nearest, first_pair_ = shift / sizeof(CandidatePair);
  }
}

void ClusterPairScratch::leave_open(const Open& pair, const CandidateArrays& of_first, int i, const CandidateArrays& of_second,
                                    int j, float slack) {
  const std::size_t block = open.size() / Lanes<float>::count, lane = open.size() % Lanes<float>::count;
  if (block == open_vertices.size()) open_vertices.emplace_back();
  TrianglePairBlock& to = open_vertices[block];
  for (int n = 0; n < 9; ++n)
    to.first[n].lane[lane] = of_first.vertices[n][i], to.second[n].lane[lane] = of_second.vertices[n][j];
  to.slack.lane[lane] = slack;
  open.push_back(pair);
}

ClusterPairs::ClusterPairs(SkinnedClusters& first, SkinnedClusters& second, Query query, QueryCounts& counts,
                           ClusterPairScratch& scratch)
    : first_(first),
      second_(second),
      query_(query),
      counts_(counts),
      scratch_(scratch) {
  // A query that ends early, or by an exception, leaves what was not decided.
  scratch.open.clear(), scratch.doubles.clear(), scratch.touching.clear();
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const double offset = second.origin()[i] - first.origin()[i];
    offset_[i] = static_cast<float>(offset);
    largest = std::max(largest, std::abs(offset));
  }
  lost_ = four_roundings * static_cast<float>(largest);
  scratch.reserve(first.tree(), second.tree());
  candidates_[0] = scratch.first.arrays(), candidates_[1] = scratch.second.arrays();
}

void ClusterPairs::add_all() {
  auto& near = scratch_.near;
  near.clear();
  if (!are_apart(first_.box_around_all(), moved(second_.box_around_all())))
    for (int a = 0; a < static_cast<int>(first_.tree().clusters().size()); ++a) list_near(a);
  if (query_ == Query::yes_no && !near.empty()) {
    const auto depth = [&](ClusterPair p) {
      return common_width(first_.cluster(p.first).box, moved(second_.cluster(p.second).box));
    };
    std::iter_swap(near.begin(),
                   std::max_element(near.begin(), near.end(), [&](ClusterPair p, ClusterPair q) { return depth(p) < depth(q); }));
  }
  for (std::size_t i = 0; i < near.size() && !is_done(); ++i) add(near[i].first, near[i].second);
  if (!is_done()) decide();
}

// Lists the clusters of the second body whose boxes meet that of a cluster of the first one.
void ClusterPairs::list_near(int a) {
  const Box<float> box = moved_back(first_.cluster(a).box);
  const int count = static_cast<int>(second_.tree().clusters().size()), block_count = blocks_of(count);
  auto &near_blocks = scratch_.near_blocks, &near_clusters = scratch_.near_clusters;
  reserve_at_least(near_blocks, block_count), reserve_at_least(near_clusters, boxes_of_block);
  const int found = kernels_.overlaps(second_.boxes_around_blocks(), block_count, box, near_blocks.data());
  counts_.ball_tests += block_count;
  for (int k = 0; k < found; ++k) {
    const int block = near_blocks[k], first = boxes_of_block * block, size = std::min(boxes_of_block, count - first);
    const int near = kernels_.overlaps(second_.boxes() + block, size, box, near_clusters.data());
    counts_.ball_tests += size;
    for (int n = 0; n < near; ++n) scratch_.near.push_back({a, first + near_clusters[n]});
  }
}

void ClusterPairs::add(int a, int b) {
  const FloatCluster &of_a = first_.cluster(a), &of_b = second_.cluster(b);
  const Box<float> box_b = moved(of_b.box);
  if (are_apart(of_a.box, box_b)) return;
  const float slack = std::max(of_a.slack, of_b.slack + lost_);
  // A point of both clusters is in both boxes.
  Box<float> common = of_a.box;
  common.cut(box_b);
  common.grow(slack);
  Side side_a{first_, a, false, candidates_[0]}, side_b{second_, b, true, candidates_[1]};
  // The cluster that has fewer triangles for its volume comes first, since about as few of them are in the common box. The triangles
  // of the other one are culled against its candidates, too, and these against what is left of the other one. Both ways find the same,
  // so it does no harm if a volume is no number.
  const bool is_second_early = static_cast<float>(side_b.triangles().count) * of_a.box.edges().prod() <
                               static_cast<float>(side_a.triangles().count) * box_b.edges().prod();
  Side &early = is_second_early ? side_b : side_a, &late = is_second_early ? side_a : side_b;
  if (!find_candidates(early, common, 2 * slack)) return;
  common.cut(early.all);
  if (!find_candidates(late, common, 2 * slack)) return;
  early.count = kernels_.keep(early.count, late.all, early.candidates);
  if (early.count == 0) return;
  // The candidates of one body are taken one by one, and those of the other in whole blocks. Which is which is chosen so that
  // there is less to compare.
  constexpr int block = Lanes<float>::count;
  const bool is_first_in_blocks = side_b.count * blocks_for<float>(side_a.count) < side_a.count * blocks_for<float>(side_b.count);
  const Side &single = is_first_in_blocks ? side_b : side_a, &in_blocks = is_first_in_blocks ? side_a : side_b;
  const int step =
      block * std::max(1, (query_ == Query::full ? pairs_at_once : pairs_at_once_of_yes_no) / (block * single.count));
  for (int begin = 0; begin < in_blocks.count && !is_done(); begin += step) {
    const int count = kernels_.meeting(single.candidates, single.count, in_blocks.candidates, begin,
                                       std::min(in_blocks.count, begin + step), 2 * slack, scratch_.pairs());
    filter(single, in_blocks, count, slack);
  }
  if (query_ == Query::yes_no && !is_done()) decide();  // it may be done then
}

bool ClusterPairs::find_candidates(Side& side, const Box<float>& common, float margin) {
  const ClusterTriangles triangles = side.triangles();
  const float* const xyz = side.body.cluster(side.cluster).xyz;
  const int room = side.body.tree().floats().room(side.cluster);
  side.count = kernels_.cull(triangles, xyz, room, side.is_second ? moved_back(common) : common, side.candidates);
  if (side.count == 0) return false;
  constexpr float none[3] = {};
  kernels_.place(triangles, xyz, room, side.is_second ? offset_ : none, side.count, side.candidates, side.all);
  side.all.grow(margin);
  return true;
}

void ClusterPairs::filter(const Side& single, const Side& in_blocks, int count, float slack) {
  if (count == 0) return;
  counts_.triangle_tests += count;
  int meet_count = 0, unknown_count = 0;
  kernels_.filter(single.candidates, single.count, in_blocks.candidates, in_blocks.count, scratch_.pairs(), count, slack,
                  scratch_.meet.data(), meet_count, scratch_.unknown.data(), unknown_count);
  const Side &side_a = single.is_second ? in_blocks : single, &side_b = single.is_second ? single : in_blocks;
  const int a = side_a.cluster, b = side_b.cluster;
  // Returns the places of a pair in the lists of candidates, that of the first body first.
  const auto places_of = [&](CandidatePair pair) {
    return single.is_second ? std::pair(second_of(pair), first_of(pair)) : std::pair(first_of(pair), second_of(pair));
  };
  const int *const triangles_a = first_.tree().triangles(a), *const triangles_b = second_.tree().triangles(b);
  if (meet_count > 0) list_touching({a, b});
  for (int m = 0; m < meet_count; ++m) {
    const auto [i, j] = places_of(scratch_.meet[m]);
    found_.push_back({triangles_a[side_a.candidates.triangle[i]], triangles_b[side_b.candidates.triangle[j]]});
  }
  const ClusterTriangles vertices_a = side_a.triangles(), vertices_b = side_b.triangles();
  for (int m = 0; m < unknown_count; ++m) {
    const auto [i, j] = places_of(scratch_.unknown[m]);
    const int s = side_a.candidates.triangle[i], t = side_b.candidates.triangle[j];  // in their clusters
    scratch_.leave_open({a,
                         b,
                         {vertices_a.vertex[0][s], vertices_a.vertex[1][s], vertices_a.vertex[2][s]},
                         {vertices_b.vertex[0][t], vertices_b.vertex[1][t], vertices_b.vertex[2][t]},
                         {triangles_a[s], triangles_b[t]}},
                        side_a.candidates, i, side_b.candidates, j, slack);
  }
  if (scratch_.open.size() >= DoublePairs::most) decide();
}

void ClusterPairs::list_touching(ClusterPair pair) {
  if (scratch_.touching.empty() || scratch_.touching.back() != pair) scratch_.touching.push_back(pair);
}

// Leaves open what this does not decide.
void ClusterPairs::decide_by_slopes() {
  auto& open = scratch_.open;
  scratch_.answers.resize(open.size());
  kernels_.filter_by_slopes(scratch_.open_vertices.data(), static_cast<int>(open.size()), scratch_.answers.data());
  std::size_t left = 0;
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (scratch_.answers[k] == Filtered::meet)
      found_.push_back(open[k].pair), list_touching({open[k].cluster_a, open[k].cluster_b});
    if (scratch_.answers[k] == Filtered::unknown) open[left++] = open[k];
  }
  open.resize(left);
}

void ClusterPairs::decide() {
  decide_by_slopes();
  std::size_t first_found = found_.size();
  for (const ClusterPairScratch::Open& open : scratch_.open) {
    const auto first = [&](int i) { return first_.padded_vertex(open.cluster_a, open.a[i]); };
    const auto second = [&](int i) { return second_.padded_vertex(open.cluster_b, open.b[i]); };
    scratch_.doubles.add({first(0), first(1), first(2)}, {second(0), second(1), second(2)}, open.pair);
    if (scratch_.doubles.is_full()) scratch_.doubles.decide(found_);
  }
  scratch_.doubles.decide(found_);
  for (const ClusterPairScratch::Open& open : scratch_.open)  // the found ones are in the same order
    if (first_found < found_.size() && found_[first_found] == open.pair)
      ++first_found, list_touching({open.cluster_a, open.cluster_b});
  scratch_.open.clear();
}

}  // namespace refitlab
