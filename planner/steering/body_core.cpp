#include "planner/steering/body_core.h"

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// Of stature: the upper half of the shanks, below most seats and table tops.
constexpr double kShankHeight = 0.22;
constexpr double kUsedShare = 0.5;   // of what was measured
constexpr double kThinnest = 0.005;  // a line that is covered by less is none [m]
constexpr double kSpacing =
    0.1;  // of points along the path: chords of its tightest bends leave it by 3 mm [m]
constexpr double kStandingMargin =
    0.1;                                // at the path's ends, where feet stand beside its point [m]
constexpr double kWalkingMargin = 0.5;  // and where one is a step behind [m]

// Where a part's axis passes a height; none where it does not.
std::optional<Eigen::Vector3d> atHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                        double height) {
  if ((from.z() - height) * (to.z() - height) > 0.0 || from.z() == to.z()) return std::nullopt;
  return from + (height - from.z()) / (to.z() - from.z()) * (to - from);
}

// To the left of the path [m].
double offsetFrom(const RootPath::Sample& path, const Eigen::Vector3d& point) {
  return Eigen::Vector2d(-std::sin(path.heading), std::cos(path.heading))
      .dot(point.head<2>() - path.position);
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
  static constexpr double kUneven = 0.01;  // between points kSpacing apart [m]
  static constexpr int kLevelPoints = 8;   // kSpacing apart: a stride

  const BodyCore::Way& way_;
  double z_;
  int uneven_ = -kLevelPoints - 1;
};

}  // namespace

BodyCore::BodyCore(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                   const Body& body, double stature) {
  if (walk.buffer.size() == 0) return;
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  const double shank = kShankHeight * stature;
  for (size_t part = 0; part < body.parts.size(); ++part) {
    const int joint = body.parts[part].joint;
    const bool pelvis = joint == roles.hips;
    if (!pelvis && joint != roles.legs[kLeft].leg && joint != roles.legs[kRight].leg) continue;
    Eigen::AlignedBox2d axis;  // where it passes the path: offset, height
    bool always = true;
    for (int frame = 0; frame < walk.buffer.size(); ++frame) {
      forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
      placeBody(body, joints, from, to);
      const RootPath::Sample path = walk.path.at(walk.buffer.states[frame].arc);
      const double ground = walk.buffer.states[frame].position.z();
      const auto at = pelvis ? std::optional(Eigen::Vector3d(0.5 * (from[part] + to[part])))
                             : atHeight(from[part], to[part], ground + shank);
      always = always && at;
      if (at) axis.extend(Eigen::Vector2d(offsetFrom(path, *at), at->z() - ground));
    }
    if (!always) continue;
    const double inside = kUsedShare * (body.parts[part].radius - 0.5 * axis.diagonal().norm());
    if (inside > kThinnest) {
      lines_.push_back(
          {axis.center().x(), axis.center().y(), inside, static_cast<int>(part), !pelvis});
    }
  }
}

std::optional<BodyCore::Touch> BodyCore::touch(const Way& way, const CollisionWorld& world,
                                               CollisionScratch& scratch) const {
  const RootPath& path = way.path;
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kSpacing)));
  const double first = way.standing_first ? kStandingMargin : kWalkingMargin;
  const double last = path.length() - (way.standing_last ? kStandingMargin : kWalkingMargin);
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
      const bool covered = !line.leg || (s - path.length() / count >= first && s <= last);
      if (i > 0 && covered && is_level) {
        const int object = world.touched(before[k], here, line.radius, scratch);
        if (object >= 0) return Touch{line.part, object, here, at.heading};
      }
      before[k] = here;
    }
  }
  return std::nullopt;
}

}  // namespace amble
