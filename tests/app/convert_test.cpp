// `amble convert` and what the other commands take of captures, from the outside.
#include <nlohmann/json.hpp>

#include "animation/captures/motion_reader.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/mirror_clip.h"
#include "animation/clips/resample_clip.h"
#include "tests/animation/captures.h"
#include "tests/animation/node_files.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"
#include "tests/app/program.h"

namespace amble {
namespace {

using nlohmann::json;

class Convert : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    std::filesystem::create_directories(folder_ / "in");
    writeInAxes(folder_ / "in/walk.bvh", walk_, 0.01, UpAxis::kY);
  }
  Clip written(const std::string& name) const { return readBvh(folder_ / name); }
  /// Largest distance of joints of the same index in frames of the same number [m].
  static double farthest(const Clip& a, const Clip& b) {
    EXPECT_EQ(a.frames(), b.frames());
    EXPECT_EQ(a.skeleton.size(), b.skeleton.size());
    double worst = 0.0;
    for (int i = 0; i < std::min(a.frames(), b.frames()); ++i) {
      const std::vector<JointFrame> x = jointFrames(a, i), y = jointFrames(b, i);
      for (size_t j = 0; j < x.size(); ++j) {
        worst = std::max(worst, (x[j].p_WJ - y[j].p_WJ).norm());
      }
    }
    return worst;
  }

  const Clip walk_ = walkingPerson();
};

TEST_F(Convert, RefusesWhatCannotBeDone) {
  expectRefused("convert in/walk.bvh", {"--output"});
  expectRefused("convert none.bvh -o out.bvh", {"none.bvh: ", "; expected "});
  expectRefused("convert in/walk.bvh -o out.fbx", {"out.fbx: ", "; expected .bvh"});
  for (const char* const trim : {"5", "5:2", "0:61", "a:b", "1.5:3", "0s:99s", "-1:3", "nans:1s"}) {
    expectRefused(std::string("convert in/walk.bvh -o out.bvh --trim ") + trim,
                  {"--trim: ", "; expected "});
  }
  expectRefused("convert in/walk.bvh -o out.bvh --fps 0", {"--fps"});
  write("in/roles.yaml", "hips: Hipps\n");
  expectRefused("convert in/walk.bvh -o out.bvh --roles in/roles.yaml",
                {"roles.yaml:1: ", "'Hipps'", "'Hips'"});
  write("in/walk.amc", "1\n");
  expectRefused("convert in/walk.amc -o out.bvh", {"walk.amc: no .asf", "--asf"});
}

TEST_F(Convert, NothingThatIsReadIsWrittenOver) {
  const std::string before = read("in/walk.bvh");
  std::filesystem::create_symlink("in/walk.bvh", folder_ / "link.bvh");
  for (const char* const out : {"in/walk.bvh", "./in/../in/walk.bvh", "link.bvh"}) {
    expectRefused(std::string("convert in/walk.bvh -o ") + out, {out, "is read too"});
    expectRefused(std::string("convert - -o ") + out + " < in/walk.bvh", {out, "is read too"});
    expectRefused(std::string("analyse in/walk.bvh --plants ") + out, {out, "is read too"});
    expectRefused(std::string("analyse in/walk.bvh --plot ") + out, {out, "is read too"});
  }
  EXPECT_EQ(read("in/walk.bvh"), before);
  EXPECT_EQ(run("convert link.bvh -o other.bvh").status, 0);
}

TEST_F(Convert, ATakeOfAFormatWithoutTakesIsTold) {
  const Ran ran = run("convert in/walk.bvh -o out.bvh --take foo");
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.err.find("'foo'"), std::string::npos) << ran.err;
}

TEST_F(Convert, OfAClipWithoutStepsNothingOfStepsIsMeasured) {
  Clip still = walk_;
  for (int i = 1; i < still.frames(); ++i) {
    still.poses.p_WR(i) = still.poses.p_WR(0);
    std::ranges::copy(still.poses.rotations(0), still.poses.rotations(i).begin());
  }
  writeInAxes(folder_ / "in/still.bvh", still, 0.01, UpAxis::kY);
  const Ran machine = run("analyse in/still.bvh --json"), people = run("analyse in/still.bvh");
  ASSERT_EQ(machine.status, 0) << machine.err;
  const json gait = json::parse(machine.out)[0]["gait"];
  for (const char* measure : {"cadence", "step_length", "step_time", "lift", "stride_length"}) {
    EXPECT_TRUE(gait.at(measure).is_null()) << measure;
  }
  EXPECT_NE(people.out.find("- steps a minute"), std::string::npos) << people.out;
  EXPECT_NE(people.out.find("0: - m long"), std::string::npos) << people.out;
}

TEST_F(Convert, WritesTheMotionInMetresAndSaysWhatItGuessed) {
  const Ran ran = run("convert in/walk.bvh -o out.bvh");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("unit        0.01 m, guessed: legs of 0.92 m"), std::string::npos)
      << ran.out;
  EXPECT_LT(farthest(written("out.bvh"), walk_), 1e-5);
  ASSERT_EQ(run("convert in/walk.bvh -o cm.bvh --bvh-units cm").status, 0);
  EXPECT_EQ(read("cm.bvh").substr(0, 9), "HIERARCHY");
  EXPECT_LT(farthest(readBvh(folder_ / "cm.bvh", {.metres_per_unit = 0.01}), walk_), 1e-5);
}

TEST_F(Convert, AGlbIsReadAsTheMotionItself) {
  ASSERT_EQ(run("convert in/walk.bvh -o out.glb --trim 10:40").status, 0);
  const Ran ran = run("convert out.glb -o back.bvh --file-fps 30");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_LT(farthest(written("back.bvh"), trimmed(walk_, 10, 40)), 1e-4);
}

TEST_F(Convert, CutsResamplesAndMirrors) {
  ASSERT_EQ(run("convert in/walk.bvh -o out.bvh --trim 10:40 --fps 60").status, 0);
  EXPECT_LT(farthest(written("out.bvh"), resampleClip(trimmed(walk_, 10, 40), 1.0 / 60.0)), 1e-5);
  ASSERT_EQ(run("convert in/walk.bvh -o seconds.bvh --trim 0.5s:").status, 0);
  EXPECT_LT(farthest(written("seconds.bvh"), trimmed(walk_, 15, 60)), 1e-5);
  ASSERT_EQ(run("convert in/walk.bvh -o mirrored.bvh --mirror").status, 0);
  const JointRoles roles = rolesByName(walk_.skeleton);
  EXPECT_LT(farthest(written("mirrored.bvh"), mirrorClip(walk_, roles)), 1e-5);
}

TEST_F(Convert, TakesWhatIsSaidOfTheFile) {
  const Ran ran = run("convert in/walk.bvh -o out.bvh --unit 0.02 --up z --facing 90");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("0.02 m, as asked"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("z, as asked"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("90.0 degrees, as asked"), std::string::npos) << ran.out;
}

TEST_F(Convert, IsAFilter) {
  const Ran ran = run("convert - -o - < in/walk.bvh");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.substr(0, 9), "HIERARCHY");
  EXPECT_NE(ran.err.find("unit "), std::string::npos);
  write("again.bvh", ran.out);
  EXPECT_EQ(run("convert - -o - < again.bvh").out, ran.out) << "a second time changes nothing";
}

TEST_F(Convert, EveryFormatGivesTheSameMotion) {
  write("in/walk.gltf", gltfOf(walk_));
  write("in/walk.dae", colladaOf(walk_, 0.0254, true));
  write("in/walk.fbx", fbxOf(walk_, {0.01, false}));
  for (const char* const format : {"gltf", "dae", "fbx"}) {
    const std::string name = format;
    const Ran ran = run("convert in/walk." + name + " -o " + name + ".bvh");
    ASSERT_EQ(ran.status, 0) << ran.err;
    const Clip copy = written(name + ".bvh");
    ASSERT_EQ(copy.frames(), walk_.frames());
    for (int i = 0; i < copy.frames(); ++i) {
      const std::vector<JointFrame> a = jointFrames(walk_, i), b = jointFrames(copy, i);
      for (int j = 0; j < walk_.skeleton.size(); ++j) {
        const int other = copy.skeleton.find(walk_.skeleton.joint(j).name);
        ASSERT_GE(other, 0);
        EXPECT_LT((a[j].p_WJ - b[other].p_WJ).norm(), 1e-3) << name;
      }
    }
    EXPECT_EQ(run("inspect in/walk." + name).status, 0);
  }
}

TEST_F(Convert, AThingThatIsNoPersonIsConvertedButNotMirrored) {
  Generator generator(2);
  writeBvh(folder_ / "in/snake.bvh", randomClip(generator, 7, 3));
  const Ran ran = run("convert in/snake.bvh -o out.bvh");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("no person"), std::string::npos) << ran.err;
  expectRefused("convert in/snake.bvh -o mirrored.bvh --mirror",
                {"snake.bvh: no joint looks like"});
}

TEST_F(Convert, AFrameRateThatIsSaidHoldsForABvhToo) {
  ASSERT_EQ(run("convert in/walk.bvh -o out.bvh --file-fps 120").status, 0);
  EXPECT_NEAR(written("out.bvh").frame_time, 1.0 / 120.0, 1e-7);
  EXPECT_EQ(written("out.bvh").frames(), walk_.frames());
  expectRefused("convert in/walk.bvh -o out.bvh --file-fps 10000", {"--file-fps", "1 to 1000"});
  expectRefused("convert in/walk.bvh -o out.bvh --fps 10000", {"--fps", "1 to 1000"});
}

TEST_F(Convert, WhatHasNoEndIsRefusedAtItsLimit) {
  expectRefused("convert - -o out.bvh < /dev/zero", {"-: is larger than 400 MiB; expected a BVH"});
}

TEST_F(Convert, InspectSaysWhatIsGuessedAndWhatNot) {
  const Ran ran = run("inspect in/walk.bvh --json --up y");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json clip = json::parse(ran.out)[0];
  EXPECT_EQ(clip["unit"]["metres"], 0.01);
  EXPECT_EQ(clip["unit"]["guessed"], true);
  EXPECT_EQ(clip["up"]["guessed"], false);
  EXPECT_EQ(clip["roles"]["left_foot"], "LeftFoot");
  EXPECT_TRUE(clip["warnings"].empty()) << clip["warnings"];
  const std::string text = run("inspect in/walk.bvh").out;
  EXPECT_NE(text.find("left leg   LeftUpLeg > LeftLeg > LeftFoot > LeftToeBase\n"),
            std::string::npos)
      << text;
  write("in/roles.yaml", "left_toe: none\n");
  EXPECT_NE(run("inspect in/walk.bvh --roles in/roles.yaml").out.find("LeftFoot > -\n"),
            std::string::npos);
}

TEST_F(Convert, TakesOfAFileAreChosenByName) {
  const auto file = sharedFolder() / "cases/captures/g4_idle_and_walk.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const std::string in = "convert '" + file.string() + "' -o out.bvh";
  const Ran walk = run(in);
  ASSERT_EQ(walk.status, 0) << walk.err;
  EXPECT_NE(walk.err.find("'Walk' is read, in which most moves"), std::string::npos) << walk.err;
  EXPECT_EQ(written("out.bvh").frames(), 121);
  ASSERT_EQ(run(in + " --take Idle").status, 0);
  EXPECT_EQ(written("out.bvh").frames(), 400);
}

TEST_F(Convert, AHostileFrameTimeIsOneLineForEveryCommand) {
  const auto folder = sharedFolder() / "cases/hostile";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const char* const name : {"ft1e9.bvh", "ft1e-300.bvh"}) {
    for (const char* const command : {"analyse", "inspect"}) {
      expectRefused(std::string(command) + " '" + (folder / name).string() + "'",
                    {name, ":134: frame time ", "; expected 0.0001 to 1 s"});
    }
  }
}

TEST_F(Convert, AnAcclaimTrialIsItsBvh) {
  AMBLE_NEEDS_CAPTURES();
  const std::string mocap = (sharedFolder() / "mocap").string();
  ASSERT_EQ(run("convert '" + mocap + "/cmu_asfamc/09_06-run.amc' -o run.bvh").status, 0);
  const Clip copy = written("run.bvh");
  const Clip bvh = readMotion(mocap + "/cmu_mb2/09_06.bvh").clip;
  ASSERT_EQ(copy.frames() + 1, bvh.frames());
  const int foot = copy.skeleton.find("lfoot"), other = bvh.skeleton.find("LeftFoot");
  for (int i = 0; i < copy.frames(); ++i) {
    EXPECT_LT((jointFrames(copy, i)[foot].p_WJ - jointFrames(bvh, i + 1)[other].p_WJ).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace amble
