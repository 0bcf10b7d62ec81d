#include "animation/captures/unit_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace amble {
namespace {

// Thigh and shank of a stature (Winter: 0.491 of it) [1].
constexpr double kLegOfStature = 0.491;

// Legs of adults and of children of three years and more: means, deviations of their logarithms,
// and how many captures are of them; by judgement. What nobody has is not impossible.
constexpr double kAdultLeg = 0.83, kAdultSpread = 0.09, kAdults = 0.92;  // [m], [1], [1]
constexpr double kChildLeg = 0.60, kChildSpread = 0.22, kChildren = 0.08;
constexpr double kNobody = 1e-5;

// Shortest and longest legs of a person [m].
constexpr double kShortestLeg = 0.3, kLongestLeg = 1.15;

// Deviation of the logarithm of people's cadence about the usual one at their speed, and how little
// a cadence that is none, as of a wrong frame time, says [1].
constexpr double kCadenceSpread = 0.12, kCadenceDoubt = 0.2;

// Few walk faster than this, and people run from 0.7 on (Alexander: a Froude number of 0.5); a run
// says as little of the legs as a cadence that is none [sqrt(g leg)].
constexpr double kBriskSpeed = 0.6, kSpeedSpread = 0.1, kSpeedDoubt = 0.2, kGravity = 9.81;

// So many times likelier than the next, a unit is sure.
constexpr double kSure = 15.0;

// CMU captured at 120 frames a second: so seldom is its unit that of a file of another rate, from
// which an inch of a small child would be told by nothing else; by judgement [1].
constexpr double kCmuUnit = 0.056444, kOtherRate = 0.03, kSameRate = 0.02;

struct Unit {
  double metres;
  double share;  // of captures that come without their unit; by judgement
};
constexpr Unit kUnits[] = {{1.0, 0.3},   {0.01, 0.35}, {0.0254, 0.1}, {kCmuUnit, 0.1},
                           {0.001, 0.1}, {0.1, 0.02},  {0.3048, 0.02}};

// How many times a file's unit may be wrong: metres that are centimetres first of all.
constexpr Unit kSlips[] = {{0.01, 0.4},  {100.0, 0.4},    {0.001, 0.05},  {1000.0, 0.05},
                           {0.1, 0.02},  {10.0, 0.02},    {0.0254, 0.02}, {1.0 / 0.0254, 0.02},
                           {2.54, 0.01}, {1 / 2.54, 0.01}};

double bell(double value, double mean, double spread) {
  const double z = std::log(value / mean) / spread;
  return std::exp(-0.5 * z * z) / spread;
}

double likelihoodOfLeg(double leg) {
  return kAdults * bell(leg, kAdultLeg, kAdultSpread) +
         kChildren * bell(leg, kChildLeg, kChildSpread) +
         kNobody * std::exp(-std::abs(std::log(leg / kAdultLeg)));
}

double likelihoodOfCadence(const StepRhythm& rhythm, double leg) {
  const double over = cadenceOverUsual(rhythm, leg);
  return rhythm.speed >= kWalkingSpeed
             ? kCadenceSpread * bell(over, 1.0, kCadenceSpread) + kCadenceDoubt
             : 1.0;
}

double likelihoodOfSpeed(const StepRhythm& rhythm, double leg) {
  const double over =
      std::max(0.0, rhythm.speed * std::sqrt(leg / kGravity) - kBriskSpeed) / kSpeedSpread;
  return (1.0 - kSpeedDoubt) * std::exp(-0.5 * over * over) + kSpeedDoubt;
}

struct Candidate {
  double metres;      // a unit
  double leg;         // [m]
  double likelihood;  // of all [1]
};

Candidate candidate(const Unit& unit, double leg, const StepRhythm& rhythm, double frame_time) {
  const double length = leg * unit.metres;
  const bool other =
      unit.metres == kCmuUnit && std::abs(frame_time / kCmuFrameTime - 1.0) > kSameRate;
  return {unit.metres, length,
          unit.share * (other ? kOtherRate : 1.0) * likelihoodOfLeg(length) *
              likelihoodOfCadence(rhythm, length) * likelihoodOfSpeed(rhythm, length)};
}

bool isPersonsLeg(double leg) { return leg >= kShortestLeg && leg <= kLongestLeg; }

std::string tall(double leg) {
  const double stature = leg / kLegOfStature;
  return stature < 1.0 ? fmt::format("{:.2g} cm", 100.0 * stature)
                       : fmt::format("{:.3g} m", stature);
}

}  // namespace

Reading<double> guessUnit(double leg, const StepRhythm& rhythm, double frame_time) {
  if (!(leg > 0.0)) return {1.0, true, false, "1 m, guessed: the legs have no length"};
  std::vector<Candidate> ranked;
  for (const Unit& unit : kUnits) ranked.push_back(candidate(unit, leg, rhythm, frame_time));
  std::sort(ranked.begin(), ranked.end(),
            [](const Candidate& a, const Candidate& b) { return a.likelihood > b.likelihood; });
  const Candidate& best = ranked[0];
  Reading<double> unit{best.metres, true, true,
                       fmt::format("{:g} m, guessed: legs of {:.2f} m", best.metres, best.leg)};
  if (!isPersonsLeg(best.leg)) {
    unit.sure = false;
    unit.text += ", which nobody has";
  }
  const auto other = std::find_if(ranked.begin() + 1, ranked.end(), [&best](const Candidate& next) {
    return isPersonsLeg(next.leg) && next.likelihood * kSure > best.likelihood;
  });
  if (other != ranked.end()) {
    unit.sure = false;
    unit.text +=
        fmt::format("; or is it {:g} m, with legs of {:.2f} m?", other->metres, other->leg);
  }
  return unit;
}

Reading<double> checkSaidUnit(double metres_per_unit, double leg) {
  Reading<double> unit{metres_per_unit, false, true,
                       fmt::format("{:g} m, as the file says", metres_per_unit)};
  if (!(leg > 0.0) || isPersonsLeg(leg)) return unit;
  unit.sure = false;
  unit.text += fmt::format(", but that makes a person of {}", tall(leg));
  const Unit* const slip =
      std::max_element(std::begin(kSlips), std::end(kSlips), [leg](const Unit& a, const Unit& b) {
        return a.share * likelihoodOfLeg(leg * a.metres) <
               b.share * likelihoodOfLeg(leg * b.metres);
      });
  if (isPersonsLeg(leg * slip->metres)) {
    unit.text += fmt::format("; --unit {:g} makes one of {}", metres_per_unit * slip->metres,
                             tall(leg * slip->metres));
  }
  return unit;
}

}  // namespace amble
