/// A page to look at motion with: one HTML file that needs nothing beside itself.
///
/// Actors move through takes in a room. A take is a motion of an actor with what is known of it; a
/// page shows one of them at a time, or several together, and begins with the first. Of a planned
/// walk that is the walk, and the others are edges of its roadmap; where no walk was found it is an
/// attempt that was refused; of captures each is a take of its own actor.
///
/// In the file: data as JSON, with arrays of numbers in base64 behind it (viz/page/page_bytes.h),
/// and the page's program (viz/page/web). No name, of whatever bytes, leaves its string. The same
/// subject gives the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "animation/body/pose.h"
#include "planner/plan_request.h"
#include "viz/figure/figure.h"
#include "viz/walk_view.h"

namespace amble {

struct Bench;  // viz/page/bench.h

/// Who moves. Borrowed: what the pointers name outlives the page.
struct PageActor {
  std::string name;
  const Skeleton* skeleton = nullptr;  ///< never null
  const Body* body = nullptr;          ///< null: its bones are shown
  const Figure* figure = nullptr;      ///< its skin; null: it is made, if there is a body
};

/// First and last frame of something.
struct FrameSpan {
  int first = 0, last = 0;
};

/// A moment with a name, on the time line.
struct PageEvent {
  std::string name;  ///< "left strike"
  Side side = kLeft;
  double frame = 0.0;  ///< may lie between two frames [>= 0]
};

/// A captured motion, and how much of it is in each frame.
struct PageSource {
  std::string name;
  std::vector<float> share;  ///< by frame [0 to 1]
};

/// What is nearest to the body in each frame.
struct PageClearance {
  std::vector<float> distance;                  ///< by frame [m]; negative: nothing is near
  std::vector<Eigen::Vector3f> on_body, on_it;  ///< the two points [m, World]
  std::vector<int> part, object;                ///< of the body, of the scene
};

/// Where an attempt failed.
struct PageStop {
  double frame = 0.0;                            ///< of the take; may lie between two frames [>= 0]
  int part = -1, object = -1;                    ///< what touched what: of the body, of the scene
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< [m, World]
};

/// A motion. Borrowed as above.
struct PageTake {
  std::string name;
  int actor = 0;                     ///< index
  double frame_time = 0.0;           ///< [s, > 0]
  const PoseArray* poses = nullptr;  ///< never null, not empty
  /// As Clip::joint_positions: null or empty where only the root moves.
  const std::vector<Eigen::Vector3d>* joint_positions = nullptr;
  int every = 1;                     ///< of the file's frames every so manieth is here [>= 1]
  bool coarse = false;               ///< for looking at only: rotations in 16 bits
  std::vector<Eigen::Vector3d> way;  ///< of the root on the ground, to be drawn [m, World]
  std::vector<float> headings;       ///< by frame [rad]; empty: the way that the root moves
  std::array<std::vector<FrameSpan>, 2> planted;  ///< by Side
  std::vector<PageEvent> events;
  std::vector<Footprint> footprints;
  double sole = 0.27;  ///< length of the soles that made them [m]
  std::vector<PageSource> sources;
  PageClearance clearance;       ///< empty where it is not known
  std::optional<PageStop> stop;  ///< it is played up to there
};

/// An edge of the roadmap that can be played.
struct PageEdgeTake {
  int edge = 0;  ///< index in RoadmapView::edges
  int take = 0;  ///< index
};

/// A walk from one place to another that was refused.
struct PageAttempt {
  std::vector<Eigen::Vector3d> line;  ///< its root path on the ground; else its ends [m, World]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< where [m, World]
  std::string what;                              ///< by which rule, and what touched
  int take = -1;                                 ///< index; -1: it cannot be played
};

/// Ground as strips along World x, of a few kinds each.
struct PageGround {
  double breadth = 0.0;                      ///< of a strip, along World y [m, > 0]
  std::vector<ReachedRegion::Strip> strips;  ///< [m, World]
  std::vector<std::uint8_t> kind;            ///< of each
};

struct PageSubject {
  std::string title;
  std::string description;  ///< of the picture, for those who do not see it: a sentence or two
  std::string why;          ///< where there is no walk: one line
  std::vector<std::pair<std::string, std::string>> facts;  ///< what is said beside it: label, value
  std::vector<std::string> notes;  ///< what is to be known of it, a line each
  const Scene* scene = nullptr;    ///< null: an empty floor
  double floor = 0.0;              ///< height of the floor [m]
  std::vector<PageActor> actors;
  std::vector<PageTake> takes;     ///< none: the room alone
  const WalkView* walk = nullptr;  ///< start, goal and roadmap; null where there is none
  std::vector<PageEdgeTake> edge_takes;
  const Bench* bench = nullptr;  ///< what is known of the takes' clips; null: no workbench
  std::vector<PageAttempt> attempts;
  PageGround reached;  ///< where there is no walk: how far one gets; empty where it is not known
  /// Where the body can be: kind 0 with hardly room beside it, 1 with some, 2 with much.
  PageGround room_to_walk;
  std::optional<Eigen::Vector3d> obstruction;  ///< what stopped most attempts [m, World]
};

void writePage(std::ostream& out, const PageSubject& subject);

}  // namespace amble
