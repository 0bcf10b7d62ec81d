/// Whole bodies against the scene: which frame of a motion touches what, between frames too.
///
/// Solid: a closed mesh is solid (each closed part by parity, hollow shells free within, where
/// parts overlap solid too), an open one is a surface. Ground: soles may touch what is ground while
/// planted, to 5 mm; everything else counts (DESIGN.md, section 3). Between frames the root moves
/// linearly and joints turn by slerp; that too is proved free or reported. What an upright body has
/// over its head (Body::upright) is looked at in frames only: no part of it moves there.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "animation/body/pose.h"
#include "animation/body/skeleton.h"
#include "environments/body/body.h"
#include "environments/collision/contact.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"

namespace amble {

struct Clearance {
  double distance = 0.0;  ///< [m]
  int frame = 0;
  double between = 0.0;  ///< so far from there to the next [frames, 0 <= . < 1]
  int part = -1;
  int object = -1;  ///< -1 where nothing is within `limit`
};

/// What is nearest to each part at each frame, [frame * parts + part].
struct PartClearances {
  std::vector<double> distance;  ///< [m], `limit` where nothing is within
  std::vector<int> object;       ///< -1 there
};

/// Scratch memory of one thread; made by CollisionWorld::makeScratch.
class CollisionScratch;
struct CollisionScratchDeleter {
  void operator()(CollisionScratch*) const;
};
using CollisionScratchPtr = std::unique_ptr<CollisionScratch, CollisionScratchDeleter>;

struct CollisionModel;
class SceneLayers;  // scene_layers.h

/// Const after construction: threads may share it, each with its own scratch.
class CollisionWorld {
 public:
  /// @pre scene and ground outlive the world; the body's joints are the skeleton's.
  /// @throws Stopped if that is asked for.
  CollisionWorld(const Scene& scene, const SceneGround& ground, const Skeleton& skeleton,
                 const Body& body, const StopRequest& stop = {}, Checker checker = Checker::kFast);
  /// The same of layers that other bodies meet too. @pre they are the scene's
  CollisionWorld(const Scene& scene, std::shared_ptr<const SceneLayers> layers,
                 const Skeleton& skeleton, const Body& body);
  ~CollisionWorld();

  CollisionScratchPtr makeScratch() const;

  /// The first contact of the motion at or between its frames, or none. Soles are free to touch
  /// ground where soles[i] do not swing; between two frames, where they do not at either end. First
  /// is to an interval: of several contacts between the same two frames, one of them. With `any`
  /// some contact is returned, sooner: coarse frames are tried first. Whether there is one does not
  /// depend on `any`. Cost: see benchmarks/.
  std::optional<Contact> check(const PoseArray& poses, std::span<const SolePhases> soles, bool any,
                               CollisionScratch& scratch) const;

  /// A standing body at one pose (both feet planted).
  std::optional<Contact> checkPose(PoseView pose, CollisionScratch& scratch) const;

  /// Every part of a standing body (both feet planted) that touches something, with each object
  /// that it touches; of ground, with one.
  std::vector<Contact> contacts(PoseView pose, CollisionScratch& scratch) const;

  /// The object, ground apart, that a capsule in World touches or lies in, or -1.
  int touched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
              CollisionScratch& scratch) const;

  /// Smallest distance to anything but the ground that soles stand on, at frames, exact, and
  /// between them, to kClearanceGap; `limit` bounds the search [m].
  Clearance clearance(const PoseArray& poses, double limit, CollisionScratch& scratch) const;

  /// The same of every part at every frame. Cost: a query each, more the larger the limit.
  PartClearances clearances(const PoseArray& poses, double limit, CollisionScratch& scratch) const;

  /// How long and how much the body is nearer than `limit` to anything but the ground: the sum
  /// over frames of what is missing of it, as its share [frames, >= 0]. Soles apart, and of every
  /// fourth frame for all four. @param limit  [m, > 0]
  double nearness(const PoseArray& poses, double limit, CollisionScratch& scratch) const;

  const Scene& scene() const;
  const Body& body() const;

 private:
  std::unique_ptr<CollisionModel> model_;
};

}  // namespace amble
