/// The root path: cubic Bezier curves in the plane, by arc length (Pettré §3, eq. 1).
///
/// With control points P0..P3 the curve is sum_i C(3,i) u^i (1-u)^(3-i) P_i, 0 <= u <= 1. Heading
/// is atan2(y', x') (the paper's arctan(y'/x') would forbid half of the headings). Everything is
/// asked by arc length s [m], 0 <= s <= length().
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace amble {

/// One cubic Bezier curve: columns are P0, P1, P2, P3 [m].
using Bezier = Eigen::Matrix<double, 2, 4>;

/// The curve from one place and heading to another whose handles are `handle` times the distance
/// long [0.1, 2].
Bezier makeBezier(const Eigen::Vector2d& from, double from_heading, const Eigen::Vector2d& to,
                  double to_heading, double handle = 0.4);

class RootPath {
 public:
  struct Sample {
    Eigen::Vector2d position;  ///< [m]
    double heading;            ///< [rad], without jumps along the path
    double curvature;          ///< [1/m], left positive
  };

  RootPath() = default;
  explicit RootPath(std::vector<Bezier> curves);

  bool empty() const { return curves_.empty(); }
  const std::vector<Bezier>& curves() const { return curves_; }
  /// Exact to 1e-9 relative, by Gauss-Legendre quadrature [m, >= 0].
  double length() const { return length_; }
  /// s is held within [0, length()]; where it is on the curves is exact to kTableError.
  Sample at(double s) const;
  double curvatureAt(double s) const;  ///< of at(s) alone [1/m]
  /// Of the arc length at which the curve's parameter is read from a table, in pieces' lengths, of
  /// which a curve has 24.
  static constexpr double kTableError = 1e-10;
  void append(const RootPath& next);
  Eigen::AlignedBox2d extent() const;  ///< the least box around it; empty without curves [m]

 private:
  struct Piece {
    double u0, u1;    // parameters at the piece's ends
    double s0;        // arc length at its begin [m]
    double length;    // [m]
    double heading0;  // at its begin, without jumps along the path [rad]
    int curve;
    bool tabulated;                   // whether `parameter` is exact enough
    std::array<double, 6> parameter;  // as a polynomial of the share of the length
  };
  struct Place {
    const Piece& piece;
    double u;
  };
  void tabulate(int curve);
  Place placeAt(double s) const;
  double parameterAt(const Piece& piece, double s) const;

  std::vector<Bezier> curves_;
  std::vector<Piece> pieces_;  // a fixed number a curve, in order of s0
  double length_ = 0.0;
};

}  // namespace amble
