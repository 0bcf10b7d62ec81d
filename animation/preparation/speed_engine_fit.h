/// Captures of one person become a walking engine (Glardon 2004, §3 and §4): its cycles found and
/// sampled; of those of a gait its space (gait_space_fit.h); each clip judged by what an engine
/// without it makes of its speed.
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
/// @param warnings  of what is not as it should be: what is unsure of a capture, captures of
/// somebody else, speeds too near for lines
/// @throws InputError naming the capture: no steady cycle, neither walk nor run nor standing
EngineData fitSpeedEngine(const EngineRequest& request,
                          std::vector<std::string>* warnings = nullptr);

}  // namespace amble
