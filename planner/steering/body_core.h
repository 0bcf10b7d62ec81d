/// What the body covers wherever it walks: lines along the root path that something touches only if
/// the body does.
///
/// A cheap test before animation, that refuses and never allows. At the heights of the pelvis and
/// the head the trunk stays on the path but for a few centimetres of sway, and no point of the path
/// is walked by without it. A limb passes every point of the path on its own side, at a height at
/// which it always crosses: it is one chain from hip or shoulder that moves from behind the point
/// to before it. So there are lines, at a height and an offset from the path each, that lie inside
/// the body when it passes: two of the trunk, and one of each shank, upper arm and forearm. How far
/// inside is measured on a straight walk from standing to standing, and half of that is used:
/// turning walks sway otherwise.
#pragma once

#include <optional>
#include <vector>

#include "environments/collision/collision_world.h"
#include "planner/steering/straight_walk.h"

namespace amble {

class BodyCore {
 public:
  /// Of a body on a walk; without lines, which refuses nothing, where the walk has no frames.
  BodyCore(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
           const Body& body, double stature);

  struct Touch {
    int part = -1;
    int object = -1;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();    ///< where the part is [m, World]
    Eigen::Vector3d body = Eigen::Vector3d::Zero();  ///< the path there, on the ground [m, World]
    double heading = 0.0;                            ///< of the path there [rad]
  };
  struct Way {
    const RootPath& path;
    double z;                            ///< of the ground at its begin [m]
    bool standing_first, standing_last;  ///< limbs that walk there cover less of the path
    const SceneGround& ground;
  };
  /// What the body would touch on its way, or none, which says nothing. Asked where the way is
  /// level: on slopes and stairs the body is carried otherwise.
  std::optional<Touch> touch(const Way& way, const CollisionWorld& world,
                             CollisionScratch& scratch) const;

 private:
  struct Measure;
  struct Line {
    double offset = 0.0;  // from the path, left positive [m]
    double height = 0.0;  // over the ground [m]
    double radius = 0.0;  // of what is inside the body for sure [m, > 0]
    // Beside ends of the path where the walker stands, or walks, so much of it is not covered [m].
    double standing = 0.0, walking = 0.0;
    int part = -1;  // of the body
  };
  std::vector<Line> lines_;
};

}  // namespace amble
