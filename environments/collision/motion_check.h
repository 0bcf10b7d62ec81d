/// How CollisionWorld checks a motion.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "animation/body/pose.h"
#include "environments/collision/collision_model.h"
#include "environments/collision/contact.h"

namespace amble {

/// Frames that `any` tries before it looks at all of them, coarsest first. By trial: most refusals
/// are found by then.
inline constexpr std::array<int, 3> kStrides = {16, 8, 4};
static_assert(kStrides[0] == 2 * kStrides[1] && kStrides[1] == 2 * kStrides[2]);

/// The check of one motion: at its frames, and between them by halving what is not yet proved.
///
/// Most of a motion is far from everything, and that is found for many frames at once. Between two
/// frames a point of a part's axis is never farther than `near` (PartMotion) from where it is at
/// the nearer of them; so from one to the next it moves by no more than twice that, and over
/// several by no more than the sum. What a part sweeps over a span of frames and the intervals
/// beside them is therefore within its capsule at the middle frame, inflated by the larger of the
/// sums to the span's two ends and by the largest `near`. Where the grids of bounds
/// (ClearanceField, GroundLayer::isAbove) call that free, so is each frame with its intervals, and
/// nothing more is asked of it; else shorter spans are asked about, and then frames, exactly.
/// A contact is never told but by an exact question: spans change what the answer costs, not the
/// answer.
class MotionCheck {
 public:
  MotionCheck(const CollisionModel& world, const PoseArray& poses,
              std::span<const SolePhases> soles, CollisionScratch& scratch)
      : world_(world), poses_(poses), soles_(soles), scratch_(scratch) {
    scratch_.prepare(poses.size());
  }

  /// A contact at some of the frames, coarsest first; none says nothing of the others.
  std::optional<Contact> coarse();
  /// All frames and what is between them, in order. With `any` a contact at a frame may be told
  /// before an earlier one between frames.
  std::optional<Contact> all(bool any);

 private:
  // A moment between two frames.
  struct Moment {
    double t;
    Capsule capsule;
  };
  // What is still to be proved of a part between two frames.
  struct Task {
    int frame, part;
    bool obstacles, ground;
    double depth;  // allowed in the ground [m]
  };

  // Frames that are placed and measured at once, ahead of the one that is asked for.
  static constexpr int kAhead = 16;
  // Spans are of kAhead frames, or of these; of fewer, each is asked by itself. By trial: halving
  // asks too often where things are near.
  static constexpr int kShortSpan = 4;

  void place(int first, int last, int step);
  std::span<const Capsule> placed(int frame) const {
    return {&scratch_.capsule(frame, 0), static_cast<size_t>(world_.parts())};
  }
  void prepare(int frame);
  void clearSpan(int first, int end, int part, const FreeAround& known);
  std::optional<Contact> checkFrame(int frame);
  std::optional<Contact> checkInterval(int frame);
  bool groundIsFree(const Task& task, const Capsule& a, const Capsule& b, const PartMotion& motion,
                    double near) const;
  std::optional<Contact> prove(const Task& task, const Moment& a, const Moment& b,
                               const PartMotion& motion) const;
  std::optional<Contact> touchedAt(const Task& task, const Moment& moment, double near) const;

  const CollisionModel& world_;
  const PoseArray& poses_;
  std::span<const SolePhases> soles_;
  CollisionScratch& scratch_;
};

}  // namespace amble
