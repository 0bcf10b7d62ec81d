#include "animation/captures/node_file.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "base/error.h"
#include "tests/animation/captures.h"
#include "tests/animation/captures/replaced.h"
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
          {"centimetres.fbx", fbxOf(walk, {0.01, false}), 0.01, UpAxis::kY},
          {"metres.fbx", fbxOf(walk, {1.0, true}), 1.0, UpAxis::kZ}};
}

TEST(NodeFile, AMissingFileIsNamed) {
  EXPECT_EQ(errorOf([] { readNodeFile("/nowhere/walk.fbx"); }),
            "/nowhere/walk.fbx: no such file; expected animation of a skeleton as FBX, glTF, GLB, "
            "VRMA or DAE");
}

TEST(NodeFile, AFileWithoutAnimationIsRefused) {
  const TestFolder folder;
  const auto file = folder.write("still.fbx", fbxOf(walkingPerson(), {0.01, false, false}));
  EXPECT_NE(errorOf([&] { readNodeFile(file); }).find("still.fbx: holds no animation; expected"),
            std::string::npos);
  EXPECT_FALSE(readNodeFileIfAny(file));
}

TEST(NodeFile, WhatIsNoSuchFileIsRefusedWithTheLineWhereThereIsOne) {
  const TestFolder folder;
  for (const char* const name : {"none.fbx", "none.gltf", "none.glb", "none.dae"}) {
    const auto file = folder.write(name, "a walk\nis none of these\n");
    const std::string error = errorOf([&] { readNodeFile(file); });
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_NE(error.find("cannot be read: "), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(NodeFile, NodesBelowThemselvesAreRefused) {
  const Clip walk = walkingPerson();
  const auto refused = [](const std::string& text, const std::string& name) {
    return errorOf([&] { parseNodeFile(text, name); });
  };
  // The first joint below its child.
  EXPECT_NE(refused(replaced(fbxOf(walk, {0.01, false}), "Connections: {\n",
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
                .find("cycle.gltf: nodes that hang on themselves"),
            std::string::npos);
}

TEST(NodeFile, NodesNestedWithoutMeasureAreRefused) {
  const int depth = 100'000;
  std::string text =
      "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_visual_scenes><visual_scene "
      "id=\"s\">";
  for (int i = 0; i < depth; ++i) text += "<node>";
  for (int i = 0; i < depth; ++i) text += "</node>";
  text +=
      "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
      "url=\"#s\"/></scene></COLLADA>";
  EXPECT_NE(errorOf([&] { parseNodeFile(text, "deep.dae"); }).find("deep.dae: cannot be read"),
            std::string::npos);
  EXPECT_NE(errorOf([&] {
              parseNodeFile(std::string(depth, '['), "deep.gltf");
            }).find("deep.gltf: cannot be read"),
            std::string::npos);
}

TEST(NodeFile, EveryFormatGivesTheWalkToAMillimetre) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    NodeFileNotes notes;
    const Clip back = readNodeFile(folder.write(written.name, written.text), {}, &notes);
    EXPECT_EQ(back.skeleton.size(), walk.skeleton.size()) << written.name;
    EXPECT_LT(farthest(walk, back), 0.05 * kMillimetre) << written.name;
    EXPECT_NEAR(back.frame_time, walk.frame_time, 1e-7) << written.name;
    EXPECT_NEAR(notes.metres_per_unit, written.unit, 1e-6) << written.name;
    EXPECT_EQ(notes.up, written.up) << written.name;
    EXPECT_TRUE(back.joint_positions.empty()) << written.name;
  }
}

TEST(NodeFile, AFrameTimeOfTheCallersIsSampled) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const Clip fine =
        readNodeFile(folder.write(written.name, written.text), {.frame_time = 1.0 / 120.0});
    ASSERT_EQ(fine.frames(), 4 * (walk.frames() - 1) + 1) << written.name;
    const int last = walk.frames() - 1;
    EXPECT_LT((fine.poses.p_WR(4 * last) - walk.poses.p_WR(last)).norm(), 1e-4) << written.name;
  }
}

TEST(NodeFile, AUnitAndAxisOfTheCallersHoldInsteadOfTheFiles) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const auto file = folder.write(written.name, written.text);
    const Clip twice = readNodeFile(file, {.metres_per_unit = 2.0 * written.unit});
    EXPECT_LT((twice.poses.p_WR(40) - 2.0 * walk.poses.p_WR(40)).norm(), 1e-4) << written.name;
    const UpAxis other = written.up == UpAxis::kY ? UpAxis::kZ : UpAxis::kY;
    const Clip tipped = readNodeFile(file, {.up = other});
    const Eigen::Quaterniond tip =
        written.up == UpAxis::kY ? yUpToWorld().conjugate() : yUpToWorld();
    EXPECT_LT((tipped.poses.p_WR(40) - tip * walk.poses.p_WR(40)).norm(), 1e-4) << written.name;
  }
}

TEST(NodeFile, TheOneEntryReadsThemAllAndSaysWhatTheFileSays) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  for (const Written& written : writtenWalks(walk)) {
    const CapturedMotion motion = readMotion(folder.write(written.name, written.text));
    EXPECT_TRUE(motion.warnings.empty()) << written.name << " " << motion.warnings[0];
    EXPECT_FALSE(motion.metres_per_unit.guessed || motion.up.guessed) << written.name;
    EXPECT_EQ(motion.clip.skeleton.joint(motion.roles.head).name, "Head") << written.name;
  }
}

TEST(NodeFile, AUnitThatTheLegsContradictIsTold) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  // Written in centimetres, and saying metres.
  std::string text = colladaOf(walk, 0.01, false);
  text.replace(text.find("meter=\"0.01\""), 12, "meter=\"1\"");
  const CapturedMotion motion = readMotion(folder.write("walk.dae", text));
  EXPECT_FALSE(motion.metres_per_unit.sure);
  EXPECT_EQ(
      motion.metres_per_unit.text,
      "1 m, as the file says, but that makes a person of 187 m; --unit 0.01 makes one of 1.87 m");
}

/// FBX of a capture, with what Maya and Mixamo put around a bone's turn.
std::string pivotedFbx(const Clip& clip, int parts, bool animated_pivots) {
  Generator generator(5);
  std::vector<FbxPivot> pivots(clip.skeleton.size());
  for (FbxPivot& pivot : pivots) {
    const Eigen::Vector3d pre = randomVector(generator, 1.5), post = randomVector(generator, 1.5);
    if (parts > 0) pivot.pre = pre;
    if (parts > 1) pivot.post = post;
    if (animated_pivots) pivot.pivot = randomVector(generator, 5.0);
    if (animated_pivots) pivot.offset = randomVector(generator, 5.0);
  }
  return fbxOf(clip, {.pivot = [&](int joint) { return pivots[joint]; }});
}

TEST(NodeFileOfCaptures, FbxWithPreAndPostRotationsAndPivotsIsItsBvhToATenthOfAMillimetre) {
  AMBLE_NEEDS_CAPTURES();
  Clip clip = readMotion(sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh").clip;
  clip.poses.resize(60);
  for (const int parts : {0, 1, 2}) {
    for (const bool pivots : {false, true}) {
      const Clip back = parseNodeFile(pivotedFbx(clip, parts, pivots), "mixamo.fbx");
      EXPECT_EQ(back.skeleton.size(), clip.skeleton.size());
      EXPECT_TRUE(back.joint_positions.empty()) << parts << pivots;
      EXPECT_LT(farthest(clip, back), 0.1 * kMillimetre) << parts << pivots;
    }
  }
}

TEST(NodeFile, ATakeIsReadByItsNameAndElseTheOneThatMoves) {
  const std::filesystem::path file = sharedFolder() / "cases/captures/g4_idle_and_walk.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  NodeFileNotes notes;
  EXPECT_EQ(readNodeFile(file, {}, &notes).frames(), 121) << "the walk";
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(notes.warnings[0].find("of 2 animations 'Walk' is read"), std::string::npos);
  EXPECT_EQ(readNodeFile(file, {.take = "Idle"}).frames(), 400);
  EXPECT_NE(errorOf([&] {
              readNodeFile(file, {.take = "Dance"});
            }).find("has no animation 'Dance'; expected --take 'Idle', 'Walk'"),
            std::string::npos);
}

TEST(NodeFile, TurnsOf16BitsAreReadToTheirPrecision) {
  const std::filesystem::path folder = sharedFolder() / "cases/captures";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  const Clip fine = readNodeFile(folder / "g5_armature_cm.gltf", {.metres_per_unit = 100.0});
  const Clip coarse = readNodeFile(folder / "g7_quantized.gltf");
  EXPECT_LT(farthest(coarse, fine), 0.5 * kMillimetre);
  EXPECT_GT(farthest(coarse, fine), 0.0);
}

TEST(NodeFile, SparseKeysGiveThirtyFramesASecond) {
  const std::filesystem::path file = sharedFolder() / "cases/captures/g3_sparse_even_keys.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const Clip clip = readNodeFile(file);
  EXPECT_NEAR(clip.frame_time, 1.0 / 30.0, 1e-6);
  EXPECT_EQ(clip.frames(), 121);
}

TEST(NodeFile, AVrmAnimationSaysWhichBoneIsWhich) {
  const Clip walk = walkingPerson();
  std::string text = gltfOf(walk);
  const std::vector<std::pair<std::string, std::string>> bones = {
      {"hips", "Hips"},
      {"head", "Head"},
      {"leftUpperLeg", "LeftUpLeg"},
      {"leftLowerLeg", "LeftLeg"},
      {"leftFoot", "LeftFoot"},
      {"rightUpperLeg", "RightUpLeg"},
      {"rightLowerLeg", "RightLeg"},
      {"rightFoot", "RightFoot"},
      {"leftUpperArm", "LeftArm"},
      {"leftLowerArm", "LeftForeArm"},
      {"rightUpperArm", "RightArm"},
      {"rightLowerArm", "RightForeArm"}};
  std::string human;
  for (const auto& [bone, joint] : bones) {
    human += (human.empty() ? "\"" : ",\"") + bone +
             "\":{\"node\":" + std::to_string(walk.skeleton.find(joint)) + "}";
  }
  for (const Joint& joint : walk.skeleton.joints()) {
    text = replaced(text, "\"" + joint.name + "\"",
                    "\"n" + std::to_string(walk.skeleton.find(joint.name)) + "\"");
  }
  text = replaced(text, "{",
                  "{\"extensionsUsed\":[\"VRMC_vrm_animation\"],\"extensions\":{"
                  "\"VRMC_vrm_animation\":{\"humanoid\":{\"humanBones\":{" +
                      human + "}}}},");
  const TestFolder folder;
  const CapturedMotion motion = readMotion(folder.write("walk.vrma", text));
  EXPECT_EQ(motion.clip.skeleton.joint(motion.roles.legs[kLeft].leg).name, "leftLowerLeg");
  EXPECT_EQ(motion.clip.skeleton.joint(motion.roles.hips).name, "hips");
}

TEST(NodeFile, AnExtensionThatWouldChangeTheMotionIsNamed) {
  const std::string text =
      replaced(gltfOf(walkingPerson()), "{", "{\"extensionsRequired\":[\"EXT_magic\"],");
  EXPECT_NE(
      errorOf([&] { parseNodeFile(text, "walk.gltf"); }).find("needs the extension EXT_magic"),
      std::string::npos);
}

TEST(NodeFile, WhatLiesOutsideOfTheFilesFolderIsNotRead) {
  const TestFolder folder;
  folder.write("motion.bin", std::string(1000, 'x'));
  std::filesystem::create_directory(folder.path() / "in");
  const std::string text = gltfOf(walkingPerson());
  const size_t begin = text.find("data:"), end = text.find('"', begin);
  const auto with = [&](const std::string& uri) {
    return errorOf([&] {
      readNodeFile(folder.write("in/walk.gltf", text.substr(0, begin) + uri + text.substr(end)));
    });
  };
  EXPECT_NE(with("../motion.bin").find("cannot be read"), std::string::npos);
  EXPECT_NE(with("/dev/zero").find("cannot be read"), std::string::npos);
}

std::string bytesOfBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  for (size_t i = 0; i + 4 <= text.size(); i += 4) {
    size_t bits = 0;
    for (size_t k = 0; k < 4; ++k) bits = bits << 6 | digits.find(text[i + k]) % 64;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(bits >> shift & 255u);
  }
  return bytes;
}

TEST(NodeFile, AFileIsNamedByItsAddress) {
  const TestFolder folder;
  const std::string text = gltfOf(walkingPerson());
  const std::string comma = ";base64,";
  const size_t begin = text.find("data:"), end = text.find('"', begin);
  const size_t data = text.find(comma, begin) + comma.size();
  const auto with = [&](const std::string& uri) {
    return errorOf([&] {
      readNodeFile(folder.write("walk.gltf", text.substr(0, begin) + uri + text.substr(end)));
    });
  };
  ASSERT_NE(with("my%20walk.bin").find("does not lie beside it"), std::string::npos);
  folder.write("my walk.bin", bytesOfBase64(text.substr(data, end - data)));
  EXPECT_EQ(with("my%20walk.bin"), "");
  EXPECT_EQ(with("my walk.bin"), "") << "as some programs write it";
  // Coded or not, what lies elsewhere is not read.
  EXPECT_NE(with("%2e%2e/my%20walk.bin").find("does not lie beside it"), std::string::npos);
}

TEST(NodeFile, HostileFilesAreOneLine) {
  const std::filesystem::path folder = sharedFolder() / "cases/hostile";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!isNodeFile(entry.path())) continue;
    const std::string error = errorOf([&] { readNodeFile(entry.path()); });
    EXPECT_TRUE(error.starts_with(entry.path().string() + ": ")) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(NodeFile, DamagedFilesAreReadOrRefusedButNothingElse) {
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
      const std::string error = errorOf([&] { parseNodeFile(text, written.name); });
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
  }
}

}  // namespace
}  // namespace amble
