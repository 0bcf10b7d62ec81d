#include "viz/page/graph_bench.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "animation/body/foot_shape.h"
#include "scenarios/captured_body.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAround = 0.75;  // played of each clip before and after a jump [s]
constexpr int kOfPlaces = 3;      // digits of a place among the clusters that can be seen

// Jumps from one clip to another, the smoothest of each cluster.
using JumpsByClips = std::map<std::pair<int, int>, std::vector<std::pair<FrameJump, int>>>;

void addJumps(const ClusterGraph& graph, const GraphCut& cut, int cluster, JumpsByClips& found) {
  std::map<std::pair<int, int>, FrameJump> best;
  for (const int s : cut.clusters[cluster].sequences) {
    const FrameSequence& from = cut.sequences[s];
    if (!graph.hasRoom(from.alignment)) continue;
    for (const int t : cut.clusters[cluster].sequences) {
      const FrameSequence& to = cut.sequences[t];
      if (s == t || !graph.hasRoom(to.alignment)) continue;
      const double error = graph.error(from.alignment, to.alignment);
      const auto [jump, is_new] =
          best.try_emplace({from.clip, to.clip}, FrameJump{from.alignment, to.alignment, error});
      if (!is_new && error < jump->second.error)
        jump->second = {from.alignment, to.alignment, error};
    }
  }
  for (const auto& [clips, jump] : best) found[clips].emplace_back(jump, cluster);
}

// The smoothest of each two clips first.
std::vector<BenchJoin> jumpsOf(const ClusterGraph& graph, const GraphCut& cut) {
  JumpsByClips by_clips;
  for (int cluster = 0; cluster < static_cast<int>(cut.clusters.size()); ++cluster)
    addJumps(graph, cut, cluster, by_clips);
  std::vector<std::pair<int, BenchJoin>> ranked;
  for (auto& [clips, jumps] : by_clips) {
    std::stable_sort(jumps.begin(), jumps.end(),
                     [](const auto& a, const auto& b) { return a.first.error < b.first.error; });
    for (size_t rank = 0; rank < jumps.size(); ++rank)
      ranked.push_back({static_cast<int>(rank), {jumps[rank].first, jumps[rank].second, {}, {}}});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.jump.error) < std::tie(b.first, b.second.jump.error);
  });
  std::vector<BenchJoin> joins;
  for (auto& [rank, join] : ranked) joins.push_back(std::move(join));
  return joins;
}

ShownClip shownOf(Clip clip, const std::string& name, const JointRoles& roles, const Body& body) {
  ShownClip shown;
  shown.file = shown.name = name;
  shown.motion.clip = std::move(clip);
  shown.motion.roles = roles;
  shown.file_frames = shown.motion.clip.frames();
  shown.body = body;
  const Clip& level = shown.motion.clip;
  shown.analysis = analyseClip(level, roles);
  shown.feet = tracePlants(footPaths(level, roles), legLengths(level, roles), level.frame_time);
  return shown;
}

ShownClip joinOf(const ClusterGraph& graph, const GraphClips& clips, const Body& body,
                 BenchJoin& join) {
  const int around = static_cast<int>(std::lround(kAround / clips.frame_time));
  const int a = graph.clipOf(join.jump.leave), b = graph.clipOf(join.jump.enter);
  const int leave = join.jump.leave - graph.clips[a].first;
  const int enter = join.jump.enter - graph.clips[b].first;
  join.ranges = {{a, std::max(0, leave - around), leave},
                 {b, enter, std::min(graph.clips[b].frames - 1, enter + around)}};
  const int blend = static_cast<int>(std::lround(kGraphBlend / clips.frame_time));
  JoinedClip motion = played(clips, join.ranges, blend);
  join.report = motion.joins[0];
  return shownOf(std::move(motion.clip),
                 frameName(graph, join.jump.leave) + " to " + frameName(graph, join.jump.enter),
                 clips.roles, body);
}

// A row a direction.
Eigen::Matrix<float, 2, Eigen::Dynamic> directionsOf(const FrameFeatures& features) {
  const Eigen::VectorXf mean = features.rowwise().mean();
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(features.rows(), features.rows());
  for (Eigen::Index i = 0; i < features.cols(); ++i) {
    const Eigen::VectorXd off = (features.col(i) - mean).cast<double>();
    spread.selfadjointView<Eigen::Lower>().rankUpdate(off);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(spread);  // the largest are last
  Eigen::Matrix<float, 2, Eigen::Dynamic> directions(2, features.rows());
  for (int i = 0; i < 2; ++i) {
    Eigen::VectorXf direction = solved.eigenvectors().col(features.rows() - 1 - i).cast<float>();
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    directions.row(i) = direction[largest] < 0.0f ? -direction : direction;  // either way is one
  }
  return directions;
}

Json clipsJson(const ClusterGraph& graph) {
  Json clips = Json::array();
  for (const GraphClip& clip : graph.clips)
    clips.push_back({{"name", clip.name},
                     {"frames", clip.frames},
                     {"first_frame", clip.first_frame},
                     {"step", clip.step}});
  return clips;
}

Json sequencesJson(const ClusterGraph& graph, const GraphCut& cut) {
  Json sequences = Json::array();
  for (const FrameSequence& sequence : cut.sequences) {
    const int first = graph.clips[sequence.clip].first;
    sequences.push_back({{"clip", sequence.clip},
                         {"cluster", sequence.cluster},
                         {"first", sequence.first - first},
                         {"last", sequence.last - first},
                         {"alignment", sequence.alignment - first}});
  }
  return sequences;
}

// Places: a column a frame of all clips.
Json clustersJson(const GraphCut& cut, const Eigen::Matrix2Xf& places) {
  Json clusters = Json::array();
  for (const FrameCluster& cluster : cut.clusters) {
    Eigen::Vector2f sum = Eigen::Vector2f::Zero();
    for (const int s : cluster.sequences)
      for (int i = cut.sequences[s].first; i <= cut.sequences[s].last; ++i) sum += places.col(i);
    const Eigen::Vector2f at = sum / static_cast<float>(cluster.frames);
    clusters.push_back({{"state", kSupportNames[static_cast<int>(cluster.state)]},
                        {"frames", cluster.frames},
                        {"spread", cluster.spread},
                        {"sequences", cluster.sequences},
                        {"next", cluster.next},
                        {"at", {at.x(), at.y()}}});
  }
  return clusters;
}

Json frameJson(const ClusterGraph& graph, int frame) {
  const int clip = graph.clipOf(frame);
  return {{"clip", clip}, {"frame", frame - graph.clips[clip].first}};
}

Json feetJson(const JoinReport& report) {
  constexpr const char* kCases[] = {"", "before", "after", "within", "slips"};
  Json feet = Json::array();
  for (const FootHold& foot : report.feet)
    feet.push_back({{"foot", foot.side == kLeft ? "left" : "right"},
                    {"case", kCases[static_cast<int>(foot.which)]},
                    {"slip", foot.slip}});
  return feet;
}

Json joinsJson(const BenchGraph& bench) {
  Json joins = Json::array();
  int take = static_cast<int>(bench.graph->clips.size());
  for (const BenchJoin& join : bench.joins) {
    joins.push_back({{"take", take++},
                     {"cluster", join.cluster},
                     {"leave", frameJson(*bench.graph, join.jump.leave)},
                     {"enter", frameJson(*bench.graph, join.jump.enter)},
                     {"error", std::sqrt(join.jump.error)},
                     {"meeting", join.report.meeting},
                     {"blend", {join.report.first, join.report.last}},
                     {"glide", join.report.glide},
                     {"feet", feetJson(join.report)},
                     {"play", rangesText(*bench.graph, join.ranges)}});
  }
  return joins;
}

}  // namespace

BenchGraph benchOfGraph(const ClusterGraph& graph, const GraphClips& clips, double error) {
  BenchGraph bench;
  bench.graph = &graph;
  bench.cut = cutAt(graph, error);
  bench.joins = jumpsOf(graph, bench.cut);
  bench.joins_found = static_cast<int>(bench.joins.size());
  if (bench.joins.size() > kMostJoins)
    bench.joins.erase(bench.joins.begin() + kMostJoins, bench.joins.end());
  const Clip& first = clips.clips[0].clip;
  const Body body = capturedBody(first, clips.roles, 0.0, statureOf(first.skeleton, clips.roles));
  for (size_t i = 0; i < clips.clips.size(); ++i)
    bench.clips.push_back(shownOf(clips.clips[i].clip, graph.clips[i].name, clips.roles, body));
  for (BenchJoin& join : bench.joins) bench.clips.push_back(joinOf(graph, clips, body, join));
  return bench;
}

std::string benchGraphJson(const BenchGraph& bench, const NumbersText& numbers) {
  const ClusterGraph& graph = *bench.graph;
  const Eigen::Matrix2Xf places = directionsOf(graph.features) * graph.features;
  Json path = Json::array();
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::VectorXd row = places.row(axis).transpose().cast<double>();
    path.push_back(
        Json::parse(numbers(std::span(row.data(), static_cast<size_t>(row.size())), kOfPlaces)));
  }
  const Json json = {{"error", bench.cut.error},
                     {"frame_time", graph.frame_time},
                     {"clips", clipsJson(graph)},
                     {"sequences", sequencesJson(graph, bench.cut)},
                     {"clusters", clustersJson(bench.cut, places)},
                     {"places", std::move(path)},
                     {"joins", joinsJson(bench)},
                     {"joins_found", bench.joins_found}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace amble
