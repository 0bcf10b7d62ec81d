#include "scenarios/validate_walk.h"

#include <algorithm>
#include <cmath>

#include "animation/analysis/foot_plants.h"
#include "animation/body/foot_shape.h"
#include "animation/captures/motion_reader.h"
#include "base/error.h"
#include "scenarios/foot_measures.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

// Of a plant that was found at each end, as QUALITY.md trims it: when exactly a foot lands is not
// known.
constexpr double kTrim = 0.15;

struct Character {
  JointRoles roles;
  double stature;
  SoleHeight sole;
};

CapturedMotion readWalk(const std::filesystem::path& file, const ValidateOptions& options) {
  CapturedMotion walk =
      readMotion(file, {.metres_per_unit = options.metres_per_unit, .up = options.up});
  if (walk.clip.frames() == 0) throw InputError(file.string(), 0, "holds no frames", "a motion");
  if (!walk.clip.joint_positions.empty()) {
    throw InputError(file.string(), 0, "joints other than the root move against their parents",
                     "rigid bones");
  }
  return walk;
}

// Height of the ankles where they are lowest: the tenth lowest of a hundred, so that one bad frame
// does not count [m, World].
double lowestAnkle(const Clip& clip, const JointRoles& roles) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<double> heights;
  for (int frame = 0; frame < clip.frames(); ++frame) {
    forwardKinematics(clip, frame, joints);
    for (const LegJoints& leg : roles.legs) heights.push_back(joints[leg.foot].p_WJ.z());
  }
  const auto tenth = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
  std::nth_element(heights.begin(), tenth, heights.end());
  return *tenth;
}

double nearestFloor(const Scene& scene, const Clip& clip, double foot, const std::string& file) {
  const Eigen::Vector3d root = clip.poses.p_WR(0);
  const std::vector<double> heights = SceneGround(scene).floors(root.x(), root.y());
  if (heights.empty()) {
    throw InputError(file, 0, "the walk begins where '" + scene.file.string() + "' has no floor",
                     "a walk within the scene");
  }
  return *std::min_element(heights.begin(), heights.end(), [&](double a, double b) {
    return std::abs(a - foot) < std::abs(b - foot);
  });
}

Character makeCharacter(const Clip& clip, const JointRoles& roles, double floor,
                        const ValidateOptions& options) {
  Character character;
  character.roles = roles;
  character.stature = options.height > 0.0 ? options.height : statureOf(clip.skeleton, roles);
  if (roles.legs[kLeft].toe >= 0) {
    const FootShape shape = makeFootShape(clip.skeleton, roles, kLeft, character.stature);
    character.sole = {shape.ankle_height, shape.radius};
  } else {
    constexpr double kThinnest =
        0.02;  // a foot whose ankle is lower than that is a broken capture [m]
    character.sole.ankle = std::max(lowestAnkle(clip, roles) - floor, kThinnest);
    character.sole.toe = 0.5 * kThinnest;
  }
  return character;
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

// Every contact of the motion, those of one pair on end put together.
std::vector<ContactSpan> findContacts(const CollisionWorld& world, const PoseArray& poses,
                                      std::span<const SolePhases> soles, double frame_time) {
  std::vector<ContactSpan> spans;
  const auto scratch = world.makeScratch();
  for (int begin = 0; begin < poses.size();) {
    PoseArray rest(poses.joints());
    rest.append(poses, begin, poses.size() - begin);
    const auto contact = world.check(rest, soles.subspan(begin), false, *scratch);
    if (!contact) break;
    const int frame = begin + contact->frame;
    const double time = (frame + contact->between) * frame_time;
    const std::string& part = world.body().parts.at(contact->part).name;
    const std::string object = objectName(world.scene().objects.at(contact->object));
    const auto same = std::find_if(spans.rbegin(), spans.rend(), [&](const ContactSpan& span) {
      return span.part == part && span.object == object && time - span.end < 2.0 * frame_time;
    });
    if (same != spans.rend()) {
      same->end = time;
    } else {
      spans.push_back({time, time, part, object});
    }
    begin = frame + 1;
  }
  return spans;
}

void measureFeet(const SoleTracks& soles, const FootPlants& plants, WalkValidation& result) {
  double sum = 0.0;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      const int trim = static_cast<int>(std::lround(kTrim * (plant.last - plant.first + 1)));
      const double slide = soles.slide(side, plant.first + trim, plant.last - trim);
      result.foot_skate_max = std::max(result.foot_skate_max, slide);
      sum += slide;
      ++result.plants;
    }
  }
  if (result.plants > 0) result.foot_skate_mean = sum / result.plants;
  result.ground_penetration = soles.penetration();
}

}  // namespace

WalkValidation validateWalk(const std::filesystem::path& bvh,
                            const std::filesystem::path& scene_file,
                            const ValidateOptions& options) {
  WalkValidation result;
  const CapturedMotion walk = readWalk(bvh, options);
  const Clip& clip = walk.clip;
  result.metres_per_unit = walk.metres_per_unit.value;
  const Scene scene = readScene(scene_file, options.load);
  const JointRoles& roles = walk.roles;
  result.floor = options.floor ? *options.floor
                               : nearestFloor(scene, clip, lowestAnkle(clip, roles), bvh.string());
  const Character character = makeCharacter(clip, roles, result.floor, options);
  result.frames = clip.frames();
  result.frame_time = clip.frame_time;
  result.stature = character.stature;

  const Body body = makeBody(clip.skeleton, character.roles, character.stature, character.sole);
  const SceneGround ground(scene, result.floor);
  const CollisionWorld world(scene, ground, clip.skeleton, body);
  const int parts = std::max(1, static_cast<int>(std::lround(options.fps * clip.frame_time)));
  const PoseArray poses = densify(clip.poses, parts);
  const double frame_time = clip.frame_time / parts;
  const std::vector<SolePhases> soles(poses.size());  // both feet planted
  result.poses_checked = poses.size();
  result.contacts = findContacts(world, poses, soles, frame_time);

  const auto scratch = world.makeScratch();
  const Clearance near = world.clearance(poses, options.clearance_limit, *scratch);
  result.clearance = near.object < 0 ? options.clearance_limit : near.distance;
  if (near.object >= 0) {
    result.clearance_part = body.parts.at(near.part).name;
    result.clearance_object = objectName(scene.objects.at(near.object));
    result.clearance_time = near.frame * frame_time;
  }
  measureFeet(SoleTracks(clip.skeleton, body, clip.poses, ground), detectPlants(clip, roles),
              result);
  return result;
}

}  // namespace amble
