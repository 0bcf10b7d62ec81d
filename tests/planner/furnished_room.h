/// A small furnished room with the default walker in it, for tests of what plans whole bodies.
#pragma once

#include "animation/body/foot_shape.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "environments/body/body.h"
#include "environments/collision/collision_world.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"

namespace amble {

/// As plans have it where nobody stoops.
inline Body uprightBody(const WalkSynthesizer& walker) {
  Body body =
      makeBody(walker.skeleton(), walker.roles(), walker.stature(), soleHeights(walker.feet()));
  body.upright = walker.stature();
  return body;
}

inline SceneObject boxObject(const std::string& name, const Eigen::Vector3d& size,
                             const Eigen::Vector3d& at) {
  SceneObject object;
  object.name = name;
  object.shape = Box{size};
  object.X_WO.translation() = at;
  return object;
}

/// 6 x 4 m: a wall at x = 3 that leaves a passage 0.9 m wide at its north end, and a low table east
/// of it.
///
///   +------+------+ 4
///   |             |   y 3.1 to 4: the passage
///   |      |      |
///   |      |  TT  |   T: 0.8 x 0.8 m, 0.45 m high, around (4.5, 1.2)
///   +------+------+ 0
///   0      3      6
inline Scene furnishedScene() {
  Scene scene;
  scene.name = "furnished room";
  scene.objects = {boxObject("floor", {6.4, 4.4, 0.1}, {3, 2, -0.05}),
                   boxObject("south", {6.4, 0.1, 2.5}, {3, -0.05, 1.25}),
                   boxObject("north", {6.4, 0.1, 2.5}, {3, 4.05, 1.25}),
                   boxObject("west", {0.1, 4.4, 2.5}, {-0.05, 2, 1.25}),
                   boxObject("east", {0.1, 4.4, 2.5}, {6.05, 2, 1.25}),
                   boxObject("wall", {0.1, 3.1, 2.5}, {3, 1.55, 1.25}),
                   boxObject("table", {0.8, 0.8, 0.45}, {4.5, 1.2, 0.225})};
  return scene;
}

struct FurnishedRoom {
  explicit FurnishedRoom(Scene the_scene = furnishedScene(), const CharacterSettings& settings = {})
      : scene(std::move(the_scene)), synthesizer(library, ground, settings) {}

  const Scene scene;
  const MotionLibrary library = openMotionLibrary("default");
  const SceneGround ground{scene, 0.0};
  const WalkSynthesizer synthesizer;
  const Body body = uprightBody(synthesizer);
  const CollisionWorld world{scene, ground, synthesizer.skeleton(), body};
  const Eigen::AlignedBox2d bounds{Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 4)};
};

/// Made once: the same for all tests, which change nothing in it.
inline const FurnishedRoom& furnishedRoom() {
  static const FurnishedRoom room;
  return room;
}

}  // namespace amble
