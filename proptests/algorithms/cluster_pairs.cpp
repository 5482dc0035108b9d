// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/cluster_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/packs/common_bit.hpp"
#include "algorithms/runtime/packs/look_up.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/guarded_bytes.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/triangles_meet.hpp"

namespace proptests::suite_cluster_pairs {
namespace {

using namespace refitlab;
using oracle::sorted;

// Looks into every pair of clusters.
std::vector<TrianglePair> pairs_of(SkinnedClusters& a, SkinnedClusters& b, QueryCounts& counts, ClusterPairScratch& scratch) {
  ClusterPairs pairs(a, b, Query::full, counts, scratch);
  for (int i = 0; i < static_cast<int>(a.tree().clusters().size()); ++i)
    for (int j = 0; j < static_cast<int>(b.tree().clusters().size()); ++j) pairs.add(i, j);
  pairs.decide();
  // Each pair found belongs to clusters that are listed, and each of these has one.
  const auto is_of = [&](const TrianglePair& p) {
    return [&](const ClusterPair& c) {
      return oracle::has_triangle(a.tree(), c.first, p.first) && oracle::has_triangle(b.tree(), c.second, p.second);
    };
  };
  for (const TrianglePair& p : pairs.found()) RC_ASSERT(std::any_of(pairs.touching().begin(), pairs.touching().end(), is_of(p)));
  for (const ClusterPair& c : pairs.touching())
    RC_ASSERT(std::any_of(pairs.found().begin(), pairs.found().end(), [&](const TrianglePair& p) { return is_of(p)(c); }));
  return sorted(pairs.found());
}

// Checks each pair of clusters by itself: a yes/no query ends with some of the expected pairs if there is one, and with no other.
// The clusters are listed as touching exactly if there is one.
void check_clusters_one_by_one(SkinnedClusters& a, SkinnedClusters& b, const std::vector<TrianglePair>& expected) {
  ClusterPairScratch scratch;
  for (int i = 0; i < static_cast<int>(a.tree().clusters().size()); ++i)
    for (int j = 0; j < static_cast<int>(b.tree().clusters().size()); ++j) {
      QueryCounts counts, of_yes_no;
      ClusterPairs all(a, b, Query::full, counts, scratch);
      all.add(i, j);
      RC_ASSERT(!all.is_done());
      all.decide();
      const bool is_any = std::any_of(expected.begin(), expected.end(), [&](const TrianglePair& p) {
        return oracle::has_triangle(a.tree(), i, p.first) && oracle::has_triangle(b.tree(), j, p.second);
      });
      RC_ASSERT(is_any == !all.found().empty());
      RC_ASSERT(is_any == !all.touching().empty());
      for (const ClusterPair& pair : all.touching()) RC_ASSERT((pair == ClusterPair{i, j}));
      ClusterPairs one(a, b, Query::yes_no, of_yes_no, scratch);
      one.add(i, j);
      if (!one.is_done()) one.decide();
      RC_ASSERT(one.is_done() == is_any && one.found().size() <= all.found().size() && one.touching().empty() == !is_any);
      RC_ASSERT(of_yes_no.triangle_tests <= counts.triangle_tests);
      for (const TrianglePair& pair : one.found()) RC_ASSERT(std::binary_search(expected.begin(), expected.end(), pair));
      if (of_yes_no.triangle_tests < counts.triangle_tests) RC_TAG("a yes/no query ends early");
    }
}

// Returns how deep the boxes of two clusters reach into each other, both seen from the first body's origin.
float depth(const ClusterPairs& pairs, SkinnedClusters& a, SkinnedClusters& b, ClusterPair of) {
  return common_width(a.cluster(of.first).box, pairs.moved(b.cluster(of.second).box));
}

// Skins both bodies whole and checks that all clusters are looked into: a full query finds the expected pairs, and a yes/no query some
// of them, in the clusters that reach deepest into each other if they touch.
void check_all_at_once(SkinnedClusters& a, SkinnedClusters& b, const std::vector<TrianglePair>& expected,
                       ClusterPairScratch& scratch) {
  a.skin_all(), b.skin_all();
  QueryCounts counts;
  ClusterPairs all(a, b, Query::full, counts, scratch);
  all.add_all();
  RC_ASSERT(sorted(all.found()) == expected);
  ClusterPair deepest{0, 0};
  for (int i = 0; i < static_cast<int>(a.tree().clusters().size()); ++i)
    for (int j = 0; j < static_cast<int>(b.tree().clusters().size()); ++j)
      if (depth(all, a, b, {i, j}) > depth(all, a, b, deepest)) deepest = {i, j};
  ClusterPairs of_deepest(a, b, Query::yes_no, counts, scratch);
  of_deepest.add(deepest.first, deepest.second);
  const bool do_deepest_touch = of_deepest.is_done();
  ClusterPairs one(a, b, Query::yes_no, counts, scratch);
  one.add_all();
  RC_ASSERT(one.is_done() == !expected.empty());
  for (const TrianglePair& pair : one.found()) RC_ASSERT(std::binary_search(expected.begin(), expected.end(), pair));
  if (do_deepest_touch) {
    RC_TAG("the deepest clusters touch");
    RC_ASSERT(depth(one, a, b, one.touching()[0]) == depth(one, a, b, deepest));
  }
}

// Candidates are moved by this offset.
constexpr float offset[] = {0.25f, -0.5f, 1};

// Draws triangles of few vertices, or of many, and a box. Some coordinates are on a side of the box, and some are no numbers.
struct DrawnTriangles {
  DrawnTriangles() {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<float> u(-1, 1);
    const bool are_many = *gen::between(0, 3) == 0, has_nan = *gen::between(0, 4) == 0;
    places = 16 * *gen::between(1, are_many ? 80 : 18), count = *gen::between(1, are_many ? 700 : 100);
    blocks.resize(3 * places / 16 + 1);
    for (int i = 0; i < 3 * places; ++i)
      blocks.data()->lane.data()[i] = random() % 50              ? u(random)
                                      : !has_nan || random() % 2 ? 0.5f
                                                                 : std::numeric_limits<float>::quiet_NaN();
    for (auto& list : vertex) {
      for (int t = 0; t < count; ++t) list.push_back(static_cast<std::uint16_t>(random() % places));
      list.resize(short_look_up_size(count), 0xffff);  // which is no place
    }
    for (int i = 0; i < 3; ++i) {
      const float a = u(random), b = random() % 4 ? u(random) : 0.5f;
      box.low[i] = std::min(a, b), box.high[i] = std::max(a, b);
    }
    for (int t = 0; t < count; ++t) {
      bool apart = false;
      for (int i = 0; i < 3; ++i) {
        apart = apart || (at(t, 0, i) < box.low[i] && at(t, 1, i) < box.low[i] && at(t, 2, i) < box.low[i]);
        apart = apart || (at(t, 0, i) > box.high[i] && at(t, 1, i) > box.high[i] && at(t, 2, i) > box.high[i]);
      }
      if (!apart) expected.push_back(t);
    }
  }

  const float* xyz() const { return blocks.data()->lane.data(); }
  ClusterTriangles triangles() const { return {count, {vertex[0].data(), vertex[1].data(), vertex[2].data()}}; }
  float at(int t, int corner, int i) const { return xyz()[i * places + vertex[corner][t]]; }
  // Returns a coordinate of a corner of the k-th triangle that is expected, moved.
  float moved(int k, int corner, int i) const { return at(expected[k], corner, i) + offset[i]; }
  std::pair<float, float> side(int k, int i) const { return std::minmax({moved(k, 0, i), moved(k, 1, i), moved(k, 2, i)}); }

  int places, count;
  std::vector<Lanes<float>> blocks;
  std::vector<std::uint16_t> vertex[3];
  Box<float> box;
  // These triangles are not certainly apart from the box.
  std::vector<int> expected;
};

// Asserts that candidates, and the box of all, are where they should be. Returns false if one has a coordinate that is no number.
bool are_numbers_in_place(const DrawnTriangles& drawn, int found, const CandidateArrays& out, const Box<float>& all) {
  bool has_nan = false;
  for (int k = 0; k < found; ++k)
    for (int i = 0; i < 9; ++i) {
      const float x = drawn.moved(k, i / 3, i % 3);
      has_nan = has_nan || std::isnan(x);
      RC_ASSERT(out.vertices[i][k] == x || std::isnan(x));
    }
  if (has_nan) return false;
  Box<float> around = Box<float>::empty();
  for (int k = 0; k < found; ++k)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = drawn.side(k, i);
      RC_ASSERT(out.box[i][k] == low && out.box[3 + i][k] == high);
      around.low[i] = std::min(around.low[i], low), around.high[i] = std::max(around.high[i], high);
    }
  RC_ASSERT(all.low == around.low && all.high == around.high);
  return true;
}

// Asserts that a smaller box leaves the candidates that meet it. Returns their number.
int check_kept(const DrawnTriangles& drawn, const ClusterPairKernels& kernels, int found, const CandidateArrays& out) {
  Box<float> part = drawn.box;
  for (int i = 0; i < 3; ++i) part.low[i] += offset[i] + 0.1f, part.high[i] += offset[i] - 0.1f;
  std::vector<int> kept;
  for (int k = 0; k < found; ++k) {
    bool apart = false;
    for (int i = 0; i < 3; ++i) apart = apart || drawn.side(k, i).first > part.high[i] || drawn.side(k, i).second < part.low[i];
    if (!apart) kept.push_back(k);
  }
  const int left = kernels.keep(found, part, out);
  RC_ASSERT(left == static_cast<int>(kept.size()));
  for (int k = 0; k < left; ++k) {
    RC_ASSERT(out.triangle[k] == drawn.expected[kept[k]]);
    for (int i = 0; i < 9; ++i) RC_ASSERT(out.vertices[i][k] == drawn.moved(kept[k], i / 3, i % 3));
    for (int i = 0; i < 3; ++i)
      RC_ASSERT(out.box[i][k] == drawn.side(kept[k], i).first && out.box[3 + i][k] == drawn.side(kept[k], i).second);
  }
  return left;
}

// Checks all candidates against all of themselves, in one part or from the second block on.
void check_meeting(Target target, int left, const CandidateArrays& out) {
  const float margin = 0.05f;
  std::vector<CandidatePair> pairs(left * left + 16);
  for (const int begin : {0, 16}) {
    if (begin >= left && begin > 0) continue;
    const int count = cluster_pair_kernels(target).meeting(out, left, out, begin, left, margin, pairs.data());
    std::vector<std::pair<int, int>> got, want;
    for (int p = 0; p < count; ++p) got.emplace_back(first_of(pairs[p]), second_of(pairs[p]));
    const int width = target == Target::avx512 ? 16 : target == Target::avx2 ? 8 : 4;
    for (int p = count; count > 0 && p < count + width; ++p) RC_ASSERT(pairs[p] == pairs[count - 1]);
    for (int k = 0; k < left; ++k)
      for (int l = begin; l < left; ++l) {
        bool apart = false;
        for (int i = 0; i < 3; ++i)
          apart = apart || out.box[3 + i][k] < out.box[i][l] - margin || out.box[3 + i][l] + margin < out.box[i][k];
        if (!apart) want.emplace_back(k, l);
      }
    std::sort(got.begin(), got.end());
    RC_ASSERT(got == want);
  }
}

void check_candidates(const DrawnTriangles& drawn, Target target) {
  const ClusterPairKernels& kernels = cluster_pair_kernels(target);
  Candidates scratch;
  scratch.reserve(drawn.count, drawn.places);
  gen::GuardedBytes outcodes(byte_table_size(drawn.places));
  CandidateArrays out = scratch.arrays();
  out.outcodes = outcodes.data();
  const int found = kernels.cull(drawn.triangles(), drawn.xyz(), drawn.places, drawn.box, out);
  RC_ASSERT(std::vector<int>(out.triangle, out.triangle + found) == drawn.expected);
  if (found == 0) return;
  Box<float> all;
  kernels.place(drawn.triangles(), drawn.xyz(), drawn.places, offset, found, out, all);
  if (!are_numbers_in_place(drawn, found, out, all)) return;
  const int left = check_kept(drawn, kernels, found, out);
  if (left > 32) RC_TAG(drawn.places > most_in_registers ? "many of many places are kept" : "many are kept");
  check_meeting(target, left, out);
}

void pairs_are_those_of_all_triangles(Suite& t) {
  t.holds("the pairs of all pairs of clusters are those of testing all pairs of triangles, from any two origins",
          {.number_type = "double",
           .cases = 200,
           .degenerate_at_least = 0.3,
           .tags_at_least = {{"in contact", 0.3}, {"a yes/no query ends early", 0.02}}},
          [] {
            const auto plan_a = *gen::mesh_plan(), plan_b = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
            const Character a = bake(gen::make_mesh(plan_a)), b = bake(gen::make_mesh(plan_b));
            const auto most = [] {
              return ClusterOptions{.most_triangles = *rc::gen::element(1, 10, 100, most_cluster_triangles)};
            };
            const ClusterTree tree_a(a, most()), tree_b(b, most());
            const Skinning skinning = gen::drawn_skinning();
            SkinnedClusters first(tree_a, skinning), second(tree_b, skinning);
            ClusterPairScratch scratch;
            std::mt19937 random(plan_b.seed);
            std::normal_distribution<double> normal;
            for (int frame = 0; frame < 2; ++frame) {
              const double spread = *rc::gen::element(1e-4, 0.1, 0.5, 3.0), far = *rc::gen::element(0.0, 1.0, 1e4, 1e8);
              const Pose pose_a = gen::random_pose(a.mesh, random, spread), pose_b = gen::random_pose(b.mesh, random, spread);
              const Point3 around(far, -far, far / 3);
              const RigidTransform<double> at_a{gen::random_rotation(random, 1), around + Point3(normal(random), 0, 0)},
                  at_b{gen::random_rotation(random, 1), around + Point3(0, normal(random), 0) * 0.5};
              const Point3 common = *rc::gen::element<Point3>(Point3::Zero(), around);
              const bool is_common = *rc::gen::arbitrary<bool>();
              first.begin(pose_a, at_a, is_common ? common : at_a.translation);
              second.begin(pose_b, at_b, is_common ? common : at_b.translation);
              const auto expected = oracle::all_pairs({a, pose_a, at_a}, {b, pose_b, at_b}, skinning);
              QueryCounts counts;
              RC_ASSERT(pairs_of(first, second, counts, scratch) == expected);
              RC_ASSERT(counts.triangle_tests >= static_cast<long>(expected.size()));
              check_clusters_one_by_one(first, second, expected);
              check_all_at_once(first, second, expected, scratch);
              RC_TAG(expected.empty() ? "apart" : "in contact");
            }
          });
  t.holds("so they are of models at the ends of what is accepted, whose floats may overflow, underflow or say nothing",
          {.number_type = "double", .cases = 400}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const gen::WideModel wide = gen::wide_model(random, *rc::gen::element(2, 4, 20));
            const Character a = bake(wide.mesh);
            const ClusterTree tree(a, {.most_triangles = *rc::gen::element(2, 256)});
            SkinnedClusters first(tree, Skinning::spherical), second(tree, Skinning::spherical);
            const RigidTransform<double> at, other{gen::random_rotation(random, 1), Point3::Zero()};
            first.begin(wide.pose, at, Point3::Zero()), second.begin(wide.pose, other, Point3::Zero());
            QueryCounts counts;
            ClusterPairScratch scratch;
            RC_LOG() << wide.what;
            const auto expected = oracle::all_pairs({a, wide.pose, at}, {a, wide.pose, other}, Skinning::spherical);
            RC_ASSERT(pairs_of(first, second, counts, scratch) == expected);
            check_all_at_once(first, second, expected, scratch);
          });
}

// Makes squares of two triangles each in the plane z = 0, row by row.
SkinnedMesh flat_grid(int side) {
  SkinnedMesh m;
  m.name = "grid";
  m.joints = {{"root", -1, {0, 0, 0}}};
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) m.vertices.push_back({double(x), double(y), 0});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x, b = a + side + 1;
      m.triangles.push_back({a, a + 1, b});
      m.triangles.push_back({a + 1, b + 1, b});
    }
  m.influences.assign(m.vertices.size(), {{0, 1.0}});
  validate(m);
  return m;
}

// Returns the pairs of a grid and itself, moved by less than a square along each axis. Only squares that are near each other are
// looked at.
std::vector<TrianglePair> pairs_of_grid(const SkinnedMesh& grid, int side, const Point3& by) {
  std::vector<TrianglePair> out;
  const auto points = [&](int t, const Point3& moved) {
    const Triangle& v = grid.triangles[t];
    return TrianglePoints{grid.vertices[v[0]] + moved, grid.vertices[v[1]] + moved, grid.vertices[v[2]] + moved};
  };
  for (int square = 0; square < side * side; ++square)
    for (int y = std::max(0, square / side - 2); y < std::min(side, square / side + 3); ++y)
      for (int x = std::max(0, square % side - 2); x < std::min(side, square % side + 3); ++x)
        for (const int i : {2 * square, 2 * square + 1})
          for (const int j : {2 * (y * side + x), 2 * (y * side + x) + 1}) {
            const TrianglePoints a = points(i, Point3::Zero()), b = points(j, by);
            const Point3 low = a[0].cwiseMin(a[1]).cwiseMin(a[2]), high = a[0].cwiseMax(a[1]).cwiseMax(a[2]);
            if ((low.array() > b[0].cwiseMax(b[1]).cwiseMax(b[2]).array()).any() ||
                (high.array() < b[0].cwiseMin(b[1]).cwiseMin(b[2]).array()).any())
              continue;
            if (triangles_meet(a, b)) out.push_back({i, j});
          }
  return sorted(out);
}

void more_open_pairs_than_a_batch(Suite& t) {
  t.example("flat grids in one plane touch where all pairs do, although floats leave many batches of pairs open", {}, [] {
    const Pose still(1);
    const RigidTransform<double> here;
    ClusterPairScratch scratch;
    std::string wrong;
    long tried = 0;
    for (const auto& [side, by, skinning] :
         {std::tuple(48, Point3(0.5, 0.25, 0), Skinning::spherical), {20, Point3(0, 0, 0), Skinning::linear}}) {
      const Character c = bake(flat_grid(side));
      const ClusterTree tree(c, {.most_triangles = most_cluster_triangles});
      const auto expected = pairs_of_grid(c.mesh, side, by);
      if (expected.size() <= DoublePairs::most) wrong += "there are few pairs; ";
      const RigidTransform<double> at{identity_quaternion<double>(), by};
      SkinnedClusters first(tree, skinning), second(tree, skinning);
      first.begin(still, here, Point3::Zero()), second.begin(still, at, Point3::Zero());
      QueryCounts counts;
      const auto found = pairs_of(first, second, counts, scratch);
      if (found != expected) wrong += std::to_string(found.size()) + " for " + std::to_string(expected.size()) + " pairs; ";
      tried += static_cast<long>(expected.size());
      // There are blocks of clusters' boxes in several blocks of their own.
      const ClusterTree fine(c, {.most_triangles = 8});
      SkinnedClusters many(fine, skinning), more(fine, skinning);
      many.begin(still, here, Point3::Zero()), more.begin(still, at, Point3::Zero());
      many.skin_all(), more.skin_all();
      ClusterPairs all(many, more, Query::full, counts, scratch);
      const long tests = counts.ball_tests, count = static_cast<long>(fine.clusters().size());
      all.add_all();
      if (sorted(all.found()) != expected) wrong += "not all pairs of small clusters; ";
      if (count < 9 * boxes_of_block || counts.ball_tests - tests > count * count / 3) wrong += "blocks are not told apart; ";
    }
    return Checked(wrong.empty(), tried, wrong);
  });
  t.example("a list of pairs is full at the most that it takes, and decides each of them, list after list", {}, [] {
    std::mt19937 random(1);
    const auto corner = [&] { return Point3(double(random() % 4), double(random() % 4), double(random() % 3)); };
    const auto padded = [](const TrianglePoints& points) {
      std::array<PaddedVertex, 3> out;
      for (std::size_t i = 0; i < 3; ++i) out[i] = {{points[i][0], points[i][1], points[i][2], 0}};
      return out;
    };
    DoublePairs pairs;
    std::vector<TrianglePair> found, expected;
    long tried = 0;
    for (const std::size_t count :
         {std::size_t(0), std::size_t(1), DoublePairs::most, DoublePairs::most - 1, DoublePairs::most}) {
      for (std::size_t k = 0; k < count; ++k, ++tried) {
        if (pairs.is_full()) return Checked(false, tried, "full too early");
        const TrianglePoints a{corner(), corner(), corner()}, b{corner(), corner(), corner()};
        const TrianglePair pair{static_cast<int>(k), static_cast<int>(count)};
        pairs.add(padded(a), padded(b), pair);
        if (triangles_meet(a, b)) expected.push_back(pair);
      }
      if (pairs.is_full() != (count == DoublePairs::most)) return Checked(false, tried, "full, or not");
      pairs.decide(found);
    }
    return Checked(found == expected && !found.empty() && static_cast<long>(found.size()) < tried, tried);
  });
}

}  // namespace

PROPTEST(cluster_pairs) {
  pairs_are_those_of_all_triangles(t);
  more_open_pairs_than_a_batch(t);
  t.holds("on every target the filter never contradicts exact arithmetic on vertices within the slack of its floats",
          {.number_type = "rational", .cases = 120, .tags_at_least = {{"decided", 0.2}, {"unknown", 0.1}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            std::uniform_real_distribution<double> u(-1, 1);
            const double unit = *rc::gen::element(1.0, 1.0, 1.0, 1e-8, 1e-10, 1e-12, 1e-20, 1e11, 1e12, 1e20),
                         slack = unit * *rc::gen::element(0.0, 1e-7, 1e-5, 1e-3, 0.1);
            const auto drawn = [&](double size) -> Point3 { return Point3(u(random), u(random), u(random)) * size; };
            constexpr int count = 40, others = 3;  // of the second list
            Candidates room_a, room_b;
            room_a.reserve(count, 16), room_b.reserve(count + others, 16);
            std::vector<CandidatePair> pairs, meet(count + 16), unknown(count + 16);
            std::vector<bool> truth;
            const auto put = [&](Candidates& c, int k, const TrianglePoints& t) {
              for (int i = 0; i < 9; ++i) {
                const double x = t[i / 3][i % 3] + slack * 0.9 * u(random);
                c.arrays().vertices[i][k] = static_cast<float>(x);
              }
            };
            for (int k = 0; k < count; ++k) {
              const TrianglePoints a{drawn(unit), drawn(unit), drawn(unit)};
              TrianglePoints b{drawn(unit), drawn(unit), drawn(unit)};
              if (random() % 2) b[0] = a[0] * 0.5 + a[1] * 0.25 + a[2] * 0.25 + drawn(slack + 1e-6 * unit);
              if (random() % 4 == 0) b[1] = a[1] * 0.5 + a[2] * 0.5 + drawn(slack);
              put(room_a, k, a), put(room_b, count + others - 1 - k, b);
              truth.push_back(oracle::triangles_meet(a, b));
              pairs.push_back(pair_of(k, count + others - 1 - k));
            }
            pairs.resize(count + 16, pairs.back());
            // Rounding to float adds an error of 2^-24 of the size.
            const auto of_floats = static_cast<float>(slack + unit * 1.5 * 0x1p-24);
            for (const Target target : available_targets()) {
              int meets = 0, unknowns = 0;
              cluster_pair_kernels(target).filter(room_a.arrays(), count, room_b.arrays(), count + others, pairs.data(), count,
                                                  of_floats, meet.data(), meets, unknown.data(), unknowns);
              std::vector<int> answer(count, 0);
              for (int m = 0; m < meets; ++m) answer[first_of(meet[m])] += 1;
              for (int m = 0; m < unknowns; ++m) answer[first_of(unknown[m])] += 2;
              for (int k = 0; k < count; ++k) RC_ASSERT(answer[k] == 2 || answer[k] == (truth[k] ? 1 : 0));
              RC_TAG(unknowns == count ? "unknown" : "decided");
              if (unit == 1 && slack < 1e-6) RC_ASSERT(unknowns < count);
            }
          });
  t.holds(
      "on every target candidates are those that are not apart for certain",
      {.number_type = "float", .cases = 500, .tags_at_least = {{"many are kept", 0.1}, {"many of many places are kept", 0.05}}},
      [] {
        const DrawnTriangles drawn;
        for (const Target target : available_targets()) check_candidates(drawn, target);
      });
  t.holds("on every target boxes that meet are listed wherever they are; a side that is no number tells nothing apart",
          {.number_type = "float", .cases = 500, .degenerate_at_least = 0.4}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            std::uniform_real_distribution<float> place(-5, 5), size(0, 1);
            const int count = *gen::between(1, 100);
            const float endless = std::numeric_limits<float>::infinity();
            const std::vector<float> odd = {std::numeric_limits<float>::quiet_NaN(), endless, -endless};
            const bool has_odd = random() % 2;
            RC_CLASSIFY(has_odd, "degenerate");
            Candidates scratch;
            scratch.reserve(count, 16);
            const CandidateArrays out = scratch.arrays();
            for (int k = 0; k < count; ++k)
              for (int i = 0; i < 3; ++i) {
                out.box[i][k] = place(random), out.box[3 + i][k] = out.box[i][k] + size(random);
                if (has_odd && random() % 8 == 0) out.box[random() % 2 ? i : 3 + i][k] = odd[random() % 3];
              }
            for (const Target target : available_targets()) check_meeting(target, count, out);
          });
}

}  // namespace proptests::suite_cluster_pairs
