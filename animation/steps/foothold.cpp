#include "animation/steps/foothold.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "animation/steps/unevenness.h"

namespace amble {
namespace {

constexpr int kRows = 7;                 // of samples, from the heel's end to the tip's
constexpr int kColumns = 3;              // from side to side
constexpr int kCellsOfTilted = 6;        // along a tilted sole, in which obstacles are looked for
constexpr double kSlopeRounding = 1e-3;  // ground as steep as the limit is walked [rad]

std::optional<SurfacePoint> uprightIfVertical(std::optional<SurfacePoint> point) {
  if (point && point->normal.z() > 1.0 - Unevenness::kVertical)
    point->normal = Eigen::Vector3d::UnitZ();
  return point;
}

}  // namespace

// Where a sole's samples lie.
struct FootholdFinder::SoleRows {
  double c, s, back, front, half_width;

  SoleRows(const FootPlace& place, const FootShape& foot)
      : c(std::cos(place.heading)),
        s(std::sin(place.heading)),
        back(foot.heel_x - foot.radius),
        front(foot.tip_x + foot.radius),
        half_width(foot.half_width) {}

  // From the sole's middle, in World's axes [m].
  Eigen::Vector2d at(int row, int column) const {
    const double x = back + (front - back) * row / (kRows - 1), y = half_width * (column - 1);
    return {c * x - s * y, s * x + c * y};
  }
};

struct FootholdFinder::Samples {
  struct Point {
    Eigen::Vector2d at;  // from the sole's middle, in World's axes [m]
    std::optional<SurfacePoint> surface;
  };
  std::array<Point, kRows * kColumns> points;
  SurfacePoint middle;
  bool level = true;  // every normal is vertical
};

// On ground that is level everywhere. Row by row, from the ends inwards: false as soon as judge()
// would refuse the place whatever is under the rest. It would, since a sample that sticks out or
// that lies too low under the highest so far does so with more of them.
bool FootholdFinder::sampleLevels(const FootPlace& place, const SoleRows& rows, double reach,
                                  Samples& samples) const {
  const double height = samples.middle.height;
  double raise = 0.0;
  int missing = 0;
  for (const int row : {kRows - 1, 0, kRows - 2, 1, kRows - 3, 2, 3}) {
    Samples::Point* points = &samples.points[row * kColumns];
    int standing = 0;
    for (int j = 0; j < kColumns; ++j) {
      points[j].at = rows.at(row, j);
      const Eigen::Vector2d at = place.position.head<2>() + points[j].at;
      points[j].surface = uprightIfVertical(ground_.surface(at.x(), at.y(), height, reach));
      if (!points[j].surface) continue;
      const double out = points[j].surface->height - height;
      if (out > Unevenness::kStraddled) return false;
      raise = std::max(raise, out);
    }
    for (int j = 0; j < kColumns; ++j) {
      const auto& surface = points[j].surface;
      standing += surface && surface->height - height >= raise - Unevenness::kStraddled ? 1 : 0;
    }
    missing += 2 * standing > kColumns ? 0 : 1;
    if (static_cast<double>(kRows - missing) / kRows < kLeastSupport) return false;
  }
  return true;
}

// What refuses the place by the samples seen, if anything.
std::optional<Foothold::Refusal> FootholdFinder::sample(const FootPlace& place,
                                                        const FootShape& foot, double reach,
                                                        Samples& out) const {
  const Eigen::Vector3d& p = place.position;
  const auto middle = uprightIfVertical(ground_.surface(p.x(), p.y(), p.z(), reach));
  if (!middle) return Foothold::Refusal::kNoGround;
  out.middle = *middle;
  out.level = middle->normal.z() == 1.0;
  const SoleRows rows(place, foot);
  if (ground_.isAllLevel()) {
    return sampleLevels(place, rows, reach, out) ? std::nullopt
                                                 : std::optional(Foothold::Refusal::kEdge);
  }
  std::array<Eigen::Vector2d, kRows * kColumns> at;
  std::array<std::optional<SurfacePoint>, kRows * kColumns> surfaces;
  for (int k = 0; k < kRows * kColumns; ++k) {
    out.points[k].at = rows.at(k / kColumns, k % kColumns);
    at[k] = p.head<2>() + out.points[k].at;
  }
  ground_.surfaces(at, middle->height, reach, surfaces);
  for (size_t k = 0; k < at.size(); ++k) {
    Samples::Point& point = out.points[k];
    point.surface = uprightIfVertical(surfaces[k]);
    out.level = out.level && (!point.surface || point.surface->normal.z() == 1.0);
  }
  return std::nullopt;
}

// Of a sole in the plane through the middle's height with this normal, raised until nothing sticks
// out.
Foothold FootholdFinder::judge(const FootPlace& place, const Samples& samples,
                               const Eigen::Vector3d& normal, double height) const {
  Foothold found;
  found.place = place;
  found.place.normal = normal;
  const auto over = [&](const Samples::Point& point) {
    return point.surface->height - height + normal.head<2>().dot(point.at) / normal.z();
  };
  double raise = 0.0;
  for (const auto& point : samples.points) {
    if (!point.surface) continue;
    const double out = over(point);
    if (out > Unevenness::kStraddled) {
      found.refusal = Foothold::Refusal::kEdge;
      return found;
    }
    raise = std::max(raise, out);
  }
  if (!samples.level) raise = std::max(0.0, raise - Unevenness::kPressed);
  int rows = 0;
  for (int i = 0; i < kRows; ++i) {
    int standing = 0;
    for (int j = 0; j < kColumns; ++j) {
      const auto& point = samples.points[i * kColumns + j];
      standing += point.surface && over(point) >= raise - Unevenness::kStraddled ? 1 : 0;
    }
    rows += 2 * standing > kColumns ? 1 : 0;
  }
  found.place.position.z() = height + raise;
  found.supported = static_cast<double>(rows) / kRows;
  if (found.supported < kLeastSupport) found.refusal = Foothold::Refusal::kEdge;
  return found;
}

// Whether anything, ground or not, sticks up through the sole.
bool FootholdFinder::obstructed(const FootPlace& stood, const FootShape& foot) const {
  const Eigen::Vector2d ahead(std::cos(stood.heading), std::sin(stood.heading));
  const Eigen::Vector2d middle = stood.position.head<2>();
  const double back = foot.heel_x - foot.radius, front = foot.tip_x + foot.radius;
  const double z = stood.position.z();
  const bool level = stood.normal.z() == 1.0;
  const double tilt = tiltAlong(stood, ahead), across = tiltAlong(stood, {-ahead.y(), ahead.x()});
  const int cells = level ? 1 : kCellsOfTilted;
  for (int i = 0; i < cells; ++i) {
    const double x0 = back + (front - back) * i / cells,
                 x1 = back + (front - back) * (i + 1) / cells;
    const double plane = z + std::max(tilt * x0, tilt * x1) + std::abs(across) * foot.half_width;
    const double most = plane + (level ? Unevenness::kPressed : 2.0 * Unevenness::kPressed);
    if (ground_.risesAbove(middle + x0 * ahead, middle + x1 * ahead, foot.half_width, most,
                           plane + Unevenness::kInTheWay))
      return true;
  }
  return false;
}

// Whether all samples of a sole are level with its middle for certain.
bool FootholdFinder::isLevelUnder(const FootPlace& place, const FootShape& foot, double height,
                                  double reach) const {
  const SoleRows rows(place, foot);
  Eigen::AlignedBox2d box;
  for (const int row : {0, kRows - 1})
    for (const int column : {0, kColumns - 1})
      box.extend(place.position.head<2>() + rows.at(row, column));
  return ground_.levelOver(box, height, reach) == height;
}

Foothold FootholdFinder::at(const FootPlace& place, Side side, double reach) const {
  const FootShape& foot = feet_[side];
  Samples samples;
  Foothold found;
  found.place = place;
  const Eigen::Vector2d p = place.position.head<2>();
  const auto level = ground_.levelOver({p, p}, place.position.z(), reach);
  if (level && isLevelUnder(place, foot, *level, reach)) {
    found.place.position.z() = *level + 0.0;
    found.place.normal = Eigen::Vector3d::UnitZ();
    if (obstructed(found.place, foot)) found.refusal = Foothold::Refusal::kEdge;
    return found;
  }
  if (const auto refusal = sample(place, foot, reach, samples)) {
    found.refusal = *refusal;
    return found;
  }
  const double height = samples.middle.height;
  found = judge(place, samples, samples.middle.normal, height);
  if (!samples.level) {
    // The mean plane of all samples, where they are one surface.
    Eigen::Matrix<double, kRows * kColumns, 3> a;
    Eigen::Matrix<double, kRows * kColumns, 1> b;
    bool whole = true;
    for (int k = 0; k < kRows * kColumns && whole; ++k) {
      const auto& point = samples.points[k];
      whole = point.surface.has_value();
      if (whole) a.row(k) << point.at.x(), point.at.y(), 1.0;
      if (whole) b[k] = point.surface->height - height;
    }
    if (whole) {
      // The samples lie the same way about the middle for every foot: well conditioned.
      const Eigen::Vector3d fit = (a.transpose() * a).ldlt().solve(a.transpose() * b);
      if ((a * fit - b).cwiseAbs().maxCoeff() <= Unevenness::kUneven) {
        const Eigen::Vector3d normal = Eigen::Vector3d(-fit.x(), -fit.y(), 1.0).normalized();
        found = judge(place, samples, normal, height + fit.z());
      }
    }
  }
  if (found.refusal != Foothold::Refusal::kNone) return found;
  if (found.place.normal.z() < std::cos(limits_.max_slope + kSlopeRounding)) {
    found.refusal = Foothold::Refusal::kSlope;
  } else if (obstructed(found.place, foot)) {
    found.refusal = Foothold::Refusal::kEdge;
  }
  return found;
}

}  // namespace amble
