#include "animation/grafting/graft_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/grafting/graft_rules.h"
#include "animation/grafting/kinematic_chains.h"
#include "animation/grafting/upper_on_base.h"
#include "base/ease.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

constexpr double kEaseStep = 0.1;  // in which a passage's length is looked for [s]
// A joint that never turns in its sources may turn so fast, and begin so, in a passage; by trial.
constexpr double kSlowTurn = 1.0;   // [rad/s]
constexpr double kSoftTurn = 10.0;  // [rad/s^2]

void requireFrames(const LocomotiveClip& clip, const std::optional<std::pair<int, int>>& frames) {
  if (!frames) return;
  const int last = clip.clip.frames() - 1;
  if (frames->first >= 0 && frames->first < frames->second && frames->second <= last) return;
  throw InputError(
      clip.file, 0,
      "has no frames " + std::to_string(frames->first) + " to " + std::to_string(frames->second),
      "two of 0 to " + std::to_string(last) + ", in order");
}

MotionStretch windowOf(const LocomotiveClip& clip,
                       const std::optional<std::pair<int, int>>& frames) {
  requireFrames(clip, frames);
  return frames ? stretchOf(clip, *frames) : stretchOf(clip);
}

// The base's and the upper clip's joints over the range, and how they pass into one another.
class Passage {
 public:
  Passage(const PoseArray& base, PoseArray upper, const std::vector<int>& joints, int first,
          bool eases_in, bool eases_out)
      : base_(base),
        upper_(std::move(upper)),
        joints_(joints),
        first_(first),
        eases_in_(eases_in),
        eases_out_(eases_out) {}

  const PoseArray& upper() const { return upper_; }

  // The frames of the range into `poses`, eased over so many frames.
  void write(double ease, PoseArray& poses) const {
    const int last = first_ + upper_.size() - 1;
    for (int i = first_; i <= last; ++i) {
      const double weight = (eases_in_ ? minimumJerk(share(i - first_, ease)) : 1.0) *
                            (eases_out_ ? minimumJerk(share(last - i, ease)) : 1.0);
      for (const int j : joints_) {
        const Eigen::Quaterniond& q = upper_.rotations(i - first_)[j];
        poses.rotations(i)[j] = weight == 1.0 ? q : base_.rotations(i)[j].slerp(weight, q);
      }
    }
  }

 private:
  static double share(int frames, double ease) { return ease <= 0.0 ? 1.0 : frames / ease; }

  const PoseArray& base_;
  PoseArray upper_;
  const std::vector<int>& joints_;
  int first_;
  bool eases_in_, eases_out_;
};

// The upper clip's turns at each frame of the range.
PoseArray takenOver(const UpperOnBase& upper, const std::vector<int>& joints, Graft& graft,
                    const TimeWarp& warp) {
  PoseArray poses(upper.poses.joints());
  poses.resize(graft.last - graft.first + 1);
  for (int i = graft.first; i <= graft.last; ++i) {
    graft.upper_frame.push_back(warp.at(i));
    upper.at(graft.upper_frame.back(), joints, poses.rotations(i - graft.first));
  }
  return poses;
}

// How many times faster a joint turns, or changes how fast, than in its sources: the most of all.
double excessOf(const std::vector<JointPeak>& peaks, const std::vector<JointPeak>& sources) {
  double excess = 0.0;
  for (size_t k = 0; k < peaks.size(); ++k) {
    excess = std::max({excess, peaks[k].speed / std::max(sources[k].speed, kSlowTurn),
                       peaks[k].acceleration / std::max(sources[k].acceleration, kSoftTurn)});
  }
  return excess;
}

// The shortest passage by which no joint turns otherwise than in its sources; else the one by which
// they exceed them least [s].
double easeOf(const Passage& passage, const LocomotiveClip& base, const Graft& graft,
              const std::vector<JointPeak>& sources) {
  const double dt = base.clip.frame_time;
  const double longest = std::min(kLongestEase, 0.5 * (graft.last - graft.first) * dt);
  const int first = std::max(graft.first - 2, base.first);
  const int last = std::min(graft.last + 2, base.last);
  PoseArray poses = base.clip.poses;
  double best = longest, least = std::numeric_limits<double>::infinity();
  for (int step = 0;; ++step) {
    const double ease = std::min(kShortestEase + step * kEaseStep, longest);
    passage.write(ease / dt, poses);
    const double excess = excessOf(jointPeaks(poses, dt, graft.joints, first, last), sources);
    if (excess < least) least = excess, best = ease;
    if (excess <= 1.0 || ease >= longest) return best;
  }
}

// Of base within its stretch, and of upper as its turns are taken over.
std::vector<JointPeak> sourcePeaks(const LocomotiveClip& base, const MotionStretch& stretch,
                                   const PoseArray& upper, const std::vector<int>& joints) {
  const double dt = base.clip.frame_time;
  std::vector<JointPeak> peaks =
      jointPeaks(base.clip.poses, dt, joints, stretch.first, stretch.last);
  const std::vector<JointPeak> others = jointPeaks(upper, dt, joints, 0, upper.size() - 1);
  for (size_t k = 0; k < peaks.size(); ++k) {
    peaks[k].speed = std::max(peaks[k].speed, others[k].speed);
    peaks[k].acceleration = std::max(peaks[k].acceleration, others[k].acceleration);
  }
  return peaks;
}

}  // namespace

std::vector<JointPeak> jointPeaks(const PoseArray& poses, double frame_time,
                                  const std::vector<int>& joints, int first, int last) {
  std::vector<JointPeak> peaks(joints.size());
  for (int i = first + 1; i < last; ++i) {
    for (size_t k = 0; k < joints.size(); ++k) {
      const int j = joints[k];
      const Eigen::Quaterniond& q = poses.rotations(i)[j];
      const Eigen::Vector3d before = logRotation(q.conjugate() * poses.rotations(i - 1)[j]);
      const Eigen::Vector3d after = logRotation(q.conjugate() * poses.rotations(i + 1)[j]);
      peaks[k].speed = std::max(peaks[k].speed, after.norm() / frame_time);
      peaks[k].acceleration =
          std::max(peaks[k].acceleration, (before + after).norm() / (frame_time * frame_time));
    }
  }
  return peaks;
}

double largestAcceleration(const std::vector<JointPeak>& peaks) {
  double largest = 0.0;
  for (const JointPeak& peak : peaks) largest = std::max(largest, peak.acceleration);
  return largest;
}

GraftPlan planGraft(const LocomotiveClip& base, const LocomotiveClip& upper,
                    const GraftWishes& wishes) {
  GraftPlan plan;
  plan.joints = graftedJoints(base.clip.skeleton, base.roles, wishes.chains, base.file);
  plan.windows = {windowOf(base, wishes.range), windowOf(upper, wishes.action)};
  plan.refusal = graftRefusal(plan.windows.upper.type, plan.windows.base.type);
  if (!plan.refusal.empty()) return plan;
  plan.alternatives = correlate(base, upper, plan.windows);
  if (plan.alternatives.empty()) {
    plan.refusal = "no two foot plants in a row of both clips go together (thesis 5.3.1)";
    return plan;
  }
  const int count = static_cast<int>(plan.alternatives.size());
  if (wishes.alternative >= count) {
    throw InputError(upper.file, 0,
                     "goes with the base in no alternative " + std::to_string(wishes.alternative),
                     count == 1 ? "0" : "0 to " + std::to_string(count - 1));
  }
  return plan;
}

Graft makeGraft(const LocomotiveClip& base, const LocomotiveClip& upper, const GraftPlan& plan,
                const GraftWishes& wishes) {
  const Correlation& correlation = plan.alternatives[static_cast<size_t>(wishes.alternative)];
  const UpperOnBase turns = upperOnBase(upper, base);
  Graft graft;
  graft.clip = base.clip;
  graft.first = correlation.first;
  graft.last = correlation.last;
  for (const int j : plan.joints) {
    if (turns.follows[j]) {
      graft.joints.push_back(j);
    } else {
      graft.kept.push_back(base.clip.skeleton.joint(j).name);
    }
  }
  const double dt = base.clip.frame_time;
  const bool eases_in = graft.first > base.first, eases_out = graft.last < base.last;
  const Passage passage(base.clip.poses,
                        takenOver(turns, graft.joints, graft, TimeWarp(correlation)), graft.joints,
                        graft.first, eases_in, eases_out);
  const std::vector<JointPeak> sources =
      sourcePeaks(base, plan.windows.base, passage.upper(), graft.joints);
  const double ease = wishes.ease ? std::min(*wishes.ease, 0.5 * (graft.last - graft.first) * dt)
                                  : easeOf(passage, base, graft, sources);
  passage.write(ease / dt, graft.clip.poses);
  graft.ease_in = eases_in ? ease : 0.0;
  graft.ease_out = eases_out ? ease : 0.0;
  graft.source_acceleration = largestAcceleration(sources);
  graft.acceleration = accelerationOf(graft, base);
  return graft;
}

double accelerationOf(const Graft& graft, const LocomotiveClip& base) {
  return largestAcceleration(jointPeaks(graft.clip.poses, graft.clip.frame_time, graft.joints,
                                        std::max(graft.first - 2, base.first),
                                        std::min(graft.last + 2, base.last)));
}

}  // namespace amble
