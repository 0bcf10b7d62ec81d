#include <cmath>

#include "environments/furniture/furniture.h"

namespace amble {
namespace {

// Amplitude [m] times wave number [1/m] is the steepest slope of each, across its crests; where
// both are steepest the sum of these vectors is 0.261 long: 14.6 degrees.
double heightAt(double x, double y) {
  return 0.40 * std::sin(0.45 * x + 0.3 * y) + 0.0635 * std::sin(1.1 * x - 0.7 * y + 1.0);
}

}  // namespace

Furniture makeTerrain() {
  RoundedBox block;
  block.size = {16.0, 10.0, 2.0};
  block.arc = 0;
  block.inner = {64, 40, 1};
  Surface surface = makeRoundedBox(block);
  surface.deform([](const Eigen::Vector3d& p) {
    return p.z() > 0.0 ? Eigen::Vector3d(p.x(), p.y(), heightAt(p.x(), p.y())) : p;
  });
  Furniture terrain;
  terrain.name = "terrain";
  terrain.add("terrain", surface);
  return terrain;
}

}  // namespace amble
