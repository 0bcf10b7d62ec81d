#include "viz/page/clip_page.h"

#include <fmt/format.h>

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "animation/clips/mirror_clip.h"
#include "base/error.h"
#include "scenarios/captured_body.h"
#include "scenarios/standing_feet.h"
#include "scenarios/walker_ground.h"

namespace amble {
namespace {

const char* sideName(Side side) { return side == kLeft ? "left" : "right"; }

// The clip as it is read, with somebody in it or without.
ShownClip readClip(const std::filesystem::path& file, MotionReadOptions options) {
  options.person = false;
  ShownClip shown;
  shown.file = file.string();
  shown.name = file == "-" ? "standard input" : file.filename().string();
  shown.motion = readMotion(file, options);
  if (shown.motion.clip.frames() == 0)
    throw InputError(file.string(), 0, "holds no frames", "a motion");
  shown.file_frames = shown.motion.clip.frames();
  return shown;
}

bool hasPerson(const ShownClip& shown) { return shown.motion.no_person.empty(); }

void makeItsBody(ShownClip& shown) {
  const Clip& clip = shown.motion.clip;
  const JointRoles& roles = shown.motion.roles;
  shown.body = capturedBody(clip, roles, shown.floor, statureOf(clip.skeleton, roles));
}

double lowestJoint(const Clip& clip) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  forwardKinematics(clip, 0, joints);
  double lowest = joints[0].p_WJ.z();
  for (const JointFrame& joint : joints) lowest = std::min(lowest, joint.p_WJ.z());
  return lowest;
}

std::string eventName(Side side, const char* what) {
  return std::string(sideName(side)) + " " + what;
}

// Of the analysis' frames, those that are shown.
double shownFrame(const ShownClip& shown, double frame) {
  return (frame + shown.first_frame) / shown.every;
}

void addEvents(const ShownClip& shown, PageTake& take) {
  for (const Side side : {kLeft, kRight}) {
    for (const SwingEvents& swing : shown.analysis->events.swings[side]) {
      const std::pair<const char*, double> all[] = {{"lift", swing.lift},
                                                    {"lift-off", swing.lift_off},
                                                    {"strike", swing.strike},
                                                    {"landing", swing.landing}};
      for (const auto& [what, frame] : all)
        if (std::isfinite(frame))
          take.events.push_back({eventName(side, what), side, shownFrame(shown, frame)});
    }
    for (const FootPlant& plant : shown.analysis->plants.plants[side]) {
      const FrameSpan span = {static_cast<int>(std::ceil(shownFrame(shown, plant.first))),
                              static_cast<int>(shownFrame(shown, plant.last))};
      if (span.first <= span.last) take.planted[side].push_back(span);  // else between two frames
    }
  }
}

PageTake takeOf(const ShownClip& shown, int actor) {
  PageTake take;
  take.name = shown.name;
  take.actor = actor;
  take.every = shown.every;
  take.frame_time = shown.motion.clip.frame_time;
  take.poses = &shown.motion.clip.poses;
  take.joint_positions = &shown.motion.clip.joint_positions;
  if (shown.analysis) addEvents(shown, take);
  return take;
}

}  // namespace

namespace {

// What is known of a clip that has been read.
void analyse(ShownClip& shown) {
  const Clip& clip = shown.motion.clip;
  if (!hasPerson(shown)) {
    shown.floor = lowestJoint(clip);
    return;
  }
  const JointRoles& roles = shown.motion.roles;
  shown.floor = lowestAnkle(clip, roles) - kAnkleHeightOfLeg * legOf(clip.skeleton, roles);
  makeItsBody(shown);
  const GoodFrames good = goodFrames(clip);
  shown.first_frame = good.first;
  const Clip level = levelled(trimmed(clip, good.first, good.last), roles, &shown.fit);
  if (const std::string doubt = doubtOf(shown.fit); !doubt.empty())
    shown.motion.warnings.push_back("the floor " + doubt);
  shown.analysis = analyseClip(level, roles);
  shown.feet = tracePlants(footPaths(level, roles), legLengths(level, roles), level.frame_time);
}

}  // namespace

ShownClip readShownClip(const std::filesystem::path& file, const MotionReadOptions& options) {
  ShownClip shown = readClip(file, options);
  analyse(shown);
  return shown;
}

ShownClip readShownPart(const std::filesystem::path& file, const ShownPart& part) {
  ShownClip shown = readClip(file, {});
  Clip& clip = shown.motion.clip;
  const auto [first, last] = part.frames;
  if (first < 0 || first > last || last >= clip.frames()) {
    throw InputError(file.string(), 0, fmt::format("has no frames {} to {}", first, last),
                     fmt::format("frames 0 to {}", clip.frames() - 1));
  }
  clip = trimmed(clip, first, last);
  if (part.mirrored && hasPerson(shown) && clip.joint_positions.empty())
    clip = mirrorClip(clip, shown.motion.roles);
  shown.file_frames = clip.frames();
  analyse(shown);
  return shown;
}

ShownClip readWalkIn(const Scene& scene, const std::filesystem::path& file,
                     const MotionReadOptions& options) {
  ShownClip shown = readClip(file, options);
  const Clip& clip = shown.motion.clip;
  const JointRoles& roles = shown.motion.roles;
  if (!hasPerson(shown)) {
    shown.floor = lowestJoint(clip);
    return shown;
  }
  GroundSettings settings = walkerGround(statureOf(clip.skeleton, roles), {});
  shown.floor = floorUnder(clip, roles, scene, settings, file.string());
  settings.level = shown.floor;
  makeItsBody(shown);
  const SceneGround ground(scene, settings);
  shown.analysis = ClipAnalysis{};
  shown.analysis->frame_time = clip.frame_time;
  shown.analysis->plants = plantsOver(clip, roles, ground, shown.floor);
  return shown;
}

PageSubject clipPage(const std::vector<ShownClip>& clips, const Scene* scene) {
  PageSubject page;
  page.scene = scene;
  page.floor = clips.front().floor;
  page.title = clips.size() == 1 ? clips.front().name : fmt::format("{} clips", clips.size());
  for (const ShownClip& shown : clips) {
    const Clip& clip = shown.motion.clip;
    page.takes.push_back(takeOf(shown, static_cast<int>(page.actors.size())));
    page.actors.push_back({.name = shown.name,
                           .skeleton = &clip.skeleton,
                           .body = shown.body ? &*shown.body : nullptr});
  }
  const Clip& first = clips.front().motion.clip;
  page.description = fmt::format("Motion capture {}: {:.1f} s of {} joints.", page.title,
                                 first.duration(), first.skeleton.size());
  page.facts = {
      {"Time", fmt::format("{:.2f} s", first.duration())},
      {"Frames", fmt::format("{} of {:.4g} ms", first.frames(), 1000.0 * first.frame_time)},
      {"Joints", std::to_string(first.skeleton.size())}};
  return page;
}

}  // namespace amble
