/// A folder of a test's own with a scene that is walked in a moment: a room of 6 x 3 m with a
/// pillar.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/error.h"

namespace amble {

class SmallRoom : public testing::Test {
 protected:
  //   y 3 +--------------------------------+
  //       |                                |
  //   1.5 |  start ->     [] pillar   goal |      0.4 m wide, in the middle
  //       |                                |
  //     0 +--------------------------------+  x 6
  static constexpr const char* kScene =
      "name: small-room\n"
      "objects:\n"
      "  - {name: floor, box: {size: [6, 3, 0.1]}, at: [3, 1.5, -0.05]}\n"
      "  - {name: wall-south, box: {size: [6, 0.1, 2.5]}, at: [3, -0.05, 1.25]}\n"
      "  - {name: wall-north, box: {size: [6, 0.1, 2.5]}, at: [3, 3.05, 1.25]}\n"
      "  - {name: wall-west, box: {size: [0.1, 3.2, 2.5]}, at: [-0.05, 1.5, 1.25]}\n"
      "  - {name: wall-east, box: {size: [0.1, 3.2, 2.5]}, at: [6.05, 1.5, 1.25]}\n"
      "  - {name: pillar, box: {size: [0.4, 0.4, 2.5]}, at: [3, 1.5, 1.25]}\n";
  static constexpr const char* kScenario =
      "scene: scene.yaml\n"
      "start: {at: [0.8, 1.5], heading: 0}\n"
      "goal: {at: [5.2, 1.5], heading: 90}\n";

  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("amble_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("scene.yaml", kScene);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  static std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path folder_;
};

/// What the InputError says that `act` throws, or "no error".
template <typename Act>
std::string inputError(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace amble
