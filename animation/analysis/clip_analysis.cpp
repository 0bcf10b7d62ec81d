#include "animation/analysis/clip_analysis.h"

namespace amble {

ClipAnalysis analyseClip(const Clip& level, const JointRoles& roles) {
  ClipAnalysis result;
  result.frame_time = level.frame_time;
  if (level.frames() == 0) return result;
  const FootPaths paths = footPaths(level, roles);
  const std::array<double, 2> legs = legLengths(level, roles);
  result.plants = detectPlants(paths, legs, level.frame_time);
  result.curves = footCurves(paths, legs, level.frame_time, result.plants);
  result.events = findGaitEvents(result.curves, level.frame_time, result.plants, paths);
  result.kind = classifyClip(result.plants, level.frame_time);
  result.gait = measureGait(level, roles, result.plants);
  return result;
}

}  // namespace amble
