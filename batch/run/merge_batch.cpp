#include "batch/run/merge_batch.h"

#include <algorithm>
#include <set>

#include "base/files.h"
#include "batch/labels/walk_row.h"
#include "batch/run/batch_folder.h"
#include "batch/run/batch_walker.h"

namespace amble {
namespace {

constexpr FileKind kRowKind = {"a row of a batch", size_t{1} << 20};

}  // namespace

std::vector<std::string> keysOfItems(const BatchJob& job, const std::vector<BatchItem>& items,
                                     const LoadLimits& limits) {
  std::vector<std::string> libraries;
  for (int i = 0; i < static_cast<int>(job.libraries.size()); ++i)
    libraries.push_back(readBatchLibrary(job, i)->digest);
  std::vector<std::string> keys;
  int scene = -1;
  std::string digest;
  for (const BatchItem& item : items) {  // those of one scene are together
    if (item.scene != scene) digest = readBatchScene(job, item.scene, limits)->digest;
    scene = item.scene;
    keys.push_back(
        itemKey(describeItem(job, item, digest, libraries[static_cast<size_t>(item.library)])));
  }
  return keys;
}

MergeSummary mergeBatch(const BatchJob& job, const std::filesystem::path& folder,
                        const BatchOptions& options) {
  const BatchFolder batch(folder);
  const std::vector<BatchItem> items = listItems(job);
  const std::vector<std::string> keys =
      keysOfItems(job, items, {options.memory, {options.stop, {}}});
  MergeSummary summary;
  summary.total = static_cast<int>(items.size());
  for (const std::string& key : keys) summary.missing += batch.has(key) ? 0 : 1;
  if (summary.missing > 0) return summary;
  const auto read = [&](const std::string& key) {
    const auto file = batch.folderOf(key) / "row.json";
    return readRow(readWholeFile(file, kRowKind), file.string());
  };
  const std::vector<ResultFile> files = {{folder / "index.csv",
                                          [&](std::ostream& out) {
                                            out << "item," << rowCsvHead() << "\r\n";
                                            for (size_t i = 0; i < keys.size(); ++i)
                                              out << i << ',' << rowCsv(read(keys[i])) << "\r\n";
                                          }},
                                         {folder / "index.jsonl", [&](std::ostream& out) {
                                            for (const std::string& key : keys) {
                                              const WalkRow row = read(key);
                                              ++summary.by_status[row.status];
                                              out << rowJson(row) << '\n';
                                            }
                                          }}};
  writeFiles(files);
  const std::set<std::string> wanted(keys.begin(), keys.end());
  summary.swept = batch.sweep([&](const std::string& key) { return wanted.count(key) > 0; });
  return summary;
}

}  // namespace amble
