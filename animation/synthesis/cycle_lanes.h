/// Cycles at four moments at once: their channels blended, and the poses that these are.
///
/// The same to the bit on every machine: where it has AVX2 that is used, else what the compiler
/// makes of it. Numbers of four frames lie side by side: quantity[4 * i + frame].
#pragma once

namespace amble {

/// A cycle that is warped and added: coefficients of each channel (WalkCycle::series), side by
/// side: alpha_0, alpha_1, beta_1, alpha_2, ...
struct LanePace {
  const double* coefficients = nullptr;
  int harmonics = 0;  ///< [0, kMaxHarmonics]
  double step = 1.0;  ///< [m, > 0]
};

/// What is blended at four frames.
struct LaneBlend {
  /// At each frame two straight walks, what these are otherwise than the plan's, and two turns.
  static constexpr int kMostPaces = 24;
  struct Weighed {
    const LanePace* pace;
    double weight[4];
  };
  int count = 0;
  Weighed paces[kMostPaces];  ///< the first `count` of them
  double phase[4];            ///< [cycles]
  double step_length[4];      ///< [m]
};

/// Where the root is put at four frames: on the point of a path and its heading, then leant.
struct LaneRoots {
  double position[12];  ///< x, y, z, four each [m, World]
  double heading[4];    ///< [rad]
  double lean[4];       ///< forwards [rad]
};

struct CycleKernel {
  /// GaitBlend::evaluate: into values[4 * channel + frame].
  void (*blend)(const LaneBlend& blend, int channels, double* values);
  /// projectChannels: into position[frame] the root's, into rotations[frame] quaternions x, y, z,
  /// w. reference: the same by joint.
  void (*project)(int joints, const double* reference, const double* channels,
                  const LaneRoots& roots, double* const position[4], double* const rotations[4]);
};

extern const CycleKernel kPlainCycles;
/// nullptr where the machine has none.
const CycleKernel* avx2Cycles();
/// The quickest that the machine has.
const CycleKernel& cycleKernel();

}  // namespace amble
