#include "scenarios/write_results.h"

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "base/stopwatch.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

// Makes a folder with all above it, and takes away again what it made unless told to keep it.
class MadeFolder {
 public:
  explicit MadeFolder(const fs::path& folder) {
    std::error_code unknown, error;
    for (fs::path way = fs::absolute(folder).lexically_normal();
         !way.empty() && !fs::exists(way, unknown); way = way.parent_path()) {
      made_.push_back(way);  // the deepest first
    }
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, unknown)) {
      removeMade();
      throw InputError(folder.string(), 0,
                       "cannot be made: " + (error ? error.message() : "it is a file"),
                       "a folder that can be written");
    }
  }
  ~MadeFolder() {
    if (!keep_) removeMade();
  }
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  void keep() { keep_ = true; }

 private:
  void removeMade() {
    std::error_code not_empty;
    for (const fs::path& folder : made_) fs::remove(folder, not_empty);
  }
  std::vector<fs::path> made_;
  bool keep_ = false;
};

// Of the names those that this run does not write.
std::vector<fs::path> obsolete(const std::vector<fs::path>& names, const fs::path& folder,
                               const std::vector<ResultFile>& files) {
  std::vector<fs::path> old;
  for (const fs::path& name : names) {
    const bool is_new = std::any_of(files.begin(), files.end(), [&](const ResultFile& file) {
      return file.file == folder / name;
    });
    if (!is_new) old.push_back(folder / name);
  }
  return old;
}

}  // namespace

void writeResults(RunResult& result, const fs::path& folder, const WriteOptions& options) {
  const Stopwatch watch;
  const bool walk = result.report.status == PlanStatus::kSolved;
  MadeFolder made(folder);
  std::vector<ResultFile> files;
  if (options.bvh && walk) {
    files.push_back({folder / "walk.bvh", [&](std::ostream& out) { out << result.bvh; }});
  }
  for (const ResultFile& more : options.more) files.push_back({folder / more.file, more.write});
  if (options.json) {
    files.push_back({folder / "report.json", [&](std::ostream& out) {
                       result.report.times.export_ = options.spent + watch.seconds();
                       writeJson(out, result.report);
                     }});
  }
  writeFiles(files, obsolete(options.names, folder, files));
  made.keep();
}

}  // namespace amble
