#include "environments/scene/mesh_warnings.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

namespace amble {
namespace {

// Walls higher than this, and not low for how wide they stand, are in another unit; hills are low
// and towers have walls that are not [m, share of the width].
constexpr double kHighest = 60.0, kLeastSlender = 0.15;
// Walls are about so high [m].
constexpr double kUsualHeight = 2.6;
// Numbers are read as floats, of 24 bits; corners that are moved by more than this are seen [m].
constexpr double kCoarse = 1e-3;

struct Unit {
  const char* name;
  double scale;  // [m]
};
constexpr Unit kUnits[] = {{"the centimetre", 0.01}, {"the inch", 0.0254}};

std::string numbers(const char* format, double a, double b, double c) {
  char text[256];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

std::string unitWarning(const std::string& object, const Eigen::Vector3d& size) {
  const auto offHeight = [&](const Unit& unit) {
    return std::abs(std::log(unit.scale * size.z() / kUsualHeight));
  };
  const Unit& likely = offHeight(kUnits[0]) <= offHeight(kUnits[1]) ? kUnits[0] : kUnits[1];
  const Eigen::Vector3d then = likely.scale * size;
  return object + ": " +
         numbers("%.0f m wide, %.0f m deep and %.0f m high", size.x(), size.y(), size.z()) +
         "; if its unit is " + likely.name + ", `scale: " + numbers("%g", likely.scale, 0, 0) +
         "` makes it " + numbers("%.1f, %.1f and %.1f m", then.x(), then.y(), then.z());
}

}  // namespace

std::vector<std::string> meshWarnings(const std::string& object, const MeshFile& file, double scale,
                                      bool is_guessed, bool y_up) {
  std::vector<std::string> warnings;
  for (const std::string& warning : file.warnings) warnings.push_back(object + ": " + warning);
  Eigen::AlignedBox3d box;
  for (const MeshPart& part : file.parts)
    for (const Eigen::Vector3d& v : part.mesh.vertices) box.extend(v);
  if (box.isEmpty()) return warnings;
  Eigen::Vector3d size = scale * box.sizes();
  if (y_up) std::swap(size.y(), size.z());
  const double width = std::max(size.x(), size.y());
  if (!file.has_axes && is_guessed && size.z() > kHighest && size.z() > kLeastSlender * width)
    warnings.push_back(unitWarning(object, size));
  const double far = scale * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const double step = std::exp2(std::floor(std::log2(far)) - 23.0);
  if (step > kCoarse)
    warnings.push_back(object + ": " +
                       numbers("lies %.4g m from the origin of its file, where numbers are read "
                               "%.2g m apart: its shape is lost; move it to its origin before it "
                               "is exported",
                               far, step, 0));
  return warnings;
}

}  // namespace amble
