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

// Arc length of the curve between two parameters (five-point Gauss-Legendre).
double arcLength(const Bezier& c, double u0, double u1) {
  static constexpr double kNode[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
  static constexpr double kWeight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (u0 + u1), half = 0.5 * (u1 - u0);
  double sum = kWeight[0] * velocity(c, middle).norm();
  for (int i = 1; i < 3; ++i) {
    sum += kWeight[i] * (velocity(c, middle - half * kNode[i]).norm() +
                         velocity(c, middle + half * kNode[i]).norm());
  }
  return sum * half;
}

double headingOf(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

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
      pieces_.push_back({u0, u1, length_, length, heading, static_cast<int>(k)});
      length_ += length;
    }
  }
}

double RootPath::parameterAt(const Piece& piece, double s) const {
  if (!(piece.length > 0.0)) return piece.u0;
  const Bezier& curve = curves_[piece.curve];
  double u = piece.u0 + (piece.u1 - piece.u0) * (s - piece.s0) / piece.length;
  for (int i = 0; i < 4; ++i) {  // Newton: within a piece the speed hardly changes
    const double speed = velocity(curve, u).norm();
    if (!(speed > 0.0)) break;
    const double step = (s - piece.s0 - arcLength(curve, piece.u0, u)) / speed;
    u = std::clamp(u + step, piece.u0, piece.u1);
    if (std::abs(step) < 1e-14) break;
  }
  return u;
}

RootPath::Sample RootPath::at(double s) const {
  if (pieces_.empty()) return {Eigen::Vector2d::Zero(), 0.0, 0.0};
  s = std::clamp(s, 0.0, length_);
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                [](double value, const Piece& p) { return value < p.s0; });
  if (piece != pieces_.begin()) --piece;
  const Bezier& curve = curves_[piece->curve];
  const double u = s >= length_ ? 1.0 : parameterAt(*piece, s);
  const Eigen::Vector2d v = velocity(curve, u), a = acceleration(curve, u);
  const double speed = v.norm();
  const double cross = v.x() * a.y() - v.y() * a.x();
  return {position(curve, u), piece->heading0 + wrapAngle(headingOf(v) - piece->heading0),
          speed > 0.0 ? cross / (speed * speed * speed) : 0.0};
}

void RootPath::append(const RootPath& next) {
  std::vector<Bezier> curves = curves_;
  curves.insert(curves.end(), next.curves_.begin(), next.curves_.end());
  *this = RootPath(std::move(curves));
}

}  // namespace amble
