/// A scene as walkers of several sizes find it: what they have in common is made once.
///
/// Its surfaces in pieces are the same to all. Ground is the same to who is as tall and takes the
/// same slopes and steps; what bodies touch, to all who have the same ground, be it of others'
/// making.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "environments/collision/scene_layers.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"

namespace amble {

/// Threads may ask at a time; others wait while one makes something. What is returned has the scene
/// and the pieces with it for as long as it is there.
class WalkedScene {
 public:
  /// So many of each, those asked for last, are kept for who asks next.
  static constexpr int kKept = 4;

  explicit WalkedScene(std::shared_ptr<const Scene> scene);

  const std::shared_ptr<const Scene>& scene() const { return scene_; }
  /// @throws Stopped
  std::shared_ptr<const SceneGround> ground(const GroundSettings& settings,
                                            const StopRequest& stop) const;
  /// @param ground  of this scene; need not outlive what is returned. @throws Stopped
  std::shared_ptr<const SceneLayers> layers(const SceneGround& ground,
                                            const StopRequest& stop) const;

 private:
  struct Layers {
    std::vector<bool> ground;  // of each triangle of the pieces
    std::shared_ptr<const SceneLayers> made;
  };

  std::shared_ptr<const Scene> scene_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::shared_ptr<const ScenePieces> pieces_;
  mutable std::deque<std::shared_ptr<const SceneGround>> grounds_;  // the last one used first
  mutable std::deque<Layers> layers_;
};

}  // namespace amble
