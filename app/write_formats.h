/// A run written in the formats that are asked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/result_formats.h"
#include "scenarios/run_scenario.h"

namespace amble {

struct ResultWishes {
  std::vector<std::string> formats = usualFormats();  ///< of formatNames()
  std::vector<std::string> views =
      {};                     ///< of viewNames(); none: all, where the format is asked for
  int threads = 1;            ///< [1 to 64]; changes no byte
  std::string command = {};   ///< that repeats the run
  bool scene_in_glb = true;   ///< and beside the actor for Gazebo
  bool film_follows = false;  ///< the eye of walk.mp4 goes along
};

/// Whether it is asked for, or written with what is.
bool isWanted(const ResultWishes& wishes, const std::string& format);

/// Into a folder, as `amble plan` does: one set of files, of one run (write_results.h).
/// @throws InputError naming the folder or the file that cannot be written.
void writeFormats(RunResult& result, const std::filesystem::path& folder,
                  const ResultWishes& wishes);

/// The one file of that kind, under a name of the caller's: walk.bvh for ".bvh", report.json for
/// ".json". @throws InputError where the name's end is none of them, the walk that it is of is not
/// there, or it cannot be written
void writeFormat(const RunResult& result, const std::filesystem::path& file,
                 const ResultWishes& wishes);

}  // namespace amble
