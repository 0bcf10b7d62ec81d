#include "planner/steering/cylinder_steering.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kLift =
    SceneGround::kLevel + 0.02;  // of the cylinder over the floor, so that rugs pass below [m]
constexpr double kPlaceSpacing = 0.05;  // between checked places; what lies between is swept [m]

class CylinderScratch : public SteeringScratch {
 public:
  CollisionScratchPtr collision;
  AnimationBuffer buffer;
};

Skeleton oneJoint() {
  Joint joint;
  joint.name = "cylinder";
  return Skeleton({joint});
}

Body cylinderBody(const CylinderSteering::Settings& settings) {
  BodyPart part;
  part.name = "bounding cylinder";
  part.from = Eigen::Vector3d(0.0, 0.0, kLift + settings.radius);
  part.to = Eigen::Vector3d(
      0.0, 0.0, std::max(kLift, settings.height - 2.0 * settings.radius) + settings.radius);
  part.radius = settings.radius;
  return {{part}};
}

void addPlace(AnimationBuffer& buffer, const Eigen::Vector3d& position) {
  const int i = buffer.size();
  buffer.poses.resize(i + 1);
  buffer.poses.p_WR(i) = position;
  buffer.states.resize(i + 1);
  buffer.soles.resize(i + 1);
}

void clear(AnimationBuffer& buffer) {
  if (buffer.poses.joints() != 1) buffer.poses = PoseArray(1);
  buffer.poses.clear();
  buffer.states.clear();
  buffer.soles.clear();
}

SteeringFailure failure(const Contact& contact, const AnimationBuffer& buffer, double heading) {
  const Eigen::Vector3d at = buffer.poses.p_WR(contact.frame);
  return {WalkRule::kContact, contact.part, contact.object, contact.gap, at, at, heading};
}

}  // namespace

double boundingRadius(const StraightWalk& walk, const Skeleton& skeleton, const Body& body) {
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  double radius = 0.0;
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const Eigen::Vector2d axis = walk.path.at(walk.buffer.states[frame].arc).position;
    for (size_t i = 0; i < body.parts.size(); ++i) {
      const double reach =
          std::max((from[i].head<2>() - axis).norm(), (to[i].head<2>() - axis).norm());
      radius = std::max(radius, reach + body.parts[i].radius);
    }
  }
  return radius;
}

CylinderSteering::CylinderSteering(const Scene& scene, const SceneGround& ground,
                                   const Settings& settings)
    : ground_(ground),
      settings_(settings),
      world_(scene, ground, oneJoint(), cylinderBody(settings)) {}

SteeringScratchPtr CylinderSteering::makeScratch() const {
  auto scratch = std::make_unique<CylinderScratch>();
  scratch->collision = world_.makeScratch();
  return scratch;
}

bool CylinderSteering::place(Stance& stance) const {
  const auto under = ground_.stand(stance.position.x(), stance.position.y(), stance.position.z(),
                                   settings_.height);
  if (under) stance.position.z() = under->height;
  return under.has_value();
}

std::optional<SteeringFailure> CylinderSteering::stand(Stance& stance,
                                                       SteeringScratch& scratch) const {
  if (!place(stance)) return SteeringFailure{WalkRule::kNoGround};
  CylinderScratch& own = static_cast<CylinderScratch&>(scratch);
  clear(own.buffer);
  addPlace(own.buffer, stance.position);
  if (const auto contact = world_.checkPose(own.buffer.poses[0], *own.collision))
    return failure(*contact, own.buffer, stance.heading);
  return std::nullopt;
}

SteerResult CylinderSteering::steer(const Waypoint& from, const Waypoint& to,
                                    SteeringScratch& scratch) const {
  CylinderScratch& own = static_cast<CylinderScratch&>(scratch);
  clear(own.buffer);
  const Eigen::Vector3d way = to.stance.position - from.stance.position;
  const double heading = std::atan2(way.y(), way.x());
  const int count = std::max(1, static_cast<int>(std::ceil(way.norm() / kPlaceSpacing)));
  for (int i = 0; i <= count; ++i) addPlace(own.buffer, from.stance.position + way * i / count);
  SteerResult result;
  result.poses = own.buffer.size();
  if (const auto contact = world_.check(own.buffer.poses, own.buffer.soles, true, *own.collision)) {
    result.failure = failure(*contact, own.buffer, heading);
    return result;
  }
  WalkEdge edge;
  edge.from = from.stance;
  edge.to = to.stance;
  edge.path = RootPath({makeBezier(from.stance.position.head<2>(), heading,
                                   to.stance.position.head<2>(), heading, 1.0 / 3.0)});
  edge.length = way.norm();
  edge.duration = edge.length / settings_.speed;
  result.edge = std::move(edge);
  return result;
}

}  // namespace amble
