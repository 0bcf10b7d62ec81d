/// An ASF's skeleton with what its AMC needs: how each bone's numbers turn and move it.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "animation/body/skeleton.h"
#include "animation/captures/asf_amc.h"

namespace amble {

/// A degree of freedom of a bone: a column of its line in the AMC.
enum class AsfDof { kRx, kRy, kRz, kTx, kTy, kTz, kLength };

inline bool isRotation(AsfDof dof) { return dof <= AsfDof::kRz; }

/// How a joint moves; of the root its `order`, position and orientation.
struct AsfBone {
  std::vector<AsfDof> dofs;                                    ///< in the order of the AMC
  Eigen::Quaterniond q_axis = Eigen::Quaterniond::Identity();  ///< C; the root's orientation
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();         ///< unit, or 0 [1]
  double length = 0.0;                                         ///< [file units, >= 0]
  Eigen::Vector3d preset_position = Eigen::Vector3d::Zero();   ///< the root's [file units]
};

struct AsfSkeleton {
  std::vector<Joint> joints;   ///< depth first, "root" first; offsets in file units
  std::vector<AsfBone> bones;  ///< by joint
  bool degrees = true;         ///< angles of the ASF; of the AMC where it does not say
};

/// @throws InputError with file and line.
AsfSkeleton parseAsf(const NamedText& asf, AsfAmcNotes& notes);

/// Comments, commas and parentheses as blanks, which they are in both files; line for line.
std::string withoutAcclaimComments(std::string_view text);

}  // namespace amble
