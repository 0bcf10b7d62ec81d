#include "animation/graph/support_state.h"

namespace amble {
namespace {

// The foot that stood alone before the first frame, by what comes.
Side footBefore(const PlantedFrames& planted) {
  for (size_t i = 0; i < planted[kLeft].size(); ++i)
    if (planted[kLeft][i] != planted[kRight][i]) return planted[kLeft][i] ? kRight : kLeft;
  return kLeft;
}

// Whether a clip that begins in the air is to have left both feet: where it lands on both, or
// never.
bool leftBoth(const PlantedFrames& planted) {
  for (size_t i = 0; i < planted[kLeft].size(); ++i)
    if (planted[kLeft][i] || planted[kRight][i]) return planted[kLeft][i] && planted[kRight][i];
  return true;
}

}  // namespace

std::vector<SupportState> supportStates(const PlantedFrames& planted) {
  Side last = footBefore(planted);
  bool both = leftBoth(planted);
  std::vector<SupportState> states;
  states.reserve(planted[kLeft].size());
  for (size_t i = 0; i < planted[kLeft].size(); ++i) {
    const bool left = planted[kLeft][i], right = planted[kRight][i];
    if (left != right) {
      last = left ? kLeft : kRight;
      both = false;
      states.push_back(left ? SupportState::kL : SupportState::kR);
    } else if (left) {
      both = true;
      states.push_back(last == kLeft ? SupportState::kLB : SupportState::kRB);
    } else if (both) {
      states.push_back(SupportState::kN);
    } else {
      states.push_back(last == kLeft ? SupportState::kLN : SupportState::kRN);
    }
  }
  return states;
}

}  // namespace amble
