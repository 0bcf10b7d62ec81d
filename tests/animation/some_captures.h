/// A capture of each kind that the MANIFEST knows, level, with the paths of its feet: for theorems
/// that must hold of any motion.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"

namespace amble {

struct SomeCapture {
  std::string path, kind;
  Clip clip;
  JointRoles roles;
  FootPaths paths;
  std::array<double, 2> legs;  // [m]
  FootPlants plants;
};

/// The first of each kind in each folder, at most 1,500 frames long; empty where the shared folder
/// is not there.
inline const std::vector<SomeCapture>& someCaptures() {
  static const std::vector<SomeCapture> kSome = [] {
    std::vector<SomeCapture> some;
    std::set<std::string> seen;
    for (const Capture& capture : captures()) {
      const std::string folder = capture.path.substr(0, capture.path.find('/'));
      if (capture.frames > 1500 || !seen.insert(capture.kind + folder).second) continue;
      const CapturedMotion motion = readLevelCapture(capture.file).motion;
      SomeCapture one{capture.path, capture.kind, motion.clip, motion.roles, {}, {}, {}};
      one.paths = footPaths(one.clip, one.roles);
      one.legs = legLengths(one.clip, one.roles);
      one.plants = detectPlants(one.paths, one.legs, one.clip.frame_time);
      some.push_back(std::move(one));
    }
    return some;
  }();
  return kSome;
}

}  // namespace amble
