#include "scenarios/standing_feet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "animation/steps/foot_state.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kTrim = 0.15;  // of a plant, or the usual one if that is longer, at each end
// Ground that is farther from a planted sole is not what it stands on [m].
constexpr double kFootReach = 0.1;

double usualPlant(const FootPlants& plants) {
  std::vector<double> frames;
  for (const Side side : {kLeft, kRight})
    for (const FootPlant& plant : plants.plants[side])
      frames.push_back(plant.last - plant.first + 1);
  return frames.empty() ? 0.0 : median(std::move(frames));
}

// First and last frame of each stay on the ground within [first, last].
std::vector<std::pair<int, int>> staysOf(const SoleTracks& soles, Side side, int first, int last,
                                         double gap_frames) {
  std::vector<std::pair<int, int>> stays;
  for (int frame = first; frame <= last; ++frame) {
    if (soles.height(side, frame) > kTouchHeight) continue;
    if (stays.empty() || frame - stays.back().second - 1 > gap_frames) {
      stays.emplace_back(frame, frame);
    }
    stays.back().second = frame;
  }
  return stays;
}

double slideOf(const SoleTracks& soles, Side side, int first, int last, double gap_frames) {
  double slide = 0.0;
  for (const auto& [begin, end] : staysOf(soles, side, first, last, gap_frames)) {
    slide = std::max(slide, soles.slide(side, begin, end));
  }
  return slide;
}

double hoverOf(const SoleTracks& soles, Side side, int first, int last) {
  std::vector<double> heights;
  for (int frame = first; frame <= last; ++frame) heights.push_back(soles.height(side, frame));
  return std::clamp(median(std::move(heights)), 0.0, kMostHover);
}

// The ground under the middle of a sole that stands; none where there is none.
std::optional<FootPlace> placeOf(const SoleTracks& soles, Side side, const FootPlant& plant,
                                 const Ground& ground) {
  const SoleEnds ends = soles.ends(side, soles.flattest(side, plant.first, plant.last));
  const Eigen::Vector3d middle = 0.5 * (ends.heel + ends.ball);
  const auto surface = ground.surface(middle.x(), middle.y(), middle.z(), kFootReach);
  if (!surface) return std::nullopt;
  return FootPlace{{middle.x(), middle.y(), surface->height}, 0.0, surface->normal};
}

}  // namespace

FootPlants plantsOver(const Clip& clip, const JointRoles& roles, const Ground& ground,
                      double floor) {
  FootPaths paths = footPaths(clip, roles);
  for (Eigen::MatrixXd& path : paths) {
    for (Eigen::Index frame = 0; frame < path.rows(); ++frame) {
      for (const Eigen::Index joint : {0, 3}) {
        double& z = path(frame, joint + 2);
        z -= ground.height(path(frame, joint), path(frame, joint + 1), z, kMostHover)
                 .value_or(floor);
      }
    }
  }
  return detectPlants(paths, legLengths(clip, roles), clip.frame_time);
}

StandingFeet measureStandingFeet(const SoleTracks& soles, const FootPlants& plants,
                                 double frame_time) {
  StandingFeet feet;
  double slides = 0.0;
  int frames = 0, hovering = 0;
  // That the clip begins or ends within a plant makes it shorter, not its landing better known.
  const double usual = usualPlant(plants);
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      const int own = plant.last - plant.first + 1;
      const auto wanted = std::lround(kTrim * std::max(usual, static_cast<double>(own)));
      const int trim = std::min(static_cast<int>(wanted), (own - 1) / 2);
      const int first = plant.first + trim, last = plant.last - trim;
      const double slide = slideOf(soles, side, first, last, kShortestGap / frame_time);
      const double hover = hoverOf(soles, side, first, last);
      feet.skate_max = std::max(feet.skate_max, slide);
      feet.hover_max = std::max(feet.hover_max, hover);
      slides += slide;
      ++feet.plants;
      frames += last - first + 1;
      hovering += hover > kHoverLimit ? last - first + 1 : 0;
    }
  }
  if (feet.plants > 0) feet.skate_mean = slides / feet.plants;
  if (frames > 0) feet.hover_share = static_cast<double>(hovering) / frames;
  return feet;
}

StepHeights measureStepHeights(const SoleTracks& soles, const FootPlants& plants,
                               const Ground& ground) {
  std::map<std::pair<int, int>, std::optional<FootPlace>> places;  // by first frame, and side
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      places[{plant.first, side}] = placeOf(soles, side, plant, ground);
    }
  }
  StepHeights steps;
  std::optional<FootPlace> last;
  for (const auto& [when, place] : places) {
    if (last && place) {
      const double height = stepHeight(*last, *place);
      steps.up = std::max(steps.up, height);
      steps.down = std::max(steps.down, -height);
    }
    if (place) last = place;
  }
  return steps;
}

}  // namespace amble
