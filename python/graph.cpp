// Cluster graphs of captures.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>

#include "app/graph_made.h"
#include "app/graph_ways.h"
#include "app/played_graph.h"
#include "python/clips.h"
#include "python/module.h"
#include "python/stoppable.h"
#include "python/text.h"

namespace amble {
namespace {

namespace py = pybind11;

struct PythonGraph {
  std::string file;
  KeptGraph kept;
  std::vector<std::string> warnings = {};  ///< of its building
};
using GraphPtr = std::shared_ptr<PythonGraph>;

GraphPtr openGraph(const std::filesystem::path& file) {
  const py::gil_scoped_release released;
  return std::make_shared<PythonGraph>(PythonGraph{file.string(), readFreshGraph(file.string())});
}

GraphPtr buildGraph(const std::vector<std::filesystem::path>& clips,
                    const std::filesystem::path& out, double fps, int threads) {
  const auto made = std::make_shared<PythonGraph>();
  made->file = out.string();
  runStoppable(threads, [&](const std::atomic<bool>& stop) {
    GraphMaking making;
    making.fps = fps;
    making.threads = threads;
    making.stop.flag = &stop;
    made->kept = makeKeptGraph(clips, out, making, made->warnings);
    writeGraph(made->kept, out);
  });
  return made;
}

py::str query(const PythonGraph& graph, const std::string& from, const std::string& to,
              double error, double stay) {
  std::string text;
  {
    const py::gil_scoped_release released;
    const GraphWays ways = waysBetween(graph.kept, from, to, {error, stay});
    text = ways.data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  return toText(text);
}

std::shared_ptr<PythonClip> play(const PythonGraph& graph, const std::string& ranges, double blend,
                                 double fps, bool foot_lock) {
  const py::gil_scoped_release released;
  PlayedGraph made = playGraph(graph.kept, graph.file, rangesNamed(graph.kept, ranges, "RANGES"),
                               {blend, fps, foot_lock});
  const auto clip = std::make_shared<PythonClip>();
  clip->motion.clip = std::move(made.motion.clip);
  clip->motion.roles = made.roles;
  clip->file = graph.file;
  return clip;
}

std::string rangesText(const KeptGraph& kept, const std::vector<NamedRange>& ranges) {
  std::string text;
  for (const NamedRange& range : ranges) {
    text += (text.empty() ? "" : ",") + kept.graph.clips[range.clip].name + ":" +
            std::to_string(range.first) + "-" + std::to_string(range.last);
  }
  return text;
}

/// The loops of a clip, the wished one first: frames of its file, seconds, metres.
py::list loops(const PythonGraph& graph, const std::string& clip, double error, double shortest,
               const std::optional<int>& left_near, int count) {
  std::vector<FrameLoop> found;
  {
    const py::gil_scoped_release released;
    found = loopsIn(graph.kept, clipNamed(graph.kept, clip, "CLIP"), {error, shortest, left_near});
  }
  py::list out;
  const ClusterGraph& of = graph.kept.graph;
  for (const FrameLoop& loop : found) {
    py::dict one;
    one["leave"] = toText(frameName(of, loop.leave));
    one["enter"] = toText(frameName(of, loop.enter));
    one["duration"] = (loop.leave - loop.enter) * of.frame_time;
    one["error"] = std::sqrt(static_cast<double>(loop.error));
    one["play"] = toText(rangesText(graph.kept, rangesOfLoop(graph.kept, loop, count)));
    out.append(one);
  }
  return out;
}

py::dict clipsOf(const PythonGraph& graph) {
  py::dict out;
  for (const GraphClip& clip : graph.kept.graph.clips)
    out[toText(clip.name)] = py::make_tuple(clip.inFile(clip.first), clip.inFile(clip.last()));
  return out;
}

}  // namespace

void bindGraph(py::module_& module) {
  py::class_<PythonGraph, GraphPtr>(module, "Graph")
      .def_property_readonly("file", [](const PythonGraph& graph) { return toText(graph.file); })
      .def_property_readonly("clips", &clipsOf)
      .def_property_readonly("warnings",
                             [](const PythonGraph& graph) { return toTexts(graph.warnings); })
      .def("query", &query)
      .def("loops", &loops)
      .def("play", &play);
  module.def("open_graph", &openGraph);
  module.def("build_graph", &buildGraph);
  module.attr("graph_error") = kGraphError;
  module.attr("graph_blend") = kGraphBlend;
}

}  // namespace amble
