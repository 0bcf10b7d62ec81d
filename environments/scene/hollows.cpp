#include "environments/scene/hollows.h"

#include <algorithm>
#include <memory>

#include "environments/scene/box_tree.h"
#include "environments/scene/parity.h"

namespace amble {
namespace {

// What is at least so large is a room: somebody can stand and walk in it.
constexpr double kRoomHeight = 1.0;  // [m]
constexpr double kRoomArea = 4.0;    // [m^2]

// The closed pieces of meshes.
class Shells {
 public:
  Shells(const Scene& scene, std::vector<ScenePiece>& pieces)
      : pieces_(pieces), boxes_(pieces.size()), solids_(pieces.size()) {
    for (size_t k = 0; k < pieces.size(); ++k) {
      const SceneObject& object = scene.objects[pieces[k].object];
      if (!pieces[k].closed || !std::holds_alternative<TriangleMesh>(object.shape)) continue;
      for (const Eigen::Vector3d& v : pieces[k].mesh.vertices) boxes_[k].extend(v);
      shells_.push_back(static_cast<int>(k));
    }
    if (shells_.size() > 1) tree_ = BoxTree(boxes_);
  }

  const std::vector<int>& all() const { return shells_; }
  const Eigen::AlignedBox3d& box(int shell) const { return boxes_[shell]; }

  /// Those that may have all of one within them.
  const std::vector<int>& around(int shell) {
    tree_.find(boxes_[shell], around_);
    std::erase_if(around_, [&](int k) { return k == shell || !boxes_[k].contains(boxes_[shell]); });
    return around_;
  }
  bool isInside(int shell, const Eigen::Vector3d& p) {
    if (!solids_[shell]) solids_[shell] = std::make_unique<Parity>(SolidMesh(pieces_[shell].mesh));
    return solids_[shell]->inside(p);
  }
  bool holds(int outer, int inner) {
    const std::vector<Eigen::Vector3d>& vertices = pieces_[inner].mesh.vertices;
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const Eigen::Vector3d& v) { return isInside(outer, v); });
  }

 private:
  const std::vector<ScenePiece>& pieces_;
  std::vector<Eigen::AlignedBox3d> boxes_;       // of shells; others are empty
  std::vector<std::unique_ptr<Parity>> solids_;  // made when first asked
  std::vector<int> shells_, around_;
  BoxTree tree_;
};

// Whether each of a piece's corners is in the solid of those of its object that go around it, which
// are told already.
bool isOwnHollow(const std::vector<ScenePiece>& pieces, int shell, Shells& shells) {
  const std::vector<Eigen::Vector3d>& vertices = pieces[shell].mesh.vertices;
  std::vector<int> depth(vertices.size(), 0);
  for (const int k : shells.around(shell)) {
    if (pieces[k].object != pieces[shell].object) continue;
    for (size_t v = 0; v < vertices.size(); ++v)
      if (shells.isInside(k, vertices[v])) depth[v] += pieces[k].hollow ? -1 : 1;
  }
  return std::all_of(depth.begin(), depth.end(), [](int d) { return d > 0; });
}

// The object in whose solid all of a piece lies, by parity over the shells of others that hold it:
// that of the smallest of them; or -1.
int solidAround(const std::vector<ScenePiece>& pieces, int shell, Shells& shells) {
  const Eigen::Vector3d apart = Eigen::Vector3d::Constant(kSeam);  // or it is the same shell
  const Eigen::AlignedBox3d box(shells.box(shell).min() - apart, shells.box(shell).max() + apart);
  int count = 0, smallest = -1;
  for (const int k : shells.around(shell)) {
    if (pieces[k].object == pieces[shell].object || !shells.box(k).contains(box)) continue;
    if (!shells.holds(k, shell)) continue;
    ++count;
    if (smallest < 0 || shells.box(k).volume() < shells.box(smallest).volume()) smallest = k;
  }
  return count % 2 == 1 ? pieces[smallest].object : -1;
}

}  // namespace

void markHollows(const Scene& scene, std::vector<ScenePiece>& pieces, const StopRequest& stop) {
  Shells shells(scene, pieces);
  if (shells.all().size() < 2) return;
  std::vector<bool> has_own(scene.objects.size(), false);
  std::vector<int> outer_first = shells.all();
  std::stable_sort(outer_first.begin(), outer_first.end(),
                   [&](int a, int b) { return shells.box(a).volume() > shells.box(b).volume(); });
  for (const int shell : outer_first) {
    stop.check();
    pieces[shell].hollow = isOwnHollow(pieces, shell, shells);
    if (pieces[shell].hollow) has_own[pieces[shell].object] = true;
  }
  for (const int shell : shells.all()) {
    stop.check();
    const Eigen::Vector3d size = shells.box(shell).sizes();
    if (size.z() < kRoomHeight || size.x() * size.y() < kRoomArea) continue;
    if (has_own[pieces[shell].object]) continue;
    const int around = solidAround(pieces, shell, shells);
    if (around < 0) continue;
    pieces[shell].hollow = true;
    pieces[shell].solid_of = around;
  }
}

}  // namespace amble
