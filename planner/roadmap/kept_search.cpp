#include "planner/roadmap/kept_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace amble {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

KeptSearch::KeptSearch(const Steering& steering, KeptRoadmap roadmap)
    : steering_(steering),
      roadmap_(std::move(roadmap)),
      out_(roadmap_.nodes.size()),
      made_(std::make_unique<Made[]>(roadmap_.edges.size())) {
  for (const KeptRoadmap::Node& node : roadmap_.nodes) places_.push_back({node.stance});
  for (size_t i = 0; i < roadmap_.edges.size(); ++i)
    out_[roadmap_.edges[i].from].push_back(static_cast<int>(i));
}

const SteerResult& KeptSearch::made(int edge, SteeringScratch& scratch) const {
  Made& known = made_[edge];
  std::call_once(known.once, [&] {
    const KeptRoadmap::Edge& kept = roadmap_.edges[edge];
    known.result = steering_.steer(places_[kept.from], places_[kept.to], scratch);
  });
  return known.result;
}

// One query. Links are the kept edges by number, and after them those that it adds.
class KeptSearch::Query {
 public:
  Query(const KeptSearch& kept, const Waypoint& from, const Waypoint& to);

  std::optional<std::vector<WalkEdge>> solve(const SearchLimits& limits, SteeringScratch& scratch,
                                             SteeringCount& count) {
    while (!limits.stopped()) {
      const std::vector<int> way = cheapest();
      if (way.empty()) return std::nullopt;
      if (!looksFree(way, scratch)) continue;
      if (auto edges = steer(way, scratch, count)) return edges;
    }
    return std::nullopt;
  }

 private:
  struct Added {
    KeptRoadmap::Edge edge;
    bool looked_at = false;
    std::optional<WalkEdge> walk = {};  // once it was steered
  };

  const Waypoint& waypoint(int place) const {
    if (place == start_) return from_;
    return place == goal_ ? to_ : kept_.places_[place];
  }
  bool isKept(int link) const { return link < static_cast<int>(struck_.size()); }
  Added& added(int link) { return added_[link - struck_.size()]; }
  const KeptRoadmap::Edge& edge(int link) const {
    return isKept(link) ? kept_.roadmap_.edges[link] : added_[link - struck_.size()].edge;
  }
  double cost(int link) const { return isKept(link) && struck_[link] ? kNever : edge(link).cost; }

  void add(int from, int to);
  template <typename Visit>
  void eachLinkFrom(int place, Visit visit) const;
  std::vector<int> cheapest() const;
  bool looksFree(const std::vector<int>& way, SteeringScratch& scratch);
  const WalkEdge* steer(int link, SteeringScratch& scratch, SteeringCount& count);
  std::optional<std::vector<WalkEdge>> steer(const std::vector<int>& way, SteeringScratch& scratch,
                                             SteeringCount& count);

  const KeptSearch& kept_;
  const Waypoint &from_, &to_;
  const int start_, goal_;    // as places, which are numbered behind the nodes
  std::vector<bool> struck_;  // kept edges that steering refused
  std::vector<Added> added_;  // start to goal, start to each node, each node to goal
};

KeptSearch::Query::Query(const KeptSearch& kept, const Waypoint& from, const Waypoint& to)
    : kept_(kept),
      from_(from),
      to_(to),
      start_(static_cast<int>(kept.places_.size())),
      goal_(start_ + 1),
      struck_(kept.roadmap_.edges.size(), false) {
  add(start_, goal_);
  for (int node = 0; node < start_; ++node) add(start_, node);
  for (int node = 0; node < start_; ++node) add(node, goal_);
}

void KeptSearch::Query::add(int from, int to) {
  const Eigen::Vector3d way = waypoint(to).stance.position - waypoint(from).stance.position;
  added_.push_back({{from, to, way.norm() / kept_.steering_.topSpeed()}});
}

template <typename Visit>
void KeptSearch::Query::eachLinkFrom(int place, Visit visit) const {
  const int first = static_cast<int>(struck_.size());
  if (place == start_) {
    for (int link = first; link <= first + start_; ++link) visit(link);
    return;
  }
  for (const int link : kept_.out_[place]) visit(link);
  visit(first + 1 + start_ + place);
}

// The cheapest way from start to goal, as links; empty where there is none.
std::vector<int> KeptSearch::Query::cheapest() const {
  std::vector<double> time(goal_ + 1, kNever);
  std::vector<int> by(goal_ + 1, -1);  // the link that a place was reached by
  std::set<std::pair<double, int>> open = {{0.0, start_}};
  time[start_] = 0.0;
  while (!open.empty() && open.begin()->second != goal_) {
    const int at = open.begin()->second;
    open.erase(open.begin());
    eachLinkFrom(at, [&](int link) {
      const int to = edge(link).to;
      const double arrival = time[at] + cost(link);
      if (!(arrival < time[to])) return;
      open.erase({time[to], to});
      time[to] = arrival;
      by[to] = link;
      open.insert({arrival, to});
    });
  }
  std::vector<int> way;
  if (by[goal_] < 0) return way;
  for (int at = goal_; at != start_; at = edge(by[at]).from) way.push_back(by[at]);
  std::reverse(way.begin(), way.end());
  return way;
}

// Whether no link of the way has become dearer because it does not look free.
bool KeptSearch::Query::looksFree(const std::vector<int>& way, SteeringScratch& scratch) {
  bool all = true;
  for (const int at : way) {
    if (isKept(at)) continue;
    Added& link = added(at);
    if (std::exchange(link.looked_at, true)) continue;
    if (kept_.steering_.looksFree(waypoint(link.edge.from), waypoint(link.edge.to), scratch))
      continue;
    link.edge.cost *= kDoubt;
    all = false;
  }
  return all;
}

// The walk along a link; null where it is refused, which strikes it out.
const WalkEdge* KeptSearch::Query::steer(int link, SteeringScratch& scratch, SteeringCount& count) {
  if (isKept(link)) {
    const SteerResult& result = kept_.made(link, scratch);
    count.add(result);
    struck_[link] = !result.edge;
    return result.edge ? &*result.edge : nullptr;
  }
  Added& own = added(link);
  if (own.walk) return &*own.walk;
  SteerResult result =
      kept_.steering_.steer(waypoint(own.edge.from), waypoint(own.edge.to), scratch);
  count.add(result);
  own.edge.cost = result.edge ? result.edge->cost() : kNever;
  own.walk = std::move(result.edge);
  return own.walk ? &*own.walk : nullptr;
}

// The edges of the way, or none where one is refused: those of the query first, which are refused
// more often.
std::optional<std::vector<WalkEdge>> KeptSearch::Query::steer(const std::vector<int>& way,
                                                              SteeringScratch& scratch,
                                                              SteeringCount& count) {
  for (const int link : way)
    if (!isKept(link) && !steer(link, scratch, count)) return std::nullopt;
  std::vector<WalkEdge> edges;
  for (const int link : way) {
    const WalkEdge* walk = steer(link, scratch, count);
    if (!walk) return std::nullopt;
    edges.push_back(*walk);
  }
  return edges;
}

std::optional<std::vector<WalkEdge>> KeptSearch::walk(const Waypoint& from, const Waypoint& to,
                                                      const SearchLimits& limits,
                                                      SteeringScratch& scratch,
                                                      SteeringCount& count) const {
  return Query(*this, from, to).solve(limits, scratch, count);
}

}  // namespace amble
