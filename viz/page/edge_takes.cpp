#include "viz/page/edge_takes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

constexpr double kWaySpacing = 0.04;  // between points of the root path [m]
constexpr int kEvery = 2;             // of an edge's frames so-and-so-many-th is kept

// Every other frame, and what is known of it.
PageTake thinnedTake(const AnimationBuffer& walk, double sole, std::deque<PoseArray>& poses) {
  PageTake take = takeOf(walk, sole);
  PoseArray& kept = poses.emplace_back(walk.poses.joints());
  std::vector<float> headings;
  for (int frame = 0; frame < walk.size(); frame += kEvery) {
    kept.append(walk.poses[frame]);
    headings.push_back(take.headings[frame]);
  }
  take.frame_time *= kEvery;
  take.poses = &kept;
  take.headings = std::move(headings);
  take.coarse = true;
  take.every = kEvery;
  const auto halve = [&](int& frame) { frame = std::min(frame / kEvery, kept.size() - 1); };
  for (std::vector<FrameSpan>& side : take.planted) {
    for (FrameSpan& span : side) {
      halve(span.first);
      halve(span.last);
    }
  }
  for (Footprint& print : take.footprints) {
    halve(print.first_frame);
    halve(print.last_frame);
  }
  return take;
}

class EdgeTakes {
 public:
  EdgeTakes(const Problem& problem, const RoadmapPicture& roadmap, double sole, WalkPage& page)
      : problem_(problem),
        roadmap_(roadmap),
        sole_(sole),
        page_(page),
        steering_(problem.synthesizer, problem.world, problem.ground,
                  {problem.scenario.walk.comfort, problem.request().within}) {}

  void addAttempts();
  void addEdges();

 private:
  // Whether of `count` things the `i`th is one of `most` that are spread evenly.
  static bool isChosen(size_t i, size_t count, size_t most) {
    return i == 0 || i * most / count != (i - 1) * most / count;
  }
  std::vector<RoadmapPicture::Refused> attemptsInOrder() const;
  void play(const RoadmapPicture::Refused& refused, PageAttempt& attempt);
  int add(const AnimationBuffer& walk, std::string name);

  const Problem& problem_;
  const RoadmapPicture& roadmap_;
  const double sole_;
  WalkPage& page_;
  const WalkSteering steering_;
  int frames_ = 0;
};

int EdgeTakes::add(const AnimationBuffer& walk, std::string name) {
  if (walk.size() < 2 || frames_ + walk.size() > kMostEdgeFrames) return -1;
  frames_ += walk.size();
  page_.subject.takes.push_back(thinnedTake(walk, sole_, page_.poses));
  page_.subject.takes.back().name = std::move(name);
  return static_cast<int>(page_.subject.takes.size()) - 1;
}

// That which was refused nearest to what stopped most of them comes first: it is looked at first.
std::vector<RoadmapPicture::Refused> EdgeTakes::attemptsInOrder() const {
  std::vector<RoadmapPicture::Refused> all = roadmap_.refused;
  const auto& stopped_at = page_.subject.obstruction;
  if (!stopped_at || all.empty()) return all;
  const auto away = [&](const RoadmapPicture::Refused& one) {
    return (one.at - *stopped_at).squaredNorm();
  };
  const auto first = std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
  std::rotate(all.begin(), first, first + 1);
  return all;
}

void EdgeTakes::play(const RoadmapPicture::Refused& refused, PageAttempt& attempt) {
  const EdgeReplay replay = replayEdge(steering_, waypointOf(refused.from), waypointOf(refused.to));
  if (!replay.stop) return;
  const EdgeReplay::Stop& stop = *replay.stop;
  const std::string what = whatRefused(problem_, stop.rule, stop.part, stop.object);
  attempt.take = add(replay.buffer, "Refused: " + what);
  if (attempt.take < 0) return;
  attempt.what = what;
  attempt.line = wayOf(replay.buffer);
  attempt.at = stop.at;
  page_.subject.takes[attempt.take].stop = {(stop.frame + stop.between) / kEvery, stop.part,
                                            stop.object, stop.at};
}

void EdgeTakes::addAttempts() {
  const std::vector<RoadmapPicture::Refused> all = attemptsInOrder();
  for (size_t i = 0; i < all.size(); ++i) {
    PageAttempt attempt;
    attempt.line = {all[i].from.stance.position, all[i].to.stance.position};
    attempt.at = all[i].at;
    attempt.what = whatRefused(problem_, all[i].rule, all[i].part, all[i].object);
    if (isChosen(i, all.size(), kMostAttemptTakes)) play(all[i], attempt);
    page_.subject.attempts.push_back(std::move(attempt));
  }
}

void EdgeTakes::addEdges() {
  for (size_t i = 0; i < roadmap_.edges.size(); ++i) {
    if (!isChosen(i, roadmap_.edges.size(), kMostEdgeTakes)) continue;
    const RoadmapPicture::Edge& edge = roadmap_.edges[i];
    const EdgeReplay replay = replayEdge(steering_, waypointOf(roadmap_.nodes[edge.from]),
                                         waypointOf(roadmap_.nodes[edge.to]));
    if (replay.stop) continue;  // of a planner that animates nothing
    const int take =
        add(replay.buffer, fmt::format("Edge {} \u2192 {}", edge.from + 1, edge.to + 1));
    if (take >= 0) page_.subject.edge_takes.push_back({static_cast<int>(i), take});
  }
}

}  // namespace

std::string whatRefused(const Problem& problem, WalkRule rule, int part, int object) {
  std::string what(walkRuleName(rule));
  std::replace(what.begin(), what.end(), '_', ' ');
  if (part >= 0 && object >= 0) {
    what += fmt::format(": {} and {}", problem.body.parts[part].name,
                        objectName(problem.scene.objects[object]));
  }
  return what;
}

std::vector<Eigen::Vector3d> wayOf(const AnimationBuffer& walk) {
  std::vector<Eigen::Vector3d> way;
  for (const FrameState& state : walk.states) {
    if (way.empty() || (state.position - way.back()).norm() >= kWaySpacing)
      way.push_back(state.position);
  }
  if (!way.empty() && way.back() != walk.states.back().position)
    way.push_back(walk.states.back().position);
  return way;
}

PageTake takeOf(const AnimationBuffer& walk, double sole) {
  PageTake take;
  take.frame_time = walk.frame_time;
  take.poses = &walk.poses;
  take.way = wayOf(walk);
  take.sole = sole;
  for (const FrameState& state : walk.states)
    take.headings.push_back(static_cast<float>(state.heading));
  take.footprints = walk.footprints;
  for (const Footprint& print : walk.footprints)
    take.planted[print.side].push_back({print.first_frame, print.last_frame});
  return take;
}

void addEdgeTakes(const Problem& problem, const RoadmapPicture& roadmap, double sole,
                  WalkPage& page) {
  EdgeTakes takes(problem, roadmap, sole, page);
  takes.addAttempts();
  takes.addEdges();
}

}  // namespace amble
