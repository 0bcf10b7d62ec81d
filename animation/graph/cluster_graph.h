/// The cluster graph of some clips (Shanbhag's thesis, chapter 4): which of their frames are alike,
/// and so where one can be left for another.
///
/// What is kept is the tree of clusters; a graph is what it is cut into at an error (GraphCut).
/// Frames are numbered through all clips, in their order, at one frame time.
#pragma once

#include <string>
#include <vector>

#include "animation/graph/agglomeration.h"
#include "animation/graph/support_state.h"

namespace amble {

/// A clip in a graph. Its frames are a part of its file's: frame i is the file's frame first_frame
/// + i * step, rounded.
struct GraphClip {
  std::string name;     ///< its file's without ending, and folders where another has the same
  int first = 0;        ///< its first frame among those of all clips
  int frames = 0;       ///< [> 0]
  int first_frame = 0;  ///< of the file [>= 0]
  double step = 1.0;    ///< frames of the file for one of the graph's [> 0]

  int last() const { return first + frames - 1; }  ///< among those of all clips
  /// The frame of the file, of a frame among those of all clips.
  int inFile(int frame) const;
  /// The one that is nearest to a frame of the file, among those of all clips; -1: none is.
  int fromFile(int file_frame) const;
};

struct ClusterGraph {
  double frame_time = 1.0 / 30.0;  ///< [s, > 0]
  std::vector<GraphClip> clips;
  FrameFeatures features;            ///< a column a frame
  std::vector<SupportState> states;  ///< a value a frame
  /// The trees of all states, one after another; node n + k is what merge k makes of n frames.
  std::vector<Merge> merges;

  int frames() const { return static_cast<int>(states.size()); }
  int clipOf(int frame) const;  ///< index of the clip that a frame is in
  float error(int i, int j) const { return frameError(features, i, j); }
  /// Whether its clip has kJoinRoom frames before a frame and behind it, for a blend.
  bool hasRoom(int frame) const;
};

/// A join without any blend is a cut: frames nearer to an end of their clip are left and entered
/// only where no others are alike [frames].
inline constexpr int kJoinRoom = 5;

/// Fills `merges`. @pre clips, features and states are there. @throws Stopped
void growTrees(ClusterGraph& graph, int threads, const StopRequest& stop = {});

/// Frames of one clip, one after another, that are in one cluster: a clip-frame sequence.
struct FrameSequence {
  int clip = 0, cluster = 0;
  int first = 0, last = 0;  ///< among those of all clips
  int alignment = 0;        ///< the frame at which it is left and entered (§4.2.4)
};

/// A node of the graph: frames alike in one state.
struct FrameCluster {
  SupportState state = SupportState::kL;
  std::vector<int> sequences;  ///< in order of their frames
  std::vector<int> next;       ///< clusters that a clip goes on to from here, in order
  int frames = 0;
  double spread = 0.0;  ///< root mean error of its frames from their mean [m, >= 0]
};

/// Frames that differ by less are taken for alike where nothing else is asked: by it a cycle of a
/// walk is some ten clusters, as in the thesis, and joins are hard to see; by trial [m].
inline constexpr double kGraphError = 0.08;

/// A graph's tree cut at an error: clusters are what agglomeration had made before two that are
/// less alike than that would have become one. In order of their first frames.
struct GraphCut {
  double error = 0.0;  ///< root of E [m]
  std::vector<FrameCluster> clusters;
  std::vector<FrameSequence> sequences;  ///< in order of their frames
  std::vector<int> sequence_of;          ///< by frame

  int clusterOf(int frame) const { return sequences[sequence_of[frame]].cluster; }
};

/// @param error  root of E [m, >= 0]
GraphCut cutAt(const ClusterGraph& graph, double error);

/// The frames of a sequence that have room, or all where none has.
std::vector<int> roomyFrames(const ClusterGraph& graph, const FrameSequence& sequence);

/// The two of these frames, one of each sequence, that are most alike; the first of such.
std::pair<int, int> bestPair(const ClusterGraph& graph, const FrameSequence& from,
                             const FrameSequence& to);

}  // namespace amble
