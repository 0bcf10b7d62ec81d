// Every option of amble animate does what the help says of it.

#include <cmath>

#include "animation/captures/bvh.h"
#include "base/rotation.h"
#include "tests/app/options.h"

namespace amble {
namespace {

using nlohmann::json;

class AnimateOptions : public Options {
 protected:
  // The walk between its start and its stop, as analyse measures it.
  json gait(const std::string& options) const {
    good("animate -o a.bvh --duration 8 " + options);
    good("convert a.bvh -o b.bvh --trim 2s:6s");
    return printed("analyse b.bvh --json")[0]["gait"];
  }
  double measured(const std::string& options, const char* what) const {
    return gait(options)[what].get<double>();
  }
  Clip clipOf(const std::string& options) const {
    good("animate -o a.bvh --duration 4 " + options);
    return readBvh(folder_ / "a.bvh");
  }
  static Eigen::Vector3d rise(const Clip& clip) {
    return clip.poses.p_WR(clip.frames() - 1) - clip.poses.p_WR(0);
  }
  Uses ofTheWalk() const;
  Uses ofTheClip() const;
  void expectEngineWalks() const;
  void expectHeld(const std::string& engine) const;
  void expectStops(const std::string& engine) const;
};

// QUALITY.md's bars of held feet, by whoever finds plants himself: at speeds that nobody was
// captured at, from and to standing.
void AnimateOptions::expectHeld(const std::string& engine) const {
  for (const char* const speed :
       {"0.2", "0.4", "0.7", "1.3", "1.2..0", "0.8..0", "0..1.2", "0..0.6"}) {
    good("animate -o a.bvh --duration 6 " + engine + speed);
    const json feet = printed("analyse a.bvh --as-is --json")[0]["quality"];
    EXPECT_LT(feet["largest_drift"].get<double>(), 0.002) << speed;
    EXPECT_LT(feet["toe_skate"].get<double>(), 0.010) << speed;
    EXPECT_LT(feet["penetration"].get<double>(), 0.005) << speed;
  }
}

// Who comes to a stand puts his last foot beside the other, as he stands before he walks; his hips
// do not go back.
void AnimateOptions::expectStops(const std::string& engine) const {
  const Clip start = clipOf(engine + "0..1");
  std::vector<JointFrame> stands(start.skeleton.size()), stops = stands;
  forwardKinematics(start, 0, stands);
  for (const char* const speed : {"0.4..0", "1..0", "1.5..0"}) {
    const Clip stop = clipOf(engine + speed);
    double farthest = stop.poses.p_WR(0).x();
    for (int i = 0; i < stop.frames(); ++i) {
      farthest = std::max(farthest, stop.poses.p_WR(i).x());
      EXPECT_GT(stop.poses.p_WR(i).x(), farthest - 0.005) << speed << ", frame " << i;
    }
    forwardKinematics(stop, stop.frames() - 1, stops);
    for (int j = 0; j < stop.skeleton.size(); ++j) {
      const std::string& name = stop.skeleton.joint(j).name;
      if (name.find("Leg") != std::string::npos) continue;  // of legs that are nearly straight
      const Eigen::Vector3d from_root = stands[j].p_WJ - stands[0].p_WJ;
      EXPECT_LT((stops[j].p_WJ - stops[0].p_WJ - from_root).norm(), 0.01) << speed << ", " << name;
    }
  }
}

// Of an engine made of three walks of ours, the speed as it is asked for, and along a ramp.
void AnimateOptions::expectEngineWalks() const {
  for (const char* const speed : {"0.8", "1.1", "1.5"}) {
    good(std::string("animate -o ") + speed + ".bvh --duration 6 --speed " + speed);
  }
  good("library engine build 0.8.bvh 1.1.bvh 1.5.bvh -o e.yaml");
  const std::string engine = "--engine e.yaml --speed ";
  EXPECT_NEAR(measured(engine + "0.95", "speed"), 0.95, 0.01);
  const Clip ramp = clipOf(engine + "0.6..1.4");
  EXPECT_NEAR(rise(ramp).x(), 4.0, 0.1);
  const int second = static_cast<int>(std::lround(1.0 / ramp.frame_time));
  const auto way = [&](int from) {
    return (ramp.poses.p_WR(from + second) - ramp.poses.p_WR(from)).x();
  };
  EXPECT_GT(way(3 * second), 1.5 * way(0));
  expectHeld(engine);
  expectStops(engine);
  EXPECT_NE(good("animate -o a.bvh --duration 2 " + engine + "3").err.find(" is taken"),
            std::string::npos);
  good("animate -o a.glb --duration 2 " + engine + "1");
  for (const char* const also : {"--turn 5", "--stride 0.6", "--incline 3", "--lift 0.1",
                                 "--stairs .1,.3", "--action carry", "--library default"}) {
    expectRefused("animate -o a.bvh " + engine + "1 " + also, {"--engine"});
  }
  expectRefused("animate -o a.bvh --speed 0.6..1.4", {"--speed", "expected one speed", "--engine"});
  expectRefused("animate -o a.bvh --engine in/room.yaml", {"in/room.yaml:"});
}

AnimateOptions::Uses AnimateOptions::ofTheWalk() const {
  return {
      {"--speed", [this] { EXPECT_NEAR(measured("--speed 0.8", "speed"), 0.8, 0.01); }},
      {"--style",
       [this] {
         good("animate --speed 0.8 --duration 8 -o calm.bvh");
         good("library add in/mine.yaml calm.bvh --style calm");
         EXPECT_NEAR(measured("--library in/mine.yaml --style calm", "speed"), 0.8, 0.02);
         expectRefused("animate -o b.bvh --library in/mine.yaml --style bold",
                       {"in/mine.yaml: ", "'bold'", "expected one of calm"});
         expectRefused("animate -o b.bvh --style bold", {"default.yaml: ", "'bold'", "no style"});
       }},
      {"--turn",
       [this] {
         EXPECT_NEAR(measured("--turn 20", "turn_rate"), 20.0, 0.5);
         EXPECT_NEAR(measured("--turn -20", "turn_rate"), -20.0, 0.5);
         for (const char* const tall : {"--height 1.4", "--height 2"})
           good(std::string("animate -o a.bvh --duration 6 --turn 60 --quality ") + tall);
       }},
      {"--stride", [this] { EXPECT_NEAR(measured("--stride 0.55", "step_length"), 0.55, 0.011); }},
      {"--lift", [this] { EXPECT_NEAR(measured("--lift 0.12", "lift"), 0.12, 0.0025); }},
      {"--incline",
       [this] {
         const Eigen::Vector3d up = rise(clipOf("--incline 8"));
         EXPECT_NEAR(up.z(), up.x() * std::tan(8.0 * kDegree), 0.02);
       }},
      {"--stairs",
       [this] {
         const double risers = rise(clipOf("--stairs .15,.3")).z() / 0.15;
         EXPECT_NEAR(risers, std::round(risers), 0.1);
         EXPECT_GE(risers, 1.9);
         EXPECT_LE(rise(clipOf("--stairs -.15,.3")).z(), -0.28);
         EXPECT_NE(good("animate -o b.bvh --stairs .15,.2 --height 2", 1)
                       .err.find("stands on treads of 0.2"),
                   std::string::npos);
         for (const char* const also : {"--turn 5", "--stride 0.6", "--incline 3"}) {
           expectRefused(std::string("animate -o a.bvh --stairs .15,.3 ") + also, {"--stairs"});
         }
       }},
      {"--height", [this] {
         const double leg = measured("", "leg_length");
         EXPECT_NEAR(measured("--height 1.5", "leg_length"), leg * 1.5 / 1.634, 0.002);
       }}};
}

AnimateOptions::Uses AnimateOptions::ofTheClip() const {
  return {{"--output",
           [this] {
             expectRefused("animate", {"--output"});
             const std::string streamed = good("animate --duration 2 -o -").out;
             good("animate --duration 2 --output a.bvh");
             EXPECT_EQ(read("a.bvh"), streamed);
           }},
          {"--duration",
           [this] {
             for (const double wanted : {3.0, 6.0}) {
               good("animate -o a.bvh --duration " + std::to_string(wanted));
               EXPECT_NEAR(readBvh(folder_ / "a.bvh").duration(), wanted, 0.3);
             }
           }},
          {"--action",
           [this] {
             const Clip free = clipOf(""), carrying = clipOf("--action carry");
             ASSERT_EQ(free.frames(), carrying.frames());
             const auto turned = [&](const char* const joint) {
               const int j = free.skeleton.find(joint), middle = free.frames() / 2;
               return free.poses.rotations(middle)[j].angularDistance(
                   carrying.poses.rotations(middle)[j]);
             };
             EXPECT_GT(turned("LeftForeArm"), 0.5);
             EXPECT_LT(turned("LeftLeg"), 1e-9);
           }},
          {"--library",
           [this] {
             const Clip named = clipOf("--library default");
             EXPECT_EQ(named.frames(), clipOf("").frames());
             expectRefused("animate -o a.bvh --library in/none.yaml", {"in/none.yaml: "});
           }},
          {"--engine", [this] { expectEngineWalks(); }},
          {"--fps", [this] { EXPECT_NEAR(clipOf("--fps 30").frame_time, 1.0 / 30.0, 1e-6); }},
          {"--bvh-units",
           [this] {
             const Eigen::Vector3d m = rise(clipOf("")), cm = rise(clipOf("--bvh-units cm"));
             EXPECT_LT((cm - 100.0 * m).norm(), 1e-3);
           }},
          {"--names",
           [this] {
             const Clip own = clipOf(""), named = clipOf("--names mixamo");
             const int hips = named.skeleton.find("mixamorig_Hips");
             ASSERT_EQ(hips, 0);
             EXPECT_EQ(own.poses.p_WR(9), named.poses.p_WR(9));
             EXPECT_GE(named.skeleton.find("mixamorig_LeftUpLeg"), 0);
           }},
          {"--quality", [this] {
             const Ran judged = good("animate -o a.bvh --duration 4 --quality");
             EXPECT_NE(judged.out.find("toe skate"), std::string::npos);
             EXPECT_EQ(judged.out.find("ABOVE"), std::string::npos) << judged.out;
           }}};
}

TEST_F(AnimateOptions, AreAllTried) { expectAll("animate", {ofTheWalk(), ofTheClip()}); }

}  // namespace
}  // namespace amble
