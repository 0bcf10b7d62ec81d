/// What SVG drawings share: World in a picture, and paths.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "base/xml.h"

namespace amble {

/// World metres to picture units: y goes down in SVG and up in World.
struct SvgFrame {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< World point at the picture's top left [m]
  double scale = 100;                                ///< picture units a metre [> 0]
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return {(p.x() - origin.x()) * scale, (origin.y() - p.y()) * scale};
  }
};

/// The attributes that every drawing of this size begins with: its element is `svg`. [units, > 0]
XmlAttributes svgRoot(double width, double height);
/// Of one that is as wide as what it is shown in, whatever that is.
XmlAttributes svgScalingRoot(double width, double height);

/// "M x y L x y ... Z" of points in the picture; "Z" only where `closed`.
std::string svgPath(std::span<const Eigen::Vector2d> points, bool closed);
/// The same of points in World.
std::string svgPath(const SvgFrame& frame, std::span<const Eigen::Vector2d> points, bool closed);

/// "M x y C ..." through points in the picture: a curve that leaves each towards where the one
/// after the next lies (Catmull and Rom 1974); "M x y L x y" where all lie on a line.
std::string svgCurve(std::span<const Eigen::Vector2d> points);

/// Attributes one after another.
XmlAttributes operator+(XmlAttributes first, const XmlAttributes& second);

}  // namespace amble
