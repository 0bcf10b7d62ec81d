/// Cluster graphs as files.
///
/// A line that says what it is, and of which format; then, as base/byte_pack.h lays them on a
/// little-endian machine, how the clips were read, the clips with the SHA-256 of their files, the
/// features (float), the states and the trees; at the end the SHA-256 of all before it. What was
/// cut off or altered is seen by that; what was made up is seen by its values: every number is
/// checked, and memory is taken for what is there, never for what is announced. No motion is in it:
/// that is read from the clips when one is played.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/graph/cluster_graph.h"

namespace amble {

/// A file that a graph was made of.
struct GraphInput {
  std::string path;  ///< relative to the graph's folder, where there is such a way
  std::string sha256;
};

struct KeptGraph {
  ClusterGraph graph;
  /// By clip: the clip itself, and what is read with it (an AMC's skeleton, a file of roles).
  std::vector<std::vector<GraphInput>> inputs;
  /// How they were read; asf and roles relative to the graph's folder, as inputs are.
  MotionReadOptions reading;
};

/// Larger files are not read [bytes]. A million frames are less.
inline constexpr size_t kMaxGraphFile = size_t{512} << 20;

std::string packGraph(const KeptGraph& kept);
/// @param name  of the file, in messages. @throws InputError
KeptGraph unpackGraph(std::string_view bytes, const std::string& name);

/// @throws InputError
void writeGraph(const KeptGraph& kept, const std::filesystem::path& file);
KeptGraph readGraph(const std::filesystem::path& file);

/// Whether a regular file begins as a graph's does, of whatever format; pipes are not opened.
bool looksLikeGraph(const std::filesystem::path& file);

/// An input of a graph that lies at `graph_file`, and such an input of a file.
std::filesystem::path inputFile(const std::filesystem::path& graph_file, const GraphInput& input);
GraphInput graphInput(const std::filesystem::path& graph_file, const std::filesystem::path& file);
/// The inputs that have changed or are not there any more, in words: "walk.bvh, run.bvh (missing)";
/// "" where none has.
std::string whatChanged(const KeptGraph& kept, const std::filesystem::path& graph_file);

}  // namespace amble
