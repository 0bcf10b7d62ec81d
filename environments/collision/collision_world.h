/// Whole bodies against the scene, on FCL: which frame of a motion touches what, between frames
/// too.
///
/// Solid: a closed mesh is solid (inside by parity over closed components, hollow shells free
/// within), an open one is a surface. Ground: soles may touch what is ground while planted, to 5
/// mm; everything else counts (DESIGN.md, section 3). Between frames the root moves linearly and
/// joints turn by slerp; that too is proved free or reported.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "animation/body/skeleton.h"
#include "animation/synthesis/animation_buffer.h"
#include "environments/body/body.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"

namespace amble {

/// Depth to which a planted sole may sink into the ground: FCL and the capsule's curve need some;
/// more is visible [m].
inline constexpr double kSoleDepth = 0.005;

/// Depth to which a sole that is neither planted nor just being lifted or put down may be in the
/// ground: rounding [m].
inline constexpr double kSwingDepth = 0.001;

/// A motion that comes nearer than this without a contact at a frame may be refused as unproved:
/// intervals are halved until parts move by less in them. Smaller costs more halvings near contact;
/// larger closes gaps that are just wide enough [m].
inline constexpr double kProofGap = 0.001;

struct Contact {
  int frame = 0;         ///< the frame, or the one before the moment of contact
  double between = 0.0;  ///< [0, 1): how far towards the next frame
  int part = -1;         ///< of the body
  int object = -1;       ///< of the scene
  /// Nearest distance that was proved [m]; 0 is a contact. Motions closer than kProofGap are
  /// refused as unproved.
  double gap = 0.0;
};

struct Clearance {
  double distance = 0.0;  ///< [m]
  int frame = 0;
  int part = -1;
  int object = -1;  ///< -1 where nothing is within `limit`
};

/// Scratch memory of one thread; made by CollisionWorld::makeScratch.
class CollisionScratch;
struct CollisionScratchDeleter {
  void operator()(CollisionScratch*) const;
};
using CollisionScratchPtr = std::unique_ptr<CollisionScratch, CollisionScratchDeleter>;

struct CollisionModel;

/// Const after construction: threads may share it, each with its own scratch.
class CollisionWorld {
 public:
  /// @pre scene and ground outlive the world; the body's joints are the skeleton's.
  CollisionWorld(const Scene& scene, const SceneGround& ground, const Skeleton& skeleton,
                 const Body& body);
  ~CollisionWorld();

  CollisionScratchPtr makeScratch() const;

  /// The first contact of the motion at or between its frames, or none. Soles are free to touch
  /// ground where states[i].planted; between two frames, where either end is planted. First is to
  /// an interval: of several contacts between the same two frames, one of them. With `any` some
  /// contact is returned, sooner: coarse frames are tried first. Whether there is one does not
  /// depend on `any`. Cost: see benchmarks/.
  std::optional<Contact> check(const PoseArray& poses, std::span<const FrameState> states, bool any,
                               CollisionScratch& scratch) const;

  /// A standing body at one pose (both feet planted).
  std::optional<Contact> checkPose(PoseView pose, CollisionScratch& scratch) const;

  /// The object, ground apart, that a capsule in World touches or lies in, or -1.
  int touched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
              CollisionScratch& scratch) const;

  /// Smallest distance to anything but the ground that soles stand on, at frames, exact; `limit`
  /// bounds the search [m].
  Clearance clearance(const PoseArray& poses, std::span<const FrameState> states, double limit,
                      CollisionScratch& scratch) const;

  const Scene& scene() const;
  const Body& body() const;

 private:
  std::unique_ptr<CollisionModel> model_;
};

}  // namespace amble
