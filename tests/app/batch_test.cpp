// amble batch from outside: what its options do, and that whoever kills it finds the same bytes.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/app/options.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class BatchOptionsTest : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    write("in/job.yaml",
          "scenes:\n  - scene: room.yaml\n    ways:\n"
          "      - {name: short, start: {at: [1, 2]}, goal: {at: [2, 2]}}\n"
          "      - {name: shorter, start: {at: [1, 2]}, goal: {at: [1.8, 2]}}\n"
          "fps: 24\nformats: [bvh, labels]\n");
  }
  const std::string kJob = "in/job.yaml ";
  const std::string kOut = kJob + "-o out ";
};

TEST_F(BatchOptionsTest, AreAllTried) {
  expectEach(
      "batch",
      {{"--output", [&] { good("batch " + kJob + "-o a"); }},
       {"--memory",
        [&] {
          writeGrid();
          write("in/grid.yaml", "objects:\n  - {name: a, mesh: grid.obj, up: z}\n");
          write("in/large.yaml", "scenes: [grid.yaml]\nways: {draw: 1}\nfps: 24\n");
          good("batch in/large.yaml -o g --memory 1");
          EXPECT_NE(read("g/index.csv").find("memory"), std::string::npos) << read("g/index.csv");
        }},
       {"--shard",
        [&] {
          EXPECT_EQ(printed("batch " + kJob + "-o s --json --shard 2/2")["walks"], 1);
          EXPECT_FALSE(fs::exists(folder_ / "s/index.csv"));
          expectRefused("batch " + kOut + "--shard 3/2", {"3/2", "I/N, I from 1 to N"});
        }},
       {"--threads",
        [&] { EXPECT_EQ(printed("batch " + kJob + "-o t --json --threads 2")["made"], 2); }},
       {"--pack",
        [&] {
          good("batch " + kJob + "-o p --pack");
          EXPECT_TRUE(fs::exists(folder_ / "p/packs/00000.npz"));
        }},
       {"--json", [&] { EXPECT_EQ(printed("batch " + kJob + "-o j --json")["walks"], 2); }}});
}

TEST_F(BatchOptionsTest, OfItsSubcommandsAreAllTried) {
  good("batch " + kOut + "--shard 1/2");
  good("batch merge " + kOut, 1);
  EXPECT_EQ(printed("batch status " + kOut + "--json", 1)["there"], 1);
  good("batch " + kOut + "--shard 2/2");
  const auto common = [&](const std::string& command) {
    return Uses{{"--output", [=, this] { good(command + kJob + "-o out"); }},
                {"--memory", [=, this] { good(command + kOut + "--memory 500"); }},
                {"--json", [=, this] { printed(command + kOut + "--json"); }}};
  };
  expectAll("batch merge",
            {common("batch merge "), {{"--pack", [&] {
                                         good("batch merge " + kOut + "--pack");
                                         EXPECT_TRUE(fs::exists(folder_ / "out/packs/index.csv"));
                                       }}}});
  expectAll("batch status", {common("batch status ")});
  const std::string check = "batch check " + kOut + "--json ";
  expectAll("batch check",
            {common("batch check "),
             {{"--sample", [&] { EXPECT_EQ(printed(check + "--sample 1").size(), 1u); }},
              {"--seed", [&] { EXPECT_EQ(printed(check + "--seed 5").size(), 2u); }},
              {"--threads", [&] { EXPECT_EQ(printed(check + "--threads 2").size(), 2u); }}}});
}

TEST_F(BatchOptionsTest, WhatIsWrongInAJobIsToldBeforeAnyWork) {
  write("in/wrong.yaml", "scenes: [room.yaml]\nways: {draw: -1}\n");
  expectRefused("batch in/wrong.yaml -o out", {"in/wrong.yaml:2: "});
  expectRefused("batch in/none.yaml -o out", {"in/none.yaml"});
  expectRefused("batch -o out", {"JOB"});
}

TEST_F(BatchOptionsTest, WhatIsWrongWithTheInputOfWalksIsPrintedToo) {
  write("in/lost.yaml", "scenes: [lost-room.yaml]\nways: {draw: 3}\n");
  const Ran ran = good("batch in/lost.yaml -o out");
  EXPECT_NE(ran.out.find("error          3\n    3 x "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("lost-room.yaml"), std::string::npos) << ran.out;
}

TEST_F(BatchOptionsTest, WalksOfAnotherJobAreNotTakenAwayWithoutAWord) {
  EXPECT_EQ(good("batch " + kOut).out.find("taken away"), std::string::npos);
  write("in/other.yaml", "scenes: [room.yaml]\nways: {draw: 1}\nfps: 24\nformats: [bvh]\n");
  const Ran ran = good("batch in/other.yaml -o out");
  EXPECT_NE(ran.out.find("taken away     2 walks of another job or input\n"), std::string::npos)
      << ran.out;
}

TEST_F(BatchOptionsTest, AWalkWhoseRowIsDamagedIsMadeAgainOnceItsFolderIsDeleted) {
  good("batch " + kOut);
  const fs::path walk =
      fs::directory_iterator(*fs::directory_iterator(folder_ / "out/walks"))->path();
  std::ofstream(walk / "row.json").close();
  expectRefused("batch merge " + kOut, {"row.json:1: is no row of a batch", "delete its folder"});
  fs::remove_all(walk);
  EXPECT_EQ(printed("batch " + kOut + "--json")["made"], 1);
}

TEST_F(BatchOptionsTest, AWalkThatIsCutShortIsFoundAndMadeAgainOnceItsFolderIsDeleted) {
  good("batch " + kOut);
  const fs::path walk =
      fs::directory_iterator(*fs::directory_iterator(folder_ / "out/walks"))->path();
  fs::resize_file(walk / "walk.bvh", fs::file_size(walk / "walk.bvh") / 2);
  const std::string found = good("batch check " + kOut, 1).out;
  EXPECT_NE(found.find("made again when its folder is deleted"), std::string::npos) << found;
  fs::remove_all(walk);
  EXPECT_EQ(printed("batch " + kOut + "--json")["made"], 1);
  EXPECT_EQ(good("batch check " + kOut).out.find("deleted"), std::string::npos);
}

// Wherever it is killed.
TEST_F(BatchOptionsTest, KilledAgainAndAgainItLeavesTheBytesOfAnUndisturbedRun) {
  good("batch " + kJob + "-o whole --threads 1");
  const Ran ran = shell(
      "for t in 0.05 0.1 0.15 0.2 0.25 0.3; do"
      "  timeout -s KILL $t $AMBLE batch in/job.yaml -o parts --threads 1 >/dev/null 2>&1;"
      "  find parts -name row.json | while read row; do"
      "    [ \"$(tail -c 1 $row | wc -l)\" = 1 ] || echo half of $row; done;"
      " done; $AMBLE batch in/job.yaml -o parts --threads 1 >/dev/null && diff -r whole parts");
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
  EXPECT_EQ(ran.out, "");
}

}  // namespace
}  // namespace amble
