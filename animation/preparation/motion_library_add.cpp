#include "animation/preparation/motion_library_add.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/body/rest_feet.h"
#include "animation/captures/bvh.h"
#include "animation/clips/add_toes.h"
#include "animation/clips/carry_over.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "animation/clips/loop_clip.h"
#include "animation/clips/mirror_clip.h"
#include "animation/clips/rest_feet_flat.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/speed_engine_reader.h"
#include "animation/library/statures.h"
#include "animation/preparation/engine_clip.h"
#include "animation/preparation/library_soles.h"
#include "animation/preparation/mirror_cycle.h"
#include "animation/preparation/transition_fit.h"
#include "animation/preparation/transition_sequence_fit.h"
#include "animation/preparation/turn_sequence_fit.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

// What is unfit for a library; by trial, good captures have 0.5 degrees and 20 mm.
constexpr double kTurnOfClip = 25.0 * kDegree;  // walkers sway by ten
constexpr double kLargestResidual = 2.0;        // of a cycle's angles [degrees]
constexpr double kLargestSlide = 0.06;          // of a standing ankle [m]
// A posture's joints keep so close to that of its middle; standing people sway by five degrees, and
// one who walks swings a leg by forty.
constexpr double kStillPosture = 12.0 * kDegree;
// A cycle that is made again has the same period, but for digits that the file does not keep [1].
constexpr double kSamePeriod = 1e-3;
constexpr double kHeldFor = 0.3;  // shortest hold that is looked for [s]

// Joints called what the BVH beside the library calls them, so that a rig is known again.
Skeleton withBvhNames(const Skeleton& skeleton) {
  const std::vector<std::string> names = bvhJointNames(skeleton);
  std::vector<Joint> joints = skeleton.joints();
  for (size_t j = 0; j < joints.size(); ++j) joints[j].name = names[j];
  return Skeleton(std::move(joints));
}

Skeleton skeletonOf(const LevelCapture& capture) {
  std::vector<Joint> joints = capture.motion.clip.skeleton.joints();
  joints[0].offset.setZero();
  return Skeleton(std::move(joints));
}

void adoptSkeleton(MotionLibrary& library, const LevelCapture& capture, const std::string& file) {
  library.skeleton = skeletonOf(capture);
  library.roles = capture.motion.roles;
  library.stature = statureOf(library.skeleton, library.roles);
  if (library.stature >= kShortestStature && library.stature <= kTallestStature) return;
  throw InputError(file, 0, "is of a person of " + shortNumber(library.stature, 3) + " m",
                   shortNumber(kShortestStature) + " to " + shortNumber(kTallestStature) +
                       " m; --unit says what the file's is");
}

// The clip of another skeleton on the library's; larger people move slower (Froude).
Clip carriedToLibrary(const MotionLibrary& library, const Clip& clip, const JointRoles& roles,
                      const ReferencePose& from, const ReferencePose& to) {
  Clip carried =
      carriedOver(clip, {clip.skeleton, roles, from}, {library.skeleton, library.roles, to});
  carried.frame_time *= std::sqrt(library.stature / statureOf(clip.skeleton, roles));
  return levelled(carried, library.roles);
}

Clip onLibrarySkeleton(const MotionLibrary& library, const LevelCapture& capture) {
  const Clip& clip = capture.motion.clip;
  const JointRoles& roles = capture.motion.roles;
  if (isOfRig(library, capture.motion.clip.skeleton))
    return onSoles(library, clip, footDrops(library.skeleton, library.roles));
  return carriedToLibrary(library, clip, roles, referenceOf(clip, roles),
                          referenceOf(library.skeleton, library.roles, library.stand().rotations));
}

// The library with nothing but its posture `stand`, on the soles that the capture shows: what is
// prepared there depends on nothing else that the library has. As it is where no foot stands.
MotionLibrary onSolesOf(const MotionLibrary& library, const LevelCapture& capture) {
  MotionLibrary own = library;
  std::erase_if(own.motions, [](const Motion& motion) { return motion.name != "stand"; });
  const auto& [clip, roles] = std::tie(capture.motion.clip, capture.motion.roles);
  if (own.skeleton.size() == 0 || !standingFootDrops(clip, roles)) return own;
  standOn(isOfRig(own, clip.skeleton)
              ? skeletonOf(capture)
              : withFootDrops(own.skeleton, own.roles, footDrops(clip.skeleton, roles)),
          own);
  return own;
}

// The clip's mirror image, on the mirror image of its soles.
Clip mirroredIn(MotionLibrary& own, const Clip& clip) {
  Clip mirrored = mirrorClip(clip, own.roles);
  std::array<double, 2> drops = footDrops(own.skeleton, own.roles);
  std::swap(drops[kLeft], drops[kRight]);
  standOn(withFootDrops(own.skeleton, own.roles, drops), own);
  mirrored.skeleton = own.skeleton;
  return mirrored;
}

// What was prepared there, on the library's soles, and the library on those of its walks.
void takeOver(MotionLibrary own, MotionLibrary& library) {
  if (library.skeleton.size() == 0) {
    library.skeleton = own.skeleton;
    library.roles = own.roles;
    library.stature = own.stature;
  }
  standOn(library.skeleton, own);
  for (Motion& motion : own.motions) {
    if (library.find(motion.name) == nullptr) library.motions.push_back(std::move(motion));
  }
  if (library.motions.back().cycle.foot_drops) settleSoles(library);
}

// `stand` of the library `default`, on this library's skeleton, whose rig `clip` shows upright.
void borrowStand(MotionLibrary& library, const Clip& clip) {
  const MotionLibrary other = openMotionLibrary("default");
  const std::vector<Eigen::Quaterniond>& rotations = other.stand().rotations;
  Clip stand{"stand", other.skeleton, 1.0 / 30.0, PoseArray(other.skeleton.size()), {}};
  Pose pose;
  pose.rotations = rotations;
  pose.p_WR.z() = other.stand().root_height;
  for (int i = 0; i < 3; ++i) stand.poses.append(pose);  // that its feet are seen to stand
  const Clip carried = carriedToLibrary(library, stand, other.roles,
                                        referenceOf(other.skeleton, other.roles, rotations),
                                        referenceOf(clip, library.roles));
  Motion motion = *other.find("stand");
  motion.posture = preparePosture(carried, library.roles, library.feet(), 0, 2);
  library.motions.push_back(std::move(motion));
}

// A clip that ends facing elsewhere than it began was captured for its turn.
bool isTurn(const Clip& clip, const JointRoles& roles) {
  const std::vector<double> headings = pelvisHeadings(clip, roles);
  return std::abs(headings.back() - headings.front()) > kTurnOfClip;
}

void requireFit(const WalkCycle& cycle, const std::string& file) {
  const double residual = cycle.residual / kDegree;
  if (residual > kLargestResidual) {
    throw InputError(file, 0,
                     "its cycle is no smooth motion: the series leaves out " +
                         std::to_string(residual) + " degrees (a joint that flips over?)",
                     "at most " + std::to_string(kLargestResidual));
  }
  if (cycle.slide > kLargestSlide) {
    throw InputError(
        file, 0,
        "its feet slide: a standing ankle moves by " + std::to_string(1000.0 * cycle.slide) + " mm",
        "at most " + std::to_string(1000.0 * kLargestSlide));
  }
}

// Of the clip, on its soles, as the library has it; of a clip that is one cycle only, and ends as
// it began, of that cycle repeated.
WalkCycle cycleOf(const MotionLibrary& library, const Clip& clip, const CycleOptions& options,
                  std::pair<int, int>& used, std::vector<FourierSeries>* captured = nullptr) {
  const std::array<FootShape, 2> feet =
      makeFootShapes(clip.skeleton, library.roles, library.stature);
  const double rise = riseBetween(clip.skeleton, library.skeleton, library.roles);
  const auto prepared = [&](const Clip& of) {
    WalkCycle cycle = prepareWalkCycle(of, library.roles, feet, library.stand().rotations, options,
                                       &used, captured);
    cycle.series.alpha(2, 0) += rise;
    for (size_t k = 0; captured != nullptr && k < captured->size(); ++k)
      (*captured)[k].alpha(2, 0) += rise;
    return cycle;
  };
  if (options.frames || hasCycle(clip, library.roles, feet, options)) return prepared(clip);
  const std::optional<Clip> loop = repeatedLoop(clip, library.roles, kLoopRuns);
  if (!loop) return prepared(clip);  // which says what is missing
  const WalkCycle cycle = prepared(*loop);
  used = {0, clip.frames() - 1};
  return cycle;
}

// @param own_rig  whether the clip is of the library's; plants  of it, where they are known
void prepareCycle(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                  bool own_rig, const FootPlants* plants, Motion& motion) {
  const std::string file = request.file.string();
  CycleOptions options{file, false, request.harmonics, request.frames, plants};
  options.turning = request.turning
                        ? *request.turning
                        : motion.kind == MotionKind::kWalk && isTurn(clip, library.roles);
  std::pair<int, int> used;
  motion.cycle = cycleOf(library, clip, options, used);
  requireFit(motion.cycle, file);
  if (own_rig && motion.kind == MotionKind::kWalk) {
    const std::array<double, 2> drops =
        standingDrops(motion.cycle, clip.skeleton, library.roles, library.stand().rotations);
    motion.cycle = cycleOf(library, onSoles(library, clip, drops), options, used);
    motion.cycle.foot_drops = drops;
  }
  if (request.source.mirrored) {
    motion.cycle =
        mirrorCycle(motion.cycle, library.skeleton, library.roles, library.stand().rotations);
  }
  motion.turning = options.turning;
  motion.source.frames = {used.first, used.second};
  if (motion.turning && std::abs(motion.cycle.turn_rate) <= kStraightTurnRate) {
    throw InputError(file, 0, "is called a turn and walks straight", "more than 8.6 degrees/s");
  }
}

// How far each frame's joints are turned from the frame in the middle, the most over the joints
// that the posture is of [rad].
double turnedWithin(const Clip& clip, const std::vector<int>& joints, int first, int last) {
  const auto& held = clip.poses.rotations((first + last) / 2);
  double most = 0.0;
  for (int i = first; i <= last; ++i) {
    for (const int j : joints) {
      most = std::max(most, clip.poses.rotations(i)[j].angularDistance(held[j]));
    }
  }
  return most;
}

std::vector<int> jointsOf(const MotionLibrary& library, const MotionRequest& request) {
  std::vector<int> joints;
  for (const std::string& chain : request.chains) {
    const std::vector<int> some = chainJoints(library.skeleton, library.roles, chain);
    if (some.empty()) {
      throw InputError(request.file.string(), 0, "the rig has no joints of the chain " + chain,
                       "another chain");
    }
    joints.insert(joints.end(), some.begin(), some.end());
  }
  for (int j = 1; request.chains.empty() && j < library.skeleton.size(); ++j) joints.push_back(j);
  return joints;
}

// A posture is the mean of frames in which somebody holds it; a mean of moving ones is nobody's.
void requireStill(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                  std::pair<int, int> frames, int first_frame) {
  const std::vector<int> joints = jointsOf(library, request);
  const double turned = turnedWithin(clip, joints, frames.first, frames.second);
  if (turned <= kStillPosture) return;
  const int window = std::max(1, static_cast<int>(std::lround(kHeldFor / clip.frame_time)));
  int stillest = frames.first;
  double least = turned;
  for (int i = frames.first; i + window <= frames.second; ++i) {
    const double here = turnedWithin(clip, joints, i, i + window);
    if (here < least) least = here, stillest = i;
  }
  const std::string most = std::to_string(std::lround(kStillPosture / kDegree)) + " degrees";
  const int first = first_frame + stillest;
  throw InputError(request.file.string(), 0,
                   "does not hold still: joints turn by " +
                       std::to_string(std::lround(turned / kDegree)) + " degrees",
                   least <= kStillPosture
                       ? "frames within " + most + ", such as " + std::to_string(first) + " to " +
                             std::to_string(first + window)
                       : "frames within " + most);
}

void preparePose(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                 int first_frame, Motion& motion) {
  const auto frames = request.frames.value_or(std::pair{0, clip.frames() - 1});
  requireStill(library, request, clip, frames, first_frame);
  motion.posture = preparePosture(clip, library.roles, library.feet(), frames.first, frames.second);
  motion.source.frames = {frames.first, frames.second};
}

// With its sequence where the clip shows enough of the walk.
void prepareTransition(const MotionLibrary& library, const MotionRequest& request,
                       const Clip& whole, Motion& motion) {
  const bool start = request.kind == MotionKind::kStart;
  const auto [first, last] = request.frames.value_or(std::pair{0, whole.frames() - 1});
  const Clip clip = trimmed(whole, first, last);
  motion.transition =
      fitTransition(clip, library.roles, start, request.file.string(), motion.source.frames);
  const auto sequence = fitTransitionSequence(clip, library.roles, library.feet(), library.stand(),
                                              start, motion.source.frames);
  if (sequence) motion.transition.sequence = *sequence;
  for (int& frame : motion.source.frames) frame += first;
}

void prepareTurn(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                 Motion& motion) {
  const SpotTurnFit how{library.feet(), &library.stand(), request.file.string(), request.frames};
  motion.turn = fitTurnOnSpot(clip, library.roles, how, motion.source.frames);
}

// Of a file's frames those that its motion has, as the motion counts them. A pose of the rig that
// stood before the motion may be named, too.
std::pair<int, int> framesOfMotion(const std::pair<int, int>& asked, int before, int count,
                                   const std::string& file) {
  const auto [first, last] = asked;
  const int end = before + count - 1;
  const std::string named = "frames " + std::to_string(first) + " to " + std::to_string(last);
  const std::string expected = "the first and the last of 0 to " + std::to_string(end);
  if (first > last) throw InputError(file, 0, named + " end before they begin", expected);
  if (first < 0 || last > end)
    throw InputError(file, 0, named + " are not all of its motion", expected);
  if (last < before) throw InputError(file, 0, named + " are a pose of its rig", expected);
  return {std::max(first - before, 0), last - before};
}

// The walk of a speed engine that is asked for; nothing where the file is a capture.
std::optional<WalkOfEngine> engineWalkOf(const MotionRequest& request) {
  if (!request.source.speed) return std::nullopt;
  const std::string file = request.file.string();
  if (request.kind != MotionKind::kWalk) {
    throw InputError(
        file, 0,
        "is a speed engine, which holds no " + motionKindNames()[static_cast<size_t>(request.kind)],
        "a walk of it");
  }
  if (request.turning.value_or(false)) {
    throw InputError(file, 0, "is a speed engine, which walks straight", "a straight walk of it");
  }
  if (request.frames) {
    throw InputError(file, 0, "is a speed engine, which has no frames", "a speed only");
  }
  return walkOfEngine(SpeedEngine(readSpeedEngine(request.file)), *request.source.speed, file);
}

// As somebody as tall as the library's person has it (Froude).
CaptureQuality qualityOf(const WalkOfEngine& walk, double stature) {
  const CapturedMotion& motion = walk.capture.motion;
  const double root = std::sqrt(stature / statureOf(motion.clip.skeleton, motion.roles));
  CaptureQuality quality = walk.quality;
  quality.toe_skate *= root;
  quality.joint_jerk /= root;
  return quality;
}

}  // namespace

LevelCapture readForLibrary(const std::filesystem::path& file, const MotionReadOptions& read,
                            std::vector<std::string>* warnings) {
  LevelCapture capture = readLevelCapture(file, read);
  for (const std::string& warning : capture.motion.warnings) {
    if (warnings != nullptr) warnings->push_back(file.string() + ": " + warning);
  }
  Clip& clip = capture.motion.clip;
  addToes(clip, capture.motion.roles, file.string());
  const JointRoles& roles = capture.motion.roles;
  const Skeleton before = clip.skeleton;
  const bool hung = restFootDrop(before, roles) > kHangingFoot;  // and said nothing of the floor
  if (restFeetFlat(clip, roles)) {
    if (hung) {
      clip = levelled(clip, roles);
    } else {
      raise(clip, riseBetween(before, clip.skeleton, roles));
    }
  }
  clip.skeleton = withBvhNames(clip.skeleton);
  return capture;
}

Clip clipForLibrary(MotionLibrary& library, const LevelCapture& capture, const std::string& file,
                    bool for_stand) {
  if (library.skeleton.size() == 0) adoptSkeleton(library, capture, file);
  if (!for_stand && library.find("stand") == nullptr) borrowStand(library, capture.motion.clip);
  const bool own = for_stand && library.motions.empty();
  Clip clip = own ? capture.motion.clip : onLibrarySkeleton(library, capture);
  clip.skeleton = library.skeleton;
  return clip;
}

void addMotion(MotionLibrary& library, const MotionRequest& asked,
               std::vector<std::string>* warnings) {
  const std::string file = asked.file.string();
  if (library.find(asked.name) != nullptr) {
    throw InputError(file, 0, "the library has a motion " + asked.name, "another name");
  }
  MotionRequest request = asked;
  const bool is_stand = isStand(request);
  const std::optional<WalkOfEngine> engines = engineWalkOf(request);
  const LevelCapture capture =
      engines ? engines->capture : readForLibrary(request.file, request.read, warnings);
  MotionLibrary own = onSolesOf(library, capture);
  if (engines && own.skeleton.size() == 0) {
    adoptSkeleton(own, capture, file);
    own.motions.push_back(engines->stand);
  }
  Clip clip = clipForLibrary(own, capture, file, is_stand);
  const bool cyclic = request.kind == MotionKind::kWalk || request.kind == MotionKind::kMovement;
  if (request.source.mirrored && !cyclic) clip = mirroredIn(own, clip);
  if (request.frames)
    request.frames = framesOfMotion(*request.frames, capture.first_frame, clip.frames(), file);
  Motion motion;
  motion.name = request.name;
  motion.kind = request.kind;
  motion.style = request.style;
  motion.valid = request.valid;
  motion.chains = request.chains;
  motion.source = request.source;
  if (asked.frames && !isPose(request.kind))
    motion.source.within = {asked.frames->first, asked.frames->second};
  if (engines && motion.source.licence.empty()) motion.source.licence = engines->licence;
  if (engines && motion.source.credit.empty()) motion.source.credit = engines->credit;
  switch (request.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      prepareCycle(own, request, clip, isOfRig(own, capture.motion.clip.skeleton),
                   engines ? &engines->plants : nullptr, motion);
      break;
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      preparePose(own, request, clip, capture.first_frame, motion);
      break;
    case MotionKind::kStart:
    case MotionKind::kStop:
      prepareTransition(own, request, clip, motion);
      break;
    case MotionKind::kTurnOnSpot:
      prepareTurn(own, request, clip, motion);
      break;
  }
  if (engines) motion.cycle.capture = qualityOf(*engines, own.stature);
  for (int& frame : motion.source.frames) frame = engines ? 0 : frame + capture.first_frame;
  own.motions.push_back(std::move(motion));
  takeOver(std::move(own), library);
}

std::vector<FourierSeries> capturedCycles(const MotionLibrary& library, const Motion& motion,
                                          const std::filesystem::path& file,
                                          const MotionReadOptions& read) {
  MotionRequest again_asked;
  again_asked.file = file;
  again_asked.source = motion.source;
  const std::optional<WalkOfEngine> engines = engineWalkOf(again_asked);
  const LevelCapture capture = engines ? engines->capture : readForLibrary(file, read);
  const MotionLibrary own = onSolesOf(library, capture);
  Clip clip = onLibrarySkeleton(own, capture);
  if (std::optional<std::array<double, 2>> drops = motion.cycle.foot_drops) {
    if (motion.source.mirrored) std::swap((*drops)[kLeft], (*drops)[kRight]);
    clip = onSoles(own, clip, *drops);
  }
  CycleOptions options{file.string(),
                       motion.turning,
                       motion.cycle.series.harmonics(),
                       {},
                       engines ? &engines->plants : nullptr};
  std::pair<int, int> used;
  std::vector<FourierSeries> cycles;
  WalkCycle again = cycleOf(library, clip, options, used, &cycles);
  if (std::abs(again.period - motion.cycle.period) > kSamePeriod * motion.cycle.period) {
    // It was looked for within some frames only.
    cycles.clear();
    options.frames = {motion.source.frames[0] - capture.first_frame - 1,
                      motion.source.frames[1] - capture.first_frame + 1};
    again = cycleOf(library, clip, options, used, &cycles);
  }
  if (std::abs(again.period - motion.cycle.period) > kSamePeriod * motion.cycle.period) {
    throw InputError(file.string(), 0, "gives another cycle than that of " + motion.name,
                     "the capture that it was made from");
  }
  for (FourierSeries& series : cycles) {
    if (!motion.source.mirrored) break;
    again.series = series;
    series = mirrorCycle(again, library.skeleton, library.roles, library.stand().rotations).series;
  }
  return cycles;
}

}  // namespace amble
