#include "scenarios/captured_body.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "base/error.h"
#include "base/statistics.h"
#include "environments/ground/scene_ground.h"

namespace amble {
namespace {

// How far the floor may be from the feet that stand on it [m].
constexpr double kNearFloor = 0.3;

SoleHeights solesOf(const Clip& clip, const JointRoles& roles, double floor, double stature) {
  if (roles.legs[kLeft].toe >= 0 && roles.legs[kRight].toe >= 0)
    return soleHeights(makeFootShapes(clip.skeleton, roles, stature));
  // A foot whose ankle is lower is a broken capture; one that is higher hangs in the air [m].
  constexpr double kThinnest = 0.02, kThickest = 0.12;
  return evenSoles(
      {std::clamp(lowestAnkle(clip, roles) - floor, kThinnest, kThickest), 0.5 * kThinnest});
}

// Under the lower ankle of a frame: how high the nearest floor is, and how far from the ankle.
struct FloorBelow {
  double height = 0.0, distance = 0.0;  // [m]
};

std::vector<FloorBelow> floorsBelow(const SceneGround& ground, const Clip& clip,
                                    const JointRoles& roles) {
  constexpr int kMostFrames = 200;  // asked about: a walk's way, no more than every few of them
  const int step = std::max(1, clip.frames() / kMostFrames);
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<FloorBelow> below;
  for (int frame = 0; frame < clip.frames(); frame += step) {
    forwardKinematics(clip, frame, joints);
    Eigen::Vector3d ankle = joints[roles.legs[kLeft].foot].p_WJ;
    const Eigen::Vector3d& other = joints[roles.legs[kRight].foot].p_WJ;
    if (other.z() < ankle.z()) ankle = other;
    std::optional<FloorBelow> nearest;
    for (const double height : ground.floors(ankle.x(), ankle.y())) {
      const double distance = std::abs(height - ankle.z());
      if (!nearest || distance < nearest->distance) nearest = {height, distance};
    }
    if (nearest) below.push_back(*nearest);
  }
  return below;
}

}  // namespace

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

Body capturedBody(const Clip& clip, const JointRoles& roles, double floor, double stature) {
  return makeBody(clip.skeleton, roles, stature, solesOf(clip, roles, floor, stature),
                  {.upright = referenceOf(clip, roles)});
}

double floorUnder(const Clip& clip, const JointRoles& roles, const Scene& scene,
                  const GroundSettings& settings, const std::string& file) {
  const std::vector<FloorBelow> below = floorsBelow(SceneGround(scene, settings), clip, roles);
  if (below.empty()) {
    throw InputError(file, 0, "the walk is where '" + scene.file.string() + "' has no floor",
                     "a walk within the scene");
  }
  for (const FloorBelow& each : below) {
    if (each.distance <= kNearFloor) return each.height;
  }
  std::vector<double> heights;
  for (const FloorBelow& each : below) heights.push_back(each.height);
  return median(heights);
}

}  // namespace amble
