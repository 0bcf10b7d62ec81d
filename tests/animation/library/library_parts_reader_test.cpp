#include "animation/library/library_parts_reader.h"

#include <gtest/gtest.h>

#include <sstream>

#include "animation/library/library_parts_writer.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "base/yaml_writer.h"
#include "tests/animation/default_library.h"
#include "tests/animation/random_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

/// What `write` puts into a map, read as YAML.
template <typename Write>
YamlNode written(const Write& write) {
  std::ostringstream text;
  YamlWriter out(text);
  out.beginMap();
  write(out);
  out.end();
  return parseYaml(text.str(), "written.yaml");
}

Posture randomPosture(Generator& generator, int joints) {
  Posture posture;
  posture.root_height = uniform(generator, 0.5, 1.2);
  posture.root_forward = uniform(generator, -0.3, 0.3);
  posture.step_width = uniform(generator, 0.05, 0.4);
  posture.toe_out = {uniform(generator, -0.5, 0.5), uniform(generator, -0.5, 0.5)};
  for (int j = 0; j < joints; ++j) posture.rotations.push_back(randomRotation(generator));
  return posture;
}

TEST(LibraryParts, APostureComesBackToTheDigitsOfTheFile) {
  Generator generator(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Posture was = randomPosture(generator, 8);
    const YamlNode file = written([&](YamlWriter& out) { putPosture(out, was); });
    const Posture is = readPosture(file.at("posture"), 8);
    EXPECT_NEAR(is.root_height, was.root_height, 1e-7);
    EXPECT_NEAR(is.root_forward, was.root_forward, 1e-7);
    EXPECT_NEAR(is.step_width, was.step_width, 1e-7);
    for (const Side side : {kLeft, kRight}) EXPECT_NEAR(is.toe_out[side], was.toe_out[side], 1e-8);
    for (int j = 0; j < 8; ++j) {
      EXPECT_LT(is.rotations[j].angularDistance(was.rotations[j]), 1e-6);
      EXPECT_NEAR(is.rotations[j].norm(), 1.0, 1e-12);
    }
  }
}

// What was read is written with the same digits, whatever rotation it is.
TEST(LibraryParts, RotationsThatWereReadAreWrittenAsTheyStood) {
  Generator generator(2);
  std::vector<Eigen::Quaterniond> rotations;
  for (int i = 0; i < 2000; ++i) rotations.push_back(randomRotation(generator));
  const auto text = [](const std::vector<Eigen::Quaterniond>& all) {
    std::ostringstream written;
    YamlWriter out(written);
    putRotations(out.beginMap(), "rotations", all);
    out.end();
    return written.str();
  };
  const std::string once = text(rotations);
  const auto read = readRotations(parseYaml(once, "r.yaml").at("rotations"), 2000);
  EXPECT_EQ(text(read), once);
}

TEST(LibraryParts, AMatrixComesBackRowByRow) {
  Generator generator(3);
  Eigen::MatrixXd was(7, 5);
  for (Eigen::Index i = 0; i < was.size(); ++i) was(i) = uniform(generator, -3.0, 3.0);
  const YamlNode file = written([&](YamlWriter& out) { putMatrix(out, "alpha", was); });
  EXPECT_LT((readMatrix(file.at("alpha"), 7, 5, "rows") - was).cwiseAbs().maxCoeff(), 0.51e-7);
}

TEST(LibraryParts, ASourceComesBackWithWhateverItsTextHolds) {
  for (const char* const text : {"plain", "\"quoted\" \\ and: # marks", "-", "ünï", "  two  "}) {
    const MotionSource was{text, {3, 120}, true, text, text, {}, std::array{2, 130}};
    const YamlNode file = written([&](YamlWriter& out) { putSource(out, was); });
    const MotionSource is = readSource(file.at("source"), MotionKind::kStart);
    EXPECT_EQ(is.clip, was.clip);
    EXPECT_EQ(is.licence, was.licence);
    EXPECT_EQ(is.credit, was.credit);
    EXPECT_EQ(is.frames, was.frames);
    EXPECT_EQ(is.within, was.within);
    EXPECT_EQ(is.mirrored, was.mirrored);
  }
}

TEST(LibraryParts, RolesComeBackOnTheirSkeleton) {
  const MotionLibrary& library = defaultLibrary();
  const YamlNode file =
      written([&](YamlWriter& out) { putRoles(out, library.skeleton, library.roles); });
  const JointRoles is = readRoles(file.at("joints"), library.skeleton);
  for (const std::string& role : roleNames())
    EXPECT_EQ(roleJoint(is, role), roleJoint(library.roles, role)) << role;
}

struct BadPart {
  const char* text;
  const char* words;
  int line;
};

/// Expects that reading `text` with `read` is refused at the line with the words.
template <typename Read>
void expectRefused(const BadPart& bad, const Read& read) {
  const std::string refused = errorOf([&] { read(parseYaml(bad.text, "bad.yaml")); });
  EXPECT_NE(refused.find(bad.words), std::string::npos) << bad.text << "\n" << refused;
  EXPECT_EQ(refused.rfind("bad.yaml:" + std::to_string(bad.line) + ":", 0), 0u) << refused;
}

TEST(LibraryParts, BadPosturesAreRefusedWhereTheyAreBad) {
  const std::string good = "root_height: 0.9\nroot_forward: 0\nstep_width: 0.1\ntoe_out: [5, -5]\n";
  const auto read = [](const YamlNode& node) { readPosture(node, 1); };
  const std::string nan = good + "rotations:\n  - [.nan, 0, 0, 0]\n",
                    none = good + "rotations:\n  - [0.5, 0, 0, 0]\n",
                    many = good + "rotations:\n  - [1, 0, 0, 0]\n  - [1, 0, 0, 0]\n",
                    odd = good + "colour: red\nrotations: []\n";
  expectRefused({nan.c_str(), "", 6}, read);
  expectRefused({none.c_str(), "not a rotation", 6}, read);
  expectRefused({many.c_str(), "2 rotations; expected 1, one a joint", 6}, read);
  expectRefused({odd.c_str(), "colour", 5}, read);
  expectRefused({"root_height: -1\nroot_forward: 0\nstep_width: 0\ntoe_out: [0, 0]\nrotations: "
                 "[[1, 0, 0, 0]]\n",
                 "height [m]", 1},
                read);
}

TEST(LibraryParts, BadSourcesAreRefusedWhereTheyAreBad) {
  const auto read = [](const YamlNode& node) { readSource(node); };
  expectRefused({"clip: a\nframes: [1]\nlicence: b\ncredit: c\n", "not two frames", 2}, read);
  expectRefused({"clip: a\nframes: [-1, 5]\nlicence: b\ncredit: c\n", "frame", 2}, read);
  expectRefused({"clip: a\nframes: [1, 5]\nmirrored: maybe\nlicence: b\ncredit: c\n", "maybe", 3},
                read);
  expectRefused({"clip: a\nframes: [1, 5]\nlicense: b\ncredit: c\n", "licen", 3}, read);
}

TEST(LibraryParts, RolesOfNoJointAndLegsThatLackOneAreRefused) {
  const Skeleton& skeleton = defaultLibrary().skeleton;
  const auto read = [&](const YamlNode& node) { readRoles(node, skeleton); };
  const std::string hips = skeleton.joint(0).name;
  expectRefused({"hips: nobody\n", "no joint nobody", 1}, read);
  const std::string odd = "hips: " + hips + "\ntail: " + hips + "\n";
  expectRefused({odd.c_str(), "no role tail", 2}, read);
  const std::string legless = "hips: " + hips + "\n";
  expectRefused({legless.c_str(), "a leg's joint is missing", 1}, read);
}

}  // namespace
}  // namespace amble
