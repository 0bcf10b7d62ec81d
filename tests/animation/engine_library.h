/// Motion libraries of an engine's walks, as `amble library add --speed` makes them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "animation/library/speed_engine_writer.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/preparation/speed_engine_fit.h"
#include "tests/animation/captures.h"

namespace amble {

/// An engine in a file of the test's own.
class EngineInFile {
 public:
  explicit EngineInFile(EngineData data) : engine_(std::move(data)) {
    static int made = 0;
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("amble_" + std::string(test->name()) + std::to_string(++made));
    std::filesystem::remove_all(folder_);
    EngineData written = engine_.data();
    written.skeleton_file = "engine.bvh";
    writeSpeedEngine(written, file());
  }
  ~EngineInFile() { std::filesystem::remove_all(folder_); }
  EngineInFile(const EngineInFile&) = delete;
  EngineInFile& operator=(const EngineInFile&) = delete;

  const SpeedEngine& engine() const { return engine_; }
  std::filesystem::path file() const { return folder_ / "engine.yaml"; }
  MotionRequest request(double speed) const {
    MotionRequest request;
    request.name = "walk-" + std::to_string(speed);
    request.file = file();
    request.source.clip = "engine.yaml";
    request.source.speed = speed;
    return request;
  }
  /// One walk at each speed, no mirror images.
  MotionLibrary library(const std::vector<double>& speeds) const {
    MotionLibrary library;
    for (const double speed : speeds) addMotion(library, request(speed));
    return library;
  }

 private:
  SpeedEngine engine_;
  std::filesystem::path folder_;
};

/// Of captures below the shared folder's mocap/.
inline EngineRequest engineRequestOf(const std::vector<std::string>& clips) {
  EngineRequest request;
  for (const std::string& clip : clips) {
    request.captures.push_back({sharedFolder() / "mocap" / clip, {}, clip, "free", "somebody"});
  }
  return request;
}

inline const std::vector<std::string> kWalksOf07 = {
    "cmu_mb2/07_01.bvh", "cmu_mb2/07_02.bvh", "cmu_mb2/07_03.bvh", "cmu_mb2/07_05.bvh",
    "cmu_mb2/07_06.bvh", "cmu_mb2/07_08.bvh", "cmu_mb2/07_10.bvh", "cmu_mb2/07_12.bvh"};
/// Without the strides that MANIFEST calls long and exaggerated: they are no matter of speed.
inline const std::vector<std::string> kWalksOf08 = {"cmu_mb2/08_01.bvh", "cmu_mb2/08_03.bvh",
                                                    "cmu_mb2/08_04.bvh", "cmu_mb2/08_06.bvh",
                                                    "cmu_mb2/08_09.bvh"};

}  // namespace amble
