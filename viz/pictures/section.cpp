#include "viz/pictures/section.h"

#include <algorithm>
#include <array>

namespace amble {

SceneSection::SceneSection(const Scene& scene) {
  for (const SceneObject& object : scene.objects) {
    if (object.role == Role::kIgnore) continue;
    const TriangleMesh mesh = worldMesh(object);
    for (const auto& triangle : mesh.triangles)
      for (const int corner : triangle) corners_.push_back(mesh.vertices[corner]);
  }
}

std::vector<SectionLine> SceneSection::cut(const Eigen::Vector3d& point,
                                           const Eigen::Vector3d& along, double reach) const {
  const Eigen::Vector3d normal(-along.y(), along.x(), 0.0);
  std::vector<SectionLine> lines;
  for (size_t i = 0; i < corners_.size(); i += 3) {
    std::array<double, 3> off;
    for (int k = 0; k < 3; ++k) off[k] = normal.dot(corners_[i + k] - point);
    if ((off[0] > 0.0) == (off[1] > 0.0) && (off[1] > 0.0) == (off[2] > 0.0)) continue;
    std::array<Eigen::Vector2d, 2> ends;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if ((off[k] > 0.0) == (off[next] > 0.0)) continue;
      const double t = off[k] / (off[k] - off[next]);
      const Eigen::Vector3d at = (1.0 - t) * corners_[i + k] + t * corners_[i + next];
      ends[count++] = {along.dot(at - point), at.z()};
    }
    const auto [low, high] = std::minmax(ends[0].x(), ends[1].x());
    if (low <= reach && high >= -reach) lines.push_back({ends[0], ends[1]});
  }
  return lines;
}

}  // namespace amble
