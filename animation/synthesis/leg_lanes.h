/// Both legs at four frames at once: where they are, where their ankles should be, and how they are
/// turned to reach there (foot_target.h, two_link.h).
///
/// The same to the bit on every machine: where it has AVX2 that is used, else what the compiler
/// makes of it. Numbers of four frames lie side by side: quantity[4 * i + frame].
#pragma once

namespace amble {

/// One leg. Joints of the skeleton by their index; of the chain by their place in it.
struct LaneLeg {
  struct Bone {
    int joint;          ///< of the skeleton
    int chain, parent;  ///< of the chain
  };
  int side;  ///< Side
  Bone up_leg, leg, foot;
  int toe;              ///< joint of the skeleton
  double knee_axis[3];  ///< about which the knee bends, in the thigh's joint frame
  double longest;       ///< reach, as a share of its length
  /// FootShape.
  double radius, ankle_height, ankle_x, heel_x, ball_x;
  double q_SF[4], q_FT[4], lateral_T[3];
};

/// The joints that legs hang on, parents first, and the legs.
struct LaneLegs {
  int joints = 0;
  const int* joint = nullptr;      ///< of the skeleton
  const int* parent = nullptr;     ///< of the chain
  const double* offset = nullptr;  ///< three each [m]
  LaneLeg legs[2];                 ///< by Side
};

/// A foot's soles at four frames (Sole).
struct LaneSoles {
  double position[12];                ///< x, y, z, four each [m, World]
  double heading[4];                  ///< [rad]
  double normal[12];                  ///< x, y, z, four each [unit]
  double pitch[4], roll[4], toes[4];  ///< [rad]
};

inline constexpr int kLaneJoint = 28;

/// What there is of legs at four frames.
struct LaneLegFrames {
  /// X_WJ of the chain's joints: q (x, y, z, w) and p, four each; kLaneJoint numbers a joint.
  double* joints;
  struct Target {
    double ankle[12], q_WF[16], toe[8];  ///< FootTarget; of half the toes' bend sine and cosine
    double distance[4];                  ///< of the ankle from the hip [m]
    double captured[4];                  ///< the same before the leg is turned to the target [m]
    double longest[4];                   ///< that the leg may be [m]; the caller's
    double hip_S[12];                    ///< the hip in the sole's frame [m]
    double behind[4];                    ///< HipOverSole [m]
  } targets[2];                          ///< by Side

  double hip(const LaneLeg& leg, int axis, int frame) const {
    return joints[kLaneJoint * leg.up_leg.chain + 16 + 4 * axis + frame];
  }
};

struct LegKernel {
  /// Joints of the chain, from poses: the root's position and quaternions x, y, z, w by joint.
  void (*placeChain)(const LaneLegs& legs, const double* const position[4],
                     const double* const rotations[4], LaneLegFrames& frames);
  /// Targets of one foot, from its soles.
  void (*aim)(const LaneLeg& leg, const LaneSoles& soles, LaneLegFrames& frames);
  /// How much lower the root has to be for no leg to be longer than it may [m].
  void (*lower)(const LaneLegs& legs, const LaneLegFrames& frames, double missing[4]);
  /// Turns the joints of both legs in `rotations` to their targets; whether both reach there.
  void (*reach)(const LaneLegs& legs, const LaneLegFrames& frames, double* const rotations[4],
                bool reached[4]);
};

extern const LegKernel kPlainLegs;
/// nullptr where the machine has none.
const LegKernel* avx2Legs();
/// The quickest that the machine has.
const LegKernel& legKernel();

}  // namespace amble
