/// The motion library (Pettré §4.1): prepared motions of one skeleton, with where they come from.
///
/// Written by `amble library build RECIPE` from captures, and read as YAML (DESIGN.md, section 5).
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/foot_shape.h"
#include "animation/joint_roles.h"
#include "animation/skeleton.h"
#include "animation/walk_cycle.h"

namespace amble {

enum class MotionKind { kWalk, kPosture };

/// Slower than this is straight, faster is a turn: walkers sway by as much [rad/s].
inline constexpr double kStraightTurnRate = 0.15;

struct MotionSource {
  std::string clip;                    ///< path below the captures' folder
  std::array<int, 2> frames = {0, 0};  ///< of the clip: first and last
  bool mirrored = false;
  std::string licence;
  std::string credit;
};

/// A walk has a cycle, a posture a pose; checked when read and when built.
struct Motion {
  std::string name;
  MotionKind kind = MotionKind::kWalk;
  bool turning = false;  ///< of a walk
  WalkCycle cycle;       ///< of a walk
  Posture posture;       ///< of a posture
  MotionSource source;
};

struct MotionLibrary {
  std::filesystem::path file;
  std::string skeleton_file;  ///< BVH beside the library; its hierarchy only is read
  Skeleton skeleton;          ///< [m]
  JointRoles roles;
  double stature = 0.0;  ///< of the captured subject, from leg length [m]
  std::vector<Motion> motions;

  const Motion* find(const std::string& motion) const;  ///< by name; null where there is none
  /// The posture `stand`, whose rotations are the reference of every cycle's rotation vectors.
  const Posture& stand() const { return find("stand")->posture; }
  std::array<FootShape, 2> feet() const;  ///< by Side
};

/// @throws InputError with file and line: unknown keys, sizes that do not fit the skeleton, a walk
/// that is called straight and turns, no posture `stand`, no straight walk.
MotionLibrary readMotionLibrary(const std::filesystem::path& file);
/// The library called `default`, or the one at a path (relative to `relative_to`). @throws
/// InputError
MotionLibrary openMotionLibrary(const std::string& name,
                                const std::filesystem::path& relative_to = {});
/// Writes the library and, beside it, the BVH of its skeleton. @throws InputError
void writeMotionLibrary(const MotionLibrary& library, const std::filesystem::path& file);

/// Reads a recipe and its captures, and prepares every motion. `captures` is the folder that clip
/// paths are relative to; where it is empty, the recipe's own `captures:`. @throws InputError
MotionLibrary buildMotionLibrary(const std::filesystem::path& recipe,
                                 const std::filesystem::path& captures = {});

}  // namespace amble
