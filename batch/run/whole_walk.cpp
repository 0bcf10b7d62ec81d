#include "batch/run/whole_walk.h"

#include <algorithm>

#include "base/error.h"
#include "batch/run/merge_batch.h"

namespace amble {

std::vector<std::string> filesOfWalk(const BatchJob& job, const WalkRow& row) {
  const auto wants = [&](const char* format) {
    return std::find(job.formats.begin(), job.formats.end(), format) != job.formats.end();
  };
  const bool planned = row.status != "error" && row.status != "no_way";
  const bool solved = row.status == "solved";
  std::vector<std::string> files = {"row.json"};
  if (planned && wants("json")) files.emplace_back("report.json");
  if (solved && wants("bvh")) files.emplace_back("walk.bvh");
  if (solved && wants("labels")) files.insert(files.end(), {"labels.json", "labels.npz"});
  return files;
}

bool isWhole(const BatchJob& job, const BatchFolder& batch, const std::string& key) {
  if (!batch.has(key)) return false;
  WalkRow row;
  try {
    row = readRowOf(batch, key);
  } catch (const InputError&) {
    return true;
  }
  const std::vector<std::string> files = filesOfWalk(job, row);
  return std::all_of(files.begin(), files.end(), [&](const std::string& file) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(batch.folderOf(key) / file, unknown);
  });
}

}  // namespace amble
