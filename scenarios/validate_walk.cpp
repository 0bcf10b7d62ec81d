#include "scenarios/validate_walk.h"

#include <algorithm>
#include <cmath>

#include "animation/analysis/motion_measures.h"
#include "animation/body/foot_shape.h"
#include "animation/captures/motion_reader.h"
#include "base/error.h"
#include "base/text.h"
#include "scenarios/captured_body.h"
#include "scenarios/find_contacts.h"
#include "scenarios/problem.h"
#include "scenarios/standing_feet.h"
#include "scenarios/walker_ground.h"

namespace amble {
namespace {

// Of the skeleton. Beyond it is no person, but a wrong unit [m].
constexpr double kShortest = 0.4, kTallest = 3.0;

CapturedMotion readAsked(const std::filesystem::path& file, const ValidateOptions& options) {
  CapturedMotion walk = readMotion(file, {.metres_per_unit = options.metres_per_unit,
                                          .up = options.up,
                                          .memory = options.load.memory});
  if (walk.clip.frames() == 0) throw InputError(file.string(), 0, "holds no frames", "a motion");
  if (!walk.clip.joint_positions.empty()) {
    throw InputError(file.string(), 0, "joints other than the root move against their parents",
                     "rigid bones");
  }
  return walk;
}

void requirePerson(const CapturedMotion& walk, const std::string& file) {
  const double stature = statureOf(walk.clip.skeleton, walk.roles);
  if (stature >= kShortest && stature <= kTallest) return;
  throw InputError(file, 0,
                   "the body is " + shortNumber(stature) + " m tall, with a file unit of " +
                       shortNumber(walk.metres_per_unit.value) + " m",
                   shortNumber(kShortest) + " to " + shortNumber(kTallest) +
                       " m; --unit says what the file's is");
}

// The clip at the rate that it is checked at: each interval in equal parts, as a player shows them.
PoseArray densify(const PoseArray& poses, int parts) {
  PoseArray dense(poses.joints());
  Pose between;
  for (int frame = 0; frame < poses.size(); ++frame) {
    dense.append(poses[frame]);
    for (int part = 1; part < parts && frame + 1 < poses.size(); ++part) {
      interpolatePose(poses[frame], poses[frame + 1], static_cast<double>(part) / parts, between);
      dense.append(between);
    }
  }
  return dense;
}

// Parts of each interval, asked before there is memory for them.
int partsOf(const Clip& clip, double fps) {
  const double parts = std::max(1.0, std::round(fps * clip.frame_time));
  if (parts * clip.frames() * clip.skeleton.size() > kMostCheckedPoses) {
    throw InputError("--fps", 0, shortNumber(fps) + " frames a second of so long a clip",
                     "at most 10 million poses of joints");
  }
  return static_cast<int>(parts);
}

void measureClearance(const CollisionWorld& world, const PoseArray& poses, double frame_time,
                      double limit, WalkValidation& result) {
  const auto scratch = world.makeScratch();
  const Clearance near = world.clearance(poses, limit, *scratch);
  result.clearance = near.object < 0 ? limit : near.distance;
  if (near.object < 0) return;
  result.clearance_part = world.body().parts.at(near.part).name;
  result.clearance_object = objectName(world.scene().objects.at(near.object));
  result.clearance_time = (near.frame + near.between) * frame_time;
}

}  // namespace

WalkValidation validateWalk(const std::filesystem::path& bvh,
                            const std::filesystem::path& scene_file,
                            const ValidateOptions& options) {
  WalkValidation result;
  const CapturedMotion walk = readAsked(bvh, options);
  requirePerson(walk, bvh.string());
  const Clip& clip = walk.clip;
  const JointRoles& roles = walk.roles;
  const int parts = partsOf(clip, options.fps);
  result.metres_per_unit = walk.metres_per_unit.value;
  result.frames = clip.frames();
  result.frame_time = clip.frame_time;
  result.stature = options.height > 0.0 ? options.height : statureOf(clip.skeleton, roles);

  const Scene scene = readScene(scene_file, options.load);
  GroundSettings settings = walkerGround(result.stature, options.limits);
  result.floor =
      options.floor ? *options.floor : floorUnder(clip, roles, scene, settings, bvh.string());
  settings.level = result.floor;
  const SceneGround ground(scene, settings, options.load.stop);
  const Body body = capturedBody(clip, roles, result.floor, result.stature);
  const CollisionWorld world(scene, ground, clip.skeleton, body, options.load.stop);
  const PoseArray poses = densify(clip.poses, parts);
  const double frame_time = clip.frame_time / parts;
  result.poses_checked = poses.size();
  result.contacts = findContacts(world, poses, frame_time);
  measureClearance(world, poses, frame_time, options.clearance_limit, result);
  const SoleTracks soles(clip.skeleton, body, clip.poses, ground);
  const FootPlants plants = plantsOver(clip, roles, ground, result.floor);
  result.feet = measureStandingFeet(soles, plants, clip.frame_time);
  result.steps = measureStepHeights(soles, plants, ground);
  result.ground_penetration = soles.penetration();
  result.pops = pops(clip);
  return result;
}

}  // namespace amble
