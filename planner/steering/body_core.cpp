#include "planner/steering/body_core.h"

#include <algorithm>
#include <cmath>

#include "animation/library/transition.h"

namespace amble {
namespace {

// Of stature: the upper half of the shanks, below most seats and table tops, and above what feet
// are lifted over.
constexpr double kShankHeight = 0.22;
constexpr double kUsedShare = 0.5;   // of what was measured
constexpr double kThinnest = 0.005;  // a line that is covered by less is none [m]
// Of points along the path: chords of its tightest bends leave it by 3 mm [m]
constexpr double kPointSpacing = 0.1;
// Of limbs at the path's ends, beyond how far before or behind its point they are there [m].
constexpr double kEndMargin = 0.1;

// Where a part's axis passes a height; none where it does not.
std::optional<Eigen::Vector3d> atHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                        double height) {
  if ((from.z() - height) * (to.z() - height) > 0.0 || from.z() == to.z()) return std::nullopt;
  return from + (height - from.z()) / (to.z() - from.z()) * (to - from);
}

bool isLimb(int joint, const JointRoles& roles) {
  for (const Side side : {kLeft, kRight}) {
    if (joint == roles.legs[side].leg || joint == roles.arms[side].arm ||
        joint == roles.arms[side].fore_arm)
      return true;
  }
  return false;
}

// Ahead of the path's point, to its left, and over the ground [m].
Eigen::Vector3d fromPath(const RootPath::Sample& path, double ground,
                         const Eigen::Vector3d& point) {
  const Eigen::Vector2d way = point.head<2>() - path.position;
  const Eigen::Vector2d ahead(std::cos(path.heading), std::sin(path.heading));
  return {ahead.dot(way), ahead.x() * way.y() - ahead.y() * way.x(), point.z() - ground};
}

// How far from its end of the walk a frame is in a captured start or stop, where a part goes
// otherwise than in a walk: the trunk while weight is shifted, limbs until they swing as the
// walk's.
std::optional<double> transitionAt(const StraightWalk& walk, const FrameState& state, bool limb) {
  const double until = limb ? TransitionSequence::kEnd : 1.0;  // on its clock [steps]
  if (state.start.there && state.start.clock < until) return state.arc;
  if (state.stop.there && state.stop.clock < until) return walk.path.length() - state.arc;
  return std::nullopt;
}

// The ground's height along a way, and where it has been level for as long as a stride.
class LevelWay {
 public:
  explicit LevelWay(const BodyCore::Way& way) : way_(way), z_(way.z) {}

  // To the next point, the i-th; whether the ground is level there and was on the last few.
  bool goTo(const Eigen::Vector2d& p, int i) {
    if (way_.ground.isLevel()) return true;
    const double reach = way_.ground.settings().limits.highestStep();
    const auto next = way_.ground.height(p.x(), p.y(), z_, reach);
    if (!next || std::abs(*next - z_) > kUneven) uneven_ = i;
    if (next) z_ = *next;
    return i - uneven_ > kLevelPoints;
  }
  double z() const { return z_; }

 private:
  static constexpr double kUneven = 0.01;  // between points kPointSpacing apart [m]
  static constexpr int kLevelPoints = 8;   // kPointSpacing apart: a stride

  const BodyCore::Way& way_;
  double z_;
  int uneven_ = -kLevelPoints - 1;
};

}  // namespace

// A part over the walk: the ends of its axis in each frame (fromPath).
struct BodyCore::Measure {
  std::vector<Eigen::Vector3d> from, to;
  // Beside standing ends, of captured starts and stops, in which the part goes otherwise [m].
  double transitions = 0.0;

  // Of the heights at which the axis passes in every frame the nearest to what is wished for; none
  // where there is none.
  std::optional<double> heightAlways(std::optional<double> wish) const {
    double low = 0.0, high = HUGE_VAL;
    for (size_t i = 0; i < from.size(); ++i) {
      low = std::max(low, std::min(from[i].z(), to[i].z()));
      high = std::min(high, std::max(from[i].z(), to[i].z()));
    }
    if (low > high) return std::nullopt;
    return std::clamp(wish.value_or(0.5 * (low + high)), low, high);
  }

  // The line that is covered at a height, or by the middle of the part.
  Line line(std::optional<double> height, double radius, int part) const {
    Eigen::AlignedBox2d box;
    double standing = 0.0, walking = 0.0;  // farthest before or behind
    for (size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector3d at =
          height ? *atHeight(from[i], to[i], *height) : Eigen::Vector3d(0.5 * (from[i] + to[i]));
      box.extend(Eigen::Vector2d(at.tail<2>()));
      walking = std::max(walking, std::abs(at.x()));
      if (i == 0 || i + 1 == from.size()) standing = std::max(standing, std::abs(at.x()));
    }
    const double inside = kUsedShare * (radius - 0.5 * box.diagonal().norm());
    const double margin = height ? kEndMargin : -HUGE_VAL;  // the trunk covers all of the path
    double beside = standing + margin;
    if (transitions > 0.0) beside = transitions + walking + (height ? kEndMargin : 0.0);
    return {box.center().x(), box.center().y(), inside, beside, walking + margin, part};
  }
};

BodyCore::BodyCore(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                   const Body& body, double stature) {
  if (walk.buffer.size() == 0) return;
  const size_t parts = body.parts.size();
  std::vector<Measure> measures(parts);
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(parts), to(parts);
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const FrameState& state = walk.buffer.states[frame];
    const RootPath::Sample path = walk.path.at(state.arc);
    for (size_t part = 0; part < parts; ++part) {
      Measure& measure = measures[part];
      if (const auto end = transitionAt(walk, state, isLimb(body.parts[part].joint, roles))) {
        measure.transitions = std::max(measure.transitions, *end);
        continue;
      }
      measure.from.push_back(fromPath(path, state.position.z(), from[part]));
      measure.to.push_back(fromPath(path, state.position.z(), to[part]));
    }
  }
  for (size_t part = 0; part < parts; ++part) {
    const int joint = body.parts[part].joint;
    const bool trunk = joint == roles.hips || joint == roles.head;
    if (measures[part].from.empty() || (!trunk && !isLimb(joint, roles))) continue;
    const bool leg = joint == roles.legs[kLeft].leg || joint == roles.legs[kRight].leg;
    const std::optional<double> height =
        measures[part].heightAlways(leg ? std::optional(kShankHeight * stature) : std::nullopt);
    if (!trunk && !height) continue;
    const Line line = measures[part].line(trunk ? std::nullopt : height, body.parts[part].radius,
                                          static_cast<int>(part));
    if (line.radius > kThinnest) lines_.push_back(line);
  }
}

std::optional<BodyCore::Touch> BodyCore::touch(const Way& way, const CollisionWorld& world,
                                               CollisionScratch& scratch) const {
  const RootPath& path = way.path;
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kPointSpacing)));
  std::vector<Eigen::Vector3d> before(lines_.size());
  LevelWay level(way);
  for (int i = 0; i <= count; ++i) {
    const double s = path.length() * i / count;
    const RootPath::Sample at = path.at(s);
    const Eigen::Vector2d left(-std::sin(at.heading), std::cos(at.heading));
    const bool is_level = level.goTo(at.position, i);
    for (size_t k = 0; k < lines_.size(); ++k) {
      const Line& line = lines_[k];
      const Eigen::Vector2d point = at.position + line.offset * left;
      const Eigen::Vector3d here(point.x(), point.y(), level.z() + line.height);
      const double first = way.standing_first ? line.standing : line.walking;
      const double last = path.length() - (way.standing_last ? line.standing : line.walking);
      const bool covered = s - path.length() / count >= first && s <= last;
      if (i > 0 && covered && is_level) {
        const int object = world.touched(before[k], here, line.radius, scratch);
        const Eigen::Vector3d body(at.position.x(), at.position.y(), level.z());
        if (object >= 0) return Touch{line.part, object, here, body, at.heading};
      }
      before[k] = here;
    }
  }
  return std::nullopt;
}

}  // namespace amble
