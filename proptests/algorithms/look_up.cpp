// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the look-up of numbers through kernels that do it, so that every target's own way is tried. Vertices of candidates are looked
// up by the places that triangles have, which are looked up themselves. Pieces of one joint that only moves are boxed where the
// table says the joint is, which packs of sixteen look up, too.
#include "algorithms/runtime/packs/look_up.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"
#include "algorithms/runtime/collide/motion_bound_piece_kernel.hpp"
#include "algorithms/runtime/packs/lanes.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_look_up {
namespace {

using namespace refitlab;

// Counts the lanes that are boxed elsewhere than at 1 + the number of their joint.
int misplaced(const std::int32_t (&joint)[motion_bound_lanes], int count, Target target) {
  const int room = look_up_size(count);
  std::vector<Lanes<float>> numbers(8 * room / Lanes<float>::count);
  float* table = numbers.data()->lane.data();
  std::fill_n(table, 8 * room, -99.f);  // nothing behind the joints is to be looked up
  std::vector<double> pose;
  for (int j = 0; j < count; ++j) pose.insert(pose.end(), {1, 0, 0, 0, 1. + j, 1. + j, 1. + j, 0});
  const double rotation[] = {1, 0, 0, 0};
  MotionBoundBox none;
  motion_bound_kernels(target).bound(pose.data(), count, rotation, nullptr, 0, false, table, room, none, nullptr);
  MotionBoundPiecePack piece{};
  MotionBoundPack& pack = piece.ball;
  FlippedBox boxes[motion_bound_lanes];
  for (int lane = 0; lane < motion_bound_lanes; ++lane) {
    for (auto& slot : pack.joint) slot[lane] = joint[lane];
    pack.joint_count[lane] = 1;
    pack.target[lane] = lane;
    boxes[lane].set_all(std::numeric_limits<float>::infinity());
  }
  for (auto& slots : pack.slot_count) slots = 1;
  if (!bound_motion_pieces(target)(table, count, room, &piece, 1, false, 0, boxes)) return motion_bound_lanes;
  int wrong = 0;
  for (int lane = 0; lane < motion_bound_lanes; ++lane)
    for (int i = 0; i < 3; ++i)
      wrong += boxes[lane].box().low[i] != 1 + joint[lane] || boxes[lane].box().high[i] != 1 + joint[lane];
  return wrong;
}

// Counts the coordinates of candidates that are not those of their triangle's vertices. As many triangles as places.
int misplaced_vertices(int count, std::mt19937& random, Target target) {
  const int places = blocks_for<float>(count) * Lanes<float>::count;
  std::vector<Lanes<float>> xyz(3 * places / Lanes<float>::count + 1);
  float* const numbers = xyz.data()->lane.data();
  for (int i = 0; i < 3 * places; ++i) numbers[i] = static_cast<float>(i);
  std::vector<std::uint16_t> vertices[3];
  for (auto& list : vertices) {
    list.resize(static_cast<std::size_t>(short_look_up_size(count)), 0xffff);  // which is no place
    for (int t = 0; t < count; ++t) list[static_cast<std::size_t>(t)] = static_cast<std::uint16_t>(random() % count);
    list[random() % count] = static_cast<std::uint16_t>(count - 1);
  }
  const ClusterTriangles triangles{count, {vertices[0].data(), vertices[1].data(), vertices[2].data()}};
  Candidates candidates;
  candidates.reserve(count, places);
  const int found = 1 + static_cast<int>(random() % count);
  for (auto& triangle : candidates.triangle) triangle = static_cast<std::int32_t>(random() % count);
  candidates.triangle[0] = count - 1;
  const float offset[] = {0, 0.5f, 0.25f};
  Box<float> all;
  const CandidateArrays out = candidates.arrays();
  cluster_pair_kernels(target).place(triangles, numbers, places, offset, found, out, all);
  int wrong = 0;
  for (int k = 0; k < found; ++k)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < 3; ++i)
        wrong += out.vertices[3 * c + i][k] != static_cast<float>(i * places + triangles.vertex[c][out.triangle[k]]) + offset[i];
  return wrong;
}

}  // namespace

PROPTEST(look_up) {
  t.example("every candidate has the vertices of its triangle, of any number of places, on every target", {}, [] {
    std::mt19937 random(1);
    long wrong = 0, tried = 0;
    for (const Target target : available_targets())
      for (int count = 1; count <= most_in_registers + 64; ++count) wrong += misplaced_vertices(count, random, target), ++tried;
    return Checked(wrong == 0, tried);
  });
  t.example("every lane has the number at its own place, in tables of any size, on every target", {}, [] {
    std::mt19937 random(1);
    long wrong = 0, tried = 0;
    for (const Target target : available_targets())
      for (int count = 1; count <= 200; ++count)
        for (int times = 0; times < 8; ++times) {
          alignas(64) std::int32_t joint[motion_bound_lanes];
          // The first and last places are there too.
          for (int lane = 0; lane < motion_bound_lanes; ++lane)
            joint[lane] = times == 0 ? (lane % 2 ? count - 1 : 0) : static_cast<int>(random() % count);
          wrong += misplaced(joint, count, target), ++tried;
        }
    return Checked(wrong == 0, tried);
  });
  t.example("a table has room for its numbers in pairs of the widest registers", {}, [] {
    bool ok = true;
    for (int count = 1; count <= 200; ++count)
      ok = ok && look_up_size(count) >= count && look_up_size(count) % 32 == 0 && look_up_size(count) < count + 32;
    return Checked(ok, 200);
  });
}

}  // namespace proptests::suite_look_up
