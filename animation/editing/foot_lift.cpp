#include "animation/editing/foot_lift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/editing/least_curve.h"

namespace amble {
namespace {

constexpr double kSmooth = 0.05;  // over which the change of height is averaged [s]
constexpr double kSmoothUnder =
    0.02;                           // the same where it is lowered; longer, and lows are lost [s]
constexpr double kTellsMost = 0.1;  // of the change's largest, below which a frame decides nothing

/// A foot's swing from one plant to the next.
struct Swing {
  const PlantMeasures &from, &to;
  int first() const { return from.plant.last; }
  int last() const { return to.plant.first; }
};

/// How high the sole is over the line between its prints, at each frame of the swing [m]; 0
/// outside.
std::vector<double> heights(const Swing& swing, const FootTrack& foot, double heel) {
  std::vector<double> heights(foot.toe.size(), 0.0);
  for (int i = swing.first(); i <= swing.last(); ++i) {
    const SoleEnds sole = capturedSole(foot.ankle[i], foot.toe[i], heel, swing.from.flat_pitch);
    heights[i] = heightOver(swing.from.ends, swing.to.ends, sole);
  }
  return heights;
}

/// A smooth curve that is nowhere above values that are not negative, and nowhere negative.
std::vector<double> curveUnder(const std::vector<double>& values, double frame_time, double width) {
  const double most = *std::max_element(values.begin(), values.end());
  std::vector<double> missing;
  for (const double value : values) missing.push_back(most - value);
  std::vector<double> curve = curveOver(missing, frame_time, width);
  for (double& value : curve) value = std::max(0.0, most - value);
  return curve;
}

/// What a swing is raised by where it is to be higher, and lowered by where it is not: less than
/// the sole is clear of the line, so that a lower lift puts no foot into the floor.
std::vector<double> changeOf(const std::vector<double>& height, double factor, double frame_time) {
  std::vector<double> clear(height);
  for (double& h : clear) h = std::max(0.0, h);
  return factor < 1.0 ? curveUnder(clear, frame_time, kSmoothUnder)
                      : averaged(clear, frame_time, kSmooth);
}

void liftSwing(const Swing& swing, double factor, double heel, double frame_time, FootTrack& foot) {
  const std::vector<double> height = heights(swing, foot, heel);
  const std::vector<double> change = changeOf(height, factor, frame_time);
  const double lift = *std::max_element(height.begin(), height.end());
  const double most = *std::max_element(change.begin(), change.end());
  if (!(lift > 0.0)) return;
  // The largest share with which no frame gets over the lift that is asked for.
  double share = std::numeric_limits<double>::infinity();
  for (int i = swing.first(); i <= swing.last(); ++i) {
    if (change[i] > kTellsMost * most) {
      share = std::min(share, (factor * lift - height[i]) / change[i]);
    }
  }
  for (size_t i = 0; i < change.size(); ++i) {
    foot.move(static_cast<int>(i), {0.0, 0.0, share * change[i]});
  }
}

}  // namespace

void scaleLift(const CapturedWalk& walk, const std::function<double(int frame)>& factor,
               WalkTracks& tracks) {
  for (const Side side : {kLeft, kRight}) {
    const double heel = kAnkleHeightOfLeg * walk.roles.legLength(walk.clip.skeleton, side);
    const PlantMeasures* before = nullptr;
    for (const PlantMeasures& plant : walk.analysis.gait.plants) {
      if (plant.side != side) continue;
      if (before != nullptr) {
        const Swing swing{*before, plant};
        const double of_swing = factor((swing.first() + swing.last()) / 2);
        liftSwing(swing, of_swing, heel, walk.clip.frame_time, tracks.feet[side]);
      }
      before = &plant;
    }
  }
}

}  // namespace amble
