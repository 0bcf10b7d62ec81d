/// What the fuzz targets of the readers share: a clip that was read has to be one, and a refusal
/// has to say where.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "animation/body/clip.h"
#include "base/error.h"

namespace amble {

/// Ends the run where a promise of the readers is broken.
inline void promise(bool kept) {
  if (!kept) std::abort();
}

/// Everything finite, turns of length 1, as many poses as were promised.
inline void checkClip(const Clip& clip) {
  promise(clip.poses.joints() == clip.skeleton.size() && clip.frame_time > 0.0);
  const size_t joints = clip.skeleton.size();
  promise(clip.joint_positions.empty() || clip.joint_positions.size() == joints * clip.frames());
  for (int i = 0; i < clip.frames(); ++i) {
    promise(clip.poses.p_WR(i).allFinite());
    for (const Eigen::Quaterniond& q : clip.poses.rotations(i)) {
      promise(q.coeffs().allFinite() && std::abs(q.norm() - 1.0) < 1e-6);
    }
  }
}

/// Reads, and takes an InputError about `file` of one line for an answer; `read` returns a clip.
template <typename Read>
void readOrRefuse(std::string_view file, Read read) {
  try {
    checkClip(read());
  } catch (const InputError& error) {
    promise(error.file() == file && !error.problem().empty());
    promise(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

inline std::string_view textOf(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace amble
