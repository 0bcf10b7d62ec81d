#include "batch/run/merge_batch.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "batch/run/batch_walker.h"
#include "batch/run/pack_batch.h"
#include "batch/run/whole_walk.h"
#include "environments/scene/kept_meshes.h"

namespace amble {
namespace {

constexpr FileKind kRowKind = {"a row of a batch", size_t{1} << 20};

void writeCredits(std::ostream& out, const std::set<std::string>& credits) {
  out << "# Whose motions these walks are made of\n\n";
  for (const std::string& credit : credits) out << "- " << credit << '\n';
}

}  // namespace

std::vector<std::string> keysOfItems(const BatchJob& job, const std::vector<BatchItem>& items,
                                     const LoadLimits& limits) {
  std::vector<std::string> libraries;
  BatchItem any;
  for (; any.library < static_cast<int>(job.libraries.size()); ++any.library)
    libraries.push_back(readBatchLibrary(job, any)->digest);
  std::vector<std::string> keys;
  KeptMeshes meshes;
  LoadLimits sharing = limits;
  sharing.meshes = &meshes;
  int scene = -1;
  std::string digest;
  for (const BatchItem& item : items) {  // those of one scene are together
    if (item.scene != scene) digest = readBatchScene(job, item.scene, sharing)->digest;
    scene = item.scene;
    keys.push_back(
        itemKey(describeItem(job, item, digest, libraries[static_cast<size_t>(item.library)])));
  }
  return keys;
}

WalkRow readRowOf(const BatchFolder& batch, const std::string& key) {
  const auto file = batch.folderOf(key) / "row.json";
  try {
    return readRow(readWholeFile(file, kRowKind), file.string());
  } catch (const InputError& error) {
    throw InputError(error.file(), error.line(), error.problem(),
                     error.expected() + "; delete its folder, and a run makes the walk again");
  }
}

namespace {

// A row at a time is in memory.
void writeTables(const BatchFolder& batch, const std::vector<std::string>& keys,
                 std::map<std::string, int>& by_status) {
  std::set<std::string> credits;
  const auto csv = [&](std::ostream& out) {
    out << "item," << rowCsvHead() << "\r\n";
    for (size_t i = 0; i < keys.size(); ++i)
      out << i << ',' << rowCsv(readRowOf(batch, keys[i])) << "\r\n";
  };
  const auto lines = [&](std::ostream& out) {
    for (const std::string& key : keys) {
      const WalkRow row = readRowOf(batch, key);
      ++by_status[row.status];
      credits.insert(row.credits.begin(), row.credits.end());
      out << rowJson(row) << '\n';
    }
  };
  const auto whose = [&](std::ostream& out) { writeCredits(out, credits); };
  writeFiles({{batch.root() / "index.csv", csv},
              {batch.root() / "index.jsonl", lines},
              {batch.root() / "CREDITS.md", whose}});
}

}  // namespace

MergeSummary mergeBatch(const BatchJob& job, const std::filesystem::path& folder,
                        const BatchOptions& options, std::vector<std::string> keys) {
  const BatchFolder batch(folder);
  if (keys.empty()) keys = keysOfItems(job, listItems(job), {options.memory, {options.stop, {}}});
  MergeSummary summary;
  summary.total = static_cast<int>(keys.size());
  for (const std::string& key : keys) summary.missing += isWhole(job, batch, key) ? 0 : 1;
  if (summary.missing > 0) return summary;
  writeTables(batch, keys, summary.by_status);
  if (options.pack) packBatch(batch, keys);
  const std::set<std::string> wanted(keys.begin(), keys.end());
  summary.swept = batch.sweep([&](const std::string& key) { return wanted.count(key) > 0; });
  return summary;
}

}  // namespace amble
