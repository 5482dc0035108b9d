// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing makes an image of a scene as a camera sees it, before a white background.
#pragma once

#include "experiments/render/camera.hpp"
#include "experiments/render/image.hpp"
#include "experiments/render/scene.hpp"

namespace refitlab::render {

struct Options {
  int width, height;      // pixels
  double outline = 1.5;   // of translucent balls, pixels
  bool occlusion = true;  // ambient occlusion and the shadow of the key light
};

// Casts rays by Embree 3. There is a soft key light from the upper left of the camera, a fill light from its right, and ambient
// light dimmed by occlusion. Translucent surfaces are composited in order of depth. The image is deterministic, because all
// sampling patterns are fixed. Throws std::invalid_argument for a scene that Scene::validate refuses and for a size that Image
// refuses, and std::runtime_error if Embree fails.
Image draw(const Scene& scene, const Camera& camera, const Options& options);

}  // namespace refitlab::render
