// amble analyse CLIP...: foot plants, gait, and QUALITY.md's measures of any clip.

#include <fmt/format.h>

#include <memory>

#include "animation/bvh.h"
#include "animation/error.h"
#include "animation/floor_fit.h"
#include "animation/foot_shape.h"
#include "animation/gait_measures.h"
#include "animation/rotation.h"
#include "app/command.h"
#include "app/findings.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  double unit = 0.0;  // [m]; 0: guessed
  std::string up = "y";
  bool as_is = false, json = false;
};

const char* sideName(Side side) { return side == kLeft ? "left" : "right"; }

struct Captured {
  Clip clip;
  JointRoles roles;
  FloorFit floor;
};

// In metres, and level unless it is to be taken as it is.
Captured readLevel(const std::string& file, const Options& options) {
  BvhReadOptions how;
  how.up = options.up == "y" ? UpAxis::kY : UpAxis::kZ;
  if (options.unit > 0.0) how.metres_per_unit = options.unit;
  Captured captured;
  captured.clip = readBvh(std::filesystem::path(file), how);
  captured.roles = guessJointRoles(captured.clip.skeleton, file);
  if (options.unit == 0.0) {
    how.metres_per_unit = guessUnit(captured.clip.skeleton, captured.roles);
    if (how.metres_per_unit != 1.0) captured.clip = readBvh(std::filesystem::path(file), how);
  }
  if (captured.clip.frames() == 0) throw InputError(file, 0, "holds no frames", "a motion");
  captured.floor = fitFloor(captured.clip, captured.roles);
  if (!options.as_is) {
    const double stature = statureOf(captured.clip.skeleton, captured.roles);
    const double ankle =
        captured.roles.legs[kLeft].toe >= 0
            ? makeFootShape(captured.clip.skeleton, captured.roles, kLeft, stature).ankle_height
            : 0.039 * stature;  // Drillis & Contini (1966)
    captured.clip = levelClip(captured.clip, captured.floor, ankle);
  }
  return captured;
}

void addGait(const GaitMeasures& gait, double frame_time, Findings& out) {
  out.facts.emplace_back(
      "walking",
      fmt::format("{:.2f} s to {:.2f} s: {:.3f} m/s, turning {:+.1f} degrees/s (at most "
                  "{:.1f}), {:.1f} steps a minute",
                  gait.begin * frame_time, gait.end * frame_time, gait.speed,
                  gait.turn_rate / kDegree, gait.peak_turn_rate / kDegree, gait.cadence));
  out.facts.emplace_back(
      "steps",
      fmt::format("{}: {:.3f} m long, {:.3f} m wide, lifted {:.3f} m, {:.3f} s; left against "
                  "right {:.2f} in length, {:.2f} in time",
                  gait.steps.size(), gait.step_length, gait.step_width, gait.lift, gait.step_time,
                  gait.length_asymmetry, gait.time_asymmetry));
  out.facts.emplace_back("support", fmt::format("double {:.3f}, flight {:.3f} of the time",
                                                gait.double_support, gait.flight));
  out.data["gait"] = {{"begin", gait.begin * frame_time},
                      {"end", gait.end * frame_time},
                      {"speed", gait.speed},
                      {"turn_rate", gait.turn_rate / kDegree},
                      {"peak_turn_rate", gait.peak_turn_rate / kDegree},
                      {"cadence", gait.cadence},
                      {"step_length", gait.step_length},
                      {"step_width", gait.step_width},
                      {"step_time", gait.step_time},
                      {"lift", gait.lift},
                      {"length_asymmetry", gait.length_asymmetry},
                      {"time_asymmetry", gait.time_asymmetry},
                      {"double_support", gait.double_support},
                      {"flight", gait.flight}};
}

void addQuality(const GaitMeasures& gait, Findings& out) {
  out.facts.emplace_back(
      "feet",
      fmt::format("toe skate {:.1f} mm/s, drift {:.1f} mm (at most {:.1f}), penetration {:.1f} mm",
                  1000.0 * gait.toe_skate, 1000.0 * gait.drift, 1000.0 * gait.largest_drift,
                  1000.0 * gait.penetration));
  out.facts.emplace_back(
      "smoothness",
      fmt::format(
          "root {:.2f} m/s2, jerk {:.1f} m/s3, pops {:.2f}, knee backwards {:.3f} of the time",
          gait.root_acceleration, gait.joint_jerk, gait.pops, gait.knee_backwards));
  out.data["quality"] = {{"toe_skate", gait.toe_skate},
                         {"drift", gait.drift},
                         {"largest_drift", gait.largest_drift},
                         {"penetration", gait.penetration},
                         {"root_acceleration", gait.root_acceleration},
                         {"joint_jerk", gait.joint_jerk},
                         {"pops", gait.pops},
                         {"knee_backwards", gait.knee_backwards},
                         {"bone_length_change", gait.bone_length_change}};
}

void addPlants(const GaitMeasures& gait, double frame_time, Findings& out) {
  std::array<int, 2> count = {0, 0};
  out.data["plants"] = Json::array();
  for (const PlantMeasures& plant : gait.plants) {
    ++count[plant.side];
    out.data["plants"].push_back({{"foot", sideName(plant.side)},
                                  {"strike", plant.plant.strike * frame_time},
                                  {"lift_off", plant.plant.lift_off * frame_time},
                                  {"at", {plant.at.x(), plant.at.y(), plant.at.z()}},
                                  {"drift", plant.drift}});
  }
  out.data["steps"] = Json::array();
  for (const StepMeasures& step : gait.steps) {
    out.data["steps"].push_back({{"foot", sideName(step.side)},
                                 {"begin", step.begin * frame_time},
                                 {"end", step.end * frame_time},
                                 {"length", step.length},
                                 {"width", step.width},
                                 {"lift", step.lift},
                                 {"rise", step.rise}});
  }
  out.facts.emplace_back("plants", fmt::format("{} left, {} right", count[kLeft], count[kRight]));
}

Findings analyse(const std::string& file, const Options& options) {
  const Captured captured = readLevel(file, options);
  const FootPlants plants = detectPlants(captured.clip, captured.roles);
  const GaitMeasures gait = measureGait(captured.clip, captured.roles, plants);
  Findings out{file, "clip", {}, {}, {}};
  const double tilt = std::acos(std::min(1.0, captured.floor.normal.z())) / kDegree;
  out.facts.emplace_back(
      "floor", fmt::format("tilted by {:.2f} degrees{}, ankles off it by {:.1f} mm", tilt,
                           options.as_is ? "" : ", levelled", 1000.0 * captured.floor.residual));
  out.data["floor_tilt"] = tilt;
  addPlants(gait, captured.clip.frame_time, out);
  addGait(gait, captured.clip.frame_time, out);
  addQuality(gait, out);
  if (gait.steps.empty()) out.warnings.push_back("no step was found");
  return out;
}

}  // namespace

void addAnalyse(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "analyse", "Measure clips: foot plants, speed, stride, lift, turn rate, quality");
  command->add_option("CLIP", options->files, "BVH files; - is standard input")->required();
  command->add_option("--unit", options->unit, "Length of the files' unit; default: from the legs")
      ->check(number(1e-6, 1e3, "m"));
  command->add_option("--up", options->up, "The files' vertical axis")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  command->add_flag("--as-is", options->as_is, "Do not level the fitted floor: it is z = 0");
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = [options] {
      std::vector<Findings> all;
      for (const std::string& file : options->files) all.push_back(analyse(file, *options));
      printFindings(all, options->json);
      return kExitDone;
    };
  });
}

}  // namespace amble
