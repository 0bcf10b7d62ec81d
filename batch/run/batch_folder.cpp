#include "batch/run/batch_folder.h"

#include <system_error>
#include <vector>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnfinished = ".part";  // behind the name of a folder that is being filled

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string(), 0,
                     "cannot be made: " + (error ? error.message() : "it is a file"),
                     "a folder that can be written");
  }
}

std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code unknown;
  for (const auto& entry : fs::directory_iterator(folder, unknown))
    if (entry.is_directory(unknown)) found.push_back(entry.path());
  return found;
}

}  // namespace

bool BatchFolder::has(const std::string& key) const {
  std::error_code unknown;
  return fs::is_regular_file(folderOf(key) / "row.json", unknown);
}

void BatchFolder::make(const std::string& key,
                       const std::function<void(const fs::path&)>& write) const {
  const fs::path folder = folderOf(key);
  fs::path beside = folder;
  beside += kUnfinished;
  std::error_code error;
  fs::remove_all(beside, error);
  makeFolder(beside);
  write(beside);
  fs::rename(beside, folder, error);
  if (!error) return;
  std::error_code unknown;
  fs::remove_all(beside, unknown);
  if (!has(key))
    throw InputError(folder.string(), 0, "cannot be made: " + error.message(),
                     "a name that is free");
}

int BatchFolder::sweep(const std::function<bool(const std::string&)>& keep) const {
  int gone = 0;
  std::error_code error;
  for (const fs::path& shelf : foldersIn(walks())) {
    for (const fs::path& walk : foldersIn(shelf)) {
      const bool finished = walk.extension() != kUnfinished;
      if (finished && keep(walk.filename().string())) continue;
      gone += finished ? 1 : 0;
      fs::remove_all(walk, error);
    }
    fs::remove(shelf, error);  // where it is empty
  }
  return gone;
}

}  // namespace amble
