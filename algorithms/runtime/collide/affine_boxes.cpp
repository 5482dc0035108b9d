// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/affine_boxes.hpp"

#include <limits>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/a1_affine_image.hpp"

namespace refitlab {

AffineSizes sizes_of(const AffineMap<double>& map, int joints) {
  const DefaultFloatEnvironment environment;
  double matrix = 0;
  for (const Point3& column : map.columns) matrix += upper_norm(column);
  return {joints, matrix, upper_norm(map.offset)};
}

Box<double> box_of_image(const AffineMap<double>& map, const Ball3<double>& ball, const Box<double>& box,
                         const AffineSizes& sizes) {
  const DefaultFloatEnvironment environment;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Point3 half = box.edges() / 2;
  const HalfBox<double> of_box = image_of_box<double>(map, {box.center(), half});
  const Point3 center = apply(map, ball.center);
  Box<double> out;
  const double length = max_of(upper_norm(ball.center), Point3(box.center().cwiseAbs() + half).sum());
  const double lost = lost_of_affine_box(sizes.joints) * (sizes.matrix * length + sizes.offset) + least_affine_box;
  if (!(lost < infinite && ball.radius < infinite)) return Box<double>::everything();
  for (int i = 0; i < 3; ++i) {
    const double of_ball = reach_along<double>(map, Point3::Unit(i)) * ball.radius;
    out.low[i] = max_of(center[i] - of_ball, of_box.center[i] - of_box.half[i]) - lost;
    out.high[i] = min_of(center[i] + of_ball, of_box.center[i] + of_box.half[i]) + lost;
  }
  return out;
}

AffineMap<double> turned(const Quaternion<double>& rotation, const AffineMap<double>& map) {
  const DefaultFloatEnvironment environment;
  AffineMap<double> turn = identity_map<double>();
  for (auto& column : turn.columns) column = rotate<double>(rotation, Point3(column));
  return compose(turn, map);
}

void bound_affine_boxes(std::span<const SimplexPiece> pieces, const SkinningPalette<double>& palette,
                        const Quaternion<double>& rotation, std::span<Box<double>> boxes) {
  const DefaultFloatEnvironment environment;
  for (Box<double>& box : boxes) box = Box<double>::empty();
  // This bounds the length of the placement's rotation, which is 1 but for its rounding and what check_placement accepts.
  constexpr double turn = 1.00001;
  std::vector<double> w;
  std::vector<AffineSizes> of_joints;
  for (const SimplexPiece& piece : pieces) {
    const auto maps = palette[static_cast<std::size_t>(piece.joint_set)].maps;
    const int joints = static_cast<int>(maps.size());
    of_joints.clear();
    for (const AffineMap<double>& map : maps) of_joints.push_back(sizes_of(map, joints));
    for (std::size_t k = 0; k < maps.size(); ++k) {
      w = piece.low;
      w[k] += piece.rest;
      AffineSizes sizes{joints, 0, 0};
      for (std::size_t j = 0; j < maps.size(); ++j)
        sizes.matrix += turn * w[j] * of_joints[j].matrix, sizes.offset += turn * w[j] * of_joints[j].offset;
      const AffineMap<double> blend = turned(rotation, blended_map<double>(maps, w));
      boxes[static_cast<std::size_t>(piece.target)].merge(box_of_image(blend, piece.reference, piece.box, sizes));
    }
  }
}

}  // namespace refitlab
