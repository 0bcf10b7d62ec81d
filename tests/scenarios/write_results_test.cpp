#include "scenarios/write_results.h"

#include <unistd.h>

#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class WriteResults : public SmallRoom {
 protected:
  static RunResult solved() {
    RunResult result;
    result.report.status = PlanStatus::kSolved;
    result.bvh = "HIERARCHY\n";
    return result;
  }
  static ResultFile picture() {
    return {"top.svg", [](std::ostream& out) { out << "<svg/>"; }};
  }
};

TEST_F(WriteResults, AFolderThatIsAFileIsAnInputError) {
  RunResult result = solved();
  EXPECT_THROW(writeResults(result, folder_ / "scene.yaml"), InputError);
  EXPECT_THROW(writeResults(result, folder_ / "scene.yaml" / "deeper"), InputError);
  EXPECT_EQ(read(folder_ / "scene.yaml"), kScene);
}

TEST_F(WriteResults, AFolderThatMayNotBeWrittenIsAnInputError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directories(folder_ / "locked");
  fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  RunResult result = solved();
  EXPECT_THROW(writeResults(result, folder_ / "locked"), InputError);
  EXPECT_THROW(writeResults(result, folder_ / "locked" / "deeper"), InputError);
  fs::permissions(folder_ / "locked", fs::perms::owner_all);
}

TEST_F(WriteResults, AllFilesAreThereAndTheReportKnowsHowLongTheyTook) {
  RunResult result = solved();
  WriteOptions options;
  options.more = {picture()};
  writeResults(result, folder_ / "out" / "deeper", options);
  for (const char* name : {"walk.bvh", "top.svg", "report.json"}) {
    EXPECT_TRUE(fs::exists(folder_ / "out" / "deeper" / name)) << name;
  }
  EXPECT_EQ(read(folder_ / "out" / "deeper" / "walk.bvh"), result.bvh);
  EXPECT_GT(result.report.times.export_, 0.0);
}

TEST_F(WriteResults, WhenOneFailsNoneIsThereNorTheFolder) {
  RunResult result = solved();
  WriteOptions options;
  options.more = {picture(),
                  {"bad.svg", [](std::ostream& out) { out.setstate(std::ios::badbit); }}};
  EXPECT_THROW(writeResults(result, folder_ / "out" / "deeper", options), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(WriteResults, OnlyWhatIsAskedForIsWritten) {
  RunResult result = solved();
  WriteOptions options;
  options.bvh = false;
  writeResults(result, folder_ / "out", options);
  EXPECT_FALSE(fs::exists(folder_ / "out" / "walk.bvh"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "report.json"));
}

TEST_F(WriteResults, AResultIsOneSetOfOneRun) {
  RunResult result = solved();
  WriteOptions all;
  all.more = {picture()};
  all.names = {"walk.bvh", "report.json", "top.svg"};
  writeResults(result, folder_ / "out", all);
  write("out/notes.txt", "the user's own");
  WriteOptions walk_only = all;
  walk_only.json = false;
  walk_only.more.clear();
  result.bvh = "HIERARCHY 2\n";
  writeResults(result, folder_ / "out", walk_only);
  EXPECT_EQ(read(folder_ / "out" / "walk.bvh"), result.bvh);
  EXPECT_FALSE(fs::exists(folder_ / "out" / "report.json"));
  EXPECT_FALSE(fs::exists(folder_ / "out" / "top.svg"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "notes.txt"));
}

TEST_F(WriteResults, AnEarlierSetStaysWhereTheNewOneFails) {
  RunResult result = solved();
  writeResults(result, folder_ / "out");
  WriteOptions bad;
  bad.json = false;
  bad.more = {{"bad.svg", [](std::ostream& out) { out.setstate(std::ios::badbit); }}};
  RunResult other = solved();
  other.bvh = "other";
  EXPECT_THROW(writeResults(other, folder_ / "out", bad), InputError);
  EXPECT_EQ(read(folder_ / "out" / "walk.bvh"), result.bvh);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "report.json"));
}

TEST_F(WriteResults, AnEarlierWalkIsNotTakenForThisOnes) {
  RunResult result = solved();
  writeResults(result, folder_ / "out");
  RunResult none;
  none.report.status = PlanStatus::kNoWalk;
  writeResults(none, folder_ / "out");
  EXPECT_FALSE(fs::exists(folder_ / "out" / "walk.bvh"));
  EXPECT_TRUE(holds(read(folder_ / "out" / "report.json"), "no_walk"));
}

}  // namespace
}  // namespace amble
