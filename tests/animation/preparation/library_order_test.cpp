// A library is the same in whatever order its motions were added.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "animation/preparation/motion_library_add.h"
#include "animation/preparation/prepare_again.h"
#include "base/error.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

// Heights go up and down once more with each walk that comes: so many roundings [m, rad, s]. Feet
// that somebody else's motions are carried over to are turned as often, and fits make more of it.
constexpr double kRounding = 1e-11, kOfOthers = 1e-6;

MotionRequest orderedRequest(MotionKind kind, const std::string& name, const std::string& clip,
                             bool mirrored = false) {
  MotionRequest request;
  request.name = mirrored ? name + "-mirrored" : name;
  request.kind = kind;
  request.file = sharedFolder() / "mocap" / clip;
  request.source = {clip, {0, 0}, mirrored, "none", "none"};
  return request;
}

/// Walks, turns and all else of one person, who is tilted by markers; a walk of somebody else, and
/// a mirrored one of each that may be.
std::vector<MotionRequest> everyKind() {
  using enum MotionKind;
  const std::string person = "accad_female1/Female1_";
  std::vector<MotionRequest> all = {
      orderedRequest(kWalk, "walk", person + "B03_Walk1.bvh"),
      orderedRequest(kWalk, "turn", person + "B09_WalkTurnLeft90.bvh"),
      orderedRequest(kWalk, "turn-right", person + "B12_WalkTurnRight90.bvh", true),
      orderedRequest(kWalk, "other", "cmu_mb2/07_01.bvh"),
      orderedRequest(kMovement, "carry", person + "B20_WalkWithBox.bvh"),
      orderedRequest(kPosture, "hold", person + "B20_WalkWithBox.bvh"),
      orderedRequest(kStart, "start", person + "B01_StandToWalk.bvh"),
      orderedRequest(kStop, "stop", person + "B02_WalkToStand.bvh", true),
      orderedRequest(kTurnOnSpot, "about", person + "B15_WalkTurnAround180.bvh")};
  for (MotionRequest& request : all) {
    if (request.kind == kPosture) request.frames = {0, 12};
  }
  return all;
}

MotionRequest standRequest() {
  return orderedRequest(MotionKind::kPosture, "stand", "accad_female1/Female1_A01_Stand.bvh");
}

/// Where the clips of all requests are.
LibraryCaptures captureFolders() { return {{sharedFolder() / "mocap"}, {}}; }

MotionLibrary libraryOf(const std::vector<MotionRequest>& requests) {
  MotionLibrary library;
  for (const MotionRequest& request : requests) addMotion(library, request);
  return library;
}

void append(const Eigen::MatrixXd& matrix, std::vector<double>& out) {
  out.insert(out.end(), matrix.data(), matrix.data() + matrix.size());
}

void append(const FootCycle& foot, std::vector<double>& out) {
  out.insert(out.end(), {foot.strike, foot.lift_off, foot.slip});
  for (const auto& part : {foot.progress, foot.height, foot.sideways, foot.roll, foot.yaw})
    out.insert(out.end(), part.begin(), part.end());
  out.insert(out.end(), foot.pitch.begin(), foot.pitch.end());
  out.insert(out.end(), foot.toes.begin(), foot.toes.end());
}

/// All that was prepared, but for the names.
std::vector<double> preparedIn(const Motion& motion) {
  const WalkCycle& cycle = motion.cycle;
  const TransitionSequence& sequence = motion.transition.sequence;
  std::vector<double> all = {cycle.speed,
                             cycle.turn_rate,
                             cycle.period,
                             cycle.step_width,
                             cycle.prints_left,
                             cycle.slide,
                             cycle.residual,
                             sequence.step_time,
                             sequence.advance,
                             sequence.sway,
                             motion.turn.angle,
                             motion.turn.duration,
                             motion.turn.twist,
                             motion.posture.root_height,
                             motion.posture.root_forward,
                             motion.posture.step_width};
  for (const Side side : {kLeft, kRight}) {
    append(cycle.feet[side], all);
    all.insert(all.end(), {cycle.foot_forward[side], cycle.toe_out[side],
                           cycle.foot_drops.value_or(std::array{0.0, 0.0})[side],
                           motion.posture.toe_out[side]});
  }
  append(sequence.swing, all);
  for (const Eigen::MatrixXd& matrix : {cycle.series.alpha, cycle.series.beta, sequence.spline,
                                        motion.turn.spline, motion.turn.turned})
    append(matrix, all);
  for (const Eigen::Quaterniond& q : motion.posture.rotations) append(q.coeffs(), all);
  return all;
}

void expectSame(const MotionLibrary& a, const MotionLibrary& b, double rounding = kRounding) {
  ASSERT_EQ(a.motions.size(), b.motions.size());
  for (int j = 0; j < a.skeleton.size(); ++j)
    EXPECT_LT((a.skeleton.joint(j).offset - b.skeleton.joint(j).offset).norm(), kRounding) << j;
  for (const Motion& motion : a.motions) {
    const Motion* other = b.find(motion.name);
    ASSERT_NE(other, nullptr) << motion.name;
    EXPECT_EQ(motion.source.frames, other->source.frames) << motion.name;
    EXPECT_EQ(motion.source.within, other->source.within) << motion.name;
    const std::vector<double> one = preparedIn(motion), same = preparedIn(*other);
    ASSERT_EQ(one.size(), same.size()) << motion.name;
    double off = 0.0;
    for (size_t i = 0; i < one.size(); ++i) off = std::max(off, std::abs(one[i] - same[i]));
    EXPECT_LT(off, motion.name == "other" ? kOfOthers : rounding) << motion.name;
  }
}

TEST(LibraryOrder, BehindItsStandALibraryIsTheSameWhateverCameFirst) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<MotionRequest> requests = everyKind();
  requests.insert(requests.begin(), standRequest());
  const MotionLibrary library = libraryOf(requests);
  std::reverse(requests.begin() + 1, requests.end());
  expectSame(library, libraryOf(requests));
  std::mt19937 random(7);
  for (int i = 0; i < 2; ++i) {
    std::shuffle(requests.begin() + 1, requests.end(), random);
    expectSame(library, libraryOf(requests));
  }
}

// Its `stand` is then the default library's, carried over to the rig of what came first.
TEST(LibraryOrder, BehindItsFirstMotionSoIsOneWithoutAStand) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<MotionRequest> requests = everyKind();
  std::rotate(requests.begin(), requests.begin() + 6, requests.end());
  const MotionLibrary library = libraryOf(requests);
  std::reverse(requests.begin() + 1, requests.end());
  expectSame(library, libraryOf(requests));
}

// Whether the walk was looked for in all of its clip or not.
TEST(LibraryOrder, AStandThatTakesTheBorrowedOnesPlaceIsAsGoodAsOneThatWasFirst) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<MotionRequest> requests = everyKind();
  requests.front().frames = {30, 110};
  MotionLibrary late = libraryOf(requests);
  ASSERT_TRUE(hasBorrowedStand(late));
  for (const Motion& motion : late.motions)
    EXPECT_EQ(problemOf(late, motion, captureFolders()), "") << motion.name;
  replaceStand(late, standRequest(), captureFolders());
  requests.insert(requests.begin(), standRequest());
  const MotionLibrary first = libraryOf(requests);
  expectSame(first, late, kOfOthers);  // this stand is taken onto the library's soles and back
  EXPECT_FALSE(hasBorrowedStand(late));
  for (size_t i = 0; i < late.motions.size(); ++i) {
    EXPECT_EQ(late.motions[i].name, first.motions[i].name);
    EXPECT_EQ(problemOf(late, late.motions[i], captureFolders()), "") << late.motions[i].name;
  }
}

// Carried over by the one that was borrowed, which is gone then.
TEST(LibraryOrder, SomebodyElsesStandThatTakesTheBorrowedOnesPlaceIsThatOfItsCapture) {
  AMBLE_NEEDS_CAPTURES();
  MotionLibrary library =
      libraryOf({orderedRequest(MotionKind::kWalk, "walk", "accad_male1/Male1_B3_Walk.bvh")});
  const Posture borrowed = library.stand();
  replaceStand(library, standRequest(), captureFolders());
  for (const Motion& motion : library.motions)
    EXPECT_EQ(problemOf(library, motion, captureFolders()), "") << motion.name;
  library.motions.front().posture = borrowed;
  EXPECT_EQ(problemOf(library, library.motions.front(), captureFolders()), "another posture");
}

TEST(LibraryOrder, AStandThatCannotTakeTheBorrowedOnesPlaceLeavesTheLibraryAsItIs) {
  AMBLE_NEEDS_CAPTURES();
  MotionLibrary library = libraryOf({everyKind().front()});
  library.motions.back().source.clip = "accad_female1/Female1_B20_WalkWithBox.bvh";
  const MotionLibrary before = library;
  EXPECT_THROW(replaceStand(library, standRequest(), captureFolders()), InputError);
  EXPECT_THROW(replaceStand(library, standRequest(), {{sharedFolder()}, {}}), InputError);
  MotionRequest moving = standRequest();
  moving.file = everyKind().front().file;
  EXPECT_THROW(replaceStand(library, moving, captureFolders()), InputError);
  expectSame(before, library);
}

TEST(LibraryOrder, AWalkThatWasTakenOutAndIsAddedAgainIsTheOneOfBefore) {
  AMBLE_NEEDS_CAPTURES();
  const std::vector<MotionRequest> requests = everyKind();
  const MotionLibrary library = libraryOf(requests);
  MotionLibrary again = library;
  for (const size_t i : {1, 7, 0}) {
    std::erase_if(again.motions,
                  [&](const Motion& motion) { return motion.name == requests[i].name; });
    addMotion(again, requests[i]);
  }
  expectSame(library, again);
}

TEST(LibraryOrder, WhatIsRefusedLeavesALibraryAsItIs) {
  AMBLE_NEEDS_CAPTURES();
  MotionLibrary library;
  const MotionRequest walk = everyKind().front();
  MotionRequest start = walk;
  start.kind = MotionKind::kStart;
  EXPECT_THROW(addMotion(library, start), InputError);
  EXPECT_EQ(library.skeleton.size(), 0);
  EXPECT_TRUE(library.motions.empty());
  addMotion(library, walk);
  const MotionLibrary before = library;
  start.name = "start";
  EXPECT_THROW(addMotion(library, start), InputError);
  expectSame(before, library);
}

}  // namespace
}  // namespace amble
