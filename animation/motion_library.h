/// The motion library (Pettré §4.1): prepared motions of one skeleton, with where they come from.
///
/// Written by `amble library build RECIPE` from captures and read as YAML (DESIGN.md, section 5).
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "animation/joint_roles.h"
#include "animation/skeleton.h"
#include "animation/walk_cycle.h"

namespace amble {

enum class MotionKind { kWalk, kPosture };

struct MotionSource {
  std::string clip;               ///< path below the captures' folder
  int first_frame = 0;            ///< of the clip, and the last, both included
  int last_frame = 0;
  bool mirrored = false;
  std::string licence;
  std::string credit;
};

/// Checked when read or built: `walk` has a cycle, `posture` a pose.
struct Motion {
  std::string name;
  MotionKind kind = MotionKind::kWalk;
  WalkCycle cycle;                ///< of a walk
  Posture posture;                ///< of a posture
  MotionSource source;
};

struct MotionLibrary {
  std::filesystem::path file;
  std::string name;
  Skeleton skeleton;              ///< as captured [m]
  JointRoles roles;
  double stature = 0.0;           ///< of the captured subject [m]
  double ankle_height = 0.0;      ///< of the ankle over a flat sole [m]
  double toe_height = 0.0;        ///< of the toe joint over a flat sole [m]
  std::vector<Motion> motions;

  const Motion* find(const std::string& motion) const;  ///< by name; null where there is none
};

/// @throws InputError with file and line.
MotionLibrary readMotionLibrary(const std::filesystem::path& file);
/// The library `default`, or the one at a path (relative to `relative_to`). @throws InputError
MotionLibrary openMotionLibrary(const std::string& name, const std::filesystem::path& relative_to = {});
void writeMotionLibrary(std::ostream& out, const MotionLibrary& library);

/// What `amble library build` does: reads the recipe and its captures, prepares every motion. `captures` is the folder that
/// clip paths are relative to. @throws InputError
MotionLibrary buildMotionLibrary(const std::filesystem::path& recipe, const std::filesystem::path& captures);

}  // namespace amble
