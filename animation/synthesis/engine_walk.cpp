#include "animation/synthesis/engine_walk.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "base/ease.h"

namespace amble {
namespace {

// From where one foot passes the other to a stand. Less, and hips come back by up to 17 mm; more,
// and the last step gets longer, for feet stand where hips come to rest [cycles]. By trial.
constexpr double kAfterPassing = 0.2;
// The foot that comes down to stand begins to lie flat so long before, and does so within this [s].
constexpr double kLaysBefore = 0.1, kLays = 0.3;
// Of the time in which a foot begins to roll later: it comes to no halt, nor rolls back [1].
constexpr double kStillRolls = 0.6;
constexpr double kStill = 1e-6;  // slower is standing [m/s]

/// Its frames are 0 to this one [>= 1].
int lastFrame(const EngineWalkRequest& request) {
  return std::max(1, static_cast<int>(std::lround(request.duration / request.frame_time)));
}

/// What the captured person does at that time [m/s]: by eq. 3 a walker so much larger does at
/// `scale` times the speed what the captured person does.
double speedAt(const SpeedEngine& engine, const EngineWalkRequest& request, double time) {
  return engine.clamped(request.speed(time) / request.scale);
}

/// Between frame i and the next.
double speedAfter(const SpeedEngine& engine, const EngineWalkRequest& request, int i) {
  return speedAt(engine, request, (i + 0.5) * request.frame_time);
}

/// The frames of the last swing that begins and comes down, or goes on to the end: its side, and
/// the first of them; nothing where none begins.
std::optional<std::pair<Side, size_t>> lastSwing(const EngineWalk& walk) {
  std::optional<std::pair<Side, size_t>> last;
  for (const Side side : {kLeft, kRight}) {
    const std::vector<bool>& planted = walk.planted[side];
    for (size_t i = 1; i < planted.size(); ++i) {
      if (planted[i - 1] && !planted[i] && (!last || i > last->second)) last = {side, i};
    }
  }
  return last;
}

/// A foot that comes down at `lands` to stand lies down at once as it is to stand: the phase goes
/// on to where it would strike by its heel, toes up.
void layFlat(const LegJoints& leg, int lands, Clip& clip) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  const int last = clip.frames() - 1;
  forwardKinematics(clip, last, joints);
  const Eigen::Quaterniond q_WStands = joints[leg.foot].q_WJ;
  for (int i = 0; i < last; ++i) {
    const double share = smoothstep(((i - lands) * clip.frame_time + kLaysBefore) / kLays);
    if (share == 0.0) continue;
    forwardKinematics(clip, i, joints);
    const std::span<Eigen::Quaterniond> q = clip.poses.rotations(i);
    const Eigen::Quaterniond q_WShank = joints[clip.skeleton.joint(leg.foot).parent].q_WJ;
    q[leg.foot] = q_WShank.conjugate() * joints[leg.foot].q_WJ.slerp(share, q_WStands);
    if (leg.toe >= 0) q[leg.toe] = q[leg.toe].slerp(share, clip.poses[last].rotations[leg.toe]);
  }
}

/// How long a swing takes at a speed of the captured person [s].
double swingTime(const SpeedEngine& engine, double speed) {
  const std::array<double, 2> both = engine.support(speed);
  return (0.5 - 0.5 * (both[kLeft] + both[kRight])) / engine.frequency(speed);
}

// Who slows down below the captured speeds puts the foot that he swings last down sooner than walks
// do: else it comes to rest with the phase, over a floor that it hardly clears. To a stand, the
// swing takes as long as it would have at the speed at which it began, times the share of that
// speed that is left; the more of a captured walk there is at the end, the less sooner.
void putDownLast(const SpeedEngine& engine, double scale, EngineWalk& walk) {
  const std::optional<std::pair<Side, size_t>> swing = lastSwing(walk);
  const double ends = walk.speeds.back();
  const double creeps = 1.0 - engine.walkShare(ends / scale);
  if (!swing || creeps <= 0.0 || ends >= walk.speeds[swing->second - 1]) return;
  const auto [side, first] = *swing;
  const double began = walk.speeds[first - 1];
  const double time = swingTime(engine, began / scale);
  size_t lands = first;
  const auto swung = [&] { return static_cast<double>(lands - first + 1) * walk.clip.frame_time; };
  while (lands < walk.speeds.size() && !walk.planted[side][lands] &&
         swung() <= time * std::pow(walk.speeds[lands] / began, creeps)) {
    ++lands;
  }
  std::fill(walk.planted[side].begin() + static_cast<std::ptrdiff_t>(lands),
            walk.planted[side].end(), true);
  if (isStanding(ends)) layFlat(engine.data().roles.legs[side], static_cast<int>(lands), walk.clip);
}

/// A swing of a foot: the first frame in which it is off the floor, and that in which it is down.
struct Swing {
  Side side = kLeft;
  size_t leaves = 0, lands = 0;
};

/// The first swing that comes down, of a foot that stands at the begin; nothing where none does.
std::optional<Swing> firstSwing(const EngineWalk& walk) {
  std::optional<Swing> found;
  for (const Side side : {kLeft, kRight}) {
    const std::vector<bool>& planted = walk.planted[side];
    const auto leaves = std::find(planted.begin(), planted.end(), false);
    const auto lands = std::find(leaves, planted.end(), true);
    if (leaves == planted.begin() || lands == planted.end()) continue;
    const Swing swing{side, static_cast<size_t>(leaves - planted.begin()),
                      static_cast<size_t>(lands - planted.begin())};
    if (!found || swing.leaves < found->leaves) found = swing;
  }
  return found;
}

/// A foot that leaves by `late` frames later than the phase has it rolls later, too: on to where it
/// leaves ever more, and less until it comes down. Else its heel would sink while it still stands.
void rollLate(const LegJoints& leg, const Swing& swing, double late, Clip& clip) {
  const double leaves = static_cast<double>(swing.leaves), lands = static_cast<double>(swing.lands);
  const double before = std::min(leaves, lands - leaves);
  late = std::min(late, kStillRolls * before);
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<Eigen::Quaterniond> q_WF, q_WShank, q_toe;
  for (size_t i = 0; i <= swing.lands; ++i) {
    forwardKinematics(clip, static_cast<int>(i), joints);
    q_WF.push_back(joints[leg.foot].q_WJ);
    q_WShank.push_back(joints[clip.skeleton.joint(leg.foot).parent].q_WJ);
    if (leg.toe >= 0) q_toe.push_back(clip.poses[static_cast<int>(i)].rotations[leg.toe]);
  }
  const auto at = [](const std::vector<Eigen::Quaterniond>& q, double frame) {
    const auto i = std::min(static_cast<size_t>(frame), q.size() - 2);
    return q[i].slerp(frame - static_cast<double>(i), q[i + 1]);
  };
  for (size_t i = 0; i < swing.lands; ++i) {
    const auto now = static_cast<double>(i);
    const double share = now < leaves ? smoothstep(1.0 - (leaves - now) / before)
                                      : smoothstep((lands - now) / (lands - leaves));
    if (share == 0.0) continue;
    const double rolls = std::max(0.0, now - late * share);
    const std::span<Eigen::Quaterniond> q = clip.poses.rotations(static_cast<int>(i));
    q[leg.foot] = q_WShank[i].conjugate() * at(q_WF, rolls);
    if (leg.toe >= 0) q[leg.toe] = at(q_toe, rolls);
  }
}

// As the last swing of who slows down, so the first of who speeds up from below the captured
// speeds: with the phase his foot would creep off. From a stand it leaves so late that the swing
// takes as long as it would at the speed at which it ends, times the share of that speed that is
// reached before; the more of a captured walk there is at the begin, the less later.
void liftFirstLate(const SpeedEngine& engine, double scale, EngineWalk& walk) {
  std::optional<Swing> swing = firstSwing(walk);
  const double creeps = 1.0 - engine.walkShare(walk.speeds.front() / scale);
  if (!swing || creeps <= 0.0 || walk.speeds.front() >= walk.speeds[swing->lands]) return;
  const double ends = walk.speeds[swing->lands];
  const double time = swingTime(engine, ends / scale);
  const size_t by_phase = swing->leaves;
  const auto longer = [&] {
    return static_cast<double>(swing->lands - swing->leaves + 1) * walk.clip.frame_time;
  };
  swing->leaves = swing->lands - 1;
  while (swing->leaves > by_phase &&
         longer() <= time * std::pow(walk.speeds[swing->leaves - 1] / ends, creeps)) {
    --swing->leaves;
  }
  std::vector<bool>& planted = walk.planted[swing->side];
  std::fill(planted.begin(), planted.begin() + static_cast<std::ptrdiff_t>(swing->leaves), true);
  rollLate(engine.data().roles.legs[swing->side], *swing,
           static_cast<double>(swing->leaves - by_phase), walk.clip);
}

}  // namespace

bool isStanding(double speed) { return speed <= kStill; }

double phaseToStand(const SpeedEngine& engine, const EngineWalkRequest& request) {
  const auto standsAt = [&](int i) {
    return isStanding(speedAt(engine, request, i * request.frame_time));
  };
  int last = lastFrame(request);
  if (!standsAt(last)) return 0.0;
  while (last > 0 && standsAt(last - 1)) --last;
  double gone = 0.0;
  for (int i = 0; i < last; ++i) {
    gone += request.frame_time * engine.frequency(speedAfter(engine, request, i));
  }
  const double first = 0.25 + kAfterPassing - gone;
  return first - std::floor(first);
}

EngineWalk engineWalk(const SpeedEngine& engine, const EngineWalkRequest& request) {
  assert(request.duration > 0.0 && request.frame_time > 0.0 && request.scale > 0.0);
  const int last = lastFrame(request);
  EngineWalk walk;
  walk.clip = {"walk",
               engine.data().skeleton.scaled(request.scale),
               request.frame_time,
               PoseArray(engine.joints()),
               {}};
  Pose pose;
  pose.rotations.resize(engine.joints());
  double phase = request.phase;
  for (int i = 0; i <= last; ++i) {
    const double speed = speedAt(engine, request, i * request.frame_time);
    engine.poseAt(speed, phase, pose);
    pose.p_WR *= request.scale;
    pose.p_WR.x() += walk.length;
    walk.clip.poses.append(pose);
    walk.speeds.push_back(speed * request.scale);
    walk.phases.push_back(phase);
    for (const Side side : {kLeft, kRight}) {
      walk.planted[side].push_back(engine.planted(speed, phase, side));
    }
    if (i == last) break;
    const double between = speedAfter(engine, request, i);
    phase += request.frame_time * engine.frequency(between);  // eq. 5
    walk.length += request.frame_time * between * request.scale;
  }
  putDownLast(engine, request.scale, walk);
  liftFirstLate(engine, request.scale, walk);
  return walk;
}

}  // namespace amble
