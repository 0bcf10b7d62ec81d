/// Local method of the planner (Pettré §5, "steering method"): what it is asked and what it
/// answers.
///
/// An extension point: `WalkSteering` walks a whole body; tests put a disc in its place, and the
/// planner `cylinder` the body's bounding cylinder. Steering is directed: steer(a, b) says nothing
/// about steer(b, a).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "animation/steps/walk_rule.h"

namespace amble {

/// A place that edges are asked between: a stance, and what of it is left to the edge.
struct Waypoint {
  Stance stance;
  bool any_heading = false;  ///< the edge chooses the heading (start or goal without one)
  bool any_leading = true;   ///< at an edge's end that walks: either foot may be in front
};

/// The four stages (DESIGN.md, section 3).
enum class SteeringStage { kRootPath, kLimits, kAnimation, kValidation };
SteeringStage stageOf(WalkRule rule);

/// Which rule refused, and what stood in the way.
struct SteeringFailure {
  WalkRule rule = WalkRule::kNoCurve;
  int part = -1;     ///< of the body, where a contact refused
  int object = -1;   ///< of the scene, where a contact refused
  double gap = 0.0;  ///< distance that was proved there [m, >= 0]
  /// Where: the part that touched; else where the walk was to begin [m, World].
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  /// The ground under the body that touched, and the way it faced there; else where the walk was to
  /// end, and its direction [m, World], [rad].
  Eigen::Vector3d body = Eigen::Vector3d::Zero();
  double heading = 0.0;
};

/// A walk that was checked: an optional turn on the spot, a root path, an optional turn on the
/// spot; or, without a root path, a few small steps to a place beside the first, `turn_first` on
/// the way. It holds what the walk is made of, not its frames: animating it again gives the same
/// frames to the bit.
struct WalkEdge {
  Stance from, to;          ///< as walked: free headings and feet are settled
  double turn_first = 0.0;  ///< on the spot at `from`, before walking [rad, left positive]
  RootPath path;            ///< empty where the edge only turns
  double turn_last = 0.0;   ///< on the spot at `to`, after walking [rad, left positive]
  bool any_leading = true;  ///< as asked: `to.leading` was the walk's choice
  int steps = 0;            ///< of the walk between the turns
  double duration = 0.0;    ///< [s, >= 0], a whole number of frames
  double length = 0.0;      ///< of the root path [m, >= 0]
  double effort = 0.0;      ///< what climbing and lifting cost beside time, in time [s, >= 0]
  double unease = 0.0;      ///< what nearness to things costs beside time, in time [s, >= 0]

  double cost() const { return duration + effort + unease; }  ///< [s]
};

/// What steering was asked, and why there is no edge.
struct RefusedEdge {
  Waypoint from, to;
  SteeringFailure failure;
};

/// Two stances between which a walk is likely that samples would hardly find.
struct StancePair {
  Stance first, second;
};

/// Ways that a search may try before it samples.
class WayGuide {
 public:
  virtual ~WayGuide() = default;
  /// Standing stances to pass one after another, ends left out; none where there is no other way.
  virtual std::optional<std::vector<Stance>> next() = 0;
  /// The next way is to lead elsewhere than here, where steering refused [m, World].
  virtual void avoid(const Eigen::Vector3d& at) = 0;
  struct Narrow {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< [m, World]
    double heading = 0.0;                          ///< of the way there [rad]
    bool may_pass = false;                         ///< next() has led, or may lead, through it
    /// There is no more room beside what is in the way than where it is right over the way.
    bool blocked = false;
    bool on_steps = false;  ///< the ground rises there by steps
  };
  /// The narrowest place of the widest way, its ends left out, if there is hardly room for the
  /// body, or none; nothing where there is no way, or room everywhere.
  virtual std::optional<Narrow> narrowest() const = 0;
};

struct SteerResult {
  std::optional<WalkEdge> edge;
  SteeringFailure failure;     ///< meaningful where there is no edge
  int poses = 0;               ///< frames handed to the collision check
  bool assumed = false;        ///< that there is an edge, which nobody has made (looksFree)
  bool too_dear = false;       ///< an edge would cost more than was asked for (steerWithin)
  bool leads_nowhere = false;  ///< an edge, if there is one, would be of no use (steerOn)
};

/// Scratch memory of one thread.
class SteeringScratch {
 public:
  virtual ~SteeringScratch() = default;
};
using SteeringScratchPtr = std::unique_ptr<SteeringScratch>;

/// Const after construction: threads may share it, each with its own scratch. Answers depend on the
/// arguments only.
class Steering {
 public:
  virtual ~Steering() = default;
  virtual SteeringScratchPtr makeScratch() const = 0;

  /// Puts the stance on the ground and asks whether the body can stand there.
  virtual std::optional<SteeringFailure> stand(Stance& stance, SteeringScratch& scratch) const = 0;

  /// Puts the stance on the ground; false where there is none.
  virtual bool place(Stance& stance) const = 0;

  /// The walk from one waypoint to another, checked, or the rule that refused.
  virtual SteerResult steer(const Waypoint& from, const Waypoint& to,
                            SteeringScratch& scratch) const = 0;

  /// The same for who has no use for an edge that costs more than `most` [s]: where the first that
  /// is proposed would, the answer may be that (`too_dear`), and what refuses it, or what else
  /// would do, has not been asked. An edge that is given is that of steer(), and costs no more, but
  /// for what nearness to things adds.
  virtual SteerResult steerWithin(const Waypoint& from, const Waypoint& to, double /*most*/,
                                  SteeringScratch& scratch) const {
    return steer(from, to, scratch);
  }

  /// Asked of an edge that is planned and not made: it has its foot that leads at the end, and its
  /// cost, as `duration`, is what it will be at least. Whether one could go on from it.
  using LeadsOn = std::function<bool(const WalkEdge& planned)>;
  /// steerWithin() for who has no use for an edge from which he could not go on: where
  /// steerWithin() would give one of those the answer may be that (`leads_nowhere`). Else it is the
  /// same.
  virtual SteerResult steerOn(const Waypoint& from, const Waypoint& to, double most, const LeadsOn&,
                              SteeringScratch& scratch) const {
    return steerWithin(from, to, most, scratch);
  }
  /// Whether steerWithin() may give an edge, for all that is known without much work; false is
  /// certain.
  virtual bool mayLead(const Waypoint&, const Waypoint&, double /*most*/, SteeringScratch&) const {
    return true;
  }

  /// Whether there is so much room all along that steer() will find a walk, nearly for sure: for
  /// who only wants to know whether one place is reached from another. False says nothing.
  virtual bool looksFree(const Waypoint&, const Waypoint&, SteeringScratch&) const { return false; }

  /// Heights of the ground at (x, y), where it lies in several layers or is not level; else none is
  /// needed: `place` finds it [m].
  virtual std::vector<double> floors(double, double) const { return {}; }
  /// Most floors over one another; 0 where they need not be told apart.
  virtual int layers() const { return 0; }
  /// Ends of narrow passages, standing: a roadmap takes them before any sample.
  virtual std::vector<StancePair> passages() const { return {}; }

  /// Ways within bounds that may lead from one place to another; null where it knows of none.
  /// @param stopped  asked now and then, by any thread: where it says so there are none
  /// @param threads  that may look for them [>= 1]; what they find does not depend on how many
  virtual std::unique_ptr<WayGuide> guide(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                          const Eigen::AlignedBox2d&, const std::function<bool()>&,
                                          int /*threads*/) const {
    return nullptr;
  }

  /// Proof that no walk leads from one place to another, whatever edges are tried: what shuts the
  /// body off. None says nothing. @param stopped  asked now and then, by any thread
  /// @param scratches  one for each thread that may look for it [1 or more]; the answer does not
  /// depend on how many
  virtual std::optional<SteeringFailure> shutOff(
      const Eigen::Vector3d&, const Eigen::Vector3d&, const std::function<bool()>&,
      std::span<const SteeringScratchPtr> /*scratches*/) const {
    return std::nullopt;
  }

  /// No edge between two places is faster than their distance over this [m/s, > 0].
  virtual double topSpeed() const = 0;
};

/// What steering was asked and answered, for reports. Counts only answers that a result depends on,
/// so that it is the same at any number of threads.
struct SteeringCount {
  std::map<WalkRule, long long> refusals;
  long long poses = 0;  ///< frames handed to the collision check
  long long asked = 0;  ///< edges asked for

  void add(const SteerResult& result);
  void add(const SteeringFailure& failure) { ++refusals[failure.rule]; }
  void add(const SteeringCount& other);
};

}  // namespace amble
