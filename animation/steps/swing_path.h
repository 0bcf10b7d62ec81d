/// The path of a swinging foot from print to print: the captured one, lifted (Shanbhag & Chandran
/// §3.3.2) and, where something lies in between, shaped to clear it.
///
/// The papers add a climb to the swing linearly (§3.3.3), which takes the foot through the nosing
/// of a stair; ours goes along the line between its prints and over that as high as it must.
#pragma once

#include <array>

#include "animation/body/foot_shape.h"
#include "animation/ground/ground.h"
#include "animation/steps/foot_blend.h"
#include "animation/steps/foot_state.h"

namespace amble {

/// What a swinging foot keeps between itself and what it passes over [m].
struct SwingMargins {
  /// Between sole and what it passes over, and ahead of the tip of the toes: twice what QUALITY.md
  /// asks for, since frames and cells are coarse. More, and thresholds are marched over.
  static constexpr double kOver = 0.025, kAhead = 0.015;
  /// Smooth ground leaves a print's plane by this times the distance squared [1/m], at most by
  /// kMostBent [m]: slopes to 15 degrees that come and go over 4 m are no obstacles.
  static constexpr double kBend = 0.25, kMostBent = 0.025;
  /// Within so much of the print behind, and of the print ahead, margins over its own ground grow
  /// from 0: toes leave it fast, and come down to it slowly.
  static constexpr double kLeaving = 0.04, kNear = 0.12;
  /// Over the edge of the tread that a foot comes down on, more than over the tread [m]: what
  /// QUALITY.md asks for; of a heel that comes down nearer behind it, this share of the way. So
  /// many cells are its edge.
  static constexpr double kNosing = 0.01, kNosingOfWay = 0.5;
  static constexpr int kNosingCells = 2;
  /// Of what there is before a riser that a foot stands near, the share that the tip keeps going
  /// up; all of it would ask feet to go straight up [0 to 1].
  static constexpr double kKeep = 0.75;
  /// That a foot moves before what lay beside it is in its way: a foot that stands against a wall
  /// goes up along it.
  static constexpr double kBeside = 0.03;
};

/// How swings are searched. By trial: finer gains nothing that is seen, coarser lifts feet by
/// centimetres more.
struct SwingSearch {
  static constexpr double kCell = 0.005;   ///< along the swing, for which heights are asked [m]
  static constexpr double kCoarse = 0.03;  ///< the same for a first look [m]
  /// Less is how coarse the cells are, and asks for no lift [m].
  static constexpr double kCoarseness = 0.001;
  /// So much higher than feet are lifted things are refused here, not left to the collision check;
  /// so much below the prints what lies between is looked for [m].
  static constexpr double kSeen = 0.1, kLowest = 0.4;
  /// Delays and early ends, and ramps up and down, that are tried (SwingShape) [shares of the
  /// swing].
  static constexpr std::array<double, 4> kDelays = {0.0, 0.1, 0.2, 0.3};
  static constexpr std::array<double, 4> kRamps = {0.6, 0.5, 0.4, 0.3};
  /// Of height, against accelerations; higher, and feet are thrown over low things [1].
  static constexpr double kLiftCost = 20.0;
};

/// Share of the way from print to print that is done at tau [0, 1].
double swingAlong(const SwingShape& shape, const FootBlend& cycle, double tau);
/// Height of the sole over the line from print to print [m].
double swingHeight(const SwingShape& shape, const FootBlend& cycle, double tau);
/// How to swing over what is there. Const: threads share it.
class SwingClearance {
 public:
  /// @param highest  extra lift that is tried at most [m, > 0]
  SwingClearance(const Ground& ground, const std::array<FootShape, 2>& feet, double highest)
      : ground_(ground), feet_(feet), highest_(highest) {}

  /// Changes `shape` so that the foot clears everything between the prints; leaves it where it does
  /// already. What goes on far above the highest lift is a wall, and for the collision check.
  /// @return false where no lift does.
  bool clear(const FootPlace& from, const FootPlace& to, Side side, const FootBlend& cycle,
             SwingShape& shape) const;

  /// Over level prints: clear() is false of whatever ends higher over both between them, up to
  /// highestSeen(), and of all of the captured height; at most that, for what ends nearest [m].
  double highestCleared(const FootBlend& cycle) const;
  /// Over the higher of two level prints: what ends higher is a wall [m].
  double highestSeen() const { return highest_ + SwingSearch::kSeen; }

 private:
  struct Strip;
  struct Ramps;
  Strip strip(const FootPlace& from, const FootPlace& to, Side side) const;
  static constexpr int kSamples = 40;  // of a swing
  using Needs = std::array<double, kSamples>;
  struct Moment;
  struct Course;
  static Moment momentAt(const Strip& strip, const FootBlend& cycle, const SwingShape& shape,
                         const Course& course, int k);
  static double needOver(const Strip& strip, const Moment& sole, int first, int last);
  static Needs needs(const Strip& strip, const FootBlend& cycle, const SwingShape& shape,
                     const Course& course);
  bool isFree(const FootPlace& from, const FootPlace& to, const FootShape& foot) const;

  const Ground& ground_;
  const std::array<FootShape, 2>& feet_;
  double highest_;
};

}  // namespace amble
