// Every option of amble graft and of graft all does what the help says of it.

#include "animation/captures/bvh.h"
#include "tests/app/capture_options.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class GraftOptions : public CaptureOptions {
 protected:
  void SetUp() override {
    CaptureOptions::SetUp();
    if (IsSkipped()) return;
    fs::copy_file(captureFolder() + "accad_female1/Female1_B20_WalkWithBox.bvh",
                  folder_ / "in/box.bvh");
  }
  json said(const std::string& options) const {
    return printed("graft in/walk.bvh in/box.bvh -o out.bvh --json " + options)[0];
  }
  Uses ofThePair() const;
};

GraftOptions::Uses GraftOptions::ofThePair() const {
  return {
      {"--chains",
       [this] {
         EXPECT_GT(said("--chains upper")["joints"].size(),
                   2 * said("--chains left_arm")["joints"].size());
         expectRefused("graft in/walk.bvh in/box.bvh -o no.bvh --chains left_leg",
                       {"in/walk.bvh: ", "left_leg", "expected one of", "right_arm"});
       }},
      {"--range",
       [this] {
         const json part = said("--range 30-120");
         EXPECT_GE(part["first"], 30);
         EXPECT_LE(part["last"], 120);
         EXPECT_EQ(said("--range 1s-4s")["base"]["first"], 30);
         expectRefused("graft in/walk.bvh in/box.bvh -o no.bvh --range 9-3", {"--range", "ends"});
       }},
      {"--action",
       [this] {
         const json part = said("--action 20-90");
         EXPECT_GE(part["upper_first"].get<double>(), 20.0);
         EXPECT_LE(part["upper_last"].get<double>(), 90.0);
       }},
      {"--alternative",
       [this] {
         const json first = said(""), other = said("--alternative 1");
         EXPECT_NE(first["upper_first"], other["upper_first"]);
         EXPECT_EQ(other["alternative"], 1);
         expectRefused("graft in/walk.bvh in/box.bvh -o no.bvh --alternative 999",
                       {"in/box.bvh: ", "expected 0 to "});
       }},
      {"--ease", [this] { EXPECT_EQ(said("--ease 0.7")["ease_in"], 0.7); }},
      {"--cut",
       [this] {
         const json whole = said("--cut");
         EXPECT_EQ(readBvh(folder_ / "out.bvh").frames(),
                   whole["last"].get<int>() - whole["first"].get<int>() + 1);
       }},
      {"--as-it-falls",
       [this] {
         EXPECT_EQ(said("--as-it-falls")["arms_in_body"]["turned"], json({0.0, 0.0}));
       }},
      {"--json", [this] { EXPECT_EQ(said("")["kind"], "graft"); }},
  };
}

TEST_F(GraftOptions, AreAllTried) {
  const Uses captures = reading(
      [](const std::string& clip) { return "graft -o out.bvh in/walk.bvh '" + clip + "'"; });
  expectAll("graft",
            {captures, ofThePair(), writing("graft in/walk.bvh in/box.bvh", "in/box.bvh")});
}

TEST_F(GraftOptions, OfAllAreTried) {
  fs::create_directories(folder_ / "clips");
  fs::copy_file(folder_ / "in/walk.bvh", folder_ / "clips/walk.bvh");
  fs::copy_file(captureFolder() + "accad_female1/Female1_C03_Run.bvh", folder_ / "clips/run.bvh");
  Uses uses =
      reading([](const std::string& clip) { return "graft all -o out in/box.bvh '" + clip + "'"; });
  uses["--memory"] = [&] {  // beyond what reading the first clip left free
    write("in/huge.gltf", read(kTwoTakes) + std::string(size_t{64} << 20, ' '));
    expectRefused("graft all -o out in/huge.gltf in/box.bvh --memory 1 --threads 1",
                  {"more than 1 MB"});
  };
  uses["--output"] = [&] {
    good("graft all clips -o there");
    EXPECT_TRUE(fs::exists(folder_ / "there/run-on-walk.bvh"));
    EXPECT_TRUE(fs::exists(folder_ / "there/index.json"));
  };
  uses["--roles"] = [&] {  // of each clip
    EXPECT_NE(run("graft all clips -o out --roles in/wrong.yaml").err.find("wrong.yaml:1: "),
              std::string::npos);
    good("graft all clips -o out --roles in/roles.yaml");
  };
  uses["--chains"] = [&] {
    EXPECT_EQ(printed("graft all clips -o out --json --chains head")[0]["chains"], json({"head"}));
  };
  uses["--json"] = [&] {
    const json index = printed("graft all clips -o out --json");
    EXPECT_EQ(index, json::parse(read("out/index.json")));
  };
  uses["--threads"] = [&] {
    const std::string one = good("graft all clips -o out --json --threads 1").out;
    const std::string bvh = read("out/walk-on-run.bvh");
    EXPECT_EQ(good("graft all clips -o out --json --threads 2").out, one);
    EXPECT_EQ(read("out/walk-on-run.bvh"), bvh);
  };
  expectEach("graft all", uses);
}

}  // namespace
}  // namespace amble
