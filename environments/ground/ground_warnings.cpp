#include "environments/ground/ground_warnings.h"

#include <algorithm>
#include <array>
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

// Steps of a flight that rise by more are refused: knee and thigh meet the next step but one, or
// the leg is too short. By trial, of flights of four steps: {going, rise} [m].
constexpr std::array<std::array<double, 2>, 7> kClimbed = {{{0.28, 0.24},
                                                            {0.31, 0.275},
                                                            {0.34, 0.285},
                                                            {0.37, 0.32},
                                                            {0.41, 0.34},
                                                            {0.52, 0.34},
                                                            {0.60, 0.385}}};
constexpr double kStepGap = 0.3;  // between a place and the next step [m]
constexpr double kTread = 0.8;    // longer ones are landings [m]

// The highest rise of a flight that is climbed [m].
double climbedRise(double going) {
  if (going <= kClimbed.front()[0]) return kClimbed.front()[1];
  for (size_t i = 1; i < kClimbed.size(); ++i) {
    const auto& [g0, r0] = kClimbed[i - 1];
    const auto& [g1, r1] = kClimbed[i];
    if (going <= g1) return r0 + (r1 - r0) * (going - g0) / (g1 - g0);
  }
  return kClimbed.back()[1];
}

struct Step {
  Eigen::Vector2i square;
  double height;  // [m, World]
};

// The next step up from a place that may be too high for a flight, no farther than `reach` [m].
std::optional<Step> highStep(const GroundCells& cells, const Step& from, const Eigen::Vector2i& way,
                             double reach, double max_climb) {
  Step next = from;
  for (int k = 1; k * cells.cell() <= reach; ++k) {
    next.square = from.square + k * way;
    for (const GroundCells::Span& span : cells.spans(next.square.x(), next.square.y())) {
      const double rise = span.height - from.height;
      if (!span.standable || rise < GroundCells::kLevel || rise > max_climb) continue;
      if (rise <= climbedRise(0.0)) return std::nullopt;
      next.height = span.height;
      return next;
    }
  }
  return std::nullopt;
}

// How far from p, along a way, ground of a height begins [m]; none within `reach`.
std::optional<double> beginOf(const SceneGround& ground, const Eigen::Vector2d& p, double height,
                              const Eigen::Vector2d& way, double reach) {
  constexpr double kFine = 0.002;  // [m]
  for (double d = 0.0; d <= reach; d += kFine) {
    const Eigen::Vector2d at = p + d * way;
    if (ground.surface(at.x(), at.y(), height, GroundCells::kLevel)) return d;
  }
  return std::nullopt;
}

// From riser to riser of two steps that were met along a way, square to them [m]; none where their
// edges are not straight and parallel, as at the corners of a flight.
std::optional<double> goingOf(const SceneGround& ground, const Eigen::Vector2d& p, const Step& one,
                              const Step& two, const Eigen::Vector2d& way) {
  constexpr double kAside = 0.1;      // [m]
  constexpr double kStraight = 0.01;  // [m]
  constexpr double kFar = kStepGap + kTread + kAside;
  std::array<std::array<double, 3>, 2> begin{};  // of each riser: to the right, ahead, to the left
  for (int riser = 0; riser < 2; ++riser) {
    for (int side = -1; side <= 1; ++side) {
      const Eigen::Vector2d from = p + side * kAside * Eigen::Vector2d(-way.y(), way.x());
      const auto at = beginOf(ground, from, riser == 0 ? one.height : two.height, way, kFar);
      if (!at) return std::nullopt;
      begin[riser][side + 1] = *at;
    }
  }
  const double skew = begin[0][2] - begin[0][1];
  for (const auto& [right, ahead, left] : begin) {
    if (std::abs(ahead - right - skew) > kStraight || std::abs(left - ahead - skew) > kStraight)
      return std::nullopt;
  }
  return (begin[1][1] - begin[0][1]) * kAside / std::hypot(kAside, skew);
}

struct Flight {
  Eigen::Vector3d at;
  double rise, going, climbed;  // [m]
};

// What begins at a place, if it is too steep to be climbed.
std::optional<Flight> steepFlight(const SceneGround& ground, const Step& from,
                                  const Eigen::Vector2i& way) {
  const GroundCells& cells = ground.cells();
  const double max_climb = ground.settings().limits.max_climb;
  const auto one = highStep(cells, from, way, kStepGap, max_climb);
  const auto two = one ? highStep(cells, *one, way, kTread, max_climb) : std::nullopt;
  if (!two) return std::nullopt;
  const Eigen::Vector2d p = cells.middle(from.square.x(), from.square.y());
  const auto going = goingOf(ground, p, *one, *two, way.cast<double>());
  if (!going) return std::nullopt;
  const double rise = std::min(one->height - from.height, two->height - one->height);
  const double climbed = climbedRise(*going);
  if (rise <= climbed + 1e-6) return std::nullopt;
  return Flight{{p.x(), p.y(), from.height}, rise, *going, climbed};
}

// That which is most too steep.
std::optional<Flight> steepestFlight(const SceneGround& ground) {
  const GroundCells& cells = ground.cells();
  std::optional<Flight> steepest;
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.columns(); ++column) {
      if (cells.isPlainAround(column, row)) continue;
      for (const GroundCells::Span& span : cells.spans(column, row)) {
        if (!span.standable) continue;
        for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                           Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
          const auto flight = steepFlight(ground, {{column, row}, span.height}, way);
          const auto over = [](const Flight& f) { return f.rise - f.climbed; };
          if (flight && (!steepest || over(*flight) > over(*steepest) + 1e-6)) steepest = flight;
        }
      }
    }
  }
  return steepest;
}

std::optional<std::string> flightWarning(const SceneGround& ground) {
  if (ground.settings().limits.max_climb <= climbedRise(0.0)) return std::nullopt;
  const auto flight = steepestFlight(ground);
  if (!flight) return std::nullopt;
  char text[240];
  std::snprintf(
      text, sizeof text,
      "steps near (%.1f, %.1f, %.1f) rise by %.2f m over %.2f m one after another: flights "
      "of more than %.2f m a step there are rarely climbed, whatever max_climb is",
      flight->at.x(), flight->at.y(), flight->at.z(), flight->rise, flight->going, flight->climbed);
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
