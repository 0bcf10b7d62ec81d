#include "viz/figure/bone_figure.h"

#include <algorithm>

#include "animation/body/reference_pose.h"
#include "base/rotation.h"

namespace amble {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr std::array<std::uint8_t, 3> kBone = {196, 186, 166}, kJoint = {88, 104, 128};
constexpr double kAlone = 0.1;       // a bone where a skeleton has none [m]
constexpr double kThick = 0.1;       // half a bone's breadth over its length
constexpr double kWidest = 0.25;     // where along it that is
constexpr double kJointSize = 0.08;  // of a usual bone's length

// Corners: both ends and four around the axis.
void addOctahedron(Figure& figure, int joint, const Vector3d& from, const Vector3d& to,
                   double widest, double half, const std::array<std::uint8_t, 3>& color) {
  const Vector3d axis = (to - from).normalized();
  const Vector3d a = axis.unitOrthogonal(), b = axis.cross(a);
  const Vector3d middle = from + widest * (to - from);
  const std::array<Vector3d, 4> around = {middle + half * a, middle + half * b, middle - half * a,
                                          middle - half * b};
  const auto face = [&](const Vector3d& p, const Vector3d& q, const Vector3d& r) {
    const auto first = static_cast<std::uint32_t>(figure.vertices.size());
    const Vector3f normal = (q - p).cross(r - p).normalized().cast<float>();
    for (const Vector3d& corner : {p, q, r}) {
      figure.vertices.push_back(corner.cast<float>());
      figure.normals.push_back(normal);
      figure.colors.push_back(color);
      figure.joints.push_back({static_cast<std::uint16_t>(joint), 0, 0, 0});
      figure.weights.push_back({1.0F, 0.0F, 0.0F, 0.0F});
    }
    figure.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < 4; ++i) {
    face(around[i], around[(i + 1) % 4], to);
    face(around[(i + 1) % 4], around[i], from);
  }
}

// Tips of the bones that begin at a joint, in its frame.
std::vector<std::vector<Vector3d>> bonesOf(const Skeleton& skeleton) {
  std::vector<std::vector<Vector3d>> tips(skeleton.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joint(j);
    if (joint.parent >= 0) tips[joint.parent].push_back(joint.offset);
    tips[j].insert(tips[j].end(), joint.end_sites.begin(), joint.end_sites.end());
  }
  return tips;
}

double usualLength(const std::vector<std::vector<Vector3d>>& bones) {
  std::vector<double> lengths;
  for (const auto& tips : bones)
    for (const Vector3d& tip : tips)
      if (tip.norm() > 0.0) lengths.push_back(tip.norm());
  if (lengths.empty()) return kAlone;
  std::nth_element(lengths.begin(), lengths.begin() + lengths.size() / 2, lengths.end());
  return lengths[lengths.size() / 2];
}

}  // namespace

Figure makeBoneFigure(const Skeleton& skeleton) {
  Figure figure;
  figure.bind = posed(skeleton, std::vector<Eigen::Quaterniond>(skeleton.size(), yUpToWorld()));
  const auto bones = bonesOf(skeleton);
  const double usual = usualLength(bones);
  for (int j = 0; j < skeleton.size(); ++j) {
    const Vector3d at = figure.bind[j].p_WJ, half = kJointSize * usual * Vector3d::UnitZ();
    addOctahedron(figure, j, at - half, at + half, 0.5, kJointSize * usual, kJoint);
    for (const Vector3d& tip : bones[j]) {
      const double length = tip.norm();
      if (length < 1e-3 * usual) continue;
      addOctahedron(figure, j, at, figure.bind[j] * tip, kWidest,
                    std::min(kThick * length, 0.5 * kThick * (length + usual)), kBone);
    }
  }
  return figure;
}

}  // namespace amble
