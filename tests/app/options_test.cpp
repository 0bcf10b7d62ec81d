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
                                      "convert", "inspect"}));
  EXPECT_EQ(listed("library", "Subcommands:"),
            (std::vector<std::string>{"build", "show", "add", "check", "find"}));
  EXPECT_EQ(optionsOf("library"), std::set<std::string>{});
  EXPECT_EQ(optionsOf(""), std::set<std::string>{"--version"});
}

TEST_F(Options, OfPlan) {
  write("in/scenario.yaml", kShort);
  const std::string plan = "plan in/scenario.yaml ";
  const auto reported = [&](const std::string& options) {
    return printed(plan + "-o out --formats bvh --json " + options);
  };
  const auto expectFiles = [&](const std::string& options, const std::set<std::string>& wanted) {
    good(plan + "-o some " + options);
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_ / "some")) {
      found.insert(entry.path().filename().string());
    }
    EXPECT_EQ(found, wanted);
  };
  expectEach(
      "plan",
      {{"--output",
        [&] {
          good(plan + "--formats json");
          EXPECT_TRUE(fs::exists(folder_ / "out/scenario/report.json"));
          good(plan + "--formats json --output there/it");
          EXPECT_TRUE(fs::exists(folder_ / "there/it/report.json"));
        }},
       {"--planner", [&] { EXPECT_EQ(reported("--planner rrt")["planner"], "rrt"); }},
       {"--seed", [&] { EXPECT_EQ(reported("--seed 9")["seed"], 9); }},
       {"--threads",
        [&] {
          good(plan + "-o one --formats bvh --threads 1");
          good(plan + "-o three --formats bvh --threads 3");
          EXPECT_EQ(read("one/walk.bvh"), read("three/walk.bvh"));
        }},
       {"--time-limit",
        [&] {
          EXPECT_NE(good(plan + "-o out --time-limit 0.001", 1).err.find("time limit"),
                    std::string::npos);
        }},
       {"--fps",
        [&] {
          const json report = reported("--fps 120");
          EXPECT_NEAR(report["frame_time"].get<double>(), 1.0 / 120.0, 1e-8);
          EXPECT_NEAR(readBvh(folder_ / "out/walk.bvh").frame_time, 1.0 / 120.0, 1e-7);
        }},
       {"--bvh-units",
        [&] {
          EXPECT_EQ(reported("--bvh-units cm")["bvh_unit"], 0.01);
          const Clip cm = readBvh(folder_ / "out/walk.bvh", {.metres_per_unit = 0.01});
          reported("--bvh-units m");
          const Clip m = readBvh(folder_ / "out/walk.bvh");
          ASSERT_EQ(cm.frames(), m.frames());
          EXPECT_LT((cm.poses.p_WR(100) - m.poses.p_WR(100)).norm(), 1e-5);
        }},
       {"--formats",
        [&] {
          expectFiles("--formats svg", {"top.svg"});
          expectFiles("--formats strip,json", {"report.json", "strip.png"});
          expectFiles("--formats bvh --formats png", {"walk.bvh", "walk.png"});
        }},
       {"--checker",
        [&] {
          good(plan + "-o fast --formats bvh --checker fast");
          good(plan + "-o fcl --formats bvh --checker fcl");
          EXPECT_EQ(read("fast/walk.bvh"), read("fcl/walk.bvh"));
        }},
       {"--memory", [&] { expectMemoryBounds("plan in/of-mesh.yaml -o out --formats json"); }},
       {"--json",
        [&] {
          json out = printed(plan + "-o out --formats json --json");
          json file = json::parse(read("out/report.json"));
          out.erase("times");
          file.erase("times");
          EXPECT_EQ(out, file);
        }},
       {"--list-planners", [&] {
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
        }}});
}

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
                 good("plan in/scenario.yaml -o out --formats bvh");
                 EXPECT_NE(read("in/scenario.yaml").find(sha256OfFile(folder_ / "out/walk.bvh")),
                           std::string::npos);
                 write("in/scenario.yaml", kShort);
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

TEST_F(Options, OfValidate) {
  good("plan in/scenario.yaml -o out --formats bvh");
  write("in/low.yaml", kRoom + "  - {name: beam, box: {size: [0.2, 4, 1]}, at: [3, 2, 2.2]}\n");
  write("in/two.yaml", kRoom + "  - {name: loft, box: {size: [6, 4, 0.1]}, at: [3, 2, 2.95]}\n");
  const std::string bare = "validate out/walk.bvh ";
  const std::string validate = bare + "--scene in/room.yaml --json ";
  const json plain = printed(validate);
  expectEach(
      "validate",
      {{"--scene",
        [&] {
          expectRefused(bare, {"--scene"});
          const json beam = printed(bare + "--scene in/low.yaml --height 1.9 --json", 1);
          EXPECT_NE(beam["contacts"].dump().find("beam"), std::string::npos);
        }},
       {"--unit",
        [&] {
          expectRefused(validate + "--unit 0.01", {"0.01634 m tall", "--unit"});
          EXPECT_EQ(printed(validate + "--unit 1"), plain);
        }},
       {"--up",
        [&] {
          EXPECT_EQ(printed(validate + "--up y"), plain);
          EXPECT_FALSE(printed(validate + "--up z", 1)["contacts"].empty());
        }},
       {"--height", [&] { EXPECT_EQ(printed(validate + "--height 1.7", 0)["stature"], 1.7); }},
       {"--fps",
        [&] {
          const int frames = plain["frames"];
          EXPECT_EQ(plain["poses_checked"], frames);
          EXPECT_EQ(printed(validate + "--fps 240")["poses_checked"], 4 * (frames - 1) + 1);
        }},
       {"--memory",
        [&] {
          writeGrid();
          expectRefused(bare + "--scene in/mesh.yaml --memory 1", {"more than 1 MB"});
        }},
       {"--floor",
        [&] {
          EXPECT_EQ(plain["floor"], 0.0);
          EXPECT_EQ(printed(validate + "--floor 3")["floor"], 3.0);
        }},
       {"--max-slope",
        [&] {
          write("in/tilted.yaml",
                "name: tilted\nobjects:\n  - {name: floor, box: {size: [8, 6, 0.1]}, "
                "rotate: [0, -5, 0], at: [3, 2, 0.2]}\n");
          write("in/up.yaml", "scene: tilted.yaml\n" + kScenario.substr(kScenario.find("start")));
          good("plan in/up.yaml -o up --formats bvh");
          good("validate up/walk.bvh --scene in/tilted.yaml --max-slope 6");
          expectRefused("validate up/walk.bvh --scene in/tilted.yaml --max-slope 4",
                        {"'in/tilted.yaml' has no floor"});
        }},
       {"--max-climb",
        [&] {
          write("in/kerb.yaml",
                kRoom + "  - {name: kerb, box: {size: [3, 4, 0.15]}, at: [4.5, 2, 0.075]}\n");
          write("in/up.yaml", "scene: kerb.yaml\n" + kScenario.substr(kScenario.find("start")));
          good("plan in/up.yaml -o up --formats bvh");
          const std::string over = "validate up/walk.bvh --scene in/kerb.yaml ";
          good(over + "--max-climb 0.16 --max-drop 0");
          EXPECT_NE(good(over + "--max-climb 0.1", 1).out.find("over"), std::string::npos);
        }},
       {"--max-drop",
        [&] {
          write("in/down.yaml",
                "scene: kerb.yaml\nstart: {at: [5, 2], heading: 180}\n"
                "goal: {at: [1, 2], heading: 180}\n");
          good("plan in/down.yaml -o down --formats bvh");
          const std::string over = "validate down/walk.bvh --scene in/kerb.yaml ";
          good(over + "--max-climb 0 --max-drop 0.16");
          good(over + "--max-drop 0.1", 1);
        }},
       {"--allow-hover",
        [&] {
          write("in/sunk.yaml",
                "name: sunk\nobjects:\n  - {name: floor, box: {size: [6, 4, 0.1]}, "
                "at: [3, 2, -0.08]}\n");
          const std::string over = bare + "--scene in/sunk.yaml --floor -0.03 ";
          EXPECT_NE(good(over, 1).out.find("hang in the air"), std::string::npos);
          EXPECT_NE(good(over + "--allow-hover").out.find("hang in the air"), std::string::npos);
        }},
       {"--json", [&] { EXPECT_EQ(plain["file"], "out/walk.bvh"); }}});
}

TEST_F(Options, OfAnimate) {
  // The walk between its start and its stop, as analyse measures it.
  const auto gait = [&](const std::string& options) {
    good("animate -o a.bvh --duration 8 " + options);
    good("convert a.bvh -o b.bvh --trim 2s:6s");
    return printed("analyse b.bvh --json")[0]["gait"];
  };
  const auto number = [](const json& value) { return value.get<double>(); };
  const auto clipOf = [&](const std::string& options) {
    good("animate -o a.bvh --duration 4 " + options);
    return readBvh(folder_ / "a.bvh");
  };
  const auto rise = [](const Clip& clip) -> Eigen::Vector3d {
    return clip.poses.p_WR(clip.frames() - 1) - clip.poses.p_WR(0);
  };
  const json plain = gait("");
  expectEach("animate",
             {{"--output",
               [&] {
                 expectRefused("animate", {"--output"});
                 const std::string streamed = good("animate --duration 2 -o -").out;
                 good("animate --duration 2 --output a.bvh");
                 EXPECT_EQ(read("a.bvh"), streamed);
               }},
              {"--speed", [&] { EXPECT_NEAR(number(gait("--speed 0.8")["speed"]), 0.8, 0.01); }},
              {"--turn",
               [&] {
                 EXPECT_NEAR(number(gait("--turn 20")["turn_rate"]), 20.0, 0.5);
                 EXPECT_NEAR(number(gait("--turn -20")["turn_rate"]), -20.0, 0.5);
               }},
              {"--duration",
               [&] {
                 for (const double wanted : {3.0, 6.0}) {
                   good("animate -o a.bvh --duration " + std::to_string(wanted));
                   EXPECT_NEAR(readBvh(folder_ / "a.bvh").duration(), wanted, 0.3);
                 }
               }},
              {"--stride",
               [&] { EXPECT_NEAR(number(gait("--stride 0.55")["step_length"]), 0.55, 0.011); }},
              {"--lift", [&] { EXPECT_NEAR(number(gait("--lift 0.12")["lift"]), 0.12, 0.0025); }},
              {"--incline",
               [&] {
                 const Eigen::Vector3d up = rise(clipOf("--incline 8"));
                 EXPECT_NEAR(up.z(), up.x() * std::tan(8.0 * kDegree), 0.02);
               }},
              {"--stairs",
               [&] {
                 const double risers = rise(clipOf("--stairs .15,.3")).z() / 0.15;
                 EXPECT_NEAR(risers, std::round(risers), 0.1);
                 EXPECT_GE(risers, 1.9);
                 EXPECT_LE(rise(clipOf("--stairs -.15,.3")).z(), -0.28);
                 for (const char* const also : {"--turn 5", "--stride 0.6", "--incline 3"}) {
                   expectRefused(std::string("animate -o a.bvh --stairs .15,.3 ") + also,
                                 {"--stairs"});
                 }
               }},
              {"--height",
               [&] {
                 const double leg = number(plain["leg_length"]);
                 EXPECT_NEAR(number(gait("--height 1.5")["leg_length"]), leg * 1.5 / 1.634, 0.002);
               }},
              {"--action",
               [&] {
                 const Clip free = clipOf(""), carrying = clipOf("--action carry");
                 ASSERT_EQ(free.frames(), carrying.frames());
                 const auto turned = [&](const char* const joint) {
                   const int j = free.skeleton.find(joint), middle = free.frames() / 2;
                   return free.poses.rotations(middle)[j].angularDistance(
                       carrying.poses.rotations(middle)[j]);
                 };
                 EXPECT_GT(turned("LeftForeArm"), 0.5);
                 EXPECT_LT(turned("LeftLeg"), 1e-9);
               }},
              {"--library",
               [&] {
                 const Clip named = clipOf("--library default");
                 EXPECT_EQ(named.frames(), clipOf("").frames());
                 expectRefused("animate -o a.bvh --library in/none.yaml", {"in/none.yaml: "});
               }},
              {"--fps", [&] { EXPECT_NEAR(clipOf("--fps 30").frame_time, 1.0 / 30.0, 1e-6); }},
              {"--bvh-units",
               [&] {
                 const Eigen::Vector3d m = rise(clipOf("")), cm = rise(clipOf("--bvh-units cm"));
                 EXPECT_LT((cm - 100.0 * m).norm(), 1e-3);
               }},
              {"--quality", [&] {
                 const Ran judged = good("animate -o a.bvh --duration 4 --quality");
                 EXPECT_NE(judged.out.find("toe skate"), std::string::npos);
                 EXPECT_EQ(judged.out.find("ABOVE"), std::string::npos) << judged.out;
               }}});
}

}  // namespace
}  // namespace amble
