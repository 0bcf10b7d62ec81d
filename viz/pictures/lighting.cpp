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
constexpr int kShadowBlur = 2;  // half width of the filter [shadow samples]
constexpr int kCornerTaps = 8;  // of the ambient occlusion, a pixel, of 16 that are averaged
constexpr float kFlat = 0.08f;  // sine of a rise that still darkens nothing
constexpr float kHalfTurn = 3.14159265f;

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
      : size_(settings.shadow_size), tiles_((size_ + kTile - 1) / kTile) {
    const Vector3f centre = settings.shadowed.center();
    const float radius = settings.shadowed.diagonal().norm() / 2 + 0.1f;
    camera_.parallel = true;
    camera_.axes = viewAxes(-settings.to_sun.normalized());
    camera_.eye = centre + settings.to_sun.normalized() * (radius + 1);
    camera_.centre = Vector2f::Constant(static_cast<float>(size_) / 2);
    camera_.scale = static_cast<float>(size_) / (2 * radius);
    map_ = rasterizeDepth(triangles, camera_, size_, size_, kNoShadow | kDecal, settings.threads);
    measureTiles(settings.threads);
  }

  // With what else throws shadows. The farthest of a tile may be nearer than is kept then.
  void add(std::span<const DrawTriangle> triangles, int threads) {
    if (triangles.empty()) return;
    const DepthMap more =
        rasterizeDepth(triangles, camera_, size_, size_, kNoShadow | kDecal, threads);
    for (size_t i = 0; i < map_.depth.size(); ++i) {
      const float depth = more.depth[i];
      if (depth == 0 || depth >= map_.depth[i]) continue;
      map_.depth[i] = depth;
      const size_t x = i % static_cast<size_t>(size_), y = i / static_cast<size_t>(size_);
      Reach& tile = reach_[y / kTile * static_cast<size_t>(tiles_) + x / kTile];
      tile.nearest = std::min(tile.nearest, depth);
    }
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
    const float behind = view.z() - kShadowBias;  // what is nearer to the sun hides the point
    const Reach depths = depthsAround(x0, y0);
    if (depths.nearest > behind) return 1;
    if (depths.farthest <= behind) return 0;
    return litShare(x0, y0, at.x() - static_cast<float>(x0), at.y() - static_cast<float>(y0),
                    behind);
  }

 private:
  static constexpr int kTile = 8;           // shadow samples along each side [>= 2 kShadowBlur + 2]
  static constexpr float kNothing = 1e30f;  // the depth where there is nothing
  static_assert(kTile >= 2 * kShadowBlur + 2);

  // Of samples next to one another.
  struct Reach {
    float nearest = kNothing, farthest = 0.0f;
    void extend(const Reach& other) {
      nearest = std::min(nearest, other.nearest);
      farthest = std::max(farthest, other.farthest);
    }
  };

  void measureTiles(int threads) {
    reach_.resize(static_cast<size_t>(tiles_) * tiles_);
    forBands(tiles_, threads, [&](int first, int last) {
      for (int y = first * kTile; y < std::min(last * kTile, size_); ++y) {
        Reach* row = &reach_[static_cast<size_t>(y / kTile) * tiles_];
        float* depth = &map_.depth[static_cast<size_t>(y) * size_];
        for (int x = 0; x < size_; ++x) {
          if (depth[x] == 0) depth[x] = kNothing;
          row[x / kTile].extend({depth[x], depth[x]});
        }
      }
    });
  }

  // Of all samples that a point beside this one is lit by, and some more: of four tiles.
  Reach depthsAround(int x, int y) const {
    const int left = (x - kShadowBlur) / kTile, right = (x + kShadowBlur + 1) / kTile;
    const int top = (y - kShadowBlur) / kTile, bottom = (y + kShadowBlur + 1) / kTile;
    Reach reach = reach_[static_cast<size_t>(top) * tiles_ + left];
    reach.extend(reach_[static_cast<size_t>(top) * tiles_ + right]);
    reach.extend(reach_[static_cast<size_t>(bottom) * tiles_ + left]);
    reach.extend(reach_[static_cast<size_t>(bottom) * tiles_ + right]);
    return reach;
  }

  // A box of 2 blur + 1 samples a side that slides with the point: its two edge columns and rows
  // count by share.
  float litShare(int x0, int y0, float fx, float fy, float behind) const {
    float sum = 0;
    for (int j = -kShadowBlur; j <= kShadowBlur + 1; ++j) {
      const float wy = j == -kShadowBlur ? 1 - fy : j == kShadowBlur + 1 ? fy : 1;
      const float* row = &map_.depth[static_cast<size_t>(y0 + j) * size_ + x0];
      float of_row = 0;
      for (int i = 1 - kShadowBlur; i <= kShadowBlur; ++i) of_row += row[i] > behind ? 1.0f : 0.0f;
      of_row += row[-kShadowBlur] > behind ? 1 - fx : 0.0f;
      of_row += row[kShadowBlur + 1] > behind ? fx : 0.0f;
      sum += wy * of_row;
    }
    return sum / ((2 * kShadowBlur + 1) * (2 * kShadowBlur + 1));
  }

  int size_, tiles_;  // along each side
  Camera camera_;
  DepthMap map_;
  std::vector<Reach> reach_;  // of each tile, row by row
};

// How open the surroundings of each pixel are [0, 1]; one value a pixel of the picture.
class Corners {
 public:
  Corners(const SampleBuffer& samples, const Camera& camera, float reach, int threads)
      : width_(samples.width / kSupersampling),
        height_(samples.height / kSupersampling),
        reach_(reach),
        camera_(camera.enlarged(1.0f / kSupersampling)),
        depth_(static_cast<size_t>(width_) * height_),
        open_(depth_.size(), 1.0f) {
    std::vector<float> raw(open_.size(), 1.0f);
    forBands(height_, threads, [&](int first, int last) {
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width_; ++x)
          depth_[index(x, y)] =
              samples.depth[samples.index(x * kSupersampling, y * kSupersampling)];
    });
    forBands(height_, threads, [&](int first, int last) {
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width_; ++x) {
          const Look& look = samples.look[samples.index(x * kSupersampling, y * kSupersampling)];
          if (depth_[index(x, y)] != 0 && !(look.flags & kDecal))
            raw[index(x, y)] = openness(look.normal(), x, y);
        }
    });
    forBands(height_, threads, [&](int first, int last) {
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width_; ++x)
          if (depth_[index(x, y)] != 0) open_[index(x, y)] = smoothed(raw, x, y);
    });
  }

  float at(int x, int y) const { return open_[index(x, y)]; }

 private:
  size_t index(int x, int y) const { return static_cast<size_t>(y) * width_ + x; }

  // A number for each point of a spiral.
  using Taps = std::array<float, kCornerTaps>;

  // A spiral's points, as shares of its radius, of each of the 16 pixels that are averaged: each
  // begins with another turn, and their distances lie between one another's.
  struct Spiral {
    Taps x, y;
  };
  static const std::array<Spiral, 16>& spirals() {
    static const std::array<Spiral, 16> all = [] {
      std::array<Spiral, 16> made;
      for (int k = 0; k < 16; ++k) {
        for (int i = 0; i < kCornerTaps; ++i) {
          const float angle =
              noise(k % 4, k / 4) * 2 * kHalfTurn + static_cast<float>(i) * 2.39996f;
          const float share =
              (static_cast<float>(i) + (static_cast<float>(k) + 0.5f) / 16) / kCornerTaps;
          made[k].x[i] = share * std::cos(angle);
          made[k].y[i] = share * std::sin(angle);
        }
      }
      return made;
    }();
    return all;
  }

  // The surface of a pixel, seen from the eye.
  struct Surface {
    Vector2f pixel;      // its middle
    float depth;         // [m]
    Vector3f p, normal;  // in view axes
  };

  // What is seen at the points of the spiral around a pixel: how far it is before the surface's
  // plane, and the square of how far from its point [m, m^2].
  struct Around {
    Taps before, square;
  };

  // Points around on a spiral; those that rise before the surface close it.
  float openness(const Vector3f& normal_W, int x, int y) const {
    Surface surface;
    surface.depth = depth_[index(x, y)];
    surface.pixel = Vector2f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    surface.p = camera_.atPixel(surface.pixel, surface.depth);
    surface.normal = camera_.axes * normal_W;
    const Around around = lookAround(surface, spirals()[4 * (y & 3) + (x & 3)]);
    float closed = 0;
    for (int i = 0; i < kCornerTaps; ++i) {
      // Most points around lie in the surface or behind it: no root, no quotient.
      const float before = around.before[i], square = around.square[i];
      if (before <= 0 || before * before < 0.99f * kFlat * kFlat * square) continue;
      const float distance = std::sqrt(square) + 1e-4f;
      const float rise = std::max(0.0f, before / distance - kFlat);
      closed += rise / (1 + (distance / reach_) * (distance / reach_));
    }
    return std::max(0.0f, 1 - 1.7f * closed / kCornerTaps);
  }

  Around lookAround(const Surface& surface, const Spiral& spiral) const {
    const float radius =
        camera_.scale * reach_ / (camera_.parallel ? 1.0f : surface.depth);  // [pixels]
    std::array<int, kCornerTaps> column, row;
    for (int i = 0; i < kCornerTaps; ++i) {
      column[i] = static_cast<int>(surface.pixel.x() + radius * spiral.x[i]);
      row[i] = static_cast<int>(surface.pixel.y() + radius * spiral.y[i]);
    }
    Taps depth;
    for (int i = 0; i < kCornerTaps; ++i) {
      const bool inside = static_cast<unsigned>(column[i]) < static_cast<unsigned>(width_) &&
                          static_cast<unsigned>(row[i]) < static_cast<unsigned>(height_);
      depth[i] = inside ? depth_[index(column[i], row[i])] : 0.0f;
    }
    const Vector3f p = surface.p, n = surface.normal;
    const Vector2f centre = camera_.centre;
    const float across = 1.0f / camera_.scale, parallel = camera_.parallel ? 1.0f : 0.0f;
    Around around;
    for (int i = 0; i < kCornerTaps; ++i) {
      const float wide = across * (parallel + (1.0f - parallel) * depth[i]);  // a pixel, there [m]
      const float dx = (static_cast<float>(column[i]) + 0.5f - centre.x()) * wide - p.x();
      const float dy = (static_cast<float>(row[i]) + 0.5f - centre.y()) * wide - p.y();
      const float dz = depth[i] - p.z();
      around.before[i] = depth[i] > 0 ? dx * n.x() + dy * n.y() + dz * n.z() : 0.0f;
      around.square[i] = dx * dx + dy * dy + dz * dz;
    }
    return around;
  }

  // Mean over 4 x 4 pixels (the noise repeats after as many) of about the same depth.
  float smoothed(const std::vector<float>& raw, int x, int y) const {
    const float depth = depth_[index(x, y)];
    float sum = 0, weight = 0;
    for (int j = std::max(0, y - 2); j < std::min(height_, y + 2); ++j) {
      for (int i = std::max(0, x - 2); i < std::min(width_, x + 2); ++i) {
        if (std::abs(depth_[index(i, j)] - depth) > 0.01f * depth) continue;
        sum += raw[index(i, j)];
        weight += 1;
      }
    }
    return weight > 0 ? sum / weight : 1;
  }

  int width_, height_;
  float reach_;
  Camera camera_;            // of the pixels
  LargeArray<float> depth_;  // of the sample that stands for each pixel [m]
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

// What the light of samples is made from.
struct Lights {
  const Camera& camera;
  const LightSettings& settings;
  const Shadows& shadows;
  Vector3f to_sun, background;  // unit length; linear

  // That falls on a point, of which a white surface would send all back.
  float at(const Vector3f& p, const Vector3f& normal, float open) const {
    const float facing = std::max(0.0f, normal.dot(to_sun));
    const float sun = facing > 0 ? facing * shadows.lit(p, normal) : 0;
    const float sky = 0.70f + 0.30f * normal.z();
    return (settings.sun * sun + settings.sky * sky * open) * 1.2f;
  }
};

Vector3f linearColor(const Look& look) {
  const auto& linear = linearTable();
  return {linear[look.color[0]], linear[look.color[1]], linear[look.color[2]]};
}

bool hasPlanks(const Look& look, const Vector3f& normal) {
  return (look.flags & kPlanks) && normal.z() > 0.9f;
}

Vector3f lightSample(const Sample& sample, const Vector3f& p, float open, const Lights& lights) {
  const Vector3f normal = sample.normal();
  const float shade = hasPlanks(sample, normal) ? plankShade(p) : 1.0f;
  return linearColor(sample) * (shade * lights.at(p, normal, open));
}

// Whether the samples of a pixel show one surface, so that one of them may be lit for all.
// @param normal  of a
bool alike(const Sample& a, const Vector3f& normal, const Sample& b) {
  if (std::abs(a.depth - b.depth) >= 0.004f * a.depth) return false;
  if (static_cast<const Look&>(a) == static_cast<const Look&>(b)) return true;
  return a.flags == b.flags && a.color == b.color && normal.dot(b.normal()) > 0.995f;
}

constexpr int kCount = kSupersampling * kSupersampling;  // samples of a pixel

// Where each sample of a pixel lies [samples].
Vector2f sampleCentre(int x, int y, int k) {
  return {static_cast<float>(x * kSupersampling + k % kSupersampling) + 0.5f,
          static_cast<float>(y * kSupersampling + k / kSupersampling) + 0.5f};
}

// Of a pixel in which one surface is seen: lit in its middle. Planks have seams finer than a pixel.
Vector3f lightOne(const Sample& sample, const Vector3f& normal, int x, int y, float open,
                  const Lights& lights) {
  const Vector2f middle(static_cast<float>(x * kSupersampling) + kSupersampling / 2.0f,
                        static_cast<float>(y * kSupersampling) + kSupersampling / 2.0f);
  float light = lights.at(lights.camera.toWorld(middle, sample.depth), normal, open);
  if (hasPlanks(sample, normal)) {
    float shade = 0;
    for (int k = 0; k < kCount; ++k)
      shade += plankShade(lights.camera.toWorld(sampleCentre(x, y, k), sample.depth));
    light *= shade / kCount;
  }
  return linearColor(sample) * light;
}

// The light of a pixel: the mean of its samples.
Vector3f lightPixel(const SampleBuffer& samples, int x, int y, float open, const Lights& lights) {
  std::array<Sample, kCount> seen;
  Vector3f normal = Vector3f::Zero();  // of the first
  bool one = true, any = false;
  for (int k = 0; k < kCount; ++k) {
    const size_t at = samples.index(x * kSupersampling + k % kSupersampling,
                                    y * kSupersampling + k / kSupersampling);
    seen[k].depth = samples.depth[at];
    if (seen[k].depth == 0) {
      one = false;
      continue;
    }
    any = true;
    seen[k] = {samples.look[at], seen[k].depth};
    if (k == 0) normal = seen[0].normal();
    one = one && alike(seen[0], normal, seen[k]);
  }
  if (!any) return lights.background;
  if (one) return lightOne(seen[0], normal, x, y, open, lights);
  Vector3f sum = Vector3f::Zero();
  for (int k = 0; k < kCount; ++k) {
    sum += seen[k].depth == 0
               ? lights.background
               : lightSample(seen[k], lights.camera.toWorld(sampleCentre(x, y, k), seen[k].depth),
                             open, lights);
  }
  return sum / kCount;
}

Image lightWith(const Shadows& shadows, const SampleBuffer& samples, const Camera& camera,
                const LightSettings& settings) {
  const Lights lights = {camera, settings, shadows, settings.to_sun.normalized(),
                         settings.background.unaryExpr([](float v) { return toLinear(v); })};
  const Corners corners(samples, camera, settings.corner_reach, settings.threads);
  static const ByteTable bytes;
  Image image(samples.width / kSupersampling, samples.height / kSupersampling);
  forBands(image.height, settings.threads, [&](int first, int last) {
    for (int y = first; y < last; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const Vector3f light = lightPixel(samples, x, y, corners.at(x, y), lights);
        for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = bytes(light[c]);
      }
    }
  });
  return image;
}

}  // namespace

Image lightSamples(const SampleBuffer& samples, const Camera& camera,
                   std::span<const DrawTriangle> triangles, const LightSettings& settings) {
  return lightWith(Shadows(triangles, settings), samples, camera, settings);
}

struct StillLight::Shade {
  Shadows shadows;
};

StillLight::StillLight(std::span<const DrawTriangle> still, const LightSettings& settings)
    : settings_(settings), shade_(new Shade{Shadows(still, settings)}) {}
StillLight::~StillLight() = default;

Image StillLight::light(const SampleBuffer& samples, const Camera& camera,
                        std::span<const DrawTriangle> moving) const {
  Shadows shadows = shade_->shadows;
  shadows.add(moving, settings_.threads);
  return lightWith(shadows, samples, camera, settings_);
}

}  // namespace amble
