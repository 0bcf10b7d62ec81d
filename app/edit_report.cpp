#include "app/edit_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

/// Of a mean step: as the prints of one foot, which stands as high on each, rise over their way.
double risePerStep(const GaitMeasures& gait) {
  std::array<const PlantMeasures*, 2> before = {nullptr, nullptr};
  double rise = 0.0, way = 0.0;
  for (const PlantMeasures& plant : gait.plants) {
    if (const PlantMeasures* from = before[plant.side]; from != nullptr) {
      rise += plant.ends.ball.z() - from->ends.ball.z();
      way += (plant.at - from->at).head<2>().norm();
    }
    before[plant.side] = &plant;
  }
  return way > 0.0 ? gait.step_length * rise / way : 0.0;
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
  report.captured_rise = risePerStep(report.captured);
  report.achieved_rise = risePerStep(report.achieved);
  const double step = report.captured.step_length;
  const double factor = request.stride ? mid(request.stride->factorOf(step)) : edited.stride;
  const double incline = request.incline ? mid(*request.incline) : 0.0;
  // Where one arrives is seen from above already.
  const double from_above = request.arrive ? 1.0 : std::cos(incline);
  if (request.stride || request.arrive || request.incline) {
    report.asked_stride = step * factor * from_above;
  }
  if (request.incline) report.asked_rise = *report.asked_stride * std::tan(incline);
  if (request.stairs) {
    report.asked_stride = request.stairs->going;
    report.asked_rise = request.stairs->rise;
  }
  if (request.lift) {
    report.asked_lift = report.captured.lift * mid(request.lift->factorOf(report.captured.lift));
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
        quantityLine("stride", captured.step_length, report.asked_stride, achieved.step_length),
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
  json["stride"] = quantity(captured.step_length, report.asked_stride, achieved.step_length);
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
