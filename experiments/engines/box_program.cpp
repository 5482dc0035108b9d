// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/box_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "experiments/engines/bind_box.hpp"
#include "lemmas/a1_affine_image.hpp"

namespace refitlab {
namespace {

// Positions of a joint's variables: of the center and the half extents three each.
constexpr int of_center = 0, of_half = 3, of_radius = 6;
constexpr double farthest = 4, farthest_wall = 1e4;  // in units of the mesh's size
constexpr double share_of_hidden = 0.001;            // of what a box at a wall counts
constexpr double tolerance = 2e-4;
constexpr int most_rounds = 40;
constexpr std::size_t rows_a_wall = 2;         // in one round
constexpr double most_growth_by_balls = 0.06;  // much more than after the next solution
constexpr double least_edge = 1e-3;            // a flat character's volume does not grow with its edges

// A unit vector for which the distance of a point from a box's core is greatest; 0 inside of it.
Point3 direction_from(const RoundedBox& box, const Point3& point) {
  const Point3 arm = point - box.center, beyond = (arm.cwiseAbs() - box.half).cwiseMax(0);
  const double distance = beyond.norm();
  Point3 out = Point3::Zero();
  if (distance > 0)
    for (int i = 0; i < 3; ++i) out[i] = std::copysign(beyond[i], arm[i]) / distance;
  return out;
}

// Returns a number for a direction's greatest coordinate and all signs, so that rows of one round are of different sides of a
// box.
int side_of(const Point3& d) {
  int greatest = 0;
  d.cwiseAbs().maxCoeff(&greatest);
  return greatest + 3 * ((d[0] > 0) + 2 * (d[1] > 0) + 4 * (d[2] > 0));
}

}  // namespace

BoxProgram::BoxProgram(const SkinnedMesh& mesh, std::span<const Pose> expected, const std::vector<RoundedBox>& boxes)
    : mesh_(mesh),
      middle_(bind_box(mesh).center()),
      size_(bind_box(mesh).edges().maxCoeff()),
      boxes_(boxes),
      first_(boxes.size(), -1) {
  if (!(size_ > 0)) size_ = 1;
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    if (boxes[j].radius < 0) continue;
    for (int i = 0; i < 3; ++i) {
      const int variable = program_.add_variable(-farthest, farthest);
      if (i == 0) first_[j] = variable;
    }
    for (int i = 0; i < 4; ++i) program_.add_variable(0, farthest);
    boxes_[j] = {(boxes[j].center - middle_) / size_, boxes[j].half / size_, boxes[j].radius / size_};
  }
  for (std::size_t p = 0; p < expected.size(); ++p) {
    auto& placed = poses_.emplace_back(boxes.size());
    const Point3 about = apply(expected[p][0], middle_);
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      placed[j].offset = (apply(expected[p][j], middle_) - about) / size_;
      placed[j].rows = rotation_rows(expected[p][j].rotation);
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1., 1.}) {
        const int variable = program_.add_variable(-farthest_wall, farthest_wall);
        if (walls_.empty()) first_wall_ = variable;
        Wall wall{p, axis, side, -infinite};
        for (std::size_t j = 0; j < boxes.size(); ++j)
          if (first_[j] >= 0) wall.value = std::max(wall.value, reach(wall, j, boxes_[j]));
        walls_.push_back(wall);
      }
  }
  for (std::size_t p = 0; p < poses_.size(); ++p) volumes_.push_back(edge(p, 0) * edge(p, 1) * edge(p, 2));
}

void BoxProgram::run() {
  for (int round = 0; round < most_rounds; ++round) {
    set_costs();
    const double beyond = add_wall_rows(is_solved_ ? tolerance / 2 : -infinite), lack = add_vertex_rows();
    if (round > 0 && beyond < tolerance && lack < tolerance) return;
    if (!program_.solve()) return;
    take_solution();
  }
}

void BoxProgram::make_balls() {
  constexpr std::size_t of_block = Lanes<float>::count;
  for (std::size_t first = 0; first < boxes_.size(); first += of_block) {
    const std::size_t last = std::min(first + of_block, boxes_.size());
    if (growth_by_balls(first, last) > most_growth_by_balls) continue;
    for (std::size_t j = first; j < last; ++j) {
      if (first_[j] < 0) continue;
      for (int k = 0; k < 3; ++k) program_.set_most(first_[j] + of_half + k, 0);
    }
  }
}

std::vector<RoundedBox> BoxProgram::boxes() const {
  std::vector<RoundedBox> out = boxes_;
  for (RoundedBox& b : out)
    if (b.radius >= 0) b = {b.center * size_ + middle_, b.half * size_, b.radius * size_};
  return out;
}

double BoxProgram::edge(std::size_t pose, int axis) const {
  const std::size_t wall = 6 * pose + 2 * static_cast<std::size_t>(axis);
  return std::max(least_edge, walls_[wall].value + walls_[wall + 1].value);
}

double BoxProgram::reach(const Wall& wall, std::size_t joint, const RoundedBox& box) const {
  const PlacedJoint& placed = poses_[wall.pose][joint];
  return wall.side * (dot<double, 3>(placed.rows[wall.axis], box.center) + placed.offset[wall.axis]) +
         image_half_extent<double>(placed.rows[wall.axis], box.half) + box.radius;
}

// The mean growth of the character's boxes, as a share of the volume, if all of these joints had balls around their boxes.
double BoxProgram::growth_by_balls(std::size_t first, std::size_t last) const {
  double sum = 0;
  for (const Wall& wall : walls_) {
    double most = 0;
    for (std::size_t j = first; j < last; ++j)
      if (first_[j] >= 0) most = std::max(most, reach(wall, j, ball_around(boxes_[j])) - wall.value);
    sum += most / edge(wall.pose, wall.axis);
  }
  return sum / static_cast<double>(poses_.size());
}

// A row for the farthest boxes that are beyond a wall by more than this. Returns how far the farthest is beyond its wall.
double BoxProgram::add_wall_rows(double least) {
  double most = 0;
  std::vector<std::pair<double, std::size_t>> beyond;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    beyond.clear();
    for (std::size_t j = 0; j < boxes_.size(); ++j)
      if (first_[j] >= 0) beyond.emplace_back(reach(wall, j, boxes_[j]) - wall.value, j);
    std::sort(beyond.begin(), beyond.end(), std::greater<>());
    most = std::max(most, beyond[0].first);
    for (std::size_t i = 0; i < std::min(rows_a_wall, beyond.size()) && beyond[i].first > least; ++i) {
      const std::size_t j = beyond[i].second;
      const PlacedJoint& placed = poses_[wall.pose][j];
      std::vector<ProgramTerm> terms = {{first_wall_ + static_cast<int>(w), 1}, {first_[j] + of_radius, -1}};
      for (int k = 0; k < 3; ++k) {
        terms.push_back({first_[j] + of_center + k, -wall.side * placed.rows[wall.axis][k]});
        terms.push_back({first_[j] + of_half + k, -std::abs(placed.rows[wall.axis][k])});
      }
      program_.add_row(terms, wall.side * placed.offset[wall.axis]);
    }
  }
  return most;
}

// Adds a row for the worst of the vertices that lack, for each joint and side of its box. Returns the greatest lack.
double BoxProgram::add_vertex_rows() {
  struct Worst {
    double lack = 0;
    std::size_t vertex = 0;
  };
  double most = 0;
  std::map<std::pair<int, int>, Worst> worst;
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    const Point3 point = (mesh_.vertices[v] - middle_) / size_;
    double lack = 0, greatest = -1;
    std::pair<int, int> key;
    for (const Influence& i : mesh_.influences[v]) {
      const RoundedBox& box = boxes_[i.joint];
      const double distance = distance_from_box(box, point);
      lack += i.weight * (distance - box.radius);
      if (const double share = i.weight * distance; share > greatest)
        greatest = share, key = {i.joint, side_of(direction_from(box, point))};
    }
    most = std::max(most, lack);
    if (Worst& w = worst[key]; lack > w.lack) w = {lack, v};
  }
  for (const auto& [key, found] : worst) {
    if (found.lack < tolerance / 2) continue;
    const Point3 point = (mesh_.vertices[found.vertex] - middle_) / size_;
    std::vector<ProgramTerm> terms;
    double least = 0;
    for (const Influence& i : mesh_.influences[found.vertex]) {
      const Point3 direction = direction_from(boxes_[i.joint], point);
      terms.push_back({first_[i.joint] + of_radius, i.weight});
      for (int k = 0; k < 3; ++k) {
        terms.push_back({first_[i.joint] + of_center + k, i.weight * direction[k]});
        terms.push_back({first_[i.joint] + of_half + k, i.weight * std::abs(direction[k])});
      }
      least += i.weight * dot<double, 3>(direction, point);
    }
    program_.add_row(terms, least);
  }
  return most;
}

void BoxProgram::set_costs() {
  std::vector<std::array<double, 7>> hidden(boxes_.size());
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    double growth = 1 / volumes_[wall.pose];
    for (int axis = 0; axis < 3; ++axis)
      if (axis != wall.axis) growth *= edge(wall.pose, axis);
    program_.set_cost(first_wall_ + static_cast<int>(w), growth);
    for (std::size_t j = 0; j < boxes_.size(); ++j) {
      for (int k = 0; k < 3; ++k) hidden[j][of_half + k] += growth * std::abs(poses_[wall.pose][j].rows[wall.axis][k]);
      hidden[j][of_radius] += growth;
    }
  }
  for (std::size_t j = 0; j < boxes_.size(); ++j)
    for (int i = of_half; first_[j] >= 0 && i <= of_radius; ++i) program_.set_cost(first_[j] + i, share_of_hidden * hidden[j][i]);
}

void BoxProgram::take_solution() {
  is_solved_ = true;
  for (std::size_t j = 0; j < boxes_.size(); ++j) {
    if (first_[j] < 0) continue;
    for (int i = 0; i < 3; ++i) {
      boxes_[j].center[i] = program_.value(first_[j] + of_center + i);
      boxes_[j].half[i] = program_.value(first_[j] + of_half + i);
    }
    boxes_[j].radius = program_.value(first_[j] + of_radius);
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) walls_[w].value = program_.value(first_wall_ + static_cast<int>(w));
}

}  // namespace refitlab
