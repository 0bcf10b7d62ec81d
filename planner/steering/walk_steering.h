/// The steering method for a walking body (Pettré §3 to §5), in four stages with named refusals
/// (DESIGN.md, section 3).
///
///   1 root path   cubic Beziers between the two stances       refuses: no_curve, bounds
///   2 limits      turn rates of the library, whole steps      refuses: turn_rate, step_length
///   3 animation   the synthesizer's frames, feet on footprints refuses: reach, no_ground
///   4 validation  the whole body, at frames and between them  refuses: contact
///
/// Between two standing stances an edge is one curve with the stances' own headings (of several
/// handle lengths the one of least curvature) or, if that is refused, the straight line with turns
/// on the spot at its ends. At a stance that walks there is no turn; all handle lengths are tried
/// there, gentlest first. Where one end may turn, curves that arrive at it (or leave it) by another
/// heading are tried too. The first that passes all stages is the edge.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "animation/synthesis/walk_synthesizer.h"
#include "environments/collision/collision_world.h"
#include "environments/map/clearance_map.h"
#include "planner/steering/body_core.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/steering.h"

namespace amble {

/// What an edge is made of.
enum class EdgePart { kTurnFirst, kWalk, kTurnLast };
using PartOrder = std::array<EdgePart, 3>;

/// What a planner asks of walks, beside what they are made of.
struct WalkWishes {
  /// Distance to things within which edges cost more, up to WalkSteering::kNearnessCost times their
  /// time [m, >= 0].
  double comfort = 0.0;
  std::optional<Eigen::AlignedBox2d> within = {};  ///< root paths stay in it; anywhere without [m]
};

class WalkSteering : public Steering {
 public:
  /// @pre all outlive the steering; the world's body is the synthesizer's.
  WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
               const SceneGround& ground, const WalkWishes& wishes = {});
  static constexpr double kNearnessCost = 2.0;

  SteeringScratchPtr makeScratch() const override;
  std::optional<SteeringFailure> stand(Stance& stance, SteeringScratch& scratch) const override;
  /// The same where the stance is, be it below what the ground is there.
  std::optional<SteeringFailure> standHere(const Stance& stance, SteeringScratch& scratch) const;
  bool place(Stance& stance) const override;
  SteerResult steer(const Waypoint& from, const Waypoint& to,
                    SteeringScratch& scratch) const override;
  SteerResult steerWithin(const Waypoint& from, const Waypoint& to, double most,
                          SteeringScratch& scratch) const override;
  SteerResult steerOn(const Waypoint& from, const Waypoint& to, double most,
                      const LeadsOn& leads_on, SteeringScratch& scratch) const override;
  bool mayLead(const Waypoint& from, const Waypoint& to, double most,
               SteeringScratch& scratch) const override;
  bool looksFree(const Waypoint& from, const Waypoint& to, SteeringScratch& scratch) const override;
  double topSpeed() const override;
  std::vector<double> floors(double x, double y) const override { return ground_.floors(x, y); }
  int layers() const override;
  std::vector<StancePair> passages() const override;
  std::unique_ptr<WayGuide> guide(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const Eigen::AlignedBox2d& bounds,
                                  const std::function<bool()>& stopped, int threads) const override;
  std::optional<SteeringFailure> shutOff(
      const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::function<bool()>& stopped,
      std::span<const SteeringScratchPtr> scratches) const override;
  /// What shuts off all who keep to the ground, as far as the body's middle: no proof where the
  /// ground is open at its edge, since a body may lean out there. For reports.
  std::optional<SteeringFailure> shutOffOnGround(
      const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::function<bool()>& stopped,
      std::span<const SteeringScratchPtr> scratches) const;

  /// By a few small steps to a standing stance beside the first, in any direction, turning on the
  /// way; refused where it is farther than kSmallSteps. For start and goal: between samples of a
  /// roadmap they would join what no walk follows, and leave it fewer guards.
  SteerResult smallSteps(const Waypoint& from, const Waypoint& to, SteeringScratch& scratch) const;

  /// The room that the walking body has; null where its breadth is not known.
  std::shared_ptr<const ClearanceMap> map(const Eigen::AlignedBox2d& bounds,
                                          const std::function<bool()>& stopped,
                                          int threads = 1) const;

  /// The same as steer(), and the proposal whose refusal it answers with; none where the two
  /// waypoints have no root path between them.
  struct Attempt {
    SteerResult result;
    std::optional<WalkEdge> refused;  ///< where there is no edge
  };
  Attempt attempt(const Waypoint& from, const Waypoint& to, SteeringScratch& scratch) const;

  /// The frames of an edge, as they were checked. `out` is overwritten.
  void animate(const WalkEdge& edge, AnimationBuffer& out) const;

  /// The same of one that may be refused: up to the part that no rule lets be made. @return that
  /// rule, or none
  WalkRule animateRefused(const WalkEdge& edge, AnimationBuffer& out) const;

  /// The first contact of an animation, between its frames too, or none.
  std::optional<SteeringFailure> contact(const AnimationBuffer& buffer,
                                         SteeringScratch& scratch) const;

  /// Where the part is that a contact of an animation is about.
  SteeringFailure touched(const Contact& contact, const AnimationBuffer& buffer,
                          SteeringScratch& scratch) const;

  const WalkSynthesizer& synthesizer() const { return synthesizer_; }
  const CollisionWorld& world() const { return world_; }

 private:
  WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
               const SceneGround& ground, const WalkWishes& wishes, const StraightWalk& walk);
  // What an edge is wanted for.
  struct Use {
    double most = HUGE_VAL;             // that it may cost [s]
    const LeadsOn* leads_on = nullptr;  // whether one could go on from it
  };
  SteerResult judge(WalkEdge edge, SteeringScratch& scratch, const Use& use) const;
  SteerResult steer(const Waypoint& from, const Waypoint& to, SteeringScratch& scratch,
                    const Use& use, std::optional<WalkEdge>* refused) const;
  bool coreTouches(const WalkEdge& edge, SteeringScratch& scratch, SteeringFailure& failure) const;
  double leastCost(int intervals, std::span<const GaitParameters> gait) const;
  WalkFilter costsAtMost(double most) const;
  WalkFilter isOfUse(const WalkEdge& edge, const Use& use, bool& leads_on) const;
  WalkResult make(const WalkEdge& edge, EdgePart part, AnimationBuffer& out,
                  const WalkFilter& is_wanted) const;
  template <typename Visit>
  bool visitParts(const WalkEdge& edge, const PartOrder& order, AnimationBuffer& buffer,
                  Visit visit, const WalkFilter& is_wanted = {}) const;

  const WalkSynthesizer& synthesizer_;
  const CollisionWorld& world_;
  const SceneGround& ground_;
  WalkWishes wishes_;
  BodyCore core_;
  BodyReach reach_;
  double half_breadth_ = 0.0;      // of the body that walks, from the path; 0: not known [m]
  ClearanceMap::Breadth breadth_;  // the same by height; without bands where it is not known
};

}  // namespace amble
