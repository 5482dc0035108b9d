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
  bytes_.resize(3 * std::size_t(width) * height);
}

void Image::write_png(const std::string& path) const {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = width_;
  png.height = height_;
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, bytes_.data(), 0, nullptr))
    throw std::runtime_error(path + ": cannot encode as PNG: " + png.message);
  file.resize(size);
  write_whole(path, file);
}

}  // namespace refitlab::render
