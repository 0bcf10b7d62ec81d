/// What `amble plan` can write of a run, each under a name that --formats takes: the one table of
/// it.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.h"
#include "scenarios/run_scenario.h"
#include "viz/figure/figure.h"
#include "viz/walk_view.h"

namespace amble {

/// What several files hold, made once, when the first of them needs it, on whatever thread.
struct SharedParts {
  std::string png, svg;          ///< files, as bytes
  std::optional<Figure> figure;  ///< of the walk's body
  std::once_flag png_made, svg_made, figure_made;
};

/// Of the points of view that pictures are taken from: "top", "side", "corner", "first".
std::vector<std::string> viewNames();

/// A run that is to be written. Borrowed: all outlives the writing.
struct ResultSubject {
  const RunResult& result;
  const WalkView& view;                          ///< of the result
  int threads = 1;                               ///< that may be used; changes no byte
  std::string command = {};                      ///< that repeats the run
  std::vector<std::string> views = viewNames();  ///< that "views" writes
  bool scene_in_glb = true;                      ///< and beside the actor for Gazebo
  bool film_follows = false;                     ///< the eye of walk.mp4 goes along
  std::shared_ptr<SharedParts> shared = std::make_shared<SharedParts>();
};

struct ResultFormat {
  const char* name;                ///< "svg"
  std::vector<const char*> files;  ///< all that it may write, relative to the folder of results
  const char* what;                ///< for help
  bool usual = true;               ///< written unless formats are named
  bool of_walk = true;             ///< there is none without a walk
  const char* program = nullptr;   ///< another program that makes it
  const char* with = nullptr;      ///< a format that its files name, so that it is written too
  /// Adds to `files` what is written of the subject, paths relative to the folder. Null for
  /// walk.bvh and report.json, which writeResults writes itself.
  void (*add)(const ResultSubject& subject, std::vector<ResultFile>& files) = nullptr;
};

const std::vector<ResultFormat>& resultFormats();

/// Their names, in the table's order; or of the usual ones.
std::vector<std::string> formatNames();
std::vector<std::string> usualFormats();

/// That the programs are there which make these formats. @throws InputError naming the one that is
/// not
void checkPrograms(const std::vector<std::string>& formats);

/// "What to write: bvh (the walk), ..."
std::string formatsHelp();

/// Every file that any of them writes.
std::vector<std::filesystem::path> resultFileNames();

}  // namespace amble
