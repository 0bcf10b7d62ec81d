#include "environments/collision/segment_distance.h"

namespace amble {
namespace {

double clamped(double share) { return std::clamp(share, 0.0, 1.0); }

// Twice the area of the triangle a, b, p seen along the normal: positive to the left of the edge.
double side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p,
            const Eigen::Vector3d& normal) {
  return (b - a).cross(p - a).dot(normal);
}

bool isOver(const Triangle3& t, const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
  return side(t[0], t[1], p, normal) >= 0.0 && side(t[1], t[2], p, normal) >= 0.0 &&
         side(t[2], t[0], p, normal) >= 0.0;
}

}  // namespace

double squaredDistance(const Segment& a, const Segment& b) {
  const Eigen::Vector3d along_a = a.to - a.from, along_b = b.to - b.from, between = a.from - b.from;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), bf = along_b.dot(between);
  double s = 0.0, t = 0.0;  // shares of the way along a and b
  if (aa <= 0.0 || bb <= 0.0) {
    if (aa > 0.0) s = clamped(-along_a.dot(between) / aa);
    if (bb > 0.0) t = clamped(bf / bb);
  } else {
    const double af = along_a.dot(between), ab = along_a.dot(along_b);
    const double sine = aa * bb - ab * ab;
    if (sine > 0.0) s = clamped((ab * bf - af * bb) / sine);
    t = (ab * s + bf) / bb;
    if (t < 0.0 || t > 1.0) {
      t = clamped(t);
      s = clamped((ab * t - af) / aa);
    }
  }
  return (between + s * along_a - t * along_b).squaredNorm();
}

double squaredDistance(const Segment& s, const Triangle3& t) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(s.from - t[0]), to = normal.dot(s.to - t[0]);
  if ((from < 0.0) != (to < 0.0) &&
      isOver(t, normal, s.from + from / (from - to) * (s.to - s.from)))
    return 0.0;
  double least = squaredDistance(s, Segment{t[0], t[1]});
  least = std::min(least, squaredDistance(s, Segment{t[1], t[2]}));
  least = std::min(least, squaredDistance(s, Segment{t[2], t[0]}));
  const double square = normal.squaredNorm();
  if (from * from < least * square && isOver(t, normal, s.from)) least = from * from / square;
  if (to * to < least * square && isOver(t, normal, s.to)) least = to * to / square;
  return least;
}

bool isWithin(double square, const Segment& s, const Triangle3& t) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(s.from - t[0]), to = normal.dot(s.to - t[0]);
  const double nearer = std::min(std::abs(from), std::abs(to));
  if ((from < 0.0) == (to < 0.0) && nearer * nearer > square * normal.squaredNorm()) return false;
  return squaredDistance(s, t) <= square;
}

}  // namespace amble
