#include "animation/preparation/turn_sequence_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/body/pelvis.h"
#include "animation/preparation/gait_track.h"
#include "base/ease.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

// A pelvis that turns more slowly has stopped, by trial: who stands sways by half of it [rad/s].
constexpr double kTurning = 20.0 * kDegree;
constexpr double kRateWindow = 0.1;  // over which the rate is taken, both ways [s]
constexpr double kPause = 0.25;      // shorter ones are within one turn [s]
// Before the pelvis the head turns, and after it trunk and arms come to rest [s].
constexpr double kBeside = 0.3;
// So long, at either end, the body comes out of `stand` and goes into it; not more than this share
// of the turn [s; 1].
constexpr double kSetsIn = 0.5, kMostSetIn = 0.3;
constexpr int kSamplesOfPiece = 8;

// Frames in which the pelvis turns one way.
struct TurnFrames {
  int first, last;
};

std::vector<TurnFrames> stretchesOf(const std::vector<double>& headings, double frame_time) {
  const int n = static_cast<int>(headings.size());
  const int half = std::max(1, static_cast<int>(std::lround(kRateWindow / frame_time)));
  const int pause = static_cast<int>(std::lround(kPause / frame_time));
  std::vector<TurnFrames> found;
  int way_before = 0;
  for (int i = 0; i < n; ++i) {
    const int a = std::max(0, i - half), b = std::min(n - 1, i + half);
    const double rate = (headings[b] - headings[a]) / (std::max(1, b - a) * frame_time);
    const int way = rate > kTurning ? 1 : rate < -kTurning ? -1 : 0;
    if (way == 0) continue;
    if (way == way_before && i - found.back().last <= pause) {
      found.back().last = i;
    } else {
      found.push_back({i, i});
    }
    way_before = way;
  }
  return found;
}

bool keepsToOneSpot(const std::vector<Eigen::Vector3d>& path, const TurnFrames& stretch) {
  Eigen::Vector2d low = path[stretch.first].head<2>(), high = low;
  for (int i = stretch.first; i <= stretch.last; ++i) {
    low = low.cwiseMin(path[i].head<2>());
    high = high.cwiseMax(path[i].head<2>());
  }
  return (high - low).norm() <= 2.0 * kOnSpot;
}

// A pelvis that turns about goes on at 0.9 m/s where a walker does, at 3 where a runner does: he
// comes to his turn and leaves it, and his feet are on the ground while he brakes [m/s].
constexpr double kFastestTurn = 1.5;

bool isSlow(const std::vector<Eigen::Vector3d>& path, const TurnFrames& stretch,
            double frame_time) {
  double way = 0.0;
  for (int i = stretch.first; i < stretch.last; ++i)
    way += (path[i + 1] - path[i]).head<2>().norm();
  return way <= kFastestTurn * (stretch.last - stretch.first) * frame_time;
}

// Who runs has both feet off the ground for longer than detectors of plants miss them.
bool staysOnGround(const FootPlants& plants, const TurnFrames& stretch, double frame_time) {
  constexpr double kMissed = 0.08;  // [s]
  int off = 0;
  for (int i = stretch.first; i <= stretch.last; ++i) {
    off = plants.planted(kLeft, i) || plants.planted(kRight, i) ? 0 : off + 1;
    if (off * frame_time > kMissed) return false;
  }
  return true;
}

// What the feet do in a stretch.
struct TurningSteps {
  int count = 0;  // feet that are put down anew
  Side first = kLeft;
};

TurningSteps stepsIn(const FootPlants& plants, const TurnFrames& stretch) {
  TurningSteps steps;
  int earliest = stretch.last + 1;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      if (plant.first > stretch.first && plant.first <= stretch.last) ++steps.count;
      if (plant.last < stretch.first || plant.last >= stretch.last) continue;
      if (plant.last < earliest) earliest = plant.last, steps.first = side;
    }
  }
  return steps;
}

// The turn within some frames of a clip.
class TurnFinder {
 public:
  TurnFinder(const Clip& level, const JointRoles& roles, const SpotTurnFit& how)
      : headings_(pelvisHeadings(level, roles)),
        path_(pelvisPath(level, roles)),
        plants_(detectPlants(level, roles)),
        how_(how),
        frame_time_(level.frame_time),
        beside_(static_cast<int>(std::lround(kBeside / level.frame_time))) {
    const auto [first, last] = how.frames.value_or(std::pair{0, level.frames() - 1});
    if (first < 0 || last >= level.frames() || first >= last) {
      throw InputError(how.file, 0, "frames that the clip does not have",
                       "up to " + std::to_string(level.frames() - 1) + " of its motion");
    }
    window_ = {first, last};
    for (TurnFrames stretch : stretchesOf(headings_, level.frame_time)) look(stretch);
  }

  const std::vector<double>& headings() const { return headings_; }
  const FootPlants& plants() const { return plants_; }

  /// @throws InputError where there is none
  TurnFrames found() const {
    if (most_ >= kLeastTurn) return best_;
    throw InputError(
        how_.file, 0,
        how_.frames ? "in these frames nobody turns on the spot" : "nobody in it turns on the spot",
        "a turn by " + shortNumber(kLeastTurn / kDegree) +
            " degrees or more within a rectangle of " + shortNumber(2.0 * kOnSpot) +
            " m across, in which a foot is put down anew and nobody runs");
  }

 private:
  void look(TurnFrames stretch) {
    stretch = {std::max(stretch.first, window_.first), std::min(stretch.last, window_.last)};
    if (stretch.first >= stretch.last || !keepsToOneSpot(path_, stretch)) return;
    stretch = {std::max(stretch.first - beside_, window_.first),
               std::min(stretch.last + beside_, window_.last)};
    if (stepsIn(plants_, stretch).count == 0) return;
    if (!isSlow(path_, stretch, frame_time_)) return;
    if (!staysOnGround(plants_, stretch, frame_time_)) return;
    const double turned = std::abs(headings_[stretch.last] - headings_[stretch.first]);
    if (turned > most_) most_ = turned, best_ = stretch;
  }

  std::vector<double> headings_;
  std::vector<Eigen::Vector3d> path_;
  FootPlants plants_;
  const SpotTurnFit& how_;
  double frame_time_;  // [s]
  int beside_;         // [frames]
  TurnFrames window_{}, best_{};
  double most_ = 0.0;
};

// The body of a stretch over the clock, as channels.
class TurningBody {
 public:
  TurningBody(const GaitTrack& track, const std::vector<double>& headings,
              const TurnFrames& stretch, const Posture& stand)
      : track_(track), headings_(headings), stretch_(stretch), stand_(stand) {
    const Skeleton& skeleton = track.clip().skeleton;
    for (const LegJoints& leg : track.roles().legs) {
      for (int j = 0; j < skeleton.size(); ++j)
        if (skeleton.isAncestor(leg.up_leg, j)) of_legs_.push_back(j);
    }
  }

  double duration() const { return (stretch_.last - stretch_.first) * track_.clip().frame_time; }
  double angle() const { return headings_[stretch_.last] - headings_[stretch_.first]; }
  double turned(double clock) const {
    return (headingAt(frame(clock)) - headings_[stretch_.first]) / angle();
  }

  Eigen::VectorXd channels(double clock) const {
    const auto& reference = stand_.rotations;
    Pose pose;
    pose.rotations.resize(reference.size());
    track_.poseAt(frame(clock), pose);
    pose.rotations[0] = aboutZ(-headingAt(frame(clock))) * pose.rotations[0];
    Eigen::VectorXd c = Eigen::VectorXd::Zero(3 + 3 * static_cast<Eigen::Index>(reference.size()));
    c[2] = pose.p_WR.z();
    for (size_t j = 0; j < reference.size(); ++j) {
      c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
          logRotation(reference[j].conjugate() * pose.rotations[j]);
    }
    for (const int j : of_legs_) c.segment<3>(3 + 3 * j).setZero();
    return c;
  }

 private:
  double frame(double clock) const {
    return stretch_.first + clock * (stretch_.last - stretch_.first);
  }
  double headingAt(double frame) const {
    const int i = std::clamp(static_cast<int>(frame), 0, static_cast<int>(headings_.size()) - 2);
    return headings_[i] + (frame - i) * (headings_[i + 1] - headings_[i]);
  }

  const GaitTrack& track_;
  const std::vector<double>& headings_;
  TurnFrames stretch_;
  const Posture& stand_;
  std::vector<int> of_legs_;  // joints
};

// Coefficients by least squares; the first and the last are given, one row a channel.
Eigen::MatrixXd fitInner(const Eigen::MatrixXd& values, const Eigen::VectorXd& first,
                         const Eigen::VectorXd& last, int pieces) {
  constexpr int kStood = TurnSequence::kStanding;
  const int samples = static_cast<int>(values.rows()), columns = pieces + 3;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(samples, columns);
  for (int i = 0; i < samples; ++i) {
    const SplineWeights w = splineWeights(pieces, static_cast<double>(i) / (samples - 1));
    for (int k = 0; k < 4; ++k) basis(i, w.first + k) = w.weight[k];
  }
  Eigen::MatrixXd spline(values.cols(), columns);
  spline.leftCols(kStood) = first.replicate(1, kStood);
  spline.rightCols(kStood) = last.replicate(1, kStood);
  const Eigen::MatrixXd left = values -
                               basis.leftCols(kStood) * spline.leftCols(kStood).transpose() -
                               basis.rightCols(kStood) * spline.rightCols(kStood).transpose();
  const int inner = columns - 2 * kStood;
  spline.middleCols(kStood, inner) =
      basis.middleCols(kStood, inner).colPivHouseholderQr().solve(left).transpose();
  return spline;
}

// Coefficients of the body's channels and of the share of its turn. Who turns about is low on feet
// that are set wide, ours are not: at its highest it is as high as `stand`.
void fitSplines(const TurningBody& body, double standing_height, TurnSequence& turn) {
  const int pieces = std::max(4, static_cast<int>(std::ceil(turn.duration / TurnSequence::kKnot)));
  const int samples = kSamplesOfPiece * pieces + 1;
  const double set_in = std::min(kSetsIn / turn.duration, kMostSetIn);
  Eigen::VectorXd stand = Eigen::VectorXd::Zero(body.channels(0.0).size());
  stand[2] = standing_height;
  Eigen::MatrixXd values(samples, stand.size()), turned(samples, 1);
  for (int i = 0; i < samples; ++i) {
    const double clock = static_cast<double>(i) / (samples - 1);
    values.row(i) = body.channels(clock);
    turned(i) = body.turned(clock);
  }
  values.col(2).array() += standing_height - values.col(2).maxCoeff();
  for (int i = 0; i < samples; ++i) {
    const double clock = static_cast<double>(i) / (samples - 1);
    const double own = minimumJerk(clock / set_in) * minimumJerk((1.0 - clock) / set_in);
    values.row(i) = stand.transpose() + own * (values.row(i) - stand.transpose());
  }
  turn.spline = fitInner(values, stand, stand, pieces);
  turn.turned = fitInner(turned, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1), pieces);
}

// Of feet that stand.
double largestTwist(const GaitTrack& track, const TurnFinder& finder, const TurnFrames& stretch) {
  double twist = 0.0;
  for (int i = stretch.first; i <= stretch.last; ++i) {
    for (const Side side : {kLeft, kRight}) {
      if (!finder.plants().planted(side, i)) continue;
      const Eigen::Vector3d forward =
          track.sole(side, i, Eigen::Quaterniond::Identity()) * Eigen::Vector3d::UnitX();
      const double yaw = std::atan2(forward.y(), forward.x()) - finder.headings()[i];
      twist = std::max(twist, std::abs(wrapAngle(yaw)));
    }
  }
  return twist;
}

}  // namespace

TurnSequence fitTurnOnSpot(const Clip& level, const JointRoles& roles, const SpotTurnFit& how,
                           std::array<int, 2>& frames) {
  const TurnFinder finder(level, roles, how);
  const TurnFrames stretch = finder.found();
  const GaitTrack track(level, roles, how.feet);
  const TurningBody body(track, finder.headings(), stretch, *how.stand);
  const TurningSteps steps = stepsIn(finder.plants(), stretch);
  TurnSequence turn;
  turn.angle = body.angle();
  turn.duration = body.duration();
  turn.first = steps.first;
  turn.steps = steps.count;
  turn.twist = largestTwist(track, finder, stretch);
  if (std::abs(turn.angle) > TurnSequence::kMostAngle || turn.duration < TurnSequence::kShortest ||
      turn.duration > TurnSequence::kLongest || turn.steps > TurnSequence::kMostSteps) {
    throw InputError(how.file, 0,
                     "turns by " + shortNumber(turn.angle / kDegree) + " degrees in " +
                         shortNumber(turn.duration) + " s and " + std::to_string(turn.steps) +
                         " steps",
                     "720 degrees at most, in 0.2 to 20 s and 100 steps at most: frames of less");
  }
  fitSplines(body, how.stand->root_height, turn);
  frames = {stretch.first, stretch.last};
  return turn;
}

}  // namespace amble
