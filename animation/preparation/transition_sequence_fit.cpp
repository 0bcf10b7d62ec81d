#include "animation/preparation/transition_sequence_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/preparation/foot_cycle_fit.h"
#include "animation/preparation/gait_track.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kEnd = TransitionSequence::kEnd;
constexpr double kSways = 0.01;         // people who stand sway by less: then they go [m]
constexpr double kMostSway = 1.0;       // before that they wait [steps]
constexpr double kNarrowStance = 0.06;  // feet nearer to one another say nothing of sides [m]
constexpr int kSplineSamples = 8;       // a piece of the spline
constexpr double kRests = 0.02;         // of a step: feet rest before they leave, after they land
constexpr double kEarliestLift = 0.02;  // on the clock [steps]
// What is captured sets in within so long after the sway's begin; what captured standing differs by
// from the posture `stand` is gone at clock 1 [steps].
constexpr double kSetIn = 0.3;
// From here, where the other foot leaves, to there, where it leaves itself, on the clock sides are
// no longer told from the foot that stands but from the path's point.
constexpr double kFromFoot = 0.2, kFromPath = 1.2;

// A clip in the order of the clock: time t falls with the frames of a stop.
struct Order {
  bool start;
  double frame(double t) const { return start ? t : -t; }
  double comes(const Plant& plant) const { return start ? plant.strike : -plant.lift_off; }
  double leaves(const Plant& plant) const { return start ? plant.lift_off : -plant.strike; }
};

// Plants by the clock, of the two feet in turn: [0] is of the foot that steps between 0 and 1, as
// it stands, [1] of the other.
struct Steps {
  Side side = kLeft;
  std::vector<Plant> plants;

  Side sideOf(int i) const { return i % 2 == 0 ? side : other(side); }
  // Middle of the double support in which plant i + 1 has come and plant i is about to leave.
  double node(const Order& order, int i) const {
    return 0.5 * (order.comes(plants[i + 1]) + order.leaves(plants[i]));
  }
};

constexpr int kPlants = 6;

std::optional<Steps> stepsFromStanding(const GaitTrack& track, const Order& order) {
  std::array<std::vector<Plant>, 2> plants = {track.plants(kLeft), track.plants(kRight)};
  for (auto& side : plants) {
    if (side.size() < kPlants / 2) return std::nullopt;
    if (!order.start) std::reverse(side.begin(), side.end());
  }
  Steps steps;
  steps.side = order.leaves(plants[kLeft][0]) < order.leaves(plants[kRight][0]) ? kLeft : kRight;
  for (int i = 0; i < kPlants; ++i) steps.plants.push_back(plants[steps.sideOf(i)][i / 2]);
  for (int i = 0; i + 1 < kPlants; ++i) {
    const Plant &plant = steps.plants[i], &next = steps.plants[i + 1];
    if (!(order.leaves(plant) < order.leaves(next))) return std::nullopt;
    if (i > 0 && !(order.comes(next) < order.leaves(plant))) return std::nullopt;  // a run
  }
  return steps;
}

// The captured way laid on the straight path along +x whose point stands at the origin.
class LaidWay {
 public:
  LaidWay(const GaitTrack& track, const Order& order, const Steps& steps, const Posture& stand)
      : track_(track), order_(order), stand_(stand), first_node_(steps.node(order, 1)) {
    step_ = steps.node(order, 2) - first_node_;
    fitLine(steps);
    standing_side_ = steps.sideOf(1);
    std::array<Eigen::Vector2d, kPlants> prints;
    for (int i = 0; i < kPlants; ++i) {
      const Eigen::Vector3d print = track_.flatFoot(steps.sideOf(i), steps.plants[i]).print;
      prints[i] = seen(print);
      floor_ += print.z() / kPlants;
    }
    const auto midway = [&](int i) -> Eigen::Vector2d { return 0.5 * (prints[i] + prints[i + 1]); };
    stood_ = midway(0).x();
    for (int i = 1; i <= 3; ++i) way_[i] = direction() * (midway(i).x() - stood_);
    for (int i = 0; i <= 3; ++i) left_[i] = midway(i).y();
    pivot_ = prints[1].y();
    const double width = (standing_side_ == kLeft ? 1.0 : -1.0) * (prints[1].y() - prints[0].y());
    widened_ = width > kNarrowStance ? stand_.step_width / width : 0.0;
  }

  bool usable() const {
    return widened_ > 0.0 && way_[1] > 0.05 && way_[2] > way_[1] && way_[3] > way_[2];
  }
  double step() const { return step_; }  // [frames]
  double advance() const { return way_[1]; }
  double frame(double clock) const { return order_.frame(first_node_ + (clock - 1.0) * step_); }
  double clock(double frame) const { return 1.0 + (order_.frame(frame) - first_node_) / step_; }

  Eigen::VectorXd channels(double clock) const {
    const auto& reference = stand_.rotations;
    Pose pose;
    pose.rotations.resize(reference.size());
    track_.poseAt(frame(clock), pose);
    const Eigen::Vector2d root = seen(pose.p_WR);
    Eigen::VectorXd c(3 + 3 * static_cast<Eigen::Index>(reference.size()));
    c[0] = root.x() - stood_ - stand_.root_forward - direction() * wayAt(clock);
    c[1] = aside(root.y(), clock);
    c[2] = pose.p_WR.z() - floor_;
    pose.rotations[0] = aboutZ(-heading_) * pose.rotations[0];
    for (size_t j = 0; j < reference.size(); ++j) {
      c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
          logRotation(reference[j].conjugate() * pose.rotations[j]);
    }
    return c;
  }

 private:
  double direction() const { return order_.start ? 1.0 : -1.0; }
  Eigen::Vector2d rootAt(double t) const {
    return track_.jointsAt(order_.frame(t))[0].p_WJ.head<2>();
  }

  // Through a cycle of the walk.
  void fitLine(const Steps& steps) {
    constexpr int kPoints = 32;
    const double from = steps.node(order_, 2), to = steps.node(order_, 4);
    const Eigen::Vector2d d = direction() * (rootAt(to) - rootAt(from));
    heading_ = std::atan2(d.y(), d.x());
    for (int i = 0; i < kPoints; ++i)
      on_line_ += rootAt(from + (to - from) * i / kPoints) / kPoints;
  }

  // Along the walk's line and to its left.
  Eigen::Vector2d seen(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d d = p.head<2>() - on_line_;
    const double c = std::cos(heading_), s = std::sin(heading_);
    return {c * d.x() + s * d.y(), -s * d.x() + c * d.y()};
  }

  // How far the path's point is from where it stands.
  double wayAt(double clock) const {
    if (clock <= 1.0) return way_[1] * transitionAdvance(clock);
    const double t = clock - 1.0, v = 1.0 - t;
    const double first = 2.0 * way_[1], last = 0.5 * (way_[3] - way_[1]);  // slopes [m a step]
    return v * v * (1.0 + 2.0 * t) * way_[1] + t * t * (3.0 - 2.0 * t) * way_[2] +
           t * v * v * first - t * t * v * last;
  }

  // How far the path's point is to the left of the walk's line: nobody stands on it. Between the
  // double supports it goes from side to side no farther than at them (Fritsch and Butland 1984).
  double leftAt(double clock) const {
    const auto slope = [&](int k) { return (left_[k + 1] - left_[k]) / (way_[k + 1] - way_[k]); };
    const auto between = [](double a, double b) {
      return a * b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
    };
    const int k = clock <= 1.0 ? 0 : 1;
    const double length = way_[k + 1] - way_[k];
    const double t = std::clamp((wayAt(clock) - way_[k]) / length, 0.0, 1.0), v = 1.0 - t;
    const double first = k == 0 ? slope(0) : between(slope(0), slope(1));
    const double last = between(slope(k), slope(k + 1));
    return v * v * (1.0 + 2.0 * t) * left_[k] + t * t * (3.0 - 2.0 * t) * left_[k + 1] +
           t * v * length * (v * first - t * last);
  }

  double aside(double left, double clock) const {
    const double print = (standing_side_ == kLeft ? 0.5 : -0.5) * stand_.step_width;
    const double of_foot = print + widened_ * (left - pivot_);
    const double share = smoothstep((clock - kFromFoot) / (kFromPath - kFromFoot));
    return of_foot + share * (left - leftAt(clock) - of_foot);
  }

  const GaitTrack& track_;
  Order order_;
  const Posture& stand_;
  double first_node_, step_ = 0.0;  // time of clock 1, and of a step [frames]
  double heading_ = 0.0;
  Eigen::Vector2d on_line_ = Eigen::Vector2d::Zero();
  double stood_ = 0.0;  // middle of the standing prints along the line [m]
  // Of the path's point at clock 0, 1, 2, 3: from where it stands, and to the left of the line [m].
  std::array<double, 4> way_{}, left_{};
  Side standing_side_ = kLeft;  // of the foot that stands while the other steps
  double pivot_ = 0.0;          // its print, to the left of the line [m]
  double widened_ = 0.0;        // the posture's width by the captured one; 0: unknown
  double floor_ = 0.0;          // height of the prints [m]
};

// People shift their weight by up to 7 cm over the foot that they stand on; a root that is so far
// from its path is not where the planner has it (QUALITY.md, path error) [m].
constexpr double kMostAside = 0.045;

// When the body leaves the place where it stands.
double begins(const GaitTrack& track, const Order& order, double before) {
  constexpr int kStill = 5;  // frames at the clip's end that show it
  const int last = track.clip().frames() - 1;
  const double first = order.start ? 0.0 : -last;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  const auto root = [&](double t) -> Eigen::Vector2d {
    return track.jointsAt(order.frame(t))[0].p_WJ.head<2>();
  };
  for (int i = 0; i < kStill; ++i) place += root(first + i) / kStill;
  double t = before;
  while (t > first && (root(t) - place).norm() > kSways) t -= 1.0;
  return std::max(t, first);
}

// Least squares; it leaves the posture `stand` at rest.
Eigen::MatrixXd fitSpline(const LaidWay& way, double sway, double standing_height) {
  constexpr int kStood = TransitionSequence::kStanding;
  const double length = kEnd + sway;
  const int pieces = static_cast<int>(std::ceil(length / TransitionSequence::kKnot));
  const int samples = kSplineSamples * pieces + 1;
  const Eigen::VectorXd first = way.channels(-sway);
  Eigen::VectorXd stand = Eigen::VectorXd::Zero(first.size());
  stand[2] = standing_height;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(samples, pieces + 3);
  Eigen::MatrixXd values(samples, first.size());
  for (int i = 0; i < samples; ++i) {
    const double x = static_cast<double>(i) / (samples - 1), since = x * length;
    const SplineWeights w = splineWeights(pieces, x);
    for (int k = 0; k < 4; ++k) basis(i, w.first + k) = w.weight[k];
    const Eigen::VectorXd moved = smoothstep(since / kSetIn) * (way.channels(since - sway) - first);
    values.row(i) = stand + smoothstep(since / (1.0 + sway)) * (first - stand) + moved;
  }
  Eigen::MatrixXd spline(first.size(), pieces + 3);
  for (int k = 0; k < kStood; ++k) spline.col(k) = stand;
  values -= basis.leftCols(kStood) * spline.leftCols(kStood).transpose();
  spline.rightCols(pieces + 3 - kStood) =
      basis.rightCols(pieces + 3 - kStood).colPivHouseholderQr().solve(values).transpose();
  return spline;
}

// The step beside standing.
FootCycle fitStep(const GaitTrack& track, const Order& order, const Steps& steps,
                  const LaidWay& way, const FootShape& shape) {
  Plant from = order.start ? steps.plants[0] : steps.plants[2];
  Plant to = order.start ? steps.plants[2] : steps.plants[0];
  const double rests = kRests * way.step();
  for (Plant* plant : {&from, &to}) plant->strike += rests, plant->lift_off -= rests;
  // The stance before a start is as long as its step: standing is its first half.
  if (order.start)
    from.strike = std::min(from.lift_off - 2.0 * rests, 2.0 * way.frame(0.0) - from.lift_off);
  // That after a stop lies flat when the clock has come to 0.
  if (!order.start)
    to.lift_off = to.strike + std::max(2.0 * rests, way.frame(0.0) - to.strike) / FootCycle::kFlat;
  FootCycle swing = fitSwing(track, steps.side, shape, from, to, false);
  swing.lift_off = std::clamp(way.clock(from.lift_off), kEarliestLift, 1.0);
  swing.strike = std::clamp(way.clock(to.strike), kEarliestLift, 1.0);
  return swing;
}

}  // namespace

std::optional<TransitionSequence> fitTransitionSequence(const Clip& level, const JointRoles& roles,
                                                        const std::array<FootShape, 2>& feet,
                                                        const Posture& stand, bool start,
                                                        std::array<int, 2>& frames) {
  const GaitTrack track(level, roles, feet);
  const Order order{start};
  const std::optional<Steps> steps = stepsFromStanding(track, order);
  if (!steps) return std::nullopt;
  const LaidWay way(track, order, *steps, stand);
  if (!way.usable()) return std::nullopt;
  TransitionSequence sequence;
  sequence.side = steps->side;
  sequence.step_time = way.step() * level.frame_time;
  sequence.advance = way.advance();
  const double begin = begins(track, order, order.leaves(steps->plants[0]));
  sequence.sway = std::clamp(-way.clock(order.frame(begin)), 0.0, kMostSway);
  sequence.swing = fitStep(track, order, *steps, way, feet[steps->side]);
  sequence.spline = fitSpline(way, sequence.sway, stand.root_height);
  const double aside = std::max(1e-9, sequence.spline.row(1).cwiseAbs().maxCoeff());
  sequence.spline.row(1) *= std::min(1.0, kMostAside / aside);
  const double a = way.frame(-sequence.sway), b = way.frame(kEnd);
  frames = {static_cast<int>(std::lround(std::min(a, b))),
            static_cast<int>(std::lround(std::max(a, b)))};
  return sequence;
}

}  // namespace amble
