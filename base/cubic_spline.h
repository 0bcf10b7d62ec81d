/// Cubic splines through points, with two continuous derivatives and given slopes at both ends.
#pragma once

#include <vector>

namespace amble {

class CubicSpline {
 public:
  CubicSpline() = default;
  /// Through (x[i], y[i]) with the slopes of the first and the last point given.
  /// @pre x strictly increasing, as many as y, at least 2
  CubicSpline(std::vector<double> x, std::vector<double> y, double first_slope, double last_slope);

  /// Where the points rise, makes the curve rise between them as well: slopes are cut to where a
  /// cubic has no hump (Fritsch & Carlson 1980), which costs the second derivative's continuity
  /// there. The ends' slopes are cut, too.
  void keepRising();

  double at(double x) const;     ///< x is held within the points
  double slope(double x) const;  ///< first derivative

 private:
  int piece(double x) const;

  std::vector<double> x_, y_, slopes_;
};

}  // namespace amble
