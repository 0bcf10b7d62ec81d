/// The body: capsules on the bones, with radii from a published table of body segments, and feet as
/// soles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/pose.h"
#include "animation/body/skeleton.h"

namespace amble {

struct FootShape;  // foot_shape.h

/// A capsule in its joint's frame.
struct BodyPart {
  std::string name;  ///< "left hand", "head", ...
  int joint = 0;
  Eigen::Vector3d from;  ///< ends of its axis, in the joint's frame [m]
  Eigen::Vector3d to;
  double radius = 0.0;  ///< [m, > 0]
  int sole = -1;  ///< Side, if this part is a sole and may touch the ground while planted; else -1
};

struct Body {
  std::vector<BodyPart> parts;

  int head = -1;  ///< the part
  /// How tall the body counts as at every frame, over its lowest sole: a walking head dips by some
  /// centimetres from step to step, and nobody passes upright under what is lower than he stands.
  /// 0 where it may stoop: the capsules alone count then [m, >= 0]
  double upright = 0.0;
  /// The pose in which the parts were shaped; empty: the rest pose.
  ReferencePose shaped_in = {};
};

/// How far joints of a foot are over the ground while its sole is flat.
struct SoleHeight {
  double ankle = 0.0;  ///< [m, > 0]
  double toe = 0.0;    ///< of the toe joint (ball) [m, > 0]
};
/// By Side.
using SoleHeights = std::array<SoleHeight, 2>;
SoleHeights soleHeights(const std::array<FootShape, 2>& feet);
SoleHeights evenSoles(const SoleHeight& both);

/// How somebody with the skeleton stands.
struct BodyStance {
  /// In which parts are shaped: across is to the left there, and up is up. Without it, or where it
  /// is the rest pose, that is taken: of rigs whose joints all point along their bones it is
  /// nobody's.
  ReferencePose upright = {};
  /// The head's joint, over a floor at z = 0: the head ends at the stature then. Without it where
  /// the pose has the head: people who stand in another are lower than they say.
  std::optional<JointFrame> head = {};
};

/// Radii are fractions of stature. Shoulder to shoulder and chest front to back are covered by more
/// than one capsule. Soles' undersides lie on the ground when the feet of the rest pose do.
Body makeBody(const Skeleton& skeleton, const JointRoles& roles, double stature,
              const SoleHeights& soles, const BodyStance& stance = {});

/// Capsule ends of every part in World. @pre from.size() == to.size() == parts.size()
void placeBody(const Body& body, std::span<const JointFrame> joints,
               std::span<Eigen::Vector3d> from, std::span<Eigen::Vector3d> to);

}  // namespace amble
