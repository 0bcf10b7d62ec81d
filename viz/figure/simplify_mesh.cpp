#include "viz/figure/simplify_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
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

struct Edge {
  double cost;
  int u, v;  // u < v

  bool operator<(const Edge& other) const {
    return std::tie(cost, u, v) < std::tie(other.cost, other.u, other.v);
  }
};

class Simplifier {
 public:
  explicit Simplifier(const TriangleMesh& mesh)
      : at_(mesh.vertices),
        triangles_(mesh.triangles),
        fans_(at_.size()),
        quadrics_(at_.size()),
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

  // In rounds, of which each takes the cheaper edges once, none beside one that went before it.
  TriangleMesh make(int triangles) {
    double share = kShare;
    while (left_ > triangles) {
      const int before = left_;
      round(triangles, share);
      if (left_ == before && share == 1.0) break;
      share = left_ < before ? kShare : 1.0;
    }
    return result();
  }

 private:
  using Triangle = std::array<int, 3>;

  static constexpr double kShare = 0.4;  // of the edges that a round tries

  void round(int triangles, double share) {
    edges_.clear();
    for (const Triangle& t : triangles_)
      for (int i = 0; i < 3 && t[0] >= 0; ++i)
        if (t[i] < t[(i + 1) % 3]) edges_.push_back(costOf(t[i], t[(i + 1) % 3]));
    const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(
                                          std::ceil(share * static_cast<double>(edges_.size())));
    if (end != edges_.end()) std::nth_element(edges_.begin(), end, edges_.end());
    std::sort(edges_.begin(), end);
    touched_.assign(at_.size(), false);
    for (auto edge = edges_.begin(); edge != end && left_ > triangles; ++edge) {
      if (touched_[edge->u] || touched_[edge->v]) continue;
      const Vector3d to = place(edge->u, edge->v, quadrics_[edge->u] + quadrics_[edge->v]);
      if (allowed(edge->u, edge->v, to)) collapse(edge->u, edge->v, to);
    }
  }

  Vector3d normal(const Triangle& t) const {
    return (at_[t[1]] - at_[t[0]]).cross(at_[t[2]] - at_[t[0]]);
  }

  static bool has(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

  Edge costOf(int u, int v) const {
    const Quadric both = quadrics_[u] + quadrics_[v];
    // What costs nothing goes by length, so that flat parts are not thinned out from one end.
    return {both.at(place(u, v, both)) + 1e-5 * both.a.trace() * (at_[u] - at_[v]).squaredNorm(), u,
            v};
  }

  // The best, near the middle where many are.
  Vector3d place(int u, int v, const Quadric& both) const {
    const Vector3d middle = 0.5 * (at_[u] + at_[v]);
    const Matrix3d a = both.a + 1e-4 * both.a.trace() * Matrix3d::Identity();
    return middle + a.inverse() * (both.b - both.a * middle);
  }

  void neighbours(int v, std::vector<int>& all) const {
    all.clear();
    for (const int i : fans_[v])
      for (const int w : triangles_[i])
        if (w != v) all.push_back(w);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  // The surface stays one (only the two corners across are neighbours of both), and no triangle
  // around turns by more than some 70 degrees or becomes a thin one.
  bool allowed(int u, int v, const Vector3d& to) {
    neighbours(u, around_u_);
    neighbours(v, around_v_);
    const auto common = std::count_if(around_u_.begin(), around_u_.end(), [&](int w) {
      return std::binary_search(around_v_.begin(), around_v_.end(), w);
    });
    if (common != 2 || around_u_.size() + around_v_.size() < 8) return false;
    return staysUp(u, v, to) && staysUp(v, u, to);
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

  void collapse(int u, int v, const Vector3d& to) {
    at_[u] = to;
    quadrics_[u] = quadrics_[u] + quadrics_[v];
    for (const int i : fans_[v]) {
      Triangle& t = triangles_[i];
      if (has(t, u)) {
        for (const int w : t)
          if (w != v) std::erase(fans_[w], i);
        t = {-1, -1, -1};
        --left_;
        continue;
      }
      for (int& w : t)
        if (w == v) w = u;
      fans_[u].push_back(i);
    }
    fans_[v].clear();
    touched_[u] = touched_[v] = true;
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
  int left_;
  std::vector<int> around_u_, around_v_;  // scratch
  std::vector<Edge> edges_;               // of a round
  std::vector<bool> touched_;             // by vertex: something beside it went in this round
};

}  // namespace

TriangleMesh simplifyMesh(const TriangleMesh& mesh, int triangles) {
  return Simplifier(mesh).make(triangles);
}

}  // namespace amble
