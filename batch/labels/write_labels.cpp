#include "batch/labels/write_labels.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/rotation.h"
#include "batch/labels/caption.h"
#include "scenarios/problem.h"
#include "viz/exchange/walk_npz.h"

namespace amble {
namespace {

using LabelJson = nlohmann::ordered_json;

double inMicro(double value) {
  constexpr double kParts = 1e6;
  const double to = std::round(value * kParts) / kParts;
  return to == 0.0 ? 0.0 : to;
}

LabelJson pointJson(const Eigen::Vector3d& p) {
  return {inMicro(p.x()), inMicro(p.y()), inMicro(p.z())};
}

LabelJson gapsJson(const std::vector<PassedGap>& gaps) {
  LabelJson json = LabelJson::array();
  for (const PassedGap& gap : gaps) {
    json.push_back({{"kind", gap.door ? "door" : "gap"},
                    {"left", gap.left},
                    {"right", gap.right},
                    {"width", inMicro(gap.width)},
                    {"time", inMicro(gap.time)},
                    {"at", pointJson(gap.at)}});
  }
  return json;
}

LabelJson eventsJson(const FrameLabels& frames, double frame_time) {
  LabelJson json = LabelJson::array();
  for (const GaitEvent& event : frames.events) {
    json.push_back({{"foot", event.side == kLeft ? "left" : "right"},
                    {"event", event.strike ? "strike" : "lift_off"},
                    {"frame", event.frame},
                    {"time", inMicro(event.frame * frame_time)}});
  }
  return json;
}

// Stretches of frames in which the walker does one thing.
LabelJson activitiesJson(const FrameLabels& frames, double frame_time) {
  LabelJson json = LabelJson::array();
  for (int first = 0; first < frames.frames;) {
    const int32_t what = frames.activity[static_cast<size_t>(first)];
    int last = first;
    while (last + 1 < frames.frames && frames.activity[static_cast<size_t>(last) + 1] == what)
      ++last;
    json.push_back({{"activity", activityNames()[static_cast<size_t>(what)]},
                    {"from", inMicro(first * frame_time)},
                    {"to", inMicro(last * frame_time)}});
    first = last + 1;
  }
  return json;
}

LabelJson actionsJson(const RunResult& run) {
  LabelJson json = LabelJson::array();
  for (const std::string& action : run.problem->scenario.walk.actions)
    json.push_back({{"action", action}, {"from", 0.0}, {"to", inMicro(run.report.duration)}});
  return json;
}

LabelJson motionsJson(const std::vector<UsedMotion>& motions) {
  LabelJson json = LabelJson::array();
  for (const UsedMotion& used : motions) {
    const MotionSource& source = used.motion->source;
    json.push_back({{"motion", used.motion->name},
                    {"share", inMicro(used.share)},
                    {"clip", source.clip},
                    {"frames", source.frames},
                    {"mirrored", source.mirrored},
                    {"licence", source.licence},
                    {"credit", source.credit}});
    if (source.speed) json.back()["speed"] = inMicro(*source.speed);
  }
  return json;
}

LabelJson camerasJson(const std::vector<CameraView>& cameras) {
  LabelJson json = LabelJson::array();
  for (const CameraView& view : cameras) {
    json.push_back({{"position", pointJson(view.position)},
                    {"target", pointJson(view.target)},
                    {"field_of_view", inMicro(view.field_of_view / kDegree)},
                    {"seen", inMicro(view.seen)}});
  }
  return json;
}

void addEvents(const std::vector<GaitEvent>& events, NpyArchive& archive) {
  std::vector<int32_t> frames, sides;
  std::vector<uint8_t> strikes;
  for (const GaitEvent& event : events) {
    frames.push_back(event.frame);
    sides.push_back(event.side);
    strikes.push_back(event.strike ? 1 : 0);
  }
  archive.add("event_frames", frames, {frames.size()});
  archive.add("event_sides", sides, {sides.size()});
  archive.addBools("event_strikes", strikes, {strikes.size()});
}

}  // namespace

WalkLabels labelWalk(const RunResult& run, bool all) {
  WalkLabels labels;
  labels.frames = labelFrames(run, all);
  labels.passed = findPassed(run);
  labels.caption = captionOf(run, labels.passed);
  if (all) labels.cameras = suggestCameras(run);
  labels.motions = usedMotions(run, labels.frames);
  return labels;
}

void writeLabelsJson(std::ostream& out, const RunResult& run, const WalkLabels& labels) {
  const double frame_time = run.report.frame_time;
  const PassedThings& passed = labels.passed;
  const LabelJson json = {{"caption", labels.caption},
                          {"frame_time", run.report.frame_time},
                          {"frames", run.report.frames},
                          {"gaps", gapsJson(passed.gaps)},
                          {"flights", passed.flights},
                          {"turned_left", inMicro(passed.turned_left / kDegree)},
                          {"turned_right", inMicro(passed.turned_right / kDegree)},
                          {"turns_on_spot", passed.turns_on_spot},
                          {"activities", activitiesJson(labels.frames, frame_time)},
                          {"actions", actionsJson(run)},
                          {"gait_events", eventsJson(labels.frames, frame_time)},
                          {"motions", motionsJson(labels.motions)},
                          {"credits", creditsOf(labels.motions)},
                          {"cameras", camerasJson(labels.cameras)}};
  out << json.dump(1, ' ', false, LabelJson::error_handler_t::replace) << '\n';
}

void writeLabelsNpz(std::ostream& out, const RunResult& run, const WalkLabels& labels) {
  WalkView view;
  view.title = run.problem->scenario.name;
  view.skeleton = &run.problem->synthesizer.skeleton();
  view.body = &run.problem->body;
  view.animation = &run.outcome.walk.buffer;
  NpyArchive archive = walkArrays(view, run.report.joint_names);
  const FrameLabels& of = labels.frames;
  const auto frames = static_cast<size_t>(of.frames);
  std::vector<std::string> motions;
  for (const Motion* motion : of.motions) motions.push_back(motion->name);
  archive.addTexts("part_names", of.parts, {of.parts.size()});
  archive.addTexts("object_names", of.objects, {of.objects.size()});
  archive.add("clearance", of.clearance, {frames, of.parts.size()});
  archive.add("nearest", of.nearest, {frames, of.parts.size()});
  archive.addBools("contact", of.contact, {frames, of.parts.size()});
  archive.addTexts("activity_names", activityNames(), {activityNames().size()});
  archive.add("activity", of.activity, {frames});
  archive.addTexts("motion_names", motions, {motions.size()});
  archive.add("motion_shares", of.shares, {frames, motions.size()});
  addEvents(of.events, archive);
  archive.write(out);
}

}  // namespace amble
