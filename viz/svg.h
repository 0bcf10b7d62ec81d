/// SVG text: numbers that every locale writes the same, names that cannot break it, elements that
/// close.
#pragma once

#include <Eigen/Core>
#include <ostream>
#include <span>
#include <string>

namespace amble {

/// At most three decimals, no trailing zeros, always a point.
std::string svgNumber(double value);
/// With & < > " ' as entities, control characters as spaces.
std::string svgEscape(const std::string& text);

/// World metres to picture units: y goes down in SVG and up in World.
struct SvgFrame {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< World point at the picture's top left [m]
  double scale = 100;                                ///< picture units a metre
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return {(p.x() - origin.x()) * scale, (origin.y() - p.y()) * scale};
  }
};

/// "M x y L x y ... Z" of the points in the picture; "Z" only where `closed`.
std::string svgPath(const SvgFrame& frame, std::span<const Eigen::Vector2d> points, bool closed);

}  // namespace amble
