/// Whether things shut the body off from a place: a proof of "no" that needs no search.
///
/// Wherever the body walks, whatever its heading, it holds some balls at heights of their own: in
/// its pelvis, its chest and its head, with what of an upright body is over it, and in each leg
/// where it crosses a height that no ankle is lifted to. Over level ground also in each leg at some
/// heights from there to the hips, and, unless it may stoop, in the trunk and the head, one over
/// the other (TrunkStack): by them hardly a bar as thick as kThinnest gets between two of those
/// balls. Each moves along a curve without a jump, from near the start to near the goal. Where a
/// ball cannot be, because something is nearer to its middle than its radius, none of its curves
/// leads. So if the plane without those places falls apart, with start and goal in different parts,
/// for any one of the balls, there is no walk.
///
/// A flood over squares decides it. A square is shut where a ball at its middle touches something
/// with its radius less half the square's diagonal: then it does wherever in the square it is. All
/// doubts are decided for the walker: balls are at the heights at which a straight walk from
/// standing to standing has them, or up to kRise higher or kDip lower, as who turns, bends or steps
/// over things is, and are kept off by what they would touch at each of these; squares are left
/// across their corners too; ends count as all squares as far from them as a ball is from the path
/// at most, and kDip more.
///
/// Over level ground a ball in each foot, where the toes begin, is lifted over things by what feet
/// are lifted beside their captured swing at most, at the moments at which they may be
/// (SwingShape): what is higher from side to side shuts off.
///
/// Lower things are passed over by swings only, and these look at what lies along the straight line
/// from print to print: over level prints they are refused for whatever ends higher than the most
/// that any captured swing is lifted to, up to where it counts as a wall (Feet::too_high). So seen
/// from above no such line leads by way of a square where a thing ends so high within the breadth
/// of a sole. Nor do feet stand there, or turn on the spot, where it is solid from below: the
/// instep's front end, over the middle of a flat sole, would touch it. Where things go on higher it
/// is that ball that is in the way, with all its lift. (A foot strays from its line by some
/// centimetres, and by more where it turns sharply: one that did so round the end of a wall which
/// its line leads through, over a thing beside it, would be lifted for nothing, and touch that.)
///
/// Where the ground around is uneven, pelvis, chest and head are carried as over any of the lines
/// from ground to ground that pass there (GroundChords), or up to kUnevenRise higher or kUnevenDip
/// lower: hips give way where legs are too short for a step. That bound was found by trial, of
/// bodies of 1.1 to 2.1 m at 0.4 to 2 m/s over stairs, kerbs, ramps, slabs and hills: they dip by
/// 0.166 m at most. What is over an upright head begins at most there, and ends no lower than over
/// the lowest ground around. Ground in several layers the flood says nothing of.
///
/// Only places near the ground that is reached count (NearGround): between places of it, and beyond
/// its open edges by as much as bodies lean out over feet that stand within, kBeyond; of 3,400
/// walks drawn along level edges none had pelvis, chest or head farther out than 0.15 m. So walls
/// that reach beyond the floor shut off, whatever is beyond them; and behind one that stands along
/// an edge only places count that bones lead to round its ends (EdgeReach). Legs count to
/// kLegsBeyond: feet that turn swing out farther, but who gets by a thing there has ground beside
/// it for his feet, and a flood that leaves that by more than a leg's radius gets by, too.
///
/// Over level ground nobody goes round the end of what stands as high as hips where it reaches the
/// ground's edge, or nearly: his feet would stand on either side of it, and shanks, thighs and
/// pelvis be beyond. Each by itself may be; but of 37,000 walks, of people 0.5 to 2.2 m tall, that
/// were drawn beside an edge and bent to get past the ends of thin walls there, straight to it or
/// aslant, none left less than 0.055 of stature between wall and edge (0.04 where the wall's lower
/// and upper parts stand as far apart as the post is thick). So a post of kPostRadius is let
/// nowhere but over ground, and is shut out where from kPostLow to kPostHigh something is at each
/// height. What is lower is stepped past: of 0.3 of stature with hardly a centimetre.
///
/// Where one after another of larger squares is open to all balls at once, in which none would
/// touch anything, from the start to the goal, no ball's flood is begun: that is nearly always so.
///
/// So "shut" is certain, up to walks that carry pelvis or chest otherwise than the straight one by
/// more than that, of which tests find none; "not shut" says little.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "animation/steps/leg_reach.h"
#include "environments/collision/collision_world.h"
#include "planner/steering/open_way.h"
#include "planner/steering/straight_walk.h"
#include "planner/steering/trunk_stack.h"

namespace amble {

class BodyReach {
 public:
  /// Than in the straight walk; over level ground hips give way by HipDip::kDeepest and kMore at
  /// most [m].
  static constexpr double kRise = 0.02, kDip = HipDip::kDeepest + HipDip::kMore + 0.01;
  static constexpr double kUnevenRise = 0.03, kUnevenDip = 0.18;  ///< the same over chords [m]
  static constexpr double kBeyond = 0.25, kLegsBeyond = 0.12;     ///< open edges [m]
  /// Of stature: a post at the body's middle, between these heights, and its radius.
  static constexpr double kPostLow = 0.1, kPostHigh = 0.5, kPostRadius = 0.03;
  /// Of stature: of ankles over the height that feet are lifted over, at most.
  static constexpr double kAnkle = 0.14;
  /// The feet of who has a ball at a place are no farther from there, of stature.
  static constexpr double kFeet = 0.5;
  /// Of what is from side to side, for balls to be near enough to each other [m].
  static constexpr double kThinnest = 0.1;
  static constexpr double kLargest = 0.05;  ///< square [m]
  /// Square of a second flood of pelvis and chest, which are broad enough to be told by it of gaps
  /// as narrow as they are [m].
  static constexpr double kFinest = 0.012;

  /// How feet go [m].
  struct Feet {
    double highest_step = 0.0;  ///< that is climbed
    double longest_step = 0.0;  ///< of the middles of two feet [> 0]
    double highest_lift = 0.0;  ///< beside their captured swing, at most [> 0]
    /// What ends between these heights over level ground they do not swing over; empty: not known.
    Eigen::AlignedBox1d too_high = {};
    double half_width = 0.0;  ///< of the soles that swing [>= 0]
  };

  /// Of a body on a walk; knows nothing where the walk has no frames.
  BodyReach(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
            const Body& body, double stature, const Feet& feet);

  /// What shuts the body off, where least is missing.
  struct Barrier {
    int part = -1;                                 ///< of the body, that does not pass
    int object = -1;                               ///< of the scene, that it would touch
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< where it would [m, World]
    /// The ground where the smaller of the two parts ends, and where the rest begins [m, World].
    Eigen::Vector3d near = Eigen::Vector3d::Zero(), far = Eigen::Vector3d::Zero();
  };
  /// None says nothing. Cost: a few hundred nanoseconds a square, where there is a way of those
  /// along it, else of the smaller part at most thrice; where there is much room some of a
  /// hundredth as many.
  /// @param from, to  on the ground [m, World]
  /// @param scratches  one for each thread that may take part [1 or more]: a ball each
  /// @param stopped  asked now and then, by any thread; where it says so nothing is known
  /// @param beyond  how far the flood may leave the ground [m, >= 0]: with less than kBeyond it is
  /// no proof, but tells what shuts off all who keep to the ground
  std::optional<Barrier> barrier(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 const CollisionWorld& world, const SceneGround& ground,
                                 const std::vector<CollisionScratch*>& scratches,
                                 const std::function<bool()>& stopped,
                                 double beyond = kBeyond) const;

  struct Ball {
    double height = 0.0, highest = 0.0;  ///< of its middle over the ground, between these [m]
    double top = 0.0;                    ///< and all that is over it up to there [m]
    double most_rise = HUGE_VAL;         ///< of ground around, over which it may be asked about [m]
    double radius = 0.0;                 ///< [m, > 0]
    double aside = 0.0;                  ///< from the path, at most [m]
    double beyond = kBeyond;             ///< open edges it may be so far [m]
    /// Of its middle, of the head's upper end, over the ground's chords, where that is uneven [m].
    Eigen::AlignedBox1d carried;
    double upright =
        -HUGE_VAL;      ///< of the end of what is over an upright head, over the lower foot
    int part = -1;      ///< of the body
    bool post = false;  ///< all of the post, which is shut out where something is at each height
    /// All of these, kDip lower and kRise higher than in the walk at most: shut out where one
    /// always touches a thing.
    TrunkStack stack = {};
    /// Feet::too_high of a foot's middle, and how far to each side of it its swings look [m].
    Eigen::AlignedBox1d too_high = {};
    double looks = 0.0;

    bool isTrunk() const { return highest > height; }  ///< or a foot, or the post
    bool isLeg() const { return most_rise < HUGE_VAL; }
    bool isFoot() const { return isLeg() && isTrunk() && !post && stack.balls.empty(); }
    bool isOverLevelOnly() const { return most_rise == SceneGround::kLevel; }
    bool isAsWide(const Ball& other) const {
      return height == other.height && highest == other.highest && top == other.top &&
             most_rise == other.most_rise && radius == other.radius && aside == other.aside;
    }
  };
  /// Those at one height first, and the largest first: their squares are the quickest to ask. Then
  /// those where legs cross a height, stacks, feet, and the post last.
  const std::vector<Ball>& balls() const { return balls_; }

 private:
  UprightPost postAround(std::span<const Ball> balls) const;
  void addCrossings(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                    const Body& body);
  void addStack(TrunkStack stack);
  void addPost(const JointRoles& roles, const Body& body);
  void addFeet(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
               const Body& body);
  Ball footBall(const StraightWalk& walk, const Skeleton& skeleton, Side side, const BodyPart& own,
                int part) const;
  double stature_;
  Feet feet_;
  std::vector<Ball> balls_;
};

}  // namespace amble
