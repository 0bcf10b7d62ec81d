#include "app/graph_ways.h"

#include <cmath>

#include "app/graph_words.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

Json wayJson(const ClusterGraph& graph, const GraphWay& way, int from, int to) {
  Json jumps = Json::array();
  for (const FrameJump& jump : way.jumps)
    jumps.push_back({{"leave", frameName(graph, jump.leave)},
                     {"enter", frameName(graph, jump.enter)},
                     {"error", std::sqrt(jump.error)}});
  return {{"jumps", jumps},
          {"error", std::sqrt(way.error)},
          {"wait", way.wait * graph.frame_time},
          {"play", rangesText(graph, rangesOf(graph, way, from, to))}};
}

}  // namespace

GraphWays waysBetween(const KeptGraph& kept, const std::string& from, const std::string& to,
                      const WayLimits& limits) {
  const ClusterGraph& graph = kept.graph;
  GraphWays ways;
  ways.from = frameNamed(kept, from, "--from");
  ways.to = frameNamed(kept, to, "--to");
  ways.difference = std::sqrt(graph.error(ways.from, ways.to));
  ways.data = {{"from", frameName(graph, ways.from)},
               {"to", frameName(graph, ways.to)},
               {"error", limits.error},
               {"difference", ways.difference},
               {"ways", Json::object()}};
  const auto add = [&](const char* name, const char* title, std::optional<GraphWay> way) {
    if (!way) return;
    ways.data["ways"][name] = wayJson(graph, *way, ways.from, ways.to);
    ways.all.push_back({name, title, std::move(*way)});
  };
  const GraphCut cut = cutAt(graph, limits.error);
  const WaySearch search{static_cast<int>(std::lround(limits.stay / graph.frame_time))};
  add("cluster", "both in a cluster", wayWithin(graph, cut, ways.from, ways.to));
  add("nearest", "nearest", nearestWay(graph, cut, ways.from, ways.to));
  add("best", "smoothest", bestWay(graph, cut, ways.from, ways.to));
  add("through", "through others", wayThrough(graph, cut, ways.from, ways.to, search));
  return ways;
}

}  // namespace amble
