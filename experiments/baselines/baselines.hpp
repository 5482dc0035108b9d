// SPDX-License-Identifier: GPL-3.0-or-later
// Baselines are what one would pick instead of refits on demand. Each skins everything, refits its volumes bottom-up or rebuilds
// them, and has its candidates decided by triangles_meet.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> baseline_kinds();
// Returns the engines that were found when this was configured.
std::vector<DetectorKind> engine_kinds();
// Returns another kind behind a first test of boxes (bounded_detector.cpp). The kind's name gets "_bounded".
DetectorKind bounded_kind(const DetectorKind& kind);
// Returns the engines that were not found.
std::vector<std::string> absent_engines();

// These baselines skin everything in float. Which of them is faster depends on the scene and on the size of the meshes.
inline constexpr const char* float_baselines[] = {"skin_all_float", "skin_all_float_384", "skin_all_float_512"};

using Maker = std::unique_ptr<Detector>(const Character& character);
Maker make_brown, make_aabb_tree, make_cgal_aabb, make_spatial_hash;
// Returns what makes the one whose clusters have up to so many triangles.
std::function<Maker> skin_all_float_maker(int most_triangles);
Maker make_fcl_aabb, make_fcl_kdop16, make_fcl_obbrss;
Maker make_bullet_dbvt, make_bullet_gimpact;
Maker make_embree;

}  // namespace refitlab
