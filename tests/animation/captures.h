/// The captures of the shared folder and what its MANIFEST says of them (measured by another
/// program than ours).
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

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
    const std::filesystem::path folder = sharedFolder() / "mocap";
    if (!std::filesystem::exists(folder / "MANIFEST.yaml")) return found;
    for (const YAML::Node& clip : YAML::LoadFile((folder / "MANIFEST.yaml").string())["clips"]) {
      const std::string path = clip["path"].as<std::string>();
      if (!path.ends_with(".bvh") || clip["kind"].as<std::string>("") == "malformed") continue;
      found.push_back(
          {folder / path, path, clip["kind"].as<std::string>(""), clip["frames"].as<int>(),
           clip["joints"].as<int>(), clip["channels"].as<int>(), clip["frame_time"].as<double>(),
           clip["metres_per_unit_guess"].as<double>(), clip["leading_frames_to_skip"].as<int>(0)});
    }
    return found;
  }();
  return kCaptures;
}

}  // namespace amble

/// Ends a test that needs the captures where they are not there.
#define AMBLE_NEEDS_CAPTURES() \
  if (amble::captures().empty()) GTEST_SKIP() << "no captures in " << amble::sharedFolder()
