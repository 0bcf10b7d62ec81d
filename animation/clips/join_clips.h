/// Motions of one skeleton joined into one (Shanbhag's thesis, §3.3 and §4.3): the first is left at
/// a frame, the next is entered at a frame of its own, and over some frames about that meeting both
/// are mixed.
///
/// The mixing begins half of its frames before the meeting in both motions (each is rolled back by
/// half of the blend) and ends as many after it. The root goes on by steps that are mixed from
/// frame to frame (root_motion.h), so that it neither glides nor turns back, wherever the captures
/// stood; what follows is moved to where that leads. Only for a foot that stands throughout it goes
/// a little nearer or farther, as far as nobody sees a glide in it, so that the foot slips less.
/// Joints turn by slerp. The weight eases (minimum jerk; the thesis' goes linearly, by which joints
/// would start and stop turning at once). Feet that stand about the meeting are seen to by
/// blend_contacts.h.
#pragma once

#include <vector>

#include "animation/clips/blend_contacts.h"
#include "animation/clips/root_motion.h"

namespace amble {

/// A motion, and when its feet stand.
struct ClipPart {
  const Clip& clip;
  const PlantedFrames& planted;  ///< one value a frame
};

struct ClipJoin {
  int leave = 0;  ///< frame of the first motion that meets ...
  int enter = 0;  ///< ... this frame of the next one
  /// Frames from the one motion alone to the other alone, half of them on each side; less where a
  /// motion begins or ends sooner [>= 0]
  int blend = 0;
};

/// What a join has done.
struct JoinReport {
  int first = 0, last = 0;  ///< frames of the joined motion that are mixed of both
  int meeting = 0;          ///< where the two frames meet
  int frame_shift = 0;      ///< frame i of the next motion is frame i + frame_shift of the joined
  GroundShift moved;        ///< where that has been moved to
  /// The root's greatest speed over the mean of its sources', weighted as they are mixed [>= 0]; 0
  /// where nothing moves.
  double glide = 0.0;
  /// Frames of the joined motion. At a cut, where nothing is mixed, feet slip from the one motion's
  /// place to the other's within a frame.
  std::vector<FootHold> feet;
};

struct JoinedClip {
  Clip clip;
  PlantedFrames planted;
  std::vector<JoinReport> joins;
};

/// The motion from a frame on, to be joined to. @pre 0 <= first < frames
JoinedClip joinedFrom(const ClipPart& part, int first);
/// Leaves what is joined so far at frame `join.leave` of it, and goes on with `next` to its end.
/// @pre the same joints and frame time, in the same order; frames that are there
void joinOn(JoinedClip& joined, const ClipPart& next, const JointRoles& roles,
            const ClipJoin& join);
/// Ends it with that frame; joins are then said up to it. @pre 0 <= last < frames
void endAt(JoinedClip& joined, int last);

}  // namespace amble
