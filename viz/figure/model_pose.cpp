#include "viz/figure/model_pose.h"

#include <cmath>

#include "animation/body/reference_pose.h"
#include "base/rotation.h"

namespace amble {

using Eigen::Quaterniond;
using Eigen::Vector3d;

int findPart(const Body& body, const std::string& name) {
  for (size_t i = 0; i < body.parts.size(); ++i)
    if (body.parts[i].name == name) return static_cast<int>(i);
  return -1;
}

int findPart(const Body& body, Side side, const std::string& name) {
  return findPart(body, (side == kLeft ? "left " : "right ") + name);
}

bool isPerson(const Body& body) {
  for (const char* name : {"pelvis", "abdomen", "chest", "neck", "head"})
    if (findPart(body, name) < 0) return false;
  for (const Side side : {kLeft, kRight})
    for (const char* name : {"shoulder", "upper arm", "forearm", "hand", "thigh", "shank",
                             "sole, outside", "sole, inside", "toes", "instep"})
      if (findPart(body, side, name) < 0) return false;
  return true;
}

namespace {

constexpr double kArms = 45.0 * kDegree;   // below the horizon
constexpr double kElbows = 8.0 * kDegree;  // bent forwards: midway between a walk's and straight
constexpr double kLegs = 6.0 * kDegree;    // from the vertical

Vector3d nearestAxis(const Vector3d& v) {
  Eigen::Index axis;
  v.cwiseAbs().maxCoeff(&axis);
  return v[axis] < 0.0 ? Vector3d(-Vector3d::Unit(axis)) : Vector3d(Vector3d::Unit(axis));
}

class Modelling {
 public:
  Modelling(const Skeleton& skeleton, const Body& body)
      : skeleton_(skeleton), body_(body), q_(body.shaped_in.q_HJ) {
    if (static_cast<int>(q_.size()) != skeleton.size()) q_.assign(skeleton.size(), yUpToWorld());
  }

  std::vector<JointFrame> make() {
    if (!isPerson(body_)) return posed(skeleton_, q_);
    turnUpright();
    for (const Side side : {kLeft, kRight}) {
      spreadArm(side);
      spreadLeg(side);
    }
    return posed(skeleton_, q_);
  }

 private:
  const BodyPart& part(Side side, const char* name) const {
    return body_.parts[findPart(body_, side, name)];
  }

  // As makeBody() finds up and left, so that the axes are exactly those of its parts.
  void turnUpright() {
    const std::vector<JointFrame> frames = posed(skeleton_, q_);
    const auto at = [&](Side side, const char* name) -> Vector3d {
      return frames[part(side, name).joint].p_WJ;
    };
    const Vector3d feet = 0.5 * (at(kLeft, "instep") + at(kRight, "instep"));
    const Vector3d up = nearestAxis(frames[body_.parts[findPart(body_, "head")].joint].p_WJ - feet);
    const Vector3d left = nearestAxis(at(kLeft, "thigh") - at(kRight, "thigh"));
    Eigen::Matrix3d axes;
    axes << left.cross(up).transpose(), left.transpose(), up.transpose();
    if (axes.determinant() < 0.5) return;  // left is up: nobody stands so
    for (Quaterniond& q : q_) q = Quaterniond(axes) * q;
  }

  // Turns a joint, and all that hangs on it, so that `from`, of its frame, points to `to`.
  void swing(int joint, const Vector3d& from, const Vector3d& to) {
    if (!(from.norm() > 1e-9)) return;
    const Quaterniond turn = turnBetween(q_[joint] * from, to);
    for (int j = joint; j < skeleton_.size(); ++j)
      if (skeleton_.isAncestor(joint, j)) q_[j] = (turn * q_[j]).normalized();
  }

  // Where a joint below another is in that one's frame.
  Vector3d below(int joint, int child) const {
    const std::vector<JointFrame> frames = posed(skeleton_, q_);
    return q_[joint].conjugate() * (frames[child].p_WJ - frames[joint].p_WJ);
  }

  void spreadArm(Side side) {
    const double out = side == kLeft ? 1.0 : -1.0;
    const Vector3d straight(0.0, out * std::cos(kArms), -std::sin(kArms));
    const Vector3d bent = std::cos(kElbows) * straight + std::sin(kElbows) * Vector3d::UnitX();
    const BodyPart &upper = part(side, "upper arm"), &fore = part(side, "forearm"),
                   &hand = part(side, "hand");
    swing(upper.joint, below(upper.joint, fore.joint), straight);
    swing(fore.joint, fore.to - fore.from, bent);
    if (hand.joint != fore.joint) swing(hand.joint, hand.to - hand.from, bent);
  }

  void spreadLeg(Side side) {
    const double out = side == kLeft ? 1.0 : -1.0;
    const Vector3d down(0.0, out * std::sin(kLegs), -std::cos(kLegs));
    const BodyPart &thigh = part(side, "thigh"), &shank = part(side, "shank");
    const BodyPart &outside = part(side, "sole, outside"), &inside = part(side, "sole, inside");
    const BodyPart& toes = part(side, "toes");
    const Vector3d ahead =
        q_[outside.joint] * (outside.to - outside.from + inside.to - inside.from);
    swing(thigh.joint, below(thigh.joint, shank.joint), down);
    swing(shank.joint, below(shank.joint, outside.joint), down);
    levelFoot(outside, inside, ahead, out);
    if (toes.joint != outside.joint)
      swing(toes.joint, toes.to - toes.from,
            q_[outside.joint] * (outside.to - outside.from + inside.to - inside.from));
  }

  // Sole down and, as before, ahead.
  void levelFoot(const BodyPart& outside, const BodyPart& inside, Vector3d ahead, double out) {
    ahead.z() = 0.0;
    if (!(ahead.norm() > 1e-9)) ahead = Vector3d::UnitX();
    const Vector3d along = outside.to - outside.from + inside.to - inside.from;
    swing(outside.joint, along, ahead);
    Vector3d aside = q_[outside.joint] * (outside.to - inside.to);
    const Vector3d level = out * Vector3d::UnitZ().cross(ahead);
    if (!(aside.norm() > 1e-9)) return;
    const double roll = std::atan2(ahead.normalized().dot(aside.cross(level)), aside.dot(level));
    swing(outside.joint, q_[outside.joint].conjugate() * aside,
          Eigen::AngleAxisd(roll, ahead.normalized()) * aside);
  }

  const Skeleton& skeleton_;
  const Body& body_;
  std::vector<Quaterniond> q_;  // by joint, of its frame in the pose's
};

}  // namespace

std::vector<JointFrame> modelPose(const Skeleton& skeleton, const Body& body) {
  return Modelling(skeleton, body).make();
}

}  // namespace amble
