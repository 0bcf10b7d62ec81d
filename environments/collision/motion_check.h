/// How CollisionWorld checks a motion.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "animation/synthesis/animation_buffer.h"
#include "environments/body/body.h"
#include "environments/body/motion_bound.h"
#include "environments/collision/collision_world.h"
#include "environments/collision/scene_layers.h"

namespace amble {

/// Frames that `any` tries before it looks at all of them, coarsest first. By trial: most refusals
/// are found by then.
inline constexpr std::array<int, 3> kStrides = {16, 8, 4};

/// Memory of one thread; nothing in it outlives a call but its size.
class CollisionScratch {
 public:
  CollisionScratch(int joint_count, int part_count)
      : parts(part_count),
        joints(joint_count),
        angles(joint_count),
        sums(2 * joint_count),
        from(part_count),
        to(part_count),
        exact(ObstacleSet::makeScratch()) {
    middle.rotations.resize(joint_count);
  }

  /// Room for every frame of a motion; kept for the next.
  void prepare(int frames) {
    const size_t cells = static_cast<size_t>(frames) * parts;
    if (capsules.size() < cells) capsules.resize(cells);
    if (free_around.size() < cells) free_around.resize(cells);
    placed.assign(frames, false);
    if (all_motions.size() < cells) all_motions.resize(cells);
    if (nears.size() < cells) nears.resize(cells);
  }
  Capsule& capsule(int frame, int part) {
    return capsules[static_cast<size_t>(frame) * parts + part];
  }
  PartMotion& motion(int frame, int part) {
    return all_motions[static_cast<size_t>(frame) * parts + part];
  }
  double& near(int frame, int part) { return nears[static_cast<size_t>(frame) * parts + part]; }
  char& freeAround(int frame, int part) {
    return free_around[static_cast<size_t>(frame) * parts + part];
  }

  int parts;
  std::vector<JointFrame> joints;
  std::vector<double> angles, sums;
  std::vector<Eigen::Vector3d> from, to;
  ObstacleSet::ScratchPtr exact;
  Pose middle;
  // [frame][part]: places, where `placed`; motion to the next frame and PartMotion::near of it [m];
  // whether the part was proved free as far as it moves in the intervals beside the frame.
  std::vector<Capsule> capsules;
  std::vector<PartMotion> all_motions;
  std::vector<double> nears;
  std::vector<char> free_around;
  std::vector<bool> placed;
};

/// A body in a scene, and what it may touch.
struct CollisionModel {
  CollisionModel(const Scene& scene_in, const SceneGround& ground_in, const Skeleton& skeleton_in,
                 const Body& body_in)
      : scene(scene_in),
        skeleton(skeleton_in),
        body(body_in),
        bound(skeleton_in, body_in),
        layers(scene_in, ground_in) {}

  const Scene& scene;
  Skeleton skeleton;
  Body body;
  MotionBound bound;
  SceneLayers layers;

  int parts() const { return static_cast<int>(body.parts.size()); }

  /// How deep a part may be in the ground [m].
  double allowedDepth(int part, const FrameState& a, const FrameState& b) const {
    const int sole = body.parts[part].sole;
    if (sole < 0) return 0.0;
    return isDown(a, sole) || isDown(b, sole) ? kSoleDepth : kSwingDepth;
  }

  /// Whether the foot is planted, or just being lifted or put down: where planes meet a print may
  /// lie a millimetre or two in one of them, which the foot then leaves.
  static bool isDown(const FrameState& state, int side) {
    constexpr double kShare = 0.1;  // of a swing
    const double at = state.feet[side].at;
    return state.planted[side] || (at > 1.0 && at < 1.0 + kShare) || at > 2.0 - kShare;
  }

  /// Capsules of the body in World.
  void place(PoseView pose, CollisionScratch& scratch, std::span<Capsule> out) const {
    forwardKinematics(skeleton, pose, scratch.joints);
    placeBody(body, scratch.joints, scratch.from, scratch.to);
    for (int i = 0; i < parts(); ++i)
      out[i] = {scratch.from[i], scratch.to[i], body.parts[i].radius};
  }

  /// What the part touches, the ground included, or -1.
  int touched(const Capsule& capsule, int part, const FrameState& state,
              CollisionScratch& scratch) const {
    const double depth = allowedDepth(part, state, state);
    const int object = layers.touchedObstacle(capsule, depth, *scratch.exact);
    return object >= 0 ? object : layers.ground().touched(capsule, depth, *scratch.exact);
  }
};

/// The check of one motion: at its frames, and between them by halving what is not yet proved.
class MotionCheck {
 public:
  MotionCheck(const CollisionModel& world, const PoseArray& poses,
              std::span<const FrameState> states, CollisionScratch& scratch)
      : world_(world), poses_(poses), states_(states), scratch_(scratch) {
    scratch_.prepare(poses.size());
  }

  /// A contact at some of the frames, coarsest first; none says nothing of the others.
  std::optional<Contact> coarse();
  /// All frames and what is between them, in order. With `any` a contact at a frame may be told
  /// before an earlier one between frames.
  std::optional<Contact> all(bool any);

 private:
  // A moment between two frames.
  struct Moment {
    double t;
    Capsule capsule;
  };
  // What is still to be proved of a part between two frames.
  struct Task {
    int frame, part;
    bool obstacles, ground;
    double depth;  // allowed in the ground [m]
  };

  void place(int frame);
  void measureInterval(int frame);
  std::optional<Contact> checkFrame(int frame);
  std::optional<Contact> checkInterval(int frame);
  bool groundIsFree(const Task& task, const Capsule& a, const Capsule& b, const PartMotion& motion,
                    double near) const;
  std::optional<Contact> prove(const Task& task, const Moment& a, const Moment& b,
                               const PartMotion& motion) const;
  std::optional<Contact> touchedAt(const Task& task, const Moment& moment, double near) const;

  const CollisionModel& world_;
  const PoseArray& poses_;
  std::span<const FrameState> states_;
  CollisionScratch& scratch_;
};

}  // namespace amble
