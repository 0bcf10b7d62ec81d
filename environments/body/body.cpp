#include "environments/body/body.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Means of men in the 1988 anthropometric survey of US Army personnel (Gordon et al.,
// NATICK/TR-89/044), rounded to millimetres, over their mean stature. Lengths of bones are not
// taken from it: they are the skeleton's.
constexpr double kStature = 1.756;
constexpr double fraction(double metres) { return metres / kStature; }
constexpr double radiusOf(double circumference) { return circumference / (2.0 * kPi) / kStature; }

constexpr double kHead = radiusOf(0.568);
constexpr double kHeadHeight = fraction(0.232);  // chin to crown
constexpr double kNeck = radiusOf(0.380);
constexpr double kChestBreadth = fraction(0.322), kChestDepth = fraction(0.243);
constexpr double kWaistBreadth = fraction(0.309), kWaistDepth = fraction(0.226);
constexpr double kHipBreadth = fraction(0.342), kButtockDepth = fraction(0.248);
constexpr double kUpperArm = radiusOf(0.338);  // biceps, flexed
constexpr double kForearm = radiusOf(0.302);   // flexed
constexpr double kWrist = radiusOf(0.174);
constexpr double kHandLength = fraction(0.194), kHandBreadth = fraction(0.090);
constexpr double kThigh = radiusOf(0.5 * (0.597 + 0.386));  // between the crotch's and the knee's
constexpr double kKnee = radiusOf(0.386);
constexpr double kCalf = radiusOf(0.378);
constexpr double kAnkle = radiusOf(0.222);
constexpr double kFootBreadth = fraction(0.101);

// A sole's radius is the ball joint's height, so that a foot that rolls about the ball does not
// sink in; but feet whose toe joint lies on the floor have some height all the same, as a fraction
// of stature.
constexpr double kThinnestSole = kLowestBallOfStature;

// Of the ankle's height over the sole: a rig's ankle may be lower than an ankle is thick, and the
// shank, which leans by thirty degrees while its foot stands, must not reach the ground.
constexpr double kShankOverSole = 0.6;

const std::array<std::string, 2> kSideNames = {"left ", "right "};

Eigen::Vector3d nearestAxis(const Eigen::Vector3d& v) {
  Eigen::Index axis;
  v.cwiseAbs().maxCoeff(&axis);
  Eigen::Vector3d unit = Eigen::Vector3d::Zero();
  unit[axis] = v[axis] < 0.0 ? -1.0 : 1.0;
  return unit;
}

class BodyMaker {
 public:
  BodyMaker(const Skeleton& skeleton, const JointRoles& roles, double stature,
            const SoleHeights& soles, const BodyStance& stance)
      : skeleton_(skeleton),
        roles_(roles),
        stature_(stature),
        soles_(soles),
        standing_head_(stance.head) {
    body_.shaped_in = stance.upright;
    // The rest pose, in which every joint's axes are the root's.
    const std::vector<Eigen::Quaterniond> level(skeleton.size(), Eigen::Quaterniond::Identity());
    rest_ = upright(level);
    at_rest_ = isRest(stance.upright);
    pose_ = at_rest_ ? rest_ : upright(stance.upright.q_HJ);
  }

  Body make() {
    addTrunk();
    for (Side side : {kLeft, kRight}) {
      addArm(side);
      addLeg(side);
      addFoot(side);
    }
    return std::move(body_);
  }

 private:
  // A pose, and where up, left and ahead are in it.
  struct Upright {
    std::vector<Eigen::Vector3d> at;    // by joint, from the root [m]
    std::vector<Eigen::Quaterniond> q;  // joint axes in the pose's
    Eigen::Vector3d feet;               // between the ankles
    Eigen::Vector3d up, left, forward;
  };

  Upright upright(const std::vector<Eigen::Quaterniond>& rotations) const {
    Upright pose;
    for (const JointFrame& frame : posed(skeleton_, rotations)) {
      pose.at.push_back(frame.p_WJ);
      pose.q.push_back(frame.q_WJ);
    }
    const LegJoints &l = roles_.legs[kLeft], &r = roles_.legs[kRight];
    pose.feet = 0.5 * (pose.at[l.foot] + pose.at[r.foot]);
    pose.up = nearestAxis(pose.at[roles_.head] - pose.feet);
    pose.left = nearestAxis(pose.at[l.up_leg] - pose.at[r.up_leg]);
    pose.forward = pose.left.cross(pose.up);
    return pose;
  }

  // Whether all joints' axes are the root's.
  static bool isRest(const ReferencePose& pose) {
    return std::all_of(pose.q_HJ.begin(), pose.q_HJ.end(), [&](const Eigen::Quaterniond& q) {
      return q.coeffs() == pose.q_HJ.front().coeffs();
    });
  }

  // @param from, to  from the joint, as it stands in the pose
  void add(std::string name, int joint, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
           double radius, int sole = -1) {
    const Eigen::Quaterniond q_JR = pose_.q[joint].conjugate();
    body_.parts.push_back({std::move(name), joint, q_JR * from, q_JR * to, radius, sole});
  }

  // The same, as it stands in the rest pose.
  void addLevel(std::string name, int joint, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                double radius, int sole) {
    body_.parts.push_back({std::move(name), joint, from, to, radius, sole});
  }

  // A cross-section `breadth` wide and `depth` deep (fractions of stature) about a point of the
  // rest pose.
  void addAcross(const std::string& name, int joint, const Eigen::Vector3d& rest_centre,
                 double breadth, double depth) {
    const Eigen::Vector3d half = pose_.left * (0.5 * (breadth - depth) * stature_);
    const Eigen::Vector3d centre = rest_centre - pose_.at[joint];
    add(name, joint, centre + half, centre - half, 0.5 * depth * stature_);
  }

  // Along a limb from its joint, tapering: it ends with `end_radius` around the next joint.
  void addLimb(const std::string& name, int joint, const Eigen::Vector3d& bone, double radius,
               double end_radius) {
    const double length = bone.norm();
    const double back = std::min(length, (radius - end_radius) * stature_);
    add(name, joint, Eigen::Vector3d::Zero(),
        length > 0.0 ? Eigen::Vector3d(bone * (1.0 - back / length)) : bone, radius * stature_);
  }

  void addTrunk() {
    const Eigen::Vector3d hip_joints =
        0.5 * (pose_.at[roles_.legs[kLeft].up_leg] + pose_.at[roles_.legs[kRight].up_leg]);
    const Eigen::Vector3d shoulders =
        0.5 * (pose_.at[roles_.arms[kLeft].arm] + pose_.at[roles_.arms[kRight].arm]);
    const int spine = roles_.spine >= 0 ? roles_.spine : roles_.hips;
    const int chest = roles_.chest >= 0 ? roles_.chest : spine;
    const Eigen::Vector3d& p_chest = pose_.at[chest];
    addAcross("pelvis", roles_.hips, 0.5 * (hip_joints + pose_.at[roles_.hips]), kHipBreadth,
              kButtockDepth);
    addAcross("abdomen", spine, 0.5 * (pose_.at[roles_.hips] + p_chest), kWaistBreadth,
              kWaistDepth);
    addAcross("chest", chest, 0.5 * (p_chest + shoulders), kChestBreadth, kChestDepth);
    const Eigen::Vector3d nape = pose_.at[roles_.head] + neckAboveHead() * pose_.up;
    if (roles_.neck >= 0 && roles_.neck != roles_.head)
      add("neck", roles_.neck, Eigen::Vector3d::Zero(), nape - pose_.at[roles_.neck],
          kNeck * stature_);
    else
      add("neck", chest, shoulders - p_chest, nape - p_chest, kNeck * stature_);
    addHead();
  }

  // Height of the crown over the head's joint, along the head: at the body's stature when it
  // stands.
  double crown() const {
    const double least = kHead * stature_;
    if (standing_head_) {
      const double upright =
          (standing_head_->q_WJ * pose_.q[roles_.head].conjugate() * pose_.up).z();
      return std::max(least, least + (stature_ - least - standing_head_->p_WJ.z()) / upright);
    }
    const double joint_height = 0.5 * (soles_[kLeft].ankle + soles_[kRight].ankle) +
                                pose_.up.dot(pose_.at[roles_.head] - pose_.feet);
    return std::clamp(stature_ - joint_height, least, kHeadHeight * stature_);
  }

  double chin() const { return crown() - kHeadHeight * stature_; }

  // How far the neck goes on over the head's joint: to the head, where a rig has that joint so low
  // that they would not meet.
  double neckAboveHead() const { return chin() > kNeck * stature_ ? chin() : 0.0; }

  void addHead() {
    const double crown = this->crown(), chin = this->chin(), radius = kHead * stature_;
    body_.head = static_cast<int>(body_.parts.size());
    add("head", roles_.head, pose_.up * (chin + radius), pose_.up * (crown - radius), radius);
  }

  void addArm(Side side) {
    const ArmJoints& arm = roles_.arms[side];
    const int chest = roles_.chest >= 0 ? roles_.chest : roles_.hips;
    const int collar = arm.shoulder >= 0 ? arm.shoulder : chest;
    const std::string& name = kSideNames[side];
    const Eigen::Vector3d to = pose_.at[arm.arm] - pose_.at[collar];
    // Of a rig without collar bones from the spine, at the shoulders' height.
    const Eigen::Vector3d from = (arm.shoulder < 0 ? pose_.up.dot(to) : 0.0) * pose_.up;
    add(name + "shoulder", collar, from, to, kUpperArm * stature_);
    addLimb(name + "upper arm", arm.arm, pose_.at[arm.fore_arm] - pose_.at[arm.arm], kUpperArm,
            kForearm);
    const Eigen::Vector3d bone = forearmBone(arm);
    addLimb(name + "forearm", arm.fore_arm, bone, kForearm, kWrist);
    const int hand = arm.hand >= 0 ? arm.hand : arm.fore_arm;
    const Eigen::Vector3d wrist = arm.hand >= 0 ? Eigen::Vector3d(0, 0, 0) : bone;
    const double radius = 0.5 * kHandBreadth * stature_;
    const Eigen::Vector3d along = handWay(arm, bone);
    add(name + "hand", hand, wrist, wrist + along * (kHandLength * stature_ - radius), radius);
  }

  // From the wrist to the fingers. In a rest pose hands go on from forearms. A pose of somebody who
  // stands or walks bends its wrists as it happens; of such a rig, whose joints all point along
  // their bones, the hand's own end says where it is, whatever the pose.
  Eigen::Vector3d handWay(const ArmJoints& arm, const Eigen::Vector3d& bone) const {
    if (!at_rest_ && arm.hand >= 0) {
      const auto& ends = skeleton_.joint(arm.hand).end_sites;
      if (!ends.empty() && ends.front().norm() > 0.0)
        return pose_.q[arm.hand] * ends.front().normalized();
    }
    return bone.norm() > 0.0 ? Eigen::Vector3d(bone.normalized()) : -pose_.up;
  }

  // Elbow to wrist; a rig without wrists has the mean proportion (Drillis and Contini 1966: 0.146
  // of stature).
  Eigen::Vector3d forearmBone(const ArmJoints& arm) const {
    if (arm.hand >= 0) return pose_.at[arm.hand] - pose_.at[arm.fore_arm];
    const auto& ends = skeleton_.joint(arm.fore_arm).end_sites;
    if (!ends.empty() && ends.front().norm() > 0.0) return pose_.q[arm.fore_arm] * ends.front();
    return 0.146 * stature_ * (pose_.at[arm.fore_arm] - pose_.at[arm.arm]).normalized();
  }

  void addLeg(Side side) {
    const LegJoints& leg = roles_.legs[side];
    addLimb(kSideNames[side] + "thigh", leg.up_leg, pose_.at[leg.leg] - pose_.at[leg.up_leg],
            kThigh, kKnee);
    addLimb(kSideNames[side] + "shank", leg.leg, pose_.at[leg.foot] - pose_.at[leg.leg], kCalf,
            std::min(kAnkle, kShankOverSole * soles_[side].ankle / stature_));
  }

  // The sole is two capsules from the heel to either side of the ball, the toes one more, the
  // instep one above them. Heel and tip lie where FootShape has them, about whose ends walkers
  // roll: a foot that rolls does not sink in.
  void addFoot(Side side) {
    const LegJoints& leg = roles_.legs[side];
    const SoleHeight& sole = soles_[side];
    const double length = kFootLengthOfStature * stature_,
                 half_breadth = 0.5 * kFootBreadth * stature_;
    const double radius = std::clamp(sole.toe, kThinnestSole * stature_, half_breadth);
    Eigen::Vector3d ball = rest_.forward * (0.5 * length) - rest_.up * (sole.ankle - sole.toe);
    double heel = 0.2 * length,
           tip = 0.27 * length - radius;  // centres: behind the ankle, before the ball
    if (leg.toe >= 0) {
      ball = rest_.at[leg.toe] - rest_.at[leg.foot];
      const FootShape shape = makeFootShape(skeleton_, roles_, side, stature_);
      heel = shape.ankle_x - shape.heel_x;
      tip = shape.tip_x - shape.ball_x;
    }
    const auto [normal, along] = solePlane(ball, sole);
    const Eigen::Vector3d p_heel = normal * (radius - sole.ankle) - along * heel;
    const Eigen::Vector3d p_ball = ball + normal * (radius - sole.toe);
    const Eigen::Vector3d out = normal.cross(along) * (side == kLeft ? 1.0 : -1.0);
    const Eigen::Vector3d spread = out * (half_breadth - radius);
    const std::string& name = kSideNames[side];
    addLevel(name + "sole, outside", leg.foot, p_heel, p_ball + spread, radius, side);
    addLevel(name + "sole, inside", leg.foot, p_heel, p_ball - spread, radius, side);
    const Eigen::Vector3d p_toe = leg.toe >= 0 ? Eigen::Vector3d(p_ball - ball) : p_ball;
    addLevel(name + "toes", leg.toe >= 0 ? leg.toe : leg.foot, p_toe,
             p_toe + along * std::max(0.0, tip), radius, side);
    // As thick as the ankle, but not below the sole.
    const Eigen::Vector3d middle = 0.5 * ball;
    const double instep = std::min({kAnkle * stature_, 0.5 * (sole.ankle + sole.toe), sole.ankle});
    addLevel(name + "instep", leg.foot, Eigen::Vector3d::Zero(), middle, instep, side);
  }

  struct SolePlane {
    Eigen::Vector3d normal, along;  // unit, in the foot's frame
  };
  // The plane that the ankle is sole.ankle and the ball sole.toe above: normal = cos(b) up + sin(b)
  // ahead with normal . ball = sole.toe - sole.ankle. It is level in the rest pose where the rig's
  // feet are flat then.
  SolePlane solePlane(const Eigen::Vector3d& ball, const SoleHeight& sole) const {
    const double rise = rest_.up.dot(ball);
    Eigen::Vector3d ahead = ball - rest_.up * rise;
    double run = ahead.norm();
    ahead = run > 0.0 ? Eigen::Vector3d(ahead / run) : rest_.forward;
    if (run < -rise && ahead.dot(rest_.forward) < 0.0) {  // toes that hang, and a little back
      ahead = -ahead;
      run = -run;
    }
    const double length = std::hypot(run, rise);
    const double sine =
        length > 0.0 ? std::clamp((sole.toe - sole.ankle) / length, -1.0, 1.0) : 0.0;
    const double tilt = std::asin(sine) - std::atan2(rise, run);
    return {std::cos(tilt) * rest_.up + std::sin(tilt) * ahead,
            std::cos(tilt) * ahead - std::sin(tilt) * rest_.up};
  }

  const Skeleton& skeleton_;
  const JointRoles& roles_;
  const double stature_;
  const SoleHeights soles_;
  const std::optional<JointFrame> standing_head_;
  bool at_rest_ = false;  // somebody stands in the rest pose
  Upright rest_;          // in which feet are flat (FootShape)
  Upright pose_;          // in which somebody stands
  Body body_;
};

}  // namespace

SoleHeights evenSoles(const SoleHeight& both) { return {both, both}; }

SoleHeights soleHeights(const std::array<FootShape, 2>& feet) {
  const auto of = [&](Side side) { return SoleHeight{feet[side].ankle_height, feet[side].radius}; };
  return {of(kLeft), of(kRight)};
}

Body makeBody(const Skeleton& skeleton, const JointRoles& roles, double stature,
              const SoleHeights& soles, const BodyStance& stance) {
  assert(stature > 0.0);
  assert(std::ranges::all_of(
      soles, [](const SoleHeight& sole) { return sole.ankle > 0.0 && sole.toe >= 0.0; }));
  return BodyMaker(skeleton, roles, stature, soles, stance).make();
}

void placeBody(const Body& body, std::span<const JointFrame> joints,
               std::span<Eigen::Vector3d> from, std::span<Eigen::Vector3d> to) {
  assert(from.size() == body.parts.size() && to.size() == body.parts.size());
  for (size_t i = 0; i < body.parts.size(); ++i) {
    const BodyPart& part = body.parts[i];
    from[i] = joints[part.joint] * part.from;
    to[i] = joints[part.joint] * part.to;
  }
}

}  // namespace amble
