/// Animated nodes, as FBX, glTF and Collada have them, and the clip that they make.
///
/// Nodes of a file carry everything: joints, meshes, cameras, the helpers that a rotation's pivots
/// become. The skeleton is the largest tree of animated nodes, from the joint on at which it
/// branches (the hips): what moves above it is in the root's place.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "animation/body/clip.h"

namespace amble {

/// Frames times joints of a sampled clip: 0.6 GB of poses. An hour of 90 joints at 30 Hz has as
/// many.
inline constexpr size_t kMaxSampledPoses = 10'000'000;
/// Frames times nodes that are placed for them, of which an FBX has several a joint; some ten
/// seconds' work.
inline constexpr size_t kMaxPlacedNodes = 100'000'000;

/// How a track goes from key to key.
enum class KeyShape { kLinear, kStep, kCubic };

/// Values at times [s], ascending, held beyond the ends. Linear in between (rotations by slerp), or
/// held, or cubic: Hermite's with a slope at each side of a key (glTF 2.0, appendix C), of a
/// rotation's four numbers, which are then normalized.
template <typename T>
struct KeyTrack {
  std::vector<double> times;
  std::vector<T> values;
  KeyShape shape = KeyShape::kLinear;
  std::vector<T> in = {}, out = {};  ///< of kCubic: slopes before and after each key [1/s]
};

/// What replaces a node's rest transform while it is animated: translation * rotation * scale.
struct NodeTracks {
  KeyTrack<Eigen::Vector3d> translations;
  KeyTrack<Eigen::Quaterniond> rotations;
  KeyTrack<Eigen::Vector3d> scales;
  bool empty() const {
    return translations.times.empty() && rotations.times.empty() && scales.times.empty();
  }
};

struct AnimatedNode {
  std::string name;
  int parent = -1;                                     ///< index, smaller than its own; -1: none
  Eigen::Affine3d X_PN = Eigen::Affine3d::Identity();  ///< in its parent, at rest
  NodeTracks tracks;                                   ///< empty: it stays at rest
  bool helper = false;  ///< a part of the next node's transform, no place of its own
  bool bone = false;    ///< a mesh's skin names it
  bool thing = false;   ///< has a mesh, a camera or a light
};

struct AnimatedNodes {
  std::vector<AnimatedNode> nodes;                        ///< parents first; tracks of one take
  Eigen::Affine3d X_WFile = Eigen::Affine3d::Identity();  ///< axes and unit, to World and metres
  double frame_time = 0.0;  ///< the file's own; 0: as the keys lie [s]
};

/// An animation that a file has for its nodes.
struct NodeTake {
  std::string name;
  std::vector<NodeTracks> tracks;  ///< by node
  double frame_time = 0.0;         ///< its own; 0: as the keys lie [s]
};

/// How much moves in a take: the largest turns of all nodes, and their ways over the longest of
/// them, summed [rad].
double movementIn(const NodeTake& take);

/// Every joint at rest has axes parallel to a y-up file's, as in BVH, wherever the file's own axes
/// point: so that clips of all formats are used alike. Nodes that end a limb without being animated
/// are end sites. Bones whose length the file changes have moving joints (Clip::joint_positions).
/// @param frame_time  of the clip [s, > 0]; none: the file's, or so many frames between its keys
/// that there are 30 a second
/// @throws InputError naming `file`: no animated node, a number that is not finite, more than
/// kMaxJoints joints, more frames than kMaxSampledPoses and kMaxPlacedNodes allow.
Clip clipOfNodes(const AnimatedNodes& scene, const std::string& file,
                 std::optional<double> frame_time = {});

}  // namespace amble
