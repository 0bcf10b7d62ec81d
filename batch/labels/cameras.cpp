#include "batch/labels/cameras.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

constexpr int kSides = 12, kLooks = 8;
constexpr double kLine = 0.01, kLens = 0.1;  // radii: of a line of sight, of a camera [m]
constexpr double kHeights[] = {1.6, 2.3};    // over the ground in the middle [m]
constexpr double kDistances[] = {2.0, 3.5};  // beyond the walk [m]
constexpr double kApart = 50.0 * kDegree;    // cameras that are told, about the walk
constexpr double kMargin = 0.15;             // of the picture, around the walk [rad]

// Head and hips now and then.
std::vector<Eigen::Vector3d> pointsToSee(const RunResult& run) {
  const WalkSynthesizer& walker = run.problem->synthesizer;
  const PoseArray& poses = run.outcome.walk.buffer.poses;
  std::vector<JointFrame> joints(static_cast<size_t>(walker.skeleton().size()));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kLooks; ++i) {
    forwardKinematics(walker.skeleton(), poses[(poses.size() - 1) * i / (kLooks - 1)], joints);
    for (const int joint : {walker.roles().hips, walker.roles().head})
      if (joint >= 0) points.push_back(joints[static_cast<size_t>(joint)].p_WJ);
  }
  return points;
}

CameraView lookFrom(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                    const std::vector<Eigen::Vector3d>& points, const CollisionWorld& world,
                    CollisionScratch& scratch) {
  CameraView view{position, target, 0.0, 0.0};
  if (world.touched(position, position, kLens, scratch) >= 0) return view;
  const Eigen::Vector3d axis = (target - position).normalized();
  int seen = 0;
  for (const Eigen::Vector3d& point : points) {
    const double cosine = (point - position).normalized().dot(axis);
    const double angle = 2.0 * (std::acos(std::clamp(cosine, -1.0, 1.0)) + kMargin);
    view.field_of_view = std::max(view.field_of_view, angle);
    if (angle <= kWidestView && world.touched(position, point, kLine, scratch) < 0) ++seen;
  }
  view.field_of_view = std::min(view.field_of_view, kWidestView);
  view.seen = static_cast<double>(seen) / static_cast<double>(points.size());
  return view;
}

double sideOf(const CameraView& view) {
  return std::atan2(view.position.y() - view.target.y(), view.position.x() - view.target.x());
}

}  // namespace

std::vector<CameraView> suggestCameras(const RunResult& run) {
  const std::vector<Eigen::Vector3d> points = pointsToSee(run);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const Eigen::Vector3d target = box.center();
  const double ground = run.outcome.walk.buffer.states.front().position.z();
  const double reach = 0.5 * box.sizes().head<2>().norm();
  const auto scratch = run.problem->world.makeScratch();
  std::vector<CameraView> all;
  for (int side = 0; side < kSides; ++side) {
    const double angle = 2.0 * kPi * side / kSides;
    for (const double distance : kDistances) {
      for (const double height : kHeights) {
        const Eigen::Vector2d at =
            target.head<2>() +
            (reach + distance) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        all.push_back(lookFrom({at.x(), at.y(), ground + height}, target, points,
                               run.problem->world, *scratch));
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.seen > b.seen; });
  std::vector<CameraView> chosen;
  for (const CameraView& view : all) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const CameraView& other) {
      return std::abs(wrapAngle(sideOf(view) - sideOf(other))) >= kApart;
    });
    if (view.seen >= kLeastSeen && apart && static_cast<int>(chosen.size()) < kMostCameras)
      chosen.push_back(view);
  }
  return chosen;
}

}  // namespace amble
