#include "viz/pictures/tiny_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace amble {
namespace {

constexpr const char* kLetters = "0123456789.:,;-_/()abcdefghijklmnopqrstuvwxyz";
constexpr int kRows = 7;

/// A text in white on black with a margin of 3 pixels.
Image drawn(std::string_view text, int dot) {
  Image image(textWidth(text, dot) + 6, kRows * dot + 6);
  drawText(image, 3, 3, text, dot, rgb(255, 255, 255));
  return image;
}

long ink(const Image& image) { return std::count(image.rgb.begin(), image.rgb.end(), 255) / 3; }

TEST(TinyText, EveryGlyphHasInkAndIsItsOwn) {
  std::set<std::vector<uint8_t>> pictures;
  for (const char letter : std::string_view(kLetters)) {
    const Image image = drawn({&letter, 1}, 1);
    EXPECT_GT(ink(image), 3) << letter;
    EXPECT_TRUE(pictures.insert(image.rgb).second) << letter << " looks like another";
  }
}

TEST(TinyText, CapitalsAreWrittenSmall) {
  EXPECT_EQ(drawn("Left ARM", 2).rgb, drawn("left arm", 2).rgb);
}

TEST(TinyText, WhatItDoesNotKnowLeavesAGap) {
  EXPECT_EQ(ink(drawn("?~\xff ", 2)), 0);
  EXPECT_EQ(ink(drawn("1?1", 1)), 2 * ink(drawn("1", 1)));
}

TEST(TinyText, InkGrowsWithTheSquareOfTheDot) {
  for (const int dot : {2, 3, 5})
    EXPECT_EQ(ink(drawn(kLetters, dot)), dot * dot * ink(drawn(kLetters, 1)));
}

TEST(TinyText, StaysWithinItsWidthAndHeight) {
  const Image image = drawn(kLetters, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const bool within = x >= 3 && x < image.width - 3 && y >= 3 && y < image.height - 3;
      EXPECT_TRUE(within || image.pixel(x, y)[0] == 0) << x << ", " << y;
    }
}

TEST(TinyText, LinesAreBrokenAtBlanksAndLoseNothing) {
  const std::string text = "contact: pelvis and a-very-long-name-of-a-thing, 0.52 m wide";
  for (const size_t letters : {1u, 8u, 16u, 40u, 200u}) {
    std::string again;
    for (const std::string& line : brokenLines(text, letters)) {
      EXPECT_TRUE(line.size() <= letters || line.find(' ') == std::string::npos) << line;
      again += (again.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(again, text);
  }
  EXPECT_TRUE(brokenLines("", 10).empty());
}

TEST(FillRect, IsCutOffAtTheEdges) {
  Image image(8, 6);
  fillRect(image, -3, 4, 5, 100, rgb(255, 255, 255));
  EXPECT_EQ(ink(image), 2 * 2);
  fillRect(image, 8, 0, 5, 5, rgb(255, 255, 255));
  fillRect(image, 0, 0, -2, 5, rgb(255, 255, 255));
  EXPECT_EQ(ink(image), 2 * 2);
}

TEST(TinyText, IsTheSamePictureWhereverItIsDrawn) {
  Image here(120, 40), there(120, 40);
  drawText(here, 5, 4, "12.5 s", 2, rgb(255, 255, 255));
  drawText(there, 30, 17, "12.5 s", 2, rgb(255, 255, 255));
  EXPECT_EQ(ink(here), ink(there));
  for (int y = 0; y < 40 - 13; ++y)
    for (int x = 0; x < 120 - 25; ++x)
      EXPECT_EQ(here.pixel(x, y)[0], there.pixel(x + 25, y + 13)[0]) << x << " " << y;
}

TEST(TinyText, ATextIsItsLettersSideBySide) {
  const std::string_view text = "3:07";
  Image whole(100, 20), letters(100, 20);
  drawText(whole, 2, 2, text, 2, rgb(255, 255, 255));
  for (size_t i = 0; i < text.size(); ++i)
    drawText(letters, 2 + textWidth(text.substr(0, i), 2), 2, text.substr(i, 1), 2,
             rgb(255, 255, 255));
  EXPECT_EQ(whole.rgb, letters.rgb);
  EXPECT_EQ(textWidth("", 3), 0);
}

}  // namespace
}  // namespace amble
