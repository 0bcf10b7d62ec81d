#include "viz/figure/simplify_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <vector>

namespace amble {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Sum of squared distances to planes, weighed by their triangles' areas: x'Ax - 2b'x + c.
struct Quadric {
  Matrix3d a = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  double c = 0.0;

  void addPlane(const Vector3d& unit, double offset, double weight) {
    a += weight * unit * unit.transpose();
    b += weight * offset * unit;
    c += weight * offset * offset;
  }
  Quadric operator+(const Quadric& other) const { return {a + other.a, b + other.b, c + other.c}; }
  double at(const Vector3d& x) const { return x.dot(a * x) - 2.0 * b.dot(x) + c; }
};

struct Collapse {
  double cost;
  int u, v;  // u < v
  int age_u, age_v;
  Vector3d to;

  bool operator<(const Collapse& other) const {  // the queue's top is the largest
    return std::tie(other.cost, other.u, other.v) < std::tie(cost, u, v);
  }
};

class Simplifier {
 public:
  explicit Simplifier(const TriangleMesh& mesh)
      : at_(mesh.vertices),
        triangles_(mesh.triangles),
        fans_(at_.size()),
        quadrics_(at_.size()),
        ages_(at_.size(), 0),
        left_(static_cast<int>(triangles_.size())) {
    for (int i = 0; i < static_cast<int>(triangles_.size()); ++i) {
      const auto& t = triangles_[i];
      const Vector3d cross = normal(t);
      const double twice = cross.norm();
      for (const int v : t) {
        fans_[v].push_back(i);
        if (twice > 0.0) quadrics_[v].addPlane(cross / twice, cross.dot(at_[t[0]]) / twice, twice);
      }
    }
  }

  // What may not go at first may when what lies around has gone: again until nothing does.
  TriangleMesh make(int triangles) {
    for (int before = left_ + 1; left_ > triangles && left_ < before;) {
      before = left_;
      offerAll();
      while (left_ > triangles && !queue_.empty()) {
        const Collapse best = queue_.top();
        queue_.pop();
        if (ages_[best.u] != best.age_u || ages_[best.v] != best.age_v) continue;
        if (allowed(best)) collapse(best);
      }
    }
    return result();
  }

 private:
  using Triangle = std::array<int, 3>;

  void offerAll() {
    for (const Triangle& t : triangles_)
      for (int i = 0; i < 3 && t[0] >= 0; ++i)
        if (t[i] < t[(i + 1) % 3]) offer(t[i], t[(i + 1) % 3]);
  }

  Vector3d normal(const Triangle& t) const {
    return (at_[t[1]] - at_[t[0]]).cross(at_[t[2]] - at_[t[0]]);
  }

  static bool has(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

  void offer(int u, int v) {
    const Quadric both = quadrics_[u] + quadrics_[v];
    Vector3d to = 0.5 * (at_[u] + at_[v]);
    const double scale = both.a.trace();
    const Matrix3d inverse_of = both.a + 1e-4 * scale * Matrix3d::Identity();  // near the middle
    to += inverse_of.inverse() * (both.b - both.a * to);
    // What costs nothing goes by length, so that flat parts are not thinned out from one end.
    const double cost = both.at(to) + 1e-5 * scale * (at_[u] - at_[v]).squaredNorm();
    queue_.push({cost, u, v, ages_[u], ages_[v], to});
  }

  std::vector<int> neighbours(int v) const {
    std::vector<int> all;
    for (const int i : fans_[v])
      for (const int w : triangles_[i])
        if (w != v) all.push_back(w);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // The surface stays one (only the two corners across are neighbours of both), and no triangle
  // around turns by more than some 70 degrees or becomes a thin one.
  bool allowed(const Collapse& c) {
    const std::vector<int> a = neighbours(c.u), b = neighbours(c.v);
    std::vector<int> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2 || a.size() + b.size() < 8) return false;
    return staysUp(c.u, c.v, c.to) && staysUp(c.v, c.u, c.to);
  }

  bool staysUp(int v, int gone, const Vector3d& to) const {
    for (const int i : fans_[v]) {
      const Triangle& t = triangles_[i];
      if (has(t, gone)) continue;
      std::array<Vector3d, 3> p, q;
      for (int k = 0; k < 3; ++k) {
        p[k] = t[k] == v ? to : at_[t[k]];
        q[k] = at_[t[k]];
      }
      const Vector3d after = (p[1] - p[0]).cross(p[2] - p[0]), before = normal(t);
      constexpr double kTurn = 0.3, kThin = 0.1;  // cosine; height over the longest side
      const double was = thinness(q);
      if (!(after.dot(before) > kTurn * after.norm() * before.norm())) return false;
      if (!(thinness(p) > std::min(kThin, was))) return false;
    }
    return true;
  }

  // Height of a triangle over its longest side [0, 0.87].
  static double thinness(const std::array<Vector3d, 3>& p) {
    const double longest = std::max(
        {(p[1] - p[0]).squaredNorm(), (p[2] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm()});
    return longest > 0.0 ? (p[1] - p[0]).cross(p[2] - p[0]).norm() / longest : 0.0;
  }

  void collapse(const Collapse& c) {
    at_[c.u] = c.to;
    quadrics_[c.u] = quadrics_[c.u] + quadrics_[c.v];
    for (const int i : fans_[c.v]) {
      Triangle& t = triangles_[i];
      if (has(t, c.u)) {
        for (const int w : t)
          if (w != c.v) std::erase(fans_[w], i);
        t = {-1, -1, -1};
        --left_;
        continue;
      }
      for (int& w : t)
        if (w == c.v) w = c.u;
      fans_[c.u].push_back(i);
    }
    fans_[c.v].clear();
    ++ages_[c.v];
    ++ages_[c.u];
    for (const int w : neighbours(c.u)) offer(std::min(c.u, w), std::max(c.u, w));
  }

  TriangleMesh result() const {
    TriangleMesh mesh;
    std::vector<int> index(at_.size(), -1);
    for (const Triangle& t : triangles_) {
      if (t[0] < 0) continue;
      Triangle named;
      for (int k = 0; k < 3; ++k) {
        int& i = index[t[k]];
        if (i < 0) {
          i = static_cast<int>(mesh.vertices.size());
          mesh.vertices.push_back(at_[t[k]]);
        }
        named[k] = i;
      }
      mesh.triangles.push_back(named);
    }
    return mesh;
  }

  std::vector<Vector3d> at_;
  std::vector<Triangle> triangles_;     // gone ones hold -1
  std::vector<std::vector<int>> fans_;  // triangles around each vertex
  std::vector<Quadric> quadrics_;
  std::vector<int> ages_;  // what was offered at another age of its ends is out of date
  int left_;
  std::priority_queue<Collapse> queue_;
};

}  // namespace

TriangleMesh simplifyMesh(const TriangleMesh& mesh, int triangles) {
  return Simplifier(mesh).make(triangles);
}

}  // namespace amble
