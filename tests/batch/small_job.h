/// A folder with two small scenes and jobs of them, for tests.
#pragma once

#include <map>
#include <set>

#include "batch/job/batch_job.h"
#include "batch/run/merge_batch.h"
#include "tests/scenarios/small_room.h"

namespace amble {

class SmallJob : public SmallRoom {
 protected:
  static constexpr const char* kWays =
      "[{name: there, start: {at: [0.8, 1.5]}, goal: {at: [2, 1]}}, "
      "{name: across, start: {at: [0.8, 1.5]}, goal: {at: [5.2, 1.5]}}]";

  void SetUp() override {
    SmallRoom::SetUp();
    // The pillar of the other room stands elsewhere.
    std::string other = kScene;
    other.replace(other.rfind("at: [3, 1.5"), 11, "at: [3, 0.6");
    write("other.yaml", other);
  }
  BatchJob job(const std::string& text) const {
    return readBatchJob(write("job.yaml", text), {"bvh", "json"});
  }
  /// Two rooms, two ways in each.
  BatchJob twoRooms(const std::string& more = "fps: 30\n") const {
    return job(std::string("scenes:\n  - {scene: scene.yaml, ways: ") + kWays +
               "}\n  - {scene: other.yaml, ways: " + kWays + "}\n" + more);
  }
  /// Every file below a folder, by its path in it.
  std::map<std::string, std::string> filesIn(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / name))
      if (entry.is_regular_file())
        files[entry.path().lexically_relative(folder_ / name).string()] = read(entry.path());
    return files;
  }
  BatchSummary make(const BatchJob& job, const std::string& name,
                    const BatchOptions& options = {}) const {
    return runBatch(job, folder_ / name, options);
  }
  std::vector<WalkRow> rows(const BatchJob& job, const std::string& name) const {
    std::vector<WalkRow> found;
    for (const std::string& key : keysOfItems(job, listItems(job), {}))
      found.push_back(readRowOf(BatchFolder(folder_ / name), key));
    return found;
  }
};

}  // namespace amble
