#include "viz/svg.h"

#include <charconv>
#include <cmath>

namespace amble {

std::string svgNumber(double value) {
  const double rounded = std::round(value * 1000) / 1000;
  if (!std::isfinite(rounded) || rounded == 0) return "0";
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, rounded, std::chars_format::fixed, 3).ptr;
  std::string number(text, end);
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number;
}

std::string svgEscape(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&apos;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

std::string svgPath(const SvgFrame& frame, std::span<const Eigen::Vector2d> points, bool closed) {
  std::string path;
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = frame(points[i]);
    path += i == 0 ? "M" : "L";
    path += svgNumber(p.x()) + ' ' + svgNumber(p.y());
  }
  return closed ? path + 'Z' : path;
}

}  // namespace amble
