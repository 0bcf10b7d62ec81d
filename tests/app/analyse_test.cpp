// amble analyse and amble library find, from the outside.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

using nlohmann::json;

const std::string kFolders = captureFolder();
const std::string kCmuWalk = kFolders + "cmu_mb2/07_01.bvh";

class Analyse : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    if (!std::filesystem::exists(kCmuWalk)) GTEST_SKIP() << "no captures in " << AMBLE_SHARED;
  }
};

TEST_F(Analyse, ABrokenClipAmongOthersIsSaidAndTheOthersAreAnalysed) {
  write("in/broken.bvh", "HIERARCHY\nROOT hips\n[\n");
  const Ran ran = run("analyse in/broken.bvh " + kCmuWalk);
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("in/broken.bvh:3: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("07_01.bvh"), std::string::npos) << ran.out;
  const Ran machine = run("analyse --json in/broken.bvh " + kCmuWalk);
  EXPECT_EQ(machine.status, 2);
  EXPECT_EQ(json::parse(machine.out).size(), 1u);
}

TEST_F(Analyse, OneFileForSeveralClipsIsRefused) {
  expectRefused("analyse --plot a.svg " + kCmuWalk + " " + kCmuWalk, {"--plot a.svg: ", "{stem}"});
  expectRefused("analyse --plants out/ " + kCmuWalk + " " + kCmuWalk,
                {"--plants out/: ", "07_01.csv"});
  std::filesystem::create_directories(folder_ / "empty");
  expectRefused("analyse empty", {"empty: holds no clips; expected "});
}

TEST_F(Analyse, PlantsAreARowAFrameOfTheFile) {
  const Ran ran = run("analyse --json --plants plants.csv " + kCmuWalk);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json clip = json::parse(ran.out)[0];
  std::istringstream rows(read("plants.csv"));
  std::string line;
  std::getline(rows, line);
  EXPECT_EQ(line, "frame,left,right");
  int frame = 0;
  for (; std::getline(rows, line); ++frame) {
    int at = -1, left = -1, right = -1;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d", &at, &left, &right), 3) << line;
    EXPECT_EQ(at, frame);
    for (const auto& [foot, planted] : {std::pair("left", left), std::pair("right", right)}) {
      const bool said = std::any_of(
          clip["plants"].begin(), clip["plants"].end(), [&, foot = foot](const json& plant) {
            return plant["foot"] == foot && plant["first_frame"] <= frame &&
                   frame <= plant["last_frame"];
          });
      EXPECT_EQ(planted, said ? 1 : 0) << line;
    }
  }
  EXPECT_EQ(frame, clip["frames"]);
  // The T-pose in front is no motion.
  EXPECT_EQ(clip["first_frame"], 1);
}

TEST_F(Analyse, SaysWhatThereIsInAClip) {
  const Ran ran = run("analyse --json --plot feet.svg " + kCmuWalk);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json clip = json::parse(ran.out)[0];
  EXPECT_EQ(clip["class"]["type"], "walk");
  EXPECT_EQ(clip["class"]["share"]["walk"], 1.0);
  EXPECT_NEAR(clip["gait"]["speed"].get<double>(), 1.37, 0.05);
  EXPECT_NEAR(
      clip["gait"]["normalised_speed"].get<double>() * clip["gait"]["leg_length"].get<double>(),
      clip["gait"]["speed"].get<double>(), 1e-9);
  EXPECT_TRUE(clip["frequency_law"]["inman_bias"].is_number());
  ASSERT_FALSE(clip["events"].empty());
  for (const json& event : clip["events"]) {
    if (event["lift"].is_null() || event["strike"].is_null()) continue;
    EXPECT_LE(event["lift"], event["lift_off"]);
    EXPECT_LT(event["lift_off"], event["strike"]);
    EXPECT_LE(event["strike"], event["landing"]);
  }
  EXPECT_NE(read("feet.svg").find("\n<svg "), std::string::npos);
}

TEST_F(Analyse, ManyClipsGiveTheSameBytesAtAnyNumberOfThreads) {
  const std::string folders = kFolders + "accad_male1 " + kFolders + "cmu_max ";
  const Ran one = run("analyse --json --threads 1 --plants one/ " + folders);
  const Ran two = run("analyse --json --threads 2 --plants 'two/{stem}.csv' " + folders);
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  const size_t clips = json::parse(one.out).size();
  EXPECT_GE(clips, 10u);
  EXPECT_EQ(files().size(), 2 * clips);
  EXPECT_EQ(read("one/Male1_B3_Walk.csv"), read("two/Male1_B3_Walk.csv"));
}

TEST_F(Analyse, SeveralClipsAreATableAndALawOfTheirSubject) {
  const Ran ran = run("analyse " + kFolders + "cmu_mb2/07_0[1236].bvh");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1 + 4 + 1) << ran.out;
  EXPECT_NE(ran.out.find("4 walks: f = "), std::string::npos) << ran.out;
}

TEST_F(Analyse, FindsClipsByHowMuchOfThemIsOfAType) {
  const std::string some = kCmuWalk + " " + kFolders + "cmu_mb2/09_01.bvh " + kFolders +
                           "accad_female1/Female1_C05_WalkToRun.bvh ";
  const Ran walks = run("library find --type walk --at-least 75% --json " + some);
  ASSERT_EQ(walks.status, 0) << walks.err;
  const json found = json::parse(walks.out);
  ASSERT_EQ(found.size(), 2u);  // the largest share first
  EXPECT_EQ(found[0]["name"], kCmuWalk);
  EXPECT_EQ(found[0]["share"], 1.0);
  EXPECT_GE(found[1]["share"], 0.75);
  EXPECT_EQ(json::parse(run("library find --type walk --at-least 1.0 --json " + some).out).size(),
            1u);
  EXPECT_EQ(run("library find --type jump " + some).status, 1);
}

TEST_F(Program, ALibrarysMotionsAreFoundByTheirKind) {
  const Ran ran = run("library find --type walk --at-least 75%");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find(": walk-"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find(": stand ("), std::string::npos);
  EXPECT_EQ(run("library find --type jump").status, 1);
  expectRefused("library find", {"--type"});
  expectRefused("library find --type walk --at-least 175%", {"175%", "expected 0% to 100%"});
  expectRefused("library find --type stroll", {"stroll"});
}

}  // namespace
}  // namespace amble
