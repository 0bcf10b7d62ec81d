#include "animation/captures/find_asf.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "animation/captures/capture_file.h"
#include "base/error.h"

namespace amble {
namespace {

/// Every .asf in a folder, by name.
std::vector<std::filesystem::path> asfFilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code unreadable;
  for (std::filesystem::directory_iterator it(folder, unreadable), end; it != end;
       it.increment(unreadable)) {
    if (lowerEnding(it->path()) == ".asf") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// `07` of `07_05-walk` and of `07-walk`.
std::string subjectOf(const std::string& stem) { return stem.substr(0, stem.find_first_of("_-")); }

/// Whether `stem` begins with `start` and goes on with another word, or not at all.
bool beginsWith(const std::string& stem, const std::string& start) {
  return stem.starts_with(start) &&
         (stem.size() == start.size() ||
          std::isalnum(static_cast<unsigned char>(stem[start.size()])) == 0);
}

}  // namespace

std::filesystem::path findAsf(const std::filesystem::path& amc) {
  const std::filesystem::path folder = amc.has_parent_path() ? amc.parent_path() : ".";
  const std::vector<std::filesystem::path> files = asfFilesIn(folder);
  const std::string stem = amc.stem().string();
  std::filesystem::path best;
  std::vector<std::filesystem::path> of_subject;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.stem().string();
    if (beginsWith(stem, name) && name.size() > best.stem().string().size()) best = file;
    if (subjectOf(name) == subjectOf(stem)) of_subject.push_back(file);
  }
  if (!best.empty()) return best;
  if (of_subject.size() == 1) return of_subject[0];
  if (files.size() == 1) return files[0];
  throw InputError(amc.string(), 0,
                   files.empty() ? "no .asf lies beside it" : "several .asf lie beside it",
                   "its skeleton, given by --asf");
}

}  // namespace amble
