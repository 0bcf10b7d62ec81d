// The same of the commands that make libraries of captures, and check them.

#include "tests/app/capture_options.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What a motion was added with, it is checked with.
TEST_F(CaptureOptions, OfLibraryCheck) {
  const std::string asf = "--asf " + captureFolder() + "cmu_asfamc/07-walk.asf";
  const auto added = [this](const std::string& clip, const std::string& option) {
    for (const char* const file : {"l.yaml", "l.bvh"}) fs::remove(folder_ / file);
    good("library add l.yaml " + clip + " " + option);
  };
  const auto holds = [this](const std::string& option) {
    return good("library check l.yaml --captures in " + option).out;
  };
  // Says what is wrong with the motion of another clip.
  const auto wrong = [&](const std::string& clip, const std::string& option) {
    std::string text = read("l.yaml");
    text.replace(text.find("walk.bvh"), 8, clip);
    write("other.yaml", text);
    return good("library check other.yaml --captures in --captures / " + option, 1).out;
  };
  Uses uses;
  for (const std::string option :
       {"--unit 0.012", "--file-fps 33", "--facing 90", "--up y", "--roles in/roles.yaml"}) {
    uses[option.substr(0, option.find(' '))] = [=, this] {
      added("in/walk.bvh", option);
      holds(option);
      if (option.starts_with("--unit") || option.starts_with("--file-fps"))
        good("library check l.yaml --captures in", 1);
    };
  }
  uses["--asf"] = [=, this] {
    added("in/trial.amc", asf);
    holds(asf);
    const Ran without = good("library check l.yaml --captures in", 1);
    EXPECT_NE(without.out.find("trial.amc: no .asf"), std::string::npos) << without.out;
  };
  uses["--take"] = [=] {
    added("in/walk.bvh", "");
    const std::string said = wrong(kTwoTakes.substr(1), "--take Run");
    EXPECT_NE(said.find("no animation 'Run'"), std::string::npos) << said;
  };
  uses["--memory"] = [=, this] {
    added("in/walk.bvh", "");
    write("in/large.gltf", read(kTwoTakes) + std::string(size_t{8} << 20, ' '));
    const std::string said = wrong("large.gltf", "--memory 1");
    EXPECT_NE(said.find("more than 1 MB"), std::string::npos) << said;
  };
  uses["--captures"] = [=, this] {
    added("in/walk.bvh", "");
    EXPECT_NE(good("library check l.yaml").out.find("were not read"), std::string::npos);
    EXPECT_EQ(holds("--captures out").find("WRONG"), std::string::npos);
    std::string text = read("l.yaml");
    const size_t speed = text.find("speed: 1");
    ASSERT_NE(speed, text.npos);
    text[text.find('.', speed) + 1] ^= 1;  // a tenth of a metre a second off
    write("l.yaml", text);
    const Ran checked = good("library check l.yaml --captures in", 1);
    EXPECT_NE(checked.out.find("measured 1"), std::string::npos) << checked.out;
  };
  expectEach("library check", uses);
}

// A walk and its mirror image are of one file, which is warned of once.
TEST_F(CaptureOptions, WhatIsUnsureOfACaptureIsSaidInOneLineByWhatMakesLibrariesAndEnginesOfIt) {
  std::string text = read("in/walk.bvh");
  const size_t frames = text.find("Frames:") + 7;
  text.replace(frames, text.find('\n', frames) - frames, " 10");
  write("in/short.bvh", text);
  for (const char* const command :
       {"library add l.yaml in/short.bvh", "library engine build in/short.bvh -o e.yaml"}) {
    const std::string said = good(command).err, warning = "warning: in/short.bvh: holds ";
    const size_t at = said.find(warning);
    ASSERT_NE(at, said.npos) << command << '\n' << said;
    EXPECT_EQ(said.find("holds ", at + warning.size()), said.npos) << command << '\n' << said;
  }
}

TEST_F(CaptureOptions, OfLibrary) {
  const std::string mocap = captureFolder();
  write("in/it.recipe.yaml",
        "skeleton: it.bvh\ncaptures: none\nlicence: none\ncredit: none\nmotions:\n"
        "  - {name: walk, kind: walk, clip: accad_male1/Male1_B3_Walk.bvh}\n");
  expectEach("library build",
             {{"--captures",
               [&] {
                 expectRefused("library build in/it.recipe.yaml", {"Male1_B3_Walk.bvh"});
                 good("library build in/it.recipe.yaml --captures " + mocap);
                 EXPECT_TRUE(fs::exists(folder_ / "in/it.yaml"));
               }},
              {"--output", [&] {
                 good("library build in/it.recipe.yaml --captures " + mocap + " -o far/other.yaml");
                 EXPECT_TRUE(fs::exists(folder_ / "far/other.yaml"));
               }}});
  expectEach("library show",
             {{"--json", [&] { EXPECT_EQ(printed("library show --json")[0]["joints"], 22); }}});
}

class LibraryAddOptions : public CaptureOptions {
 protected:
  void expectWalksOfAnEngine() const;
  void expectClipsFound() const;
};

void LibraryAddOptions::expectWalksOfAnEngine() const {
  good("library engine build in/walk.bvh -o anna.yaml --licence 'A B'");
  fs::remove(folder_ / "l.yaml");
  good("library add l.yaml anna.yaml --speed 0.6,1");
  const json motions = printed("library show l.yaml --json")[0]["motions"];
  ASSERT_EQ(motions.size(), 5u) << "a stance, two walks, their mirror images";
  EXPECT_EQ(motions[2]["name"], "anna-0.6-mirrored");
  EXPECT_EQ(motions[3]["name"], "anna-1");
  EXPECT_NEAR(motions[3]["speed"].get<double>(), 1.0, 1e-6);
  EXPECT_EQ(motions[3]["source"]["speed"], 1.0);
  EXPECT_EQ(motions[3]["source"]["licence"], "A B");
  EXPECT_NE(good("library show l.yaml").out.find("anna.yaml at 0.6 m/s, mirrored (A B)"),
            std::string::npos);
  EXPECT_NE(good("library check l.yaml --captures .").out.find("5 motions, 0 wrong"),
            std::string::npos);
  const std::string before = read("l.yaml");
  for (const auto& [use, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"anna.yaml", {"anna.yaml: is a speed engine", "expected --speed"}},
           {"anna.yaml --speed 0.1", {"--speed", "0.3 to 5"}},
           {"anna.yaml --speed 3", {"anna.yaml: 3 m/s is beyond what was captured", "0.3 to"}},
           {"anna.yaml --speed 1 --kind start", {"anna.yaml: ", "holds no start"}},
           {"anna.yaml --speed 1 --turning turn", {"anna.yaml: ", "walks straight"}},
           {"anna.yaml --speed 1 --frames 1 9", {"anna.yaml: ", "has no frames"}},
           {"l.yaml --speed 1", {"l.yaml: is no speed engine", "library engine build"}},
           {"in/walk.bvh --speed 1", {"walk.bvh: is no speed engine", "library engine build"}}})
    expectRefused("library add l.yaml " + use + " --name other", words);
  EXPECT_EQ(read("l.yaml"), before);
}

// From which the motions that there are are made again.
void LibraryAddOptions::expectClipsFound() const {
  const std::string stand = captureFolder() + "accad_female1/Female1_A01_Stand.bvh";
  for (const char* const file : {"l.yaml", "l.bvh"}) fs::remove(folder_ / file);
  good("library add l.yaml in/walk.bvh");
  const std::string own = "library add l.yaml " + stand + " --kind posture --name stand";
  fs::rename(folder_ / "in/walk.bvh", folder_ / "walk.bvh");
  expectRefused(own, {"walk.bvh: is not there", "--captures DIR"});
  good(own + " --captures in --captures .");
  fs::rename(folder_ / "walk.bvh", folder_ / "in/walk.bvh");
  EXPECT_EQ(printed("library show --json l.yaml")[0]["motions"][0]["source"]["clip"],
            "Female1_A01_Stand.bvh");
}

TEST_F(LibraryAddOptions, OfLibraryAdd) {
  const auto call = [this](const std::string& clip) {
    fs::remove(folder_ / "l.yaml");
    fs::remove(folder_ / "l.bvh");
    return "library add l.yaml '" + clip + "'";
  };
  // What the library made with the option has behind the stance of all.
  const auto made = [&](const std::string& option) {
    good(call("in/walk.bvh") + " " + option);
    json motions = printed("library show --json l.yaml")[0]["motions"];
    motions.erase(0);
    return motions;
  };
  const json plain = made("");
  Uses uses =
      reading([](const std::string& clip) { return "library add new.yaml '" + clip + "'"; });
  uses["--unit"] = [&] {
    EXPECT_EQ(made("--unit 0.01"), plain);
    const double speed = plain[0]["speed"];
    EXPECT_NEAR(made("--unit 0.012")[0]["speed"].get<double>(), 1.2 * speed, 1e-3);
    expectRefused(call("in/walk.bvh") + " --unit 0.02", {"walk.bvh: ", "3.27 m", "--unit"});
  };
  uses["--up"] = [&] {
    EXPECT_EQ(made("--up y"), plain);
    expectRefused(call("in/walk.bvh") + " --up z", {"backwards or sideways"});
  };
  uses["--facing"] = [&] {
    EXPECT_NEAR(made("--facing 90")[0]["speed"].get<double>(), plain[0]["speed"], 1e-6);
  };
  uses["--asf"] = [&] {
    expectRefused(call("in/trial.amc"), {"trial.amc: no .asf", "--asf"});
    good(call("in/trial.amc") + " --asf " + captureFolder() + "cmu_asfamc/07-walk.asf");
  };
  uses["--roles"] = [&] { EXPECT_EQ(made("--roles in/roles.yaml"), plain); };
  uses["--file-fps"] = [&] {
    EXPECT_NEAR(made("--file-fps 33")[0]["speed"].get<double>(),
                1.1 * plain[0]["speed"].get<double>(), 0.05);
  };
  uses["--name"] = [&] {
    const json named = made("--name 'a stroll'");
    EXPECT_EQ(named[0]["name"], "a stroll");
    EXPECT_EQ(named[1]["name"], "a stroll-mirrored");
  };
  uses["--kind"] = [&] { EXPECT_EQ(made("--kind movement")[0]["kind"], "movement"); };
  uses["--turning"] = [&] {
    EXPECT_EQ(made("--turning straight"), plain);
    expectRefused(call("in/walk.bvh") + " --turning turn", {"walks straight; expected"});
  };
  uses["--joints"] = [&] {
    made("--kind movement --joints left_arm,trunk");
    EXPECT_NE(read("l.yaml").find("joints: [left_arm, trunk]"), std::string::npos);
  };
  uses["--frames"] = [&] {
    const json source = made("--frames 10 120")[0]["source"];
    EXPECT_GE(source["frames"][0], 10);
    EXPECT_LE(source["frames"][1], 120);
    EXPECT_GT(plain[0]["source"]["frames"][1], 120);
  };
  uses["--speed"] = [&] { expectWalksOfAnEngine(); };
  uses["--style"] = [&] {
    const json styled = made("--style old-man");
    ASSERT_EQ(styled.size(), 1u) << "a manner is not mirrored unless that is asked for";
    EXPECT_EQ(styled[0]["style"], "old-man");
    EXPECT_EQ(printed("library show l.yaml --json")[0]["styles"], json({"old-man"}));
    expectRefused(call("in/walk.bvh") + " --style x --kind posture", {"--style: ", "expected"});
  };
  uses["--mirror"] = [&] {
    EXPECT_EQ(made("--style old-man --mirror").size(), 2u);
    expectRefused(call("in/walk.bvh") + " --mirror", {"--mirror: ", "expected --style"});
  };
  uses["--no-mirror"] = [&] {
    EXPECT_EQ(made("--no-mirror").size(), 1u);
    EXPECT_EQ(plain.size(), 2u);
  };
  uses["--captures"] = [&] { expectClipsFound(); };
  uses["--licence"] = [&] { EXPECT_EQ(made("--licence 'A B'")[0]["source"]["licence"], "A B"); };
  uses["--credit"] = [&] { EXPECT_EQ(made("--credit 'C D'")[0]["source"]["credit"], "C D"); };
  expectEach("library add", uses);
}

}  // namespace
}  // namespace amble
