#include "animation/synthesis/transition_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/body/pose.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kCandidates = 0.05;  // between moments that are tried for the join [steps]

TransitionSequence scaledSequence(TransitionSequence sequence, double scale) {
  sequence.step_time *= std::sqrt(scale);
  sequence.advance *= scale;
  sequence.spline.topRows(3) *= scale;
  // How far a root may be from its path does not grow with the walker (QUALITY.md, path error).
  if (scale > 1.0) sequence.spline.row(1) /= scale;
  for (double& c : sequence.swing.height) c *= scale;
  for (double& c : sequence.swing.sideways) c *= scale;
  return sequence;
}

// The library's transition of a kind and side whose walk is nearest in speed; none of walks that
// are faster than the plan's: slowed down to a stroll, their bodies jerk.
const Motion* nearest(const MotionLibrary& library, MotionKind kind, Side side, double speed) {
  const Motion* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Motion& motion : library.motions) {
    const TransitionSequence& sequence = motion.transition.sequence;
    if (motion.kind != kind || sequence.empty() || sequence.side != side) continue;
    if (speed < motion.transition.speed) continue;
    const double off = std::abs(std::log(speed / motion.transition.speed));
    if (off < least) best = &motion, least = off;
  }
  return best;
}

// Joints as seen from the root, whose heading is the path's.
void bodyAt(const MotionLibrary& library, std::span<const double> channels, double scale,
            Pose& pose, std::vector<JointFrame>& joints) {
  const auto& reference = library.stand().rotations;
  for (size_t j = 0; j < reference.size(); ++j) {
    const double* v = &channels[3 + 3 * j];
    pose.rotations[j] = reference[j] * expRotation(Eigen::Vector3d(v[0], v[1], v[2]));
  }
  pose.p_WR = Eigen::Vector3d(0.0, 0.0, channels[2] / scale);
  forwardKinematics(library.skeleton, pose, joints);
}

// How unlike the two bodies are at a moment: places and velocities of the joints [m^2].
class Likeness {
 public:
  Likeness(const MotionLibrary& library, const TransitionSequence& sequence, bool start,
           double scale, const WalkAt& walk_at)
      : library_(library),
        sequence_(sequence),
        start_(start),
        scale_(scale),
        walk_at_(walk_at),
        channels_(sequence.spline.rows()) {
    pose_.rotations.resize(library.skeleton.size());
    for (auto* joints : {&a_, &b_, &c_, &d_}) joints->resize(library.skeleton.size());
  }

  double operator()(double clock) {
    constexpr double kHalf = 0.05;  // over which velocities are taken, both ways [steps]
    const double rate = TransitionBlend::kVelocityTime / (2.0 * kHalf * sequence_.step_time);
    place(clock - kHalf, a_, b_);
    place(clock + kHalf, c_, d_);
    double sum = 0.0;
    for (size_t j = 0; j < a_.size(); ++j) {
      const Eigen::Vector3d early = a_[j].p_WJ - b_[j].p_WJ, late = c_[j].p_WJ - d_[j].p_WJ;
      sum += (0.5 * (early + late)).squaredNorm() + (rate * (late - early)).squaredNorm();
    }
    return sum;
  }

 private:
  void place(double clock, std::vector<JointFrame>& own, std::vector<JointFrame>& walk) {
    transitionAt(sequence_, clock, channels_);
    bodyAt(library_, channels_, scale_, pose_, own);
    walk_at_(clock, sequence_.side, start_, channels_);
    bodyAt(library_, channels_, scale_, pose_, walk);
  }

  const MotionLibrary& library_;
  const TransitionSequence& sequence_;
  bool start_;
  double scale_;
  const WalkAt& walk_at_;
  std::vector<double> channels_;
  Pose pose_;
  std::vector<JointFrame> a_, b_, c_, d_;
};

}  // namespace

TransitionBlend::TransitionBlend(const MotionLibrary& library, double scale, double speed,
                                 const WalkAt& walk_at) {
  for (const bool start : {true, false}) {
    for (const Side side : {kLeft, kRight}) {
      const Motion* motion = nearest(library, start ? MotionKind::kStart : MotionKind::kStop, side,
                                     speed / std::sqrt(scale));
      if (motion == nullptr) continue;
      Joined joined;
      joined.motion = motion;
      joined.sequence = scaledSequence(motion->transition.sequence, scale);
      Likeness unlike(library, joined.sequence, start, scale, walk_at);
      const double last = TransitionSequence::kEnd - 0.5 * kBlend;
      double best = 1.0, least = unlike(best);
      for (double clock = 1.0 + kCandidates; clock < last; clock += kCandidates) {
        const double here = unlike(clock);
        if (here < least) best = clock, least = here;
      }
      joined.blend_from = best - 0.5 * kBlend;
      joined.blend_to = best + 0.5 * kBlend;
      joined_[start ? 0 : 1][side] = std::move(joined);
    }
  }
}

double TransitionBlend::Joined::share(double clock) const {
  return 1.0 - smoothstep((clock - blend_from) / (blend_to - blend_from));
}

void TransitionBlend::Joined::mix(double clock, double step_length, std::span<double> scratch,
                                  double* channels, int stride) const {
  const double own = share(clock);
  if (own <= 0.0) return;
  transitionAt(sequence, clock, scratch);
  scratch[0] *= 0.5 * step_length / sequence.advance;  // its way is as long as the step asks
  for (size_t i = 0; i < scratch.size(); ++i) {
    double& value = channels[static_cast<size_t>(stride) * i];
    value += own * (scratch[i] - value);
  }
}

std::array<EndSwing, 2> TransitionBlend::swings(int stop) const {
  std::array<EndSwing, 2> swings;
  for (const Side side : {kLeft, kRight}) {
    const Joined* joined = of(stop, side);
    if (joined == nullptr) continue;
    const FootCycle& swing = joined->sequence.swing;
    swings[side] = {true, swing.lift_off, swing.strike};
  }
  return swings;
}

double TransitionBlend::sway(int stop) const {
  double sway = 0.0;
  for (const auto& joined : joined_[stop])
    if (joined) sway = std::max(sway, joined->sequence.sway);
  return sway;
}

void TransitionBlend::addSwings(SwingCycles& cycles) const {
  cycles.first = cycles.last = cycles.walk;
  for (const Side side : {kLeft, kRight}) {
    if (const Joined* joined = start(side)) cycles.first[side] = joined->sequence.swing;
    if (const Joined* joined = stop(side)) cycles.last[side] = joined->sequence.swing;
  }
}

}  // namespace amble
