/// What the options do to every command that takes captures that say what their files leave open.
#pragma once

#include "animation/captures/bvh.h"
#include "test_paths.h"
#include "tests/app/options.h"

namespace amble {

class CaptureOptions : public Options {
 protected:
  inline static const std::string kOneTake =
      captureFolder() + "accad_female1/Female1_B03_Walk1.bvh";
  inline static const std::string kTwoTakes =
      std::string(AMBLE_SHARED) + "/cases/captures/g4_idle_and_walk.gltf";

  void SetUp() override {
    Options::SetUp();
    if (!std::filesystem::exists(kOneTake) || !std::filesystem::exists(kTwoTakes))
      GTEST_SKIP() << "no " << AMBLE_SHARED;
    std::filesystem::copy_file(kOneTake, folder_ / "in/walk.bvh");
    std::filesystem::copy_file(captureFolder() + "cmu_asfamc/07_05-walk.amc",
                               folder_ / "in/trial.amc");
    write("in/roles.yaml", "hips: Hips\n");
    write("in/wrong.yaml", "left_foot: LeftFoof\n");
  }

  /// The options that say what a capture leaves open. What they change is asked of the command.
  /// @param call  the command on a capture, with what else it needs
  Uses reading(const std::function<std::string(const std::string& clip)>& call) const {
    const std::string walk = call("in/walk.bvh");
    return {
        {"--unit",
         [=, this] {
           expectRefused(walk + " --unit 0", {"--unit", "1e-06 to 1000 m"});
         }},
        {"--up",
         [=, this] {
           expectRefused(walk + " --up x", {"--up", "x"});
         }},
        {"--facing",
         [=, this] {
           expectRefused(walk + " --facing 361", {"--facing", "-360 to"});
         }},
        {"--asf",
         [=, this] {
           expectRefused(call("in/trial.amc"), {"trial.amc: no .asf", "--asf"});
           good(call("in/trial.amc") + " --asf " + captureFolder() + "cmu_asfamc/07-walk.asf");
         }},
        {"--roles",
         [=, this] {
           expectRefused(walk + " --roles in/wrong.yaml", {"wrong.yaml:1: ", "'LeftFoof'"});
           good(walk + " --roles in/roles.yaml");
         }},
        {"--file-fps", [=, this] { expectRefused(walk + " --file-fps 0", {"--file-fps"}); }},
        {"--take",
         [=, this] {
           expectRefused(call(kTwoTakes) + " --take Run", {"no animation 'Run'", "'Idle', 'Walk'"});
         }},
        {"--memory",
         [=, this] {
           write("in/large.gltf", read(kTwoTakes) + std::string(size_t{8} << 20, ' '));
           expectRefused(call("in/large.gltf") + " --memory 1", {"more than 1 MB", "--memory MB"});
         }},
    };
  }
  /// The options of the motion that a command on captures writes.
  /// @param command  with the captures, the last of which is `input`
  Uses writing(const std::string& command, const std::string& input) const {
    const auto written = [=, this](const std::string& options) {
      good(command + " -o out.bvh " + options);
      return readBvh(folder_ / "out.bvh");
    };
    return {
        {"--output",
         [=, this] {
           expectRefused(command, {"--output"});
           expectRefused(command + " -o " + input, {input + ": "});
           expectRefused(command + " -o out.txt", {"out.txt: ", ".bvh or .glb"});
           EXPECT_TRUE(good(command + " -o -").out.starts_with("HIERARCHY"));
           good(command + " -o out.glb");
           EXPECT_TRUE(read("out.glb").starts_with("glTF"));
         }},
        {"--bvh-units",
         [=] {
           const Clip metres = written(""), centimetres = written("--bvh-units cm");
           EXPECT_NEAR(centimetres.poses.p_WR(9).norm(), 100.0 * metres.poses.p_WR(9).norm(), 1e-3);
         }},
        {"--names", [=] { EXPECT_GE(written("--names vrm").skeleton.find("leftUpperLeg"), 0); }},
    };
  }
  /// Those of reading, for a command that prints what it read.
  Uses readingPrinted(const std::string& command) const {
    Uses uses = reading([=](const std::string& clip) { return command + " " + clip; });
    const auto said = [=, this](const std::string& option) {
      return printed(command + " --json in/walk.bvh " + option)[0];
    };
    const auto also = [&uses](const std::string& option, const std::function<void()>& use) {
      uses[option] = [first = uses.at(option), use] {
        first();
        use();
      };
    };
    also("--unit", [=] {
      EXPECT_EQ(said("--unit 0.02")["unit"],
                nlohmann::json({{"metres", 0.02}, {"guessed", false}, {"sure", true}}));
    });
    also("--up", [=] { EXPECT_EQ(said("--up z")["up"]["axis"], "z"); });
    also("--facing",
         [=] { EXPECT_NEAR(said("--facing 90")["facing"]["degrees"].get<double>(), 90.0, 1e-9); });
    also("--roles", [=, this] {
      write("in/toeless.yaml", "left_toe: none\n");
      EXPECT_FALSE(said("--roles in/toeless.yaml")["roles"].contains("left_toe"));
    });
    also("--file-fps", [=] { EXPECT_EQ(said("--file-fps 50")["frame_time"], 0.02); });
    also("--take", [=, this] {
      const auto frames = [&](const std::string& take) {
        return printed(command + " --json " + kTwoTakes + " --take " + take)[0]["frames"];
      };
      EXPECT_EQ(frames("Idle"), 400);
      EXPECT_EQ(frames("Walk"), 121);
    });
    return uses;
  }
};

}  // namespace amble
