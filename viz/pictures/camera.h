/// A camera without lens faults: perspective or parallel.
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace amble {

struct Camera {
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();  ///< World [m]
  /// Rows: right, down and forward in World, of unit length.
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  /// Where the forward axis meets the picture [pixels].
  Eigen::Vector2f centre = Eigen::Vector2f::Zero();
  float scale = 1.0f;  ///< perspective: focal length [pixels]; parallel: pixels a metre
  bool parallel = false;

  /// Right and down from the eye [m], and the depth along the view [m].
  Eigen::Vector3f toView(const Eigen::Vector3f& p) const { return axes * (p - eye); }
  /// Of a point in view axes. @pre parallel, or v.z() > 0
  Eigen::Vector2f toPixel(const Eigen::Vector3f& v) const {
    return centre + v.head<2>() * (parallel ? scale : scale / v.z());
  }
  /// The inverse: the point in view axes at a pixel and depth.
  Eigen::Vector3f atPixel(const Eigen::Vector2f& pixel, float depth) const {
    const Eigen::Vector2f v = (pixel - centre) * (parallel ? 1.0f / scale : depth / scale);
    return {v.x(), v.y(), depth};
  }
  /// The same point in World.
  Eigen::Vector3f toWorld(const Eigen::Vector2f& pixel, float depth) const {
    return eye + axes.transpose() * atPixel(pixel, depth);
  }
  /// From a point on a surface towards the eye, unit length.
  Eigen::Vector3f towardsEye(const Eigen::Vector3f& p) const {
    return parallel ? Eigen::Vector3f(-axes.row(2).transpose()) : (eye - p).normalized();
  }
  /// The same view in a picture `factor` times as large.
  Camera enlarged(float factor) const;
};

/// Axes of a camera that looks along `forward` with World z up in the picture. @pre forward is not
/// vertical
Eigen::Matrix3f viewAxes(const Eigen::Vector3f& forward);

/// How far round (from +x, counter-clockwise) and how high above the horizon the eye stands [rad].
struct ViewDirection {
  double azimuth = -0.9;
  double elevation = 0.7;  ///< [0 < . < pi/2]
};

/// The perspective view from there that shows all `points` as large as they fit a picture with
/// `margin` [pixels].
Camera frameView(std::span<const Eigen::Vector3f> points, const ViewDirection& from, int width,
                 int height, float margin);

}  // namespace amble
