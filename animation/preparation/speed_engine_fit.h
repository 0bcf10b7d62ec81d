/// Captures of one person become a walking engine (Glardon 2004, §3 and §4): its cycles found and
/// sampled, principal components, lines over speed, the person's own frequency law.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/library/speed_engine.h"

namespace amble {

/// A capture that the engine is made from.
struct EngineCapture {
  std::filesystem::path file;
  MotionReadOptions read;
  std::string clip, licence, credit;  ///< as MotionSource has them
};

struct EngineRequest {
  std::vector<EngineCapture> captures;
  double variance = 0.8;  ///< that the components keep at least (Glardon §4.1) [0 to 1]
};

/// The engine. A capture's steady cycles go to the space of their gait; one that stands gives the
/// standing posture, without such a one it is that of the library `default`, carried over. The
/// first capture's skeleton is the engine's; those of others are carried over to it.
/// @param warnings  of what is not as it should be: captures of somebody else, speeds too near for
/// lines @throws InputError naming the capture: no steady cycle, neither walk nor run nor standing
EngineData fitSpeedEngine(const EngineRequest& request,
                          std::vector<std::string>* warnings = nullptr);

/// A cycle on the engine's skeleton.
struct EngineCycle {
  int clip = 0;         ///< index of the capture that it is from [>= 0]
  double speed = 0.0;   ///< [m/s, > 0]
  double period = 0.0;  ///< [s, > 0]
  /// Rows: channels of WalkCycle::series, rotations against the mean posture; columns: phases.
  Eigen::MatrixXd channels;
  std::array<double, 2> support = {0, 0};
  double step_width = 0.0;                      ///< as WalkCycle has these [m]
  std::array<double, 2> foot_forward = {0, 0};  ///< [m]
  std::array<double, 2> toe_out = {0, 0};       ///< [rad]
  std::array<FootCycle, 2> feet;                ///< of a walk; without pitch: not known
};

/// The space of these cycles (all but GaitSpace::clips), of a person whose legs are so long [m].
/// @pre one cycle or more
GaitSpace fitGaitSpace(const std::vector<EngineCycle>& cycles, double leg, double variance);

/// The motion vector of a space at a speed (eq. 1 and 2), beyond its captures as well. Rows:
/// rotation channels; columns: phases.
Eigen::MatrixXd motionVectorAt(const GaitSpace& space, double speed);

}  // namespace amble
