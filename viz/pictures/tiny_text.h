/// Words and numbers in a picture: a font of 5 x 7 dots.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viz/pictures/color.h"
#include "viz/pictures/image.h"

namespace amble {

/// Digits, letters, all of them small, and .:,;-_/(); others leave a gap.
/// @param dot  pixels a dot [>= 1]
void drawText(Image& image, int x, int y, std::string_view text, int dot, const Color& color);
/// Width of a text in pixels.
int textWidth(std::string_view text, int dot);

/// A text as lines of at most so many letters, broken where it has blanks; a longer word is a line.
std::vector<std::string> brokenLines(std::string_view text, size_t letters);

/// Cut off at the picture's edges.
void fillRect(Image& image, int x, int y, int width, int height, const Color& color);

}  // namespace amble
