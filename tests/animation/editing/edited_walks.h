/// Captures of tests/animation/captures.h as walks that are to be edited.
#pragma once

#include "animation/editing/edit_walk.h"
#include "tests/animation/captures.h"

namespace amble {

inline CapturedWalk capturedWalk(const std::string& path) {
  CapturedMotion motion = readMotion(sharedFolder() / path);
  return captureWalk(motion, path);
}

/// What the project's own analyser reads off a clip, finding its plants anew.
inline GaitMeasures analysed(const Clip& clip, const JointRoles& roles) {
  return measureGait(clip, roles, detectPlants(clip, roles));
}

inline EditRequest withStride(double from, double to) {
  EditRequest request;
  request.stride = EditAmount{{from, to}, true};
  return request;
}

}  // namespace amble
