// Tables, shelf, cupboard, door and picture: what is made of boards.
#include <array>
#include <cmath>

#include "environments/furniture/furniture.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

Surface board(const Vector3d& size, const Vector3d& at, double radius = 0.003, int arc = 0) {
  return makeRoundedBox({size, radius, arc}).move(at.x(), at.y(), at.z());
}

// A table top with round corners, from `low` to `high`.
Surface tableTop(double width, double depth, double corner, double low, double high) {
  constexpr int kArc = 8;  // pieces of a rounded corner
  std::vector<Vector2d> outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double x = (quarter == 0 || quarter == 3 ? 1 : -1) * (width / 2 - corner);
    const double y = (quarter < 2 ? 1 : -1) * (depth / 2 - corner);
    for (int k = 0; k <= kArc; ++k) {
      const double angle = (quarter + static_cast<double>(k) / kArc) * kPi / 2;
      outline.emplace_back(x + corner * std::cos(angle), y + corner * std::sin(angle));
    }
  }
  return makeLoft(outline, {0, 0}, plateRings(low, high, 0.2 * (high - low)));
}

void addLegs(Furniture& piece, double x, double y, double splay, Leg leg) {
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      leg.top = {sx * x, sy * y};
      leg.foot = {sx * (x + splay), sy * (y + splay)};
      piece.add("legs", makeLeg(leg));
    }
  }
}

void addApron(Furniture& piece, double x, double y, double low, double high) {
  const double middle = (low + high) / 2;
  for (const double s : {-1.0, 1.0}) {
    piece.add("apron", board({2 * x - 0.05, 0.02, high - low}, {0, s * y, middle}));
    piece.add("apron", board({0.02, 2 * y - 0.05, high - low}, {s * x, 0, middle}));
  }
}

// A bowl standing at the origin: one closed skin, thick as glazed clay.
Surface bowl(double radius, double height) {
  const auto outside =
      smoothCurve({{radius * 0.35, 0}, {radius * 0.75, height * 0.35}, {radius, height}}, 6);
  std::vector<Vector2d> profile = {{0, 0}};
  profile.insert(profile.end(), outside.begin(), outside.end());
  for (auto p = outside.rbegin(); p != outside.rend(); ++p)
    profile.emplace_back(p->x() - 0.006, p->y() + (p == outside.rbegin() ? 0.0 : 0.006));
  profile.emplace_back(0, 0.006);
  return makeLathe(profile, 40);
}

// Numbers that look random and are the same everywhere: the fraction of i times the golden ratio
// [0, 1).
double scatter(int i) {
  const double value = i * 0.6180339887498949;
  return value - std::floor(value);
}

// A row of books from `left` to `right` on a board at `z`, some leaning at the end of the row.
void addBooks(Furniture& piece, int row, double left, double right, double z, double room) {
  double x = left;
  for (int i = 0;; ++i) {
    const int seed = row * 41 + i;
    const double thick = 0.018 + 0.030 * scatter(seed);
    const double tall = room * (0.62 + 0.30 * scatter(seed * 3 + 1));
    const double deep = 0.15 + 0.07 * scatter(seed * 5 + 2);
    if (x + thick > right) break;
    Surface book = makeRoundedBox({{thick, deep, tall}, 0.004, 0});
    piece.add("books", book.move(x + thick / 2, -0.13 + deep / 2, z + tall / 2 + 0.0005));
    x += thick + 0.0015;
  }
}

}  // namespace

Furniture makeLowTable() {
  Furniture piece{"low-table", {}};
  piece.add("top", tableTop(0.60, 0.90, 0.06, 0.385, 0.42));
  addApron(piece, 0.24, 0.39, 0.335, 0.384);
  addLegs(piece, 0.245, 0.395, 0.0, {{}, {}, 0.384, 0.014, 0.022, 16});
  piece.add("shelf", tableTop(0.47, 0.77, 0.03, 0.14, 0.16));
  piece.add("magazines", board({0.22, 0.30, 0.014}, {0.02, -0.12, 0.168}, 0.004, 1));
  Surface second = board({0.21, 0.28, 0.008}, {0, 0, 0}, 0.003, 2);
  piece.add("magazines", second.rotate(2, 24).move(0.02, -0.12, 0.180));
  piece.add("bowl", bowl(0.13, 0.055).move(0.03, -0.05, 0.4203));
  return piece;
}

Furniture makeDiningTable() {
  Furniture piece{"dining-table", {}};
  piece.add("top", tableTop(1.50, 0.85, 0.08, 0.712, 0.74));
  addApron(piece, 0.66, 0.335, 0.63, 0.711);
  addLegs(piece, 0.665, 0.34, 0.02, {{}, {}, 0.711, 0.020, 0.034, 16});
  piece.add("vase", makeLathe(smoothCurve({{0, 0},
                                           {0.045, 0.0},
                                           {0.075, 0.07},
                                           {0.05, 0.16},
                                           {0.028, 0.21},
                                           {0.036, 0.24},
                                           {0, 0.235}},
                                          5),
                              40)
                        .move(0.1, 0.05, 0.746));
  piece.add("bowl", bowl(0.15, 0.07).move(-0.28, -0.03, 0.7403));
  return piece;
}

Furniture makeBookshelf() {
  constexpr double kWidth = 1.20, kDepth = 0.30, kHeight = 2.0, kBoard = 0.022;  // [m]
  constexpr std::array<double, 6> kShelves = {0.07, 0.45, 0.80,
                                              1.14, 1.46, 1.74};  // undersides [m]
  Furniture piece{"bookshelf", {}};
  for (const double x : {-0.5, 0.0, 0.5})
    piece.add("sides", board({kBoard, kDepth, kHeight - kBoard},
                             {x * (kWidth - kBoard), 0, (kHeight - kBoard) / 2}));
  piece.add("sides", board({kWidth, kDepth, kBoard}, {0, 0, kHeight - kBoard / 2}));
  piece.add("back", board({kWidth - 2 * kBoard, 0.008, kHeight - 2 * kBoard},
                          {0, kDepth / 2 - 0.006, kHeight / 2}));
  const double bay = (kWidth - 3 * kBoard) / 2;
  for (size_t i = 0; i < kShelves.size(); ++i) {
    const double low = kShelves[i] + kBoard;
    const double room = (i + 1 < kShelves.size() ? kShelves[i + 1] : kHeight - kBoard) - low;
    for (const double side : {-1.0, 1.0}) {
      const double middle = side * (bay + kBoard) / 2;
      piece.add("shelves", board({bay - 0.002, kDepth - 0.03, kBoard},
                                 {middle, -0.01, kShelves[i] + kBoard / 2}));
      const int row = static_cast<int>(2 * i) + (side > 0 ? 1 : 0);
      const double filled = bay * (0.55 + 0.43 * scatter(row * 7 + 3));
      addBooks(piece, row, middle - bay / 2 + 0.004, middle - bay / 2 + filled, low, room);
    }
  }
  return piece;
}

Furniture makeDoor() {
  Furniture piece{"door", {}};
  piece.add("leaf", board({0.80, 0.04, 2.00}, {0, -0.025, 1.005}, 0.004, 1));
  for (const double z : {0.55, 1.50})  // raised panels
    for (const double x : {-0.19, 0.19})
      piece.add("panels",
                makeRoundedBox({{0.27, 0.02, z < 1 ? 0.75 : 0.80}, 0.008, 1}).move(x, -0.047, z));
  for (const double side : {-1.0, 1.0})
    piece.add("frame", board({0.07, 0.06, 2.09}, {side * 0.44, -0.031, 1.045}, 0.01, 1));
  piece.add("frame", board({0.808, 0.06, 0.07}, {0, -0.031, 2.05}, 0.01, 1));
  piece.add(
      "handle",
      makeTube(
          {{0.33, -0.04, 1.03}, {0.33, -0.085, 1.03}, {0.31, -0.095, 1.03}, {0.21, -0.095, 1.03}},
          {0.011, 0.010, 0.010, 0.009}, 14));
  return piece;
}

Furniture makePicture() {
  Furniture piece{"picture", {}};
  piece.add("canvas", board({0.84, 0.015, 0.54}, {0, -0.0085, 0}, 0.003));
  for (const double s : {-1.0, 1.0}) {
    piece.add("frame", board({0.90, 0.03, 0.035}, {0, -0.016, s * 0.2825}, 0.008, 1));
    piece.add("frame", board({0.035, 0.03, 0.53}, {s * 0.4325, -0.016, 0}, 0.008, 1));
  }
  return piece;
}

Furniture makeCupboard() {
  Furniture piece{"cupboard", {}};
  piece.add("body", board({1.10, 0.80, 2.10}, {0, 0.02, 1.05}, 0.006, 2));
  for (const double side : {-1.0, 1.0}) {
    piece.add("doors", board({0.545, 0.02, 2.0}, {side * 0.2745, -0.391, 1.06}, 0.004, 1));
    piece.add("handles", makeTube({{side * 0.03, -0.40, 1.0},
                                   {side * 0.03, -0.43, 1.02},
                                   {side * 0.03, -0.43, 1.18},
                                   {side * 0.03, -0.40, 1.20}},
                                  {0.007, 0.007, 0.007, 0.007}, 12));
  }
  return piece;
}

}  // namespace amble
