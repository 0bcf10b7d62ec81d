// amble graft, from the outside.

#include <nlohmann/json.hpp>

#include "animation/captures/bvh.h"
#include "animation/captures/motion_reader.h"
#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class GraftCommand : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    if (!fs::exists(kFemale)) GTEST_SKIP() << "no captures";
  }
  void take(const std::string& from, const std::string& as) const {
    fs::copy_file(captureFolder() + from, folder_ / "in" / as);
  }
  const std::string kFemale = captureFolder() + "accad_female1/";
};

TEST_F(GraftCommand, APairThatTheThesisForbidsIsRefusedInOneLineWithItsRule) {
  take("cmu_mb2/01_01.bvh", "jump.bvh");
  take("cmu_mb2/02_01.bvh", "walk.bvh");
  expectRefused("graft in/walk.bvh in/jump.bvh -o out.bvh",
                {"in/jump.bvh: jump on walk", "rule 4", "; expected "});
  expectRefused("graft in/jump.bvh in/walk.bvh -o out.bvh",
                {"in/walk.bvh: walk on jump", "rule 2", "; expected "});
  expectRefused("graft in/jump.bvh -o out.bvh", {"amble graft: two clips are needed"});
  expectRefused("graft in/jump.bvh none.bvh -o out.bvh", {"none.bvh: "});
  expectRefused("graft - - -o out.bvh", {"-: is given twice"});
  expectRefused("graft all in/jump.bvh -o out", {"in/jump.bvh: is one clip"});
  expectRefused("graft all in/jump.bvh none.bvh -o out", {"none.bvh: "});
}

TEST_F(GraftCommand, OfAFolderMakesTheNinePairsAndListsTheOthersWithTheirRule) {
  take("accad_female1/Female1_A01_Stand.bvh", "stand.bvh");
  take("cmu_mb2/02_01.bvh", "walk.bvh");
  take("cmu_mb2/02_03.bvh", "run <b>.bvh");
  take("cmu_mb2/01_01.bvh", "jump.bvh");
  const Ran ran = run("graft all in -o out --json");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json index = json::parse(ran.out);
  ASSERT_EQ(index.size(), 12u);  // four by four, without themselves
  int made = 0;
  for (const json& pair : index) {
    if (!pair["refused"].get<std::string>().empty()) {
      EXPECT_NE(pair["refused"].get<std::string>().find("thesis 5.4.2, rule"), std::string::npos);
      continue;
    }
    ++made;
    const fs::path file = folder_ / "out" / pair["file"].get<std::string>();
    EXPECT_EQ(readBvh(file).frames(), readMotion(folder_ / pair["base"]["file"]).clip.frames());
  }
  EXPECT_EQ(made, 5);  // nine without the four of a type with itself
  size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "out")) files += entry.exists() ? 1 : 0;
  EXPECT_EQ(files, 6u);  // and the index
  const Ran text = run("graft all in -o out");
  EXPECT_NE(text.out.find("refused: jump on walk"), std::string::npos) << text.out;
}

TEST_F(GraftCommand, WhatIsCarriedGoesIntoALibraryAndIsCarriedOnAWalk) {
  take("accad_female1/Female1_B03_Walk1.bvh", "walk.bvh");
  take("accad_female1/Female1_B20_WalkWithBox.bvh", "box.bvh");
  ASSERT_EQ(run("graft in/walk.bvh in/box.bvh --cut -o box-walk.bvh").status, 0);
  const fs::path motions = fs::path(AMBLE_SOURCE_DIR) / "animation/motions";
  for (const char* const name : {"default.yaml", "default.bvh"})
    fs::copy_file(motions / name, folder_ / "in" / name);
  const Ran added =
      run("library add in/default.yaml box-walk.bvh --kind movement --joints left_arm,right_arm "
          "--name box");
  ASSERT_EQ(added.status, 0) << added.err;
  write("in/carrying.yaml",
        kScenario + "character: {library: default.yaml}\nwalk: {actions: [box]}\n");
  ASSERT_EQ(run("plan in/carrying.yaml -o with --formats bvh").status, 0);
  ASSERT_EQ(run("plan in/scenario.yaml -o without --formats bvh").status, 0);
  const Clip with = readBvh(folder_ / "with/walk.bvh");
  const Clip without = readBvh(folder_ / "without/walk.bvh");
  // A box is before the belly; hands that swing pass the thighs.
  const auto lowestHand = [](const Clip& clip) {
    const int hand = clip.skeleton.find("LeftHand");
    std::vector<JointFrame> joints(clip.skeleton.size());
    double lowest = 10.0;
    for (int i = 0; i < clip.frames(); ++i) {
      forwardKinematics(clip, i, joints);
      lowest = std::min(lowest, joints[hand].p_WJ.z());
    }
    return lowest;
  };
  EXPECT_GT(lowestHand(with), lowestHand(without) + 0.1);
}

}  // namespace
}  // namespace amble
