#include "viz/page/library_bench.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "animation/body/foot_shape.h"
#include "animation/library/library_style.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/action.h"
#include "animation/synthesis/gait_blend.h"
#include "base/error.h"
#include "base/rotation.h"
#include "scenarios/captured_body.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kCycles = 2;                    // of a walk that are played
constexpr double kFrameTime = 1.0 / 60.0;     // [s]
constexpr double kHeld = 1.0;                 // for which a pose is shown [s]
constexpr int kCurve = 96;                    // points of a cycle's curve
constexpr int kOfAngles = 2, kOfLengths = 4;  // digits that can be seen
constexpr double kSlowest = 0.3;              // that the law of steps is drawn from [m/s]
constexpr int kLawPoints = 60;

bool isCycle(const Motion& motion) {
  return motion.kind == MotionKind::kWalk || motion.kind == MotionKind::kMovement;
}
bool isPose(const Motion& motion) {
  return motion.kind == MotionKind::kPosture || motion.kind == MotionKind::kBlocking;
}

// The line or circle of a walk at a time, and how it heads there.
Eigen::Vector2d wayAt(const WalkCycle& cycle, double time) {
  const double half = 0.5 * cycle.turn_rate * time, length = cycle.speed * time;
  const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
  return chord * Eigen::Vector2d(std::cos(half), std::sin(half));
}

// Pettré's eq. 2 put back on the line or circle that it was taken from.
Pose poseOf(const WalkCycle& cycle, const std::vector<Eigen::Quaterniond>& reference, double time) {
  const Eigen::VectorXd c = fourierAt(cycle.series, time / cycle.period);
  const double heading = cycle.turn_rate * time;
  Pose pose;
  pose.p_WR = aboutZ(heading) * Eigen::Vector3d(c[0], c[1], c[2]);
  pose.p_WR.head<2>() += wayAt(cycle, time);
  for (size_t j = 0; j < reference.size(); ++j) {
    const auto v = c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j));
    pose.rotations.push_back(reference[j] * expRotation(v));
  }
  pose.rotations[0] = aboutZ(heading) * pose.rotations[0];
  return pose;
}

// The straight walk, of no style, that a movement is laid over: that of the nearest speed.
const WalkCycle& walkUnder(const MotionLibrary& library, const Motion& movement) {
  const WalkCycle* nearest = &movement.cycle;
  double away = std::numeric_limits<double>::infinity();
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning || !motion.style.empty()) continue;
    const double off = std::abs(motion.cycle.speed - movement.cycle.speed);
    if (off < away) nearest = &motion.cycle;
    away = std::min(away, off);
  }
  return *nearest;
}

// What is played: of a movement the walk that it is laid over, as MovementController does.
const WalkCycle& playedCycle(const MotionLibrary& library, const Motion& motion) {
  return motion.kind == MotionKind::kMovement ? walkUnder(library, motion) : motion.cycle;
}

Clip clipOf(const MotionLibrary& library, const Motion& motion) {
  Clip clip{motion.name, library.skeleton, kFrameTime, PoseArray(library.skeleton.size()), {}};
  if (isPose(motion)) {
    clip.frame_time = kHeld;
    Pose pose;
    pose.p_WR = {motion.posture.root_forward, 0.0, motion.posture.root_height};
    pose.rotations = motion.posture.rotations;
    for (int i = 0; i < 2; ++i) clip.poses.append(pose);
    return clip;
  }
  const WalkCycle& walk = playedCycle(library, motion);
  const std::vector<Eigen::Quaterniond>& reference = library.stand().rotations;
  const int frames = static_cast<int>(std::lround(kCycles * walk.period / kFrameTime));
  clip.frame_time = kCycles * walk.period / frames;
  for (int i = 0; i <= frames; ++i) {
    const double phase = static_cast<double>(kCycles * i) / frames;
    Pose pose = poseOf(walk, reference, phase * walk.period);
    if (motion.kind == MotionKind::kMovement) {
      const Pose own = poseOf(motion.cycle, reference, phase * motion.cycle.period);
      for (const int j : movedJoints(library, motion)) pose.rotations[j] = own.rotations[j];
    }
    clip.poses.append(pose);
  }
  return clip;
}

// Who stands when, as the cycle's feet say.
FootPlants plantsOf(const MotionLibrary& library, const Motion& motion, const Clip& clip) {
  FootPlants plants;
  plants.frames = clip.frames();
  const int last = clip.frames() - 1;
  for (const Side side : {kLeft, kRight}) {
    if (isPose(motion)) {
      plants.plants[side].push_back({0, last, -0.5, last + 0.5});
      continue;
    }
    const WalkCycle& walk = playedCycle(library, motion);
    const FootCycle& foot = walk.feet[side];
    const double cycle = walk.period / clip.frame_time;
    const double stance = std::fmod(foot.lift_off - foot.strike + 1.0, 1.0);
    for (int k = -1; k <= kCycles; ++k) {
      const double strike = (foot.strike + k) * cycle, leaves = strike + stance * cycle;
      const int first = std::max(0, static_cast<int>(std::ceil(strike)));
      const int end = std::min(last, static_cast<int>(std::floor(leaves)));
      if (first <= end) plants.plants[side].push_back({first, end, strike, leaves});
    }
  }
  return plants;
}

ShownClip shownOf(const MotionLibrary& library, const Motion& motion) {
  ShownClip shown;
  shown.file = library.file.string();
  shown.name = motion.name;
  shown.motion.clip = clipOf(library, motion);
  shown.motion.roles = library.roles;
  shown.file_frames = shown.motion.clip.frames();
  shown.body = capturedBody(shown.motion.clip, library.roles, 0.0, library.stature);
  shown.analysis = ClipAnalysis{};
  shown.analysis->frame_time = shown.motion.clip.frame_time;
  shown.analysis->plants = plantsOf(library, motion, shown.motion.clip);
  return shown;
}

bool isThere(const std::filesystem::path& captures, const std::filesystem::path& file) {
  std::error_code ignored;
  return !captures.empty() && std::filesystem::is_regular_file(file, ignored);
}

std::string notThere(const Motion& motion) {
  return "The capture " + motion.source.clip + " is not there: --captures DIR says where";
}

// How walks begin and end, as they were captured; nothing where the capture is not there.
std::optional<ShownClip> capturedPart(const MotionLibrary& library, BenchMotion& bench,
                                      const std::filesystem::path& captures) {
  const MotionSource& source = bench.motion->source;
  const std::filesystem::path file = captures / source.clip;
  if (!isThere(captures, file)) {
    bench.lacking = notThere(*bench.motion);
    return std::nullopt;
  }
  try {
    ShownClip shown = readShownPart(file, {source.frames, source.mirrored});
    shown.file = library.file.string();
    shown.name = bench.motion->name;
    return shown;
  } catch (const InputError& error) {
    bench.lacking = error.what();
    return std::nullopt;
  }
}

BenchMotion benchMotionOf(const MotionLibrary& library, const Motion& motion,
                          const std::filesystem::path& captures) {
  BenchMotion bench{&motion, {}, ""};
  if (!isCycle(motion)) return bench;
  const std::filesystem::path file = captures / motion.source.clip;
  if (!isThere(captures, file)) {
    bench.lacking = notThere(motion);
    return bench;
  }
  try {
    bench.captured = capturedCycles(library, motion, file);
  } catch (const InputError& error) {
    bench.lacking = error.what();
  }
  return bench;
}

// A channel of a series over its cycle, from phase 0 to 1.
std::vector<double> curveOf(const FourierSeries& series, int channel, double unit) {
  std::vector<double> curve;
  for (int i = 0; i <= kCurve; ++i) {
    const double phase = static_cast<double>(i) / kCurve;
    double value = 0.0;
    for (int k = 0; k <= series.harmonics(); ++k) {
      value += series.alpha(channel, k) * std::cos(2.0 * kPi * k * phase) +
               series.beta(channel, k) * std::sin(2.0 * kPi * k * phase);
    }
    curve.push_back(value / unit);
  }
  return curve;
}

Json channelJson(const BenchMotion& bench, int channel, const NumbersText& numbers) {
  const double unit = channel < 3 ? 1.0 : kDegree;
  const int digits = channel < 3 ? kOfLengths : kOfAngles;
  const auto curve = [&](const FourierSeries& series) {
    return Json::parse(numbers(curveOf(series, channel, unit), digits));
  };
  Json captured = Json::array();
  for (const FourierSeries& series : bench.captured) captured.push_back(curve(series));
  return {{"fourier", curve(bench.motion->cycle.series)}, {"captured", std::move(captured)}};
}

// Curves over the phase: of the root's errors around its line or circle [m], and of each joint's
// rotation vector against the stance [degrees].
Json cycleJson(const BenchMotion& bench, const NumbersText& numbers) {
  const char* const errors[] = {"forward", "left", "height"};
  const char* const axes[] = {"x", "y", "z"};
  Json root = Json::object(), joints = Json::array();
  for (int i = 0; i < 3; ++i) root[errors[i]] = channelJson(bench, i, numbers);
  for (int channel = 3; channel < bench.motion->cycle.series.channels(); channel += 3) {
    Json joint = Json::object();
    for (int i = 0; i < 3; ++i) joint[axes[i]] = channelJson(bench, channel + i, numbers);
    joints.push_back(std::move(joint));
  }
  return {{"points", kCurve + 1}, {"root", std::move(root)}, {"joints", std::move(joints)}};
}

Json measuresJson(const WalkCycle& cycle) {
  return {{"speed", cycle.speed},
          {"turn_rate", cycle.turn_rate / kDegree},
          {"period", cycle.period},
          {"step_length", cycle.stepLength()},
          {"double_support", cycle.doubleSupport()},
          {"step_width", cycle.step_width},
          {"toe_out", {cycle.toe_out[kLeft] / kDegree, cycle.toe_out[kRight] / kDegree}},
          {"cycles", cycle.cycles},
          {"harmonics", cycle.series.harmonics()},
          {"closure", cycle.closure},
          {"residual", cycle.residual / kDegree},
          {"slide", cycle.slide},
          {"slip", {cycle.feet[kLeft].slip, cycle.feet[kRight].slip}}};
}

std::string validText(const Validity& valid) {
  switch (valid.when) {
    case Validity::When::kAtStart:
      return "at the start";
    case Validity::When::kAtEnd:
      return "at the end";
    case Validity::When::kBetween:
      return "at some times";
    case Validity::When::kClearanceAbove:
      return "where there is room";
    default:
      return "always";
  }
}

Json motionJson(const BenchMotion& bench, const NumbersText& numbers) {
  const Motion& motion = *bench.motion;
  const MotionSource& source = motion.source;
  Json json = {{"name", motion.name},
               {"kind", motionKindNames()[static_cast<size_t>(motion.kind)]},
               {"turning", motion.turning},
               {"valid", validText(motion.valid)},
               {"chains", motion.chains},
               {"source",
                {{"clip", source.clip},
                 {"frames", {source.frames[0], source.frames[1]}},
                 {"mirrored", source.mirrored},
                 {"licence", source.licence},
                 {"credit", source.credit}}}};
  if (source.speed) json["source"]["speed"] = *source.speed;
  if (isCycle(motion)) {
    json["measures"] = measuresJson(motion.cycle);
    json["cycle"] = cycleJson(bench, numbers);
  }
  if (motion.kind == MotionKind::kStart || motion.kind == MotionKind::kStop) {
    json["transition"] = {{"speed", motion.transition.speed},
                          {"first_speed", motion.transition.first_speed},
                          {"acceleration", motion.transition.acceleration}};
  }
  if (motion.kind == MotionKind::kTurnOnSpot) {
    json["turn"] = {{"angle", motion.turn.angle / kDegree},
                    {"duration", motion.turn.duration},
                    {"steps", motion.turn.steps},
                    {"first", motion.turn.first == kLeft ? "left" : "right"},
                    {"twist", motion.turn.twist / kDegree}};
  }
  if (!bench.lacking.empty()) json["lacking"] = bench.lacking;
  return json;
}

// Step length over speed, through the straight walks of no style; nothing where there is none.
Json stepLawJson(const MotionLibrary& library, const NumbersText& numbers) {
  const MotionLibrary plain = inStyle(library, "");
  if (!whatItLacks(plain).problem.empty()) return nullptr;
  Json points = Json::array();
  double fastest = 0.0;
  for (const Motion& motion : plain.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning) continue;
    points.push_back({{"name", motion.name},
                      {"speed", motion.cycle.speed},
                      {"step", motion.cycle.stepLength()}});
    fastest = std::max(fastest, motion.cycle.speed);
  }
  const GaitBlend blend(plain, 1.0);
  std::vector<double> speeds, steps;
  for (int i = 0; i <= kLawPoints; ++i) {
    speeds.push_back(kSlowest + (1.25 * fastest - kSlowest) * i / kLawPoints);
    steps.push_back(blend.law().stepLength(speeds.back()));
  }
  return {{"speeds", Json::parse(numbers(speeds, kOfLengths))},
          {"steps", Json::parse(numbers(steps, kOfLengths))},
          {"points", std::move(points)},
          {"first_speed", blend.law().onset().first_speed},
          {"acceleration", blend.law().onset().acceleration}};
}

}  // namespace

BenchLibrary benchOfLibrary(const MotionLibrary& library, const std::filesystem::path& captures) {
  BenchLibrary bench;
  bench.library = &library;
  std::vector<BenchMotion> unplayed;
  for (const Motion& motion : library.motions) {
    BenchMotion one = benchMotionOf(library, motion, captures);
    std::optional<ShownClip> shown;
    if (isCycle(motion) || isPose(motion)) {
      shown = shownOf(library, motion);
    } else {
      shown = capturedPart(library, one, captures);
    }
    if (shown) bench.clips.push_back(std::move(*shown));
    (shown ? bench.motions : unplayed).push_back(std::move(one));
  }
  std::move(unplayed.begin(), unplayed.end(), std::back_inserter(bench.motions));
  return bench;
}

std::string benchLibraryJson(const BenchLibrary& bench, const NumbersText& numbers) {
  Json motions = Json::array();
  for (const BenchMotion& motion : bench.motions) motions.push_back(motionJson(motion, numbers));
  const Json json = {{"file", bench.library->file.string()},
                     {"stature", bench.library->stature},
                     {"motions", std::move(motions)},
                     {"step_law", stepLawJson(*bench.library, numbers)}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string motionAnalysisJson(const Motion& motion, const ShownClip& clip) {
  Json plants = Json::array();
  const double frame_time = clip.motion.clip.frame_time;
  for (const Side side : {kLeft, kRight}) {
    if (!clip.analysis) continue;  // nobody is found in the capture
    for (const FootPlant& plant : clip.analysis->plants.plants[side])
      plants.push_back({{"foot", side == kLeft ? "left" : "right"},
                        {"strike", (plant.strike + clip.first_frame) * frame_time},
                        {"lift_off", (plant.lift_off + clip.first_frame) * frame_time}});
  }
  Json json = {{"class", {{"type", motionKindNames()[static_cast<size_t>(motion.kind)]}}},
               {"gait", Json::object()},
               {"plants", std::move(plants)}};
  if (isCycle(motion)) {
    json["gait"] = {{"speed", motion.cycle.speed},
                    {"turn_rate", motion.cycle.turn_rate / kDegree},
                    {"cadence", 120.0 / motion.cycle.period},
                    {"step_length", motion.cycle.stepLength()}};
  }
  return json.dump();
}

}  // namespace amble
