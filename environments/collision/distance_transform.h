/// Lower bounds of the distances between voxels, of all voxels to the nearest occupied one.
///
/// Of two voxels i, j apart by d whole steps along an axis, points are at least max(0, |d| - 1)
/// steps apart. The square of a distance is the sum of its squares along the axes, so its least is
/// found axis after axis (Felzenszwalb and Huttenlocher 2012, their distance transform), here over
/// a window of steps, outwards, until no voxel of a run can gain.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace amble {

/// Longest window [steps]: squares of three of them stay below the end of an int16_t.
inline constexpr int kLongestWindow = 50;

/// Puts of_square[s] for each voxel, with s the least of the squares of its distances to occupied
/// ones [steps^2], and the last of of_square where that is not less than its window's.
/// Cost: some nanoseconds a voxel, on all processors.
/// @param voxels  by x, which runs fastest, y and z; in: 0 is free, all else occupied
/// @param count  voxels along each axis [> 0]
/// @param window  in steps, from which on distances are not told apart [1 to kLongestWindow]
/// @pre of_square has window^2 + 1 values
void transformDistances(std::vector<uint8_t>& voxels, const Eigen::Vector3i& count, int window,
                        std::span<const uint8_t> of_square);

}  // namespace amble
