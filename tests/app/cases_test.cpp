// Every input of cases/ through the program, against the column "right" of its README.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(AMBLE_SHARED) / "cases";

struct Row {
  std::string input;      // below cases/
  std::string arguments;  // {} stands for the input
  int status;
  std::vector<std::string> says, never = {};  // on either stream
  std::string more = "";  // to be put behind a scenario, so that a search in vain is short
};

std::string changed(std::string text, const std::string& what, const std::string& by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

const std::string kPlan = "plan {} --formats bvh,json -o out";
const std::string kRightLegs = "legs of 0.80 m";
const std::string kRightWalk = "1.036 m/s (1.29 legs/s)";
const std::string kRightRhythm = "110.6 steps a minute";

// `base` is the same walk without a fault: 4 s of legs of 0.80 m at 30 frames a second.
const std::vector<Row> kCaptureRows = {
    {"captures/a01_one_frame_more.bvh",
     "analyse {}",
     0,
     {"121 of 0.0333333 s", kRightWalk, "warning: holds 121 frames, not 120 as line 133 says"}},
    {"captures/a17_trailing_nul.bvh",
     "analyse {}",
     0,
     {"121 of", kRightWalk, "warning: a NUL behind the last line is passed over"}},
    {"captures/a17b_ctrl_z.bvh",
     "analyse {}",
     0,
     {"121 of", kRightWalk, "warning: a Ctrl-Z behind the last line is passed over"}},
    {"captures/a09b_utf16.bvh",
     "analyse {}",
     2,
     {":1: the text is UTF-16; expected ASCII or UTF-8"}},
    {"captures/a09c_cr_only.bvh",
     "analyse {}",
     0,
     {"121 of", kRightWalk, "warning: lines end in CR alone"}},
    {"captures/a11d_frametime_as_fps.bvh",
     "analyse {}",
     0,
     {"121 of 0.03333333 s", kRightWalk,
      "line 134: frame time 30 s is taken as 30 frames a second"}},
    {"captures/a12_wrong_frame_time_24.bvh",
     "analyse {}",
     0,
     {"121 of 0.0083333 s",
      "the frame time looks 4.1 times too short; --file-fps 30 makes it 111"}},
    {"captures/a12_wrong_frame_time_24.bvh",
     "analyse {} --file-fps 30",
     0,
     {kRightWalk, kRightRhythm},
     {"warning"}},
    {"captures/a25_unit_dm.bvh",
     "analyse {}",
     0,
     {"0.1 m, guessed: " + kRightLegs, kRightWalk},
     {"warning"}},
    {"captures/a25_unit_child_inch_060.bvh",
     "analyse {}",
     0,
     {"unit        0.0254 m, guessed: legs of 0.48 m"}},
    {"captures/a30_mixamo_names_walk.bvh",
     "analyse {}",
     0,
     {"1 m, guessed: " + kRightLegs, "109.9 steps a minute"}},
    {"captures/a30_mixamo_names_walk.bvh", "library add mine.yaml {}", 0, {"mine.yaml"}},
    {"captures/a30_mixamo_names_walk.bvh",
     "library show mine.yaml",
     0,
     {"a30_mixamo_names_walk.bvh"}},
    {"captures/a30_mixamo_names_walk.bvh",
     "plan mixamo.yaml --formats bvh,json -o out",
     0,
     {"solved"}},
    {"captures/b01_in_place.bvh",
     "analyse {}",
     0,
     {"warning: walks on the spot: the ground goes back under it at 1.15 m/s"}},
    {"captures/b05_jitter_1.5deg.bvh",
     "analyse {}",
     0,
     {"warning: noisy: joints shake by 1.5 degrees", "type        walk", "111.7 steps a minute"}},
    {"captures/b08_jump_back.bvh",
     "analyse {}",
     0,
     {"motion from 60 to 120",
      "warning: the root jumps by 1.47 m between frames 59 and 60: what is measured is cut there"}},
    {"captures/g3_sparse_even_keys.gltf", "analyse {}", 0, {"121 of 0.0333334 s", "108.7 steps"}},
    {"captures/g4_idle_and_walk.gltf",
     "analyse {}",
     0,
     {"1.038 m/s", "of 2 animations 'Walk' is read", "--take chooses of 'Idle', 'Walk'"}},
    {"captures/g4_idle_and_walk.gltf",
     "inspect {} --take Idle",
     0,
     {"stays where it is"},
     {"warning: of 2 animations"}},
    {"captures/g5_armature_cm.gltf",
     "analyse {}",
     0,
     {"warning: unit 1 m", "a person of 1.6 cm; --unit 100 makes one of 1.63 m"}},
    {"captures/g5_armature_cm.gltf", "analyse {} --unit 100", 0, {"1.038 m/s"}, {"person of"}},
    {"captures/g7_quantized.gltf", "analyse {}", 0, {"121 of", "1.038 m/s", kRightRhythm}},
};

const std::vector<Row> kScenes = {
    {"scenes/s03_cm_forgot/m.obj",
     "inspect {}",
     0,
     {"620.00 x 420.00 x 260.00 of the file's unit"}},
    {"scenes/s03_cm_forgot/scene.yaml",
     "inspect {}",
     0,
     {"warning: world: 620 m wide, 420 m deep and 260 m high", "`scale: 0.01`"}},
    {"scenes/s03_cm_forgot/plan.yaml", kPlan, 0, {"warning: world: 620 m wide", "`scale: 0.01`"}},
    {"scenes/s10_floor_plane_facing_down/m.obj", "inspect {}", 0, {"62 triangles"}},
    {"scenes/s10_floor_plane_facing_down/scene.yaml",
     "inspect {}",
     0,
     {"warning: world: floor: faces down"}},
    {"scenes/s10_floor_plane_facing_down/plan.yaml", kPlan, 2, {"world: floor: faces down"}},
    {"scenes/s10_floor_plane_facing_down/scene-ground.yaml", "inspect {}", 0, {"0.00, 2.50 m"}},
    {"scenes/s10_floor_plane_facing_down/plan-ground.yaml", kPlan, 0, {"solved"}, {"faces down"}},
    {"scenes/s16_geo_offset/m.obj", "inspect {}", 0, {"64 triangles"}},
    {"scenes/s16_geo_offset/scene.yaml", "inspect {}", 0, {"warning: world: lies 5.412e+06 m"}},
    {"scenes/s16_geo_offset/plan.yaml",
     kPlan,
     2,
     {"'start.at' is more than 100 km from the origin", "brought there by the `at`"}},
    {"scenes/s16_geo_offset/scene-at.yaml", "inspect {}", 0, {"levels         0.00, 2.50 m"}},
    {"scenes/s16_geo_offset/plan-at.yaml", kPlan, 0, {"its shape is lost", "solved"}},
    {"scenes/s17_site400/m.obj", "inspect {}", 0, {"400.00 x 400.00"}},
    {"scenes/s17_site400/scene.yaml", "inspect {}", 0, {"400.00 x 400.00 x 1.46 m"}},
    {"scenes/s17_site400/plan.yaml", kPlan, 0, {"solved", "walk       5.5"}},
    {"scenes/s19_ply_points/m.ply", "inspect {}", 2, {"only points or lines, no faces"}},
    {"scenes/s19_ply_points/scene.yaml", "inspect {}", 2, {"m.ply: holds only points"}},
    {"scenes/s19_ply_points/plan.yaml", kPlan, 2, {"m.ply: holds only points or lines, no faces"}},
    {"scenes/s23_gpu_instancing/m.gltf", "inspect {}", 2, {"EXT_mesh_gpu_instancing"}},
    {"scenes/s23_gpu_instancing/scene.yaml", "inspect {}", 2, {"EXT_mesh_gpu_instancing"}},
    {"scenes/s23_gpu_instancing/plan.yaml", kPlan, 2, {"requires the extension EXT_mesh_gpu"}},
};

const std::vector<Row> kPlans = {
    {"plans/room-scene.yaml", "inspect {}", 0, {"objects  7"}, {"warning"}},
    {"plans/d01_start_5cm_from_wall.yaml",
     kPlan,
     1,
     {"start_blocked", "w3 is 0.03 m away; 0.15 m would do"}},
    {"plans/d03c_goal_in_bed_no_z.yaml", kPlan, 1, {"goal_blocked", "it is in bed"}},
    {"plans/two-scene.yaml", "inspect {}", 0, {"levels   0.00, 2.80 m"}},
    {"plans/d05b_other_floor_unreachable.yaml",
     kPlan,
     1,
     {"no_walk", "2.80 m higher; at most 0.25 m is stepped", "from 0 samples"}},
    {"plans/gap-scene.yaml", "inspect {}", 0, {"levels   0.00 m"}},
    {"plans/d06_floor_gap_2m.yaml",
     kPlan,
     1,
     {"no_walk", "a break of 2.00 m", "is stepped over", "from 0 samples"}},
    {"plans/d10_goal_10cm.yaml", kPlan, 0, {"solved", "walk       0.10 m"}},
    {"plans/lowdoor-scene.yaml", "inspect {}", 0, {"lintel   box"}},
    {"plans/d13b_lintel_170_person_175.yaml",
     kPlan,
     1,
     {"no_walk", "lintel hangs 1.70 m", "1.75 m would do"},
     {},
     "planner: {max_failures: 20}\n"},
    {"plans/rise28-go37-scene.yaml", "inspect {}", 0, {"0.00, 0.28, 0.56, 0.84"}},
    {"plans/rise28-go37.yaml", kPlan, 0, {"solved"}, {"warning"}},
};

// How the program meets a mesh, and how a capture. The guard's own limit once: to fill it takes
// seconds.
const std::vector<std::string> kAsMesh = {"inspect {}", "convert {} -o out.bvh --memory 100",
                                          "plan mesh.yaml -o out --memory 100"};
const std::vector<std::string> kAsCapture = {"inspect {}", "analyse {}", "convert {} -o out.bvh",
                                             "validate {} --scene scene.yaml"};

struct Hostile {
  std::string input;
  std::vector<std::string> says;  // by one of its readers: each says what it notices first
};
const std::vector<Hostile> kHostile = {
    {"hostile/badglb.glb", {"goes beyond the end", "is shorter than its header says"}},
    {"hostile/dae-cycle.dae", {"nesting without end"}},
    {"hostile/dae-selfcycle.dae", {"nesting without end"}},
    {"hostile/dae-laughs.dae", {"fills more than"}},
    {"hostile/fbx-cycle.fbx", {"nesting without end"}},
    {"hostile/fbx-self.fbx", {"nesting without end"}},
    {"hostile/fbx-dag.fbx", {"fills more than"}},
    {"hostile/gltf-diamond.gltf", {"a node hangs on two others", "fills more than"}},
    {"hostile/gltf-sparse.gltf", {"fills more than", "holds no animation"}},
    {"hostile/ft1e-300.bvh", {":134: frame time 1e-300 s; expected 0.0001 to 1 s"}},
    {"hostile/ft1e9.bvh", {":134: frame time 1e+09 s; expected 0.0001 to 1 s"}},
};

class Cases : public Program {
 protected:
  void SetUp() override {
    if (!fs::exists(kCases)) GTEST_SKIP() << "the cases are not there";
    Program::SetUp();
    write("scene.yaml",
          "objects:\n  - {name: floor, box: {size: [8, 6, 0.1]}, at: [4, 3, -0.05]}\n");
    write("mixamo.yaml",
          "scene: scene.yaml\ncharacter: {library: mine.yaml}\n"
          "start: {at: [1, 1]}\ngoal: {at: [5, 3]}\n");
  }

  Ran runOn(const std::string& input, const std::string& arguments) const {
    return run(changed(arguments, "{}", "'" + (kCases / input).string() + "'"));
  }

  // With a copy of the scenario that has more in it.
  Ran runCopy(const Row& row) const {
    std::ostringstream text;
    text << std::ifstream(kCases / row.input).rdbuf();
    const std::string folder = (kCases / row.input).parent_path().string();
    write("more.yaml", changed(text.str(), "scene: ", "scene: " + folder + "/") + row.more);
    return run(changed(row.arguments, "{}", "more.yaml"));
  }

  void expect(const std::vector<Row>& rows) const {
    for (const Row& row : rows) {
      SCOPED_TRACE("amble " + changed(row.arguments, "{}", row.input));
      const Ran ran = row.more.empty() ? runOn(row.input, row.arguments) : runCopy(row);
      const std::string all = ran.out + ran.err;
      EXPECT_EQ(ran.status, row.status) << all;
      for (const std::string& text : row.says)
        EXPECT_NE(all.find(text), std::string::npos) << "'" << text << "' is not in: " << all;
      for (const std::string& text : row.never)
        EXPECT_EQ(all.find(text), std::string::npos) << "'" << text << "' is in: " << all;
      const auto raw = [](unsigned char c) { return c < 0x20 && c != '\n'; };
      EXPECT_TRUE(std::none_of(all.begin(), all.end(), raw)) << "control bytes";
      if (row.status == 2) {
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << all;
      }
    }
  }
};

TEST_F(Cases, CapturesAreReadAsTheyAreMeant) { expect(kCaptureRows); }
TEST_F(Cases, ScenesAreReadOrSaidWhyNot) { expect(kScenes); }
TEST_F(Cases, PlansSayWhatStandsInTheWay) { expect(kPlans); }

TEST_F(Cases, HostileFilesAreRefusedInOneLineAndUnderAGigabyte) {
  for (const Hostile& hostile : kHostile) {
    write("mesh.yaml", "scene: mesh-scene.yaml\nstart: {at: [1, 1]}\ngoal: {at: [5, 3]}\n");
    write("mesh-scene.yaml",
          "objects:\n  - {name: m, mesh: '" + (kCases / hostile.input).string() + "'}\n");
    const bool is_capture = hostile.input.ends_with(".bvh");
    for (const std::string& arguments : is_capture ? kAsCapture : kAsMesh) {
      SCOPED_TRACE("amble " + changed(arguments, "{}", hostile.input));
      const std::set<std::string> before = files();
      const Ran ran = runOn(hostile.input, arguments);
      EXPECT_EQ(ran.status, 2);
      EXPECT_EQ(ran.out, "");
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
      const auto isSaid = [&](const std::string& text) {
        return ran.err.find(text) != std::string::npos;
      };
      EXPECT_TRUE(std::any_of(hostile.says.begin(), hostile.says.end(), isSaid)) << ran.err;
      EXPECT_EQ(files(), before);
#ifndef __SANITIZE_ADDRESS__  // which has memory of its own
      EXPECT_LT(ran.memory, size_t{1} << 30);
#endif
    }
  }
}

std::set<std::string> inputsOfRows() {
  std::set<std::string> inputs;
  for (const auto* rows : {&kCaptureRows, &kScenes, &kPlans})
    for (const Row& row : *rows) inputs.insert(row.input);
  for (const Hostile& hostile : kHostile) inputs.insert(hostile.input);
  return inputs;
}

TEST_F(Cases, EveryFileHasARow) {
  const std::set<std::string> inputs = inputsOfRows();
  for (const auto& entry : fs::recursive_directory_iterator(kCases)) {
    const std::string name = fs::relative(entry.path(), kCases).string();
    // What an earlier run wrote beside its scene.
    const bool is_result = name.find("/out_plan/") != std::string::npos;
    if (!entry.is_regular_file() || name == "README.md" || is_result) continue;
    EXPECT_TRUE(inputs.contains(name)) << name;
  }
}

// The table's first column: "plans/d05b, d06".
TEST_F(Cases, EveryLineOfTheReadmeHasARow) {
  const std::set<std::string> inputs = inputsOfRows();
  std::ifstream readme(kCases / "README.md");
  int lines = 0;
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with("| ") || line.starts_with("| input") || line.starts_with("| ---"))
      continue;
    const std::string cell = line.substr(2, line.find(" |") - 2);
    std::istringstream names(changed(cell, ",", " "));
    const std::string kind =
        cell.find('/') == std::string::npos ? "hostile/" : cell.substr(0, cell.find('/') + 1);
    for (std::string name; names >> name;) {
      if (name.starts_with(kind)) name.erase(0, kind.size());
      const auto isNamed = [&](const std::string& input) {
        return input.starts_with(kind) && input.find(name) != std::string::npos;
      };
      EXPECT_TRUE(std::any_of(inputs.begin(), inputs.end(), isNamed)) << kind << name;
      ++lines;
    }
  }
  EXPECT_GT(lines, 30);
}

}  // namespace
}  // namespace amble
