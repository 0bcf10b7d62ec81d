#include "animation/captures/asf_amc.h"

#include <gtest/gtest.h>

#include <map>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/captures/replaced.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

// A root, a bone with turned axes and a bone at its end. Lines from 1.
const std::string kAsf =
    ":version 1.10\n"
    ":name SMALL  # of the test\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.45\n"
    "  angle deg\n"
    ":documentation\n"
    "   bones: none of this (is) read, :really\n"
    ":root\n"
    "  order TX TY TZ RX RY RZ\n"  // 10
    "  axis XYZ\n"
    "  position 0 0 0\n"
    "  orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "    id 1\n"
    "    name thigh\n"
    "    direction 0 -1 0\n"
    "    length 7\n"
    "    axis 0 0 20 XYZ\n"  // 20
    "    dof rx ry rz\n"
    "    limits (-160.0 20.0)\n"
    "           (-70.0, 70.0)\n"
    "           (-inf inf)\n"
    "  end\n"
    "  begin\n"
    "    id 2\n"
    "    name shin\n"
    "    direction 0 -2 0\n"
    "    length 8\n"  // 30
    "    axis -90 0 20 XYZ\n"
    "    dof rx\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    root thigh\n"
    "    thigh shin\n"
    "  end\n";

const std::string kAmc =
    "#!OML:ASF small.asf\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 1 2 3 10 20 30\n"
    "thigh 40 50 60\n"
    "shin 70\n"
    "2\n"
    "root 4 5 6 11 21 31\n"
    "shin 71\n"
    "thigh 41 51 61\n";

Clip read(const std::string& asf, const std::string& amc, const AsfAmcOptions& options = {},
          AsfAmcNotes* notes = nullptr) {
  return parseAsfAmc({asf, "s.asf"}, {amc, "m.amc"}, options, notes);
}

std::string refusal(const std::string& asf, const std::string& amc) {
  try {
    read(asf, amc);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without an error";
}

std::string refusedAsf(const std::string& from, const std::string& to) {
  return refusal(replaced(kAsf, from, to), kAmc);
}

std::string refusedAmc(const std::string& from, const std::string& to) {
  return refusal(kAsf, replaced(kAmc, from, to));
}

TEST(AsfAmc, ASkeletonIsRefusedWithFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal("", kAmc), "s.asf:1: the file ends here; expected :root");
  EXPECT_EQ(refusal("<<<<<<< HEAD\n" + kAsf, kAmc),
            "s.asf:1: '<<<<<<<'; expected a section: a word that begins with ':'");
  EXPECT_EQ(refusedAsf("length 0.45", "length 0"),
            "s.asf:5: a unit of no length; expected more than 0");
  EXPECT_EQ(refusedAsf("angle deg", "angle gon"), "s.asf:6: 'gon'; expected deg or rad");
  EXPECT_EQ(refusedAsf("RX RY RZ", "RX RY RX"),
            "s.asf:10: 'RX'; expected each degree of freedom once");
  EXPECT_EQ(refusedAsf("axis XYZ\n  position", "axis XYX\n  position"),
            "s.asf:11: 'XYX'; expected an order of axes, as XYZ");
  EXPECT_EQ(refusedAsf("direction 0 -1 0", "direction 0 1e999 0"),
            "s.asf:18: '1e999'; expected a finite number");
  EXPECT_EQ(refusedAsf("length 7", "length -7"),
            "s.asf:19: a bone of negative length; expected 0 or more");
  EXPECT_EQ(refusedAsf("dof rx ry rz", "dof rx ry rw"),
            "s.asf:21: 'rw'; expected rx, ry, rz, tx, ty, tz or l");
  EXPECT_EQ(refusedAsf("(-70.0, 70.0)", "(-70.0, 7O.0)"),
            "s.asf:23: '7O.0'; expected a finite number");
  EXPECT_EQ(refusedAsf("name shin", "name thigh"),
            "s.asf:33: a second bone 'thigh'; expected each name once");
  EXPECT_EQ(refusedAsf("    thigh shin\n", "    thigh shank\n"),
            "s.asf:37: 'shank'; expected a bone of :bonedata, or root");
}

TEST(AsfAmc, AHierarchyThatIsNoTreeIsRefused) {
  EXPECT_EQ(refusedAsf("    thigh shin\n", ""),
            "s.asf:28: the bone 'shin' hangs on nothing; expected a place in :hierarchy");
  EXPECT_EQ(refusedAsf("    root thigh\n    thigh shin\n", "    shin thigh\n    thigh shin\n"),
            "s.asf:36: 'thigh' hangs on itself, over others; expected a tree below root");
  EXPECT_EQ(refusedAsf("    thigh shin\n", "    thigh shin\n    root shin\n"),
            "s.asf:38: 'shin' hangs on two bones; expected one, as line 37 says");
  EXPECT_EQ(refusedAsf("    thigh shin\n", "    thigh shin root\n"),
            "s.asf:37: the root below a bone; expected a bone");
}

TEST(AsfAmc, AMotionIsRefusedWithFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal(kAsf, ""),
            "m.amc:1: the file ends here; expected a frame: its number alone on a line");
  EXPECT_EQ(refusedAmc("thigh 40 50 60", "thigh 40 50"),
            "m.amc:6: 2 numbers of 'thigh'; expected 3, its degrees of freedom");
  EXPECT_EQ(refusedAmc("thigh 40 50 60", "thigh 40 50 60 70"),
            "m.amc:6: too many numbers of 'thigh'; expected 3, its degrees of freedom");
  EXPECT_EQ(refusedAmc("shin 70", "shin nan"), "m.amc:7: 'nan'; expected a finite number");
  EXPECT_EQ(refusedAmc("shin 70", "shin 70\nshin 70"),
            "m.amc:8: 'shin' twice in a frame; expected each bone once");
  EXPECT_EQ(refusedAmc("shin 70", "chin 70"),
            "m.amc:7: 'chin'; expected a frame's number or a bone of the ASF");
  EXPECT_EQ(refusedAmc("\n2\n", "\n3\n"), "m.amc:8: frame 3; expected frame 2, after 1");
  EXPECT_EQ(refusedAmc("\n1\n", "\n2147483647\n"),
            "m.amc:8: frame 2; expected frame 2147483648, after 2147483647");
  EXPECT_EQ(refusedAmc("\n2\n", "\n99999999999\n"),
            "m.amc:8: '99999999999'; expected a whole number, 0 to 2147483647");
  EXPECT_TRUE(refusedAmc("shin 70\n", "").starts_with("m.amc:7: the frame of line 4 lacks 'shin'"));
}

TEST(AsfAmc, AFileThatEndsTooSoonIsRefused) {
  for (size_t cut = 0; cut + 6 < kAsf.size(); ++cut) {  // "  end" is the last line
    EXPECT_NE(refusal(kAsf.substr(0, cut), kAmc), "read without an error") << cut;
  }
  const size_t second = kAmc.find("\n2\n");
  for (size_t cut = second + 2; cut < kAmc.rfind("thigh"); ++cut) {
    EXPECT_NE(refusal(kAsf, kAmc.substr(0, cut)), "read without an error") << cut;
  }
}

TEST(AsfAmc, JointsLieAtTheStartOfTheirBones) {
  const Clip clip = read(kAsf, kAmc, {.metres_per_unit = 0.5});
  ASSERT_EQ(clip.skeleton.size(), 3);
  EXPECT_EQ(clip.skeleton.find("root"), 0);
  EXPECT_EQ(clip.skeleton.find("thigh"), 1);
  EXPECT_EQ(clip.skeleton.find("shin"), 2);
  EXPECT_EQ(clip.skeleton.joint(1).offset, Eigen::Vector3d::Zero());
  EXPECT_EQ(clip.skeleton.joint(2).offset, Eigen::Vector3d(0, -3.5, 0));
  EXPECT_EQ(clip.skeleton.joint(1).order, (RotationOrder{'Z', 'Y', 'X'}));
  EXPECT_EQ(clip.skeleton.joint(2).order, (RotationOrder{'X', 'Z', 'Y'}));
  ASSERT_EQ(clip.skeleton.joint(2).end_sites.size(), 1u);
  EXPECT_EQ(clip.skeleton.joint(2).end_sites[0], Eigen::Vector3d(0, -4, 0));
  EXPECT_TRUE(clip.joint_positions.empty());
  EXPECT_EQ(clip.frames(), 2);
  EXPECT_EQ(clip.frame_time, kAmcFrameTime);
}

// About fixed axes: x first, then y, then z is Rz Ry Rx.
Eigen::Quaterniond fixedXyz(double x, double y, double z) {
  return fromEuler(Eigen::Vector3d(z, y, x) * kDegree, {'Z', 'Y', 'X'});
}

TEST(AsfAmc, ABoneTurnsAboutItsOwnAxes) {
  const Clip clip = read(kAsf, kAmc, {.up = UpAxis::kZ});
  const auto q = clip.poses.rotations(1);
  EXPECT_LT(q[0].angularDistance(fixedXyz(11, 21, 31)), 1e-12);
  const Eigen::Quaterniond c = fixedXyz(0, 0, 20), d = fixedXyz(-90, 0, 20);
  EXPECT_LT(q[1].angularDistance(c * fixedXyz(41, 51, 61) * c.conjugate()), 1e-12);
  EXPECT_LT(q[2].angularDistance(d * fixedXyz(71, 0, 0) * d.conjugate()), 1e-12);
  EXPECT_EQ(clip.poses.p_WR(1), Eigen::Vector3d(4, 5, 6));
}

TEST(AsfAmc, AYUpFileIsPlacedInWorld) {
  const Clip file = read(kAsf, kAmc, {.up = UpAxis::kZ});
  const Clip world = read(kAsf, kAmc);
  EXPECT_EQ(world.poses.p_WR(0), Eigen::Vector3d(1, -3, 2));
  EXPECT_LT(world.poses.rotations(0)[0].angularDistance(yUpToWorld() * file.poses.rotations(0)[0]),
            1e-15);
}

TEST(AsfAmc, OrdersAreThoseOfTheFile) {
  const std::string asf = replaced(replaced(kAsf, "TX TY TZ RX RY RZ", "RZ TY RX TX RY TZ"),
                                   "dof rx ry rz", "dof rz rx ry");
  const std::string amc = replaced(replaced(kAmc, "root 1 2 3 10 20 30", "root 30 2 10 1 20 3"),
                                   "thigh 40 50 60", "thigh 60 40 50");
  const Clip clip = read(asf, amc, {.up = UpAxis::kZ});
  EXPECT_EQ(clip.poses.p_WR(0), Eigen::Vector3d(1, 2, 3));
  // Turned about z first, then x, then y.
  const auto zxy = [](double x, double y, double z) {
    return fromEuler(Eigen::Vector3d(y, x, z) * kDegree, {'Y', 'X', 'Z'});
  };
  const Eigen::Quaterniond c = fixedXyz(0, 0, 20);
  EXPECT_LT(clip.poses.rotations(0)[0].angularDistance(zxy(10, 20, 30)), 1e-12);
  EXPECT_LT(clip.poses.rotations(0)[1].angularDistance(c * zxy(40, 50, 60) * c.conjugate()), 1e-12);
}

TEST(AsfAmc, RadiansAreReadWhereTheFileHasThem) {
  const std::string amc =
      ":FULLY-SPECIFIED\n:RADIANS\n1\nroot 0 0 0 0.1 0.2 0.3\nthigh 0 0 0\nshin 0\n";
  const Eigen::Quaterniond wanted = fixedXyz(0.1 / kDegree, 0.2 / kDegree, 0.3 / kDegree);
  EXPECT_LT(read(kAsf, amc, {.up = UpAxis::kZ}).poses.rotations(0)[0].angularDistance(wanted),
            1e-12);
  // Where the AMC says nothing the ASF's angles hold, and its axes are in them too.
  const std::string asf =
      replaced(replaced(replaced(kAsf, "angle deg", "angle rad"), "axis 0 0 20", "axis 0 0 0.5"),
               "axis -90 0 20", "axis 0 0 0");
  const Clip clip = read(asf, replaced(amc, ":RADIANS\n", ""), {.up = UpAxis::kZ});
  EXPECT_LT(clip.poses.rotations(0)[0].angularDistance(wanted), 1e-12);
}

TEST(AsfAmc, PresetsPlaceTheRootBeforeItMoves) {
  const std::string asf = replaced(replaced(kAsf, "position 0 0 0", "position 1 2 3"),
                                   "orientation 0 0 0", "orientation 0 90 0");
  const Clip clip = read(asf, kAmc, {.up = UpAxis::kZ});
  EXPECT_EQ(clip.poses.p_WR(0), Eigen::Vector3d(2, 4, 6));
  EXPECT_LT(clip.poses.rotations(0)[0].angularDistance(fixedXyz(10, 20, 30) * fixedXyz(0, 90, 0)),
            1e-12);
}

TEST(AsfAmc, MovingAndGrowingBonesMoveTheJointsBelowThem) {
  const std::string asf =
      replaced(replaced(kAsf, "dof rx ry rz", "dof rx ry rz l"), "dof rx\n", "dof tx rx\n");
  const std::string amc =
      ":FULLY-SPECIFIED\n:DEGREES\n"
      "1\nroot 0 0 0 0 0 0\nthigh 0 0 0 0\nshin 0 0\n"
      "2\nroot 0 0 0 0 0 0\nthigh 0 0 0 1.5\nshin 0.5 0\n";
  const Clip clip = read(asf, amc, {.metres_per_unit = 0.5});
  ASSERT_EQ(clip.joint_positions.size(), 6u);
  EXPECT_EQ(clip.joint_positions[2], Eigen::Vector3d(0, -3.5, 0));
  const Eigen::Vector3d along_x = fixedXyz(-90, 0, 20) * Eigen::Vector3d::UnitX();
  EXPECT_LT((clip.joint_positions[5] - (Eigen::Vector3d(0, -4.25, 0) + 0.25 * along_x)).norm(),
            1e-12);
}

TEST(AsfAmc, BonesOfAFileThatIsNotFullySpecifiedStayAsTheyWere) {
  const std::string amc =
      replaced(replaced(kAmc, ":FULLY-SPECIFIED\n", ""), "thigh 41 51 61\n", "");
  const Clip clip = read(kAsf, amc);
  EXPECT_EQ(clip.poses.rotations(0)[1].coeffs(), clip.poses.rotations(1)[1].coeffs());
}

TEST(AsfAmc, UnknownSectionsArePassedOverWithAWarning) {
  AsfAmcNotes notes;
  const std::string asf =
      replaced(kAsf, ":hierarchy", ":colours\n  thigh red\n  begin\n:hierarchy");
  const std::string amc =
      replaced(kAmc, ":DEGREES", ":DEGREES\n:CAMERA front\n:SAMPLES-PER-SECOND 60");
  const Clip clip = read(asf, amc, {}, &notes);
  ASSERT_EQ(notes.warnings.size(), 2u);
  EXPECT_EQ(notes.warnings[0], "s.asf:34: section ':colours' is passed over");
  EXPECT_EQ(notes.warnings[1], "m.amc:4: ':CAMERA' is passed over");
  EXPECT_EQ(notes.length_unit, 0.45);
  EXPECT_TRUE(notes.frame_time_said);
  EXPECT_EQ(clip.frame_time, 1.0 / 60.0);
  EXPECT_EQ(read(asf, amc, {.frame_time = 0.02}).frame_time, 0.02);
}

TEST(AsfAmc, ManyBonesOrDeepOnesAreRefusedWithLittleMemory) {
  std::string asf = kAsf.substr(0, kAsf.find("  begin"));
  std::string chain;
  for (int i = 0; i < 1100; ++i) {
    const std::string name = "b" + std::to_string(i);
    asf += "begin name " + name + " end\n";
    chain += (i == 0 ? "root" : "b" + std::to_string(i - 1)) + " " + name + "\n";
  }
  EXPECT_NE(refusal(asf + ":hierarchy\nbegin\n" + chain + "end\n", kAmc).find("nested too deep"),
            std::string::npos);
  for (int i = 1100; i < 11000; ++i) asf += "begin name b" + std::to_string(i) + " end\n";
  EXPECT_NE(refusal(asf, kAmc).find("too many bones"), std::string::npos);
  // Bones without degrees of freedom cost an AMC nothing: frames of them are bounded.
  asf = kAsf.substr(0, kAsf.find("  begin"));
  std::string star = "root";
  for (int i = 0; i < 9000; ++i) {
    asf += "begin name b" + std::to_string(i) + " end\n";
    star += " b" + std::to_string(i);
  }
  std::string amc;
  for (int i = 1; i < 20000; ++i) amc += std::to_string(i) + "\n";
  EXPECT_NE(
      refusal(asf + ":hierarchy\nbegin\n" + star + "\nend\n", amc).find("too many bones without"),
      std::string::npos);
}

TEST(AsfAmc, DamagedFilesAreReadOrRefused) {
  Generator generator(23);
  for (int i = 0; i < 4000; ++i) {
    std::string asf = kAsf, amc = kAmc;
    std::string& text = i % 2 == 0 ? asf : amc;
    const auto place = [&] {
      return std::uniform_int_distribution<size_t>(0, text.size() - 1)(generator);
    };
    for (int k = i % 5; k >= 0; --k) text[place()] = static_cast<char>(generator() & 0xFF);
    if (i % 7 == 0) text.erase(place(), place());
    try {
      const Clip clip = read(asf, amc);
      for (int frame = 0; frame < clip.frames(); ++frame) {
        for (const JointFrame& joint : jointFrames(clip, frame)) {
          EXPECT_TRUE(joint.p_WJ.allFinite());
        }
      }
    } catch (const InputError& error) {
      EXPECT_TRUE(error.file() == "s.asf" || error.file() == "m.amc");
      EXPECT_GE(error.line(), 1) << error.what();
    }
  }
}

struct Pair {
  const char* asf;
  const char* amc;
  const char* bvh;
};

// The BVH joint of an Acclaim bone of legs and spine, as cgspeed's conversion named them.
const std::map<std::string, std::string> kLegsAndSpine = {
    {"root", "Hips"},           {"lhipjoint", "LHipJoint"}, {"lfemur", "LeftUpLeg"},
    {"ltibia", "LeftLeg"},      {"lfoot", "LeftFoot"},      {"ltoes", "LeftToeBase"},
    {"rhipjoint", "RHipJoint"}, {"rfemur", "RightUpLeg"},   {"rtibia", "RightLeg"},
    {"rfoot", "RightFoot"},     {"rtoes", "RightToeBase"},  {"lowerback", "LowerBack"},
    {"upperback", "Spine"},     {"thorax", "Spine1"}};

TEST(AsfAmcOfCaptures, LieWhereTheirBvhHasThem) {
  AMBLE_NEEDS_CAPTURES();
  const std::filesystem::path folder = sharedFolder() / "mocap";
  for (const Pair& pair : {Pair{"07-walk.asf", "07_05-walk.amc", "07_05.bvh"},
                           Pair{"09-run.asf", "09_06-run.amc", "09_06.bvh"},
                           Pair{"01.asf", "01_01.amc", "01_01.bvh"}}) {
    const Clip acclaim =
        readAsfAmc(folder / "cmu_asfamc" / pair.asf, folder / "cmu_asfamc" / pair.amc);
    const Clip bvh = readBvh(folder / "cmu_mb2" / pair.bvh);
    ASSERT_EQ(bvh.frames(), acclaim.frames() + 1) << pair.amc;
    EXPECT_NEAR(bvh.frame_time, acclaim.frame_time, 1e-6);
    double largest = 0.0;
    for (int i = 0; i < acclaim.frames(); ++i) {
      const std::vector<JointFrame> a = jointFrames(acclaim, i), b = jointFrames(bvh, i + 1);
      for (const auto& [bone, joint] : kLegsAndSpine) {
        const int ja = acclaim.skeleton.find(bone), jb = bvh.skeleton.find(joint);
        ASSERT_GE(ja, 0) << bone;
        ASSERT_GE(jb, 0) << joint;
        largest = std::max(largest, (a[ja].p_WJ - b[jb].p_WJ).norm());
      }
    }
    EXPECT_LT(largest, 1e-3) << pair.amc;  // file units
  }
}

TEST(AsfAmcOfCaptures, TheMalformedSkeletonIsRefusedAtItsFirstLine) {
  AMBLE_NEEDS_CAPTURES();
  const std::filesystem::path folder = sharedFolder() / "mocap";
  try {
    readAsfAmc(folder / "formats/malformed_merge_conflict.asf", folder / "cmu_asfamc/01_01.amc");
    ADD_FAILURE() << "read without an error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 1);
    EXPECT_TRUE(error.file().ends_with("malformed_merge_conflict.asf"));
  }
}

}  // namespace
}  // namespace amble
