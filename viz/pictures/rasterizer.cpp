#include "viz/pictures/rasterizer.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace amble {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kBands = 32;           // of a picture: enough for every thread to be busy to the end
constexpr float kDecalLift = 0.02f;  // a decal wins against what is no more than this before it [m]

struct Corner {
  Vector3f view;  // in view axes [m]
  Vector3f normal;
};

// Cuts the triangle at the nearest depth. @return corners in `out`, 0 to 4 of them
int clipNear(const std::array<Corner, 3>& in, std::array<Corner, 4>& out) {
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const Corner& a = in[i];
    const Corner& b = in[(i + 1) % 3];
    if (a.view.z() >= kNearest) out[count++] = a;
    if ((a.view.z() >= kNearest) != (b.view.z() >= kNearest)) {
      const float t = (kNearest - a.view.z()) / (b.view.z() - a.view.z());
      out[count++] = {a.view + t * (b.view - a.view), a.normal + t * (b.normal - a.normal)};
    }
  }
  return count;
}

// Three corners on the picture, and what interpolation over it needs.
struct ScreenTriangle {
  std::array<Vector2f, 3> at;     // [pixels]
  std::array<float, 3> nearness;  // linear over the picture: 1 / depth, or -depth where parallel
  std::array<Vector3f, 3> normal;
};

// Cuts [x0, x1] down to where a row of samples may lie in the triangle: beside it each edge, seen
// from the row's left end, is crossed. A sample more at both ends against rounding, which what is
// far larger than a picture leaves no sense in.
void narrowRow(const ScreenTriangle& t, double area, double y, int& x0, int& x1) {
  constexpr float kFar = 1e5f;
  double low = x0, high = x1;
  for (int k = 0; k < 3; ++k) {
    const Vector2f &p = t.at[k], &q = t.at[(k + 1) % 3];
    if (p.cwiseAbs().maxCoeff() > kFar) return;
    const double dx = static_cast<double>(q.x()) - p.x(), dy = static_cast<double>(q.y()) - p.y();
    if (dy == 0.0) continue;
    const double crossed = p.x() + (y - p.y()) / dy * dx - 0.5;
    if ((dy > 0.0) == (area > 0.0))
      high = std::min(high, crossed + 1.0);
    else
      low = std::max(low, crossed - 1.0);
  }
  if (low > high) {
    x1 = x0 - 1;
    return;
  }
  x0 = std::max(x0, static_cast<int>(std::floor(low)));
  x1 = std::min(x1, static_cast<int>(std::ceil(high)));
}

// Calls visit(x, y, weights) for every sample of the triangle whose row is in [first, last).
template <typename Visit>
void coverSamples(const ScreenTriangle& t, int width, int first, int last, const Visit& visit) {
  const Vector2f &a = t.at[0], &b = t.at[1], &c = t.at[2];
  const float area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  if (area == 0) return;
  const auto [low_x, high_x] = std::minmax({a.x(), b.x(), c.x()});
  const auto [low_y, high_y] = std::minmax({a.y(), b.y(), c.y()});
  if (high_x < 0 || low_x > static_cast<float>(width)) return;
  const int x0 = std::max(0, static_cast<int>(std::max(low_x, -1.0f)));
  const int x1 = std::min(width - 1, static_cast<int>(std::min(high_x, 1e6f)));
  const int y0 = std::max(first, static_cast<int>(std::max(low_y, -1.0f)));
  const int y1 = std::min(last - 1, static_cast<int>(std::min(high_y, 1e6f)));
  const float inverse = 1 / area;
  constexpr int kNarrow = 8;  // samples, all of which are sooner asked
  for (int y = y0; y <= y1; ++y) {
    int from = x0, to = x1;
    if (to - from > kNarrow) narrowRow(t, area, y + 0.5, from, to);
    for (int x = from; x <= to; ++x) {
      const Vector2f s(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float w0 = ((b - s).x() * (c - s).y() - (b - s).y() * (c - s).x()) * inverse;
      const float w1 = ((c - s).x() * (a - s).y() - (c - s).y() * (a - s).x()) * inverse;
      const float w2 = 1 - w0 - w1;
      if (w0 < 0 || w1 < 0 || w2 < 0) continue;
      visit(x, y, Vector3f(w0, w1, w2));
    }
  }
}

// Calls visit(screen triangle) for what of `triangle` is before the camera and turned to it.
template <typename Visit>
void project(const DrawTriangle& triangle, const Camera& camera, const Visit& visit) {
  const Vector3f face = (triangle.p[1] - triangle.p[0]).cross(triangle.p[2] - triangle.p[0]);
  const bool front = face.dot(camera.towardsEye(triangle.p[0])) > 0;
  if (!front && !(triangle.flags & (kTwoSided | kCut))) return;
  std::array<Corner, 3> corners;
  for (int i = 0; i < 3; ++i) {
    corners[i] = {camera.toView(triangle.p[i]), front ? triangle.normal[i] : -triangle.normal[i]};
    if (!front && (triangle.flags & kCut)) corners[i].normal = Vector3f::UnitZ();
  }
  std::array<Corner, 4> clipped;
  const int count = clipNear(corners, clipped);
  for (int i = 2; i < count; ++i) {
    ScreenTriangle screen;
    const std::array<const Corner*, 3> fan = {&clipped[0], &clipped[i - 1], &clipped[i]};
    for (int k = 0; k < 3; ++k) {
      screen.at[k] = camera.toPixel(fan[k]->view);
      screen.nearness[k] = camera.parallel ? -fan[k]->view.z() : 1 / fan[k]->view.z();
      screen.normal[k] = fan[k]->normal;
    }
    visit(screen);
  }
}

// What of the triangles the camera sees, projected once, and which of it meets each band of the
// picture's rows.
class Projected {
 public:
  struct Item {
    ScreenTriangle screen;
    const DrawTriangle* source;
  };

  // In the order of the triangles, of those that `wanted` takes.
  template <typename Wanted>
  Projected(std::span<const DrawTriangle> triangles, const Camera& camera, int rows, int threads,
            const Wanted& wanted)
      : rows_(rows), bands_(bandCount(rows)) {
    constexpr int kParts = 64;
    std::array<std::vector<Item>, kParts> parts;
    parallelFor(kParts, threads, [&](int part, int) {
      const size_t begin = triangles.size() * part / kParts;
      const size_t end = triangles.size() * (part + 1) / kParts;
      for (const DrawTriangle& triangle : triangles.subspan(begin, end - begin)) {
        if (wanted(triangle))
          project(triangle, camera, [&](const ScreenTriangle& t) {
            parts[part].push_back({t, &triangle});
          });
      }
    });
    for (const std::vector<Item>& part : parts)
      items_.insert(items_.end(), part.begin(), part.end());
    for (size_t i = 0; i < items_.size(); ++i) addToBands(static_cast<int>(i));
  }

  static int bandCount(int rows) { return std::min(rows, kBands); }

  // Calls draw(item, first row, end of rows) for what meets each band.
  template <typename Draw>
  void forEach(int threads, const Draw& draw) const {
    parallelFor(static_cast<int>(bands_.size()), threads, [&](int b, int) {
      for (const int i : bands_[b]) draw(items_[i], begin(b), begin(b + 1));
    });
  }

 private:
  int begin(int band) const { return rows_ * band / static_cast<int>(bands_.size()); }

  void addToBands(int i) {
    const auto& [a, b, c] = items_[i].screen.at;
    const auto [low, high] = std::minmax({a.y(), b.y(), c.y()});
    const float last = static_cast<float>(rows_);
    if (!(high >= 0.0f && low <= last)) return;
    for (int band = 0; band < static_cast<int>(bands_.size()); ++band)
      if (static_cast<float>(begin(band)) <= high && low <= static_cast<float>(begin(band + 1)))
        bands_[band].push_back(i);
  }

  int rows_;
  std::vector<Item> items_;
  std::vector<std::vector<int>> bands_;  // numbers of items, ascending
};

float depthOf(float nearness, bool parallel) { return parallel ? -nearness : 1 / nearness; }

uint8_t byteOf(float v) {
  return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255));
}

void drawBand(const DrawTriangle& triangle, const ScreenTriangle& t, bool parallel, int first,
              int last, SampleBuffer& buffer) {
  const std::array<uint8_t, 3> color = {byteOf(triangle.color.x()), byteOf(triangle.color.y()),
                                        byteOf(triangle.color.z())};
  const float lift = triangle.flags & kDecal ? kDecalLift : 0.0f;
  coverSamples(t, buffer.width, first, last, [&](int x, int y, const Vector3f& w) {
    if ((triangle.flags & kSeeThrough) && ((x & 1) || (y & 1))) return;
    const float nearness = w.x() * t.nearness[0] + w.y() * t.nearness[1] + w.z() * t.nearness[2];
    const float depth = depthOf(nearness, parallel);
    float& seen = buffer.depth[buffer.index(x, y)];
    if (seen > 0 && depth - lift >= seen) return;
    Vector3f normal = Vector3f::Zero();
    for (int k = 0; k < 3; ++k) normal += w[k] * (parallel ? 1.0f : t.nearness[k]) * t.normal[k];
    seen = depth;
    buffer.look[buffer.index(x, y)] = {normal.normalized(), color, triangle.flags};
  });
}

}  // namespace

void forBands(int rows, int threads, const std::function<void(int, int)>& work) {
  const int bands = Projected::bandCount(rows);
  parallelFor(bands, threads, [&](int b, int) { work(rows * b / bands, rows * (b + 1) / bands); });
}

SampleBuffer rasterize(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                       int height, int threads) {
  SampleBuffer buffer(width, height);
  for (const bool decals : {false, true}) {
    const Projected seen(triangles, camera, height, threads, [&](const DrawTriangle& t) {
      return ((t.flags & kDecal) != 0) == decals;
    });
    seen.forEach(threads, [&](const Projected::Item& item, int first, int last) {
      drawBand(*item.source, item.screen, camera.parallel, first, last, buffer);
    });
  }
  return buffer;
}

DepthMap rasterizeDepth(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                        int height, uint8_t skip_flags, int threads) {
  DepthMap map{width, height, std::vector<float>(static_cast<size_t>(width) * height)};
  const Projected seen(triangles, camera, height, threads,
                       [&](const DrawTriangle& t) { return !(t.flags & skip_flags); });
  seen.forEach(threads, [&](const Projected::Item& item, int first, int last) {
    const ScreenTriangle& t = item.screen;
    coverSamples(t, width, first, last, [&](int x, int y, const Vector3f& w) {
      const float nearness = w.x() * t.nearness[0] + w.y() * t.nearness[1] + w.z() * t.nearness[2];
      const float depth = depthOf(nearness, camera.parallel);
      float& old = map.depth[static_cast<size_t>(y) * width + x];
      if (old == 0 || depth < old) old = depth;
    });
  });
  return map;
}

}  // namespace amble
