// What is said for machines and what is said for people is the same; what is wrong is one line.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The number behind some words of a text; NaN where there is none.
double after(const std::string& text, const std::string& words) {
  const size_t at = text.find(words);
  if (at == std::string::npos) return std::nan("");
  return std::strtod(text.c_str() + at + words.size(), nullptr);
}

double of(const json& value) { return value.get<double>(); }

class Figures : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    write("in/room.yaml",
          kRoom + "  - {name: pillar, cylinder: {radius: 0.3, height: 2.5}, at: [3, 3.2, 1.25]}\n");
  }
  /// Both of a command; the same exit status.
  std::pair<json, std::string> both(const std::string& arguments, int status = 0) const {
    const Ran machine = run(arguments + " --json"), people = run(arguments);
    EXPECT_EQ(machine.status, status) << arguments << '\n' << machine.err;
    EXPECT_EQ(people.status, status) << arguments << '\n' << people.err;
    EXPECT_EQ(machine.err, people.err) << arguments;
    return {json::parse(machine.out), people.out};
  }
};

TEST_F(Figures, OfPlanAreThoseOfTheReport) {
  const auto [report, text] = both("plan in/scenario.yaml -o out");
  EXPECT_NEAR(after(text, "walk       "), of(report["length"]), 0.0051);
  EXPECT_NEAR(after(text, " m, "), of(report["duration"]), 0.0051);
  EXPECT_EQ(after(text, " s, "), of(report["frames"]));
  EXPECT_EQ(after(text, "frames, "), report["steps"].size());
  EXPECT_NEAR(after(text, "clearance  "), of(report["clearance"]["min"]), 0.00051);
  EXPECT_NEAR(after(text, "foot skate "), 1000.0 * of(report["foot_skate"]["max"]), 0.051);
  EXPECT_EQ(after(text, "roadmap    "), of(report["roadmap"]["guards"]));
  EXPECT_NE(text.find(report["clearance"]["part"].get<std::string>() + " and pillar"),
            std::string::npos);
}

TEST_F(Figures, OfPlanWithoutAWalkAreThoseOfTheReport) {
  wallOff();
  write("in/scenario.yaml", kScenario + "planner: {max_failures: 3}\n");
  const auto [report, text] = both("plan in/scenario.yaml -o out", 1);
  EXPECT_EQ(report["status"], "no_walk");
  EXPECT_NE(text.find("scenario: no_walk"), std::string::npos);
  EXPECT_NE(text.find("why        " + report["why"].get<std::string>() + "\n"), std::string::npos);
}

TEST_F(Figures, OfCheckAreThoseOfItsTable) {
  const auto [rows, text] = both("check in");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(after(text, "solved"), of(rows[0]["length"]), 0.0051);
  EXPECT_NEAR(after(text, " s "), of(rows[0]["clearance"]), 0.00051);
  EXPECT_NE(text.find("1 scenarios: 1 as expected"), std::string::npos);
}

TEST_F(Figures, OfValidateAreThoseOfItsText) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats bvh").status, 0);
  const auto [found, text] = both("validate out/walk.bvh --scene in/room.yaml --fps 120");
  EXPECT_EQ(after(text, "walk.bvh: "), of(found["frames"]));
  EXPECT_EQ(after(text, " s, "), of(found["poses_checked"]));
  EXPECT_NEAR(after(text, "body         "), of(found["stature"]), 0.00051);
  EXPECT_NEAR(after(text, "clearance    "), of(found["clearance"]["min"]), 0.00051);
  EXPECT_NEAR(after(text, "foot skate   "), 1000.0 * of(found["foot_skate"]["mean"]), 0.051);
  EXPECT_NEAR(after(text, "mean, "), 1000.0 * of(found["foot_skate"]["max"]), 0.051);
  EXPECT_EQ(after(text, "largest, of "), of(found["plants"]));
  EXPECT_NEAR(after(text, "hover        "), 1000.0 * of(found["hover"]["max"]), 0.051);
  EXPECT_NEAR(after(text, "steps        "), of(found["steps"]["up"]), 0.00051);
  EXPECT_NEAR(after(text, "penetration  "), 1000.0 * of(found["ground_penetration"]["max"]), 0.051);
  EXPECT_TRUE(found["contacts"].empty());
  EXPECT_NE(text.find("contact      none"), std::string::npos);
}

TEST_F(Figures, OfValidatesContactsAreThoseOfItsText) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats bvh").status, 0);
  wallOff();
  const auto [found, text] = both("validate out/walk.bvh --scene in/room.yaml", 1);
  size_t lines = 0;
  for (size_t at = 0; (at = text.find("\n  contact ", at)) != text.npos; ++at) ++lines;
  EXPECT_EQ(lines, found["contacts"].size());
  double start = 0.0;
  for (const json& contact : found["contacts"]) {
    EXPECT_LE(start, of(contact["start"])) << "in order of their start";
    EXPECT_LE(of(contact["start"]), of(contact["end"]));
    start = contact["start"];
  }
}

TEST_F(Figures, OfAnalyseAreThoseOfItsText) {
  ASSERT_EQ(run("animate -o a.bvh --duration 6 --turn 12").status, 0);
  const auto [all, text] = both("analyse a.bvh");
  const json& gait = all[0]["gait"];
  EXPECT_EQ(after(text, "frames      "), of(all[0]["frames"]));
  EXPECT_NEAR(after(text, "s: "), of(gait["speed"]), 0.00051);
  EXPECT_NEAR(after(text, "turning "), of(gait["turn_rate"]), 0.051);
  EXPECT_NEAR(after(text, "lifted "), of(gait["lift"]), 0.00051);
  EXPECT_NEAR(after(text, "support     double "), of(gait["double_support"]), 0.00051);
  EXPECT_NE(text.find("type        " + all[0]["class"]["type"].get<std::string>()),
            std::string::npos);
  int left = 0;
  for (const json& plant : all[0]["plants"]) left += plant["foot"] == "left" ? 1 : 0;
  EXPECT_EQ(after(text, "plants      "), left);
}

TEST_F(Figures, OfInspectAreThoseOfItsText) {
  ASSERT_EQ(run("animate -o in/a.bvh --duration 3").status, 0);
  write("in/t.obj", "o thing\nv 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
  const auto [all, text] = both("inspect in/room.yaml in/scenario.yaml in/a.bvh in/t.obj");
  ASSERT_EQ(all.size(), 4u);
  for (const json& each : all) {
    EXPECT_NE(text.find(each["file"].get<std::string>() + ": " + each["kind"].get<std::string>()),
              std::string::npos);
    for (const json& warning : each["warnings"]) {
      EXPECT_NE(text.find("  warning: " + warning.get<std::string>()), std::string::npos);
    }
  }
  EXPECT_NEAR(after(text, "size     "), of(all[0]["bounds"]["max"][0]), 0.0051);
  EXPECT_EQ(after(text, "objects  "), all[0]["objects"].size());
  EXPECT_EQ(after(text, "frames     "), of(all[2]["frames"]));
  EXPECT_EQ(after(text, "joints     "), of(all[2]["joints"]));
  EXPECT_NEAR(after(text, "travels "), of(all[2]["root_travel"]), 0.00051);
  EXPECT_EQ(all[3]["triangles"], 1);
}

TEST_F(Figures, OfAMeshAreInTheAxesAndUnitThatAreAskedFor) {
  write("in/t.obj", "o thing\nv 0 0 0\nv 100 0 0\nv 0 200 300\nf 1 2 3\n");
  const auto [asked, text] = both("inspect in/t.obj --up y --unit 0.01");
  EXPECT_EQ(asked[0]["bounds"]["min"], (std::vector<double>{0, -3, 0}));
  EXPECT_EQ(asked[0]["bounds"]["max"], (std::vector<double>{1, 0, 2}));
  EXPECT_NE(text.find("1.00 x 3.00 x 2.00 m"), std::string::npos) << text;
  EXPECT_EQ(text.find("which axis is up"), std::string::npos) << text;
}

TEST_F(Figures, OfLibrariesAreThoseOfItsText) {
  const auto [all, text] = both("library show default");
  EXPECT_EQ(after(text, "skeleton                 "), of(all[0]["joints"]));
  for (const json& motion : all[0]["motions"]) {
    const size_t at = text.find("\n  " + motion["name"].get<std::string>() + " ");
    ASSERT_NE(at, text.npos) << motion["name"];
    const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    EXPECT_NE(line.find(motion["source"]["clip"].get<std::string>()), line.npos) << line;
    if (!motion.contains("turn_rate")) continue;
    EXPECT_NEAR(after(line, "walk, "), of(motion["speed"]), 0.00051) << line;
    EXPECT_NEAR(after(line, "m/s, "), of(motion["turn_rate"]), 0.051) << line;
    EXPECT_NEAR(after(line, "period "), of(motion["period"]), 0.00051) << line;
  }
}

// Two letters exchanged, at each place of the name.
std::vector<std::string> slipsOf(const std::string& name, size_t from) {
  std::vector<std::string> slips;
  for (size_t i = from; i + 1 < name.size(); i += 2) {
    std::string slip = name;
    std::swap(slip[i], slip[i + 1]);
    if (slip != name) slips.push_back(slip);
  }
  return slips;
}

TEST_F(Figures, EveryMistypedCommandIsNamedWithTheOneThatWasMeant) {
  for (const std::string command :
       {"plan", "check", "validate", "animate", "analyse", "library", "edit", "convert", "graft",
        "inspect", "roadmap", "graph", "view"}) {
    for (const std::string& slip : slipsOf(command, 1)) {
      expectRefused(slip,
                    {"amble: there is no command '" + slip + "'; expected '" + command + "'"});
    }
  }
}

TEST_F(Figures, EveryMistypedOptionIsNamedWithTheOneThatWasMeant) {
  const std::pair<const char*, std::vector<std::string>> kOptions[] = {
      {"plan", {"--planner", "--time-limit", "--bvh-units", "--formats", "--list-planners"}},
      {"check", {"--junit", "--update", "--judge-times"}},
      {"validate", {"--scene", "--allow-hover", "--max-slope", "--height"}},
      {"animate", {"--duration", "--stride", "--incline", "--stairs", "--quality"}},
      {"library add", {"--turning", "--no-mirror", "--licence", "--credit"}},
      {"analyse", {"--file-fps", "--facing", "--plants", "--roles"}}};
  for (const auto& [command, options] : kOptions) {
    for (const std::string& option : options) {
      const std::string slip = slipsOf(option, 2).back();
      expectRefused(std::string(command) + " " + slip, {"amble " + std::string(command) + ": ",
                                                        "'" + slip + "'; expected '" + option});
    }
  }
}

TEST_F(Figures, WhatIsNoInputIsOneLineForEveryCommand) {
  fs::create_directories(folder_ / "in/folder.bvh");
  write("in/empty.bvh", "");
  write("in/noise.bvh", std::string("\x89PNG\r\n\x1a\n\0\xff\xfe\x1b[31m", 19) + "\n");
  write("in/empty.yaml", "");
  write("in/noise.yaml", "\x1b[31m: [\x07\n");
  write("in/list.yaml", "- 1\n- 2\n");
  for (const std::string kind : {"empty", "noise"}) {
    for (const std::string& call :
         {"analyse in/" + kind + ".bvh", "inspect in/" + kind + ".bvh",
          "convert in/" + kind + ".bvh -o out.bvh", "library add l.yaml in/" + kind + ".bvh",
          "validate in/" + kind + ".bvh --scene in/room.yaml",
          "library find --type walk in/" + kind + ".bvh"}) {
      const Ran ran = run(call);
      EXPECT_EQ(ran.status, 2) << call;
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << call << '\n' << ran.err;
      EXPECT_EQ(ran.err.find_first_of("\x1b\x07\r"), std::string::npos) << call << '\n' << ran.err;
      EXPECT_NE(ran.err.find("; expected "), std::string::npos) << call << '\n' << ran.err;
    }
  }
  for (const std::string kind : {"empty", "noise", "list"}) {
    for (const std::string& call :
         {"plan in/" + kind + ".yaml -o out", "inspect in/" + kind + ".yaml",
          "library show in/" + kind + ".yaml", "library build in/" + kind + ".yaml -o l.yaml",
          "validate in/none.bvh --scene in/" + kind + ".yaml",
          "animate -o a.bvh --library in/" + kind + ".yaml",
          "library check in/" + kind + ".yaml"}) {
      const Ran ran = run(call);
      EXPECT_EQ(ran.status, 2) << call;
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << call << '\n' << ran.err;
      EXPECT_EQ(ran.err.find_first_of("\x1b\x07\r"), std::string::npos) << call << '\n' << ran.err;
    }
  }
  EXPECT_FALSE(fs::exists(folder_ / "out.bvh"));
  EXPECT_FALSE(fs::exists(folder_ / "l.yaml"));
}

class ClipSources : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    ASSERT_EQ(run("animate -o clips/b/walk.bvh --duration 2", "mkdir -p clips/b clips/a;").status,
              0);
    fs::copy_file(folder_ / "clips/b/walk.bvh", folder_ / "clips/a/stroll.bvh");
    write("clips/notes.txt", "no clip");
  }
};

TEST_F(ClipSources, AFolderIsAllOfItsClipsByName) {
  const json all = json::parse(run("analyse --json clips").out);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["file"], "clips/a/stroll.bvh");
  EXPECT_EQ(all[1]["file"], "clips/b/walk.bvh");
}

TEST_F(ClipSources, StandardInputIsAClipOnce) {
  const json all = json::parse(run("analyse --json - < clips/b/walk.bvh").out);
  EXPECT_EQ(all[0]["file"], "-");
  expectRefused("analyse - - < clips/b/walk.bvh", {"-: is given twice; expected one"});
  EXPECT_EQ(run("analyse - --plants 'out/{stem}.csv' < clips/b/walk.bvh").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/stdin.csv"));
}

TEST_F(ClipSources, EachClipHasAFileOfItsOwn) {
  EXPECT_EQ(run("analyse clips --plants 'out/{stem}-{stem}.csv' --plot plots/").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/walk-walk.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out/stroll-stroll.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "plots/walk.svg"));
  fs::copy_file(folder_ / "clips/b/walk.bvh", folder_ / "clips/a/walk.bvh");
  expectRefused("analyse clips --plants more/", {"--plants more/: gives two clips the name"});
}

}  // namespace
}  // namespace amble
