/// What the files of motion libraries and of speed engines have in common, written: numbers,
/// joints, sources, postures, the skeleton beside.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "base/yaml_writer.h"

namespace amble {

/// Numbers with seven digits after the point, and no zeros at their end.
void put(YamlWriter& out, const char* key, double value);
/// @param unit  that values are divided by, such as kDegree
void putList(YamlWriter& out, std::span<const double> values, double unit = 1.0);
void putList(YamlWriter& out, const char* key, std::span<const double> values, double unit = 1.0);
/// A list of its rows.
void putMatrix(YamlWriter& out, const char* name, const Eigen::MatrixXd& matrix);

/// Quaternions [w, x, y, z].
void putRotations(YamlWriter& out, const char* name,
                  const std::vector<Eigen::Quaterniond>& rotations);

/// `posture:`, `source:`, `capture:`, `joints:`. Joints are called what the BVH beside the file
/// calls them.
void putPosture(YamlWriter& out, const Posture& posture);
void putSource(YamlWriter& out, const MotionSource& source);
void putCapture(YamlWriter& out, const CaptureQuality& capture);
void putRoles(YamlWriter& out, const Skeleton& skeleton, const JointRoles& roles);

/// Writes a file and, beside it, the BVH of its skeleton; folders that are not there are made. A
/// BVH that holds the skeleton already stays as it is: it may be the capture that the file names.
/// @throws InputError where the BVH holds anything else but the skeleton of some library
void writeWithSkeleton(const Skeleton& skeleton, const std::string& skeleton_file,
                       const std::filesystem::path& file,
                       const std::function<void(std::ostream&)>& write);

/// Whether the file is the skeleton of some library, byte by byte as it is written here, and so may
/// be written anew.
bool isLibrarySkeleton(const std::filesystem::path& file);

/// A name beside a file that nothing has but, where the file is there already, the skeleton of some
/// library, which is taken for its own unless another library or engine of the folder names it:
/// captures often are called what is made of them.
std::string skeletonNameBeside(const std::filesystem::path& file);

/// Where a library whose skeleton has become this one keeps it: where it was, if the file is not
/// there or holds it; otherwise under a name of the library's own, for a capture or another library
/// may be read from there. @param name  of its file so far
std::string skeletonNameFor(const Skeleton& skeleton, const std::string& name,
                            const std::filesystem::path& library);

}  // namespace amble
