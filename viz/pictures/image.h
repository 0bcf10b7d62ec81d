/// A picture in memory, and as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <vector>

namespace amble {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;  ///< row by row from the top, three bytes a pixel, sRGB

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgb(static_cast<size_t>(w) * h * 3) {}
  uint8_t* pixel(int x, int y) { return rgb.data() + (static_cast<size_t>(y) * width + x) * 3; }
  const uint8_t* pixel(int x, int y) const {
    return rgb.data() + (static_cast<size_t>(y) * width + x) * 3;
  }
};

/// 8-bit RGB, no time stamp, fixed compression: the same picture gives the same bytes.
void writePng(std::ostream& out, const Image& image);
/// Written beside and renamed. @throws InputError if it cannot be written.
void writePng(const std::filesystem::path& file, const Image& image);

}  // namespace amble
