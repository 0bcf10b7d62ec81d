#include "viz/pictures/svg.h"

#include <vector>

namespace amble {

XmlAttributes svgRoot(double width, double height) {
  return {{"xmlns", "http://www.w3.org/2000/svg"},
          {"width", width},
          {"height", height},
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

XmlAttributes operator+(XmlAttributes first, const XmlAttributes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace amble
