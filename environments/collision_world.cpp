#include "environments/collision_world.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "environments/clearance_field.h"
#include "environments/ground_layer.h"
#include "environments/motion_bound.h"
#include "environments/obstacle_set.h"

namespace amble {
namespace {

// Obstacles higher than this over the floor are left to FCL: nobody is so tall [m].
constexpr double kFieldTop = 2.2;
constexpr double kFieldBottom = -0.3;  // soles and their depth need little [m]
constexpr double kFieldMargin = 0.7;   // beyond what can be walked on: an arm's reach [m]

// Frames that `any` tries before it looks at all of them, coarsest first. By trial: most refusals
// are found by then.
constexpr std::array<int, 3> kStrides = {16, 8, 4};

struct Layers {
  std::vector<Obstacle> obstacles, ground;
};

// Parts a ground object's surfaces into those that lie on the floor's level or below, and the rest.
void splitGround(const SceneObject& object, int index, double top, Layers& layers) {
  const TriangleMesh mesh = worldMesh(object);
  TriangleMesh low{mesh.vertices, {}}, rest{mesh.vertices, {}};
  for (const std::array<int, 3>& t : mesh.triangles) {
    const double height =
        std::max({mesh.vertices[t[0]].z(), mesh.vertices[t[1]].z(), mesh.vertices[t[2]].z()});
    (height <= top ? low : rest).triangles.push_back(t);
  }
  layers.ground.push_back({index, cleanMesh(low), Eigen::Isometry3d::Identity(), {}});
  if (!rest.triangles.empty())
    layers.obstacles.push_back({index, cleanMesh(rest), Eigen::Isometry3d::Identity(), mesh, top});
}

Layers makeLayers(const Scene& scene, const SceneGround& ground) {
  Layers layers;
  const double top = ground.floor() + SceneGround::kLevel;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    const int index = static_cast<int>(i);
    if (object.role == Role::kIgnore) continue;
    if (ground.isGround(index)) {
      splitGround(object, index, top, layers);
      continue;
    }
    const bool is_mesh = std::holds_alternative<TriangleMesh>(object.shape);
    layers.obstacles.push_back(
        {index, object.shape, object.X_WO, is_mesh ? worldMesh(object) : TriangleMesh{}});
  }
  return layers;
}

// Where bodies can be: around the ground, not higher than they are; and no larger than what there
// is to touch.
Eigen::AlignedBox3d fieldRegion(const Eigen::AlignedBox3d& obstacles, const SceneGround& ground) {
  if (obstacles.isEmpty()) return {};
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kFieldMargin);
  Eigen::AlignedBox3d region(obstacles.min() - margin, obstacles.max() + margin);
  const Eigen::AlignedBox2d extent = ground.extent();
  if (extent.isEmpty()) return region;
  const Eigen::Vector3d low(extent.min().x() - kFieldMargin, extent.min().y() - kFieldMargin,
                            ground.floor() + kFieldBottom);
  const Eigen::Vector3d high(extent.max().x() + kFieldMargin, extent.max().y() + kFieldMargin,
                             ground.floor() + kFieldTop);
  return region.intersection(Eigen::AlignedBox3d(low, high));
}

}  // namespace

class CollisionScratch {
 public:
  explicit CollisionScratch(int joint_count, int part_count)
      : parts(part_count),
        joints(joint_count),
        angles(joint_count),
        sums(2 * joint_count),
        from(part_count),
        to(part_count),
        exact(ObstacleSet::makeScratch()) {
    middle.rotations.resize(joint_count);
  }

  // Room for every frame of a motion; kept for the next.
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

void CollisionScratchDeleter::operator()(CollisionScratch* scratch) const { delete scratch; }

struct CollisionWorld::Impl {
  Impl(const Scene& scene_in, const SceneGround& ground_in, const Skeleton& skeleton_in,
       const Body& body_in, Layers layers)
      : scene(scene_in),
        skeleton(skeleton_in),
        body(body_in),
        bound(skeleton_in, body_in),
        obstacles(layers.obstacles),
        ground(std::move(layers.ground), ground_in),
        field(layers.obstacles, fieldRegion(obstacles.bounds(), ground_in)) {}

  const Scene& scene;
  Skeleton skeleton;
  Body body;
  MotionBound bound;
  ObstacleSet obstacles;
  GroundLayer ground;
  ClearanceField field;

  int parts() const { return static_cast<int>(body.parts.size()); }

  // An object that the capsule touches, or -1; ground is asked apart.
  int touchedObstacle(const Capsule& capsule, CollisionScratch& scratch) const {
    return field.isFree(capsule) ? -1 : obstacles.touched(capsule, *scratch.exact);
  }

  // How deep a part may be in the ground [m].
  double allowedDepth(int part, const FrameState& a, const FrameState& b) const {
    const int sole = body.parts[part].sole;
    if (sole < 0) return 0.0;
    return a.planted[sole] || b.planted[sole] ? kSoleDepth : kSwingDepth;
  }

  void place(PoseView pose, CollisionScratch& scratch, std::span<Capsule> out) const {
    forwardKinematics(skeleton, pose, scratch.joints);
    placeBody(body, scratch.joints, scratch.from, scratch.to);
    for (int i = 0; i < parts(); ++i)
      out[i] = {scratch.from[i], scratch.to[i], body.parts[i].radius};
  }

  // What the part touches, the ground included, or -1.
  int touched(const Capsule& capsule, int part, const FrameState& state,
              CollisionScratch& scratch) const {
    const int object = touchedObstacle(capsule, scratch);
    return object >= 0 ? object
                       : ground.touched(capsule, allowedDepth(part, state, state), *scratch.exact);
  }
};

namespace {

double chordOf(const Capsule& a, const Capsule& b) {
  return std::sqrt(std::max((b.from - a.from).squaredNorm(), (b.to - a.to).squaredNorm()));
}

}  // namespace

// One motion's check.
class MotionCheck {
 public:
  MotionCheck(const CollisionWorld::Impl& world, const PoseArray& poses,
              std::span<const FrameState> states, CollisionScratch& scratch)
      : world_(world), poses_(poses), states_(states), scratch_(scratch) {
    scratch_.prepare(poses.size());
  }

  std::optional<Contact> coarse();
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

  const CollisionWorld::Impl& world_;
  const PoseArray& poses_;
  std::span<const FrameState> states_;
  CollisionScratch& scratch_;
};

void MotionCheck::place(int frame) {
  if (scratch_.placed[frame]) return;
  world_.place(poses_[frame], scratch_,
               {&scratch_.capsule(frame, 0), static_cast<size_t>(world_.parts())});
  scratch_.placed[frame] = true;
}

std::optional<Contact> MotionCheck::coarse() {
  for (size_t level = 0; level < kStrides.size(); ++level) {
    for (int frame = 0; frame < poses_.size(); frame += kStrides[level]) {
      if (level > 0 && frame % kStrides[level - 1] == 0) continue;
      place(frame);
      for (int part = 0; part < world_.parts(); ++part) {
        const int object =
            world_.touched(scratch_.capsule(frame, part), part, states_[frame], scratch_);
        if (object >= 0) return Contact{frame, 0.0, part, object, 0.0};
      }
    }
  }
  return std::nullopt;
}

std::optional<Contact> MotionCheck::all(bool any) {
  const int frames = poses_.size();
  for (int frame = 0; frame < frames; ++frame) {
    place(frame);
    if (frame + 1 < frames) measureInterval(frame);
    const std::optional<Contact> here = checkFrame(frame);
    if (any && here) return here;
    // What happens before this frame comes first, unless it is the same contact, whose beginning it
    // is then.
    if (frame > 0) {
      const std::optional<Contact> before = checkInterval(frame - 1);
      if (before) return before;
    }
    if (here) return here;
  }
  return std::nullopt;
}

void MotionCheck::measureInterval(int frame) {
  place(frame + 1);
  const size_t parts = static_cast<size_t>(world_.parts());
  world_.bound.compute(poses_[frame], poses_[frame + 1], {&scratch_.motion(frame, 0), parts},
                       scratch_.angles, scratch_.sums);
  for (int part = 0; part < world_.parts(); ++part) {
    const double chord = chordOf(scratch_.capsule(frame, part), scratch_.capsule(frame + 1, part));
    scratch_.near(frame, part) = scratch_.motion(frame, part).near(chord);
  }
}

// Leaves in freeAround whether a part is free of obstacles as far as it moves in the intervals
// beside the frame.
std::optional<Contact> MotionCheck::checkFrame(int frame) {
  std::optional<Contact> found;
  for (int part = 0; part < world_.parts(); ++part) {
    const Capsule& capsule = scratch_.capsule(frame, part);
    double near = 0.0;
    for (int side : {frame - 1, frame}) {
      if (side < 0 || side + 1 >= poses_.size()) continue;
      near = std::max(near, scratch_.near(side, part));
    }
    const bool around = world_.touchedObstacle(capsule.inflated(near), scratch_) < 0;
    scratch_.freeAround(frame, part) = around;
    int object = around ? -1 : world_.touchedObstacle(capsule, scratch_);
    if (object < 0)
      object = world_.ground.touched(
          capsule, world_.allowedDepth(part, states_[frame], states_[frame]), *scratch_.exact);
    if (object >= 0 && !found) found = Contact{frame, 0.0, part, object, 0.0};
  }
  return found;
}

std::optional<Contact> MotionCheck::checkInterval(int frame) {
  std::optional<Contact> first;
  for (int part = 0; part < world_.parts(); ++part) {
    const Capsule &a = scratch_.capsule(frame, part), &b = scratch_.capsule(frame + 1, part);
    const PartMotion& motion = scratch_.motion(frame, part);
    Task task{frame, part,
              !(scratch_.freeAround(frame, part) && scratch_.freeAround(frame + 1, part)), true,
              world_.allowedDepth(part, states_[frame], states_[frame + 1])};
    task.ground = !groundIsFree(task, a, b, motion, scratch_.near(frame, part));
    if (!task.obstacles && !task.ground) continue;
    const auto contact = prove(task, {0.0, a}, {1.0, b}, motion);
    if (contact && (!first || contact->between < first->between)) first = contact;
  }
  return first;
}

// By heights: the lowest point of a part is an end of its axis, and that leaves the straight line
// between its two places by `bend` at most. Where the ground is not level there, as for obstacles.
bool MotionCheck::groundIsFree(const Task& task, const Capsule& a, const Capsule& b,
                               const PartMotion& motion, double near) const {
  const double lowest = std::min(a.lowest(), b.lowest()) + task.depth - motion.bend;
  if (lowest >= world_.ground.highest()) return true;
  Eigen::AlignedBox3d box = a.bounds();
  box.extend(b.bounds());
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(motion.bend);
  if (lowest >= world_.ground.ceiling({box.min() - more, box.max() + more})) return true;
  return world_.ground.touched(a.inflated(near), task.depth, *scratch_.exact) < 0 &&
         world_.ground.touched(b.inflated(near), task.depth, *scratch_.exact) < 0;
}

std::optional<Contact> MotionCheck::touchedAt(const Task& task, const Moment& moment,
                                              double near) const {
  const Capsule capsule = moment.capsule.inflated(near);
  int object = task.obstacles ? world_.touchedObstacle(capsule, scratch_) : -1;
  if (object < 0 && task.ground)
    object = world_.ground.touched(capsule, task.depth, *scratch_.exact);
  if (object < 0) return std::nullopt;
  // t = 1 is the next frame.
  const bool next = moment.t >= 1.0;
  return Contact{task.frame + (next ? 1 : 0), next ? 0.0 : moment.t, task.part, object, 0.0};
}

// Halves the interval until each piece is proved free, or is so short that the part moves by less
// than kProofGap in it.
std::optional<Contact> MotionCheck::prove(const Task& task, const Moment& a, const Moment& b,
                                          const PartMotion& motion) const {
  const double near = motion.near(chordOf(a.capsule, b.capsule));
  Task left = task;
  if (task.obstacles)
    left.obstacles = world_.touchedObstacle(a.capsule.inflated(near), scratch_) >= 0 ||
                     world_.touchedObstacle(b.capsule.inflated(near), scratch_) >= 0;
  if (task.ground) left.ground = !groundIsFree(task, a.capsule, b.capsule, motion, near);
  if (!left.obstacles && !left.ground) return std::nullopt;
  if (near < kProofGap) {
    for (const Moment& moment : {a, b}) {
      if (auto contact = touchedAt(left, moment, 0.0)) return contact;
    }
    for (const Moment& moment : {a, b}) {
      auto contact = touchedAt(left, moment, near);
      if (!contact) continue;
      contact->gap = world_.obstacles.nearest(moment.capsule, kProofGap, *scratch_.exact).distance;
      return contact;
    }
    return std::nullopt;
  }
  Moment middle{0.5 * (a.t + b.t), {}};
  interpolatePose(poses_[task.frame], poses_[task.frame + 1], middle.t, scratch_.middle);
  forwardKinematics(world_.skeleton, scratch_.middle, scratch_.joints);
  const BodyPart& part = world_.body.parts[task.part];
  const JointFrame& X_WJ = scratch_.joints[part.joint];
  middle.capsule = {X_WJ * part.from, X_WJ * part.to, part.radius};
  if (auto contact = touchedAt(left, middle, 0.0)) return contact;
  if (auto contact = prove(left, a, middle, motion.halved())) return contact;
  return prove(left, middle, b, motion.halved());
}

CollisionWorld::CollisionWorld(const Scene& scene, const SceneGround& ground,
                               const Skeleton& skeleton, const Body& body)
    : impl_(std::make_unique<Impl>(scene, ground, skeleton, body, makeLayers(scene, ground))) {}

CollisionWorld::~CollisionWorld() = default;

const Scene& CollisionWorld::scene() const { return impl_->scene; }
const Body& CollisionWorld::body() const { return impl_->body; }

CollisionScratchPtr CollisionWorld::makeScratch() const {
  return CollisionScratchPtr(new CollisionScratch(impl_->skeleton.size(), impl_->parts()));
}

std::optional<Contact> CollisionWorld::check(const PoseArray& poses,
                                             std::span<const FrameState> states, bool any,
                                             CollisionScratch& scratch) const {
  assert(static_cast<int>(states.size()) >= poses.size());
  MotionCheck check(*impl_, poses, states, scratch);
  if (any) {
    if (const auto contact = check.coarse()) return contact;
  }
  return check.all(any);
}

std::optional<Contact> CollisionWorld::checkPose(PoseView pose, CollisionScratch& scratch) const {
  const FrameState standing;
  scratch.prepare(1);
  impl_->place(pose, scratch, {&scratch.capsule(0, 0), static_cast<size_t>(impl_->parts())});
  for (int part = 0; part < impl_->parts(); ++part) {
    const int object = impl_->touched(scratch.capsule(0, part), part, standing, scratch);
    if (object >= 0) return Contact{0, 0.0, part, object, 0.0};
  }
  return std::nullopt;
}

Clearance CollisionWorld::clearance(const PoseArray& poses, std::span<const FrameState>,
                                    double limit, CollisionScratch& scratch) const {
  Clearance best{limit, 0, -1, -1};
  const size_t parts = static_cast<size_t>(impl_->parts());
  scratch.prepare(poses.size());
  // Coarse frames first: a small distance found early spares most of the exact queries.
  const auto measure = [&](int frame) {
    impl_->place(poses[frame], scratch, {&scratch.capsule(frame, 0), parts});
    for (size_t part = 0; part < parts; ++part) {
      const Capsule& capsule = scratch.capsule(frame, static_cast<int>(part));
      if (impl_->field.isFree(capsule.inflated(best.distance))) continue;
      const ObstacleSet::Nearest nearest =
          impl_->obstacles.nearest(capsule, best.distance, *scratch.exact);
      if (nearest.object >= 0)
        best = {nearest.distance, frame, static_cast<int>(part), nearest.object};
    }
  };
  for (int frame = 0; frame < poses.size(); frame += kStrides[0]) measure(frame);
  for (int frame = 0; frame < poses.size(); ++frame)
    if (frame % kStrides[0] != 0) measure(frame);
  return best;
}

}  // namespace amble
