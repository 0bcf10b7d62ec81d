#include "viz/pictures/svg.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace amble {

XmlAttributes svgRoot(double width, double height) {
  return {{"xmlns", "http://www.w3.org/2000/svg"},
          {"width", width},
          {"height", height},
          {"viewBox", "0 0 " + xmlNumber(width) + " " + xmlNumber(height)},
          {"font-family", "sans-serif"}};
}

XmlAttributes svgScalingRoot(double width, double height) {
  return {{"xmlns", "http://www.w3.org/2000/svg"},
          {"width", "100%"},
          {"viewBox", "0 0 " + xmlNumber(width) + " " + xmlNumber(height)},
          {"font-family", "sans-serif"}};
}

std::string svgPath(std::span<const Eigen::Vector2d> points, bool closed) {
  std::string path;
  for (size_t i = 0; i < points.size(); ++i) {
    path += i == 0 ? "M" : "L";
    path += xmlNumber(points[i].x()) + ' ' + xmlNumber(points[i].y());
  }
  return closed ? path + 'Z' : path;
}

std::string svgPath(const SvgFrame& frame, std::span<const Eigen::Vector2d> points, bool closed) {
  std::vector<Eigen::Vector2d> placed;
  for (const Eigen::Vector2d& p : points) placed.push_back(frame(p));
  return svgPath(placed, closed);
}

std::string svgCurve(std::span<const Eigen::Vector2d> points) {
  using Eigen::Vector2d;
  constexpr double kStraight = 0.05;  // off the line between the ends [units]
  if (points.size() < 2) return svgPath(points, false);
  const Vector2d along = points.back() - points.front();
  const Vector2d across = Vector2d(-along.y(), along.x()).normalized();
  double off = 0.0;
  for (const Vector2d& p : points) off = std::max(off, std::abs(across.dot(p - points.front())));
  if (off < kStraight && along.norm() > kStraight)
    return svgPath(std::vector<Vector2d>{points.front(), points.back()}, false);
  const auto text = [](const Vector2d& p) { return xmlNumber(p.x()) + ' ' + xmlNumber(p.y()); };
  std::string path = 'M' + text(points[0]);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector2d before = points[i > 0 ? i - 1 : 0];
    const Vector2d after = points[std::min(i + 2, points.size() - 1)];
    const Vector2d leave = points[i] + (points[i + 1] - before) / 6;
    const Vector2d arrive = points[i + 1] - (after - points[i]) / 6;
    path += 'C' + text(leave) + ' ' + text(arrive) + ' ' + text(points[i + 1]);
  }
  return path;
}

XmlAttributes operator+(XmlAttributes first, const XmlAttributes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace amble
