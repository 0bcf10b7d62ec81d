#include "app/analysis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/read_options.h"
#include "app/say.h"
#include "base/rotation.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSameLeg = 0.005;  // legs of one subject, relative: skeletons are written rounded
// Walks that say how frequency goes with speed: all of the clip, a whole cycle at least, steps of
// one time (as the captures' MANIFEST calls a walk steady).
constexpr double kAllWalk = 0.9;
constexpr size_t kFewestSteps = 2;
constexpr double kSteady = 0.15;

const char* sideName(Side side) { return side == kLeft ? "left" : "right"; }

double milli(double metres) { return 1000.0 * metres; }

/// "-" and null for what could not be measured.
std::string shareText(const std::optional<double>& share) {
  return share ? fmt::format("{:.2f}", *share) : "-";
}
Json orNull(const std::optional<double>& share) { return share ? Json(*share) : Json(nullptr); }

/// What was measured of so many steps: of none nothing was, whatever the number.
struct OfSteps {
  size_t count;
  std::string text(double value, int digits) const {
    return count == 0 ? "-" : fmt::format("{:.{}f}", value, digits);
  }
  Json json(double value) const { return count == 0 ? Json(nullptr) : Json(value); }
};

OfSteps stepsOf(const GaitMeasures& gait) { return {gait.steps.size()}; }
/// What a foot does from its last print to its next, of those swings that were seen whole.
OfSteps swingsOf(const GaitMeasures& gait) { return {gait.stride_length > 0.0 ? 1U : 0U}; }
OfSteps liftsOf(const GaitMeasures& gait) { return {gait.lift > 0.0 ? 1U : 0U}; }

/// Times and frames of the file from frames of the analysis.
struct FileTime {
  double frame_time;
  int first_frame;
  double operator()(double frame) const { return (frame + first_frame) * frame_time; }
};

FileTime timeOf(const AnalysedClip& clip) { return {clip.analysis.frame_time, clip.first_frame}; }

std::string sharesText(const ClipClass& kind) {
  std::string text;
  for (int i = 0; i < kMotionTypes; ++i) {
    if (kind.share[i] <= 0.0) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ",
                        motionTypeName(static_cast<MotionType>(i)), 100.0 * kind.share[i]);
  }
  return text;
}

void addReading(const AnalysedClip& clip, Findings& out) {
  const CapturedMotion& motion = clip.motion;
  const ClipAnalysis& analysis = clip.analysis;
  out.facts.emplace_back("frames",
                         fmt::format("{} of {:.7g} s", clip.file_frames, analysis.frame_time));
  if (analysis.frames() != clip.file_frames) {
    out.facts.back().second += fmt::format("; motion from {} to {}", clip.first_frame,
                                           clip.first_frame + analysis.frames() - 1);
  }
  addReadings(motion, out);
  const double tilt = std::acos(std::min(1.0, clip.floor.normal.z())) / kDegree;
  out.facts.emplace_back("floor",
                         fmt::format("tilted by {:.2f} degrees, ankles off it by {:.1f} mm", tilt,
                                     milli(clip.floor.residual)));
  out.data["frames"] = clip.file_frames;
  out.data["first_frame"] = clip.first_frame;
  out.data["last_frame"] = clip.first_frame + analysis.frames() - 1;
  out.data["floor_tilt"] = tilt;
}

void addKind(const AnalysedClip& clip, Findings& out) {
  const ClipClass& kind = clip.analysis.kind;
  const FileTime time = timeOf(clip);
  out.facts.emplace_back("type",
                         fmt::format("{}: {}", motionTypeName(kind.type), sharesText(kind)));
  Json shares = Json::object(), segments = Json::array();
  for (int i = 0; i < kMotionTypes; ++i) {
    if (static_cast<MotionType>(i) == MotionType::kOther) continue;
    shares[std::string(motionTypeName(static_cast<MotionType>(i)))] = kind.share[i];
  }
  for (const MotionSegment& segment : kind.segments) {
    segments.push_back({{"type", motionTypeName(segment.type)},
                        {"first_frame", segment.first + clip.first_frame},
                        {"last_frame", segment.last + clip.first_frame},
                        {"begin", time(segment.first)},
                        {"end", time(segment.last)}});
  }
  out.data["class"] = {
      {"type", motionTypeName(kind.type)}, {"share", shares}, {"segments", segments}};
}

void addGait(const AnalysedClip& clip, Findings& out) {
  const GaitMeasures& gait = clip.analysis.gait;
  const FileTime time = timeOf(clip);
  const OfSteps steps = stepsOf(gait), swings = swingsOf(gait), lifts = liftsOf(gait);
  out.facts.emplace_back(
      "walking",
      fmt::format("{:.2f} s to {:.2f} s: {:.3f} m/s ({:.2f} legs/s), turning {:+.1f} degrees/s (at "
                  "most {:.1f}), {} steps a minute",
                  time(gait.begin), time(gait.end), gait.speed, gait.normalised_speed,
                  gait.turn_rate / kDegree, gait.peak_turn_rate / kDegree,
                  steps.text(gait.cadence, 1)));
  out.facts.emplace_back(
      "steps",
      fmt::format("{}: {} m long, {} m wide, lifted {} m, toe {} m clear, {} "
                  "s; stride {} m; left against right {} in length, {} in time",
                  steps.count, steps.text(gait.step_length, 3), steps.text(gait.step_width, 3),
                  lifts.text(gait.lift, 3), swings.text(gait.toe_clearance, 3),
                  steps.text(gait.step_time, 3), swings.text(gait.stride_length, 3),
                  shareText(gait.length_asymmetry), shareText(gait.time_asymmetry)));
  out.facts.emplace_back("support", fmt::format("double {:.3f}, flight {:.3f} of the time",
                                                gait.double_support, gait.flight));
  out.data["gait"] = {{"begin", time(gait.begin)},
                      {"end", time(gait.end)},
                      {"speed", gait.speed},
                      {"leg_length", gait.leg_length},
                      {"normalised_speed", gait.normalised_speed},
                      {"turn_rate", gait.turn_rate / kDegree},
                      {"peak_turn_rate", gait.peak_turn_rate / kDegree},
                      {"cadence", steps.json(gait.cadence)},
                      {"cycle_frequency", steps.json(gait.cycle_frequency)},
                      {"step_length", steps.json(gait.step_length)},
                      {"step_width", steps.json(gait.step_width)},
                      {"step_time", steps.json(gait.step_time)},
                      {"step_time_variation", steps.json(gait.step_time_variation)},
                      {"stride_length", swings.json(gait.stride_length)},
                      {"lift", lifts.json(gait.lift)},
                      {"toe_clearance", swings.json(gait.toe_clearance)},
                      {"length_asymmetry", orNull(gait.length_asymmetry)},
                      {"time_asymmetry", orNull(gait.time_asymmetry)},
                      {"double_support", gait.double_support},
                      {"flight", gait.flight}};
  if (gait.steps.empty()) out.warnings.push_back("no step was found");
}

std::string lawText(const FrequencyFit& fit) {
  return fmt::format("f = {:.3f} V^{:.2f}{}", fit.law.factor, fit.law.power,
                     fit.own_power ? "" : " (Inman's power)");
}

std::string biasText(const SubjectLaw& law) {
  return fmt::format("Inman's {:+.0f} %, Glardon's {:+.0f} %",
                     100.0 * lawBias(kInmanLaw, law.walks),
                     100.0 * lawBias(kGlardonLaw, law.walks));
}

void addLaw(const SubjectLaw& law, Findings& out) {
  if (law.walks.empty()) return;
  const FrequencyFit& fit = law.fit;
  out.facts.emplace_back("frequency", fmt::format("{} of {} clip{}; {}", lawText(fit), fit.samples,
                                                  fit.samples == 1 ? "" : "s", biasText(law)));
  out.data["frequency_law"] = {{"factor", fit.law.factor},
                               {"power", fit.law.power},
                               {"own_power", fit.own_power},
                               {"clips", fit.samples},
                               {"residual", fit.residual},
                               {"inman_bias", lawBias(kInmanLaw, law.walks)},
                               {"glardon_bias", lawBias(kGlardonLaw, law.walks)}};
}

void addQuality(const GaitMeasures& gait, Findings& out) {
  out.facts.emplace_back(
      "feet",
      fmt::format("toe skate {:.1f} mm/s, drift {:.1f} mm (at most {:.1f}), penetration {:.1f} mm",
                  milli(gait.toe_skate), milli(gait.drift), milli(gait.largest_drift),
                  milli(gait.penetration)));
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

void addPlants(const AnalysedClip& clip, Findings& out) {
  const GaitMeasures& gait = clip.analysis.gait;
  const FileTime time = timeOf(clip);
  std::array<int, 2> count = {0, 0};
  out.data["plants"] = Json::array();
  for (const PlantMeasures& plant : gait.plants) {
    ++count[plant.side];
    out.data["plants"].push_back({{"foot", sideName(plant.side)},
                                  {"first_frame", plant.plant.first + clip.first_frame},
                                  {"last_frame", plant.plant.last + clip.first_frame},
                                  {"strike", time(plant.plant.strike)},
                                  {"lift_off", time(plant.plant.lift_off)},
                                  {"at", {plant.at.x(), plant.at.y(), plant.at.z()}},
                                  {"drift", plant.drift}});
  }
  out.data["steps"] = Json::array();
  const double cut_off = time(0.0);  // the analysis begins so long after the file
  for (const StepMeasure& step : gait.steps) {
    out.data["steps"].push_back({{"foot", sideName(step.side)},
                                 {"begin", cut_off + step.strike - step.duration},
                                 {"end", cut_off + step.strike},
                                 {"time", step.duration},
                                 {"length", step.stride},
                                 {"stride", step.two_steps},
                                 {"width", step.width},
                                 {"lift", step.lift},
                                 {"toe_clearance", step.toe_clearance},
                                 {"rise", step.climb},
                                 {"speed", step.speed},
                                 {"turn_rate", step.turn_rate / kDegree},
                                 {"double_support", step.double_support}});
  }
  out.facts.emplace_back("plants", fmt::format("{} left, {} right", count[kLeft], count[kRight]));
}

void addEvents(const AnalysedClip& clip, Findings& out) {
  const FileTime time = timeOf(clip);
  out.data["events"] = Json::array();
  for (const Side side : {kLeft, kRight}) {
    for (const SwingEvents& swing : clip.analysis.events.swings[side]) {
      out.data["events"].push_back(
          {{"foot", sideName(side)},
           {"lift", time(swing.lift)},
           {"lift_off", time(swing.lift_off)},
           {"strike", time(swing.strike)},
           {"landing", time(swing.landing)},
           {"heel", {{"lift", time(swing.heel.lift)}, {"landing", time(swing.heel.landing)}}},
           {"toe", {{"lift", time(swing.toe.lift)}, {"landing", time(swing.toe.landing)}}}});
    }
  }
}

bool sameSubject(const AnalysedClip& a, const AnalysedClip& b) {
  const double leg = a.analysis.gait.leg_length, other = b.analysis.gait.leg_length;
  return a.motion.clip.skeleton.size() == b.motion.clip.skeleton.size() &&
         std::abs(leg - other) <= kSameLeg * std::max(leg, other);
}

}  // namespace

std::vector<SubjectLaw> subjectLaws(const std::vector<AnalysedClip>& clips) {
  std::vector<SubjectLaw> laws;
  for (int i = 0; i < static_cast<int>(clips.size()); ++i) {
    if (!clips[i].good()) continue;
    const auto own = std::find_if(laws.begin(), laws.end(), [&](const SubjectLaw& law) {
      return sameSubject(clips[law.clips.front()], clips[i]);
    });
    SubjectLaw& law = own != laws.end() ? *own : laws.emplace_back();
    const GaitMeasures& gait = clips[i].analysis.gait;
    law.clips.push_back(i);
    law.leg_length = clips[law.clips.front()].analysis.gait.leg_length;
    const bool walks = clips[i].analysis.kind.shareOf(MotionType::kWalk) >= kAllWalk &&
                       gait.cycle_frequency > 0.0 && gait.normalised_speed > 0.0 &&
                       gait.steps.size() >= kFewestSteps && gait.step_time_variation < kSteady;
    if (walks) law.walks.push_back({gait.normalised_speed, gait.cycle_frequency});
  }
  for (SubjectLaw& law : laws) {
    if (!law.walks.empty()) law.fit = fitFrequencyLaw(law.walks);
  }
  return laws;
}

Findings describeAnalysis(const AnalysedClip& clip, const SubjectLaw& law) {
  Findings out{clip.file.string(), "clip", {}, {}, {}};
  addReading(clip, out);
  addKind(clip, out);
  addPlants(clip, out);
  addEvents(clip, out);
  addGait(clip, out);
  addLaw(law, out);
  addQuality(clip.analysis.gait, out);
  return out;
}

void printAnalysisTable(const std::vector<AnalysedClip>& clips,
                        const std::vector<SubjectLaw>& laws) {
  size_t width = 4;
  for (const AnalysedClip& clip : clips) width = std::max(width, clip.file.string().size());
  say(stdout,
      "{:<{}}  {:<7} {:>5} {:>7} {:>6} {:>6} {:>5} {:>6} {:>6} {:>6} {:>6} "
      "{:>6} {:>6} {:>6}\n",
      "clip", width, "type", "share", "seconds", "m/s", "legs/s", "deg/s", "st/min", "step",
      "stride", "lift", "clear", "double", "L/R");
  for (const AnalysedClip& clip : clips) {
    if (!clip.good()) continue;
    const GaitMeasures& gait = clip.analysis.gait;
    const OfSteps steps = stepsOf(gait);
    const ClipClass& kind = clip.analysis.kind;
    say(stdout,
        "{:<{}}  {:<7} {:>3.0f} % {:>7.2f} {:>6.2f} {:>6.2f} {:>+5.0f} {:>6} {:>6} {:>6} "
        "{:>6} {:>6} {:>6.3f} {:>6}\n",
        clip.file.string(), width, motionTypeName(kind.largest()),
        100.0 * kind.shareOf(kind.largest()), clip.analysis.frames() * clip.analysis.frame_time,
        gait.speed, gait.normalised_speed, gait.turn_rate / kDegree, steps.text(gait.cadence, 0),
        steps.text(gait.step_length, 3), swingsOf(gait).text(gait.stride_length, 3),
        liftsOf(gait).text(gait.lift, 3), swingsOf(gait).text(gait.toe_clearance, 3),
        gait.double_support, shareText(gait.time_asymmetry));
  }
  for (const SubjectLaw& law : laws) {
    if (law.walks.empty()) continue;
    say(stdout, "subject with legs of {:.3f} m, {} walk{}: {} (off by {:.1f} %); {}\n",
        law.leg_length, law.walks.size(), law.walks.size() == 1 ? "" : "s", lawText(law.fit),
        100.0 * law.fit.residual, biasText(law));
  }
}

void writePlantsCsv(std::ostream& out, const AnalysedClip& clip) {
  const std::vector<bool> left = clip.analysis.plants.planted(kLeft);
  const std::vector<bool> right = clip.analysis.plants.planted(kRight);
  out << "frame,left,right\n";
  for (int frame = 0; frame < clip.file_frames; ++frame) {
    const int i = frame - clip.first_frame;
    const bool motion = i >= 0 && i < clip.analysis.frames();
    out << frame << ',' << (motion && left[i] ? 1 : 0) << ',' << (motion && right[i] ? 1 : 0)
        << '\n';
  }
}

}  // namespace amble
