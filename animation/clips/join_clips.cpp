#include "animation/clips/join_clips.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/body/reference_pose.h"
#include "base/ease.h"

namespace amble {
namespace {

// Slower roots stand, and their speeds have no ratio [m/s].
constexpr double kStanding = 0.05;
// Feet that are off the ground for less are taken as standing throughout [s].
constexpr double kShortGap = 0.07;
// The root goes no faster than this, against its sources, to spare a foot a slip: half of what
// would be seen as a glide.
constexpr double kMostGlide = 1.05;

// The frames of both motions that are mixed: `frames` + 1 of each.
struct Window {
  int before = 0;  // first of them in the motion before
  int after = 0;   // and in the motion after
  int frames = 0;  // [>= 0]
  RootMotion root_before, root_after;

  double weight(double i) const { return frames == 0 ? 0.0 : minimumJerk(i / frames); }
};

Window windowOf(const Clip& a, const Clip& b, const JointRoles& roles, const ClipJoin& join) {
  const int half = std::min({join.blend / 2, join.leave, a.frames() - 1 - join.leave, join.enter,
                             b.frames() - 1 - join.enter});
  Window w{join.leave - half, join.enter - half, 2 * half, {}, {}};
  w.root_before = rootMotion(a, roles, w.before, w.before + w.frames);
  w.root_after = rootMotion(b, roles, w.after, w.after + w.frames);
  return w;
}

std::vector<RootPlace> placesOf(const Window& w) {
  std::vector<RootPlace> places = {w.root_before.places[0]};
  for (int i = 0; i < w.frames; ++i)
    places.push_back(advanced(
        places.back(), mixed(w.root_before.step(i), w.root_after.step(i), w.weight(i + 0.5))));
  return places;
}

// How far the root goes to the next place against the mean of its sources, weighted as they are
// mixed, the greatest of all.
double glideOf(const Window& w, const std::vector<RootPlace>& places, double least) {
  double most = 0.0;
  for (int i = 0; i < w.frames; ++i) {
    const double weight = w.weight(i + 0.5);
    const double usual = (1.0 - weight) * w.root_before.step(i).way.norm() +
                         weight * w.root_after.step(i).way.norm();
    const double way = (places[i + 1].at - places[i].at).norm();
    if (usual > least) most = std::max(most, way / usual);
  }
  return most;
}

// The root's way with a shift added over the blend, from rest to rest.
std::vector<RootPlace> shifted(std::vector<RootPlace> places, const Eigen::Vector2d& by) {
  const double frames = static_cast<double>(places.size()) - 1.0;
  for (size_t i = 1; i < places.size(); ++i)
    places[i].at += smoothstep(static_cast<double>(i) / frames) * by;
  return places;
}

std::vector<FootFrames> feetOf(const Clip& clip, const JointRoles& roles, int first, int count,
                               const GroundShift& moved) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<FootFrames> feet(count);
  for (int i = 0; i < count; ++i) {
    forwardKinematics(clip, first + i, joints);
    for (const Side side : {kLeft, kRight}) {
      const FootFrame foot = footFrame(joints, roles.legs[side]);
      feet[i][side] = {moved * foot.joint, moved * foot.toe};
    }
  }
  return feet;
}

// Origins of the joints at a frame, which few clips move.
Eigen::Vector3d originOf(const Clip& clip, int frame, int joint) {
  if (clip.joint_positions.empty()) return clip.skeleton.joint(joint).offset;
  return clip.joint_positions[static_cast<size_t>(frame) * clip.skeleton.size() + joint];
}

std::vector<Eigen::Vector3d> joinedOrigins(const Clip& a, const Clip& b, const Window& w) {
  if (a.joint_positions.empty() && b.joint_positions.empty()) return {};
  const int joints = a.skeleton.size();
  std::vector<Eigen::Vector3d> origins;
  for (int i = 0; i < w.before + w.frames + b.frames() - (w.after + w.frames); ++i) {
    const int k = i - w.before;
    const double weight = std::clamp(w.weight(k), 0.0, 1.0);
    const int in_a = std::min(i, w.before + w.frames), in_b = std::max(w.after, w.after + k);
    for (int j = 0; j < joints; ++j) {
      if (k <= 0) {
        origins.push_back(originOf(a, in_a, j));
      } else if (k > w.frames) {
        origins.push_back(originOf(b, in_b, j));
      } else {
        origins.push_back((1.0 - weight) * originOf(a, in_a, j) + weight * originOf(b, in_b, j));
      }
    }
  }
  return origins;
}

// Mixes the frames of `next` into those that end `poses`.
void mixPoses(PoseArray& poses, const PoseArray& next, const Window& w,
              const std::vector<RootPlace>& places) {
  for (int i = 0; i <= w.frames; ++i) {
    const double weight = w.weight(i);
    const auto q = poses.rotations(w.before + i);
    const auto q_next = next.rotations(w.after + i);
    for (size_t j = 1; j < q.size(); ++j) q[j] = q[j].slerp(weight, q_next[j]);
    placeRoot(poses, w.before + i, places[i],
              mixed(w.root_before.carriages[i], w.root_after.carriages[i], weight));
  }
}

// A foot that stands throughout slips by as much as both motions have it elsewhere under the root
// (blend_contacts.h, case 4). The root takes as much of that over as lets it go no faster than
// kMostGlide allows: where it would have to hurry the foot slips for the rest.
std::vector<RootPlace> sparingFeet(const Window& w, const std::vector<RootPlace>& places,
                                   const std::vector<FootFrames>& before,
                                   const std::vector<FootFrames>& after,
                                   const std::vector<FootHold>& feet) {
  Eigen::Vector2d slip = Eigen::Vector2d::Zero();
  int count = 0;
  for (const FootHold& foot : feet) {
    if (foot.which != ContactCase::kSlips) continue;
    for (size_t i = 0; i < before.size(); ++i, ++count)
      slip += (after[i][foot.side].toe - before[i][foot.side].toe).head<2>();
  }
  if (count == 0 || w.frames == 0) return places;
  constexpr int kHalvings = 10;  // to a thousandth of the way
  double share = 0.0, step = 1.0;
  for (int i = 0; i <= kHalvings; ++i, step *= 0.5) {
    const double tried = share + step;
    if (tried <= 1.0 && glideOf(w, shifted(places, -tried / count * slip), 0.0) <= kMostGlide)
      share = tried;
  }
  return shifted(places, -share / count * slip);
}

std::vector<bool> part(const std::vector<bool>& values, int first, int count) {
  return {values.begin() + first, values.begin() + first + count};
}

// What stands within a blend is what is held there; a cut has the first motion's last frame.
void joinPlanted(std::vector<bool>& planted, const std::vector<bool>& next, const Window& w) {
  planted.resize(w.before + (w.frames == 0 ? 1 : 0));
  if (w.frames > 0) planted.insert(planted.end(), w.frames + 1, false);
  planted.insert(planted.end(), next.begin() + w.after + w.frames + 1, next.end());
}

// Along the ground [m].
double wayAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return (to - from).head<2>().norm();
}

}  // namespace

JoinedClip joinedFrom(const ClipPart& part, int first) {
  const Clip& clip = part.clip;
  assert(first >= 0 && first < clip.frames());
  JoinedClip joined{
      {clip.name, clip.skeleton, clip.frame_time, PoseArray(clip.skeleton.size()), {}},
      part.planted,
      {}};
  joined.clip.poses.append(clip.poses, first, clip.frames() - first);
  if (!clip.joint_positions.empty())
    joined.clip.joint_positions.assign(
        clip.joint_positions.begin() + static_cast<ptrdiff_t>(first) * clip.skeleton.size(),
        clip.joint_positions.end());
  for (std::vector<bool>& side : joined.planted) side.erase(side.begin(), side.begin() + first);
  return joined;
}

void joinOn(JoinedClip& joined, const ClipPart& next, const JointRoles& roles,
            const ClipJoin& join) {
  Clip& clip = joined.clip;
  assert(clip.skeleton.size() == next.clip.skeleton.size());
  assert(join.leave >= 0 && join.leave < clip.frames() && join.enter >= 0 &&
         join.enter < next.clip.frames());
  const Window w = windowOf(clip, next.clip, roles, join);
  const int count = w.frames + 1, rest = w.after + count;  // first frame of `next` alone
  JoinReport report{w.before, w.before + w.frames, join.leave, w.before - w.after, {}, 0.0, {}};
  const int gap = static_cast<int>(std::lround(kShortGap / clip.frame_time));
  for (const Side side : {kLeft, kRight}) {
    const auto held = contactsOf(side, part(joined.planted[side], w.before, count),
                                 part(next.planted[side], w.after, count), gap);
    report.feet.insert(report.feet.end(), held.begin(), held.end());
    joinPlanted(joined.planted[side], next.planted[side], w);
  }
  const std::vector<FootFrames> before = feetOf(clip, roles, w.before, count, {});
  const auto feetAfter = [&](const std::vector<RootPlace>& places) {
    report.moved = between(w.root_after.places.back(), places.back());
    return feetOf(next.clip, roles, w.after, count, report.moved);
  };
  std::vector<RootPlace> places = placesOf(w);
  places = sparingFeet(w, places, before, feetAfter(places), report.feet);
  const std::vector<FootFrames> after = feetAfter(places);
  report.glide = glideOf(w, places, kStanding * clip.frame_time);

  clip.joint_positions = joinedOrigins(clip, next.clip, w);
  clip.poses.resize(w.before + count);
  mixPoses(clip.poses, next.clip.poses, w, places);
  clip.poses.append(next.clip.poses, rest, next.clip.frames() - rest);
  moveRoot(clip.poses, w.before + count, clip.frames() - 1, report.moved);
  const auto knees = kneeAxes(roles, referenceOf(next.clip, roles));
  if (w.frames > 0)
    holdFeet(clip, roles, joined.planted, {w.before, before, after, knees}, report.feet);
  for (FootHold& foot : report.feet) {
    if (w.frames == 0) foot.slip = wayAlong(before[0][foot.side].toe, after[0][foot.side].toe);
    foot.first += w.before;
    foot.last += w.before;
    for (int i = foot.first; i <= foot.last; ++i) joined.planted[foot.side][i] = true;
  }
  joined.joins.push_back(report);
}

void endAt(JoinedClip& joined, int last) {
  assert(last >= 0 && last < joined.clip.frames());
  joined.clip.poses.resize(last + 1);
  if (!joined.clip.joint_positions.empty())
    joined.clip.joint_positions.resize(static_cast<size_t>(last + 1) * joined.clip.skeleton.size());
  for (std::vector<bool>& side : joined.planted) side.resize(last + 1);
  for (JoinReport& join : joined.joins) {
    join.last = std::min(join.last, last);
    std::erase_if(join.feet, [&](const FootHold& foot) { return foot.first > last; });
    for (FootHold& foot : join.feet) foot.last = std::min(foot.last, last);
  }
}

}  // namespace amble
