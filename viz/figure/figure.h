/// The figure: a skin for a body, made by the program from the body's measures.
///
/// A person in plain clothes: closed, without holes or pieces apart, triangles counter-clockwise
/// from outside. It lies within the body's capsules but for nose and thumbs, so that what the
/// capsules clear it clears as well.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "animation/body/skeleton.h"
#include "environments/body/body.h"

namespace amble {

struct Figure {
  /// In `bind`, World axes: z up, facing +x [m].
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;              ///< unit, outwards
  std::vector<std::array<std::uint8_t, 3>> colors;   ///< sRGB
  std::vector<std::array<std::uint16_t, 4>> joints;  ///< that a vertex hangs on
  std::vector<std::array<float, 4>> weights;         ///< of these; they sum to 1, [0, 1]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// X_WJ of every joint in the pose that the vertices are in: upright with arms and legs apart,
  /// whatever the rest pose is (of many rigs nobody stands in it), the root at the origin. A vertex
  /// is at the sum of weight * X_WJ * bind[joint]^-1 * vertex over its joints, in any pose.
  std::vector<JointFrame> bind;
};

/// 2,000 to 5,000 triangles for a body as makeBody() makes it; of parts with other names each is a
/// capsule. The same body gives the same bytes. Cost: 0.15 s.
Figure makeFigure(const Skeleton& skeleton, const Body& body);

}  // namespace amble
