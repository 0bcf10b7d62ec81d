#include "environments/ground/ground_cells.h"

#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/rotation.h"

namespace amble {
namespace {

// Surfaces nearer than this lie on one another [m].
constexpr double kTouching = 1e-3;
// Beyond what the steepest slope explains, as far as a foot reaches, a surface may be uneven by so
// much and be one to stand on [m].
constexpr double kUneven = 0.01;
constexpr int kFootHeadings = 8;  // by which a foot is tried, of half a turn
// Steps bridge so many squares [cells]: gaps between treads, not strides.
constexpr int kStepReach = 3;

// A surface that the vertical line through a square's middle meets.
struct Hit {
  double height;
  int triangle, piece;
  bool faces_up;
};

int rootOf(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

struct GroundCells::Builder {
  const Scene& scene;
  const ScenePieces& pieces;
  const TriangleGrid& all;
  const std::vector<bool>& up;
  const GroundSettings& settings;
  GroundCells& cells;
  std::vector<Hit> hits = {};
  std::vector<int> inside = {};              // closed pieces that the line is in
  std::vector<bool> said = {};               // of each span: of an object that is said to be ground
  std::vector<int> parent = {};              // of each span, union-find
  std::vector<Eigen::Vector2i> square = {};  // of each span

  void build();
  void collect(const Eigen::Vector2d& p);
  void addSpans(int column, int row);
  bool hasRoom(const Eigen::Vector3d& p) const;
  std::optional<double> beside(const Eigen::Vector3d& p, const Eigen::Vector2d& offset) const;
  bool isStraight(const Eigen::Vector3d& p, const Eigen::Vector2d& offset) const;
  void joinSteps();
  template <typename Visit>
  void eachNeighbour(int span, const Eigen::Vector2i& step, double most, Visit visit_one) const;
  void choose();
  void goOn();
};

// Surfaces over p, lowest first, each once: a line through an edge meets the triangles on both
// sides.
void GroundCells::Builder::collect(const Eigen::Vector2d& p) {
  hits.clear();
  all.visitAt(p.x(), p.y(), [&](int t) {
    if (const auto z = heightOver(all.triangles()[t], p.x(), p.y()))
      hits.push_back({*z, t, pieces.piece_of[t], upwardness(all.triangles()[t]) > 0.0});
  });
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.height, a.piece, a.faces_up, a.triangle) <
           std::tie(b.height, b.piece, b.faces_up, b.triangle);
  });
  const auto doubled = [](const Hit& a, const Hit& b) {
    return a.piece == b.piece && a.faces_up == b.faces_up && b.height - a.height < kTouching;
  };
  hits.erase(std::unique(hits.begin(), hits.end(), doubled), hits.end());
}

void GroundCells::Builder::addSpans(int column, int row) {
  const Eigen::Vector2d p = cells.middle(column, row);
  collect(p);
  inside.clear();
  for (size_t begin = 0, end; begin < hits.size(); begin = end) {
    bool stands = false, is_said = false;
    for (end = begin; end < hits.size() && hits[end].height - hits[begin].height < kTouching;
         ++end) {
      const Hit& hit = hits[end];
      const ScenePiece& piece = pieces.pieces[hit.piece];
      if (piece.closed) {
        const auto found = std::find(inside.begin(), inside.end(), hit.piece);
        found == inside.end() ? inside.push_back(hit.piece) : (void)inside.erase(found);
      }
      stands = stands || up[hit.triangle];
      is_said = is_said || (up[hit.triangle] && scene.objects[piece.object].role == Role::kGround);
    }
    if (!stands) continue;
    Span span;
    span.height = hits[end - 1].height;
    const bool open = end == hits.size() || hits[end].height - span.height >= settings.headroom;
    span.standable = inside.empty() && open && hasRoom({p.x(), p.y(), span.height});
    cells.spans_.push_back(span);
    said.push_back(is_said);
    square.emplace_back(column, row);
  }
}

// The surface beside p that a slope from there could lead to, the nearest in height.
std::optional<double> GroundCells::Builder::beside(const Eigen::Vector3d& p,
                                                   const Eigen::Vector2d& offset) const {
  const double most = cells.slope_ * offset.norm() + kUneven;
  const double x = p.x() + offset.x(), y = p.y() + offset.y();
  std::optional<double> nearest;
  all.visitAt(x, y, [&](int t) {
    if (!up[t]) return;
    const auto z = heightOver(all.triangles()[t], x, y);
    if (!z || std::abs(*z - p.z()) > most) return;
    if (!nearest || std::abs(*z - p.z()) < std::abs(*nearest - p.z())) nearest = z;
  });
  return nearest;
}

// Whether the ground goes on straight to both sides of p.
bool GroundCells::Builder::isStraight(const Eigen::Vector3d& p,
                                      const Eigen::Vector2d& offset) const {
  const auto before = beside(p, -offset), after = beside(p, offset);
  return before && after && std::abs(*before + *after - 2.0 * p.z()) <= 2.0 * kUneven;
}

bool GroundCells::Builder::hasRoom(const Eigen::Vector3d& p) const {
  for (int k = 0; k < kFootHeadings; ++k) {
    const double heading = kPi * k / kFootHeadings;
    const Eigen::Vector2d along =
        0.5 * settings.foot_length * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const Eigen::Vector2d aside =
        0.5 * settings.foot_breadth * Eigen::Vector2d(-std::sin(heading), std::cos(heading));
    if (isStraight(p, along) && isStraight(p, 0.5 * along) && isStraight(p, aside)) return true;
  }
  return false;
}

// Calls visit_one(other) for the spans over a neighbouring square that are no farther up or down
// than `most`.
template <typename Visit>
void GroundCells::Builder::eachNeighbour(int span, const Eigen::Vector2i& step, double most,
                                         Visit visit_one) const {
  const Eigen::Vector2i other = square[span] + step;
  if ((other.array() < 0).any() || (other.array() >= cells.count_.array()).any()) return;
  const size_t cell = static_cast<size_t>(other.y()) * cells.count_.x() + other.x();
  for (int k = cells.start_[cell]; k < cells.start_[cell + 1]; ++k) {
    if (std::abs(cells.spans_[k].height - cells.spans_[span].height) <= most) visit_one(k);
  }
}

void GroundCells::Builder::joinSteps() {
  parent.resize(cells.spans_.size());
  std::iota(parent.begin(), parent.end(), 0);
  const double step = std::max({settings.max_climb, settings.max_drop, kLevel});
  for (int span = 0; span < static_cast<int>(parent.size()); ++span) {
    if (!cells.spans_[span].standable) continue;
    for (int far = 1; far <= kStepReach; ++far) {
      for (const Eigen::Vector2i& way : {Eigen::Vector2i(far, 0), Eigen::Vector2i(0, far)}) {
        eachNeighbour(span, way, step, [&](int other) {
          if (!cells.spans_[other].standable) return;
          const int a = rootOf(parent, span), b = rootOf(parent, other);
          parent[std::max(a, b)] = std::min(a, b);
        });
      }
    }
  }
  for (size_t span = 0; span < parent.size(); ++span)
    if (cells.spans_[span].standable)
      cells.spans_[span].part = rootOf(parent, static_cast<int>(span));
}

// Parts that are ground: large, said to be, or stood on by the problem.
void GroundCells::Builder::choose() {
  std::vector<int> size(parent.size(), 0);
  std::vector<bool> chosen(parent.size(), false);
  for (const Span& span : cells.spans_)
    if (span.part >= 0) ++size[span.part];
  for (size_t i = 0; i < parent.size(); ++i) {
    Span& span = cells.spans_[i];
    const bool at_level = settings.level && std::abs(span.height - *settings.level) <= kLevel;
    if (span.part >= 0 &&
        (size[span.part] * cells.cell_ * cells.cell_ >= kFloorArea || said[i] || at_level))
      chosen[span.part] = true;
    span.ground = said[i] || at_level;
  }
  for (const Eigen::Vector2d& place : settings.places) {
    const Eigen::Vector2i at = cells.squareAt(place);
    const auto here = cells.spans(at.x(), at.y());
    const auto large = [&](const Span& span) { return span.part >= 0 && chosen[span.part]; };
    if (std::any_of(here.begin(), here.end(), large)) continue;
    for (const Span& span : here)
      if (span.part >= 0) chosen[span.part] = true;
  }
  for (Span& span : cells.spans_)
    span.ground = span.ground || (span.part >= 0 && chosen[span.part]);
}

// Ground goes on level where nobody stands.
void GroundCells::Builder::goOn() {
  std::vector<int> open;
  for (size_t i = 0; i < cells.spans_.size(); ++i)
    if (cells.spans_[i].ground) open.push_back(static_cast<int>(i));
  const double most = std::max(kLevel, cells.slope_ * cells.cell_);
  for (size_t next = 0; next < open.size(); ++next) {
    const int from = open[next];
    for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                       Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
      eachNeighbour(from, way, most, [&](int other) {
        if (std::exchange(cells.spans_[other].ground, true)) return;
        open.push_back(other);
      });
    }
  }
}

void GroundCells::Builder::build() {
  for (int row = 0; row < cells.count_.y(); ++row) {
    for (int column = 0; column < cells.count_.x(); ++column) {
      cells.start_.push_back(static_cast<int>(cells.spans_.size()));
      addSpans(column, row);
    }
  }
  cells.start_.push_back(static_cast<int>(cells.spans_.size()));
  joinSteps();
  choose();
  goOn();
  for (size_t c = 0; c + 1 < cells.start_.size(); ++c) {
    const auto begin = cells.spans_.begin() + cells.start_[c];
    const auto end = cells.spans_.begin() + cells.start_[c + 1];
    const auto standing = [](const Span& span) { return span.ground && span.standable; };
    cells.layers_ = std::max(cells.layers_, static_cast<int>(std::count_if(begin, end, standing)));
  }
}

GroundCells::GroundCells(const Scene& scene, const ScenePieces& pieces, const TriangleGrid& all,
                         const std::vector<bool>& up, const GroundSettings& settings)
    : slope_(std::tan(settings.max_slope)) {
  Eigen::AlignedBox2d extent;
  for (size_t t = 0; t < up.size(); ++t) {
    if (!up[t]) continue;
    for (const Eigen::Vector3d& corner : all.triangles()[t])
      extent.extend(Eigen::Vector2d(corner.head<2>()));
  }
  if (extent.isEmpty()) return;
  min_ = extent.min();
  cell_ = std::max(kCell, extent.sizes().maxCoeff() / kMostCells);
  for (int k = 0; k < 2; ++k) count_[k] = 1 + static_cast<int>(extent.sizes()[k] / cell_);
  Builder{scene, pieces, all, up, settings, *this}.build();
}

std::span<const GroundCells::Span> GroundCells::spans(int column, int row) const {
  if (column < 0 || row < 0 || column >= count_.x() || row >= count_.y()) return {};
  const size_t cell = static_cast<size_t>(row) * count_.x() + column;
  return {spans_.data() + start_[cell], spans_.data() + start_[cell + 1]};
}

Eigen::Vector2i GroundCells::squareAt(const Eigen::Vector2d& p) const {
  const Eigen::Array2d steps = ((p - min_) / cell_).array().floor();
  return steps.max(-1.0).min(count_.cast<double>().array()).cast<int>();
}

// Whether ground over one of the squares near p goes on as the plane through p does.
bool GroundCells::matches(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
  const Eigen::Vector2i at = squareAt(p.head<2>());
  for (int row = at.y() - 1; row <= at.y() + 1; ++row) {
    for (int column = at.x() - 1; column <= at.x() + 1; ++column) {
      const Eigen::Vector2d way = middle(column, row) - p.head<2>();
      const double z = p.z() - normal.head<2>().dot(way) / normal.z();
      for (const Span& span : spans(column, row))
        if (span.ground && std::abs(span.height - z) <= kLevel) return true;
    }
  }
  return false;
}

bool GroundCells::isGround(const Triangle3& t) const {
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector3d& corner : t) plan.extend(Eigen::Vector2d(corner.head<2>()));
  const Eigen::Vector2i low = squareAt(plan.min()), high = squareAt(plan.max());
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const Eigen::Vector2d p = middle(column, row);
      const auto here = spans(column, row);
      if (std::none_of(here.begin(), here.end(), [](const Span& span) { return span.ground; }))
        continue;
      const auto z = heightOver(t, p.x(), p.y());
      if (!z) continue;
      for (const Span& span : here)
        if (span.ground && std::abs(span.height - *z) <= kTouching) return true;
    }
  }
  // Small and narrow ones lie between the middles of squares.
  const Eigen::Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return matches(centre, normal) ||
         std::any_of(t.begin(), t.end(), [&](const Eigen::Vector3d& corner) {
           return matches(0.5 * (centre + corner), normal);
         });
}

}  // namespace amble
