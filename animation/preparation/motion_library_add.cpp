#include "animation/preparation/motion_library_add.h"

#include <cmath>

#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/clips/carry_over.h"
#include "animation/clips/level_capture.h"
#include "animation/clips/mirror_clip.h"
#include "animation/preparation/transition_fit.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSameOffset = 1e-3;  // of joints of one subject in two clips [m]
// What is unfit for a library; by trial, good captures have 0.5 degrees and 20 mm.
constexpr double kTurnOfClip = 25.0 * kDegree;  // walkers sway by ten
constexpr double kLargestResidual = 2.0;        // of a cycle's angles [degrees]
constexpr double kLargestSlide = 0.06;          // of a standing ankle [m]

bool sameSkeleton(const Skeleton& a, const Skeleton& b) {
  bool same = a.size() == b.size();
  for (int i = 0; same && i < a.size(); ++i) {
    same = a.joint(i).name == b.joint(i).name &&
           (i == 0 || (a.joint(i).offset - b.joint(i).offset).norm() < kSameOffset);
  }
  return same;
}

void adoptSkeleton(MotionLibrary& library, const LevelCapture& capture, const std::string& file) {
  for (const LegJoints& leg : capture.motion.roles.legs) {
    if (leg.toe < 0) throw InputError(file, 0, "a foot without a toe joint", "a rig with both");
  }
  std::vector<Joint> joints = capture.motion.clip.skeleton.joints();
  joints[0].offset.setZero();
  library.skeleton = Skeleton(std::move(joints));
  library.roles = capture.motion.roles;
  library.stature = statureOf(library.skeleton, library.roles);
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
  Clip clip = capture.motion.clip;
  if (sameSkeleton(clip.skeleton, library.skeleton)) {
    clip.skeleton = library.skeleton;
    return clip;
  }
  const JointRoles& roles = capture.motion.roles;
  return carriedToLibrary(library, clip, roles, referenceOf(clip, roles),
                          referenceOf(library.skeleton, library.roles, library.stand().rotations));
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

void prepareCycle(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                  Motion& motion) {
  const std::string file = request.file.string();
  CycleOptions options{file, false, request.harmonics, request.frames};
  options.turning = request.turning
                        ? *request.turning
                        : motion.kind == MotionKind::kWalk && isTurn(clip, library.roles);
  std::pair<int, int> used;
  motion.cycle = prepareWalkCycle(clip, library.roles, library.feet(), library.stand().rotations,
                                  options, &used);
  requireFit(motion.cycle, file);
  motion.turning = options.turning;
  motion.source.frames = {used.first, used.second};
  if (motion.turning && std::abs(motion.cycle.turn_rate) <= kStraightTurnRate) {
    throw InputError(file, 0, "is called a turn and walks straight", "more than 8.6 degrees/s");
  }
}

void preparePose(const MotionLibrary& library, const MotionRequest& request, const Clip& clip,
                 Motion& motion) {
  const auto frames = request.frames.value_or(std::pair{0, clip.frames() - 1});
  if (frames.first < 0 || frames.second >= clip.frames()) {
    throw InputError(request.file.string(), 0, "frames that the clip does not have",
                     "up to " + std::to_string(clip.frames() - 1) + " of its motion");
  }
  motion.posture = preparePosture(clip, library.roles, library.feet(), frames.first, frames.second);
  motion.source.frames = {frames.first, frames.second};
}

}  // namespace

void addMotion(MotionLibrary& library, const MotionRequest& asked) {
  const std::string file = asked.file.string();
  if (library.find(asked.name) != nullptr) {
    throw InputError(file, 0, "the library has a motion " + asked.name, "another name");
  }
  MotionRequest request = asked;
  const LevelCapture capture = readLevelCapture(request.file, request.read);
  if (library.skeleton.size() == 0) adoptSkeleton(library, capture, file);
  const bool is_stand = request.name == "stand" && request.kind == MotionKind::kPosture;
  if (!is_stand && library.find("stand") == nullptr) borrowStand(library, capture.motion.clip);
  Clip clip = is_stand && library.motions.empty() ? capture.motion.clip
                                                  : onLibrarySkeleton(library, capture);
  clip.skeleton = library.skeleton;
  if (request.source.mirrored) clip = mirrorClip(clip, library.roles);
  if (request.frames) {
    request.frames->first -= capture.first_frame;
    request.frames->second -= capture.first_frame;
  }
  Motion motion;
  motion.name = request.name;
  motion.kind = request.kind;
  motion.valid = request.valid;
  motion.chains = request.chains;
  motion.source = request.source;
  switch (request.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      prepareCycle(library, request, clip, motion);
      break;
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      preparePose(library, request, clip, motion);
      break;
    case MotionKind::kStart:
    case MotionKind::kStop:
      motion.transition = fitTransition(clip, library.roles, request.kind == MotionKind::kStart,
                                        file, motion.source.frames);
      break;
  }
  for (int& frame : motion.source.frames) frame += capture.first_frame;
  library.motions.push_back(std::move(motion));
}

}  // namespace amble
