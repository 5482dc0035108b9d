// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/candidate_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace refitlab {

CandidatePairs::CandidatePairs(const SkinnedMesh& mesh, VertexInWorld vertex)
    : mesh_(mesh),
      vertex_(std::move(vertex)),
      sides_{{FrameStamps(mesh.triangles.size()), std::vector<Lanes<float>>(mesh.triangles.size()), {}, {}},
             {FrameStamps(mesh.triangles.size()), std::vector<Lanes<float>>(mesh.triangles.size()), {}, {}}},
      meet_(many + Lanes<float>::count),
      unknown_(many + Lanes<float>::count) {
  for (Side& s : sides_) s.candidates.reserve(many, 0), s.lists = s.candidates.arrays();
  for (int k = 0; k < many; ++k) lanes_.push_back(pair_of(k, k));
}

void CandidatePairs::begin(const Point3& origin) {
  origin_ = origin, largest_ = 0;
  for (Side& s : sides_) s.is_made.begin();
}

void CandidatePairs::ask(Query query) {
  query_ = query;
  open_.clear(), doubles_.clear(), found_.clear();
}

void CandidatePairs::add(int first, int second) {
  if (is_done()) return;
  ++count_;
  put(0, first), put(1, second);
  open_.push_back({first, second});
  if (static_cast<int>(open_.size()) < (query_ == Query::yes_no ? few : many)) return;
  filter();
  if (query_ == Query::yes_no) doubles_.decide(found_);
}

std::vector<TrianglePair> CandidatePairs::found() {
  filter();
  doubles_.decide(found_);
  if (query_ == Query::yes_no && found_.size() > 1) found_.resize(1);
  return std::move(found_);
}

// Puts a triangle into the lane of the next pair.
void CandidatePairs::put(int side, int triangle) {
  make(side, triangle);
  const Side& s = sides_[side];
  for (int i = 0; i < 9; ++i) s.lists.vertices[i][open_.size()] = s.vertices[triangle].lane[i];
}

void CandidatePairs::make(int side, int triangle) {
  Side& s = sides_[side];
  if (s.is_made.is_made(triangle)) return;
  for (int c = 0; c < 3; ++c) {
    const PaddedVertex& v = vertex_(side, mesh_.triangles[triangle][c]);
    for (int i = 0; i < 3; ++i) {
      const double seen = v.of[i] - origin_[i];
      largest_ = std::max(largest_, std::abs(seen));
      s.vertices[triangle].lane[3 * c + i] = static_cast<float>(seen);
    }
  }
  s.is_made.mark(triangle);
}

// Rounding to float loses half of 2^-23 of a coordinate, and taking it from the origin in double less by far.
void CandidatePairs::filter() {
  const float slack = static_cast<float>(0x1p-23 * largest_ + least_float_slack);
  int meet_count = 0, unknown_count = 0;
  kernels_.filter(sides_[0].lists, many, sides_[1].lists, many, lanes_.data(), static_cast<int>(open_.size()), slack,
                  meet_.data(), meet_count, unknown_.data(), unknown_count);
  for (int m = 0; m < meet_count; ++m) found_.push_back(open_[first_of(meet_[m])]);
  const auto points = [&](int side, int triangle) {
    const Triangle& t = mesh_.triangles[triangle];
    return std::array{vertex_(side, t[0]), vertex_(side, t[1]), vertex_(side, t[2])};
  };
  for (int m = 0; m < unknown_count; ++m) {
    const TrianglePair& pair = open_[first_of(unknown_[m])];
    doubles_.add(points(0, pair.first), points(1, pair.second), pair);
    if (doubles_.is_full()) doubles_.decide(found_);
  }
  open_.clear();
}

}  // namespace refitlab
