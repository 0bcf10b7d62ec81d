/// A body at four poses at once: where its capsules are, and how far they move between two poses.
///
/// The capsules of placeBody up to rounding, the bounds of motion_bound.h; the same to the bit on
/// every machine: where it has AVX2 that is used, else what the compiler makes of it.
#pragma once

namespace amble {

/// Skeleton and parts as plain arrays. Points are x, y, z.
struct LaneBody {
  int joints = 0, parts = 0;
  const int* parent = nullptr;            ///< by joint
  const double* offset = nullptr;         ///< by joint, three each [m]
  const double* offset_length = nullptr;  ///< by joint [m]
  const int* part_joint = nullptr;        ///< by part
  const double* part_from = nullptr;      ///< by part, three each, in the joint's frame [m]
  const double* part_to = nullptr;        ///< the same
  const double* part_length = nullptr;    ///< by part: from the joint to its axis' farther end [m]
  const double* radius = nullptr;         ///< by part [m]
};

/// Of each pose the root's position and the joints' quaternions, x, y, z, w each.
struct LanePoses {
  const double* position[4];
  const double* rotations[4];
};

/// Numbers of scratch memory that a call needs for each joint.
inline constexpr int kLaneScratch = 28;

/// Four poses at once by one set of instructions.
struct LaneKernel {
  /// Into capsules[pose]: of each part from, to and radius, seven numbers.
  void (*place)(const LaneBody& body, const LanePoses& poses, double* scratch,
                double* const capsules[4]);
  /// Between the poses a[i] and b[i], of each part: into motions[i] PartMotion's path and bend,
  /// into nears[i] PartMotion::near, `rounding` added.
  void (*measure)(const LaneBody& body, const LanePoses& a, const LanePoses& b,
                  const double* const capsules_a[4], const double* const capsules_b[4],
                  double rounding, double* scratch, double* const motions[4],
                  double* const nears[4]);
};

extern const LaneKernel kPlainLanes;
/// nullptr where the machine has none.
const LaneKernel* avx2Lanes();
/// The quickest that the machine has.
const LaneKernel& lanes();

}  // namespace amble
