#include "animation/captures/capture_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "animation/captures/step_rhythm.h"
#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

// Nobody's hips are faster: Bolt ran 12.4 [m/s]. At high rates a jump is that and a hand's breadth.
constexpr double kFastest = 13.0;
constexpr double kLeastJump = 0.1;  // [m]
// A jump is so many times the way between the frames before and after it, of the two before and the
// two after, but for one: what is out for a single frame jumps back at once. By trial [1].
constexpr double kOutstanding = 6.0;

constexpr size_t kToldJumps = 3;

constexpr double kStill = 1e-12;  // of all changes of a joint's turning, squared [rad^2]

// Captures begin with poses and places that are no motion: a reference pose at the origin, one
// frame long (QUALITY.md); that is no news [frames].
constexpr int kStart = 12;

// On the spot: the ground goes so fast under it, and the pelvis by no more than this share of that.
// [leg lengths/s], [1]
constexpr double kGroundMoves = 0.4, kOnTheSpot = 0.3;
constexpr int kFewestSteps = 3;

// Cadence against what is usual at the speed, as far as people differ; and a cadence that is none
// of a walk or a run at all. [1], [steps/s]
constexpr double kFastCadence = 1.4, kSlowCadence = 0.72;
constexpr double kQuickest = 3.7, kSlowest = 1.0;
constexpr double kUsualCadence = 1.8;  // of an adult's walk: 108 a minute (QUALITY.md) [steps/s]
constexpr double kUsualRates[] = {24, 25, 30, 48, 50, 60, 72, 90, 100, 120, 200, 240};  // [1/s]

double wayOf(const Clip& clip, int frame) {
  if (frame < 0 || frame + 1 >= clip.frames()) return 0.0;
  return (clip.poses.p_WR(frame + 1) - clip.poses.p_WR(frame)).norm();
}

std::string jumpsText(const std::vector<RootJump>& jumps) {
  std::string text;
  for (size_t i = 0; i < std::min(jumps.size(), kToldJumps); ++i) {
    text += fmt::format("{}{:.2f} m between frames {} and {}", i == 0 ? "the root jumps by " : ", ",
                        jumps[i].distance, jumps[i].frame, jumps[i].frame + 1);
  }
  if (jumps.size() > kToldJumps)
    text += fmt::format(", and {} times more", jumps.size() - kToldJumps);
  return text + ": what is measured is cut there";
}

std::string cadenceText(const Clip& clip, const StepRhythm& rhythm, double leg) {
  const double over = cadenceOverUsual(rhythm, leg);
  const bool walks = rhythm.speed >= kWalkingSpeed;
  const bool fast = walks && over > kFastCadence && rhythm.cadence > kQuickest;
  // However slowly it goes: who steps so seldom takes small steps. But who stops in between does
  // not.
  const bool slow = over > 0.0 && over < kSlowCadence && rhythm.least_step * kSlowest > 1.0;
  if (!fast && !slow) return "";
  const double times = rhythm.cadence / kUsualCadence, wanted = 1.0 / (clip.frame_time * times);
  const double rate = *std::min_element(
      std::begin(kUsualRates), std::end(kUsualRates), [wanted](double a, double b) {
        return std::abs(std::log(a / wanted)) < std::abs(std::log(b / wanted));
      });
  return fmt::format(
      "{:.0f} steps a minute at {:.1f} m/s: the frame time looks {:.2g} times too {}; --file-fps "
      "{:g} makes it {:.0f}",
      60.0 * rhythm.cadence, rhythm.speed * leg, fast ? times : 1.0 / times,
      fast ? "short" : "long", rate, 60.0 * rhythm.cadence * rate * clip.frame_time);
}

}  // namespace

std::vector<RootJump> rootJumps(const Clip& clip) {
  std::vector<RootJump> jumps;
  for (int i = 0; i + 1 < clip.frames(); ++i) {
    const double way = wayOf(clip, i);
    std::array<double, 4> near = {wayOf(clip, i - 2), wayOf(clip, i - 1), wayOf(clip, i + 1),
                                  wayOf(clip, i + 2)};
    std::sort(near.begin(), near.end());
    const double about = near[2];
    if (way > kLeastJump + kFastest * clip.frame_time && way > kOutstanding * about) {
      jumps.push_back({i, way});
    }
  }
  return jumps;
}

double jointJitter(const Clip& clip) {
  const int joints = clip.skeleton.size(), frames = clip.frames();
  if (frames < 4) return 0.0;
  std::vector<double> squares(joints, 0.0), products(joints, 0.0);
  std::vector<Eigen::Vector3d> turn(joints), bend(joints);  // first and second differences
  for (int i = 1; i < frames; ++i) {
    const auto before = clip.poses.rotations(i - 1), q = clip.poses.rotations(i);
    for (int j = 0; j < joints; ++j) {
      const Eigen::Vector3d next = logRotation(before[j].conjugate() * q[j]);
      const Eigen::Vector3d change = next - turn[j];
      if (i > 1) squares[j] += change.squaredNorm();
      if (i > 2) products[j] += change.dot(bend[j]);
      turn[j] = next;
      bend[j] = change;
    }
  }
  // Noise of deviation s that is another in each frame makes second differences 1, -2, 1: of
  // variance 6 s^2 and covariance -4 s^2 from one to the next. That of movement is not negative.
  std::vector<double> variances;
  for (int j = 0; j < joints; ++j) {
    // Joints that stand still, as fingers and helpers may, say nothing of the others.
    if (squares[j] > kStill)
      variances.push_back(std::max(0.0, -products[j] / (4.0 * 3.0 * (frames - 3))));
  }
  if (variances.empty()) return 0.0;
  return std::sqrt(upperMedian(std::move(variances)));
}

std::vector<std::string> captureWarnings(const Clip& clip, const JointRoles& roles) {
  std::vector<std::string> warnings;
  std::vector<RootJump> jumps = rootJumps(clip);
  std::erase_if(jumps, [](const RootJump& jump) { return jump.frame < kStart; });
  if (!jumps.empty()) warnings.push_back(jumpsText(jumps));
  const double jitter = jointJitter(clip);
  if (jitter > kNoisy) {
    warnings.push_back(
        fmt::format("noisy: joints shake by {:.1f} degrees from frame to frame; "
                    "what is measured is smoothed",
                    jitter / kDegree));
  }
  const StepRhythm rhythm = stepRhythm(clip, roles);
  const double leg = roles.meanLeg(clip.skeleton);
  if (rhythm.steps < kFewestSteps || !(leg > 0.0)) return warnings;
  if (rhythm.ground_speed > kGroundMoves && rhythm.speed < kOnTheSpot * rhythm.ground_speed) {
    warnings.push_back(fmt::format("walks on the spot: the ground goes back under it at {:.2f} m/s",
                                   rhythm.ground_speed * leg));
  }
  const std::string cadence = cadenceText(clip, rhythm, leg);
  if (!cadence.empty()) warnings.push_back(cadence);
  return warnings;
}

}  // namespace amble
