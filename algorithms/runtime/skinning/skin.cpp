// SPDX-License-Identifier: MIT
#include "algorithms/runtime/skinning/skin.hpp"

#include <stdexcept>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {

std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette,
                         Skinning skinning, const Deformation& deformation) {
  const DefaultFloatEnvironment environment;
  if (palette.is_affine() && skinning != Skinning::linear)
    throw std::invalid_argument(mesh.name + ": a palette of affine joints is for linear skinning");
  std::vector<Point3> deformed, out;
  if (!deformation.is_none()) deformed = deformed_vertices(mesh, sets, deformation);
  const std::vector<Point3>& vertices = deformation.is_none() ? mesh.vertices : deformed;
  // One entry is made here for each joint-set, since one for each vertex would cost a quarter of linear skinning.
  std::vector<PaletteEntry<double>> entries;
  entries.reserve(palette.size());
  for (std::size_t s = 0; s < palette.size(); ++s) entries.push_back(palette[s]);
  out.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const int v = static_cast<int>(i);
    out.push_back(blend<double>(skinning, entries[sets.of_vertex(v)], sets.weights(v), vertices[i]));
  }
  return out;
}

std::vector<Point3> deformed_vertices(const SkinnedMesh& mesh, const JointSets& sets, const Deformation& deformation) {
  const DefaultFloatEnvironment environment;
  check_deformation(mesh, deformation);
  const SkinningPalette<double> scales = make_scale_palette(mesh, sets, deformation.scales);
  std::vector<Point3> out;
  out.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const int v = static_cast<int>(i);
    const PaletteEntry<double> set = scales.is_affine() ? scales[sets.of_vertex(v)] : PaletteEntry<double>{};
    out.push_back(deformed<double>(mesh.vertices[i], mesh.displacements(v), deformation.weights, set, sets.weights(v)));
  }
  return out;
}

}  // namespace refitlab
