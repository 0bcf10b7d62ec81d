#include "animation/preparation/speed_engine_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/foot_plants.h"
#include "animation/body/rest_feet.h"
#include "animation/body/rotation_mean.h"
#include "animation/clips/loop_clip.h"
#include "animation/library/harmonics.h"
#include "animation/preparation/cycle_samples.h"
#include "animation/preparation/foot_cycle_fit.h"
#include "animation/preparation/gait_space_fit.h"
#include "animation/preparation/heel_rise_fit.h"
#include "animation/preparation/library_soles.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

// Legs that differ by more are another person's: marker sets of one person give the same to a few
// millimetres [1].
constexpr double kSameLegs = 0.02;
constexpr double kStandsFor = 0.3;  // that a standing posture is the mean of [s]
constexpr int kFewestClips = 3;     // to leave one out and fit a line to the others

// Cycles of one gait, and the clips that they are from.
struct Captured {
  std::vector<EngineCycle> cycles;
  std::vector<EngineClip> clips;
};

// The samples of a cycle without what its capture shakes (kMaxHarmonics), nor the edge where its
// ends are put together.
FourierSeries seriesOf(const Eigen::MatrixXd& samples) {
  std::vector<double> phases;
  for (Eigen::Index i = 0; i < samples.cols(); ++i) {
    phases.push_back(static_cast<double>(i) / static_cast<double>(samples.cols()));
  }
  return fitFourier(samples, phases, kMaxHarmonics);
}

Eigen::MatrixXd samplesOf(const FourierSeries& series, Eigen::Index count) {
  Eigen::MatrixXd samples(series.channels(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    samples.col(i) = fourierAt(series, static_cast<double>(i) / static_cast<double>(count));
  }
  return samples;
}

// The root's way and where feet are put down, as libraries' walks have it: so that feet stay.
void takeFeet(const GaitTrack& track, const Stretch& stretch, const MotionLibrary& rig,
              const std::string& clip, const FourierSeries& series, EngineCycle& cycle) {
  WalkCycle walk;
  walk.speed = cycle.speed;
  walk.period = cycle.period;
  walk.series = series;
  walk.step_width = cycle.step_width;
  walk.toe_out = cycle.toe_out;
  for (const Side side : {kLeft, kRight}) {
    FootCycle& foot = walk.feet[side];
    foot = fitFootCycle(track, side, rig.feet()[side], stretch, clip);
    walk.foot_forward[side] = cycle.foot_forward[side] - 0.5 * foot.slip;
  }
  fitHeelRise(rig.skeleton, rig.roles, rig.feet(), rig.stand().rotations, walk);
  cycle.channels = samplesOf(walk.series, cycle.channels.cols());
  cycle.foot_forward = walk.foot_forward;
}

// What a walk's mean cycle stands on, by Side [rad].
std::array<double, 2> walkedDrops(const MotionLibrary& rig, const Clip& level,
                                  const std::string& name) {
  const auto& reference = rig.stand().rotations;
  const WalkCycle mean =
      prepareWalkCycle(level, rig.roles, rig.feet(), reference, {name, false, kMaxHarmonics, {}});
  return standingDrops(mean, level.skeleton, rig.roles, reference);
}

// A capture, and what is done in it.
struct Seen {
  const EngineCapture* from;
  LevelCapture capture;
  ClipClass kind;
  int frames;  // of the capture; more are in the clip of a loop, which is walked on

  const Clip& clip() const { return capture.motion.clip; }
  std::string file() const { return from->file.string(); }
};

// `level` is on the engine's skeleton.
void takeCycles(const MotionLibrary& rig, const Clip& level, const Seen& seen, Gait gait,
                Captured& out) {
  const EngineCapture& from = *seen.from;
  const int first_frame = seen.capture.first_frame;
  const std::array<FootShape, 2> feet = rig.feet();
  const GaitTrack track(level, rig.roles, feet);
  const CycleOptions options{from.file.string(), false, 0, {}};
  EngineClip clip;
  clip.capture = measureCapture(level, rig.roles);
  clip.source = {from.clip, {first_frame + level.frames(), 0}, false, from.licence, from.credit};
  for (const Stretch& stretch : findStretches(track, options, gait)) {
    const CycleSamples samples =
        sampleCycle(track, stretch, gait, rig.stand().rotations, kEnginePhases);
    clip.speed += samples.speed;
    clip.frequency += 1.0 / samples.period;
    clip.cycles += 1;
    auto& frames = clip.source.frames;
    frames[0] = std::min(frames[0], first_frame + static_cast<int>(stretch.begin));
    frames[1] = std::max(frames[1], first_frame + static_cast<int>(stretch.end));
    const FourierSeries series = seriesOf(samples.channels);
    EngineCycle cycle{static_cast<int>(out.clips.size()),
                      samples.speed,
                      samples.period,
                      samplesOf(series, samples.channels.cols()),
                      samples.support,
                      samples.step_width,
                      samples.foot_forward,
                      samples.toe_out};
    if (gait == Gait::kWalk) takeFeet(track, stretch, rig, options.clip, series, cycle);
    out.cycles.push_back(std::move(cycle));
  }
  if (seen.frames < level.frames())
    clip.source.frames = {first_frame, first_frame + seen.frames - 1};
  clip.speed /= clip.cycles;
  clip.frequency /= clip.cycles;
  out.clips.push_back(std::move(clip));
}

// The rotations of all cycles are mostly near their mean, which rotation vectors are against.
std::vector<Eigen::Quaterniond> meanPosture(const std::array<Captured, 2>& gaits,
                                            const std::vector<Eigen::Quaterniond>& reference) {
  std::vector<RotationMean> sums(reference.size());
  for (const Captured& gait : gaits) {
    for (const EngineCycle& cycle : gait.cycles) {
      for (size_t j = 0; j < reference.size(); ++j) {
        const auto vectors = cycle.channels.middleRows<3>(3 + 3 * static_cast<Eigen::Index>(j));
        for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
          sums[j].add(reference[j] * expRotation(vectors.col(i)));
        }
      }
    }
  }
  std::vector<Eigen::Quaterniond> mean;
  for (const RotationMean& sum : sums) mean.push_back(sum.mean());
  return mean;
}

void rebase(const std::vector<Eigen::Quaterniond>& from, const std::vector<Eigen::Quaterniond>& to,
            std::vector<EngineCycle>& cycles) {
  for (EngineCycle& cycle : cycles) {
    for (size_t j = 0; j < from.size(); ++j) {
      const Eigen::Quaterniond turn = to[j].conjugate() * from[j];
      auto vectors = cycle.channels.middleRows<3>(3 + 3 * static_cast<Eigen::Index>(j));
      for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
        vectors.col(i) = logRotation(turn * expRotation(vectors.col(i)));
      }
    }
  }
}

// Root mean square of the angles between the rotations of two motion vectors, over these joints.
double angleBetween(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                    const std::vector<int>& joints) {
  double squares = 0.0;
  for (const int j : joints) {
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
      const Eigen::Quaterniond p = expRotation(a.col(i).segment<3>(3 * j));
      const Eigen::Quaterniond q = expRotation(b.col(i).segment<3>(3 * j));
      squares += std::pow(p.angularDistance(q), 2);
    }
  }
  return std::sqrt(squares / static_cast<double>(joints.size() * static_cast<size_t>(a.cols())));
}

struct JudgedJoints {
  std::vector<int> all, legs;
};

JudgedJoints judgedJoints(const Skeleton& skeleton, const JointRoles& roles) {
  const auto beyondWrist = [&](int joint) {
    return std::any_of(roles.arms.begin(), roles.arms.end(), [&](const ArmJoints& arm) {
      return arm.hand >= 0 && joint != arm.hand && skeleton.isAncestor(arm.hand, joint);
    });
  };
  JudgedJoints joints;
  for (int j = 0; j < skeleton.size(); ++j) {
    if (!beyondWrist(j)) joints.all.push_back(j);
  }
  for (const LegJoints& leg : roles.legs) {
    joints.legs.insert(joints.legs.end(), {leg.up_leg, leg.leg, leg.foot, leg.toe});
  }
  return joints;
}

Eigen::MatrixXd meanVector(const std::vector<EngineCycle>& cycles, int clip) {
  Eigen::MatrixXd sum;
  double count = 0.0;
  for (const EngineCycle& cycle : cycles) {
    if (cycle.clip != clip) continue;
    const Eigen::MatrixXd vector = cycle.channels.bottomRows(cycle.channels.rows() - 3);
    sum = count == 0.0 ? vector : Eigen::MatrixXd(sum + vector);
    count += 1.0;
  }
  return sum / count;
}

// The other clip whose speed is nearest.
int nearestClip(const std::vector<EngineClip>& clips, int to) {
  int nearest = to == 0 ? 1 : 0;
  for (int i = 0; i < static_cast<int>(clips.size()); ++i) {
    const double away = std::abs(clips[i].speed - clips[to].speed);
    if (i != to && away < std::abs(clips[nearest].speed - clips[to].speed)) nearest = i;
  }
  return nearest;
}

// A clip against the engine that has not seen it, and against the one next to it in speed.
LeftOut leaveOut(const Captured& gait, int out, const JudgedJoints& joints, double leg,
                 double variance) {
  std::vector<EngineCycle> others;
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
  for (const EngineCycle& cycle : gait.cycles) {
    if (cycle.clip == out) continue;
    others.push_back(cycle);
    slowest = std::min(slowest, gait.clips[cycle.clip].speed);
    fastest = std::max(fastest, gait.clips[cycle.clip].speed);
  }
  const double speed = gait.clips[out].speed;
  const Eigen::MatrixXd captured = meanVector(gait.cycles, out);
  const Eigen::MatrixXd fitted =
      motionVectorAt(fitGaitSpace(others, leg, variance), std::clamp(speed, slowest, fastest));
  const Eigen::MatrixXd beside = meanVector(gait.cycles, nearestClip(gait.clips, out));
  return {speed > slowest && speed < fastest, angleBetween(captured, fitted, joints.all),
          angleBetween(captured, fitted, joints.legs), angleBetween(captured, beside, joints.all),
          angleBetween(captured, beside, joints.legs)};
}

// The space of a gait's cycles, its clips judged and sorted.
GaitSpace spaceOf(const MotionLibrary& rig, double variance, Captured& gait) {
  const double leg = rig.roles.meanLeg(rig.skeleton);
  const JudgedJoints judged = judgedJoints(rig.skeleton, rig.roles);
  const int clips = static_cast<int>(gait.clips.size());
  for (int i = 0; clips >= kFewestClips && i < clips; ++i) {
    gait.clips[i].left_out = leaveOut(gait, i, judged, leg, variance);
  }
  GaitSpace space = fitGaitSpace(gait.cycles, leg, variance);
  space.clips = std::move(gait.clips);
  std::stable_sort(space.clips.begin(), space.clips.end(),
                   [](const EngineClip& a, const EngineClip& b) { return a.speed < b.speed; });
  return space;
}

bool showsCycle(const Clip& clip, const JointRoles& roles, const std::string& file) {
  const GaitTrack track(clip, roles,
                        makeFootShapes(clip.skeleton, roles, statureOf(clip.skeleton, roles)));
  const CycleOptions options{file, false, 0, {}};
  return !wholeCycles(track, options, Gait::kWalk).empty() ||
         !wholeCycles(track, options, Gait::kRun).empty();
}

using Warnings = std::vector<std::string>;

// A loop that is one cycle is walked on, so that whole cycles are in it.
Seen see(const EngineCapture& from, Warnings& warnings) {
  LevelCapture capture = readForLibrary(from.file, from.read, &warnings);
  Clip& clip = capture.motion.clip;
  const JointRoles& roles = capture.motion.roles;
  const int frames = clip.frames();
  const auto kind = [&] { return classifyClip(detectPlants(clip, roles), clip.frame_time); };
  ClipClass done = kind();
  if (done.largest() != MotionType::kStand && !showsCycle(clip, roles, from.file.string())) {
    if (std::optional<Clip> loop = repeatedLoop(clip, roles, kLoopRuns)) {
      clip = std::move(*loop);
      done = kind();
    }
  }
  return {&from, std::move(capture), std::move(done), frames};
}

// First frame of the kStandsFor in which joints turn least.
int stillestFrame(const Clip& clip, int frames) {
  std::vector<double> turned = {0.0};  // all joints, up to the frame [rad]
  for (int i = 1; i < clip.frames(); ++i) {
    double sum = turned.back();
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      sum += clip.poses.rotations(i)[j].angularDistance(clip.poses.rotations(i - 1)[j]);
    }
    turned.push_back(sum);
  }
  int stillest = 0;
  for (int i = 0; i + frames < clip.frames(); ++i) {
    const double here = turned[i + frames] - turned[i];
    if (here < turned[stillest + frames] - turned[stillest]) stillest = i;
  }
  return stillest;
}

// The standing posture: of the moment in which the capture stands stillest.
void takeStand(const Seen& seen, MotionLibrary& rig) {
  if (rig.find("stand") != nullptr) {
    throw InputError(seen.file(), 0, "is a second capture of standing", "one");
  }
  const Clip clip = clipForLibrary(rig, seen.capture, seen.file(), true);
  const int frames = std::min(
      clip.frames() - 1, std::max(1, static_cast<int>(std::lround(kStandsFor / clip.frame_time))));
  const int first = stillestFrame(clip, frames);
  Motion stand;
  stand.name = "stand";
  stand.kind = MotionKind::kPosture;
  stand.posture = preparePosture(clip, rig.roles, rig.feet(), first, first + frames);
  const int begin = seen.capture.first_frame + first;
  const EngineCapture& from = *seen.from;
  stand.source = {from.clip, {begin, begin + frames}, false, from.licence, from.credit};
  rig.motions.push_back(std::move(stand));
}

Gait gaitOf(const Seen& seen) {
  const double walks = seen.kind.shareOf(MotionType::kWalk);
  const double runs = seen.kind.shareOf(MotionType::kRun);
  if (walks > 0.0 || runs > 0.0) return walks >= runs ? Gait::kWalk : Gait::kRun;
  throw InputError(seen.file(), 0, "neither walks, runs nor stands", "a walk, a run or standing");
}

// The engine stands on what its walks stand on in the mean: they are of one person and one set of
// markers. Of captures without a cycle takeGaits warns.
void standOnWalks(const std::vector<Seen>& all, MotionLibrary& rig) {
  std::array<double, 2> sum = {0.0, 0.0};
  int walks = 0;
  for (const Seen& seen : all) {
    if (seen.kind.largest() == MotionType::kStand) continue;
    const Clip clip = clipForLibrary(rig, seen.capture, seen.file());
    if (!isOfRig(rig, seen.clip().skeleton)) continue;
    try {
      if (gaitOf(seen) != Gait::kWalk) continue;
      const std::array<double, 2> drops = walkedDrops(rig, clip, seen.file());
      for (const Side side : {kLeft, kRight}) sum[side] += drops[side];
      ++walks;
    } catch (const InputError&) {
      continue;
    }
  }
  if (walks == 0) return;
  standOn(withFootDrops(rig.skeleton, rig.roles, {sum[kLeft] / walks, sum[kRight] / walks}), rig);
}

// Cycles of every capture that moves, by Gait. One without a steady cycle is left out.
std::array<Captured, 2> takeGaits(const std::vector<Seen>& all, MotionLibrary& rig,
                                  Warnings& warnings) {
  std::array<Captured, 2> gaits;
  for (const Seen& seen : all) {
    if (seen.kind.largest() == MotionType::kStand) continue;
    const Clip clip = clipForLibrary(rig, seen.capture, seen.file());
    const double ratio =
        seen.capture.motion.roles.meanLeg(seen.clip().skeleton) / rig.roles.meanLeg(rig.skeleton);
    if (std::abs(ratio - 1.0) > kSameLegs) {
      warnings.push_back(seen.file() + ": is of another person, whose legs are " +
                         shortNumber(ratio, 3) + " times as long; carried over");
    }
    try {
      const Gait gait = gaitOf(seen);
      takeCycles(rig, clip, seen, gait, gaits[static_cast<size_t>(gait)]);
    } catch (const InputError& error) {
      if (all.size() == 1) throw;
      warnings.push_back(std::string(error.what()) + "; left out");
    }
  }
  return gaits;
}

void warnOfSpeeds(const char* gait, const GaitSpace& space, Warnings& warnings) {
  if (!space.components.empty()) return;
  warnings.push_back(std::string("the ") + gait +
                     " are too near each other in speed for lines over it: they differ by less "
                     "than a tenth; their mean is taken");
}

}  // namespace

EngineData fitSpeedEngine(const EngineRequest& request, std::vector<std::string>* warnings) {
  Warnings said;
  std::vector<Seen> all;
  for (const EngineCapture& capture : request.captures) all.push_back(see(capture, said));
  MotionLibrary rig;  // the engine's skeleton and posture
  for (const Seen& seen : all) {
    if (seen.kind.largest() == MotionType::kStand) takeStand(seen, rig);
  }
  standOnWalks(all, rig);
  std::array<Captured, 2> gaits = takeGaits(all, rig, said);
  if (gaits[0].cycles.empty() && gaits[1].cycles.empty()) {
    throw InputError(request.captures.front().file.string(), 0, "holds no cycle, nor do the others",
                     "walks or runs");
  }
  EngineData data;
  data.skeleton = rig.skeleton;
  data.roles = rig.roles;
  data.stature = rig.stature;
  data.stand = rig.stand();
  data.stand_source = rig.find("stand")->source;
  data.mean_posture = meanPosture(gaits, rig.stand().rotations);
  for (const Gait gait : {Gait::kWalk, Gait::kRun}) {
    Captured& captured = gaits[static_cast<size_t>(gait)];
    if (captured.cycles.empty()) continue;
    rebase(rig.stand().rotations, data.mean_posture, captured.cycles);
    GaitSpace space = spaceOf(rig, request.variance, captured);
    warnOfSpeeds(gait == Gait::kWalk ? "walks" : "runs", space, said);
    (gait == Gait::kWalk ? data.walk : data.run) = std::move(space);
  }
  if (warnings != nullptr) *warnings = std::move(said);
  return data;
}

}  // namespace amble
