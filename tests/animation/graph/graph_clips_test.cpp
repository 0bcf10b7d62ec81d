#include "animation/graph/graph_clips.h"

#include <gtest/gtest.h>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/graph/graph_captures.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

const std::string kWalk = "accad_female1/Female1_B03_Walk1.bvh";

struct GraphClipsRead : testing::Test {
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(GraphClipsRead, FramesAreNumberedThroughAllClipsInTheirOrder) {
  int first = 0;
  ASSERT_EQ(someClips().about.size(), graphPaths().size());
  for (size_t i = 0; i < someClips().about.size(); ++i) {
    const GraphClip& about = someClips().about[i];
    EXPECT_EQ(about.first, first);
    EXPECT_EQ(about.frames, someClips().clips[i].clip.frames());
    for (const Side side : {kLeft, kRight})
      EXPECT_EQ(static_cast<int>(someClips().clips[i].planted[side].size()), about.frames);
    first = about.last() + 1;
  }
  EXPECT_EQ(someGraph().frames(), first);
  EXPECT_EQ(someGraph().features.cols(), first);
}

TEST_F(GraphClipsRead, EveryFrameIsFoundAgainByItsNumberInTheFile) {
  for (const GraphClip& about : someClips().about) {
    for (int frame = about.first; frame <= about.last(); ++frame)
      EXPECT_EQ(about.fromFile(about.inFile(frame)), frame) << about.name;
    EXPECT_EQ(about.fromFile(-1000), -1);
    EXPECT_EQ(about.fromFile(1000000), -1);
  }
}

TEST_F(GraphClipsRead, ThreadsChangeNothing) {
  const GraphClips four = graphClips(graphPaths(), 4);
  ASSERT_EQ(four.clips.size(), someClips().clips.size());
  for (size_t i = 0; i < four.clips.size(); ++i) {
    const Clip &a = four.clips[i].clip, &b = someClips().clips[i].clip;
    ASSERT_EQ(a.frames(), b.frames());
    EXPECT_EQ(four.clips[i].planted, someClips().clips[i].planted);
    for (int frame = 0; frame < a.frames(); frame += 9) {
      EXPECT_EQ(a.poses.p_WR(frame), b.poses.p_WR(frame));
      for (int j = 0; j < a.skeleton.size(); ++j)
        EXPECT_EQ(a.poses.rotations(frame)[j].coeffs(), b.poses.rotations(frame)[j].coeffs());
    }
  }
}

// Names are as long as it takes to tell them apart.
TEST_F(GraphClipsRead, ClipsOfOneNameAreToldApartByTheirFolders) {
  const TestFolder folder;
  std::vector<std::filesystem::path> files;
  for (const char* const name : {"a/x/walk.bvh", "b/x/walk.bvh", "b/y/walk.bvh", "b/y/run.bvh"}) {
    files.push_back(folder.path() / name);
    std::filesystem::create_directories(files.back().parent_path());
    std::filesystem::copy_file(sharedFolder() / "mocap" / kWalk, files.back());
  }
  const GraphClips clips = readGraphClips(files, {}, {}, 1);
  ASSERT_EQ(clips.about.size(), 4u);
  EXPECT_EQ(clips.about[0].name, "a/x/walk");
  EXPECT_EQ(clips.about[1].name, "b/x/walk");
  EXPECT_EQ(clips.about[2].name, "y/walk");
  EXPECT_EQ(clips.about[3].name, "run");
}

TEST_F(GraphClipsRead, TheFrameTimeIsTheOneAskedForOrTheSlowestClips) {
  EXPECT_NEAR(someClips().frame_time, 1.0 / kGraphRate, 1e-12);
  const std::filesystem::path file = sharedFolder() / "mocap" / kWalk;
  const GraphClips fine = readGraphClips({file}, {}, 1.0 / 60.0, 1);
  EXPECT_EQ(fine.clips[0].clip.frame_time, 1.0 / 60.0);
  EXPECT_NEAR(fine.about[0].frames, 2.0 * graphClips({kWalk}).about[0].frames, 2.0);
  const GraphClips slow = readGraphClips({file}, {.frame_time = 0.1}, {}, 1);
  EXPECT_EQ(slow.frame_time, 0.1);
  EXPECT_EQ(slow.about[0].step, 1.0);
}

TEST_F(GraphClipsRead, AClipTooShortToBeComparedIsRefusedByName) {
  const TestFolder folder;
  Clip clip = LevelWalk(kWalk).clip;
  const int frames = static_cast<int>(3.5 / kGraphRate / clip.frame_time);
  clip.poses.resize(frames);
  writeBvh(folder.path() / "short.bvh", clip);
  const std::string refused =
      errorOf([&] { readGraphClips({folder.path() / "short.bvh"}, {}, {}, 1); });
  EXPECT_NE(refused.find("short.bvh"), std::string::npos) << refused;
  EXPECT_NE(refused.find("at least 5 frames to be compared"), std::string::npos) << refused;
}

// A loop of one cycle is walked on, so that its ends are as comparable as its middle.
TEST_F(GraphClipsRead, AClipOfOneCycleIsWalkedOn) {
  for (const char* const path : {"formats/mass_walk.bvh", "cmu_style_loops/142_12_EDIT_LOOP.bvh"}) {
    const CapturedMotion motion = readLevelCapture(sharedFolder() / "mocap" / path).motion;
    const GraphClips clips = graphClips({path});
    EXPECT_NEAR(clips.clips[0].clip.duration(), kLoopTimes * motion.clip.duration(),
                2.0 * clips.frame_time + 2.0 * motion.clip.frame_time)
        << path;
  }
  EXPECT_LT(graphClips({"accad_female1/Female1_A01_Stand.bvh"}).clips[0].clip.duration(),
            1.05 * LevelWalk("accad_female1/Female1_A01_Stand.bvh").clip.duration());
}

// Where somebody walked and which way is nothing to what is alike: frames pair as they did.
TEST_F(GraphClipsRead, AGraphOfAMovedClipIsTheSameGraph) {
  GraphClips there = graphClips({kWalk});
  const ClusterGraph here = makeGraph(there, 1);
  there.clips[0].clip = moved(there.clips[0].clip, aboutZ(1.3), {5.0, -8.0, 0.0});
  const ClusterGraph gone = makeGraph(there, 1);
  EXPECT_EQ(here.states, gone.states);
  EXPECT_LT((here.features - gone.features).cwiseAbs().maxCoeff(), 1e-4f);
  const GraphCut a = cutAt(here, kGraphError), b = cutAt(gone, kGraphError);
  EXPECT_EQ(a.clusters.size(), b.clusters.size());
}

// The order of files is that of the numbers, and nothing else.
TEST_F(GraphClipsRead, ErrorsBetweenFramesDoNotKnowTheOrderOfClips) {
  const std::string run = "accad_female1/Female1_C05_WalkToRun.bvh";
  const ClusterGraph one = makeGraph(graphClips({kWalk, run}), 1);
  const ClusterGraph two = makeGraph(graphClips({run, kWalk}), 1);
  const int walk = one.clips[0].frames, of_run = one.clips[1].frames;
  for (int i = 0; i < walk; i += 7) {
    for (int j = 0; j < of_run; j += 11) {
      // Both are on the first clip's skeleton, which is the same person's.
      EXPECT_NEAR(one.error(i, walk + j), two.error(of_run + i, j),
                  1e-3f * (1.0f + one.error(i, walk + j)));
    }
  }
  const auto count = [](const ClusterGraph& graph) {
    return cutAt(graph, kGraphError).clusters.size();
  };
  EXPECT_NEAR(static_cast<double>(count(one)), static_cast<double>(count(two)),
              0.1 * static_cast<double>(count(one)));
}

TEST_F(GraphClipsRead, ALargerErrorNeverMakesMoreClusters) {
  size_t before = static_cast<size_t>(someGraph().frames());
  for (const double error : {0.0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 1.0, 100.0}) {
    const GraphCut cut = cutAt(someGraph(), error);
    EXPECT_LE(cut.clusters.size(), before) << error;
    before = cut.clusters.size();
    for (const FrameCluster& cluster : cut.clusters) EXPECT_LE(cluster.spread, error + 1e-6);
  }
}

}  // namespace
}  // namespace amble
