#include "batch/job/batch_job.h"

#include "tests/batch/small_job.h"

namespace amble {
namespace {

using BatchJobFile = SmallJob;

TEST_F(BatchJobFile, WhatIsWrongInItIsToldByFileAndLine) {
  const auto error = [&](const std::string& text) { return inputError([&] { job(text); }); };
  const std::string scene = "scenes: [scene.yaml]\nways: {draw: 1}\n";
  EXPECT_NE(error(scene + "hights: [1.7]\n").find("job.yaml:3: "), std::string::npos);
  EXPECT_NE(error(scene + "hights: [1.7]\n").find("'heights'"), std::string::npos);
  EXPECT_NE(error(scene + "heights: [1.7, 3]\n").find("job.yaml:3: "), std::string::npos);
  EXPECT_NE(error(scene + "formats: [bvh, gif]\n").find("job.yaml:3: "), std::string::npos);
  EXPECT_NE(error(scene + "planner: {name: visbility}\n").find("'visibility'"), std::string::npos);
  EXPECT_NE(error("scenes: [none-*.yaml]\nways: {draw: 1}\n").find("job.yaml:1: no file"),
            std::string::npos);
}

TEST_F(BatchJobFile, ARangeIsToBeDrawnOf) {
  const std::string text = "scenes: [scene.yaml]\nways: {draw: 1}\nheights: {from: 1.5, to: 1.8}\n";
  EXPECT_NE(inputError([&] { job(text); }).find("job.yaml:3: a range has no product"),
            std::string::npos);
  EXPECT_EQ(job(text + "sample: 3\n").heights.range, std::pair(1.5, 1.8));
}

TEST_F(BatchJobFile, InEverySceneSomebodyWalks) {
  EXPECT_NE(inputError([&] { job("scenes: [scene.yaml]\n"); }).find("nobody walks"),
            std::string::npos);
  EXPECT_NO_THROW(twoRooms());
}

TEST_F(BatchJobFile, APatternTakesWhatItMatchesInTheOrderOfNames) {
  for (const char* name : {"rooms/b/room.yaml", "rooms/a/room.yaml", "rooms/a/other.txt"})
    write(name, kScene);
  const BatchJob found = job("scenes: [rooms/*/room.yaml]\nways: {draw: 1}\n");
  ASSERT_EQ(found.scenes.size(), 2u);
  EXPECT_EQ(found.scenes[0].name, "rooms/a/room.yaml");
  EXPECT_EQ(found.scenes[1].name, "rooms/b/room.yaml");
}

TEST_F(BatchJobFile, TwoWaysOfOneNameAreRefused) {
  const std::string way = "{name: in, start: {at: [1, 1]}, goal: {at: [2, 1]}}";
  const std::string text =
      "scenes:\n  - scene: scene.yaml\n    ways:\n      - " + way + "\n      - " + way + "\n";
  EXPECT_NE(inputError([&] { job(text); }).find("job.yaml:5: "), std::string::npos);
}

}  // namespace
}  // namespace amble
