#include "animation/graph/graph_clips.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "animation/analysis/foot_plants.h"
#include "animation/body/reference_pose.h"
#include "animation/clips/add_toes.h"
#include "animation/clips/carry_over.h"
#include "animation/clips/level_capture.h"
#include "animation/clips/loop_clip.h"
#include "animation/clips/resample_clip.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"

namespace amble {
namespace {

// Accelerations take two frames on each side.
constexpr int kFewestFrames = 5;
// Bones that differ by less are the same, as they are written [m].
constexpr double kSameBone = 1e-4;

// Longer clips that end as they begin are no single cycle [s].
constexpr double kLongestCycle = 4.0;
// Joints of who stands move by less against the root; of walkers by five times as much [m/s].
constexpr double kStill = 0.1;

struct ReadClip {
  LevelCapture capture;
  double file_frame_time = 0.0;  // [s]
};

// Walked on where it is one cycle: who begins and ends standing comes back to no step.
Clip walkedOn(const Clip& clip, const JointRoles& roles) {
  if (clip.frames() < kFewestFrames || clip.duration() > kLongestCycle) return clip;
  std::vector<JointFrame> first(clip.skeleton.size()), second(first.size());
  forwardKinematics(clip, 0, first);
  forwardKinematics(clip, 1, second);
  if (poseGap(first, second, roles) < kStill * clip.frame_time) return clip;
  const auto loop = repeatedLoop(clip, roles, kLoopTimes);
  return loop ? *loop : clip;
}

ReadClip readOne(const std::filesystem::path& file, const MotionReadOptions& options) {
  ReadClip read{readLevelCapture(file, options), 0.0};
  CapturedMotion& motion = read.capture.motion;
  read.file_frame_time = motion.clip.frame_time;
  if (!motion.clip.joint_positions.empty()) {
    motion.warnings.push_back("joints other than the root move; they are held fixed");
    motion.clip.joint_positions.clear();
  }
  addToes(motion.clip, motion.roles, file.string());
  motion.clip = walkedOn(motion.clip, motion.roles);
  return read;
}

bool sameSkeleton(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (int j = 0; j < a.size(); ++j) {
    const Joint &p = a.joint(j), &q = b.joint(j);
    if (p.name != q.name || p.parent != q.parent || (p.offset - q.offset).norm() > kSameBone)
      return false;
  }
  return true;
}

// Onto the skeleton of the first clip, and on the floor again.
Clip carried(const CapturedMotion& motion, const CapturedMotion& onto) {
  if (sameSkeleton(motion.clip.skeleton, onto.clip.skeleton)) return motion.clip;
  const ReferencePose there = referenceOf(motion.clip, motion.roles),
                      here = referenceOf(onto.clip, onto.roles);
  return levelled(carriedOver(motion.clip, {motion.clip.skeleton, motion.roles, there},
                              {onto.clip.skeleton, onto.roles, here}),
                  onto.roles);
}

PlantedFrames plantedAt(const FootPlants& plants, const Clip& clip, double step) {
  PlantedFrames planted;
  for (const Side side : {kLeft, kRight}) {
    const std::vector<bool> all = plants.planted(side);
    for (int i = 0; i < clip.frames(); ++i) {
      const int frame = static_cast<int>(std::lround(i * step));
      planted[side].push_back(all[std::min<size_t>(frame, all.size() - 1)]);
    }
  }
  return planted;
}

PlayableClip playable(const ReadClip& read, const ReadClip& first, double frame_time,
                      const std::filesystem::path& file) {
  const Clip full = carried(read.capture.motion, first.capture.motion);
  PlayableClip result{resampleClip(full, frame_time), {}};
  if (result.clip.frames() < kFewestFrames)
    throw InputError(file.string(), 0,
                     "lasts for " + counted(result.clip.frames(), "frame") + " at " +
                         std::to_string(std::lround(1.0 / frame_time)) + " a second",
                     "at least " + std::to_string(kFewestFrames) + " frames to be compared");
  const FootPlants plants = detectPlants(full, first.capture.motion.roles);
  result.planted = plantedAt(plants, result.clip, frame_time / full.frame_time);
  return result;
}

// A file's name without ending, with as many of its folders before it as tell it from the others.
std::vector<std::string> namesOf(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> names(files.size());
  std::vector<std::filesystem::path> above(files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    names[i] = files[i].stem().string();
    above[i] = std::filesystem::absolute(files[i]).lexically_normal().parent_path();
  }
  for (bool again = true; again;) {
    again = false;
    std::map<std::string, int> count;
    for (const std::string& name : names) ++count[name];
    for (size_t i = 0; i < files.size(); ++i) {
      if (count[names[i]] == 1 || !above[i].has_filename()) continue;
      names[i] = above[i].filename().string() + "/" + names[i];
      above[i] = above[i].parent_path();
      again = true;
    }
  }
  return names;
}

double frameTimeOf(const std::vector<ReadClip>& read) {
  double frame_time = 1.0 / kGraphRate;
  for (const ReadClip& clip : read) frame_time = std::max(frame_time, clip.file_frame_time);
  // 1/30 s is written with more or fewer digits.
  return frame_time < 1.001 / kGraphRate ? 1.0 / kGraphRate : frame_time;
}

}  // namespace

GraphClips readGraphClips(const std::vector<std::filesystem::path>& files,
                          const MotionReadOptions& options, std::optional<double> frame_time,
                          int threads, const StopRequest& stop) {
  const int count = static_cast<int>(files.size());
  std::vector<ReadClip> read(count);
  parallelFor(count, threads, [&](int i, int) {
    stop.check();
    read[i] = readOne(files[i], options);
  });
  GraphClips result;
  result.roles = read[0].capture.motion.roles;
  result.frame_time = frame_time.value_or(frameTimeOf(read));
  result.clips.resize(count);
  parallelFor(count, threads, [&](int i, int) {
    stop.check();
    result.clips[i] = playable(read[i], read[0], result.frame_time, files[i]);
  });
  const std::vector<std::string> names = namesOf(files);
  int first = 0;
  for (int i = 0; i < count; ++i) {
    result.about.push_back({names[i], first, result.clips[i].clip.frames(),
                            read[i].capture.first_frame,
                            result.frame_time / read[i].file_frame_time});
    first += result.about.back().frames;
    for (const std::string& warning : read[i].capture.motion.warnings)
      result.warnings.push_back(files[i].string() + ": " + warning);
  }
  return result;
}

ClusterGraph makeGraph(const GraphClips& clips, int threads, const StopRequest& stop) {
  ClusterGraph graph;
  graph.frame_time = clips.frame_time;
  graph.clips = clips.about;
  const GraphClip& last = graph.clips.back();
  graph.features.resize(kFeatureRows, last.last() + 1);
  for (size_t i = 0; i < clips.clips.size(); ++i) {
    const PlayableClip& clip = clips.clips[i];
    graph.features.middleCols(clips.about[i].first, clips.about[i].frames) =
        frameFeatures(clip.clip, clips.roles);
    const std::vector<SupportState> states = supportStates(clip.planted);
    graph.states.insert(graph.states.end(), states.begin(), states.end());
  }
  growTrees(graph, threads, stop);
  return graph;
}

}  // namespace amble
