#include "animation/graph/support_state.h"

#include <gtest/gtest.h>

#include "tests/animation/planted_clip.h"

namespace amble {
namespace {

/// Letters: which feet stand, a frame each; `-` none.
std::string states(const std::string& drawn) {
  PlantedFrames planted;
  for (const char c : drawn) {
    planted[kLeft].push_back(c == 'L' || c == 'B');
    planted[kRight].push_back(c == 'R' || c == 'B');
  }
  std::string text;
  for (const SupportState state : supportStates(planted))
    text += std::string(kSupportNames[static_cast<int>(state)]) + " ";
  return text;
}

TEST(SupportState, OfNoFramesIsNone) { EXPECT_EQ(states(""), ""); }

TEST(SupportState, BothFeetAndNoneAreToldApartByTheFootBefore) {
  EXPECT_EQ(states("LBRBL"), "L LB R RB L ");
  EXPECT_EQ(states("L-R-L"), "L LN R RN L ");
}

TEST(SupportState, AJumpOffBothFeetIsN) { EXPECT_EQ(states("LB-BR"), "L LB N LB R "); }

TEST(SupportState, BeforeTheFirstFrameItIsAsWalksAndRunsHaveIt) {
  EXPECT_EQ(states("BR"), "LB R ");
  EXPECT_EQ(states("BL"), "RB L ");
  EXPECT_EQ(states("-L"), "RN L ");
  EXPECT_EQ(states("-B"), "N LB ");
  EXPECT_EQ(states("BB"), "LB LB ");
  EXPECT_EQ(states("--"), "N N ");
}

TEST(SupportState, AWalkGoesRoundItsFourStatesInOrderAndARunNeverHasBothFeetDown) {
  AMBLE_NEEDS_CAPTURES();
  const std::vector<SupportState> walk =
      supportStates(plantedClip("accad_female1/Female1_B03_Walk1.bvh").planted);
  for (size_t i = 1; i < walk.size(); ++i) {
    if (walk[i] == walk[i - 1]) continue;
    // The single foot is kept through the time on both.
    if (walk[i] == SupportState::kLB) {
      EXPECT_EQ(walk[i - 1], SupportState::kL);
    } else if (walk[i] == SupportState::kRB) {
      EXPECT_EQ(walk[i - 1], SupportState::kR);
    }
  }
  for (const SupportState state :
       supportStates(plantedClip("accad_male1/Male1_C03_Run.bvh").planted)) {
    EXPECT_NE(state, SupportState::kLB);
    EXPECT_NE(state, SupportState::kRB);
  }
}

}  // namespace
}  // namespace amble
