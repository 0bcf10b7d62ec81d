#include "viz/pictures/color.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace amble {
namespace {

bool isColor(const Color& color) { return color.minCoeff() >= 0.0f && color.maxCoeff() <= 1.0f; }

TEST(Color, HexDigitsAreTheBytes) {
  for (int v = 0; v < 256; ++v) {
    const std::string hex = hexColor(rgb(v, 255 - v, 7));
    ASSERT_EQ(hex.size(), 7u);
    EXPECT_EQ(std::stoi(hex.substr(1, 2), nullptr, 16), v);
    EXPECT_EQ(std::stoi(hex.substr(3, 2), nullptr, 16), 255 - v);
  }
  EXPECT_EQ(hexColor({-1.0f, 0.0f, 9.0f}), "#0000ff");
}

TEST(Color, TimeRunsThroughColorsWithoutAJumpOrAReturn) {
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const Color here = timeColor(static_cast<double>(i) / kSteps);
    EXPECT_TRUE(isColor(here));
    EXPECT_LT((timeColor((i + 1.0) / kSteps) - here).norm(), 0.02f);
    EXPECT_GT((timeColor(0.0) - timeColor(1.0)).norm(), 0.5f);
    for (int k = 0; k + 40 <= i; ++k)
      EXPECT_GT((timeColor(static_cast<double>(k) / kSteps) - here).norm(), 0.05f) << k << " " << i;
  }
  EXPECT_EQ(timeColor(-1.0), timeColor(0.0));
  EXPECT_EQ(timeColor(2.0), timeColor(1.0));
}

TEST(Color, APartsNameComesBeforeItsObjects) {
  EXPECT_EQ(namedColor("sofa", "pillow"), namedColor("", "pillow"));
  EXPECT_EQ(namedColor("sofa", ""), namedColor("SOFA-2", "x"));
  EXPECT_NE(namedColor("sofa", "pillow"), namedColor("sofa", ""));
  EXPECT_FALSE(namedColor("zzz", "").has_value());
}

TEST(Color, OthersKeepTheirsAndDifferAmongThemselves) {
  EXPECT_EQ(otherColor("crate"), otherColor("crate"));
  std::set<std::string> seen;
  for (char a = 'a'; a <= 'z'; ++a)
    for (char b = 'a'; b <= 'z'; ++b) seen.insert(hexColor(otherColor({a, b})));
  EXPECT_EQ(seen.size(), 10u);
}

TEST(Color, AFamilyIsWhatIsLeftOfANameWithoutItsNumber) {
  for (const char* name : {"tread", "tread-1", "tread-12", "tread_07", "tread 3", "tread.001"})
    EXPECT_EQ(familyName(name), "tread") << name;
  EXPECT_EQ(familyName("2nd-floor"), "2nd-floor");
  EXPECT_EQ(familyName("17"), "17");  // a number alone is a name
  EXPECT_EQ(familyName(""), "");
}

TEST(Color, AFamilyHasOneColour) {
  for (int i = 1; i <= 20; ++i)
    EXPECT_EQ(otherColor("tread-" + std::to_string(i)), otherColor("tread-1"));
}

// Spread of a colour's channels: 0 of a grey.
float saturation(const Color& color) { return color.maxCoeff() - color.minCoeff(); }

TEST(Color, WhatHasNoneGetsAQuieterOneThanBodiesPrintsAndPath) {
  float loudest = 0.0f;
  for (char a = 'a'; a <= 'z'; ++a)
    for (char b = 'a'; b <= 'z'; ++b) loudest = std::max(loudest, saturation(otherColor({a, b})));
  for (int i = 0; i <= 100; ++i) EXPECT_GT(saturation(timeColor(i / 100.0)), 2 * loudest);
  for (const Color& color : {sideColor(kLeft), sideColor(kRight), kPathColor})
    EXPECT_GT(saturation(color), 2 * loudest);
}

TEST(Color, TintsStayNear) {
  const Color base = rgb(200, 100, 50);
  for (int piece = 0; piece < 200; ++piece) {
    const Color tint = tinted(base, piece);
    EXPECT_TRUE(isColor(tint));
    EXPECT_LE((tint - base).cwiseAbs().maxCoeff(), 0.11f * base.maxCoeff() + 1e-5f);
  }
  EXPECT_TRUE(isColor(tinted(rgb(255, 255, 255), 3)));
}

TEST(Color, MixesAreBetween) {
  const Color a = rgb(10, 200, 30), b = rgb(110, 100, 230);
  EXPECT_EQ(mix(a, b, 0.0f), a);
  EXPECT_LT((mix(a, b, 1.0f) - b).norm(), 1e-6f);
  EXPECT_LT((mix(a, b, 0.5f) - 0.5f * (a + b)).norm(), 1e-6f);
}

TEST(Color, LeftAndRightDifferInBlueAndRedBothWays) {
  const Color left = sideColor(kLeft), right = sideColor(kRight);
  EXPECT_GT(left.z() - right.z(), 0.5f);
  EXPECT_GT(right.x() - left.x(), 0.5f);
}

}  // namespace
}  // namespace amble
