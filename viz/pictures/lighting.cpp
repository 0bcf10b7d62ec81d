#include "viz/pictures/lighting.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace amble {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// What is nearer to the sun than a surface by less than this is still the surface [m].
constexpr float kShadowBias = 0.012f;
constexpr int kShadowBlur = 2;   // half width of the filter [shadow samples]
constexpr int kCornerTaps = 14;  // of the ambient occlusion, a pixel
constexpr float kFlat = 0.08f;   // sine of a rise that still darkens nothing
constexpr float kPi = 3.14159265f;

float toLinear(float srgb) { return std::pow(srgb, 2.2f); }
float toSrgb(float linear) { return std::pow(std::clamp(linear, 0.0f, 1.0f), 1 / 2.2f); }

uint8_t toByte(float linear) { return static_cast<uint8_t>(std::lround(toSrgb(linear) * 255)); }

// toByte, which grows with its argument, of a number by its place among the least numbers that give
// each byte.
class ByteTable {
 public:
  ByteTable() {
    for (int byte = 1; byte < 256; ++byte) least_[byte] = leastOf(byte);
    for (int cell = 0, byte = 0; cell <= kCells; ++cell) {
      while (byte < 255 && least_[byte + 1] <= static_cast<float>(cell) / kCells) ++byte;
      at_[cell] = static_cast<uint8_t>(byte);
    }
  }

  uint8_t operator()(float linear) const {
    int byte = at_[static_cast<int>(std::clamp(linear, 0.0f, 1.0f) * kCells)];
    while (byte < 255 && least_[byte + 1] <= linear) ++byte;
    while (byte > 0 && least_[byte] > linear) --byte;
    return static_cast<uint8_t>(byte);
  }

 private:
  static constexpr int kCells = 4096;

  // Halved until nothing lies between.
  static float leastOf(int byte) {
    float low = 0.0f, high = 1.0f;
    for (float middle = 0.5f; middle > low && middle < high; middle = 0.5f * (low + high))
      (toByte(middle) < byte ? low : high) = middle;
    return high;
  }

  std::array<float, 256> least_ = {};        // that gives each byte
  std::array<uint8_t, kCells + 1> at_ = {};  // of the least number of each cell
};

const std::array<float, 256>& linearTable() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) values[i] = toLinear(static_cast<float>(i) / 255);
    return values;
  }();
  return table;
}

// Fraction of a number that looks random, from two integers [0, 1).
float noise(int x, int y) {
  uint32_t h = static_cast<uint32_t>(x) * 374761393u + static_cast<uint32_t>(y) * 668265263u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 65536.0f;
}

// What the sun sees.
class Shadows {
 public:
  Shadows(std::span<const DrawTriangle> triangles, const LightSettings& settings)
      : size_(settings.shadow_size) {
    const Vector3f centre = settings.shadowed.center();
    const float radius = settings.shadowed.diagonal().norm() / 2 + 0.1f;
    camera_.parallel = true;
    camera_.axes = viewAxes(-settings.to_sun.normalized());
    camera_.eye = centre + settings.to_sun.normalized() * (radius + 1);
    camera_.centre = Vector2f::Constant(static_cast<float>(size_) / 2);
    camera_.scale = static_cast<float>(size_) / (2 * radius);
    map_ = rasterizeDepth(triangles, camera_, size_, size_, kNoShadow | kDecal, settings.threads);
  }

  // Share of the sun that reaches a point with this normal [0, 1].
  float lit(const Vector3f& p, const Vector3f& normal) const {
    const Vector3f view = camera_.toView(p + 0.006f * normal);
    const Vector2f at = camera_.toPixel(view) - Vector2f(0.5f, 0.5f);
    const int x0 = static_cast<int>(std::floor(at.x()));
    const int y0 = static_cast<int>(std::floor(at.y()));
    if (x0 < kShadowBlur || y0 < kShadowBlur || x0 >= size_ - kShadowBlur - 1 ||
        y0 >= size_ - kShadowBlur - 1)
      return 1;
    const float fx = at.x() - static_cast<float>(x0), fy = at.y() - static_cast<float>(y0);
    // A box of 2 blur + 1 samples a side that slides with the point: its two edge columns and rows
    // count by share.
    float sum = 0;
    for (int j = -kShadowBlur; j <= kShadowBlur + 1; ++j) {
      const float wy = j == -kShadowBlur ? 1 - fy : j == kShadowBlur + 1 ? fy : 1;
      for (int i = -kShadowBlur; i <= kShadowBlur + 1; ++i) {
        const float wx = i == -kShadowBlur ? 1 - fx : i == kShadowBlur + 1 ? fx : 1;
        const float depth = map_.at(x0 + i, y0 + j);
        if (depth == 0 || depth > view.z() - kShadowBias) sum += wx * wy;
      }
    }
    return sum / ((2 * kShadowBlur + 1) * (2 * kShadowBlur + 1));
  }

 private:
  int size_;
  Camera camera_;
  DepthMap map_;
};

// How open the surroundings of each pixel are [0, 1]; one value a pixel of the picture.
class Corners {
 public:
  Corners(const SampleBuffer& samples, const Camera& camera, float reach, int threads)
      : width_(samples.width / kSupersampling),
        height_(samples.height / kSupersampling),
        open_(static_cast<size_t>(width_) * height_, 1.0f) {
    std::vector<float> raw(open_.size(), 1.0f);
    forBands(height_, threads, [&](int first, int last) {
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width_; ++x) raw[index(x, y)] = openness(samples, camera, reach, x, y);
    });
    forBands(height_, threads, [&](int first, int last) {
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width_; ++x) open_[index(x, y)] = smoothed(samples, raw, x, y);
    });
  }

  float at(int x, int y) const { return open_[index(x, y)]; }

 private:
  size_t index(int x, int y) const { return static_cast<size_t>(y) * width_ + x; }

  // Of the sample that stands for a pixel.
  static size_t sampleOf(const SampleBuffer& samples, int x, int y) {
    return samples.index(x * kSupersampling, y * kSupersampling);
  }

  // Directions of a spiral's points, from each of the turns that pixels begin it with.
  using Spiral = std::array<Vector2f, kCornerTaps>;
  static const std::array<Spiral, 16>& spirals() {
    static const std::array<Spiral, 16> all = [] {
      std::array<Spiral, 16> made;
      for (int k = 0; k < 16; ++k) {
        for (int i = 0; i < kCornerTaps; ++i) {
          const float angle = noise(k % 4, k / 4) * 2 * kPi + static_cast<float>(i) * 2.39996f;
          made[k][i] = {std::cos(angle), std::sin(angle)};
        }
      }
      return made;
    }();
    return all;
  }

  // Points around on a spiral; those that rise before the surface close it.
  float openness(const SampleBuffer& samples, const Camera& camera, float reach, int x,
                 int y) const {
    const size_t sample = sampleOf(samples, x, y);
    const float depth = samples.depth[sample];
    if (depth == 0 || (samples.look[sample].flags & kDecal)) return 1;
    const Vector2f pixel(static_cast<float>(x * kSupersampling) + 0.5f,
                         static_cast<float>(y * kSupersampling) + 0.5f);
    const Vector3f p = camera.atPixel(pixel, depth);
    const Vector3f normal = camera.axes * samples.look[sample].normal;
    const float radius = camera.scale * reach / (camera.parallel ? 1.0f : depth);
    const Spiral& spiral = spirals()[4 * (y & 3) + (x & 3)];
    float closed = 0;
    for (int i = 0; i < kCornerTaps; ++i) {
      const float r = radius * (static_cast<float>(i) + 0.5f) / kCornerTaps;
      const Vector2f at = pixel + r * spiral[i];
      const int sx = static_cast<int>(at.x()), sy = static_cast<int>(at.y());
      if (sx < 0 || sy < 0 || sx >= samples.width || sy >= samples.height) continue;
      const float other = samples.depth[samples.index(sx, sy)];
      if (other == 0) continue;
      const Vector3f d = camera.atPixel(at, other) - p;
      // Most points around lie in the surface or behind it: no root, no quotient.
      const float before = d.dot(normal), square = d.squaredNorm();
      if (before <= 0 || before * before < 0.99f * kFlat * kFlat * square) continue;
      const float distance = std::sqrt(square) + 1e-4f;
      const float rise = std::max(0.0f, before / distance - kFlat);
      closed += rise / (1 + (distance / reach) * (distance / reach));
    }
    return std::max(0.0f, 1 - 1.7f * closed / kCornerTaps);
  }

  // Mean over 4 x 4 pixels (the noise repeats after as many) of about the same depth.
  float smoothed(const SampleBuffer& samples, const std::vector<float>& raw, int x, int y) const {
    const float depth = samples.depth[sampleOf(samples, x, y)];
    float sum = 0, weight = 0;
    for (int j = std::max(0, y - 2); j < std::min(height_, y + 2); ++j) {
      for (int i = std::max(0, x - 2); i < std::min(width_, x + 2); ++i) {
        if (std::abs(samples.depth[sampleOf(samples, i, j)] - depth) > 0.01f * depth) continue;
        sum += raw[index(i, j)];
        weight += 1;
      }
    }
    return weight > 0 ? sum / weight : 1;
  }

  int width_, height_;
  std::vector<float> open_;
};

// Boards 0.14 m wide and 1.8 m long, each a little lighter or darker, with dark seams.
float plankShade(const Vector3f& p) {
  constexpr float kWidth = 0.14f, kLength = 1.8f, kSeam = 0.0025f;  // [m]
  const int row = static_cast<int>(std::floor(p.y() / kWidth));
  const float along = p.x() + kLength * noise(row, 7);
  const int board = static_cast<int>(std::floor(along / kLength));
  const float in_row = p.y() - static_cast<float>(row) * kWidth;
  const float in_board = along - static_cast<float>(board) * kLength;
  if (in_row < kSeam || in_board < kSeam) return 0.86f;
  return 0.965f + 0.07f * noise(board * 17 + 3, row);
}

Vector3f lightSample(const Sample& sample, const Vector3f& p, float open, const Shadows& shadows,
                     const LightSettings& settings) {
  const auto& linear = linearTable();
  Vector3f color(linear[sample.color[0]], linear[sample.color[1]], linear[sample.color[2]]);
  if ((sample.flags & kPlanks) && sample.normal.z() > 0.9f) color *= plankShade(p);
  const float facing = std::max(0.0f, sample.normal.dot(settings.to_sun.normalized()));
  const float sun = facing > 0 ? facing * shadows.lit(p, sample.normal) : 0;
  const float sky = 0.70f + 0.30f * sample.normal.z();
  return color * (settings.sun * sun + settings.sky * sky * open) * 1.2f;
}

// Whether the samples of a pixel show one surface, so that one of them may be lit for all.
bool alike(const Sample& a, const Sample& b) {
  return a.flags == b.flags && a.color == b.color &&
         std::abs(a.depth - b.depth) < 0.004f * a.depth && a.normal.dot(b.normal) > 0.995f;
}

// The light of a pixel: the mean of its samples.
Vector3f lightPixel(const SampleBuffer& samples, const Camera& camera, int x, int y, float open,
                    const Shadows& shadows, const Vector3f& background,
                    const LightSettings& settings) {
  constexpr int kCount = kSupersampling * kSupersampling;
  std::array<Sample, kCount> seen;
  bool one = true;
  for (int k = 0; k < kCount; ++k) {
    seen[k] = samples.at(x * kSupersampling + k % kSupersampling,
                         y * kSupersampling + k / kSupersampling);
    one = one && alike(seen[0], seen[k]);
  }
  if (one && seen[0].flags & kPlanks) one = false;  // seams are finer than a pixel
  Vector3f sum = Vector3f::Zero();
  for (int k = 0; k < (one ? 1 : kCount); ++k) {
    const float middle = one ? kSupersampling / 2.0f : 0.5f;
    const Vector2f pixel(static_cast<float>(x * kSupersampling + k % kSupersampling) + middle,
                         static_cast<float>(y * kSupersampling + k / kSupersampling) + middle);
    sum += seen[k].depth == 0 ? background
                              : lightSample(seen[k], camera.toWorld(pixel, seen[k].depth), open,
                                            shadows, settings);
  }
  return one ? sum : Vector3f(sum / kCount);
}

}  // namespace

Image lightSamples(const SampleBuffer& samples, const Camera& camera,
                   std::span<const DrawTriangle> triangles, const LightSettings& settings) {
  const Shadows shadows(triangles, settings);
  const Corners corners(samples, camera, settings.corner_reach, settings.threads);
  const Vector3f background = settings.background.unaryExpr([](float v) { return toLinear(v); });
  static const ByteTable bytes;
  Image image(samples.width / kSupersampling, samples.height / kSupersampling);
  forBands(image.height, settings.threads, [&](int first, int last) {
    for (int y = first; y < last; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const Vector3f light =
            lightPixel(samples, camera, x, y, corners.at(x, y), shadows, background, settings);
        for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = bytes(light[c]);
      }
    }
  });
  return image;
}

}  // namespace amble
