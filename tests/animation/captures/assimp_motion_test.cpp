#include "animation/captures/assimp_motion.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "base/error.h"
#include "tests/animation/node_files.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

constexpr double kMillimetre = 1e-3;

/// Largest distance between the same joint of two clips in any frame [m].
double farthest(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.frames(), b.frames());
  double worst = 0.0;
  for (int i = 0; i < std::min(a.frames(), b.frames()); ++i) {
    const std::vector<JointFrame> x = jointFrames(a, i), y = jointFrames(b, i);
    for (int j = 0; j < a.skeleton.size(); ++j) {
      const int other = b.skeleton.find(a.skeleton.joint(j).name);
      EXPECT_GE(other, 0) << a.skeleton.joint(j).name;
      if (other >= 0) worst = std::max(worst, (x[j].p_WJ - y[other].p_WJ).norm());
    }
  }
  return worst;
}

/// A person's walk in each format, with the unit and vertical axis that the file says.
struct Written {
  std::string name, text;
  double unit;
  UpAxis up;
};

std::vector<Written> writtenWalks(const Clip& walk) {
  return {{"walk.gltf", gltfOf(walk), 1.0, UpAxis::kY},
          {"metres.dae", colladaOf(walk, 1.0, false), 1.0, UpAxis::kY},
          {"inches.dae", colladaOf(walk, 0.0254, true), 0.0254, UpAxis::kZ},
          {"centimetres.fbx", fbxOf(walk, 0.01, false), 0.01, UpAxis::kY},
          {"metres.fbx", fbxOf(walk, 1.0, true), 1.0, UpAxis::kZ}};
}

TEST(AssimpMotion, AMissingFileIsNamed) {
  EXPECT_EQ(errorOf([] { readAssimpMotion("/nowhere/walk.fbx"); }),
            "/nowhere/walk.fbx: no such file; expected animation of a skeleton as FBX, glTF, GLB "
            "or DAE");
}

TEST(AssimpMotion, AFileWithoutAnimationIsRefused) {
  const TestFolder folder;
  const auto file = folder.write("still.fbx", fbxOf(walkingPerson(), 0.01, false, false));
  EXPECT_NE(
      errorOf([&] { readAssimpMotion(file); }).find("still.fbx: holds no animation; expected"),
      std::string::npos);
  EXPECT_FALSE(holdsAnimation(file));
}

TEST(AssimpMotion, WhatIsNoSuchFileIsRefusedWithTheLineWhereThereIsOne) {
  const TestFolder folder;
  for (const char* const name : {"none.fbx", "none.gltf", "none.glb", "none.dae"}) {
    const auto file = folder.write(name, "a walk\nis none of these\n");
    const std::string error = errorOf([&] { readAssimpMotion(file); });
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_NE(error.find("cannot be read: "), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(AssimpMotion, NodesBelowThemselvesAreRefused) {
  const Clip walk = walkingPerson();
  const auto refused = [](const std::string& text, const std::string& name) {
    return errorOf([&] { parseAssimpMotion(text, name); });
  };
  // The first joint below its child.
  EXPECT_NE(refused(replaced(fbxOf(walk, 0.01, false), "Connections: {\n",
                             "Connections: {\nC: \"OO\",1000,1001\n"),
                    "cycle.fbx")
                .find("cycle.fbx: cannot be read: "),
            std::string::npos);
  EXPECT_NE(refused(replaced(colladaOf(walk, 1.0, false), "</node>",
                             "<instance_node url=\"#j0\"/></node>"),
                    "cycle.dae")
                .find("cycle.dae: cannot be read: "),
            std::string::npos);
  EXPECT_NE(refused(replaced(gltfOf(walk), "\"children\":[2]", "\"children\":[2,0]"), "cycle.gltf")
                .find("cycle.gltf: cannot be read: "),
            std::string::npos);
}

TEST(AssimpMotion, NodesNestedWithoutMeasureAreRefused) {
  const int depth = 100'000;
  std::string text =
      "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_visual_scenes><visual_scene "
      "id=\"s\">";
  for (int i = 0; i < depth; ++i) text += "<node>";
  for (int i = 0; i < depth; ++i) text += "</node>";
  text +=
      "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
      "url=\"#s\"/></scene></COLLADA>";
  EXPECT_NE(errorOf([&] { parseAssimpMotion(text, "deep.dae"); }).find("deep.dae: cannot be read"),
            std::string::npos);
  EXPECT_NE(errorOf([&] {
              parseAssimpMotion(std::string(depth, '['), "deep.gltf");
            }).find("deep.gltf: cannot be read"),
            std::string::npos);
}

TEST(AssimpMotion, EveryFormatGivesTheWalkToAMillimetre) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    AssimpMotionNotes notes;
    const Clip back = readAssimpMotion(folder.write(written.name, written.text), {}, &notes);
    EXPECT_EQ(back.skeleton.size(), walk.skeleton.size()) << written.name;
    EXPECT_LT(farthest(walk, back), 0.05 * kMillimetre) << written.name;
    EXPECT_NEAR(back.frame_time, walk.frame_time, 1e-7) << written.name;
    EXPECT_NEAR(notes.metres_per_unit, written.unit, 1e-6) << written.name;
    EXPECT_EQ(notes.up, written.up) << written.name;
    EXPECT_TRUE(back.joint_positions.empty()) << written.name;
  }
}

TEST(AssimpMotion, AFrameTimeOfTheCallersIsSampled) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const Clip fine =
        readAssimpMotion(folder.write(written.name, written.text), {.frame_time = 1.0 / 120.0});
    ASSERT_EQ(fine.frames(), 4 * (walk.frames() - 1) + 1) << written.name;
    const int last = walk.frames() - 1;
    EXPECT_LT((fine.poses.p_WR(4 * last) - walk.poses.p_WR(last)).norm(), 1e-4) << written.name;
  }
}

TEST(AssimpMotion, AUnitAndAxisOfTheCallersHoldInsteadOfTheFiles) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const auto file = folder.write(written.name, written.text);
    const Clip twice = readAssimpMotion(file, {.metres_per_unit = 2.0 * written.unit});
    EXPECT_LT((twice.poses.p_WR(40) - 2.0 * walk.poses.p_WR(40)).norm(), 1e-4) << written.name;
    const UpAxis other = written.up == UpAxis::kY ? UpAxis::kZ : UpAxis::kY;
    const Clip tipped = readAssimpMotion(file, {.up = other});
    const Eigen::Quaterniond tip =
        written.up == UpAxis::kY ? yUpToWorld().conjugate() : yUpToWorld();
    EXPECT_LT((tipped.poses.p_WR(40) - tip * walk.poses.p_WR(40)).norm(), 1e-4) << written.name;
  }
}

TEST(AssimpMotion, TheOneEntryReadsThemAllAndSaysWhatTheFileSays) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const CapturedMotion motion = readMotion(folder.write(written.name, written.text));
    EXPECT_TRUE(motion.warnings.empty()) << written.name << " " << motion.warnings[0];
    EXPECT_FALSE(motion.metres_per_unit.guessed || motion.up.guessed) << written.name;
    EXPECT_EQ(motion.clip.skeleton.joint(motion.roles.head).name, "Head") << written.name;
  }
}

TEST(AssimpMotion, AUnitThatTheLegsContradictIsTold) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  // Written in centimetres, and saying metres.
  std::string text = colladaOf(walk, 0.01, false);
  text.replace(text.find("meter=\"0.01\""), 12, "meter=\"1\"");
  const CapturedMotion motion = readMotion(folder.write("walk.dae", text));
  EXPECT_FALSE(motion.metres_per_unit.sure);
  EXPECT_NE(motion.metres_per_unit.text.find("0.01"), std::string::npos)
      << motion.metres_per_unit.text;
}

TEST(AssimpMotion, DamagedFilesAreReadOrRefusedButNothingElse) {
  Clip walk = walkingPerson();
  walk.poses.resize(5);
  Generator generator(17);
  for (const Written& written : writtenWalks(walk)) {
    for (int i = 0; i < 40; ++i) {
      std::string text = written.text;
      const auto place = [&] {
        return std::uniform_int_distribution<size_t>(0, text.size() - 1)(generator);
      };
      if (i % 2 == 0) {
        text.resize(place());
      } else {
        for (int k = 0; k < 5; ++k) text[place()] = static_cast<char>(generator() & 0xFF);
      }
      const std::string error = errorOf([&] { parseAssimpMotion(text, written.name); });
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
  }
}

}  // namespace
}  // namespace amble
