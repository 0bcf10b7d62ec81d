#include "batch/run/batch_status.h"

#include <algorithm>
#include <chrono>
#include <system_error>

#include "batch/run/batch_folder.h"
#include "batch/run/merge_batch.h"
#include "batch/run/whole_walk.h"

namespace amble {

BatchStatus batchStatus(const BatchJob& job, const std::filesystem::path& folder,
                        const LoadLimits& limits) {
  namespace fs = std::filesystem;
  const BatchFolder batch(folder);
  const std::vector<BatchItem> items = listItems(job);
  std::vector<fs::file_time_type> times;
  BatchStatus status;
  status.total = static_cast<int>(items.size());
  for (const std::string& key : keysOfItems(job, items, limits)) {
    if (!isWhole(job, batch, key)) continue;
    ++status.there;
    std::error_code gone;
    const auto time = fs::last_write_time(batch.folderOf(key) / "row.json", gone);
    if (!gone) times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  if (times.size() < 2) return status;
  const size_t count = std::min(times.size(), static_cast<size_t>(kRateOf));
  const std::chrono::duration<double> took = times.back() - times[times.size() - count];
  if (took.count() > 0.0) status.rate = static_cast<double>(count - 1) / took.count();
  return status;
}

}  // namespace amble
