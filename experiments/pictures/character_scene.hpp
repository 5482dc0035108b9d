// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of a character show its skin, balls of its tree, and marks at vertices.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {

// The colours of skins, balls and marks mean the same in every picture.
namespace figure_colors {
inline constexpr render::Color holding = render::palette::blue, missing = render::palette::vermillion,
                               without = render::palette::purple, idle{0.85, 0.85, 0.85}, touching{0.835, 0.369, 0};
}

// Returns the wanted levels that the tree has, or its last one if it has none of them.
std::vector<int> levels_there(const SphereTree& tree, const std::vector<int>& wanted);

render::MeshShape skin_shape(const SkinnedMesh& model, std::vector<Point3> vertices);

// Adds a dot for each marked vertex, as large as it takes to be seen in a picture of this size (in model units).
void mark_vertices(render::Scene& scene, const std::vector<Point3>& vertices, const std::vector<bool>& marked,
                   render::Color color, double picture_size);

// Returns how many balls there are, how many miss a vertex, and how many of these are no ball at all.
std::vector<PictureNumber> counts_of(std::size_t balls, const Misses& misses);

}  // namespace refitlab
