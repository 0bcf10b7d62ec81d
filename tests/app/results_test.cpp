// What is in the results' folder after runs that end well, badly, or not at all.

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

// What Ctrl-C does, SIGTERM does: a shell has its background jobs ignore SIGINT.
const std::string kStopped = " & pid=$!; sleep 1; kill -TERM $pid; wait $pid";

class Results : public InRoom {
 protected:
  std::set<std::string> results() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(Results, CtrlCLeavesAnEarlierWalkWithItsReport) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out").status, 0);
  const std::string walk = read("out/walk.bvh"), report = read("out/report.json");
  makeEndless();
  const Ran ran = run("plan in/scenario.yaml -o out" + kStopped);
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_NE(ran.err.find("stopped; nothing was written to out"), std::string::npos) << ran.err;
  EXPECT_EQ(read("out/walk.bvh"), walk);
  EXPECT_EQ(read("out/report.json"), report);
  EXPECT_EQ(results(), (std::set<std::string>{"report.html", "report.json", "top.svg", "walk.bvh",
                                              "walk.html", "walk.png"}));
}

TEST_F(Results, OfTwoRunsNoneIsMixed) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out").status, 0);
  write("out/notes.txt", "the user's own");
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats bvh --seed 7").status, 0);
  EXPECT_EQ(results(), (std::set<std::string>{"notes.txt", "walk.bvh"}));
  wallOff();
  write("in/scenario.yaml", kScenario + "planner: {max_failures: 3}\n");
  EXPECT_EQ(run("plan in/scenario.yaml -o out --formats json").status, 1);
  EXPECT_EQ(results(), (std::set<std::string>{"notes.txt", "report.json"}));
}

// They are made at once on all threads.
TEST_F(Results, FilesAreTheSameAtAnyNumberOfThreads) {
  const std::string plan =
      "plan in/scenario.yaml --formats bvh,json,svg,png,html,report,views,strip,glb,csv,npz,sdf ";
  ASSERT_EQ(run(plan + "-o one --threads 1").status, 0);
  ASSERT_EQ(run(plan + "-o out --threads 3").status, 0);
  EXPECT_EQ(results().size(), 19u);
  for (const std::string& name : results()) {
    if (name.starts_with("report.")) continue;  // they say how long each part took
    EXPECT_EQ(read("out/" + name), read("one/" + name)) << name;
  }
}

TEST_F(Results, OfALoadingThatTookTooLongThereIsTheReportAlone) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out").status, 0);
  const Ran late = run("plan in/scenario.yaml -o out --time-limit 0.001");
  EXPECT_EQ(late.status, 1) << late.err;
  EXPECT_NE(late.out.find("time limit passed while the scene was loaded"), std::string::npos);
  EXPECT_EQ(results(), (std::set<std::string>{"report.json"}));
}

TEST_F(Results, WhatAKilledRunLeftIsClearedByTheNext) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats json").status, 0);
  // The name that a process which is gone gave it.
  const Ran gone = run("--version & echo $!; wait $!");
  const std::string process = gone.out.substr(0, gone.out.find('\n'));
  write("out/walk.bvh.part-" + process + "-0", "half");
  write("out/report.json.part-" + process + "-1", "half");
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats json").status, 0);
  EXPECT_EQ(results(), (std::set<std::string>{"report.json"}));
}

TEST_F(Results, AnUpdateThatIsInterruptedChangesNoScenario) {
  makeEndless();
  const std::string before = read("in/scenario.yaml");
  const Ran ran = run("check in --update" + kStopped);
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_EQ(ran.out.find("differs"), std::string::npos) << ran.out;
  EXPECT_EQ(read("in/scenario.yaml"), before);
}

// A hall of 1,000 posts, whose names are all that markup, tables and paths trip over.
TEST_F(Results, OddNamesOfManyObjectsDoNoHarmInAnyFile) {
  const std::vector<std::string> odd = {"a'b`c",        "<script>alert(1)</script>",
                                        "\u691c\u5b50", "with space",
                                        "]]>--&amp;",   "}}{{",
                                        "new\\nline",   "a, b: #c",
                                        "../up/{0}%s",  "\\\"quoted\\\"",
                                        "\\x01\\x7f"};
  std::string room =
      "objects:\n  - {name: floor, box: {size: [30, 30, 0.1]}, at: [15, 15, -0.05]}\n";
  for (int i = 0; i < 1000; ++i) {
    const double x = 0.3 + 0.6 * (i % 50), y = 0.3 + 0.6 * (i / 50) + (i / 50 < 22 ? 0 : 11);
    room += "  - {name: \"" + odd[i % odd.size()] + std::to_string(i) +
            "\", box: {size: [0.1, 0.1, 0.4]}, at: [" + std::to_string(x) + ", " +
            std::to_string(y) + ", 0.2]}\n";
  }
  write("in/room.yaml", room);
  write("in/<b> \u691c 'x'.yaml",
        "scene: room.yaml\nstart: {at: [14, 16], heading: 0}\ngoal: {at: [16, 16], heading: 0}\n");
  const Ran ran =
      run("plan \"in/<b> \u691c 'x'.yaml\" -o out "
          "--formats bvh,json,svg,png,html,report,strip,glb,csv,npz,sdf");
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* name : {"top.svg", "walk.sdf", "walk.dae", "room.dae"}) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file((folder_ / "out" / name).c_str())) << name;
    EXPECT_FALSE(document.select_node("//script[contains(., 'alert')]")) << name;
  }
  EXPECT_TRUE(nlohmann::json::accept(read("out/report.json")));
  const std::string glb = read("out/walk.glb");
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  const auto names = nlohmann::json::parse(glb.substr(20, size))["nodes"];
  EXPECT_GT(names.size(), 1000u);
  for (const char* page : {"out/walk.html", "out/report.html"})
    EXPECT_EQ(read(page).find("<script>alert"), std::string::npos) << page;
  const std::string steps = read("out/steps.csv");
  EXPECT_EQ(std::count(steps.begin(), steps.end(), '\x01'), 0);
}

class Films : public Results {
 protected:
  // Instead of ffmpeg.
  void installFilmMaker(const std::string& script) const {
    write("bin/ffmpeg", "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder_ / "bin/ffmpeg", fs::perms::owner_all);
  }
  const std::string path_ = "PATH=$PWD/bin:$PATH;";
};

TEST_F(Films, WithoutFfmpegItIsSaidBeforeThePlanning) {
  makeEndless();
  expectRefused("plan in/scenario.yaml -o out --formats bvh,mp4",
                {"--formats: mp4 is made by the program ffmpeg, which is not installed; expected"},
                "PATH=/nowhere;");
}

TEST_F(Films, WhatFfmpegComplainsOfIsSaidAndNothingIsWritten) {
  installFilmMaker("echo \"Unknown encoder 'libx264'\" >&2; exit 3");
  expectRefused("plan in/scenario.yaml -o out --formats bvh,mp4",
                {"ffmpeg: ended with status 3: Unknown encoder 'libx264'; expected"}, path_);
}

TEST_F(Films, CtrlCWhileOneIsMadeLeavesNothing) {
  installFilmMaker("exec sleep 3");
  const Ran ran =
      run("plan in/scenario.yaml -o out --formats bvh,mp4 & pid=$!; sleep 2; kill -TERM $pid; wait "
          "$pid",
          path_);
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_NE(ran.err.find("stopped while the film was made"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Results, APipeThatNobodyReadsFromIsNotWaitedForAndCtrlCEndsTheWait) {
  const Ran alone = run("animate --duration 2 -o pipe", "mkfifo pipe;");
  EXPECT_EQ(alone.status, 2);
  EXPECT_NE(alone.err.find("pipe: nobody reads from the pipe; expected"), std::string::npos);
  const Ran read_from = run("animate --duration 2 -o pipe & cat pipe >walk.bvh; wait $!");
  EXPECT_EQ(read_from.status, 0) << read_from.err;
  EXPECT_EQ(read("walk.bvh").rfind("HIERARCHY", 0), 0u);
  const Ran stopped = run("animate --duration 2 -o pipe" + kStopped);
  EXPECT_EQ(stopped.status, 130) << stopped.err;
}

TEST_F(Results, NoFileThatAMeshNamesIsWrittenOver) {
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
      "bufferViews":[{"buffer":0,"byteLength":36}],
      "buffers":[{"byteLength":36,"uri":"top%2Esvg"}]})";
  const float corners[9] = {0, 0, 0, 0.2f, 0, 0, 0, 0.2f, 0};
  const std::string buffer(reinterpret_cast<const char*>(corners), sizeof corners);
  write("in/mat.gltf", gltf);
  write("in/top.svg", buffer);
  write("in/room.yaml", kRoom + "  - {name: mat, mesh: mat.gltf, at: [3, 0.5, 1]}\n");
  expectRefused("plan in/scenario.yaml -o in", {"in/top.svg: "});
  EXPECT_EQ(read("in/top.svg"), buffer);
  EXPECT_EQ(run("plan in/scenario.yaml -o out").status, 0);
  EXPECT_NE(read("out/report.json").find("top.svg\""), std::string::npos) << "it is an input";
}

TEST_F(Results, LinksAndModesAreKept) {
  fs::create_directories(folder_ / "far");
  fs::create_directories(folder_ / "out");
  fs::create_symlink("../far/walk.bvh", folder_ / "out/walk.bvh");
  write("out/report.json", "{}");
  fs::permissions(folder_ / "out/report.json", fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats bvh,json").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "out/walk.bvh"));
  EXPECT_EQ(read("far/walk.bvh").rfind("HIERARCHY", 0), 0u);
  EXPECT_EQ(fs::status(folder_ / "out/report.json").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace
}  // namespace amble
