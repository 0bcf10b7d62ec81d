#include "viz/page/nearest_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace amble {
namespace {

using Eigen::Vector3d;

// Two points, and their distance [m].
struct Pair {
  Vector3d first, second;
  double distance = std::numeric_limits<double>::infinity();
  void take(const Vector3d& a, const Vector3d& b) {
    const double found = (a - b).norm();
    if (found < distance) *this = {a, b, found};
  }
};

// Ericson, "Real-Time Collision Detection" (2005), 5.1.9.
void takeSegments(const Vector3d& p, const Vector3d& p_end, const Vector3d& q,
                  const Vector3d& q_end, Pair& best) {
  const Vector3d u = p_end - p, v = q_end - q, w = p - q;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), vw = v.dot(w);
  const double sine = uu * vv - uv * uv;
  double s = sine > 1e-12 * uu * vv ? std::clamp((uv * vw - u.dot(w) * vv) / sine, 0.0, 1.0) : 0.0;
  const double t = vv > 0.0 ? std::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0.0;
  if (uu > 0.0) s = std::clamp((uv * t - u.dot(w)) / uu, 0.0, 1.0);
  best.take(p + s * u, q + t * v);
}

// The point below p in the triangle's plane, where that is within the triangle.
void takeFace(const Vector3d& p, const std::array<Vector3d, 3>& t, Pair& best) {
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  if (n.squaredNorm() <= 0.0) return;
  const Vector3d q = p - n.dot(p - t[0]) / n.squaredNorm() * n;
  for (int i = 0; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).cross(q - t[i]).dot(n) < 0.0) return;
  best.take(p, q);
}

bool isFar(const std::array<Vector3d, 3>& t, const Eigen::AlignedBox3d& near) {
  const Vector3d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
  const Vector3d high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  return (low.array() > near.max().array()).any() || (high.array() < near.min().array()).any();
}

Pair closest(const Vector3d& from, const Vector3d& to, const TriangleMesh& mesh, double reach) {
  Eigen::AlignedBox3d near(from);
  near.extend(to);
  near.min().array() -= reach;
  near.max().array() += reach;
  Pair best;
  for (const auto& corners : mesh.triangles) {
    const std::array<Vector3d, 3> t = {mesh.vertices[corners[0]], mesh.vertices[corners[1]],
                                       mesh.vertices[corners[2]]};
    if (isFar(t, near)) continue;
    takeFace(from, t, best);
    takeFace(to, t, best);
    for (int i = 0; i < 3; ++i) takeSegments(from, to, t[i], t[(i + 1) % 3], best);
  }
  return best;
}

}  // namespace

PageClearance nearestThings(const CollisionWorld& world, const Skeleton& skeleton,
                            const PoseArray& poses) {
  constexpr double kSlack = 0.005;  // of chords of round things [m]
  const Body& body = world.body();
  const auto scratch = world.makeScratch();
  std::map<int, TriangleMesh> meshes;
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Vector3d> from(body.parts.size()), to(body.parts.size());
  PageClearance all;
  PoseArray one(poses.joints());
  for (int frame = 0; frame < poses.size(); ++frame) {
    one.clear();
    one.append(poses[frame]);
    const Clearance near = world.clearance(one, kNearLimit, *scratch);
    all.part.push_back(near.part);
    all.object.push_back(near.object);
    Pair pair{Vector3d::Zero(), Vector3d::Zero()};
    if (near.object >= 0) {
      forwardKinematics(skeleton, poses[frame], joints);
      placeBody(body, joints, from, to);
      auto mesh = meshes.find(near.object);
      if (mesh == meshes.end())
        mesh = meshes.emplace(near.object, worldMesh(world.scene().objects[near.object])).first;
      const double radius = body.parts[near.part].radius;
      pair = closest(from[near.part], to[near.part], mesh->second, near.distance + radius + kSlack);
    }
    const bool found = pair.distance > 0.0 && std::isfinite(pair.distance);
    if (found) {
      const double radius = std::min(body.parts[near.part].radius, pair.distance);
      pair.first += radius / pair.distance * (pair.second - pair.first);
    }
    all.distance.push_back(found ? static_cast<float>(near.distance) : -1.0f);
    all.on_body.push_back(pair.first.cast<float>());
    all.on_it.push_back(pair.second.cast<float>());
  }
  return all;
}

}  // namespace amble
