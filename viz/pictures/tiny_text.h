/// Numbers and units in a picture: a font of 5 x 7 dots.
#pragma once

#include <string_view>

#include "viz/pictures/color.h"
#include "viz/pictures/image.h"

namespace amble {

/// Digits, '.', ':', '-', ' ' and the letters of "frame s m"; others leave a gap.
/// @param dot  pixels a dot [>= 1]
void drawText(Image& image, int x, int y, std::string_view text, int dot, const Color& color);
/// Width of a text in pixels.
int textWidth(std::string_view text, int dot);

/// Cut off at the picture's edges.
void fillRect(Image& image, int x, int y, int width, int height, const Color& color);

}  // namespace amble
