// SPDX-License-Identifier: GPL-3.0-or-later
// An Image has the pixels of a picture, and becomes a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace refitlab::render {

// A Color is red, green and blue in [0, 1], sRGB-encoded, as a style sheet has them.
struct Color {
  double red, green, blue;
};

// These are of Okabe and Ito's eight colours, which are told apart under every common colour blindness
// (jfly.uni-koeln.de/color, 2008), and the neutrals that go with them.
namespace palette {
inline constexpr Color black{0, 0, 0}, orange{0.902, 0.624, 0}, green{0, 0.620, 0.451}, yellow{0.941, 0.894, 0.259},
    blue{0, 0.447, 0.698}, vermillion{0.835, 0.369, 0}, purple{0.800, 0.475, 0.655}, clay{0.82, 0.80, 0.77},
    gray{0.45, 0.45, 0.45};
}  // namespace palette

// Pixels are red, green and blue of 8 bits each, in sRGB. Rows go from the top.
class Image {
 public:
  Image(int width, int height);  // black; throws std::invalid_argument for a size outside [1, 16384]
  int width() const { return width_; }
  int height() const { return height_; }
  std::uint8_t* pixel(int x, int y) { return &bytes_[3 * (std::size_t(y) * width_ + x)]; }

  // Writes the image whole or not at all, like every result file (write_whole). The same image gives the same bytes. Throws
  // std::runtime_error that names the path and the reason.
  void write_png(const std::string& path) const;

 private:
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace refitlab::render
