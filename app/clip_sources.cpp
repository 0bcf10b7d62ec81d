#include "app/clip_sources.h"

#include <algorithm>
#include <set>

#include "animation/captures/motion_reader.h"
#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

const std::string kStem = "{stem}";

std::vector<fs::path> clipsBelow(const fs::path& folder) {
  std::vector<fs::path> found;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && isMotionFile(entry.path())) found.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), 0, "cannot be read: " + error.code().message(),
                     "a folder of clips");
  }
  if (found.empty()) throw InputError(folder.string(), 0, "holds no clips", "a folder of clips");
  std::sort(found.begin(), found.end());
  return found;
}

std::string stemOf(const fs::path& clip) { return clip == "-" ? "stdin" : clip.stem().string(); }

bool isFolder(const std::string& pattern) {
  std::error_code ignored;
  return pattern.ends_with('/') || fs::is_directory(pattern, ignored);
}

fs::path filled(std::string pattern, const std::string& stem) {
  for (size_t at = pattern.find(kStem); at != std::string::npos;
       at = pattern.find(kStem, at + stem.size())) {
    pattern.replace(at, kStem.size(), stem);
  }
  return pattern;
}

}  // namespace

std::vector<fs::path> findClips(const std::vector<std::string>& paths) {
  std::vector<fs::path> clips;
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    throw InputError("-", 0, "is given twice", "one clip on standard input");
  }
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      clips.emplace_back(path);
      continue;
    }
    const std::vector<fs::path> below = clipsBelow(path);
    clips.insert(clips.end(), below.begin(), below.end());
  }
  return clips;
}

std::vector<fs::path> outputNames(const std::string& option, const std::string& pattern,
                                  const std::string& extension,
                                  const std::vector<fs::path>& clips) {
  const bool folder = isFolder(pattern), has_stem = pattern.find(kStem) != std::string::npos;
  if (clips.size() > 1 && !folder && !has_stem) {
    throw InputError(option + " " + pattern, 0, "is one file for several clips",
                     "a folder, or a name with {stem} in it");
  }
  std::vector<fs::path> names;
  std::set<fs::path> taken;
  for (const fs::path& clip : clips) {
    const std::string stem = stemOf(clip);
    names.push_back(has_stem ? filled(pattern, stem)
                    : folder ? fs::path(pattern) / (stem + "." + extension)
                             : fs::path(pattern));
    if (names.back() != "-" && !taken.insert(names.back().lexically_normal()).second) {
      throw InputError(option + " " + pattern, 0,
                       "gives two clips the name " + names.back().string(),
                       "clips whose names differ");
    }
  }
  for (const fs::path& name : names) {
    std::error_code failed;
    if (name.has_parent_path()) fs::create_directories(name.parent_path(), failed);
    if (failed) throw InputError(name.string(), 0, failed.message(), "a folder that can be made");
  }
  return names;
}

}  // namespace amble
