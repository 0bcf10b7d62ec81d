/// The clips of a graph, read and made comparable: level, at one frame time, on one skeleton.
///
/// Clips are of the first one's skeleton, or are carried over to it by joint role and leg length
/// (carry_over.h); one whose roles do not allow that is refused. Joints other than the root that
/// move are held fixed. A clip of one cycle, which ends as it begins, is walked on kLoopTimes
/// times: only so has its loop frames before and behind, to be compared and mixed. Its file's
/// frames are counted on.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/clips/join_clips.h"
#include "animation/graph/cluster_graph.h"

namespace amble {

/// A clip as it is played.
struct PlayableClip {
  Clip clip;
  PlantedFrames planted;
};

struct GraphClips {
  JointRoles roles;
  double frame_time = 1.0 / 30.0;     ///< [s]
  std::vector<GraphClip> about;       ///< where each is from
  std::vector<PlayableClip> clips;    ///< the same
  std::vector<std::string> warnings;  ///< with the file's name
};

inline constexpr int kLoopTimes = 3;

/// Frames a second of a graph for which none are asked: or those of its slowest clip [1/s].
inline constexpr double kGraphRate = 30.0;

/// @param frame_time  of all of them [s]; none: of kGraphRate, or of the slowest clip
/// @throws InputError as the reader does; for clips too short to be compared (three frames), or
/// that cannot be carried over; Stopped
GraphClips readGraphClips(const std::vector<std::filesystem::path>& files,
                          const MotionReadOptions& options, std::optional<double> frame_time,
                          int threads, const StopRequest& stop = {});

/// A graph of them. @param threads  changes no result. @throws Stopped
ClusterGraph makeGraph(const GraphClips& clips, int threads, const StopRequest& stop = {});

}  // namespace amble
