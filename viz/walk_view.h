/// What the pictures show: a scene, and whatever is known of the walk through it.
///
/// World, metres. Everything but the scene may be missing (null or empty): where no walk was found
/// the plan view still shows the room, start, goal and roadmap.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "animation/body/skeleton.h"
#include "animation/ground/ground.h"
#include "animation/steps/root_path.h"
#include "animation/synthesis/animation_buffer.h"
#include "environments/body/body.h"
#include "environments/scene/scene.h"
#include "planner/plan_request.h"

namespace amble {

/// A place on the floor; without a heading any will do.
struct PlaceView {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> heading;                       ///< [rad]
  double height = 0.0;                                 ///< of the floor there [m, World]
};

/// The roadmap as it is drawn.
struct RoadmapView {
  struct Node {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
    double heading = 0.0;                                ///< [rad]
    bool connector = false;                              ///< else a guard
    double height = 0.0;                                 ///< of the ground there [m, World]
  };
  struct Edge {
    int from = 0, to = 0;               ///< indices of nodes
    std::vector<Eigen::Vector2d> line;  ///< its root path [m]; empty: straight
  };
  /// A walk that was tried and is none.
  struct Refused {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();  ///< [m]
    Eigen::Vector2d at = Eigen::Vector2d::Zero();                                  ///< where [m]
    std::string what;  ///< "contact: left shank and sofa"
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  std::vector<Refused> refused;
};

/// Borrowed: what the pointers name outlives the view.
struct WalkView {
  std::string title;
  const Scene* scene = nullptr;    ///< never null where a picture is made
  double floor = 0.0;              ///< height of the floor that is walked on [m]
  const Ground* ground = nullptr;  ///< what feet stand on, all over the scene
  const Skeleton* skeleton = nullptr;
  const Body* body = nullptr;
  const AnimationBuffer* animation = nullptr;
  const RootPath* path = nullptr;
  RoadmapView roadmap;
  std::optional<PlaceView> start, goal;
  std::vector<PlaceView> via;
  std::string why;                           ///< without a walk: why, in a line
  const Obstruction* obstruction = nullptr;  ///< the same, where it is known
  const ReachedRegion* reached = nullptr;    ///< and how far one gets, where that is known

  /// Skeleton, body and frames are there.
  bool hasBody() const {
    return skeleton != nullptr && body != nullptr && animation != nullptr && animation->size() > 0;
  }
};

/// X_WJ of the body's joints at a frame. @pre view.hasBody()
std::vector<JointFrame> jointFramesAt(const WalkView& view, int frame);

/// Capsule ends of the body's parts at a frame, in World. @pre view.hasBody()
struct PlacedBody {
  std::vector<Eigen::Vector3d> from, to;  ///< [m], one a part
};
PlacedBody placeBodyAt(const WalkView& view, int frame);

/// The root path as a polyline, a point every 2 cm or so [m]; empty without one.
std::vector<Eigen::Vector2d> pathLine(const WalkView& view);

/// Length of the soles [m]: of the body's sole capsules, or 0.27 without a body.
double soleLength(const WalkView& view);

/// The outline of a shoe's sole, counter-clockwise from above: heel at -length/2, toe at +length/2
/// along x, big toe on the inner side [m].
std::vector<Eigen::Vector2d> shoeOutline(Side side, double length);

/// The same, placed as a footprint lies.
std::vector<Eigen::Vector2d> placedShoe(const Footprint& footprint, double length);

}  // namespace amble
