#include "app/edit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/editing/walk_path.h"
#include "base/rotation.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

/// From one print of a foot to its next, which stands as high on each.
struct PrintWay {
  double along = 0.0;  // up the ground's way, or where they lead [m]
  double rise = 0.0;   // [m]
};

/// Of whole plants, where a foot has two: at the clip's ends it is only seen coming down or
/// leaving, and that is higher.
std::vector<PrintWay> printWays(const GaitMeasures& gait, int frames,
                                const std::optional<Eigen::Vector2d>& heading) {
  std::vector<PrintWay> whole, all;
  std::array<const PlantMeasures*, 2> before = {nullptr, nullptr};
  const auto isWhole = [&](const PlantMeasures& plant) {
    return plant.plant.first > 0 && plant.plant.last < frames - 1;
  };
  for (const PlantMeasures& plant : gait.plants) {
    if (const PlantMeasures* from = before[plant.side]; from != nullptr) {
      const Eigen::Vector2d way = (plant.at - from->at).head<2>();
      const PrintWay pair{heading ? way.dot(*heading) : way.norm(),
                          plant.ends.ball.z() - from->ends.ball.z()};
      all.push_back(pair);
      if (isWhole(*from) && isWhole(plant)) whole.push_back(pair);
    }
    before[plant.side] = &plant;
  }
  return whole.empty() ? all : whole;
}

/// How steeply prints go up: the least squares' slope through nothing, so that those that go round
/// or back say as much.
double slopeOf(const std::vector<PrintWay>& ways) {
  double rise = 0.0, squares = 0.0;
  for (const PrintWay& way : ways) {
    rise += way.rise * way.along;
    squares += way.along * way.along;
  }
  return squares > 0.0 ? rise / squares : 0.0;
}

/// Of a tread: feet's own ways from print to print, over the treads that they go on by. (A step
/// from foot to foot is measured along the pelvis' way, which on short treads sways by a third.)
double goingOf(const std::vector<PrintWay>& ways, double asked) {
  double along = 0.0, treads = 0.0;
  for (const PrintWay& way : ways) {
    along += way.along;
    treads += std::round(way.along / asked);
  }
  return treads > 0.0 ? along / treads : 0.0;
}

/// Over the captured steps, each as long as it is, and where the root passes between its prints:
/// about when it strikes.
double meanFactor(const CapturedWalk& walk, const Ramp& factor) {
  std::vector<Eigen::Vector3d> root;
  for (int i = 0; i < walk.clip.frames(); ++i) root.push_back(walk.clip.poses.p_WR(i));
  const WalkPath path(root, walk.clip.frame_time);
  double sum = 0.0, length = 0.0;
  for (const StepMeasure& step : walk.analysis.gait.steps) {
    const int strike = static_cast<int>(std::lround(step.strike / walk.clip.frame_time));
    const int frame = std::clamp(strike, 0, path.frames() - 1);
    sum += step.stride * factor.at(path.share(frame));
    length += step.stride;
  }
  return length > 0.0 ? sum / length : factor.at(0.5);
}

double mid(const Ramp& ramp) { return ramp.at(0.5); }

std::string quantityLine(const char* label, double captured, const std::optional<double>& asked,
                         double achieved) {
  const std::string wanted = asked ? fmt::format("{:.3f} asked, ", *asked) : "";
  return fmt::format("{:<12} {:.3f} m captured, {}{:.3f} achieved", label, captured, wanted,
                     achieved);
}

Json quantity(double captured, const std::optional<double>& asked, double achieved) {
  return {{"captured", captured},
          {"asked", asked ? Json(*asked) : Json(nullptr)},
          {"achieved", achieved}};
}

/// Where slope or stairs lie, so that they can be made elsewhere.
Json groundJson(const EditRequest& request, const EditedGround& place) {
  Json ground = {{"origin", {place.origin.x(), place.origin.y()}},
                 {"heading", place.heading / kDegree}};
  if (request.incline) {
    ground["incline"] = {request.incline->from / kDegree, request.incline->to / kDegree};
  } else {
    ground["rise"] = place.stairs.rise;
    ground["going"] = place.stairs.going;
    ground["risers"] = place.stairs.count;
    ground["first_riser"] = place.stairs.start;
  }
  return ground;
}

}  // namespace

EditReport editReport(const CapturedWalk& walk, const EditRequest& request,
                      const EditedWalk& edited) {
  EditReport report;
  report.captured = walk.analysis.gait;
  const FootPlants plants = detectPlants(edited.clip, walk.roles);
  report.achieved = measureGait(edited.clip, walk.roles, plants);
  report.captured_stride = report.captured.step_length;
  report.achieved_stride = report.achieved.step_length;
  std::optional<Eigen::Vector2d> uphill;
  if (request.incline || request.stairs) {
    uphill = Eigen::Vector2d(std::cos(edited.place.heading), std::sin(edited.place.heading));
  }
  const int frames = edited.clip.frames();
  const std::vector<PrintWay> ways = printWays(report.achieved, frames, uphill);
  const double step = report.captured.step_length;
  const Ramp factor =
      request.stride ? request.stride->factorOf(step) : Ramp{edited.stride, edited.stride};
  const double incline = request.incline ? mid(*request.incline) : 0.0;
  // Where one arrives is seen from above already.
  const double from_above = request.arrive ? 1.0 : std::cos(incline);
  if (request.stride || request.arrive || request.incline) {
    report.asked_stride = step * meanFactor(walk, factor) * from_above;
  }
  if (request.stairs) {
    report.asked_stride = request.stairs->going;
    report.asked_rise = request.stairs->rise;
    report.achieved_stride = goingOf(ways, request.stairs->going);
  }
  if (request.incline) report.asked_rise = *report.asked_stride * std::tan(incline);
  report.captured_rise = step * slopeOf(printWays(report.captured, frames, std::nullopt));
  report.achieved_rise = report.achieved_stride * slopeOf(ways);
  if (request.lift) {
    const Ramp lift = request.lift->factorOf(report.captured.lift);
    report.asked_lift = report.captured.lift * mid(lift);
  }
  if (request.arrive) {
    const Eigen::Vector3d& end = edited.clip.poses.p_WR(edited.clip.frames() - 1);
    report.arrival_error = (end.head<2>() - *request.arrive).norm();
  }
  return report;
}

std::vector<std::string> editLines(const EditReport& report, const EditedWalk& edited) {
  std::vector<std::string> lines;
  const GaitMeasures &captured = report.captured, &achieved = report.achieved;
  if (!captured.steps.empty()) {
    lines = {
        quantityLine("stride", report.captured_stride, report.asked_stride, report.achieved_stride),
        quantityLine("lift", captured.lift, report.asked_lift, achieved.lift),
        quantityLine("rise a step", report.captured_rise, report.asked_rise, report.achieved_rise)};
  }
  if (report.arrival_error) {
    lines.push_back(fmt::format("{:<12} off by {:.1f} mm", "arrival", 1e3 * *report.arrival_error));
  }
  lines.push_back(fmt::format(
      "{:<12} {:.1f} mm captured, {:.1f} now; planted feet slide {:.0f} mm/s, {:.0f} now", "drift",
      1e3 * captured.largest_drift, 1e3 * achieved.largest_drift, 1e3 * captured.toe_skate,
      1e3 * achieved.toe_skate));
  lines.push_back(fmt::format("{:<12} {:.0f} mm lower at most", "hips", 1e3 * edited.fit.lowered));
  return lines;
}

Json editJson(const EditReport& report, const CapturedWalk& walk, const EditRequest& request,
              const EditedWalk& edited, const std::string& in, const std::string& out) {
  const GaitMeasures &captured = report.captured, &achieved = report.achieved;
  Json json;
  json["file"] = out;
  json["from"] = in;
  json["first_frame"] = walk.first_frame;
  json["frames"] = edited.clip.frames();
  json["frame_time"] = edited.clip.frame_time;
  json["steps"] = achieved.steps.size();
  json["stride"] = quantity(report.captured_stride, report.asked_stride, report.achieved_stride);
  json["lift"] = quantity(captured.lift, report.asked_lift, achieved.lift);
  json["rise"] = quantity(report.captured_rise, report.asked_rise, report.achieved_rise);
  json["arrival_error"] = report.arrival_error ? Json(*report.arrival_error) : Json(nullptr);
  json["drift"] = {{"captured", captured.largest_drift}, {"achieved", achieved.largest_drift}};
  json["toe_skate"] = {{"captured", captured.toe_skate}, {"achieved", achieved.toe_skate}};
  json["joint_jerk"] = {{"captured", captured.joint_jerk}, {"achieved", achieved.joint_jerk}};
  json["pops"] = {{"captured", captured.pops}, {"achieved", achieved.pops}};
  json["root_acceleration"] = {{"captured", captured.root_acceleration},
                               {"achieved", achieved.root_acceleration}};
  json["knee_backwards"] = achieved.knee_backwards;
  json["feet_moved_to_be_held"] = edited.lock_moved;
  json["hips_lowered"] = edited.fit.lowered;
  if (request.incline || request.stairs) json["ground"] = groundJson(request, edited.place);
  return json;
}

}  // namespace amble
