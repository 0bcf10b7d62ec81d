#include "animation/steps/root_path.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// A cubic's speed is smooth; over a 24th of it, five Gauss-Legendre points are exact to 1e-12
// unless a handle nearly vanishes.
constexpr int kPiecesPerCurve = 24;

Eigen::Vector2d position(const Bezier& c, double u) {
  const double v = 1.0 - u;
  return v * v * v * c.col(0) + 3.0 * u * v * v * c.col(1) + 3.0 * u * u * v * c.col(2) +
         u * u * u * c.col(3);
}

Eigen::Vector2d velocity(const Bezier& c, double u) {
  const double v = 1.0 - u;
  return 3.0 * (v * v * (c.col(1) - c.col(0)) + 2.0 * u * v * (c.col(2) - c.col(1)) +
                u * u * (c.col(3) - c.col(2)));
}

Eigen::Vector2d acceleration(const Bezier& c, double u) {
  return 6.0 * ((1.0 - u) * (c.col(2) - 2.0 * c.col(1) + c.col(0)) +
                u * (c.col(3) - 2.0 * c.col(2) + c.col(1)));
}

using Two = double __attribute__((vector_size(2 * sizeof(double))));

// Arc length of the curve between two parameters (five-point Gauss-Legendre). Speeds are those of
// velocity() to the bit, two at once.
double arcLength(const Bezier& c, double u0, double u1) {
  static constexpr double kNode[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
  static constexpr double kWeight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (u0 + u1), half = 0.5 * (u1 - u0);
  const Eigen::Vector2d a = c.col(1) - c.col(0), b = c.col(2) - c.col(1), d = c.col(3) - c.col(2);
  const auto squared_speed = [&](const auto& u) {
    const auto v = 1.0 - u, vv = v * v, uv = 2.0 * u * v, uu = u * u;
    const auto x = 3.0 * (vv * a.x() + uv * b.x() + uu * d.x()),
               y = 3.0 * (vv * a.y() + uv * b.y() + uu * d.y());
    return x * x + y * y;
  };
  double sum = kWeight[0] * std::sqrt(squared_speed(middle));
  for (int i = 1; i < 3; ++i) {
    const double off = half * kNode[i];
    const Two square = squared_speed(Two{middle - off, middle + off});
    sum += kWeight[i] * (std::sqrt(square[0]) + std::sqrt(square[1]));
  }
  return sum * half;
}

double headingOf(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

double curvature(const Eigen::Vector2d& v, const Eigen::Vector2d& a) {
  const double speed = v.norm();
  return speed > 0.0 ? (v.x() * a.y() - v.y() * a.x()) / (speed * speed * speed) : 0.0;
}

// Derivatives of the parameter by arc length, first and second: u' = 1 / |v|, and that once more.
Eigen::Vector2d parameterSlopes(const Bezier& c, double u) {
  const Eigen::Vector2d v = velocity(c, u);
  const double square = v.squaredNorm();
  return {1.0 / std::sqrt(square), -v.dot(acceleration(c, u)) / (square * square)};
}

// The polynomial over t, 0 to 1, that has these values, slopes and second derivatives at its ends.
std::array<double, 6> quintic(double a, const Eigen::Vector2d& da, double b,
                              const Eigen::Vector2d& db) {
  const double rise = b - a - da[0] - 0.5 * da[1];
  const double slope = db[0] - da[0] - da[1], bend = db[1] - da[1];
  return {a,
          da[0],
          0.5 * da[1],
          10.0 * rise - 4.0 * slope + 0.5 * bend,
          -15.0 * rise + 7.0 * slope - bend,
          6.0 * rise - 3.0 * slope + 0.5 * bend};
}

double valueAt(const std::array<double, 6>& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
}

}  // namespace

Bezier makeBezier(const Eigen::Vector2d& from, double from_heading, const Eigen::Vector2d& to,
                  double to_heading, double handle) {
  const double h = handle * (to - from).norm();
  Bezier curve;
  curve.col(0) = from;
  curve.col(1) = from + h * Eigen::Vector2d(std::cos(from_heading), std::sin(from_heading));
  curve.col(2) = to - h * Eigen::Vector2d(std::cos(to_heading), std::sin(to_heading));
  curve.col(3) = to;
  return curve;
}

RootPath::RootPath(std::vector<Bezier> curves) : curves_(std::move(curves)) {
  double heading = curves_.empty() ? 0.0 : headingOf(velocity(curves_[0], 0.0));
  pieces_.reserve(curves_.size() * kPiecesPerCurve);
  for (size_t k = 0; k < curves_.size(); ++k) {
    for (int i = 0; i < kPiecesPerCurve; ++i) {
      const double u0 = static_cast<double>(i) / kPiecesPerCurve;
      const double u1 = static_cast<double>(i + 1) / kPiecesPerCurve;
      heading += wrapAngle(headingOf(velocity(curves_[k], u0)) - heading);
      const double length = arcLength(curves_[k], u0, u1);
      pieces_.push_back({u0, u1, length_, length, heading, static_cast<int>(k), false, {}});
      length_ += length;
    }
    tabulate(static_cast<int>(k));
  }
}

// The parameter over arc length in each piece of a curve. Its error is largest in the middle: where
// that is too large (a handle nearly vanishes, and with it the speed) the piece stays without.
void RootPath::tabulate(int curve) {
  const Bezier& c = curves_[curve];
  Eigen::Vector2d begin = parameterSlopes(c, 0.0);
  for (size_t i = pieces_.size() - kPiecesPerCurve; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    const Eigen::Vector2d end = parameterSlopes(c, piece.u1);
    const Eigen::Vector2d scale(piece.length, piece.length * piece.length);
    piece.parameter =
        quintic(piece.u0, begin.cwiseProduct(scale), piece.u1, end.cwiseProduct(scale));
    const double middle = valueAt(piece.parameter, 0.5);
    piece.tabulated =
        middle > piece.u0 && middle < piece.u1 &&
        std::abs(arcLength(c, piece.u0, middle) - 0.5 * piece.length) < kTableError * piece.length;
    begin = end;
  }
}

double RootPath::parameterAt(const Piece& piece, double s) const {
  if (!(piece.length > 0.0)) return piece.u0;
  const double share = (s - piece.s0) / piece.length;
  double u = valueAt(piece.parameter, share);
  if (piece.tabulated) return u;
  const Bezier& curve = curves_[piece.curve];
  if (!(u >= piece.u0 && u <= piece.u1)) u = piece.u0 + (piece.u1 - piece.u0) * share;
  for (int i = 0; i < 6; ++i) {  // Newton, whose next step is as the square of its last
    const double speed = velocity(curve, u).norm();
    if (!(speed > 0.0)) break;
    const double step = (s - piece.s0 - arcLength(curve, piece.u0, u)) / speed;
    u = std::clamp(u + step, piece.u0, piece.u1);
    if (std::abs(step) < 1e-8) break;
  }
  return u;
}

RootPath::Place RootPath::placeAt(double s) const {
  s = std::clamp(s, 0.0, length_);
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                [](double value, const Piece& p) { return value < p.s0; });
  if (piece != pieces_.begin()) --piece;
  return {*piece, s >= length_ ? 1.0 : parameterAt(*piece, s)};
}

RootPath::Sample RootPath::at(double s) const {
  if (pieces_.empty()) return {Eigen::Vector2d::Zero(), 0.0, 0.0};
  const auto& [piece, u] = placeAt(s);
  const Bezier& curve = curves_[piece.curve];
  const Eigen::Vector2d v = velocity(curve, u);
  return {position(curve, u), piece.heading0 + wrapAngle(headingOf(v) - piece.heading0),
          curvature(v, acceleration(curve, u))};
}

double RootPath::curvatureAt(double s) const {
  if (pieces_.empty()) return 0.0;
  const auto& [piece, u] = placeAt(s);
  const Bezier& curve = curves_[piece.curve];
  return curvature(velocity(curve, u), acceleration(curve, u));
}

void RootPath::append(const RootPath& next) {
  std::vector<Bezier> curves = curves_;
  curves.insert(curves.end(), next.curves_.begin(), next.curves_.end());
  *this = RootPath(std::move(curves));
}

// A cubic is farthest along an axis at its ends, or where its velocity along it, which is three
// times a (1-u)^2 + 2 b u (1-u) + d u^2, is none.
Eigen::AlignedBox2d RootPath::extent() const {
  Eigen::AlignedBox2d box;
  for (const Bezier& c : curves_) {
    box.extend(c.col(0).eval()).extend(c.col(3).eval());
    for (int axis = 0; axis < 2; ++axis) {
      const double a = c(axis, 1) - c(axis, 0), b = c(axis, 2) - c(axis, 1),
                   d = c(axis, 3) - c(axis, 2), half = b - a, square = a - 2.0 * b + d;
      const double under_root = half * half - square * a;
      if (under_root < 0.0) continue;
      const double sum = -(half + std::copysign(std::sqrt(under_root), half));
      for (const double u : {sum / square, a / sum}) {
        if (u > 0.0 && u < 1.0) box.extend(position(c, u));
      }
    }
  }
  return box;
}

}  // namespace amble
