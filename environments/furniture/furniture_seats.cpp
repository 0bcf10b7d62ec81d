// What people sit on: stool, chair, sofa, armchair.
#include <algorithm>
#include <cmath>

#include "environments/furniture/furniture.h"

namespace amble {
namespace {

using Eigen::Vector3d;

Surface block(const Vector3d& size, const Vector3d& at, double radius, int arc = 1) {
  return makeRoundedBox({size, radius, arc}).move(at.x(), at.y(), at.z());
}

// A stuffed cushion: its broad sides (normal to z) bulge by `bulge` in the middle, seams stay where
// they are.
Surface cushion(const Vector3d& size, double radius, double bulge) {
  const Vector3d half = size / 2;
  return makeRoundedBox({size, radius, 2, {7, 7, 1}}).deform([=](const Vector3d& p) {
    const double x = p.x() / half.x();
    const double y = p.y() / half.y();
    const double fill = std::max(0.0, 1 - x * x) * std::max(0.0, 1 - y * y);
    return Vector3d(p.x(), p.y(), p.z() + bulge * fill * p.z() / half.z());
  });
}

// Legs at the corners of a rectangle, feet wider apart than tops by `splay` [m].
void addFourLegs(Furniture& piece, double x, double y, double splay, const Leg& like) {
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      Leg leg = like;
      leg.top = {sx * x, sy * y};
      leg.foot = {sx * (x + splay), sy * (y + splay)};
      piece.add("legs", makeLeg(leg));
    }
  }
}

// Frame, arms and feet that sofa and armchair share; seats are between the arms.
struct Upholstery {
  double width, depth;             // over all [m]
  double arm;                      // width of an arm [m]
  double seat, arm_top, back_top;  // heights [m]
  int seats;
};

constexpr double kFeet = 0.10;       // height of sofa feet [m]
constexpr double kCushion = 0.16;    // thickness of a seat cushion [m]
constexpr double kBackDepth = 0.20;  // of the frame's back [m]

void addFrame(Furniture& piece, const Upholstery& u) {
  const double base_top = u.seat - kCushion;
  piece.add("frame",
            block({u.width - 2 * u.arm - 0.004, u.depth - kBackDepth - 0.03, base_top - kFeet},
                  {0, -kBackDepth / 2, (base_top + kFeet) / 2}, 0.02, 2));
  for (const double side : {-1.0, 1.0}) {
    Surface arm = makeRoundedBox({{u.arm, u.depth, u.arm_top - kFeet}, 0.055, 3});
    arm.move(side * (u.width - u.arm) / 2, 0, (u.arm_top + kFeet) / 2);
    piece.add("arms", arm);
  }
  Surface back = makeRoundedBox(
      {{u.width - 2 * u.arm - 0.004, kBackDepth, u.back_top - kFeet}, 0.06, 3, {3, 1, 3}});
  back.deform([&](const Vector3d& p) {  // leans back, but not beyond the depth over all
    return Vector3d(p.x(), p.y() + 0.04 * p.z() / u.back_top - 0.03, p.z());
  });
  piece.add("frame", back.move(0, (u.depth - kBackDepth) / 2, (u.back_top + kFeet) / 2));
  Leg foot{
      .foot = {}, .top = {}, .height = kFeet + 0.015, .foot_radius = 0.022, .top_radius = 0.03};
  addFourLegs(piece, u.width / 2 - 0.09, u.depth / 2 - 0.09, 0, foot);
}

void addCushions(Furniture& piece, const Upholstery& u) {
  const double pitch = (u.width - 2 * u.arm) / u.seats;
  const double seat_depth = u.depth - kBackDepth - 0.02;
  for (int i = 0; i < u.seats; ++i) {
    const double x = (i - (u.seats - 1) / 2.0) * pitch;
    piece.add("cushions", cushion({pitch - 0.012, seat_depth, kCushion - 0.02}, 0.045, 0.02)
                              .move(x, -kBackDepth / 2 - 0.01, u.seat - kCushion / 2));
    piece.add("cushions", cushion({pitch - 0.02, 0.46, 0.14}, 0.06, 0.04)
                              .rotate(0, 78)
                              .move(x, u.depth / 2 - kBackDepth - 0.105, u.seat + 0.235));
  }
}

Furniture upholster(const std::string& name, const Upholstery& upholstery) {
  Furniture piece{name, {}};
  addFrame(piece, upholstery);
  addCushions(piece, upholstery);
  return piece;
}

}  // namespace

Furniture makePianoStool() {
  Furniture piece{"piano-stool", {}};
  Surface seat = makeRoundedBox({{0.44, 0.34, 0.07}, 0.03, 3, {10, 8, 1}});
  seat.deform([](const Vector3d& p) {  // padded: a low dome with eight tufts drawn in
    const double share = std::max(0.0, p.z() / 0.035);  // only the upper half is stuffed
    const double dome = 0.010 * (1 - std::pow(p.x() / 0.22, 2)) * (1 - std::pow(p.y() / 0.17, 2));
    const double tuft = 0.004 * std::pow(std::cos(p.x() * 22) * std::cos(p.y() * 28), 2);
    return Vector3d(p.x(), p.y(), p.z() + share * (dome - tuft - 0.010));
  });
  piece.add("seat", seat.move(0, 0, 0.465));
  piece.add("apron", block({0.41, 0.31, 0.05}, {0, 0, 0.410}, 0.006, 2));
  addFourLegs(piece, 0.175, 0.125, 0.012, {{}, {}, 0.39, 0.014, 0.022, 16});
  for (const double y : {-0.128, 0.128})
    piece.add("stretchers", makeTube({{-0.18, y, 0.12}, {0.18, y, 0.12}}, {0.008, 0.008}, 10));
  piece.add("stretchers", makeTube({{0, -0.128, 0.12}, {0, 0.128, 0.12}}, {0.008, 0.008}, 10));
  return piece;
}

Furniture makeChair() {
  Furniture piece{"chair", {}};
  Surface seat = makeRoundedBox({{0.44, 0.43, 0.035}, 0.015, 1, {6, 6, 1}});
  seat.deform([](const Vector3d& p) {  // hollowed where one sits
    const double hollow =
        p.z() > 0 ? 0.010 * std::exp(-(p.x() * p.x() + p.y() * p.y()) / 0.018) : 0;
    return Vector3d(p.x(), p.y(), p.z() - hollow);
  });
  piece.add("seat", seat.move(0, -0.02, 0.4325));
  for (const double side : {-1.0, 1.0}) {
    piece.add("legs",
              makeLeg({{side * 0.195, -0.205}, {side * 0.185, -0.195}, 0.418, 0.013, 0.019, 10}));
    piece.add("legs", makeTube({{side * 0.185, 0.225, 0.003},
                                {side * 0.183, 0.190, 0.25},
                                {side * 0.180, 0.180, 0.46},
                                {side * 0.180, 0.200, 0.70},
                                {side * 0.178, 0.235, 0.90}},
                               {0.013, 0.017, 0.018, 0.016, 0.014}, 10));
    piece.add("stretchers", makeTube({{side * 0.19, -0.20, 0.20}, {side * 0.183, 0.195, 0.20}},
                                     {0.009, 0.009}, 8));
  }
  piece.add("stretchers", makeTube({{-0.187, 0, 0.20}, {0.187, 0, 0.20}}, {0.009, 0.009}, 8));
  for (const double z : {0.86, 0.52}) {  // rails, bowed to the sitter's back
    Surface rail = makeRoundedBox({{0.36, 0.022, z > 0.6 ? 0.09 : 0.045}, 0.009, 1, {6, 1, 1}});
    rail.deform([](const Vector3d& p) {
      return Vector3d(p.x(), p.y() + 0.03 * (1 - std::pow(p.x() / 0.18, 2)), p.z());
    });
    piece.add("back", rail.move(0, z > 0.6 ? 0.222 : 0.183, z));
  }
  for (int i = -2; i <= 2; ++i) {
    const double bow = 0.03 * (1 - std::pow(i * 0.055 / 0.18, 2));
    Surface slat = makeRoundedBox({{0.030, 0.010, 0.32}, 0.0045, 1, {1, 1, 1}});
    slat.deform([=](const Vector3d& p) {
      return Vector3d(p.x(), p.y() + bow + 0.2025 + 0.125 * p.z(), p.z());
    });
    piece.add("back", slat.move(i * 0.055, 0, 0.69));
  }
  return piece;
}

Furniture makeSofa() {
  Furniture sofa = upholster("sofa", {2.15, 0.92, 0.20, 0.44, 0.62, 0.84, 3});
  const auto pillow = [](double turn, const Vector3d& at) {
    Surface surface = cushion({0.40, 0.40, 0.05}, 0.02, 0.05);
    return surface.rotate(0, 68).rotate(2, turn).move(at.x(), at.y(), at.z());
  };
  sofa.add("pillow-left", pillow(14, {-0.62, -0.08, 0.66}));
  sofa.add("pillow-right", pillow(-18, {0.60, -0.08, 0.66}));
  return sofa;
}

Furniture makeArmchair() { return upholster("armchair", {0.86, 0.86, 0.16, 0.43, 0.60, 0.86, 1}); }

}  // namespace amble
