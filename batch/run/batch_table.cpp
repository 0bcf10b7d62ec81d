#include "batch/run/batch_table.h"

#include <system_error>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "batch/run/batch_folder.h"

namespace amble {
namespace {

constexpr FileKind kTableKind = {"a batch's table", size_t{4} << 30};
constexpr FileKind kLabelsKind = {"labels of a walk", size_t{1} << 30};

}  // namespace

std::vector<WalkRow> readBatchTable(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "index.jsonl";
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) {
    throw InputError(folder.string(), 0, "has no index.jsonl",
                     "a batch that is merged: amble batch merge JOB.yaml -o " + folder.string());
  }
  const std::string text = readWholeFile(file, kTableKind);
  std::vector<WalkRow> rows;
  int line = 0;
  for (std::string_view left = text; !left.empty();) {
    ++line;
    const auto parts = splitAt(left, "\n");
    const std::string_view row = parts ? parts->first : left;
    left = parts ? parts->second : std::string_view();
    if (!row.empty()) rows.push_back(readRow(std::string(row), file.string(), line));
  }
  return rows;
}

BatchStatistics batchStatistics(const std::filesystem::path& folder) {
  const std::vector<WalkRow> rows = readBatchTable(folder);
  BatchStatistics all = statisticsOf(rows);
  const BatchFolder batch(folder);
  for (const WalkRow& row : rows) {
    const std::filesystem::path labels = batch.folderOf(row.key) / "labels.json";
    std::error_code unknown;
    if (row.status == "solved" && std::filesystem::exists(labels, unknown))
      addLabels(readWholeFile(labels, kLabelsKind), labels.string(), all);
  }
  return all;
}

}  // namespace amble
