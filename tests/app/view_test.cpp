// amble view of captures and of libraries, from the outside. Pages in a browser: tests/app/pages.

#include <nlohmann/json.hpp>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

using nlohmann::json;

const std::string kViewed = captureFolder() + "cmu_mb2/07_01.bvh";
const std::string kRun = captureFolder() + "accad_female1/Female1_C03_Run.bvh";

class View : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    if (!std::filesystem::exists(kViewed)) GTEST_SKIP() << "no captures in " << AMBLE_SHARED;
  }
};

TEST_F(View, ABrokenClipAmongOthersIsSaidAndTheOthersAreShown) {
  write("in/broken.bvh", "HIERARCHY\nROOT hips\n[\n");
  const Ran ran = run("view in/broken.bvh " + kViewed + " -o page.html");
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("in/broken.bvh:3: "), std::string::npos) << ran.err;
  EXPECT_NE(read("page.html").find("07_01.bvh"), std::string::npos);
  expectRefused("view in/broken.bvh -o none.html", {"in/broken.bvh:3: "});
}

TEST_F(View, JsonSaysOfClipsWhatAnalyseSays) {
  const Ran ran = run("view --json " + kViewed + " " + kRun);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json clips = json::parse(ran.out);
  const json analysed = json::parse(run("analyse --json " + kViewed + " " + kRun).out);
  ASSERT_EQ(clips.size(), 2u);
  for (size_t i = 0; i < clips.size(); ++i) {
    for (const auto& [key, value] : clips[i]["analysis"].items())
      EXPECT_EQ(value, analysed[i][key]) << key;
    EXPECT_EQ(clips[i]["warnings"], analysed[i]["warnings"]);
    EXPECT_EQ(clips[i]["root"]["x"].size(), analysed[i]["frames"]);
  }
  EXPECT_TRUE(files().empty());  // no page was asked for
}

class ViewOfRun : public InRoom {};

// As `amble view out/NAME` does: the page that came with the run, or one made of its walk.
TEST_F(ViewOfRun, AFolderThatHoldsOneRunIsThatRun) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out/one --formats bvh,json,html").status, 0);
  const Ran whole = run("view out");
  EXPECT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.out, run("view out/one").out);
  EXPECT_EQ(whole.out.find("out/one/walk.html"), 0u) << whole.out;
  std::filesystem::remove(folder_ / "out/one/walk.html");
  ASSERT_EQ(run("view out --scene in/room.yaml -o made.html").status, 0);
  ASSERT_EQ(run("view out/one --scene in/room.yaml -o same.html").status, 0);
  EXPECT_EQ(read("made.html"), read("same.html"));
  EXPECT_NE(read("made.html").find("\"objects\":[\""), std::string::npos);  // in its room
}

TEST_F(ViewOfRun, SeveralRunsOrOtherClipsBesideOneAreCaptures) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out/one --formats bvh,json").status, 0);
  write("out/clips/other.bvh", read("out/one/walk.bvh"));
  ASSERT_EQ(run("view out -o both.html").status, 0);
  EXPECT_NE(read("both.html").find("other.bvh"), std::string::npos);
  std::filesystem::rename(folder_ / "out/clips", folder_ / "clips");
  ASSERT_EQ(run("plan in/scenario.yaml -o out/two --formats bvh,json").status, 0);
  ASSERT_EQ(run("view out -o two.html").status, 0);
  EXPECT_NE(read("two.html").find("\"title\":\"2 clips\""), std::string::npos);
}

TEST_F(ViewOfRun, ARunWithoutAWalkIsShownAsItsPage) {
  wallOff();
  ASSERT_EQ(run("plan in/scenario.yaml -o out/none --formats json,html").status, 1);
  const Ran shown = run("view out");
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.out.find("out/none/walk.html"), 0u) << shown.out;
}

// What captured numbers say: both strikes of a step are moments of the gait.
TEST_F(View, JsonHasAPhaseThatGoesWithTheStrikes) {
  const json clip = json::parse(run("view --json " + kViewed).out)[0];
  const double frame_time = clip["frame_time"];
  ASSERT_GE(clip["phase"].size(), 2u);
  for (const json& moment : clip["phase"]) {
    double nearest = 1.0;
    for (const json& plant : clip["analysis"]["plants"])
      nearest = std::min(
          nearest, std::abs(plant["strike"].get<double>() - moment[0].get<double>() * frame_time));
    EXPECT_LT(nearest, 0.12);
  }
}

TEST_F(View, ALibraryIsShownWithTheCapturesThatItIsOf) {
  const std::string library = std::string(AMBLE_SOURCE_DIR) + "/animation/motions/default.yaml";
  const Ran with = run("view --json " + library + " --captures " + captureFolder());
  ASSERT_EQ(with.status, 0) << with.err;
  for (const json& motion : json::parse(with.out)["library"]["motions"]) {
    EXPECT_FALSE(motion.contains("lacking")) << motion["lacking"];
    if (!motion.contains("cycle")) continue;
    EXPECT_EQ(motion["cycle"]["joints"][0]["x"]["captured"].size(), motion["measures"]["cycles"]);
  }
  const Ran without = run("view " + library + " --captures nowhere -o library.html");
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_NE(read("library.html").find("is not there: --captures DIR"), std::string::npos);
}

TEST_F(View, WhatIsNoLibraryIsRefused) {
  write("in/scene.yaml", "objects: []\n");
  const auto toldAs = [&](const std::string& what, const std::string& yaml) {
    write("in/it.yaml", yaml);
    expectRefused("view in/it.yaml", {"in/it.yaml:1: is " + what + ", which ",
                                      "; expected a folder of results, captures, a motion"});
  };
  toldAs("a scene", "objects: []\n");
  toldAs("a scenario", "scene: room.yaml\n");
  toldAs("a speed engine", "mean_posture: {}\n");
  toldAs("a job of many walks", "scenes: [room.yaml]\n");
  expectRefused("view --json -o - " + kViewed, {"--json: ", "-o FILE"});
}

}  // namespace
}  // namespace amble
