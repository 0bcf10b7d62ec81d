/// Captures that grafts are tried on.
#pragma once

#include <map>
#include <string>

#include "animation/captures/motion_reader.h"
#include "animation/grafting/locomotive_clip.h"
#include "tests/animation/captures.h"

namespace amble {

/// Of mocap/, read once.
inline const LocomotiveClip& graftSource(const std::string& path) {
  static std::map<std::string, LocomotiveClip> read;
  const auto there = read.find(path);
  if (there != read.end()) return there->second;
  CapturedMotion motion = readMotion(sharedFolder() / "mocap" / path);
  return read[path] = locomotiveClip(std::move(motion.clip), motion.roles, path);
}

inline const char* const kStand = "cmu_mb2/02_05.bvh";  // punches
inline const char* const kWalk = "cmu_mb2/02_01.bvh";
inline const char* const kRun = "cmu_mb2/02_03.bvh";
inline const char* const kJump = "cmu_mb2/01_01.bvh";
inline const char* const kLongWalk = "accad_female1/Female1_B03_Walk1.bvh";
inline const char* const kCarry = "accad_female1/Female1_B20_WalkWithBox.bvh";

}  // namespace amble
