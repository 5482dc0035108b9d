// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/baselines.hpp"

namespace refitlab {

std::vector<DetectorKind> baseline_kinds() {
  const auto baseline = Origin::baseline;
  return {
      {"brown", "sphere tree, refitted bottom-up [Brown et al. 2001]", baseline, make_brown},
      {"aabb_tree", "tree of axis-aligned boxes, one triangle a leaf, refitted bottom-up [van den Bergen 1997]", baseline,
       make_aabb_tree},
      {"skin_all_float",
       "skins everything in float, clusters of 256 triangles with their boxes; clusters whose boxes meet are compared in float, "
       "and only what that leaves unknown is decided on vertices in double",
       baseline, skin_all_float_maker(256)},
      {"skin_all_float_384", "the same with clusters of 384 triangles", baseline, skin_all_float_maker(384)},
      {"skin_all_float_512",
       "the same with clusters of 512 triangles, which are fewer to skin and to compare, but more loosely boxed", baseline,
       skin_all_float_maker(512)},
      {"cgal_aabb", "CGAL's AABB_tree of the first body, rebuilt, asked with the second one's triangles' boxes", baseline,
       make_cgal_aabb},
      {"spatial_hash",
       "hash of a uniform grid's cells with the first body's triangles, asked with the second one's [Teschner et al. 2003]",
       baseline, make_spatial_hash}};
}

std::vector<DetectorKind> engine_kinds() {
  const auto engine = Origin::engine;
  std::vector<DetectorKind> kinds;
  kinds.push_back({"embree", "Embree's rtcCollide on user geometry, refitted", engine, make_embree});
#ifdef REFITLAB_FCL
  kinds.push_back({"fcl_aabb", "FCL's BVHModel of axis-aligned boxes, refitted bottom-up", engine, make_fcl_aabb});
  kinds.push_back({"fcl_kdop16", "FCL's BVHModel of k-DOPs of 16 planes, refitted bottom-up", engine, make_fcl_kdop16});
  kinds.push_back({"fcl_obbrss",
                   "FCL's BVHModel of oriented boxes and swept spheres, refitted bottom-up; misses a pair now and then", engine,
                   make_fcl_obbrss, false, 0.01});
#endif
#ifdef REFITLAB_BULLET
  kinds.push_back({"bullet_dbvt", "Bullet's btDbvt, refitted bottom-up as its soft bodies do", engine, make_bullet_dbvt});
  kinds.push_back({"bullet_gimpact", "Bullet's quantised box sets of GImpact, updated", engine, make_bullet_gimpact});
#endif
  return kinds;
}

std::vector<std::string> absent_engines() {
  std::vector<std::string> absent;
#ifndef REFITLAB_FCL
  absent.push_back("FCL (libfcl-dev)");
#endif
#ifndef REFITLAB_BULLET
  absent.push_back("Bullet (libbullet-dev)");
#endif
  return absent;
}

}  // namespace refitlab
