#include "scenarios/walked_scene.h"

#include <algorithm>
#include <utility>

#include "environments/scene/scene_pieces.h"

namespace amble {
namespace {

// The one that is wanted, made where it is not there, and now the first of those kept.
template <typename T, typename IsWanted, typename Make>
T foundOrMade(std::deque<T>& kept, const IsWanted& is_wanted, const Make& make) {
  const auto found = std::find_if(kept.begin(), kept.end(), is_wanted);
  T wanted = found == kept.end() ? make() : *found;
  if (found != kept.end()) kept.erase(found);
  kept.push_front(wanted);
  if (static_cast<int>(kept.size()) > WalkedScene::kKept) kept.pop_back();
  return wanted;
}

}  // namespace

WalkedScene::WalkedScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

std::shared_ptr<const SceneGround> WalkedScene::ground(const GroundSettings& settings,
                                                       const StopRequest& stop) const {
  const std::lock_guard lock(mutex_);
  if (!pieces_) pieces_ = std::make_shared<const ScenePieces>(splitScene(*scene_, stop));
  return foundOrMade(
      grounds_, [&](const auto& kept) { return kept->settings() == settings; },
      [&] { return std::make_shared<const SceneGround>(*scene_, pieces_, settings, stop); });
}

std::shared_ptr<const SceneLayers> WalkedScene::layers(const SceneGround& ground,
                                                       const StopRequest& stop) const {
  const std::lock_guard lock(mutex_);
  return foundOrMade(
             layers_, [&](const Layers& kept) { return kept.ground == ground.groundTriangles(); },
             [&] {
               return Layers{ground.groundTriangles(),
                             std::make_shared<const SceneLayers>(*scene_, ground, stop)};
             })
      .made;
}

}  // namespace amble
