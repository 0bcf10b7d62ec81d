#include "planner/why/ground_profile.h"

#include <algorithm>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/steps/foothold.h"
#include "animation/steps/stride_law.h"
#include "animation/steps/unevenness.h"
#include "base/rotation.h"
#include "environments/scene/scene_pieces.h"

namespace amble {
namespace {

constexpr double kStep = 0.01;              // between places of the line [m]
constexpr double kHips = 0.55;              // of stature: what is higher is not stepped on
constexpr double kSeen = 1.5;               // down, to which ground is seen from an edge [m]
constexpr double kSteepFor = 0.1;           // what is shorter is an edge, and no slope [m]
constexpr double kRounding = 1e-4;          // of heights [m], of angles [rad]
constexpr double kRiser = 0.03;             // a lower step is none [m]
constexpr double kSteepest = 60 * kDegree;  // what is steeper is a wall [rad]

// What somebody at a height finds at a place of the line.
struct Spot {
  double height = 0.0;     // [m, World]
  double steepness = 0.0;  // of the surface [rad]
  int object = -1;
};

class Profile {
 public:
  Profile(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const PlanRequest& request)
      : from_(from),
        way_((to - from).head<2>()),
        length_(way_.norm()),
        ground_(*request.ground),
        synthesizer_(*request.synthesizer),
        scene_(request.world->scene()),
        limits_(ground_.settings().limits),
        height_(from.z()) {
    if (length_ > 0.0) way_ /= length_;
  }

  bool measure(Obstruction& why);
  bool highest(Obstruction& why);

 private:
  Eigen::Vector3d at(double s) const {
    const Eigen::Vector2d p = from_.head<2>() + s * way_;
    return {p.x(), p.y(), height_};
  }
  std::optional<Spot> spot(double s) const;
  void nameStep(const Spot& spot, Obstruction& why) const;
  bool isTooHigh(const Spot& spot, double s, Obstruction& why) const;
  bool isTooSteep(const Spot& spot, double s, Obstruction& why);
  bool isTooShort(const Spot& spot, double s, Obstruction& why);
  double edge(double on, double off) const;
  bool isBroken(double s, Obstruction& why) const;
  std::string name(int object) const {
    return object < 0 ? "" : objectName(scene_.objects[object]);
  }

  const Eigen::Vector3d from_;
  Eigen::Vector2d way_;
  const double length_;
  const SceneGround& ground_;
  const WalkSynthesizer& synthesizer_;
  const Scene& scene_;
  const GroundLimits& limits_;
  double height_;                     // of the ground so far [m]
  int object_ = -1;                   // that this ground is of
  std::optional<double> steep_from_;  // where it became too steep
  std::optional<double> riser_;       // the last
};

std::optional<Spot> Profile::spot(double s) const {
  const Eigen::Vector3d p = at(s);
  const double highest = height_ + kHips * synthesizer_.stature();
  std::optional<Spot> best;
  const auto& triangles = ground_.all().triangles();
  ground_.all().visitAt(p.x(), p.y(), [&](int triangle) {
    const double up = upwardness(triangles[triangle]);
    if (up < std::cos(kSteepest)) return;
    const auto height = heightOver(triangles[triangle], p.x(), p.y());
    if (!height || *height > highest || *height < height_ - kSeen) return;
    if (best && *height <= best->height) return;
    best = Spot{*height, std::acos(std::min(1.0, up)), ground_.pieces().pieceOf(triangle).object};
  });
  return best;
}

// From the ground so far: its edge is whose top is higher.
void Profile::nameStep(const Spot& spot, Obstruction& why) const {
  const bool down = spot.height < height_;
  why.lack = down ? Obstruction::Lack::kDrop : Obstruction::Lack::kStep;
  why.object = name(down ? object_ : spot.object);
}

bool Profile::isTooHigh(const Spot& spot, double s, Obstruction& why) const {
  const double rise = spot.height - height_;
  const double most = highestStep(limits_, rise > 0.0);
  if (spot.steepness > limits_.max_slope || std::abs(rise) <= most + kRounding) return false;
  why.rule = WalkRule::kStepHeight;
  nameStep(spot, why);
  why.at = at(s);
  why.width = std::abs(rise);
  why.needed = most;
  return true;
}

bool Profile::isTooSteep(const Spot& spot, double s, Obstruction& why) {
  if (spot.steepness <= limits_.max_slope + kRounding) {
    steep_from_.reset();
    return false;
  }
  if (!steep_from_) steep_from_ = s;
  if (s - *steep_from_ < kSteepFor) return false;
  why.rule = WalkRule::kSlope;
  why.lack = Obstruction::Lack::kSlope;
  why.object = name(spot.object);
  why.at = at(*steep_from_);
  why.slope = spot.steepness;
  why.max_slope = limits_.max_slope;
  return true;
}

// Of one riser to the next, both the same way.
bool Profile::isTooShort(const Spot& spot, double s, Obstruction& why) {
  const double rise = spot.height - height_;
  if (std::abs(rise) < kRiser) return false;
  const double needed =
      FootholdFinder::kLeastSupport * kFootLengthOfStature * synthesizer_.stature();
  const bool is_short = riser_ && s - *riser_ < needed - kStep;
  if (is_short) {
    why.rule = WalkRule::kFoothold;
    why.lack = Obstruction::Lack::kTread;
    why.object = name(spot.object);
    why.at = at(*riser_);
    why.width = s - *riser_;
    why.needed = needed;
  }
  riser_ = s;
  return is_short;
}

// Of two places, of which the one has ground, where that ends.
double Profile::edge(double on, double off) const {
  for (int halvings = 0; halvings < 8; ++halvings)
    (spot(0.5 * (on + off)) ? on : off) = 0.5 * (on + off);
  return on;
}

// The ground ends at s: is it too far to where it goes on?
bool Profile::isBroken(double s, Obstruction& why) const {
  double beyond = s;
  while (beyond < length_ && !spot(beyond)) beyond += kStep;
  s = edge(s - kStep, s);
  beyond = edge(beyond, beyond - kStep);
  if (beyond - s <= longestBreak(synthesizer_)) return false;
  why.rule = WalkRule::kNoGround;
  why.lack = Obstruction::Lack::kGround;
  why.at = at(s);
  why.width = beyond - s;
  why.needed = longestBreak(synthesizer_);
  return true;
}

bool Profile::measure(Obstruction& why) {
  for (double s = 0.0; s <= length_; s += kStep) {
    const auto here = spot(s);
    if (!here) {
      if (isBroken(s, why)) return true;
      while (s < length_ && !spot(s)) s += kStep;
      continue;
    }
    if (isTooHigh(*here, s, why) || isTooSteep(*here, s, why) || isTooShort(*here, s, why))
      return true;
    height_ = here->height;
    object_ = here->object;
  }
  return false;
}

bool Profile::highest(Obstruction& why) {
  double most = kRiser;
  for (double s = 0.0; s <= length_; s += kStep) {
    const auto here = spot(s);
    if (!here) continue;
    if (std::abs(here->height - height_) > most) {
      most = std::abs(here->height - height_);
      nameStep(*here, why);
      why.at = at(s);
      why.at.z() = std::min(here->height, height_);
      why.width = most;
    }
    height_ = here->height;
    object_ = here->object;
  }
  return most > kRiser;
}

}  // namespace

bool measureGround(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const PlanRequest& request, Obstruction& why) {
  return Profile(from, to, request).measure(why);
}

bool measureRise(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const PlanRequest& request,
                 Obstruction& why) {
  return Profile(from, to, request).highest(why);
}

double highestStep(const GroundLimits& limits, bool up) {
  return std::max(up ? limits.max_climb : limits.max_drop, Unevenness::kNatural);
}

double longestStep(const WalkSynthesizer& synthesizer) {
  return StrideLaw::kLongestStep * synthesizer.capturedStep();
}

// Either sole has so much of its length on the ground.
double longestBreak(const WalkSynthesizer& synthesizer) {
  const double sole = kFootLengthOfStature * synthesizer.stature();
  return longestStep(synthesizer) - 2.0 * (FootholdFinder::kLeastSupport - 0.5) * sole;
}

}  // namespace amble
