// SPDX-License-Identifier: GPL-3.0-or-later
// The rounded boxes that make the box of the character the smallest in poses that are expected, by a linear program.
//
// What a rounded box reaches along an axis is linear in its center, half extents and radius, and a wall of the character's box in
// a pose is at least what any joint reaches. The inequality of a vertex (a4_joint_volumes) is convex: its distance from a box is
// the greatest of linear functions, one for each direction. So the least sum of all edges of the character's boxes is that of a
// linear program, whose rows are added where its last solution violates them. An edge counts by how fast its box's volume grows
// with it, as a share of the volume at the beginning. Boxes that reach no wall count a little, or they could be of any size.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "experiments/engines/linear_program.hpp"
#include "experiments/engines/rounded_boxes.hpp"

namespace refitlab {

class BoxProgram {
 public:
  // Begins with boxes that are sound. Poses are at least one. The mesh outlives this.
  BoxProgram(const SkinnedMesh& mesh, std::span<const Pose> expected, const std::vector<RoundedBox>& boxes);

  // Goes on until no vertex is beyond the boxes by more than a share of the mesh's size, and no box beyond its walls, or a number
  // of rounds is over. The radii are then to be raised where they lack (weighted_radii).
  void run();
  // Makes the boxes of some blocks of joints balls from now on: of those whose balls, around the last solution's boxes, would
  // make the character's boxes hardly larger.
  void make_balls();
  // Returns the boxes by joint.
  std::vector<RoundedBox> boxes() const;

 private:
  // A joint that moves vertices, in one pose: the rows of its matrix, and where the middle of the mesh goes, in units of its
  // size.
  struct PlacedJoint {
    std::array<Point3, 3> rows;
    Point3 offset;
  };
  struct Wall {
    std::size_t pose;
    int axis;
    double side;   // -1 or 1
    double value;  // of the last solution: its coordinate times the side
  };

  // Returns an edge of the character's box in the last solution, which is no less than a small length.
  double edge(std::size_t pose, int axis) const;
  // Returns how far a joint's box reaches, as the wall's value is given.
  double reach(const Wall& wall, std::size_t joint, const RoundedBox& box) const;
  double growth_by_balls(std::size_t first, std::size_t last) const;
  double add_wall_rows(double least);
  double add_vertex_rows();
  void set_costs();
  void take_solution();

  const SkinnedMesh& mesh_;
  Point3 middle_;
  double size_;
  std::vector<RoundedBox> boxes_;                // about the middle, in units of the size
  std::vector<std::vector<PlacedJoint>> poses_;  // by joint
  std::vector<Wall> walls_;                      // of each pose six: by axis, the side of -1 first
  std::vector<double> volumes_;                  // by pose, at the beginning
  std::vector<int> first_;                       // by joint: the first of its variables, -1 of one that moves no vertex
  LinearProgram program_;
  int first_wall_;  // variable
  bool is_solved_ = false;
};

}  // namespace refitlab
