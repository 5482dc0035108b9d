// The report's pictures of characters and their bounding spheres (the paper's Figures 1 and 5).
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"

namespace refitlab {

struct Picture {
  std::string caption;
  std::string data_uri;  // the PNG, embedded
};

// The reference posture, the posture under linear blending and under spherical blending, each bare and with the balls of
// levels 4 and 6. The PNG files also go to folder.
std::vector<Picture> twist_pictures(const Character& character, const std::string& posture_name, const Posture& posture,
                                    const std::string& folder);

}  // namespace refitlab
