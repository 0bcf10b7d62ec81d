#include "batch/labels/caption.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"
#include "base/text.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

constexpr double kSlow = 0.8, kFast = 1.5;  // mean speed [m/s]
constexpr double kNear = 0.1;               // what is passed so near is told [m]
constexpr int kRoundTo = 5;                 // of turns [degrees]

std::string countWord(int count) {
  static const std::array<const char*, 13> words = {"no",   "one",    "two",   "three", "four",
                                                    "five", "six",    "seven", "eight", "nine",
                                                    "ten",  "eleven", "twelve"};
  return count < static_cast<int>(words.size()) ? words[static_cast<size_t>(count)]
                                                : std::to_string(count);
}

std::string doorsText(int doors) {
  if (doors == 0) return "";
  return doors == 1 ? " through a door" : " through " + countWord(doors) + " doors";
}

// The narrowest of the gaps that are no doors.
std::string gapText(const std::vector<PassedGap>& gaps) {
  const PassedGap* narrowest = nullptr;
  for (const PassedGap& gap : gaps)
    if (!gap.door && (narrowest == nullptr || gap.width < narrowest->width)) narrowest = &gap;
  if (narrowest == nullptr) return "";
  const std::string left = withoutControls(narrowest->left);
  const std::string right = withoutControls(narrowest->right);
  if (left == right) return " past " + left + " on both sides";
  return " between " + left + " and " + right;
}

std::string flightText(int steps) {
  const int count = std::abs(steps);
  if (steps > 0) return count == 1 ? "steps up once" : "climbs " + countWord(count) + " steps";
  return count == 1 ? "steps down once" : "goes down " + countWord(count) + " steps";
}

std::string turnText(const PassedThings& passed) {
  const auto round = [](double angle) {
    return static_cast<int>(std::lround(angle / kDegree / kRoundTo)) * kRoundTo;
  };
  const int left = round(passed.turned_left), right = round(passed.turned_right);
  constexpr int kTold = 30;  // [degrees]
  std::vector<std::string> turns;
  if (left >= kTold) turns.push_back(std::to_string(left) + " degrees to the left");
  if (right >= kTold) turns.push_back(std::to_string(right) + " degrees to the right");
  return turns.empty() ? "" : "turns " + joined(turns, " and ");
}

std::string mannerText(const RunResult& run) {
  const double speed = run.report.duration > 0.0 ? run.report.length / run.report.duration : 0.0;
  const WalkSpec& walk = run.problem->scenario.walk;
  std::string text = speed < kSlow ? " slowly" : speed > kFast ? " briskly" : "";
  if (!walk.style.empty()) text += " in the style " + withoutControls(walk.style);
  if (!walk.actions.empty())
    text += ", doing " + withoutControls(joined(walk.actions, ", ", " and "));
  return text;
}

}  // namespace

std::string captionOf(const RunResult& run, const PassedThings& passed) {
  const Report& report = run.report;
  const int doors = static_cast<int>(std::count_if(passed.gaps.begin(), passed.gaps.end(),
                                                   [](const PassedGap& gap) { return gap.door; }));
  std::vector<std::string> does = {"walks " + fixedNumber(report.length, 1) + " m" +
                                   mannerText(run) + doorsText(doors) + gapText(passed.gaps)};
  for (const int flight : passed.flights) does.push_back(flightText(flight));
  if (const std::string turns = turnText(passed); !turns.empty()) does.push_back(turns);
  const bool stops = run.problem->scenario.walk.to_standing;
  if (stops) does.push_back("stops");
  std::string text = "A person of " + fixedNumber(report.stature, 2) + " m " +
                     joined(does, ", ", " and ") + " after " + fixedNumber(report.duration, 1) +
                     " s.";
  const ClearanceReport& near = report.clearance;
  if (!near.object.empty() && near.min < kNear) {
    text += " The " + near.part + " passes " + withoutControls(near.object) + " at " +
            fixedNumber(100.0 * near.min, 0) + " cm.";
  }
  return text;
}

}  // namespace amble
