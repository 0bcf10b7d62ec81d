/// A body in a scene as checks of motions have it, and a thread's memory for them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "animation/body/pose.h"
#include "environments/body/body.h"
#include "environments/body/body_track.h"
#include "environments/collision/contact.h"
#include "environments/collision/scene_layers.h"

namespace amble {

/// Of what a part at a frame is free as far as it moves in the intervals beside it.
struct FreeAround {
  bool obstacles = false, ground = false;

  bool all() const { return obstacles && ground; }
};

/// The larger distance that an end of the axis has moved [m].
inline double chordOf(const Capsule& a, const Capsule& b) {
  return std::sqrt(std::max((b.from - a.from).squaredNorm(), (b.to - a.to).squaredNorm()));
}

/// Memory of one thread; nothing in it outlives a call but its size.
class CollisionScratch {
 public:
  CollisionScratch(int joint_count, int part_count)
      : parts(part_count),
        joints(joint_count),
        from(part_count),
        to(part_count),
        exact(ObstacleSet::makeScratch()),
        lanes(static_cast<size_t>(joint_count) * kLaneScratch) {
    middle.rotations.resize(joint_count);
  }

  /// Room for every frame of a motion; kept for the next.
  void prepare(int frames) {
    const size_t cells = static_cast<size_t>(frames) * parts;
    if (capsules.size() < cells) capsules.resize(cells);
    if (free_around.size() < cells) free_around.resize(cells);
    if (ways.size() < cells) ways.resize(cells);
    placed.assign(frames, false);
    if (motions.nears.size() < cells) {
      motions.bounds.resize(cells);
      motions.nears.resize(cells);
    }
  }
  Capsule& capsule(int frame, int part) {
    return capsules[static_cast<size_t>(frame) * parts + part];
  }
  const PartMotion& motion(int frame, int part) const {
    return motions.bounds[static_cast<size_t>(frame) * parts + part];
  }
  double near(int frame, int part) const {
    return motions.nears[static_cast<size_t>(frame) * parts + part];
  }
  double& way(int frame, int part) { return ways[static_cast<size_t>(frame) * parts + part]; }
  FreeAround& freeAround(int frame, int part) {
    return free_around[static_cast<size_t>(frame) * parts + part];
  }

  int parts;
  std::vector<JointFrame> joints;
  std::vector<Eigen::Vector3d> from, to;
  ObstacleSet::ScratchPtr exact;
  Pose middle;
  BodyTrack::Scratch lanes;
  // [frame][part]: places, where `placed`; motion to the next frame; how far a point of the part
  // goes until the frame at most, from some frame before; of what the part was proved free as far
  // as it moves in the intervals beside the frame.
  std::vector<Capsule> capsules;
  BodyTrack::Motions motions;
  std::vector<double> ways;
  std::vector<FreeAround> free_around;
  std::vector<bool> placed;
};

inline constexpr SolePhases kStanding = {SolePhase::kPlanted, SolePhase::kPlanted};

/// A body in a scene, and what it may touch.
struct CollisionModel {
  CollisionModel(const Scene& scene_in, const SceneGround& ground_in, const Skeleton& skeleton_in,
                 const Body& body_in, const StopRequest& stop = {},
                 Checker checker = Checker::kFast)
      : CollisionModel(scene_in,
                       std::make_shared<const SceneLayers>(scene_in, ground_in, stop, checker),
                       skeleton_in, body_in) {}
  CollisionModel(const Scene& scene_in, std::shared_ptr<const SceneLayers> layers_in,
                 const Skeleton& skeleton_in, const Body& body_in)
      : scene(scene_in),
        skeleton(skeleton_in),
        body(body_in),
        track(skeleton_in, body_in),
        shared(std::move(layers_in)),
        layers(*shared) {}

  const Scene& scene;
  Skeleton skeleton;
  Body body;
  BodyTrack track;
  std::shared_ptr<const SceneLayers> shared;
  const SceneLayers& layers;

  int parts() const { return static_cast<int>(body.parts.size()); }

  /// How deep a part may be in the ground, between two frames or at one [m].
  double allowedDepth(int part, const SolePhases& a, const SolePhases& b) const {
    const int sole = body.parts[part].sole;
    if (sole < 0) return 0.0;
    const bool swings = a[sole] == SolePhase::kSwinging && b[sole] == SolePhase::kSwinging;
    return swings ? kSwingDepth : kSoleDepth;
  }

  /// Capsules of the body in World.
  void place(PoseView pose, CollisionScratch& scratch, std::span<Capsule> out) const {
    forwardKinematics(skeleton, pose, scratch.joints);
    placeBody(body, scratch.joints, scratch.from, scratch.to);
    for (int i = 0; i < parts(); ++i)
      out[i] = {scratch.from[i], scratch.to[i], body.parts[i].radius};
  }

  /// The same of one pose, as frame 0 of the scratch memory.
  void placeAlone(PoseView pose, CollisionScratch& scratch) const {
    scratch.prepare(1);
    place(pose, scratch, {&scratch.capsule(0, 0), static_cast<size_t>(parts())});
  }

  /// The capsule of a part, so far of the way from a pose to the next (interpolatePose).
  /// @param t  [0, 1]
  Capsule placeBetween(PoseView a, PoseView b, double t, int part,
                       CollisionScratch& scratch) const {
    interpolatePose(a, b, t, scratch.middle);
    forwardKinematics(skeleton, scratch.middle, scratch.joints);
    const BodyPart& at = body.parts[part];
    const JointFrame& X_WJ = scratch.joints[at.joint];
    return {X_WJ * at.from, X_WJ * at.to, at.radius};
  }

  /// What an upright body has over its head where that is lower than it stands.
  std::optional<Capsule> crown(std::span<const Capsule> placed) const {
    if (body.upright <= 0.0) return std::nullopt;
    double ground = std::numeric_limits<double>::infinity();
    for (int i = 0; i < parts(); ++i)
      if (body.parts[i].sole >= 0) ground = std::min(ground, placed[i].lowest());
    const Capsule& head = placed[body.head];
    const Eigen::Vector3d& top = head.from.z() > head.to.z() ? head.from : head.to;
    const double missing = ground + body.upright - (top.z() + head.radius);
    if (!(missing > 0.0)) return std::nullopt;
    return Capsule{top, top + missing * Eigen::Vector3d::UnitZ(), head.radius};
  }

  /// The first part of the standing body there that touches something.
  std::optional<Contact> firstContact(CollisionScratch& scratch) const {
    const std::span<const Capsule> placed(&scratch.capsule(0, 0), static_cast<size_t>(parts()));
    for (int part = 0; part < parts(); ++part) {
      const int object = touchedAt(placed, part, kStanding, scratch);
      if (object >= 0) return Contact{0, 0.0, part, object, 0.0};
    }
    return std::nullopt;
  }

  /// Every object that a part of the standing body there touches, over the head too where it is
  /// upright: each once.
  std::vector<int> allTouched(int part, CollisionScratch& scratch) const {
    const std::span<const Capsule> placed(&scratch.capsule(0, 0), static_cast<size_t>(parts()));
    const double depth = allowedDepth(part, kStanding, kStanding);
    std::set<int> objects;
    const auto add = [&](const Capsule& capsule) {
      int object = -1;
      while ((object = layers.touchedObstacle(capsule, depth, *scratch.exact, object)) >= 0)
        objects.insert(object);
      object = layers.ground().touched(capsule, depth, *scratch.exact);
      if (object >= 0) objects.insert(object);
    };
    add(placed[part]);
    if (const auto over = part == body.head ? crown(placed) : std::nullopt) add(*over);
    return {objects.begin(), objects.end()};
  }

  /// What the part of a placed body touches, or -1; over the head as far as it is upright.
  int touchedAt(std::span<const Capsule> placed, int part, const SolePhases& soles,
                CollisionScratch& scratch) const {
    const int object = touched(placed[part], part, soles, scratch);
    return object >= 0 || part != body.head ? object : touchedCrown(placed, scratch);
  }
  int touchedCrown(std::span<const Capsule> placed, CollisionScratch& scratch) const {
    const auto over = crown(placed);
    return over ? touched(*over, body.head, kStanding, scratch) : -1;
  }

  /// What the part touches, the ground included, or -1.
  int touched(const Capsule& capsule, int part, const SolePhases& soles,
              CollisionScratch& scratch) const {
    const double depth = allowedDepth(part, soles, soles);
    const int object = layers.touchedObstacle(capsule, depth, *scratch.exact);
    return object >= 0 ? object : layers.ground().touched(capsule, depth, *scratch.exact);
  }
};

}  // namespace amble
