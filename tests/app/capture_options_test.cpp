// The same of the commands that take captures: what their files leave open, and what is theirs.

#include "tests/app/capture_options.h"

#include <cmath>

#include "animation/captures/bvh.h"
#include "base/rotation.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

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
  uses["--names"] = [&] {
    const Clip named = said("--names vrm", "230 frames");
    EXPECT_GE(named.skeleton.find("leftUpperLeg"), 0);
    EXPECT_LT(named.skeleton.find(plain.skeleton.joint(0).name), 0);
  };
  uses["--bvh-units"] = [&] {
    EXPECT_NEAR(said("--bvh-units cm", "230 frames").poses.p_WR(9).norm(),
                100.0 * plain.poses.p_WR(9).norm(), 1e-3);
  };
  expectEach("convert", uses);
}

class EditOptions : public CaptureOptions {
 protected:
  json said(const std::string& options) const {
    return printed("edit in/walk.bvh -o out.bvh --json " + options);
  }
  Uses ofTheWalk() const;
};

EditOptions::Uses EditOptions::ofTheWalk() const {
  return {
      {"--stride",
       [this] {
         EXPECT_NEAR(said("--stride 0.6")["stride"]["achieved"], 0.6, 0.012);
         const json longer = said("--stride 1.2x")["stride"];
         EXPECT_NEAR(longer["achieved"], 1.2 * longer["captured"].get<double>(), 0.015);
         const json ramp = said("--stride 0.5..0.7")["stride"];  // asked of the steps that are seen
         EXPECT_NEAR(ramp["asked"], 0.6, 0.02);
         EXPECT_NEAR(ramp["achieved"], ramp["asked"].get<double>(), 0.012);
         expectRefused("edit in/walk.bvh -o no.bvh --stride 3x",
                       {"--stride", "3 of what was captured", "0.6x to 1.4x"});
         expectRefused("edit in/walk.bvh -o no.bvh --stride 1x..0.5", {"--stride", "FROM..TO"});
       }},
      {"--lift",
       [this] {
         EXPECT_NEAR(said("--lift 0.08")["lift"]["achieved"], 0.08, 0.0016);
         expectRefused("edit in/walk.bvh -o no.bvh --lift 9x", {"--lift", "0.5x to 3x"});
       }},
      {"--incline",
       [this] {
         const json rise = said("--incline -5")["rise"];
         EXPECT_NEAR(rise["achieved"], rise["asked"].get<double>(), 0.003);
         EXPECT_LT(rise["asked"], -0.05);
         EXPECT_EQ(said("--incline 2..6")["ground"]["incline"], json({2.0, 6.0}));
         const std::string turn = captureFolder() + "accad_female1/Female1_B09_WalkTurnLeft90.bvh";
         const json on_it = printed("edit -o out.bvh --json --incline 8 " + turn)["rise"];
         EXPECT_NEAR(on_it["achieved"], on_it["asked"].get<double>(), 0.0017);
       }},
      {"--stairs",
       [this] {
         const json stairs = said("--stairs .17,.29");
         EXPECT_NEAR(stairs["rise"]["achieved"], 0.17, 0.0034);
         EXPECT_NEAR(stairs["stride"]["achieved"], 0.29, 0.0058);
         EXPECT_EQ(stairs["ground"]["going"], 0.29);
         expectRefused("edit in/walk.bvh -o no.bvh --stairs .17,.29 --incline 3", {"--incline"});
       }},
      {"--arrive",
       [this] {
         const Clip level = (said(""), readBvh(folder_ / "out.bvh"));
         const Eigen::Vector2d begin = level.poses.p_WR(0).head<2>();
         const Eigen::Vector2d end = level.poses.p_WR(level.frames() - 1).head<2>();
         const Eigen::Vector2d there = begin + 0.9 * (end - begin).reverse();
         said("--arrive " + std::to_string(there.x()) + "," + std::to_string(there.y()));
         const Clip arrived = readBvh(folder_ / "out.bvh");
         EXPECT_LT((arrived.poses.p_WR(level.frames() - 1).head<2>() - there).norm(), 0.01);
         EXPECT_NE(
             good("edit in/walk.bvh -o no.bvh --arrive 900,0", 1).err.find("strides are scaled"),
             std::string::npos);
       }},
      {"--footlock",
       [this] {
         const json drift = said("--footlock")["drift"];
         EXPECT_GT(drift["captured"], 0.004);
         EXPECT_LT(drift["achieved"], 0.002);
       }},
      {"--json", [this] { EXPECT_EQ(said("")["from"], "in/walk.bvh"); }},
  };
}

TEST_F(EditOptions, AreAllTried) {
  const Uses captures =
      reading([](const std::string& clip) { return "edit -o out.bvh '" + clip + "'"; });
  expectAll("edit", {captures, ofTheWalk(), writing("edit in/walk.bvh", "in/walk.bvh")});
}

TEST_F(EditOptions, WhatIsNoWalkIsRefusedWithWhatItIs) {
  fs::copy_file(captureFolder() + "accad_female1/Female1_A01_Stand.bvh", folder_ / "in/stand.bvh");
  expectRefused("edit in/stand.bvh -o no.bvh --stride 1.1x",
                {"in/stand.bvh: is no walk: it stands for 100 % of its time", "--footlock"});
  good("edit in/stand.bvh -o held.bvh --footlock");
  EXPECT_FALSE(fs::exists(folder_ / "no.bvh"));
}

TEST_F(CaptureOptions, OfView) {
  Uses uses = reading([](const std::string& clip) { return "view -o out.html '" + clip + "'"; });
  uses["--output"] = [&] {
    good("view in/walk.bvh --output there.html");
    EXPECT_TRUE(read("there.html").starts_with("<!DOCTYPE html>"));
    expectRefused("view in/walk.bvh -o in/walk.bvh", {"in/walk.bvh: "});
  };
  uses["--scene"] = [&] {
    good("plan in/scenario.yaml -o out --formats bvh");
    good("view out/walk.bvh --scene in/room.yaml -o in-room.html");
    EXPECT_NE(read("in-room.html").find("\"objects\":[\"floor\""), std::string::npos);
    expectRefused("view in/walk.bvh out/walk.bvh --scene in/room.yaml", {"--scene", "one walk"});
  };
  uses["--json"] = [&] {
    EXPECT_FALSE(printed("view in/walk.bvh --json").empty());
    expectRefused("view in/walk.bvh --json -o -", {"--json", "-o FILE"});
  };
  uses["--captures"] = [&] {  // of a library: its walks beside those that they were made from
    const std::string shown = "view " AMBLE_SOURCE_DIR "/animation/motions/default.yaml --json ";
    EXPECT_NE(good(shown + "--captures " + captureFolder()).out, good(shown + "--captures in").out);
  };
  uses["--error"] = [&] {  // of a cluster graph: what differs by less is one cluster
    good("graph build in/walk.bvh -o it.graph");
    const auto clusters = [&](const std::string& error) {
      return printed("view it.graph --json --error " + error)["graph"]["clusters"].size();
    };
    EXPECT_LT(clusters("0.2"), clusters("0.05"));
    expectRefused("view it.graph --error=-1", {"--error"});
  };
  uses["--open"] = [&] {
    write("bin/xdg-open", "#!/bin/sh\necho \"$1\" > opened\n");
    good("view in/walk.bvh -o new.html --open", 0, "chmod +x bin/xdg-open; PATH=$PWD/bin:$PATH;");
    EXPECT_EQ(read("opened"), (folder_ / "new.html").string() + "\n");
    const Ran none = run("view in/walk.bvh -o new.html --open", "PATH=$PWD;");
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("new.html: cannot be shown"), std::string::npos) << none.err;
  };
  expectEach("view", uses);
}

TEST_F(CaptureOptions, OfViewOfAFolderOfResults) {
  good("plan in/scenario.yaml -o out --formats bvh,json");
  expectRefused("view out", {"report.json: its scene is found nowhere", "--scene FILE"});
  good("view ../out -o ../found.html", 0, "cd in;");
  const std::string found = read("found.html");
  EXPECT_NE(found.find("\"objects\":[\"floor\""), std::string::npos);
  good("view out --scene in/room.yaml");
  EXPECT_EQ(read("out/walk.html"), found);
  fs::remove(folder_ / "out/walk.html");
  write("in/room.yaml", read("in/room.yaml") + "# other bytes\n");
  expectRefused("view ../out", {"report.json: its scene is found nowhere"}, "cd in;");
}

TEST_F(CaptureOptions, OfViewOfAFolderWithItsPage) {
  good("plan in/scenario.yaml -o out");
  const std::string page = read("out/walk.html");
  good("view out -o copy.html");
  EXPECT_EQ(read("copy.html"), page);
  good("view out");
  EXPECT_EQ(read("out/walk.html"), page);
  expectRefused("view out -o out/walk.html", {"out/walk.html: "});
}

TEST_F(CaptureOptions, OfLibraryEngine) {
  const std::string build = "library engine build ";
  Uses uses = reading([&](const std::string& clip) { return build + "'" + clip + "' -o n.yaml"; });
  const auto made = [&](const std::string& option) {
    good(build + "in/walk.bvh -o e.yaml " + option);
    return printed("library engine show --json e.yaml")[0];
  };
  const json plain = made("");
  const auto speedOf = [](const json& engine) { return engine["fastest"].get<double>(); };
  uses["--unit"] = [&] { EXPECT_NEAR(speedOf(made("--unit 0.012")), 1.2 * speedOf(plain), 1e-3); };
  uses["--up"] = [&] { EXPECT_EQ(made("--up y"), plain); };
  uses["--facing"] = [&] { EXPECT_NEAR(speedOf(made("--facing 90")), speedOf(plain), 1e-5); };
  uses["--roles"] = [&] { EXPECT_EQ(made("--roles in/roles.yaml"), plain); };
  uses["--file-fps"] = [&] {
    EXPECT_NEAR(speedOf(made("--file-fps 33")), 1.1 * speedOf(plain), 0.05);
  };
  uses["--output"] = [&] {
    expectRefused(build + "in/walk.bvh", {"--output"});
    expectRefused(build + "in/walk.bvh -o in/walk.bvh", {"walk.bvh: is no name of an engine"});
    expectRefused(build + "in/walk.bvh -o in/room.yaml", {"room.yaml: is no speed engine"});
  };
  uses["--variance"] = [&] {
    expectRefused(build + "in/walk.bvh -o e.yaml --variance 2", {"--variance", "0 to 1"});
    const std::string some = captureFolder() + "cmu_mb2/07_0[135].bvh -o e.yaml --variance ";
    const auto components = [&](const std::string& variance) {
      good(build + some + variance);
      return printed("library engine show --json e.yaml")[0]["walk"]["components"].size();
    };
    EXPECT_LT(components("0.5"), components("0.95"));
  };
  const auto source = [&](const char* key, const std::string& option) {
    return made(option)["walk"]["clips"][0][key];
  };
  uses["--licence"] = [&] { EXPECT_EQ(source("licence", "--licence 'A B'"), "A B"); };
  uses["--credit"] = [&] { EXPECT_EQ(source("credit", "--credit 'C D'"), "C D"); };
  expectEach("library engine build", uses);
  expectEach("library engine show",
             {{"--json", [&] { EXPECT_EQ(plain["kind"], "speed engine"); }}});
  EXPECT_NE(good("inspect e.yaml").out.find("speed engine"), std::string::npos);
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
