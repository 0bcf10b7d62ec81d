/// Whose joint is whose in a capture: what its user says, then names, then the shape of the tree;
/// and what of it is unsure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

struct RoleGuess {
  JointRoles roles;
  std::vector<std::string> unsure;  ///< a role and why, for people: "left_toe: no joint fits"
  std::string
      missing;  ///< the first role without which nobody walks and which nothing tells, or ""
};

/// @param clip  in any unit and with any vertical axis; without frames only names help.
/// @param overrides  a YAML map of role to joint name (`hips: Pelvis`), or to `none` for a role
/// that the rig has not; it holds for the roles that it names. Empty: none.
/// @throws InputError with file and line: a role or joint that is not there, a skeleton of no
/// joints.
RoleGuess guessRoles(const Clip& clip, const std::string& file,
                     const std::filesystem::path& overrides = {});

}  // namespace amble
