// Acclaim files that are written from clips: what is read is what was written, in any order of the
// degrees of freedom, axes and units; and which skeleton goes with which motion.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "animation/captures/asf_amc.h"
#include "animation/captures/asf_skeleton.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

// How a file is written. What a bone is turned by is C M C^-1.
struct Make {
  bool radians = false;
  std::string dofs = "xyz";  // of the root and of each bone, the first turned first
  double unit = 1.0;         // of a length in the file [m]
};

// Bones as Acclaim has them: siblings begin where their parent ends.
struct Bones {
  std::vector<Eigen::Vector3d> ends;     // in the rest pose, of each [m]
  std::vector<int> parents;              // -1: the root
  std::vector<Eigen::Quaterniond> axes;  // C
};

Bones randomBones(Generator& generator, int count) {
  Bones bones;
  for (int b = 0; b < count; ++b) {
    bones.ends.push_back(randomVector(generator, 0.6));
    bones.parents.push_back(std::uniform_int_distribution<int>(-1, b - 1)(generator));
    bones.axes.push_back(randomRotation(generator));
  }
  return bones;
}

// Angles about fixed axes, in the order of the letters: the last of them is the first factor.
Eigen::Vector3d fixedAngles(const Eigen::Quaterniond& q, const std::string& letters) {
  const RotationOrder order = {static_cast<char>(letters[2] - 'x' + 'X'),
                               static_cast<char>(letters[1] - 'x' + 'X'),
                               static_cast<char>(letters[0] - 'x' + 'X')};
  const Eigen::Vector3d euler = toEuler(q, order);
  return {euler[2], euler[1], euler[0]};
}

class AcclaimText {
 public:
  explicit AcclaimText(const Make& make) : make_(make) { out_.precision(17); }

  std::string asf(const Bones& bones) {
    out_ << ":version 1.10\n:units\n angle " << (make_.radians ? "rad" : "deg")
         << "\n:root\n order";
    for (const char axis : make_.dofs) out_ << " r" << axis;
    out_ << " tx ty tz\n axis XYZ\n position 0 0 0\n orientation 0 0 0\n:bonedata\n";
    for (size_t b = 0; b < bones.ends.size(); ++b) writeBone(bones, b);
    out_ << ":hierarchy\nbegin\n";
    for (size_t b = 0; b < bones.ends.size(); ++b) {
      out_ << (bones.parents[b] < 0 ? "root" : name(bones.parents[b])) << ' '
           << name(static_cast<int>(b)) << '\n';
    }
    out_ << "end\n";
    return out_.str();
  }
  /// @param turns  of root and bones in their parents, a row a frame
  std::string amc(const Bones& bones, const std::vector<std::vector<Eigen::Quaterniond>>& turns,
                  const std::vector<Eigen::Vector3d>& places) {
    out_ << ":FULLY-SPECIFIED\n" << (make_.radians ? ":RADIANS\n" : ":DEGREES\n");
    for (size_t i = 0; i < turns.size(); ++i) {
      out_ << i + 1 << "\nroot";
      writeAngles(fixedAngles(turns[i][0], make_.dofs));
      writeVector(places[i] / make_.unit);
      for (size_t b = 0; b < bones.ends.size(); ++b) {
        const Eigen::Quaterniond& c = bones.axes[b];
        out_ << '\n' << name(static_cast<int>(b));
        writeAngles(fixedAngles(c.conjugate() * turns[i][b + 1] * c, make_.dofs));
      }
      out_ << '\n';
    }
    return out_.str();
  }
  static std::string name(int bone) { return "bone" + std::to_string(bone); }

 private:
  void writeBone(const Bones& bones, size_t b) {
    out_ << "begin\n id " << b + 1 << "\n name " << name(static_cast<int>(b)) << "\n direction";
    writeVector(bones.ends[b].normalized());
    out_ << "\n length " << bones.ends[b].norm() / make_.unit << "\n axis";
    writeAngles(fixedAngles(bones.axes[b], "xyz"));
    out_ << " XYZ\n dof";
    for (const char axis : make_.dofs) out_ << " r" << axis;
    out_ << "\n limits (-180 180)\n (-180 180)\n (-180 180)\nend\n";
  }
  void writeAngles(const Eigen::Vector3d& angles) {
    writeVector(make_.radians ? angles : Eigen::Vector3d(angles / kDegree));
  }
  void writeVector(const Eigen::Vector3d& v) {
    for (const double x : v) out_ << ' ' << x;
  }

  const Make make_;
  std::ostringstream out_;
};

// Forward kinematics of the bones themselves, z up: where each begins.
std::vector<Eigen::Vector3d> placesOf(const Bones& bones,
                                      const std::vector<Eigen::Quaterniond>& turns,
                                      const Eigen::Vector3d& root) {
  std::vector<Eigen::Vector3d> begins, ends;
  std::vector<Eigen::Quaterniond> q_WB;
  for (size_t b = 0; b < bones.ends.size(); ++b) {
    const int parent = bones.parents[b];
    begins.push_back(parent < 0 ? root : ends[parent]);
    q_WB.push_back((parent < 0 ? turns[0] : q_WB[parent]) * turns[b + 1]);
    ends.push_back(begins[b] + q_WB[b] * bones.ends[b]);
  }
  return begins;
}

TEST(Acclaim, WhatIsWrittenOfAnySkeletonIsReadInAnyOrderAndUnit) {
  Generator generator(11);
  const std::string orders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
  for (int round = 0; round < 24; ++round) {
    const Make make = {round % 2 == 1, orders[round % 6], round % 3 == 0 ? 0.056444 : 1.0};
    SCOPED_TRACE(make.dofs);
    const Bones bones = randomBones(generator, 9);
    std::vector<std::vector<Eigen::Quaterniond>> turns(4);
    std::vector<Eigen::Vector3d> places;
    for (auto& frame : turns) {
      places.push_back(randomVector(generator, 3.0));
      for (int b = 0; b <= 9; ++b) frame.push_back(randomRotation(generator));
    }
    const std::string asf = AcclaimText(make).asf(bones);
    const std::string amc = AcclaimText(make).amc(bones, turns, places);
    const Clip clip = parseAsfAmc({asf, "it.asf"}, {amc, "it.amc"},
                                  {.metres_per_unit = make.unit, .up = UpAxis::kZ});
    ASSERT_EQ(clip.frames(), 4);
    for (int i = 0; i < 4; ++i) {
      const std::vector<JointFrame> joints = jointFrames(clip, i);
      const std::vector<Eigen::Vector3d> wanted = placesOf(bones, turns[i], places[i]);
      for (int b = 0; b < 9; ++b) {
        const int joint = clip.skeleton.find(AcclaimText::name(b));
        ASSERT_GE(joint, 0);
        EXPECT_LT((joints[joint].p_WJ - wanted[b]).norm(), 1e-9);
      }
    }
  }
}

TEST(Acclaim, AJointTurnsInTheOrderOfItsDegreesOfFreedom) {
  for (const std::string dofs : {"xyz", "zxy", "x", "zy"}) {
    Generator generator(5);
    Bones bones = randomBones(generator, 1);
    AsfAmcNotes notes;
    std::string asf = AcclaimText({false, "xyz", 1.0}).asf(bones);
    std::string words;
    for (const char axis : dofs) words += std::string(" r") + axis;
    asf.replace(asf.find(" dof rx ry rz"), 13, " dof" + words);
    const AsfSkeleton skeleton = parseAsf({asf, "it.asf"}, notes);
    ASSERT_EQ(skeleton.bones[1].dofs.size(), dofs.size());
    // The first that is turned is the last factor; those without freedom come after it.
    const RotationOrder& order = skeleton.joints[1].order;
    for (size_t i = 0; i < dofs.size(); ++i) {
      EXPECT_EQ(order[dofs.size() - 1 - i], dofs[i] - 'x' + 'X') << dofs;
    }
    EXPECT_TRUE(std::is_permutation(order.begin(), order.end(), std::string("XYZ").begin()));
  }
}

TEST(Acclaim, CommentsAndBracketsAreBlanksLineForLine) {
  const std::string text = "a (1, 2) # (b)\r\nc# d\n(e)";
  const std::string plain = withoutAcclaimComments(text);
  EXPECT_EQ(plain.size(), text.size());
  EXPECT_EQ(plain, "a  1  2       \r\nc   \n e ");
}

// Any line of a skeleton may be lost or doubled by an editor: it is read, or refused at a line that
// the file has.
TEST(Acclaim, ALineThatIsLostOrDoubledIsRefusedWithinTheFile) {
  Generator generator(3);
  const Bones bones = randomBones(generator, 4);
  const std::string asf = AcclaimText({}).asf(bones);
  const std::vector<std::vector<Eigen::Quaterniond>> still(
      1, std::vector<Eigen::Quaterniond>(5, Eigen::Quaterniond::Identity()));
  const std::string amc = AcclaimText({}).amc(bones, still, {Eigen::Vector3d::Zero()});
  std::vector<std::string> lines;
  std::istringstream in(asf);
  for (std::string line; std::getline(in, line);) lines.push_back(line + '\n');
  int refused = 0;
  for (size_t at = 0; at < lines.size(); ++at) {
    for (const bool doubled : {false, true}) {
      std::string broken;
      for (size_t i = 0; i < lines.size(); ++i) {
        if (i == at) broken += doubled ? lines[i] + lines[i] : "";
        if (i != at) broken += lines[i];
      }
      try {
        parseAsfAmc({broken, "it.asf"}, {amc, "it.amc"});
      } catch (const InputError& error) {
        ++refused;
        EXPECT_LE(error.line(), static_cast<int>(lines.size()) + 2) << error.what();
        EXPECT_GE(error.line(), 1) << error.what();
        EXPECT_FALSE(error.expected().empty()) << error.what();
      }
    }
  }
  EXPECT_GE(refused, 30);
}

}  // namespace
}  // namespace amble
