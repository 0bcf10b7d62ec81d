/// The trials of the shared folder with foot contacts measured by force plates.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/captures/bvh.h"
#include "tests/animation/captures.h"

namespace amble {

struct ForceTrial {
  std::filesystem::path file;
  Clip clip;
  JointRoles roles;
  std::array<std::vector<int>, 2> planted;  ///< by Side, a value a frame: 1, 0, or -1 for unknown
};

/// Empty where the shared folder is not there.
inline const std::vector<ForceTrial>& forceTrials() {
  static const std::vector<ForceTrial> kTrials = [] {
    std::vector<ForceTrial> trials;
    const std::filesystem::path folder = sharedFolder() / "gait" / "trials";
    if (!std::filesystem::exists(folder)) return trials;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".bvh") continue;
      ForceTrial trial;
      trial.file = entry.path();
      trial.clip = readBvh(trial.file, {.metres_per_unit = 0.01});
      trial.roles = guessJointRoles(trial.clip.skeleton, trial.file.string());
      std::ifstream truth(std::filesystem::path(trial.file).replace_extension(".contact.csv"));
      std::string line;
      std::getline(truth, line);
      while (std::getline(truth, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        int frame = 0, left = 0, right = 0;
        double time = 0.0;
        row >> frame >> time >> left >> right;
        trial.planted[kLeft].push_back(left);
        trial.planted[kRight].push_back(right);
      }
      trials.push_back(std::move(trial));
    }
    std::sort(trials.begin(), trials.end(),
              [](const ForceTrial& a, const ForceTrial& b) { return a.file < b.file; });
    return trials;
  }();
  return kTrials;
}

}  // namespace amble

/// Ends a test that needs the trials where they are not there.
#define AMBLE_NEEDS_TRIALS() \
  if (amble::forceTrials().empty()) GTEST_SKIP() << "no trials in " << amble::sharedFolder()
