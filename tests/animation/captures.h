/// The captures of the shared folder and what its MANIFEST says of them (measured by another
/// program than ours).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/strict_yaml.h"
#include "test_paths.h"

namespace amble {

struct Capture {
  std::filesystem::path file;
  std::string path;  ///< within mocap/
  std::string kind;
  int frames = 0;
  int joints = 0;
  int channels = 0;
  double frame_time = 0.0;  ///< [s]
  double metres_per_unit = 1.0;
  int skip = 0;  ///< frames at the start that are no motion
};

inline std::filesystem::path sharedFolder() { return AMBLE_SHARED; }

/// Every BVH of mocap/ that is a capture; empty where the shared folder is not there.
inline const std::vector<Capture>& captures() {
  static const std::vector<Capture> kCaptures = [] {
    std::vector<Capture> found;
    constexpr int kMost = 1'000'000;
    const std::filesystem::path folder = sharedFolder() / "mocap";
    if (!std::filesystem::exists(folder / "MANIFEST.yaml")) return found;
    for (const YamlNode& clip : readYaml(folder / "MANIFEST.yaml").at("clips").items()) {
      const std::string path = clip.at("path").asString();
      const YamlNode kind = clip["kind"], skip = clip["leading_frames_to_skip"];
      if (!path.ends_with(".bvh") || (kind && kind.asString() == "malformed")) continue;
      found.push_back({folder / path, path, kind ? kind.asString() : "",
                       clip.at("frames").asInt(0, kMost), clip.at("joints").asInt(0, kMost),
                       clip.at("channels").asInt(0, kMost), clip.at("frame_time").asDouble(),
                       clip.at("metres_per_unit_guess").asDouble(),
                       skip ? skip.asInt(0, kMost) : 0});
    }
    return found;
  }();
  return kCaptures;
}

}  // namespace amble

/// Ends a test that needs the captures where they are not there.
#define AMBLE_NEEDS_CAPTURES() \
  if (amble::captures().empty()) GTEST_SKIP() << "no captures in " << amble::sharedFolder()
