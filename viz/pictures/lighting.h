/// Light on what the rasteriser saw: a sun with soft shadows, a sky, and darker corners (ambient
/// occlusion).
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>

#include "viz/pictures/image.h"
#include "viz/pictures/rasterizer.h"

namespace amble {

struct LightSettings {
  /// From any point towards it; made unit length [not 0].
  Eigen::Vector3f to_sun = {-0.35f, -0.25f, 0.9f};
  float sun = 0.62f;           ///< share of full white that it gives a surface turned to it [0, 1]
  float sky = 0.50f;           ///< share that the sky gives a surface that faces up [0, 1]
  float corner_reach = 0.25f;  ///< how far away a surface darkens another [m, > 0]
  int shadow_size = 2048;      ///< samples along each side of the shadow map [>= 16]
  Color background = rgb(246, 247, 249);
  Eigen::AlignedBox3f shadowed = {};  ///< what throws and gets shadows lies in here [m]
  int threads = 1;                    ///< change no result [>= 1]
};

/// Samples per pixel along each axis.
inline constexpr int kSupersampling = 2;

/// The picture of the samples. Where nothing is seen it is the background; a surface is never
/// darker with more light on it, nor lighter in a shadow or a corner.
/// @param camera  of the samples, kSupersampling times as large as the picture
Image lightSamples(const SampleBuffer& samples, const Camera& camera,
                   std::span<const DrawTriangle> triangles, const LightSettings& settings);

/// The same light on many pictures of one place: what stands still throws its shadows once.
class StillLight {
 public:
  StillLight(std::span<const DrawTriangle> still, const LightSettings& settings);
  ~StillLight();

  /// lightSamples with the shadows of both.
  Image light(const SampleBuffer& samples, const Camera& camera,
              std::span<const DrawTriangle> moving) const;

 private:
  struct Shade;
  LightSettings settings_;
  std::unique_ptr<const Shade> shade_;
};

}  // namespace amble
