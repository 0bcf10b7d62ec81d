#include "app/library_addition.h"

#include "animation/captures/capture_file.h"
#include "animation/library/library_parts_writer.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/speed_engine_reader.h"
#include "base/error.h"
#include "base/text.h"

namespace amble {

namespace {

// Whether it is a speed engine; its speeds are then said.
bool isEngine(const std::filesystem::path& file, const std::vector<double>& speeds) {
  const bool engine = isYaml(file) && isSpeedEngine(file);
  if (engine && speeds.empty()) {
    throw InputError(file.string(), 0, "is a speed engine, which walks at any speed",
                     "--speed 0.6,0.8,1 or others: a walk of the library each");
  }
  if (!engine && !speeds.empty()) {
    throw InputError(file.string(), 0, "is no speed engine, whose walks --speed tells",
                     "an engine (amble library engine build)");
  }
  return engine;
}

// The motion, and its mirror image.
void addRequests(MotionRequest request, const LibraryAddition& how,
                 std::vector<MotionRequest>& out) {
  out.push_back(request);
  // A manner is its walker's own, lame on the left and not on the right.
  if (!isForBothSides(request.kind) || !how.mirror.value_or(how.style.empty())) return;
  request.name += "-mirrored";
  request.source.mirrored = true;
  out.push_back(std::move(request));
}

}  // namespace

bool isYaml(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".yaml" || ending == ".yml";
}

std::vector<MotionRequest> requestsOf(const std::filesystem::path& clip,
                                      const LibraryAddition& how) {
  const bool engine = isEngine(clip, how.speeds);
  // What is not said of an engine's captures is in its file.
  const std::string unsaid = engine ? "" : "unknown";
  MotionRequest request;
  request.name = how.name.empty() ? clip.stem().string() : how.name;
  request.kind = how.kind;
  request.turning = how.turning;
  request.style = how.style;
  request.chains = how.chains;
  request.file = clip;
  request.read = how.read;
  request.source.clip = clip.filename().string();
  const auto said = [&](const std::string& text) {
    return text.empty() || text == "unknown" ? unsaid : text;
  };
  request.source.licence = said(how.licence);
  request.source.credit = said(how.credit);
  request.frames = how.frames;
  std::vector<MotionRequest> requests;
  if (!engine) addRequests(request, how, requests);
  for (const double speed : how.speeds) {
    MotionRequest at = request;
    at.name += "-" + shortNumber(speed);
    at.source.speed = speed;
    addRequests(std::move(at), how, requests);
  }
  return requests;
}

void requireLibraryName(const std::filesystem::path& file) {
  if (!isYaml(file)) throw InputError(file.string(), 0, "is no name of a library", "NAME.yaml");
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
