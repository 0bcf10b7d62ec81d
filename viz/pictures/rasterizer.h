/// Triangles to samples: a z-buffer that keeps what is seen at each sample, to be lit afterwards.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/large_array.h"
#include "viz/pictures/camera.h"
#include "viz/pictures/color.h"

namespace amble {

/// How a triangle is drawn; sums of these.
enum DrawFlag : uint8_t {
  kTwoSided = 1,    ///< its back is drawn too
  kSeeThrough = 2,  ///< one sample in four only: a ghost after averaging
  kNoShadow = 4,    ///< throws none
  kPlanks = 8,      ///< patterned as a wooden floor
  kDecal = 16,  ///< drawn over what lies within 2 cm before it; gets shadows, no corner darkening
  kCut = 32,    ///< cut open from above: its back is drawn as the level face of the cut
};

struct DrawTriangle {
  std::array<Eigen::Vector3f, 3> p;       ///< counter-clockwise from its front, World [m]
  std::array<Eigen::Vector3f, 3> normal;  ///< unit length
  Color color = Color::Zero();
  uint8_t flags = 0;
};

/// What a surface looks like, in eight bytes: a picture has millions of them.
struct Look {
  /// The normal's place on an octahedron that is folded flat (Meyer et al., On floating-point
  /// normal vectors, EGSR 2010) [1/32767].
  int16_t u = 0, v = 0;
  std::array<uint8_t, 3> color = {0, 0, 0};
  uint8_t flags = 0;

  bool operator==(const Look&) const = default;
  void setNormal(const Eigen::Vector3f& direction);  ///< of any length but 0
  Eigen::Vector3f normal() const;                    ///< unit length, right to 0.004 degrees
};

/// What is seen at a sample.
struct Sample : Look {
  float depth = 0;  ///< along the view [m]; 0 where there is nothing
};

/// Row by row from the top. Depths apart: they are asked for most, all around.
struct SampleBuffer {
  SampleBuffer(int samples_x, int samples_y)
      : width(samples_x),
        height(samples_y),
        depth(static_cast<size_t>(samples_x) * samples_y),
        look(depth.size()) {}

  int width, height;
  LargeArray<float> depth;  ///< [m]; 0 where there is nothing
  LargeArray<Look> look;    ///< the same; where there is nothing without meaning

  size_t index(int x, int y) const { return static_cast<size_t>(y) * width + x; }
  Sample at(int x, int y) const { return {look[index(x, y)], depth[index(x, y)]}; }
};

/// Nothing nearer than this is drawn [m].
inline constexpr float kNearest = 0.05f;

/// Of triangles at the same depth the first is seen, decals before others.
/// @param width, height  [samples, >= 1]  @param threads  change no result [>= 1]
SampleBuffer rasterize(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                       int height, int threads = 1);

/// Depths only [m]; 0 where there is nothing. Triangles with `skip_flags` are left out.
struct DepthMap {
  int width = 0;
  int height = 0;
  LargeArray<float> depth;
  float at(int x, int y) const { return depth[static_cast<size_t>(y) * width + x]; }
};
DepthMap rasterizeDepth(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                        int height, uint8_t skip_flags, int threads = 1);

/// Calls work(first, last) for bands of [0, rows). Every row is worked once, so the result does not
/// depend on the number of threads where rows do not depend on one another.
void forBands(int rows, int threads, const std::function<void(int first, int last)>& work);

}  // namespace amble
