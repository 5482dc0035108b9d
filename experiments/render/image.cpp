// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/image.hpp"

#include <png.h>

#include <stdexcept>

#include "algorithms/results/result_file.hpp"

namespace refitlab::render {

Image::Image(int width, int height) : width_(width), height_(height) {
  constexpr int largest = 16384;
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw std::invalid_argument("picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels: each side must be in [1, " + std::to_string(largest) + "]");
  bytes_.resize(4 * std::size_t(width) * height);
}

bool Image::opaque() const {
  for (std::size_t i = 3; i < bytes_.size(); i += 4)
    if (bytes_[i] != 255) return false;
  return true;
}

void Image::write_png(const std::string& path) const {
  std::vector<std::uint8_t> samples;
  const int channels = opaque() ? 3 : 4;
  samples.reserve(bytes_.size());
  for (std::size_t i = 0; i < bytes_.size(); i += 4)
    samples.insert(samples.end(), bytes_.begin() + i, bytes_.begin() + i + channels);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = width_;
  png.height = height_;
  png.format = channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, samples.data(), 0, nullptr))
    throw std::runtime_error(path + ": cannot encode as PNG: " + png.message);
  file.resize(size);
  write_whole(path, file);
}

}  // namespace refitlab::render
