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

// Between which samples of a row a triangle may lie: beside it each edge, seen from the row's left
// end, is crossed.
class RowBounds {
 public:
  RowBounds() = default;
  RowBounds(const ScreenTriangle& t, double area) {
    constexpr float kFar =
        1e5f;  // what is far larger than a picture leaves no sense in it [pixels]
    for (int k = 0; k < 3; ++k) {
      const Vector2f &p = t.at[k], &q = t.at[(k + 1) % 3];
      is_far_ = is_far_ || p.cwiseAbs().maxCoeff() > kFar;
      const double dx = static_cast<double>(q.x()) - p.x(), dy = static_cast<double>(q.y()) - p.y();
      if (dy == 0.0) continue;
      edges_[count_++] = {p.x() - 0.5, p.y(), dx / dy, (dy > 0.0) == (area > 0.0)};
    }
  }

  // Cuts [x0, x1] down; a sample more at both ends against rounding.
  void narrow(double y, int& x0, int& x1) const {
    if (is_far_) return;
    double low = x0, high = x1;
    for (int k = 0; k < count_; ++k) {
      const Edge& edge = edges_[k];
      const double crossed = edge.x + (y - edge.y) * edge.slope;
      if (edge.is_right)
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

 private:
  struct Edge {
    double x = 0.0, y = 0.0;  // where it begins [samples]
    double slope = 0.0;       // to the right, a row
    bool is_right = false;    // of the triangle
  };
  std::array<Edge, 3> edges_;
  int count_ = 0;
  bool is_far_ = false;
};

// Samples next to one another in a row, computed at once.
struct SampleRun {
  static constexpr int kLength = 8;
  std::array<float, kLength> w0, w1, w2, depth;

  // From sample x on of the row at height sy.
  void compute(const ScreenTriangle& t, float inverse, bool parallel, int x, float sy) {
    const Vector2f &a = t.at[0], &b = t.at[1], &c = t.at[2];
    const float ay = a.y() - sy, by = b.y() - sy, cy = c.y() - sy;
    for (int i = 0; i < kLength; ++i) {
      const float sx = static_cast<float>(x + i) + 0.5f;
      w0[i] = ((b.x() - sx) * cy - by * (c.x() - sx)) * inverse;
      w1[i] = ((c.x() - sx) * ay - cy * (a.x() - sx)) * inverse;
      w2[i] = 1 - w0[i] - w1[i];
      const float nearness = w0[i] * t.nearness[0] + w1[i] * t.nearness[1] + w2[i] * t.nearness[2];
      depth[i] = parallel ? -nearness : 1 / nearness;
    }
  }
};

// Calls visit(x, y, weights, depth) for every sample of the triangle whose row is in [first, last).
template <typename Visit>
void coverSamples(const ScreenTriangle& t, bool parallel, int width, int first, int last,
                  const Visit& visit) {
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
  const bool is_wide = x1 - x0 >= SampleRun::kLength;
  const RowBounds bounds = is_wide ? RowBounds(t, area) : RowBounds();
  SampleRun run;
  for (int y = y0; y <= y1; ++y) {
    int from = x0, to = x1;
    if (is_wide) bounds.narrow(y + 0.5, from, to);
    for (int x = from; x <= to; x += SampleRun::kLength) {
      run.compute(t, inverse, parallel, x, static_cast<float>(y) + 0.5f);
      const int count = std::min(SampleRun::kLength, to - x + 1);
      for (int i = 0; i < count; ++i) {
        if (run.w0[i] < 0 || run.w1[i] < 0 || run.w2[i] < 0) continue;
        visit(x + i, y, Vector3f(run.w0[i], run.w1[i], run.w2[i]), run.depth[i]);
      }
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
    Look look;  // its colour and flags; its normal where that is the same all over
    bool is_flat;
  };

  // In the order of the triangles, of those that `wanted` takes. Without looks where depths are
  // enough.
  template <typename Wanted>
  Projected(std::span<const DrawTriangle> triangles, const Camera& camera, int rows, int threads,
            bool with_looks, const Wanted& wanted)
      : rows_(rows) {
    parallelFor(kParts, threads, [&](int p, int) {
      const size_t begin = triangles.size() * p / kParts;
      const size_t end = triangles.size() * (p + 1) / kParts;
      for (const DrawTriangle& triangle : triangles.subspan(begin, end - begin)) {
        if (wanted(triangle))
          project(triangle, camera, [&](const ScreenTriangle& t) {
            const Bands bands = bandsOf(t);
            if (bands.first > bands.last) return;
            parts_[p].items.push_back(with_looks ? itemOf(t, triangle) : Item{t, {}, false});
            parts_[p].bands.push_back(bands);
          });
      }
    });
  }

  static int bandCount(int rows) { return std::min(rows, kBands); }

  // Calls draw(item, first row, end of rows) for what meets each band. A small picture is one band
  // where there is one thread; bands of a large one stay in the processor's cache.
  template <typename Draw>
  void forEach(int threads, const Draw& draw) const {
    if (threads == 1 && rows_ <= kSmall) {
      for (const Part& part : parts_)
        for (const Item& item : part.items) draw(item, 0, rows_);
      return;
    }
    parallelFor(bandCount(rows_), threads, [&](int b, int) {
      for (const Part& part : parts_)
        for (size_t i = 0; i < part.items.size(); ++i)
          if (part.bands[i].first <= b && b <= part.bands[i].last)
            draw(part.items[i], begin(b), begin(b + 1));
    });
  }

 private:
  static constexpr int kParts = 64;    // of the triangles, for threads to take
  static constexpr int kSmall = 1024;  // [rows]

  struct Bands {
    int8_t first = 1, last = 0;
  };
  struct Part {
    std::vector<Item> items;
    std::vector<Bands> bands;  // of each item
  };

  static Item itemOf(const ScreenTriangle& t, const DrawTriangle& triangle) {
    Item item{t, {}, t.normal[0] == t.normal[1] && t.normal[0] == t.normal[2]};
    for (int k = 0; k < 3; ++k) item.look.color[k] = colorByte(triangle.color[k]);
    item.look.flags = triangle.flags;
    if (item.is_flat) item.look.setNormal(t.normal[0]);
    return item;
  }

  int begin(int band) const { return rows_ * band / bandCount(rows_); }

  // None outside the picture, and of what is no number.
  Bands bandsOf(const ScreenTriangle& t) const {
    const auto& [a, b, c] = t.at;
    const auto [low, high] = std::minmax({a.y(), b.y(), c.y()});
    const float last = static_cast<float>(rows_);
    if (!(high >= 0.0f && low <= last)) return {};
    const int count = bandCount(rows_);
    // A row more at both ends against rounding.
    const int from = static_cast<int>(std::max(low - 1.0f, 0.0f)) * count / rows_;
    const int to = static_cast<int>(std::min(high + 1.0f, last)) * count / rows_ + 1;
    return {static_cast<int8_t>(std::max(from - 1, 0)),
            static_cast<int8_t>(std::min(to, count - 1))};
  }

  int rows_;
  std::array<Part, kParts> parts_;
};

void drawBand(const Projected::Item& item, bool parallel, int first, int last,
              SampleBuffer& buffer) {
  const ScreenTriangle& t = item.screen;
  Look look = item.look;
  const float lift = look.flags & kDecal ? kDecalLift : 0.0f;
  const auto draw = [&](int x, int y, const Vector3f& w, float depth) {
    if ((look.flags & kSeeThrough) && ((x & 1) || (y & 1))) return;
    float& seen = buffer.depth[buffer.index(x, y)];
    if (seen > 0 && depth - lift >= seen) return;
    seen = depth;
    if (!item.is_flat) {
      Vector3f normal = Vector3f::Zero();
      for (int k = 0; k < 3; ++k) normal += w[k] * (parallel ? 1.0f : t.nearness[k]) * t.normal[k];
      look.setNormal(normal);
    }
    buffer.look[buffer.index(x, y)] = look;
  };
  coverSamples(t, parallel, buffer.width, first, last, draw);
}

}  // namespace

void Look::setNormal(const Vector3f& direction) {
  constexpr float kMost = 32767.0f;
  const float sum = std::abs(direction.x()) + std::abs(direction.y()) + std::abs(direction.z());
  if (!(sum > 0.0f)) return;
  float a = direction.x() / sum, b = direction.y() / sum;
  if (direction.z() < 0.0f) {
    const float folded = std::copysign(1.0f - std::abs(b), a);
    b = std::copysign(1.0f - std::abs(a), b);
    a = folded;
  }
  const auto rounded = [](float share) {
    return static_cast<int16_t>(share * kMost + std::copysign(0.5f, share));
  };
  u = rounded(a);
  v = rounded(b);
}

Vector3f Look::normal() const {
  constexpr float kMost = 32767.0f;
  Vector3f n(static_cast<float>(u) / kMost, static_cast<float>(v) / kMost, 0.0f);
  n.z() = 1.0f - std::abs(n.x()) - std::abs(n.y());
  const float fold = std::max(-n.z(), 0.0f);
  n.x() -= std::copysign(fold, n.x());
  n.y() -= std::copysign(fold, n.y());
  return n.normalized();
}

void forBands(int rows, int threads, const std::function<void(int, int)>& work) {
  const int bands = Projected::bandCount(rows);
  parallelFor(bands, threads, [&](int b, int) { work(rows * b / bands, rows * (b + 1) / bands); });
}

SampleBuffer rasterize(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                       int height, int threads) {
  SampleBuffer buffer(width, height);
  for (const bool decals : {false, true}) {
    const Projected seen(triangles, camera, height, threads, true, [&](const DrawTriangle& t) {
      return ((t.flags & kDecal) != 0) == decals;
    });
    seen.forEach(threads, [&](const Projected::Item& item, int first, int last) {
      drawBand(item, camera.parallel, first, last, buffer);
    });
  }
  return buffer;
}

DepthMap rasterizeDepth(std::span<const DrawTriangle> triangles, const Camera& camera, int width,
                        int height, uint8_t skip_flags, int threads) {
  DepthMap map{width, height, LargeArray<float>(static_cast<size_t>(width) * height)};
  const Projected seen(triangles, camera, height, threads, false,
                       [&](const DrawTriangle& t) { return !(t.flags & skip_flags); });
  seen.forEach(threads, [&](const Projected::Item& item, int first, int last) {
    const auto draw = [&](int x, int y, const Vector3f&, float depth) {
      float& old = map.depth[static_cast<size_t>(y) * width + x];
      if (old == 0 || depth < old) old = depth;
    };
    coverSamples(item.screen, camera.parallel, width, first, last, draw);
  });
  return map;
}

}  // namespace amble
