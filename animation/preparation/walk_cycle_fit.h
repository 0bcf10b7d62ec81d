/// A levelled capture becomes a walk cycle (Pettré §4.1): its steady cycles, each around its fitted
/// line or circle, averaged and taken as Fourier series.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/body/clip.h"
#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/library/walk_cycle.h"

namespace amble {

struct CycleOptions {
  std::string clip;      ///< for messages
  bool turning = false;  ///< look for a turn: the cycle with the least closure for its turn rate
  int harmonics = 0;     ///< of the low-pass [1, 12]; 0: as few as leave little out
  std::optional<std::pair<int, int>> frames;  ///< look only within these frames of the clip
  const FootPlants* plants = nullptr;         ///< of the clip, where they are known; null: detected
};

/// Finds the steady cycles of a levelled clip, fits a line or circle to each, averages the errors
/// around it over the cycles and takes their Fourier series. Fit: of all lines (circles) the one on
/// which the cycle closes, that is, whose ends are a whole cycle's ends; least squares over a
/// single cycle would lean with the sway. @param reference  the library's reference rotations, root
/// against heading first
/// @param captured  if not null: the cycles that were averaged, each as a series that leaves
/// nothing of it out (kAllHarmonics)
/// @throws InputError naming the clip where no whole cycle is found.
WalkCycle prepareWalkCycle(const Clip& level, const JointRoles& roles,
                           const std::array<FootShape, 2>& feet,
                           const std::vector<Eigen::Quaterniond>& reference,
                           const CycleOptions& options, std::pair<int, int>* used_frames = nullptr,
                           std::vector<FourierSeries>* captured = nullptr);

/// Of the 64 samples of a cycle.
inline constexpr int kAllHarmonics = 31;

/// Whether there is a whole cycle in the clip, steady or not.
bool hasCycle(const Clip& level, const JointRoles& roles, const std::array<FootShape, 2>& feet,
              const CycleOptions& options);

/// QUALITY.md's measures of a levelled capture.
CaptureQuality measureCapture(const Clip& level, const JointRoles& roles);

/// The mean pose of a standing clip's frames [first, last].
Posture preparePosture(const Clip& level, const JointRoles& roles,
                       const std::array<FootShape, 2>& feet, int first, int last);

}  // namespace amble
