/// The foot as a walker rolls over it: a flat sole between two round ends, heel and ball.
///
/// Sole frame: origin in the middle of the sole's length on the ground, x towards the toes, z up,
/// while the foot is flat. The foot rolls about the centre of its heel when the toes are up and
/// about the toe joint (ball) when the heel is up; both lie `radius` above a flat sole, so that a
/// round end stays tangent to the ground while it rolls and its point of contact stays where it is.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"

namespace amble {

struct FootShape {
  /// Of heel and ball, height of the toe joint over a flat sole: each foot has its own [m, > 0].
  double radius = 0.0;
  double ankle_height = 0.0;  ///< over a flat sole [m]
  /// Of the ankle, of heel centre, toe joint and toe tip's centre, in the sole frame [m].
  double ankle_x = 0.0, heel_x = 0.0, ball_x = 0.0, tip_x = 0.0;
  double half_width = 0.0;  ///< of the sole [m, > 0]
  /// Foot joint in the sole frame, and toe joint in the foot joint, while flat.
  Eigen::Quaterniond q_SF = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond q_FT = Eigen::Quaterniond::Identity();
  /// The sole frame's y in the toe joint's frame while flat [unit].
  Eigen::Vector3d lateral_T = Eigen::Vector3d::UnitY();
};

/// Drillis & Contini (1966): foot length 0.152 of stature; thigh and shank together 0.491.
inline constexpr double kFootLengthOfStature = 0.152;
inline constexpr double kLegOfStature = 0.491;
/// Height of the ankle joint over the sole in leg lengths: 0.039 of stature (Drillis & Contini).
inline constexpr double kAnkleHeightOfLeg = 0.039 / kLegOfStature;
/// Breadth of the foot: Gordon et al. (1989), 0.101 of 1.756 m, as the body's soles have it.
inline constexpr double kFootBreadthOfStature = 0.0575;
/// Height of the toe joint over the sole, of both feet in the mean; chosen so that the ankle of our
/// captures comes to Drillis & Contini's 0.039 of stature. No toe joint is lower than the second,
/// for feet have some height and roll about it: where one would be, both ankles are higher.
inline constexpr double kBallHeightOfStature = 0.0095, kLowestBallOfStature = 0.006;

/// Stature from leg length (thigh + shank) [m].
double statureOf(const Skeleton& skeleton, const JointRoles& roles);

/// Feet are flat in the rest pose (all rotations zero), as in every common rig. Both ankles are as
/// high over the sole: captured ones are, to some millimetres, and a leg that stood on a higher one
/// would be bent. What feet of one rig differ by in how far they drop, the toe joint's height
/// takes.
/// @pre the roles have toe joints
FootShape makeFootShape(const Skeleton& skeleton, const JointRoles& roles, Side side,
                        double stature);
/// Of both feet, by Side.
std::array<FootShape, 2> makeFootShapes(const Skeleton& skeleton, const JointRoles& roles,
                                        double stature);

/// Rest pose's frame in the heading frame (x forward, y left, z up): forward is where the feet
/// point.
Eigen::Quaterniond restToHeading(const Skeleton& skeleton, const JointRoles& roles);
/// The same where forward is across the line of the hip joints, wherever the feet point.
Eigen::Quaterniond restToPelvisHeading(const Skeleton& skeleton, const JointRoles& roles);

/// The sole frame in World, of a foot that heads so and stands on a plane with this normal [need
/// not be a unit vector, z > 0]: turned about the vertical, then tilted on the shortest way.
/// Exactly the first where the normal is vertical.
Eigen::Quaterniond soleFrame(double heading, const Eigen::Vector3d& normal);

/// Undersides of the round ends of a foot's sole [m, World].
struct SoleEnds {
  Eigen::Vector3d heel, ball;
};
/// Of a foot whose ankle is at `ankle` and whose joint is turned by q_WF.
SoleEnds soleEnds(const FootShape& shape, const Eigen::Vector3d& ankle,
                  const Eigen::Quaterniond& q_WF);
/// How high a sole is over the lines that its ends go along from print to print: the less of heel
/// and ball [m].
double heightOver(const SoleEnds& from, const SoleEnds& to, const SoleEnds& sole);

/// Where the ankle is over a sole whose frame lies at the origin and that is rolled by `pitch`
/// [rad, toes down positive]: about heel or ball, in the sole frame [m].
Eigen::Vector3d rolledAnkle(const FootShape& shape, double pitch);
/// Where the ball goes, in the sole frame, when the toes roll over their tip by an angle
/// [rad, >= 0] [m].
Eigen::Vector3d rolledBall(const FootShape& shape, double toes);

}  // namespace amble
