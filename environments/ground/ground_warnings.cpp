#include "environments/ground/ground_warnings.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

// Whether anything that faces up lies below the middle of a triangle.
bool hasFloorBelow(const Triangle3& t, const SceneGround& ground) {
  const Eigen::Vector3d middle = (t[0] + t[1] + t[2]) / 3.0;
  bool found = false;
  ground.all().visitAt(middle.x(), middle.y(), [&](int k) {
    const Triangle3& other = ground.all().triangles()[k];
    if (found || upwardness(other) <= 0.0) return;
    const auto z = heightOver(other, middle.x(), middle.y());
    found = z && *z < middle.z() - kTouching;
  });
  return found;
}

// Area of a piece's triangles that would be ground if they were turned, or none where one faces up
// or lies over a floor [m^2].
double areaFacingDown(const ScenePiece& piece, const SceneGround& ground) {
  const double least = std::cos(ground.settings().limits.max_slope);
  double area = 0.0;
  for (size_t k = 0; k < piece.mesh.triangles.size(); ++k) {
    const Triangle3& t = ground.pieces().triangles()[piece.first + static_cast<int>(k)];
    const double up = upwardness(t);
    if (up >= least) return 0.0;
    if (up > -least) continue;
    if (hasFloorBelow(t, ground)) return 0.0;
    area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  }
  return area;
}

// Steps of a flight that rise by more are refused, at any going (from 0.25 m on where that is less
// than the 0.37 m that people's feet and knees need there): knee and thigh meet the next step
// but one. By trial: 0.30 m over 0.37 m is climbed, 0.32 m is not [m].
constexpr double kFlightRise = 0.3;
constexpr double kStepGap = 0.3;  // between a place and the next step [m]
constexpr double kTread = 0.8;    // longer ones are landings [m]

struct Step {
  Eigen::Vector2i square;
  double height;  // [m, World]
};

// The next step up from a place that is too high for a flight, no farther than `reach` [m].
std::optional<Step> highStep(const GroundCells& cells, const Step& from, const Eigen::Vector2i& way,
                             double reach, double max_climb) {
  Step next = from;
  for (int k = 1; k * cells.cell() <= reach; ++k) {
    next.square = from.square + k * way;
    for (const GroundCells::Span& span : cells.spans(next.square.x(), next.square.y())) {
      const double rise = span.height - from.height;
      if (!span.standable || rise < GroundCells::kLevel || rise > max_climb) continue;
      if (rise <= kFlightRise + 1e-6) return std::nullopt;
      next.height = span.height;
      return next;
    }
  }
  return std::nullopt;
}

// The highest of the steps of flights, and where it is.
std::optional<Step> steepestFlight(const GroundCells& cells, double max_climb, double& highest) {
  std::optional<Step> found;
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.columns(); ++column) {
      if (cells.isPlainAround(column, row)) continue;
      for (const GroundCells::Span& span : cells.spans(column, row)) {
        if (!span.standable) continue;
        const Step from{{column, row}, span.height};
        for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                           Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
          const auto one = highStep(cells, from, way, kStepGap, max_climb);
          const auto two = one ? highStep(cells, *one, way, kTread, max_climb) : std::nullopt;
          if (!two || one->height - from.height <= highest) continue;
          highest = one->height - from.height;
          found = from;
        }
      }
    }
  }
  return found;
}

std::optional<std::string> flightWarning(const SceneGround& ground) {
  const double max_climb = ground.settings().limits.max_climb;
  if (max_climb <= kFlightRise) return std::nullopt;
  double rise = 0.0;
  const auto step = steepestFlight(ground.cells(), max_climb, rise);
  if (!step) return std::nullopt;
  const Eigen::Vector2d at = ground.cells().middle(step->square.x(), step->square.y());
  char text[200];
  std::snprintf(text, sizeof text,
                "steps near (%.1f, %.1f, %.1f) rise by %.2f m one after another: flights of more "
                "than %.2f m a step are rarely climbed, whatever max_climb is",
                at.x(), at.y(), step->height, rise, kFlightRise);
  return text;
}

}  // namespace

std::vector<std::string> groundWarnings(const Scene& scene, const SceneGround& ground) {
  std::vector<std::string> warnings;
  int last = -1;
  for (const ScenePiece& piece : ground.pieces().pieces) {
    const SceneObject& object = scene.objects[piece.object];
    if (piece.closed || piece.object == last || object.role != Role::kAuto) continue;
    if (areaFacingDown(piece, ground) < GroundCells::kFloorArea) continue;
    last = piece.object;
    warnings.push_back(objectName(object) +
                       ": faces down, so that nobody stands on it; turn its faces over in the "
                       "file, or say `role: ground`");
  }
  if (const auto warning = flightWarning(ground)) warnings.push_back(*warning);
  return warnings;
}

std::vector<std::string> sceneWarnings(const Scene& scene, const SceneGround& ground) {
  std::vector<std::string> all = scene.warnings;
  for (std::string& warning : groundWarnings(scene, ground)) all.push_back(std::move(warning));
  return all;
}

}  // namespace amble
