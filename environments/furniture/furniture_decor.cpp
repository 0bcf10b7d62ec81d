// Lamp and plant, and the list of what the living room holds.
#include <cmath>

#include "environments/furniture/furniture.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

// A pointed blade along +x from the origin, its width in y, that arches upwards and then droops.
Surface leaf(double length, double width, double droop) {
  Surface blade = makeRoundedBox({{length, width, 0.003}, 0.0012, 0, {7, 2, 1}});
  return blade.deform([=](const Vector3d& p) {
    const double along = p.x() / length + 0.5;  // 0 at the stem, 1 at the tip
    const double wide = 0.08 + 0.92 * std::pow(std::sin(kPi * std::pow(along, 0.8)), 0.8);
    const double fold = 0.18 * std::abs(p.y()) * wide;  // the halves rise from the middle rib
    return Vector3d(along * length, p.y() * wide, p.z() + fold - droop * length * along * along);
  });
}

}  // namespace

Furniture makeLamp() {
  Furniture piece{"lamp", {}};
  piece.add("foot", makeLathe({{0, 0},
                               {0.145, 0},
                               {0.150, 0.006},
                               {0.148, 0.016},
                               {0.10, 0.026},
                               {0.03, 0.034},
                               {0.016, 0.05},
                               {0, 0.05}},
                              36));
  piece.add("pole", makeTube({{0, 0, 0.045}, {0, 0, 1.46}}, {0.011, 0.011}, 16));
  std::vector<Vector2d> shade;  // one closed skin: up on the outside, down on the inside
  const auto outside = smoothCurve({{0.21, 1.28}, {0.185, 1.38}, {0.150, 1.50}, {0.120, 1.62}}, 5);
  shade.insert(shade.end(), outside.begin(), outside.end());
  for (auto p = outside.rbegin(); p != outside.rend(); ++p)
    shade.emplace_back(p->x() - 0.004, p->y());
  piece.add("shade", makeLathe(shade, 44, true));
  piece.add(
      "bulb",
      makeLathe(
          smoothCurve(
              {{0, 1.455}, {0.018, 1.46}, {0.022, 1.49}, {0.034, 1.53}, {0.022, 1.565}, {0, 1.57}},
              3),
          20));
  for (int i = 0; i < 3; ++i) {  // spokes that carry the shade
    const double angle = 2 * kPi * i / 3;
    const Vector2d out(std::cos(angle), std::sin(angle));
    piece.add("pole", makeTube({{0.012 * out.x(), 0.012 * out.y(), 1.455},
                                {0.160 * out.x(), 0.160 * out.y(), 1.455}},
                               {0.003, 0.003}, 6));
  }
  return piece;
}

Furniture makePlant() {
  Furniture piece{"plant", {}};
  piece.add("pot", makeLathe({{0, 0},
                              {0.115, 0},
                              {0.122, 0.008},
                              {0.150, 0.26},
                              {0.164, 0.265},
                              {0.166, 0.30},
                              {0.160, 0.306},
                              {0.148, 0.300},
                              {0.142, 0.27},
                              {0, 0.275}},
                             48));
  constexpr int kStems = 11;
  for (int i = 0; i < kStems; ++i) {
    const double turn =
        i * 137.5077640500378;  // the golden angle: leaves shade one another least [degrees]
    const double height = 0.55 + 0.055 * ((i * 7) % kStems);
    const double lean = 0.07 + 0.012 * ((i * 5) % kStems);
    const Vector2d out(std::cos(turn * kPi / 180), std::sin(turn * kPi / 180));
    const Vector2d top = lean * out;
    piece.add(
        "stems",
        makeTube({{0.03 * out.x(), 0.03 * out.y(), 0.262},
                  {0.4 * top.x() + 0.02 * out.x(), 0.4 * top.y() + 0.02 * out.y(), height * 0.7},
                  {top.x(), top.y(), height}},
                 {0.007, 0.006, 0.004}, 8));
    for (int k = 0; k < 5; ++k) {
      Surface blade = leaf(0.24 + 0.02 * ((i + 3 * k) % 5), 0.085, 0.35 + 0.06 * k);
      blade.rotate(1, -(58 - 13.0 * k)).rotate(2, turn + k * 137.5077640500378);
      piece.add("leaves", blade.move(top.x(), top.y(), height - 0.04 * k));
    }
  }
  return piece;
}

std::vector<Furniture> makeLivingRoomFurniture() {
  return {makePiano(),     makePianoStool(),  makeSofa(),  makeArmchair(),
          makeLowTable(),  makeDiningTable(), makeChair(), makeLamp(),
          makeBookshelf(), makePlant(),       makeDoor(),  makePicture()};
}

}  // namespace amble
