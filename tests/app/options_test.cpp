// Every option of every command does what the help says of it: each test runs all options of a
// command, and fails for one that the help has and no line here.

#include "tests/app/options.h"

#include <cmath>

#include "animation/captures/bvh.h"
#include "base/rotation.h"
#include "base/sha256.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const kShort =
    "scene: room.yaml\nstart: {at: [1, 2], heading: 0}\ngoal: {at: [2, 2], heading: 0}\n";

// Below, each command's options in the order of its help.

TEST_F(Options, EveryCommandIsTriedHere) {
  EXPECT_EQ(listed("", "Subcommands:"),
            (std::vector<std::string>{"plan", "check", "validate", "animate", "analyse", "library",
                                      "edit", "convert", "graft", "inspect", "roadmap", "graph",
                                      "view", "batch", "help", "completion"}));
  EXPECT_EQ(listed("batch", "Subcommands:"),
            (std::vector<std::string>{"merge", "stats", "status", "check"}));
  EXPECT_EQ(listed("graft", "Subcommands:"), (std::vector<std::string>{"all"}));
  EXPECT_EQ(listed("library", "Subcommands:"),
            (std::vector<std::string>{"build", "show", "add", "check", "find", "engine"}));
  EXPECT_EQ(listed("library engine", "Subcommands:"), (std::vector<std::string>{"build", "show"}));
  EXPECT_EQ(optionsOf("library"), std::set<std::string>{});
  EXPECT_EQ(optionsOf(""), std::set<std::string>{"--version"});
}

class PlanOptions : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    write("in/scenario.yaml", kShort);
  }
  json reported(const std::string& options) const {
    return printed(kPlan + "-o out --formats bvh --json " + options);
  }
  void expectFiles(const std::string& options, const std::set<std::string>& wanted) const {
    good(kPlan + "-o some " + options);
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_ / "some")) {
      found.insert(entry.path().filename().string());
    }
    EXPECT_EQ(found, wanted);
  }
  Uses ofTheSearch() const;
  Uses ofResults() const;

  const std::string kPlan = "plan in/scenario.yaml ";
};

PlanOptions::Uses PlanOptions::ofTheSearch() const {
  return {
      {"--planner", [this] { EXPECT_EQ(reported("--planner rrt")["planner"], "rrt"); }},
      {"--seed", [this] { EXPECT_EQ(reported("--seed 9")["seed"], 9); }},
      {"--threads",
       [this] {
         good(kPlan + "-o one --formats bvh --threads 1");
         good(kPlan + "-o three --formats bvh --threads 3");
         EXPECT_EQ(read("one/walk.bvh"), read("three/walk.bvh"));
       }},
      {"--time-limit",
       [this] {
         EXPECT_NE(good(kPlan + "-o out --time-limit 0.001", 1).out.find("time_limit"),
                   std::string::npos);
       }},
      {"--checker",
       [this] {
         good(kPlan + "-o fast --formats bvh --checker fast");
         good(kPlan + "-o fcl --formats bvh --checker fcl");
         EXPECT_EQ(read("fast/walk.bvh"), read("fcl/walk.bvh"));
       }},
      {"--memory", [this] { expectMemoryBounds("plan in/of-mesh.yaml -o out --formats json"); }},
      {"--roadmap",
       [this] {
         good("roadmap build in/scenario.yaml -o in/it.roadmap --m 1");
         EXPECT_TRUE(reported("--roadmap in/it.roadmap")["inputs"].contains("it.roadmap"));
         expectRefused(kPlan + "-o new --roadmap in/scenario.yaml", {"is no roadmap"});
         expectRefused(kPlan + "-o new --fps 30 --roadmap in/it.roadmap", {"fps 30, was 60"});
       }},
      {"--list-planners", [this] {
         std::istringstream planners(good("plan --list-planners").out);
         wallOff();
         write("in/few.yaml", kScenario + "planner: {max_failures: 2}\n");
         int count = 0;
         for (std::string line; std::getline(planners, line); ++count) {
           const std::string name = line.substr(0, line.find(' '));
           const json report = printed("plan in/few.yaml -o out --json --planner " + name, 1);
           EXPECT_EQ(report["planner"], name);
         }
         EXPECT_GE(count, 4);
       }}};
}

PlanOptions::Uses PlanOptions::ofResults() const {
  return {{"--output",
           [this] {
             good(kPlan + "--formats json");
             EXPECT_TRUE(fs::exists(folder_ / "out/scenario/report.json"));
             good(kPlan + "--formats json --output there/it");
             EXPECT_TRUE(fs::exists(folder_ / "there/it/report.json"));
           }},
          {"--fps",
           [this] {
             const json report = reported("--fps 120");
             EXPECT_NEAR(report["frame_time"].get<double>(), 1.0 / 120.0, 1e-8);
             EXPECT_NEAR(readBvh(folder_ / "out/walk.bvh").frame_time, 1.0 / 120.0, 1e-7);
           }},
          {"--bvh-units",
           [this] {
             EXPECT_EQ(reported("--bvh-units cm")["bvh_unit"], 0.01);
             const Clip cm = readBvh(folder_ / "out/walk.bvh", {.metres_per_unit = 0.01});
             reported("--bvh-units m");
             const Clip m = readBvh(folder_ / "out/walk.bvh");
             ASSERT_EQ(cm.frames(), m.frames());
             EXPECT_LT((cm.poses.p_WR(100) - m.poses.p_WR(100)).norm(), 1e-5);
           }},
          {"--names",
           [this] {
             const json report = reported("--names unreal");
             EXPECT_GE(readBvh(folder_ / "out/walk.bvh").skeleton.find("thigh_l"), 0);
             EXPECT_NE(report["body"].dump().find("\"thigh_l\""), std::string::npos);
             expectRefused(kPlan + "-o out --names maya", {"--names", "maya"});
           }},
          {"--views",
           [this] {
             expectFiles("--formats bvh --views top,first",
                         {"walk-first.png", "walk-top.png", "walk.bvh"});
             expectRefused(kPlan + "-o out --views above", {"--views", "above"});
           }},
          {"--film",
           [this] {  // the first picture, as ffmpeg is given it
             write("bin/ffmpeg", "#!/bin/sh\nhead -c 2764800 > film.raw\nexit 1\n");
             const std::string path = "chmod +x bin/ffmpeg; PATH=$PWD/bin:$PATH;";
             good(kPlan + "--formats mp4 -o out", 2, path);
             const std::string still = read("film.raw");
             good(kPlan + "--formats mp4 --film corner -o out", 2, path);
             EXPECT_EQ(read("film.raw"), still);
             good(kPlan + "--formats mp4 --film follow -o out", 2, path);
             EXPECT_NE(read("film.raw"), still);
             expectRefused(kPlan + "-o out --film above", {"--film", "above"});
           }},
          {"--no-scene",
           [this] {
             good(kPlan + "--formats glb -o out");
             EXPECT_NE(read("out/walk.glb").find("\"name\":\"scene\""), std::string::npos);
             good(kPlan + "--formats glb -o out --no-scene");
             EXPECT_EQ(read("out/walk.glb").find("\"name\":\"scene\""), std::string::npos);
             expectFiles("--formats sdf", {"room.dae", "walk.bvh", "walk.dae", "walk.sdf"});
             expectFiles("--formats sdf --no-scene", {"walk.bvh", "walk.dae", "walk.sdf"});
           }},
          {"--formats",
           [this] {
             expectFiles("--formats glb", {"walk.glb"});
             expectFiles("--formats svg", {"top.svg"});
             expectFiles("--formats strip,json", {"report.json", "strip.png"});
             expectFiles("--formats bvh --formats png", {"walk.bvh", "walk.png"});
           }},
          {"--json", [this] {
             json out = printed(kPlan + "-o out --formats json --json");
             json file = json::parse(read("out/report.json"));
             out.erase("times");
             file.erase("times");
             EXPECT_EQ(out, file);
           }}};
}

TEST_F(PlanOptions, AreAllTried) { expectAll("plan", {ofTheSearch(), ofResults()}); }

TEST_F(Options, OfCheck) {
  write("in/scenario.yaml", kShort);
  const std::string check = "check in/scenario.yaml ";
  expectEach("check",
             {{"--junit",
               [&] {
                 good(check + "--junit it.xml");
                 EXPECT_NE(read("it.xml").find("tests=\"1\""), std::string::npos) << read("it.xml");
               }},
              {"--update",
               [&] {
                 good(check + "--update");
                 EXPECT_TRUE(fs::exists(folder_ / "in/accepted/scenario.png"));
                 good("plan in/scenario.yaml -o out --formats bvh");
                 EXPECT_NE(read("in/scenario.yaml").find(sha256OfFile(folder_ / "out/walk.bvh")),
                           std::string::npos);
                 fs::remove_all(folder_ / "in/accepted");
                 write("in/scenario.yaml", kShort);
               }},
              {"--output",
               [&] {
                 good(check + "-o there/it");
                 const std::string page = read("there/it/index.html");
                 EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
                 EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
                 expectRefused(check + "-o in/scenario.yaml", {"scenario.yaml: cannot be made"});
               }},
              {"--list",
               [&] {
                 EXPECT_EQ(good(check + "--list").out, "scenario  in/scenario.yaml\n");
                 EXPECT_EQ(printed(check + "--list --json")[0]["scenario"], "scenario");
               }},
              {"--filter",
               [&] {
                 write("in/other.yaml", kShort);
                 EXPECT_EQ(printed("check in --list --json --filter 'o*'").size(), 1u);
                 EXPECT_EQ(printed("check in --list --json --filter other,scenario").size(), 2u);
                 expectRefused("check in --filter scenaro", {"expected 'scenario'"});
               }},
              {"--jobs",
               [&] {
                 json one = printed("check in --json"), two = printed("check in --json -j 2");
                 ASSERT_EQ(one.size(), 2u);
                 for (json* rows : {&one, &two})
                   for (json& row : *rows) {
                     row.erase("planning_time");
                     row.erase("total_time");
                   }
                 EXPECT_EQ(one, two);
                 fs::remove(folder_ / "in/other.yaml");
               }},
              {"--judge-times",
               [&] {
                 write("in/scenario.yaml",
                       std::string(kShort) + "expect: {max_planning_time: 0.000001}\n");
                 good(check);
                 const Ran judged = good(check + "--judge-times", 1);
                 EXPECT_NE(judged.out.find("1 differ"), std::string::npos) << judged.out;
                 write("in/scenario.yaml", kShort);
               }},
              {"--threads",
               [&] {
                 const json one = printed(check + "--json --threads 1")[0];
                 const json three = printed(check + "--json --threads 3")[0];
                 EXPECT_EQ(one["length"], three["length"]);
                 EXPECT_EQ(one["foot_skate"], three["foot_skate"]);
               }},
              {"--memory",
               [&] {
                 writeGrid();
                 EXPECT_NE(good("check in/of-mesh.yaml --memory 1", 2).err.find("more than 1 MB"),
                           std::string::npos);
                 good("check in/of-mesh.yaml");
               }},
              {"--json", [&] { EXPECT_EQ(printed(check + "--json")[0]["verdict"], "ok"); }}});
}

class ValidateOptions : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    good("plan in/scenario.yaml -o out --formats bvh");
    write("in/low.yaml", kRoom + "  - {name: beam, box: {size: [0.2, 4, 1]}, at: [3, 2, 2.2]}\n");
    write("in/kerb.yaml",
          kRoom + "  - {name: kerb, box: {size: [3, 4, 0.15]}, at: [4.5, 2, 0.075]}\n");
    plain_ = printed(kValidate);
  }
  Uses ofReading() const;
  Uses ofTheGround() const;

  // It fails with these words, and with the option it says them only.
  void expectSaid(const Clip& clip, const std::string& option, const std::string& words) const {
    writeBvh(folder_ / "other.bvh", clip, {});
    const std::string other = "validate other.bvh --scene in/room.yaml ";
    EXPECT_NE(good(other, 1).out.find(words), std::string::npos);
    EXPECT_NE(good(other + option).out.find(words), std::string::npos);
  }

  const std::string kBare = "validate out/walk.bvh ";
  const std::string kValidate = kBare + "--scene in/room.yaml --json ";
  json plain_;
};

ValidateOptions::Uses ValidateOptions::ofReading() const {
  return {
      {"--scene",
       [this] {
         expectRefused(kBare, {"--scene"});
         const json beam = printed(kBare + "--scene in/low.yaml --height 1.9 --json", 1);
         EXPECT_NE(beam["contacts"].dump().find("beam"), std::string::npos);
       }},
      {"--unit",
       [this] {
         expectRefused(kValidate + "--unit 0.01", {"0.01634 m tall", "--unit"});
         EXPECT_EQ(printed(kValidate + "--unit 1"), plain_);
       }},
      {"--up",
       [this] {
         EXPECT_EQ(printed(kValidate + "--up y"), plain_);
         EXPECT_FALSE(printed(kValidate + "--up z", 1)["contacts"].empty());
       }},
      {"--height", [this] { EXPECT_EQ(printed(kValidate + "--height 1.7", 0)["stature"], 1.7); }},
      {"--fps",
       [this] {
         const int frames = plain_["frames"];
         EXPECT_EQ(plain_["poses_checked"], frames);
         EXPECT_EQ(printed(kValidate + "--fps 240")["poses_checked"], 4 * (frames - 1) + 1);
       }},
      {"--memory",
       [this] {
         writeGrid();
         expectRefused(kBare + "--scene in/mesh.yaml --memory 1", {"more than 1 MB"});
       }},
      {"--json", [this] { EXPECT_EQ(plain_["file"], "out/walk.bvh"); }}};
}

ValidateOptions::Uses ValidateOptions::ofTheGround() const {
  return {{"--floor",
           [this] {
             EXPECT_EQ(plain_["floor"], 0.0);
             EXPECT_EQ(printed(kValidate + "--floor 3")["floor"], 3.0);
           }},
          {"--max-slope",
           [this] {
             write("in/tilted.yaml",
                   "name: tilted\nobjects:\n  - {name: floor, box: {size: [8, 6, 0.1]}, "
                   "rotate: [0, -5, 0], at: [3, 2, 0.2]}\n");
             write("in/up.yaml",
                   "scene: tilted.yaml\n" + kScenario.substr(kScenario.find("start")));
             good("plan in/up.yaml -o up --formats bvh");
             good("validate up/walk.bvh --scene in/tilted.yaml --max-slope 6");
             expectRefused("validate up/walk.bvh --scene in/tilted.yaml --max-slope 4",
                           {"'in/tilted.yaml' has no floor"});
           }},
          {"--max-climb",
           [this] {
             write("in/up.yaml", "scene: kerb.yaml\n" + kScenario.substr(kScenario.find("start")));
             good("plan in/up.yaml -o up --formats bvh");
             const std::string over = "validate up/walk.bvh --scene in/kerb.yaml ";
             good(over + "--max-climb 0.16 --max-drop 0");
             EXPECT_NE(good(over + "--max-climb 0.1", 1).out.find("over"), std::string::npos);
           }},
          {"--max-drop",
           [this] {
             write("in/down.yaml",
                   "scene: kerb.yaml\nstart: {at: [5, 2], heading: 180}\n"
                   "goal: {at: [1, 2], heading: 180}\n");
             good("plan in/down.yaml -o down --formats bvh");
             const std::string over = "validate down/walk.bvh --scene in/kerb.yaml ";
             good(over + "--max-climb 0 --max-drop 0.16");
             good(over + "--max-drop 0.1", 1);
           }},
          {"--allow-hover",
           [this] {
             write("in/sunk.yaml",
                   "name: sunk\nobjects:\n  - {name: floor, box: {size: [6, 4, 0.1]}, "
                   "at: [3, 2, -0.08]}\n");
             const std::string over = kBare + "--scene in/sunk.yaml --floor -0.03 ";
             EXPECT_NE(good(over, 1).out.find("hang in the air"), std::string::npos);
             EXPECT_NE(good(over + "--allow-hover").out.find("hang in the air"), std::string::npos);
           }},
          {"--allow-slide",
           [this] {
             Clip clip = readBvh(folder_ / "out/walk.bvh");
             for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).x() *= 0.6;
             expectSaid(clip, "--allow-slide", "feet slide");
           }},
          {"--allow-pops", [this] {
             Clip clip = readBvh(folder_ / "out/walk.bvh");
             const int neck = clip.skeleton.size() / 2;
             clip.poses.rotations(100)[neck] *=
                 Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX()));
             expectSaid(clip, "--allow-pops", "a joint jumps");
           }}};
}

TEST_F(ValidateOptions, AreAllTried) { expectAll("validate", {ofReading(), ofTheGround()}); }

}  // namespace
}  // namespace amble
