// A small walk to draw: a person of six capsules who goes straight ahead.
#pragma once

#include <cmath>
#include <memory>

#include "viz/figure/figure.h"
#include "viz/walk_view.h"

namespace amble {

/// Everything that a WalkView borrows. Not movable: the view points into it.
struct TestWalk {
  Scene scene;
  Skeleton skeleton;
  Body body;
  AnimationBuffer animation;
  RootPath path;
  WalkView view;

  TestWalk() = default;
  TestWalk(const TestWalk&) = delete;
  TestWalk& operator=(const TestWalk&) = delete;
};

inline SceneObject testBox(const std::string& name, const Eigen::Vector3d& size,
                           const Eigen::Vector3d& at) {
  SceneObject object;
  object.name = name;
  object.shape = Box{size};
  object.X_WO.translation() = at;
  return object;
}

inline BodyPart testPart(const std::string& name, int joint, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to, double radius, int sole = -1) {
  BodyPart part;
  part.name = name;
  part.joint = joint;
  part.from = from;
  part.to = to;
  part.radius = radius;
  part.sole = sole;
  return part;
}

/// A room of 6 x 4 m with four walls and a low box in a corner.
inline Scene testRoom() {
  Scene scene;
  scene.name = "room";
  scene.objects = {testBox("floor", {6, 4, 0.1}, {3, 2, -0.05}),
                   testBox("wall-west", {0.1, 4, 2.5}, {-0.05, 2, 1.25}),
                   testBox("wall-east", {0.1, 4, 2.5}, {6.05, 2, 1.25}),
                   testBox("wall-south", {6, 0.1, 2.5}, {3, -0.05, 1.25}),
                   testBox("wall-north", {6, 0.1, 2.5}, {3, 4.05, 1.25}),
                   testBox("chest", {0.6, 0.5, 0.7}, {5.5, 3.6, 0.35})};
  return scene;
}

/// From (1, 2) four metres along +x in 4 s, at 30 frames a second, with a footprint every half
/// metre.
inline std::unique_ptr<TestWalk> makeTestWalk() {
  auto walk = std::make_unique<TestWalk>();
  walk->scene = testRoom();
  Joint hips, left, right;
  hips.name = "hips";
  left.name = "left";
  right.name = "right";
  left.parent = right.parent = 0;
  left.offset = {0, 0.1, 0};
  right.offset = {0, -0.1, 0};
  walk->skeleton = Skeleton({hips, left, right});
  walk->body.parts = {testPart("trunk", 0, {0, 0, 0.1}, {0, 0, 0.5}, 0.15),
                      testPart("head", 0, {0, 0, 0.7}, {0, 0, 0.72}, 0.1),
                      testPart("left leg", 1, {0, 0, 0}, {0, 0, -0.8}, 0.07),
                      testPart("right leg", 2, {0, 0, 0}, {0, 0, -0.8}, 0.07),
                      testPart("left sole", 1, {-0.05, 0, -0.86}, {0.13, 0, -0.86}, 0.04, kLeft),
                      testPart("right sole", 2, {-0.05, 0, -0.86}, {0.13, 0, -0.86}, 0.04, kRight)};
  walk->animation.frame_time = 1.0 / 30;
  walk->animation.poses = PoseArray(3);
  walk->animation.poses.resize(121);
  walk->animation.states.resize(121);
  for (int i = 0; i <= 120; ++i) walk->animation.poses.p_WR(i) = {1 + 4.0 * i / 120, 2, 0.9};
  for (int i = 0; i < 8; ++i) {
    Footprint print;
    print.side = i % 2 == 0 ? kLeft : kRight;
    print.position = {1.04 + 0.5 * i, i % 2 == 0 ? 2.1 : 1.9, 0};
    print.first_frame = 15 * i;
    print.last_frame = 15 * i + 18;
    walk->animation.footprints.push_back(print);
  }
  walk->path = RootPath({makeBezier({1, 2}, 0, {5, 2}, 0)});
  WalkView& view = walk->view;
  view.title = "a test & <walk>";
  view.scene = &walk->scene;
  view.skeleton = &walk->skeleton;
  view.body = &walk->body;
  view.animation = &walk->animation;
  view.path = &walk->path;
  view.start = PlaceView{{1, 2}, 0.0};
  view.goal = PlaceView{{5, 2}, std::nullopt};
  return walk;
}

inline const Figure& figureOfTestWalk() {
  static const Figure figure = [] {
    const auto walk = makeTestWalk();
    return makeFigure(walk->skeleton, walk->body);
  }();
  return figure;
}

}  // namespace amble
