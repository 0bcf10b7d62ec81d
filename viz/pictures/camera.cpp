#include "viz/pictures/camera.h"

#include <algorithm>
#include <cmath>

namespace amble {

using Eigen::Matrix3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

// Across the picture's width [rad]; narrow: rooms look like models
constexpr float kFieldOfView = 0.56f;

// Smallest and largest of the points' pixels.
Eigen::AlignedBox2f pixelBounds(const Camera& camera, std::span<const Vector3f> points) {
  Eigen::AlignedBox2f box;
  for (const Vector3f& p : points) {
    Vector3f v = camera.toView(p);
    v.z() = std::max(v.z(), 0.01f);
    box.extend(camera.toPixel(v));
  }
  return box;
}

}  // namespace

Camera Camera::enlarged(float factor) const {
  Camera camera = *this;
  camera.centre *= factor;
  camera.scale *= factor;
  return camera;
}

Matrix3f viewAxes(const Vector3f& forward) {
  Matrix3f axes;
  const Vector3f right = forward.cross(Vector3f::UnitZ()).normalized();
  axes.row(0) = right;
  axes.row(1) = forward.cross(right).normalized();
  axes.row(2) = forward.normalized();
  return axes;
}

Camera frameView(std::span<const Vector3f> points, const ViewDirection& from, int width, int height,
                 float margin) {
  Eigen::AlignedBox3f box;
  for (const Vector3f& p : points) box.extend(p);
  const double level = std::cos(from.elevation);
  const Vector3f back(static_cast<float>(level * std::cos(from.azimuth)),
                      static_cast<float>(level * std::sin(from.azimuth)),
                      static_cast<float>(std::sin(from.elevation)));
  Camera camera;
  camera.axes = viewAxes(-back);
  camera.scale = 0.5f * static_cast<float>(width) / std::tan(kFieldOfView / 2);
  const Vector2f room(static_cast<float>(width) - 2 * margin,
                      static_cast<float>(height) - 2 * margin);
  float near = box.diagonal().norm() * 0.5f + 0.1f;
  float far = near * 40;
  for (int i = 0; i < 40; ++i) {  // the farther, the smaller: halve the interval of distances
    const float distance = (near + far) / 2;
    camera.eye = box.center() + distance * back;
    const Vector2f size = pixelBounds(camera, points).sizes();
    (size.x() > room.x() || size.y() > room.y() ? near : far) = distance;
  }
  camera.eye = box.center() + far * back;
  camera.centre = Vector2f(static_cast<float>(width), static_cast<float>(height)) / 2 -
                  pixelBounds(camera, points).center();
  return camera;
}

}  // namespace amble
