#include "viz/page/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"
#include "tests/animation/random_clip.h"
#include "tests/viz/page/read_back.h"
#include "viz/page/thin_clips.h"

namespace amble {
namespace {

using nlohmann::json;

const std::string kWalk = "accad_female1/Female1_B03_Walk1.bvh";

ShownClip shownWalk(const std::string& clip = kWalk) {
  return readShownClip(sharedFolder() / "mocap" / clip, {});
}

json plainJson(const ShownClip& shown) {
  return json::parse(benchClipJson({&shown, "", {}}, plainNumbers()));
}

TEST(PageNumbers, KeepTheDigitsThatCanBeSeen) {
  for (const double most : {1e-6, 0.4, 180.0, 2000.0, 1e6}) {
    for (const int digits : {2, 4}) {
      PageBytes bytes;
      const std::vector<double> values = {most, -most, 0.0, most / 3.0, -most / 7.0};
      const std::vector<double> read =
          readBack(bytes, json::parse(pageNumbers(bytes)(values, digits)));
      ASSERT_EQ(read.size(), values.size());
      for (size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(read[i], values[i], std::pow(10.0, -digits) / 2.0 + 1e-7 * most) << most;
    }
  }
}

TEST(PageNumbers, OfAnEmptyArrayAndOfZerosAreThose) {
  PageBytes bytes;
  const std::vector<double> zeros = {0.0, 0.0};
  EXPECT_EQ(readBack(bytes, json::parse(pageNumbers(bytes)({}, 3))), std::vector<double>());
  EXPECT_EQ(readBack(bytes, json::parse(pageNumbers(bytes)(zeros, 3))), zeros);
}

TEST(BenchClip, NamesOfAnyBytesStayInTheirStrings) {
  AMBLE_NEEDS_CAPTURES();
  ShownClip shown = shownWalk();
  shown.file = "</script>\"\n\xff";
  EXPECT_EQ(plainJson(shown)["file"].get<std::string>().substr(0, 11), "</script>\"\n");
}

// The file's own numbers, read by words.
TEST(BenchClip, ChannelsOfEveryJointAreThoseOfTheFile) {
  AMBLE_NEEDS_CAPTURES();
  const ShownClip shown = shownWalk();
  const json clip = plainJson(shown);
  std::ifstream file(sharedFolder() / "mocap" / kWalk);
  std::string word;
  std::vector<std::string> channels;  // axes of rotations, in the file's order
  while (file >> word && word != "MOTION") {
    if (word.ends_with("rotation")) channels.push_back(word.substr(0, 1));
    if (word.ends_with("position")) channels.push_back("");
  }
  while (file >> word && word != "Time:") {
  }
  file >> word;
  double value = 0.0;
  for (int frame = 0; frame < shown.file_frames; ++frame) {
    int rotations = 0;
    for (const std::string& axis : channels) {
      ASSERT_TRUE(file >> value);
      if (axis.empty()) continue;
      const int joint = rotations++ / 3;
      if (joint == 0) continue;  // the root is placed in World
      const double shows = clip["joints"][joint]["channels"][axis][frame];
      EXPECT_NEAR(std::remainder(shows - value, 360.0), 0.0, 2e-3) << joint << axis << frame;
    }
  }
}

TEST(BenchClip, FeetAreAsTheDetectorOfPlantsSeesThem) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& name : {kWalk, std::string("cmu_mb2/07_01.bvh")}) {
    const ShownClip shown = shownWalk(name);
    const json clip = plainJson(shown);
    const LevelCapture level = readLevelCapture(sharedFolder() / "mocap" / name);
    EXPECT_EQ(clip["first_frame"], level.first_frame);
    const FootPlants plants = detectPlants(level.motion.clip, level.motion.roles);
    for (const Side side : {kLeft, kRight}) {
      const json& foot = clip["feet"][side];
      ASSERT_EQ(foot["ankle"]["height"].size(), static_cast<size_t>(level.motion.clip.frames()));
      for (const FootPlant& plant : plants.plants[side]) {
        const int middle = (plant.first + plant.last) / 2;
        bool below = false;
        for (const char* const point : {"ankle", "toe"}) {
          below = below || (foot[point]["height"][middle] < foot[point]["height_limit"] &&
                            foot[point]["speed"][middle] < foot[point]["speed_limit"]);
        }
        EXPECT_TRUE(below) << name << " " << plant.first;
      }
    }
  }
}

TEST(BenchClip, SpeedsOfTheRootAreWhatItsPlacesSay) {
  AMBLE_NEEDS_CAPTURES();
  const ShownClip shown = shownWalk();
  const json root = plainJson(shown)["root"];
  const int last = shown.file_frames - 1;
  double way = 0.0;
  for (int i = 1; i <= last; ++i)
    way += root["speed"][i].get<double>() * shown.motion.clip.frame_time;
  const double length = std::hypot(root["x"][last].get<double>() - root["x"][0].get<double>(),
                                   root["y"][last].get<double>() - root["y"][0].get<double>());
  EXPECT_NEAR(way, length, 0.03 * length);  // it walks straight
}

TEST(ThinClips, LeaveNothingOutWhereAllOfItFits) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<ShownClip> clips = {shownWalk()};
  EXPECT_TRUE(thinClips(clips).empty());
  EXPECT_EQ(clips[0].motion.clip.frames(), clips[0].file_frames);
  EXPECT_TRUE(fitExactly(clips));
}

TEST(ThinClips, KeepFramesOfTheFileAndSayHowMany) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<ShownClip> clips = {shownWalk("cmu_mb2/07_01.bvh"), shownWalk()};
  const Clip whole = clips[0].motion.clip;
  const std::vector<std::string> notes = thinClips(clips, 200'000);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("07_01.bvh: 60 of 120 frames a second"), std::string::npos) << notes[0];
  const Clip& thin = clips[0].motion.clip;
  EXPECT_EQ(clips[0].every, 2);
  EXPECT_EQ(clips[1].every, 1);  // it has 30 a second
  EXPECT_DOUBLE_EQ(thin.frame_time, 2.0 * whole.frame_time);
  for (int frame = 0; frame < thin.frames(); ++frame)
    ASSERT_EQ(thin.poses.p_WR(frame), whole.poses.p_WR(2 * frame));
  EXPECT_EQ(plainJson(clips[0])["frame_time"].get<double>(), whole.frame_time);
}

// Frames a second, and how many, of a clip that nobody is in.
ShownClip madeClip(double rate, int frames) {
  ShownClip shown;
  shown.name = std::to_string(static_cast<int>(rate));
  Generator random(1);
  Clip& clip = shown.motion.clip;
  clip.skeleton = randomSkeleton(random, 20);
  clip.frame_time = 1.0 / rate;
  clip.poses = PoseArray(20);
  clip.poses.resize(frames);
  shown.file_frames = frames;
  return shown;
}

TEST(ThinClips, NoClipIsThinnedBelowWhatIsSmoothAndEveryFasterOneIsThinnedThatFar) {
  Generator random(2);
  for (int round = 0; round < 20; ++round) {
    std::vector<ShownClip> clips;
    for (const double rate : {25.0, 30.0, 47.0, 60.0, 100.0, 120.0, 240.0})
      if (uniform(random, 0.0, 1.0) < 0.7) clips.push_back(madeClip(rate, 100));
    thinClips(clips, 1);  // all that may be left out is
    for (const ShownClip& shown : clips) {
      const double rate = 1.0 / shown.motion.clip.frame_time;
      EXPECT_GE(rate, kFewestFrames - 1e-9) << shown.name;
      EXPECT_LT(rate * shown.every / (shown.every + 1), kFewestFrames) << shown.name;
      EXPECT_EQ(shown.motion.clip.frames(), (100 + shown.every - 1) / shown.every);
    }
  }
}

TEST(ThinClips, LeaveOutNoMoreThanIsNeeded) {
  const auto size = [](const std::vector<ShownClip>& clips) {
    size_t frames = 0;
    for (const ShownClip& shown : clips) frames += shown.motion.clip.frames();
    return frames * 20 * 14;  // rotations in 16 bits and three angles
  };
  for (const size_t most : {1'000'000u, 600'000u, 300'000u}) {
    std::vector<ShownClip> clips = {madeClip(240, 2400), madeClip(120, 1200), madeClip(30, 300)};
    thinClips(clips, most);
    EXPECT_LE(size(clips), most);
    // One frame in fewer of the fastest would be too many.
    const auto fastest = std::max_element(
        clips.begin(), clips.end(), [](const auto& a, const auto& b) { return a.every < b.every; });
    ASSERT_GT(fastest->every, 1);
    EXPECT_GT(fastest->every * size(clips) / (fastest->every - 1), most);
  }
}

// A plant may be so short that none of its frames is on the page.
TEST(ThinClips, EveryPlantOnThePageHasAFrameThatIsThere) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<ShownClip> clips = {shownWalk("cmu_mb2/07_01.bvh")};
  thinClips(clips, 1);
  ShownClip& shown = clips[0];
  ASSERT_GT(shown.every, 1);
  for (int first = 0; first < 40; ++first)
    for (int length = 0; length < 6; ++length)
      shown.analysis->plants.plants[kRight].push_back({first, first + length});
  const int end = shown.file_frames - 1 - shown.first_frame;
  shown.analysis->plants.plants[kRight].push_back({end, end});
  const PageTake take = clipPage(clips).takes[0];
  for (const auto& side : take.planted)
    for (const FrameSpan& span : side) {
      EXPECT_LE(span.first, span.last);
      EXPECT_GE(span.first, 0);
      EXPECT_LT(span.last, shown.motion.clip.frames());
    }
}

// Of the page, a plant's frames are those of its time.
TEST(ThinClips, MoveNoPlant) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<ShownClip> clips = {shownWalk("cmu_mb2/07_01.bvh")};
  const std::vector<FrameSpan> before = clipPage(clips).takes[0].planted[kLeft];
  thinClips(clips, 1);
  const int every = clips[0].every;
  ASSERT_GT(every, 1);
  const std::vector<FrameSpan> after = clipPage(clips).takes[0].planted[kLeft];
  ASSERT_EQ(after.size(), before.size());
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_GE(after[i].first * every, before[i].first);
    EXPECT_LT(after[i].first * every, before[i].first + every);
    EXPECT_LE(after[i].last * every, before[i].last);
  }
}

}  // namespace
}  // namespace amble
