#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/captures/replaced.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

Clip read(const std::string& text, const BvhReadOptions& options = {}) {
  std::istringstream in(text);
  return readBvh(in, "test.bvh", options);
}

/// The message of the InputError that reading throws.
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without an error";
}

// A root and a joint, two frames. Lines: 1 HIERARCHY .. 16 the last frame.
const std::string kSmall =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 0 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT Spine\n"
    "  {\n"
    "    OFFSET 0 10 1\n"
    "    CHANNELS 3 Zrotation Xrotation Yrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 5 0\n"
    "    }\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.0333333\n"
    "1 2 3 10 20 30 40 50 60\n"
    "4 5 6 11 21 31 41 51 61\n";

TEST(BvhReader, RefusesWithFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal(""), "test.bvh:1: the file ends here; expected HIERARCHY");
  EXPECT_EQ(refusal(replaced(kSmall, "HIERARCHY", "HIERARCHX")),
            "test.bvh:1: 'HIERARCHX'; expected HIERARCHY");
  EXPECT_EQ(refusal(replaced(kSmall, "{\n    OFFSET", "{F\n    OFFSET")),
            "test.bvh:7: '{F'; expected {");
  EXPECT_EQ(refusal(replaced(kSmall, "0 10 1", "0 10 one")),
            "test.bvh:8: 'one'; expected a finite number");
  EXPECT_EQ(refusal(replaced(kSmall, "MOTION", "MOTIONS")),
            "test.bvh:16: 'MOTIONS'; expected MOTION");
  EXPECT_EQ(refusal(replaced(kSmall, "Frames:", "Count:")),
            "test.bvh:17: no 'Frames:'; expected it here");
}

TEST(BvhReader, RefusesUnknownAndDoubledChannels) {
  EXPECT_TRUE(refusal(replaced(kSmall, "3 Zrotation", "3 Wrotation"))
                  .starts_with("test.bvh:9: 'Wrotation'"));
  EXPECT_TRUE(refusal(replaced(kSmall, "3 Zrotation", "3 Yrotation"))
                  .starts_with("test.bvh:9: a channel twice"));
  EXPECT_TRUE(refusal(replaced(kSmall, "CHANNELS 3", "CHANNELS 7")).starts_with("test.bvh:9: "));
  EXPECT_TRUE(
      refusal(replaced(kSmall, "CHANNELS 3", "CHANNELS -3")).starts_with("test.bvh:9: '-3'"));
  EXPECT_TRUE(
      refusal(replaced(kSmall, "CHANNELS 3", "CHANNELS 2")).starts_with("test.bvh:9: 'Yrotation'"));
}

TEST(BvhReader, RefusesFewerFramesThanTheFileSays) {
  EXPECT_EQ(refusal(replaced(kSmall, "Frames: 2", "Frames: 3")),
            "test.bvh:21: the file ends after frame 2; expected 3 as line 17 says");
  EXPECT_EQ(refusal(replaced(kSmall, "4 5 6 11", "4 5 6")),
            "test.bvh:20: 8 numbers in a frame; expected 9");
  EXPECT_EQ(refusal(kSmall + "\n\nrubbish\n"), "test.bvh:23: 'rubbish'; expected a finite number");
  EXPECT_EQ(refusal(replaced(kSmall, "4 5 6", "4 5 6 7")),
            "test.bvh:20: too many numbers in a frame; expected 9");
}

TEST(BvhReader, ReadsAllFramesWhereThereAreMoreThanTheFileSays) {
  for (const char* const says : {"Frames: 1", "Frames: 0"}) {
    BvhNotes notes;
    EXPECT_EQ(parseBvh(replaced(kSmall, "Frames: 2", says), "test.bvh", {}, &notes).frames(), 2);
    ASSERT_EQ(notes.warnings.size(), 1u);
    EXPECT_EQ(notes.warnings[0],
              "holds 2 frames, not " + std::string(says).substr(8) + " as line 17 says");
  }
}

TEST(BvhReader, FrameTimesThatCannotBeAreRefusedWithWhatWouldDo) {
  for (const char* const bad : {"1e9", "1e-12", "1e-300", "1000", "5", "0.00009"}) {
    const std::string error = refusal(replaced(kSmall, "0.0333333", bad));
    EXPECT_TRUE(error.starts_with("test.bvh:18: frame time ")) << error;
    EXPECT_NE(error.find("expected 0.0001 to 1 s, or a rate given by --file-fps"), error.npos);
    const Clip clip = read(replaced(kSmall, "0.0333333", bad), {.frame_time = 0.01});
    EXPECT_EQ(clip.frame_time, 0.01) << "the caller's holds whatever the file says";
  }
}

TEST(BvhReader, ARateInPlaceOfAFrameTimeIsTakenAsOneAndTold) {
  BvhNotes notes;
  const Clip clip = parseBvh(replaced(kSmall, "0.0333333", "30"), "test.bvh", {}, &notes);
  EXPECT_EQ(clip.frame_time, 1.0 / 30.0);
  EXPECT_TRUE(notes.frame_time_guessed);
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(notes.warnings[0].find("line 18: frame time 30 s is taken as 30 frames a second"),
            std::string::npos);
}

TEST(BvhReader, WhatOldProgramsPutBehindTheLastLineIsPassedOver) {
  for (const std::string& behind :
       {std::string(1, '\0'), std::string("\x1A"), std::string("\x1A\0\0", 3)}) {
    BvhNotes notes;
    EXPECT_EQ(parseBvh(kSmall + behind, "test.bvh", {}, &notes).frames(), 2);
    EXPECT_EQ(notes.warnings.size(), behind.size() == 1 ? 1u : 2u);
  }
}

TEST(BvhReader, LinesThatEndInCrAloneAreRead) {
  std::string mac = kSmall;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  BvhNotes notes;
  const Clip clip = parseBvh(mac, "test.bvh", {}, &notes), unix = read(kSmall);
  EXPECT_EQ(clip.poses.p_WR(1), unix.poses.p_WR(1));
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(notes.warnings[0].find("CR alone"), std::string::npos);
}

TEST(BvhReader, Utf16IsRefusedByName) {
  std::string wide = "\xFF\xFE";
  for (const char c : kSmall) wide += {c, '\0'};
  EXPECT_EQ(refusal(wide), "test.bvh:1: the text is UTF-16; expected ASCII or UTF-8");
  EXPECT_EQ(refusal(wide.substr(2)),
            "test.bvh:1: the text is UTF-16 without its mark; expected ASCII or UTF-8");
}

TEST(BvhReader, RefusesNumbersThatAreNoneOrNotFinite) {
  for (const char* const bad :
       {"nan", "inf", "-inf", "1e999", "1.#QNAN", "0,5", "0x10", "--1", "1e10"}) {
    EXPECT_TRUE(
        refusal(replaced(kSmall, "4 5 6", std::string("4 5 ") + bad)).starts_with("test.bvh:20: '"))
        << bad;
  }
  for (const char* const bad : {"0", "-0.1", "nan"}) {
    EXPECT_TRUE(refusal(replaced(kSmall, "0.0333333", bad)).starts_with("test.bvh:18: ")) << bad;
  }
}

TEST(BvhReader, DoesNotTrustCounts) {
  EXPECT_EQ(refusal(replaced(kSmall, "Frames: 2", "Frames: 999999999")),
            "test.bvh:21: the file ends after frame 2; expected 999999999 as line 17 says");
  EXPECT_TRUE(
      refusal(replaced(kSmall, "Frames: 2", "Frames: 99999999999")).starts_with("test.bvh:17: "));
}

TEST(BvhReader, RefusesRigsWithoutMeasure) {
  std::string deep = "HIERARCHY\nROOT r\n{\n", wide = "HIERARCHY\nROOT r\n{\n";
  for (int i = 0; i < 100'000; ++i) deep += "JOINT a\n{\n";
  for (int i = 0; i < 20'000; ++i) wide += "JOINT a\n{\n}\n";
  EXPECT_EQ(refusal(deep), "test.bvh:2002: joints nested too deep; expected at most 1,000 levels");
  EXPECT_EQ(refusal(wide), "test.bvh:30001: too many joints; expected at most 10,000");
}

TEST(BvhReader, RefusesPosesOutOfProportionToTheFile) {
  // One channel, 9,999 joints without one: each byte of motion would take 150 kB.
  std::string text = "HIERARCHY\nROOT r\n{\nCHANNELS 1 Xrotation\n";
  for (int i = 0; i < 9'999; ++i) text += "JOINT a\n{\n}\n";
  text += "}\nMOTION\nFrames: 100000\nFrame Time: 1\n";
  for (int i = 0; i < 100'000; ++i) text += "0\n";
  EXPECT_NE(refusal(text).find("too many joints without channels"), std::string::npos);
}

TEST(BvhReader, RefusesFilesThatAreNone) {
  EXPECT_THROW(readBvh(std::filesystem::path("no/such/file.bvh")), InputError);
  EXPECT_THROW(readBvh(std::filesystem::temp_directory_path()), InputError);
}

/// World positions of all joints at a frame as the product of what the file says, y up, worked out
/// by hand here.
TEST(BvhReader, PlacesAYUpFileInWorld) {
  const Clip clip = read(kSmall, {.metres_per_unit = 0.01});
  ASSERT_EQ(clip.frames(), 2);
  ASSERT_EQ(clip.skeleton.size(), 2);
  EXPECT_NEAR(clip.frame_time, 0.0333333, 1e-15);
  EXPECT_LT((clip.poses.p_WR(0) - Eigen::Vector3d(0.01, -0.03, 0.02)).norm(), 1e-15);
  const Eigen::Vector3d degrees(10, 20, 30);
  const Eigen::Vector3d spine_file =
      Eigen::Vector3d(1, 2, 3) +
      fromEuler(degrees * kDegree, {'Z', 'X', 'Y'}) * Eigen::Vector3d(0, 10, 1);
  const Eigen::Vector3d expected =
      0.01 * Eigen::Vector3d(spine_file.x(), -spine_file.z(), spine_file.y());
  EXPECT_LT((jointFrames(clip, 0)[1].p_WJ - expected).norm(), 1e-15);
  EXPECT_LT((clip.skeleton.joint(1).end_sites[0] - Eigen::Vector3d(0, 0.05, 0)).norm(), 1e-15);
}

TEST(BvhReader, LeavesAZUpFileAsItIs) {
  const Clip clip = read(kSmall, {.up = UpAxis::kZ});
  EXPECT_EQ(clip.poses.p_WR(0), Eigen::Vector3d(1, 2, 3));
}

TEST(BvhReader, LineEndsBlanksMarksAndCaseMakeNoDifference) {
  const Clip clip = read(kSmall);
  std::string crlf, tabs;
  for (const char c : kSmall) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    tabs += c == ' ' ? '\t' : c;
  }
  const std::vector<std::string> same = {
      crlf,
      replaced(replaced(tabs, "Frame\tTime:", "Frame Time:"), "End\tSite", "End Site"),
      "\xEF\xBB\xBF" + kSmall,
      "\n\n" + kSmall + "\n \t\n\r\n",
      kSmall.substr(0, kSmall.size() - 1),
      replaced(kSmall, "HIERARCHY", "Hierarchy"),
      replaced(kSmall, "Zrotation Xrotation Yrotation\n  J", "ZROTATION xrotation YRotation\n  J"),
      replaced(kSmall, "Frames: 2", "Frames :2"),
      replaced(kSmall, "Frame Time: ", "Frame Time:"),
      replaced(kSmall, "Hips\n{", "Hips {"),
      replaced(kSmall, "1 2 3 10", "+1 2.0e0 3 1e1"),
      replaced(kSmall, "End Site", "End site"),
      replaced(kSmall, "End Site", "End Site spine_tip"),
      replaced(kSmall, "End Site\n    {", "EndSite {"),
  };
  for (const std::string& text : same) {
    const Clip other = read(text);
    ASSERT_EQ(other.frames(), clip.frames()) << text;
    EXPECT_EQ(other.skeleton.joint(0).name, "Hips");
    for (int j = 0; j < 2; ++j) {
      EXPECT_EQ(jointFrames(other, 1)[j].p_WJ, jointFrames(clip, 1)[j].p_WJ) << text;
      EXPECT_EQ(jointFrames(other, 1)[j].q_WJ.coeffs(), jointFrames(clip, 1)[j].q_WJ.coeffs())
          << text;
    }
  }
}

TEST(BvhReader, KeepsNamesWithBlanksAndOddCharacters) {
  for (const std::string name :
       {"Bip01 L Thigh", "mixamorig:Hips", "\xC3\xBC\xE2\x82\xAC", "a\"b'<&", ""}) {
    EXPECT_EQ(read(replaced(kSmall, "Spine", name)).skeleton.joint(1).name, name);
  }
}

TEST(BvhReader, EveryOrderOfChannelsGivesTheSameMotion) {
  // The same rotations, written once in each order, beside position channels before, behind and
  // between.
  Generator generator(31);
  const Eigen::Quaterniond root = randomRotation(generator), spine = randomRotation(generator);
  const std::vector<std::string> orders = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
  for (const std::string& root_order : orders) {
    for (const std::string& spine_order : orders) {
      std::ostringstream text;
      text.precision(17);
      text << "HIERARCHY\nROOT r\n{\nOFFSET 7 8 9\nCHANNELS 6";
      for (const char axis : root_order) text << " " << axis << "rotation " << axis << "position";
      text << "\nJOINT s\n{\nOFFSET 1 2 3\nCHANNELS 3";
      for (const char axis : spine_order) text << " " << axis << "rotation";
      text << "\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n";
      const auto write = [&](const Eigen::Quaterniond& q, const std::string& order,
                             bool positions) {
        const Eigen::Vector3d angles = toEuler(q, {order[0], order[1], order[2]}) / kDegree;
        for (int i = 0; i < 3; ++i) {
          text << angles[i] << " ";
          if (positions) text << 4 + (order[i] - 'X') << " ";
        }
      };
      write(root, root_order, true);
      write(spine, spine_order, false);
      const Clip clip = read(text.str());
      const Eigen::Vector3d file = Eigen::Vector3d(4, 5, 6) + root * Eigen::Vector3d(1, 2, 3);
      const JointFrame found = jointFrames(clip, 0)[1];
      EXPECT_LT((found.p_WJ - yUpToWorld() * file).norm(), 1e-13);
      EXPECT_LT(found.q_WJ.angularDistance(yUpToWorld() * root * spine), 1e-7);
      EXPECT_LT(
          (found.q_WJ.toRotationMatrix() - (yUpToWorld() * root * spine).toRotationMatrix()).norm(),
          1e-13);
    }
  }
}

TEST(BvhReader, MissingRotationChannelsAreZero) {
  const std::string one =
      replaced(replaced(replaced(kSmall, "CHANNELS 3 Zrotation Xrotation Yrotation\n    End",
                                 "CHANNELS 1 Yrotation\n    End"),
                        "40 50 60", "60"),
               "41 51 61", "61");
  EXPECT_LT(read(one).poses[0].rotations[1].angularDistance(
                fromEuler({60 * kDegree, 0, 0}, {'Y', 'X', 'Z'})),
            1e-7);
  const std::string none =
      replaced(replaced(replaced(kSmall, "    CHANNELS 3 Zrotation Xrotation Yrotation\n", ""),
                        "40 50 60", ""),
               "41 51 61", "");
  EXPECT_EQ(read(none).poses[0].rotations[1].w(), 1.0);
}

TEST(BvhReader, RootOffsetIsPassedOverWhereTheRootHasPositionChannels) {
  EXPECT_EQ(read(replaced(kSmall, "OFFSET 0 0 0", "OFFSET 70 80 90")).poses.p_WR(0),
            read(kSmall).poses.p_WR(0));
  const std::string turning =
      replaced(replaced(replaced(replaced(kSmall, "OFFSET 0 0 0", "OFFSET 7 8 9"),
                                 "6 Xposition Yposition Zposition", "3"),
                        "1 2 3 10", "10"),
               "4 5 6 11", "11");
  EXPECT_LT((read(turning).poses.p_WR(1) - Eigen::Vector3d(7, -9, 8)).norm(), 1e-14);
  EXPECT_EQ(read(turning).skeleton.joint(0).offset, Eigen::Vector3d::Zero());
}

std::string withJointPositions(const std::string& second_frame) {
  return replaced(
      replaced(replaced(kSmall, "CHANNELS 3", "CHANNELS 6 Yposition Xposition Zposition"),
               "10 20 30 40", "10 20 30 12 -1 2 40"),
      "11 21 31 41", "11 21 31 " + second_frame + " 41");
}

TEST(BvhReader, JointPositionsThatStayReplaceTheOffset) {
  const Clip clip = read(withJointPositions("12 -1 2"), {.metres_per_unit = 0.01});
  EXPECT_TRUE(clip.joint_positions.empty());
  EXPECT_LT((clip.skeleton.joint(1).offset - Eigen::Vector3d(-0.01, 0.12, 0.02)).norm(), 1e-15);
}

TEST(BvhReader, JointPositionsThatMoveAreKept) {
  const Clip clip = read(withJointPositions("13 -1 2"), {.metres_per_unit = 0.01});
  ASSERT_EQ(clip.joint_positions.size(), 4u);
  EXPECT_LT((clip.joint_positions[1] - Eigen::Vector3d(-0.01, 0.12, 0.02)).norm(), 1e-15);
  EXPECT_LT((clip.joint_positions[3] - Eigen::Vector3d(-0.01, 0.13, 0.02)).norm(), 1e-15);
  const Eigen::Vector3d arm = clip.poses[1].rotations[0] * clip.joint_positions[3];
  EXPECT_LT((jointFrames(clip, 1)[1].p_WJ - clip.poses.p_WR(1) - arm).norm(), 1e-15);
}

TEST(BvhReader, ZeroLengthJointsAndTipsAreJointsAndTips) {
  const Clip clip =
      read(replaced(replaced(kSmall, "0 10 1", "0 0 0"), "OFFSET 0 5 0", "OFFSET 0 0 0"));
  EXPECT_EQ(clip.skeleton.size(), 2);
  EXPECT_EQ(clip.skeleton.joint(1).end_sites.size(), 1u);
}

TEST(BvhReader, AFileMayHoldNoFramesOrOne) {
  const std::string head = kSmall.substr(0, kSmall.find("1 2 3"));
  EXPECT_EQ(read(replaced(head, "Frames: 2", "Frames: 0")).frames(), 0);
  const Clip one = read(replaced(head, "Frames: 2", "Frames: 1") + "1 2 3 10 20 30 40 50 60");
  EXPECT_EQ(one.frames(), 1);
  EXPECT_EQ(one.duration(), 0.0);
}

/// Bytes flipped, cut off, doubled and moved, under a seed: a file is read or refused, never more.
TEST(BvhReader, DamagedFilesAreReadOrRefused) {
  Generator generator(32);
  const auto below = [&](size_t n) {
    return std::uniform_int_distribution<size_t>(0, n - 1)(generator);
  };
  const std::string alphabet = "0123456789.-+eE{}\n\r\t ,:naifOFSETCHJ\0\xFF";
  int read_count = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = kSmall;
    for (size_t changes = 1 + below(4); changes > 0; --changes) {
      const size_t at = below(text.size());
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text[at] = alphabet[below(alphabet.size())];
          break;
        case 2:
          text.erase(at, 1 + below(20));
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), below(40)));
          break;
        default:
          text.resize(std::max<size_t>(1, at));
          break;
      }
      if (text.empty()) text = "x";
    }
    try {
      const Clip clip = read(text);
      for (int frame = 0; frame < clip.frames(); ++frame) {
        for (const JointFrame& joint : jointFrames(clip, frame))
          ASSERT_TRUE(joint.p_WJ.allFinite());
      }
      ++read_count;
    } catch (const InputError& error) {
      ASSERT_GT(error.line(), 0) << error.what();
    }
  }
  EXPECT_GT(read_count, 100);     // digits may change
  EXPECT_LT(read_count, 15'000);  // and the mutations do bite
}

TEST(BvhReader, EveryTruncationIsRefusedBeforeTheLastNumber) {
  const size_t last = kSmall.rfind(' ') + 1;
  for (size_t length = 0; length < last; ++length) {
    EXPECT_THROW(read(kSmall.substr(0, length)), InputError) << length;
  }
}

TEST(BvhCaptures, HoldWhatTheManifestSays) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    EXPECT_EQ(clip.frames(), capture.frames) << capture.path;
    EXPECT_EQ(clip.skeleton.size(), capture.joints) << capture.path;
    EXPECT_NEAR(clip.frame_time, capture.frame_time, 1e-6) << capture.path;
    EXPECT_TRUE(clip.joint_positions.empty()) << capture.path;
  }
}

TEST(BvhCaptures, PeopleAreTheSizeOfPeople) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    double tallest = 0.0;
    for (int frame = capture.skip; frame < clip.frames(); frame += 20) {
      double low = 1e9, high = -1e9;
      for (const JointFrame& joint : jointFrames(clip, frame)) {
        low = std::min(low, joint.p_WJ.z());
        high = std::max(high, joint.p_WJ.z());
      }
      tallest = std::max(tallest, high - low);
    }
    EXPECT_GT(tallest, 1.1) << capture.path;
    EXPECT_LT(tallest, 2.3) << capture.path;  // stooped to arms up
  }
}

TEST(BvhCaptures, BonesKeepTheirLength) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    for (int frame = 0; frame < clip.frames(); frame += 37) {
      const std::vector<JointFrame> frames = jointFrames(clip, frame);
      for (int j = 1; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joint(j);
        const double length = (frames[j].p_WJ - frames[joint.parent].p_WJ).norm();
        ASSERT_NEAR(length, joint.offset.norm(), 1e-12) << capture.path << " " << joint.name;
      }
    }
  }
}

TEST(BvhCaptures, DamagedCapturesAreRefusedByNameAndLine) {
  AMBLE_NEEDS_CAPTURES();
  const std::filesystem::path folder = sharedFolder() / "mocap" / "formats";
  const std::vector<std::pair<std::string, int>> damaged = {{"malformed_brace.bvh", 7},
                                                            {"malformed_hierarchx.bvh", 1}};
  for (const auto& [name, line] : damaged) {
    try {
      readBvh(folder / name);
      ADD_FAILURE() << name << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), (folder / name).string());
      EXPECT_EQ(error.line(), line);
    }
  }
}

}  // namespace
}  // namespace amble
