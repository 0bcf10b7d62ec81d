#include "batch/run/draw_way.h"

#include <cmath>

#include "planner/steering/walk_steering.h"

namespace amble {
namespace {

// Beside the walking body, that nobody is put down in a cranny [m].
constexpr double kRoom = 0.05;
// Ways lead where there is as much, as those that the search tries: on stairs the tread after next
// is beside the body [m].
constexpr double kTightestWay = -0.06;

double toMillimetre(double value) { return std::round(value * 1000.0) / 1000.0; }

// Numbers of the parts of the map that ways lead all over; -1 where there is no way.
std::vector<int> partsOf(const ClearanceMap& map) {
  std::vector<int> part(static_cast<size_t>(map.size()), -1), open;
  int count = 0;
  for (int first = 0; first < map.size(); ++first) {
    if (part[static_cast<size_t>(first)] >= 0 || map.spare(first) < kTightestWay) continue;
    part[static_cast<size_t>(first)] = count;
    open.push_back(first);
    while (!open.empty()) {
      const int here = open.back();
      open.pop_back();
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int next = map.beside(here, dx, dy);
        if (next < 0 || map.spare(next) < kTightestWay || part[static_cast<size_t>(next)] >= 0)
          continue;
        part[static_cast<size_t>(next)] = count;
        open.push_back(next);
      }
    }
    ++count;
  }
  return part;
}

}  // namespace

struct WayDrawer::Parts {
  explicit Parts(const Problem& of)
      : problem(of),
        steering(of.synthesizer, of.world, of.ground),
        map(steering.map(of.bounds(), [] { return false; })) {
    if (map) part = partsOf(*map);
    const Eigen::AlignedBox3d all = of.scene.bounds();
    box = {all.min().head<2>(), all.max().head<2>()};
    if (of.scenario.bounds) box = {of.scenario.bounds->min, of.scenario.bounds->max};
  }

  struct Found {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  // on the ground
    int part = -1;                                 // of the map
  };
  // A place with room, if there is one at the first point that is drawn.
  std::optional<Found> place(SampleStream& stream) const {
    const double x = toMillimetre(stream.uniform(box.min().x(), box.max().x()));
    const double y = toMillimetre(stream.uniform(box.min().y(), box.max().y()));
    const double which = stream.uniform();
    const std::vector<double> floors = problem.ground.floors(x, y);
    if (floors.empty()) return std::nullopt;
    const size_t floor = static_cast<size_t>(which * static_cast<double>(floors.size()));
    const Eigen::Vector3d at(x, y, floors[floor]);
    const int nearest = map->placeAt(at);
    if (nearest < 0 || map->spare(nearest) < kRoom) return std::nullopt;
    const bool there = (map->at(nearest) - at).head<2>().cwiseAbs().maxCoeff() <= map->cell() &&
                       std::abs(map->at(nearest).z() - at.z()) < kFloorReach;
    if (!there) return std::nullopt;
    return Found{at, part[static_cast<size_t>(nearest)]};
  }
  bool canStand(const Eigen::Vector3d& at, const Eigen::Vector3d& facing,
                SteeringScratch& scratch) const {
    Stance stance;
    stance.position = at;
    stance.standing = true;
    stance.heading = std::atan2(facing.y() - at.y(), facing.x() - at.x());
    return !steering.stand(stance, scratch);
  }

  const Problem& problem;
  const WalkSteering steering;
  const std::shared_ptr<const ClearanceMap> map;
  std::vector<int> part;  // of each place
  Eigen::AlignedBox2d box;
};

WayDrawer::WayDrawer(const Problem& problem) : parts_(std::make_unique<const Parts>(problem)) {}
WayDrawer::~WayDrawer() = default;

std::optional<WayDrawer::Ends> WayDrawer::draw(SampleStream& stream, double least,
                                               double most) const {
  if (!parts_->map) return std::nullopt;
  const auto scratch = parts_->steering.makeScratch();
  int starts = 0;
  for (int i = 0; i < kTries && starts < kStarts; ++i) {
    const auto start = parts_->place(stream);
    if (!start) continue;
    ++starts;
    for (int j = 0; j < kGoals; ++j) {
      const auto goal = parts_->place(stream);
      if (!goal || goal->part != start->part) continue;
      const double distance = (goal->at - start->at).head<2>().norm();
      if (distance < least || distance > most) continue;
      if (!parts_->canStand(start->at, goal->at, *scratch)) break;
      if (!parts_->canStand(goal->at, start->at, *scratch)) continue;
      const auto placed = [](const Parts::Found& found) {
        return Place{found.at.head<2>(), toMillimetre(found.at.z()), {}};
      };
      return Ends{placed(*start), placed(*goal)};
    }
  }
  return std::nullopt;
}

}  // namespace amble
