// Every option of every command does what the help says of it: each test runs all options of a
// command, and fails for one that the help has and no line here.

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/rotation.h"
#include "base/sha256.h"
#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kWalk = captureFolder() + "accad_female1/Female1_B03_Walk1.bvh";
const char* const kShort =
    "scene: room.yaml\nstart: {at: [1, 2], heading: 0}\ngoal: {at: [2, 2], heading: 0}\n";
const std::string kTwoTakes = std::string(AMBLE_SHARED) + "/cases/captures/g4_idle_and_walk.gltf";

class Options : public InRoom {
 protected:
  /// What an option is seen to do, by its long name.
  using Uses = std::map<std::string, std::function<void()>>;

  /// First words of the lines of a part of the help, such as "Subcommands:".
  std::vector<std::string> listed(const std::string& command, const std::string& part) const {
    std::istringstream help(run(command + " --help").out);
    std::vector<std::string> words;
    bool within = false;
    for (std::string line; std::getline(help, line);) {
      if (line == part || line.empty()) within = line == part;
      if (within && line.starts_with("  ") && line[2] != ' ') {
        words.push_back(line.substr(2, line.find(' ', 2) - 2));
      }
    }
    return words;
  }
  /// Long names of a command's options but --help.
  std::set<std::string> optionsOf(const std::string& command) const {
    std::set<std::string> names;
    for (const std::string& word : listed(command, "Options:")) {
      const size_t longer = word.find("--");
      if (longer != word.npos && !word.ends_with("--help")) names.insert(word.substr(longer));
    }
    return names;
  }
  void expectEach(const std::string& command, const Uses& uses) const {
    std::set<std::string> used;
    for (const auto& [option, use] : uses) used.insert(option);
    EXPECT_EQ(optionsOf(command), used);
    for (const auto& [option, use] : uses) {
      SCOPED_TRACE("amble " + command + " " + option);
      use();
    }
  }
  Ran good(const std::string& arguments, int status = 0) const {
    Ran ran = run(arguments);
    EXPECT_EQ(ran.status, status) << "amble " << arguments << '\n' << ran.out << ran.err;
    return ran;
  }
  json printed(const std::string& arguments, int status = 0) const {
    return json::parse(good(arguments, status).out);
  }
  /// A mesh of 28,000 triangles, which do not fit into a megabyte.
  void writeGrid() const {
    constexpr int kSide = 120;
    std::ostringstream grid;
    for (int i = 0; i < kSide * kSide; ++i) {
      grid << "v " << 0.05 * (i % kSide) << ' ' << 0.03 * static_cast<int>(i / kSide) << " 0\n";
    }
    for (int i = 0; i + kSide + 1 < kSide * kSide; ++i) {
      if (i % kSide + 1 == kSide) continue;
      grid << "f " << i + 1 << ' ' << i + 2 << ' ' << i + kSide + 2 << ' ' << i + kSide + 1 << '\n';
    }
    write("in/grid.obj", grid.str());
    write("in/mesh.yaml", kRoom + "  - {name: grid, mesh: grid.obj, up: z, at: [0, 0, 0]}\n");
    write("in/of-mesh.yaml", "scene: mesh.yaml\n" + kScenario.substr(kScenario.find("start")));
  }
  void expectMemoryBounds(const std::string& arguments) const {
    writeGrid();
    expectRefused(arguments + " --memory 1", {"more than 1 MB", "--memory"});
    good(arguments + " --memory 700");
  }
};

class CaptureOptions : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    if (!fs::exists(kWalk) || !fs::exists(kTwoTakes)) GTEST_SKIP() << "no " << AMBLE_SHARED;
    fs::copy_file(kWalk, folder_ / "in/walk.bvh");
    fs::copy_file(captureFolder() + "cmu_asfamc/07_05-walk.amc", folder_ / "in/trial.amc");
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
           expectRefused(call(kTwoTakes) + " --memory 1", {"more than 1 MB", "--memory MB"});
         }},
    };
  }
  /// The same for a command that prints what it read.
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
                json({{"metres", 0.02}, {"guessed", false}, {"sure", true}}));
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

TEST_F(CaptureOptions, OfAnalyse) {
  Uses uses = readingPrinted("analyse");
  const std::string start = captureFolder() + "cmu_mb2/07_01.bvh";  // a T-pose first
  uses["--as-is"] = [&] {
    EXPECT_EQ(printed("analyse --json " + start)[0]["first_frame"], 1);
    EXPECT_EQ(printed("analyse --json --as-is " + start)[0]["first_frame"], 0);
  };
  uses["--plants"] = [&] {
    good("analyse in/walk.bvh --plants out/{stem}.csv");
    EXPECT_TRUE(read("out/walk.csv").starts_with("frame,left,right\n0,"));
  };
  uses["--plot"] = [&] {
    good("analyse in/walk.bvh --plot out/");
    EXPECT_NE(read("out/walk.svg").find("<svg "), std::string::npos);
  };
  uses["--threads"] = [&] {
    const std::string two = "analyse --json in/walk.bvh " + start;
    EXPECT_EQ(good(two + " --threads 1").out, good(two + " --threads 2").out);
  };
  uses["--json"] = [&] { EXPECT_EQ(printed("analyse --json in/walk.bvh")[0]["kind"], "clip"); };
  expectEach("analyse", uses);
}

TEST_F(CaptureOptions, OfInspect) {
  Uses uses = readingPrinted("inspect");
  uses["--memory"] = [&] { expectMemoryBounds("inspect in/grid.obj"); };
  uses["--json"] = [&] { EXPECT_EQ(printed("inspect --json in/walk.bvh")[0]["frames"], 230); };
  expectEach("inspect", uses);
}

TEST_F(CaptureOptions, OfConvert) {
  const auto call = [](const std::string& clip) { return "convert -o out.bvh '" + clip + "'"; };
  const auto said = [&](const std::string& option, const std::string& fact) {
    EXPECT_NE(good(call("in/walk.bvh") + " " + option).out.find(fact), std::string::npos) << fact;
    return readBvh(folder_ / "out.bvh");
  };
  const Clip plain = said("", "0.01 m, guessed");
  Uses uses = reading(call);
  uses["--unit"] = [&] {
    EXPECT_NEAR(said("--unit 0.02", "0.02 m, as asked").poses.p_WR(9).norm(),
                2.0 * plain.poses.p_WR(9).norm(), 1e-4);
  };
  uses["--up"] = [&] {
    const Eigen::Vector3d p = said("--up z", "z, as asked").poses.p_WR(9);
    EXPECT_LT((p - Eigen::Vector3d(plain.poses.p_WR(9).x(), plain.poses.p_WR(9).z(),
                                   -plain.poses.p_WR(9).y()))
                  .norm(),
              1e-4);
  };
  uses["--facing"] = [&] { said("--facing 90", "90.0 degrees, as asked"); };
  uses["--file-fps"] = [&] { EXPECT_EQ(said("--file-fps 50", "230 frames").frame_time, 0.02); };
  uses["--take"] = [&] {
    good(call(kTwoTakes) + " --take Idle");
    EXPECT_EQ(readBvh(folder_ / "out.bvh").frames(), 400);
  };
  uses["--output"] = [&] { expectRefused("convert in/walk.bvh", {"--output"}); };
  uses["--fps"] = [&] {
    const Clip twice = said("--fps 60", "459 frames");
    EXPECT_LT((twice.poses.p_WR(100) - plain.poses.p_WR(50)).norm(), 1e-4);
  };
  uses["--trim"] = [&] { EXPECT_EQ(said("--trim 10:39", "30 frames").frames(), 30); };
  uses["--mirror"] = [&] {
    const Clip mirrored = said("--mirror", "230 frames");
    good("convert out.bvh -o back.bvh --mirror");
    const Clip back = readBvh(folder_ / "back.bvh");
    EXPECT_GT((mirrored.poses.p_WR(100) - plain.poses.p_WR(100)).norm(), 0.1);
    EXPECT_LT((back.poses.p_WR(100) - plain.poses.p_WR(100)).norm(), 1e-4);
  };
  uses["--bvh-units"] = [&] {
    EXPECT_NEAR(said("--bvh-units cm", "230 frames").poses.p_WR(9).norm(),
                100.0 * plain.poses.p_WR(9).norm(), 1e-3);
  };
  expectEach("convert", uses);
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
  expectEach("library check",
             {{"--captures", [&] {
                 EXPECT_NE(good("library check in/it.yaml").out.find("were not read"),
                           std::string::npos);
                 good("library check in/it.yaml --captures " + mocap);
                 std::string text = read("in/it.yaml");
                 const size_t speed = text.find("speed: 1");
                 ASSERT_NE(speed, text.npos);
                 text[text.find('.', speed) + 1] ^= 1;  // a tenth of a metre a second off
                 write("in/it.yaml", text);
                 const Ran checked = good("library check in/it.yaml --captures " + mocap, 1);
                 EXPECT_NE(checked.out.find("measured 1"), std::string::npos) << checked.out;
               }}});
}

TEST_F(CaptureOptions, OfLibraryAdd) {
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
  uses["--no-mirror"] = [&] {
    EXPECT_EQ(made("--no-mirror").size(), 1u);
    EXPECT_EQ(plain.size(), 2u);
  };
  uses["--licence"] = [&] { EXPECT_EQ(made("--licence 'A B'")[0]["source"]["licence"], "A B"); };
  uses["--credit"] = [&] { EXPECT_EQ(made("--credit 'C D'")[0]["source"]["credit"], "C D"); };
  expectEach("library add", uses);
}

TEST_F(CaptureOptions, OfLibraryFind) {
  const std::string find = "library find in/walk.bvh --type walk ";
  Uses uses = reading([](const std::string& clip) {
    return "library find --type walk --at-least 0 '" + clip + "'";
  });
  const auto found = [&](const std::string& option, int status) {
    return printed(find + option + " --json", status);
  };
  uses["--unit"] = [&] { EXPECT_EQ(found("--unit 0.01", 0), found("", 0)); };
  uses["--up"] = [&] {
    EXPECT_EQ(found("--up y", 0), found("", 0));
    good("library find --type walk --up z " + captureFolder() + "cmu_mb2/07_01.bvh", 1);
  };
  uses["--facing"] = [&] { EXPECT_EQ(found("--facing 90", 0)[0]["share"], 1.0); };
  uses["--file-fps"] = [&] { found("--file-fps 1000", 1); };
  uses["--type"] = [&] {
    expectRefused("library find in/walk.bvh", {"--type"});
    good("library find in/walk.bvh --type jump", 1);
  };
  uses["--at-least"] = [&] {
    EXPECT_EQ(printed("library find in/walk.bvh --type jump --at-least 0 --json")[0]["share"], 0.0);
    found("--at-least 100%", 0);
  };
  uses["--threads"] = [&] { EXPECT_EQ(found("--threads 1", 0), found("--threads 2", 0)); };
  uses["--json"] = [&] { EXPECT_EQ(found("", 0)[0]["largest"], "walk"); };
  expectEach("library find", uses);
}

}  // namespace
}  // namespace amble
