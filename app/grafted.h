/// One clip grafted on another, looked over and put right: what `amble graft` makes of two
/// captures, whether they were named or found in a folder.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/grafting/graft_clip.h"
#include "environments/body/body.h"
#include "environments/collision/clear_arms.h"

namespace amble {

struct GraftSource {
  std::filesystem::path file;
  CapturedMotion motion;  ///< without its clip, which is in `clip`
  LocomotiveClip clip;
  Body body;
};

/// @param file  that it is from. @throws InputError for a clip without frames
GraftSource graftSource(CapturedMotion motion, const std::filesystem::path& file);
/// The same of a file. @throws InputError as readMotion does too
GraftSource readGraftSource(const std::filesystem::path& file, const MotionReadOptions& options);

/// Frames in which a part of an arm is deeper in another part than in both sources.
struct ArmInBody {
  std::string part, other;
  int first = 0, last = 0, frames = 0;  ///< of the base: from, to, and how many of them
  double depth = 0.0;                   ///< the largest [m]
  double sources = 0.0;                 ///< the largest in either source [m]
};

struct Grafted {
  GraftPlan plan;
  Graft graft;  ///< its clip is as it is to be written
  ArmClearing clearing;
  std::vector<ArmInBody> found;  ///< before arms were turned
  std::vector<ArmInBody> left;   ///< after it
  std::array<double, 2> arm_leg = {0, 0}, base_arm_leg = {0, 0}, upper_arm_leg = {0, 0};
  std::string refusal;  ///< why nothing is to be written, in one line; "" for nothing
};

/// @param clear  arms that are in the body are turned out of it, and what stays in it is refused
/// @throws InputError as planGraft does
Grafted graftOn(const GraftSource& base, const GraftSource& upper, const GraftWishes& wishes,
                bool clear);

}  // namespace amble
