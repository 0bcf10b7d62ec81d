// A baby grand: the case as lofts of one outline, 88 keys, three turned legs, lyre and lid.
#include <cmath>

#include "environments/furniture/furniture.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kBass = -0.74;   // x of the straight side [m]
constexpr double kFront = -0.79;  // y of the front edge of the key bed [m]
constexpr double kCase = -0.55;   // y of the case's front, behind the keys [m]
constexpr double kBottom = 0.62;  // height of the case's underside [m]
constexpr double kRim = 0.96;     // height of the rim [m]
constexpr double kLidAngle = 33;  // of the open lid [degrees]

Surface block(const Vector3d& size, const Vector3d& at, double radius, int arc = 1) {
  return makeRoundedBox({size, radius, arc}).move(at.x(), at.y(), at.z());
}

// The wing shape from `front` to the tail, counter-clockwise: bass side straight, treble side bent.
std::vector<Vector2d> wing(double front) {
  std::vector<Vector2d> outline;
  for (int i = 0; i < 12; ++i) outline.emplace_back(kBass + 1.48 * i / 12.0, front);
  const auto bent = smoothCurve({{0.74, front},
                                 {0.74, -0.16},
                                 {0.66, 0.10},
                                 {0.46, 0.30},
                                 {0.30, 0.50},
                                 {0.14, 0.69},
                                 {-0.14, 0.78},
                                 {-0.44, 0.79},
                                 {-0.66, 0.73},
                                 {kBass, 0.58}},
                                6);
  outline.insert(outline.end(), bent.begin(), bent.end());
  for (int i = 1; i < 8; ++i) outline.emplace_back(kBass, 0.58 + (front - 0.58) * i / 8.0);
  return outline;
}

void addCase(Furniture& piano) {
  constexpr double kWall = 0.05;    // thickness of the rim [m]
  constexpr double kInside = 0.86;  // height of the sound board in the open case [m]
  auto rings = plateRings(kBottom, kRim, 0.012);
  rings.push_back({kWall, kRim});
  rings.push_back({kWall, kInside});
  piano.add("case", makeLoft(wing(kCase), {-0.2, 0.0}, rings));
  std::vector<LoftRing> plate = plateRings(kInside + 0.001, kInside + 0.02, 0.006);
  for (LoftRing& ring : plate) ring.inset += kWall + 0.03;
  piano.add("plate", makeLoft(wing(kCase), {-0.2, 0.0}, plate));
  for (int i = 0; i < 36; ++i) {  // strings fan out from the keys to the bent side
    const double share = i / 35.0;
    const double x = -0.58 + 1.16 * share;
    const double end = 0.60 - 0.72 * std::pow(share, 0.8);
    piano.add("strings", makeTube({{x, -0.36, 0.892}, {x - 0.10 * (1 - share), end, 0.892}},
                                  {0.0016, 0.0016}, 3));
  }
}

void addKeys(Furniture& piano) {
  constexpr int kWhite = 52;
  constexpr double kPitch = 0.0235;  // width of a white key with its gap [m]
  piano.add("key-bed", block({1.48, kCase - kFront + 0.04, 0.045},
                             {0, (kCase + kFront) / 2 + 0.02, 0.6325}, 0.008));
  for (int i = 0; i < kWhite; ++i) {
    const double x = (i - (kWhite - 1) / 2.0) * kPitch;
    piano.add("white-keys", block({kPitch - 0.001, 0.215, 0.04}, {x, -0.660, 0.6795}, 0.0025, 0));
    const int tone = i % 7;  // the lowest white key is A
    const bool sharp = tone == 0 || tone == 2 || tone == 3 || tone == 5 || tone == 6;
    if (sharp && i + 1 < kWhite)
      piano.add("black-keys",
                block({0.011, 0.14, 0.012}, {x + kPitch / 2, -0.622, 0.7062}, 0.003, 0));
  }
  for (const double side : {-1.0, 1.0})
    piano.add("case", block({0.115, 0.25, 0.20}, {side * 0.6825, -0.665, 0.7555}, 0.02, 2));
  piano.add("case", block({1.245, 0.02, 0.14}, {0, kCase - 0.001, 0.77}, 0.006));
}

void addLid(Furniture& piano) {
  constexpr double kHinge = kRim + 0.003;
  const double lean = kLidAngle * 3.14159265358979323846 / 180;
  Surface lid = makeLoft(wing(-0.30), {-0.2, 0.15}, plateRings(0.0, 0.018, 0.006));
  piano.add("lid", lid.move(-kBass, 0, 0).rotate(1, -kLidAngle).move(kBass, 0, kHinge));
  const double reach = 1.02;  // from the hinge to the prop's upper end, along the lid [m]
  const Vector3d top(kBass + reach * std::cos(lean), -0.12,
                     kHinge + reach * std::sin(lean) - 0.006);
  piano.add("prop", makeTube({{0.66, -0.12, kRim - 0.02}, top}, {0.010, 0.008}, 14));
  // The front flap of the lid lies folded back; the music desk stands before it.
  piano.add("stand", block({1.36, 0.20, 0.016}, {0, -0.43, kRim - 0.03}, 0.005));
  Surface desk = makeRoundedBox({{0.72, 0.014, 0.24}, 0.006, 1});
  piano.add("stand", desk.rotate(0, -14).move(0, -0.40, kRim + 0.10));
  Surface sheet = makeRoundedBox({{0.42, 0.004, 0.20}, 0.0015, 1});
  piano.add("music", sheet.rotate(0, -14).move(0, -0.412, kRim + 0.10));
}

void addLegs(Furniture& piano) {
  std::vector<Vector2d> profile = {{0, 0.05}, {0.022, 0.05}};
  const auto turned = smoothCurve({{0.026, 0.07},
                                   {0.034, 0.12},
                                   {0.026, 0.15},
                                   {0.048, 0.30},
                                   {0.060, 0.44},
                                   {0.042, 0.49},
                                   {0.060, 0.52},
                                   {0.064, 0.58}},
                                  4);
  profile.insert(profile.end(), turned.begin(), turned.end());
  profile.insert(profile.end(), {{0.064, kBottom - 0.001}, {0, kBottom - 0.001}});
  const Surface leg = makeLathe(profile, 28);
  for (const Vector2d& at :
       {Vector2d(-0.62, -0.46), Vector2d(0.62, -0.46), Vector2d(-0.28, 0.56)}) {
    Surface placed = leg;
    piano.add("legs", placed.move(at.x(), at.y(), 0));
    Surface wheel = makeLathe(
        {{0, -0.012}, {0.020, -0.012}, {0.025, -0.006}, {0.025, 0.006}, {0.020, 0.012}, {0, 0.012}},
        20);
    piano.add("legs", wheel.rotate(0, 90).move(at.x(), at.y(), 0.025));
  }
}

void addLyre(Furniture& piano) {
  for (const double side : {-1.0, 1.0}) {
    piano.add("lyre", makeTube({{side * 0.06, -0.33, kBottom - 0.002},
                                {side * 0.085, -0.33, 0.46},
                                {side * 0.055, -0.33, 0.30},
                                {side * 0.075, -0.33, 0.15}},
                               {0.016, 0.015, 0.013, 0.015}, 12));
    piano.add("lyre", makeTube({{side * 0.06, -0.30, 0.14}, {side * 0.06, 0.02, kBottom - 0.002}},
                               {0.006, 0.006}, 8));
  }
  piano.add("lyre", block({0.26, 0.13, 0.055}, {0, -0.32, 0.125}, 0.012, 3));
  for (const double x : {-0.07, 0.0, 0.07}) {
    Surface pedal = makeRoundedBox({{0.034, 0.15, 0.012}, 0.005, 1, {1, 6, 1}});
    pedal.deform([](const Vector3d& p) {  // wider at the toe's end and curved down
      const double out = (0.075 - p.y()) / 0.15;
      return Vector3d(p.x() * (0.6 + 0.4 * out), p.y(), p.z() - 0.02 * out * out);
    });
    piano.add("pedals", pedal.move(x, -0.43, 0.105));
  }
}

}  // namespace

Furniture makePiano() {
  Furniture piano{"piano", {}};
  addCase(piano);
  addKeys(piano);
  addLid(piano);
  addLegs(piano);
  addLyre(piano);
  return piano;
}

}  // namespace amble
