#include "animation/clips/blend_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "animation/body/two_link.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Corrections below it are rounding: the leg stays to the bit [m, rad].
constexpr double kNothing = 1e-7;

struct Run {
  int first = 0, last = 0;
};

std::vector<Run> runsOf(const std::vector<bool>& planted) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(planted.size()); ++i) {
    if (!planted[i]) continue;
    if (!runs.empty() && runs.back().last == i - 1)
      runs.back().last = i;
    else
      runs.push_back({i, i});
  }
  return runs;
}

// The contact that the blend begins with: of the motion before, and where that goes on to the end
// but the motion after leaves the ground, as long as that one stands, half of the blend at least.
std::optional<Run> firstContact(const std::vector<Run>& before, const std::vector<Run>& after,
                                int end) {
  if (before.empty() || before.front().first > 0) return std::nullopt;
  const int last = before.front().last;
  const bool stands_after = !after.empty() && after.back().last == end;
  if (last < end || stands_after) return Run{0, last};
  const bool stood = !after.empty() && after.front().first == 0;
  return Run{0, std::max(end / 2, stood ? after.front().last : 0)};
}

// The same seen from the end.
std::optional<Run> lastContact(const std::vector<Run>& before, const std::vector<Run>& after,
                               int end) {
  if (after.empty() || after.back().last < end) return std::nullopt;
  const int first = after.back().first;
  const bool stood_before = !before.empty() && before.front().first == 0;
  if (first > 0 || stood_before) return Run{first, end};
  const bool strikes = !before.empty() && before.back().last == end;
  return Run{std::min(end / 2, strikes ? before.back().first : end), end};
}

// A place and a turn by which a foot is moved [m, rotation vector].
using Correction = Eigen::Matrix<double, 6, 1>;

Correction correctionOf(const JointFrame& from, const JointFrame& to) {
  Correction c;
  c << to.p_WJ - from.p_WJ, logRotation(to.q_WJ * from.q_WJ.conjugate());
  return c;
}

JointFrame mixed(const JointFrame& a, const JointFrame& b, double weight) {
  return {a.q_WJ.slerp(weight, b.q_WJ), (1.0 - weight) * a.p_WJ + weight * b.p_WJ};
}

// From a value and a slope to others over `frames`, at `t` of them: Hermite's cubic.
struct Knot {
  int frame = 0;
  Correction value = Correction::Zero();
  Correction slope = Correction::Zero();  // a frame
};
Correction between(const Knot& a, const Knot& b, int frame) {
  const double length = b.frame - a.frame, t = (frame - a.frame) / length;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a.value + (t3 - 2 * t2 + t) * length * a.slope +
         (3 * t2 - 2 * t3) * b.value + (t3 - t2) * length * b.slope;
}

/// Turns a leg so that its foot is where and as it is asked to be, or as near as it reaches.
class LegSolver {
 public:
  LegSolver(const Skeleton& skeleton, const LegJoints& leg, const Eigen::Vector3d& knee_axis)
      : skeleton_(skeleton), leg_(leg), knee_axis_(knee_axis) {}

  // @param joint  X_WJ of the pose as it is
  void solve(std::span<const JointFrame> joint, const JointFrame& foot,
             std::span<Eigen::Quaterniond> q) const {
    const TwoLink links{joint[leg_.up_leg].p_WJ, joint[leg_.leg].p_WJ, joint[leg_.foot].p_WJ,
                        joint[leg_.up_leg].q_WJ * knee_axis_};
    const auto solved = solveTwoLink(links, inReach(links, foot.p_WJ));
    if (!solved) return;
    const auto parent = [&](int j) { return joint[skeleton_.joint(j).parent].q_WJ; };
    const Eigen::Quaterniond thigh = solved->thigh * joint[leg_.up_leg].q_WJ;
    const Eigen::Quaterniond shank = solved->shank * joint[leg_.leg].q_WJ;
    // Joints between those of the leg turn with the link that they are in.
    q[leg_.up_leg] = (parent(leg_.up_leg).conjugate() * thigh).normalized();
    q[leg_.leg] = ((solved->thigh * parent(leg_.leg)).conjugate() * shank).normalized();
    q[leg_.foot] = ((solved->shank * parent(leg_.foot)).conjugate() * foot.q_WJ).normalized();
  }

 private:
  static Eigen::Vector3d inReach(const TwoLink& leg, const Eigen::Vector3d& target) {
    constexpr double kNearlyStraight = 0.9995;
    const double reach =
        kNearlyStraight * ((leg.knee - leg.hip).norm() + (leg.ankle - leg.knee).norm());
    const Eigen::Vector3d way = target - leg.hip;
    // Where the motion itself stands straighter than that, it stays so.
    const double most = std::max(reach, (leg.ankle - leg.hip).norm());
    return way.norm() <= most ? target : Eigen::Vector3d(leg.hip + way * (most / way.norm()));
  }

  const Skeleton& skeleton_;
  const LegJoints& leg_;
  const Eigen::Vector3d knee_axis_;
};

// Corrections of one foot over the frames that any of its holds reaches.
class CorrectionTrack {
 public:
  CorrectionTrack(const Clip& clip, const JointRoles& roles, Side side, const BlendFeet& blend)
      : clip_(clip), roles_(roles), side_(side), blend_(blend) {}

  // Knots: a fade before the holds, one at each end of each, a fade behind the last.
  std::vector<Correction> over(int first, int last, const std::vector<FootHold>& holds,
                               const std::vector<bool>& planted) const {
    std::vector<Correction> track(last - first + 1, Correction::Zero());
    Knot from{fadeFrom(holds.front(), first, planted), Correction::Zero(), Correction::Zero()};
    for (const FootHold& hold : holds) {
      const Knot begin = knotAt(hold, hold.first, 1), end = knotAt(hold, hold.last, -1);
      fill(track, first, from, begin);
      for (int i = hold.first; i <= hold.last; ++i) track[i - first] = asked(hold, i);
      from = end;
    }
    const Knot rest{fadeTo(holds.back(), last, planted), Correction::Zero(), Correction::Zero()};
    fill(track, first, from, rest);
    return track;
  }

 private:
  int fade() const { return static_cast<int>(std::ceil(kHoldFade / clip_.frame_time)); }
  int end() const { return static_cast<int>(blend_.before.size()) - 1; }

  // A frame of the blend from which the foot is off the ground until the hold, or the blend's
  // first: corrections begin there.
  int fadeFrom(const FootHold& hold, int first, const std::vector<bool>& planted) const {
    int from = std::max(first, std::min(0, hold.first - fade()));
    for (int i = std::min(hold.first, 0) - 1; i >= from; --i)
      if (planted[blend_.first + i]) return i + 1;
    return from;
  }
  int fadeTo(const FootHold& hold, int last, const std::vector<bool>& planted) const {
    const int to = std::min(last, std::max(end(), hold.last + fade()));
    for (int i = std::max(hold.last, end()) + 1; i <= to; ++i)
      if (planted[blend_.first + i]) return i - 1;
    return to;
  }

  JointFrame footAt(int i) const {
    std::vector<JointFrame> joints(clip_.skeleton.size());
    forwardKinematics(clip_, blend_.first + i, joints);
    return joints[roles_.legs[side_].foot];
  }

  Correction asked(const FootHold& hold, int i) const {
    const JointFrame &a = blend_.before[i][side_].joint, &b = blend_.after[i][side_].joint;
    return correctionOf(footAt(i), mixed(a, b, weightOf(hold, i)));
  }

  double weightOf(const FootHold& hold, int i) const {
    switch (hold.which) {
      case ContactCase::kBefore:
        return 0.0;
      case ContactCase::kAfter:
        return 1.0;
      case ContactCase::kWithin:
        return hold.first + hold.last < end() ? 0.0 : 1.0;
      case ContactCase::kSlips:
        break;
    }
    return minimumJerk(static_cast<double>(i) / std::max(1, end()));
  }

  Knot knotAt(const FootHold& hold, int i, int inward) const {
    Knot knot{i, asked(hold, i), Correction::Zero()};
    if (hold.first < hold.last) knot.slope = inward * (asked(hold, i + inward) - knot.value);
    return knot;
  }

  static void fill(std::vector<Correction>& track, int first, const Knot& a, const Knot& b) {
    for (int i = a.frame + 1; i < b.frame; ++i) track[i - first] = between(a, b, i);
  }

  const Clip& clip_;
  const JointRoles& roles_;
  const Side side_;
  const BlendFeet& blend_;
};

// How far the foot is off its way, or goes on it from the one place to the other.
void measureSlip(const Clip& clip, const JointRoles& roles, const BlendFeet& blend,
                 FootHold& hold) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  const int end = static_cast<int>(blend.before.size()) - 1;
  for (int i = hold.first; i <= hold.last; ++i) {
    const Eigen::Vector3d &a = blend.before[i][hold.side].toe, &b = blend.after[i][hold.side].toe;
    Eigen::Vector3d off = b - a;
    if (hold.which != ContactCase::kSlips) {
      forwardKinematics(clip, blend.first + i, joints);
      const bool first = hold.which == ContactCase::kBefore ||
                         (hold.which == ContactCase::kWithin && hold.first + hold.last < end);
      off = footFrame(joints, roles.legs[hold.side]).toe - (first ? a : b);
    }
    hold.slip = std::max(hold.slip, off.head<2>().norm());
  }
}

}  // namespace

FootFrame footFrame(std::span<const JointFrame> joints, const LegJoints& leg) {
  return {joints[leg.foot], joints[leg.toe >= 0 ? leg.toe : leg.foot].p_WJ};
}

std::vector<FootHold> contactsOf(Side side, const std::vector<bool>& before,
                                 const std::vector<bool>& after, int gap) {
  const int end = static_cast<int>(before.size()) - 1;
  const std::vector<Run> a = runsOf(before), b = runsOf(after);
  const std::optional<Run> first = firstContact(a, b, end), last = lastContact(a, b, end);
  if (first && last && last->first - first->last <= gap + 1)
    return {{side, ContactCase::kSlips, 0, end, 0.0}};
  std::vector<FootHold> holds;
  if (first) holds.push_back({side, ContactCase::kBefore, first->first, first->last, 0.0});
  const int from = first ? first->last + gap + 1 : 1, to = last ? last->first - gap - 1 : end - 1;
  // Of the one motion in the first half, of the other in the second: the way that is nearer.
  for (const Run& run : a)
    if (run.first >= from && run.last <= to && run.first + run.last < end)
      holds.push_back({side, ContactCase::kWithin, run.first, run.last, 0.0});
  const int free = holds.empty() ? from : std::max(from, holds.back().last + gap + 1);
  for (const Run& run : b)
    if (run.first >= free && run.last <= to && run.first + run.last >= end)
      holds.push_back({side, ContactCase::kWithin, run.first, run.last, 0.0});
  if (last) holds.push_back({side, ContactCase::kAfter, last->first, last->last, 0.0});
  return holds;
}

void holdFeet(Clip& clip, const JointRoles& roles, const PlantedFrames& planted,
              const BlendFeet& blend, std::vector<FootHold>& holds) {
  const int first = -blend.first, last = clip.frames() - 1 - blend.first;
  const int reach = static_cast<int>(std::ceil(kHoldFade / clip.frame_time));
  const int from = std::max(first, -reach);
  const int to = std::min(last, static_cast<int>(blend.before.size()) - 1 + reach);
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (const Side side : {kLeft, kRight}) {
    std::vector<FootHold> own;
    for (const FootHold& hold : holds)
      if (hold.side == side) own.push_back(hold);
    if (own.empty()) continue;
    const std::vector<Correction> track =
        CorrectionTrack(clip, roles, side, blend).over(from, to, own, planted[side]);
    const LegSolver solver(clip.skeleton, roles.legs[side], blend.knees[side]);
    for (int i = from; i <= to; ++i) {
      const Correction& c = track[i - from];
      if (c.cwiseAbs().maxCoeff() < kNothing) continue;
      forwardKinematics(clip, blend.first + i, joints);
      const JointFrame& foot = joints[roles.legs[side].foot];
      const Eigen::Quaterniond turn = expRotation(c.tail<3>());
      solver.solve(joints, {turn * foot.q_WJ, foot.p_WJ + c.head<3>()},
                   clip.poses.rotations(blend.first + i));
    }
  }
  for (FootHold& hold : holds) measureSlip(clip, roles, blend, hold);
}

}  // namespace amble
