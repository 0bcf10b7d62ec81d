/// The walking engine (Glardon, Boulic & Thalmann, "PCA-based Walking Engine using Motion Capture
/// Data", CGI 2004): one person's captured cycles as a space of principal components, in which a
/// speed is a point.
///
/// Phase is WalkCycle's: 0 is the middle of the double support with the left foot in front, or of
/// the flight before the left foot comes down, 0.5 the same with the right. A motion vector is a
/// matrix here: rows are channels, columns the phases i / kEnginePhases. Its channels are rotation
/// vectors [rad], three a joint (the root's against the heading of the path first), each against
/// the engine's mean posture: q = q_mean * exp(v). Walks and runs are two spaces.
///
/// Where we depart from the paper: the root's own motion and where feet are put are no part of the
/// motion vector but lines over speed of their own; the piece to standing goes to the standing
/// posture itself, not to its shadow in the space; and it is measured by stride, not by speed, so
/// that feet keep still where the frequency law is a power (see SpeedEngine::walkShare), heights by
/// its square, as an inverted pendulum's.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "animation/body/pose.h"
#include "animation/library/frequency_law.h"
#include "animation/library/motion_library.h"

namespace amble {

/// Samples of a cycle (Glardon §5).
inline constexpr int kEnginePhases = 100;

/// A straight line over speed.
struct SpeedLine {
  double at_zero = 0.0;  ///< where it meets speed 0; not what it is there: below the slowest
                         ///< capture a piece leads to standing
  double slope = 0.0;    ///< per m/s

  double at(double speed) const { return at_zero + slope * speed; }
};

/// A principal component and what speed says of it.
struct PrincipalComponent {
  Eigen::MatrixXd
      direction;          ///< e_i (eq. 1), of length 1. Rows: rotation channels; columns: phases
  SpeedLine coefficient;  ///< A_i(S) = m_i S + b_i (eq. 2)
  double share = 0.0;     ///< of the cycles' variance [0, 1]
};

/// How far the engine is off where it has not seen a clip: root mean square of the angle between
/// joints' rotations and those of the clip's mean cycle, over phases and joints, without those
/// beyond the wrists [rad, >= 0].
struct LeftOut {
  bool between = false;                             ///< others are slower, and others faster
  double joints = 0.0, legs = 0.0;                  ///< of the engine fitted without the clip
  double nearest_joints = 0.0, nearest_legs = 0.0;  ///< of the clip next to it in speed
};

/// A capture whose cycles are in a space.
struct EngineClip {
  MotionSource source;
  double speed = 0.0;               ///< mean of its cycles [m/s, > 0]
  double frequency = 0.0;           ///< of cycles [Hz, > 0]
  int cycles = 0;                   ///< [>= 1]
  CaptureQuality capture;           ///< of the clip
  std::optional<LeftOut> left_out;  ///< none where too few others are left to fit a line
};

/// The space of one gait.
struct GaitSpace {
  std::vector<EngineClip> clips;               ///< by speed; one or more
  Eigen::MatrixXd mean;                        ///< theta_0 (eq. 1). Rows and columns as above
  std::vector<PrincipalComponent> components;  ///< by share; none where all clips are of one speed
  /// Of the root around the point that walks evenly along the path: forward, left, height over the
  /// ground. Rows: these three [m], then their slopes [s]; columns: phases.
  Eigen::MatrixXd root;
  FrequencyFit law;  ///< of this person (§4.2, eq. 6)
  /// Share of the cycle for which both feet are down around phase 0 and phase 0.5; negative: fly.
  std::array<SpeedLine, 2> support;
  // Of the prints. Poses have them already: they say where the walker stands who stops.
  SpeedLine step_width;                   ///< as WalkCycle has it [m]
  std::array<SpeedLine, 2> foot_forward;  ///< the same, by Side [m]
  std::array<SpeedLine, 2> toe_out;       ///< the same, by Side [rad]

  double slowest() const { return clips.front().speed; }
  double fastest() const { return clips.back().speed; }
  double variance() const;  ///< that the components keep [0, 1]
};

/// Data of an engine, as its file has it (speed_engine_reader.h).
struct EngineData {
  std::filesystem::path file;
  std::string skeleton_file;  ///< BVH beside the file; its hierarchy only is read
  Skeleton skeleton;          ///< [m]
  JointRoles roles;
  double stature = 0.0;  ///< [m]
  /// Mean rotation of each joint over all cycles, the root's against the heading.
  std::vector<Eigen::Quaterniond> mean_posture;
  Posture stand;
  MotionSource stand_source;
  std::optional<GaitSpace> walk, run;  ///< one at least
};

/// A prepared engine: const after construction, threads may share it. Nothing allocates per frame.
///
/// Speeds are those of the captured person; another's is divided by the ratio of leg lengths, since
/// poses go with V = v / leg (eq. 3). Since every coefficient is a straight line over speed, so is
/// every channel: an engine is a few arrays that are weighted by speed and read at a phase. So
/// speed may change from frame to frame.
///
/// Speeds that were not captured: below the slowest walk cycles shrink towards standing, down to 0;
/// between the fastest walk and the slowest run the two are mixed; beyond the fastest, and below
/// the slowest where only runs are there, everything is clamped (clamped()). Glardon goes on along
/// the lines to 1.43 times his fastest and finds legs that nobody has; a clip left out at an end is
/// met worse by lines that go on than by the clip next to it.
class SpeedEngine {
 public:
  explicit SpeedEngine(EngineData data);

  const EngineData& data() const { return data_; }
  int joints() const { return static_cast<int>(data_.mean_posture.size()); }
  int channels() const { return 3 + 3 * joints(); }  ///< as WalkCycle::series has them
  double leg() const { return leg_; }                ///< thigh and shank [m]

  double slowest() const { return slowest_; }  ///< 0, or of an engine that only runs its slowest
  double fastest() const { return fastest_; }  ///< [m/s]
  /// Fastest of what is a walk and not in part a run; 0 of an engine that only runs [m/s].
  double fastestWalk() const { return walk_top_; }
  double clamped(double speed) const;  ///< [m/s]
  /// Whether the person was captured slower and faster in one gait, or stands.
  bool isCaptured(double speed) const;

  /// Cycles a second [Hz]: the phase goes on by that times the time (eq. 5).
  double frequency(double speed) const;
  double stepLength(double speed) const {
    return 0.5 * clamped(speed) / frequency(speed);
  }  ///< [m]
  /// How much of the slowest captured walk is in a walk: 1 from its speed on, 0 standing. By the
  /// length of the stride, v / f: the swing of the legs is then what the root goes on by.
  double walkShare(double speed) const;
  double runShare(double speed) const;  ///< 0 in walks, 1 in runs
  /// Share of the cycle with both feet down around phase 0 and 0.5; negative: with neither.
  std::array<double, 2> support(double speed) const;
  bool planted(double speed, double phase, Side side) const;

  /// The pose at a phase, on a path along x whose point is (0, 0): a smooth curve through the
  /// samples around it. @pre pose has joints() rotations
  void poseAt(double speed, double phase, Pose& pose) const;
  /// The whole cycle (Glardon's update). Rows: channels; columns: phases. Written into `cycle`.
  void cycleAt(double speed, Eigen::MatrixXd& cycle) const;

  /// Of the slowest captured walk. Below, strides grow from standing as a parabola, that walking
  /// may begin and end there: by the law alone they would leap from 0. Nobody walks so slowly [1].
  static constexpr double kCrawl = 0.2;
  /// Of that walk's speed: so far below it the piece to standing bends to the walk itself, and so
  /// far above it that bends into the lines. By trial, joints jerk where it is narrower and the
  /// speed rises through it [1].
  static constexpr double kBend = 0.3;

 private:
  // What is weighted: X(speed) = sum of weight * array.
  struct Weights {
    double stand = 0.0;
    std::array<double, 4> arrays = {0, 0, 0, 0};  // walk, its slope, run, its slope
  };
  // Four samples around a phase and the weights of the curve through them (Catmull and Rom).
  struct Reading {
    std::array<int, 4> column;
    std::array<double, 4> weight;
  };
  static Reading readingAt(double phase);
  Weights weigh(double speed) const;
  double strideShare(double x) const;    // of the slowest walk's stride at x times its speed
  double walkSpeed(double speed) const;  // at which the lines of walks are read [m/s]
  Eigen::Vector3d threeAt(const Weights& weights, const Reading& reading, Eigen::Index row) const;
  double mixed(double speed, const SpeedLine& walk, const SpeedLine& run, double stand) const;

  EngineData data_;
  double leg_ = 0.0, slowest_ = 0.0, fastest_ = 0.0;
  double walk_top_ = 0.0, run_bottom_ = 0.0;  // of what is captured or goes on [m/s]
  std::array<Eigen::MatrixXd, 4> arrays_;     // empty where there is no such gait
  Eigen::VectorXd stand_;                     // channels of the standing posture
};

}  // namespace amble
