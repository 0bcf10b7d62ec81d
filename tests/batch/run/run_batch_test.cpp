#include "batch/run/run_batch.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>

#include "scenarios/run_scenario.h"
#include "tests/batch/small_job.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using RunBatch = SmallJob;

TEST_F(RunBatch, ShardsTheirOrderAndThreadsChangeNoByte) {
  const BatchJob walks = twoRooms("fps: 30\nways: {draw: 1, least: 2}\n");
  make(walks, "one");
  mergeBatch(walks, folder_ / "one", {});
  for (const int index : {3, 1, 2}) {
    BatchOptions options;
    options.shard = {index, 3};
    options.threads = 2;
    make(walks, "three", options);
  }
  mergeBatch(walks, folder_ / "three", {});
  const auto files = filesIn("one");
  EXPECT_EQ(files.size(), 6u * 5 + 3);  // bvh, report, labels x 2, row; index x 2, credits
  EXPECT_EQ(files, filesIn("three"));
}

TEST_F(RunBatch, AWalkIsThatOfAmblePlan) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  const BatchItem across = listItems(walks)[1];
  const WalkRow row = rows(walks, "out")[1];
  Scenario scenario = scenarioOf(walks, across);
  scenario.name = "walk-" + row.key;
  RunOptions how;
  how.frame_time = 1.0 / walks.fps;
  EXPECT_EQ(read(folder_ / "out" / BatchFolder::nameOf(row.key) / "walk.bvh"),
            runScenario(scenario, how).bvh);
  EXPECT_EQ(row.status, "solved");
}

TEST_F(RunBatch, GoesOnWhereItWasStopped) {
  const BatchJob walks = twoRooms();
  make(walks, "whole");
  std::atomic<bool> stop = false;
  BatchOptions options;
  options.stop = &stop;
  options.progress = [&](const BatchProgress& at) { stop = at.done == 2; };
  const BatchSummary first = make(walks, "parts", options);
  EXPECT_TRUE(first.stopped);
  EXPECT_EQ(first.made, 2);
  // As somebody who is killed leaves it: a folder that is half filled, with a file that is.
  const std::string key = rows(walks, "whole")[3].key;
  write("parts/" + BatchFolder::nameOf(key).string() + ".part-host-1-0/row.json", "{\"walk\": \"");
  const BatchSummary second = make(walks, "parts");
  EXPECT_EQ(second.kept, 2);
  EXPECT_EQ(second.made, 2);
  for (const char* name : {"parts", "whole"}) mergeBatch(walks, folder_ / name, {});
  EXPECT_EQ(filesIn("parts"), filesIn("whole"));
}

TEST_F(RunBatch, OfAChangedSceneRedoesItsOwnWalksAndLeavesNoStaleOnes) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  std::string scene = kScene;
  write("scene.yaml", scene.replace(scene.rfind("2.5"), 3, "2.4"));
  const BatchSummary again = make(walks, "out");
  EXPECT_EQ(again.kept, 2);
  EXPECT_EQ(again.made, 2);
  const MergeSummary merged = mergeBatch(walks, folder_ / "out", {});
  EXPECT_EQ(merged.swept, 2);
  make(walks, "fresh");
  mergeBatch(walks, folder_ / "fresh", {});
  EXPECT_EQ(filesIn("out"), filesIn("fresh"));
}

TEST_F(RunBatch, WhatIsWrongOrRefusedIsARowWithItsReason) {
  std::string walled = kScene;
  walled += "  - {name: wall, box: {size: [0.1, 3, 2.5]}, at: [1.5, 1.5, 1.25]}\n";
  write("walled.yaml", walled);
  write("broken.yaml", "objects:\n  - {name: a, box: {size: [1, 1]}}\n");
  const std::string way = "ways: [{start: {at: [0.8, 1.5]}, goal: {at: [5.2, 1.5]}}]}\n";
  const BatchJob walks =
      job("scenes:\n  - {scene: walled.yaml, " + way + "  - {scene: broken.yaml, " + way +
          "  - {scene: none.yaml, " + way + "  - {scene: scene.yaml, " + way + "fps: 30\n");
  const BatchSummary made = make(walks, "out");
  EXPECT_EQ(made.made_by_status,
            (std::map<std::string, int>{{"error", 2}, {"no_walk", 1}, {"solved", 1}}));
  const auto found = rows(walks, "out");
  EXPECT_EQ(found[0].rule, "disconnected");
  EXPECT_NE(found[0].reason.find("wall"), std::string::npos);
  EXPECT_TRUE(found[1].reason.starts_with("broken.yaml:2: ")) << found[1].reason;
  EXPECT_TRUE(found[2].reason.starts_with("job.yaml:4: the scene 'none.yaml'")) << found[2].reason;
}

TEST_F(RunBatch, OnASharedRoadmapWalksDoNotDependOnOneAnother) {
  const std::string how = "fps: 30\nplanner: {roadmap: shared}\n";
  const BatchJob two = twoRooms(how);
  const BatchJob one =
      job("scenes:\n  - {scene: other.yaml, ways: [{name: across, start: {at: [0.8, 1.5]}, "
          "goal: {at: [5.2, 1.5]}}]}\n" +
          how);
  make(two, "two");
  make(one, "one");
  for (const auto& [file, bytes] : filesIn("one")) EXPECT_EQ(filesIn("two").at(file), bytes);
}

TEST_F(RunBatch, ARunKnowsTheKeysThatMergingFinds) {
  const BatchJob walks = twoRooms();
  EXPECT_EQ(make(walks, "out").keys, keysOfItems(walks, listItems(walks), {}));
  BatchOptions second;
  second.shard = {2, 2};
  const std::vector<std::string> all = keysOfItems(walks, listItems(walks), {});
  EXPECT_EQ(make(walks, "half", second).keys, std::vector<std::string>(all.begin() + 2, all.end()));
}

// Memory of the process [bytes].
size_t resident() {
  std::ifstream in("/proc/self/statm");
  size_t all = 0, here = 0;
  in >> all >> here;
  return here * static_cast<size_t>(::getpagesize());
}

// What one scene with its walker takes is 10 MB.
TEST_F(RunBatch, MemoryDoesNotGrowFromSceneToScene) {
  constexpr int kScenes = 10, kWalks = 2;
  std::string scenes = "scenes:\n";
  for (int i = 0; i < kScenes; ++i) {
    std::string scene = kScene;
    scene.replace(scene.rfind("at: [3, 1.5"), 11, "at: [3, 0." + std::to_string(i));
    const std::string name = "scene-" + std::to_string(i) + ".yaml";
    write(name, scene);
    scenes += "  - {scene: " + name + ", ways: " + kWays + "}\n";
  }
  std::vector<size_t> sizes;  // as the second walk of each scene is done
  BatchOptions options;
  options.progress = [&](const BatchProgress& at) {
    if (at.done % kWalks == 0) sizes.push_back(resident());
  };
  make(job(scenes + "fps: 30\n"), "out", options);
  ASSERT_EQ(sizes.size(), static_cast<size_t>(kScenes));
  const auto half = sizes.begin() + kScenes / 2;
  const size_t first = *std::max_element(sizes.begin(), half),
               second = *std::max_element(half, sizes.end());
  EXPECT_LT(second, first + (size_t{4} << 20));
}

TEST_F(RunBatch, NothingIsMergedWhileWalksAreMissing) {
  const BatchJob walks = twoRooms();
  BatchOptions options;
  options.shard = {1, 2};
  make(walks, "out", options);
  EXPECT_EQ(mergeBatch(walks, folder_ / "out", {}).missing, 2);
  EXPECT_FALSE(fs::exists(folder_ / "out/index.csv"));
}

}  // namespace
}  // namespace amble
