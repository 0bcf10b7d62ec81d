// Every command answers bad input with one line that names file, line and what was expected, exit
// status 2, and leaves no half-written file.

#include "tests/app/program.h"

namespace amble {
namespace {

const char* const kRoom =
    "name: room\n"
    "objects:\n"
    "  - name: floor\n"
    "    box: {size: [6, 4, 0.1]}\n"
    "    at: [3, 2, -0.05]\n";

const char* const kScenario =
    "scene: room.yaml\n"
    "start: {at: [1, 2], heading: 0}\n"
    "goal: {at: [5, 2], heading: 0}\n";

const char* const kBvh =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 0 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  End Site\n"
    "  {\n"
    "    OFFSET 0 1 0\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.033333\n"
    "0 1 0 0 0 0\n"
    "0 1 0 0 0 0\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

class BadInput : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write("in/room.yaml", kRoom);
    write("in/scenario.yaml", kScenario);
    write("in/clip.bvh", kBvh);
  }
};

TEST_F(BadInput, AWrongCommandLineIsRefused) {
  expectRefused("", {"amble: ", "; expected "});
  expectRefused("plam in/scenario.yaml", {"amble: ", "; expected "});
  expectRefused("plan", {"amble plan: ", "; expected "});
  expectRefused("plan --sede 3 in/scenario.yaml",
                {"amble plan: ", "--sede", "; expected ", "--seed"});
  expectRefused("animate --speed nan -o a.bvh", {"--speed", "'nan'; expected 0 to 12"});
  expectRefused("animate --speed 20 -o a.bvh", {"--speed", "'20'; expected 0 to 12"});
  expectRefused("animate --speed 2.1 -o a.bvh", {"--speed", "2.1 m/s; expected 0.3 to 2 m/s"});
  expectRefused("animate --fps 0 -o a.bvh", {"--fps", "'0'; expected 24 to 240"});
  expectRefused("animate --duration 1e999 -o a.bvh", {"--duration", "'1e999'"});
  expectRefused("animate --turn 170 -o a.bvh", {"--turn", "170", "; expected "});
  expectRefused("animate --stride 0.5.. -o a.bvh", {"--stride", "'0.5..'; expected 0.05 to 2"});
  expectRefused("animate --stride 0.1 -o a.bvh", {"--stride", "0.1", "; expected "});
  expectRefused("animate --lift 0.4 -o a.bvh", {"--lift", "0.4", "; expected "});
  expectRefused("animate --incline 50 -o a.bvh", {"--incline", "'50'; expected -45 to 45"});
  expectRefused("animate --stairs 0.17 -o a.bvh", {"--stairs", "'0.17'; expected"});
  expectRefused("animate --stairs 0.17,nan -o a.bvh", {"--stairs", "'0.17,nan'; expected"});
  expectRefused("animate --stairs .17,.29 --incline 5 -o a.bvh", {"--stairs", "; expected "});
  expectRefused("animate --action nobody -o a.bvh",
                {"--action: ", "'nobody' is no movement or posture", "; expected of", " carry"});
  expectRefused("animate --action walk-slow -o a.bvh", {"--action: ", "'walk-slow'"});
  expectRefused("plan in/scenario.yaml -o out --threads 0", {"--threads", "'0'; expected"});
  expectRefused("plan in/scenario.yaml -o out --seed -1", {"--seed", "'-1'; expected"});
  expectRefused("plan in/scenario.yaml -o out --time-limit 0", {"--time-limit", "'0'; expected"});
  expectRefused("plan in/scenario.yaml -o out --formats bvh,doc", {"--formats", "doc", "expected"});
}

TEST_F(BadInput, AnEndingOfWhichNothingIsWrittenIsNamedWithThoseThatAre) {
  for (const char* motion : {"animate", "animate --engine none.yaml", "convert in/clip.bvh"})
    expectRefused(std::string(motion) + " -o out.txt", {"out.txt: ", "expected .bvh or .glb"});
  expectRefused("library build in/it.recipe.yaml -o out.txt", {"out.txt: ", "NAME.yaml"});
  expectRefused("view in/clip.bvh -o out.txt", {"out.txt: ", "expected NAME.html"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.txt"));
}

TEST_F(BadInput, AMissingFileIsNamed) {
  expectRefused("plan none.yaml -o out", {"none.yaml: ", "; expected "});
  expectRefused("check none.yaml", {"none.yaml: ", "; expected "});
  expectRefused("validate none.bvh --scene in/room.yaml", {"none.bvh: ", "; expected "});
  ASSERT_EQ(run("animate --duration 3 -o in/walk.bvh").status, 0);
  expectRefused("validate in/walk.bvh --scene none.yaml", {"none.yaml: ", "; expected "});
  expectRefused("animate --library none.yaml -o a.bvh", {"none.yaml: ", "; expected "});
  expectRefused("analyse none.bvh", {"none.bvh: ", "; expected "});
  expectRefused("library build none.recipe.yaml", {"none.recipe.yaml: ", "; expected "});
  expectRefused("library show none.yaml", {"none.yaml: ", "; expected "});
  expectRefused("inspect none.yaml", {"none.yaml: ", "; expected "});
  expectRefused("inspect none.bvh", {"none.bvh: ", "; expected "});
  expectRefused("inspect none.obj", {"none.obj: ", "; expected "});
  write("in/scenario.yaml", replaced(kScenario, "room.yaml", "none.yaml"));
  expectRefused("plan in/scenario.yaml -o out", {"none.yaml", "; expected "});
}

TEST_F(BadInput, AnUnknownKeyIsNamedWithTheOneThatWasMeant) {
  write("in/scenario.yaml", replaced(kScenario, "start:", "strat:"));
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:2: ", "'strat'", "'start'"});
  write("in/scenario.yaml", std::string(kScenario) + "planner: {sede: 3}\n");
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:4: ", "'sede'", "'seed'"});
  const Ran check = run("check in");  // which goes on with other scenarios, and prints its table
  EXPECT_EQ(check.status, 2);
  EXPECT_NE(check.err.find("scenario.yaml:4: unknown key 'sede'"), std::string::npos) << check.err;
  write("in/room.yaml", replaced(kRoom, "box:", "bxo:"));
  expectRefused("inspect in/room.yaml", {"room.yaml:4: ", "'bxo'", "'box'"});
  ASSERT_EQ(run("animate --duration 3 -o in/walk.bvh").status, 0);
  expectRefused("validate in/walk.bvh --scene in/room.yaml", {"room.yaml:4: ", "'bxo'", "'box'"});
}

TEST_F(BadInput, ADoubledKeyIsNamed) {
  write("in/scenario.yaml", std::string(kScenario) + "start: {at: [2, 2]}\n");
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:4: ", "'start'", "; expected "});
  expectRefused("inspect in/scenario.yaml", {"scenario.yaml:4: ", "'start'", "; expected "});
  write("in/room.yaml", std::string(kRoom) + "    at: [3, 2, 0]\n");
  expectRefused("inspect in/room.yaml", {"room.yaml:6: ", "'at'", "; expected "});
}

TEST_F(BadInput, ANumberOutOfRangeIsNamed) {
  write("in/scenario.yaml", std::string(kScenario) + "walk: {speed: 20}\n");
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:4: ", "20", "; expected ", "2"});
  write("in/scenario.yaml", std::string(kScenario) + "character: {height: .nan}\n");
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:4: ", ".nan", "; expected "});
  write("in/room.yaml", replaced(kRoom, "0.1]", "-0.1]"));
  expectRefused("inspect in/room.yaml", {"room.yaml:4: ", "-0.1", "; expected "});
  write("in/room.yaml", replaced(kRoom, "0.1]", "010]"));
  expectRefused("inspect in/room.yaml", {"room.yaml:4: ", "010", "; expected "});
}

TEST_F(BadInput, ABrokenBvhIsNamedWithItsLine) {
  const std::string text = kBvh;
  const auto check = [&](const std::string& bvh, const std::string& where) {
    write("in/clip.bvh", bvh);
    expectRefused("inspect in/clip.bvh", {where, "; expected "});
    expectRefused("analyse in/clip.bvh", {where, "; expected "});
    expectRefused("validate in/clip.bvh --scene in/room.yaml", {where, "; expected "});
  };
  check("", "clip.bvh");
  check("not a BVH\n", "clip.bvh:1: ");
  check(text.substr(0, text.size() / 2), "clip.bvh:");
  check(replaced(text, "0 1 0 0 0 0\n", "0 1 0 nan 0 0\n"), "clip.bvh:14: ");
  check(replaced(text, "0 1 0 0 0 0\n", "0 1 0 0 0\n"), "clip.bvh:");
  check(replaced(text, "Zrotation", "Wrotation"), "clip.bvh:5: ");
  check(replaced(text, "0.033333", "0"), "clip.bvh:13: ");
}

TEST_F(BadInput, AnEmptyOrNonFiniteMeshIsNamed) {
  write("in/room.yaml", std::string(kRoom) + "  - {name: thing, mesh: thing.obj, up: z}\n");
  const auto check = [&](const std::string& obj) {
    write("in/thing.obj", obj);
    expectRefused("inspect in/thing.obj", {"thing.obj", "; expected "});
    expectRefused("inspect in/room.yaml", {"thing.obj", "; expected "});
    expectRefused("plan in/scenario.yaml -o out", {"thing.obj", "; expected "});
  };
  check("");
  check("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  check("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
  check("v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n");
  check("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
}

TEST_F(BadInput, ASceneInMillimetresIsRefusedWithTheScaleItNeeds) {
  write("in/room.yaml", "name: mm\nobjects:\n  - {name: room, mesh: room.obj, up: z}\n");
  write("in/room.obj", "v 0 0 0\nv 6000 0 0\nv 6000 4000 0\nv 0 4000 0\nf 1 2 3 4\n");
  expectRefused("inspect in/room.yaml", {"room.yaml", "; expected ", "scale", "0.001"});
  expectRefused("plan in/scenario.yaml -o out", {"room.yaml", "; expected ", "scale", "0.001"});
}

// What is no mesh takes no `scale`.
TEST_F(BadInput, ASceneOfBoxesInMillimetresIsNotToldToScaleThem) {
  write("in/room.yaml",
        "name: mm\nobjects:\n  - {name: floor, box: {size: [6000, 4000, 100]}, at: [3000, 2000, "
        "-50]}\n");
  expectRefused("inspect in/room.yaml", {"room.yaml:3: ", "6000 m large; expected 0.5 m to 1 km"});
  EXPECT_EQ(run("inspect in/room.yaml").err.find("scale"), std::string::npos);
}

TEST_F(BadInput, AStartOutsideTheSceneIsNamedWithItsLine) {
  write("in/scenario.yaml", replaced(kScenario, "[1, 2]", "[-30, 2]"));
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:2: ", "; expected "});
  write("in/scenario.yaml", replaced(kScenario, "[5, 2]", "[5, 200]"));
  expectRefused("plan in/scenario.yaml -o out", {"scenario.yaml:3: ", "; expected "});
}

TEST_F(BadInput, AnUnwritableFolderIsNamed) {
  // Root may write into a read-only folder; nobody may write below a file.
  expectRefused("animate --duration 2 -o in/room.yaml/a.bvh",
                {"in/room.yaml/a.bvh: ", "; expected "});
  expectRefused("animate --duration 2 -o none/a.bvh", {"none/a.bvh: ", "; expected "});
  expectRefused("plan in/scenario.yaml -o in/room.yaml", {"in/room.yaml", "; expected "});
  expectRefused("plan in/scenario.yaml -o in/room.yaml/out", {"in/room.yaml", "; expected "});
}

TEST_F(BadInput, AFullDiskIsNamedAndLeavesNoHalfWrittenFile) {
  expectRefused("animate --duration 2 -o /dev/full",
                {"/dev/full: ", "No space left", "; expected "});
  // A disk that is full after 1 KiB, without one: a limit on the size of files.
  const std::string full = "ulimit -f 1;";
  expectRefused("animate --duration 10 -o a.bvh", {"a.bvh: ", "too large", "; expected "}, full);
  expectRefused("animate --duration 10 -o a.glb", {"a.glb: ", "too large", "; expected "}, full);
  expectRefused("plan in/scenario.yaml -o out", {"out/", "too large", "; expected "}, full);
}

TEST_F(BadInput, AnOutputThatCannotBeWrittenIsNoSuccess) {
  for (const char* const command :
       {"inspect in/room.yaml", "library show", "library show --json"}) {
    const Ran ran = run(std::string(command) + " >/dev/full");
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.err, "-: cannot be written; expected an open output\n");
  }
}

TEST_F(BadInput, AFileOfNoKnownKindIsNamed) {
  write("in/other.yaml", "shopping: [milk]\n");
  expectRefused("inspect in/other.yaml", {"other.yaml:1: ", "; expected "});
  write("in/other.txt", "milk\n");
  expectRefused("inspect in/other.txt", {"other.txt: ", "; expected "});
}

TEST_F(BadInput, WhatIsAmblesOwnIsNamedWhereItIsNotTaken) {
  write("in/job.yaml", "scenes: [room.yaml]\n");
  expectRefused("inspect in/job.yaml", {"job.yaml:1: is a job of many walks", "; expected "});
  ASSERT_EQ(run("roadmap build in/scenario.yaml -o in/kept").status, 0);
  expectRefused("inspect in/kept", {"kept: is a kept roadmap", "; expected .yaml"});
  write("in/few", "amble graph 1\n");
  expectRefused("inspect in/few", {"few: is a cluster graph", "; expected .yaml"});
}

}  // namespace
}  // namespace amble
