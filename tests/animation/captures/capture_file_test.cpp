#include "animation/captures/capture_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

TEST(CaptureFile, TextInTwoBytesALetterIsRefusedByName) {
  std::string mended;
  std::vector<std::string> warnings;
  const auto refused = [&](const std::string& text) {
    return errorOf([&] { plainText(text, "a.bvh", mended, warnings); });
  };
  EXPECT_EQ(refused("\xFF\xFEH"), "a.bvh:1: the text is UTF-16; expected ASCII or UTF-8");
  EXPECT_EQ(refused("\xFE\xFF"), "a.bvh:1: the text is UTF-16; expected ASCII or UTF-8");
  EXPECT_NE(refused(std::string("\0H", 2)).find("UTF-16 without its mark"), std::string::npos);
  EXPECT_EQ(refused("\xEF\xBB\xBFH"), "");
}

TEST(CaptureFile, OnlyWhatOldProgramsAddIsTakenOff) {
  const auto plain = [](const std::string& text, size_t told) {
    std::string mended;
    std::vector<std::string> warnings;
    const std::string left(plainText(text, "a.bvh", mended, warnings));
    EXPECT_EQ(warnings.size(), told) << text;
    return left;
  };
  EXPECT_EQ(plain("a\r\nb\n", 0), "a\r\nb\n");
  EXPECT_EQ(plain("", 0), "");
  EXPECT_EQ(plain("a\nb\n\x1A", 1), "a\nb\n");
  EXPECT_EQ(plain(std::string("a\nb\n\0\x1A\n", 7), 2), "a\nb\n");
  EXPECT_EQ(plain("a\rb\r", 1), "a\nb\n");
  EXPECT_EQ(plain(std::string("ab\0c\n", 5), 0), std::string("ab\0c\n", 5)) << "within it stays";
}

TEST(CaptureFile, AClipAsWrittenIsThatInWorldScaledAndTurned) {
  Generator generator(4);
  const Clip written = randomClip(generator, 6, 3);
  Clip clip = written;
  turnUpright(UpAxis::kY, clip);
  scaleToMetres(0.01, clip);
  for (int i = 0; i < clip.frames(); ++i) {
    const std::vector<JointFrame> a = jointFrames(written, i), b = jointFrames(clip, i);
    for (size_t j = 0; j < a.size(); ++j) {
      EXPECT_LT((0.01 * (yUpToWorld() * a[j].p_WJ) - b[j].p_WJ).norm(), 1e-12);
    }
  }
}

TEST(CaptureFile, JointsThatStayGetTheirPlaceAsOffset) {
  Generator generator(5);
  Clip clip = randomClip(generator, 3, 2);
  for (int i = 0; i < 2; ++i) {
    clip.joint_positions.emplace_back(0, 0, 0);
    clip.joint_positions.emplace_back(10, 20, 30);
    clip.joint_positions.emplace_back(1, 2, 3 + i);
  }
  const Eigen::Vector3d moving = clip.skeleton.joint(2).offset;
  scaleToMetres(0.1, clip);
  EXPECT_LT((clip.skeleton.joint(1).offset - Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((clip.skeleton.joint(2).offset - 0.1 * moving).norm(), 1e-12);
  EXPECT_FALSE(clip.joint_positions.empty()) << "one still moves";
}

TEST(CaptureFile, FrameTimesAreThoseOfCaptures) {
  for (const double good : {1.0, 1.0 / 24.0, 1.0 / 480.0, 1e-4}) EXPECT_TRUE(isFrameTime(good));
  for (const double bad : {1e9, 1.1, 1e-5, 1e-300, 0.0}) EXPECT_FALSE(isFrameTime(bad));
}

}  // namespace
}  // namespace amble
