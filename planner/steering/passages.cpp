#include "planner/steering/passages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/rotation.h"
#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

constexpr int kSeedSpacing = 3;  // squares between places that lines begin at
// That a direction uphill is taken from: a tread and more [m]
constexpr double kNeighbourhood = 0.45;
constexpr double kLineStep = 0.05;   // between points of a line [m]
constexpr double kLevelRun = 0.5;    // without a change of height: ground is level there [m]
constexpr double kLevelSpan = 0.02;  // that heights of level ground may differ by [m]
constexpr double kLanding = 0.9;     // between two flights: one stands there [m]
// Where a person stands beyond the last step: in the middle of a landing, no farther than this [m].
constexpr double kFarthestStand = 0.8;
constexpr double kLongest = 40.0;    // of a line [m]
constexpr double kLeastRise = 0.04;  // lower ones any walk crosses [m]
// Faces of risers that a direction is taken from: no higher, and within so much of the slope found.
constexpr double kTallestRiser = 0.35;           // [m]
constexpr double kFaceTurn = 50.0 * kDegree;     // [rad]
constexpr double kSameFace = 2.0 * kDegree;      // of one direction [rad]
constexpr double kSameHeading = 10.0 * kDegree;  // of lines side by side [rad]
constexpr double kSameLine = 0.3;                // between two lines that are one [m]
constexpr int kLinesOfFlight = 3;                // kept of lines side by side
constexpr size_t kMostPassages = 60;             // of a scene

Eigen::Vector2d unit(double heading) { return {std::cos(heading), std::sin(heading)}; }

class Finder {
 public:
  explicit Finder(const SceneGround& ground)
      : ground_(ground), step_(ground.settings().limits.highestStep()) {}

  std::vector<Passage> find();

 private:
  std::optional<double> uphill(int column, int row, double height) const;
  double acrossRisers(const Eigen::Vector3d& p, double heading) const;
  std::vector<Eigen::Vector3d> follow(const Eigen::Vector3d& p, double heading) const;
  std::optional<Passage> through(const Eigen::Vector3d& p, double heading) const;

  const SceneGround& ground_;
  double step_;
};

// Direction in which the ground around a square rises (least squares), none where it is level.
std::optional<double> Finder::uphill(int column, int row, double height) const {
  const GroundCells& cells = ground_.cells();
  const int reach = static_cast<int>(kNeighbourhood / cells.cell());
  const Eigen::Vector2d middle = cells.middle(column, row);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double lowest = height, highest = height;
  for (int j = row - reach; j <= row + reach; ++j) {
    for (int i = column - reach; i <= column + reach; ++i) {
      const Eigen::Vector2d way = cells.middle(i, j) - middle;
      if (way.norm() > kNeighbourhood) continue;
      for (const GroundCells::Span& span : cells.spans(i, j)) {
        if (!span.ground || !span.standable || std::abs(span.height - height) > 2.0 * step_)
          continue;
        const Eigen::Vector3d row_of(way.x(), way.y(), 1.0);
        normal += row_of * row_of.transpose();
        right += (span.height - height) * row_of;
        lowest = std::min(lowest, span.height);
        highest = std::max(highest, span.height);
      }
    }
  }
  if (highest - lowest < kLevelSpan) return std::nullopt;
  const Eigen::Vector3d plane = normal.ldlt().solve(right);
  if (!plane.allFinite() || plane.head<2>().norm() < 1e-3) return std::nullopt;
  return std::atan2(plane.y(), plane.x());
}

// The direction that most of the faces of risers near p have, or the slope below it: exact where
// the one found from squares is not. At a flight's corner it is that of the risers, not one between
// them and the flight's side.
double Finder::acrossRisers(const Eigen::Vector3d& p, double heading) const {
  std::vector<std::pair<double, double>> directions;  // heading, weight
  const auto add = [&](const Eigen::Vector2d& across, double weight) {
    if (!(across.norm() > 1e-9)) return;
    double direction = std::atan2(across.y(), across.x());
    if (std::abs(wrapAngle(direction - heading)) > 0.5 * kPi) direction += kPi;
    if (std::abs(wrapAngle(direction - heading)) > kFaceTurn) return;
    const auto same = std::find_if(directions.begin(), directions.end(), [&](const auto& other) {
      return std::abs(wrapAngle(other.first - direction)) < kSameFace;
    });
    if (same != directions.end())
      same->second += weight;
    else
      directions.emplace_back(direction, weight);
  };
  const Eigen::Vector2d at = p.head<2>(), reach = Eigen::Vector2d::Constant(kNeighbourhood);
  ground_.all().visitBox({at - reach, at + reach}, [&](int t) {
    const Triangle3& face = ground_.all().triangles()[t];
    const auto [low, high] = std::minmax({face[0].z(), face[1].z(), face[2].z()});
    if (high - low > kTallestRiser || high < p.z() - 2.0 * step_ || low > p.z() + 2.0 * step_)
      return;
    const Eigen::Vector3d area = (face[1] - face[0]).cross(face[2] - face[0]);
    if (std::abs(area.z()) < 0.2 * area.norm()) add(area.head<2>(), area.norm());
  });
  if (const auto here = ground_.surface(p.x(), p.y(), p.z(), step_))
    add(-here->normal.head<2>(), here->normal.head<2>().norm());
  if (directions.empty()) return heading;
  return std::max_element(directions.begin(), directions.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// The ground along a heading, from p on, as far as steps lead and until it has been level for long
// enough to stand there.
std::vector<Eigen::Vector3d> Finder::follow(const Eigen::Vector3d& p, double heading) const {
  const Eigen::Vector2d way = kLineStep * unit(heading);
  std::vector<Eigen::Vector3d> line = {p};
  size_t begin = 0;  // of what has been level since
  for (int i = 0; i * kLineStep < kLongest; ++i) {
    const Eigen::Vector3d& last = line.back();
    const auto next = ground_.height(last.x() + way.x(), last.y() + way.y(), last.z(), step_);
    if (!next) break;
    const double run = static_cast<double>(line.size() - 1 - begin) * kLineStep;
    if (run >= 2.0 * kFarthestStand) break;
    if (run >= kLanding && std::abs(line[begin].z() - *next) > kLevelSpan) break;
    line.emplace_back(last.x() + way.x(), last.y() + way.y(), *next);
    while (std::abs(line[begin].z() - *next) > kLevelSpan) ++begin;
  }
  return line;
}

// Where one stands on the level ground at the end of a line: in its middle, not far from the slope.
std::optional<Eigen::Vector3d> standAtEnd(const std::vector<Eigen::Vector3d>& line) {
  size_t level = 0;  // points at the end
  while (level < line.size() &&
         std::abs(line[line.size() - 1 - level].z() - line.back().z()) <= kLevelSpan)
    ++level;
  const double run = static_cast<double>(level) * kLineStep;
  if (run < kLevelRun || level == line.size()) return std::nullopt;
  const auto in = static_cast<size_t>(std::min(0.5 * run, kFarthestStand) / kLineStep);
  return line[line.size() - level + in];
}

std::optional<Passage> Finder::through(const Eigen::Vector3d& p, double heading) const {
  const std::vector<Eigen::Vector3d> ahead = follow(p, heading), back = follow(p, heading + kPi);
  std::vector<Eigen::Vector3d> line(back.rbegin(), back.rend() - 1);
  line.insert(line.end(), ahead.begin(), ahead.end());
  const auto high = standAtEnd(line);
  std::reverse(line.begin(), line.end());
  const auto low = standAtEnd(line);
  if (!high || !low || high->z() - low->z() < kLeastRise) return std::nullopt;
  return Passage{*low, *high, wrapAngle(heading)};
}

// Of lines side by side the middle one and two beside it.
std::vector<Passage> thin(std::vector<Passage> lines) {
  std::vector<Passage> kept;
  std::vector<bool> done(lines.size(), false);
  for (size_t i = 0; i < lines.size() && kept.size() < kMostPassages; ++i) {
    if (done[i]) continue;
    const Eigen::Vector2d along = unit(lines[i].heading), left(-along.y(), along.x());
    const auto offset = [&](const Passage& line) {
      return left.dot((line.low - lines[i].low).head<2>());
    };
    std::vector<Passage> flight;
    for (size_t k = i; k < lines.size(); ++k) {
      const Eigen::Vector3d low = lines[k].low - lines[i].low, high = lines[k].high - lines[i].high;
      if (done[k] || std::abs(wrapAngle(lines[k].heading - lines[i].heading)) > kSameHeading ||
          std::abs(low.z()) > kLevelSpan || std::abs(high.z()) > kLevelSpan ||
          std::abs(along.dot(low.head<2>())) > 1.0 || std::abs(along.dot(high.head<2>())) > 1.0)
        continue;
      done[k] = true;
      flight.push_back(lines[k]);
    }
    std::stable_sort(flight.begin(), flight.end(),
                     [&](const Passage& a, const Passage& b) { return offset(a) < offset(b); });
    std::vector<Passage> chosen;
    for (const size_t part : {2, 1, 3}) {
      const Passage& line = flight[std::min(flight.size() - 1, part * flight.size() / 4)];
      const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](const Passage& other) {
        return std::abs(offset(other) - offset(line)) < kSameLine;
      });
      if (is_new && chosen.size() < kLinesOfFlight) chosen.push_back(line);
    }
    kept.insert(kept.end(), chosen.begin(), chosen.end());
  }
  return kept;
}

std::vector<Passage> Finder::find() {
  const GroundCells& cells = ground_.cells();
  std::vector<Passage> lines;
  for (int row = 0; row < cells.rows(); row += kSeedSpacing) {
    for (int column = 0; column < cells.columns(); column += kSeedSpacing) {
      if (cells.isPlainAround(column, row)) continue;  // nothing rises
      for (const GroundCells::Span& span : cells.spans(column, row)) {
        if (!span.ground || !span.standable) continue;
        const auto direction = uphill(column, row, span.height);
        if (!direction) continue;
        const Eigen::Vector2d at = cells.middle(column, row);
        const Eigen::Vector3d p(at.x(), at.y(), span.height);
        const auto line = through(p, acrossRisers(p, *direction));
        if (line) lines.push_back(*line);
      }
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Passage& a, const Passage& b) {
    return std::tuple(a.low.z(), a.low.x(), a.low.y()) <
           std::tuple(b.low.z(), b.low.x(), b.low.y());
  });
  return thin(std::move(lines));
}

}  // namespace

std::vector<Passage> findPassages(const SceneGround& ground) {
  if (ground.isLevel() || ground.cells().columns() == 0) return {};
  return Finder(ground).find();
}

}  // namespace amble
