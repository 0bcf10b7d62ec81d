#include "animation/synthesis/motion_shares.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const FlatGround kGround;

struct Made {
  AnimationBuffer buffer;
  WalkResult result;
};

Made walkOf(const WalkSynthesizer& walker, double length) {
  const RootPath path = straightPath(length);
  Made made;
  made.result =
      walker.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, made.buffer);
  EXPECT_EQ(made.result.refused, WalkRule::kNone);
  return made;
}

double sumOf(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

// Of the motions of a kind.
double shareOf(const MotionShares& shares, const FrameState& state, MotionKind kind) {
  const std::vector<double> all = shares.at(state);
  double sum = 0.0;
  for (size_t i = 0; i < all.size(); ++i)
    if (shares.motions()[i][0]->kind == kind) sum += all[i];
  return sum;
}

MotionLibrary withoutSequences() {
  MotionLibrary library = defaultLibrary();
  for (Motion& motion : library.motions) {
    motion.transition.sequence = {};
    motion.turn = {};
  }
  return library;
}

TEST(MotionShares, SumToOneWhateverAWalkIsMadeOf) {
  const WalkSynthesizer walker(defaultLibrary(), kGround, {});
  const MotionShares shares(defaultLibrary(), walker);
  const RootPath path = circlePath(2.0, 1.5);
  AnimationBuffer buffer;
  ASSERT_EQ(walker.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, buffer)
                .refused,
            WalkRule::kNone);
  for (const FrameState& state : buffer.states) EXPECT_NEAR(sumOf(shares.at(state)), 1.0, 1e-12);
}

TEST(MotionShares, AWalkStandsStartsWalksStopsAndStands) {
  const WalkSynthesizer walker(defaultLibrary(), kGround, {});
  const MotionShares shares(defaultLibrary(), walker);
  const std::vector<FrameState> states = walkOf(walker, 6.0).buffer.states;
  EXPECT_EQ(shares.at(states.front())[0], 1.0);
  EXPECT_EQ(shares.at(states.back())[0], 1.0);
  double started = 1.0, stopped = 0.0;
  for (size_t i = 1; i + 1 < states.size(); ++i) {
    const double start = shareOf(shares, states[i], MotionKind::kStart);
    const double stop = shareOf(shares, states[i], MotionKind::kStop);
    EXPECT_LE(start, started) << i;
    EXPECT_GE(stop, stopped) << i;
    started = start, stopped = stop;
  }
  EXPECT_EQ(started, 0.0);
  EXPECT_EQ(stopped, 1.0);
  EXPECT_EQ(shareOf(shares, states[states.size() / 2], MotionKind::kWalk), 1.0);
}

// Rotation vectors are mixed linearly, and no joint is placed by how a hand is turned: where the
// captured start is joined to the walk does not depend on it.
TEST(MotionShares, AHandThatACapturedStartTurnsIsTurnedByItsShare) {
  const int hand = defaultLibrary().skeleton.find("LeftHand");
  ASSERT_GE(hand, 0);
  const Eigen::Vector3d turn(0.02, -0.01, 0.03);
  MotionLibrary turned = defaultLibrary();
  for (Motion& motion : turned.motions) {
    Eigen::MatrixXd& spline = motion.transition.sequence.spline;
    if (motion.kind == MotionKind::kStart && spline.size() > 0)
      spline.middleRows(3 + 3 * hand, 3).colwise() += turn;
  }
  const WalkSynthesizer walker(defaultLibrary(), kGround, {}), other(turned, kGround, {});
  const AnimationBuffer plain = walkOf(walker, 4.0).buffer, made = walkOf(other, 4.0).buffer;
  ASSERT_EQ(plain.size(), made.size());
  const MotionShares shares(defaultLibrary(), walker);
  const Eigen::Quaterniond reference = defaultLibrary().stand().rotations[hand];
  const auto vectorOf = [&](const AnimationBuffer& walk, int frame) -> Eigen::Vector3d {
    return logRotation(reference.conjugate() * walk.poses[frame].rotations[hand]);
  };
  int begun = 0;
  for (int i = 0; i < plain.size(); ++i) {
    if (shares.at(plain.states[i])[0] > 0.0) continue;  // it stands
    const double share = shareOf(shares, plain.states[i], MotionKind::kStart);
    begun += share > 0.0 ? 1 : 0;
    EXPECT_LT((vectorOf(made, i) - vectorOf(plain, i) - share * turn).norm(), 1e-9) << i;
  }
  EXPECT_GT(begun, 30);
}

TEST(MotionShares, WithoutCapturedStartsAWalkIsMixedWithStanding) {
  const MotionLibrary library = withoutSequences();
  const WalkSynthesizer walker(library, kGround, {});
  const MotionShares shares(library, walker);
  for (const auto& motions : shares.motions())
    EXPECT_TRUE(motions[0]->kind == MotionKind::kWalk || motions[0]->name == "stand");
  int between = 0;
  for (const FrameState& state : walkOf(walker, 4.0).buffer.states) {
    EXPECT_EQ(shares.at(state)[0], state.standing);
    between += state.standing > 0.0 && state.standing < 1.0 ? 1 : 0;
  }
  EXPECT_GT(between, 10);
}

}  // namespace
}  // namespace amble
