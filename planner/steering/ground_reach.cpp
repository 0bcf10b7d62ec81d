#include "planner/steering/ground_reach.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace amble {
namespace {

// How far the square that a place stands on may be from it in height: kerbs beside it [m].
constexpr double kSameFloor = 0.3;
constexpr int kNearSquares = 2;      // and to each side, where its own has no ground
constexpr double kTwoFeet = 0.2;     // from one foot's line to the other's, and more [m]
constexpr int kSweepsOfNearest = 4;  // from one side of a gap to the other

// A surface over a square.
struct Spot {
  Eigen::Vector2i square;
  const GroundCells::Span* span = nullptr;
};

class Flood {
 public:
  Flood(const SceneGround& ground, double longest_step)
      : cells_(ground.cells()),
        limits_(ground.settings().limits),
        reach_(longest_step + kTwoFeet + 2.0 * cells_.cell()) {}

  std::optional<Spot> spotAt(const Eigen::Vector3d& p) const;
  /// Everything that is reached from `begin`; stops early at `end`.
  std::vector<Spot> from(const Spot& begin, const Spot* end) const;
  Eigen::Vector3d middle(const Spot& spot) const {
    Eigen::Vector3d p;
    p << cells_.middle(spot.square.x(), spot.square.y()), spot.span->height;
    return p;
  }

 private:
  // Ground over a square that a step from the spot may reach.
  template <typename Visit>
  void eachOver(const Spot& from, const Eigen::Vector2i& square, Visit visit) const {
    const double way = cells_.cell() * (square - from.square).cast<double>().norm();
    const double most =
        limits_.highestStep() + std::tan(limits_.max_slope) * (way + cells_.cell()) + kLevel;
    for (const GroundCells::Span& span : cells_.spans(square.x(), square.y())) {
      if (span.ground && std::abs(span.height - from.span->height) <= most)
        visit(Spot{square, &span});
    }
  }
  bool isInner(const Spot& spot) const;

  static constexpr double kLevel = GroundCells::kLevel;
  const GroundCells& cells_;
  const GroundLimits limits_;
  double reach_;
};

std::optional<Spot> Flood::spotAt(const Eigen::Vector3d& p) const {
  const Eigen::Vector2i at = cells_.squareAt(p.head<2>());
  std::optional<Spot> best;
  double least = HUGE_VAL;
  for (int j = -kNearSquares; j <= kNearSquares; ++j) {
    for (int i = -kNearSquares; i <= kNearSquares; ++i) {
      const Eigen::Vector2i square = at + Eigen::Vector2i(i, j);
      for (const GroundCells::Span& span : cells_.spans(square.x(), square.y())) {
        const double off = std::abs(span.height - p.z());
        if (!span.ground || off > kSameFloor) continue;
        const double distance = off + cells_.cell() * std::hypot(i, j);
        if (distance >= least) continue;
        least = distance;
        best = Spot{square, &span};
      }
    }
  }
  return best;
}

// Whether the ground goes on all around, with nothing over or under it: what is reached from there
// is reached from where it does not.
bool Flood::isInner(const Spot& spot) const {
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const Eigen::Vector2i square = spot.square + Eigen::Vector2i(i, j);
      if (cells_.spans(square.x(), square.y()).size() != 1) return false;
      int reached = 0;
      eachOver(spot, square, [&](const Spot&) { ++reached; });
      if (reached != 1) return false;
    }
  }
  return true;
}

std::vector<Spot> Flood::from(const Spot& begin, const Spot* end) const {
  std::vector<Spot> open = {begin};
  std::unordered_set<const GroundCells::Span*> seen = {begin.span};
  const int far = static_cast<int>(std::ceil(reach_ / cells_.cell()));
  for (size_t next = 0; next < open.size(); ++next) {
    const Spot spot = open[next];
    if (end != nullptr && spot.span == end->span) return open;
    const int range = isInner(spot) ? 1 : far;
    for (int j = -range; j <= range; ++j) {
      for (int i = -range; i <= range; ++i) {
        if (cells_.cell() * std::hypot(i, j) > reach_) continue;
        eachOver(spot, spot.square + Eigen::Vector2i(i, j), [&](const Spot& other) {
          if (seen.insert(other.span).second) open.push_back(other);
        });
      }
    }
  }
  return open;
}

Eigen::Vector3d nearest(const Flood& flood, const std::vector<Spot>& spots,
                        const Eigen::Vector3d& p) {
  Eigen::Vector3d best = flood.middle(spots.front());
  for (const Spot& spot : spots) {
    const Eigen::Vector3d at = flood.middle(spot);
    if ((at - p).squaredNorm() < (best - p).squaredNorm()) best = at;
  }
  return best;
}

}  // namespace

std::optional<GroundGap> findGap(const SceneGround& ground, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, double longest_step) {
  if (ground.cells().columns() == 0) return std::nullopt;
  const Flood flood(ground, longest_step);
  const auto begin = flood.spotAt(from), end = flood.spotAt(to);
  if (!begin || !end) return std::nullopt;
  if (begin->span->part >= 0 && begin->span->part == end->span->part) return std::nullopt;
  const std::vector<Spot> here = flood.from(*begin, &*end);
  const bool arrives = std::any_of(here.begin(), here.end(),
                                   [&](const Spot& spot) { return spot.span == end->span; });
  if (arrives) return std::nullopt;
  const std::vector<Spot> there = flood.from(*end, nullptr);
  GroundGap gap{from, to};
  for (int i = 0; i < kSweepsOfNearest; ++i) {
    gap.near = nearest(flood, here, gap.far);
    gap.far = nearest(flood, there, gap.near);
  }
  return gap;
}

}  // namespace amble
