#include "batch/run/batch_folder.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnfinished = ".part-";  // behind the name of a folder that is being filled

// As no other who may fill a folder for the same walk has it: on this machine or another, since a
// shard may be at work twice where a machine was given up too early.
std::string unfinishedMark() {
  static std::atomic<unsigned> count{0};
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  return kUnfinished + std::string(host.data()) + "-" + std::to_string(::getpid()) + "-" +
         std::to_string(count++);
}

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

void BatchFolder::remove(const std::string& key) const {
  std::error_code unknown;
  fs::remove_all(folderOf(key), unknown);
}

void BatchFolder::make(const std::string& key,
                       const std::function<void(const fs::path&)>& write) const {
  const fs::path folder = folderOf(key);
  fs::path beside = folder;
  beside += unfinishedMark();
  std::error_code error;
  fs::remove_all(beside, error);
  makeFolder(beside);
  try {
    write(beside);
  } catch (const InputError&) {
    if (!has(key)) throw;  // else another has made it, and swept this away
    return;
  }
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
      const bool finished = walk.filename().string().find(kUnfinished) == std::string::npos;
      if (finished && keep(walk.filename().string())) continue;
      gone += finished ? 1 : 0;
      fs::remove_all(walk, error);
    }
    fs::remove(shelf, error);  // where it is empty
  }
  return gone;
}

}  // namespace amble
