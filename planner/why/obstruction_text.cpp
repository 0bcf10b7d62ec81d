#include "planner/why/obstruction_text.h"

#include <cmath>
#include <cstdio>

#include "base/rotation.h"

namespace amble {
namespace {

using Lack = Obstruction::Lack;

constexpr double kInside = 0.005;  // nearer than that one is in it [m]

std::string metres(double value, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f m", digits, value);
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string placeText(const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = p + Eigen::Vector3d::Constant(1e-9);  // no -0.00
  char text[96];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", q.x(), q.y(), q.z());
  return text;
}

// In centimetres that would do: up where more is needed, down where less is.
double toDo(double needed, bool most) {
  constexpr double kCentimetre = 0.01, kRoundedBy = 1e-7;
  return kCentimetre * (most ? std::floor(needed / kCentimetre + kRoundedBy)
                             : std::ceil(needed / kCentimetre - kRoundedBy));
}

// So many digits that what there is does not look like what would do.
int digitsOf(double width, double needed) {
  return std::abs(std::round(width * 100) - std::round(needed * 100)) < 1.0 ? 3 : 2;
}

std::string wouldDo(const Obstruction& why) {
  if (!why.needed) return "";
  std::string text = "; " + metres(toDo(*why.needed, false)) + " would do";
  if (why.speed) text += " at " + number(*why.speed) + " m/s";
  return text;
}

std::string atMost(const Obstruction& why, const char* what) {
  if (!why.needed) return "";
  return "; at most " + metres(toDo(*why.needed, true)) + " is " + what;
}

// What a rule means, where nothing was touched: its name alone says little.
const char* meaningOf(WalkRule rule) {
  switch (rule) {
    case WalkRule::kNoCurve:
      return " (too near, or too sharp a turn, to walk)";
    case WalkRule::kBounds:
      return " (walks would leave the scenario's bounds)";
    case WalkRule::kStepLength:
      return " (no whole number of steps fits)";
    case WalkRule::kTurnRate:
      return " (a sharper turn than the library's walks)";
    case WalkRule::kReach:
      return " (a leg is too short)";
    case WalkRule::kFoothold:
      return " (no room for a whole sole)";
    default:
      return "";
  }
}

// Of what was not measured.
std::string unmeasured(const Obstruction& why) {
  if (why.rule == WalkRule::kDisconnected && !why.object.empty())
    return why.object + " shuts the way off at " + placeText(why.at) + ", and none leads around it";
  std::string text(walkRuleName(why.rule));
  text += meaningOf(why.rule);
  if (why.part.empty()) {
    if (!why.object.empty()) text += ": " + why.object;
  } else {
    text = why.part + " and " + why.object + " touch";
  }
  text += " at " + placeText(why.at);
  const double way = (why.body - why.at).norm();
  if (why.part.empty() && way > 0.0)
    text += ", on the way to " + placeText(why.body) + ", " + metres(way);
  if (why.gap > 0.0 && std::isfinite(why.gap)) text += ", " + metres(why.gap, 3) + " apart";
  return text;
}

std::string gapText(const Obstruction& why, const std::string& width, const std::string& at) {
  const std::string sides =
      why.other == why.object ? "two sides of " + why.object : why.object + " and " + why.other;
  return "the gap between " + sides + " is " + width + " wide" + at + wouldDo(why);
}

std::string stepText(const Obstruction& why, const std::string& width, const std::string& at) {
  if (!why.needed) return "a step of " + width + " is out of a leg's reach" + at;
  const bool down = why.lack == Lack::kDrop;
  if (why.object.empty())
    return "no ground leads from " + placeText(why.at) + " to " + placeText(why.body) + ", " +
           width + (down ? " lower" : " higher") +
           atMost(why, down ? "stepped down" : "stepped up");
  if (down)
    return "the ground beside " + why.object + " is " + width + " lower" + at +
           atMost(why, "stepped down");
  return why.object + " is " + width + " high" + at + atMost(why, "stepped over or climbed");
}

std::string measured(const Obstruction& why) {
  const int digits = why.width && why.needed ? digitsOf(*why.width, *why.needed) : 2;
  const std::string width = metres(why.width.value_or(0.0), digits),
                    at = " at " + placeText(why.at);
  switch (why.lack) {
    case Lack::kGap:
      return gapText(why, width, at);
    case Lack::kHeadroom:
      return why.object + " hangs " + width + " over the ground" + at + wouldDo(why);
    case Lack::kStep:
    case Lack::kDrop:
      return stepText(why, width, at);
    case Lack::kGround:
      return "the ground has a break of " + width + at + atMost(why, "stepped over");
    case Lack::kTread:
      return why.object + " is a step " + width + " deep, too short for a foot," + at +
             wouldDo(why);
    case Lack::kSlope:
      return why.object + " is " + number(std::round(*why.slope / kDegree)) + " degrees steep" +
             at + "; at most " + number(*why.max_slope / kDegree) + " are walked";
    case Lack::kDistance:
      if (*why.width < kInside) return "it is in " + why.object;
      return why.object + " is " + width + " away" + wouldDo(why);
    case Lack::kUnknown:
      break;
  }
  return unmeasured(why);
}

}  // namespace

std::string describe(const Obstruction& why) {
  std::string text = why.via ? "via[" + std::to_string(*why.via) + "] is blocked: " : "";
  text += measured(why);
  const bool is_told = why.lack == Lack::kGap || why.lack == Lack::kUnknown;
  if (is_told && why.overlap && !why.part.empty())
    text += "; the walk that came nearest had its " + why.part + " " + metres(*why.overlap, 3) +
            " in " + why.object;
  if (why.free) text += "; the nearest place that would do is " + placeText(*why.free);
  return text;
}

std::string_view lackName(Lack lack) {
  switch (lack) {
    case Lack::kUnknown:
      return "unknown";
    case Lack::kGap:
      return "gap";
    case Lack::kHeadroom:
      return "headroom";
    case Lack::kStep:
      return "step";
    case Lack::kDrop:
      return "drop";
    case Lack::kGround:
      return "ground";
    case Lack::kTread:
      return "tread";
    case Lack::kSlope:
      return "slope";
    case Lack::kDistance:
      return "distance";
  }
  return "unknown";
}

}  // namespace amble
