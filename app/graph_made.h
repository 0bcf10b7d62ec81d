/// A cluster graph made of clips, with what is to be kept beside it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "animation/graph/graph_file.h"
#include "app/read_options.h"

namespace amble {

struct GraphMaking {
  ReadOptions read;
  double fps = 0.0;  ///< [1/s]; 0: kGraphRate or that of the slowest clip
  int threads = 1;   ///< changes no result
  StopRequest stop;  ///< ends it, with Stopped
  std::function<void(const std::string&)> stage;  ///< told what is done now
};

/// @param out  where it is to be written: its clips are called by their way from there
/// @throws InputError as the reader does, and for a clip that is given twice or is `out`
KeptGraph makeKeptGraph(const std::vector<std::filesystem::path>& files,
                        const std::filesystem::path& out, const GraphMaking& making,
                        std::vector<std::string>& warnings);

}  // namespace amble
