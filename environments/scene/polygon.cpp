#include "environments/scene/polygon.h"

#include <Eigen/Geometry>
#include <cassert>

#include "environments/scene/mesh.h"

namespace amble {
namespace {

// Along its normal, so that it turns to the left: its largest coordinate left out.
std::vector<Eigen::Vector2d> seenFromAbove(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (size_t i = 2; i < corners.size(); ++i)
    normal += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  Eigen::Index out = 0;
  normal.cwiseAbs().maxCoeff(&out);
  Eigen::Index x = (out + 1) % 3, y = (out + 2) % 3;
  if (normal[out] < 0.0) std::swap(x, y);
  std::vector<Eigen::Vector2d> seen;
  seen.reserve(corners.size());
  for (const Eigen::Vector3d& p : corners)
    seen.push_back({p[x] - corners[0][x], p[y] - corners[0][y]});
  return seen;
}

// Twice its area; above 0 where it turns to the left.
double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// To the left, by an area that cleanMesh leaves.
bool turnsLeft(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double turn = turnOf(a, b, c);
  return turn > 0.0 && turn * turn > kZeroArea * (b - a).squaredNorm() * (c - a).squaredNorm();
}

// Cuts ears off, corners at which nothing else of the polygon is in the way.
class EarCutter {
 public:
  explicit EarCutter(std::vector<Eigen::Vector2d> corners) : at_(std::move(corners)) {
    const int count = static_cast<int>(at_.size());
    for (int i = 0; i < count; ++i) around_.push_back({(i + count - 1) % count, (i + 1) % count});
    for (int i = 0; i < count; ++i)
      if (!isConvex(i)) blunt_.push_back(i);
  }

  std::vector<std::array<int, 3>> cut() {
    std::vector<std::array<int, 3>> triangles;
    int corner = 1, left = static_cast<int>(at_.size());
    for (int passed = 0; left > 3;) {
      // A polygon that crosses itself may have none: then any is taken.
      if (!isEar(corner) && passed++ < left) {
        corner = around_[corner].next;
        continue;
      }
      triangles.push_back({around_[corner].before, corner, around_[corner].next});
      corner = takeOut(corner);
      passed = 0;
      --left;
    }
    triangles.push_back({around_[corner].before, corner, around_[corner].next});
    return triangles;
  }

 private:
  struct Around {
    int before, next;
  };

  bool isConvex(int corner) const {
    return turnsLeft(at_[around_[corner].before], at_[corner], at_[around_[corner].next]);
  }

  // What is in the way has a corner in it, or on its edge, that is not convex.
  bool isEar(int corner) const {
    const Eigen::Vector2d &a = at_[around_[corner].before], &b = at_[corner],
                          &c = at_[around_[corner].next];
    if (!turnsLeft(a, b, c)) return false;
    for (const int other : blunt_) {
      const Eigen::Vector2d& p = at_[other];
      if (p == a || p == b || p == c) continue;
      if (turnOf(a, b, p) >= 0.0 && turnOf(b, c, p) >= 0.0 && turnOf(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  // Returns the next.
  int takeOut(int corner) {
    const int before = around_[corner].before, next = around_[corner].next;
    around_[before].next = next;
    around_[next].before = before;
    std::erase_if(
        blunt_, [&](int i) { return i == corner || ((i == before || i == next) && isConvex(i)); });
    return next;
  }

  std::vector<Eigen::Vector2d> at_;
  std::vector<Around> around_;
  std::vector<int> blunt_;  // corners that are not convex
};

}  // namespace

std::vector<std::array<int, 3>> cutPolygon(const std::vector<Eigen::Vector3d>& corners) {
  assert(corners.size() >= 3);
  return EarCutter(seenFromAbove(corners)).cut();
}

}  // namespace amble
