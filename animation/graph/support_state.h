/// On which feet somebody stands, and on which before (Shanbhag's thesis, §4.2.2): only frames of
/// one state are compared.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "animation/clips/blend_contacts.h"

namespace amble {

enum class SupportState : std::uint8_t {
  kL = 0,   ///< the left foot alone
  kLB = 1,  ///< both, and the one before was the left alone
  kLN = 2,  ///< none, and the left alone before
  kR = 3,   ///< the right foot alone
  kRB = 4,  ///< both, and the right alone before
  kRN = 5,  ///< none, and the right alone before
  kN = 6,   ///< none, and both before
};
inline constexpr int kSupportStates = 7;
/// As the thesis writes them.
inline constexpr std::array<const char*, kSupportStates> kSupportNames = {"L",  "LB", "LN", "R",
                                                                          "RB", "RN", "N"};

/// One a frame. Before a clip's first frame it is as what follows has it in a walk or a run: both
/// feet are down after the left alone where the right alone comes next, and so on; LB where both
/// stand all the time, N where none ever does. A flight between both feet and both is N, and when
/// they are down again the single foot before it counts.
std::vector<SupportState> supportStates(const PlantedFrames& planted);

}  // namespace amble
