/// The colours of the pictures; one place, so that plan view, walk and film strip agree.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "animation/body/joint_roles.h"

namespace amble {

/// sRGB, each 0 to 1.
using Color = Eigen::Vector3f;

inline Color rgb(int r, int g, int b) {
  return Color(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)) / 255.0f;
}

/// Of one of the three, rounded [0 to 255].
inline uint8_t colorByte(float share) {
  // In double no half is rounded twice; std::lround takes ten times as long.
  return static_cast<uint8_t>(static_cast<double>(std::clamp(share, 0.0f, 1.0f) * 255) + 0.5);
}

/// Left is blue and right is orange wherever feet are told apart: seen as two by the colour-blind
/// too.
Color sideColor(Side side);
/// The colour of a moment: from teal at 0 through violet to amber at 1.
Color timeColor(double share);
/// What its names say a thing is ("leaves" are green), the part's before the object's; none where
/// they say nothing.
std::optional<Color> namedColor(const std::string& object, const std::string& part);
/// What things that are counted have in common: the name without the number at its end ("tread" of
/// "tread-12", "Cube" of "Cube.001").
std::string familyName(const std::string& object);
/// One of ten quiet colours, by the family's name: it stays when other things are added, and the
/// treads of one stair have one.
Color otherColor(const std::string& object);
/// One of ten that tell pieces apart, by the piece's number.
Color motleyColor(int piece);
/// A little lighter or darker, by a number that looks random: pieces of one thing differ so.
Color tinted(const Color& color, int piece);
/// Pieces of a thing that are known for being of many colours (books).
bool isMotley(const std::string& part);
Color mix(const Color& a, const Color& b, float share);

inline const Color kWallColor = rgb(232, 230, 224);
inline const Color kFloorColor = rgb(214, 196, 170);
inline const Color kRugColor = rgb(150, 70, 62);
inline const Color kStartColor = rgb(29, 122, 69);
inline const Color kGoalColor = rgb(179, 38, 30);
inline const Color kPathColor = rgb(190, 30, 75);
inline const Color kReachedColor = rgb(0, 130, 95);  ///< ground that one gets to
inline const Color kStopColor = rgb(205, 25, 20);    ///< what stood in the way

/// "#rrggbb"
std::string hexColor(const Color& color);

}  // namespace amble
