#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

std::string written(const Clip& clip, double metres_per_unit = 1.0) {
  std::ostringstream out;
  writeBvh(out, clip, {.metres_per_unit = metres_per_unit});
  return out.str();
}

Clip readAgain(const std::string& text, double metres_per_unit = 1.0) {
  std::istringstream in(text);
  return readBvh(in, "written.bvh", {.metres_per_unit = metres_per_unit});
}

/// The numbers of the motion table, a row a frame.
std::vector<std::vector<double>> table(const std::string& text) {
  std::istringstream in(text.substr(text.find('\n', text.find("Frame Time")) + 1));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
  }
  return rows;
}

/// Largest distance of a joint's origin between two clips of one skeleton, whose joints may stand
/// in another order [m].
double largestDistance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (int frame = 0; frame < a.frames(); ++frame) {
    const std::vector<JointFrame> in_a = jointFrames(a, frame), in_b = jointFrames(b, frame);
    for (int j = 0; j < a.skeleton.size(); ++j) {
      const int named = b.skeleton.find(a.skeleton.joint(j).name);
      const JointFrame& other = in_b[named >= 0 ? named : j];
      largest = std::max(largest, (in_a[j].p_WJ - other.p_WJ).norm());
    }
  }
  return largest;
}

TEST(BvhWriter, RefusesClipsThatAreNone) {
  EXPECT_THROW(written(Clip()), std::invalid_argument);
  Generator generator(41);
  Clip clip = randomClip(generator, 3, 1);
  clip.poses.p_WR(0).x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(written(clip), std::invalid_argument);
}

TEST(BvhWriter, AFolderThatIsNotThereIsBadInput) {
  Generator generator(42);
  EXPECT_THROW(writeBvh(std::filesystem::path("no/such/folder/a.bvh"), randomClip(generator, 3, 1)),
               InputError);
}

TEST(BvhWriter, WritesWhatEveryReaderAgreesOn) {
  Joint root, spine, tail;
  root.name = "mixamorig:Hips";
  root.offset = {1, 2, 3};
  spine.name = "Bip01 Spine";
  spine.parent = 0;
  spine.offset = {0, 0.1, -0.0000001};
  spine.order = {'X', 'Y', 'Z'};
  spine.end_sites = {{0, 0.25, 0}};
  tail.name = "Bip01_Spine";
  tail.parent = 0;
  Clip clip;
  clip.skeleton = Skeleton({root, spine, tail});
  clip.frame_time = 1.0 / 60.0;
  clip.poses = PoseArray(3);
  clip.poses.resize(1);
  clip.poses.p_WR(0) = {1.5, -2.0, 0.875};
  clip.poses.rotations(0)[0] =
      yUpToWorld() * fromEuler(Eigen::Vector3d(10, 20, 30) * kDegree, {'Z', 'X', 'Y'});
  clip.poses.rotations(0)[1] = fromEuler({0, 0, -90 * kDegree}, {'Z', 'X', 'Y'});
  EXPECT_EQ(written(clip),
            "HIERARCHY\n"
            "ROOT mixamorig_Hips\n"
            "{\n"
            "\tOFFSET 0.000000 0.000000 0.000000\n"
            "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "\tJOINT Bip01_Spine\n"
            "\t{\n"
            "\t\tOFFSET 0.000000 0.100000 0.000000\n"
            "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "\t\tEnd Site\n"
            "\t\t{\n"
            "\t\t\tOFFSET 0.000000 0.250000 0.000000\n"
            "\t\t}\n"
            "\t}\n"
            "\tJOINT Bip01_Spine_2\n"
            "\t{\n"
            "\t\tOFFSET 0.000000 0.000000 0.000000\n"
            "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "\t\tEnd Site\n"
            "\t\t{\n"
            "\t\t\tOFFSET 0.000000 0.000000 0.000000\n"
            "\t\t}\n"
            "\t}\n"
            "}\n"
            "MOTION\n"
            "Frames: 1\n"
            "Frame Time: 0.0166667\n"
            "1.500000 0.875000 2.000000 10.000000 20.000000 30.000000 0.000000 0.000000 -90.000000 "
            "0.000000 0.000000 0.000000\n");
}

TEST(BvhWriter, CentimetresAreAHundredTimesTheMetres) {
  Generator generator(43);
  const Clip clip = randomClip(generator, 6, 3);
  const Clip again = readAgain(written(clip, 0.01), 0.01);
  EXPECT_LT(largestDistance(readAgain(written(clip)), again), 1e-5);
  EXPECT_EQ(written(again, 0.01), written(clip, 0.01));
}

// Ties, zeros with a sign, what is just below the next digit, and the largest.
TEST(BvhWriter, NumbersAreThoseThatPrintfWritesOfTheirMillionths) {
  std::vector<double> values = {
      0.0,       -0.0,   5e-7,   -5e-7,     4.9999999e-7,      -4e-7,
      0.5,       2.5e-6, 1.5e-6, 9.9999995, 99.9999995,        999.9999995,
      -999.9995, 1e9,    -1e9,   1e-300,    999999999.9999995, 123.456789};
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int n = 0; n < 100000; ++n)
    values.push_back(unit(generator) * std::pow(10.0, 9.0 * std::abs(unit(generator))));
  while (values.size() % 3 != 0) values.push_back(1.0);
  Clip clip;
  Joint root;
  root.name = "root";
  root.parent = -1;
  clip.skeleton = Skeleton({root});
  clip.frame_time = 0.01;
  clip.poses = PoseArray(1);
  clip.poses.resize(static_cast<int>(values.size() / 3));
  for (int i = 0; i < clip.frames(); ++i)  // z up, and the file's y
    clip.poses.p_WR(i) = {values[3 * i], -values[3 * i + 2], values[3 * i + 1]};
  std::ostringstream out;
  writeBvh(out, clip);
  std::istringstream in(out.str().substr(out.str().find("Frame Time")));
  std::string line, found;
  std::getline(in, line);
  for (size_t i = 0; i < values.size(); ++i) {
    char right[64];
    const auto millionths = static_cast<double>(std::llround(values[i] * 1e6));
    std::snprintf(right, sizeof right, "%.6f", millionths == 0.0 ? 0.0 : millionths / 1e6);
    in >> found;
    ASSERT_EQ(found, right) << values[i];
    if (i % 3 == 2) std::getline(in, line);
  }
}

TEST(BvhWriter, NamesAreUniqueAndClean) {
  std::vector<Joint> joints(8);
  const char* const names[] = {"a b", "a_b", "a_b_2", "", "joint", "\xC3\xA4", "Hips", "Hips"};
  for (int j = 0; j < 8; ++j) {
    joints[j].name = names[j];
    joints[j].parent = j - 1;
  }
  Clip clip;
  clip.skeleton = Skeleton(joints);
  clip.poses = PoseArray(8);
  std::set<std::string> seen;
  const Clip again = readAgain(written(clip));
  for (const Joint& joint : again.skeleton.joints()) {
    EXPECT_TRUE(std::regex_match(joint.name, std::regex("[A-Za-z0-9_]+"))) << joint.name;
    EXPECT_TRUE(seen.insert(joint.name).second) << joint.name;
  }
}

/// The theorem of the round trip: what is read back stands where it stood, and its second writing
/// is the first.
void expectRoundTrip(const Clip& clip, double tolerance, const std::string& what) {
  const std::string first = written(clip);
  const Clip again = readAgain(first);
  EXPECT_LT(largestDistance(clip, again), tolerance) << what;
  EXPECT_TRUE(written(again) == first) << what << ": second writing differs";
  EXPECT_EQ(first.find("-0.000000"), std::string::npos) << what;
}

TEST(BvhWriter, RandomPosesSurviveAndRepeat) {
  Generator generator(44);
  for (int i = 0; i < 20; ++i) expectRoundTrip(randomClip(generator, 12, 50), 1e-5, "random poses");
}

TEST(BvhWriter, GimbalLockSurvivesAndRepeats) {
  Generator generator(45);
  Clip clip = randomClip(generator, 4, 4000);
  for (int frame = 0; frame < clip.frames(); ++frame) {
    for (Eigen::Quaterniond& q : clip.poses.rotations(frame)) {
      // From exactly on the lock to a degree beside it, whose last digits are just those that are
      // told apart.
      const double away =
          std::pow(10.0, uniform(generator, -9.0, 0.0)) * (frame % 7 == 0 ? 0.0 : 1.0);
      const double side = uniform(generator, -1, 1) < 0 ? -1.0 : 1.0;
      Eigen::Vector3d degrees = randomVector(generator, 180.0);
      degrees[1] = side * (90.0 - away);
      if (frame % 3 == 0) degrees = (degrees * 1e6).array().round() / 1e6;
      q = fromEuler(degrees * kDegree, {'Z', 'X', 'Y'});
    }
    clip.poses.rotations(frame)[0] = yUpToWorld() * clip.poses.rotations(frame)[0];
  }
  expectRoundTrip(clip, 1e-5, "gimbal lock");
}

TEST(BvhWriter, HalfTurnsRepeat) {
  // Halves, quarters and whole turns, where a rounding error decides between solutions.
  Clip clip;
  clip.skeleton = Skeleton({Joint()});
  clip.poses = PoseArray(1);
  for (int z = -2; z <= 2; ++z) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        Pose pose;
        pose.rotations = {yUpToWorld() *
                          fromEuler(Eigen::Vector3d(z, x, y) * (kPi / 2), {'Z', 'X', 'Y'})};
        clip.poses.append(pose);
        pose.rotations[0].coeffs() *= -1.0;
        clip.poses.append(pose);
      }
    }
  }
  expectRoundTrip(clip, 1e-12, "half turns");
}

TEST(BvhWriter, AnglesDoNotJumpInASmoothTurn) {
  // Ten turns about a tilted axis: principal angles would jump once a turn.
  Clip clip;
  clip.skeleton = Skeleton({Joint()});
  clip.poses = PoseArray(1);
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 1.0, 0.2).normalized();
  constexpr double kStep = 0.05;  // [rad]
  for (int frame = 0; frame < 1256; ++frame) {
    Pose pose;
    pose.rotations = {yUpToWorld() * Eigen::Quaterniond(Eigen::AngleAxisd(kStep * frame, axis))};
    clip.poses.append(pose);
  }
  const std::vector<std::vector<double>> rows = table(written(clip));
  for (size_t i = 1; i < rows.size(); ++i) {
    for (int c = 3; c < 6; ++c) {
      EXPECT_LT(std::abs(rows[i][c] - rows[i - 1][c]) * kDegree, 2.0 * kStep) << i;
    }
  }
  EXPECT_GT(std::abs(rows.back()[5]), 3000.0);
}

/// As in Germany: 1.234.567,89
struct CommaPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(BvhWriter, TheLocaleMakesNoDifference) {
  Generator generator(46);
  Clip clip = randomClip(generator, 4, 1200);
  clip.poses.p_WR(0).x() = 12345.0;
  const std::string before = written(clip);
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
  const std::string with_comma = written(clip), again = written(readAgain(before));
  std::locale::global(old);
  EXPECT_TRUE(with_comma == before);
  EXPECT_TRUE(again == written(readAgain(before)));
}

TEST(BvhWriter, FramesAndTheirTimeAreTrue) {
  Generator generator(47);
  for (const int frames : {0, 1, 7}) {
    Clip clip = randomClip(generator, 3, frames);
    clip.frame_time = 1.0 / 120.0;
    const std::string text = written(clip);
    EXPECT_NE(text.find("Frames: " + std::to_string(frames) + "\nFrame Time: 0.0083333\n"),
              std::string::npos);
    EXPECT_EQ(readAgain(text).frames(), frames);
  }
}

TEST(BvhWriter, JointsInAnyOrderKeepTheirPlace) {
  // Breadth first: the file's order is another, the joints' places are the same.
  Generator generator(48);
  Clip clip = randomClip(generator, 30, 2);
  const Clip again = readAgain(written(clip));
  for (int j = 0; j < 30; ++j) {
    const int there = again.skeleton.find(clip.skeleton.joint(j).name);
    ASSERT_GE(there, 0);
    EXPECT_LT((jointFrames(clip, 1)[j].p_WJ - jointFrames(again, 1)[there].p_WJ).norm(), 1e-5);
  }
}

TEST(BvhCaptures, SurviveAndRepeat) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    expectRoundTrip(clip, 1e-5, capture.path);
  }
}

TEST(BvhCaptures, ChannelsOfJointsSurviveToTheLastDigit) {
  AMBLE_NEEDS_CAPTURES();
  // ACCAD writes Z X Y and up to six decimals: our table holds the file's own numbers, whole turns
  // and the other solution aside, and of the root its place.
  const Capture* straight = nullptr;
  for (const Capture& capture : captures()) {
    if (capture.path == "accad_female1/Female1_B03_Walk1.bvh") straight = &capture;
  }
  ASSERT_NE(straight, nullptr);
  std::ifstream in(straight->file);
  const std::string source{std::istreambuf_iterator<char>(in), {}};
  const auto theirs = table(source), ours = table(written(readBvh(straight->file)));
  ASSERT_EQ(theirs.size(), ours.size());
  for (size_t frame = 0; frame < ours.size(); ++frame) {
    for (size_t c = 0; c < ours[frame].size(); ++c) {
      const double turns =
          c < 3 ? 0.0 : 360.0 * std::round((theirs[frame][c] - ours[frame][c]) / 360.0);
      ASSERT_NEAR(ours[frame][c] + turns, theirs[frame][c], 1e-6) << frame << " " << c;
    }
  }
}

}  // namespace
}  // namespace amble
