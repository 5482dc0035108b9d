// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: a scene, seen by a camera, as an image.
#pragma once

#include "experiments/render/camera.hpp"
#include "experiments/render/image.hpp"
#include "experiments/render/scene.hpp"

namespace refitlab::render {

struct Options {
  int width = 900, height = 900;  // pixels
  bool transparent = false;       // else the background is white
  int supersampling = 2;          // rays per pixel in each direction, in [1, 8]
  double outline = 1.5;           // of translucent balls, pixels; 0 for none
  bool occlusion = true;          // ambient occlusion and the shadow of the key light
};

// Ray casting by Embree 3: a soft key light from the upper left of the camera, a fill light from its right, ambient
// light dimmed by occlusion, translucent surfaces composited in order of depth. Deterministic: all sampling patterns
// are fixed. Throws std::invalid_argument for what Scene::validate or the options refuse, std::runtime_error if Embree
// fails.
Image draw(const Scene& scene, const Camera& camera, const Options& options = {});

}  // namespace refitlab::render
