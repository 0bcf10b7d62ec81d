/// One entry for every capture format: a clip in World and metres, whose joint is whose in it, and
/// what of that was guessed.
///
/// Formats by the name's end: .bvh; .amc with its .asf; .fbx, .gltf, .glb, .vrma and .dae, which
/// say their unit and axes. Every guess is said with its reason and can be set in the options.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/captures/reading.h"
#include "base/file_axes.h"
#include "base/guard_limits.h"

namespace amble {

struct MotionReadOptions {
  /// None: said by the file, or guessed from the legs [m, > 0].
  std::optional<double> metres_per_unit = {};
  /// None: said by the file, or guessed from how the person stands.
  std::optional<UpAxis> up = {};
  /// Heading that the pelvis shall have in the first frame: the clip is turned about World z. None:
  /// as it is [rad].
  std::optional<double> facing = {};
  /// Of a BVH or an AMC instead of its own; none: the file's, of an AMC that does not say it
  /// kAmcFrameTime. FBX, glTF and Collada are sampled at it; none: the file's, and at least 30 a
  /// second [s, kMinFrameTime to kMaxFrameTime].
  std::optional<double> frame_time = {};
  std::string take = {};             ///< animation of an FBX, glTF or Collada file; "": what moves
  std::filesystem::path asf = {};    ///< skeleton of an AMC; empty: as findAsf() has it
  std::filesystem::path roles = {};  ///< YAML map of role to joint name that overrides the guess
  bool person = true;                ///< a skeleton in which no person is found is refused
  /// That reading an FBX, glTF or Collada file may fill [bytes, > 0].
  size_t memory = GuardLimits{}.memory;
};

struct CapturedMotion {
  Clip clip;  ///< World, z up, metres
  JointRoles roles;
  std::string no_person;  ///< which role nothing tells: `roles` are incomplete; "" for a person
  Reading<double> metres_per_unit;
  Reading<UpAxis> up;
  Reading<double> frame_time;         ///< [s]
  Reading<double> facing;             ///< heading of the pelvis in the first frame [rad]
  std::vector<std::string> warnings;  ///< of what is unsure or likely not meant
};

/// @param file  `-` is a BVH on standard input. @throws InputError with file and line: as the
/// reader of its format has it, no format that Amble knows, no person's skeleton.
CapturedMotion readMotion(const std::filesystem::path& file, const MotionReadOptions& options = {});
/// The same; nothing where the file holds meshes without an animation.
std::optional<CapturedMotion> readMotionIfAny(const std::filesystem::path& file,
                                              const MotionReadOptions& options = {});

/// Whether the name ends as one of a format that readMotion() reads.
bool isMotionFile(const std::filesystem::path& file);

}  // namespace amble
