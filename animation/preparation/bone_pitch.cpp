#include "animation/preparation/bone_pitch.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {

double seenDown(const Eigen::Vector3d& bone, double heading) {
  const Eigen::Vector3d seen = aboutZ(-heading) * bone;
  return std::atan2(-seen.z(), seen.x());
}

double flatDrop(const FootShape& shape) {
  return std::atan2(shape.ankle_height - shape.radius, shape.ball_x - shape.ankle_x);
}

double pitchOfBone(double down, double yaw, double roll, const FootShape& shape) {
  const double ahead = shape.ball_x - shape.ankle_x, under = shape.ankle_height - shape.radius;
  const double across = under * std::sin(roll), below = under * std::cos(roll);
  const double sine = std::sin(down), cosine = std::cos(down);
  const double size = std::hypot(ahead, below) * std::hypot(cosine, std::cos(yaw) * sine);
  const double aside = std::asin(std::clamp(across * std::sin(yaw) * sine / size, -1.0, 1.0));
  return wrapAngle(std::atan2(std::cos(yaw) * sine, cosine) - aside - std::atan2(below, ahead));
}

}  // namespace amble
