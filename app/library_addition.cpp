#include "app/library_addition.h"

#include "animation/library/library_parts_writer.h"
#include "animation/library/motion_library_reader.h"
#include "base/error.h"

namespace amble {

std::vector<MotionRequest> requestsOf(const std::filesystem::path& clip,
                                      const LibraryAddition& how) {
  MotionRequest request;
  request.name = how.name.empty() ? clip.stem().string() : how.name;
  request.kind = how.kind;
  request.turning = how.turning;
  request.style = how.style;
  request.chains = how.chains;
  request.file = clip;
  request.read = how.read;
  request.source.clip = clip.filename().string();
  request.source.licence = how.licence.empty() ? "unknown" : how.licence;
  request.source.credit = how.credit.empty() ? "unknown" : how.credit;
  request.frames = how.frames;
  std::vector<MotionRequest> requests = {request};
  // A manner is its walker's own, lame on the left and not on the right.
  if (isForBothSides(request.kind) && how.mirror.value_or(how.style.empty())) {
    request.name += "-mirrored";
    request.source.mirrored = true;
    requests.push_back(request);
  }
  return requests;
}

void requireLibraryName(const std::filesystem::path& file) {
  if (file.extension() != ".yaml" && file.extension() != ".yml")
    throw InputError(file.string(), 0, "is no name of a library", "NAME.yaml");
}

MotionLibrary libraryAt(const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) return readMotionLibrary(file);
  requireLibraryName(file);
  std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  while (!std::filesystem::exists(folder)) folder = folder.parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(file.string(), 0, "lies in " + folder.string() + ", which is no folder",
                     "a folder, or one that can be made");
  }
  MotionLibrary library;
  library.file = file;
  library.skeleton_file = skeletonNameBeside(file);
  return library;
}

}  // namespace amble
