// In whose manner to walk, from the outside.

#include <nlohmann/json.hpp>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Style : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    if (!fs::exists(captureFolder() + "cmu_style_loops")) GTEST_SKIP() << "no captures";
    const fs::path motions = fs::path(AMBLE_SOURCE_DIR) / "animation/motions";
    for (const char* const name : {"default.yaml", "default.bvh"})
      fs::copy_file(motions / name, folder_ / "in" / name);
    const Ran added = run("library add in/default.yaml --style old-man --name old '" +
                          captureFolder() + "cmu_style_loops/137_33_EDIT_LOOP.bvh'");
    ASSERT_EQ(added.status, 0) << added.err;
  }
  json planned(const std::string& walk) const {
    write("in/styled.yaml", kScenario + "character: {library: default.yaml}\nwalk: " + walk + "\n");
    const Ran ran = run("plan in/styled.yaml -o out --formats bvh,json --json");
    EXPECT_EQ(ran.status, 0) << ran.err;
    return json::parse(ran.out);
  }
};

TEST_F(Style, AScenarioWalksInItAtItsOwnSpeedAndWithoutItAsBefore) {
  const json old_man = planned("{style: old-man}");
  const double slow = old_man["length"].get<double>() / old_man["duration"].get<double>();
  EXPECT_GT(slow, 0.2);
  EXPECT_LT(slow, 0.4);  // 0.36 m/s, but for the start and the stop
  planned("{speed: 1.2}");
  const std::string before = read("out/walk.bvh");
  ASSERT_EQ(run("plan in/scenario.yaml -o plain --formats bvh").status, 0);
  EXPECT_EQ(before, read("plain/walk.bvh")) << "a styled walk is no part of another";
}

TEST_F(Style, OneThatIsNotThereIsAnErrorOfItsLineThatNamesThoseThatAre) {
  write("in/styled.yaml",
        kScenario + "character: {library: default.yaml}\nwalk:\n  style: young-man\n");
  expectRefused("plan in/styled.yaml -o out",
                {"in/styled.yaml:", "'young-man'", "; expected one of old-man"});
  write("in/styled.yaml", kScenario + "walk: {style: old-man}\n");
  expectRefused("plan in/styled.yaml -o out", {"in/styled.yaml:", "'old-man'", "no style"});
}

}  // namespace
}  // namespace amble
