#include "animation/synthesis/animation_buffer.h"

namespace amble {

void AnimationBuffer::append(const AnimationBuffer& next) {
  if (next.size() == 0) return;
  if (size() == 0) {
    *this = next;
    return;
  }
  const int offset = size() - 1;  // where next's first frame lies
  const double arc = states.back().arc - next.states.front().arc;
  poses.append(next.poses, 1, next.size() - 1);
  for (size_t i = 1; i < next.states.size(); ++i) {
    states.push_back(next.states[i]);
    states.back().arc += arc;
  }
  soles.insert(soles.end(), next.soles.begin() + 1, next.soles.end());
  for (Footprint print : next.footprints) {
    const bool goes_on = print.first_frame == 0;
    print.first_frame += offset;
    print.last_frame += offset;
    Footprint* before = nullptr;
    for (Footprint& ours : footprints) {
      if (goes_on && ours.side == print.side && ours.last_frame == offset) before = &ours;
    }
    if (before != nullptr) {
      before->last_frame = print.last_frame;
    } else {
      footprints.push_back(print);
    }
  }
}

void AnimationBuffer::markFootprints() {
  footprints.clear();
  soles.clear();
  std::array<int, 2> open = {-1, -1};  // index of the footprint that each foot stands on
  for (int i = 0; i < static_cast<int>(states.size()); ++i) {
    soles.push_back({solePhase(states[i].feet[kLeft]), solePhase(states[i].feet[kRight])});
    for (const Side side : {kLeft, kRight}) {
      const FootState& foot = states[i].feet[side];
      states[i].planted[side] = foot.planted();
      if (!foot.planted()) {
        open[side] = -1;
        continue;
      }
      if (open[side] < 0) {
        open[side] = static_cast<int>(footprints.size());
        footprints.push_back({side, foot.from.position, foot.from.heading, i, i, {}});
      }
      footprints[open[side]].last_frame = i;
    }
  }
}

}  // namespace amble
