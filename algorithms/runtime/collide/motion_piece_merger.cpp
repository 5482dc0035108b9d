// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_piece_merger.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::vector<Pose> compared_poses(const SkinnedMesh& mesh) {
  const DefaultFloatEnvironment environment;
  constexpr int count = 6;
  std::vector<Pose> out;
  for (int p = 0; p < count; ++p) {
    const double half_angle = p % 2 == 0 ? 0.1 : 0.3;
    Pose& pose = out.emplace_back();
    for (int j = 0; j < static_cast<int>(mesh.joints.size()); ++j) {
      const int axis = 1 + (j + p) % 3;
      Quaternion<double> turn{std::cos(half_angle), 0, 0, 0};
      turn[axis] = (j / 3 + p) % 2 == 0 ? std::sin(half_angle) : -std::sin(half_angle);
      const Point3& about = mesh.joints[static_cast<std::size_t>(j)].origin;
      pose.push_back({turn, Point3(about - rotate(turn, about))});
    }
  }
  return out;
}

// A Part may become one of a list's pieces.
struct MotionPieceMerger::Part {
  std::vector<int> vertices;
  MotionPiece piece;
  BoxesByPose boxes;
  bool is_merged = false;  // into another one
};

// A Merge of one part into another one, by their positions, would make this of the latter.
struct MotionPieceMerger::Merge {
  std::size_t from, into;
  MotionPiece piece;
  BoxesByPose boxes;
};

MotionPieceMerger::MotionPieceMerger(const Character& character)
    : character_(character),
      poses_(compared_poses(character.mesh)),
      bounds_(poses_.size(), MotionBound(character.mesh, character.sets, Skinning::spherical)) {
  // The target is one that all processors have, so that trees are the same on all.
  for (std::size_t i = 0; i < poses_.size(); ++i) bounds_[i].box(poses_[i], {}, Target::baseline);
}

std::vector<MotionPiece> MotionPieceMerger::pieces(std::span<const std::vector<int>> lists) {
  const DefaultFloatEnvironment environment;
  std::vector<MotionPiece> out;
  for (std::size_t list = 0; list < lists.size(); ++list) {
    std::vector<Part> parts = parts_of(lists[list]);
    merge(parts);
    for (const Part& part : parts) {
      if (part.is_merged) continue;
      out.push_back(part.piece);
      out.back().target = static_cast<int>(list);
    }
  }
  return out;
}

// Returns the boxes of each piece in the compared poses, or nothing if some are not known.
std::vector<MotionPieceMerger::BoxesByPose> MotionPieceMerger::boxes_of(std::vector<MotionPiece> pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].target = static_cast<int>(i);
  const auto packs = make_motion_bound_packs(character_, pieces);
  if (packs.empty()) return {};
  std::vector<FlippedBox> flipped(pieces.size());
  std::vector<BoxesByPose> out(pieces.size());
  for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
    if (!bounds_[pose].boxes(packs, poses_[pose], flipped)) return {};
    for (std::size_t i = 0; i < pieces.size(); ++i) out[i].push_back(flipped[i].box());
  }
  return out;
}

std::vector<MotionPieceMerger::Part> MotionPieceMerger::parts_of(std::span<const int> vertices) const {
  std::vector<Part> out;
  for (const auto& [set, list] : by_joint_set(character_.sets, vertices))
    out.push_back({list, motion_piece(character_, set, list), {}});
  return out;
}

bool MotionPieceMerger::is_within(const Part& a, const Part& b) const {
  const auto few = character_.sets.joints(a.piece.joint_set), many = character_.sets.joints(b.piece.joint_set);
  return &a != &b && !a.is_merged && !b.is_merged && std::includes(many.begin(), many.end(), few.begin(), few.end());
}

void MotionPieceMerger::add_merges(const std::vector<Part>& parts, std::span<const std::pair<std::size_t, std::size_t>> pairs,
                                   std::vector<Merge>& merges) {
  std::vector<MotionPiece> pieces;
  for (const auto& [from, into] : pairs) {
    std::vector<int> both = parts[into].vertices;
    both.insert(both.end(), parts[from].vertices.begin(), parts[from].vertices.end());
    pieces.push_back(motion_piece(character_, parts[into].piece.joint_set, both));
  }
  const auto boxes = boxes_of(pieces);
  for (std::size_t i = 0; i < boxes.size(); ++i) merges.push_back({pairs[i].first, pairs[i].second, pieces[i], boxes[i]});
}

// Returns the extents of the box around all parts, summed up over the poses, as it would be after a merge.
double MotionPieceMerger::size_with(const std::vector<Part>& parts, const Merge* merge) const {
  double sum = 0;
  for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
    Box<double> all = merge ? merge->boxes[pose] : Box<double>::empty();
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!parts[i].is_merged && !(merge && (i == merge->from || i == merge->into))) all.merge(parts[i].boxes[pose]);
    sum += all.extent();
  }
  return sum;
}

// Merges parts as long as their common box does not become too large, each time those that let it grow least.
void MotionPieceMerger::merge(std::vector<Part>& parts) {
  std::vector<MotionPiece> single;
  for (const Part& part : parts) single.push_back(part.piece);
  const auto boxes = boxes_of(std::move(single));
  if (boxes.empty()) return;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].boxes = boxes[i];

  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = 0; b < parts.size(); ++b)
      if (is_within(parts[a], parts[b])) pairs.emplace_back(a, b);
  std::vector<Merge> merges;
  add_merges(parts, pairs, merges);
  for (const double most = size_with(parts, nullptr) * (1 + most_growth); !merges.empty();) {
    std::vector<double> sizes;
    for (const Merge& m : merges) sizes.push_back(size_with(parts, &m));
    const auto least = std::min_element(sizes.begin(), sizes.end());
    if (!(*least <= most)) return;
    const Merge best = merges[static_cast<std::size_t>(least - sizes.begin())];
    Part &from = parts[best.from], &into = parts[best.into];
    into.vertices.insert(into.vertices.end(), from.vertices.begin(), from.vertices.end());
    into.piece = best.piece;
    into.boxes = best.boxes, from.is_merged = true;
    const auto is_old = [&](std::size_t part) { return part == best.from || part == best.into; };
    std::erase_if(merges, [&](const Merge& m) { return is_old(m.from) || is_old(m.into); });
    pairs.clear();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (is_within(parts[i], into)) pairs.emplace_back(i, best.into);
      if (is_within(into, parts[i])) pairs.emplace_back(best.into, i);
    }
    add_merges(parts, pairs, merges);
  }
}

}  // namespace refitlab
