#include "environments/collision/motion_check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace amble {
// Those of frames [first, last) that are not placed yet, every `step`th.
void MotionCheck::place(int first, int last, int step) {
  std::array<int, kAhead + 1> missing;
  int count = 0;
  const auto flush = [&] {
    world_.track.place(poses_, {missing.data(), static_cast<size_t>(count)}, scratch_.capsules,
                       scratch_.lanes);
    count = 0;
  };
  for (int frame = first; frame < std::min(last, poses_.size()); frame += step) {
    if (scratch_.placed[frame]) continue;
    scratch_.placed[frame] = true;
    missing[count++] = frame;
    if (count == static_cast<int>(missing.size())) flush();
  }
  flush();
}

std::optional<Contact> MotionCheck::coarse() {
  for (size_t level = 0; level < kStrides.size(); ++level) {
    // Of the finer strides every other frame has been tried.
    const int first = level > 0 ? kStrides[level] : 0;
    const int stride = level > 0 ? kStrides[level - 1] : kStrides[level];
    for (int frame = first; frame < poses_.size(); frame += stride) {
      if (!scratch_.placed[frame]) place(frame, frame + 4 * stride, stride);
      for (int part = 0; part < world_.parts(); ++part) {
        const int object = world_.touchedAt(placed(frame), part, soles_[frame], scratch_);
        if (object >= 0) return Contact{frame, 0.0, part, object, 0.0};
      }
    }
  }
  return std::nullopt;
}

std::optional<Contact> MotionCheck::all(bool any) {
  const int frames = poses_.size();
  for (int frame = 0; frame < frames; ++frame) {
    if (frame % kAhead == 0) prepare(frame);
    const std::optional<Contact> here = checkFrame(frame);
    if (any && here) return here;
    // What happens before this frame comes first, unless it is the same contact, whose beginning it
    // is then.
    if (frame > 0) {
      const std::optional<Contact> before = checkInterval(frame - 1);
      if (before) return before;
    }
    if (here) return here;
  }
  return std::nullopt;
}

void MotionCheck::prepare(int frame) {
  const int last = std::min(frame + kAhead, poses_.size() - 1);
  place(frame, last + 1, 1);
  world_.track.measure(poses_, frame, last, scratch_.capsules, scratch_.motions, scratch_.lanes);
  const int parts = world_.parts(), end = std::min(frame + kAhead, poses_.size());
  const int cells = (end - frame) * parts;
  std::fill_n(&scratch_.freeAround(frame, 0), cells, FreeAround{});
  double* const way = &scratch_.way(frame, 0);
  const double* const near = &scratch_.motions.nears[static_cast<size_t>(frame) * parts];
  std::fill_n(way, parts, 0.0);
  for (int i = parts; i < cells; ++i) way[i] = way[i - parts] + 2.0 * near[i - parts];
  for (int part = 0; part < parts; ++part) clearSpan(frame, end, part, {});
}

// Marks of what a part is free at frames [first, end) and in the intervals beside them. Soles are
// near the ground: for them it is not asked about here.
// @param known  what is marked already
void MotionCheck::clearSpan(int first, int end, int part, const FreeAround& known) {
  const int middle = (first + end) / 2;
  const bool is_sole = world_.body.parts[part].sole >= 0;
  double near = 0.0;
  const int begin = std::max(0, first - 1), intervals = std::min(end, poses_.size() - 1) - begin;
  const double* own = &scratch_.motions.nears[static_cast<size_t>(begin) * world_.parts() + part];
  for (int i = 0; i < intervals; ++i, own += world_.parts()) near = std::max(near, *own);
  const double way = std::max(scratch_.way(middle, part) - scratch_.way(first, part),
                              scratch_.way(end - 1, part) - scratch_.way(middle, part));
  const Capsule swept = scratch_.capsule(middle, part).inflated(way + near);
  const FreeAround free = {
      known.obstacles || world_.layers.isFree(swept, is_sole ? kSoleDepth : 0.0),
      known.ground || (!is_sole && world_.layers.ground().isAbove(swept, 0.0))};
  if (free.obstacles != known.obstacles || free.ground != known.ground)
    for (int i = first; i < end; ++i) scratch_.freeAround(i, part) = free;
  if ((free.obstacles && (free.ground || is_sole)) || end - first <= kShortSpan) return;
  for (int i = first; i < end; i += kShortSpan)
    clearSpan(i, std::min(i + kShortSpan, end), part, free);
}

// Leaves in freeAround of what a part is free as far as it moves in the intervals beside the frame,
// where spans have not told. In those soles may be no less deep than at the frame.
std::optional<Contact> MotionCheck::checkFrame(int frame) {
  std::optional<Contact> found;
  const bool has_before = frame > 0, has_after = frame + 1 < poses_.size();
  const GroundLayer& ground = world_.layers.ground();
  for (int part = 0; part < world_.parts(); ++part) {
    FreeAround& free = scratch_.freeAround(frame, part);
    int object = -1;
    if (!free.all()) {
      const Capsule& capsule = scratch_.capsule(frame, part);
      const double near = std::max(has_before ? scratch_.near(frame - 1, part) : 0.0,
                                   has_after ? scratch_.near(frame, part) : 0.0);
      const double depth = world_.allowedDepth(part, soles_[frame], soles_[frame]);
      const Capsule around = capsule.inflated(near);
      if (!free.obstacles)
        free.obstacles = world_.layers.touchedObstacle(around, depth, *scratch_.exact) < 0;
      if (!free.ground) {
        const bool is_sole = world_.body.parts[part].sole >= 0;
        free.ground = is_sole ? ground.isAbove(around, depth) : ground.isFree(around, depth);
      }
      if (!free.obstacles) object = world_.layers.touchedObstacle(capsule, depth, *scratch_.exact);
      if (object < 0 && !free.ground) object = ground.touched(capsule, depth, *scratch_.exact);
    }
    if (object < 0 && part == world_.body.head)
      object = world_.touchedCrown(placed(frame), scratch_);
    if (object >= 0 && !found) found = Contact{frame, 0.0, part, object, 0.0};
  }
  return found;
}

std::optional<Contact> MotionCheck::checkInterval(int frame) {
  std::optional<Contact> first;
  for (int part = 0; part < world_.parts(); ++part) {
    const FreeAround &here = scratch_.freeAround(frame, part),
                     &next = scratch_.freeAround(frame + 1, part);
    Task task{frame, part, !(here.obstacles && next.obstacles), !(here.ground && next.ground), 0.0};
    if (!task.obstacles && !task.ground) continue;
    task.depth = world_.allowedDepth(part, soles_[frame], soles_[frame + 1]);
    const Capsule &a = scratch_.capsule(frame, part), &b = scratch_.capsule(frame + 1, part);
    const PartMotion& motion = scratch_.motion(frame, part);
    if (task.ground) task.ground = !groundIsFree(task, a, b, motion, scratch_.near(frame, part));
    if (!task.obstacles && !task.ground) continue;
    const auto contact = prove(task, {0.0, a}, {1.0, b}, motion);
    if (contact && (!first || contact->between < first->between)) first = contact;
  }
  return first;
}

// By planes: a point of the part's axis leaves the straight line between its two places by `bend`
// at most. Where no plane parts it from the ground, as for obstacles.
bool MotionCheck::groundIsFree(const Task& task, const Capsule& a, const Capsule& b,
                               const PartMotion& motion, double near) const {
  if (world_.layers.ground().isClearBetween(a, b, task.depth, motion.bend)) return true;
  return world_.layers.ground().touched(a.inflated(near), task.depth, *scratch_.exact) < 0 &&
         world_.layers.ground().touched(b.inflated(near), task.depth, *scratch_.exact) < 0;
}

std::optional<Contact> MotionCheck::touchedAt(const Task& task, const Moment& moment,
                                              double near) const {
  const Capsule capsule = moment.capsule.inflated(near);
  int object =
      task.obstacles ? world_.layers.touchedObstacle(capsule, task.depth, *scratch_.exact) : -1;
  if (object < 0 && task.ground)
    object = world_.layers.ground().touched(capsule, task.depth, *scratch_.exact);
  if (object < 0) return std::nullopt;
  // t = 1 is the next frame.
  const bool next = moment.t >= 1.0;
  return Contact{task.frame + (next ? 1 : 0), next ? 0.0 : moment.t, task.part, object, 0.0};
}

// Halves the interval until each piece is proved free, or is so short that the part moves by less
// than kProofGap in it.
std::optional<Contact> MotionCheck::prove(const Task& task, const Moment& a, const Moment& b,
                                          const PartMotion& motion) const {
  const double near = motion.near(chordOf(a.capsule, b.capsule));
  Task left = task;
  if (task.obstacles)
    left.obstacles =
        world_.layers.touchedObstacle(a.capsule.inflated(near), task.depth, *scratch_.exact) >= 0 ||
        world_.layers.touchedObstacle(b.capsule.inflated(near), task.depth, *scratch_.exact) >= 0;
  if (task.ground) left.ground = !groundIsFree(task, a.capsule, b.capsule, motion, near);
  if (!left.obstacles && !left.ground) return std::nullopt;
  if (near < kProofGap) {
    for (const Moment& moment : {a, b}) {
      if (auto contact = touchedAt(left, moment, 0.0)) return contact;
    }
    for (const Moment& moment : {a, b}) {
      auto contact = touchedAt(left, moment, near);
      if (!contact) continue;
      contact->gap =
          world_.layers.nearestObstacle(moment.capsule, kProofGap, false, *scratch_.exact).distance;
      return contact;
    }
    return std::nullopt;
  }
  const double t = 0.5 * (a.t + b.t);
  const Moment middle{
      t, world_.placeBetween(poses_[task.frame], poses_[task.frame + 1], t, task.part, scratch_)};
  if (auto contact = touchedAt(left, middle, 0.0)) return contact;
  if (auto contact = prove(left, a, middle, motion.halved())) return contact;
  return prove(left, middle, b, motion.halved());
}

}  // namespace amble
