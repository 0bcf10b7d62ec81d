// What a page shows of a plan beside the body: its places and its roadmap.
#include <nlohmann/json.hpp>

#include "viz/page/page_data.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;

constexpr double kReach = 0.5;  // to the ground from where it is expected [m]

Json placeJson(const PlaceView& place) {
  Json json = {{"at", {place.position.x(), place.position.y(), place.height}}};
  json["heading"] = place.heading ? Json(*place.heading) : Json(nullptr);
  return json;
}

Json placeJson(const std::optional<PlaceView>& place) {
  return place ? placeJson(*place) : Json(nullptr);
}

// An edge's line on the ground, which is looked for near the straight line between its ends.
std::vector<float> groundLine(const WalkView& view, const RoadmapView::Edge& edge) {
  const RoadmapView::Node &from = view.roadmap.nodes[edge.from], &to = view.roadmap.nodes[edge.to];
  std::vector<Vector2d> line = edge.line;
  if (line.empty()) line = {from.position, to.position};
  std::vector<float> points;
  double height = from.height;
  for (size_t i = 0; i < line.size(); ++i) {
    const double share = line.size() < 2 ? 0.0 : static_cast<double>(i) / (line.size() - 1.0);
    const double straight = from.height + share * (to.height - from.height);
    const auto ground = view.ground != nullptr
                            ? view.ground->height(line[i].x(), line[i].y(), height, kReach)
                            : std::nullopt;
    height = ground.value_or(straight);
    for (const double value : {line[i].x(), line[i].y(), height})
      points.push_back(static_cast<float>(value));
  }
  return points;
}

Json roadmapJson(const PageSubject& subject, PageBytes& bytes) {
  const RoadmapView& roadmap = subject.walk->roadmap;
  Json nodes = Json::array(), edges = Json::array();
  for (const RoadmapView::Node& node : roadmap.nodes) {
    nodes.push_back({{"at", {node.position.x(), node.position.y(), node.height}},
                     {"heading", node.heading},
                     {"connector", node.connector}});
  }
  for (const RoadmapView::Edge& edge : roadmap.edges) {
    const std::vector<float> line = groundLine(*subject.walk, edge);
    edges.push_back({{"from", edge.from},
                     {"to", edge.to},
                     {"line", Json::parse(bytes.add(std::span<const float>(line)))},
                     {"take", nullptr}});
  }
  for (const PageEdgeTake& played : subject.edge_takes) edges[played.edge]["take"] = played.take;
  return {{"nodes", std::move(nodes)}, {"edges", std::move(edges)}};
}

Json attemptsJson(const std::vector<PageAttempt>& attempts, PageBytes& bytes) {
  Json all = Json::array();
  for (const PageAttempt& attempt : attempts) {
    const std::vector<float> line = flat(attempt.line);
    all.push_back({{"line", Json::parse(bytes.add(std::span<const float>(line)))},
                   {"at", {attempt.at.x(), attempt.at.y(), attempt.at.z()}},
                   {"what", attempt.what},
                   {"take", attempt.take < 0 ? Json(nullptr) : Json(attempt.take)}});
  }
  return all;
}

Json groundJson(const PageGround& ground, PageBytes& bytes) {
  if (ground.strips.empty()) return nullptr;
  std::vector<Eigen::Vector3d> ends;
  for (const ReachedRegion::Strip& strip : ground.strips) {
    ends.push_back(strip.from);
    ends.push_back(strip.to);
  }
  const std::vector<float> points = flat(ends);
  return {{"breadth", ground.breadth},
          {"strips", Json::parse(bytes.add(std::span<const float>(points)))},
          {"kind", Json::parse(bytes.add(std::span<const std::uint8_t>(ground.kind)))}};
}

}  // namespace

std::string walkJson(const PageSubject& subject, PageBytes& bytes) {
  const WalkView& walk = *subject.walk;
  Json via = Json::array();
  for (const PlaceView& place : walk.via) via.push_back(placeJson(place));
  Json obstruction = nullptr;
  if (subject.obstruction) {
    const Eigen::Vector3d& at = *subject.obstruction;
    obstruction = {at.x(), at.y(), at.z()};
  }
  const Json json = {{"start", placeJson(walk.start)},
                     {"goal", placeJson(walk.goal)},
                     {"via", std::move(via)},
                     {"roadmap", roadmapJson(subject, bytes)},
                     {"attempts", attemptsJson(subject.attempts, bytes)},
                     {"reached", groundJson(subject.reached, bytes)},
                     {"room_to_walk", groundJson(subject.room_to_walk, bytes)},
                     {"obstruction", std::move(obstruction)}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace amble
