// amble graph build|show|query|loop|play, as a shell runs them.

#include <cmath>
#include <regex>

#include "animation/captures/bvh.h"
#include "tests/app/options.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class GraphCommand : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    good("animate --speed 1.2 --duration 6 --fps 30 -o slow.bvh");
    good("animate --speed 1.5 --turn 15 --duration 6 --fps 60 -o 'fast, 1:2 \"x\".bvh'");
    good("graph build slow.bvh 'fast, 1:2 \"x\".bvh' -o it.graph");
  }
  json shown(const std::string& options = "") const {
    return printed("graph show --json it.graph " + options);
  }
  Clip written() const { return readBvh(folder_ / "out.bvh"); }

  const std::string kFast = "'fast, 1:2 \"x\"";
  const std::string kQuery = "graph query it.graph --from slow:30 --to " + kFast + ":300' ";
};

TEST_F(GraphCommand, ShowsWhatItHolds) {
  const json graph = shown();
  EXPECT_EQ(graph["clips"][0]["name"], "slow");
  EXPECT_EQ(graph["clips"][1]["name"], "fast, 1:2 \"x\"");
  EXPECT_NEAR(graph["frame_time"].get<double>(), 1.0 / 30.0, 1e-7);
  int frames = 0;
  for (const json& cluster : graph["clusters"]) frames += cluster["frames"].get<int>();
  EXPECT_EQ(frames, graph["frames"]);
  // Frames are the file's own: this one has two for one of the graph's.
  EXPECT_EQ(graph["clips"][1]["last"].get<int>(), 2 * (graph["clips"][1]["frames"].get<int>() - 1));
  const Ran told = good("graph show it.graph");
  for (const char* part : {"2 clips", "clusters at error 0.08 m", "slow.bvh", "  LB "})
    EXPECT_NE(told.out.find(part), std::string::npos) << part << told.out;
}

TEST_F(GraphCommand, WhatIsPlayedIsToldAsItIs) {
  const std::string play = "graph play it.graph -o out.bvh ";
  const auto count = [](const std::string& text, const std::string& word) {
    int found = 0;
    for (size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  // A cut has no root's way between its frames; frames that do not fit are told once.
  const std::string there_and_back = "slow:30-60,slow:45-60,slow:45-60,slow:45-90 ";
  const Ran cut = good(play + there_and_back + "--blend 0");
  EXPECT_EQ(count(cut.out, "a cut; "), 3) << cut.out;
  EXPECT_EQ(count(cut.out, "root at most"), 0) << cut.out;
  EXPECT_LE(count(cut.err, "feet will not fit"), 1) << cut.err;
  // A last range that is shorter than half of a blend.
  const Ran ends = good(play + "slow:30-60,slow:62-64");
  EXPECT_NE(ends.err.find("ends within its last blend"), std::string::npos) << ends.err;
  const Ran whole = good(play + "slow:30-60,slow:62-90");
  EXPECT_EQ(whole.err.find("ends within its last blend"), std::string::npos) << whole.err;
  const Ran held = good(play + there_and_back + "--footlock");
  EXPECT_NE(held.out.find("then feet that stand are held"), std::string::npos) << held.out;
  EXPECT_EQ(cut.out.find("are held"), std::string::npos) << cut.out;
}

TEST_F(GraphCommand, PlaysTheWayThatAQueryTells) {
  const json found = printed(kQuery + "--json");
  EXPECT_TRUE(found["ways"].contains("nearest")) << found;
  for (const auto& [name, way] : found["ways"].items()) {
    const std::string ranges = way["play"];
    const Ran played = good("graph play it.graph '" + ranges + "' -o out.bvh");
    EXPECT_NE(played.out.find(std::to_string(way["jumps"].size()) + " join"), std::string::npos)
        << played.out;
    // The one file has one frame for one of the graph's, the other two.
    int frames = 1;
    const std::regex range("(slow|\"):([0-9]+)-([0-9]+)");
    for (std::sregex_iterator at(ranges.begin(), ranges.end(), range), end; at != end; ++at)
      frames += (std::stoi((*at)[3]) - std::stoi((*at)[2])) / ((*at)[1] == "slow" ? 1 : 2);
    EXPECT_EQ(written().frames(), frames) << ranges;
  }
  const Ran told = good(kQuery);
  EXPECT_NE(told.out.find("to play: amble graph play it.graph slow:30-"), std::string::npos);
}

TEST_F(GraphCommand, ALoopIsAsLongAsItsTimes) {
  const Ran listed = good("graph loop it.graph slow");
  EXPECT_NE(listed.out.find("slow:"), std::string::npos) << listed.out;
  const auto frames = [&](int count) {
    good("graph loop it.graph slow -o out.bvh --count " + std::to_string(count));
    return written().frames();
  };
  const int once = frames(1), twice = frames(2);
  EXPECT_EQ(once, readBvh(folder_ / "slow.bvh").frames());
  EXPECT_GT(twice, once + 12);
  EXPECT_EQ(frames(5), once + 4 * (twice - once));
}

TEST_F(GraphCommand, APageShowsWhatGraphShowPrintsAndPlaysWhatGraphPlayWrites) {
  for (const std::string error : {"0.08", "0.15"}) {
    const json graph = shown("--error " + error);
    const json page = printed("view it.graph --json --error " + error)["graph"];
    ASSERT_EQ(page["clusters"].size(), graph["clusters"].size());
    for (size_t i = 0; i < page["clusters"].size(); ++i) {
      EXPECT_EQ(page["clusters"][i]["state"], graph["clusters"][i]["state"]);
      EXPECT_EQ(page["clusters"][i]["next"], graph["clusters"][i]["next"]);
    }
  }
  const json page = printed("view it.graph --json");
  const json join = page["graph"]["joins"][0];
  good("graph play it.graph '" + join["play"].get<std::string>() + "' -o out.bvh");
  const Clip written = this->written();
  const json& x = page["clips"][join["take"].get<int>()]["root"]["x"];
  ASSERT_EQ(static_cast<size_t>(written.frames()), x.size());
  for (int i = 0; i < written.frames(); ++i)
    EXPECT_NEAR(x[i].get<double>(), written.poses.p_WR(i).x(), 1e-4);
  good("view it.graph -o page.html");
  EXPECT_NE(read("page.html").find("fast, 1:2 \\\"x\\\""), std::string::npos);
}

TEST_F(GraphCommand, WhatIsStaleDamagedOrMisspeltIsOneLineAndNothingIsWritten) {
  shell("mkfifo pipe");
  expectRefused("graph build pipe -o new.graph", {"pipe: is no file that can be read again"});
  fs::remove(folder_ / "pipe");
  expectRefused("view it.graph --scene in/room.yaml", {"--scene: with a cluster graph"});
  const std::string play = "graph play it.graph slow:1-20 -o new.bvh";
  const std::string clip = read("slow.bvh"), whole = read("it.graph");
  write("slow.bvh", clip + "\n");
  expectRefused(play, {"it.graph: ", "these have changed: slow.bvh"});
  expectRefused(kQuery, {"these have changed: slow.bvh"});
  EXPECT_NE(good("graph show it.graph").err.find("changed: slow.bvh"), std::string::npos);
  fs::remove(folder_ / "slow.bvh");
  expectRefused(play, {"slow.bvh (missing)"});
  write("slow.bvh", clip);
  write("it.graph", whole.substr(0, whole.size() / 2));
  expectRefused(play, {"it.graph: is a damaged cluster graph"});
  write("it.graph", whole);
  expectRefused("graph show slow.bvh", {"slow.bvh: is no cluster graph"});
  expectRefused("graph play it.graph slwo:1-20 -o new.bvh", {"no clip 'slwo'", "'slow'"});
  expectRefused("graph play it.graph slow:1-9999 -o new.bvh", {"has no frame 9999"});
  expectRefused("graph play it.graph slow:20-1 -o new.bvh", {"ends before it begins"});
  expectRefused("graph play it.graph slow -o new.bvh", {"'slow'", "CLIP:A-B"});
  expectRefused("graph play it.graph slow:1-20, -o new.bvh", {"CLIP:A-B"});
  expectRefused("graph query it.graph --from slow --to slow:3", {"CLIP:FRAME"});
  expectRefused("graph build slow.bvh slow.bvh -o new.graph", {"given twice"});
  expectRefused("graph build slow.bvh -o slow.bvh", {"slow.bvh"});
  expectRefused(play.substr(0, play.size() - 7) + "it.graph.bvh -o slow.bvh", {"--output"});
  expectRefused("graph play it.graph slow:1-20 -o slow.bvh", {"slow.bvh"});
  EXPECT_FALSE(fs::exists(folder_ / "new.bvh"));
  EXPECT_FALSE(fs::exists(folder_ / "new.graph"));
}

TEST_F(GraphCommand, MovedWithItsClipsItIsFresh) {
  fs::create_directory(folder_ / "away");
  for (const char* file : {"slow.bvh", "fast, 1:2 \"x\".bvh", "it.graph"})
    fs::rename(folder_ / file, folder_ / "away" / file);
  good("graph play away/it.graph slow:1-20 -o out.bvh");
  EXPECT_EQ(written().frames(), 20);
}

TEST_F(GraphCommand, OptionsOfBuild) {
  const std::string build = "graph build slow.bvh ";
  expectEach(
      "graph build",
      {{"--output", [&] { expectRefused(build, {"--output"}); }},
       {"--fps",
        [&] {
          good(build + "-o it.graph --fps 15");
          EXPECT_NEAR(shown()["frame_time"].get<double>(), 1.0 / 15.0, 1e-7);
        }},
       {"--threads",
        [&] {
          good(build + "-o one.graph --threads 1");
          good(build + "-o three.graph --threads 3");
          EXPECT_EQ(read("one.graph"), read("three.graph"));
        }},
       {"--unit",
        [&] {
          good(build + "-o it.graph --unit 0.5");
          good("graph play it.graph slow:1-20 -o out.bvh");  // read so again
          const double half = written().skeleton.joint(2).offset.norm();
          good(build + "-o it.graph --unit 1");
          good("graph play it.graph slow:1-20 -o out.bvh");
          EXPECT_NEAR(half, 0.5 * written().skeleton.joint(2).offset.norm(), 1e-4);
        }},
       {"--up", [&] { good(build + "-o it.graph --up y"); }},
       {"--facing",
        [&] {
          good(build + "-o it.graph --facing 90");
          good("graph play it.graph slow:1-150 -o out.bvh");
          const Clip clip = written();
          const Eigen::Vector3d way = clip.poses.p_WR(149) - clip.poses.p_WR(0);
          EXPECT_GT(way.y(), 3.0 * std::abs(way.x()));
        }},
       {"--asf", [&] { good(build + "-o it.graph --asf none.asf", 2); }},
       {"--roles",
        [&] {
          write("roles.yaml", "head: none\n");
          expectRefused(build + "-o new.graph --roles roles.yaml", {"head"});
        }},
       {"--file-fps",
        [&] {
          good(build + "-o it.graph --file-fps 60 --fps 60");
          EXPECT_EQ(shown()["frames"], readBvh(folder_ / "slow.bvh").frames());
        }},
       {"--take", [&] { good(build + "-o it.graph --take any"); }},
       {"--memory", [&] { expectRefused(build + "-o new.graph --memory 0", {"--memory"}); }}});
}

TEST_F(GraphCommand, OptionsOfShowAndQuery) {
  const auto error = [&] {
    EXPECT_GT(shown("--error 0.01")["clusters"].size(), shown("--error 0.2")["clusters"].size());
  };
  expectEach("graph show", {{"--error", error}, {"--json", [&] { shown(); }}});
  expectEach(
      "graph query",
      {{"--from", [&] { expectRefused("graph query it.graph --to slow:3", {"--from"}); }},
       {"--to", [&] { expectRefused("graph query it.graph --from slow:3", {"--to"}); }},
       {"--error",
        [&] { EXPECT_NE(good(kQuery + "--error 0", 1).err.find("no way"), std::string::npos); }},
       {"--stay",
        [&] {
          EXPECT_GE(printed(kQuery + "--json --stay 5")["ways"]["through"]["error"],
                    printed(kQuery + "--json --stay 0")["ways"]["through"]["error"]);
        }},
       {"--json", [&] { printed(kQuery + "--json"); }}});
}

TEST_F(GraphCommand, OptionsOfLoopAndPlay) {
  const std::string play = "graph play it.graph slow:1-60,slow:61-120 ",
                    loop = "graph loop it.graph slow ";
  const auto playing = [&](const std::string& command) {
    return Uses{{"--bvh-units",
                 [this, command] {
                   good(command + "-o out.bvh --bvh-units cm");
                   EXPECT_GT(written().skeleton.joint(2).offset.norm(), 5.0);
                 }},
                {"--names",
                 [this, command] {
                   good(command + "-o out.bvh --names mixamo");
                   EXPECT_NE(read("out.bvh").find("mixamorig"), std::string::npos);
                 }},
                {"--blend",
                 [this, command] {
                   good(command + "-o out.bvh --blend 0");
                   const std::string cut = read("out.bvh");
                   good(command + "-o out.bvh --blend 1");
                   EXPECT_NE(read("out.bvh"), cut);
                 }},
                {"--footlock",
                 [this, command] {
                   good(command + "-o out.bvh");
                   const std::string free = read("out.bvh");
                   good(command + "-o out.bvh --footlock");
                   EXPECT_NE(read("out.bvh"), free);
                 }},
                {"--fps", [this, command] {
                   good(command + "-o out.bvh --fps 60");
                   EXPECT_NEAR(written().frame_time, 1.0 / 60.0, 1e-6);
                 }}};
  };
  expectAll("graph play", {playing(play), {{"--output", [&] {
                                              good(play + "-o out.glb");
                                              expectRefused(play + "-o out.txt", {"out.txt"});
                                            }}}});
  expectAll("graph loop", {playing(loop),
                           {{"--output", [&] { good(loop); }},
                            {"--count", [&] { expectRefused(loop + "--count 0", {"--count"}); }},
                            {"--at",
                             [&] {
                               EXPECT_NE(good(loop + "--at 60").out.substr(0, 40),
                                         good(loop + "--at 140").out.substr(0, 40));
                             }},
                            {"--shortest", [&] { good(loop + "--shortest 100", 1); }},
                            {"--error", [&] { good(loop + "--error 0", 1); }}}});
}

}  // namespace
}  // namespace amble
